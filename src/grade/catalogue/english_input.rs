//! What is said in English of an answer that cannot be read.

use super::super::read::UnreadableKind;

/// What is wrong, and what to write instead; it follows a colon.
pub(super) fn sentence(kind: &UnreadableKind) -> String {
    let plain = match kind {
        UnreadableKind::NotANumber => "a number is expected here, such as `3.1`, `-0.4`, `1.2e3` or `3/4`.",
        UnreadableKind::NameBefore => "write the value alone, without a name and `=` before it.",
        UnreadableKind::Underscore => "an underscore is not allowed in a number.",
        UnreadableKind::Marks => "this combination of points and commas is not a number.",
        UnreadableKind::SecondNumber => "there is a second number here: write one value.",
        UnreadableKind::MixedOrGrouped => {
            "this could be a whole number and a fraction, or one grouped number: write it without the space, or as a decimal."
        }
        UnreadableKind::LostExponent => {
            "this could be a power of ten or a difference: write `10^-3`, or spaces around the minus sign."
        }
        UnreadableKind::RangeOrDifference => {
            "this could be a range or a difference: write one value, or put the difference in brackets, with spaces around the minus sign."
        }
        UnreadableKind::ProductAfterBar => "this could belong above or below the fraction bar: write brackets.",
        UnreadableKind::TwoSigns => "there are two signs in a row.",
        UnreadableKind::OpenBracket => "this bracket is not closed.",
        UnreadableKind::TooDeep => "this is nested too deeply.",
        UnreadableKind::TooLarge => "this number is too large, too small or too long.",
        UnreadableKind::Undefined => "this has no value.",
        UnreadableKind::AngleUnit => "an angle needs its unit here: `sin(30 deg)`, `40° below +x` or `0.5 rad`.",
        UnreadableKind::NotOneValue => "write one value, not a range or a condition.",
        UnreadableKind::SignAndDirection => "write a sign or a direction, not both.",
        UnreadableKind::SeveralOptions => "this fits more than one option: write more of its text.",
        UnreadableKind::Direction => {
            "this direction cannot be understood: write `40° below +x`, `36° N of E` or, after an `@`, `-40°`."
        }
        UnreadableKind::MixedUnits => "write one unit for the whole, or the same unit after each value.",
        UnreadableKind::Axis => "no component is expected along this axis, or it is already given.",
        UnreadableKind::NotAnInterval => {
            "write an interval or a condition, such as `0 < e <= 0.5`, `e >= 0.3` or `(0, 0.5]`."
        }
        UnreadableKind::EmptyInterval => "the lower end is above the upper end, so the interval is empty.",
        UnreadableKind::NotEuler => {
            "`e` is not given here: write `exp(x)` for a power of 2.718, and `exp(1)` for 2.718 itself."
        }
        UnreadableKind::InverseOrReciprocal => "this could be the inverse function or the reciprocal: write which one.",
        UnreadableKind::Logarithm => {
            "`log` has two meanings: write `ln`, or `log10` for the logarithm to the base ten."
        }
        UnreadableKind::NoArgument => "the argument of the function is expected here, preferably in brackets.",
        UnreadableKind::NumberBehind => "a number follows a factor: write `*` or `^` before it, or put it first.",
        UnreadableKind::TooManyParts => "this formula has too many parts.",
        UnreadableKind::NotAFormula => "this is not allowed in a formula.",
        UnreadableKind::NoTerm => "a name, a number or a bracket is expected here.",
        other => return filled(other),
    };
    plain.to_owned()
}

/// Faults with something to fill in.
fn filled(kind: &UnreadableKind) -> String {
    match kind {
        UnreadableKind::TooLong(most) => format!("an answer has at most {most} characters."),
        UnreadableKind::OtherMark(mark) => format!("the decimal mark is `{mark}` here."),
        UnreadableKind::AmbiguousMark([whole, decimal]) => {
            format!("this can be read in two ways: write `{whole}` or `{decimal}`.")
        }
        UnreadableKind::Ambiguous([one, other]) => format!("this can be read in two ways: write `{one}` or `{other}`."),
        UnreadableKind::Uncertainty(reading) => {
            format!("this can be read as `{reading}`, a value with its uncertainty, or as two values: write one value.")
        }
        UnreadableKind::Multiple(name) => format!("write a number times `{name}`, such as `0.75 {name}`."),
        UnreadableKind::Behind(rest) => {
            format!("`{rest}` cannot be understood after the number: write the value, its unit and nothing else.")
        }
        UnreadableKind::Unit(fault) => format!("{fault}; {}.", fault.help().trim_end_matches('?')),
        UnreadableKind::UnitOrDirection(letter) => {
            format!("`{letter}` could be a unit or a direction: write the direction as a word.")
        }
        UnreadableKind::NoDirection(word) => {
            format!("\"{word}\" is a direction, but only a size is asked for: leave it out.")
        }
        UnreadableKind::OtherDirection { word, senses: [plus, minus] } => {
            let thousand =
                if word == "k" { " If a thousand is meant, write it into the unit, as in `kN`." } else { "" };
            format!("\"{word}\" is not one of the directions here: \"{plus}\" or \"{minus}\".{thousand}")
        }
        UnreadableKind::NoOption(count) => {
            format!("choose one of the {count} options, by its letter, its number or its text.")
        }
        UnreadableKind::Components(count) => {
            format!(
                "a vector has {count} components here: write `(1.2, -3.4) m/s`, with `;` between decimal commas, or a magnitude and a direction."
            )
        }
        UnreadableKind::OtherName(name) => format!("the question asks for `{name}`."),
        UnreadableKind::UnknownName { name, near } => match near {
            Some(near) => format!("`{name}` is not given here; did you mean `{near}`?"),
            None => {
                format!("`{name}` is not given here: write the answer in terms of the quantities that the sheet gives.")
            }
        },
        UnreadableKind::AmbiguousName { name, readings } => {
            format!("`{name}` can be read as {}: write `*` between factors and `_` before an index.", either(readings))
        }
        UnreadableKind::TwoReadings(readings) => {
            format!("this can be read as {}: write brackets.", either(readings))
        }
        UnreadableKind::AskedName(name) => {
            format!("`{name}` is the quantity asked for: write it in terms of the quantities that the sheet gives.")
        }
        // Every fault without anything to fill in has its words above.
        _ => String::new(),
    }
}

/// Two readings, either of which may be meant.
fn either(readings: &[String]) -> String {
    readings.iter().map(|reading| format!("`{reading}`")).collect::<Vec<_>>().join(" or as ")
}
