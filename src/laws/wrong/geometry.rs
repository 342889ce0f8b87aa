//! Mistakes about components, magnitudes and directions.

use std::sync::Arc;

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Symbol;
use momentous_quantity::Dimension;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::WrongForm;
use super::rewrite::factors;
use super::rewrite::one;
use super::rewrite::sine_and_cosine;
use super::rewrite::terms;
use super::rewrite::whole;

/// Sine and cosine exchanged.
pub const SINE_COSINE: Misconception = Misconception {
    id: "sine-cosine-exchanged",
    does: "exchanges sine and cosine",
    ask: "From which line is the angle measured? Which component grows as the angle becomes small?",
    hint: "Try the limit of a very small angle: the component along the line from which it is measured must be nearly the whole.",
};
/// The whole for a component.
pub const WHOLE: Misconception = Misconception {
    id: "whole-for-component",
    does: "uses a whole vector where one of its components belongs",
    ask: "Does the whole vector lie along this axis, or only a component of it?",
    hint: "Draw the vector and the axis: the component along the axis is smaller than the vector.",
};
/// A part for the whole, or the whole for a part.
pub const COMPONENT_FOR_MAGNITUDE: Misconception = Misconception {
    id: "component-for-magnitude",
    does: "gives one component for another, or for the whole, or the whole for a component",
    ask: "Is the magnitude asked, or a component, and which one? What have you written down?",
    hint: "Draw the arrow with its components, and mark the one that is asked.",
};
/// Sizes of momenta for an arrow between them.
pub const SIZES: Misconception = Misconception {
    id: "sizes-for-vectors",
    does: "adds or subtracts the sizes of two vectors that do not lie along one line",
    ask: "Do both velocities lie along one line? How are arrows of different directions subtracted?",
    hint: "Subtract component by component, and only then find the magnitude.",
};
/// Magnitudes of perpendicular parts added.
pub const ADDED: Misconception = Misconception {
    id: "magnitudes-added",
    does: "adds perpendicular components as if they lay along one line",
    ask: "What is the angle between the two components? How long is the arrow that they form?",
    hint: "Perpendicular components are the legs of a right-angled triangle.",
};
/// Squares of perpendicular parts subtracted.
pub const SQUARES_SUBTRACTED: Misconception = Misconception {
    id: "squares-subtracted",
    does: "subtracts the squares of perpendicular components instead of adding them",
    ask: "Which side of the right-angled triangle is asked: the longest, or a leg?",
    hint: "The square of the longest side is the sum of the squares of both legs.",
};
/// The root of the sum of squares forgotten.
pub const MAGNITUDE_ROOT: Misconception = Misconception {
    id: "root-of-magnitude-forgotten",
    does: "gives the sum of the squares of the components without its root",
    ask: "Which unit has your sum? What is left to do with it?",
    hint: "The sum of the squares is the square of the magnitude.",
};
/// The angle to the other axis.
pub const OTHER_AXIS: Misconception = Misconception {
    id: "angle-from-other-axis",
    does: "measures the angle from the other axis",
    ask: "From which axis is the angle to be measured? Which component is in the numerator of the tangent?",
    hint: "The tangent of an angle is the component perpendicular to its axis over that along it.",
};
/// Quadrant lost.
pub const QUADRANT: Misconception = Misconception {
    id: "quadrant-lost",
    does: "leaves the signs of the components out of the direction",
    ask: "Draw the components with their signs. In which quadrant does the arrow lie?",
    hint: "A calculator's inverse tangent gives angles in only two of the four quadrants.",
};
/// The angle to a line of impact taken for that to the axis.
pub const LINE_FORGOTTEN: Misconception = Misconception {
    id: "line-of-impact-as-axis",
    does: "gives the angle to the line of impact instead of that to the axis",
    ask: "From which line is your angle measured, and from which one should it be?",
    hint: "The components are along and across the line of impact, which is itself inclined.",
};
/// `omega = v r`.
pub const RADIUS: Misconception = Misconception {
    id: "radius-multiplied",
    does: "multiplies by the radius where it divides, or the reverse",
    ask: "Two points on one arm: which of them is the faster, the inner or the outer one?",
    hint: "Check the units: an angular velocity contains no length.",
};

/// The radius of another instant.
pub const OTHER_RADIUS: Misconception = Misconception {
    id: "wrong-radius",
    does: "uses the radius of another body or another instant",
    ask: "How far from the axis is the body at this instant?",
    hint: "The radius, the speed and the angular velocity in one equation belong to the same instant.",
};
/// The tangent turned over.
pub const TANGENT_INVERTED: Misconception = Misconception {
    id: "tangent-inverted",
    does: "divides by a tangent where it multiplies, or the reverse",
    ask: "From which line is the angle measured, and which side lies opposite to it?",
    hint: "Try a small angle: which of the two lengths is then much smaller?",
};

