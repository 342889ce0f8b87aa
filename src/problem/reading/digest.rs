//! Digests of a problem file: of its bytes, and of what its numbers, its marks and its words depend on.

use std::fmt::Write;

use sha2::{Digest, Sha256};

use momentous_fault::Source;

use super::document::{Entry, Kind, Node};

/// Digests that change only with what they stand for: comments, the order of keys and the way of writing YAML change none of them.
///
/// ```
/// use momentous_bank::Bank;
/// use momentous_fault::Source;
/// use momentous_problem::load;
/// let file = Bank::built_in().find("impact/two-carts")?.clone();
/// let now = load(file.clone())?.digests;
/// let reworded = load(Source::new("carts.yaml", &file.text.replace("They collide.", "They meet.")))?.digests;
/// assert!(reworded.draw == now.draw && reworded.marking == now.marking && reworded.words != now.words);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Digests {
    /// Everything from which the numbers of a seed follow.
    pub draw: String,
    /// Everything from which marks follow, besides the numbers.
    pub marking: String,
    /// The words that students read.
    pub words: String,
}

/// The aspects that a key may concern.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Aspect {
    Draw,
    Marking,
    Words,
}

const ALL: [Aspect; 3] = [Aspect::Draw, Aspect::Marking, Aspect::Words];

/// The aspects that the values of some keys concern, at whatever depth. Every other key concerns those of the key around it; at
/// the top, the draw and the marking.
const CONCERNS: &[(&str, &[Aspect])] = &[
    ("level", &[]),
    ("source", &[]),
    // What the author means of what `momentous check` finds.
    ("acknowledge", &[]),
    ("tags", &[]),
    // They name the draw, and stand before everything else in it.
    ("id", &[]),
    ("was", &[]),
    ("because", &[Aspect::Words]),
    ("feedback", &[Aspect::Words]),
    ("hints", &[Aspect::Words]),
    ("label", &[Aspect::Words]),
    ("text", &[Aspect::Words]),
    ("title", &[Aspect::Words]),
    ("points", &[Aspect::Marking]),
    ("rubric", &[Aspect::Marking]),
    ("name", &[Aspect::Marking, Aspect::Words]),
    ("symbols", &[Aspect::Marking, Aspect::Words]),
];

impl Digests {
    /// Digests of the document of a problem whose numbers are drawn under that identity.
    pub(super) fn new(root: &Node, drawn_as: &str) -> Self {
        let [draw, marking, words] = ALL.map(|aspect| {
            let mut hash = Sha256::new();
            if aspect == Aspect::Draw {
                hash.update(drawn_as);
            }
            feed(&mut hash, root, "", aspect, &[Aspect::Draw, Aspect::Marking]);
            hex(&hash.finalize())
        });
        Self { draw, marking, words }
    }

    /// A digest of all of them: a version of the problem that students, markers or draws can tell from another.
    #[must_use]
    pub fn version(&self) -> String {
        hex(&Sha256::digest([&*self.draw, &*self.marking, &*self.words].concat()))
    }
}

/// Feeds each value that concerns an aspect, with the keys that lead to it; what lies at `path` concerns those that are `concerned`.
fn feed(hash: &mut Sha256, node: &Node, path: &str, aspect: Aspect, concerned: &[Aspect]) {
    match &node.kind {
        Kind::Scalar(scalar) if concerned.contains(&aspect) => hash.update(format!("{path}={}\n", scalar.text.trim())),
        Kind::Scalar(_) => {}
        Kind::List(items) => {
            for (place, item) in items.iter().enumerate() {
                feed(hash, item, &format!("{path}.{place}"), aspect, concerned);
            }
        }
        Kind::Mapping(mapping) => {
            let mut entries: Vec<&Entry> = mapping.entries().iter().collect();
            entries.sort_by(|one, other| one.key.cmp(&other.key));
            for Entry { key, value, .. } in entries {
                feed(hash, value, &format!("{path}.{key}"), aspect, aspects(key, value).unwrap_or(concerned));
            }
        }
    }
}

/// The points of a scene and of a graph are no marks, and are not a single value.
fn aspects(key: &str, value: &Node) -> Option<&'static [Aspect]> {
    // What marking must say of an author's own answers; in a form, `expect` is a word.
    if key == "expect" && matches!(value.kind, Kind::Mapping(_)) {
        return Some(&[]);
    }
    let is_place = key == "points" && !matches!(value.kind, Kind::Scalar(_));
    CONCERNS.iter().find(|(listed, _)| *listed == key && !is_place).map(|(_, aspects)| *aspects)
}

/// The first 16 hexadecimal digits of SHA-256 of a file's bytes, each line end as a single line feed.
///
/// ```
/// use momentous_fault::Source;
/// use momentous_problem::digest;
/// assert_eq!(digest(&Source::new("a", "x: 1\r\n")), digest(&Source::new("b", "x: 1\n")));
/// ```
#[must_use]
pub fn digest(source: &Source) -> String {
    hex(&Sha256::digest(source.text.replace("\r\n", "\n").as_bytes()))
}

/// The bytes of a digest that are written down.
const BYTES: usize = 8;

/// Whether a word is written as [`digest`] writes.
#[must_use]
pub fn is_digest(word: &str) -> bool {
    word.len() == 2 * BYTES && word.bytes().all(|byte| byte.is_ascii_hexdigit())
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().take(BYTES).fold(String::new(), |mut digits, byte| {
        // Writing to a string cannot fail.
        let _ = write!(digits, "{byte:02x}");
        digits
    })
}
