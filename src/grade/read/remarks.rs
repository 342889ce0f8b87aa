//! Words around a number that say nothing of it: `v = about 3.2 m/s (2 s.f.)`; and numbers in words.

use momentous_quantity::Dimension;
use momentous_quantity::Rational;

use super::super::number::Number;
use super::answer::{NumberAnswer, Sense, Written};
use super::calculation;
use super::comments;
use super::direction;
use super::direction::Phrase;
use super::numeral::DecimalMark;
use super::plain::ENDS;
use super::unit_vectors::unit_vectors;
use super::unreadable::{At, UnreadableKind};
use super::value;
use super::value::Asked;

/// Words before a number, the longer first.
const BEFORE: [&str; 24] = [
    "the answer is",
    "my answer is",
    "answer is",
    "answer:",
    "answer",
    "ans:",
    "ans.",
    "ans",
    "result:",
    "approximately",
    "approx.",
    "approx",
    "roughly",
    "around",
    "about",
    "circa",
    "ca.",
    "nearly",
    "almost",
    "exactly",
    "it is",
    "is",
    "~",
    "≈",
];
/// Words behind a number.
const BEHIND: [&str; 14] = [
    "(no units)",
    "(no unit)",
    "(unitless)",
    "(dimensionless)",
    "no units",
    "no unit",
    "unitless",
    "dimensionless",
    "(approximately)",
    "(approx.)",
    "(approx)",
    "approximately",
    "approx.",
    "approx",
];
/// Words behind an energy whose name says that it is one of these.
const BEHIND_ENERGY: [(&str, &[&str]); 2] = [
    ("lost", &["(lost)", "are lost", "is lost", "was lost", "were lost", "lost", "(dissipated)", "dissipated"]),
    ("gained", &["(gained)", "are gained", "is gained", "was gained", "gained", "(supplied)", "supplied"]),
];
/// How figures and decimals are counted, in brackets behind a number of them.
const COUNTED: [&str; 12] = [
    "s.f.",
    "s.f",
    "sf",
    "sig figs",
    "sig fig",
    "sig. figs.",
    "sig. fig.",
    "significant figures",
    "significant figure",
    "d.p.",
    "dp",
    "decimal places",
];
/// Words for a minus sign.
const MINUS: [&str; 2] = ["minus ", "negative "];
/// Words for nothing.
const ZERO: [&str; 3] = ["zero", "nil", "nought"];
/// Words for no velocity.
const REST: [&str; 6] = ["at rest", "stationary", "not moving", "does not move", "it stops", "stands still"];
/// Words before what a sign means.
const EXPLAINING: [&str; 6] = ["i.e.", "i. e.", "ie ", "that is", "which is", "meaning"];
/// The axes of the unit vectors i, j and k.
const AXES: [char; 3] = ['x', 'y', 'z'];
/// The longest name before an equals sign, in bytes.
const LONGEST_NAME: usize = 40;
/// Signs that stand between a name and its value.
const EQUALS: [char; 3] = ['=', ':', '≈'];

