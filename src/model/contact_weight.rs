//! The impulse of weight on a body in a short contact, beside the change of its momentum.

use momentous_expr::Expr;

/// From which share of the change of momentum on what is left out must not be: one part in so many.
const TOO_MUCH: i64 = 10;

/// The impulse of weight on a body in a short contact, beside the change of its momentum; both for each unit of its mass.
#[derive(Clone, Debug)]
pub struct ContactWeight {
    /// The stage, counted from 0.
    pub stage: usize,
    /// The short name of the body.
    pub on: String,
    /// Whether it stands in the balance.
    pub included: bool,
    /// The velocity that weight gives the body while the contact lasts.
    pub fall: Expr,
    /// How the components of its velocity change.
    pub change: Vec<Expr>,
}

impl ContactWeight {
    /// The sides of the comparison that holds where weight is small: the square of ten times its impulse, and that of the change.
    #[must_use]
    pub fn squares(&self) -> [Expr; 2] {
        let change = self.change.iter().map(|change| change.clone().powi(2));
        [(Expr::integer(TOO_MUCH) * self.fall.clone()).powi(2), Expr::sum(change)]
    }

    /// The impulse of weight as a share of the change of momentum, with `value` giving the value of a term.
    #[must_use]
    pub fn share(&self, value: &dyn Fn(&Expr) -> f64) -> f64 {
        let [weight, change] = self.squares().map(|square| libm::sqrt(value(&square)));
        #[allow(clippy::cast_precision_loss, reason = "a small whole number")]
        let whole = TOO_MUCH as f64;
        weight / whole / change
    }
}
