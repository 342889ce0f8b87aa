//! Mistakes about circles, springs and friction as single laws, and about the whole of a velocity for one of its components.

use momentous_expr::Expr;
use momentous_expr::Function;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::WrongForm;
use super::friction::FRICTION_COEFFICIENT;
use super::friction::friction_whole;
use super::geometry::COMPONENT_FOR_MAGNITUDE;
use super::rewrite::one;

/// `v / r` for `v^2 / r`.
pub const SPEED_NOT_SQUARED: Misconception = Misconception {
    id: "speed-on-a-circle-not-squared",
    does: "does not square the speed in the acceleration towards the centre",
    ask: "Which units have speed over radius, and which has an acceleration?",
    hint: "The acceleration towards the centre is the square of the speed over the radius.",
};
/// `k s / 2`.
pub const HALF_FORCE: Misconception = Misconception {
    id: "mean-force-of-a-spring",
    does: "takes the mean force of a spring on its way for the force at the end",
    ask: "Is the force at this deformation asked, or its average on the way there?",
    hint: "The half belongs to the energy: the force of a spring is its stiffness times its deformation.",
};
/// `h = s tan(angle)`.
pub const TANGENT_FOR_SINE: Misconception = Misconception {
    id: "tangent-for-sine-of-a-slope",
    does: "uses the tangent of a slope with the distance along it",
    ask: "Is the distance counted along the slope, or along the level?",
    hint: "The distance along the slope is the longest side of the triangle: the height is its sine times that.",
};

/// Wrong forms of an acceleration towards the centre, and of the force that gives it.
pub const TURN: &[WrongForm] = &[WrongForm { of: &SPEED_NOT_SQUARED, write: speed_not_squared }];
/// Wrong forms of the force of a spring.
pub const SPRING_FORCE: &[WrongForm] =
    &[WrongForm { of: &HALF_FORCE, write: |law| one((law.left(), Expr::ratio(1, 2) * law.right())) }];
/// Wrong forms of friction.
pub const FRICTION: &[WrongForm] = &[WrongForm { of: &FRICTION_COEFFICIENT, write: friction_whole }];
/// Wrong forms of the height of a slope.
pub const SLOPE: &[WrongForm] = &[WrongForm { of: &TANGENT_FOR_SINE, write: tangent_for_sine }];

/// Every squared velocity to the first power.
pub(super) fn speed_not_squared(law: &Taught<'_>) -> Vec<Wrong> {
    fn within(law: &Taught<'_>, term: &Expr) -> Expr {
        match term {
            Expr::Power(pair) if pair.1 == Expr::integer(2) && law.is_velocity(&pair.0) => pair.0.clone(),
            other => other.map_children(|part| within(law, part)),
        }
    }
    law.both(|side| within(law, side))
}

fn tangent_for_sine(law: &Taught<'_>) -> Vec<Wrong> {
    fn within(term: &Expr) -> Expr {
        match term {
            Expr::Apply(Function::Sin, parts) => Expr::Apply(Function::Tan, parts.clone()),
            other => other.map_children(within),
        }
    }
    law.both(within)
}

/// The magnitude of a velocity for the component that belongs in the law: on one side, and on both.
pub(super) fn whole_for_component(law: &Taught<'_>) -> Vec<Wrong> {
    let whole = |side: &Expr| {
        side.substitute(&|symbol| {
            let component = Expr::from(symbol);
            let has_leg = |root: &Expr| law.is_velocity(&component) && root.contains(symbol);
            law.beside("magnitude").find(|(_, root)| has_leg(root)).map(|(magnitude, _)| magnitude.clone())
        })
    };
    let [left, right] = [whole(&law.sides.0), whole(&law.sides.1)];
    let ways = [(left.clone(), right.clone()), (left, law.right()), (law.left(), right)];
    let mut ways: Vec<_> = ways.into_iter().filter(|sides| sides != law.sides).collect();
    ways.dedup();
    ways.into_iter().map(Wrong::from).collect()
}

/// The row of it, for the laws of one component.
pub(super) const WHOLE_FOR_COMPONENT: WrongForm =
    WrongForm { of: &COMPONENT_FOR_MAGNITUDE, write: whole_for_component };
