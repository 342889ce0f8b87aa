//! Several values of one quantity in one answer: `2 m/s or -2 m/s`, `±2 m/s`, `2; -2 m/s`, `t = 0.5 s, t = 1.5 s`.

use super::arithmetic;

/// The texts between two values.
const BETWEEN: [&str; 8] = [" or ", " and ", ";", ", ", " oder ", " und ", " / ", " & "];

/// The values of an answer, each as a text of its own: a unit behind the last belongs to all, and `±` is both signs.
///
/// ```
/// use momentous_grade::read_several;
/// assert_eq!(read_several("2 or -2 m/s"), ["2 m/s", "-2 m/s"]);
/// assert_eq!(read_several("±2 m/s"), ["2 m/s", "-2 m/s"]);
/// ```
#[must_use]
pub fn read_several(answer: &str) -> Vec<String> {
    let answer = answer.trim();
    let value = answer.rsplit_once('=').map_or(answer, |(_, value)| value.trim_start());
    if let Some(size) = ["±", "+-", "+/-", "\\pm"].iter().find_map(|sign| value.strip_prefix(sign)) {
        let size = size.trim_start();
        return vec![size.to_owned(), format!("-{size}")];
    }
    let answer = answer.replace(['{', '}'], "");
    let mut pieces = vec![answer.as_str()];
    for word in BETWEEN {
        pieces = pieces.into_iter().flat_map(|piece| piece.split(word)).collect();
    }
    let pieces: Vec<&str> = pieces.into_iter().map(str::trim).filter(|piece| !piece.is_empty()).collect();
    let pieces = with_words(&answer, &pieces);
    let unit = pieces.last().map_or("", |last| behind_number(last));
    let with_unit = |piece: &&str| {
        if behind_number(piece).is_empty() {
            format!("{piece} {unit}").trim_end().to_owned()
        } else {
            (*piece).to_owned()
        }
    };
    pieces.iter().map(with_unit).collect()
}

/// The same with what has no number in it left where it was: `2 m/s, to the left`.
fn with_words<'t>(answer: &'t str, pieces: &[&'t str]) -> Vec<&'t str> {
    let mut joined: Vec<&str> = Vec::new();
    for piece in pieces {
        let has_number = piece.char_indices().any(|(at, _)| arithmetic::begins_number(&piece[at..]));
        match joined.last_mut() {
            Some(last) if !has_number => {
                let start = last.as_ptr() as usize - answer.as_ptr() as usize;
                let end = piece.as_ptr() as usize - answer.as_ptr() as usize + piece.len();
                *last = answer.get(start..end).unwrap_or(last);
            }
            _ => joined.push(piece),
        }
    }
    joined
}

/// The text behind the digits at the start: a unit, perhaps with a direction. None where it is part of a calculation.
fn behind_number(text: &str) -> &str {
    let text = text.rsplit_once('=').map_or(text, |(_, value)| value.trim_start());
    let end = text.rfind(|last: char| last.is_ascii_digit() || last == ')').map_or(0, |at| at + 1);
    let unit =
        text.find(|first: char| first.is_alphabetic() && first != 'e' && first != 'x' || first == '°' || first == '%');
    match unit {
        Some(at) if !arithmetic::begins_number(&text[at..]) => text[at..].trim(),
        _ => text[end..].trim(),
    }
}
