//! The moment of contact: an impact in the plane, or one against a surface.

use momentous_figure::Contact;
use momentous_figure::Drawing;
use momentous_figure::Form;
use momentous_figure::LabelledVector;
use momentous_figure::Layout;
use momentous_figure::Moving;
use momentous_figure::MovingBody;
use momentous_figure::Partner;
use momentous_figure::Situation;
use momentous_scene::Plane;
use momentous_scene::Stage;
use momentous_scene::stage::Blow;
use momentous_scene::stage::Impact;
use momentous_scene::stage::Partners;

use super::super::compass::Compass;
use super::super::labels::body_math;
use super::super::quantities::Quantities;
use super::super::words::situation_wording;

/// From this share of the normal on a face is neither level nor upright.
const SLANT: f64 = 0.1;

/// The bodies touching, with the velocities with which they come; none where that would not tell anything.
pub(in super::super) fn drawing(quantities: &Quantities<'_>, compass: &Compass, impact: &Impact) -> Option<Drawing> {
    let frame = quantities.model().frames.first().and_then(Option::as_ref);
    let normal = frame.and_then(|frame| quantities.direction(&frame.normal));
    let body = |name: &str| (name.to_owned(), quantities.body(name, quantities.motion(compass, name, 1)));
    let bodies = match impact.partners()? {
        Partners::Surface(name, _) => vec![body(name)],
        Partners::Bodies(first, second) if quantities.axes.len() == 2 => vec![body(first), body(second)],
        Partners::Bodies(..) => return None,
    };
    if !bodies.iter().any(|(_, body)| body.is_told()) {
        return None;
    }
    let wording = situation_wording(quantities, &bodies, &quantities.when(1));
    let mut moving = bodies.into_iter().map(|(_, body)| body);
    let first = moving.next()?;
    let angle = frame.and_then(|frame| quantities.angle_mark(compass, &frame.normal));
    let contact = match moving.next() {
        None => {
            let [x, y] = normal?;
            // The line from the body into the surface.
            let line_of_impact = compass.angle([-x, -y]);
            let show_line = angle.is_some();
            let second = plate(quantities, compass, impact, [x, y]).map_or(Partner::Surface, Partner::Plate);
            Contact { line_of_impact, show_line, angle, first, second, walls: walls(quantities, compass) }
        }
        Some(second) => {
            let line = normal.or_else(|| approach(quantities, impact))?;
            let show_line = normal.is_some();
            // Blocks would be turned so as to touch along a face, of which nothing is known.
            let round = |body: MovingBody| if show_line { body } else { body.shaped(Form::Disc) };
            let is_wedge = show_line && second.form != Form::Disc && stands_on_floor(quantities, impact, line);
            let partner = if is_wedge { Partner::Wedge } else { Partner::Body };
            let (first, second) = (round(first), partner(round(second)));
            Contact { line_of_impact: compass.angle(line), show_line, angle, first, second, walls: Vec::new() }
        }
    };
    Some(Situation { wording, layout: Layout::Contact(contact), axes: compass.marks() }.drawing())
}

/// The directions into the fixed surfaces that later impacts strike.
fn walls(quantities: &Quantities<'_>, compass: &Compass) -> Vec<f64> {
    let scene = quantities.scene();
    let later = scene.stages.iter().enumerate().skip(1).filter(|(_, stage)| is_fixed(quantities, stage));
    let frames = later.filter_map(|(index, _)| quantities.model().frames.get(index)?.as_ref());
    let normals = frames.filter_map(|frame| quantities.direction(&frame.normal));
    normals.map(|[x, y]| compass.angle([-x, -y])).collect()
}

fn is_fixed(quantities: &Quantities<'_>, stage: &Stage) -> bool {
    let Stage::Impact(impact) = stage else { return false };
    let surface = impact.against.as_ref().and_then(|surface| quantities.scene().surfaces.get(surface));
    surface.is_some_and(|surface| surface.velocity.is_none())
}

/// A body that something strikes which an axis leads away from, such as a cushion: the surface at which it rebounds.
pub(in super::super) fn cushion(quantities: &Quantities<'_>, compass: &Compass, blow: &Blow) -> Option<Drawing> {
    let away = format!("away from {}", blow.by);
    let axes = quantities.scene().axes.rectangular();
    let [_, _] = axes[..] else { return None };
    let (position, sense) = axes.iter().enumerate().find_map(|(position, (_, senses))| match &away {
        direction if *direction == senses.positive => Some((position, 1.0)),
        direction if *direction == senses.negative => Some((position, -1.0)),
        _ => None,
    })?;
    let body = &blow.body;
    let vectors = [1, 2].into_iter().flat_map(|instant| quantities.motion(compass, body, instant)).collect();
    let first = quantities.body(body, vectors);
    if !first.is_told() {
        return None;
    }
    let both = format!("{} and {}", quantities.when(1), quantities.when(2));
    let wording = situation_wording(quantities, &[(body.clone(), first.clone())], &both);
    let line_of_impact = compass.angle(quantities.along(position, -sense));
    let contact =
        Contact { line_of_impact, show_line: false, angle: None, first, second: Partner::Surface, walls: Vec::new() };
    Some(Situation { wording, layout: Layout::Contact(contact), axes: compass.marks() }.drawing())
}

/// The surface that is struck, where it moves; with its velocity along its normal, where that is given.
fn plate(quantities: &Quantities<'_>, compass: &Compass, impact: &Impact, normal: [f64; 2]) -> Option<MovingBody> {
    let Partners::Surface(_, surface) = impact.partners()? else { return None };
    let moves = quantities.term(quantities.scene().surfaces.get(surface)?.velocity.as_ref()?)?;
    let along = |label, value: f64| {
        Moving::velocity(LabelledVector::known(label, compass.place(normal.map(|part| part * value))))
    };
    let velocity = match quantities.evaluate(&moves) {
        Some(value) => Some(along(quantities.unsigned(&moves), value)),
        None => quantities.asked(&moves).map(|label| along(label, 1.0).asked()),
    };
    Some(MovingBody { vectors: velocity.into_iter().collect(), ..MovingBody::new(body_math(surface)) })
}

/// Whether the second body can slide along a level floor and is struck on a face that slants.
fn stands_on_floor(quantities: &Quantities<'_>, impact: &Impact, [across, down]: [f64; 2]) -> bool {
    let Some(Partners::Bodies(_, second)) = impact.partners() else { return false };
    let scene = &quantities.worked.problem.loaded().draft.scene;
    let guide = scene.bodies.get(second).and_then(|body| body.guide.as_ref());
    let is_level = guide.is_some_and(|guide| guide.along.0.trim() == "x") && scene.plane == Plane::Vertical;
    is_level && across.abs() > SLANT && down < -SLANT
}

/// The direction in which the first body comes nearer to the second: where no line of impact is stated, they lie so.
fn approach(quantities: &Quantities<'_>, impact: &Impact) -> Option<[f64; 2]> {
    let Partners::Bodies(first, second) = impact.partners()? else { return None };
    let (first_velocity, second_velocity) = (quantities.velocity(first, 1)?, quantities.velocity(second, 1)?);
    let approach = [first_velocity[0] - second_velocity[0], first_velocity[1] - second_velocity[1]];
    (approach != [0.0, 0.0]).then_some(approach)
}
