//! One scale for all arrows of a kind in a figure.

use super::Point;

/// Below this part of the longest arrow a vector is rounding, not motion.
const NOTHING: f64 = 1e-9;
/// The shortest arrow in a sketch, and the shortest that still reads as one; smaller vectors are drawn so, and no longer to
/// scale.
const SKETCHED: f64 = 11.0;
const SHORTEST: f64 = 7.0;
/// The length of an arrow whose size is asked for, as a part of the longest.
const ASKED: f64 = 0.7;

/// From a quantity's unit to drawing units.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scale {
    largest: f64,
    longest: f64,
    shortest: f64,
    /// Whether a vector is so small that its arrow is longer than the scale makes it.
    pub lengthens: bool,
}

impl Scale {
    /// The scale by which the largest of `vectors` becomes an arrow of length `longest`.
    pub(super) fn fitting(vectors: impl IntoIterator<Item = Point>, longest: f64) -> Self {
        Self::with_shortest(vectors, longest, SHORTEST)
    }

    /// The same for arrows whose lengths claim less.
    pub(super) fn sketching(vectors: impl IntoIterator<Item = Point>, longest: f64) -> Self {
        Self::with_shortest(vectors, longest, SKETCHED)
    }

    fn with_shortest(vectors: impl IntoIterator<Item = Point>, longest: f64, shortest: f64) -> Self {
        let sizes: Vec<f64> = vectors.into_iter().map(Point::length).collect();
        let largest = sizes.iter().copied().fold(0.0, f64::max);
        let is_short = |size: &f64| *size > NOTHING * largest && size * longest < shortest * largest;
        Self { largest, longest, shortest, lengthens: sizes.iter().any(is_short) }
    }

    /// An arrow in the direction of `vector`, with a length that says nothing.
    pub(super) fn sketch(self, vector: Point) -> Option<Point> {
        let size = vector.length();
        (size > 0.0 && size.is_finite()).then(|| vector * (ASKED * self.longest / size))
    }

    /// The arrow for `vector`; `None` for one that is zero.
    pub(super) fn arrow(self, vector: Point) -> Option<Point> {
        let size = vector.length();
        if size <= NOTHING * self.largest || !size.is_finite() {
            return None;
        }
        let length = (size / self.largest * self.longest).max(self.shortest);
        Some(vector * (length / size))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_fills_the_panel_and_the_tiniest_is_still_seen() {
        let (large, tiny) = (Point::new(3.0, 4.0), Point::new(0.0, -0.001));
        let scale = Scale::fitting([large, tiny], 70.0);
        assert!(scale.arrow(large).is_some_and(|arrow| (arrow.length() - 70.0).abs() < 1e-9));
        assert_eq!(scale.arrow(tiny), Some(Point::new(0.0, -SHORTEST)));
        assert_eq!(scale.arrow(Point::ORIGIN), None);
        assert!(scale.lengthens);
    }

    #[test]
    fn what_is_small_and_can_be_seen_is_drawn_to_scale() {
        let (large, small) = (Point::new(70.0, 0.0), Point::new(0.0, 8.0));
        let scale = Scale::fitting([large, small, Point::ORIGIN], 70.0);
        assert_eq!(scale.arrow(small), Some(small));
        assert!(!scale.lengthens);
    }
}
