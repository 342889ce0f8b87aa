//! Questions answered by a formula, from the file to the mark; and the formula of every answer of the bank.

use std::collections::BTreeMap;
use std::sync::Arc;

use momentous::bank::Bank;
use momentous::exercise::Exercise;
use momentous::fault::Source;
use momentous::grade::{self, DecimalMark, UnreadableKind};
use momentous::problem::{FormulaPart, Part, PartKind, Problem, compile, load};

mod judged;
mod kinds;
mod rewritten;

fn problem(text: &str) -> Arc<Problem> {
    let loaded = load(Source::new("formulas.yaml", text)).unwrap();
    Arc::new(compile(loaded, None).unwrap_or_else(|faults| panic!("{faults}")))
}

fn exercise(text: &str) -> Exercise {
    Exercise::draw(&problem(text), 0, 1).unwrap_or_else(|reason| panic!("{reason}"))
}

fn faults(text: &str) -> String {
    compile(load(Source::new("formulas.yaml", text)).unwrap(), None).unwrap_err().to_string()
}

/// The verdict on an answer to the part of that name, and the mistakes to which it is traced.
fn marked(exercise: &Exercise, part: &str, answer: &str) -> (String, Vec<&'static str>) {
    let answers = BTreeMap::from([(part.to_owned(), answer.to_owned())]);
    let report = exercise.grade(&answers, DecimalMark::Point);
    let own = report.parts.into_iter().find(|own| own.id == part).unwrap();
    (own.verdict.to_string(), own.diagnosis.map(|found| found.codes).unwrap_or_default())
}

fn printed(exercise: &Exercise) -> Vec<String> {
    exercise.worked().form.parts.iter().map(|part| exercise.printed(part)).collect()
}

/// `m_A v_A1 = (m_A + m_B) v_C2`, and `T_lost = m_A v_A1^2/2 - (m_A + m_B) v_C2^2/2`.
const COUPLING: &str = "
id: test/coupling
title: Coupling
level: intro
scene:
  axes: { x: east }
  bodies: { A: { name: wagon A }, B: { name: wagon B } }
  stages: [ { impact: { between: [A, B], plastic: true, becomes: C } } ]
given:
  m_A: { min: 20, max: 60, step: 2, unit: t }
  m_B: { min: 20, max: 60, step: 2, unit: t }
  v_A1: { min: 1, max: 2, step: 0.1, unit: m/s }
  v_B1: 0 m/s
text: >
  Wagon A ({{ m_A | HOW }}) has the velocity {{ v_A1 | HOW }} and couples with wagon B ({{ m_B | HOW }}), which {{ v_B1 | motion }}.
ask:
  - { find: v_C2, as: formula, points: 2 }
  - { find: T_lost, as: formula, unit: T_1 }
";

#[test]
fn a_formula_is_judged_as_a_function() {
    let coupling = exercise(&COUPLING.replace("HOW", "symbol"));
    assert_eq!(printed(&coupling), ["m_A*v_A1/(m_A + m_B)", "m_B*T_1/(m_A + m_B)"]);
    let verdicts = [
        ("v_C2", "m_A v_A1/(m_A + m_B)", "right"),
        ("v_C2", "v_C2 = v_{A1}/(1 + m_B/m_A)", "right"),
        ("v_C2", "-m_A v_A1/(m_A + m_B)", "sense_reversed"),
        ("v_C2", "2 m_A v_A1/(m_A + m_B)", "formula_factor"),
        ("v_C2", "m_A/(m_A + m_B)", "formula_dimension"),
        ("v_C2", "m_A + v_A1", "formula_dimension"),
        ("v_C2", "m_B v_A1/(m_A + m_B)", "wrong"),
        ("v_C2", "m_A u/(m_A + m_B)", "unreadable"),
        ("v_C2", "v_C2", "unreadable"),
        ("T_lost", "m_B T_1/(m_A + m_B)", "right"),
        ("T_lost", "m_B/(m_A + m_B)", "right_with_note"),
        ("T_lost", "m_A m_B v_A1^2/(2 (m_A + m_B))", "right"),
        ("T_lost", "m_A m_B v_A1^2/(m_A + m_B)", "formula_factor"),
        ("T_lost", "m_A/(m_A + m_B)", "wrong"),
    ];
    for (part, answer, verdict) in verdicts {
        assert_eq!(marked(&coupling, part, answer).0, verdict, "{part} = {answer}");
    }
}

