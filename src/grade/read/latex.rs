//! The LaTeX of numbers, units and vectors, in the plain signs that they stand for.

/// How deeply arguments may be nested.
const MAX_DEPTH: usize = 8;

/// Commands without an argument, and what they stand for.
const SIGNS: &[(&str, &str)] = &[
    ("geqslant", "≥"),
    ("leqslant", "≤"),
    ("geq", "≥"),
    ("leq", "≤"),
    ("ge", "≥"),
    ("le", "≤"),
    ("gt", ">"),
    ("lt", "<"),
    ("neq", "≠"),
    ("infty", "∞"),
    ("in", "∈"),
    ("pm", "±"),
    ("approx", "≈"),
    ("sim", "~"),
    ("degree", "°"),
    ("angle", "∠"),
    ("div", "÷"),
    ("ast", "*"),
    ("rightarrow", "→"),
    ("to", "→"),
    ("leftarrow", "←"),
    ("uparrow", "↑"),
    ("downarrow", "↓"),
    ("imath", "i"),
    ("jmath", "j"),
    ("quad", " "),
    ("qquad", " "),
    ("displaystyle", ""),
    ("rm", ""),
    ("big", ""),
    ("bigl", ""),
    ("bigr", ""),
];
/// Functions, which are read by their names.
const FUNCTIONS: &[&str] = &["arcsin", "arccos", "arctan", "sin", "cos", "tan", "ln", "lg", "exp"];
/// Commands of one character that are nothing but space, or nothing.
const SPACES: &[(char, &str)] = &[(':', " "), ('>', " "), ('!', ""), ('(', ""), (')', ""), ('[', ""), (']', "")];
/// Commands whose argument is read as it stands.
const BARE: &[&str] =
    &["num", "si", "mathit", "boldsymbol", "bm", "operatorname", "mbox", "textbf", "textit", "overrightarrow"];
/// Commands that make a vector of a letter.
const VECTORS: &[&str] = &["hat", "vec", "mathbf", "boldsymbol", "bm", "textbf", "widehat"];
/// A unit vector by its letter.
const UNIT_VECTORS: &[(&str, &str)] =
    &[("i", "î"), ("j", "ĵ"), ("k", "k\u{302}"), ("x", "x\u{302}"), ("y", "ŷ"), ("z", "z\u{302}")];
/// Names of prefixes, which are glued to the unit behind them.
const PREFIXES: &[&str] = &["kilo", "milli", "centi", "mega", "micro", "giga", "nano"];

/// A text and, for each of its bytes, the character of the answer.
pub(super) type Placed = (String, Vec<usize>);

/// The answer with the commands replaced that this table knows; others are left as they are.
pub(super) fn expanded(answer: &str) -> Placed {
    let characters: Vec<char> = answer.chars().collect();
    let mut out = Out::default();
    expand(&characters, 0, 0, false, &mut out);
    (out.text, out.places)
}

#[derive(Default)]
struct Out {
    text: String,
    places: Vec<usize>,
}

impl Out {
    fn push(&mut self, text: &str, place: usize) {
        self.text.push_str(text);
        self.places.resize(self.text.len(), place);
    }
}

/// Writes out these characters, the first of which stands at `place`; within a unit unknown commands are words.
fn expand(text: &[char], place: usize, depth: usize, in_unit: bool, out: &mut Out) {
    let mut at = 0;
    while let Some([first, rest @ ..]) = text.get(at..) {
        let here = place + at;
        if *first == '~' && at > 0 {
            out.push(" ", here);
            at += 1;
            continue;
        }
        if *first != '\\' || depth >= MAX_DEPTH {
            out.push(first.encode_utf8(&mut [0; 4]), here);
            at += 1;
            continue;
        }
        let length = rest.iter().take_while(|next| next.is_ascii_alphabetic()).count();
        let name: String = rest.iter().take(length).collect();
        if let Some((_, written)) = SPACES.iter().find(|(sign, _)| length == 0 && rest.first() == Some(sign)) {
            out.push(written, here);
            at += 2;
            continue;
        }
        let mut reader = Arguments { text, at: at + 1 + length };
        if command(&name, &mut reader, place, depth, in_unit, out) {
            at = reader.at;
        } else {
            out.push("\\", here);
            at += 1;
        }
    }
}

