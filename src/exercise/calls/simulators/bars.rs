//! The bars and arrows beside a scene, as time runs: velocities, momenta and energies of each body and of all together.

use serde::Serialize;

use momentous_simulate::{Moment, Record};

use super::Curve;

/// The roles of bodies.
const ROLES: [&str; 2] = ["body-0", "body-1"];

/// A quantity of which each curve is a bar, as long as it is at the time.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Bars {
    /// The quantity.
    pub title: String,
    /// Its unit.
    pub unit: &'static str,
    /// The greatest amount of any of them: the whole length.
    pub most: f64,
    /// Whose they are.
    pub curves: Vec<Curve>,
}

impl Bars {
    pub(super) fn new(title: impl Into<String>, unit: &'static str, curves: Vec<Curve>) -> Self {
        let values = curves.iter().flat_map(|curve| &curve.points).map(|[_, value]| value.abs());
        Self { title: title.into(), unit, most: values.fold(0.0, f64::max), curves }
    }
}

/// The velocities along an axis, of each body and of the centre of mass.
pub(super) fn velocities(record: &Record, axis: usize) -> Vec<Curve> {
    let mut curves = each(record, |moment, body| part(&moment.velocities, body, axis));
    let together = |moment: &Moment| Some(moment.momentum.get(axis)? / moment.masses.iter().sum::<f64>());
    curves.push(over(record, "centre of mass", "centre", together));
    curves
}

/// The momenta along an axis, of each body and of all together.
pub(super) fn momenta(title: &str, record: &Record, axis: usize) -> Bars {
    let momentum =
        |moment: &Moment, body: usize| Some(moment.masses.get(body)? * part(&moment.velocities, body, axis)?);
    let mut curves = each(record, momentum);
    curves.push(over(record, "together", "centre", |moment| moment.momentum.get(axis).copied()));
    Bars::new(title, "kg\u{a0}m/s", curves)
}

/// The kinetic energies, of each body and of all together, and what is lost.
pub(super) fn energies(record: &Record) -> Bars {
    let energy = |moment: &Moment, body: usize| {
        let squared: f64 = moment.velocities.get(body)?.iter().map(|part| part * part).sum();
        Some(moment.masses.get(body)? * squared / 2.0)
    };
    let mut curves = each(record, energy);
    curves.push(over(record, "together", "centre", |moment| Some(moment.kinetic)));
    curves.push(over(record, "lost", "work", |moment| Some(moment.lost)));
    Bars::new("Kinetic energy", "J", curves)
}

/// A quantity as time runs.
pub(super) fn over(record: &Record, name: &str, role: &'static str, value: impl Fn(&Moment) -> Option<f64>) -> Curve {
    Curve::new(name, role, record.moments.iter().filter_map(|moment| Some([moment.time, value(moment)?])))
}

fn each(record: &Record, value: impl Fn(&Moment, usize) -> Option<f64>) -> Vec<Curve> {
    let bodies = record.bodies.iter().zip(ROLES).enumerate();
    bodies.map(|(body, (named, role))| over(record, &named.name, role, |moment| value(moment, body))).collect()
}

fn part(vectors: &[Vec<f64>], body: usize, axis: usize) -> Option<f64> {
    vectors.get(body)?.get(axis).copied()
}
