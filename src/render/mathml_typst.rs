//! An author's mathematics as Typst: read from the `MathML` that was made of it, so that every format prints what was checked.

use momentous_expr::TypstMath;

use super::mathml::Element;
use super::mathml::NOTHING;

/// Signs that are only read.
const INVISIBLE: [char; 5] = ['\u{2061}', '\u{2062}', '\u{2063}', '\u{2064}', '\u{200b}'];
/// The sign between a function and its argument.
const APPLIED: &str = "\u{2061}";
/// Signs over or under a whole term that Typst draws by functions.
const DRAWN: [(&str, &str, &str); 4] = [
    ("mover", "\u{23de}", "overbrace"),
    ("munder", "\u{23df}", "underbrace"),
    ("mover", "\u{203e}", "overline"),
    ("munder", "_", "underline"),
];
/// Signs over a letter that Typst knows as accents.
const ACCENTS: &str =
    "`\u{b4}^~\u{af}\u{203e}\u{2d8}.\u{2d9}\u{a8}\u{2da}\u{2c7}\u{2192}\u{2190}\u{2194}\u{20d7}\u{21c0}\u{2c6}\u{2dc}";

/// Translates the content of `<math>` into Typst for math mode.
pub(super) fn typst(mathml: &str) -> String {
    let mut code = TypstMath::default();
    write_row(&Element::read(mathml), &mut code);
    code.into_code()
}

fn write_row(element: &Element, code: &mut TypstMath) {
    let parts: Vec<&Element> = element.elements().collect();
    for (index, part) in parts.iter().enumerate() {
        let is_applied = parts.get(index + 1).is_some_and(|next| next.name == "mo" && next.text() == APPLIED);
        match part.name.as_str() {
            "mi" if is_applied => code.call("op", |code| code.words(&part.text())),
            _ => write(part, code),
        }
        // The square of a sine is no name of a function, so Typst sets no gap behind it.
        if is_applied && part.name != "mi" {
            code.words("\u{2009}");
        }
    }
}

fn write(element: &Element, code: &mut TypstMath) {
    let part = |index: usize| element.elements().nth(index).unwrap_or(&NOTHING);
    match element.name.as_str() {
        "mn" => code.number(&element.text()),
        "mi" => write_identifier(element, code),
        "mo" => write_operator(element, code),
        "mtext" => write_words(element, code),
        "mspace" => write_space(element, code),
        "msqrt" => code.call("sqrt", |code| write_row(element, code)),
        "mroot" => code.call("root", |code| {
            write(part(1), code);
            code.argument("");
            write(part(0), code);
        }),
        "mfrac" => styled(element, code, |code| write_fraction(element, part(0), part(1), code)),
        "msub" => attached(part(0), &[("b:", part(1))], false, code),
        "msup" => attached(part(0), &[("t:", part(1))], false, code),
        "msubsup" => attached(part(0), &[("b:", part(1)), ("t:", part(2))], false, code),
        "munder" | "mover" => write_over_or_under(element, part(0), part(1), code),
        "munderover" => attached(part(0), &[("b:", part(1)), ("t:", part(2))], true, code),
        "mmultiscripts" => write_scripts(element, code),
        "mtable" => styled(element, code, |code| write_table(element, code)),
        "mphantom" => code.call("std.hide", |code| write_row(element, code)),
        "menclose" => code.call("cancel", |code| write_row(element, code)),
        _ if is_fenced(element) => code.call("lr", |code| write_row(element, code)),
        _ => styled(element, code, |code| write_row(element, code)),
    }
}

/// A letter in italics, unless it says otherwise; longer names upright.
fn write_identifier(element: &Element, code: &mut TypstMath) {
    let text = element.text();
    let mut letters = text.chars();
    match (letters.next(), letters.next()) {
        (Some(letter), None) if element.attribute("mathvariant") == Some("normal") => {
            code.call("upright", |code| code.sign(letter));
        }
        (Some(letter), None) => code.sign(letter),
        _ => code.words(&text),
    }
}

fn write_operator(element: &Element, code: &mut TypstMath) {
    let text: String = element.text().chars().filter(|sign| !INVISIBLE.contains(sign)).collect();
    if text.chars().count() > 1 && text.chars().all(char::is_alphabetic) {
        code.call("op", |code| {
            code.words(&text);
            if element.attribute("movablelimits").is_some() {
                code.argument("limits:#true");
            }
        });
        return;
    }
    match element.attribute("minsize").and_then(length) {
        Some(size) => code.call("lr", |code| {
            code.put(&format!("size:#{size},"));
            text.chars().for_each(|sign| code.sign(sign));
        }),
        None => text.chars().for_each(|sign| code.sign(sign)),
    }
}

/// Words, bold or slanted where the whole is.
fn write_words(element: &Element, code: &mut TypstMath) {
    let inner = element.elements().next();
    let looks = match inner.map_or("", |inner| inner.name.as_str()) {
        "b" => "bold",
        "i" | "em" => "italic",
        _ => return code.words(&element.text()),
    };
    code.call(looks, |code| code.words(&element.text()));
}

fn write_space(element: &Element, code: &mut TypstMath) {
    let negative = || element.attribute("style")?.strip_prefix("margin-left:").map(|text| text.trim_end_matches(';'));
    if let Some(width) = element.attribute("width").or_else(negative).and_then(length) {
        code.put(&format!("#h({width})"));
    }
}

