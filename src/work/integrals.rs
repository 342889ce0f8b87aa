//! Definite integrals in a side, taken apart as text: `∫_0^T F dt`, `\int_{v_1}^{v_2} \frac{dv}{v}`.

/// Spellings of the sign, each with what stands before its limits; of those that begin alike the longest stands first.
const SIGNS: [&str; 5] = ["\\int\\limits", "\\int", "∫", "integral", "int"];
/// Spellings of an upright d before the variable.
const UPRIGHT: [&str; 3] = ["\\mathrm{d}", "\\text{d}", "{\\rm d}"];

/// An integral as it stands in a side.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct WrittenIntegral {
    /// The text before it.
    pub(crate) before: String,
    /// From where and to where; none where no limits are written.
    pub(crate) limits: Option<[String; 2]>,
    /// The integrand.
    pub(crate) integrand: String,
    /// Over what.
    pub(crate) variable: String,
    /// The text behind it.
    pub(crate) behind: String,
}

/// A term between limits, `[t^3/3]_0^T`, as it stands in a side.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct BetweenLimits {
    /// The text before it.
    pub(crate) before: String,
    /// The term.
    pub(crate) term: String,
    /// From where and to where.
    pub(crate) limits: [String; 2],
    /// The text behind it.
    pub(crate) behind: String,
}

/// The first term between limits of a side; nothing where there is none.
pub(crate) fn between_limits(side: &str) -> Option<BetweenLimits> {
    let close = side.match_indices(']').map(|(at, _)| at).find(|at| side[at + 1..].starts_with(['_', '^']))?;
    let open = side[..close].rfind('[')?;
    let (limits, behind) = limits(&side[close + 1..]).ok()?;
    Some(BetweenLimits {
        before: side[..open].to_owned(),
        term: side[open + 1..close].to_owned(),
        limits: limits?,
        behind: behind.to_owned(),
    })
}

/// Faults of an integral.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum IntegralFault {
    /// One limit, or none where none are known.
    Limits,
    /// No `dt` stands in it.
    Variable,
    /// It is no sum of terms whose integral has a formula.
    Formula,
}

impl IntegralFault {
    /// The fault as a clause.
    pub(crate) fn said(self) -> &'static str {
        match self {
            Self::Limits => "its integral has no limits; write them as in `\\int_0^T F dt`",
            Self::Variable => "its integral has no variable; write it behind what is integrated, as `dt`",
            Self::Formula => "its integral has no formula that is known here; write its value",
        }
    }
}

/// The first integral of a side; nothing where there is none.
pub(crate) fn first(side: &str) -> Option<Result<WrittenIntegral, IntegralFault>> {
    let side = UPRIGHT.iter().fold(side.to_owned(), |side, upright| side.replace(upright, "d"));
    let (at, sign) = SIGNS.iter().filter_map(|sign| Some((sign_at(&side, sign)?, *sign))).min_by_key(|sign| sign.0)?;
    let (before, rest) = (&side[..at], &side[at + sign.len()..]);
    let (limits, rest) = match limits(rest) {
        Ok(parts) => parts,
        Err(fault) => return Some(Err(fault)),
    };
    let (inside, behind) = rest.split_at(end(rest));
    let Some((at, length)) = differential(inside) else { return Some(Err(IntegralFault::Variable)) };
    let variable = inside[at + 1..at + length].trim_start_matches([' ', '\\']).to_owned();
    let left = inside[..at].trim_end_matches(['\\', ',', ' ', '*']).trim();
    let is_factor = left.ends_with(|sign: char| sign.is_alphanumeric() || matches!(sign, ')' | '}' | ']' | '\''))
        && !left.ends_with("\\frac{");
    let one = if is_factor { "*1" } else { "1" };
    let integrand = format!("{left}{one}{}", &inside[at + length..]);
    Some(Ok(WrittenIntegral { before: before.to_owned(), limits, integrand, variable, behind: behind.to_owned() }))
}

/// The place of a sign, where it is no part of a word.
fn sign_at(side: &str, sign: &str) -> Option<usize> {
    side.match_indices(sign).map(|(at, _)| at).find(|at| {
        let is_word = sign.starts_with(char::is_alphabetic);
        let before = side[..*at].chars().next_back();
        let behind = side[at + sign.len()..].chars().next();
        !is_word
            || !before.is_some_and(|sign| sign.is_alphabetic() || sign == '\\' || sign == '_')
                && behind.is_some_and(|sign| sign == '_' || sign == ' ')
    })
}

/// The limits behind a sign, and the rest.
fn limits(rest: &str) -> Result<(Option<[String; 2]>, &str), IntegralFault> {
    if let Some(words) = rest.trim_start().strip_prefix("from ") {
        let parts = words.split_once(" to ").and_then(|(low, rest)| Some((low, rest.split_once(" of ")?)));
        let (low, (high, rest)) = parts.ok_or(IntegralFault::Limits)?;
        return Ok((Some([low.to_owned(), high.to_owned()]), rest));
    }
    let (mut low, mut high, mut rest) = (None, None, rest);
    loop {
        let trimmed = rest.trim_start();
        let (limit, behind) = match trimmed.chars().next() {
            Some('_') if low.is_none() => (&mut low, &trimmed[1..]),
            Some('^') if high.is_none() => (&mut high, &trimmed[1..]),
            _ => break,
        };
        let (text, behind) = group(behind.trim_start());
        *limit = Some(text.to_owned());
        rest = behind;
    }
    match (low, high) {
        (Some(low), Some(high)) => Ok((Some([low, high]), rest)),
        (None, None) => Ok((None, rest)),
        _ => Err(IntegralFault::Limits),
    }
}

