//! Springs: conservation of energy, and between two bodies that of momentum.

use crate::Alternative;
use crate::Builder;
use crate::Effect;
use crate::Influence;
use crate::Opposing;
use crate::QuantityKind;
use crate::Reason;
use crate::builder::LAW_COST;
use crate::incline::Incline;
use crate::pair::Pair;
use crate::stored::Stored;
use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::Law;
use momentous_laws::Sides;
use momentous_laws::energy;
use momentous_laws::force;
use momentous_laws::kinematics;
use momentous_quantity::Dimension;
use momentous_scene::Term;
use momentous_scene::stage::Ends;
use momentous_scene::stage::Spring;
use momentous_scene::stage::Until;
use momentous_solve::Relation;

/// The words for the effect of a spring on the kinetic energy.
const SPRING_WORKS: &str = "the spring does work: it stores kinetic energy when it is deformed, and gives it back";

/// The deformation of a spring at both ends of a stage, and how far its end moves in between.
struct Deformation {
    before: Expr,
    after: Expr,
    travel: Expr,
}

/// The forces besides the spring while its end moves.
struct OnTheWay {
    index: usize,
    mass: Expr,
    friction: Option<Expr>,
    incline: Incline,
    /// Whether the body rises on its way.
    rises: bool,
}

impl OnTheWay {
    fn acts(&self) -> bool {
        self.friction.is_some() || !self.incline.is_level()
    }
}

