//! Strings that are jerked at the same time: each pulls along itself, and all of them are solved together.

use crate::Agent;
use crate::Builder;
use crate::Impulse;
use crate::Name;
use crate::QuantityKind;
use crate::Reason;
use crate::guide::dot;
use crate::taut_string::TautString;
use crate::weight_in_contact::Lasting;
use momentous_expr::Expr;
use momentous_fault::Path;
use momentous_laws::kinematics;
use momentous_laws::momentum;
use momentous_scene::Axis;
use momentous_scene::Plane;
use momentous_scene::stage::Taut;
use momentous_solve::Relation;

/// One of the strings, as the equations need it.
struct Pulling {
    ends: [String; 2],
    /// Its impulse on each of them.
    impulse: Expr,
    /// The components of the unit vector from the first end to the second.
    line: Vec<Expr>,
    /// Its name in a sentence.
    called: String,
}

impl Builder<'_> {
    pub(super) fn jerked_together(&mut self, index: usize, stage: &Taut, path: &Path) {
        let strings: Vec<Pulling> =
            (0..stage.strings.len()).map(|position| self.pulling(index, stage, position, path)).collect();
        let bodies = stage.jerked();
        let because = "the strings pull with equal and opposite impulses at their two ends";
        self.momentum_of_all(index, because, [&bodies, &bodies]);
        for body in &bodies {
            self.pulled_by_strings(index, body, &strings, stage, path);
        }
        for string in &strings {
            let [first, second] = string.ends.each_ref().map(|body| self.called(body));
            let because = format!(
                "{} does not stretch: once it is taut, {first} and {second} have the same velocity along it",
                string.called
            );
            let [behind, ahead] =
                string.ends.each_ref().map(|body| dot(&self.velocities(body, index + 2), &string.line));
            self.law(&kinematics::TOGETHER, Some(index), because, (ahead, behind));
            let reason = Reason::GoesSlackInJerk(first, second);
            self.require(string.impulse.clone(), Relation::AtLeast, Expr::zero(), reason);
        }
        let pulls = Expr::sum(strings.iter().map(|string| string.impulse.clone()));
        self.require(Expr::zero(), Relation::Less, pulls, Reason::NoneIsJerked);
        self.neglect("the masses of the strings", "they are light");
        if self.scene.plane == Plane::Vertical {
            let why = "it is not impulsive: its impulse during the short jerk is negligible compared with those of the strings";
            self.neglect("weight during the jerk", why);
        }
        let lasting = Lasting { index, duration: stage.duration.as_ref(), include: None, path };
        let weighed: Vec<(&str, &str)> = bodies.iter().map(|body| (*body, *body)).collect();
        self.weigh_contact(&lasting, &weighed, false);
    }

    /// A string with its impulse, which is noted on both of its ends.
    fn pulling(&mut self, index: usize, stage: &Taut, position: usize, path: &Path) -> Pulling {
        let string = &stage.strings[position];
        let at = path.key("strings").index(position).key("along");
        let direction = match &string.along {
            Some(term) => self.direction(term, &at),
            None => self.first_axis(),
        };
        let line = self.components(&direction);
        let ends = string.between.clone();
        self.lies_on_the_string(index, string.ends(), &direction);
        self.strings.push(TautString { jerk: index, ends: ends.clone(), direction });
        let [first, second] = ends.each_ref().map(|body| self.called(body));
        let called = format!("the string between {first} and {second}");
        let name = Name::of(QuantityKind::Impulse, &ends.concat()).during(self.stage_label(index));
        let meaning = format!("the impulse with which {called} pulls each of them");
        let impulse = Expr::from(self.symbol(name, meaning));
        for (on, other, sign) in [(0, 1, 1), (1, 0, -1)] {
            let components = line.iter().map(|part| Expr::integer(sign) * impulse.clone() * part.clone()).collect();
            self.impulses.push(Impulse {
                stage: index,
                on: ends[on].clone(),
                by: Agent::Body(ends[other].clone()),
                called: called.clone(),
                components,
                impulsive: true,
            });
        }
        Pulling { ends, impulse, line, called }
    }

    /// The change of momentum of one body along each axis by all strings that are tied to it.
    fn pulled_by_strings(&mut self, index: usize, body: &str, strings: &[Pulling], stage: &Taut, path: &Path) {
        let (name, mass) = (self.called(body), self.mass(body));
        let tied: Vec<&Pulling> = strings.iter().filter(|string| string.ends.iter().any(|end| end == body)).collect();
        let only = match &tied[..] {
            [one] => format!("the only impulse on {name} is that of {}", one.called),
            _ => format!("the only impulses on {name} are those of the strings that are tied to it"),
        };
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        let mut all = Vec::new();
        for (position, axis) in axes.iter().enumerate() {
            let along = self.along(*axis);
            let parts: Vec<Expr> = tied.iter().filter_map(|string| string.on(body, position)).collect();
            let [start, end] = [index + 1, index + 2].map(|instant| self.velocity(body, instant, *axis));
            let sides = momentum::impulse_momentum(&mass, &start, &parts, &end);
            self.law(&momentum::IMPULSE_MOMENTUM, Some(index), only.clone(), sides);
            let whole = Name::of(QuantityKind::Impulse, body).along(self.letter(*axis)).during(self.stage_label(index));
            let whole = Expr::from(self.symbol(whole, format!("the impulse on {name} from the strings{along}")));
            let because = format!("the impulse on {name} from the strings is its change of momentum{along}");
            let sides = momentum::impulse_momentum(&mass, &start, std::slice::from_ref(&whole), &end);
            self.law(&momentum::IMPULSE_MOMENTUM, Some(index), because, sides);
            all.push(whole);
        }
        if let [only] = &all[..] {
            self.mean_force(index, body, only, stage.duration.as_ref(), path);
        } else {
            self.resultant(index, body, &all, &format!("the impulse on {name} from the strings"));
        }
    }
}

impl Pulling {
    /// The impulse on a body along an axis: towards its other end.
    fn on(&self, body: &str, position: usize) -> Option<Expr> {
        let part = self.line.get(position).filter(|part| !part.is_zero())?;
        let sign = if self.ends[0] == body { 1 } else { -1 };
        Some(Expr::integer(sign) * self.impulse.clone() * part.clone())
    }
}
