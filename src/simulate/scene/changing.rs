//! A mass that changes steadily under a steady force.

/// The mass at the start, how quickly it grows, and the force that accelerates it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Changing {
    pub mass: f64,
    pub grows: f64,
    pub force: f64,
}

/// The share of the mass below which its change is followed by a series.
const SMALL: f64 = 1e-2;

/// The terms of the series, of which each is smaller by that share.
const TERMS: u32 = 9;

impl Changing {
    /// The mass after a time, and what the force has given of speed and of way, where what is thrown away goes on as fast.
    pub(super) fn after(self, gone: f64) -> [f64; 3] {
        let [once, twice] = logarithms(self.share(gone));
        let gained = self.force / self.mass * gone;
        [self.mass + self.grows * gone, gained * once, gained * gone * twice]
    }

    /// The mass after a time, its speed and way as seen from where what joins it rests, and the energy that the joining has cost.
    pub(super) fn joined(self, speed: f64, gone: f64) -> [f64; 4] {
        let Self { mass, grows, force } = self;
        let now = mass + grows * gone;
        // The momentum grows evenly: a speed that is in balance, and one over the mass.
        let (even, rest) = (force / grows, mass * (speed - force / grows));
        let logarithm = gone / mass * logarithms(self.share(gone))[0];
        let squares = even * even * gone + 2.0 * even * rest * logarithm + rest * rest * gone / (mass * now);
        [now, (mass * speed + force * gone) / now, even * gone + rest * logarithm, grows * squares / 2.0]
    }

    fn share(self, gone: f64) -> f64 {
        self.grows * gone / self.mass
    }
}

/// The logarithm of 1 + x over x, and the integral of that logarithm over x².
fn logarithms(share: f64) -> [f64; 2] {
    if share.abs() >= SMALL {
        let logarithm = libm::log1p(share);
        return [logarithm / share, ((1.0 + share) * logarithm - share) / (share * share)];
    }
    let mut power = 1.0;
    let (mut once, mut twice) = (0.0, 0.0);
    for order in (1..=TERMS).map(f64::from) {
        once += power / order;
        twice += power / (order * (order + 1.0));
        power *= -share;
    }
    [once, twice]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 10 kg, of which 2 kg/s are thrown away, under 20 N: after 3 s.
    #[test]
    fn a_rocket_gains_the_logarithm_of_its_masses() {
        let [mass, gained, way] = Changing { mass: 10.0, grows: -2.0, force: 20.0 }.after(3.0);
        assert!((mass - 4.0).abs() < 1e-15);
        assert!((gained - 10.0 * 2.5_f64.ln()).abs() < 1e-14, "{gained}");
        // F/q (t - m/q ln(m_0/m))
        assert!((way - 10.0 * (3.0 - 2.0 * 2.5_f64.ln())).abs() < 1e-13, "{way}");
    }

    /// A cart of 2 kg at 3 m/s under 4 N that catches 1 kg/s from rest, after 2 s: 14 N s and 4 kg.
    #[test]
    fn what_joins_shares_the_momentum() {
        let cart = Changing { mass: 2.0, grows: 1.0, force: 4.0 };
        let [mass, speed, way, lost] = cart.joined(3.0, 2.0);
        assert!(
            (mass - 4.0).abs() + (speed - 3.5).abs() < 1e-15 && (way - (8.0 - 2.0 * 2.0_f64.ln())).abs() < 1e-14,
            "{way}"
        );
        let work = 4.0 * way + 9.0 - 2.0 * 3.5 * 3.5;
        assert!((lost - work).abs() < 1e-13, "{lost} {work}");
    }

    #[test]
    fn both_ways_to_work_it_out_agree() {
        let [series, plain] = [SMALL - 1e-15, SMALL].map(logarithms);
        assert!(series.iter().zip(plain).all(|(one, other)| (one - other).abs() < 1e-12), "{series:?} {plain:?}");
    }
}
