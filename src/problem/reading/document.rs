//! A YAML document as it was written: every scalar is still text, and everything knows its place.

use std::collections::BTreeMap;

use saphyr_parser::{Event, Parser, ScalarStyle, StrInput};

use momentous_fault::{Code, Fault, Source, Span};

use super::syntax::way_out;

/// How deep mappings and lists may lie in one another.
const DEPTH_LIMIT: usize = 32;

/// Keys that may be written in another word of the field, and what they are called here.
pub(super) const SAME_KEYS: [(&str, &str); 2] = [("torque", "moment"), ("perfectly_inelastic", "plastic")];

/// A part of a document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Node {
    /// Its bytes; of a block scalar, those of its lines, without the mark `>` or `|`.
    pub span: Span,
    /// Its kind.
    pub kind: Kind,
}

/// The kinds of node.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A single value.
    Scalar(Scalar),
    /// Items in order.
    List(Vec<Node>),
    /// Keys with their values, in the order of the file.
    Mapping(Mapping),
}

/// A single value, as text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scalar {
    /// The text, after YAML's quotes, escapes and folds are undone.
    pub text: String,
    /// How it was written.
    pub style: Style,
}

/// The notation of a scalar.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// Without marks: `3 kg`.
    Plain,
    /// In single or double quotes.
    Quoted,
    /// After `>` or `|`, on lines of its own.
    Block,
}

/// A key and its value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// The key.
    pub key: String,
    /// The bytes of the key.
    pub key_span: Span,
    /// The value.
    pub value: Node,
}

/// Keys with their values, in the order of the file. A key stands once.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Mapping {
    entries: Vec<Entry>,
    /// The place of each key among them.
    places: BTreeMap<String, usize>,
}

impl Mapping {
    /// The entries.
    #[must_use]
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// The entry of exactly that key.
    fn get(&self, key: &str) -> Option<&Entry> {
        self.places.get(key).map(|place| &self.entries[*place])
    }

    fn push(&mut self, entry: Entry) {
        self.places.insert(entry.key.clone(), self.entries.len());
        self.entries.push(entry);
    }
}

/// The result of reading a source: the tree, unless the text is not YAML, and the faults of form.
#[derive(Clone, Debug)]
pub struct Document {
    /// The whole document.
    pub root: Option<Node>,
    /// Faults of form: no YAML, a key twice, a part of YAML that the language leaves out.
    pub faults: Vec<Fault>,
}

/// The usual name of a key: `moment` for `torque`.
pub(super) fn usual_key(key: &str) -> &str {
    SAME_KEYS.iter().find(|(other, _)| *other == key).map_or(key, |(_, usual)| usual)
}

impl Document {
    /// Reads a source. Of a key that stands twice the first is kept.
    #[must_use]
    pub fn read(source: &Source) -> Self {
        let mut reader = Reader {
            parser: Parser::new_from_str(&source.text),
            text: &source.text,
            bytes: Offsets::of(&source.text),
            line_ends: None,
            faults: Vec::new(),
        };
        let root = reader.document().unwrap_or_else(|fault| {
            reader.faults.push(fault);
            None
        });
        Self { root, faults: reader.faults }
    }
}

impl Node {
    /// The entries of a mapping; none for anything else.
    #[must_use]
    pub fn entries(&self) -> &[Entry] {
        match &self.kind {
            Kind::Mapping(mapping) => mapping.entries(),
            _ => &[],
        }
    }

    /// The items of a list; none for anything else.
    #[must_use]
    pub fn items(&self) -> &[Node] {
        match &self.kind {
            Kind::List(items) => items,
            _ => &[],
        }
    }

    /// The entry of that key, perhaps in another word for it.
    #[must_use]
    pub fn entry(&self, key: &str) -> Option<&Entry> {
        let Kind::Mapping(mapping) = &self.kind else { return None };
        let mut others = SAME_KEYS.iter().filter(|(_, usual)| *usual == key);
        mapping.get(key).or_else(|| others.find_map(|(other, _)| mapping.get(other)))
    }

    /// Whether nothing was written, or one of YAML's words for it.
    #[must_use]
    pub fn is_null(&self) -> bool {
        matches!(&self.kind, Kind::Scalar(Scalar { text, style: Style::Plain })
            if matches!(text.as_str(), "" | "~" | "null" | "Null" | "NULL"))
    }
}

