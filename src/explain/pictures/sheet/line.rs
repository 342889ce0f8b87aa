//! Bodies along a line: on a track before an impact, or one that is pushed or struck.

use momentous_expr::Math;
use momentous_figure::Drawing;
use momentous_figure::Form;
use momentous_figure::Grains;
use momentous_figure::Layout;
use momentous_figure::Line;
use momentous_figure::LineSpring;
use momentous_figure::Moving;
use momentous_figure::MovingBody;
use momentous_figure::Situation;
use momentous_figure::Tie;
use momentous_model::ForceKind;
use momentous_scene::Plane;
use momentous_scene::Stage;
use momentous_scene::Term;
use momentous_scene::stage::Ends;
use momentous_scene::stage::Partners;
use momentous_scene::stage::Spring;

use super::super::compass::Compass;
use super::super::labels::body_math;
use super::super::quantities::Quantities;
use super::super::quantities::Scope;
use super::super::words::sentences;
use super::super::words::situation_wording;
use super::strung;
use momentous_scene::list;

/// The bodies before a stage; after the last one, where nothing is given of them before. In a solution with their momenta.
pub(in super::super) fn drawing(quantities: &Quantities<'_>, compass: &Compass, stage: usize) -> Option<Drawing> {
    let last = quantities.timeline.last();
    let slope = quantities.slope(stage);
    let compass = &match &slope {
        Some((rise, _)) => compass.tilted(*rise),
        None => compass.clone(),
    };
    let before = bodies(quantities, compass, stage);
    let is_telling = |bodies: &[(String, MovingBody)]| bodies.iter().any(|(_, body)| body.is_told());
    let rebounds = |body: &str| !departure(quantities, compass, body, stage).is_empty();
    let after = || {
        let alive = quantities.timeline.alive(last);
        let body = |body: &str| (body.to_owned(), quantities.body(body, quantities.motion(compass, body, last)));
        alive.into_iter().map(body).collect::<Vec<_>>()
    };
    // Bodies that are at rest may stand on something, or be tied, before they move.
    let shows_before = is_telling(&before) || !is_telling(&after()) && quantities.scope() == Scope::Given;
    let (when, bodies) = if shows_before {
        let both = before.iter().any(|(body, _)| rebounds(body));
        let when = quantities.when(stage + 1);
        (if both { format!("{when} and {}", quantities.when(stage + 2)) } else { when }, before)
    } else {
        (quantities.when(last), after())
    };
    if bodies.is_empty() || quantities.scope() == Scope::Solved && !is_telling(&bodies) {
        return None;
    }
    let mut wording = situation_wording(quantities, &bodies, &when);
    let upright = libm::cos(compass.axis_angle(0)).abs() < 1e-9;
    let names: Vec<&str> = bodies.iter().map(|(name, _)| name.as_str()).collect();
    let grains = grains(quantities, &names, stage);
    if let Some((_, told)) = &grains {
        wording.description = format!("{} {told}", wording.description);
    }
    let line = Line {
        angle: line_angle(quantities, compass, stage),
        floor: !upright && has_floor(quantities, stage, &bodies),
        slope: slope.and_then(|(_, label)| label),
        spring: spring(quantities, &names, stage),
        hung: hung(quantities, &names).filter(|_| !upright),
        tied: tied(quantities, &names, stage),
        wall: has_wall(quantities, stage),
        grains: grains.map(|(grains, _)| grains),
        exhaust: None,
        bodies: if shows_before { until_they_part(quantities, stage, bodies) } else { alone(bodies) },
    };
    Some(Situation { wording, layout: Layout::Line(line), axes: compass.marks() }.drawing())
}

