//! Text of any kind: what it holds is printed, and nothing in it is read as Typst.

use momentous::explain::Inline;
use momentous::expr::Math;
use momentous::render::{Format, Identity, Page, Renderer, Sheet, SheetPart, text_faults};
use proptest::prelude::*;
use unicode_normalization::UnicodeNormalization;

use super::bank::{GROSS, SIDES};
use super::{PRESS, RENDERER, poppler, print};

/// Pieces that Typst would read, or that a writer could break.
const READ: &[&str] = &[
    "#",
    "#let x = 1",
    "#panic(\"no\")",
    "#import \"/etc/passwd\"",
    "$",
    "$x$",
    "$$",
    "*",
    "**b**",
    "_",
    "__",
    "`",
    "```",
    "<a>",
    "@a",
    "[",
    "]",
    "](",
    "{",
    "}",
    "(",
    ")",
    "\\",
    "\\\\",
    "\\u{41}",
    "\\ ",
    "//",
    "/*",
    "*/",
    "http://a.b/c",
    "~",
    "--",
    "---",
    "-?",
    "-1",
    "...",
    "\"",
    "'",
    "=",
    "= ",
    "== h",
    "- i",
    "+ i",
    "/ t: d",
    "1. ",
    "12.",
    ";",
    ";;",
    ":",
    "%",
    "&",
    "^",
    "|",
    "<<",
    ">>",
    "<%",
    "%>",
    "<#",
    "]]>",
    "</svg>",
    "&amp;",
    "é",
    "ß",
    "Ω",
    "Ж",
    "ẞ",
    "−",
    "×",
    "→",
    "„“",
    "’",
    "½",
    "m/s^2",
    "a",
    "Zoë",
    "7",
    " ",
];

fn hostile() -> impl Strategy<Value = String> {
    let piece = prop_oneof![3 => prop::sample::select(READ).prop_map(str::to_owned), 1 => "[ -~]{1,6}", 1 => "[a-zA-Z0-9À-ž]{1,8}"];
    prop::collection::vec(piece, 1..6).prop_map(|pieces| pieces.concat())
}

/// What poppler can give back: signs in their plain forms, without blanks and places where long words may break.
fn plain(text: &str) -> String {
    text.nfkc().filter(|sign| !sign.is_whitespace() && *sign != '\u{200b}').collect()
}

/// A text that fits the line, in which mathematics is not broken; a hat would raise what follows it.
fn in_mathematics(text: &str) -> String {
    text.chars().filter(|sign| *sign != '^').take(12).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    /// Twenty texts at a time, in every place that takes one.
    #[test]
    fn text_is_printed_as_it_is(title in hostile(), student in hostile(), problem in hostile(), texts in prop::collection::vec(hostile(), 20)) {
        let part = |text: &String| SheetPart {
            label: "a".into(),
            // A blank between them: what has none may be wider than the page.
            text: [Inline::Text, Inline::Emphasis, Inline::Strong]
                .into_iter()
                .flat_map(|kind| [kind(text.clone()), Inline::Text(" ".into())])
                .chain([Inline::Math(Math::Text(in_mathematics(text)))])
                .collect(),
            ..SheetPart::default()
        };
        let identity = Identity { problem: problem.clone(), ..Identity::default() };
        let parts = texts.iter().map(part).collect();
        let sheet = Sheet { title: format!("A{title}"), student: Some(student.clone()), identity, parts, ..Sheet::default() };
        let pdf = print(&[Page::Sheet(sheet)]);
        if poppler::is_installed() {
            let pages = poppler::pages(&pdf);
            // The foot of a page would stand between the lines of a text that goes on overleaf.
            let foot = plain(&format!("{student} · {problem}"));
            let printed: String = pages.iter().enumerate().map(|(page, text)| plain(text).replace(&format!("{foot}{}", page + 1), "")).collect();
            let mut rest = printed.as_str();
            for expected in std::iter::once(format!("A{title}For {student}")).chain(texts.iter().map(|text| format!("{text}{text}{text}{}", in_mathematics(text)))) {
                let expected = plain(&expected);
                let place = rest.find(&expected);
                prop_assert!(place.is_some(), "{expected:?} is not in {rest:?}");
                rest = &rest[place.unwrap() + expected.len()..];
            }
        }
    }

    /// Whatever an author may write is set; what is refused is refused before the press.
    #[test]
    fn what_authors_may_write_is_set(pieces in prop::collection::vec(author(), 1..12)) {
        let statement = pieces.concat();
        if text_faults(&statement).is_empty() {
            print(&[Page::Sheet(Sheet { title: "T".into(), statement, ..Sheet::default() })]);
        }
    }
}

