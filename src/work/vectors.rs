//! Equations of vectors: `m_A \vec{v}_A1 + m_B \vec{v}_B1 = (4, -3) N s` states one equation along each axis.

use std::collections::BTreeMap;
use std::collections::BTreeSet;

use momentous_expr::SymbolTable;
use momentous_quantity::Unit;

use super::cross;
use super::series::terms;
use super::spelling::letters;

/// Commands and signs that mark a vector.
const MARKS: [&str; 6] = ["\\overrightarrow", "\\boldsymbol", "\\mathbf", "\\vec", "\\bm", "\u{20d7}"];
/// Unit vectors along x, y and z, in every spelling; of those that begin alike the longest stands first.
const UNIT_VECTORS: [[&str; 8]; 3] = [
    ["\\hat{\\imath}", "\\hat{i}", "\\hat i", "\\hat{x}", "\\hat x", "ihat", "x_hat", "î"],
    ["\\hat{\\jmath}", "\\hat{j}", "\\hat j", "\\hat{y}", "\\hat y", "jhat", "y_hat", "ĵ"],
    ["\\hat{k}", "\\hat k", "\\hat{z}", "\\hat z", "khat", "z_hat", "k̂", "ẑ"],
];
/// Letters of unit vectors, where the problem has no such quantity.
const LETTERS: [char; 3] = ['i', 'j', 'k'];
/// How units are set in LaTeX.
const SETTING: [&str; 7] = ["\\,", "\\;", "\\text", "\\mathrm", "{", "}", "~"];
const AXES: [&str; 3] = ["x", "y", "z"];

/// The vectors of a problem.
#[derive(Clone, Debug, Default)]
pub(crate) struct Vectors {
    /// The axes along which there are components: positions in `AXES`.
    axes: Vec<usize>,
    /// The names whose components are quantities, by their letters alone.
    names: BTreeMap<String, String>,
    /// Quantities that are called like a unit vector.
    letters: BTreeSet<char>,
}

/// A side along one axis.
#[derive(Default)]
struct Component {
    text: String,
    has_vector: bool,
    is_none: bool,
}

impl Vectors {
    /// The vectors among the quantities of a problem.
    pub(crate) fn among(symbols: &SymbolTable) -> Self {
        let mut vectors = Self::default();
        for (_, entry) in symbols.iter() {
            let name = entry.name.as_str();
            vectors.letters.extend(LETTERS.iter().filter(|letter| name.strip_prefix(**letter) == Some("")));
            let Some((vector, component)) = name.rsplit_once('.') else { continue };
            let Some(axis) = AXES.iter().position(|axis| *axis == component) else { continue };
            vectors.names.insert(letters(vector), vector.to_owned());
            if !vectors.axes.contains(&axis) {
                vectors.axes.push(axis);
            }
        }
        vectors.axes.sort_unstable();
        let is_whole =
            |name: &String| vectors.axes.iter().all(|axis| symbols.find(&format!("{name}.{}", AXES[*axis])).is_some());
        let is_vector = |name: &String| symbols.find(name).is_none() && is_whole(name);
        let whole = vectors.names.iter().filter(|(_, name)| is_vector(name));
        let whole = whole.map(|(letters, name)| (letters.clone(), name.clone())).collect();
        vectors.names = whole;
        vectors
    }