/// Reads a number without what stands around it, or a calculation with units; else the fault is what was found before.
pub(super) fn read(
    text: &str,
    asked: Asked<'_>,
    mark: DecimalMark,
    fault: (usize, UnreadableKind),
) -> At<NumberAnswer> {
    if let Some(answer) = end_of_chain(text, asked, mark) {
        return answer;
    }
    if let Some(answer) = in_brackets(text, asked, mark) {
        return answer;
    }
    if fault.1.is_doubt() {
        return Err(fault);
    }
    if let Some(answer) = along_unit_vector(text, asked, mark).or_else(|| explained(text, asked, mark)) {
        return answer;
    }
    let mut to = text.trim_end_matches(ENDS).len();
    let mut from = to - text[..to].trim_start().len();
    let whole = (from, to);
    if let Some(start) = behind_name(&text[from..to], asked.name).map_err(|kind| (from, kind))? {
        from += start;
    }
    while let Some(start) = behind_words(&text[from..to]) {
        from += start;
    }
    while let Some(end) = before_remark(&text[from..to], asked) {
        to = from + end;
    }
    let bare = &text[from..to];
    if let Some(count) = comments::counted(bare, asked) {
        return Ok(count);
    }
    let comment = comments::start(bare, asked).filter(|(end, _)| !bare[..*end].trim().is_empty());
    let unjudged = comment.and_then(|(_, direction)| direction).map(str::to_owned);
    if let Some((end, _)) = comment {
        to = from + end;
        while let Some(end) = before_remark(&text[from..to], asked) {
            to = from + end;
        }
    }
    let inner = text[from..to].trim_end_matches([' ', ',', '(']);
    if let Some(zero) = in_words(inner, asked) {
        return Ok(zero);
    }
    let minus = MINUS.iter().find_map(|word| without_case(inner, word));
    if let Some(rest) = minus {
        let start = from + inner.len() - rest.len();
        let value = value::read(rest, asked, mark).map_err(|(at, kind)| (start + at, kind))?;
        if value.signed || value.sense.is_some() {
            return Err((from, UnreadableKind::SignAndDirection));
        }
        return Ok(NumberAnswer { number: value.number.negated(), signed: true, ..value });
    }
    let again = if (from, to) == whole {
        Err(fault)
    } else {
        value::read(inner, asked, mark).map_err(|(at, kind)| (from + at, kind))
    };
    // A sign says nothing of a size beside a direction in words.
    let again = match again {
        Ok(value) if comment.is_some() && value.signed && asked.senses.is_none() => {
            Err((from, UnreadableKind::SignAndDirection))
        }
        Ok(value) => Ok(NumberAnswer { unjudged, ..value }),
        again => again,
    };
    let again = again.or_else(|fault| in_several_units(inner, asked, mark).ok_or(fault));
    again.or_else(|fault| match calculation::read(inner, asked.unit, mark).filter(|_| !fault.1.is_doubt()) {
        Some(result) => result.map_err(|(at, kind)| (from + at, kind)),
        None => Err(fault),
    })
}

/// `1 ft 1.9 in away from the quay`: a value in several units, and its direction.
fn in_several_units(text: &str, asked: Asked<'_>, mark: DecimalMark) -> Option<NumberAnswer> {
    text.match_indices(' ').find_map(|(at, _)| {
        let Phrase::Declared(sense) = asked.direction(&text[at..]) else { return None };
        let value = calculation::read(&text[..at], asked.unit, mark)?.ok()?;
        (!value.signed).then_some(NumberAnswer { sense: Some(sense), ..value })
    })
}

/// `m g h = 9.81 J`, `0.450 m = 45.0 cm`: the value at the end of a chain of equations, which every value in the chain has to be.
fn end_of_chain(text: &str, asked: Asked<'_>, mark: DecimalMark) -> Option<At<NumberAnswer>> {
    let (chain, last) = text.rsplit_once(['=', '≈'])?;
    let links: Vec<&str> = chain.split(['=', '≈']).map(str::trim).filter(|link| !link.is_empty()).collect();
    // A name alone is read with its value, and told where it is another's.
    if links.is_empty() || links.len() == 1 && is_name(links[0]) || text.contains(['<', '>', '?']) {
        return None;
    }
    // `v - 1 = 3` is an equation for something.
    if links.iter().any(|link| has_number_beside_letters(link)) {
        return None;
    }
    if links.first().is_some_and(|first| is_name(first) && is_another(first, asked.name)) {
        return Some(Err((0, UnreadableKind::OtherName(asked.name.to_owned()))));
    }
    let at = text.len() - last.trim_start().len();
    let value = value::read(last.trim(), asked, mark).ok()?;
    let in_unit = |value: &NumberAnswer| {
        let unit = value.unit.as_ref().filter(|unit| unit.dimension() == asked.unit.dimension());
        value.directed().to_f64() * unit.map_or(1.0, |unit| unit.in_terms_of(asked.unit).to_f64())
    };
    let is_other = |link: &&str| {
        value::read(link, asked, mark)
            .is_ok_and(|linked| (in_unit(&linked) - in_unit(&value)).abs() > ROUNDED_IN_CHAIN * in_unit(&value).abs())
    };
    if links.iter().any(is_other) {
        return Some(Err((at, UnreadableKind::SecondNumber)));
    }
    Some(Ok(value))
}

/// How far the values of a chain may be apart, as a share.
const ROUNDED_IN_CHAIN: f64 = 0.01;

/// Whether a bare number is added to letters.
fn has_number_beside_letters(link: &str) -> bool {
    let is_number = |term: &str| term.trim().parse::<f64>().is_ok();
    link.contains(char::is_alphabetic) && link.split(['+', '-']).any(is_number)
}

