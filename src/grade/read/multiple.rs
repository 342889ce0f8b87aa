//! Answers in terms of a quantity: `0.75 v_{A1}` is 0.75, `3 v_A1/4` and `u/5` are 3/4 and 1/5.

use std::borrow::Cow;

use momentous_quantity::Unit;

use super::super::expected::ExpectedNumber;
use super::answer::NumberAnswer;
use super::formula::{lowered, spellings};
use super::unreadable::{Unreadable, UnreadableKind};
use super::vulgar::of_character;

/// Signs of multiplication before a quantity, as they are typed.
const TIMES: [&str; 9] = ["*", "·", "×", "⋅", "∙", "\\cdot", "\\times", "\\,", "~"];
/// The word before a quantity of which something is a part.
const OF: &str = " of";
/// The signs that join the letters of a name and its index.
const JOINTS: [char; 5] = ['_', '{', '}', ',', '\\'];
const SIGNS: [char; 4] = ['+', '-', '−', '–'];

/// The answer without the quantity of which a multiple is asked, where one is.
pub(super) fn without<'t>(answer: &'t str, asked: &ExpectedNumber) -> Result<Cow<'t, str>, Unreadable> {
    match asked.called.as_ref().and_then(|called| called.multiple_of.as_ref()) {
        Some(multiple) => factor(answer, &multiple.name).map(Cow::Owned).map_err(|(at, kind)| Unreadable { at, kind }),
        None => Ok(Cow::Borrowed(answer)),
    }
}

/// The reason where the unit cannot be read and none is wanted but the quantity of which the answer is a multiple.
pub(super) fn reason(kind: UnreadableKind, asked: &ExpectedNumber) -> UnreadableKind {
    match (asked.called.as_ref().and_then(|called| called.multiple_of.clone()), kind) {
        (Some(multiple), UnreadableKind::Unit(_)) => UnreadableKind::Multiple(multiple.name),
        (_, kind) => kind,
    }
}

/// A multiple with a unit, as `6m N s`, `6 m/s m` or `6m kg m/s`, with the mass m: every place is tried as that of the quantity until
/// what remains is a number with the unit of the multiple or of the product. None where there is no such place. A number with the unit of
/// the product alone keeps it: the quantity is missing.
pub(super) fn with_unit(
    answer: &str,
    asked: &ExpectedNumber,
    read: impl Fn(&str) -> Option<NumberAnswer>,
) -> Option<NumberAnswer> {
    let multiple = asked.called.as_ref()?.multiple_of.as_ref()?;
    let [unit_of_part, product] = multiple.units.as_ref()?;
    let signs: Vec<char> = answer.chars().collect();
    let plain = |answer: NumberAnswer, fitting: &[&Unit]| match &answer.unit {
        None => Some(answer),
        Some(unit) => {
            let fits = fitting.iter().find(|other| other.dimension() == unit.dimension())?;
            Some(NumberAnswer { number: answer.number.scaled(&unit.in_terms_of(fits))?, unit: None, ..answer })
        }
    };
    let taken = |start: usize| {
        let end = name_at(&signs, start, &multiple.name, true)?;
        // Behind a unit the quantity is only left out: `6 m/s m`.
        let behind_unit =
            signs[..start].iter().rev().find(|sign| **sign != ' ').is_some_and(|sign| sign.is_alphabetic());
        let left_out = behind_unit.then(|| signs[..start].iter().chain(&signs[end..]).collect());
        let rests = [without_name(signs.clone(), start, end), left_out];
        rests.into_iter().flatten().find_map(|rest| plain(read(&rest)?, &[unit_of_part, product]))
    };
    let alone = || {
        let value = read(answer)?;
        let is_product = value.unit.as_ref().is_some_and(|unit| unit.dimension() == product.dimension());
        if is_product { Some(value) } else { plain(value, &[unit_of_part]) }
    };
    (0..signs.len()).find_map(taken).or_else(alone)
}

/// The answer with the quantity taken out, or a one put in its place where nothing stands before it. Every other character keeps its
/// place. An answer that does not name the quantity is the multiple itself.
///
/// # Errors
/// Where it is not a number times the quantity, with the character.
fn factor(answer: &str, name: &str) -> Result<String, (usize, UnreadableKind)> {
    let signs: Vec<char> = answer.chars().collect();
    let mut named = (0..signs.len()).filter_map(|start| Some((start, name_at(&signs, start, name, false)?)));
    let Some((start, end)) = named.next() else { return Ok(answer.to_owned()) };
    let is_alone = named.next().is_none();
    let fault = || (start, UnreadableKind::Multiple(name.to_owned()));
    if is_alone { without_name(signs, start, end).ok_or_else(fault) } else { Err(fault()) }
}

