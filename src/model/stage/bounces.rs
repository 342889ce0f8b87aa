//! Repeated bounces of a body that was dropped on a level floor, in closed form.

use crate::Agent;
use crate::Builder;
use crate::Effect;
use crate::Impulse;
use crate::Influence;
use crate::Name;
use crate::QuantityKind;
use crate::Series;
use crate::Shown;
use crate::bounce_terms::BounceTerms;
use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::Law;
use momentous_laws::bouncing;
use momentous_laws::kinematics;
use momentous_quantity::Dimension;
use momentous_scene::Stage;
use momentous_scene::stage::Bounces;

use super::bounce_heights::is_dropped;

/// All bounces together, as they stand in names.
pub(super) const IN_ALL: &str = "total";
/// The bounce that is counted.
pub(super) const COUNTED: &str = "n";

/// What it counts.
const NUMBER: &str = "the number of bounces";

/// A quantity of the bounce that is counted.
pub(super) fn at_bounce(kind: QuantityKind) -> Name {
    Name::of(kind, COUNTED)
}

/// `factor (1 + 2 e + 2 e^2 + ...)`: a fall, and the ways up and down after it, each e to that power times the one before; to the
/// bounce that is counted, or for ever.
fn there_and_back(factor: &Expr, (e, power): (&Expr, i64), count: Option<&Expr>) -> Shown {
    let twice = |times: Expr| Expr::integer(2) * e.clone().power((Expr::integer(power) * times).simplify());
    let mut terms = vec![Expr::one(), twice(Expr::one())];
    terms.extend(count.is_none().then(|| twice(Expr::integer(2))));
    let last = count.map(|count| twice(count.clone() - Expr::one()));
    Shown::Series(Series { factor: factor.clone(), terms, last })
}

/// `factor (e + e^2 + ...)`: flights of which each takes e times as long as the one before.
pub(super) fn one_after_another(factor: &Expr, e: &Expr, count: Option<&Expr>) -> Shown {
    let mut terms = vec![e.clone(), e.clone().powi(2)];
    terms.extend(count.is_none().then(|| e.clone().powi(3)));
    let last = count.map(|count| e.clone().power(count.clone() - Expr::one()));
    Shown::Series(Series { factor: factor.clone(), terms, last })
}

