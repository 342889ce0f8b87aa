//! Random impacts of two bodies, written as problem files and solved.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

use momentous::problem::{Problem, Sampler, Variant};
use momentous::solve::Bounded;
use proptest::prelude::*;

use crate::variants::{instead, problem, sheet, value};

thread_local! {
    /// Problems that were compiled before, by their text: many impacts differ in numbers only.
    static COMPILED: RefCell<BTreeMap<String, Rc<Problem>>> = RefCell::default();
}

/// Whether the bodies separate or stay together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Separate,
    Together,
}

/// An impact of A on B, in tenths of kilograms and of metres per second, hundredths for e.
#[derive(Clone, Debug)]
pub struct Impact {
    pub kind: Kind,
    /// Whether it happens in a plane, or along a line.
    pub plane: bool,
    pub masses: [i64; 2],
    pub tenths: [[i64; 2]; 2],
    /// The line of impact, from A to B: so many degrees from the x axis,
    pub turn: i64,
    /// from its positive or its negative part, and towards +y or -y.
    pub signs: [i64; 2],
    pub e: i64,
    /// Whether the file is written in grams and kilometres per hour.
    pub small_units: bool,
}

/// What the solver finds.
#[derive(Clone, Debug)]
pub struct After {
    pub velocities: [[f64; 2]; 2],
    pub impulses: [[f64; 2]; 2],
    pub lost: Bounded,
}

/// Impacts that happen: A moves towards B along the line of impact.
pub fn impacts() -> impl Strategy<Value = Impact> {
    let kind = prop_oneof![3 => Just(Kind::Separate), 1 => Just(Kind::Together)];
    let masses = [1_i64..500, 1_i64..500];
    let tenths = [[-200_i64..200, -200_i64..200], [-200_i64..200, -200_i64..200]];
    let signs = [prop_oneof![Just(1_i64), Just(-1)], prop_oneof![Just(1_i64), Just(-1)]];
    (kind, any::<bool>(), masses, tenths, 0_i64..=90, signs, 0_i64..=100)
        .prop_map(|(kind, plane, masses, tenths, turn, signs, e)| {
            let mut impact = Impact { kind, plane, masses, tenths, turn, signs, e, small_units: false };
            if !plane {
                impact.turn = 0;
                impact.tenths.iter_mut().for_each(|velocity| velocity[1] = 0);
            }
            if impact.approach() < 0.0 {
                impact.tenths.swap(0, 1);
            }
            impact
        })
        .prop_filter("the bodies must meet", |impact| impact.approach() > 0.05)
}

#[allow(clippy::cast_precision_loss, reason = "whole numbers that are small")]
fn tenth(value: i64) -> f64 {
    value as f64 / 10.0
}

impl Impact {
    pub fn axes(&self) -> usize {
        if self.plane { 2 } else { 1 }
    }

    pub fn mass(&self, body: usize) -> f64 {
        tenth(self.masses[body])
    }

    pub fn velocities(&self) -> [[f64; 2]; 2] {
        self.tenths.map(|velocity| velocity.map(tenth))
    }

    /// The direction of the line of impact.
    pub fn normal(&self) -> [f64; 2] {
        let turn = (tenth(self.turn) * 10.0).to_radians();
        let [x, y] = self.signs.map(|sign| tenth(10 * sign));
        [x * turn.cos(), y * turn.sin()]
    }

    /// How fast A nears B along the line.
    pub fn approach(&self) -> f64 {
        let ([cos, sin], [a, b]) = (self.normal(), self.velocities());
        cos * (a[0] - b[0]) + sin * (a[1] - b[1])
    }

    pub fn fastest(&self) -> f64 {
        self.velocities().iter().flatten().fold(0.1, |most: f64, velocity| most.max(velocity.abs()))
    }

    pub fn energy(&self, velocities: &[[f64; 2]; 2]) -> f64 {
        (0..2).map(|body| self.mass(body) * velocities[body].iter().map(|part| part * part).sum::<f64>() / 2.0).sum()
    }

