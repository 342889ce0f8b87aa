//! Impulse-momentum diagrams: for each body of a stage, momentum before + impulses = momentum after.

use std::sync::Arc;

use crate::expr::Math;
use crate::figure::BodyMomentum;
use crate::figure::Drawing;
use crate::figure::Form;
use crate::figure::MomentumDiagram;
use crate::model::ForceKind;
use crate::model::Impulse;
use crate::model::QuantityKind;
use crate::scene::Stage;
use crate::scene::stage::Ends;
use crate::scene::stage::Impact;
use crate::scene::stage::Partners;

use super::super::cache::SolutionCache;
use super::besides::Besides;
use super::compass::Compass;
use super::quantities::Quantities;
use super::vectors::Labelled;
use super::vectors::body_math;
use super::words::diagram_wording;

/// One body in one stage, along x and y of the scene.
#[derive(Clone, Debug)]
pub(super) struct Balance {
    pub body: String,
    pub before: Labelled,
    pub impulses: Vec<Labelled>,
    pub after: Labelled,
}

/// The diagram of a stage, as far as no number changes it.
pub(in super::super) struct Plan {
    rows: Vec<Planned>,
    /// What the arrows of a body that takes part alone need besides.
    besides: Option<Besides>,
}

/// The row of a body.
struct Planned {
    participant: Participant,
    name: Math,
    form: Form,
    /// How its momentum is written before and after, and each impulse on it.
    before: Math,
    after: Math,
    impulses: Vec<Math>,
}

fn plan(quantities: &Quantities<'_>, own: &Stage, stage: usize) -> Plan {
    let mut bodies = Drawn::of(own).participants;
    let besides = if let [only] = &bodies[..] { Some(Besides::of(quantities, stage, &only.body)) } else { None };
    if concerns_mass_centre(quantities) {
        let taken = |body: &str| bodies.iter().any(|own| own.body == body || own.before == body);
        let others: Vec<String> =
            quantities.timeline.alive(stage + 1).into_iter().filter(|body| !taken(body)).map(str::to_owned).collect();
        bodies.extend(others.iter().map(|body| Participant::alone(body)));
        bodies.sort();
    }
    let row = |participant: Participant| {
        let Participant { body, before, after } = &participant;
        let impulses = impulses_on(quantities, stage, body).map(|impulse| quantities.impulse_name(impulse));
        Planned {
            name: body_math(body),
            form: quantities.form(body),
            before: quantities.momentum_name(body, before, stage + 1),
            after: quantities.momentum_name(body, after, stage + 2),
            impulses: impulses.collect(),
            participant,
        }
    };
    Plan { rows: bodies.into_iter().map(row).collect(), besides }
}

fn impulses_on<'a>(quantities: &Quantities<'a>, stage: usize, body: &str) -> impl Iterator<Item = &'a Impulse> {
    quantities.model().impulses.iter().filter(move |impulse| impulse.stage == stage && impulse.on == body)
}

/// The diagram of a stage.
pub(super) fn diagram(quantities: &Quantities<'_>, compass: &Compass, stage: usize) -> Option<Drawing> {
    let own = quantities.scene().stages.get(stage)?;
    let cache = SolutionCache::of(quantities.worked);
    let kept = cache.way(quantities.worked).diagrams.get(stage)?;
    let Plan { rows, besides } = kept.get_or_init(|| plan(quantities, own, stage));
    let tilted = quantities.slope(stage).map(|(rise, _)| compass.tilted(rise));
    let compass = tilted.as_ref().unwrap_or(compass);
    let with_all = besides.as_ref().map(|own| own.added_to(quantities));
    let with_all = with_all.as_ref().unwrap_or(quantities);
    let mut balances: Vec<Balance> = rows.iter().map(|row| balance(with_all, own, stage, row, rows.len())).collect();
    complete(&mut balances, Drawn::of(own).mutual);
    let frame = quantities.model().frames.get(stage)?.as_ref();
    let normal = frame.and_then(|frame| quantities.direction(&frame.normal)).map(|normal| compass.angle(normal));
    let turned = frame.is_some_and(|frame| !frame.normal.turn.is_zero());
    let on_floor =
        quantities.model().forces.iter().any(|force| force.stage == stage && force.kind == ForceKind::Normal);
    let stands = on_floor || quantities.slope(stage).is_some() && !matches!(own, Stage::Flight(_));
    let surface = if matches!(own, Stage::Impact(Impact { against: Some(_), .. })) {
        normal
    } else {
        stands.then(|| compass.angle([0.0, 1.0]))
    };
    let rows = balances.iter().zip(rows).map(|(balance, row)| BodyMomentum {
        name: row.name.clone(),
        form: row.form,
        surface,
        line_of_impact: normal.filter(|_| turned && surface.is_none()),
        before: balance.before.placed(compass),
        impulses: balance.impulses.iter().map(|impulse| impulse.placed(compass)).collect(),
        after: balance.after.placed(compass),
    });
    let wording = diagram_wording(quantities, compass, stage, &balances);
    let diagram = MomentumDiagram { wording, bodies: rows.collect(), axes: compass.marks() };
    Some(diagram.drawing())
}

