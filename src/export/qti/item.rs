//! A variant as an item of QTI. A window is written as two comparisons, which every player knows; tolerances are not.

use momentous_fault::Faults;
use momentous_render::Markup;

use super::super::band::{Band, bands, printed};
use super::super::element::{Element, element, html_element};
use super::super::field::{Asked, Choice, Field};
use super::super::question::{Asking, Pictures, Question, TypedUnit, said};
use super::dialect::Dialect;

const MARKUP: Markup = Markup::MathMl;

/// The outcome that shows the worked solution, and what it is set to.
const SOLUTION: [&str; 2] = ["SOLUTION", "solution"];

/// The item with its pictures.
pub(super) fn item(question: &Question<'_>, dialect: Dialect) -> Result<(Element, Pictures), Faults> {
    let mut pictures = Pictures::named(&question.item.code);
    let mut item = element("assessment-item")
        .with("xmlns", dialect.namespace)
        .with("identifier", identifier(question))
        .with("title", question.title())
        .with("adaptive", "false")
        .with("time-dependent", "false")
        .with("xml:lang", "en");
    let statement = question.statement(MARKUP, &mut pictures)?;
    let writing = question.writing(MARKUP, TypedUnit::Never);
    let mut body = element("item-body").html(statement + &writing + &question.code(MARKUP, None));
    let mut outcomes = vec![
        outcome("SCORE", "float").holding(element("default-value").holding(value("0"))),
        outcome("MAXSCORE", "float").holding(element("default-value").holding(value(question.weight().to_string()))),
        outcome(SOLUTION[0], "identifier"),
    ];
    let mut processing = element("response-processing");
    let labelled = question.asked.len() > 1;
    for asking in &question.asked {
        let mut room = html_element("div");
        let mut line = html_element("p").html(asking.question(MARKUP, labelled));
        let mut below: Vec<Element> = Vec::new();
        for field in &asking.fields {
            let cases = cases(asking, field);
            item = item.holding(declaration(field));
            outcomes.push(outcome(&feedback_outcome(field), "identifier"));
            match &field.asked {
                Asked::Number(_) => {
                    line = line.text(format!(" {} ", field.caption)).holding(gap(field)).text(" ");
                    line = line.html(asking.unit(MARKUP));
                }
                Asked::Choice(options) => {
                    let option = |(option, place): (&Choice<'_>, usize)| {
                        element("simple-choice").with("identifier", choice(place)).html(option.shown(MARKUP))
                    };
                    let interaction = element("choice-interaction")
                        .with("response-identifier", response(field))
                        .with("shuffle", "false")
                        .with("max-choices", "1");
                    below.push(interaction.holding_all(options.iter().zip(1..).map(option)));
                }
            }
            let spoken = cases.iter().filter(|case| !case.feedback.is_empty());
            below.extend(
                spoken
                    .map(|case| feedback(&feedback_outcome(field), &case.name, said(MARKUP, &case.feedback), dialect)),
            );
            processing = processing.holding_all(condition(field, &cases));
        }
        room = room.holding(line).holding_all(below);
        body = body.holding(room);
    }
    let solution = question.solution(MARKUP, &mut pictures)?;
    body = body.holding(feedback(SOLUTION[0], SOLUTION[1], solution, dialect));
    processing = processing.holding(set(SOLUTION[0], base("identifier", SOLUTION[1])));
    Ok((item.holding_all(outcomes).holding(body).holding(processing), pictures))
}

/// How an item is called; a name begins with a letter.
pub(super) fn identifier(question: &Question<'_>) -> String {
    format!("item-{}", question.item.code)
}

/// Answers to a field that are marked alike.
struct Case {
    name: String,
    test: Element,
    score: f64,
    feedback: Vec<String>,
}

