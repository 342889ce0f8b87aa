//! Mistakes outside the laws: a given taken in another unit, a slip in writing the answer down.

use super::Misconception;
use super::geometry::OTHER_AXIS;
use super::momentum::WEIGHT_AS_MASS;

/// Prefixes and multiples overlooked.
pub const GRAMS: Misconception = Misconception {
    id: "grams-as-kilograms",
    does: "uses grams where kilograms belong",
    ask: "In which unit is the mass given, and in which must you use it?",
    hint: "Convert every mass to kilograms before you calculate.",
};
/// Tonnes as kilograms.
pub const TONNES: Misconception = Misconception {
    id: "tonnes-as-kilograms",
    does: "uses tonnes where kilograms belong",
    ask: "In which unit is the mass given, and in which must you use it?",
    hint: "Convert every mass to kilograms before you calculate.",
};
/// Kilometres per hour as metres per second.
pub const KILOMETRES_PER_HOUR: Misconception = Misconception {
    id: "kilometres-per-hour-as-metres-per-second",
    does: "uses kilometres per hour where metres per second belong",
    ask: "In which unit is the speed given, and in which must you use it?",
    hint: "Convert every speed to metres per second before you calculate.",
};
/// Degrees as radians.
pub const DEGREES: Misconception = Misconception {
    id: "degrees-as-radians",
    does: "calculates sines and cosines of degrees as if they were radians",
    ask: "Does your calculator work in degrees or in radians?",
    hint: "Calculate the sine of a right angle with it: it must be one.",
};
/// Lengths in a multiple of the metre.
pub const LENGTHS: Misconception = Misconception {
    id: "lengths-not-in-metres",
    does: "uses centimetres, millimetres or kilometres where metres belong",
    ask: "In which unit is the length given, and in which must you use it?",
    hint: "Convert every length to metres before you calculate.",
};
/// Areas in a multiple of the square metre.
pub const AREAS: Misconception = Misconception {
    id: "areas-converted-as-lengths",
    does: "converts an area with the factor of a length",
    ask: "How many square centimetres fill a square metre?",
    hint: "Both sides of a square are converted: the factor of the length is squared.",
};
/// Times in a multiple of the second.
pub const TIMES: Misconception = Misconception {
    id: "times-not-in-seconds",
    does: "uses milliseconds or minutes where seconds belong",
    ask: "In which unit is the time given, and in which must you use it?",
    hint: "Convert every time to seconds before you calculate.",
};
/// Forces in a multiple of the newton.
pub const FORCES: Misconception = Misconception {
    id: "forces-not-in-newtons",
    does: "uses kilonewtons where newtons belong",
    ask: "In which unit is the force or its moment given, and in which must you use it?",
    hint: "Convert every force to newtons before you calculate.",
};
/// Ounces as pounds.
pub const OUNCES: Misconception = Misconception {
    id: "ounces-as-pounds",
    does: "uses ounces where pounds belong",
    ask: "In which unit is the weight given, and in which must you use it?",
    hint: "Convert every weight to pounds before you calculate.",
};
/// The direction of an answer lost.
pub const DIRECTION: Misconception = Misconception {
    id: "direction-reversed",
    does: "gives the answer the opposite sign",
    ask: "Which direction does your sign mean, and which direction is positive here?",
    hint: "Draw the axis and the arrow of your answer next to each other.",
};
/// `180 deg - x`.
pub const SUPPLEMENT: Misconception = Misconception {
    id: "angle-supplement",
    does: "measures the angle from the other end of the line",
    ask: "From which end of the axis is the angle measured?",
    hint: "Draw the direction and the axis with its arrow, then measure the angle between the arrows.",
};
/// `180 deg - x`, of two arrows.
pub const BETWEEN: Misconception = Misconception {
    id: "angle-between-supplement",
    does: "measures the angle between one arrow and the other turned round",
    ask: "Do both arrows start from the point at which the angle between them is measured?",
    hint: "Draw both arrows from one point: the angle between them is the one that they enclose there.",
};
/// Radians in the place of degrees.
pub const RADIANS: Misconception = Misconception {
    id: "radians-without-a-word",
    does: "gives an angle in radians without saying so",
    ask: "Is your angle in degrees, or in radians?",
    hint: "Write the unit behind the number; where degrees are asked, convert what a calculator shows in radians.",
};
/// One more or less.
pub const COUNT: Misconception = Misconception {
    id: "count-off-by-one",
    does: "counts one too many or one too few",
    ask: "Does the condition hold for your number, and for the one before it?",
    hint: "The number sought is the first for which the condition holds.",
};