#[test]
fn a_wrong_formula_is_traced_to_the_wrong_form_that_gives_it() {
    let coupling = exercise(&COUPLING.replace("HOW", "symbol"));
    let traced = |answer: &str| marked(&coupling, "v_C2", answer).1;
    // Energy in place of momentum: m_A v_A1^2 = (m_A + m_B) v_C2^2.
    assert!(traced("sqrt(m_A/(m_A + m_B)) v_A1").contains(&"energy-for-momentum"));
    assert_eq!(traced("m_B v_A1/(m_A + m_B)"), ["masses-exchanged"]);
    assert_eq!(traced("m_A v_A1/(m_A + 3 m_B)"), Vec::<&str>::new());
}

/// With half the right velocity `m_A v_A1/(2 (m_A + m_B))` a quarter of the energy is left that should be, so that
/// `T_lost = T_1 (1 - m_A/(4 (m_A + m_B)))`; the right one is `T_1 m_B/(m_A + m_B)`.
#[test]
fn a_formula_follows_from_an_earlier_wrong_one() {
    let coupling = exercise(&COUPLING.replace("HOW", "symbol"));
    let half = "m_A v_A1/(2 (m_A + m_B))";
    let cases = [
        (half, "T_1 (1 - m_A/(4 (m_A + m_B)))", "follow_through"),
        (half, "1 - m_A/(4 (m_A + m_B))", "follow_through"),
        (half, "m_A v_A1^2/2 - (m_A + m_B) (m_A v_A1/(2 (m_A + m_B)))^2/2", "follow_through"),
        (half, "1 - m_A/(2 (m_A + m_B))", "wrong"),
        (half, "m_B/(m_A + m_B)", "right_with_note"),
        // More energy than there was: the step is right, and something is wrong with what went into it.
        ("2 v_A1", "T_1 (1 - 4 (m_A + m_B)/m_A)", "follow_through_unphysical"),
        // Equal to a given, nothing, or of another dimension: the rest would be trivial.
        ("v_A1", "-m_B v_A1^2/2", "wrong"),
        ("0", "1", "wrong"),
        ("m_A", "T_1 - (m_A + m_B) v_A1^2/8", "wrong"),
    ];
    for (velocity, loss, verdict) in cases {
        let report = both(&coupling, velocity, loss);
        let own = &report.parts[1];
        assert_eq!(own.verdict.code(), verdict, "{velocity}, then {loss}: {}", own.message);
        assert_eq!(own.follows.is_some(), verdict.starts_with("follow"), "{}", own.message);
    }
    let follows = both(&coupling, half, cases[0].1).parts.swap_remove(1);
    assert!(follows.message.starts_with("This follows from your own v_C2 by "), "{}", follows.message);
    assert_eq!(follows.points.0, grade::Points::default().0 + momentous::quantity::Rational::from(1));
}

/// The number for the energy lost is what the formula for the velocity makes of it.
#[test]
fn a_number_follows_from_an_earlier_wrong_formula() {
    let named = COUPLING.replace("HOW", "named").replace("T_lost, as: formula, unit: T_1", "T_lost, unit: kJ");
    let coupling = exercise(&named);
    let worked = coupling.worked();
    let value = |name: &str| worked.variant.value(worked.problem.model().symbols.find(name).unwrap()).unwrap().value;
    let (m_a, m_b, v) = (value("m_A"), value("m_B"), value("v_A1"));
    let lost = m_a * v * v / 2.0 * (1.0 - m_a / (4.0 * (m_a + m_b))) / 1000.0;
    let report = both(&coupling, "m_A v_A1/(2 (m_A + m_B))", &format!("{lost:.2} kJ"));
    assert_eq!(report.parts[1].verdict.code(), "follow_through", "{}", report.parts[1].message);
}

