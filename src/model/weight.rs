//! The weight of a body as what acts on it in a stage.

use momentous_expr::Expr;

use super::Builder;
use super::Effect;
use super::Influence;

impl Builder<'_> {
    /// Weight on a body in the air or on a slope, along each axis.
    pub(crate) fn weight_on(&mut self, index: usize, body: &str) -> Influence {
        let pull = self.mass(body) * self.gravity();
        let along =
            |position| self.downwards(position).map_or_else(Expr::zero, |down| Expr::integer(down) * pull.clone());
        weight(index, body, (0..self.axes.len()).map(along).map(Effect::Of).collect())
    }

    /// The same where no equation needs to know how large it is: nothing makes up for it.
    pub(crate) fn some_weight_on(&self, index: usize, body: &str) -> Influence {
        let along = |position| self.downwards(position).map_or(Effect::Of(Expr::zero()), |_| Effect::Open);
        weight(index, body, (0..self.axes.len()).map(along).collect())
    }
}

fn weight(index: usize, body: &str, force: Vec<Effect>) -> Influence {
    let weight = Influence::outside(index, body, "weight");
    Influence { force, ..weight.works(Effect::Open, "weight does work as the height changes") }
}