    /// The sides along each axis, where all of them are vectors or zero. Along one axis a mark is no more than an ornament.
    pub(crate) fn components(&self, sides: &[String]) -> Option<Vec<Vec<String>>> {
        let plain: Vec<String> = sides.iter().map(|side| unmarked(side)).collect();
        if self.axes.len() < 2 {
            return (plain != sides).then(|| vec![plain]);
        }
        let part = |side: &str, axis: usize| self.along(side, axis);
        let plain: Vec<String> = match self.axes.len() {
            2 => plain.iter().map(|side| cross::along(side, &part, None).unwrap_or_else(|| side.clone())).collect(),
            _ => plain,
        };
        let along = |axis: usize| {
            let is_product = |side: &String| cross::along(side, &part, Some(axis));
            let products: Vec<Option<String>> = plain.iter().map(is_product).collect();
            let component = |(side, product): (&String, &Option<String>)| match product {
                Some(text) => Component { text: text.clone(), has_vector: true, is_none: false },
                None => self.component(side, axis),
            };
            let parts: Vec<Component> = plain.iter().zip(&products).map(component).collect();
            let is_vector = |side: &String| {
                side.trim() == "0"
                    || is_product(side).is_some()
                    || terms(side).iter().all(|term| self.component(term, axis).has_vector)
            };
            let all = plain.iter().all(is_vector) && !parts.iter().any(|part| part.is_none);
            (all && parts.iter().any(|part| part.has_vector))
                .then(|| parts.into_iter().map(|part| part.text).collect::<Vec<_>>())
        };
        (0..self.axes.len()).map(along).collect()
    }

    /// A side along an axis, where it is one vector.
    fn along(&self, side: &str, axis: usize) -> Option<String> {
        let part = self.component(side, axis);
        (axis < self.axes.len() && part.has_vector && !part.is_none).then_some(part.text)
    }

    /// Whether a name is that of a vector.
    pub(crate) fn is_vector(&self, name: &str) -> bool {
        self.axes.len() > 1 && self.names.contains_key(&letters(name))
    }

    /// A term with the sizes of its vectors as roots of sums of squares: `|v_A1 - v_B1|`, `v_A1^2`, and a vector's name among numbers.
    pub(crate) fn with_sizes(&self, term: &str) -> String {
        if self.axes.len() < 2 {
            return term.to_owned();
        }
        let term = unmarked(term);
        let (mut text, mut rest) = (String::new(), term.as_str());
        while let Some(sign) = rest.chars().next() {
            let bars = rest.strip_prefix('|').and_then(|inner| inner.split_once('|')).map(|(inner, _)| inner);
            let (vector, length) = match bars {
                Some(inner) => (inner, inner.len() + 2),
                None => (&rest[..word(rest)], word(rest)),
            };
            let parts: Vec<Component> = (0..self.axes.len()).map(|axis| self.component(vector, axis)).collect();
            // A component is a number already.
            let is_component = bars.is_none() && rest[length..].starts_with('.');
            let is_unit = bars.is_none() && is_unit(&text, vector);
            if !is_component && !is_unit && parts.iter().all(|part| part.has_vector && !part.is_none) {
                let squares: Vec<String> = parts.iter().map(|part| format!("({})^2", part.text)).collect();
                text.extend(["(sqrt(", &squares.join(" + "), "))"]);
                rest = &rest[length..];
                continue;
            }
            let length = if sign.is_alphabetic() { word(rest) } else { sign.len_utf8() };
            text.push_str(&rest[..length]);
            rest = &rest[length..];
        }
        text
    }

    /// A side along an axis: each name of a vector as that of its component, each list as one of its parts.
    fn component(&self, side: &str, axis: usize) -> Component {
        let mut component = Component::default();
        let mut rest = side;
        while let Some(sign) = rest.chars().next() {
            let taken = self
                .unit_vector(rest, &component.text, axis)
                .or_else(|| self.list(rest, axis).filter(|_| !component.text.ends_with("atan2")))
                .or_else(|| {
                    let is_unit = is_unit(&component.text, &rest[..word(rest)]);
                    (!is_unit).then(|| self.name(rest, axis, &mut component.is_none)).flatten()
                });
            if let Some((text, length)) = taken {
                component.text.push_str(&text);
                component.has_vector = true;
                rest = &rest[length..];
                continue;
            }
            // A name that is none of a vector is passed over as a whole.
            let length = if sign.is_alphabetic() { word(rest) } else { sign.len_utf8() };
            component.text.push_str(&rest[..length]);
            rest = &rest[length..];
        }
        component
    }

