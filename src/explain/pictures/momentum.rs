//! Impulse-momentum diagrams: for each body of a stage, momentum before + impulses = momentum after.

use std::sync::Arc;

use momentous_expr::Math;
use momentous_figure::BodyMomentum;
use momentous_figure::Drawing;
use momentous_figure::MomentumDiagram;
use momentous_model::Agent;
use momentous_model::ForceKind;
use momentous_model::Impulse;
use momentous_model::QuantityKind;
use momentous_problem::Picture;
use momentous_scene::Stage;
use momentous_scene::stage::Impact;

use super::balance::Balance;
use super::balance::complete;
use super::compass::Compass;
use super::diagram_plan::Besides;
use super::diagram_plan::Plan;
use super::diagram_plan::Planned;
use super::labels::body_math;
use super::participants::Arrows;
use super::participants::Drawn;
use super::participants::Participant;
use super::quantities::Quantities;
use super::vectors::Labelled;
use super::words::diagram_wording;
use super::words::offered_wording;

fn plan(quantities: &Quantities<'_>, participants: &[Participant], stage: usize) -> Plan {
    let mut bodies = participants.to_vec();
    let besides = if let [only] = &bodies[..] { Some(Besides::of(quantities, stage, &only.body)) } else { None };
    if concerns_mass_centre(quantities) {
        let taken = |body: &str| bodies.iter().any(|named| named.body == body || named.before == body);
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
    diagram_with(quantities, compass, stage, drawn, None)
}

/// The diagram of a stage with arrows of a picture that is offered in place of its own.
pub(super) fn diagram_with(
    quantities: &Quantities<'_>,
    compass: &Compass,
    stage: usize,
    drawn: &Drawn,
    offered: Option<&Picture>,
) -> Option<Drawing> {
    let entry = quantities.scene().stages.get(stage)?;
    let Plan { rows, besides } = quantities.pictures.diagram(stage, || plan(quantities, &drawn.participants, stage))?;
    let tilted = quantities.slope(stage).map(|(rise, _)| compass.tilted(rise));
    let compass = tilted.as_ref().unwrap_or(compass);
    let with_all = besides.as_ref().map(|besides| besides.added_to(quantities));
    let with_all = with_all.as_ref().unwrap_or(quantities);
    let mut balances: Vec<Balance> =
        rows.iter().map(|row| balance(with_all, drawn.arrows, stage, row, rows.len())).collect();
    complete(&mut balances, drawn.mutual);
    if let Some(picture) = offered {
        for balance in &mut balances {
            balance.take(quantities, picture);
        }
    }
    let frame = quantities.model().frames.get(stage)?.as_ref();
    let normal = frame.and_then(|frame| quantities.direction(&frame.normal)).map(|normal| compass.angle(normal));
    let turned = frame.is_some_and(|frame| !frame.normal.turn.is_zero());
    let on_floor =
        quantities.model().forces.iter().any(|force| force.stage == stage && force.kind == ForceKind::Normal);
    let stands = on_floor || quantities.slope(stage).is_some() && !matches!(entry, Stage::Flight(_));
    let surface = if let Stage::Impact(Impact { against: Some(surface), .. }) = entry {
        // What moves is no wall.
        let moves = quantities.scene().surfaces.get(surface).is_some_and(|surface| surface.velocity.is_some());
        normal.filter(|_| !moves)
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
    let wording = match offered {
        Some(picture) => offered_wording(quantities, compass, &balances, &picture.name),
        None => diagram_wording(quantities, compass, stage, &balances),
    };
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
    let scale = |instant: usize| quantities.mass(body, instant).or((count == 1).then_some(1.0));
    let model = quantities.model();
    // Forces that depend on the position have one impulse together.
    let one_by_one = model.forces.iter().any(|force| force.stage == stage);
    let impulses = match arrows {
        Arrows::Forces if one_by_one => {
            let forces = model.forces.iter().filter(|force| force.stage == stage && force.on == *body);
            // Where the body never starts to move, no force has a time in which it changes the momentum.
            let forces = forces.filter(|force| quantities.evaluate(&force.during[0]).is_some());
            // What a guide gives is no force by its size, but an impulse all the same.
            let guides = impulses_on(quantities, stage, body).filter(|impulse| impulse.by == Agent::Guide);
            forces
                .map(|force| quantities.impulse_of_force(force))
                .chain(guides.map(|impulse| quantities.impulse(impulse)))
                .collect()
        }
        Arrows::Weight => vec![quantities.impulse_of_weight(body, stage)],
        Arrows::Resultant => vec![resultant()],
        Arrows::Impulses | Arrows::Forces => {
            // To the scale of velocities, an impulse is the change of velocity.
            let massless = quantities.mass_symbol(body, stage + 1).is_some_and(|mass| quantities.is_assumed(mass));
            let value = |impulse| if massless { None } else { quantities.impulse_value(impulse) };
            let named = impulses_on(quantities, stage, body).zip(&row.impulses);
            named.map(|(impulse, name)| Labelled { label: name.clone(), value: value(impulse) }).collect()
        }
    };
    Balance {
        body: body.clone(),
        before: Labelled {
            label: row.before.clone(),
            value: quantities.momentum_value(before, stage + 1, scale(stage + 1)),
        },
        impulses,
        after: Labelled {
            label: row.after.clone(),
            value: quantities.momentum_value(after, stage + 2, scale(stage + 2)),
        },
    }
}

/// All impulses on a body in one, where nobody needs to tell them apart; it follows from the momenta.
fn resultant() -> Labelled {
    let bound = || Arc::new(Math::Row(Vec::new()));
    let [sum, force, time] = ["\u{3a3}", "F", "t"].map(|letter| Math::Identifier(letter.to_owned()));
    let forces = Math::Row(vec![sum, force]);
    Labelled { label: Math::Integral(bound(), bound(), Arc::new(forces), Arc::new(time)), value: None }
}
