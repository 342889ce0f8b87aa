//! Rates as they are written, `dm/dt`, `\frac{dH}{dt}`, `\dot{p}`, each as one name: `rate_m`.

/// Spellings of an upright d.
const UPRIGHT: [&str; 3] = ["\\mathrm{d}", "\\text{d}", "{\\rm d}"];
/// The beginning of the name of a rate.
const RATE: &str = "rate_";

/// A line with the rates that have a name under it.
pub(crate) fn named(line: &str, is_name: &dyn Fn(&str) -> bool) -> String {
    let mut text = UPRIGHT.iter().fold(line.to_owned(), |line, upright| line.replace(upright, "d"));
    let mut from = 0;
    while let Some((start, end, letter)) = next(&text, from) {
        let name = format!("{RATE}{letter}");
        if is_name(&name) {
            // Between spaces, so that an exponent or a factor behind it stays apart.
            let name = format!(" {name} ");
            text.replace_range(start..end, &name);
            from = start + name.len();
        } else {
            from = end;
        }
    }
    text
}

/// The next rate of a text from some place on: where it starts and ends, and of what it is one.
fn next(text: &str, from: usize) -> Option<(usize, usize, String)> {
    let rest = text.get(from..)?;
    let rates = [quotient(rest), fraction(rest), dotted(rest)];
    let (start, end, letter) = rates.into_iter().flatten().min_by_key(|place| place.0)?;
    Some((from + start, from + end, bare(letter)))
}

/// `dH/dt`, also with brackets: `d(m v)/dt` is none.
fn quotient(text: &str) -> Option<(usize, usize, &str)> {
    text.match_indices("/dt").find_map(|(at, sign)| {
        let end = at + sign.len();
        let start = text[..at]
            .rfind(|sign: char| !is_of_name(sign))
            .map_or(0, |place| place + text[place..].chars().next().map_or(1, char::len_utf8));
        let letter = text[start..at].strip_prefix('d').filter(|letter| !letter.is_empty())?;
        let is_word = text[end..].starts_with(|sign: char| sign.is_alphanumeric() || sign == '_');
        (!is_word).then_some((start, end, letter))
    })
}

/// `\frac{dH}{dt}`.
fn fraction(text: &str) -> Option<(usize, usize, &str)> {
    text.match_indices("}{dt}").find_map(|(at, sign)| {
        let start = text[..at].rfind("\\frac{d")?;
        let letter = text[start + "\\frac{d".len()..at].trim();
        (!letter.is_empty() && letter.chars().all(is_of_name)).then_some((start, at + sign.len(), letter))
    })
}

/// `\dot{H}`, `\dot H`.
fn dotted(text: &str) -> Option<(usize, usize, &str)> {
    let start = text.find("\\dot")?;
    let behind = &text[start + "\\dot".len()..];
    if let Some(inner) = behind.strip_prefix('{') {
        let end = inner.find('}')?;
        // What stands behind the bracket may be an index: `\dot{m}_A`.
        return Some((start, start + "\\dot{".len() + end + 1, &inner[..end]));
    }
    let letter = behind.trim_start();
    let first = letter.chars().next().filter(|sign| sign.is_alphabetic())?;
    let at = text.len() - letter.len();
    Some((start, at + first.len_utf8(), &text[at..at + first.len_utf8()]))
}

fn is_of_name(sign: char) -> bool {
    sign.is_alphanumeric() || matches!(sign, '_' | '{' | '}' | '.' | ',')
}

fn bare(name: &str) -> String {
    name.chars().filter(|sign| sign.is_alphanumeric() || *sign == '_').collect()
}

#[cfg(test)]
mod tests {
    use super::named;

    #[test]
    fn rates_are_one_name() {
        let rate = |line: &str| named(line, &|name| name != "rate_Q");
        assert_eq!(rate("dm/dt = 28.8"), " rate_m  = 28.8");
        assert_eq!(rate("F = \\frac{\\mathrm{d}p_x}{\\mathrm{d}t}"), "F =  rate_p_x ");
        assert_eq!(rate("F - \\dot{m} v = m dv/dt"), "F -  rate_m  v = m  rate_v ");
        assert_eq!(rate("x/dt + dQ/dt = 3 m/dtx"), "x/dt + dQ/dt = 3 m/dtx");
    }
}
