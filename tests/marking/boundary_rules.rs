//! Rules at the boundary that well-known systems get wrong. One test each, with the reason.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::{Duration, Instant};

use momentous::expr::{Expr, Symbol, SymbolEntry, SymbolTable};
use momentous::grade::{
    DecimalMark, Expected, ExpectedFormula, ExpectedKind, ExpectedNumber, ExpectedVector, Frame, FrameAxis, Rubric,
    Verdict, Writing, grade, judge, read,
};
use momentous::quantity::{Decimal, Dimension, Tolerance, Unit};

fn number(value: &str, unit: &str) -> ExpectedNumber {
    let value = Decimal::parse(value).unwrap();
    ExpectedNumber {
        exact: Some(value.to_rational()),
        ..ExpectedNumber::new(value.to_f64(), Unit::parse(unit).unwrap())
    }
}

fn part(kind: ExpectedKind) -> Expected {
    Expected { id: "v_A2".to_owned(), points: 4, kind }
}

fn verdict_on(kind: ExpectedKind, text: &str) -> Verdict {
    let part = part(kind);
    let answer = read(text, &part.kind, DecimalMark::Point).unwrap_or_else(|fault| panic!("{text}: {fault}"));
    judge(&part, &answer).verdict
}

fn verdict(number: &ExpectedNumber, text: &str) -> Verdict {
    verdict_on(ExpectedKind::Number(number.clone()), text)
}

/// In doubles 1.005 - 1.00 is more than 0.005, so a system that computes in them calls the boundary wrong.
#[test]
fn half_a_per_cent_off_is_right_at_half_a_per_cent() {
    let right = ExpectedNumber { tolerance: Tolerance::Relative(Decimal::from_scaled(5, 3)), ..number("1.00", "m") };
    assert_eq!(verdict(&right, "1.005 m"), Verdict::Right);
    assert_eq!(verdict(&right, "0.995 m"), Verdict::Right);
    assert_ne!(verdict(&right, "1.00500001 m"), Verdict::Right);
    let inexact = ExpectedNumber { exact: None, error: 1e-16, ..right };
    assert_eq!(verdict(&inexact, "1.005 m"), Verdict::Right);
}

/// Rounding both sides and comparing makes 1.2349 equal to 1.23 and 1.2351 not; half a unit of the exact value's last figure
/// treats both sides alike.
#[test]
fn strict_figures_are_half_a_unit_of_the_exact_value() {
    let right = ExpectedNumber { tolerance: Tolerance::ToFigures, ..number("1.234", "m") };
    for accepted in ["1.23 m", "1.229 m", "1.239 m"] {
        assert!(verdict(&right, accepted).is_right(), "{accepted}");
    }
    for refused in ["1.2289 m", "1.2391 m", "1.24 m"] {
        assert!(!verdict(&right, refused).is_right(), "{refused}");
    }
}

/// Nobody can tell whether the zeros of 100 were meant; the student has the benefit of the doubt.
#[test]
fn a_hundred_has_one_to_three_figures() {
    for figures in 1..=3 {
        let right = ExpectedNumber { figures, writing: Writing::Require, ..number("100", "m") };
        assert_eq!(verdict(&right, "100 m"), Verdict::Right, "{figures}");
    }
    let four = ExpectedNumber { figures: 4, writing: Writing::Require, ..number("100", "m") };
    assert_eq!(verdict(&four, "100 m"), Verdict::FiguresFew);
}

/// One figure more than asked says nothing false yet; two do.
#[test]
fn one_figure_more_than_is_required_passes() {
    let right = ExpectedNumber { writing: Writing::Require, ..number("2.5013", "m") };
    for (answer, wanted) in [
        ("2.5 m", Verdict::FiguresFew),
        ("2.50 m", Verdict::Right),
        ("2.501 m", Verdict::Right),
        ("2.5013 m", Verdict::FiguresMany),
    ] {
        assert_eq!(verdict(&right, answer), wanted, "{answer}");
    }
}

/// One per cent of zero is zero, and 1e-12 is arbitrary: the speeds of the problem say what is nothing.
#[test]
fn zero_is_judged_by_the_speed_of_approach() {
    let zero = ExpectedNumber { scale: 4.0, ..number("0", "m/s") };
    assert_eq!(verdict(&zero, "0.03 m/s"), Verdict::Right);
    assert_eq!(verdict(&zero, "0.04 m/s"), Verdict::Right);
    assert!(!verdict(&zero, "0.05 m/s").is_right());
}

