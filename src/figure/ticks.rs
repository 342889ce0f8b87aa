//! Round numbers along an axis.

/// About this many steps along an axis.
const STEPS: f64 = 4.5;

/// Tick values from `low` to `high`, and how they are written: `digits` decimals after division by ten to the `power`.
#[derive(Clone, Debug, PartialEq)]
pub struct Ticks {
    /// The values, in rising order.
    pub values: Vec<f64>,
    /// The decimals of what is written.
    pub digits: usize,
    /// The power of ten that is taken out.
    pub power: i32,
}

impl Ticks {
    /// Steps of 1, 2 or 5 times a power of ten; powers of a thousand are taken out of very large and very small numbers.
    #[must_use]
    pub fn between(low: f64, high: f64) -> Self {
        let (low, high) = if low.is_finite() && high.is_finite() && low < high { (low, high) } else { (0.0, 1.0) };
        let rough = (high - low) / STEPS;
        let decade = libm::pow(10.0, libm::floor(libm::log10(rough)));
        let nice = [1.0, 2.0, 5.0].map(|factor| factor * decade);
        let step = nice.into_iter().find(|step| *step >= rough).unwrap_or(10.0 * decade);
        let first = libm::ceil(low / step - 1e-9);
        let values: Vec<f64> = (0..=12_i32)
            .map(|number| (first + f64::from(number)) * step)
            .take_while(|value| *value <= high + 1e-9 * step)
            .collect();
        let largest = low.abs().max(high.abs());
        let power = match decimal_exponent(largest) {
            -2..=4 => 0,
            exponent => exponent.div_euclid(3) * 3,
        };
        let digits = usize::try_from(power - decimal_exponent(step)).unwrap_or(0).min(12);
        Self { values, digits, power }
    }

    /// A tick's value as written.
    #[must_use]
    pub fn text(&self, value: f64) -> String {
        let scaled = value / libm::pow(10.0, f64::from(self.power));
        let text = format!("{scaled:.*}", self.digits);
        let is_zero = text.chars().all(|character| matches!(character, '-' | '0' | '.'));
        if is_zero { "0".to_owned() } else { text }
    }
}

/// The exponent of the leading digit. A magnitude near the limits of f64 counts as the limit.
fn decimal_exponent(value: f64) -> i32 {
    if value <= 0.0 {
        return 0;
    }
    #[allow(clippy::cast_possible_truncation)] // The logarithm of a finite number lies between -324 and 309.
    let exponent = libm::floor(libm::log10(value) + 1e-9) as i32;
    exponent
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(low: f64, high: f64) -> (Vec<String>, i32) {
        let ticks = Ticks::between(low, high);
        (ticks.values.iter().map(|value| ticks.text(*value)).collect(), ticks.power)
    }

    #[test]
    fn ticks_are_round() {
        assert_eq!(written(0.0, 9.0).0, ["0", "2", "4", "6", "8"]);
        assert_eq!(written(0.0, 0.05).0, ["0", "0.02", "0.04"]);
        assert_eq!(written(-3.0, 4.0).0, ["-2", "0", "2", "4"]);
    }

    #[test]
    fn powers_of_a_thousand_are_taken_out() {
        assert_eq!(written(0.0, 250_000.0), (vec!["0".into(), "100".into(), "200".into()], 3));
        assert_eq!(written(0.0, 0.004), (vec!["0".into(), "1".into(), "2".into(), "3".into(), "4".into()], -3));
    }

    #[test]
    fn an_empty_range_is_replaced() {
        assert!(Ticks::between(2.0, 2.0).values.len() > 2);
        assert!(Ticks::between(f64::NAN, 2.0).values.len() > 2);
    }
}
