//! Impacts at a point with friction. What they need turns, which the bodies of the methods do not: the laws of restitution stand in
//! their place.

use crate::point_impact::{PointImpact, PointOutcome, RestitutionLaw};
use crate::refusal::Refusal;

use super::{Row, Verdict};

/// A rod of mass and length 1 m that strikes with its end; the inverse masses are worked by hand.
const ROD: PointImpact = PointImpact {
    tangential: 2.92,
    coupling: 1.44,
    normal: 2.08,
    slip: -0.2,
    approach: -1.0,
    friction: 0.3,
    restitution: 0.9,
};

/// The same kind of contact, where friction pushes it together faster than it can part: 8/5 - 9/8 * 8/5 is negative.
const JAMMED: PointImpact =
    PointImpact { tangential: 2.6, coupling: 1.6, normal: 1.6, slip: 1.0, friction: 1.125, ..ROD };

/// The energy that Stronge's law takes, in J, from the phases by hand; and how well it has to be met.
const LOST: f64 = 0.134_425_1;
const TOLERANCE: f64 = 1e-6;

type Rule = fn(&PointImpact) -> Result<PointOutcome, Refusal>;

/// How an impact at a point can be solved; the last is what the program does where nobody chooses.
const RULES: [(&str, Rule); 5] = [
    ("Newton, first slip", PointImpact::solve_with_first_slip),
    ("Newton", |contact| contact.solve_by(RestitutionLaw::Newton)),
    ("Poisson", |contact| contact.solve_by(RestitutionLaw::Poisson)),
    ("Stronge", |contact| contact.solve_by(RestitutionLaw::Stronge)),
    ("the law needed", PointImpact::solve),
];

/// Both contacts by every rule.
pub(super) fn run_all() -> Vec<Row> {
    let scenes = [("rod with friction: energy lost", ROD), ("jamming", JAMMED)];
    let each = scenes.into_iter().flat_map(|scene| RULES.map(|rule| (scene, rule)));
    each.map(|((scene, contact), (method, rule))| Row { scene, method, verdict: verdict(rule(&contact)) }).collect()
}

fn verdict(outcome: Result<PointOutcome, Refusal>) -> Verdict {
    match outcome {
        Err(refusal) => Verdict::Refused(refusal.name()),
        Ok(outcome) => {
            let error = (outcome.energy_lost - LOST).abs() / LOST;
            if error <= TOLERANCE { Verdict::Right } else { Verdict::Off(error) }
        }
    }
}