/// A given in one unit taken as if it stood in another.
#[derive(Debug)]
pub struct Misreading {
    /// The mistake.
    pub of: &'static Misconception,
    /// The unit in which the value is given.
    pub given: &'static str,
    /// The unit in which it is taken.
    pub taken: &'static str,
    /// Whether one of several such givens may be taken so by itself. One of several masses in tonnes that is taken in kilograms
    /// is as good as left out, which is the likelier mistake.
    pub alone: bool,
}

/// Every misreading of a unit.
pub const MISREADINGS: &[Misreading] = &[
    Misreading { of: &GRAMS, given: "g", taken: "kg", alone: true },
    Misreading { of: &TONNES, given: "t", taken: "kg", alone: false },
    Misreading { of: &KILOMETRES_PER_HOUR, given: "km/h", taken: "m/s", alone: true },
    Misreading { of: &DEGREES, given: "deg", taken: "rad", alone: true },
    Misreading { of: &LENGTHS, given: "cm", taken: "m", alone: true },
    Misreading { of: &LENGTHS, given: "mm", taken: "m", alone: true },
    Misreading { of: &LENGTHS, given: "km", taken: "m", alone: true },
    Misreading { of: &AREAS, given: "cm^2", taken: "m cm", alone: true },
    Misreading { of: &AREAS, given: "mm^2", taken: "m mm", alone: true },
    Misreading { of: &TIMES, given: "ms", taken: "s", alone: true },
    Misreading { of: &TIMES, given: "min", taken: "s", alone: true },
    Misreading { of: &FORCES, given: "kN", taken: "N", alone: true },
    Misreading { of: &FORCES, given: "kN m", taken: "N m", alone: true },
    Misreading { of: &OUNCES, given: "oz", taken: "lb", alone: true },
    Misreading { of: &WEIGHT_AS_MASS, given: "lbm", taken: "slug", alone: true },
];

/// A slip in writing an answer down.
#[derive(Debug)]
pub struct Slip {
    /// The mistake.
    pub of: &'static Misconception,
    /// Which answers it can happen to.
    pub to: SlipOf,
    /// What is written for a value, in radians where it is an angle.
    pub written: fn(f64) -> f64,
}

/// The answers to which a slip can happen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SlipOf {
    /// To every signed component.
    Signed,
    /// To every angle in the plane but that between two arrows.
    Angle,
    /// To the angle between two arrows.
    Between,
    /// To every number that is counted.
    Count,
    /// To every other number but a direction.
    Size,
}

/// Every slip.
pub const SLIPS: &[Slip] = &[
    Slip { of: &DIRECTION, to: SlipOf::Signed, written: |value| -value },
    Slip { of: &SUPPLEMENT, to: SlipOf::Angle, written: |value| std::f64::consts::PI - value },
    Slip { of: &OTHER_AXIS, to: SlipOf::Angle, written: |value| std::f64::consts::FRAC_PI_2 - value },
    Slip { of: &BETWEEN, to: SlipOf::Between, written: |value| std::f64::consts::PI - value },
    Slip { of: &RADIANS, to: SlipOf::Angle, written: f64::to_radians },
    Slip { of: &RADIANS, to: SlipOf::Between, written: f64::to_radians },
    Slip { of: &COUNT, to: SlipOf::Count, written: |value| value + 1.0 },
    Slip { of: &COUNT, to: SlipOf::Count, written: |value| value - 1.0 },
];
