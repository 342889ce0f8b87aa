//! How far two runs of one scene are apart, as a whole: no quantity is left out that a method may get wrong.

use super::record::{Moment, Record};

impl Record {
    /// The greatest difference from a record of the same scene, relative to the greatest size of what differs: of times, of
    /// impulses, of the places and the velocities after each impact, at the end, and without impacts all the way. Impacts are
    /// compared by their number; where `to_rest` says that infinitely many end the run, those that both have. None where the two
    /// do not have the same impacts.
    #[must_use]
    pub fn apart(&self, truth: &Self, to_rest: bool) -> Option<f64> {
        let (impacts, other) = (&self.impacts, &truth.impacts);
        let counted = impacts.len() == other.len() || to_rest && !impacts.is_empty() && !other.is_empty();
        let same = impacts.iter().zip(other).all(|(one, other)| one.contact == other.contact);
        let (first, last) = (truth.moments.first()?, truth.moments.last()?);
        if !counted || !same {
            return None;
        }
        let sizes = Sizes::of(truth, first);
        let mut worst = sizes.between(self.moments.last()?, last);
        let mut keep = |part: f64| worst = if part.is_nan() { f64::INFINITY } else { worst.max(part) };
        for (one, other) in impacts.iter().zip(other) {
            keep(share(one.time - other.time, sizes.time));
            keep(share(distance(&one.impulse, &other.impulse), sizes.impulse));
            if let (Some(one), Some(other)) = (self.just_after(one.time), truth.just_after(other.time)) {
                keep(sizes.between(one, other));
            }
        }
        if impacts.is_empty() && self.moments.len() == truth.moments.len() {
            self.moments.iter().zip(&truth.moments).for_each(|(one, other)| keep(sizes.between(one, other)));
        }
        Some(worst)
    }

    /// The last moment at a time, where the record has one.
    fn just_after(&self, time: f64) -> Option<&Moment> {
        let next = self.moments.partition_point(|moment| moment.time <= time);
        self.moments.get(next.checked_sub(1)?).filter(|moment| moment.time >= time)
    }
}

/// The greatest sizes of what two records can differ in.
struct Sizes {
    time: f64,
    /// The distance that a body goes from where it starts.
    way: f64,
    speed: f64,
    impulse: f64,
}

impl Sizes {
    fn of(truth: &Record, first: &Moment) -> Self {
        let greatest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
        let ways = truth.moments.iter().flat_map(|moment| moment.positions.iter().zip(&first.positions));
        let speeds = truth.moments.iter().flat_map(|moment| &moment.velocities);
        Self {
            time: greatest(&mut truth.moments.iter().map(|moment| (moment.time - first.time).abs())),
            way: greatest(&mut ways.map(|(way, first)| distance(way, first))),
            speed: greatest(&mut speeds.map(|speed| size(speed))),
            impulse: greatest(&mut truth.impacts.iter().map(|impact| size(&impact.impulse))),
        }
    }

    fn between(&self, one: &Moment, other: &Moment) -> f64 {
        let places =
            one.positions.iter().zip(&other.positions).map(|(one, other)| share(distance(one, other), self.way));
        let speeds = one.velocities.iter().zip(&other.velocities);
        let speeds = speeds.map(|(one, other)| share(distance(one, other), self.speed));
        places
            .chain(speeds)
            .chain([share(one.time - other.time, self.time)])
            .fold(0.0, |worst: f64, part| if part.is_nan() { f64::INFINITY } else { worst.max(part) })
    }
}

fn share(part: f64, whole: f64) -> f64 {
    if part == 0.0 { 0.0 } else { (part / whole).abs() }
}

fn size(vector: &[f64]) -> f64 {
    vector.iter().map(|part| part * part).sum::<f64>().sqrt()
}

fn distance(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(one, other)| (one - other) * (one - other)).sum::<f64>().sqrt()
}
