//! Mistakes about conical pendulums and about forces that are in balance.

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_quantity::Dimension;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::WrongForm;
use super::geometry::SINE_COSINE;
use super::geometry::TANGENT_INVERTED;
use super::geometry::WHOLE;
use super::geometry::tangent_inverted;
use super::rewrite::factors;
use super::rewrite::one;
use super::rewrite::sine_and_cosine;
use super::rewrite::whole;

/// `v^2 / r = g sin(angle)`, or with the cosine.
pub const TENSION_AS_WEIGHT: Misconception = Misconception {
    id: "tension-taken-as-weight",
    does: "takes the tension of an inclined cord to be as large as the weight",
    ask: "Which component of the tension balances the weight? Is the tension itself as large as the weight?",
    hint: "The tension's vertical component is the weight, so the tension is larger than that; its horizontal component is the weight times the tangent.",
};
/// `v^2 = 2 g L (1 - cos(angle))`.
pub const SWING: Misconception = Misconception {
    id: "energy-of-a-swing",
    does: "lets the body swing down from the angle of the cord, although it moves on a level circle",
    ask: "Does the height of the body change while it goes round?",
    hint: "On a level circle the speed follows from the forces: the sum of them points to the centre of the circle.",
};
/// `L_1 sin(angle_1) = L_2 sin(angle_2)`, or the same speed.
pub const CIRCLE_KEPT: Misconception = Misconception {
    id: "circle-kept",
    does: "keeps the radius or the speed of the circle as the cord changes",
    ask: "Which quantity stays the same while the cord becomes shorter or longer, and why?",
    hint: "No force has a moment about the vertical axis: the angular momentum about it is conserved, and radius and speed both change.",
};
/// `T = W cos(angle)`.
pub const RESOLVED_WEIGHT: Misconception = Misconception {
    id: "weight-resolved-for-force",
    does: "resolves the weight along the cord, although a component of the tension balances the whole weight",
    ask: "Along which line is there no acceleration? What has to balance along that line?",
    hint: "Resolve the tension, which is inclined, and leave the weight, which is vertical, as it is.",
};

/// Wrong forms of a conical pendulum.
pub const CONICAL: &[WrongForm] = &[
    WrongForm { of: &TANGENT_INVERTED, write: tangent_inverted },
    WrongForm { of: &SINE_COSINE, write: exchanged },
    WrongForm {
        of: &TENSION_AS_WEIGHT,
        write: |law| [Function::Sin, Function::Cos].iter().flat_map(|other| tangent(law, *other)).collect(),
    },
    WrongForm { of: &SWING, write: swing },
    WrongForm { of: &CIRCLE_KEPT, write: circle_kept },
];
/// Wrong forms of a balance of forces.
pub const BALANCE: &[WrongForm] = &[
    WrongForm { of: &RESOLVED_WEIGHT, write: resolved_weight },
    WrongForm { of: &SINE_COSINE, write: sine_and_cosine },
    WrongForm { of: &WHOLE, write: whole },
];

/// Sine and cosine exchanged, and the tangent turned over with them.
fn exchanged(law: &Taught<'_>) -> Vec<Wrong> {
    fn within(term: &Expr) -> Expr {
        match term {
            Expr::Apply(Function::Tan, _) => term.clone().powi(-1),
            Expr::Apply(Function::Sin, parts) => Expr::Apply(Function::Cos, parts.clone()),
            Expr::Apply(Function::Cos, parts) => Expr::Apply(Function::Sin, parts.clone()),
            other => other.map_children(within),
        }
    }
    law.both(within)
}

/// Another function in the place of the tangent.
fn tangent(law: &Taught<'_>, other: Function) -> Vec<Wrong> {
    fn within(term: &Expr, other: Function) -> Expr {
        match term {
            Expr::Apply(Function::Tan, parts) => Expr::Apply(other, parts.clone()),
            part => part.map_children(|child| within(child, other)),
        }
    }
    law.both(|side| within(side, other))
}

/// The velocity and the radius of `v^2 / r`.
fn turning(law: &Taught<'_>, side: &Expr) -> Option<[Expr; 2]> {
    let of =
        |dimension: Dimension| side.symbols().into_iter().find(|symbol| law.is(*symbol, dimension)).map(Expr::from);
    Some([of(Dimension::VELOCITY)?, of(Dimension::LENGTH)?])
}

/// `v^2 = 2 g L (1 - cos(angle))`, L being that of `r = L sin(angle)`.
fn swing(law: &Taught<'_>) -> Vec<Wrong> {
    let (Some([speed, radius]), Some(gravity)) = (turning(law, &law.sides.0), law.symbols.find("g")) else {
        return Vec::new();
    };
    let sine = |factor: &Expr| match factor {
        Expr::Apply(Function::Sin, parts) => Some(parts.clone()),
        _ => None,
    };
    let lengths = law.beside("components").filter(|(side, _)| *side == radius).filter_map(|(_, inclined)| {
        let parts = factors(inclined);
        let angle = parts.iter().find_map(sine)?;
        let length = Expr::product(parts.iter().filter(|part| sine(part).is_none()).cloned());
        Some(length * (Expr::one() - Expr::Apply(Function::Cos, angle)))
    });
    let fallen = lengths.map(|height| Expr::integer(2) * Expr::from(gravity) * height);
    fallen.flat_map(|square| one((speed.clone().powi(2), square))).collect()
}

/// The radius, or the speed, of another instant on this circle; H^2 stands for the circle in the law.
fn circle_kept(law: &Taught<'_>) -> Vec<Wrong> {
    let parts = factors(&law.sides.1);
    let angle = parts.iter().find_map(|factor| match factor {
        Expr::Apply(Function::Tan, parts) => parts.first().cloned(),
        _ => None,
    });
    let length = parts.iter().find_map(|factor| match factor {
        Expr::Power(pair) if law.has(&pair.0, Dimension::LENGTH) => Some(pair.0.clone()),
        _ => None,
    });
    let (Some(angle), Some(length), Some(gravity)) = (angle, length, law.symbols.find("g")) else { return Vec::new() };
    let mut others = law.beside("conical-pendulum").filter(|sides| *sides != law.sides);
    let Some([speed, radius]) = others.find_map(|(side, _)| turning(law, side)) else { return Vec::new() };
    let radius_here = length * Expr::apply(Function::Sin, angle.clone());
    let square = Expr::product([gravity.into(), radius_here.clone(), Expr::apply(Function::Tan, angle)]);
    let kept = |sides| Wrong { equations: vec![sides], without: &["conservation-of-angular-momentum"] };
    vec![kept((radius, radius_here)), kept((speed.powi(2), square))]
}

/// `F = W cos(angle)` for `F cos(angle) = W`.
fn resolved_weight(law: &Taught<'_>) -> Vec<Wrong> {
    let is_share = |factor: &Expr| matches!(factor, Expr::Apply(Function::Sin | Function::Cos, _));
    let parts = factors(&law.sides.0);
    let (shares, force): (Vec<Expr>, Vec<Expr>) = parts.into_iter().partition(is_share);
    if shares.is_empty() || force.is_empty() {
        return Vec::new();
    }
    one((Expr::product(force), law.right() * Expr::product(shares)))
}