/// `h = L cos(angle)`.
pub const FROM_FIXED_END: Misconception = Misconception {
    id: "height-from-fixed-end",
    does: "takes the distance below the fixed end or the centre for the height above the lowest point",
    ask: "From which point is the height measured, and where does the length times the cosine begin?",
    hint: "Try an angle of zero: the body is then at its lowest point, and the height must be zero.",
};
/// The whole length for the height.
pub const WHOLE_RADIUS: Misconception = Misconception {
    id: "whole-radius-as-height",
    does: "takes the whole radius, or the whole length of the cord, for the height",
    ask: "Does the body move from the height of the centre, or of the fixed end? What does the given angle say?",
    hint: "Draw the start and the lowest point: the height is the length less what the cosine of the angle leaves of it.",
};
/// What can be got wrong in any law in which a sine or a cosine stands.
pub const ANYWHERE: &[WrongForm] =
    &[WrongForm { of: &SINE_COSINE, write: sine_and_cosine }, WrongForm { of: &WHOLE, write: whole }];

/// Wrong forms of a height on a circle.
pub const HEIGHT_ON_CIRCLE: &[WrongForm] = &[
    WrongForm { of: &FROM_FIXED_END, write: from_fixed_end },
    WrongForm { of: &WHOLE_RADIUS, write: whole_radius },
    WrongForm { of: &SINE_COSINE, write: height_by_sine },
];
/// Wrong forms of a height in a bowl.
pub const HEIGHT_IN_BOWL: &[WrongForm] = &[WrongForm { of: &TANGENT_INVERTED, write: tangent_inverted }];
/// Wrong forms of components.
pub const COMPONENTS: &[WrongForm] = &[
    WrongForm { of: &SINE_COSINE, write: sine_and_cosine },
    WrongForm { of: &WHOLE, write: whole },
    WrongForm { of: &ADDED, write: |law| from_legs_in_components(law, sum_of_legs) },
    WrongForm { of: &SQUARES_SUBTRACTED, write: |law| from_legs_in_components(law, difference_of_squares) },
    WrongForm { of: &MAGNITUDE_ROOT, write: |law| from_legs_in_components(law, sum_of_squares) },
];
/// Wrong forms of a magnitude.
pub const MAGNITUDE: &[WrongForm] = &[
    WrongForm { of: &ADDED, write: |law| from_legs(law, sum_of_legs) },
    WrongForm { of: &SQUARES_SUBTRACTED, write: |law| from_legs(law, difference_of_squares) },
    WrongForm { of: &MAGNITUDE_ROOT, write: |law| from_legs(law, sum_of_squares) },
    WrongForm { of: &COMPONENT_FOR_MAGNITUDE, write: one_component },
    WrongForm { of: &SIZES, write: sizes },
];
/// Wrong forms of a direction.
pub const DIRECTION: &[WrongForm] = &[
    WrongForm { of: &OTHER_AXIS, write: other_axis },
    WrongForm { of: &QUADRANT, write: quadrant },
    WrongForm { of: &LINE_FORGOTTEN, write: line_forgotten },
];
/// Wrong forms of speed on a circle.
pub const ARC: &[WrongForm] = &[
    WrongForm { of: &RADIUS, write: radius },
    WrongForm { of: &OTHER_RADIUS, write: other_radius },
    WrongForm { of: &super::inertia::ARM_NOT_SQUARED, write: super::inertia::speed_without_arm },
];

/// `h = L cos(angle)` for `h = L - L cos(angle)`.
fn from_fixed_end(law: &Taught<'_>) -> Vec<Wrong> {
    match &terms(&law.sides.1)[..] {
        [Expr::Symbol(_), raised] => one((law.left(), -raised.clone())),
        _ => Vec::new(),
    }
}

/// `h = L`.
fn whole_radius(law: &Taught<'_>) -> Vec<Wrong> {
    match &terms(&law.sides.1)[..] {
        [Expr::Symbol(length), _] => one((law.left(), (*length).into())),
        _ => Vec::new(),
    }
}

/// `h = L - L sin(angle)` and `h = L sin(angle)`.
fn height_by_sine(law: &Taught<'_>) -> Vec<Wrong> {
    let turned = sine_and_cosine(law);
    let bare = |wrong: &Wrong| {
        let (left, right) = wrong.equations.first()?;
        let raised = terms(right).into_iter().find(Expr::begins_with_minus)?;
        Some(Wrong::from((left.clone(), -raised)))
    };
    let alone: Vec<Wrong> = turned.iter().filter_map(bare).collect();
    [turned, alone].concat()
}

/// The legs of a root of a sum of squares.
fn legs(root: &Expr) -> Option<Vec<Expr>> {
    let Expr::Power(pair) = root else { return None };
    let leg = |term: Expr| match term {
        Expr::Power(square) if square.1 == Expr::integer(2) => Some(square.0.clone()),
        _ => None,
    };
    terms(&pair.0).into_iter().map(leg).collect()
}

fn size(leg: &Expr) -> Expr {
    Expr::apply(Function::Abs, leg.clone())
}

fn sum_of_legs(legs: &[Expr]) -> Expr {
    Expr::sum(legs.iter().map(size))
}

fn sum_of_squares(legs: &[Expr]) -> Expr {
    Expr::sum(legs.iter().map(|leg| leg.clone().powi(2)))
}

