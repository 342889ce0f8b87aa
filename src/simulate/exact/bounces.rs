//! Sums over a train of bounces, in the form that keeps its digits when e is nearly 1.

/// A ball that is dropped and bounces on a level floor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BounceTrain {
    height: f64,
    gravity: f64,
    loss: f64,
}

impl BounceTrain {
    /// A drop from `height` (m) under `gravity` (m/s²), and `1 - e` for the coefficient of restitution `e`: the difference is
    /// what must be exact. For `e = 0.999999` pass `1e-6`.
    ///
    /// ```
    /// use momentous_simulate::BounceTrain;
    /// let train = BounceTrain::new(4.0, 9.81, 1e-6);
    /// assert!((train.height_after(1_000_000) - 0.541340591605).abs() < 1e-12);
    /// ```
    #[must_use]
    pub fn new(height: f64, gravity: f64, loss: f64) -> Self {
        Self { height, gravity, loss }
    }

    /// `e^(power n)`.
    fn power(&self, bounces: u64, power: f64) -> f64 {
        libm::exp(power * exact(bounces) * libm::log1p(-self.loss))
    }

    /// The height that is reached after bounce number `bounces`, in m.
    #[must_use]
    pub fn height_after(&self, bounces: u64) -> f64 {
        self.height * self.power(bounces, 2.0)
    }

    /// The time of the first fall, in s.
    fn fall(&self) -> f64 {
        (2.0 * self.height / self.gravity).sqrt()
    }

    /// When bounce number `bounces` (1, 2, ...) happens, in s.
    #[must_use]
    pub fn time_of(&self, bounces: u64) -> f64 {
        let between = bounces.saturating_sub(1);
        let fall = self.fall();
        if self.loss == 0.0 {
            return fall * (1.0 + 2.0 * exact(between));
        }
        // 1 + 2 (e + e^2 + ... + e^k) = 1 + 2 e (1 - e^k)/(1 - e)
        let missing = -libm::expm1(exact(between) * libm::log1p(-self.loss));
        fall * (1.0 + 2.0 * (1.0 - self.loss) * missing / self.loss)
    }

    /// When all bounces are over, in s; infinite where nothing is lost.
    #[must_use]
    pub fn end(&self) -> f64 {
        self.fall() * (2.0 - self.loss) / self.loss
    }

    /// The length of the whole path, in m.
    #[must_use]
    pub fn path(&self) -> f64 {
        let e = 1.0 - self.loss;
        self.height * (1.0 + e * e) / (self.loss * (1.0 + e))
    }
}

#[allow(clippy::cast_precision_loss, reason = "counts of bounces stay far below 2^53")]
fn exact(count: u64) -> f64 {
    count as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The reference has 50 digits. The textbook's sum with `1 - e^k`, and with the nearest number for e, is off by 1.2e-11 of itself.
    #[test]
    fn a_million_bounces_at_e_nearly_1_keep_their_digits() {
        let train = BounceTrain::new(4.0, 9.81, 1e-6);
        let (time, height) = (train.time_of(1_000_000), train.height_after(1_000_000));
        assert!((time / 1_141_668.934_222_207 - 1.0).abs() < 1e-15, "{time}");
        assert!((height / 0.541_340_591_605_227_6 - 1.0).abs() < 1e-14, "{height}");
    }
}
