//! A body that strikes an arm: angular momentum about the point that holds the arm, and restitution where it is struck.

use crate::Agent;
use crate::Builder;
use crate::Impulse;
use crate::Reason;
use crate::turned::Turned;
use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::angular;
use momentous_laws::restitution;
use momentous_quantity::Dimension;
use momentous_scene::stage::Strike;
use momentous_solve::Relation;

impl Builder<'_> {
    pub(crate) fn strike(&mut self, index: usize, stage: &Strike, path: &Path) {
        let body = stage.body.as_str();
        let (name, centre) = (self.called(body), self.point(&stage.about));
        let meaning = format!("the distance from {centre} at which {name} strikes");
        let distance = self.read_positive(&stage.at, Dimension::LENGTH, &meaning, &path.key("at"));
        let mut momenta = Vec::new();
        let mut contact = Vec::new();
        let mut turning = Vec::new();
        for side in [0, 1] {
            let instant = index + 1 + side;
            let turn = self.turn_of_arm(&centre, instant);
            let velocity = self.transverse(body, instant);
            let striking = Expr::product([self.mass(body), distance.clone(), velocity.clone()]);
            let mut terms = Vec::new();
            for (carried, term) in &stage.carries {
                let meaning = format!("the distance of {} from {centre}", self.called(carried));
                let arm =
                    self.read_positive(term, Dimension::LENGTH, &meaning, &path.key("carries").key(carried.as_str()));
                terms.push(self.on_arm(index, carried, instant, &arm, &turn));
            }
            terms.extend(self.momentum_of_rotor(stage.rotor.as_deref(), &turn));
            turning.push(Expr::sum(terms.iter().cloned()));
            terms.insert(0, striking);
            let meaning = format!("the angular momentum about {centre} {}", self.when(instant));
            let momentum = Expr::from(self.symbol(self.momentum_on_arm_by_name(index, side, &stage.about), meaning));
            let because = match &stage.rotor {
                Some(rotor) => {
                    format!(
                        "{name} moves at right angles to the radius, and {} turns about {centre}",
                        self.called(rotor)
                    )
                }
                None => "all move at right angles to the arm".to_owned(),
            };
            self.law(&angular::ANGULAR_MOMENTUM, Some(index), because, (momentum.clone(), Expr::sum(terms)));
            momenta.push(momentum);
            contact.push([velocity, distance.clone() * turn]);
        }
        let arm = self.struck(stage);
        let because = format!(
            "the impulse at {centre} has no moment there, and that between {name} and {arm} acts within the system"
        );
        if let [before, after] = &momenta[..] {
            self.law(&angular::CONSERVATION, Some(index), because, (before.clone(), after.clone()));
        }
        if let Ok(ends) = <[Expr; 2]>::try_from(turning) {
            self.turned.push(Turned {
                stage: index,
                of: format!("of {name} on {arm} about {centre}"),
                letter: None,
                law: &angular::ANGULAR_IMPULSE,
                because: format!("the impulse at {centre} has no moment there, and only that of {name} turns {arm}"),
                ends,
            });
        }
        if let [[v1, w1], [v2, w2]] = &contact[..] {
            self.parting(index, stage, [[v1, w1], [v2, w2]], path);
        }
        self.impulses.push(Impulse {
            stage: index,
            on: body.to_owned(),
            by: Agent::Outside,
            called: arm,
            components: Vec::new(),
            impulsive: true,
        });
        if stage.rotor.is_none() {
            self.neglect("the mass of the arm", "it is light");
        }
        self.not_needed(format!("the impulse at {centre}"), "it has no moment there");
    }

    /// The name of the struck body.
    fn struck(&self, stage: &Strike) -> String {
        stage.rotor.as_ref().map_or_else(|| "the arm".to_owned(), |rotor| self.called(rotor))
    }

    /// How the body and the place that it strikes part: `v` of the body, `w` of the place, before and after.
    fn parting(&mut self, index: usize, stage: &Strike, [[v1, w1], [v2, w2]]: [[&Expr; 2]; 2], path: &Path) {
        let (name, arm) = (self.called(&stage.body), self.struck(stage));
        let reason = Reason::NotMet(name.clone(), arm.clone());
        self.require(v1.clone(), Relation::Differs, w1.clone(), reason);
        match (&stage.restitution, stage.plastic) {
            (Some(_), true) => {
                let fault = Fault::new(Code::OverDetermined, "`plastic` and `restitution` cannot be used together");
                self.faults.push(fault.help("remove one of them").at_path(path.key("plastic")));
            }
            (Some(term), false) => {
                let e = self.restitution_coefficient(term, &path.key("restitution"));
                let sides = restitution::restitution(&e, [v1, w1], [v2, w2]);
                let parted = if e.is_zero() {
                    "do not separate again, since the coefficient of restitution is zero"
                } else {
                    "separate again"
                };
                let because = format!("{name} and the point that it strikes {parted}");
                self.law(&restitution::RESTITUTION, Some(index), because, sides);
            }
            (None, true) => {
                let because = format!("{name} stays on {arm}");
                self.law(&restitution::PLASTIC, Some(index), because, (v2.clone(), w2.clone()));
            }
            (None, false) => {
                let squared = |one: &Expr, other: &Expr| (one.clone() - other.clone()).powi(2);
                let reason = Reason::LeavesFaster(name, arm);
                self.require(squared(v1, w1), Relation::AtLeast, squared(v2, w2), reason);
            }
        }
    }
}
