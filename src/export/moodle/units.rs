//! The units that students type behind a number, in the spellings that marking takes.

use momentous_quantity::Unit;

/// Units in which students answer, beside the one that is asked; those that measure the same go along.
const USUAL: [&str; 53] = [
    "m",
    "cm",
    "mm",
    "km",
    "ft",
    "in",
    "s",
    "ms",
    "min",
    "h",
    "kg",
    "g",
    "t",
    "slug",
    "m/s",
    "km/h",
    "cm/s",
    "mm/s",
    "km/s",
    "ft/s",
    "mph",
    "m/s^2",
    "ft/s^2",
    "N",
    "kN",
    "MN",
    "kg m/s^2",
    "lb",
    "N s",
    "kN s",
    "kg m/s",
    "g m/s",
    "t m/s",
    "lb s",
    "J",
    "kJ",
    "mJ",
    "MJ",
    "N m",
    "kg m^2/s^2",
    "ft lb",
    "W",
    "kW",
    "J/s",
    "rad/s",
    "1/s",
    "kg m^2/s",
    "N m s",
    "N/m",
    "kN/m",
    "kg/s",
    "deg",
    "rad",
];
/// A share, which is asked with or without its sign.
const PERCENT: &str = "%";
/// Signs between the units of a product; a space is none, for Moodle takes spaces out of what is typed.
const BETWEEN: [&str; 6] = ["", "*", "·", "⋅", ".", "-"];
/// Units with a spelling that is no product of their symbols.
const OTHERWISE: [(&str, &[&str]); 2] = [("km/h", &["kph", "kmh", "kmph"]), ("m/s", &["mps"])];
/// British words, and what they are in America.
const AMERICAN: [(&str, &str); 2] = [("metre", "meter"), ("tonne", "metric ton")];

/// Each spelling of the unit and of usual others, with how many of it make one of the unit asked. None where there is no unit, or it
/// begins with a digit, which Moodle would read as one of the number.
pub(super) fn units(asked: &Unit) -> Vec<(String, f64)> {
    let is_typed = |unit: &Unit| !unit.to_string().starts_with(|first: char| first.is_ascii_digit());
    let mut all: Vec<(String, f64)> = Vec::new();
    if asked.is_none() || !is_typed(asked) {
        return all;
    }
    let usual = USUAL.iter().chain([&PERCENT]).filter_map(|text| Unit::parse(text).ok());
    let same = usual.filter(|unit| unit.dimension() == asked.dimension() && is_typed(unit));
    for unit in std::iter::once(asked.clone()).chain(same) {
        let multiplier = if unit == *asked { 1.0 } else { asked.in_terms_of(&unit).to_f64() };
        for name in spellings(&unit, asked) {
            if !all.iter().any(|(listed, _)| *listed == name) {
                all.push((name, multiplier));
            }
        }
    }
    all
}

/// The ways to write a unit without spaces that mean it where that other unit is asked, the usual one first.
fn spellings(unit: &Unit, asked: &Unit) -> Vec<String> {
    let plain = unit.to_string();
    let (above, below) = plain.split_once('/').unwrap_or((&plain, ""));
    let factors =
        |text: &str| -> Vec<String> { text.trim_matches(['(', ')']).split_whitespace().map(str::to_owned).collect() };
    let (above, below) = (factors(above), factors(below));
    let mut all = vec![plain.replace(' ', "")];
    for between in BETWEEN {
        let mut divided = above.join(between);
        match below.len() {
            0 => {}
            1 => divided.extend(["/", &below.concat()]),
            _ => divided.extend(["/(", &below.join(between), ")"]),
        }
        let powers: Vec<String> = above.iter().cloned().chain(below.iter().map(|power| inverse(power))).collect();
        let powers = powers.join(between);
        all.extend(
            [seconds(&divided, &above, &below, between), Some(raised(&divided)), Some(raised(&powers))]
                .into_iter()
                .flatten(),
        );
        all.extend([divided, powers]);
    }
    let mut spoken: Vec<String> = Vec::new();
    for plural in [true, false] {
        let words = unit.spoken(plural);
        let american = AMERICAN.iter().fold(words.clone(), |words, (british, other)| words.replace(british, other));
        spoken.extend([words, american]);
    }
    let otherwise = OTHERWISE.iter().filter(|(listed, _)| *listed == plain).flat_map(|(_, names)| names.iter());
    all.extend(otherwise.map(|name| (*name).to_owned()));
    let means = |name: &String| Unit::parse_asked(name, asked.dimension()).is_ok_and(|read| read == *unit);
    let mut kept: Vec<String> = Vec::new();
    for name in all.into_iter().chain(spoken) {
        let typed = name.replace(' ', "");
        if !typed.is_empty() && !kept.contains(&typed) && (kept.is_empty() || means(&name)) {
            kept.push(typed);
        }
    }
    kept
}

/// One over a factor: `s^-2`.
fn inverse(factor: &str) -> String {
    match factor.split_once('^') {
        Some((symbol, exponent)) => format!("{symbol}^-{exponent}"),
        None => format!("{factor}^-1"),
    }
}

/// With raised exponents: `s⁻²`.
fn raised(name: &str) -> String {
    let raise = |letter: char| match letter {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        other => other,
    };
    let mut pieces = name.split('^');
    let mut out = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let digits = piece.find(|letter: char| !letter.is_ascii_digit() && letter != '-');
        let end = digits.unwrap_or(piece.len());
        // A hyphen behind a digit stands between factors.
        let end = piece.char_indices().skip(1).find(|(_, letter)| *letter == '-').map_or(end, |(at, _)| end.min(at));
        out.extend(piece[..end].chars().map(raise));
        out.push_str(&piece[end..]);
    }
    out
}

/// With `sec` for the second, where it stands alone.
fn seconds(divided: &str, above: &[String], below: &[String], between: &str) -> Option<String> {
    if below == ["s"] {
        return Some(format!("{}/sec", divided.strip_suffix("/s")?));
    }
    let (last, rest) = above.split_last().filter(|(last, _)| *last == "s" && below.is_empty())?;
    let _ = last;
    Some([rest, &["sec".to_owned()]].concat().join(between))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_has_the_spellings_that_marking_takes() {
        let names = |unit: &str| units(&Unit::parse(unit).unwrap());
        let of =
            |unit: &str, name: &str| names(unit).iter().find(|(listed, _)| listed == name).map(|(_, times)| *times);
        for name in
            ["m/s", "ms^-1", "ms⁻¹", "m·s⁻¹", "m*s^-1", "m·s^-1", "m/sec", "metrespersecond", "meterspersecond", "mps"]
        {
            assert_eq!(of("m/s", name), Some(1.0), "{name}");
        }
        assert_eq!((of("m/s", "km/h"), of("m/s", "kph"), of("m/s", "mm/s")), (Some(3.6), Some(3.6), Some(1000.0)));
        for name in
            ["Ns", "N*s", "N·s", "N-s", "N.s", "Nsec", "newtonseconds", "kgm/s", "kg·m/s", "kgms^-1", "kg*m*s^-1"]
        {
            assert_eq!(of("N s", name), Some(1.0), "{name}");
        }
        // A millisecond is no metre times second.
        assert_eq!(of("s", "ms"), Some(1000.0));
        assert_eq!(raised("kg-m^2-s^-1"), "kg-m²-s⁻¹");
        assert!(names("1/s").is_empty());
    }
}
