//! Two bodies on a taut string over a pulley: impulse and momentum, work and energy along the string.

use crate::Because;
use crate::Builder;
use crate::Influence;
use crate::Opposing;
use crate::QuantityKind;
use crate::Reason;
use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::energy;
use momentous_laws::kinematics;
use momentous_laws::momentum;
use momentous_quantity::Dimension;
use momentous_scene::stage::Connected;
use momentous_scene::stage::MOST_STRANDS;
use momentous_scene::stage::Strand;
use momentous_scene::stage::Until;
use momentous_solve::Relation;

/// One end of the string.
struct Side {
    name: String,
    mass: Expr,
    /// Everything but the tension that acts along the string, forwards: weight and friction.
    drive: Expr,
    before: Expr,
    after: Expr,
    /// On how many strands of the string it hangs.
    strands: Expr,
}

impl Side {
    /// The velocity or the way of the string at this side, from that of its body.
    fn of_string(&self, of_body: &Expr) -> Expr {
        self.strands.clone() * of_body.clone()
    }
}

impl Builder<'_> {
    pub(crate) fn connected(&mut self, index: usize, stage: &Connected, path: &Path) {
        let stops = stage.until == Some(Until::Rest);
        let trailing = self.strand(index, &stage.trailing, -1, stops, &path.key("trailing"));
        let leading = self.strand(index, &stage.leading, 1, stops, &path.key("leading"));
        let pulley = stage.over.clone().unwrap_or_else(|| "the pulley".into());
        let duration = self.stage_duration(index, stage.duration.as_ref(), path);
        self.lasting[index] = Some(duration.clone());
        if stops {
            self.takes_time(index, &duration);
        }
        let because = "the string stays taut and does not stretch";
        let is_plain = leading.strands == trailing.strands;
        let constraint = if is_plain { &kinematics::TOGETHER } else { &kinematics::STRANDS };
        for (one, other) in [(&leading.before, &trailing.before), (&leading.after, &trailing.after)] {
            if !other.is_zero() {
                let sides = if is_plain {
                    (one.clone(), other.clone())
                } else {
                    (leading.of_string(one), trailing.of_string(other))
                };
                self.law(constraint, Some(index), because, sides);
            }
        }
        let meaning = format!("the tension of the string during {}", self.stage_phrase(index));
        let tension = Expr::from(self.symbol(self.in_stage(QuantityKind::Tension, "", index), meaning));
        let sides = [&trailing, &leading];
        let pulls = [trailing.of_string(&tension), -leading.of_string(&tension)];
        self.string_acts(index, stage, (&pulley, is_plain), pulls);
        let fact = format!(
            "the string runs freely over {pulley} and pulls both equally, {} forwards and {} back along it",
            trailing.name, leading.name
        );
        let because = Because::Conclusion(fact, "its impulses cancel in the sum".to_owned());
        let masses =
            |velocity: &dyn Fn(&Side) -> Expr| momentum::total(&sides.map(|side| (side.mass.clone(), velocity(side))));
        let driven = Expr::sum(sides.map(|side| side.drive.clone()));
        let start = Expr::sum([masses(&|side| side.before.clone()), driven.clone() * duration.clone()]);
        let end = masses(&|side| side.after.clone());
        if is_plain {
            self.law(&momentum::IMPULSE_MOMENTUM, Some(index), because, (start, end));
        }
        for (side, sign) in [(&trailing, 1), (&leading, -1)] {
            let (what, pull) = match side.strands.as_number() {
                Some(one) if one.is_one() => ("the tension".to_owned(), tension.clone()),
                _ => ("the tension of each strand".to_owned(), side.of_string(&tension)),
            };
            let pull = Expr::integer(sign) * pull;
            let because = format!("{what} and the other forces along the string change the momentum of {}", side.name);
            let impulses = [(pull + side.drive.clone()) * duration.clone()];
            let sides = momentum::impulse_momentum(&side.mass, &side.before, &impulses, &side.after);
            self.law(&momentum::IMPULSE_MOMENTUM, Some(index), because, sides);
        }
        if let Some(axis) = self.only_axis() {
            for (side, strand) in [(&trailing, &stage.trailing), (&leading, &stage.leading)] {
                self.moves_evenly((index, &strand.body), axis, [&side.before, &side.after], &duration);
            }
        }
        if let Some(term) = &stage.distance {
            let meaning = if is_plain {
                format!("how far {} and {} move", trailing.name, leading.name)
            } else {
                format!("how far {} moves", leading.name)
            };
            let distance = self.read_positive(term, Dimension::LENGTH, &meaning, &path.key("distance"));
            let kinetic = |velocity: &dyn Fn(&Side) -> Expr| {
                Expr::sum(sides.map(|side| energy::kinetic(&side.mass, &[velocity(side)])))
            };
            self.comes_evenly(index, &leading.name, &distance, [&leading.before, &leading.after], &duration);
            let run = leading.of_string(&distance);
            let works = sides
                .map(|side| Expr::product([side.drive.clone(), run.clone(), side.strands.clone().powi(-1)]).simplify());
            let fact = "the string does equal and opposite work on the two bodies".to_owned();
            let because = Because::Conclusion(fact, "its total work is zero".to_owned());
            self.goes_the_whole_way(&leading.name, kinetic(&|side| side.before.clone()), works.clone());
            let sides =
                energy::work_energy(kinetic(&|side| side.before.clone()), works, kinetic(&|side| side.after.clone()));
            self.law(&energy::WORK_ENERGY, Some(index), because, sides);
        }
        let rubs = [&stage.trailing, &stage.leading].iter().any(|strand| strand.friction.is_some());
        let opposing = rubs.then_some(Opposing::Friction);
        for speed in [&leading.before, &leading.after].into_iter().filter(|speed| !speed.is_zero()) {
            let reason = Reason::MovesBack(leading.name.clone()).against(opposing);
            self.require(speed.clone(), Relation::AtLeast, Expr::zero(), reason);
        }
        self.require(tension, Relation::AtLeast, Expr::zero(), Reason::Slack("the string".to_owned()));
        let many = [&stage.trailing, &stage.leading].iter().any(|strand| strand.strands() > 1);
        if many {
            let why = "they are light and smooth, so that the tension is the same in all strands";
            self.neglect("the masses and the friction of the pulleys", why);
        } else {
            let why = "it is light and smooth, so that the tension is the same on both sides";
            self.neglect(format!("the mass and the friction of {pulley}"), why);
        }
        self.neglect("the mass of the string", "it is light");
    }

    /// A plain string takes from one body what it gives to the other; along it the pulley, which turns it, gives nothing. The strands
    /// of a movable pulley give more than they take.
    fn string_acts(&mut self, index: usize, stage: &Connected, (pulley, is_plain): (&str, bool), pulls: [Expr; 2]) {
        let [trailing, leading] = [&stage.trailing, &stage.leading];
        for ([strand, other], pull) in [[trailing, leading], [leading, trailing]].into_iter().zip(pulls) {
            let string = Influence::outside(index, &strand.body, "the string").force(vec![pull.simplify()]);
            self.acts(if is_plain { string.by(&[&other.body]) } else { string });
            self.acts(Influence::outside(index, &strand.body, pulley).force(vec![Expr::zero()]).workless());
        }
    }

    fn weight_of(&mut self, mass: &Expr) -> Expr {
        mass.clone() * self.gravity()
    }

    /// A body on its side of the pulley: `forwards` is down (1) or up (-1) for one that hangs.
    fn strand(&mut self, index: usize, strand: &Strand, forwards: i64, stops: bool, path: &Path) -> Side {
        let body = strand.body.as_str();
        let name = self.called(body);
        let mass = self.mass(body);
        let hung = (1..=MOST_STRANDS).contains(&strand.strands()) && (strand.strands() == 1 || strand.hangs());
        if !hung {
            let message = format!("{name} cannot hang on {} strands", strand.strands());
            let help = format!("a body that hangs has 1 to {MOST_STRANDS} strands, and one that slides has one");
            self.faults.push(Fault::new(Code::Value, message).help(help).at_path(path.key("strands")));
        }
        let (along, press) = match strand.on.as_ref().map(|term| term.0.trim()) {
            None | Some("hanging") => (Expr::one(), Expr::zero()),
            Some("level") => (Expr::zero(), Expr::one()),
            Some(angle) => {
                let angle = self.read_angle(angle, &path.key("on"));
                (angle.clone().sin().simplify(), angle.cos().simplify())
            }
        };
        // On a level way weight has no part along the string.
        let pull = if along.is_zero() {
            along
        } else {
            Expr::product([Expr::integer(forwards), self.weight_of(&mass), along])
        };
        let mut parts = vec![pull];
        self.acts(Influence::outside(index, body, "weight").force(parts.clone()));
        if let (Some(_), true) = (&strand.friction, press.is_zero()) {
            let message = format!("{name} hangs on the string, and rubs on nothing");
            let help = "remove its `friction`, or say what it slides on: `on: level` or `on: alpha`";
            self.faults.push(Fault::new(Code::Value, message).help(help).at_path(path.key("friction")));
        }
        if let Some(term) = &strand.friction {
            let meaning = format!("the coefficient of kinetic friction of {name}");
            let friction = self.read_positive(term, Dimension::NONE, &meaning, &path.key("friction"));
            let friction = -Expr::product([friction, self.weight_of(&mass), press]);
            self.acts(Influence::outside(index, body, "friction").force(vec![friction.clone()]));
            parts.push(friction);
        }
        if stops {
            self.comes_to_rest(index, body);
        }
        let ends = [index + 1, index + 2].map(|instant| self.velocities(body, instant));
        let [before, after] = ends.map(|mut components| components.pop().unwrap_or_else(Expr::zero));
        self.note_impulse(index, body, "the string and weight", Vec::new());
        let after = if stops { Expr::zero() } else { after };
        Side {
            name,
            mass,
            drive: Expr::sum(parts.into_iter().filter(|part| !part.is_zero())),
            before,
            after,
            strands: Expr::integer(i64::from(strand.strands())),
        }
    }
}