/// Whether a link of a chain is a name: `v`, `v_A2`, `N`.
fn is_name(link: &str) -> bool {
    link.starts_with(char::is_alphabetic) && link.chars().all(|next| next.is_alphanumeric() || "_{}.,'′".contains(next))
}

/// `-3.16 m/s (to the left)`: a value with its sign, and in brackets what the sign means.
fn in_brackets(text: &str, asked: Asked<'_>, mark: DecimalMark) -> Option<At<NumberAnswer>> {
    let bare = text.trim_end_matches(ENDS).strip_suffix(')')?;
    let at = bare.rfind('(')?;
    let Phrase::Declared(sense) = asked.direction(&bare[at + 1..]) else { return None };
    let value = value::read(text[..at].trim_end(), asked, mark).ok().filter(|value| value.signed)?;
    Some(agreeing(value, &sense, at))
}

/// The value where its sign says the direction beside it.
fn agreeing(value: NumberAnswer, sense: &Sense, at: usize) -> At<NumberAnswer> {
    let agree = value.number.is_zero() || value.number.is_negative() != sense.positive;
    if agree { Ok(value) } else { Err((at, UnreadableKind::SignAndDirection)) }
}

/// `-0.25 m/s, i.e. to the left`: a value, and in words what its sign means. The two must agree; words alone tell the direction.
fn explained(text: &str, asked: Asked<'_>, mark: DecimalMark) -> Option<At<NumberAnswer>> {
    let (at, word) = EXPLAINING.iter().find_map(|word| Some((text.find(word)?, word)))?;
    let phrase = text[at + word.len()..].trim_matches([' ', ',', '.', ':', ')']);
    let Phrase::Declared(sense) = asked.direction(phrase) else { return None };
    let value = text[..at].trim_end_matches([' ', ',', ';', '(', ':']);
    let value = match value::read(value, asked, mark) {
        Ok(value) if value.sense.is_none() => value,
        Ok(_) => return None,
        Err(fault) => return Some(Err(fault)),
    };
    if !value.signed {
        return Some(Ok(NumberAnswer { sense: Some(sense), ..value }));
    }
    Some(agreeing(value, &sense, at))
}

/// `-3.2 î m/s`: a component with the unit vector of its axis; what turns has that of the axis about which it turns.
pub(super) fn along_unit_vector(text: &str, asked: Asked<'_>, mark: DecimalMark) -> Option<At<NumberAnswer>> {
    let [(axis, start, end)] = unit_vectors(text)[..] else { return None };
    let (senses, letter) = (asked.senses.or(asked.in_space)?, AXES.get(axis)?);
    if !text[..start].contains(|before: char| before.is_ascii_digit()) {
        return None;
    }
    let own_axis = asked.axis.unwrap_or(AXES[if direction::turns_about_k(senses) { 2 } else { 0 }]);
    if own_axis != *letter {
        let word = text[start..end].to_owned();
        return Some(Err((start, UnreadableKind::OtherDirection { word, senses: senses.clone() })));
    }
    Some(value::read(&format!("{}{:width$}{}", &text[..start], "", &text[end..], width = end - start), asked, mark))
}

/// The beginning of the value behind its name and an equals sign; the fault is another name than the one that is asked.
pub(super) fn behind_name(text: &str, asked: &str) -> Result<Option<usize>, UnreadableKind> {
    let Some((at, sign)) = text.char_indices().find(|(_, next)| EQUALS.contains(next)) else { return Ok(None) };
    let (name, start) = (text[..at].trim(), at + sign.len_utf8());
    if name.is_empty()
        || name.len() > LONGEST_NAME
        || !name.starts_with(|first: char| first.is_alphabetic() || "|‖\\∆Δ".contains(first))
    {
        return Ok(None);
    }
    let belongs = |next: char| next.is_alphanumeric() || "_{}|‖\\∆Δ.,'′ ̂⃗()".contains(next);
    if !name.chars().all(belongs) || text[start..].contains(EQUALS) {
        return Ok(None);
    }
    if is_another(name, asked) { Err(UnreadableKind::OtherName(asked.to_owned())) } else { Ok(Some(start)) }
}

