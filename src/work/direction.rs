//! Words of direction behind a value: `0.83 m/s to the left` is a number with a sign.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_model::QuantityKind;
use momentous_quantity::Dimension;

use super::convention::{Named, named, words};
use super::judge::Judge;
use super::phrases::says_direction;
use super::reader::term;
use super::setting::unset;
use super::sides::{last_side, sides};

/// Words with which what is said of a direction begins.
const LEADS: [&str; 13] = [
    "to", "toward", "towards", "away", "in", "i.e.", "due", "directed", "pointing", "moving", "going", "along",
    "against",
];

/// A value and what is said of its direction.
struct Directed<'t> {
    value: &'t str,
    phrase: String,
}

impl Judge<'_> {
    /// A statement with the direction behind its value as a sign: along the axis of its quantity, as the student counts.
    ///
    /// # Errors
    /// A question where the words are no direction of that axis, or say another one than the sign.
    pub(crate) fn with_direction(&self, text: &str) -> Result<String, String> {
        let plain = unset(text);
        let Some((before, last)) = last_side(&plain) else { return Ok(text.to_owned()) };
        let Some(Directed { value, phrase }) = directed(last) else { return Ok(text.to_owned()) };
        let Some((senses, is_turned)) = self.senses_of(&plain) else { return Ok(text.to_owned()) };
        let spoken = words(&phrase);
        let signs = ["positive", "negative"].map(|sign| spoken.contains(sign));
        let is_positive = match named(&spoken, &senses[0], &senses[1]) {
            Some(direction) => (direction == Named::Positive) != is_turned,
            // `in the negative direction`, as the student counts.
            None if signs[0] != signs[1] => signs[0],
            None if says_direction(&phrase) => {
                return Err(format!("which way is `{phrase}` here: {} or {}?", senses[0], senses[1]));
            }
            None => return Ok(text.to_owned()),
        };
        let value = value.trim();
        let size = value.strip_prefix(['-', '−']);
        match (is_positive, size) {
            (true, Some(_)) => Err(format!("the sign and `{phrase}` say opposite directions")),
            (false, None) => {
                let is_number = value.starts_with(|sign: char| sign.is_ascii_digit() || sign == '.');
                let last = if is_number { format!("-{value}") } else { format!("-({value})") };
                let signed = format!("{before} {last}");
                // The sides before may be sizes as well.
                let (found, _) = self.tried(&signed);
                let all = (!found.verdict.is_true()).then(|| with_all_signs(before)).flatten();
                let all = all.map(|before| format!("{before} {last}"));
                let all = all.filter(|all| self.tried(all).0.verdict.is_true());
                Ok(all.unwrap_or(signed))
            }
            _ => Ok(format!("{before} {value}")),
        }
    }

    /// The equation of a sentence with the direction behind it as a sign.
    ///
    /// # Errors
    /// As of a statement.
    pub(crate) fn equation_with_direction(&self, equation: &str, sentence: &str) -> Result<String, String> {
        let said = |text: &str| last_side(text).and_then(|(_, last)| directed(last).map(|directed| directed.phrase));
        let (None, Some(phrase)) = (said(equation), said(sentence)) else { return Ok(equation.to_owned()) };
        let whole = format!("{equation} {phrase}");
        let signed = self.with_direction(&whole)?;
        Ok(if signed == whole { equation.to_owned() } else { signed })
    }

    /// The words for the two directions of a quantity of the scene, the positive one first; none where its sign is no direction. A
    /// displacement is counted as the places are, where all of them are along one axis.
    pub(crate) fn senses(&self, symbol: Symbol) -> Option<[String; 2]> {
        let problem = self.worked.problem;
        let model = problem.model();
        if symbol.index() >= model.symbols.len() {
            return None;
        }
        let senses = |symbol: Symbol| problem.turns_with(symbol).map(|senses| [senses.positive, senses.negative]);
        if model.name(symbol).kind != QuantityKind::Displacement {
            return senses(symbol);
        }
        let mut all = model.symbols.iter().filter_map(|(symbol, _)| senses(symbol));
        let one = all.next()?;
        all.all(|other| other == one).then_some(one)
    }

    /// The words for the two directions of the quantity of which a statement gives the value, and whether the student counts the other way;
    /// where all motion is along one axis, those of it for whatever else has a direction.
    fn senses_of(&self, statement: &str) -> Option<([String; 2], bool)> {
        let sides = sides(statement)?;
        let first = sides.first()?.first()?.sides.first()?.clone();
        let (first, line) = term(&self.alphabet.asked(&first), &self.alphabet, self.mark).ok()?;
        let senses = |symbol: Symbol| Some((self.senses(symbol)?, self.turned.contains(&symbol)));
        match first {
            Expr::Symbol(symbol) => senses(symbol),
            first => {
                let dimension = first.dimension(&line.symbols).ok()?;
                let velocity = Dimension::LENGTH / Dimension::TIME;
                let is_directed = dimension == velocity || dimension == Dimension::MASS * velocity;
                let all = || first.symbols().into_iter().filter_map(senses);
                let one = all().next()?;
                let is_size = matches!(first, Expr::Power(_) | Expr::Apply(..));
                (is_directed && !is_size && all().all(|other| other == one)).then_some(one)
            }
        }
    }
}