impl Builder<'_> {
    pub(crate) fn bounces(&mut self, index: usize, stage: &Bounces, path: &Path) {
        let e = self.restitution_coefficient(&stage.restitution, &path.key("restitution"));
        let count = match &stage.count {
            Some(term) => Some(self.read_positive(term, Dimension::NONE, NUMBER, &path.key("count"))),
            None => self.bounces_counted(),
        };
        if let Some(Expr::Symbol(count)) = &count {
            self.counts.insert(*count);
        }
        let written = stage.count.as_ref().and_then(|term| term.0.trim().parse::<f64>().ok());
        if written.is_some_and(|number| number.fract() != 0.0) {
            let fault = Fault::new(Code::Unphysical, "bounces are counted by whole numbers");
            self.faults.push(fault.help("write a whole number").at_path(path.key("count")));
        }
        // After that many bounces there would be no height and no speed to speak of.
        if let (Expr::Symbol(e), Some(Expr::Symbol(_)), true) = (&e, &count, stage.count.is_some()) {
            self.system.positive.insert(*e);
        }
        if is_dropped(self.scene, index, stage) {
            self.bounces_after_a_drop(index, stage, &e, count.as_ref());
        } else {
            self.bounces_after_arrival(index, stage, [&e, count.as_ref().unwrap_or(&Expr::one())], path);
        }
        self.floor_acts(index, stage);
        self.impulses.push(Impulse {
            stage: index,
            on: stage.body.clone(),
            by: Agent::Outside,
            called: stage.surface().into(),
            components: Vec::new(),
            impulsive: true,
        });
        self.neglect("air resistance", "the problem gives none");
        self.neglect("the duration of each contact", "it is short compared with the time in the air");
    }

    /// The number of bounces where the stage names none: `n`, unless that is the name of something that is no number.
    fn bounces_counted(&mut self) -> Option<Expr> {
        let known = self.symbols.find(COUNTED);
        let is_free = known.is_none_or(|known| self.symbols.entry(known).dimension == Dimension::NONE);
        let name = Name::of(QuantityKind::Own(COUNTED.to_owned()), "");
        is_free.then(|| self.symbol_of(name, Dimension::NONE, NUMBER).into())
    }

    /// A smooth level floor acts upwards only; on a slope, weight acts along the floor as well.
    fn floor_acts(&mut self, index: usize, stage: &Bounces) {
        let is_level = stage.incline.is_none() && self.weight_has_a_component();
        let along = |position| {
            if is_level && self.downwards(position).is_none() { Effect::Of(Expr::zero()) } else { Effect::Open }
        };
        let force = (0..self.axes.len()).map(along).collect();
        self.acts(Influence { force, ..Influence::outside(index, &stage.body, stage.surface()) });
    }

    fn bounces_after_a_drop(&mut self, index: usize, stage: &Bounces, e: &Expr, count: Option<&Expr>) {
        let name = self.called(&stage.body);
        let gravity = self.gravity();
        let drop = self.drop_height(index, &stage.body);
        if index > 0 {
            let because = format!("{name} is released from rest");
            for velocity in self.velocities(&stage.body, index) {
                self.law(&kinematics::REST, Some(index), because.clone(), (velocity, Expr::zero()));
            }
        }
        let first = bouncing::first_fall(&gravity, &drop);
        let squared = Expr::product([Expr::integer(2), gravity.clone(), drop.clone()]);
        let (body, e_of_all) = (stage.body.clone(), e.clone());
        self.bounce_terms.push(BounceTerms { stage: index, body, e: e_of_all, squared, count: count.cloned() });
        let speeds = format!("{name} is dropped, and each bounce multiplies the speed by e");
        let heights = format!("{speeds}, hence the height that it reaches by the square of e");
        let times = format!("{speeds}, hence the time of each flight by e");
        let law = |builder: &mut Self, (law, because): (&'static Law, &str), (name, meaning): (Name, String), value| {
            let symbol = builder.positive(name, meaning);
            builder.law(law, Some(index), because, (symbol.into(), value));
        };
        if let Some(count) = count {
            let height = bouncing::bounce_height(e, count, &drop);
            law(
                self,
                (&bouncing::BOUNCE_HEIGHT, &heights),
                (at_bounce(QuantityKind::Height), format!("the height that {name} reaches after the n-th bounce")),
                height,
            );
            let speed = bouncing::bounce_speed(e, count, &gravity, &drop);
            law(
                self,
                (&bouncing::BOUNCE_SPEED, &speeds),
                (at_bounce(QuantityKind::Velocity), format!("the speed of {name} just after the n-th bounce")),
                speed.clone(),
            );
            let flight = bouncing::flight(&speed, &gravity);
            law(
                self,
                (&bouncing::BOUNCE_FLIGHT, &times),
                (
                    at_bounce(QuantityKind::Duration),
                    format!("the duration of the flight of {name} after the n-th bounce"),
                ),
                flight,
            );
            let time = bouncing::bounce_time(e, count, &first);
            law(
                self,
                (&bouncing::BOUNCE_TIME, &times),
                (at_bounce(QuantityKind::Time), "the time of the n-th bounce, measured from the release".into()),
                time,
            );
            self.shows(there_and_back(&first, (e, 1), Some(count)));
            let path_length = bouncing::path_to(e, count, &drop);
            law(
                self,
                (&bouncing::BOUNCE_PATH, &heights),
                (
                    at_bounce(QuantityKind::PathLength),
                    format!("the distance travelled by {name} from the release to the n-th bounce"),
                ),
                path_length,
            );
            self.shows(there_and_back(&drop, (e, 2), Some(count)));
        }
        // A ball that loses nothing does not stop.
        if e.is_one() {
            return;
        }
        let total = bouncing::total_time(e, &first);
        law(
            self,
            (&bouncing::BOUNCE_TIME, &times),
            (
                Name::of(QuantityKind::Time, IN_ALL),
                format!("the time at which {name} comes to rest, measured from the release"),
            ),
            total,
        );
        self.shows(there_and_back(&first, (e, 1), None));
        let path_length = bouncing::total_path(e, &drop);
        law(
            self,
            (&bouncing::BOUNCE_PATH, &heights),
            (Name::of(QuantityKind::PathLength, IN_ALL), format!("the total distance travelled by {name}")),
            path_length,
        );
        self.shows(there_and_back(&drop, (e, 2), None));
    }

    /// The height of the fall just before, or `h_0`.
    pub(super) fn drop_height(&mut self, index: usize, body: &str) -> Expr {
        let before = index.checked_sub(1).and_then(|before| Some((before, self.scene.stages.get(before)?)));
        let meaning = format!("the height from which {} is dropped", self.called(body));
        if let Some((before, Stage::Fall(fall))) = before
            && fall.body == body
        {
            let path = Path::root().key("scene").key("stages").index(before).key("fall").key("height");
            return self.read_positive(&fall.height, Dimension::LENGTH, &meaning, &path);
        }
        self.positive(Name::of(QuantityKind::Height, "").at(0), meaning).into()
    }
}
