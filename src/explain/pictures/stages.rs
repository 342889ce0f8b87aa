//! Drawings of each kind of stage: on the problem sheet, in the solution, and in its diagram of momenta.

use momentous_figure::Drawing;
use momentous_problem::Picture;
use momentous_scene::Force;
use momentous_scene::Plane;
use momentous_scene::Stage;
use momentous_scene::Strength;
use momentous_scene::stage::Ends;
use momentous_scene::stage::Partners;
use momentous_scene::stage::Push;
use momentous_scene::stage::Slide;
use momentous_scene::stage::Swing;
use momentous_scene::stage::Taut;

use super::angular;
use super::arm;
use super::compass::Compass;
use super::curve;
use super::flow;
use super::free_body;
use super::graph;
use super::moment;
use super::momentum;
use super::participants::Arrows;
use super::participants::Drawn;
use super::participants::Participant;
use super::principle;
use super::quantities::Quantities;
use super::resisted;
use super::sheet;
use super::snapshot;
use super::string;

/// The figure of the problem sheet, by what happens first; none where nothing that is given can be drawn.
pub(super) fn sheet(quantities: &Quantities<'_>, compass: &Compass) -> Option<Drawing> {
    if let Some(graph) = &quantities.model().graph {
        return graph::force_plot(quantities, graph.stage);
    }
    match quantities.scene().stages.first() {
        Some(Stage::Interact(interact)) if interact.friction.is_some() => {
            sheet::ride::rub(quantities, compass, interact)
        }
        None | Some(Stage::Interact(_)) => snapshot::drawing(quantities, compass),
        Some(Stage::Impact(impact)) => sheet::contact::drawing(quantities, compass, impact)
            .or_else(|| sheet::line::drawing(quantities, compass, 0)),
        Some(Stage::Push(push)) if is_graph(push) => graph::force_plot(quantities, 0),
        Some(Stage::Push(push)) if push.is_of_several() => {
            snapshot::pushed(quantities, compass).or_else(|| sheet::line::drawing(quantities, compass, 0))
        }
        Some(Stage::Push(_)) => {
            snapshot::in_space(quantities, compass).or_else(|| sheet::line::drawing(quantities, compass, 0))
        }
        Some(Stage::Slide(slide @ Slide { on: Some(on), .. })) => {
            Some(sheet::carried::on_face(quantities, compass, 0, slide, on))
        }
        Some(Stage::Swing(swing @ Swing { on: Some(on), .. })) => {
            Some(sheet::carried::on_circle(quantities, compass, 0, swing, on))
        }
        Some(Stage::Slide(slide)) if slide.is_ramp() => Some(sheet::ramp::drawing(quantities, compass, 0, slide)),
        Some(Stage::Taut(Taut { between: Some(both), over: Some(_), .. })) => {
            Some(sheet::pulley::taut(quantities, 0, both))
        }
        Some(Stage::Blow(_) | Stage::Taut(_))
            if let Some(jerk) = sheet::strung::jerked(&quantities.scene().stages, 0) =>
        {
            sheet::strung::drawing(quantities, compass, 0, jerk)
                .or_else(|| sheet::line::drawing(quantities, compass, 0))
        }
        Some(Stage::Blow(blow)) => {
            sheet::contact::cushion(quantities, compass, blow).or_else(|| sheet::line::drawing(quantities, compass, 0))
        }
        Some(
            Stage::Slide(_)
            | Stage::Spring(_)
            | Stage::Taut(_)
            | Stage::Tow(_)
            | Stage::Motion(_)
            | Stage::Separate(_)
            | Stage::Drift(_),
        ) => sheet::line::drawing(quantities, compass, 0),
        Some(Stage::Flight(flight)) => sheet::flight::drawing(quantities, compass, 0, flight)
            .or_else(|| sheet::line::drawing(quantities, compass, 0)),
        Some(Stage::Rotate(rotate)) => sheet::central::on_arm(quantities, rotate),
        Some(Stage::Central(stage)) => sheet::central::under_force(quantities, stage),
        Some(Stage::Swing(swing)) => Some(sheet::swing::drawing(quantities, compass, 0, swing)),
        Some(Stage::Connected(connected)) => Some(sheet::pulley::connected(quantities, 0, connected)),
        Some(Stage::SlideOff(slide)) => Some(sheet::ride::slide(quantities, compass, slide)),
        Some(Stage::Walk(walk)) => sheet::ride::walk(quantities, compass, 0, walk),
        Some(Stage::Moment(stage)) => Some(moment::sheet(quantities, compass, stage)),
        Some(Stage::Strike(stage)) => Some(arm::strike_sheet(quantities, stage)),
        Some(Stage::Conical(stage)) => Some(sheet::revolution::conical(quantities, stage)),
        Some(Stage::Bowl(stage)) => Some(sheet::revolution::bowl(quantities, stage)),
        Some(Stage::Fall(fall)) => sheet::fall::drawing(quantities, compass, 0, fall),
        Some(Stage::Stream(stream)) => sheet::stream::drawing(quantities, compass, 0, stream),
        Some(Stage::Thrust(thrust)) => sheet::stream::rocket(quantities, compass, 0, thrust),
        Some(Stage::Bounces(bounces)) => sheet::fall::bouncing(quantities, bounces),
    }
}

