//! Directions in words, as unit vectors.

use crate::scene::Axis;

use super::nothing::NothingToSimulate;
use super::values::Values;

impl Values<'_> {
    /// The unit vector, in x and y, of a direction: `to the left`, `+x`, `30 deg above +x`, `beta from -y`, `40 deg north of east`.
    pub(super) fn direction(&self, text: &str) -> Result<[f64; 2], NothingToSimulate> {
        let text = text.trim();
        if let Some(axis) = self.along_axis(text) {
            return Ok(axis);
        }
        let counted = |base: &str| {
            let base = if base.trim() == "the horizontal" { "+x" } else { base };
            self.along_axis(base).ok_or(NothingToSimulate::Unread)
        };
        for (joint, sign) in [(" above ", 1.0), (" below ", -1.0)] {
            if let Some((angle, base)) = text.split_once(joint) {
                let base = counted(base)?;
                // Above is towards +y: the other way round where the angle is counted from -x.
                let sign = if base[0] < 0.0 { -sign } else { sign };
                return Ok(turned(base, sign * self.number(angle)?));
            }
        }
        if let Some((angle, base)) = text.split_once(" from ") {
            return Ok(turned(counted(base)?, self.number(angle)?));
        }
        if let Some((before, base)) = text.split_once(" of ")
            && let Some((angle, towards)) = before.rsplit_once(' ')
            && let (Some(base), Some(towards)) = (self.along_axis(base), self.along_axis(towards))
        {
            let sign = base[0] * towards[1] - base[1] * towards[0];
            return Ok(turned(base, sign * self.number(angle)?));
        }
        Ok(turned([1.0, 0.0], self.number(text)?))
    }

    /// Words for a direction along or against an axis.
    fn along_axis(&self, text: &str) -> Option<[f64; 2]> {
        let text = text.trim();
        self.scene.axes.rectangular().into_iter().find_map(|(axis, senses)| {
            let said = |phrase: &str, sign: char| {
                text == phrase
                    || phrase.strip_prefix("to the ") == Some(text)
                    || phrase.strip_suffix("wards") == Some(text)
                    || text.strip_prefix(sign) == Some(axis.letter())
            };
            let unit = match axis {
                Axis::Z => return None,
                _ => unit(axis),
            };
            if text == axis.letter() || said(&senses.positive, '+') {
                Some(unit)
            } else {
                said(&senses.negative, '-').then(|| unit.map(|part| -part))
            }
        })
    }
}

/// The unit vector along an axis of the plane.
pub(super) fn unit(axis: Axis) -> [f64; 2] {
    match axis {
        Axis::X => [1.0, 0.0],
        Axis::Y => [0.0, 1.0],
        Axis::Z => [0.0, 0.0],
    }
}

/// A vector turned counter-clockwise.
pub(super) fn turned([x, y]: [f64; 2], angle: f64) -> [f64; 2] {
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    [cos * x - sin * y, sin * x + cos * y]
}

/// The component of a vector along an axis of the plane.
pub(super) fn part([x, y]: [f64; 2], axis: Axis) -> f64 {
    match axis {
        Axis::X => x,
        Axis::Y => y,
        Axis::Z => 0.0,
    }
}