/// The root of the first square without the others, or of the others without the first.
fn difference_of_squares(legs: &[Expr]) -> Expr {
    let squares = legs.iter().enumerate().map(|(place, leg)| {
        let square = leg.clone().powi(2);
        if place == 0 { square } else { -square }
    });
    size(&Expr::sum(squares)).sqrt()
}

/// Something else in the place of the root of the squares.
fn from_legs(law: &Taught<'_>, wrong: fn(&[Expr]) -> Expr) -> Vec<Wrong> {
    legs(&law.sides.1).map(|legs| Wrong::from((law.left(), wrong(&legs)))).into_iter().collect()
}

/// The same where the magnitude is found from components and a direction.
fn from_legs_in_components(law: &Taught<'_>, wrong: fn(&[Expr]) -> Expr) -> Vec<Wrong> {
    let factors = factors(&law.sides.1);
    let magnitudes = law.beside("magnitude").filter(|(magnitude, _)| factors.contains(magnitude));
    let roots = magnitudes.filter_map(|(magnitude, root)| Some((magnitude.clone(), legs(root)?)));
    roots
        .filter(|(_, legs)| legs.contains(&law.sides.0))
        .map(|(magnitude, legs)| Wrong::from((magnitude, wrong(&legs))))
        .collect()
}

/// One component in the place of the magnitude.
fn one_component(law: &Taught<'_>) -> Vec<Wrong> {
    let Some(legs) = legs(&law.sides.1) else { return Vec::new() };
    legs.iter().map(|leg| Wrong::from((law.left(), size(leg)))).collect()
}

/// `J = m |v_2| - m |v_1|`, or the sum of both.
fn sizes(law: &Taught<'_>) -> Vec<Wrong> {
    let balance = |leg: &Expr| law.beside("impulse-momentum").find(|(start, _)| terms(start).contains(leg));
    let ends = |leg: &Expr| {
        let (start, after) = balance(leg)?;
        let before = terms(start).into_iter().filter(|term| term != leg);
        Some([Expr::sum(before), after.clone()])
    };
    let Some(legs) = legs(&law.sides.1) else { return Vec::new() };
    let Some(ends) = legs.iter().map(ends).collect::<Option<Vec<_>>>() else { return Vec::new() };
    let length = |end: usize| Expr::sum(ends.iter().map(|point| point[end].clone().powi(2))).sqrt();
    let [before, after] = [length(0), length(1)];
    vec![Wrong::from((law.left(), size(&(after.clone() - before.clone())))), Wrong::from((law.left(), after + before))]
}

/// The right side with what stands in the two places of its direction rewritten.
fn pointed(law: &Taught<'_>, change: &dyn Fn(&Expr, &Expr) -> [Expr; 2]) -> Vec<Wrong> {
    fn within(term: &Expr, change: &dyn Fn(&Expr, &Expr) -> [Expr; 2]) -> Expr {
        match term {
            Expr::Apply(Function::Atan2, parts) => match &parts[..] {
                [y, x] => Expr::Apply(Function::Atan2, Arc::new(change(y, x))),
                _ => term.clone(),
            },
            other => other.map_children(|part| within(part, change)),
        }
    }
    law.both(|side| within(side, change))
}

/// Every tangent turned over.
pub(super) fn tangent_inverted(law: &Taught<'_>) -> Vec<Wrong> {
    fn inverted(term: &Expr) -> Expr {
        match term {
            Expr::Apply(Function::Tan, _) => term.clone().powi(-1),
            other => other.map_children(inverted),
        }
    }
    law.both(inverted)
}

fn other_axis(law: &Taught<'_>) -> Vec<Wrong> {
    pointed(law, &|y, x| [x.clone(), y.clone()])
}

fn quadrant(law: &Taught<'_>) -> Vec<Wrong> {
    let size = |term: &Expr| Expr::apply(Function::Abs, term.clone());
    pointed(law, &|y, x| [size(y), size(x)])
}

fn line_forgotten(law: &Taught<'_>) -> Vec<Wrong> {
    let points = |term: &&Expr| matches!(term, Expr::Apply(Function::Atan2, _));
    match &law.sides.1 {
        Expr::Sum(parts) => parts.iter().filter(points).map(|term| Wrong::from((law.left(), term.clone()))).collect(),
        _ => Vec::new(),
    }
}

/// `v_2 = r_1 omega_2`.
fn other_radius(law: &Taught<'_>) -> Vec<Wrong> {
    let radii = law.quantities(Dimension::LENGTH);
    let is_other = |symbol: &Symbol| law.is(*symbol, Dimension::LENGTH) && !radii.contains(symbol);
    let others = law.known.iter().copied().filter(is_other);
    others.flat_map(|other| law.replaced(&|symbol| radii.contains(&symbol).then(|| other.into()))).collect()
}

/// `v r = omega`.
fn radius(law: &Taught<'_>) -> Vec<Wrong> {
    let parts = factors(&law.sides.1);
    let (arms, others): (Vec<Expr>, Vec<Expr>) = parts.into_iter().partition(|part| law.has(part, Dimension::LENGTH));
    if arms.is_empty() { Vec::new() } else { one((law.left() * Expr::product(arms), Expr::product(others))) }
}
