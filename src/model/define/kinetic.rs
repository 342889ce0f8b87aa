//! Kinetic energies, and what a stage loses.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::Law;
use momentous_laws::energy;
use momentous_scene::Stage;
use momentous_scene::stage::MassChange;

use super::super::Because;
use super::super::Builder;
use super::super::Name;
use super::super::QuantityKind;
use super::super::stored::is_spring;
use super::relative::energy_of_the_centre;
use super::spring::energy_of_spring;

pub(super) fn kinetic_energy(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let instant = builder.number(name)?;
    if name.is_of_mass_centre() {
        return energy_of_the_centre(builder, instant);
    }
    let when = builder.when(instant);
    let (whose, bodies) = if name.subject.is_empty() {
        ("the system".to_owned(), builder.timeline.alive(instant).into_iter().map(str::to_owned).collect())
    } else {
        let (body, _) = builder.body_at(name)?;
        (builder.called(&body), vec![body])
    };
    let whose = if bodies.len() == 1 { builder.called(&bodies[0]) } else { whose };
    let symbol = builder.symbol(builder.canonical(name), format!("the kinetic energy of {whose} {when}"));
    let terms: Vec<Expr> = bodies.iter().map(|body| builder.kinetic_term(body, instant)).collect();
    builder.law(&energy::KINETIC, None, Because::Definition, (symbol.into(), Expr::sum(terms)));
    let turned: Option<Vec<Expr>> = bodies.iter().map(|body| builder.kinetic_turned(body, instant)).collect();
    if let Some(terms) = turned {
        builder.law(&energy::KINETIC, None, Because::Definition, (symbol.into(), Expr::sum(terms)));
    }
    Some(symbol)
}

/// The potential energy of a spring, or of a body's weight, where an axis points up or down.
pub(super) fn potential_energy(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    if is_spring(builder.scene, name) {
        return energy_of_spring(builder, name);
    }
    let (body, instant) = builder.body_at(name)?;
    let (position, down) = (0..builder.axes.len()).find_map(|place| Some((place, builder.downwards(place)?)))?;
    let axis = builder.axes.get(position)?.0;
    let (owner, when) = (builder.called(&body), builder.when(instant));
    let symbol = builder.symbol(
        Name { subject: body.clone(), ..name.clone() }.at(instant),
        format!("the potential energy of {owner} {when}"),
    );
    let height = Expr::integer(-down) * builder.place(&body, instant, axis);
    let (mass, gravity) = (builder.mass_at(&body, instant), builder.gravity());
    let sides = (symbol.into(), Expr::product([mass, gravity, height]));
    builder.law(&energy::POTENTIAL, None, Because::Definition, sides);
    Some(symbol)
}

pub(super) fn energy_lost(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    if let Some(symbol) = builder.loss_of_a_bounce(name) {
        return Some(symbol);
    }
    let stage = balanced_stage(builder, name, &builder.impacts())?;
    if let Some(symbol) = builder.loss_in_all_bounces(stage) {
        return Some(symbol);
    }
    if let Some(Stage::Stream(_)) = builder.scene.stages.get(stage) {
        return builder.lost_in_stream(stage);
    }
    let meaning = format!("the kinetic energy lost in {}", builder.stage_phrase(stage));
    balance_of_energy(builder, &energy::LOSS, stage, QuantityKind::EnergyLost, meaning)
}

pub(super) fn energy_gained(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let stage = balanced_stage(builder, name, &(0..builder.scene.stages.len()).collect::<Vec<_>>())?;
    let meaning = format!("the kinetic energy gained in {}", builder.stage_phrase(stage));
    balance_of_energy(builder, &energy::GAIN, stage, QuantityKind::EnergyGained, meaning)
}

/// The work of all forces in a stage, by what it makes of the kinetic energy.
pub(super) fn work(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let stage = balanced_stage(builder, name, &(0..builder.scene.stages.len()).collect::<Vec<_>>())?;
    let meaning = format!("the work done during {}", builder.stage_phrase(stage));
    let name = builder.in_stage(QuantityKind::Work, "", stage);
    let symbol = builder.symbol(name, meaning);
    builder.check_energy(stage, |_| true);
    let [before, after] = builder.kinetic_energies(stage);
    let sides = energy::work_energy(before?.into(), [symbol.into()], after?.into());
    builder.law(&energy::WORK_ENERGY, Some(stage), Because::Definition, sides);
    Some(symbol)
}

/// The stage that a name says, or the only one that could be meant.
fn balanced_stage(builder: &Builder<'_>, name: &Name, meant: &[usize]) -> Option<usize> {
    match &name.stage {
        Some(stage) => {
            builder.timeline.stage(builder.scene, stage).or_else(|| stage.parse::<usize>().ok()?.checked_sub(1))
        }
        None => match meant {
            [only] => Some(*only),
            _ => None,
        },
    }
}