/// The bodies on a spring with their velocities at the start of the motion.
pub(in super::super) fn on_spring(
    quantities: &Quantities<'_>,
    compass: &Compass,
    stage: usize,
    spring: &Spring,
) -> Option<Drawing> {
    let names = match spring.ends()? {
        Ends::Free(first, second) => vec![first, second],
        Ends::Fixed(body) => vec![body],
    };
    let slope = quantities.slope(stage);
    let compass = &match &slope {
        Some((rise, _)) => compass.tilted(*rise),
        None => compass.clone(),
    };
    let moving = |name: &&str| ((*name).to_owned(), quantities.body(name, quantities.motion(compass, name, stage + 1)));
    let bodies: Vec<(String, MovingBody)> = names.iter().map(moving).collect();
    let mut wording = situation_wording(quantities, &bodies, &quantities.when(stage + 1));
    let called: Vec<String> = names.iter().map(|name| quantities.called(name)).collect();
    wording.title = format!("Velocities of {} on the spring", list(&called));
    let upright = libm::cos(compass.axis_angle(0)).abs() < 1e-9;
    let line = Line {
        angle: compass.axis_angle(0),
        floor: !upright,
        slope: slope.and_then(|(_, label)| label),
        spring: self::spring(quantities, &names, stage),
        bodies: alone(bodies),
        ..Line::default()
    };
    Some(Situation { wording, layout: Layout::Line(line), axes: compass.marks() }.drawing())
}

fn bodies(quantities: &Quantities<'_>, compass: &Compass, stage: usize) -> Vec<(String, MovingBody)> {
    let vectors = |body: &String| {
        if quantities.scope() == Scope::Solved {
            let momentum = quantities.momentum(body, body, stage + 1, quantities.mass(body, stage + 1));
            return vec![Moving::momentum(momentum.placed(compass))];
        }
        let before = quantities.motion(compass, body, stage + 1);
        let mut vectors: Vec<Moving> = if is_struck(quantities, body, stage) {
            before.into_iter().map(Moving::arriving).collect()
        } else {
            before
        };
        vectors.extend(departure(quantities, compass, body, stage));
        vectors.extend(quantities.impulses_on(compass, body, stage));
        vectors.extend(quantities.forces_on(compass, body, stage));
        vectors
    };
    let order = order(quantities, stage);
    order.into_iter().map(|body| (body.clone(), quantities.body(&body, vectors(&body)))).collect()
}

/// Bodies that come apart in a stage are drawn as one before it, with the first velocity that is told of one of them.
fn until_they_part(quantities: &Quantities<'_>, stage: usize, bodies: Vec<(String, MovingBody)>) -> Vec<MovingBody> {
    let Some(Stage::Separate(separate)) = quantities.scene().stages.get(stage) else { return alone(bodies) };
    let parts = separate.into.iter().map(|part| (body_math(part), quantities.form(part))).collect();
    let (mut whole, rest): (Vec<_>, Vec<_>) = match &separate.from {
        Some(whole) => bodies.into_iter().partition(|(body, _)| body == whole),
        None => bodies.into_iter().partition(|(body, _)| separate.into.contains(body)),
    };
    let Some(first) = whole.iter().position(|(_, body)| body.is_told()).or((!whole.is_empty()).then_some(0)) else {
        return alone(rest);
    };
    let (_, body) = whole.swap_remove(first);
    let name = if separate.from.is_some() { body.name.clone() } else { Math::Row(Vec::new()) };
    let joined = MovingBody { name, ..body }.joined(parts);
    [joined].into_iter().chain(alone(rest)).collect()
}

fn alone(bodies: Vec<(String, MovingBody)>) -> Vec<MovingBody> {
    bodies.into_iter().map(|(_, body)| body).collect()
}

/// A struck body comes and goes: the velocity with which it goes belongs to the picture, where it is given.
fn departure(quantities: &Quantities<'_>, compass: &Compass, body: &str, stage: usize) -> Vec<Moving> {
    if is_struck(quantities, body, stage) { quantities.motion(compass, body, stage + 2) } else { Vec::new() }
}

fn is_struck(quantities: &Quantities<'_>, body: &str, stage: usize) -> bool {
    matches!(quantities.scene().stages.get(stage), Some(Stage::Blow(blow)) if blow.body == body)
}

