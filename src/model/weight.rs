//! The weight of a body as what acts on it in a stage.

use momentous_expr::Expr;

use super::Builder;
use super::Effect;
use super::Influence;

impl Builder<'_> {
    /// Weight on a body in the air or on a slope: nothing makes up for it along an axis that points up or down.
    pub(crate) fn weight_on(&self, index: usize, body: &str) -> Influence {
        let along = |position| match self.downwards(position) {
            Some(_) => Effect::Open,
            None => Effect::Of(Expr::zero()),
        };
        let weight = Influence::outside(index, body, "weight");
        let weight = weight.works(Effect::Open, "weight does work as the height changes");
        Influence { force: (0..self.axes.len()).map(along).collect(), ..weight }
    }
}
