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
use crate::scene::stage::Impact;

use super::besides::Besides;
use super::compass::Compass;
use super::participants::Arrows;
use super::participants::Drawn;
use super::participants::Participant;
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
pub(super) struct Plan {
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

fn plan(quantities: &Quantities<'_>, participants: &[Participant], stage: usize) -> Plan {
    let mut bodies = participants.to_vec();
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
pub(super) fn diagram(quantities: &Quantities<'_>, compass: &Compass, stage: usize, drawn: &Drawn) -> Option<Drawing> {
    let own = quantities.scene().stages.get(stage)?;
    let Plan { rows, besides } = quantities.pictures.diagram(stage, || plan(quantities, &drawn.participants, stage))?;
    let tilted = quantities.slope(stage).map(|(rise, _)| compass.tilted(rise));
    let compass = tilted.as_ref().unwrap_or(compass);
    let with_all = besides.as_ref().map(|own| own.added_to(quantities));
    let with_all = with_all.as_ref().unwrap_or(quantities);
    let mut balances: Vec<Balance> =
        rows.iter().map(|row| balance(with_all, drawn.arrows, stage, row, rows.len())).collect();
    complete(&mut balances, drawn.mutual);
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

fn balance(quantities: &Quantities<'_>, arrows: Arrows, stage: usize, row: &Planned, count: usize) -> Balance {
    let Participant { body, before, after } = &row.participant;
    // Alone in its diagram, a body of unknown mass is drawn to the scale of its velocities.
    let scale = quantities.mass(body).or((count == 1).then_some(1.0));
    let model = quantities.model();
    // Forces that depend on the position have one impulse together.
    let one_by_one = model.forces.iter().any(|force| force.stage == stage);
    let impulses = match arrows {
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