/// Writes out a command with its arguments; whether it is known.
fn command(name: &str, reader: &mut Arguments<'_>, place: usize, depth: usize, in_unit: bool, out: &mut Out) -> bool {
    let here = place + reader.at - 1;
    let put = |(start, text): (usize, &[char]), in_unit: bool, out: &mut Out| {
        expand(text, place + start, depth + 1, in_unit, out);
    };
    if ["frac", "dfrac", "tfrac"].contains(&name) {
        let (Some(above), Some(below)) = (reader.next(), reader.next()) else { return false };
        let is_number = [above.1, below.1].concat().iter().any(char::is_ascii_digit);
        let (open, between, close) = if is_number { ("((", ")/(", "))") } else { (" (", ")/(", ")") };
        out.push(open, here);
        put(above, false, out);
        out.push(between, here);
        put(below, false, out);
        out.push(close, here);
    } else if ["SI", "qty"].contains(&name) {
        let (Some(number), Some(unit)) = (reader.next(), reader.next()) else { return false };
        put(number, false, out);
        out.push(" ", here);
        put(unit, true, out);
    } else if name == "ang" {
        let Some(angle) = reader.next() else { return false };
        put(angle, false, out);
        out.push("°", here);
    } else if let Some((letter, start)) = VECTORS.contains(&name).then(|| reader.letter()).flatten() {
        let vector = UNIT_VECTORS.iter().find(|(listed, _)| *listed == letter);
        match vector.filter(|_| name == "hat" || ["i", "j", "k"].contains(&letter.as_str())) {
            Some((_, vector)) => out.push(vector, place + start),
            None => out.push(&letter, place + start),
        }
    } else if BARE.contains(&name) || name == "unit" && in_unit {
        let Some(argument) = reader.next() else { return false };
        put(argument, name == "si", out);
    } else if let Some((_, written)) = SIGNS.iter().find(|(listed, _)| *listed == name) {
        out.push(written, here);
    } else if FUNCTIONS.contains(&name) {
        out.push(name, here);
    } else if ["begin", "end"].contains(&name) {
        let Some((_, kind)) = reader.next() else { return false };
        if !kind.iter().collect::<String>().ends_with("matrix") {
            return false;
        }
        out.push(if name == "begin" { "(" } else { ")" }, here);
    } else if name.is_empty() && reader.text.get(reader.at) == Some(&'\\') {
        // The rows of a column.
        reader.at += 1;
        out.push(", ", here);
    } else if in_unit && !name.is_empty() {
        out.push(" ", here);
        out.push(name, here);
        out.push(if PREFIXES.contains(&name) { "" } else { " " }, here);
        if PREFIXES.contains(&name) && reader.text.get(reader.at) == Some(&'\\') {
            // The unit follows its prefix at once.
            let rest = reader.text.iter().skip(reader.at + 1);
            let unit: String = rest.take_while(|next| next.is_ascii_alphabetic()).collect();
            out.push(&unit, here);
            out.push(" ", here);
            reader.at += 1 + unit.len();
        }
    } else {
        return false;
    }
    true
}

/// The arguments behind a command.
struct Arguments<'t> {
    text: &'t [char],
    at: usize,
}

impl<'t> Arguments<'t> {
    /// The text in braces here, or the one character; with its place.
    fn next(&mut self) -> Option<(usize, &'t [char])> {
        while self.text.get(self.at) == Some(&' ') {
            self.at += 1;
        }
        let start = self.at;
        if self.text.get(start)? != &'{' {
            self.at += 1;
            return self.text.get(start..=start).map(|one| (start, one)).filter(|(_, one)| one != &['\\']);
        }
        let mut depth = 0;
        for (offset, next) in self.text.get(start..)?.iter().enumerate() {
            depth += i32::from(*next == '{') - i32::from(*next == '}');
            if depth == 0 {
                self.at = start + offset + 1;
                return self.text.get(start + 1..start + offset).map(|inner| (start + 1, inner));
            }
        }
        None
    }

    /// The one letter in the argument here, within whatever commands, and its place.
    fn letter(&mut self) -> Option<(String, usize)> {
        let before = self.at;
        while self.text.get(self.at) == Some(&' ') {
            self.at += 1;
        }
        let whole: (usize, &[char]) = if self.text.get(self.at) == Some(&'\\') {
            let start = self.at;
            let length = self.text.get(start + 1..)?.iter().take_while(|next| next.is_ascii_alphabetic()).count();
            self.at = start + 1 + length;
            (start, self.text.get(start..self.at)?)
        } else {
            self.next()?
        };
        let written: String = whole.1.iter().collect();
        let known = VECTORS.iter().chain(["imath", "jmath", "mathrm", "text"].iter());
        let mut letter = written.replace("imath", "i").replace("jmath", "j");
        for command in known {
            letter = letter.replace(&format!("\\{command}"), "");
        }
        let letter: String = letter.chars().filter(|next| !"\\{} ".contains(*next)).collect();
        if letter.chars().count() == 1 {
            return Some((letter, whole.0));
        }
        self.at = before;
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_become_what_they_stand_for() {
        let cases = [
            (r"\frac{1}{4}", "((1)/(4))"),
            (r"\frac12", "((1)/(2))"),
            (r"3.1 \frac{m}{s}", "3.1  (m)/(s)"),
            (r"\SI{-3.2}{m/s}", "-3.2 m/s"),
            (r"\SI{3.2}{\metre\per\second}", "3.2  metre  per  second "),
            (r"\qty{3.2}{\kilo\gram}", "3.2  kilogram "),
            (r"-3.2~m/s", "-3.2 m/s"),
            (r"\vec{i}", "î"),
            (r"\hat{\imath}", "î"),
            (r"\hat\jmath", "ĵ"),
            (r"\mathbf{\hat{i}}", "î"),
            (r"e \geq 0.5", "e ≥ 0.5"),
            (r"\vec{v} = 3", "v = 3"),
            (r"\begin{pmatrix} 1 \\ 2 \end{pmatrix}", "( 1 ,  2 )"),
            (r"\unknown{1}", r"\unknown{1}"),
            (r"\mathrm{~N}", r"\mathrm{ N}"),
        ];
        for (written, plain) in cases {
            let (text, places) = expanded(written);
            assert_eq!((text.as_str(), places.len()), (plain, text.len()), "{written}");
        }
    }
}
