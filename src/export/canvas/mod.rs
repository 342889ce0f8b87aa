//! QTI 1.2 as Classic Quizzes of Canvas import it: for each field of a form a group that picks one variant.

mod item;

use std::io::Write;

use super::Export;
use super::NotWritten;
use super::element::{Element, VERBATIM, element};
use super::package::Package;
use super::question::Question;

const NAMESPACE: &str = "http://www.imsglobal.org/xsd/ims_qtiasiv1p2";
const SETTINGS: &str = "http://canvas.instructure.com/xsd/cccv1p0";
const MANIFEST: &str = "http://www.imsglobal.org/xsd/imsccv1p1/imscp_v1p1";

/// A package on its way. Its questions stand in one file, which has to wait until the pictures are written.
struct Canvas<W: Write> {
    package: Package<W>,
    /// How the quiz is called: by the code of its first variant, so that another quiz does not replace it in Canvas.
    quiz: String,
    title: String,
    /// Groups that are done, as XML.
    done: String,
    points: u32,
    form: String,
    /// The groups of the form that is being written.
    groups: Vec<Group>,
    pictures: Vec<String>,
}

/// The variants of a field.
struct Group {
    name: String,
    title: String,
    points: u32,
    items: String,
}

/// Begins a package.
pub(super) fn begin<'w>(out: Box<dyn Write + 'w>, title: &str) -> Box<dyn Export + 'w> {
    Box::new(Canvas {
        package: Package::new(out),
        quiz: String::from("quiz"),
        title: title.to_owned(),
        done: String::new(),
        points: 0,
        form: String::new(),
        groups: Vec::new(),
        pictures: Vec::new(),
    })
}

impl<W: Write> Export for Canvas<W> {
    fn write(&mut self, question: &Question<'_>) -> Result<(), NotWritten> {
        if self.form.is_empty() {
            self.quiz = format!("quiz-{}", question.item.code);
        }
        let form = question.name();
        if form != self.form {
            self.end_form();
            self.form = form;
        }
        let (items, pictures) = item::items(question)?;
        self.package.pictures(item::FOLDER, &pictures)?;
        self.pictures.extend(pictures.files.into_iter().map(|(name, _)| name));
        for (field, points, item) in items {
            let place = self.groups.iter().position(|group| group.name == field).unwrap_or_else(|| {
                let title = format!("{} ({field})", question.form_title());
                self.groups.push(Group { name: field, title, points, items: String::new() });
                self.groups.len() - 1
            });
            if let Some(group) = self.groups.get_mut(place) {
                item.write(VERBATIM, &mut group.items);
                group.items.push('\n');
            }
        }
        Ok(())
    }

    fn finish(mut self: Box<Self>) -> Result<(), NotWritten> {
        self.end_form();
        let assessment = element("assessment").with("ident", &self.quiz).with("title", &self.title);
        let section = element("section").with("ident", "root_section").html(&self.done);
        let quiz = element("questestinterop").with("xmlns", NAMESPACE).holding(assessment.holding(section));
        self.package.put(&self.file(), &quiz.document(VERBATIM))?;
        let settings = element("quiz")
            .with("xmlns", SETTINGS)
            .with("identifier", &self.quiz)
            .holding(element("title").text(&self.title))
            .holding(element("points_possible").text(self.points.to_string()))
            .holding(element("allowed_attempts").text("1"));
        self.package.put(&self.settings(), &settings.document(VERBATIM))?;
        self.package.put("imsmanifest.xml", &self.manifest().document(VERBATIM))?;
        self.package.finish()
    }
}

impl<W: Write> Canvas<W> {
    /// Closes the groups of a form.
    fn end_form(&mut self) {
        for group in std::mem::take(&mut self.groups) {
            let selection = element("selection")
                .holding(element("selection_number").text("1"))
                .holding(element("selection_extension").holding(points_per_item(group.points)));
            let section = element("section")
                .with("ident", format!("{}-{}", self.form, group.name))
                .with("title", group.title)
                .holding(element("selection_ordering").holding(selection))
                .html(group.items);
            section.write(VERBATIM, &mut self.done);
            self.points += group.points;
        }
    }

    fn file(&self) -> String {
        format!("{0}/{0}.xml", self.quiz)
    }

    fn settings(&self) -> String {
        format!("{}/assessment_meta.xml", self.quiz)
    }

    fn manifest(&self) -> Element {
        let (quiz, settings) = (&self.quiz, format!("{}-settings", self.quiz));
        let file = |path: &str| element("file").with("href", path);
        let resource = |name: &str, kind: &str| element("resource").with("identifier", name).with("type", kind);
        let picture = |name: &String| {
            let path = format!("{}{name}", item::FOLDER);
            resource(&format!("picture-{name}"), "webcontent").with("href", &path).holding(file(&path))
        };
        let metadata = element("metadata")
            .holding(element("schema").text("IMS Content"))
            .holding(element("schemaversion").text("1.1.3"));
        let quiz_resource = resource(quiz, "imsqti_xmlv1p2")
            .holding(file(&self.file()))
            .holding(element("dependency").with("identifierref", &settings));
        let about = resource(&settings, "associatedcontent/imscc_xmlv1p1/learning-application-resource")
            .with("href", self.settings())
            .holding(file(&self.settings()));
        let resources = element("resources").holding(quiz_resource).holding(about);
        element("manifest")
            .with("identifier", "manifest")
            .with("xmlns", MANIFEST)
            .holding(metadata)
            .holding(element("organizations"))
            .holding(resources.holding_all(self.pictures.iter().map(picture)))
    }
}

fn points_per_item(points: u32) -> Element {
    element("points_per_item").text(points.to_string())
}
