//! Small documents with every kind of content.

use std::sync::Arc;

use momentous::explain::Audience;
use momentous::explain::Block;
use momentous::explain::Inline;
use momentous::explain::Outline;
use momentous::explain::Section;
use momentous::expr::Math;
use momentous::expr::Operator;
use momentous::figure::Drawing;
use momentous::figure::Point;
use momentous::figure::Role;
use momentous::figure::Shape;
use momentous::render::Identity;
use momentous::render::Key;
use momentous::render::KeyRow;
use momentous::render::Sheet;
use momentous::render::SheetPart;
use momentous::render::Solution;

pub fn text(text: &str) -> Inline {
    Inline::Text(text.into())
}

fn quantity(number: &str, unit: &str) -> Math {
    Math::Row(vec![Math::Number(number.into()), Math::Operator(Operator::Juxtapose), Math::Text(unit.into())])
}

fn row(parts: &[&Math]) -> Math {
    Math::Row(parts.iter().map(|part| (*part).clone()).collect())
}

fn bracketed(parts: &[&Math]) -> Math {
    Math::Bracketed(Arc::new(row(parts)))
}

fn fraction(over: Math, under: Math) -> Math {
    Math::Fraction(Arc::new(over), Arc::new(under))
}

/// `(v_A)_{1n}`
fn normal(body: &str, instant: &str) -> Math {
    let velocity = Math::Bracketed(Arc::new(Math::subscripted("v", body)));
    Math::Sub(Arc::new(velocity), Arc::new(Math::Text(format!("{instant}n"))))
}

const EQUALS: Math = Math::Operator(Operator::Equals);
const PLUS: Math = Math::Operator(Operator::Plus);
const MINUS: Math = Math::Operator(Operator::Minus);
const TIMES: Math = Math::Operator(Operator::Juxtapose);

fn conservation() -> Block {
    let (m_a, m_b) = (Math::subscripted("m", "A"), Math::subscripted("m", "B"));
    let left = row(&[&m_a, &TIMES, &normal("A", "1")]);
    let line = row(&[&left, &EQUALS, &m_a, &TIMES, &normal("A", "2"), &PLUS, &m_b, &TIMES, &normal("B", "2")]);
    Block::Equation { lines: vec![line], number: Some(1) }
}

fn restitution() -> Block {
    let e = Math::Identifier("e".into());
    let line = row(&[&e, &TIMES, &normal("A", "1"), &EQUALS, &normal("B", "2"), &MINUS, &normal("A", "2")]);
    Block::Equation { lines: vec![line], number: Some(2) }
}

fn result() -> Block {
    let (m_a, m_b) = (Math::subscripted("m", "A"), Math::subscripted("m", "B"));
    let (one, e) = (Math::Number("1".into()), Math::Identifier("e".into()));
    let symbols = fraction(row(&[&m_a, &TIMES, &bracketed(&[&one, &PLUS, &e])]), row(&[&m_a, &PLUS, &m_b]));
    let (two, rest) = (Math::Number("2".into()), Math::Number("1.8".into()));
    let numbers = fraction(row(&[&bracketed(&[&two]), &bracketed(&[&rest])]), Math::Number("3".into()));
    let line = row(&[
        &normal("B", "2"),
        &EQUALS,
        &symbols,
        &TIMES,
        &normal("A", "1"),
        &EQUALS,
        &numbers,
        &TIMES,
        &bracketed(&[&quantity("3.464", "m/s")]),
        &EQUALS,
        &quantity("4.157", "m/s"),
    ]);
    Block::Equation { lines: vec![line], number: None }
}

fn energy_check() -> Block {
    let energies = |instant: &str| Math::subscripted("T", instant);
    let lost = row(&[&energies("1"), &MINUS, &energies("2")]);
    let square =
        |number: &str| Math::Sup(Arc::new(bracketed(&[&quantity(number, "m/s")])), Arc::new(Math::Number("2".into())));
    let half = fraction(Math::Number("1".into()), Math::Number("2".into()));
    let term = |mass: &str, speed: &str| row(&[&half, &bracketed(&[&quantity(mass, "kg")]), &square(speed)]);
    let line = row(&[
        &lost,
        &EQUALS,
        &term("2", "4.000"),
        &MINUS,
        &term("2", "1.386"),
        &MINUS,
        &term("2", "-2.000"),
        &MINUS,
        &term("1", "4.157"),
        &EQUALS,
        &quantity("16.00", "J"),
        &MINUS,
        &quantity("14.56", "J"),
        &EQUALS,
        &quantity("1.44", "J"),
    ]);
    Block::Equation { lines: vec![line], number: None }
}

