//! Documents in every format: what they look like, what they escape, and what a user's templates may change.

mod samples;

use std::fs;
use std::sync::Arc;

use momentous::exercise::Exercise;
use momentous::explain::Audience;
use momentous::explain::Block;
use momentous::explain::Detail;
use momentous::explain::Inline;
use momentous::explain::Outline;
use momentous::fault::Code;
use momentous::fault::Source;
use momentous::problem::compile;
use momentous::problem::load;
use momentous::render::Figures;
use momentous::render::Format;
use momentous::render::Key;
use momentous::render::Markup;
use momentous::render::Page;
use momentous::render::Renderer;
use momentous::render::Sheet;
use momentous::render::Solution;
use momentous::render::fade;

use crate::pdflatex;

fn renderer() -> Renderer {
    Renderer::new(None).unwrap()
}

/// The document without its style sheets, which would only repeat themselves in every snapshot.
fn bare(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once("<style>") {
        out.push_str(before);
        rest = after.split_once("</style>").map_or("", |(_, after)| after);
    }
    out + rest
}

#[test]
fn sheets_in_every_format() {
    for format in Format::ALL {
        let document = renderer().render_sheets(&[samples::sheet()], format).unwrap();
        insta::assert_snapshot!(format!("sheet_{format}"), bare(&document.text));
    }
}

#[test]
fn solutions_in_every_format() {
    for format in Format::ALL {
        let document = renderer().render_solution(&samples::solution(), format).unwrap();
        insta::assert_snapshot!(format!("solution_{format}"), bare(&document.text));
    }
}

#[test]
fn keys_in_every_format() {
    for format in Format::ALL {
        let document = renderer().render_key(&samples::key(), format).unwrap();
        insta::assert_snapshot!(format!("key_{format}"), bare(&document.text));
    }
}

#[test]
fn a_faded_solution_keeps_its_first_steps_and_drops_the_answer() {
    let solution = Solution { faded: Some(1), ..samples::solution() };
    let document = renderer().render_solution(&solution, Format::Markdown).unwrap();
    insta::assert_snapshot!("faded_markdown", document.text);
    assert!(!document.text.contains("4.157") && !document.text.contains("4.16"));
}

#[test]
fn fading_shows_exactly_the_steps_asked() {
    let equations = |outline: &Outline| {
        let blocks = outline.sections.iter().flat_map(|section| &section.blocks);
        blocks.filter(|block| matches!(block, Block::Equation { .. })).count()
    };
    let outline = samples::outline();
    for steps in 0..=3 {
        assert_eq!(equations(&fade(&outline, steps)), steps);
    }
    assert_eq!(fade(&outline, 3), fade(&outline, 99));
    assert!(fade(&outline, 99).sections.iter().all(|section| section.audience == Audience::Everyone));
}

#[test]
fn a_sheet_and_its_solution_share_a_document_with_one_main_heading() {
    let pages = [Page::Sheet(samples::sheet()), Page::Solution(samples::solution())];
    let html = renderer().render(&pages, Format::Html).unwrap().text;
    assert_eq!(html.matches("<h1>").count(), 1);
    assert_eq!(html.matches("<article").count(), 2);
    let title = samples::sheet().title;
    assert_eq!(html.matches(&format!(">{title}</h")).count(), 1, "the shared title stands once");
    let latex = renderer().render(&pages, Format::Latex).unwrap().text;
    assert_eq!(latex.matches("\\begin{document}").count(), 1);
    assert_eq!(latex.matches("\\clearpage").count(), 1);
}

#[test]
fn a_solution_for_students_hides_what_is_the_instructors() {
    let solution = Solution { audience: Audience::Everyone, ..samples::solution() };
    let text = renderer().render_solution(&solution, Format::Html).unwrap().text;
    assert!(text.contains("Answer and check") && !text.contains("Certificate"));
}

#[test]
fn figures_may_lie_beside_a_markdown_document() {
    let renderer = renderer().figures(Figures::Beside("two pucks".into()));
    let document = renderer.render_solution(&samples::solution(), Format::Markdown).unwrap();
    assert!(document.text.contains("](two%20pucks-1.svg)") && !document.text.contains("<svg"));
    assert_eq!(document.beside.len(), 1);
    assert_eq!(document.beside[0].name, "two pucks-1.svg");
    assert!(document.beside[0].text.starts_with("<svg"));
    let html = renderer.render_solution(&samples::solution(), Format::Html).unwrap();
    assert!(html.text.contains("<svg") && html.beside.is_empty());
}

/// A sheet with hostile text in every place that a person fills in.
fn hostile_sheet() -> Sheet {
    let attack = "</title><script>alert(1)</script>\\input{x}\\end{document}$\\x$\"'&#{}%";
    let mut sheet = samples::sheet();
    sheet.title = attack.into();
    sheet.student = Some(attack.into());
    sheet.statement =
        format!("<script>alert(1)</script>\n\ntext <img src=x onerror=alert(1)> {}", "\\input{x} & 5% #1");
    sheet.parts[0].text = vec![Inline::Text(attack.into()), Inline::Strong(attack.into())];
    sheet.parts[0].label = attack.into();
    sheet.hints = vec!["<iframe>".into()];
    sheet.identity.problem = attack.into();
    sheet.identity.form = Some(attack.into());
    sheet
}