/// Whether anything in the problem speaks of the centre of mass.
pub(super) fn concerns_mass_centre(quantities: &Quantities<'_>) -> bool {
    let model = quantities.model();
    model
        .symbols
        .iter()
        .map(|(symbol, _)| model.name(symbol))
        .any(|name| name.is_of_mass_centre() && matches!(name.kind, QuantityKind::Velocity | QuantityKind::Position))
}

/// Who takes part in a stage, and with which body it moves at either end.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Participant {
    body: String,
    before: String,
    after: String,
}

impl Participant {
    fn alone(body: &str) -> Self {
        Self::between(body, body, body)
    }

    fn between(body: &str, before: &str, after: &str) -> Self {
        let [body, before, after] = [body, before, after].map(str::to_owned);
        Self { body, before, after }
    }
}

/// What the diagram of a stage shows.
struct Drawn {
    participants: Vec<Participant>,
    /// What is drawn between the momenta.
    arrows: Arrows,
    /// Whether two bodies act on each other, with equal and opposite impulses.
    mutual: bool,
}

/// What changes a momentum.
#[derive(Clone, Copy)]
enum Arrows {
    /// Each impulse.
    Impulses,
    /// The impulse of each force.
    Forces,
    /// The impulse of weight.
    Weight,
    /// All impulses in one.
    Resultant,
}

impl Drawn {
    fn of(stage: &Stage) -> Self {
        let alone = |body: &str| vec![Participant::alone(body)];
        let several = |bodies: &[String]| bodies.iter().map(|body| Participant::alone(body)).collect();
        let drawn = |participants, arrows| Self { participants, arrows, mutual: false };
        match stage {
            Stage::Impact(impact) => {
                let participants = match impact.partners() {
                    Some(Partners::Bodies(first, second)) => {
                        let after = |body| Participant::between(body, body, impact.becomes.as_deref().unwrap_or(body));
                        [first, second].map(after).to_vec()
                    }
                    Some(Partners::Surface(body, _)) => alone(body),
                    None => Vec::new(),
                };
                Self { participants, arrows: Arrows::Impulses, mutual: impact.between.is_some() }
            }
            Stage::Separate(separate) => {
                let before = |part| Participant::between(part, separate.from.as_deref().unwrap_or(part), part);
                let participants = separate.into.iter().map(|part| before(part)).collect();
                Self { participants, arrows: Arrows::Impulses, mutual: true }
            }
            Stage::Spring(own) => match own.ends() {
                Some(Ends::Free(first, second)) => {
                    let participants = [first, second].map(Participant::alone).to_vec();
                    Self { participants, arrows: Arrows::Impulses, mutual: true }
                }
                Some(Ends::Fixed(body)) => drawn(alone(body), Arrows::Resultant),
                None => drawn(Vec::new(), Arrows::Resultant),
            },
            Stage::Taut(own) => Self { mutual: own.over.is_none(), ..drawn(several(&own.between), Arrows::Impulses) },
            Stage::Flight(own) => drawn(own.flying().map(Participant::alone).collect(), Arrows::Weight),
            Stage::Fall(own) => drawn(alone(&own.body), Arrows::Weight),
            Stage::Interact(own) => drawn(several(&own.between), Arrows::Resultant),
            Stage::SlideOff(own) => {
                drawn([&own.body, &own.on].map(|body| Participant::alone(body)).to_vec(), Arrows::Resultant)
            }
            Stage::Push(own) => drawn(alone(&own.body), Arrows::Forces),
            Stage::Slide(own) => drawn(alone(&own.body), Arrows::Forces),
            Stage::Tow(own) => drawn(own.both().map(|own| Participant::alone(&own.body)).to_vec(), Arrows::Forces),
            Stage::Blow(own) => drawn(alone(&own.body), Arrows::Impulses),
            Stage::Motion(own) => drawn(alone(&own.body), Arrows::Impulses),
            Stage::Swing(_)
            | Stage::Connected(_)
            | Stage::Rotate(_)
            | Stage::Moment(_)
            | Stage::Strike(_)
            | Stage::Conical(_)
            | Stage::Bowl(_)
            | Stage::Central(_)
            | Stage::Bounces(_)
            | Stage::Stream(_)
            | Stage::Thrust(_)
            | Stage::Drift(_)
            | Stage::Walk(_) => drawn(Vec::new(), Arrows::Impulses),
        }
    }
}

