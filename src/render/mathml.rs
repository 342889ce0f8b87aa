//! `MathML` as a tree, for what writes it in another language.

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

/// An element with its attributes and what it holds.
#[derive(Debug, Default)]
pub(super) struct Element {
    /// Its name without a prefix.
    pub name: String,
    attributes: Vec<(String, String)>,
    nodes: Vec<Node>,
}

/// The element that holds nothing.
pub(super) static NOTHING: Element = Element { name: String::new(), attributes: Vec::new(), nodes: Vec::new() };

/// The content of an element.
#[derive(Debug)]
pub(super) enum Node {
    Element(Element),
    Text(String),
}

impl Element {
    /// The element that a well-formed text holds; of any other text, what can be read of it.
    pub fn read(text: &str) -> Self {
        let mut reader = Reader::from_str(text);
        let mut open = vec![Self::default()];
        loop {
            let node = match reader.read_event() {
                Ok(Event::Start(tag)) => {
                    open.push(Self::opened(&tag));
                    continue;
                }
                Ok(Event::Empty(tag)) => Some(Node::Element(Self::opened(&tag))),
                Ok(Event::End(_)) => open.pop().map(Node::Element),
                Ok(Event::Text(text)) => text.decode().ok().map(|text| Node::Text(text.into_owned())),
                Ok(Event::GeneralRef(name)) => name.decode().ok().and_then(|name| referred(&name)).map(Node::Text),
                Ok(Event::Eof) | Err(_) => break,
                Ok(_) => None,
            };
            if let (Some(element), Some(node)) = (open.last_mut(), node) {
                element.nodes.push(node);
            }
        }
        let Some(whole) = open.into_iter().next() else { return Self::default() };
        whole
            .nodes
            .into_iter()
            .find_map(|node| if let Node::Element(root) = node { Some(root) } else { None })
            .unwrap_or_default()
    }

    fn opened(tag: &BytesStart) -> Self {
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        let attributes = tag
            .attributes()
            .flatten()
            .map(|attribute| (text(attribute.key.as_ref()), text(&attribute.value)))
            .collect();
        Self { name: text(tag.local_name().as_ref()), attributes, nodes: Vec::new() }
    }

    /// The elements that it holds.
    pub fn elements(&self) -> impl Iterator<Item = &Self> {
        self.nodes.iter().filter_map(|node| if let Node::Element(element) = node { Some(element) } else { None })
    }

    /// The value of an attribute, as it is written.
    pub fn attribute(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(key, _)| key == name).map(|(_, value)| value.as_str())
    }

    /// All text in it.
    pub fn text(&self) -> String {
        let text = |node: &Node| match node {
            Node::Element(element) => element.text(),
            Node::Text(text) => text.clone(),
        };
        self.nodes.iter().map(text).collect()
    }
}

/// The sign that a reference stands for.
fn referred(name: &str) -> Option<String> {
    let number = match name.strip_prefix('#') {
        Some(number) => match number.strip_prefix('x') {
            Some(digits) => u32::from_str_radix(digits, 16).ok()?,
            None => number.parse().ok()?,
        },
        None => return quick_xml::escape::resolve_predefined_entity(name).map(str::to_owned),
    };
    char::from_u32(number).map(String::from)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elements_hold_their_text_and_attributes() {
        let math = Element::read(
            "<math><mi mathvariant=\"normal\">a</mi><mo>&lt;</mo><mrow><mn>1</mn>&#x2212;&#8722;</mrow><mspace/></math>",
        );
        assert_eq!(math.name, "math");
        let names: Vec<&str> = math.elements().map(|element| element.name.as_str()).collect();
        assert_eq!(names, ["mi", "mo", "mrow", "mspace"]);
        assert_eq!(math.elements().next().unwrap().attribute("mathvariant"), Some("normal"));
        assert_eq!(math.text(), "a<1\u{2212}\u{2212}");
    }
}
