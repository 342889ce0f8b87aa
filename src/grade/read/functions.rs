//! The functions that may stand in an answer. There is no `log`, which has two meanings.

use std::f64::consts::PI;

use super::super::number::Number;

/// A function of one argument.
#[derive(Clone, Copy, Debug)]
pub(super) enum Function {
    SquareRoot,
    Absolute,
    /// A function of an angle.
    Angle(fn(f64) -> f64),
    /// An angle, in radians.
    Arc(fn(f64) -> f64),
    Other(fn(f64) -> f64),
}

const NAMES: &[(&str, Function)] = &[
    ("sqrt", Function::SquareRoot),
    ("abs", Function::Absolute),
    ("cbrt", Function::Other(libm::cbrt)),
    ("exp", Function::Other(libm::exp)),
    ("ln", Function::Other(libm::log)),
    ("lg", Function::Other(libm::log10)),
    ("log10", Function::Other(libm::log10)),
    ("asin", Function::Arc(libm::asin)),
    ("arcsin", Function::Arc(libm::asin)),
    ("acos", Function::Arc(libm::acos)),
    ("arccos", Function::Arc(libm::acos)),
    ("atan", Function::Arc(libm::atan)),
    ("arctan", Function::Arc(libm::atan)),
    ("sin", Function::Angle(libm::sin)),
    ("cos", Function::Angle(libm::cos)),
    ("tan", Function::Angle(libm::tan)),
];

const DEGREES: &[&str] = &["°", "º", "˚", "deg", "degs", "degree", "degrees"];
const RADIANS: &[&str] = &["rad", "rads", "radian", "radians"];

/// The function of that name.
pub(super) fn find(name: &str) -> Option<Function> {
    NAMES.iter().find(|(known, _)| *known == name).map(|(_, function)| *function)
}

/// A unit of an angle.
#[derive(Clone, Copy, Debug)]
pub(super) enum AngleUnit {
    Degrees,
    Radians,
}

/// The unit of an angle of that name.
pub(super) fn find_angle_unit(name: &str) -> Option<AngleUnit> {
    if DEGREES.contains(&name) {
        return Some(AngleUnit::Degrees);
    }
    RADIANS.contains(&name).then_some(AngleUnit::Radians)
}

impl AngleUnit {
    /// An angle of so many of these, in radians.
    pub(super) fn to_radians(self, angle: &Number) -> Option<Number> {
        match self {
            Self::Degrees => angle.times(&Number::rounded(PI / 180.0)?),
            Self::Radians => Some(angle.clone()),
        }
    }
}

impl Function {
    /// Whether its value is an angle.
    pub(super) fn is_arc(self) -> bool {
        matches!(self, Self::Arc(_))
    }

    /// The inverse function: a sine to the power -1 is that, and no reciprocal.
    pub(super) fn inverse(self) -> Option<Self> {
        let of = |name: &str| NAMES.iter().find(|(known, _)| *known == name).map(|(_, function)| *function);
        let (name, _) = NAMES.iter().find(|(_, listed)| match (self, listed) {
            (Self::Angle(function), Self::Angle(other)) => std::ptr::fn_addr_eq(function, *other),
            _ => false,
        })?;
        of(&format!("a{name}"))
    }

    /// Whether its argument is an angle.
    pub(super) fn takes_angle(self) -> bool {
        matches!(self, Self::Angle(_))
    }

    /// Its value; `None` where it has none.
    pub(super) fn apply(self, argument: &Number) -> Option<Number> {
        match self {
            Self::SquareRoot => argument.square_root(),
            Self::Absolute if argument.is_negative() => Some(argument.clone().negated()),
            Self::Absolute => Some(argument.clone()),
            Self::Angle(function) | Self::Arc(function) | Self::Other(function) => argument.through(function),
        }
    }
}