/// The figures of a stage in the worked solution.
pub(super) fn solution(
    quantities: &Quantities<'_>,
    compass: &Compass,
    index: usize,
    stage: &Stage,
) -> Vec<Option<Drawing>> {
    let stages = &quantities.scene().stages;
    let momenta = || momentum::diagram(quantities, compass, index, &drawn(stage));
    if principle::is_without_momentum(quantities, index)
        && let Some(drawings) = without_momentum(quantities, compass, index, stage)
    {
        return drawings.into_iter().map(Some).collect();
    }
    match stage {
        Stage::Rotate(rotate) if rotate.is_arm() => vec![arm::rotation(quantities, index, rotate)],
        Stage::Rotate(rotate) => vec![angular::rotation(quantities, index, rotate)],
        Stage::Strike(strike) => vec![arm::strike(quantities, index, strike)],
        // Nothing changes on one circle.
        Stage::Conical(conical) if conical.length.is_constant() => Vec::new(),
        Stage::Conical(conical) => vec![Some(angular::conical(quantities, index, conical))],
        Stage::Bowl(bowl) => vec![Some(angular::bowl(quantities, index, bowl))],
        Stage::Moment(moment) => vec![moment::diagram(quantities, compass, index, moment)],
        Stage::Central(central) => vec![Some(angular::central(quantities, index, central))],
        Stage::Bounces(bounces) => vec![sheet::fall::bouncing(quantities, bounces)],
        Stage::Push(push) => {
            let plot = graph::force_plot(quantities, index);
            let place = if push.is_of_several() { snapshot::pushed } else { snapshot::in_space };
            let place = if index == 0 { place(quantities, compass) } else { None };
            // What leaves, or arrives with a velocity, takes momentum with it that is none of the body's.
            let carried = push.mass_change().is_some_and(|change| !change.gains || change.velocity.is_some());
            let last = if carried { sheet::line::drawing(quantities, compass, index) } else { momenta() };
            [place, plot, last].into_iter().collect()
        }
        Stage::Slide(slide @ Slide { on: Some(on), .. }) => {
            vec![Some(sheet::carried::on_face(quantities, compass, index, slide, on)), momenta()]
        }
        Stage::Swing(swing @ Swing { on: Some(on), .. }) => {
            vec![Some(sheet::carried::on_circle(quantities, compass, index, swing, on)), momenta()]
        }
        Stage::Slide(slide) if slide.is_ramp() => vec![Some(sheet::ramp::drawing(quantities, compass, index, slide))],
        Stage::Swing(swing) => vec![Some(sheet::swing::drawing(quantities, compass, index, swing))],
        Stage::Connected(connected) => vec![string::diagram(quantities, index, connected)],
        Stage::Stream(stream) => vec![
            sheet::stream::drawing(quantities, compass, index, stream),
            flow::arriving(quantities, compass, index, stream),
        ],
        Stage::Thrust(thrust) => {
            [sheet::stream::rocket(quantities, compass, index, thrust), flow::leaving(quantities, compass, thrust)]
                .to_vec()
        }
        // What a ball gains before it bounces on is not asked for; the figure of the bounces shows its fall.
        Stage::Motion(motion) => {
            vec![curve::velocity(quantities, index, motion), momenta()]
        }
        Stage::Fall(_) if matches!(stages.get(index + 1), Some(Stage::Bounces(_))) => Vec::new(),
        Stage::Walk(walk) => vec![sheet::ride::walk(quantities, compass, index, walk)],
        Stage::Interact(interact) if interact.at_rest => {
            vec![snapshot::displacements(quantities, compass, index, &interact.between)]
        }
        Stage::Drift(_) => Vec::new(),
        Stage::Flight(_) if quantities.scene().plane == Plane::Horizontal => Vec::new(),
        Stage::Flight(flight) if !flight.is_free() => {
            let forces = resisted::drawing(quantities, compass, index, flight).or_else(momenta);
            vec![sheet::flight::drawing(quantities, compass, index, flight), forces]
        }
        Stage::Impact(_)
        | Stage::Spring(_)
        | Stage::Taut(_)
        | Stage::Tow(_)
        | Stage::Blow(_)
        | Stage::Fall(_)
        | Stage::Separate(_)
        | Stage::Slide(_)
        | Stage::SlideOff(_)
        | Stage::Interact(_)
        | Stage::Flight(_) => {
            vec![momenta()]
        }
    }
}