    /// The same impact for an observer who moves with these tenths of metres per second.
    pub fn seen_from(&self, observer: [i64; 2]) -> Self {
        let mut seen = self.clone();
        for velocity in &mut seen.tenths {
            for axis in 0..self.axes() {
                velocity[axis] -= observer[axis];
            }
        }
        seen
    }

    /// The same impact with an axis turned round.
    pub fn mirrored(&self, axis: usize) -> Self {
        let mut mirrored = self.clone();
        mirrored.tenths.iter_mut().for_each(|velocity| velocity[axis] *= -1);
        mirrored.signs[axis] *= -1;
        mirrored
    }

    /// The same impact with the names of the bodies exchanged.
    pub fn exchanged(&self) -> Self {
        let mut exchanged = self.clone();
        exchanged.masses.swap(0, 1);
        exchanged.tenths.swap(0, 1);
        exchanged.signs = exchanged.signs.map(|sign| -sign);
        exchanged
    }

    fn scene(&self) -> String {
        let line = match (self.plane, self.signs) {
            (false, [1, _]) => "to the right".to_owned(),
            (false, _) => "to the left".to_owned(),
            (true, [x, y]) => {
                let side = if y == 1 { "above" } else { "below" };
                format!("alpha {side} {}x", if x == 1 { "+" } else { "-" })
            }
        };
        let axes = if self.plane { "{ x: to the right, y: up }" } else { "{ x: to the right }" };
        let contact = match self.kind {
            Kind::Separate => format!("restitution: e, line_of_impact: {line}"),
            Kind::Together if self.plane => "plastic: true, becomes: C".to_owned(),
            Kind::Together => format!("plastic: true, becomes: C, line_of_impact: {line}"),
        };
        format!(
            "axes: {axes}\nbodies:\n  A: {{ name: disc A }}\n  B: {{ name: disc B }}\nstages:\n  - impact: {{ between: \
             [A, B], {contact} }}"
        )
    }

    /// The names of what is given, with their values.
    fn given(&self) -> Vec<(String, String)> {
        let mut given = Vec::new();
        for (body, letter) in ["A", "B"].into_iter().enumerate() {
            let mass = self.masses[body];
            let mass = if self.small_units { format!("{} g", mass * 100) } else { format!("{} kg", decimal(mass, 1)) };
            given.push((format!("m_{letter}"), mass));
            for axis in 0..self.axes() {
                let speed = self.tenths[body][axis];
                let speed = if self.small_units {
                    format!("{} km/h", decimal(36 * speed, 2))
                } else {
                    format!("{} m/s", decimal(speed, 1))
                };
                given.push((self.component(&format!("v_{letter}1"), axis), speed));
            }
        }
        if self.kind == Kind::Separate {
            given.push(("e".to_owned(), decimal(self.e, 2)));
            if self.plane {
                given.push(("alpha".to_owned(), format!("{} deg", self.turn)));
            }
        }
        given
    }

    fn component(&self, name: &str, axis: usize) -> String {
        if self.plane { format!("{name}.{}", ["x", "y"][axis]) } else { name.to_owned() }
    }

    /// The names of the velocities after the impact.
    fn velocities_after(&self, body: usize) -> Vec<String> {
        let letter = if self.kind == Kind::Together { "C" } else { ["A", "B"][body] };
        (0..self.axes()).map(|axis| self.component(&format!("v_{letter}2"), axis)).collect()
    }

    fn impulses(&self, body: usize) -> Vec<String> {
        let name = format!("J_{}", ["A", "B"][body]);
        match (self.kind, self.plane) {
            (Kind::Separate, true) => vec![format!("{name}.n")],
            _ => (0..self.axes()).map(|axis| self.component(&name, axis)).collect(),
        }
    }

    /// The problem file.
    pub fn text(&self) -> String {
        self.sheet(&self.given(), &self.asked())
    }

    fn asked(&self) -> Vec<String> {
        let of_body = |body| [self.velocities_after(body), self.impulses(body)].concat();
        let mut asked: Vec<String> = (0..2).flat_map(of_body).chain(["T_lost".to_owned()]).collect();
        asked.sort();
        asked.dedup();
        asked
    }

