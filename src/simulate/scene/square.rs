//! A resistance in proportion to the square of the speed on a line, against a steady drive.

/// A speed that changes by `drive - rate s |s|`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Square {
    pub drive: f64,
    pub rate: f64,
    /// The speed at the start.
    pub speed: f64,
}

impl Square {
    /// What the resistance has changed of the speed in a time, and what of the way.
    pub(super) fn integrals(self, gone: f64) -> [f64; 2] {
        let (speed, way) = self.after(gone);
        [speed - self.speed - self.drive * gone, way - self.speed * gone - self.drive * gone * gone / 2.0]
    }

    /// Speed and way after a time.
    fn after(self, gone: f64) -> (f64, f64) {
        let Self { drive, rate, speed } = self;
        if drive < 0.0 {
            let (speed, way) = Self { drive: -drive, speed: -speed, ..self }.after(gone);
            return (-speed, -way);
        }
        if drive == 0.0 {
            let slowed = 1.0 + rate * speed.abs() * gone;
            return (speed / slowed, speed.signum() * libm::log(slowed) / rate);
        }
        // The speed at which the drive is in balance, and how soon.
        let (last, soon) = (libm::sqrt(drive / rate), libm::sqrt(drive * rate));
        if speed < 0.0 {
            let angle = libm::atan(speed / last);
            let (turns, lost) = (-angle / soon, libm::log(libm::cos(angle)) / rate);
            if gone > turns {
                let (speed, way) = Self { speed: 0.0, ..self }.after(gone - turns);
                return (speed, lost + way);
            }
            let now = angle + soon * gone;
            return (last * libm::tan(now), lost - libm::log(libm::cos(now)) / rate);
        }
        let (share, faded) = (speed / last, libm::exp(-2.0 * soon * gone));
        let tangent = libm::tanh(soon * gone);
        let grown = f64::midpoint(1.0, faded) + share * (1.0 - faded) / 2.0;
        (last * (share + tangent) / (1.0 + share * tangent), (soon * gone + libm::log(grown)) / rate)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Speed and way go on as the equation says, before and after the speed turns, faster and slower than the balance.
    #[test]
    fn the_formula_solves_its_equation() {
        for (drive, speed) in [(3.0, -2.0), (3.0, 0.0), (3.0, 9.0), (-3.0, 2.0), (0.0, 4.0), (0.0, -4.0)] {
            let square = Square { drive, rate: 0.5, speed };
            assert!((square.after(0.0).0 - speed).abs() < 1e-15);
            for time in [0.1, 0.4, 0.9, 3.0] {
                let [before, now, after] = [time - 1e-4, time, time + 1e-4].map(|time| square.after(time));
                let slope = (after.0 - before.0) / 2e-4;
                assert!((slope - (drive - 0.5 * now.0 * now.0.abs())).abs() < 1e-5, "{square:?} at {time}");
                assert!(((after.1 - before.1) / 2e-4 - now.0).abs() < 1e-6, "{square:?} at {time}");
            }
        }
    }
}