fn balance(quantities: &Quantities<'_>, own: &Stage, stage: usize, row: &Planned, count: usize) -> Balance {
    let Participant { body, before, after } = &row.participant;
    // Alone in its diagram, a body of unknown mass is drawn to the scale of its velocities.
    let scale = quantities.mass(body).or((count == 1).then_some(1.0));
    let model = quantities.model();
    // Forces that depend on the position have one impulse together.
    let one_by_one = model.forces.iter().any(|force| force.stage == stage);
    let impulses = match Drawn::of(own).arrows {
        Arrows::Forces if one_by_one => {
            let forces = model.forces.iter().filter(|force| force.stage == stage && force.on == *body);
            // Where the body never starts to move, no force has a time in which it changes the momentum.
            let forces = forces.filter(|force| quantities.evaluate(&force.during[0]).is_some());
            forces.map(|force| quantities.impulse_of_force(force)).collect()
        }
        Arrows::Weight => vec![quantities.impulse_of_weight(body)],
        Arrows::Resultant => vec![resultant()],
        Arrows::Impulses | Arrows::Forces => {
            // To the scale of velocities, an impulse is the change of velocity.
            let massless = quantities.mass_symbol(body).is_some_and(|mass| quantities.is_assumed(mass));
            let value = |impulse| if massless { None } else { quantities.impulse_value(impulse) };
            let named = impulses_on(quantities, stage, body).zip(&row.impulses);
            named.map(|(impulse, name)| Labelled { label: name.clone(), value: value(impulse) }).collect()
        }
    };
    Balance {
        body: body.clone(),
        before: Labelled { label: row.before.clone(), value: quantities.momentum_value(before, stage + 1, scale) },
        impulses,
        after: Labelled { label: row.after.clone(), value: quantities.momentum_value(after, stage + 2, scale) },
    }
}

/// All impulses on a body in one, where nobody needs to tell them apart; it follows from the momenta.
fn resultant() -> Labelled {
    let bound = || Arc::new(Math::Row(Vec::new()));
    let [sum, force, time] = ["\u{3a3}", "F", "t"].map(|letter| Math::Identifier(letter.to_owned()));
    let forces = Math::Row(vec![sum, force]);
    Labelled { label: Math::Integral(bound(), bound(), Arc::new(forces), Arc::new(time)), value: None }
}

/// What a plan that is no longer than needed has not solved: the last unknown of each body follows from the others, and
/// the impulse on one of two bodies from that on the other.
pub(super) fn complete(balances: &mut [Balance], act_on_each_other: bool) {
    balances.iter_mut().for_each(Balance::complete);
    if let (true, [first, second]) = (act_on_each_other, &mut *balances) {
        second.take_reaction(first);
        first.take_reaction(second);
        balances.iter_mut().for_each(Balance::complete);
    }
}

impl Balance {
    fn vectors(&mut self) -> Vec<(f64, &mut Option<[f64; 2]>)> {
        let impulses = self.impulses.iter_mut().map(|impulse| (1.0, &mut impulse.value));
        let ends = [(1.0, &mut self.before.value), (-1.0, &mut self.after.value)];
        ends.into_iter().chain(impulses).collect()
    }

    /// The one vector that is missing; momentum before + impulses - momentum after = 0.
    fn complete(&mut self) {
        let mut vectors = self.vectors();
        let sum = vectors.iter().filter_map(|(sign, value)| Some((*sign, (**value)?)));
        let [x, y] = sum.fold([0.0, 0.0], |[x, y], (sign, value)| [x + sign * value[0], y + sign * value[1]]);
        let mut missing = vectors.iter_mut().filter(|(_, value)| value.is_none());
        if let (Some((sign, value)), None) = (missing.next(), missing.next()) {
            **value = Some([-*sign * x, -*sign * y]);
        }
    }

    fn take_reaction(&mut self, other: &Self) {
        // The first impulse is the one that the two give each other; a guide may add another.
        if let ([own, ..], [other, ..]) = (&mut self.impulses[..], &other.impulses[..]) {
            own.value = own.value.or(other.value.map(|[x, y]| [-x, -y]));
        }
    }
}