/// Whether a name is that of a quantity of the same kind, but of another body, at another time or along another axis: `v_A1`
/// beside `v_A2`. Any other name may be the student's own.
fn is_another(typed: &str, asked: &str) -> bool {
    let plain = |name: &str| name.chars().filter(|next| next.is_alphanumeric()).collect::<String>();
    let (typed_text, other) = (plain(typed), plain(asked));
    let stem = plain(asked.split('_').next().unwrap_or(asked));
    let Some(index) = typed_text.strip_prefix(&stem).filter(|_| asked.contains('_')) else { return false };
    let is_index = |next: char| next.is_uppercase() || next.is_ascii_digit();
    let letters = |name: &str| name.chars().filter(|next| !next.is_ascii_digit()).collect::<String>();
    let axis = asked.rsplit_once('.').map(|(_, axis)| axis).filter(|_| index.len() == 1);
    let of_other_axis = axis.is_some_and(|axis| ["x", "y", "z"].contains(&index) && axis != index);
    let of_other_time =
        letters(&typed_text) == letters(&other) && typed_text.len() == other.len() && typed_text != other;
    !index.is_empty() && (of_other_axis || of_other_time || index.chars().all(is_index) && !other.contains(index))
}

/// The beginning of the number behind words that say nothing of it.
fn behind_words(text: &str) -> Option<usize> {
    let bare = text.trim_start_matches([' ', '=']);
    let rest = BEFORE.iter().find_map(|word| without_case(bare, word)).unwrap_or(bare);
    let word = &bare[..bare.len() - rest.len()];
    let ends = !word.ends_with(char::is_alphabetic) || !rest.starts_with(char::is_alphanumeric);
    (ends && rest.len() < text.len()).then(|| text.len() - rest.trim_start().len())
}

/// The end of the number before words that say nothing of it.
fn before_remark(text: &str, asked: Asked<'_>) -> Option<usize> {
    let bare = text.trim_end_matches(ENDS);
    let is_energy = asked.unit.dimension() == Dimension::ENERGY && asked.senses.is_none();
    // What is lost is not gained.
    let fits = |kind: &&str| is_energy && (asked.name.is_empty() || asked.name.contains(*kind));
    let of_energy = BEHIND_ENERGY.iter().filter(|(kind, _)| fits(kind)).flat_map(|(_, words)| words.iter());
    let words = BEHIND.iter().chain(of_energy);
    let cut = |word: &str| {
        let start = text.trim_end().len().checked_sub(word.len())?;
        let end = text.get(start..start + word.len())?;
        let apart = text[..start].ends_with([' ', ')']) || text[..start].ends_with(|last: char| last.is_ascii_digit());
        (end.eq_ignore_ascii_case(word) && apart).then_some(start)
    };
    let counted = || {
        let open = bare.rfind('(').or_else(|| bare.rfind(" to "))?;
        let inner = bare[open + 1..].trim_end_matches(')').trim();
        let inner = inner.strip_prefix("to ").or(inner.strip_prefix("in ")).unwrap_or(inner);
        let digits = inner.find(|next: char| !next.is_ascii_digit())?;
        (digits > 0 && COUNTED.contains(&inner[digits..].trim())).then_some(open)
    };
    let end = words.into_iter().find_map(|word| cut(word)).or_else(counted)?;
    (end > 0).then_some(end)
}

/// Nothing, in words.
fn in_words(text: &str, asked: Asked<'_>) -> Option<NumberAnswer> {
    let bare = text.trim();
    let is = |words: &[&str]| words.iter().any(|word| bare.eq_ignore_ascii_case(word));
    let unit_of_zero = ZERO.iter().find_map(|word| without_case(bare, word)).filter(|rest| rest.starts_with(' '));
    let rests = is(&REST) && asked.unit.dimension() == Dimension::VELOCITY;
    let unit = match unit_of_zero {
        Some(unit) => super::unit::unit(unit, 0, unit.len(), asked.unit).ok()?,
        None if rests => Some(asked.unit.clone()),
        None if is(&ZERO) => None,
        None => return None,
    };
    Some(NumberAnswer {
        number: Number::exact(Rational::ZERO),
        written: Written::Computed,
        signed: false,
        unit,
        pounds_as_mass: false,
        sense: None,
        heading: None,
        unjudged: None,
    })
}

/// The text behind a word at the start, in whatever case it is written.
fn without_case<'t>(text: &'t str, word: &str) -> Option<&'t str> {
    let start = text.get(..word.len())?;
    start.eq_ignore_ascii_case(word).then(|| &text[word.len()..])
}
