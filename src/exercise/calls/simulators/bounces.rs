//! The bounces of a run, one after another.

use serde::Serialize;

use momentous_simulate::Trajectory;

use super::{Amount, Curve, Phase};

/// Halvings that find a peak to the last digit of a double.
const HALVINGS: usize = 60;

/// A contact lasts no time; in words it is said for this share of the run.
const CONTACT: f64 = 0.004;

/// A bounce.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Bounce {
    /// Its number; 0 is the release.
    pub number: usize,
    /// When.
    pub time: Amount,
    /// The velocity just before, upwards positive.
    pub before: Amount,
    /// The velocity just after.
    pub after: Amount,
    /// The height that is reached after it.
    pub height: Amount,
    /// The same as a share of the height of release.
    pub share: Amount,
    /// When that height is reached, in s.
    pub peak: f64,
}

/// The release and the first bounces of a ball that was dropped.
pub(super) fn bounces(run: &Trajectory<1>, released: f64, most: usize) -> Vec<Bounce> {
    let time_amount = |time: f64| Amount::new(time, 0.0, "s");
    let velocity = |value: f64| Amount::new(value, 0.0, "m/s");
    let height = |value: f64| Amount::new(value, 0.0, "m");
    let mut all = vec![Bounce {
        number: 0,
        time: time_amount(0.0),
        before: velocity(0.0),
        after: velocity(0.0),
        height: height(released),
        share: Amount::share(1.0, 1.0),
        peak: 0.0,
    }];
    for (place, impact) in run.impacts.iter().enumerate().take(most) {
        // At the very end no piece of the path begins any more.
        let after = if impact.time >= run.last.time {
            run.last.velocities.first().copied()
        } else {
            run.just_after(0, impact.time).map(|(_, velocity)| velocity)
        };
        let (Some(before), Some(after)) = (run.at(0, impact.time), after) else { break };
        let next = run.impacts.get(place + 1).map_or(run.last.time, |next| next.time);
        let (peak, reached) = peak(run, impact.time, next);
        all.push(Bounce {
            number: place + 1,
            time: time_amount(impact.time),
            before: velocity(before.1.x),
            after: velocity(after.x),
            height: height(reached),
            share: Amount::share(reached, released),
            peak,
        });
    }
    all
}

/// When and where a ball between two impacts turns.
fn peak(run: &Trajectory<1>, from: f64, to: f64) -> (f64, f64) {
    let (mut low, mut high) = (from, to);
    for _ in 0..HALVINGS {
        let middle = f64::midpoint(low, high);
        if run.just_after(0, middle).is_some_and(|(_, velocity)| velocity.x > 0.0) {
            low = middle;
        } else {
            high = middle;
        }
    }
    let time = f64::midpoint(low, high);
    (time, run.at(0, time).map_or(0.0, |(place, _)| place.x.max(0.0)))
}

/// The line through the peaks.
pub(super) fn envelope(name: &str, bounces: &[Bounce]) -> Curve {
    Curve::new(name, "total", bounces.iter().map(|bounce| [bounce.peak, bounce.height.value])).dashed()
}

/// The phases of the ball's motion, one after another.
pub(super) fn phases(bounces: &[Bounce], end: f64, rests: bool) -> Vec<Phase> {
    let mut all: Vec<Phase> = Vec::new();
    for (bounce, last) in bounces.iter().skip(1).zip(bounces) {
        let contact = (CONTACT * end).min((bounce.time.value - last.peak) / 2.0);
        all.push(Phase { until: bounce.time.value - contact, words: "falling" });
        all.push(Phase { until: bounce.time.value + contact, words: "contact" });
        if bounce.peak > bounce.time.value + contact {
            all.push(Phase { until: bounce.peak, words: "rising" });
        }
    }
    all.push(Phase { until: end, words: if rests { "coming to rest" } else { "falling" } });
    all
}
