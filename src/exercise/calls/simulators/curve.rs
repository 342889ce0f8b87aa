//! Points of a plot.

use serde::Serialize;

use momentous_simulate::Record;

/// Points nearer to the line between their neighbours than this share of the curve's size say nothing.
const STRAIGHT: f64 = 1e-9;

/// A line of a plot.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Curve {
    /// Its name.
    pub name: String,
    /// Its role, which decides how it looks.
    pub role: &'static str,
    /// Whether it is dashed: what is not the exact motion.
    pub dashed: bool,
    /// Its points: time in s, and what it shows.
    pub points: Vec<[f64; 2]>,
}

impl Curve {
    /// A curve through points in the order of time, without those in the middle of straight lines.
    pub(super) fn new(name: impl Into<String>, role: &'static str, points: impl Iterator<Item = [f64; 2]>) -> Self {
        let all: Vec<[f64; 2]> = points.collect();
        let size = all.iter().map(|[_, up]| up.abs()).fold(0.0, f64::max);
        let mut points: Vec<[f64; 2]> = Vec::new();
        for (place, point) in all.iter().enumerate() {
            let straight = match (points.last(), all.get(place + 1)) {
                (Some(before), Some(after)) => lies_between(before, point, after, STRAIGHT * size),
                _ => false,
            };
            if !straight {
                points.push(*point);
            }
        }
        Self { name: name.into(), role, dashed: false, points }
    }

    /// The same curve, dashed.
    #[must_use]
    pub(super) fn dashed(mut self) -> Self {
        self.dashed = true;
        self
    }

    /// The place of a body along an axis in the course of a run.
    pub(super) fn place(
        name: impl Into<String>,
        role: &'static str,
        record: &Record,
        [body, axis]: [usize; 2],
    ) -> Self {
        let at = |places: &Vec<Vec<f64>>| places.get(body).and_then(|place| place.get(axis)).copied();
        let points = record.moments.iter().filter_map(|moment| Some([moment.time, at(&moment.positions)?]));
        Self::new(name, role, points)
    }

    /// The height of the line at a time.
    pub(super) fn at(&self, time: f64) -> Option<f64> {
        let after = self.points.partition_point(|[at, _]| *at < time);
        let [end, up] = *self.points.get(after)?;
        let Some([start, low]) = after.checked_sub(1).and_then(|before| self.points.get(before)).copied() else {
            return (end <= time).then_some(up);
        };
        Some(low + (up - low) * (time - start) / (end - start))
    }
}

/// The places of two bodies and their centre of mass along an axis.
pub(super) fn places(record: &Record, axis: usize) -> Vec<Curve> {
    let centre = record.moments.iter().filter_map(|moment| Some([moment.time, *moment.centre.get(axis)?]));
    vec![
        Curve::place("A", "body-0", record, [0, axis]),
        Curve::place("B", "body-1", record, [1, axis]),
        Curve::new("centre of mass", "centre", centre),
    ]
}

fn lies_between([start, low]: &[f64; 2], [time, up]: &[f64; 2], [end, high]: &[f64; 2], near: f64) -> bool {
    end > start && (low + (high - low) * (time - start) / (end - start) - up).abs() <= near
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_straight_line_keeps_its_ends_and_corners() {
        let points = [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0], [3.0, 1.0], [4.0, 0.0]];
        let curve = Curve::new("place", "body-0", points.into_iter());
        assert_eq!(curve.points, [[0.0, 0.0], [2.0, 2.0], [4.0, 0.0]]);
        assert_eq!([1.0, 3.0, 4.0, 5.0].map(|time| curve.at(time)), [Some(1.0), Some(1.0), Some(0.0), None]);
    }
}