    fn unit_vector(&self, rest: &str, before: &str, axis: usize) -> Option<(String, usize)> {
        let (place, length) = AXES.iter().enumerate().find_map(|(place, _)| {
            let spelling = UNIT_VECTORS[place].iter().find(|unit| rest.starts_with(**unit)).map(|unit| unit.len());
            let letter = LETTERS[place];
            let is_alone = || !self.letters.contains(&letter) && word(rest) == 1 && !before.ends_with(['\\', '_', '.']);
            spelling.or_else(|| (rest.starts_with(letter) && is_alone()).then_some(1)).map(|length| (place, length))
        })?;
        let one = usize::from(self.axes.get(axis) == Some(&place));
        let is_factor =
            before.trim_end().ends_with(|sign: char| sign.is_alphanumeric() || matches!(sign, ')' | '}' | ']'));
        let (unit, behind) = unit(&rest[length..]);
        let unit = if unit.is_empty() { unit } else { format!(" {unit}") };
        Some((if is_factor { format!("{unit}*{one}") } else { format!("{one}{unit}") }, length + behind))
    }

    /// `(3, -4) m/s` as its part along an axis, with the unit behind it.
    fn list(&self, rest: &str, axis: usize) -> Option<(String, usize)> {
        let open = rest.chars().next().filter(|sign| matches!(sign, '(' | '[' | '⟨'))?;
        let (mut depth, mut parts, mut end) = (0_i32, vec![String::new()], None);
        for (at, sign) in rest.char_indices() {
            match sign {
                '(' | '[' | '{' | '⟨' => depth += 1,
                ')' | ']' | '}' | '⟩' => depth -= 1,
                _ => {}
            }
            if depth == 0 {
                end = Some(at + sign.len_utf8());
                break;
            }
            if depth == 1 && matches!(sign, ',' | ';' | '|') {
                parts.push(String::new());
            } else if let Some(last) = parts.last_mut().filter(|_| at >= open.len_utf8()) {
                last.push(sign);
            }
        }
        let (end, part) = (end?, parts.get(axis).filter(|_| parts.len() == self.axes.len())?);
        let (unit, length) = unit(&rest[end..]);
        Some((format!("({} {unit})", part.trim()).replace(" )", ")"), end + length))
    }

    fn name(&self, rest: &str, axis: usize, is_none: &mut bool) -> Option<(String, usize)> {
        let length = word(rest);
        let name = self.names.get(&letters(&rest[..length]))?;
        // The square of a vector is a number.
        *is_none |= rest[length..].trim_start().starts_with(['^', '²', '×', '.']);
        Some((format!("{name}.{}", AXES[*self.axes.get(axis)?]), length))
    }
}

/// The length of the name that a text begins with: letters, digits and an index.
fn word(text: &str) -> usize {
    let (mut depth, mut before) = (0_i32, ' ');
    for (at, sign) in text.char_indices() {
        let is_inside = match sign {
            '{' => before == '_',
            '}' => depth > 0,
            '_' | '\'' => at > 0,
            other => other.is_alphanumeric(),
        };
        if !is_inside {
            return at;
        }
        depth += i32::from(sign == '{') - i32::from(sign == '}');
        before = sign;
    }
    text.len()
}

/// The unit that a text begins with, empty where it begins with none, and its length.
fn unit(text: &str) -> (String, usize) {
    let written = text.find(['+', '-', '=', '(', ')', '*', ',', '·']).map_or(text, |at| &text[..at]);
    let plain = SETTING.iter().fold(written.to_owned(), |unit, setting| unit.replace(setting, " "));
    let plain = plain.trim();
    let is_unit = !plain.is_empty() && Unit::parse(plain).is_ok();
    if is_unit { (plain.to_owned(), written.len()) } else { (String::new(), 0) }
}

/// Whether a word is a unit, behind a number: `12 J`.
fn is_unit(before: &str, word: &str) -> bool {
    before.trim_end().ends_with(|sign: char| sign.is_ascii_digit()) && Unit::parse(word).is_ok()
}

/// A name without the brackets of its index: `v_{A1}` as `v_A1`.
fn bare(name: &str) -> String {
    name.chars().filter(|sign| !matches!(sign, '{' | '}')).collect()
}

