//! A position in a YAML document, named by the keys and indices that lead to it.

use std::fmt;
use std::sync::Arc;

/// One step of a [`Path`].
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Segment {
    /// Into a mapping: the value of a key.
    Key(Arc<str>),
    /// Into a mapping: the key itself, for a fault in a name.
    Name(Arc<str>),
    /// Into a list, by position from 0.
    Index(usize),
}

/// A position in a YAML document. Code that knows what a value means says where it stands by its path; the loader
/// turns paths into spans of the text, and only when there is a fault to show.
///
/// A path shares its beginning with the path that it was made from, so making one and cloning one are cheap.
///
/// ```
/// use momentous_fault::Path;
/// let impact = Path::root().key("scene").key("stages").index(0).key("impact");
/// assert_eq!(impact.to_string(), "scene.stages[0].impact");
/// ```
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Path(Option<Arc<Node>>);

#[derive(Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
struct Node {
    parent: Path,
    segment: Segment,
}

impl Path {
    /// The whole document.
    #[must_use]
    pub fn root() -> Self {
        Self(None)
    }

    /// The value of a key of this mapping.
    #[must_use]
    pub fn key(&self, key: impl Into<Arc<str>>) -> Self {
        self.step(Segment::Key(key.into()))
    }

    /// A key of this mapping itself, rather than its value: for a fault in the name that an author chose.
    #[must_use]
    pub fn name(&self, key: impl Into<Arc<str>>) -> Self {
        self.step(Segment::Name(key.into()))
    }

    /// An item of this list, counted from 0.
    #[must_use]
    pub fn index(&self, index: usize) -> Self {
        self.step(Segment::Index(index))
    }

    /// One step further.
    #[must_use]
    pub fn step(&self, segment: Segment) -> Self {
        Self(Some(Arc::new(Node { parent: self.clone(), segment })))
    }

    /// The mapping or list that this position is in; `None` for the whole document.
    #[must_use]
    pub fn parent(&self) -> Option<&Path> {
        self.0.as_deref().map(|node| &node.parent)
    }

    /// The last step; `None` for the whole document.
    #[must_use]
    pub fn last(&self) -> Option<&Segment> {
        self.0.as_deref().map(|node| &node.segment)
    }

    /// The steps from the whole document to here.
    #[must_use]
    pub fn segments(&self) -> Vec<Segment> {
        let mut segments: Vec<Segment> =
            std::iter::successors(Some(self), |path| path.parent()).filter_map(|path| path.last().cloned()).collect();
        segments.reverse();
        segments
    }
}

impl FromIterator<Segment> for Path {
    fn from_iter<I: IntoIterator<Item = Segment>>(segments: I) -> Self {
        segments.into_iter().fold(Self::root(), |path, segment| path.step(segment))
    }
}

impl fmt::Display for Path {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (position, segment) in self.segments().iter().enumerate() {
            match segment {
                Segment::Key(key) | Segment::Name(key) if position == 0 => write!(out, "{key}")?,
                Segment::Key(key) | Segment::Name(key) => write!(out, ".{key}")?,
                Segment::Index(index) => write!(out, "[{index}]")?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_reads_as_it_is_spoken_and_knows_its_parent() {
        let path = Path::root().key("given").key("m_A").key("one_of").index(2);
        assert_eq!(path.to_string(), "given.m_A.one_of[2]");
        assert_eq!(path.parent().map(ToString::to_string).as_deref(), Some("given.m_A.one_of"));
        assert_eq!(path.segments().into_iter().collect::<Path>(), path);
        assert_eq!(Path::root().to_string(), "");
    }
}