struct Reader<'a> {
    parser: Parser<'a, StrInput<'a>>,
    text: &'a str,
    bytes: Offsets,
    /// The ends of its lines, once somebody has asked.
    line_ends: Option<Vec<usize>>,
    faults: Vec<Fault>,
}

type Spanned<'a> = (Event<'a>, Span);

impl<'a> Reader<'a> {
    fn document(&mut self) -> Result<Option<Node>, Fault> {
        let mut root = None;
        loop {
            let (event, span) = self.next()?;
            match event {
                Event::StreamEnd => break,
                Event::StreamStart | Event::DocumentStart(_) | Event::DocumentEnd | Event::Nothing => {}
                _ if root.is_some() => {
                    return Err(Fault::new(Code::Syntax, "a second document begins here")
                        .help("a file holds one problem: remove the line `---`, or make a second file")
                        .at(span));
                }
                _ => root = Some(self.node((event, span), 0)?),
            }
        }
        match root {
            Some(root) if !root.is_null() => Ok(Some(root)),
            _ => Err(Fault::new(Code::Syntax, "the file is empty")
                .help("`momentous new NAME` writes a commented problem to start from")
                .at(Span::default())),
        }
    }

    fn next(&mut self) -> Result<Spanned<'a>, Fault> {
        match self.parser.next_event() {
            None => Ok((Event::StreamEnd, Span::default())),
            Some(Ok((event, span))) => {
                let span = Span { start: self.bytes.byte(span.start.index()), end: self.bytes.byte(span.end.index()) };
                Ok((event, span))
            }
            Some(Err(error)) => Err(self.syntax(self.bytes.byte(error.marker().index()), error.info())),
        }
    }

    fn node(&mut self, (event, span): Spanned<'a>, depth: usize) -> Result<Node, Fault> {
        if depth > DEPTH_LIMIT {
            return Err(Fault::new(
                Code::Syntax,
                format!("lists and mappings are nested more than {DEPTH_LIMIT} deep"),
            )
            .help("no problem needs such depth: is a bracket not closed?")
            .at(span));
        }
        match event {
            Event::Scalar(text, style, anchor, tag) => {
                self.refuse(anchor != 0 || tag.is_some(), span);
                let style = match style {
                    ScalarStyle::Plain => Style::Plain,
                    ScalarStyle::SingleQuoted | ScalarStyle::DoubleQuoted => Style::Quoted,
                    ScalarStyle::Literal | ScalarStyle::Folded => Style::Block,
                };
                Ok(Node { span: self.trim(span), kind: Kind::Scalar(Scalar { text: text.into_owned(), style }) })
            }
            Event::SequenceStart(anchor, tag) => {
                self.refuse(anchor != 0 || tag.is_some(), span);
                let mut items = Vec::new();
                loop {
                    let (event, end) = self.next()?;
                    if event == Event::SequenceEnd {
                        let span = self.trim(Span { start: span.start, end: end.end });
                        return Ok(Node { span, kind: Kind::List(items) });
                    }
                    items.push(self.node((event, end), depth + 1)?);
                }
            }
            Event::MappingStart(anchor, tag) => {
                self.refuse(anchor != 0 || tag.is_some(), span);
                self.mapping(span, depth)
            }
            _ => {
                self.refuse(true, span);
                Ok(Node { span, kind: Kind::Scalar(Scalar { text: String::new(), style: Style::Quoted }) })
            }
        }
    }

    fn mapping(&mut self, start: Span, depth: usize) -> Result<Node, Fault> {
        let mut mapping = Mapping::default();
        loop {
            let (event, span) = self.next()?;
            if event == Event::MappingEnd {
                let span = self.trim(Span { start: start.start, end: span.end });
                return Ok(Node { span, kind: Kind::Mapping(mapping) });
            }
            let key = self.node((event, span), depth + 1)?;
            let value = self.next()?;
            let value = self.node(value, depth + 1)?;
            match key.kind {
                Kind::Scalar(scalar) => match mapping.get(&scalar.text) {
                    Some(first) => {
                        let line = self.line(first.key_span.start);
                        let fault = Fault::new(Code::Duplicate, format!("`{}` is repeated", scalar.text));
                        let help = format!("it is already on line {line}: keep one of the two, or rename one");
                        self.faults.push(fault.help(help).at(key.span));
                    }
                    None => mapping.push(Entry { key: scalar.text, key_span: key.span, value }),
                },
                Kind::List(_) | Kind::Mapping(_) => return Err(self.compound_key(start, key.span)),
            }
        }
    }

    /// The line of a byte, from 1.
    fn line(&mut self, byte: usize) -> usize {
        let text = self.text;
        let ends = self.line_ends.get_or_insert_with(|| text.match_indices('\n').map(|(end, _)| end).collect());
        ends.partition_point(|end| *end < byte) + 1
    }

    fn compound_key(&self, mapping: Span, key: Span) -> Fault {
        if self.text[mapping.start..].starts_with("{{") {
            return Fault::new(Code::Syntax, "YAML reads a text that begins with `{{` as a mapping")
                .help("write the text in quotes, or on the next line after `>`")
                .at(key);
        }
        Fault::new(Code::Syntax, "a key must be a word, not a list or a mapping")
            .help("write the text in quotes if it is meant as text")
            .at(key)
    }

    fn refuse(&mut self, unwanted: bool, span: Span) {
        if unwanted {
            let fault =
                Fault::new(Code::Syntax, "anchors `&`, aliases `*` and tags `!` are not allowed in a problem file");
            self.faults
                .push(fault.help("write the value out; write a text that begins with such a mark in quotes").at(span));
        }
    }

    /// The span without the blanks and line ends that the parser counts to a block's end.
    fn trim(&self, span: Span) -> Span {
        let text = self.text.get(span.start..span.end).unwrap_or_default();
        Span { start: span.start, end: span.start + text.trim_end().len() }
    }

    fn syntax(&self, byte: usize, info: &str) -> Fault {
        let line_start = self.text[..byte].rfind('\n').map_or(0, |newline| newline + 1);
        let line = self.text[line_start..].lines().next().unwrap_or_default();
        let help = way_out(info, line);
        let end =
            self.text[byte..].chars().next().filter(|next| *next != '\n').map_or(byte, |next| byte + next.len_utf8());
        Fault::new(Code::Syntax, format!("this is not YAML: {info}")).help(help).at(Span { start: byte, end })
    }
}