/// A name for how much the kinetic energy of all bodies changes in a stage.
fn balance_of_energy(
    builder: &mut Builder<'_>,
    law: &'static Law,
    stage: usize,
    kind: QuantityKind,
    meaning: String,
) -> Option<Symbol> {
    let name = builder.in_stage(kind, "", stage);
    let key = format!("balance {name}");
    let symbol = builder.symbol(name, meaning);
    builder.check_energy(stage, |change| !change.gains || change.velocity.is_some());
    let [before, after] = builder.kinetic_energies(stage);
    let [before, after] = [Expr::from(before?), Expr::from(after?)];
    // A stage may be named in several ways: `T_lost` and `T_lost[1]`.
    if !builder.defined.insert(key) {
        return Some(symbol);
    }
    let change = if law.id == energy::LOSS.id { before - after } else { after - before };
    builder.law(law, Some(stage), Because::Definition, (symbol.into(), change));
    Some(symbol)
}

impl Builder<'_> {
    /// The kinetic energies of all bodies before and after a stage.
    fn kinetic_energies(&mut self, stage: usize) -> [Option<Symbol>; 2] {
        [stage + 1, stage + 2].map(|instant| self.quantity(Name::of(QuantityKind::KineticEnergy, "").at(instant)))
    }

    /// Matter that joins a body, leaves it or is thrown away carries kinetic energy that is no work and no loss.
    fn check_energy(&mut self, stage: usize, carries: impl Fn(&MassChange<'_>) -> bool) {
        let entry = self.scene.stages.get(stage);
        let joining = if let Some(Stage::Push(push)) = entry {
            push.mass_change().filter(carries).map(|change| (change.name, "push", change.key()))
        } else {
            matches!(entry, Some(Stage::Thrust(_))).then_some(("the exhaust", "thrust", "exhaust"))
        };
        let Some((name, at, key)) = joining else { return };
        let message = format!("the kinetic energy that {name} carries with it is neither work nor loss");
        let help = "ask for the kinetic energies at both ends: `T_1`, `T_2`";
        let path = Path::root().key("scene").key("stages").index(stage).key(at).key(key);
        self.faults.push(Fault::new(Code::Value, message).help(help).at_path(path));
    }

    /// The stages that are impacts; else those of bounces, and all of them where there are none.
    fn impacts(&self) -> Vec<usize> {
        let all: Vec<usize> = (0..self.scene.stages.len()).collect();
        let those = |is_one: fn(&Stage) -> bool| {
            all.iter().copied().filter(|index| self.scene.stages.get(*index).is_some_and(is_one)).collect::<Vec<_>>()
        };
        let sudden =
            [those(|stage| matches!(stage, Stage::Impact(_))), those(|stage| matches!(stage, Stage::Bounces(_)))];
        sudden.into_iter().find(|stages| !stages.is_empty()).unwrap_or(all)
    }
}

impl Builder<'_> {
    /// The kinetic energy of a body as a term in the components that its impact has made.
    pub(crate) fn kinetic_of(&mut self, body: &str, instant: usize) -> Expr {
        self.kinetic_turned(body, instant).unwrap_or_else(|| self.kinetic_term(body, instant))
    }

    /// The kinetic energy of a body as a term in its velocity.
    pub(crate) fn kinetic_term(&mut self, body: &str, instant: usize) -> Expr {
        if let Some(turning) = self.kinetic_of_rotor(body, instant) {
            return turning;
        }
        let mass = self.mass_at(body, instant);
        if self.axes.is_empty() {
            let speed = self.quantity(Name::of(QuantityKind::Speed, body).at(instant));
            let speed = speed.map_or_else(Expr::zero, Expr::from);
            return energy::kinetic(&mass, &[speed]);
        }
        let components = self.velocities(body, instant);
        energy::kinetic(&mass, &components)
    }

    /// The same in components along and across a line of impact, where those were made.
    fn kinetic_turned(&mut self, body: &str, instant: usize) -> Option<Expr> {
        let stage = [instant.checked_sub(2), instant.checked_sub(1)].into_iter().flatten().find(|stage| {
            self.frames
                .get(*stage)
                .is_some_and(|frame| frame.as_ref().is_some_and(|frame| !frame.normal.turn.is_zero()))
        })?;
        let frame = self.frames.get(stage)?.clone()?;
        let split = self.split(body, instant, stage, &frame);
        let mass = self.mass_at(body, instant);
        Some(energy::kinetic(&mass, &[split.along, split.across?]))
    }
}