/// The sides of a statement behind the first one with a minus: `v = 1.2/3 =` as `v = -(1.2/3) =`; `None` where there is no other.
fn with_all_signs(before: &str) -> Option<String> {
    let sides: Vec<&str> = before.trim_end().trim_end_matches('=').split('=').collect();
    let (first, others) = sides.split_first().filter(|(_, others)| !others.is_empty())?;
    let others: Vec<String> = others.iter().map(|side| format!("-({})", side.trim())).collect();
    Some(format!("{first} = {} =", others.join(" = ")))
}

/// The value that a side begins with and the words of direction behind it.
fn directed(side: &str) -> Option<Directed<'_>> {
    let side = side.trim_end_matches(['.', ',', ' ', '!']);
    // `(positive away from the wall)` says how the value is counted.
    if ["positive", "negative"].iter().any(|sign| side.contains(sign)) && !side.contains("direction") {
        return None;
    }
    let starts = side.match_indices([' ', '(']).map(|(at, _)| at).filter(|at| !side[..*at].trim().is_empty());
    starts.into_iter().find_map(|at| {
        let phrase = side[at..].trim_matches([' ', '(', ')', ',', '.']);
        let is_prose = |word: &str| {
            let word = word.trim_matches([',', '.', ';', '(', ')']);
            word.chars().all(|sign| sign.is_alphabetic() || matches!(sign, '-' | '.' | '\''))
        };
        let first = phrase.split([' ', ',']).next()?.to_lowercase();
        let second = phrase.split([' ', ',']).nth(1);
        let is_inch = first == "in" && !matches!(second, Some("the" | "positive" | "negative"));
        let leads = LEADS.contains(&first.as_str()) || says_direction(&first);
        let value = side[..at].trim_end_matches([' ', ',', '(']);
        let is_value = value.contains(|sign: char| sign.is_alphanumeric());
        (leads && !is_inch && is_value && phrase.split(' ').all(is_prose) && says_direction(phrase))
            .then(|| Directed { value, phrase: phrase.to_lowercase() })
    })
}

#[cfg(test)]
mod tests {
    use super::directed;

    #[test]
    fn a_direction_stands_behind_a_value() {
        let cases = [
            ("0.833 m/s to the left", Some(("0.833 m/s", "to the left"))),
            ("0.833 m/s left", Some(("0.833 m/s", "left"))),
            ("1.2 m/s (to the right)", Some(("1.2 m/s", "to the right"))),
            ("2.03 ft away from the quay.", Some(("2.03 ft", "away from the quay"))),
            ("-2.49 ft, i.e. away from the quay", Some(("-2.49 ft", "i.e. away from the quay"))),
            ("3.57 m/s downwards", Some(("3.57 m/s", "downwards"))),
            ("3 in", None),
            ("1.8 N s in the direction of motion", None),
            ("m_A v_A2 + m_B v_B2", None),
            ("2 (m_A + m_B)", None),
        ];
        for (side, expected) in cases {
            let directed = directed(side);
            let parts = directed.as_ref().map(|directed| (directed.value, directed.phrase.as_str()));
            assert_eq!(parts, expected, "{side}");
        }
    }
}
