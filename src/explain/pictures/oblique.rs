//! A scene in space on paper: an oblique projection, in which what lies across the paper is shortened.

use momentous_scene::Axis;
use momentous_scene::Senses;

/// The direction on paper of an axis that points away from the reader, and by how much it is shortened.
const AWAY: [f64; 2] = [0.46, 0.34];

/// The directions of a scene's three axes on paper, each with the length of its unit.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Oblique {
    units: [[f64; 2]; 3],
}

impl Oblique {
    /// The projection of a scene with three axes; none of any other.
    pub(super) fn of(axes: &[(Axis, Senses)]) -> Option<Self> {
        let [_, _, _] = axes else { return None };
        let upright = axes.iter().position(|(_, senses)| senses.rise().is_some()).unwrap_or(2);
        let up = if axes[upright].1.rise() == Some(-1) { [0.0, -1.0] } else { [0.0, 1.0] };
        let towards = AWAY.map(|part| -part);
        let right = [1.0, 0.0];
        // The axes are right-handed.
        let units = match (upright, up[1] > 0.0) {
            (0, true) => [up, right, AWAY],
            (0, false) => [up, right, towards],
            (1, true) => [right, up, towards],
            (1, false) => [right, up, AWAY],
            (_, true) => [right, AWAY, up],
            (_, false) => [right, towards, up],
        };
        Some(Self { units })
    }

    /// A vector along the axes as one of the drawing.
    pub(super) fn place(&self, vector: [f64; 3]) -> [f64; 2] {
        let part =
            |coordinate: usize| self.units.iter().zip(vector).map(|(unit, value)| unit[coordinate] * value).sum();
        [part(0), part(1)]
    }

    /// The units of the axes on the drawing.
    pub(super) fn units(&self) -> [[f64; 2]; 3] {
        self.units
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use momentous_scene::Sense;

    fn oblique(words: [&str; 3]) -> Option<Oblique> {
        let senses = |(axis, words): (Axis, &str)| (axis, Sense::Positive(words.to_owned()).senses(axis));
        let axes: Vec<_> = [Axis::X, Axis::Y, Axis::Z].into_iter().zip(words).map(senses).collect();
        Oblique::of(&axes)
    }

    #[test]
    fn what_points_upwards_stands_upright_and_the_axes_are_right_handed() {
        let map = oblique(["east", "north", "upwards"]).map(|oblique| oblique.units());
        assert_eq!(map, Some([[1.0, 0.0], AWAY, [0.0, 1.0]]));
        let board = oblique(["to the right", "upwards", "towards you"]).map(|oblique| oblique.place([1.0, 2.0, 1.0]));
        assert_eq!(board, Some([1.0 - AWAY[0], 2.0 - AWAY[1]]));
    }
}
