//! Directions in words, as unit vectors.

use momentous_scene::{Axis, Term};

use super::nothing::NothingToSimulate;
use super::values::Values;
use super::vector::{Vector, times, turned, unit};

impl Values<'_> {
    /// The unit vector of a direction: `to the left`, `+x`, `30 deg above +x`, `beta from -y`, `40 deg north of east`. Angles lie in the
    /// plane of x and y.
    pub(super) fn direction(&self, text: &str) -> Result<Vector, NothingToSimulate> {
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
                // Above is towards +y, or -y where y points down: the other way round where the angle is counted from -x.
                let mut axes = self.scene.axes.rectangular().into_iter();
                let falls = axes.any(|(axis, senses)| axis == Axis::Y && senses.rise() == Some(-1));
                let sign = if falls { -sign } else { sign };
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
        Ok(turned([1.0, 0.0, 0.0], self.number(text)?))
    }

    /// The direction in which something acts that may say so: along the first axis where it does not.
    pub(super) fn towards(&self, direction: Option<&Term>) -> Result<Vector, NothingToSimulate> {
        match direction {
            Some(term) => self.direction(&term.0),
            None => Ok(self.axes().first().map_or(unit(Axis::X), |axis| unit(*axis))),
        }
    }

    /// Words for a direction along or against an axis.
    fn along_axis(&self, text: &str) -> Option<Vector> {
        let (axis, sign) = self.scene.axes.pointed(text)?;
        Some(if sign < 0 { times(-1.0, unit(axis)) } else { unit(axis) })
    }
}
