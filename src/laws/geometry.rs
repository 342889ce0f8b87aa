//! Components, magnitudes and directions.

use momentous_expr::Expr;

use super::Law;
use super::Sides;
use super::wrong;

/// Components of a vector of known magnitude and direction.
pub const COMPONENTS: Law = Law {
    id: "components",
    name: "the definition of sine and cosine",
    statement: "A vector's component along an axis is its magnitude times the cosine of the angle between them; perpendicular to the axis, times the sine.",
    signs: "Angles are measured counter-clockwise from the axis.",
    when: "Always.",
    source: "Trigonometry.",
    wrong: wrong::geometry::COMPONENTS,
};

/// The change to axes along and across a line.
pub const ROTATION: Law = Law {
    id: "turned-axes",
    name: "projection onto the turned axes",
    statement: "Along an axis turned by an angle, a component is the sum of the old components times the cosine and the sine of that angle.",
    signs: "n points along the line, t at 90° counter-clockwise from it.",
    when: "Always.",
    source: "Trigonometry.",
    wrong: wrong::geometry::COMPONENTS,
};

/// The magnitude from the components.
pub const MAGNITUDE: Law = Law {
    id: "magnitude",
    name: "Pythagoras' theorem",
    statement: "The square of a vector's magnitude is the sum of the squares of its components.",
    signs: "A magnitude is never negative.",
    when: "Always, along perpendicular axes.",
    source: "Pythagoras' theorem.",
    wrong: wrong::geometry::MAGNITUDE,
};

/// The speed on a line.
pub const SPEED: Law = Law {
    id: "speed",
    name: "the definition of speed",
    statement: "A speed is the magnitude of a velocity: along a line, the absolute value of its one component.",
    signs: "A speed is never negative.",
    when: "Always.",
    source: "Definition of speed.",
    wrong: &[],
};

/// The direction from the components.
pub const DIRECTION: Law = Law {
    id: "direction",
    name: "the definition of the tangent",
    statement: "The tangent of the angle between a vector and an axis is its component across the axis over that along it.",
    signs: "Angles are measured counter-clockwise; the signs of both components give the quadrant.",
    when: "Always, along perpendicular axes.",
    source: "Trigonometry.",
    wrong: wrong::geometry::DIRECTION,
};

/// A direction counted from another axis, or the other way round.
pub const COUNTED: Law = Law {
    id: "counted-direction",
    name: "the conversion of an angle",
    statement: "An angle measured from another axis is smaller by the angle of that axis; measured clockwise it has the opposite sign.",
    signs: "Angles are measured counter-clockwise unless stated otherwise.",
    when: "Always.",
    source: "The sense in which angles are measured.",
    wrong: &[],
};

/// The angle between two vectors.
pub const BETWEEN: Law = Law {
    id: "angle-between",
    name: "the scalar product",
    statement: "The cosine of the angle between two vectors is their scalar product over the product of their magnitudes.",
    signs: "The angle lies between 0 and 180 degrees.",
    when: "Always, along perpendicular axes.",
    source: "Definition of the scalar product.",
    wrong: &[],
};

/// Speed on a circle.
pub const ARC: Law = Law {
    id: "speed-on-a-circle",
    name: "the kinematics of motion on a circle",
    statement: "The velocity of a point on a circle is perpendicular to the radius, and the radius times the angular velocity.",
    signs: "Counter-clockwise is positive.",
    when: "The distance from the centre does not change at that instant.",
    source: "The length of an arc.",
    wrong: wrong::geometry::ARC,
};

/// Acceleration on a circle.
pub const TURNING: Law = Law {
    id: "acceleration-on-a-circle",
    name: "the kinematics of motion on a circle",
    statement: "The acceleration of a point on a circle towards the centre is the square of its speed over the radius.",
    signs: "Positive towards the centre.",
    when: "The point moves at right angles to the radius at that instant.",
    source: "The change in the direction of the velocity.",
    wrong: wrong::circle::TURN,
};