pub fn drawing() -> Drawing {
    let point = |x, y| Point { x, y };
    let label = |x, y, text: Math, role| Shape::Label { at: point(x, y), text, role };
    Drawing {
        title: "Momentum and impulse of puck A".into(),
        description: "The momentum of A before the impact plus the impulse of the contact is its momentum after."
            .into(),
        caption: "Puck A: momentum before + impulse = momentum after".into(),
        low: point(0.0, 0.0),
        high: point(300.0, 90.0),
        shapes: vec![
            Shape::Circle { centre: point(40.0, 45.0), radius: 14.0, role: Role::Body },
            Shape::Arrow { from: point(54.0, 45.0), to: point(110.0, 45.0), role: Role::Momentum },
            label(82.0, 56.0, Math::subscripted("p", "A1"), Role::Momentum),
            label(130.0, 45.0, PLUS, Role::Body),
            Shape::Circle { centre: point(190.0, 45.0), radius: 14.0, role: Role::Body },
            Shape::Arrow { from: point(226.0, 66.0), to: point(202.0, 52.0), role: Role::Impulse },
            label(236.0, 74.0, Math::Identifier("J".into()), Role::Impulse),
        ],
    }
}

pub fn identity() -> Identity {
    Identity {
        problem: "impact/two-pucks".into(),
        form: Some("forward".into()),
        seed: Some(17),
        secret: None,
        digest: Some("5f1c09ab".into()),
        scheme: Some(1),
    }
}

pub fn sheet() -> Sheet {
    Sheet {
        room: 0,
        title: "Two smooth pucks".into(),
        place: None,
        identity: identity(),
        student: None,
        statement: "Puck A (2 kg) slides on a level table at $v_{A1} = 4\\,\\text{m/s}$ along *+x* and strikes puck B \
                    (1 kg), which is at rest. The line of impact is 30° above +x, and the coefficient of restitution \
                    is 0.8. Both pucks are smooth."
            .into(),
        parts: vec![
            SheetPart {
                pictures: Vec::new(),
                options: Vec::new(),
                label: "a".into(),
                text: vec![text("Find the speed of puck B just after the impact")],
                unit: Some(Math::Text("m/s".into())),
                points: Some(2.0),
            },
            SheetPart {
                pictures: Vec::new(),
                options: Vec::new(),
                label: "b".into(),
                text: vec![
                    text("Find the direction of "),
                    Inline::Math(Math::subscripted("v", "B2")),
                    text(", counter-clockwise from +x"),
                ],
                unit: Some(Math::Text("degrees".into())),
                points: Some(1.0),
            },
        ],
        note: vec![
            text("Take "),
            Inline::Math(Math::relation(Math::Identifier("g".into()), Operator::Equals, quantity("9.81", "m/s^2"))),
            text("."),
        ],
        figure: Some(Box::new(drawing())),
        hints: vec!["Which impulse acts on B, and **along which line**?".into()],
    }
}

pub fn outline() -> Outline {
    let section = |heading: &str, audience, blocks| Section { heading: heading.into(), audience, blocks };
    let say = |words: &str| Block::Paragraph(vec![text(words)]);
    Outline {
        title: "Two smooth pucks".into(),
        sections: vec![
            section(
                "System",
                Audience::Everyone,
                vec![say("Pucks A and B together, from just before (1) to just after (2) the impact.")],
            ),
            section(
                "Momentum and impulse diagrams",
                Audience::Everyone,
                vec![
                    Block::Figure(Box::new(drawing())),
                    Block::Paragraph(vec![
                        text("The only impulse in the plane is that of the contact, "),
                        Inline::Math(Math::Identifier("J".into())),
                        text(", "),
                        Inline::Emphasis("equal and opposite".into()),
                        text(" on A and B. Left out:"),
                    ]),
                    Block::List(vec![
                        vec![Inline::Strong("weight".into()), text(", because it is not impulsive;")],
                        vec![text("friction between the pucks, because they are smooth.")],
                    ]),
                ],
            ),
            section(
                "Laws",
                Audience::Everyone,
                vec![
                    say("Along n the impulses on A and B cancel, so the momentum of the system is conserved:"),
                    conservation(),
                    say("Restitution, along n only:"),
                    restitution(),
                    say("Multiply (2) by the mass of A and add it to (1):"),
                    result(),
                ],
            ),
            section(
                "Answer and check",
                Audience::Everyone,
                vec![
                    Block::Authored("The speed is $v_{B2} = 4.16$ m/s, along the line of impact.".into()),
                    energy_check(),
                ],
            ),
            section(
                "Certificate",
                Audience::Instructor,
                vec![Block::Table {
                    head: vec![vec![text("Wrong form")], vec![text("What it gives")]],
                    rows: vec![vec![vec![text("Restitution inverted")], vec![Inline::Math(quantity("5.20", "m/s"))]]],
                }],
            ),
        ],
    }
}

pub fn solution() -> Solution {
    Solution { outline: outline(), identity: identity(), audience: Audience::Instructor, faded: None }
}

pub fn key() -> Key {
    let row = |seed, part: &str, number: &str, unit: &str| KeyRow {
        identity: Identity { seed: Some(seed), ..identity() },
        student: None,
        part: part.into(),
        answer: vec![Inline::Math(quantity(number, unit))],
    };
    Key {
        title: "Answer key".into(),
        rows: vec![row(17, "a", "4.16", "m/s"), row(17, "b", "30.0", "°"), row(18, "a", "-0.40", "m/s")],
    }
}
