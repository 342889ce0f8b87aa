//! Requests to the method, as they are typed.

use crate::quantity::Dimension;
use crate::quantity::Quantity;
use crate::simulate::MethodKind;

/// A method by the name that was typed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Named(MethodKind);

impl Named {
    pub(super) fn kind(self) -> MethodKind {
        self.0
    }
}

/// Reads the name of a method.
pub(super) fn method(text: &str) -> Result<Named, String> {
    MethodKind::named(text).map(Named)
}

/// Reads a relative error.
pub(super) fn accuracy(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(value) if value > 0.0 && value < 1.0 => Ok(value),
        _ => Err("an accuracy is a number between 0 and 1, such as 1e-6".to_owned()),
    }
}

/// Reads a time; a plain number is in seconds.
pub(super) fn budget(text: &str) -> Result<f64, String> {
    let told = || "a budget is a time, such as 10us or 2 ms".to_owned();
    let quantity = Quantity::parse(text.trim()).map_err(|_| told())?;
    let seconds = quantity.value.to_f64() * quantity.unit.factor().to_f64();
    let is_time = [Dimension::TIME, Dimension::NONE].contains(&quantity.unit.dimension());
    if is_time && seconds > 0.0 && seconds.is_finite() { Ok(seconds) } else { Err(told()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_typed_is_read_or_told() {
        assert_eq!(method("Runge_Kutta").map(Named::kind), Ok(MethodKind::RungeKutta));
        assert_eq!(method("event driven").map(Named::kind), Ok(MethodKind::EventDriven));
        assert!(method("penalti").is_err_and(|said| said.contains("`penalty`")));
        assert_eq!([accuracy("1e-6"), accuracy("0"), accuracy("x")].map(Result::ok), [Some(1e-6), None, None]);
        for text in ["10us", "10 µs", "0.00001", "1e-5 s"] {
            assert!(budget(text).is_ok_and(|seconds| (seconds - 1e-5).abs() < 1e-18), "{text}: {:?}", budget(text));
        }
        assert!(["10 kg", "-1 s", "soon"].iter().all(|text| budget(text).is_err()));
    }
}
