//! Meanings of signs, so that an answer with the wrong one is not taken for a magnitude.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_model::QuantityKind;
use momentous_quantity::Dimension;
use momentous_scene::Senses;

use super::super::compiling::planned::Problem;
use super::sense::senses_of;

/// The meaning of a quantity's sign.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Sign {
    /// Which of two directions a vector has, or which of two senses a turn.
    Sense(Senses),
    /// Something without words of its own: the side of the origin, or whether work is done on a body or by it.
    Other,
    /// Nothing, since the quantity is a magnitude.
    Nothing,
}

impl Problem {
    /// The meaning of a quantity's sign, whatever its value is. An expression has a sign where it is a sum or where something in
    /// it has one.
    ///
    /// ```
    /// use momentous_bank::Bank;
    /// use momentous_problem::{Sign, compile, load};
    ///
    /// let problem = compile(load(Bank::built_in().find("impact/two-carts")?.clone())?, None)?;
    /// let sign = |name| problem.model().symbol_of(name).map(|symbol| problem.sign(symbol));
    /// assert!(matches!(sign("v_A2"), Some(Sign::Sense(_))));
    /// assert_eq!(sign("m_A"), Some(Sign::Nothing));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn sign(&self, symbol: Symbol) -> Sign {
        if let Some(expression) = self.model().expressions.get(&symbol) {
            let signed = expression.symbols().iter().any(|part| self.sign(*part) != Sign::Nothing);
            return if signed || matches!(expression, Expr::Sum(_)) { Sign::Other } else { Sign::Nothing };
        }
        if let Some(senses) = self.senses(symbol) {
            return Sign::Sense(senses);
        }
        let name = self.model().name(symbol);
        // A coefficient or a ratio below zero is no size with a slip of the pen: something was subtracted the wrong way round.
        let is_pure = self.model().symbols.entry(symbol).dimension == Dimension::NONE;
        if is_pure && matches!(name.kind, QuantityKind::Value(_) | QuantityKind::Own(_)) {
            return Sign::Other;
        }
        // Work has no name of its own where there is one stage only.
        if name.is_plain() && name.kind != QuantityKind::Work {
            return Sign::Nothing;
        }
        let scene = &self.loaded().draft.scene;
        let along = senses_of(scene, &self.model().symbols.entry(symbol).name);
        match &name.kind {
            QuantityKind::AngularVelocity
            | QuantityKind::AngularMomentum
            | QuantityKind::AngularMomentumRate
            | QuantityKind::AngularImpulse
            | QuantityKind::Moment => match scene.axes.rectangular().len() {
                0 | 2 => Sign::Sense(Senses::of_a_turn()),
                1 => along.map_or(Sign::Other, Sign::Sense),
                _ => Sign::Other,
            },
            QuantityKind::Acceleration
            | QuantityKind::HoldingForce
            | QuantityKind::MomentumRate
            | QuantityKind::TimeIntegral => along.map_or(Sign::Nothing, Sign::Sense),
            // What is positive by its meaning is the distance travelled.
            QuantityKind::Displacement if !self.model().system.positive.contains(&symbol) => {
                along.map_or(Sign::Nothing, Sign::Sense)
            }
            // On a circle a position is the distance from its centre.
            QuantityKind::Position if along.as_ref().is_some_and(|senses| !senses.is_of_a_turn()) => Sign::Other,
            QuantityKind::Coordinate(_) | QuantityKind::Work => Sign::Other,
            kind if kind.is_velocity() => Sign::Other,
            _ => Sign::Nothing,
        }
    }

    /// The words for the two directions between which the sign of a quantity decides, as they lie in space, for one that hangs on a
    /// string, too; none for a turn in a scene without axes, where no sense is told from the other.
    #[must_use]
    pub fn directions_told(&self, symbol: Symbol) -> Option<Senses> {
        let has_axes = !self.loaded().draft.scene.axes.rectangular().is_empty();
        self.hanging(symbol).or_else(|| match self.sign(symbol) {
            Sign::Sense(senses) if has_axes || !senses.is_of_a_turn() => Some(senses),
            Sign::Sense(_) | Sign::Other | Sign::Nothing => None,
        })
    }
}
