//! QTI 3.0 and 2.1: a package with an item for each variant, and a test that selects one variant of each form at random.

mod dialect;
mod item;

use std::io::Write;

use super::Export;
use super::NotWritten;
use super::element::{Element, element};
use super::package::Package;
use super::question::Question;
use dialect::{Dialect, QTI_2, QTI_3};

/// A package on its way.
struct Qti<W: Write> {
    package: Package<W>,
    dialect: Dialect,
    /// The name of the test.
    title: String,
    sections: Vec<Section>,
    /// The entries of the manifest for the items; they stand at the end.
    resources: Vec<Element>,
}

/// The variants of a form.
struct Section {
    name: String,
    title: String,
    items: Vec<String>,
}

/// Begins a package of QTI 3.0.
pub(super) fn begin_3<'w>(out: Box<dyn Write + 'w>, title: &str) -> Box<dyn Export + 'w> {
    begin(out, QTI_3, title)
}

/// Begins a package of QTI 2.1.
pub(super) fn begin_2<'w>(out: Box<dyn Write + 'w>, title: &str) -> Box<dyn Export + 'w> {
    begin(out, QTI_2, title)
}

fn begin<'w>(out: Box<dyn Write + 'w>, dialect: Dialect, title: &str) -> Box<dyn Export + 'w> {
    Box::new(Qti {
        package: Package::new(out),
        dialect,
        title: title.to_owned(),
        sections: Vec::new(),
        resources: Vec::new(),
    })
}

impl<W: Write> Export for Qti<W> {
    fn write(&mut self, question: &Question<'_>) -> Result<(), NotWritten> {
        let (item, pictures) = item::item(question, self.dialect)?;
        let name = item::identifier(question);
        let path = file(&name);
        self.package.put(&path, &item.document(self.dialect.spelling))?;
        self.package.pictures("items/", &pictures)?;
        let files = pictures.files.iter().map(|(name, _)| listed(&format!("items/{name}")));
        let resource = self.resource(&name, "item", &path).holding_all(files);
        self.resources.push(resource);
        let group = question.name();
        match self.sections.last_mut() {
            Some(last) if last.name == group => last.items.push(name),
            _ => {
                let title = question.form_title();
                self.sections.push(Section { name: group, title, items: vec![name] });
            }
        }
        Ok(())
    }

    fn finish(mut self: Box<Self>) -> Result<(), NotWritten> {
        let spelling = self.dialect.spelling;
        let test = self.test().document(spelling);
        self.package.put("test.xml", &test)?;
        let manifest = self.manifest().document(super::element::VERBATIM);
        self.package.put("imsmanifest.xml", &manifest)?;
        self.package.finish()
    }
}

impl<W: Write> Qti<W> {
    fn test(&self) -> Element {
        let section = |(section, number): (&Section, usize)| {
            let item = |name: &String| element("assessment-item-ref").with("identifier", name).with("href", file(name));
            element("assessment-section")
                .with("identifier", format!("section-{number}"))
                .with("title", &section.title)
                .with("visible", "true")
                .holding(element("selection").with("select", "1"))
                .holding_all(section.items.iter().map(item))
        };
        let part = element("test-part")
            .with("identifier", "part")
            .with("navigation-mode", "nonlinear")
            .with("submission-mode", "individual")
            .holding_all(self.sections.iter().zip(1..).map(section));
        element("assessment-test")
            .with("xmlns", self.dialect.namespace)
            .with("identifier", "momentous")
            .with("title", &self.title)
            .holding(part)
    }

    fn manifest(&mut self) -> Element {
        let [schema, version] = self.dialect.schema;
        let metadata =
            element("metadata").holding(element("schema").text(schema)).holding(element("schemaversion").text(version));
        let items = self.sections.iter().flat_map(|section| &section.items);
        let needed = items.map(|name| element("dependency").with("identifierref", format!("resource-{name}")));
        let test = self.resource("test", "test", "test.xml").holding_all(needed);
        let resources = std::mem::take(&mut self.resources);
        element("manifest")
            .with("xmlns", self.dialect.manifest)
            .with("identifier", "manifest")
            .holding(metadata)
            .holding(element("organizations"))
            .holding(element("resources").holding(test).holding_all(resources))
    }

    fn resource(&self, name: &str, kind: &str, path: &str) -> Element {
        element("resource")
            .with("identifier", format!("resource-{name}"))
            .with("type", format!("imsqti_{kind}_{}", self.dialect.resource))
            .with("href", path)
            .holding(listed(path))
    }
}

fn listed(path: &str) -> Element {
    element("file").with("href", path)
}

fn file(name: &str) -> String {
    format!("items/{name}.xml")
}