/// The bodies from back to front: in an impact, the second body lies ahead of the first, and what tows ahead of what is towed.
fn order(quantities: &Quantities<'_>, stage: usize) -> Vec<String> {
    let mut order: Vec<String> = Vec::new();
    let place = |order: &Vec<String>, body: &str| order.iter().position(|name| name == body);
    for stage in &quantities.scene().stages {
        let pairs = if let Stage::Tow(tow) = stage {
            vec![[tow.rear.body.as_str(), tow.front.body.as_str()]]
        } else if let Stage::Taut(taut) = stage {
            taut.ends()
        } else if let Stage::Impact(impact) = stage
            && let Some(Partners::Bodies(first, second)) = impact.partners()
        {
            vec![[first, second]]
        } else {
            continue;
        };
        for [first, second] in pairs {
            match (place(&order, first), place(&order, second)) {
                (None, None) => order.extend([first.to_owned(), second.to_owned()]),
                (Some(behind), None) => order.insert(behind + 1, second.to_owned()),
                (None, Some(ahead)) => order.insert(ahead, first.to_owned()),
                (Some(_), Some(_)) => {}
            }
        }
    }
    let alive = quantities.timeline.alive(stage + 1);
    order.retain(|body| alive.contains(&body.as_str()));
    let others: Vec<&str> = alive.into_iter().filter(|body| place(&order, body).is_none()).collect();
    order.extend(others.into_iter().map(str::to_owned));
    order
}

/// A floor is drawn under what rubs on it or is held by a spring, and under vehicles that meet on a level line.
fn has_floor(quantities: &Quantities<'_>, stage: usize, bodies: &[(String, MovingBody)]) -> bool {
    let rubs = quantities.model().forces.iter().any(|force| force.stage == stage && force.kind == ForceKind::Normal);
    let sprung = matches!(quantities.scene().stages.get(stage), Some(Stage::Spring(_)));
    let level = quantities.scene().plane == Plane::Horizontal && quantities.axes.len() == 1;
    let vehicles = bodies.len() > 1 && bodies.iter().all(|(_, body)| body.form == Form::Block);
    rubs || sprung || level && vehicles
}

/// The direction in which the bodies follow each other: that of the string between them, or the first axis.
fn line_angle(quantities: &Quantities<'_>, compass: &Compass, stage: usize) -> f64 {
    let taut = matches!(quantities.scene().stages.get(stage), Some(Stage::Taut(taut)) if taut.along.is_some());
    let frame = quantities.model().frames.get(stage).and_then(Option::as_ref).filter(|_| taut);
    let string = frame.and_then(|frame| quantities.direction(&frame.normal));
    string.map_or_else(|| compass.axis_angle(0), |direction| compass.angle(direction))
}

/// The spring of this stage or the next, where it lies along the line; what is written at it is its stiffness.
fn spring(quantities: &Quantities<'_>, names: &[&str], stage: usize) -> Option<(LineSpring, Option<Math>)> {
    let scene = quantities.scene();
    let mut near = scene.stages.iter().enumerate().skip(stage).take(2);
    let (at, spring) =
        near.find_map(|(at, stage)| if let Stage::Spring(spring) = stage { Some((at, spring)) } else { None })?;
    let place = match spring.ends()? {
        Ends::Free(first, second) if at == stage && names.starts_with(&[first, second]) => LineSpring::Between,
        Ends::Free(..) => return None,
        Ends::Fixed(body) => {
            let deformed = |term: &Option<Term>| quantities.evaluate(&quantities.term(term.as_ref()?)?);
            let relaxes = deformed(&spring.from).zip(deformed(&spring.to)).is_some_and(|(from, to)| from > to);
            // A spring is pressed ahead of a body that moves into it, and drives one that it moves from behind.
            let drives = spring.releases() || relaxes;
            let members = scene.members(body);
            let holds = |name: Option<&&str>| name.is_some_and(|name| *name == body || members.contains(name));
            if drives == quantities.is_backwards(spring.direction.as_ref()) {
                holds(names.last()).then_some(LineSpring::Ahead)?
            } else {
                holds(names.first()).then_some(LineSpring::Behind)?
            }
        }
    };
    Some((place, quantities.label_of(&spring.stiffness)))
}