/// One quantity has two units; comparing units as texts marks half of the right answers wrong.
#[test]
fn a_newton_second_is_a_kilogram_metre_per_second() {
    assert_eq!(verdict(&number("12", "N s"), "12 kg m/s"), Verdict::Right);
    assert_eq!(verdict(&number("12", "kg m/s"), "12 N s"), Verdict::Right);
}

/// "Wrong" alone does not help who has only slipped in the unit.
#[test]
fn a_right_number_with_a_wrong_dimension_is_told_so() {
    assert_eq!(verdict(&number("-9.81", "m/s^2"), "-9.81 m/s"), Verdict::UnitWrongDimension);
}

/// A conversion must be exact, and must not depend on which way it goes.
#[test]
fn grams_are_thousandths_of_kilograms() {
    assert_eq!(verdict(&number("0.025", "kg"), "25 g"), Verdict::Right);
    assert_eq!(verdict(&number("25", "g"), "0.025 kg"), Verdict::Right);
}

/// Zero times any unit is zero, so a system that multiplies before it compares takes every zero for right.
#[test]
fn a_zero_of_something_else_is_not_right() {
    assert!(!verdict(&number("0", "m/s"), "0.0 m").is_right());
    assert!(verdict(&number("0", "m/s"), "0.0 m/s").is_right());
}

/// A component near zero has no relative tolerance of its own: the vector as a whole has.
#[test]
fn a_vector_is_right_as_a_whole() {
    let axis = |letter, plus: &str, minus: &str| FrameAxis { letter, senses: [plus.to_owned(), minus.to_owned()] };
    let frame = Frame { axes: vec![axis('x', "east", "west"), axis('y', "north", "south")] };
    let components = vec![number("3", "m/s"), number("-4", "m/s")];
    let kind = || ExpectedKind::Vector(ExpectedVector { components: components.clone(), frame: frame.clone() });
    for (text, verdict) in [
        ("(3, -4) m/s", Verdict::Right),
        ("(3.05, -4) m/s", Verdict::Right),
        ("(3.03, -4.04) m/s", Verdict::Right),
        ("(3.06, -4) m/s", Verdict::Wrong),
        ("3i - 4j m/s", Verdict::Right),
        ("5 m/s at 53.13° south of east", Verdict::Right),
        ("(10.8, -14.4) km/h", Verdict::Right),
        ("(-4, 3) m/s", Verdict::ComponentsExchanged),
        ("(-3, 4) m/s", Verdict::SenseReversed),
        ("(3, 4) m/s", Verdict::ComponentSign),
        ("(4.58, 2) m/s", Verdict::DirectionWrong),
        ("(3, -4)", Verdict::UnitMissing),
        ("(3, -4) m", Verdict::UnitWrongDimension),
        ("(3, -4) km/h", Verdict::UnitWrong),
        ("(1, 1) m/s", Verdict::Wrong),
    ] {
        assert_eq!(verdict_on(kind(), text), verdict, "{text}");
    }
}

/// An angle of 40° that is called 140°, 50° or -40° is a question of where one counts from, and is said to be one.
#[test]
fn slips_with_an_angle_have_names() {
    let right = ExpectedNumber {
        tolerance: Tolerance::Absolute(Decimal::from_scaled(5, 1)),
        cyclic: true,
        ..number("40", "°")
    };
    for (text, verdict_found) in [
        ("400°", Verdict::Right),
        ("-320°", Verdict::Right),
        ("40.5°", Verdict::Right),
        ("140°", Verdict::AngleSupplement),
        ("50°", Verdict::AngleComplement),
        ("-40°", Verdict::AngleOtherSense),
        ("220°", Verdict::AngleReversed),
        ("130°", Verdict::AngleOtherAxis),
        ("-50°", Verdict::AngleOtherAxis),
        ("60°", Verdict::Wrong),
    ] {
        assert_eq!(verdict(&right, text), verdict_found, "{text}");
    }
}

