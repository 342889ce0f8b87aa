//! Elements of XML, as they are put together before they are written.

use std::borrow::Cow;

use quick_xml::escape::escape;

use super::printable;

/// An element.
#[derive(Clone, Debug)]
pub(super) struct Element {
    name: &'static str,
    /// Whether its name is spelt the same everywhere.
    is_html: bool,
    attributes: Vec<(&'static str, String)>,
    inside: Vec<Inside>,
}

#[derive(Clone, Debug)]
enum Inside {
    Element(Element),
    Text(String),
    /// HTML that is well-formed XML.
    Html(String),
}

/// How the names of elements and attributes are spelt.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spelling {
    pub element: fn(&str) -> Cow<'_, str>,
    pub attribute: fn(&str) -> Cow<'_, str>,
}

/// Names as they stand.
pub(super) const VERBATIM: Spelling = Spelling { element: |name| name.into(), attribute: |name| name.into() };

/// An element without anything in it.
pub(super) fn element(name: &'static str) -> Element {
    Element { name, is_html: false, attributes: Vec::new(), inside: Vec::new() }
}

/// An element of HTML among others.
pub(super) fn html_element(name: &'static str) -> Element {
    Element { is_html: true, ..element(name) }
}

impl Element {
    /// With that attribute.
    pub fn with(mut self, name: &'static str, value: impl Into<String>) -> Self {
        self.attributes.push((name, value.into()));
        self
    }

    /// With an element in it.
    pub fn holding(self, inner: Self) -> Self {
        self.holding_all([inner])
    }

    /// With elements in it.
    pub fn holding_all(mut self, inner: impl IntoIterator<Item = Self>) -> Self {
        self.inside.extend(inner.into_iter().map(Inside::Element));
        self
    }

    /// With a text in it.
    pub fn text(mut self, text: impl Into<String>) -> Self {
        self.inside.push(Inside::Text(text.into()));
        self
    }

    /// With HTML in it, which must be well-formed XML.
    pub fn html(mut self, html: impl Into<String>) -> Self {
        self.inside.push(Inside::Html(html.into()));
        self
    }

    /// The element as a whole document.
    pub fn document(&self, spelling: Spelling) -> String {
        let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
        self.write(spelling, &mut out);
        out.push('\n');
        out
    }

    /// Writes the element.
    pub fn write(&self, spelling: Spelling, out: &mut String) {
        let name = self.spelt(spelling);
        self.open(spelling, out);
        if self.inside.is_empty() {
            out.truncate(out.len() - 1);
            out.push_str("/>");
            return;
        }
        for inside in &self.inside {
            match inside {
                Inside::Element(element) => element.write(spelling, out),
                Inside::Text(text) => out.push_str(&escape(printable(text))),
                Inside::Html(html) => out.push_str(&printable(html)),
            }
        }
        out.push_str("</");
        out.push_str(&name);
        out.push('>');
    }

    fn spelt(&self, spelling: Spelling) -> Cow<'_, str> {
        if self.is_html { self.name.into() } else { (spelling.element)(self.name) }
    }

    /// Writes its first tag alone.
    pub fn open(&self, spelling: Spelling, out: &mut String) {
        out.push('<');
        out.push_str(&self.spelt(spelling));
        for (name, value) in &self.attributes {
            out.push(' ');
            out.push_str(&(spelling.attribute)(name));
            out.push_str("=\"");
            out.push_str(&escape(printable(value)));
            out.push('"');
        }
        out.push('>');
    }
}
