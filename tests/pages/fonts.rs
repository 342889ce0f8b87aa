//! The font of mathematics: it holds every character that documents print as mathematics, and what has to grow can.

use std::collections::BTreeMap;

use momentous::exercise::Exercise;
use momentous::explain::Audience;
use momentous::explain::Detail;
use momentous::render::Format;
use momentous::render::Identity;
use momentous::render::Key;
use momentous::render::MATH_FONT;
use momentous::render::Page;
use momentous::render::Renderer;
use momentous::render::Sheet;
use momentous::render::Solution;
use ttf_parser::Face;

use crate::problems;

/// What an author may reasonably write between dollars.
const AUTHORED: &[&str] = &[
    r"abcdefghijklmnopqrstuvwxyz ABCDEFGHIJKLMNOPQRSTUVWXYZ 0123456789 + - * / = < > ( ) [ ] | . , : ; ! ?",
    r"\alpha\beta\gamma\delta\epsilon\varepsilon\zeta\eta\theta\vartheta\iota\kappa\lambda\mu\nu\xi\pi\varpi\rho\varrho",
    r"\sigma\varsigma\tau\upsilon\phi\varphi\chi\psi\omega\Gamma\Delta\Theta\Lambda\Xi\Pi\Sigma\Upsilon\Phi\Psi\Omega",
    r"\vec v \hat v \bar v \dot v \ddot v \tilde v \overline{v} \overrightarrow{AB} \overbrace{a} \underbrace{a}",
    r"\mathbf{p} \boldsymbol{v} \boldsymbol\omega \mathrm{kg} \text{kg m} \mathbb R \mathbb N \mathbb Z \mathbb C",
    r"\frac12 \sqrt{2} \sqrt[3]{2} \sum_{i=1}^n \prod_i \int_0^t \iint \oint f'(x) f''(x) x^{\prime}",
    r"\left(\frac12\right) \left[\frac12\right] \left\{\frac12\right\} \left|\frac12\right| \langle x \rangle \lVert x \rVert",
    r"a \pm b \mp c \times d \cdot e \div f \ast g \circ h \oplus i \otimes j \cap k \cup l \wedge m \vee n",
    r"a \neq b \approx c \sim d \simeq e \cong f \equiv g \propto h \leq i \geq j \ll k \gg l \perp m \parallel n \mid o",
    r"a \to b \rightarrow c \leftarrow d \leftrightarrow e \Rightarrow f \Leftarrow g \Leftrightarrow h \implies i \iff j",
    r"\mapsto \longrightarrow \uparrow \downarrow \updownarrow \nearrow \searrow \rightleftharpoons \rightharpoonup",
    r"\in \notin \subset \subseteq \forall \exists \infty \partial \nabla \hbar \ell \angle \therefore",
    r"\ldots \cdots \vdots \ddots \quad a\,b\;c\:d \% \# \& 30^\circ \ln x \sin x \max \min \lim_{x\to0}",
    r"\begin{cases} 1 & t < 1 \\ 2 & t \geq 1 \end{cases} \begin{pmatrix} 1 & 2 \\ 3 & 4 \end{pmatrix}",
];

/// What grows upwards with its contents, and beyond every size that the font has ready.
const GROWING: &str = "√()[]{}|‖∫";

fn font() -> Vec<u8> {
    wuff::decompress_woff2(MATH_FONT).unwrap()
}

/// Each character within `<math>` as a browser looks it up in the font, and an element in which it stands.
fn characters(name: &str, html: &str, found: &mut BTreeMap<char, String>) {
    for element in html.split("<math").skip(1).filter_map(|rest| rest.split("</math>").next()) {
        for tag in element.split('<').skip(1) {
            let (tag, text) = tag.split_once('>').unwrap();
            let text = ["&lt;", "&gt;", "&quot;", "&#39;", "&amp;"]
                .into_iter()
                .zip(["<", ">", "\"", "'", "&"])
                .fold(text.to_owned(), |text, (entity, character)| text.replace(entity, character));
            let is_single = tag == "mi" && text.chars().count() == 1;
            for character in text.chars().filter(|character| !character.is_control()) {
                found
                    .entry(if is_single { italic(character) } else { character })
                    .or_insert_with(|| format!("{name}: <math{element}"));
            }
        }
    }
}

/// The letter that a browser sets for a single one in `<mi>`: the table *italic* of `MathML` Core, appendix C.
fn italic(letter: char) -> char {
    let from = |first: char, start: u32| char::from_u32(start + u32::from(letter) - u32::from(first)).unwrap();
    match letter {
        'h' => '\u{210e}',
        'A'..='Z' => from('A', 0x1d434),
        'a'..='z' => from('a', 0x1d44e),
        'Α'..='Ω' => from('Α', 0x1d6e2),
        'α'..='ω' => from('α', 0x1d6fc),
        '∇' => '\u{1d6fb}',
        '∂' => '\u{1d715}',
        'ϵ' => '\u{1d716}',
        'ϑ' => '\u{1d717}',
        'ϰ' => '\u{1d718}',
        'ϕ' => '\u{1d719}',
        'ϱ' => '\u{1d71a}',
        'ϖ' => '\u{1d71b}',
        'ı' => '\u{1d6a4}',
        'ȷ' => '\u{1d6a5}',
        other => other,
    }
}