/// The ties between bodies that follow each other in a stage: the position of the one behind, and what ties it to the next.
fn tied(quantities: &Quantities<'_>, names: &[&str], stage: usize) -> Vec<(usize, Tie)> {
    let stages = &quantities.scene().stages;
    let Some(entry) = stages.get(stage) else { return Vec::new() };
    let (tie, pairs) = if let Stage::Taut(taut) = entry {
        (Tie::Slack, taut.ends())
    } else if let Stage::Tow(tow) = entry {
        (Tie::Firm, vec![[tow.rear.body.as_str(), tow.front.body.as_str()]])
    } else if let Some((_, taut)) = strung::jerked(stages, stage) {
        // What is struck pulls the others along at once.
        (Tie::Firm, taut.ends())
    } else {
        return Vec::new();
    };
    let is_tied =
        |behind: &str, ahead: &str| pairs.iter().any(|tied| *tied == [behind, ahead] || *tied == [ahead, behind]);
    // Bodies at rest on a straight string stay so until another one pulls; what moves towards its jerk has slack string behind it.
    let rests = |body: &str| quantities.velocity(body, stage + 1).is_some_and(|velocity| velocity == [0.0, 0.0]);
    let between = |pair: &[&str]| if pair.iter().all(|body| rests(body)) { Tie::Firm } else { tie };
    let next = names.windows(2).enumerate();
    next.filter(|(_, pair)| is_tied(pair[0], pair[1])).map(|(behind, pair)| (behind, between(pair))).collect()
}

/// The grains that fall onto one of the bodies in a stage, or out of it, and the words for it.
fn grains(quantities: &Quantities<'_>, names: &[&str], stage: usize) -> Option<(Grains, String)> {
    let Stage::Push(push) = quantities.scene().stages.get(stage)? else { return None };
    let (change, body) = (push.mass_change()?, push.pushed().next()?);
    let label = change.flow.and_then(|flow| quantities.label_of(flow));
    let falls = if change.gains { "falls onto" } else { "falls out of" };
    let told = sentences([format!("{} {falls} {}", change.name, quantities.called(body))]);
    Some((Grains { body: names.iter().position(|name| *name == body)?, join: change.gains, label }, told))
}

/// Which of the bodies hangs on a cord, on which it or what it becomes will swing: one that is at rest.
fn hung(quantities: &Quantities<'_>, names: &[&str]) -> Option<usize> {
    let mut stages = quantities.scene().stages.iter();
    let body =
        stages.find_map(|stage| if let Stage::Swing(swing) = stage { Some(swing.body.as_str()) } else { None })?;
    let members = quantities.scene().members(body);
    let resting = |name: &&&str| quantities.velocity(name, 1).is_some_and(|velocity| velocity == [0.0, 0.0]);
    let named_members = names.iter().filter(|name| members.contains(name));
    let chosen = named_members.clone().find(resting).or_else(|| named_members.clone().next_back())?;
    names.iter().position(|name| name == chosen)
}

/// Whether a body will strike a wall that lies beyond the last of them.
fn has_wall(quantities: &Quantities<'_>, stage: usize) -> bool {
    let later = quantities.scene().stages.iter().enumerate().skip(stage + 1);
    let walls = later.filter(
        |(_, stage)| matches!(stage, Stage::Impact(impact) if matches!(impact.partners(), Some(Partners::Surface(..)))),
    );
    let frames = walls.filter_map(|(index, _)| quantities.model().frames.get(index)?.as_ref());
    let mut normals = frames.filter_map(|frame| quantities.direction(&frame.normal));
    quantities.axes.len() == 1 && normals.any(|[x, y]| x + y < 0.0)
}
