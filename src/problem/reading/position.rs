//! From paths to bytes of the source: where a fault is to be shown.

use std::collections::BTreeMap;

use momentous_fault::{Fault, Faults, Path, Segment, Source, Span};

use super::document::{Document, Kind, Node, Scalar, Style};

/// The places of a document. It is made from the text only when there is a fault to show.
///
/// ```
/// use momentous_fault::{Path, Source};
/// use momentous_problem::Index;
/// let source = Source::new("a.yaml", "given:\n  e: 0.7\n");
/// let index = Index::of(&source);
/// let span = index.place(&Path::root().key("given").key("e")).unwrap();
/// assert_eq!(&source.text[span.start..span.end], "0.7");
/// ```
#[derive(Clone, Debug)]
pub struct Index {
    source: Source,
    root: Option<Node>,
}

impl Index {
    /// The places of the document in a source.
    #[must_use]
    pub fn of(source: &Source) -> Self {
        Self { source: source.clone(), root: Document::read(source).root }
    }

    /// The same, of a document that is read already.
    #[must_use]
    pub fn new(source: &Source, root: Option<Node>) -> Self {
        Self { source: source.clone(), root }
    }

    /// The bytes to show for a path: a value, a key ([`Path::name`]), or, of what is not there, the nearest part around it.
    /// A mapping or a list that runs over several lines is shown by its key.
    #[must_use]
    pub fn place(&self, path: &Path) -> Option<Span> {
        self.find(path).map(|(span, _)| span)
    }

    /// The fault with its span, from its path and its place within the scalar there.
    #[must_use]
    pub fn locate(&self, fault: Fault) -> Fault {
        self.locate_by(fault, &mut BTreeMap::new())
    }

    /// The same, with the ways through the texts of scalars that were gone before.
    fn locate_by(&self, fault: Fault, ways: &mut BTreeMap<Span, Way>) -> Fault {
        let (None, Some(path)) = (fault.span, &fault.path) else { return fault };
        let Some((mut span, scalar)) = self.find(path) else { return fault };
        if let (Some(scalar), Some(within)) = (scalar, fault.within) {
            let written = self.source.text.get(span.start..span.end).unwrap_or_default();
            let way = ways.entry(span).or_insert_with(|| Way::through(scalar, written));
            if let (Some(start), Some(end)) = (way.at(within.start), way.at(within.end)) {
                span = Span { start: span.start + start, end: span.start + end };
            }
        }
        fault.at(span)
    }

    /// All these faults, each with its place, in the order of the file.
    #[must_use]
    pub fn locate_all(&self, faults: Vec<Fault>) -> Faults {
        let mut ways = BTreeMap::new();
        let mut list: Vec<Fault> = faults.into_iter().map(|fault| self.locate_by(fault, &mut ways)).collect();
        list.sort_by_key(|fault| fault.span);
        // What stands in a line of the file is told once, however many forms it spoils and however often it stands there.
        let line = |fault: &Fault| Some(self.source.text.get(..fault.span?.start)?.matches('\n').count());
        list.dedup_by(|later, earlier| {
            later.span.is_some() && later.message == earlier.message && line(later) == line(earlier)
        });
        Faults { source: self.source.clone(), list }
    }

    fn find(&self, path: &Path) -> Option<(Span, Option<&Scalar>)> {
        let mut node = self.root.as_ref()?;
        let mut heading = None;
        for segment in path.segments() {
            let child = match &segment {
                Segment::Key(key) => node.entry(key).map(|entry| (Some(entry.key_span), &entry.value)),
                Segment::Index(index) => node.items().get(*index).map(|item| (None, item)),
                Segment::Name(key) => match node.entry(key) {
                    Some(entry) => return Some((entry.key_span, None)),
                    None => None,
                },
            };
            let Some(child) = child else { return Some((self.show(node, heading), None)) };
            (heading, node) = child;
        }
        let scalar = match &node.kind {
            Kind::Scalar(scalar) if !scalar.text.is_empty() => Some(scalar),
            _ => None,
        };
        Some((self.show(node, heading), scalar))
    }