/// From a count of characters to bytes.
enum Offsets {
    Ascii(usize),
    Table(Vec<usize>),
}

impl Offsets {
    fn of(text: &str) -> Self {
        if text.is_ascii() {
            return Self::Ascii(text.len());
        }
        Self::Table(text.char_indices().map(|(byte, _)| byte).chain([text.len()]).collect())
    }

    fn byte(&self, character: usize) -> usize {
        match self {
            Self::Ascii(length) => character.min(*length),
            Self::Table(table) => table.get(character).or(table.last()).copied().unwrap_or(0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> (Source, Document) {
        let source = Source::new("a.yaml", text);
        let document = Document::read(&source);
        (source, document)
    }

    #[test]
    fn scalars_keep_their_text_and_their_place() {
        let (source, document) =
            read("# é\na: 0.70\nb: [007, 'x y', .5]\nc:\n  d: 3 kg # mass\n\n  e: >\n    one\n    two\n\nf: no\n");
        assert_eq!(document.faults, []);
        let root = document.root.unwrap();
        let slice = |node: &Node| source.text[node.span.start..node.span.end].to_owned();
        let value = |key: &str| slice(&root.entry(key).unwrap().value);
        assert_eq!([value("a"), value("b"), value("f")], ["0.70", "[007, 'x y', .5]", "no"]);
        let inner = &root.entry("c").unwrap().value;
        assert_eq!(slice(&inner.entries()[0].value), "3 kg");
        assert_eq!(slice(inner), "d: 3 kg # mass\n\n  e: >\n    one\n    two");
        assert_eq!(slice(&inner.entries()[1].value), "one\n    two");
        assert_eq!(slice(&root.entry("b").unwrap().value.items()[1]), "'x y'");
    }

    #[test]
    fn faults_of_form_are_collected() {
        let (source, document) = read("a: 1\nb: &x 2\na: 3\nd: *x\nc: {{ m_A }}\n");
        let texts: Vec<_> =
            document.faults.iter().map(|fault| source.line_and_column(fault.span.unwrap().start)).collect();
        assert_eq!(texts.len(), 4, "{:?}", document.faults);
    }

    #[test]
    fn hostile_depth_is_a_fault() {
        let (_, document) = read(&"[".repeat(100_000));
        assert_eq!(document.faults.len(), 1);
        assert!(document.root.is_none());
    }
}
