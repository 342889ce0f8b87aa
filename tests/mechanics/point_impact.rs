//! Impacts at a point with friction: the rod of the stability suite, jamming, and properties.

use momentous::simulate::{PointImpact, Refusal, RestitutionLaw};
use proptest::prelude::*;

/// A rod of mass and length 1; the numbers are worked by hand, phase by phase.
const ROD: PointImpact = PointImpact {
    tangential: 2.92,
    coupling: 1.44,
    normal: 2.08,
    slip: -0.2,
    approach: -1.0,
    friction: 0.3,
    restitution: 0.9,
};

#[test]
fn a_rule_that_gains_energy_is_refused() {
    let Err(Refusal::EnergyGain { gain, .. }) = ROD.solve_with_first_slip() else { panic!("it gains energy") };
    assert!((gain - 0.115_545).abs() < 1e-6, "{gain}");
}

#[test]
fn poisson_and_stronge_lose_what_they_lose() {
    for (law, lost) in [(RestitutionLaw::Poisson, 0.136_515_5), (RestitutionLaw::Stronge, 0.134_425_1)] {
        let outcome = ROD.solve_by(law).unwrap();
        assert!((outcome.energy_lost - lost).abs() < 1e-7, "{law:?}: {outcome:?}");
    }
    assert_eq!(ROD.solve().unwrap().law, RestitutionLaw::Stronge);
}

#[test]
fn painleve_jams() {
    // Friction 9/8 on the coupling 8/5 makes the normal coefficient 8/5 - 9/5.
    let jammed = PointImpact { tangential: 2.6, coupling: 1.6, normal: 1.6, slip: 1.0, friction: 1.125, ..ROD };
    assert_eq!(jammed.solve(), Err(Refusal::Jamming));
}

#[test]
fn smooth_and_central_impacts_need_newton_only() {
    for rod in [PointImpact { friction: 0.0, ..ROD }, PointImpact { coupling: 0.0, ..ROD }] {
        let outcome = rod.solve().unwrap();
        assert_eq!(outcome.law, RestitutionLaw::Newton);
        for law in [RestitutionLaw::Poisson, RestitutionLaw::Stronge] {
            let other = rod.solve_by(law).unwrap();
            assert!((other.normal_impulse - outcome.normal_impulse).abs() < 1e-14, "{law:?}");
        }
    }
}

fn contact() -> impl Strategy<Value = PointImpact> {
    (0.1..10.0_f64, -0.99..0.99_f64, 0.1..10.0_f64, -5.0..5.0_f64, 0.01..5.0_f64, 0.0..2.0_f64, 0.0..=1.0_f64).prop_map(
        |(tangential, share, normal, slip, speed, friction, restitution)| PointImpact {
            tangential,
            coupling: share * (tangential * normal).sqrt(),
            normal,
            slip,
            approach: -speed,
            friction,
            restitution,
        },
    )
}

proptest! {
    /// Stronge's law never creates energy, friction stays in its cone, and bodies part.
    #[test]
    fn stronge_never_gains(contact in contact()) {
        match contact.solve_by(RestitutionLaw::Stronge) {
            Err(refusal) => prop_assert_eq!(refusal, Refusal::Jamming),
            Ok(outcome) => {
                prop_assert!(outcome.energy_lost >= -1e-12 * (1.0 + outcome.energy_lost.abs()));
                prop_assert!(outcome.separation >= -1e-12);
                let cone = contact.friction * outcome.normal_impulse;
                prop_assert!(outcome.tangential_impulse.abs() <= cone * (1.0 + 1e-12) + 1e-15);
            }
        }
    }

    /// The law that is chosen is never refused for its energy.
    #[test]
    fn the_selector_never_gains(contact in contact()) {
        if let Err(refusal) = contact.solve() {
            prop_assert_eq!(refusal, Refusal::Jamming);
        }
    }

    /// Where the selector says that Newton's law will do, all three laws agree.
    #[test]
    fn the_laws_agree_where_newton_is_chosen(contact in contact()) {
        if contact.law_needed() == Ok(RestitutionLaw::Newton) {
            let newton = contact.solve_by(RestitutionLaw::Newton).unwrap();
            for law in [RestitutionLaw::Poisson, RestitutionLaw::Stronge] {
                let other = contact.solve_by(law).unwrap();
                prop_assert!((other.normal_impulse - newton.normal_impulse).abs() <= 1e-9 * newton.normal_impulse);
            }
        }
    }
}