/// The answer with the name between two characters taken out; `None` where it is not multiplied by one number.
fn without_name(mut signs: Vec<char>, start: usize, end: usize) -> Option<String> {
    let before: String = signs[..start].iter().collect();
    let bare = before.trim_end();
    let bare = TIMES.iter().find_map(|times| bare.strip_suffix(times)).unwrap_or(bare).trim_end();
    let factor = bare.strip_suffix(OF).unwrap_or(bare).trim_end();
    let last = factor.chars().next_back();
    let is_multiplied = last.is_some_and(|last| {
        last.is_ascii_digit() || [')', '}', '.', '%'].contains(&last) || of_character(last).is_some()
    });
    let next = signs[end..].iter().find(|next| **next != ' ').copied();
    let goes_on = next.is_some_and(|next| next.is_ascii_digit() || SIGNS.contains(&next) || "^√π".contains(next));
    if goes_on || last.is_some_and(|last| last == '/' || last == '^') {
        return None;
    }
    let from = if is_multiplied { factor.chars().count() } else { start };
    signs[from..end].fill(' ');
    if !is_multiplied {
        signs[start] = '1';
    }
    (!is_sum(&signs)).then(|| signs.into_iter().collect())
}

/// The end of the name that begins at this character, in whatever spelling: `v_A1`, `vA1`, `v_{A,1}`, `v_A₁`. A unit may follow
/// it without a space.
fn name_at(signs: &[char], start: usize, name: &str, before_unit: bool) -> Option<usize> {
    let is_part = |sign: &char| sign.is_alphabetic() || *sign == '_' || *sign == '\\';
    if start.checked_sub(1).and_then(|before| signs.get(before)).is_some_and(is_part) {
        return None;
    }
    let ends = |letters: Vec<char>| {
        let (mut at, mut open) = (start + usize::from(signs.get(start) == Some(&'\\')), 0);
        for (place, letter) in letters.iter().enumerate() {
            while place > 0 && signs.get(at).is_some_and(|sign| JOINTS.contains(sign)) {
                open += i32::from(signs.get(at) == Some(&'{')) - i32::from(signs.get(at) == Some(&'}'));
                at += 1;
            }
            if lowered(*signs.get(at)?) != *letter {
                return None;
            }
            at += 1;
        }
        while open > 0 && signs.get(at) == Some(&'}') {
            (at, open) = (at + 1, open - 1);
        }
        let goes_on = signs.get(at).is_some_and(|next| lowered(*next).is_alphanumeric() || *next == '_');
        ((before_unit || !goes_on) && open == 0).then_some(at)
    };
    spellings(name).into_iter().find_map(ends)
}

/// Whether terms are added outside brackets.
fn is_sum(signs: &[char]) -> bool {
    let (mut depth, mut before) = (0, ' ');
    signs.iter().any(|next| {
        depth += i32::from("({".contains(*next)) - i32::from(")}".contains(*next));
        let joins = depth == 0 && SIGNS.contains(next) && (before.is_ascii_digit() || ")}".contains(before));
        before = if *next == ' ' { before } else { *next };
        joins
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn takes_the_quantity_out_of_a_multiple() {
        let rows = [
            ("0.75 v_A1", "0.75"),
            ("0.75 v_{A1}", "0.75"),
            ("0.75*vA1", "0.75"),
            ("0.75·v_{A,1}", "0.75"),
            ("0.75 \\cdot v_{A1}", "0.75"),
            ("0.75 v_A₁ to the right", "0.75      to the right"),
            ("0.75 of v_A1", "0.75"),
            ("26 % of v_A1", "26 %"),
            ("26% v_A1", "26%"),
            ("3 v_A1/4", "3     /4"),
            ("3/4 v_A1", "3/4"),
            ("(3/4)v_A1", "(3/4)"),
            ("\\frac{3}{4}v_{A1}", "\\frac{3}{4}"),
            ("\\frac{v_{A1}}{4}", "\\frac{1     }{4}"),
            ("v_A1/4", "1   /4"),
            ("-v_A1", "-1"),
            ("v_A1", "1"),
            ("(1/2 + 1/4) v_A1", "(1/2 + 1/4)"),
            ("½v_A1", "½"),
            ("1.5e-3 v_A1", "1.5e-3"),
            ("v_B2 = 0.75 v_A1", "v_B2 = 0.75"),
            ("0.75", "0.75"),
            ("0.75 v_A12", "0.75 v_A12"),
            ("0.75 v_B1", "0.75 v_B1"),
        ];
        for (typed, factor_alone) in rows {
            assert_eq!(factor(typed, "v_A1").as_deref().map(str::trim_end), Ok(factor_alone), "{typed}");
        }
        assert_eq!(factor("u/5", "u").as_deref(), Ok("1/5"));
        assert_eq!(factor("0.2u", "u").as_deref().map(str::trim_end), Ok("0.2"));
        assert_eq!(factor("2 omega_1/3", "omega_1").as_deref(), Ok("2        /3"));
        assert_eq!(factor("2 ω_1/3", "omega_1").as_deref(), Ok("2    /3"));
    }

    #[test]
    fn refuses_what_is_no_multiple() {
        for typed in [
            "3/v_A1",
            "v_A1 + 0.5",
            "0.5 + v_A1",
            "0.1 + 0.5 v_A1",
            "v_A1^2",
            "v_A1 3/4",
            "2 v_A1 1/2",
            "v_A1 v_A1",
            "v_A1 - 0.25 v_A1",
        ] {
            assert!(factor(typed, "v_A1").is_err(), "{typed}");
        }
    }
}
