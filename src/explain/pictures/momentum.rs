//! Impulse-momentum diagrams: for each body of a stage, momentum before + impulses = momentum after.

use crate::figure::BodyMomentum;
use crate::figure::Drawing;
use crate::figure::MomentumDiagram;
use crate::model::ForceKind;
use crate::scene::Stage;
use crate::scene::stage::Ends;
use crate::scene::stage::Partners;

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

/// The diagram of a stage.
pub(super) fn diagram(quantities: &Quantities<'_>, compass: &Compass, stage: usize) -> Option<Drawing> {
    let own = quantities.scene().stages.get(stage)?;
    let mut bodies = participants(own);
    if concerns_mass_centre(quantities) {
        let taken = |body: &str| bodies.iter().any(|own| own.body == body || own.before == body);
        let others: Vec<String> =
            quantities.timeline.alive(stage + 1).into_iter().filter(|body| !taken(body)).map(str::to_owned).collect();
        bodies.extend(others.iter().map(|body| Participant::alone(body)));
        bodies.sort();
    }
    let mut balances: Vec<Balance> =
        bodies.iter().map(|participant| balance(quantities, own, stage, participant, bodies.len())).collect();
    let act_on_each_other = match own {
        Stage::Impact(impact) => impact.between.is_some(),
        Stage::Spring(spring) => spring.between.is_some(),
        Stage::Taut(taut) => taut.over.is_none(),
        Stage::Separate(_) => true,
        _ => false,
    };
    complete(&mut balances, act_on_each_other);
    let frame = quantities.model().frames.get(stage)?.as_ref();
    let normal = frame.and_then(|frame| quantities.direction(&frame.normal)).map(|normal| compass.angle(normal));
    let turned = frame.is_some_and(|frame| !frame.normal.turn.is_zero());
    let on_floor =
        quantities.model().forces.iter().any(|force| force.stage == stage && force.kind == ForceKind::Normal);
    let surface = match own {
        Stage::Impact(impact) if impact.against.is_some() => normal,
        _ => on_floor.then(|| compass.angle([0.0, 1.0])),
    };
    let rows = balances.iter().map(|balance| BodyMomentum {
        name: body_math(&balance.body),
        form: quantities.form(&balance.body),
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

/// Whether nothing tells for how long the forces of a stage act, so that their impulses are not known.
pub(super) fn has_no_time(quantities: &Quantities<'_>, stage: usize) -> bool {
    let mut own = quantities.model().forces.iter().filter(|force| force.stage == stage);
    own.any(|force| quantities.evaluate(&force.during[1]).is_none())
}

/// Whether anything in the problem speaks of the mass centre.
pub(super) fn concerns_mass_centre(quantities: &Quantities<'_>) -> bool {
    let is_of_centre = |name: &str| name.starts_with("v_G") || name.starts_with("r_G");
    quantities.model().symbols.iter().any(|(_, entry)| is_of_centre(&entry.name))
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

fn participants(stage: &Stage) -> Vec<Participant> {
    let alone = |body: &str| vec![Participant::alone(body)];
    match stage {
        Stage::Impact(impact) => match impact.partners() {
            Some(Partners::Bodies(first, second)) => {
                let after = |body| Participant::between(body, body, impact.becomes.as_deref().unwrap_or(body));
                [first, second].map(after).to_vec()
            }
            Some(Partners::Surface(body, _)) => alone(body),
            None => Vec::new(),
        },
        Stage::Separate(separate) => {
            let before = |part| Participant::between(part, separate.from.as_deref().unwrap_or(part), part);
            separate.into.iter().map(|part| before(part)).collect()
        }
        Stage::Flight(stage) => stage.flying().map(Participant::alone).collect(),
        Stage::Push(stage) => alone(&stage.body),
        Stage::Slide(stage) => alone(&stage.body),
        Stage::Spring(stage) => match stage.ends() {
            Some(Ends::Free(first, second)) => [first, second].map(Participant::alone).to_vec(),
            Some(Ends::Fixed(body)) => alone(body),
            None => Vec::new(),
        },
        Stage::Taut(stage) => stage.between.iter().map(|body| Participant::alone(body)).collect(),
        Stage::Blow(stage) => alone(&stage.body),
        Stage::Fall(stage) => alone(&stage.body),
        Stage::Swing(_)
        | Stage::Connected(_)
        | Stage::Rotate(_)
        | Stage::Moment(_)
        | Stage::Strike(_)
        | Stage::Conical(_)
        | Stage::Bowl(_)
        | Stage::Interact(_)
        | Stage::Central(_)
        | Stage::Bounces(_)
        | Stage::Stream(_)
        | Stage::Thrust(_)
        | Stage::Drift(_)
        | Stage::SlideOff(_)
        | Stage::Walk(_) => Vec::new(),
    }
}

fn balance(
    quantities: &Quantities<'_>,
    own: &Stage,
    stage: usize,
    Participant { body, before, after }: &Participant,
    count: usize,
) -> Balance {
    // Alone in its diagram, a body of unknown mass is drawn to the scale of its velocities.
    let scale = quantities.mass(body).or((count == 1).then_some(1.0));
    let model = quantities.model();
    let impulses = match own {
        Stage::Push(_) | Stage::Slide(_) => {
            let forces = model.forces.iter().filter(|force| force.stage == stage && force.on == *body);
            // Where the body never starts to move, no force has a time in which it changes the momentum.
            let forces = forces.filter(|force| quantities.evaluate(&force.during[0]).is_some());
            forces.map(|force| quantities.impulse_of_force(force)).collect()
        }
        Stage::Fall(_) | Stage::Flight(_) => vec![quantities.impulse_of_weight(body)],
        _ => {
            let impulses = model.impulses.iter().filter(|impulse| impulse.stage == stage && impulse.on == *body);
            impulses.map(|impulse| quantities.impulse(impulse)).collect()
        }
    };
    Balance {
        body: body.clone(),
        before: quantities.momentum(body, before, stage + 1, scale),
        impulses,
        after: quantities.momentum(body, after, stage + 2, scale),
    }
}

/// What a plan that is no longer than needed has not solved: the last unknown of each body follows from the others, and
/// the impulse on one of two bodies from that on the other.
fn complete(balances: &mut [Balance], act_on_each_other: bool) {
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