#[test]
fn no_text_breaks_out_of_html() {
    let html = renderer().render_sheets(&[hostile_sheet()], Format::Html).unwrap().text;
    assert!(!html.contains("<script") && !html.contains("<img") && !html.contains("<iframe"));
    assert!(html.contains("&lt;script&gt;") && html.contains("&lt;img src=x onerror=alert(1)&gt;"));
    assert_eq!(html.matches("</title>").count(), html.matches("<title>").count());
}

#[test]
fn no_text_breaks_out_of_latex() {
    let latex = renderer().render_sheets(&[hostile_sheet()], Format::Latex).unwrap().text;
    assert_eq!(latex.matches("\\end{document}").count(), 1);
    assert!(!latex.contains("\\input{"));
    assert!(latex.contains("\\textbackslash{}input\\{x\\}"));
}

#[test]
fn raw_html_does_not_pass_through_markdown() {
    let markdown = renderer().render_sheets(&[hostile_sheet()], Format::Markdown).unwrap().text;
    let options = pulldown_cmark::Options::ENABLE_MATH;
    for event in pulldown_cmark::Parser::new_ext(&markdown, options) {
        if let pulldown_cmark::Event::Html(html) | pulldown_cmark::Event::InlineHtml(html) = event {
            assert!(!html.contains("alert") && !html.contains("iframe"), "{html}");
        }
    }
}

#[test]
fn an_authors_bad_mathematics_is_a_located_fault() {
    let sheet = Sheet { statement: "A cart moves\nat $\\frac{1}$.".into(), ..samples::sheet() };
    let faults = renderer().render_sheets(&[sheet], Format::Latex).unwrap_err();
    assert_eq!(faults.list[0].code, Code::Text);
    insta::assert_snapshot!("bad_mathematics", faults);
}

#[test]
fn a_users_file_replaces_the_built_in_one_of_its_name_only() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("html")).unwrap();
    fs::write(folder.path().join("html/style.css"), "body { color: rebeccapurple }").unwrap();
    fs::create_dir(folder.path().join("latex")).unwrap();
    fs::write(
        folder.path().join("latex/key.tera"),
        "<% component key(page) %>Loesungen: << page.title >><% endcomponent %>",
    )
    .unwrap();
    let renderer = Renderer::new(Some(folder.path())).unwrap();
    let html = renderer.render_key(&samples::key(), Format::Html).unwrap().text;
    assert!(html.contains("rebeccapurple") && html.contains("<table>"));
    let latex = renderer.render_key(&samples::key(), Format::Latex).unwrap().text;
    assert!(latex.contains("Loesungen: Answer key") && latex.contains("\\documentclass"));
}

#[test]
fn faults_in_templates_are_shown_at_their_place() {
    let cases = [
        ("syntax", "html/sheet.tera", "{% component sheet(page, level) %}\n<p>{{ page.title\n{% endcomponent %}"),
        (
            "filter",
            "html/key.tera",
            "{% component key(page, level) %}\n\u{e9} {{ page.title | shout }}\n{% endcomponent %}",
        ),
        ("render", "html/key.tera", "{% component key(page, level) %}\n{{ page.heading }}\n{% endcomponent %}"),
        ("component", "html/blocks.tera", "{# nothing #}"),
    ];
    for (name, path, text) in cases {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join("html")).unwrap();
        fs::write(folder.path().join(path), text).unwrap();
        let result =
            Renderer::new(Some(folder.path())).and_then(|renderer| renderer.render_key(&samples::key(), Format::Html));
        let faults = result.unwrap_err();
        assert!(faults.list.iter().all(|fault| fault.code == Code::Template && fault.span.is_some()), "{name}");
        let shown = faults.to_string().replace(&folder.path().display().to_string(), "FOLDER");
        insta::assert_snapshot!(format!("template_{name}"), shown);
    }
}

#[test]
fn a_folder_of_templates_that_is_not_there_is_a_fault() {
    let faults = Renderer::new(Some(std::path::Path::new("no/such/folder"))).err().unwrap();
    assert_eq!(faults.list[0].code, Code::Unreadable);
}

/// Every sign that a name, a title or a unit may hold: the letters of Europe, and those of the subject.
fn many_signs() -> String {
    let ranges = ['\u{a0}'..='\u{17f}', '\u{370}'..='\u{3c9}', '\u{2010}'..='\u{2044}', '\u{2190}'..='\u{21d5}'];
    let singles = "−·×°²³⁻¹⁰⁷→≈≤≥≠∞√∂∑∫⊥∥∠€™é e\u{301} o\u{30c} 中文 ☃";
    let signs: Vec<String> = ranges.into_iter().flatten().map(String::from).collect();
    format!("{} {singles} [x] -- << >> ?` !`", signs.join(" "))
}