fn cases(asking: &Asking<'_>, field: &Field<'_>) -> Vec<Case> {
    let name = |place: usize| format!("{}-{place}", field.name);
    match &field.asked {
        Asked::Number(number) => {
            let mut alike: Vec<Vec<Band<'_>>> = Vec::new();
            for window in bands(number, asking.part.field.points) {
                let is_alike = |all: &&mut Vec<Band<'_>>| all.iter().all(|band| band.is_marked_as(&window));
                match alike.iter_mut().find(is_alike) {
                    Some(all) => all.push(window),
                    None => alike.push(vec![window]),
                }
            }
            let case = |(all, place): (Vec<Band<'_>>, usize)| {
                let first = all.first()?;
                let (score, feedback) = (first.share * f64::from(asking.weight), first.feedback.to_vec());
                let mut tests: Vec<Element> =
                    all.iter().map(|window| between(field, window.low, window.high)).collect();
                let test = if tests.len() == 1 { tests.pop()? } else { element("or").holding_all(tests) };
                Some(Case { name: name(place), test, score, feedback })
            };
            alike.into_iter().zip(1..).filter_map(case).collect()
        }
        Asked::Choice(options) => {
            let case = |(option, place): (&Choice<'_>, usize)| Case {
                name: name(place),
                test: element("match").holding(variable(&response(field))).holding(base("identifier", &choice(place))),
                score: if option.right { f64::from(asking.weight) } else { 0.0 },
                feedback: [option.feedback.clone()].into_iter().filter(|text| !text.is_empty()).collect(),
            };
            options.iter().zip(1..).map(case).collect()
        }
    }
}

/// The first case that fits counts.
fn condition(field: &Field<'_>, cases: &[Case]) -> Option<Element> {
    let branch = |(case, place): (&Case, usize)| {
        let mut branch =
            element(if place == 0 { "response-if" } else { "response-else-if" }).holding(case.test.clone());
        if case.score > 0.0 {
            let sum = element("sum").holding(variable("SCORE")).holding(base("float", &case.score.to_string()));
            branch = branch.holding(set("SCORE", sum));
        }
        if !case.feedback.is_empty() {
            branch = branch.holding(set(&feedback_outcome(field), base("identifier", &case.name)));
        }
        branch
    };
    let told = cases.iter().filter(|case| case.score > 0.0 || !case.feedback.is_empty());
    let branches: Vec<Element> = told.zip(0..).map(branch).collect();
    (!branches.is_empty()).then(|| element("response-condition").holding_all(branches))
}

/// Whether something is answered (an empty answer would count as zero) and lies within a window.
fn between(field: &Field<'_>, low: f64, high: f64) -> Element {
    let answer = || variable(&response(field));
    let is_given = element("not").holding(element("is-null").holding(answer()));
    let end = |name, end: f64| element(name).holding(answer()).holding(base("float", &end.to_string()));
    element("and").holding_all([is_given, end("gte", low), end("lte", high)])
}

fn declaration(field: &Field<'_>) -> Element {
    let (kind, right) = match &field.asked {
        Asked::Number(number) => ("float", Some(printed(number))),
        Asked::Choice(options) => {
            let right = options.iter().zip(1..).find(|(option, _)| option.right);
            ("identifier", right.map(|(_, place)| choice(place)))
        }
    };
    element("response-declaration")
        .with("identifier", response(field))
        .with("cardinality", "single")
        .with("base-type", kind)
        .holding_all(right.map(|right| element("correct-response").holding(value(right))))
}

fn outcome(name: &str, kind: &str) -> Element {
    element("outcome-declaration").with("identifier", name).with("cardinality", "single").with("base-type", kind)
}

fn gap(field: &Field<'_>) -> Element {
    element("text-entry-interaction").with("response-identifier", response(field)).with("expected-length", "10")
}

fn feedback(outcome: &str, name: &str, html: String, dialect: Dialect) -> Element {
    let block = element("feedback-block")
        .with("outcome-identifier", outcome)
        .with("identifier", name)
        .with("show-hide", "show");
    if dialect.has_content_body { block.holding(element("content-body").html(html)) } else { block.html(html) }
}

fn set(outcome: &str, expression: Element) -> Element {
    element("set-outcome-value").with("identifier", outcome).holding(expression)
}

fn variable(name: &str) -> Element {
    element("variable").with("identifier", name)
}

fn base(kind: &str, text: &str) -> Element {
    element("base-value").with("base-type", kind).text(text)
}

fn value(text: impl Into<String>) -> Element {
    element("value").text(text)
}

fn response(field: &Field<'_>) -> String {
    format!("RESPONSE-{}", field.name)
}

/// The outcome that says which feedback on a field is shown.
fn feedback_outcome(field: &Field<'_>) -> String {
    format!("FEEDBACK-{}", field.name)
}

fn choice(place: usize) -> String {
    format!("choice-{place}")
}