fn both(coupling: &Exercise, velocity: &str, loss: &str) -> grade::Report {
    let answers = [("v_C2", velocity), ("T_lost", loss)].map(|(part, text)| (part.to_owned(), text.to_owned()));
    coupling.grade(&BTreeMap::from(answers), DecimalMark::Point)
}

#[test]
fn the_record_holds_the_formula_as_text_and_as_latex() {
    let record = exercise(&COUPLING.replace("HOW", "symbol")).record(None);
    let asked = &record["ask"][0];
    assert_eq!(asked["kind"], "formula");
    assert_eq!(asked["value"], "m_A*v_A1/(m_A + m_B)");
    assert_eq!(asked["latex"], r"\frac{m_{A}\,v_{A1}}{m_{A} + m_{B}}");
    assert_eq!(asked["symbols"], serde_json::json!(["m_A", "m_B", "v_A1"]));
    // A value that the sheet does not tell is no part of the question.
    assert_eq!(record["given"]["m_A"], serde_json::json!({ "value": null, "unit": "t" }));
}

/// Behind wagon B no wagon A can catch it: only where it can, formulas are compared.
#[test]
fn formulas_are_compared_where_the_problem_has_variants() {
    let caught = COUPLING
        .replace("HOW", "symbol")
        .replace("v_B1: 0 m/s", "v_B1: { min: 0.5, max: 1.9, step: 0.1, unit: m/s }")
        .replace("ask:", "require: [ v_A1 > v_B1 ]\nask:\n  - { find: J_B, as: formula }")
        .replace("  - { find: T_lost, as: formula, unit: T_1 }\n", "");
    let coupling = exercise(&caught);
    let verdicts = [
        ("m_A m_B (v_A1 - v_B1)/(m_A + m_B)", "right"),
        ("m_A m_B |v_A1 - v_B1|/(m_A + m_B)", "right_agrees"),
        ("m_A m_B \\sqrt{(v_{A1} - v_{B1})^2}/(m_A + m_B)", "right_agrees"),
        ("m_A m_B (v_B1 - v_A1)/(m_A + m_B)", "sense_reversed"),
        ("m_A m_B |v_A1 + v_B1|/(m_A + m_B)", "wrong"),
        ("m_A m_B sqrt(v_B1 - v_A1)^2/(m_A + m_B)", "sense_reversed"),
        ("m_A m_B sqrt((v_B1 - v_A1) v_A1)/(m_A + m_B)", "unreadable"),
    ];
    for (answer, verdict) in verdicts {
        assert_eq!(marked(&coupling, "J_B", answer).0, verdict, "{answer}");
    }
}

#[test]
fn numbers_may_stand_beside_the_symbols() {
    let coupling = exercise(&COUPLING.replace("HOW", "named"));
    let sheet = coupling.sheet().statement;
    let (value, _) = coupling.variant().given(coupling.problem().model().symbols.find("m_A").unwrap()).unwrap();
    assert!(sheet.contains(&format!("($m_{{A}}$ = {value}\u{a0}t)")), "{sheet}");
    assert_eq!(marked(&coupling, "v_C2", "v_A1 m_A/(m_A + m_B)").0, "right");
    assert_eq!(coupling.record(None)["given"]["m_A"]["value"], value.to_string());
}

/// `v_B2 = (1 + e) m_A u/(m_A + k m_A)`: with e = 0.5 and k = 3 that is 3 u/8.
const SCALE_FREE: &str = "
id: test/ratio
title: Ratios
level: intro
scene:
  axes: { x: east }
  bodies: { A: { name: ball A }, B: { name: ball B } }
  stages: [ { impact: { between: [A, B], restitution: e } } ]
given: { m: any kg, m_A: m, m_B: k*m, u: any m/s, v_A1: u, v_B1: 0 m/s, k: 3, e: 0.5 }
text: Ball A has the velocity u; ball B, {{ k }} times as heavy, is at rest. The coefficient of restitution is {{ e }}.
ask: [ { find: v_B2, as: formula }, { find: J_B, as: formula } ]
";

