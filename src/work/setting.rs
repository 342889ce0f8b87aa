//! Removes typesetting from a line: commands of LaTeX, columns of a matrix, commas in an index.

/// Spellings of a change.
const CHANGES: [(&str, &str); 3] = [("\\Delta ", "Δ"), ("Delta ", "Δ"), ("delta ", "Δ")];

/// Commands and signs of LaTeX that only typeset a line, each with the plain text for it.
const SETTING: [(&str, &str); 25] = [
    ("\\max", "max"),
    ("\\min", "min"),
    ("\\dots", "…"),
    ("\\ldots", "…"),
    ("\\cdots", "…"),
    ("...", "…"),
    ("\\begin{aligned}", ""),
    ("\\end{aligned}", ""),
    ("\\begin{align*}", ""),
    ("\\end{align*}", ""),
    ("\\begin{equation}", ""),
    ("\\end{equation}", ""),
    ("\\quad", " "),
    ("\\qquad", " "),
    ("\\[", ""),
    ("\\]", ""),
    ("$", ""),
    ("&", ""),
    ("\\\\", " "),
    ("\\ ", " "),
    ("\\;", " "),
    ("\\:", " "),
    ("\\!", ""),
    ("_\\text{", "_{"),
    ("_\\mathrm{", "_{"),
];

/// Functions of an angle.
const FUNCTIONS: [&str; 3] = ["sin", "cos", "tan"];
/// Environments in which a vector stands as a column.
const COLUMNS: [&str; 4] = ["pmatrix", "bmatrix", "matrix", "array"];

/// A line as plain text.
pub(crate) fn unset(line: &str) -> String {
    let line = with_pi_apart(&with_lists(line));
    let line = SETTING.iter().fold(line, |line, (from, to)| line.replace(from, to));
    let line = with_arguments_apart(&with_plain_indices(&line));
    with_joined_indices(&CHANGES.iter().fold(line, |line, (from, to)| line.replace(from, to)))
}

/// `\begin{pmatrix} 3 \\ -4 \end{pmatrix}` as `(3, -4)`.
fn with_lists(line: &str) -> String {
    let mut text = line.to_owned();
    for name in COLUMNS {
        let (begin, end) = (format!("\\begin{{{name}}}"), format!("\\end{{{name}}}"));
        while let Some((before, rest)) = text.split_once(&begin) {
            let Some((inner, behind)) = rest.split_once(&end) else { break };
            // The columns of an array are told first: `{c}`.
            let inner = match inner.split_once('}') {
                Some((_, inner)) if name == "array" => inner,
                _ => inner,
            };
            let parts: Vec<&str> = inner.split("\\\\").flat_map(|row| row.split('&')).map(str::trim).collect();
            let parts: Vec<&str> = parts.into_iter().filter(|part| !part.is_empty()).collect();
            let bare = |side: &str| side.trim_end().ends_with(['(', '[']);
            let list = parts.join(", ");
            let list = if bare(before) || bare(before.trim_end().trim_end_matches("\\left")) {
                list
            } else {
                format!("({list})")
            };
            text = format!("{before}{list}{behind}");
        }
    }
    text
}

/// `\pi t` as `\pi*t`.
fn with_pi_apart(line: &str) -> String {
    let (mut text, mut rest) = (String::with_capacity(line.len()), line);
    while let Some((before, behind)) = rest.split_once("\\pi ") {
        let is_factor = behind.trim_start().starts_with(char::is_alphabetic);
        text.extend([before, if is_factor { "\\pi*" } else { "\\pi " }]);
        rest = behind;
    }
    text + rest
}

/// `cos45` as `cos 45`.
fn with_arguments_apart(line: &str) -> String {
    let mut text = String::with_capacity(line.len());
    for sign in line.chars() {
        let is_function = |name: &str| {
            let before = text.strip_suffix(name);
            before.is_some_and(|before| !before.ends_with(|sign: char| sign.is_alphabetic() || sign == '_'))
        };
        let is_argument = sign.is_ascii_digit() || sign.is_alphabetic() && !sign.is_ascii();
        if is_argument && FUNCTIONS.iter().any(|function| is_function(function)) {
            text.push(' ');
        }
        text.push(sign);
    }
    text
}

/// `v_{\text{rel},A1}` as `v_{rel_A1}`, as the sheet sets it.
fn with_plain_indices(line: &str) -> String {
    let (mut text, mut rest) = (String::with_capacity(line.len()), line);
    while let Some((before, behind)) = rest.split_once("_{") {
        let mut depth = 1_usize;
        let end = behind.find(|sign| {
            depth = match sign {
                '{' => depth + 1,
                '}' => depth - 1,
                _ => depth,
            };
            depth == 0
        });
        let Some(end) = end else { break };
        let index = ["\\text", "\\mathrm", "{", "}", " "]
            .iter()
            .fold(behind[..end].to_owned(), |index, word| index.replace(word, ""));
        text.extend([before, "_{", &index.replace(',', "_"), "}"]);
        rest = &behind[end + 1..];
    }
    text + rest
}

/// `v_A,x`, `F_T,C2` and `T_rel,1` with the index behind the comma joined to the one before.
fn with_joined_indices(line: &str) -> String {
    let signs: Vec<char> = line.chars().collect();
    let mut text = String::with_capacity(line.len());
    let mut is_index = false;
    for (at, sign) in signs.iter().enumerate() {
        let before = at.checked_sub(1).and_then(|before| signs.get(before));
        let is_next = |next: &char| next.is_alphabetic() || is_index && next.is_numeric();
        let is_joined = *sign == ','
            && before.is_some_and(|before| before.is_alphabetic())
            && signs.get(at + 1).is_some_and(is_next);
        is_index = *sign == '_' || is_joined || is_index && (sign.is_alphanumeric() || *sign == '{');
        text.push(if is_joined { '_' } else { *sign });
    }
    text
}

#[cfg(test)]
mod tests {
    use super::unset;

    #[test]
    fn a_column_is_a_list() {
        assert_eq!(unset("r = \\begin{pmatrix} 13 \\\\ -12 \\end{pmatrix}\\ \\text{m}"), "r = (13, -12) \\text{m}");
        assert_eq!(unset("\\left[\\begin{array}{c} 3 \\\\ 4 \\end{array}\\right]"), "\\left[3, 4\\right]");
    }

    #[test]
    fn an_index_is_one_word() {
        assert_eq!(unset("v_{\\text{rel},A1} = v_A,x"), "v_{rel_A1} = v_A_x");
    }
}