/// Pieces of Markdown and mathematics.
fn author() -> impl Strategy<Value = String> {
    const PIECES: &[&str] = &[
        "# h\n",
        "### h\n",
        "\n\n",
        "\n- i\n",
        "\n  - ii\n",
        "\n3. x\n",
        "> q\n",
        "*e*",
        "**s**",
        "`c`",
        "```\nx  #y\n```\n",
        "---\n",
        "  \n",
        "[l](https://a.b/?c=d#e)",
        "\n\n| a | b |\n|---|:-:|\n| 1 | $x$ |\n\n",
        "<b>",
        "&lt;",
        "\\*",
        " word ",
        "$v_{A1} = -2{,}5$",
        "$\\frac{1}{2} m v^2$",
        "$$\\sum_{i=1}^n x_i$$",
        "$\\vec v \\hat v \\bar v \\dot v \\overline{v} \\overrightarrow{AB}$",
        "$\\left(\\frac12\\right]\\left\\{a\\right|$",
        "$\\sqrt[3]{x}\\int_0^t f'(x)\\,dx$",
        "$\\text{a # b \\$ c}$",
        "$\\mathrm{kg}\\,\\mathbf{p}$",
        "$\\begin{cases} 1 & t < 1 \\\\ 2 & t \\geq 1 \\end{cases}$",
        "$\\begin{pmatrix} 1 & 2 \\\\ 3 & 4 \\end{pmatrix}$",
        "$a;b,c:d.e!f\\#g$",
        "$\\begin{aligned} a &= b \\\\ c &= d \\end{aligned}$",
        "$\\lim_{x\\to0} \\max_i \\sin^2 x$",
        "$\\overbrace{a}^b \\underbrace{c}_d$",
        "$\\binom{n}{k} \\dfrac12 \\tfrac12 \\big( x \\big)$",
        "$\\cancel{x} \\phantom{y} \\boldsymbol\\omega$",
        "$x'' \\langle a \\rangle \\lVert b \\rVert$",
    ];
    prop_oneof![4 => prop::sample::select(PIECES).prop_map(str::to_owned), 1 => "[ -~]{1,5}"]
}

#[test]
fn a_word_wider_than_a_line_is_broken() {
    if !poppler::is_installed() {
        return;
    }
    let word = "Wholly".repeat(40);
    let statement = format!(
        "A {word}, *{word}* and `{word}` with https://example.org/{word}.\n\n| a | b |\n|---|---|\n| {word} | b |"
    );
    let part = SheetPart { label: "a".into(), text: vec![Inline::Text(word.clone())], ..SheetPart::default() };
    let identity = Identity { problem: word.clone(), ..Identity::default() };
    let sheet =
        Sheet { title: word.clone(), statement, student: Some(word), identity, parts: vec![part], ..Sheet::default() };
    for (left, right, word) in poppler::boxes(&print(&[Page::Sheet(sheet)])) {
        assert!(left >= SIDES[0] - GROSS && right <= SIDES[1] + GROSS, "{left} {right} {word}");
    }
}

#[test]
fn a_sign_that_no_font_has_is_named() {
    let sheet = Sheet { title: "T".into(), student: Some("\u{738b}".into()), ..Sheet::default() };
    let document = RENDERER.render_sheets(&[sheet], Format::Typst).unwrap().text;
    let faults = PRESS.pdf(&document).unwrap_err().to_string();
    assert!(faults.contains('\u{738b}') && faults.contains("templates/fonts/"), "{faults}");
}

#[test]
fn a_document_reads_no_file_and_its_faults_have_a_place() {
    let folder = tempfile::tempdir().unwrap();
    let templates = folder.path().join("typst");
    std::fs::create_dir(&templates).unwrap();
    std::fs::write(templates.join("document.tera"), "\n#read(\"/etc/passwd\")\n").unwrap();
    let renderer = Renderer::new(Some(folder.path())).unwrap();
    let document = renderer.render_sheets(&[Sheet::default()], Format::Typst).unwrap().text;
    let faults = PRESS.pdf(&document).unwrap_err().to_string();
    assert!(faults.contains(":2:") && !faults.contains("root:"), "{faults}");
}