    fn show(&self, node: &Node, heading: Option<Span>) -> Span {
        let Span { start, end } = node.span;
        let text = self.source.text.get(start..end).unwrap_or_default();
        match (&node.kind, heading) {
            (Kind::Scalar(scalar), Some(key)) if scalar.text.is_empty() && text.is_empty() => key,
            (Kind::Scalar(_), _) => node.span,
            (_, Some(key)) if text.contains('\n') => key,
            _ => Span { start, end: start + text.lines().next().map_or(0, str::len) },
        }
    }
}

/// The way from the bytes of a scalar's text to the text as written.
struct Way {
    /// For each character its byte in the text and in the text as written, as far as no escape is in the way.
    steps: Vec<(usize, usize)>,
    /// The end of the text, if it was gone through to its end.
    end: Option<usize>,
}

impl Way {
    fn through(scalar: &Scalar, written: &str) -> Self {
        let mut steps = Vec::with_capacity(scalar.text.len());
        let end = Self::walk(scalar, written, &mut steps);
        Self { steps, end }
    }

    fn walk(scalar: &Scalar, written: &str, steps: &mut Vec<(usize, usize)>) -> Option<usize> {
        let quote = match scalar.style {
            Style::Quoted => written.chars().next(),
            Style::Plain | Style::Block => None,
        };
        let mut at = quote.map_or(0, char::len_utf8);
        for (byte, wanted) in scalar.text.char_indices() {
            let here = written.get(at..)?;
            if !wanted.is_whitespace() {
                at += here.len() - here.trim_start().len();
            }
            steps.push((byte, at));
            if wanted.is_whitespace() {
                at += here.chars().next().filter(|next| next.is_whitespace()).map_or(0, char::len_utf8);
                continue;
            }
            let sign = written.get(at..)?.chars().next()?;
            if sign != wanted || (sign == '\\' && quote == Some('"')) {
                return None;
            }
            let doubled = sign == '\'' && quote == Some('\'');
            at += sign.len_utf8() * if doubled { 2 } else { 1 };
        }
        Some(at.min(written.len()))
    }

    /// The place of the byte `target` of the text; `None` where an escape is in the way.
    fn at(&self, target: usize) -> Option<usize> {
        let next = self.steps.partition_point(|(byte, _)| *byte < target);
        self.steps.get(next).map(|(_, at)| *at).or(self.end)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use momentous_fault::Code;

    const TEXT: &str = "id: a\nscene:\n  bodies:\n    A: { mass: 'm''_A + x' }\ngiven:\n  e: m_A + zz\ntext: >\n  One {{ a }}\n  two {{ zz }}\n  three.\nempty:\n";

    fn shown(path: &Path, within: Option<Span>) -> String {
        let source = Source::new("a.yaml", TEXT);
        let mut fault = Fault::new(Code::Value, "wrong").at_path(path.clone());
        fault.within = within;
        let span = Index::of(&source).locate(fault).span.unwrap();
        source.text[span.start..span.end].to_owned()
    }

    #[test]
    fn paths_lead_to_values_keys_and_the_nearest_part_of_what_is_missing() {
        let root = Path::root();
        let body = root.key("scene").key("bodies").key("A");
        assert_eq!(shown(&root.key("id"), None), "a");
        assert_eq!(shown(&body.name("mass"), None), "mass");
        assert_eq!(shown(&body.key("mass"), None), "'m''_A + x'");
        assert_eq!(shown(&body.key("colour"), None), "{ mass: 'm''_A + x' }");
        assert_eq!(shown(&root.key("scene").key("axes"), None), "scene");
        assert_eq!(shown(&root.key("title"), None), "id: a");
        assert_eq!(shown(&root.key("empty"), None), "empty");
    }

    #[test]
    fn a_place_within_a_scalar_is_exact_in_every_style() {
        let root = Path::root();
        let within = |start, end| Some(Span { start, end });
        assert_eq!(shown(&root.key("given").key("e"), within(6, 8)), "zz");
        let mass = root.key("scene").key("bodies").key("A").key("mass");
        assert_eq!(shown(&mass, within(7, 8)), "x");
        let folded = "One {{ a }} two {{ zz }} three.";
        let start = folded.find("zz").unwrap();
        assert_eq!(shown(&root.key("text"), within(start, start + 2)), "zz");
    }
}