/// Fails where the font lacks one of them.
fn holds(found: &BTreeMap<char, String>) {
    let data = font();
    let face = Face::parse(&data, 0).unwrap();
    let lacking: Vec<String> = found
        .iter()
        .filter(|(character, _)| face.glyph_index(**character).is_none())
        .map(|(character, element)| format!("U+{:04X} {character} in {element}", u32::from(*character)))
        .collect();
    assert!(lacking.is_empty(), "not in the font; add them to templates/fonts/make.py:\n{}", lacking.join("\n"));
}

/// The pages of an exercise for students and for instructors, and its row of a key.
fn pages(exercise: &Exercise) -> Vec<Page> {
    let solution = |audience| {
        let (outline, identity) = (exercise.outline(audience, Detail::Full), exercise.identity());
        Page::Solution(Solution { outline, identity, audience, faded: None })
    };
    let key = Page::Key(Key { title: String::new(), rows: exercise.key() });
    vec![Page::Sheet(exercise.sheet()), solution(Audience::Everyone), solution(Audience::Instructor), key]
}

#[test]
fn the_font_holds_what_the_bank_prints() {
    let renderer = Renderer::new(None).unwrap();
    let mut found = BTreeMap::new();
    for seed in [1, 2] {
        for exercise in problems::exercises(seed) {
            let html = renderer.render(&pages(&exercise), Format::Html).unwrap().text;
            characters(&problems::name(&exercise), &html, &mut found);
        }
    }
    assert!(found.contains_key(&'\u{1d463}') && found.contains_key(&'∫'), "{:?}", found.keys());
    holds(&found);
}

#[test]
fn the_font_holds_what_authors_write() {
    let renderer = Renderer::new(None).unwrap();
    let mut found = BTreeMap::new();
    for text in AUTHORED {
        let sheet = Sheet { statement: format!("${text}$"), identity: Identity::default(), ..Sheet::default() };
        characters(text, &renderer.render_sheets(&[sheet], Format::Html).unwrap().text, &mut found);
    }
    holds(&found);
}

#[test]
fn roots_and_brackets_grow() {
    let data = font();
    let face = Face::parse(&data, 0).unwrap();
    let variants = face.tables().math.unwrap().variants.unwrap();
    for character in GROWING.chars() {
        let glyph = face.glyph_index(character).unwrap();
        let grown = variants.vertical_constructions.get(glyph).unwrap_or_else(|| panic!("{character} does not grow"));
        assert!(grown.assembly.is_some_and(|assembly| assembly.parts.len() > 1), "{character} grows up to a limit");
    }
}

#[test]
fn the_font_says_whose_it_is() {
    let data = font();
    let face = Face::parse(&data, 0).unwrap();
    let name = |id| face.names().into_iter().find(|name| name.name_id == id).and_then(|name| name.to_string()).unwrap();
    let licence = include_str!("../../templates/fonts/OFL.txt");
    assert_eq!(name(ttf_parser::name_id::FULL_NAME), "Momentous Math");
    assert!(licence.contains(&name(ttf_parser::name_id::COPYRIGHT_NOTICE)));
    assert!(name(ttf_parser::name_id::LICENSE).contains("SIL Open Font License, Version 1.1"));
}

/// A document holds the font once, and only where it has mathematics.
#[test]
fn documents_hold_the_font_where_they_need_it() {
    let sheet = |statement: &str| [Sheet { statement: statement.to_owned(), ..Sheet::default() }];
    let html =
        |renderer: &Renderer, statement: &str| renderer.render_sheets(&sheet(statement), Format::Html).unwrap().text;
    let fonts = |text: &str| text.matches("src: url(data:font/woff2;base64,d09GMk9U").count();
    let (plain, with) = (Renderer::new(None).unwrap(), Renderer::new(None).unwrap().with_font());
    assert_eq!(fonts(&html(&with, "Find $v$.")), 1);
    assert_eq!(fonts(&html(&with, "Find nothing.")), 0);
    assert_eq!(fonts(&html(&plain, "Find $v$.")), 0);
    assert_eq!(
        html(&with, "Find $v$.").len() - html(&plain, "Find $v$.").len(),
        MATH_FONT.len().div_ceil(3) * 4 + RULE
    );
}

/// What the rule around the font takes, in bytes.
const RULE: usize =
    r#"@font-face { font-family: "Momentous Math"; src: url(data:font/woff2;base64,) format("woff2"); }"#.len() + 1;
