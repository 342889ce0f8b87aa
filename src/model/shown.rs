//! Laws whose equation is shown with the step that it follows from: an integral, a series, a balance.

use momentous_laws::Law;
use momentous_laws::Sides;

use super::Because;
use super::Builder;
use super::Integral;
use super::Shown;
use super::builder::LAW_COST;

impl Builder<'_> {
    /// One use of a law whose right side is the value of an integral.
    pub(super) fn integral(
        &mut self,
        law: &'static Law,
        stage: usize,
        because: impl Into<Because>,
        sides: Sides,
        integral: Integral,
    ) {
        let equation = self.stated(LAW_COST, law, Some(stage), because, sides, Some(integral));
        self.system.equations.push(equation);
    }

    /// Shows what the equation of the law that was stated last follows from.
    pub(super) fn shows(&mut self, shown: Shown) {
        if let Some(instance) = self.instances.last_mut() {
            instance.shown = Some(shown);
        }
    }

    /// The same, where the laws of these tags name what stands in the value for the ends of the range.
    pub(super) fn integral_between(
        &mut self,
        law: &'static Law,
        (stage, ends): (usize, &[usize]),
        because: impl Into<Because>,
        sides: Sides,
        integral: Integral,
    ) {
        self.integral(law, stage, because, sides, integral);
        if let Some(instance) = self.instances.last_mut() {
            instance.ends = ends.to_vec();
        }
    }
}
