//! When a gap that changes with constant acceleration closes for the first time.

/// When a gap closes, and how fast it closes then.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meeting {
    /// The time until then, in s.
    pub after: f64,
    /// The rate of the gap then, in m/s: not positive.
    pub rate: f64,
}

/// When `gap + rate t + curvature t^2 / 2` first falls to zero, for `t >= 0`. A gap that is closed already meets at once where it is
/// closing, and otherwise when it closes again; a gap that only touches zero does not meet.
///
/// The small root is `2 gap / (-rate + sqrt(disc))`, never the textbook's difference, and the rate then is `-sqrt(disc)`.
///
/// ```
/// use momentous_simulate::first_contact;
/// let meeting = first_contact(1e-12, -3.0, 9.81).unwrap();
/// assert!((meeting.after * 3.0 / 1e-12 - 1.0).abs() < 1e-11);
/// assert_eq!(first_contact(1.0, 1.0, 0.0), None);
/// ```
#[must_use]
pub fn first_contact(gap: f64, rate: f64, curvature: f64) -> Option<Meeting> {
    if gap <= 0.0 && (rate < 0.0 || (rate == 0.0 && curvature < 0.0)) {
        return Some(Meeting { after: 0.0, rate });
    }
    let gap = gap.max(0.0);
    if curvature == 0.0 {
        return (rate < 0.0).then(|| Meeting { after: gap / -rate, rate });
    }
    let speed = if gap == 0.0 { rate.abs() } else { discriminant(rate, gap, curvature)?.sqrt() };
    let after = if rate <= 0.0 {
        if curvature > 0.0 && speed == 0.0 {
            return None;
        }
        2.0 * gap / (-rate + speed)
    } else if curvature < 0.0 {
        (rate + speed) / -curvature
    } else {
        return None;
    };
    (after.is_finite() && speed > 0.0).then_some(Meeting { after, rate: -speed })
}

/// `rate^2 - 2 gap curvature`, exact to its own last digits where the two nearly cancel (Kahan); `None` where it is negative.
fn discriminant(rate: f64, gap: f64, curvature: f64) -> Option<f64> {
    let product = 2.0 * gap * curvature;
    let plain = rate * rate - product;
    let value = if product > 0.0 && plain.abs() < 1e-3 * product {
        let error = libm::fma(-2.0 * gap, curvature, product);
        libm::fma(rate, rate, -product) + error
    } else {
        plain
    };
    (value >= 0.0).then_some(value)
}
