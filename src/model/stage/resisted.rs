//! The motion of a body along one axis against a resistance in proportion to its speed, whatever stage it is in.

use crate::Builder;
use crate::Integral;
use crate::Name;
use crate::QuantityKind;
use crate::Shown;
use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_fault::Path;
use momentous_laws::momentum;
use momentous_laws::motion;
use momentous_laws::resistance;
use momentous_quantity::Dimension;
use momentous_scene::Axis;
use momentous_scene::Term;

/// Resistance by the speed.
const LINEAR: Dimension = Dimension::new(1, 0, -1);

/// A motion along one axis against a resistance in proportion to the speed.
pub(super) struct Resisted<'a> {
    pub index: usize,
    pub body: &'a str,
    pub axis: Axis,
    /// The force along the axis besides, which stays the same.
    pub steady: Expr,
    /// The resistance divided by the speed.
    pub resists: &'a Expr,
    pub clock: Symbol,
    /// The start and the end on the clock.
    pub during: [&'a Expr; 2],
    pub moved: Expr,
    /// The velocity at the end: zero where the body comes to rest.
    pub after: Expr,
}

impl Builder<'_> {
    /// Shows what the law that was stated last follows from: a time or a way as an integral over the speed, between these speeds.
    pub(super) fn shows_separated(
        &mut self,
        quantity: Expr,
        [low, high]: [&Expr; 2],
        integrand: &dyn Fn(&Expr) -> Expr,
    ) {
        let name = Name::of(QuantityKind::Own("v_".to_owned()), "");
        let variable = self.symbol_of(name, Dimension::VELOCITY, "the velocity on the way");
        let integrand = integrand(&variable.into()).simplify();
        let integral = Integral { integrand, variable, low: low.clone(), high: high.clone() };
        self.shows(Shown::Integral { of: quantity, integral });
    }

    /// Reads a resistance divided by the speed.
    pub(super) fn linear_resistance(&mut self, term: &Term, path: &Path) -> Expr {
        self.read_positive(term, LINEAR, "the resistance divided by the speed", &path.key("linear"))
    }

    /// Velocity and displacement as functions of time, and the impulse.
    pub(super) fn resisted(&mut self, resisted: &Resisted<'_>) {
        let Resisted { index, body, axis, steady, resists, moved, after, .. } = resisted;
        let (index, [start, end]) = (Some(*index), resisted.during);
        let (name, mass, along) = (self.called(body), self.mass(body), self.along(*axis));
        let before = self.velocity(body, resisted.index + 1, *axis);
        let lasts = (end.clone() - start.clone()).simplify();
        let endless = after.is_zero() && steady.is_zero();
        let impulses = [steady.clone() * lasts.clone(), -((*resists).clone() * moved.clone())];
        let impulses: Vec<Expr> = impulses.into_iter().filter(|impulse| !impulse.is_zero()).collect();
        let because = if endless {
            format!(
                "{name} comes ever closer to rest, and the resistance gives its coefficient times the whole displacement as an impulse"
            )
        } else {
            "the impulse of the resistance is its coefficient times the displacement".to_owned()
        };
        let sides = momentum::impulse_momentum(&mass, &before, &impulses, after);
        self.law(&momentum::IMPULSE_MOMENTUM, index, because, sides);
        if endless {
            return;
        }
        let mut terminal = Expr::zero();
        if !steady.is_zero() {
            let name_of = self.in_stage(QuantityKind::TerminalSpeed, "", resisted.index).along(self.letter(*axis));
            terminal = Expr::from(self.symbol(name_of, format!("the terminal velocity of {name}{along}")));
            let because = format!("the forces on {name} besides the resistance do not change");
            self.law(&resistance::TERMINAL, index, because, resistance::terminal(resists, &terminal, steady));
        }
        let because = format!("the resistance grows in proportion to the speed of {name}");
        let velocity = |time: &Expr| resistance::velocity(&before, &terminal, &resistance::left(resists, &mass, time));
        self.law(&resistance::LINEAR, index, because.clone(), (after.clone(), velocity(&lasts)));
        let net = |speed: &Expr| steady.clone() - (*resists).clone() * speed.clone();
        self.shows_separated(lasts.clone(), [&before, after], &|speed| mass.clone() / net(speed));
        let integrand = velocity(&(Expr::from(resisted.clock) - start.clone()));
        let value = resistance::way(&before, &terminal, [&mass, resists, &lasts]);
        let integral = Integral { integrand, variable: resisted.clock, low: start.clone(), high: end.clone() };
        self.integral(&motion::DISPLACEMENT, resisted.index, because, (moved.clone(), value), integral);
    }
}
