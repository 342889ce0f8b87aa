//! Settings of each simulator, and their limits.

use std::collections::BTreeMap;

use serde::Deserialize;
use serde::Serialize;

use momentous_fault::did_you_mean;

use super::{Refused, RefusedKind};

/// A number that can be set.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Control {
    /// Its name in requests and addresses.
    pub name: &'static str,
    /// Its name in the problem; nothing where the problem does not have it.
    #[serde(skip)]
    pub given: &'static str,
    /// Its letter and index.
    pub symbol: [&'static str; 2],
    /// Its label.
    pub label: &'static str,
    /// Its unit; empty where it has none.
    pub unit: &'static str,
    /// The least value.
    pub min: f64,
    /// The greatest value.
    pub max: f64,
    /// By how much it moves.
    pub step: f64,
    /// Its value where none is said.
    pub usual: f64,
    /// Whether nothing may be said, and then what it stands for is not there; such controls come last.
    pub is_optional: bool,
}

impl Control {
    const fn optional(mut self) -> Self {
        self.is_optional = true;
        self
    }
}

/// The words of a row of the tables below, in the order of the fields of [`Control`].
type Words = (&'static str, &'static str, [&'static str; 2], &'static str, &'static str);

const fn control(words: Words, [min, max, step, usual]: [f64; 4]) -> Control {
    let (name, given, symbol, label, unit) = words;
    Control { name, given, symbol, label, unit, min, max, step, usual, is_optional: false }
}

/// The controls of the collision.
pub const COLLISION: &[Control] = &[
    control(("m_A", "m_A", ["m", "A"], "Mass of A", "kg"), [0.1, 20.0, 0.1, 3.0]),
    control(("v_A", "v_A1", ["v", "A"], "Velocity of A", "m/s"), [-10.0, 10.0, 0.1, 3.0]),
    control(("m_B", "m_B", ["m", "B"], "Mass of B", "kg"), [0.1, 20.0, 0.1, 2.0]),
    control(("v_B", "v_B1", ["v", "B"], "Velocity of B", "m/s"), [-10.0, 10.0, 0.1, -2.0]),
    control(("x_A", "", ["x", "A"], "Place of A at the start", "m"), [-6.0, -1.0, 0.1, -2.5]),
    control(("x_B", "", ["x", "B"], "Place of B at the start", "m"), [1.0, 6.0, 0.1, 2.5]),
    control(("e", "e", ["e", ""], "Coefficient of restitution", ""), [0.0, 1.0, 0.01, 0.7]),
];

/// The controls of the collision in the plane.
pub const DISCS: &[Control] = &[
    control(("m_A", "m_A", ["m", "A"], "Mass of A", "kg"), [0.1, 20.0, 0.1, 3.0]),
    control(("v_A", "v_A1.x", ["v", "A"], "Velocity of A", "m/s"), [-10.0, 10.0, 0.1, 3.0]),
    control(("m_B", "m_B", ["m", "B"], "Mass of B", "kg"), [0.1, 20.0, 0.1, 2.0]),
    control(("v_B", "v_B1.x", ["v", "B"], "Velocity of B", "m/s"), [-10.0, 10.0, 0.1, -2.0]),
    control(("b", "", ["b", ""], "Impact parameter", "m"), [-1.0, 1.0, 0.01, 0.4]),
    control(("e", "e", ["e", ""], "Coefficient of restitution", ""), [0.0, 1.0, 0.01, 0.7]),
];

/// The controls of the bouncing ball; a terminal speed of 0 is no air resistance.
pub const RESTITUTION: &[Control] = &[
    control(("h", "h_0", ["h", "0"], "Height of release", "m"), [0.1, 20.0, 0.1, 4.0]),
    control(("e", "e", ["e", ""], "Coefficient of restitution", ""), [0.0, 1.0, 0.01, 0.75]),
    control(("n", "n", ["n", ""], "Bounce to look at", ""), [1.0, 12.0, 1.0, 3.0]),
    control(("v_t", "", ["v", "t"], "Terminal speed in air (0: no air)", "m/s"), [0.0, 60.0, 1.0, 0.0]),
    control(("e_2", "", ["e", "2"], "A second ball beside it, with", ""), [0.0, 1.0, 0.01, 0.5]).optional(),
];

/// Asks for a simulator's scene with these values.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct SimulatorRequest {
    /// Values of controls by their names; the usual ones where none are said.
    #[serde(default)]
    pub values: BTreeMap<String, f64>,
    /// The method to compare with the exact motion, as `momentous simulate --method` has it; nothing for none.
    #[serde(default)]
    pub method: Option<String>,
    /// Its step in s, where it has one.
    #[serde(default)]
    pub step: Option<f64>,
}

impl SimulatorRequest {
    /// The value of a control that may be left out, where it is not.
    pub(super) fn optional(&self, name: &str) -> Option<f64> {
        self.values.get(name).map(|value| value + 0.0)
    }

    /// The value of each control in order; whether all are within their limits is another question.
    ///
    /// # Errors
    /// Where a name is no control's.
    pub(super) fn values<const N: usize>(&self, controls: &[Control]) -> Result<[f64; N], Refused> {
        for name in self.values.keys() {
            if !controls.iter().any(|control| control.name == name) {
                let refused = Refused::new(RefusedKind::Invalid, format!("`{name}` cannot be set here"));
                let names = controls.iter().map(|control| control.name);
                return Err(match did_you_mean(name, names.clone()) {
                    Some(near) => refused.help(format!("did you mean `{near}`?")),
                    None => refused.help(format!("what can be set is {}", names.collect::<Vec<_>>().join(", "))),
                });
            }
        }
        let mut all = [0.0; N];
        for (value, control) in all.iter_mut().zip(controls) {
            // No negative zero, which would be written with its sign.
            *value = self.values.get(control.name).copied().unwrap_or(control.usual) + 0.0;
        }
        Ok(all)
    }
}

/// The values as they may be set in the problem.
pub(super) fn set(controls: &'static [Control], values: &[f64]) -> Vec<(&'static str, String)> {
    let with_unit = |control: &Control, value: &f64| format!("{value} {}", control.unit).trim_end().to_owned();
    let settable = controls.iter().zip(values).filter(|(control, _)| !control.given.is_empty());
    settable.map(|(control, value)| (control.given, with_unit(control, value))).collect()
}

/// A value that lies outside the limits of its control.
pub(super) fn outside(controls: &[Control], values: &[f64]) -> Option<Refused> {
    let outside = controls.iter().zip(values).find(|(control, value)| !(control.min..=control.max).contains(*value));
    outside.map(|(control, value)| {
        let Control { name, min, max, unit, .. } = control;
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        let message = format!("`{name}` lies between {min}{unit} and {max}{unit} here, and {value:e}{unit} does not");
        Refused::new(RefusedKind::Values, message)
    })
}