#[test]
fn of_ratios_the_answer_is_a_multiple_of_what_is_left_open() {
    let ratio = exercise(SCALE_FREE);
    assert_eq!(printed(&ratio), ["3*u/8", "9*m*u/8"]);
    let verdicts = [
        ("v_B2", "3u/8", "right"),
        ("v_B2", "0.375 u", "right"),
        ("v_B2", "3 v_A1/8", "right"),
        ("v_B2", "(1 + e) u/(1 + k)", "right"),
        ("v_B2", "u/8", "formula_factor"),
        ("J_B", "9 m u/8", "right"),
        ("J_B", "3 m_B u/8", "right"),
    ];
    for (part, answer, verdict) in verdicts {
        assert_eq!(marked(&ratio, part, answer).0, verdict, "{part} = {answer}");
    }
}

#[test]
fn what_cannot_be_answered_by_a_formula_is_a_fault() {
    let coupling = COUPLING.replace("HOW", "symbol");
    let cases = [
        ("unit: T_1", "unit: J", "a formula has no unit"),
        ("unit: T_1", "figures: 2", "a formula has no figures"),
        ("points: 2 }\n", "points: 2 }\n  - { find: T_2, unit: J }\n", "it cannot be proven that `T_2`"),
    ];
    for (from, to, message) in cases {
        let found = faults(&coupling.replace(from, to));
        assert!(found.contains(message), "{found}");
    }
}

/// The formula of each number of the bank, where there is one, gives that number, and is marked right when it is typed.
#[test]
fn the_formula_of_an_answer_gives_its_value() {
    let bank = Bank::built_in();
    let (mut formulas, mut numbers) = (0, 0);
    for source in bank.sources() {
        let problem = Arc::new(compile(load(source.clone()).unwrap(), None).unwrap());
        for form in 0..problem.forms().len() {
            let Ok(exercise) = Exercise::draw(&problem, form, 3) else { continue };
            let worked = exercise.worked();
            for part in &worked.form.parts {
                let PartKind::Number(number) = &part.kind else { continue };
                numbers += 1;
                let asked = FormulaPart { symbol: number.symbol, in_terms_of: None };
                let Some(formula) = worked.formula(&asked) else { continue };
                formulas += 1;
                let value = |symbol| worked.variant.value(symbol).map_or(f64::NAN, |value| value.value);
                let (found, right) = (formula.evaluate(&value), value(number.symbol));
                let name = &problem.model().symbols.entry(number.symbol).name;
                let close = (found - right).abs() <= 1e-9 * right.abs().max(1e-9);
                let text = formula.text(&problem.model().symbols);
                assert!(close, "{} {name}: {found} {right} {text}", problem.id());
                let expected = exercise.expected(&Part { kind: PartKind::Formula(asked), ..part.clone() });
                let marked = grade::read(&text, &expected.kind, DecimalMark::Point);
                let verdict = marked.map(|answer| grade::judge(&expected, &answer).verdict);
                // What is beyond all doubles agrees with nothing.
                for beyond in ["1e309", "-1e400", "exp(800)"] {
                    for answer in
                        [beyond.to_owned(), format!("{beyond}*({text})"), format!("{text} + {beyond}*({text})")]
                    {
                        let marked = grade::read(&answer, &expected.kind, DecimalMark::Point);
                        let right = marked.is_ok_and(|answer| grade::judge(&expected, &answer).verdict.is_right());
                        assert!(!right || value(number.symbol) == 0.0, "{} {name} = {answer}", problem.id());
                    }
                }
                let long = matches!(&verdict, Err(fault) if fault.kind == UnreadableKind::TooManyParts);
                let right = verdict.as_ref().is_ok_and(|verdict| verdict.is_right());
                assert!(right || long, "{} {name} = {text}: {verdict:?}", problem.id());
            }
        }
    }
    assert!(10 * formulas > 8 * numbers, "{formulas} of {numbers}");
}