impl Builder<'_> {
    pub(crate) fn spring(&mut self, index: usize, stage: &Spring, path: &Path) {
        let stiffness = self.read_positive(
            &stage.stiffness,
            Dimension::new(1, 0, -2),
            "the stiffness of the spring",
            &path.key("stiffness"),
        );
        let deformation = self.deformation(index, stage, &stiffness, path);
        let deformations = [deformation.before.clone(), deformation.after.clone()];
        self.stored.push(Stored {
            stage: index,
            called: "the spring".to_owned(),
            stiffness: stiffness.clone(),
            deformations,
        });
        match stage.ends() {
            Some(Ends::Fixed(body)) => self.fixed_spring(index, stage, body, &stiffness, &deformation, path),
            Some(Ends::Free(first, second)) => {
                self.free_spring(index, stage, [first, second], &stiffness, &deformation, path);
            }
            None => {}
        }
        self.neglect("the mass of the spring", "it is light");
    }

    /// A body that a spring carries deforms it by its weight, which acts along a vertical axis. Whether the stage leads upwards,
    /// which relaxes the spring first.
    fn presses_on_spring(&mut self, stage: &Spring, pan: &str, path: &Path) -> bool {
        let Some(down) = self.downwards(0) else {
            let message =
                format!("{} does not deform the spring: its weight does not act along the axis", self.called(pan));
            let help =
                "write the deformation at the start, `from: d`, or let the axis point up or down in a vertical plane";
            self.faults.push(Fault::new(Code::Value, message).help(help).at_path(path.key("carried")));
            return false;
        };
        let rises = self.sense(stage.direction.as_ref(), path) == -down;
        let told = match (rises, stage.travel.is_some(), stage.releases() && stage.until.is_none()) {
            (true, false, false) => Some((
                "to",
                "on its way up from rest the body relaxes the spring, and may stretch it then",
                "write how far it moves, `travel: s`; or leave out `to`, for a spring that relaxes",
            )),
            (false, _, true) => Some((
                "carried",
                "on its way down from rest the body presses the spring further, which does not relax",
                "write how far it moves, `travel: s`, or `direction: upwards`",
            )),
            _ => None,
        };
        if let Some((key, message, help)) = told {
            self.faults.push(Fault::new(Code::Value, message).help(help).at_path(path.key(key)));
        }
        rises
    }

    fn deformation(&mut self, index: usize, stage: &Spring, stiffness: &Expr, path: &Path) -> Deformation {
        let phrase = self.stage_phrase(index);
        let length = |builder: &mut Self, term: Option<&Term>, meaning: &str, key: &str| {
            term.map(|term| builder.read_positive(term, Dimension::LENGTH, meaning, &path.key(key)))
        };
        let from = format!("the deformation of the spring at the start of {phrase}");
        let to = format!("the deformation of the spring at the end of {phrase}");
        let before = length(self, stage.from.as_ref(), &from, "from");
        let after = length(self, stage.to.as_ref(), &to, "to");
        let travel = length(self, stage.travel.as_ref(), "the increase in the deformation of the spring", "travel");
        let mut rises = false;
        let before = match &stage.carried {
            Some(pan) => {
                rises = self.presses_on_spring(stage, pan, path);
                let deformation = before.unwrap_or_else(|| {
                    self.positive(self.in_stage(QuantityKind::SpringDeformation, pan, index), from).into()
                });
                let load = self.mass(pan) * self.gravity();
                let because = format!("the spring carries {} at rest", self.called(pan));
                self.law(&force::HOOKE, Some(index), because, (stiffness.clone() * deformation.clone(), load));
                deformation
            }
            None => before.unwrap_or_else(Expr::zero),
        };
        let deformation = match (after, travel) {
            (_, Some(travel)) => {
                let deformed = if rises { -travel.clone() } else { travel.clone() };
                let after = (before.clone() + deformed).simplify();
                Deformation { before, after, travel }
            }
            (Some(after), None) => {
                let travel = (after.clone() - before.clone()).simplify();
                Deformation { before, after, travel }
            }
            (None, None) => Deformation { travel: -before.clone(), before, after: Expr::zero() },
        };
        if stage.until.is_some() && stage.to.is_none() && stage.travel.is_none() {
            let message = "the greatest deformation of the spring has no name";
            let help = "write `to: s`, give or ask for `s`, or write how much further it is pressed: `travel: s`";
            self.faults.push(Fault::new(Code::MissingKey, message).help(help).at_path(path.clone()));
        }
        let is_relaxed = |term: Option<&Term>| term.is_none_or(Term::is_written_as_zero);
        let ends = [&stage.from, &stage.to, &stage.travel];
        if stage.until.is_none() && stage.carried.is_none() && ends.into_iter().all(|end| is_relaxed(end.as_ref())) {
            let message =
                "the spring is relaxed at the start and at the end, which says nothing of what happens between";
            let help = "write how far it is pressed: `from: s` for a spring that relaxes, `to: s` for one that is pressed, or \
                `until: rest` for its greatest deformation; one stage for each way";
            self.faults.push(Fault::new(Code::Value, message).help(help).at_path(path.clone()));
        }
        deformation
    }

    /// A spring whose other end is fixed.
    fn fixed_spring(
        &mut self,
        index: usize,
        stage: &Spring,
        body: &str,
        stiffness: &Expr,
        deformation: &Deformation,
        path: &Path,
    ) {
        let name = self.called(body);
        let mass = self.mass(body);
        let stops = stage.until == Some(Until::Rest);
        let opposing = stage.friction.as_ref().map(|_| Opposing::Friction);
        let way = self.one_way(index, body, stage.direction.as_ref(), stops, opposing, path);
        let incline = self.incline(index, stage.incline.as_ref(), path);
        let friction = stage.friction.as_ref().map(|term| {
            let meaning = "the coefficient of kinetic friction";
            self.read_positive(term, Dimension::NONE, meaning, &path.key("friction"))
        });
        if stage.friction.is_some() {
            self.rubs_on_a_floor(&incline, &path.key("friction"));
        }
        let rises = incline.sign * way.sign > 0;
        let on_the_way = OnTheWay { index, mass, friction, incline, rises };
        let energies = [0, 1].map(|side| {
            let deformed = [&deformation.before, &deformation.after][side];
            on_the_way.mass.clone() * way.energies[side].clone() + energy::of_spring(stiffness, deformed)
        });
        if stage.may_relax() && on_the_way.acts() && stage.carried.is_none() {
            self.further_or_back(&name, &on_the_way, &energies, &deformation.travel);
        } else {
            let length =
                if stage.releases() { -deformation.travel.clone() } else { deformation.travel.clone() }.simplify();
            if stage.carried.is_some() {
                let reason = Reason::MovesBack(name.clone());
                self.require(length.clone(), Relation::AtLeast, Expr::zero(), reason);
            }
            let (law, because, sides) = self.energies_on_the_way(&name, &on_the_way, &energies, &length);
            if !stops {
                let moving = on_the_way.mass.clone() * way.energies[1].clone();
                let left = (sides.0.clone() - sides.1.clone() + moving).simplify();
                self.goes_the_whole_way(&name, left, []);
            }
            self.law(law, Some(index), because, sides);
        }
        // Released at rest, it is at rest at once: the end of its way is the other one.
        if stops && (on_the_way.acts() || !deformation.before.is_zero()) {
            let reason = Reason::TakesTime(self.stage_phrase(index));
            self.require(deformation.travel.clone().powi(2), Relation::Greater, Expr::zero(), reason);
        }
        self.acts(Influence::outside(index, body, "the spring").works(Effect::Open, SPRING_WORKS));
        self.note_impulse(index, body, "the spring", Vec::new());
        if stage.friction.is_none() && on_the_way.incline.along != Expr::one() {
            self.neglect("friction", "the problem gives none");
        }
    }

    /// The energies of a body and its spring at both ends, with the work of friction on a way of that length.
    fn energies_on_the_way(
        &mut self,
        name: &str,
        way: &OnTheWay,
        [start, end]: &[Expr; 2],
        length: &Expr,
    ) -> (&'static Law, String, Sides) {
        let (mut start, mut end) = (start.clone(), end.clone());
        if !way.incline.is_level() {
            let weight = way.mass.clone() * self.gravity();
            let raised = Expr::product([weight, way.incline.along.clone(), length.clone()]);
            if way.rises { end = end + raised } else { start = start + raised }
        }
        let friction = way.friction.as_ref().map(|friction| {
            let press = Expr::product([way.mass.clone(), self.gravity(), way.incline.press.clone()]);
            -Expr::product([friction.clone(), press, length.clone()])
        });
        let what = if way.incline.is_level() { "the spring alone does" } else { "only the spring and weight do" };
        let (law, because) = match friction {
            None => (&energy::CONSERVATION, format!("{what} work on {name}")),
            Some(_) => (
                &energy::WORK_ENERGY,
                format!("friction takes energy from {name} over the whole distance, and the spring stores some"),
            ),
        };
        (law, because, energy::work_energy(start, friction, end))
    }

    /// The same where only the values tell whether the spring is deformed further or relaxes: on a way of either sense friction takes
    /// energy.
    fn further_or_back(&mut self, name: &str, way: &OnTheWay, energies: &[Expr; 2], travel: &Expr) {
        let senses = [
            ("the spring is deformed further", travel.clone(), Relation::AtLeast, Reason::SpringRelaxes),
            ("the spring relaxes", (-travel.clone()).simplify(), Relation::Less, Reason::SpringDeforms),
        ];
        let ways = senses.map(|(what, length, relation, reason)| {
            let mut alternative = Alternative { what: what.to_owned(), ..Alternative::default() };
            let (law, because, sides) = self.energies_on_the_way(name, way, energies, &length);
            alternative.equations.push(self.stated(LAW_COST, law, Some(way.index), because, sides, None));
            alternative.conditions.push(self.condition(travel.clone(), relation, Expr::zero(), reason));
            alternative
        });
        self.choices.push(ways.into());
    }

    /// A spring between two bodies that are free to move along one axis.
    fn free_spring(
        &mut self,
        index: usize,
        stage: &Spring,
        bodies: [&str; 2],
        stiffness: &Expr,
        deformation: &Deformation,
        path: &Path,
    ) {
        let [(axis, _)] = self.axes[..] else {
            let fault = Fault::new(Code::Value, "a spring between two bodies needs a scene with one axis");
            self.faults.push(fault.help("leave one axis, along the spring").at_path(path.clone()));
            return;
        };
        let of_a_fixed_end =
            [("friction", &stage.friction), ("incline", &stage.incline), ("direction", &stage.direction)];
        for (key, _) in of_a_fixed_end.into_iter().filter(|(_, told)| told.is_some()) {
            let message =
                format!("`{key}` cannot be used beside `between`: the two bodies move freely along their line");
            let help = format!("remove `{key}`, or name one `body` at a spring whose other end is fixed");
            self.faults.push(Fault::new(Code::Value, message).help(help).at_path(path.key(key)));
        }
        let velocities = |builder: &mut Self, instant| bodies.map(|body| builder.velocity(body, instant, axis));
        let (before, after) = (velocities(self, index + 1), velocities(self, index + 2));
        let [first, second] = bodies.map(|body| self.called(body));
        let masses = bodies.map(|body| self.mass(body));
        let total = |velocities: &[Expr; 2], deformation: &Expr| {
            let kinetic = masses.iter().zip(velocities).map(|(mass, v)| energy::kinetic(mass, std::slice::from_ref(v)));
            Expr::sum(kinetic.chain([energy::of_spring(stiffness, deformation)]))
        };
        let sides = (total(&before, &deformation.before), total(&after, &deformation.after));
        let because = format!("the spring alone does work on {first} and {second}");
        self.law(&energy::CONSERVATION, Some(index), because, sides);
        if stage.until == Some(Until::Rest) {
            let because = format!("the spring is deformed most when {first} and {second} stop approaching each other");
            self.law(&kinematics::TOGETHER, Some(index), because, (after[1].clone(), after[0].clone()));
        }
        let [one, other] = if stage.releases() { [&after, &after] } else { [&before, &before] };
        let (greater, less, reason) = if stage.releases() {
            (&one[1], &other[0], Reason::NotPushedApart(first.clone(), second.clone()))
        } else {
            (&one[0], &other[1], Reason::NotCompressed(first.clone(), second.clone()))
        };
        self.require(greater.clone(), Relation::AtLeast, less.clone(), reason);
        for [body, other] in [bodies, [bodies[1], bodies[0]]] {
            let spring = Influence::outside(index, body, "the spring").by(&[other]);
            self.acts(spring.works(Effect::Open, SPRING_WORKS));
        }
        let pair = Pair { index, bodies, before, after, link: "the spring", line: "it", pulley: None };
        self.pair(&pair, None, &|_, impulse| vec![impulse.clone()], None, path);
        self.neglect("friction and other resistance", "the problem gives none");
    }
}