    fn sheet(&self, given: &[(String, String)], ask: &[String]) -> String {
        let given: Vec<(&str, &str)> = given.iter().map(|(name, value)| (name.as_str(), value.as_str())).collect();
        sheet(&self.scene(), &given, &ask.iter().map(String::as_str).collect::<Vec<_>>())
    }

    /// Compiles the scene with some numbers in every place, once for all impacts of this shape, and solves it with these.
    fn solved(&self, given: &[(String, String)], ask: &[String]) -> (Rc<Problem>, Variant) {
        let any = |value: &str| match value.split_once(' ') {
            Some((_, unit)) => format!("{{ one_of: [1, 2], unit: {unit} }}"),
            None => "{ one_of: [0.1, 0.2] }".to_owned(),
        };
        let some: Vec<(String, String)> = given.iter().map(|(name, value)| (name.clone(), any(value))).collect();
        let text = self.sheet(&some, ask);
        let compiled = COMPILED.with_borrow_mut(|compiled| {
            compiled.entry(text).or_insert_with_key(|text| Rc::new(problem("impact.yaml", text))).clone()
        });
        let values: Vec<_> = given.iter().map(|(name, value)| instead(&compiled, name, value)).collect();
        let mut sampler = Sampler::new(&compiled, 0).unwrap();
        let variant = sampler.with_values(0, &values);
        let variant = variant.unwrap_or_else(|fault| panic!("{fault}\n{}", self.sheet(given, ask)));
        drop(sampler);
        (compiled, variant)
    }

    /// What the solver finds.
    pub fn solve(&self) -> After {
        let (problem, variant) = self.solved(&self.given(), &self.asked());
        let known = |name: &String| value(&problem, &variant, name).value;
        let vector = |names: Vec<String>| {
            let mut parts = names.iter().map(known);
            [parts.next().unwrap_or(0.0), parts.next().unwrap_or(0.0)]
        };
        let impulse = |body| match (self.kind, self.plane) {
            (Kind::Separate, true) => {
                let size = known(&self.impulses(body)[0]);
                self.normal().map(|part| size * part)
            }
            _ => vector(self.impulses(body)),
        };
        After {
            velocities: [0, 1].map(|body| vector(self.velocities_after(body))),
            impulses: [0, 1].map(impulse),
            lost: value(&problem, &variant, "T_lost"),
        }
    }

    /// The names of givens that the outcome lets one find again.
    pub fn backwards(&self) -> &'static [&'static str] {
        if self.plane { &["e", "m_A", "v_A1.x", "v_B1.x"] } else { &["e", "m_A", "m_B", "v_A1", "v_B1"] }
    }

    /// Whether the impulse depends on that given at all: motion across the line of impact has no part in it.
    pub fn lets_find(&self, name: &str) -> bool {
        !(self.turn == 90 && ["v_A1.x", "v_B1.x"].contains(&name))
    }

    /// Asks for a given, with a result told in its place; the value found and the one that was given.
    pub fn ask_back(&self, name: &str, after: &After) -> (Bounded, f64) {
        let told = if self.plane { "J_B.n" } else { "v_B2" };
        let (cos, sin) = (self.normal()[0], self.normal()[1]);
        let told_value = if self.plane {
            format!("{} N s", cos * after.impulses[1][0] + sin * after.impulses[1][1])
        } else {
            format!("{} m/s", after.velocities[1][0])
        };
        let (problem, variant) = self.solved(&self.given(), &self.asked());
        let given_value = value(&problem, &variant, name).value;
        let mut given = self.given();
        given.retain(|(listed, _)| listed != name);
        given.push((told.to_owned(), told_value));
        let (problem, variant) = self.solved(&given, &[name.to_owned()]);
        (value(&problem, &variant, name), given_value)
    }
}

/// A whole number of units of the last of so many places.
pub fn decimal(value: i64, places: u32) -> String {
    let scale = 10_i64.pow(places);
    let (sign, size) = (if value < 0 { "-" } else { "" }, value.abs());
    format!("{sign}{}.{:0width$}", size / scale, size % scale, width = places as usize)
}