/// Height on a circle.
pub const HEIGHT_ON_CIRCLE: Law = Law {
    id: "height-on-a-circle",
    name: "the definition of the cosine",
    statement: "The lower end of a cord lies below its fixed end by the length of the cord times the cosine of its angle with the vertical.",
    signs: "Heights and lengths are positive.",
    when: "The cord is straight.",
    source: "Trigonometry.",
    wrong: wrong::geometry::HEIGHT_ON_CIRCLE,
};

/// Height of a slope.
pub const HEIGHT_OF_SLOPE: Law = Law {
    id: "height-of-a-slope",
    name: "the definition of the sine",
    statement: "The difference in height along a slope is the distance along it times the sine of the slope's angle.",
    signs: "Heights and lengths are positive.",
    when: "The slope is straight.",
    source: "Trigonometry.",
    wrong: wrong::circle::SLOPE,
};

/// Height inside a cone or a bowl.
pub const HEIGHT_IN_BOWL: Law = Law {
    id: "height-in-a-bowl",
    name: "the shape of the wall",
    statement: "In a cone the height above the apex is the distance from the axis over the tangent of the angle between axis and wall; in a sphere the squares of the distance from the axis and of the depth below the centre add up to the square of the radius.",
    signs: "Heights and lengths are positive.",
    when: "The axis is vertical, and the position lies below the centre of the sphere.",
    source: "Trigonometry, and Pythagoras' theorem.",
    wrong: wrong::geometry::HEIGHT_IN_BOWL,
};

/// A condition begins to hold at its boundary.
pub const BOUNDARY: Law = Law {
    id: "boundary-of-a-condition",
    name: "the condition of the question",
    statement: "A condition begins or ceases to hold where its two sides are equal.",
    signs: "As for the two sides.",
    when: "Both sides change continuously with the quantity whose range is asked for.",
    source: "The question.",
    wrong: &[],
};

/// An expression in a question stands for a quantity.
pub const ASKED: Law = Law {
    id: "expression-asked",
    name: "the definition in the question",
    statement: "A question may give a name to an expression of several quantities.",
    signs: "As for the quantities in it.",
    when: "Always, by definition.",
    source: "The question.",
    wrong: &[],
};

/// Given by the author.
pub const RELATION: Law = Law {
    id: "stated-relation",
    name: "a relation stated in the problem",
    statement: "An equation that the problem itself states.",
    signs: "As stated.",
    when: "As stated.",
    source: "The problem.",
    wrong: wrong::relation::STATED,
};

/// The laws of this chapter.
pub const LAWS: &[&Law] = &[
    &COMPONENTS,
    &ROTATION,
    &MAGNITUDE,
    &SPEED,
    &DIRECTION,
    &COUNTED,
    &BETWEEN,
    &ARC,
    &TURNING,
    &HEIGHT_ON_CIRCLE,
    &HEIGHT_OF_SLOPE,
    &HEIGHT_IN_BOWL,
    &BOUNDARY,
    &ASKED,
    &RELATION,
];

/// The two components of a vector of that magnitude, `angle` being counted from the first axis.
#[must_use]
pub fn components(magnitude: &Expr, angle: &Expr, along: &Expr, across: &Expr) -> [Sides; 2] {
    [
        (along.clone(), magnitude.clone() * angle.clone().cos()),
        (across.clone(), magnitude.clone() * angle.clone().sin()),
    ]
}

/// Components along and across a line from those of `(x, y)`; the cosine and the sine of its direction come first.
#[must_use]
pub fn turned([cos, sin]: [&Expr; 2], x: &Expr, y: &Expr) -> [Expr; 2] {
    [x.clone() * cos.clone() + y.clone() * sin.clone(), y.clone() * cos.clone() - x.clone() * sin.clone()]
}

/// Components `(x, y)` from those along and across a line.
#[must_use]
pub fn turned_back([cos, sin]: [&Expr; 2], along: &Expr, across: &Expr) -> [Expr; 2] {
    [
        along.clone() * cos.clone() - across.clone() * sin.clone(),
        along.clone() * sin.clone() + across.clone() * cos.clone(),
    ]
}
