//! How deep mathematics nests. What reads it calls itself for every level, so a level too many would end the program.

/// The levels that may lie in each other: a page shows fewer, and a thread has room for more than twice as many.
pub(super) const DEEPEST: usize = 32;

/// Commands that hold for the rest of their group, or may.
const FOR_THE_REST: [&str; 6] = ["displaystyle", "textstyle", "scriptstyle", "scriptscriptstyle", "color", "genfrac"];

/// So many signs behind a command, one after the other, are more than its arguments: what follows is no argument of it.
/// `\genfrac`, which takes more, is counted as one that holds for the rest.
const BEHIND: usize = 3;

/// A part of a formula that was begun and not ended yet.
struct Group {
    /// The sign or command that ends it.
    end: &'static str,
    /// The levels of what stood open before it.
    before: usize,
    /// The levels at its beginning.
    inside: usize,
    /// The commands right before it.
    chain: usize,
}

/// The place at which a formula nests too deep, in bytes; none where it does not.
///
/// No grammar is needed to be on the safe side: every group is a level, and so is every command that may be an argument of
/// the one before.
pub(super) fn too_deep(tex: &str) -> Option<usize> {
    let mut groups: Vec<Group> = Vec::new();
    // The levels of the groups that are open, with their commands for the rest; the commands that may be arguments of each
    // other; and the signs behind the last of these.
    let (mut levels, mut chain, mut signs) = (0, 0, 0);
    let mut rest = tex;
    while let Some((token, behind)) = token(rest) {
        let begun = match token {
            "{" => Some("}"),
            "[" => Some("]"),
            r"\left" => Some(r"\right"),
            r"\begin" => Some(r"\end"),
            _ => None,
        };
        if let Some(end) = begun {
            let inside = levels + chain + 1;
            groups.push(Group { end, before: levels, inside, chain });
            (levels, chain) = (inside, 0);
        } else if let Some(place) = ended(&groups, token) {
            if let Some(group) = groups.drain(place..).next() {
                (levels, chain, signs) = (group.before, group.chain, 0);
            }
        } else if matches!(token, "&" | r"\\") {
            // The next cell of a table.
            (levels, chain) = (groups.last().map_or(0, |group| group.inside), 0);
        } else if token.strip_prefix('\\').is_some_and(|name| FOR_THE_REST.contains(&name)) {
            (levels, chain) = (levels + chain + 1, 0);
        } else if is_command(token) || matches!(token, "^" | "_") {
            (chain, signs) = (chain + 1, 0);
        } else if !token.trim().is_empty() {
            signs += 1;
            chain = if signs < BEHIND { chain } else { 0 };
        }
        if levels + chain > DEEPEST {
            return Some(tex.len() - rest.len());
        }
        rest = behind;
    }
    None
}

/// The group that a token ends: a bracket the innermost only, for it may also be a sign that is printed.
fn ended(groups: &[Group], token: &str) -> Option<usize> {
    let ends = |group: &Group| group.end == token;
    match token {
        "]" => groups.last().is_some_and(ends).then(|| groups.len() - 1),
        _ => groups.iter().rposition(ends),
    }
}

/// A command with its letters, an escaped sign, or one sign; and what stands behind it.
fn token(tex: &str) -> Option<(&str, &str)> {
    let mut signs = tex.chars();
    let first = signs.next()?;
    let mut length = first.len_utf8();
    if first == '\\' {
        let letters = signs.clone().take_while(char::is_ascii_alphabetic).count();
        length += letters.max(signs.next().map_or(0, char::len_utf8));
    }
    tex.split_at_checked(length)
}

fn is_command(token: &str) -> bool {
    token.strip_prefix('\\').is_some_and(|name| name.starts_with(|sign: char| sign.is_ascii_alphabetic()))
}

#[cfg(test)]
mod tests {
    use math_core::LatexToMathML;
    use math_core::MathDisplay;

    use super::*;

    /// Ways to nest, each with what begins and ends a level.
    const WAYS: [(&str, &str); 28] = [
        (r"\sqrt{", "}"),
        (r"\sqrt ", ""),
        (r"\sqrt[a", "]b"),
        (r"\sqrt[\sqrt ", "]b"),
        (r"\frac{a}", ""),
        (r"\frac a", ""),
        (r"\left(a", r"a\right)"),
        (r"\left[a", r"a\right]"),
        (r"\displaystyle a", ""),
        (r"\color{red}a", ""),
        ("x^{", "}"),
        ("{a_", "}"),
        ("{", "}"),
        (r"\begin{matrix}a", r"a\end{matrix}"),
        (r"\begin{cases}a&", r"\\a\end{cases}"),
        (r"\overset{a}{", "}"),
        (r"\mathbin{", "}"),
        (r"\mathbf{", "}"),
        (r"\not ", ""),
        (r"\hat ", ""),
        (r"\phantom{", "}"),
        (r"\xrightarrow[", "]{a}"),
        (r"\sideset{", r"}{}\sum"),
        (r"{a\over ", "}"),
        (r"\prescript a b", ""),
        (r"\prescript{a}{b}", ""),
        (r"\genfrac()00a", ""),
        (r"\frac+", ""),
    ];

    fn nested((begin, end): (&str, &str), levels: usize) -> String {
        format!("{}x{}", begin.repeat(levels), end.repeat(levels))
    }

    #[test]
    fn whatever_nests_is_bounded_before_it_is_read() {
        for way in WAYS {
            let levels = (1..2000).find(|levels| too_deep(&nested(way, *levels)).is_some());
            let levels = levels.unwrap_or_else(|| panic!("{way:?} nests without end"));
            assert!(levels > DEEPEST / 3, "{way:?}: only {levels}");
            // A thread has 2 MB; what is still let through must not need them.
            let _ = LatexToMathML::default().convert_with_local_state(&nested(way, levels - 1), MathDisplay::Block);
        }
    }

    #[test]
    fn what_stands_side_by_side_is_not_deep() {
        let sum = r"\frac{\vec{p}_{1}}{\sqrt{2}} + ".repeat(20) + &r"\vec{p}_1 + 2 m v + ".repeat(300);
        let letters = r"\alpha\beta\gamma\delta\epsilon\zeta\eta\theta\iota\kappa\lambda\mu\nu\xi\pi\rho\sigma\tau";
        let rows = format!(
            r"\begin{{aligned}}{}\end{{aligned}}",
            r"\displaystyle a &= \frac{1}{2} \cdot \vec{b} \\ ".repeat(300)
        );
        let signs = "]0, 1[, [0, 1], ".repeat(3) + r"\{\}\[ \% \$ é";
        for tex in [sum.as_str(), letters, &rows, &signs, "", r"\", r"}}]\right"] {
            assert_eq!(too_deep(tex), None, "{}", tex.get(..80).unwrap_or(tex));
        }
    }
}