/// A limit, in brackets or without, and the rest.
fn group(text: &str) -> (&str, &str) {
    if text.starts_with(['{', '(']) {
        let mut depth = 0_usize;
        for (at, sign) in text.char_indices() {
            match sign {
                '{' | '(' => depth += 1,
                '}' | ')' => depth -= 1,
                _ => {}
            }
            if depth == 0 {
                return (&text[1..at], &text[at + 1..]);
            }
        }
    }
    let is_inside = |(at, sign): (usize, char)| {
        sign.is_alphanumeric() || matches!(sign, '.' | '_' | '\'') || at == 0 && matches!(sign, '\\' | '-')
    };
    let end = text.char_indices().find(|place| !is_inside(*place)).map_or(text.len(), |(at, _)| at);
    text.split_at(end)
}

/// The end of an integral: a sign of a sum behind its variable, or a bracket that was opened before it.
fn end(text: &str) -> usize {
    let variable = differential(text).map_or(text.len(), |(at, length)| at + length);
    let mut depth = 0_i32;
    for (at, sign) in text.char_indices() {
        match sign {
            '(' | '{' | '[' => depth += 1,
            ')' | '}' | ']' if depth == 0 => return at,
            ')' | '}' | ']' => depth -= 1,
            '+' | '-' | '−' if depth == 0 && at >= variable => return at,
            _ => {}
        }
    }
    text.len()
}

/// The first `dt` of a text: its place and its length.
fn differential(text: &str) -> Option<(usize, usize)> {
    text.match_indices('d').find_map(|(at, _)| {
        let behind = &text[at + 1..];
        let letter = behind.trim_start();
        let command =
            letter.strip_prefix('\\').map(|word| word.find(|sign: char| !sign.is_alphabetic()).unwrap_or(word.len()));
        let length = match command {
            Some(length) if length > 1 => 1 + length,
            Some(_) => return None,
            None => letter.chars().next().filter(|sign| sign.is_alphabetic())?.len_utf8(),
        };
        let gap = behind.len() - letter.len();
        let ends = letter[length..].chars().next().is_none_or(|next| !next.is_alphabetic() && next != '_');
        let is_word = text[..at].ends_with(['\\', '_']);
        (ends && !is_word && (gap == 0 || command.is_some())).then_some((at, 1 + gap + length))
    })
}

#[cfg(test)]
mod tests {
    use super::{IntegralFault, between_limits, first};

    fn parts(side: &str) -> Option<Result<[String; 6], IntegralFault>> {
        first(side).map(|side| {
            side.map(|between| {
                let [low, high] = between.limits.unwrap_or_default();
                [between.before, low, high, between.integrand, between.variable, between.behind]
                    .map(|part| part.trim().to_owned())
            })
        })
    }

    #[test]
    fn a_term_between_limits_is_taken_apart() {
        let between = between_limits("k [t^2/2]_0^{t_1} + 3").unwrap();
        assert_eq!([between.before, between.term, between.behind], ["k ", "t^2/2", " + 3"]);
        assert_eq!(between.limits, ["0", "t_1"]);
        assert_eq!(between_limits("J_A[hit] = [3 + 4]"), None);
    }

    #[test]
    fn an_integral_is_taken_apart() {
        let cases = [
            ("∫_0^T F dt", ["", "0", "T", "F*1", "t", ""]),
            (
                "m v_1 + \\int_{0}^{t_1} (F - m g)\\,\\mathrm{d}t - 3",
                ["m v_1 +", "0", "t_1", "(F - m g)*1", "t", "- 3"],
            ),
            ("(int_0^0.5 200 t dt)/m", ["(", "0", "0.5", "200 t*1", "t", ")/m"]),
            ("\\int_{v_1}^{v_2} \\frac{dv}{v^2}", ["", "v_1", "v_2", "\\frac{1}{v^2}", "v", ""]),
            ("∫_{v_1}^{v_2} dv/v", ["", "v_1", "v_2", "1/v", "v", ""]),
            ("integral from 0 to 2 of 3 t^2 dt", ["", "0", "2", "3 t^2*1", "t", ""]),
            ("∫ F dt", ["", "", "", "F*1", "t", ""]),
            ("\\int_0^\\tau F d\\tau", ["", "0", "\\tau", "F*1", "tau", ""]),
        ];
        for (side, expected) in cases {
            assert_eq!(parts(side), Some(Ok(expected.map(str::to_owned))), "{side}");
        }
        assert_eq!(parts("m_A v_A1 + point"), None);
        assert_eq!(parts("∫_0 F dt"), Some(Err(IntegralFault::Limits)));
        assert_eq!(parts("∫_0^2 3"), Some(Err(IntegralFault::Variable)));
    }
}
