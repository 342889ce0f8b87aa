//! A reader of XML, and of the text in HTML.

use quick_xml::Reader;
use quick_xml::events::Event;

/// An element.
#[derive(Clone, Debug, Default)]
pub struct Node {
    pub name: String,
    pub attributes: Vec<(String, String)>,
    pub children: Vec<Node>,
    pub text: String,
    /// What stands between its tags, as it is written.
    pub inner: String,
    pub start: usize,
}

impl Node {
    pub fn all<'n>(&'n self, name: &'n str) -> impl Iterator<Item = &'n Node> + use<'n> {
        self.children.iter().filter(move |child| child.name == name)
    }

    pub fn at(&self, path: &[&str]) -> Option<&Node> {
        path.iter().try_fold(self, |node, name| node.children.iter().find(|child| child.name == *name))
    }

    pub fn text_at(&self, path: &[&str]) -> &str {
        self.at(path).map_or("", |node| &node.text)
    }

    /// Visits the node and everything in it.
    pub fn walk<'n>(&'n self, visit: &mut impl FnMut(&'n Node)) {
        visit(self);
        self.children.iter().for_each(|child| child.walk(visit));
    }

    /// The text of the node and of everything in it.
    pub fn whole_text(&self) -> String {
        decoded(&self.inner)
    }

    pub fn attribute(&self, name: &str) -> &str {
        self.attributes.iter().find(|(key, _)| key == name).map_or("", |(_, value)| value)
    }
}

/// The root of a document.
pub fn read(xml: &str) -> Node {
    let mut reader = Reader::from_str(xml);
    let mut open = vec![Node::default()];
    loop {
        let before = place(&reader);
        match reader.read_event().unwrap() {
            Event::Start(start) => {
                let attributes = attributes(&start);
                let name = String::from_utf8(start.name().as_ref().to_vec()).unwrap();
                open.push(Node { name, attributes, start: place(&reader), ..Node::default() });
            }
            Event::Empty(start) => {
                let attributes = attributes(&start);
                let name = String::from_utf8(start.name().as_ref().to_vec()).unwrap();
                open.last_mut().unwrap().children.push(Node { name, attributes, ..Node::default() });
            }
            Event::End(_) => {
                let mut node = open.pop().unwrap();
                xml[node.start..before].clone_into(&mut node.inner);
                open.last_mut().unwrap().children.push(node);
            }
            Event::Text(text) => open.last_mut().unwrap().text.push_str(&text.decode().unwrap()),
            Event::CData(text) => open.last_mut().unwrap().text.push_str(&text.decode().unwrap()),
            Event::GeneralRef(name) => {
                let name = name.decode().unwrap();
                open.last_mut().unwrap().text.push_str(&decoded(&format!("&{name};")));
            }
            Event::Eof => break,
            _ => {}
        }
    }
    assert_eq!(open.len(), 1, "an element is open");
    open.pop().unwrap().children.pop().unwrap()
}

fn place(reader: &Reader<&[u8]>) -> usize {
    usize::try_from(reader.buffer_position()).unwrap()
}

fn attributes(start: &quick_xml::events::BytesStart<'_>) -> Vec<(String, String)> {
    let attribute = |read: quick_xml::events::attributes::Attribute<'_>| {
        let name = String::from_utf8(read.key.as_ref().to_vec()).unwrap();
        (name, decoded(std::str::from_utf8(&read.value).unwrap()))
    };
    start.attributes().map(|attribute_read| attribute(attribute_read.unwrap())).collect()
}

/// Text of HTML: without elements, references read.
pub fn decoded(html: &str) -> String {
    let mut out = String::new();
    let mut rest = html;
    while let Some(first) = rest.chars().next() {
        if first == '<' {
            rest = rest.split_once('>').unwrap().1;
        } else if first == '&' {
            let (name, after) = rest[1..].split_once(';').unwrap();
            out.push(match name {
                "amp" => '&',
                "lt" => '<',
                "gt" => '>',
                "quot" => '"',
                "apos" => '\'',
                number => char::from_u32(number.trim_start_matches('#').parse().unwrap()).unwrap(),
            });
            rest = after;
        } else {
            out.push(first);
            rest = &rest[first.len_utf8()..];
        }
    }
    out
}
