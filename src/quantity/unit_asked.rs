//! Units beside what is asked: the dimension decides between readings, and a hertz beside a rotation is a turn a second.

use super::unit::Symbol;
use super::unit_lookup::in_other_case;
use super::{Dimension, Factor, Rational, Unit, UnitFault, UnitFaultKind};

/// The number of times that one text may be read in two ways.
const MOST_CHOICES: usize = 3;

/// One turn, in radians.
fn turn() -> Factor {
    Factor { rational: Rational::from(2), pi: 1 }
}

impl Unit {
    /// Reads a unit as [`Unit::parse`] does; of two readings, the one that measures what is asked.
    ///
    /// ```
    /// use momentous_quantity::{Dimension, Unit};
    /// assert!(Unit::parse("ms^-1").is_err());
    /// assert_eq!(Unit::parse_asked("ms^-1", Dimension::VELOCITY)?.to_string(), "m/s");
    /// # Ok::<(), momentous_quantity::UnitFault>(())
    /// ```
    ///
    /// # Errors
    /// As [`Unit::parse`]: where both readings measure what is asked, or none does, too.
    pub fn parse_asked(text: &str, asked: Dimension) -> Result<Self, UnitFault> {
        let fault = match Self::parse(text) {
            Err(fault) if matches!(fault.kind, UnitFaultKind::Ambiguous { .. }) => fault,
            Ok(unit) if unit.dimension() != asked => return Ok(in_other_case_asked(text, asked).unwrap_or(unit)),
            clear => return clear,
        };
        let mut units: Vec<Self> = Vec::new();
        for unit in readings(text, MOST_CHOICES) {
            if unit.dimension() == asked && !units.contains(&unit) {
                units.push(unit);
            }
        }
        if units.len() == 1 { units.pop().ok_or(fault) } else { Err(fault) }
    }

    /// The number of the other unit that it is, as [`Unit::in_terms_of`] says; where the one is a frequency and the other a
    /// rotation, a hertz is one turn a second.
    ///
    /// ```
    /// use momentous_quantity::Unit;
    /// let [hertz, rotation] = ["Hz", "rpm"].map(Unit::parse);
    /// assert_eq!(rotation?.turning_as(&hertz?).to_f64(), 1.0 / 60.0);
    /// # Ok::<(), momentous_quantity::UnitFault>(())
    /// ```
    #[must_use]
    pub fn turning_as(&self, other: &Self) -> Factor {
        let plain = self.in_terms_of(other);
        match (self.kind_of_turning(), other.kind_of_turning()) {
            ((1, 0), (0, 1)) => plain * turn(),
            ((0, 1), (1, 0)) => plain * turn().power(-1),
            _ => plain,
        }
    }

    /// Whether it is a unit of angles, turns among them.
    #[must_use]
    pub fn measures_angles(&self) -> bool {
        self.dimension() == Dimension::NONE && self.kind_of_turning() == (0, 1)
    }

    /// Whether it is the per cent.
    #[must_use]
    pub fn is_percent(&self) -> bool {
        matches!(self.powers(), [only] if only.exponent == 1 && only.symbol.row.symbol == "%")
    }

    /// Whether it counts how often something happens in a time, as a hertz does.
    #[must_use]
    pub fn counts_events(&self) -> bool {
        self.kind_of_turning().0 != 0
    }

    /// The exponents of frequencies and of angles.
    fn kind_of_turning(&self) -> (i8, i8) {
        let total = |is_one: fn(&Symbol) -> bool| {
            let ones = self.powers().iter().filter(|power| is_one(&power.symbol));
            ones.fold(0_i8, |sum, power| sum.saturating_add(power.exponent))
        };
        (total(Symbol::is_frequency), total(Symbol::is_angle))
    }

    /// Whether it is a unit of plain angles, of which a whole turn is as good as none; `rev` counts turns.
    #[must_use]
    pub fn is_plain_angle(&self) -> bool {
        self.dimension() == Dimension::NONE
            && matches!(self.powers(), [only] if only.exponent == 1 && only.symbol.is_angle() && only.symbol.row.symbol != "rev")
    }
}

/// The unit that a word of several letters names in another case, where that alone measures what is asked: `kn` beside a force.
fn in_other_case_asked(text: &str, asked: Dimension) -> Option<Unit> {
    let word = text.trim();
    if word.len() < 2 || !word.chars().all(char::is_alphabetic) {
        return None;
    }
    let units = in_other_case(word).into_iter().filter_map(|name| Unit::parse(&name).ok());
    let mut units = units.filter(|unit| unit.dimension() == asked);
    let unit = units.next();
    if units.next().is_none() { unit } else { None }
}

/// Every unit that a text can mean.
fn readings(text: &str, choices: usize) -> Vec<Unit> {
    match Unit::parse(text) {
        Ok(unit) => vec![unit],
        Err(UnitFault { kind: UnitFaultKind::Ambiguous { readings: several, .. }, span }) if choices > 0 => {
            let (before, behind) = (text.get(..span.start), text.get(span.end..));
            let (Some(before), Some(behind)) = (before, behind) else { return Vec::new() };
            several.iter().flat_map(|one| readings(&format!("{before}({one}){behind}"), choices - 1)).collect()
        }
        Err(_) => Vec::new(),
    }
}

impl Symbol {
    fn is_frequency(&self) -> bool {
        self.row.symbol == "Hz"
    }

    fn is_angle(&self) -> bool {
        ["rad", "mrad", "µrad", "°", "rev", "rpm"].contains(&self.row.symbol)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test may panic
mod tests {
    use super::*;

    #[test]
    fn the_dimension_decides_between_readings() {
        let cases = [
            ("kg ms-1", Dimension::MOMENTUM, Some("kg m/s")),
            ("ms⁻¹", Dimension::new(0, 0, -1), Some("1/ms")),
            ("ms^-1", Dimension::MASS, None),
            ("rads^-1", Dimension::new(0, 0, -1), Some("rad/s")),
            ("KN", Dimension::FORCE, Some("kN")),
            ("KN", Dimension::MASS, None),
            ("kn", Dimension::FORCE, Some("kN")),
            ("kn", Dimension::VELOCITY, Some("kt")),
            ("MM", Dimension::LENGTH, None),
            ("m/s kg", Dimension::MOMENTUM, Some("m kg/s")),
            ("furlong", Dimension::LENGTH, None),
        ];
        for (text, asked, expected) in cases {
            let found = Unit::parse_asked(text, asked).ok().map(|unit| unit.to_string());
            assert_eq!(found.as_deref(), expected, "{text}");
        }
    }

    #[test]
    fn a_hertz_is_a_turn_a_second_beside_a_rotation() {
        use std::f64::consts::TAU;
        let factor =
            |given: &str, asked: &str| Unit::parse(given).unwrap().turning_as(&Unit::parse(asked).unwrap()).to_f64();
        for (given, asked, expected) in [
            ("Hz", "rad/s", TAU),
            ("Hz", "rpm", 60.0),
            ("rpm", "Hz", 1.0 / 60.0),
            ("rad/s", "kHz", 1.0 / (1000.0 * TAU)),
            ("°/s", "Hz", 1.0 / 360.0),
            ("1/s", "Hz", 1.0),
            ("1/s", "rad/s", 1.0),
            ("rpm", "rad/s", TAU / 60.0),
        ] {
            assert!((factor(given, asked) / expected - 1.0).abs() < 1e-14, "{given} as {asked}");
        }
    }
}
