//! The cosine of a grazing oblique impact.

/// The cosine of the angle between the line of impact and the approach, for two spheres whose lines of motion are
/// `2R(1 - d)` apart: `sqrt(d (2 - d))`. The naive `sqrt(1 - (1 - d)^2)` keeps five digits at `d = 1e-12`, and none at 1e-16.
///
/// ```
/// use momentous_simulate::grazing_cosine;
/// assert!((grazing_cosine(1e-12) / 1.41421356237274e-6 - 1.0).abs() < 1e-14);
/// ```
#[must_use]
pub fn grazing_cosine(d: f64) -> f64 {
    (d * (2.0 - d)).sqrt()
}