/// The figures of a stage that a solution deals with by energy or by forces; none where it has no such figures.
fn without_momentum(
    quantities: &Quantities<'_>,
    compass: &Compass,
    index: usize,
    stage: &Stage,
) -> Option<Vec<Drawing>> {
    let drawings: Vec<Drawing> = if let Stage::Fall(fall) = stage {
        sheet::fall::drawing(quantities, compass, index, fall).into_iter().collect()
    } else if let Stage::Motion(motion) = stage {
        curve::velocity(quantities, index, motion).into_iter().collect()
    } else if let Stage::Spring(spring) = stage {
        sheet::line::on_spring(quantities, compass, index, spring).into_iter().collect()
    } else {
        let forces = free_body::of_stage(quantities, compass, index, stage)?;
        let graph = graph::force_plot(quantities, index);
        graph.into_iter().chain([forces]).chain(curve::works(quantities, index)).collect()
    };
    (!drawings.is_empty()).then_some(drawings)
}

/// A diagram of momenta that is offered among others.
pub(super) fn offered(quantities: &Quantities<'_>, stage: usize, picture: &Picture) -> Option<Drawing> {
    let drawn = drawn(quantities.scene().stages.get(stage)?);
    momentum::diagram_with(quantities, quantities.compass(), stage, &drawn, Some(picture))
}

/// The participants in the diagram of momenta of a stage, and its arrows.
fn drawn(stage: &Stage) -> Drawn {
    let alone = |body: &str| vec![Participant::alone(body)];
    let several = |bodies: &[String]| bodies.iter().map(|body| Participant::alone(body)).collect();
    let drawn = |participants, arrows| Drawn { participants, arrows, mutual: false };
    if let Some(both) = stage.carried() {
        return drawn(both.map(Participant::alone).to_vec(), Arrows::Resultant);
    }
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
            Drawn { participants, arrows: Arrows::Impulses, mutual: impact.between.is_some() }
        }
        Stage::Separate(separate) => {
            let before = |part| Participant::between(part, separate.from.as_deref().unwrap_or(part), part);
            let participants = separate.into.iter().map(|part| before(part)).collect();
            Drawn { participants, arrows: Arrows::Impulses, mutual: true }
        }
        Stage::Spring(spring) => match spring.ends() {
            Some(Ends::Free(first, second)) => {
                let participants = [first, second].map(Participant::alone).to_vec();
                Drawn { participants, arrows: Arrows::Impulses, mutual: true }
            }
            Some(Ends::Fixed(body)) => drawn(alone(body), Arrows::Resultant),
            None => drawn(Vec::new(), Arrows::Resultant),
        },
        Stage::Taut(taut) => {
            let participants = taut.jerked().into_iter().map(Participant::alone).collect();
            Drawn { mutual: taut.over.is_none(), ..drawn(participants, Arrows::Impulses) }
        }
        Stage::Flight(flight) => {
            let arrows = if flight.is_free() { Arrows::Weight } else { Arrows::Resultant };
            drawn(flight.flying().map(Participant::alone).collect(), arrows)
        }
        Stage::Fall(fall) => drawn(alone(&fall.body), Arrows::Weight),
        Stage::Interact(interact) if interact.friction.is_some() => {
            Drawn { mutual: true, ..drawn(several(&interact.between), Arrows::Impulses) }
        }
        Stage::Interact(interact) => drawn(several(&interact.between), Arrows::Resultant),
        Stage::SlideOff(slide_off) => {
            drawn([&slide_off.body, &slide_off.on].map(|body| Participant::alone(body)).to_vec(), Arrows::Resultant)
        }
        Stage::Push(push) => drawn(push.pushed().map(Participant::alone).collect(), Arrows::Forces),
        Stage::Slide(slide) => drawn(alone(&slide.body), Arrows::Forces),
        Stage::Tow(tow) => drawn(tow.both().map(|towed| Participant::alone(&towed.body)).to_vec(), Arrows::Forces),
        Stage::Blow(blow) => drawn(alone(&blow.body), Arrows::Impulses),
        Stage::Motion(motion) => drawn(alone(&motion.body), Arrows::Impulses),
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

/// Whether a force is read from a graph, which the figure has to show.
fn is_graph(push: &Push) -> bool {
    push.forces.iter().any(|force| matches!(force, Force::Pull(pull) if matches!(pull.value, Strength::Graph(_))))
}
