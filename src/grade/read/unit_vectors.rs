//! Unit vectors in a text.

/// Unit vectors along the first, second and third axis, the longer writings first.
const UNIT_VECTORS: [&[&str]; 3] =
    [&["i\u{302}", "x\u{302}", "î", "i"], &["j\u{302}", "y\u{302}", "ĵ", "ŷ", "j"], &["k\u{302}", "z\u{302}", "k"]];

/// The places of unit vectors: the axis, and the bytes.
pub(super) fn unit_vectors(text: &str) -> Vec<(usize, usize, usize)> {
    let mut places = Vec::new();
    let mut before = ' ';
    for (at, next) in text.char_indices() {
        let names =
            UNIT_VECTORS.iter().enumerate().flat_map(|(axis, names)| names.iter().map(move |name| (axis, *name)));
        let mut here = names.filter(|(_, name)| text[at..].starts_with(name));
        if let Some((axis, name)) = here.next().filter(|_| !before.is_alphabetic() && before != '^') {
            let end = at + name.len();
            // `i.e.` is no unit vector.
            if !text[end..].starts_with(|next: char| next.is_alphanumeric() || next == '\u{302}')
                && !text[at..].starts_with("i.e")
            {
                places.push((axis, at, end));
            }
        }
        before = next;
    }
    places
}