/// A length of CSS as one of Typst; none in a unit that Typst lacks.
fn length(text: &str) -> Option<String> {
    let end = text.find(|sign: char| sign.is_ascii_alphabetic())?;
    let (number, unit) = text.split_at(end);
    let size: f64 = number.trim().parse().ok()?;
    let (size, unit) = match unit {
        "em" | "rem" => (size, "em"),
        "ex" => (size * 0.45, "em"),
        "px" => (size * 0.75, "pt"),
        "pt" | "cm" | "mm" | "in" => (size, unit),
        _ => return None,
    };
    size.is_finite().then(|| format!("{size:.4}{unit}"))
}

fn write_fraction(element: &Element, over: &Element, under: &Element, code: &mut TypstMath) {
    if element.attribute("linethickness").is_some_and(|thickness| thickness.starts_with('0')) {
        code.call("mat", |code| {
            code.put("delim:#none,");
            write(over, code);
            code.put(";");
            write(under, code);
        });
    } else {
        code.call("frac", |code| {
            write(over, code);
            code.argument("");
            write(under, code);
        });
    }
}

/// In the size and style that the element says.
fn styled(element: &Element, code: &mut TypstMath, inner: impl FnOnce(&mut TypstMath)) {
    let style = match (element.attribute("displaystyle"), element.attribute("scriptlevel")) {
        (_, Some("1")) => "script",
        (_, Some("2")) => "sscript",
        (Some("true"), _) => "display",
        (Some("false"), _) => "inline",
        _ => return inner(code),
    };
    code.call(style, inner);
}

/// Whether brackets at its ends grow with what is between them.
fn is_fenced(element: &Element) -> bool {
    let grows = |part: &Element| {
        let is_single = part.text().chars().count() == 1;
        part.name == "mo"
            && is_single
            && part.attribute("stretchy") != Some("false")
            && "()[]{}|\u{2016}\u{27e8}\u{27e9}\u{2308}\u{2309}\u{230a}\u{230b}".contains(&part.text())
    };
    element.elements().next().is_some_and(grows) || element.elements().last().is_some_and(grows)
}

fn attached(base: &Element, scripts: &[(&str, &Element)], with_limits: bool, code: &mut TypstMath) {
    code.call("attach", |code| {
        // Signs such as that of a sum know by themselves where their limits belong.
        if with_limits && base.name != "mo" {
            code.call("limits", |code| write(base, code));
        } else {
            write(base, code);
        }
        for (place, script) in scripts {
            code.argument(place);
            write(script, code);
        }
    });
}

fn write_over_or_under(element: &Element, base: &Element, sign: &Element, code: &mut TypstMath) {
    let text = sign.text();
    let drawn = |(name, written, _): &&(&str, &str, &str)| {
        sign.name == "mo" && *name == element.name && text == *written && sign.attribute("stretchy") != Some("false")
    };
    if let Some((_, _, function)) = DRAWN.iter().find(drawn) {
        code.call(function, |code| write(base, code));
    } else if element.attribute("accent").is_some() && text.chars().count() == 1 && ACCENTS.contains(&text) {
        code.call("accent", |code| {
            write(base, code);
            code.argument("");
            code.words(&text);
        });
    } else {
        let place = if element.name == "mover" { "t:" } else { "b:" };
        attached(base, &[(place, sign)], true, code);
    }
}

/// Scripts behind the base, then in front of it.
fn write_scripts(element: &Element, code: &mut TypstMath) {
    let mut parts = element.elements();
    let base = parts.next().unwrap_or(&NOTHING);
    let mut scripts = Vec::new();
    let mut places = ["b:", "t:", "bl:", "tl:"].into_iter();
    for part in parts {
        if part.name == "mprescripts" {
            places = ["bl:", "tl:", "", ""].into_iter();
        } else if let Some(place) = places.next().filter(|place| !place.is_empty()) {
            scripts.push((place, part));
        }
    }
    attached(base, &scripts, false, code);
}

fn write_table(table: &Element, code: &mut TypstMath) {
    code.call("mat", |code| {
        code.put("delim:#none,");
        for (row, line) in table.elements().enumerate() {
            if row > 0 {
                code.put(";");
            }
            for (column, cell) in line.elements().enumerate() {
                if column > 0 {
                    code.argument("");
                }
                let aligned = |side: &str| cell.attribute("style").is_some_and(|style| style.contains(side));
                if aligned("text-align: left") {
                    code.put("&");
                }
                write_row(cell, code);
                if aligned("text-align: right") {
                    code.put("&");
                }
            }
        }
    });
}

#[cfg(test)]
mod tests {
    use super::super::authored::{Authored, Piece};

    fn of(tex: &str) -> String {
        let text = format!("${tex}$");
        let checked = Authored::check("demo", &text).unwrap();
        let Some(Piece::Math { mathml, .. }) = checked.pieces.get(1) else { panic!("{:?}", checked.pieces) };
        super::typst(mathml)
    }

    #[test]
    fn what_authors_write_is_what_typst_reads() {
        for (tex, expected) in [
            (r"v_A = -2", r"attach(v,b:A)\=\−2"),
            (r"\frac{1}{2} m v^2", "frac(1,2)m attach(v,t:2)"),
            (r"\vec v", "accent(v,\"\u{20d7}\")"),
            (r"\sqrt[3]{x}", "root(3,x)"),
            (r"\sin x", "op(\"sin\")x"),
            (r"\sin^2 x", "attach(op(\"sin\"),t:2)x"),
            (r"5\,\mathrm{kg}", "5#h(0.1667em)\"kg\""),
            (r"\left(\frac12\right)", r"lr(\(frac(1,2)\))"),
            // The reader of authors' mathematics takes the blank after `\&` as the end of its name.
            (r"\$ \# \text{a \& b}", "\\$\\#\"a\u{a0}&b\""),
        ] {
            assert_eq!(of(tex), expected, "{tex}");
        }
    }
}