/// Values that belong to named bodies are not a set: exchanged, they are wrong, and the student is told what happened.
#[test]
fn exchanged_bodies_are_told() {
    let answer =
        |id: &str, value| Expected { id: id.to_owned(), points: 1, kind: ExpectedKind::Number(number(value, "m/s")) };
    let answers =
        BTreeMap::from([("v_A2".to_owned(), "3.1 m/s".to_owned()), ("v_B2".to_owned(), "-0.4 m/s".to_owned())]);
    let report =
        grade(&[answer("v_A2", "-0.4"), answer("v_B2", "3.1")], &answers, DecimalMark::Point, &Rubric::default());
    assert!(report.parts.iter().all(|part| part.verdict == Verdict::BodiesSwapped), "{report}");
}

fn formula() -> (ExpectedKind, usize) {
    let mut symbols = SymbolTable::default();
    let mut add = |name: &str, dimension| {
        symbols.intern(SymbolEntry { name: name.to_owned(), dimension, meaning: String::new() })
    };
    let names =
        [("m_A", Dimension::MASS), ("m_B", Dimension::MASS), ("v_A1", Dimension::VELOCITY), ("e", Dimension::NONE)];
    let names = names.map(|(name, dimension)| add(name, dimension));
    let asked = add("v_B2", Dimension::VELOCITY);
    let [m_a, m_b, v, e] = names.map(Expr::from);
    let formula = (Expr::one() + e) * m_a.clone() * v / (m_a + m_b);
    let domain: Vec<(Symbol, f64, f64)> = names.map(|name| (name, 0.5, 4.0)).to_vec();
    let count = domain.len();
    let kind = ExpectedKind::Formula(ExpectedFormula::new(formula, Arc::new(symbols), asked, domain));
    (kind, count)
}

/// Comparing formulas as texts marks every other arrangement wrong; at one point of the range unequal ones can agree.
#[test]
fn formulas_are_equal_as_functions() {
    for (text, verdict) in [
        ("(1+e) m_A v_A1/(m_A+m_B)", Verdict::Right),
        ("(1+e) v_A1/(1+m_B/m_A)", Verdict::Right),
        ("v_A1 (m_A + e m_A)/(m_B + m_A)", Verdict::Right),
        ("sqrt(v_A1^2) (1+e) m_A/(m_A+m_B)", Verdict::Right),
        ("(sin(e)^2 + cos(e)^2 + e) m_A v_A1/(m_A+m_B)", Verdict::Right),
        ("(tan(e) cos(e)/sin(e) + e) m_A v_A1/(m_A+m_B)", Verdict::RightAgrees),
        ("-(1+e) m_A v_A1/(m_A+m_B)", Verdict::SenseReversed),
        ("2*(1+e) m_A v_A1/(m_A+m_B)", Verdict::FormulaFactor),
        ("(1-e) m_A v_A1/(m_A+m_B)", Verdict::Wrong),
        ("m_A v_A1", Verdict::FormulaDimension),
        ("(1+e) v_A1 + m_A", Verdict::FormulaDimension),
        ("0", Verdict::Wrong),
    ] {
        let found = verdict_on(formula().0, text);
        assert!(found == verdict || verdict == Verdict::RightAgrees && found == Verdict::Right, "{text}: {found}");
    }
}

/// A formula whose canonical form is huge must not hang marking.
#[test]
fn long_formulas_are_judged_at_once() {
    let right = "(1+e) m_A v_A1/(m_A+m_B)";
    let sums = ["(m_A+m_B)"; 12].join("*");
    let hard = [
        format!("{right}*({sums})/({sums})"),
        format!("{right}*(m_A+m_B+m_A*e)^12/(m_A+m_B+m_A*e)^12"),
        format!("{right}*sin(e)/sin(e)*cos(e)/cos(e)*exp(e)/exp(e)"),
        format!("{right} + 0*{}", ["v_A1"; 30].join(" + 0*")),
        ["v_A1"; 100].join("+"),
    ];
    for text in hard {
        let start = Instant::now();
        let (kind, _) = formula();
        let part = part(kind);
        let Ok(answer) = read(&text, &part.kind, DecimalMark::Point) else { panic!("{text}") };
        let _ = judge(&part, &answer);
        // A build without optimisation, on a busy machine; the bound of a release build is 5 ms.
        assert!(start.elapsed() < Duration::from_secs(1), "{text}: {:?}", start.elapsed());
    }
}