#[test]
fn pdflatex_sets_every_document_without_an_overfull_line() {
    if !pdflatex::is_installed() {
        return;
    }
    let mut signs = samples::sheet();
    signs.statement = format!(
        "{}\n\n1. one\n2. two\n   - [inner] *list*\n\n| a | b |\n|---|--:|\n| [x] | $v_{{θ}} = 3\\,\\text{{m·s⁻¹}}$ |\n\n\
         ```\nlet a_b = \\x{{}};\n```\n\n> quoted `code_1` <https://example.org/a_b>\n\n$$p = m v$$\n",
        many_signs().replace(['<', '`', '['], "")
    );
    signs.student = Some(many_signs());
    let pages = [Page::Sheet(samples::sheet()), Page::Solution(samples::solution()), Page::Key(samples::key())];
    let faded = Solution { faded: Some(1), ..samples::solution() };
    for (name, pages) in
        [("samples", pages.to_vec()), ("faded", vec![Page::Solution(faded)]), ("signs", vec![Page::Sheet(signs)])]
    {
        let text = renderer().render(&pages, Format::Latex).unwrap().text;
        assert_eq!(pdflatex::compile(&text), Ok(Vec::new()), "{name}");
    }
    // Hostile text is one long word, which may run over the margin, but it compiles.
    let text = renderer().render_sheets(&[hostile_sheet()], Format::Latex).unwrap().text;
    assert!(pdflatex::compile(&text).is_ok());
}

/// Mathematics in an option and in a label, with a dollar that is a sign.
const PRICED: &str = "
id: test/priced
title: Priced
level: core
scene:
  axes: { x: to the right }
  bodies: { A: { name: cart A } }
  surfaces: { wall: { name: the wall, normal: to the left } }
  stages: [ { impact: { body: A, against: wall, restitution: e } } ]
given: { m_A: 2 kg, v_A1: 3 m/s, e: 0.5 }
text: 'Cart A ({{ m_A }}) {{ v_A1 | motion }} and hits a wall; e = {{ e }}.'
ask:
  - { find: v_A2, unit: m/s, label: 'the velocity $u_2$' }
  - choose: What is lost of $T_1$?
    options:
      - { text: 'It is $\\frac{1}{2} m v^2$.', right: true, because: it is so }
      - { text: It costs $5 or 6 $., feedback: No. }
";

#[test]
fn lines_of_authors_hold_mathematics_in_every_format() {
    let problem = load(Source::new("priced.yaml", PRICED)).and_then(|loaded| compile(loaded, None));
    let exercise = Exercise::draw(&Arc::new(problem.unwrap()), 0, 1).unwrap();
    exercise.printable().unwrap();
    let solution = Solution {
        outline: exercise.outline(Audience::Everyone, Detail::Short),
        identity: exercise.identity(),
        audience: Audience::Everyone,
        faded: None,
    };
    let key = Key { title: String::new(), rows: exercise.key() };
    let expected = [
        (Format::Markdown, ["$\\frac{1}{2} m v^2$", "$u_2$", r"It costs \$5 or 6 \$."]),
        (
            Format::Html,
            ["<mfrac><mn>1</mn><mn>2</mn></mfrac>", "<msub><mi>u</mi><mn>2</mn></msub>", "It costs $5 or 6 $."],
        ),
        (Format::Latex, ["$\\frac{1}{2} m v^2$", "$u_2$", r"It costs \$5 or 6 \$."]),
        (Format::Typst, ["frac(1,2)", "attach(u,b:2)", r"It costs \$5 or 6 \$\."]),
    ];
    for (format, [option, label, price]) in expected {
        let sheet = renderer().render_sheets(&[exercise.sheet()], format).unwrap().text;
        let solved = renderer().render_solution(&solution, format).unwrap().text;
        let key = renderer().render_key(&key, format).unwrap().text;
        for (text, parts) in
            [(&sheet, vec![option, label, price]), (&solved, vec![option, label]), (&key, vec![option])]
        {
            for part in parts {
                assert!(text.contains(part), "{format}: no {part} in {text}");
            }
        }
    }
    let line = "a < $\\frac{1}{2}$";
    let written = [(Markup::Markdown, r"a \< $\frac{1}{2}$"), (Markup::Tex, r"a &lt; \(\frac{1}{2}\)")];
    for (markup, expected) in written {
        assert_eq!(markup.line(line), expected);
    }
    assert!(Markup::MathMl.line(line).contains("<mfrac>") && Markup::Pictures.line(line).contains("equation_images"));
}

#[test]
fn mathematics_that_cannot_be_set_is_told_at_its_question() {
    let problem = load(Source::new("priced.yaml", &PRICED.replace("frac{1}", "frack{1}")))
        .and_then(|loaded| compile(loaded, None));
    let faults = Exercise::draw(&Arc::new(problem.unwrap()), 0, 1).unwrap().printable().unwrap_err().to_string();
    assert!(faults.contains("this mathematics cannot be set") && faults.contains("priced.yaml:14"), "{faults}");
}
