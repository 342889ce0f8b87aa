//! The curve of a graph, and whether two curves look alike.

/// A curve over time, in SI units. Between its pieces it may jump.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Its pieces in order of time, each a line through points (time, value).
    pub pieces: Vec<Vec<[f64; 2]>>,
}

/// Two curves are alike at an instant where they differ by less than this share of the height that both take.
const NEAR: f64 = 0.12;

/// Two curves look alike that differ over less than this share of the time.
const ALIKE: f64 = 0.12;

impl Curve {
    /// Its points.
    pub fn points(&self) -> impl Iterator<Item = [f64; 2]> {
        self.pieces.iter().flatten().copied()
    }

    /// Whether every point of it has a place.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        self.points().flatten().all(f64::is_finite)
    }

    /// The lowest and the highest value, zero included.
    #[must_use]
    pub fn reach(&self) -> [f64; 2] {
        self.points().fold([0.0, 0.0], |[low, high], [_, value]| [low.min(value), high.max(value)])
    }

    /// The largest size of its values.
    pub(crate) fn largest(&self) -> f64 {
        let [low, high] = self.reach();
        high.max(-low)
    }

    /// The value at a time, by straight lines between points; none outside of it.
    #[must_use]
    pub fn at(&self, time: f64) -> Option<f64> {
        let lines = self.pieces.iter().flat_map(|piece| piece.windows(2));
        let mut over = lines.filter_map(|line| match line {
            [[from, start], [to, end]] if *from <= time && time <= *to && from < to => {
                Some(start + (end - start) * (time - from) / (to - from))
            }
            _ => None,
        });
        over.next()
    }

    /// Whether the eye takes it for another curve over the same times.
    pub(crate) fn looks_like(&self, other: &Self) -> bool {
        let [low, high] = [self, other].map(Self::reach).into_iter().fold([0.0, 0.0], |[low, high], ends| {
            let [lowest, highest]: [f64; 2] = ends;
            [f64::min(low, lowest), f64::max(high, highest)]
        });
        let near = NEAR * (high - low);
        let (mut apart, mut whole) = (0.0, 0.0);
        for (one, other) in self.pieces.iter().zip(&other.pieces) {
            for (one, other) in one.windows(2).zip(other.windows(2)) {
                let ([[from, left], [to, right]], [[_, other_left], [_, other_right]]) = (one, other) else { continue };
                let differ = f64::midpoint(*left, *right) - f64::midpoint(*other_left, *other_right);
                whole += to - from;
                apart += if differ.abs() > near { to - from } else { 0.0 };
            }
        }
        apart <= ALIKE * whole
    }
}