/// A term with components as the program names them: `(v_A2)_x` and `(v_{A2})_{x}` as `v_A2.x`.
pub(crate) fn with_components(term: &str) -> String {
    let mut text = term.to_owned();
    while let Some(close) = text.find(")_") {
        let Some(open) = text[..close].rfind('(') else { return text };
        let vector = &text[open + 1..close];
        let behind = &text[close + 2..];
        let length = behind.find(|sign: char| !sign.is_alphanumeric() && !matches!(sign, '{' | '}' | '\\'));
        let (component, rest) = behind.split_at(length.unwrap_or(behind.len()));
        let component = bare(component).replace('\\', "");
        if component.is_empty() || vector.is_empty() || word(vector) != vector.len() {
            return text;
        }
        text = format!("{}{}.{component}{rest}", &text[..open], bare(vector));
    }
    text
}

/// A side without the marks of vectors: `m\vec{v}_A1` as `m v_A1`.
pub(crate) fn unmarked(side: &str) -> String {
    let mut text = side.replace("\\,", " ");
    for mark in MARKS {
        while let Some(at) = text.find(mark) {
            let behind = text[at + mark.len()..].trim_start();
            let behind = match behind.strip_prefix('{').and_then(|inner| inner.split_once('}')) {
                Some((inner, rest)) => format!("{inner}{rest}"),
                None => behind.to_owned(),
            };
            let is_joined = mark.starts_with('\\') && text[..at].ends_with(char::is_alphanumeric);
            text = format!("{}{}{behind}", &text[..at], if is_joined { " " } else { "" });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use momentous_expr::{SymbolEntry, SymbolTable};
    use momentous_quantity::Dimension;

    use super::{Vectors, with_components};

    fn symbols() -> SymbolTable {
        let mut symbols = SymbolTable::default();
        for name in ["m_A", "v_A1.x", "v_A1.y", "v_A2.x", "v_A2.y"] {
            symbols.intern(SymbolEntry { name: name.into(), dimension: Dimension::NONE, meaning: String::new() });
        }
        symbols
    }

    fn components(sides: [&str; 2]) -> Option<Vec<Vec<String>>> {
        Vectors::among(&symbols()).components(&sides.map(str::to_owned))
    }

    #[test]
    fn an_equation_of_vectors_has_one_along_each_axis() {
        let cases = [
            (["m_A \\vec{v}_{A1}", "(4, -3) N s"], [["m_A v_A1.x", "(4 N s)"], ["m_A v_A1.y", "(-3 N s)"]]),
            (["v_A2", "3 i - 4 j"], [["v_A2.x", "3 *1 - 4 *0"], ["v_A2.y", "3 *0 - 4 *1"]]),
            (["m_A v_A1 - m_A v_A2", "0"], [["m_A v_A1.x - m_A v_A2.x", "0"], ["m_A v_A1.y - m_A v_A2.y", "0"]]),
        ];
        for (sides, expected) in cases {
            let expected = expected.map(|sides| sides.map(str::to_owned).to_vec()).to_vec();
            assert_eq!(components(sides), Some(expected), "{sides:?}");
        }
    }

    #[test]
    fn the_size_of_a_vector_is_the_root_of_its_squares() {
        let vectors = Vectors::among(&symbols());
        assert_eq!(vectors.with_sizes("m_A v_A1.x"), "m_A v_A1.x");
        assert_eq!(vectors.with_sizes("m_A v_A1^2"), "m_A (sqrt((v_A1.x)^2 + (v_A1.y)^2))^2");
        assert_eq!(vectors.with_sizes("|v_A2 - v_A1|"), "(sqrt((v_A2.x - v_A1.x)^2 + (v_A2.y - v_A1.y)^2))");
        assert_eq!(with_components("(v_{A2})_{x} = 3 (v_A1)_y"), "v_A2.x = 3 v_A1.y");
    }

    #[test]
    fn a_number_is_no_vector() {
        assert_eq!(components(["v_A1", "5 m/s"]), None);
        assert_eq!(components(["12 - v_A1", "v_A1 - 3"]), None);
        assert_eq!(components(["v_A1^2", "v_A2^2"]), None);
    }
}
