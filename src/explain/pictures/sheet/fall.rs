//! A body that falls, and perhaps bounces.

use std::f64::consts::FRAC_PI_2;

use momentous_expr::name_math;
use momentous_figure::Drawing;
use momentous_figure::Fall;
use momentous_figure::Ground;
use momentous_figure::Height;
use momentous_figure::Layout;
use momentous_figure::Situation;
use momentous_scene::Stage;
use momentous_scene::stage;
use momentous_scene::stage::Bounces;
use momentous_scene::stage::Partners;

use super::super::compass::Compass;
use super::super::quantities::Quantities;
use super::super::quantities::Scope;
use super::super::words::fall_wording;

/// Heights of bounces on a sheet: a sketch, since the true ones may be asked.
const SKETCHED: f64 = 0.6;
/// Bounces in a sketch, and at most in a solution.
const SKETCHED_BOUNCES: u32 = 3;
const MOST_BOUNCES: u32 = 6;

/// The start of a fall, with what the body falls on; in a solution also its end, with the velocities at both.
pub(in super::super) fn drawing(
    quantities: &Quantities<'_>,
    compass: &Compass,
    index: usize,
    fall: &stage::Fall,
) -> Option<Drawing> {
    let scene = quantities.scene();
    // An axis along the string of a pulley points down where the body falls along it.
    let hangs = scene.sinks(index, &fall.body).filter(|_| scene.axes.rectangular().len() == 1);
    let upright = hangs.map(|down| compass.tilted(if down > 0 { -FRAC_PI_2 } else { FRAC_PI_2 }));
    let compass = upright.as_ref().unwrap_or(compass);
    let next = scene.stages.get(index + 1);
    if let Some(Stage::Bounces(bounces)) = next {
        return bouncing(quantities, bounces);
    }
    let struck = next.and_then(|next| if let Stage::Impact(impact) = next { impact.partners() } else { None });
    let ground = match struck {
        Some(Partners::Bodies(first, second)) => {
            let other = if first == fall.body { second } else { first };
            let body = quantities.body(other, quantities.motion(compass, other, index + 1));
            if is_carried(quantities, other) { Ground::Sprung(body) } else { Ground::Body(body) }
        }
        Some(Partners::Surface(..)) => slope(quantities, compass, index + 1),
        None if next.is_none() => Ground::Level,
        None => Ground::Air,
    };
    let label = quantities.label_of(&fall.height);
    let body = quantities.body(&fall.body, quantities.motion(compass, &fall.body, index + 1));
    let wording = fall_wording(quantities, &fall.body, label.as_ref(), 0);
    let end = (quantities.scope() == Scope::Solved).then(|| quantities.motion(compass, &fall.body, index + 2));
    let fall = Fall { body, heights: vec![Height { label, value: 1.0 }], ground, end };
    Some(Situation { wording, layout: Layout::Fall(fall), axes: compass.marks() }.drawing())
}

/// Whether a spring carries a body.
fn is_carried(quantities: &Quantities<'_>, body: &str) -> bool {
    let carries = |stage: &Stage| matches!(stage, Stage::Spring(spring) if spring.carried.as_deref() == Some(body));
    quantities.scene().stages.iter().any(carries)
}

/// The surface that is struck in a stage: a slope where its normal is turned from the vertical.
fn slope(quantities: &Quantities<'_>, compass: &Compass, stage: usize) -> Ground {
    let frame = quantities.model().frames.get(stage).and_then(Option::as_ref);
    let normal = frame.and_then(|frame| Some((frame, quantities.direction(&frame.normal)?)));
    match normal {
        Some((frame, normal)) if !frame.normal.turn.is_zero() => {
            let mark = quantities.angle_mark(compass, &frame.normal);
            // The angle between normals is that between the surfaces, where it is counted from the vertical.
            let upright = frame.normal.quarters % 2 == 1;
            Ground::Slope(compass.angle(normal) - FRAC_PI_2, mark.filter(|_| upright).map(|mark| mark.label))
        }
        _ => Ground::Level,
    }
}

/// A fall and its bounces: to scale in a solution, sketched on a sheet.
pub(in super::super) fn bouncing(quantities: &Quantities<'_>, bounces: &Bounces) -> Option<Drawing> {
    let scene = quantities.scene();
    let falls = scene.stages.iter().any(|stage| matches!(stage, Stage::Fall(fall) if fall.body == bounces.body));
    // Of a body that arrives in another way, height and speed are not known before they are solved.
    if !falls && quantities.named("h_0").is_none() {
        return None;
    }
    let solved = quantities.scope() == Scope::Solved;
    let stages = quantities.scene().stages.iter();
    let mut falls = stages.filter_map(|stage| if let Stage::Fall(fall) = stage { Some(fall) } else { None });
    let drop = falls.find(|fall| fall.body == bounces.body).map(|fall| &fall.height);
    let label = match drop {
        Some(term) => quantities.label_of(term),
        None => quantities.named("h_0").map(|_| name_math("h_0")).or_else(|| quantities.asked_name("h_0")),
    };
    let restitution = quantities.term(&bounces.restitution).and_then(|e| quantities.evaluate(&e));
    let ratio = if solved { restitution.map(|e| e * e)? } else { SKETCHED };
    let count = bounces.count.as_ref().and_then(|count| quantities.evaluate(&quantities.term(count)?));
    let number = count.filter(|_| solved).map_or(SKETCHED_BOUNCES, whole);
    let mut value = 1.0;
    let mut heights = vec![Height { label: label.clone(), value }];
    for bounce in 1..=number {
        value *= ratio;
        let last = solved && bounce == number && count.is_some_and(|count| count <= f64::from(MOST_BOUNCES));
        let numbered = format!("h_{bounce}");
        let label = if quantities.named(&numbered).is_some() {
            solved.then(|| name_math(&numbered))
        } else {
            last.then(|| name_math("h_n")).filter(|_| quantities.named("h_n").is_some())
        };
        heights.push(Height { label, value });
    }
    let wording = fall_wording(quantities, &bounces.body, label.as_ref(), number);
    let fall = Fall { body: quantities.body(&bounces.body, Vec::new()), heights, ground: Ground::Level, end: None };
    Some(Situation { wording, layout: Layout::Fall(fall), axes: Vec::new() }.drawing())
}

/// A count as a number of bounces that can be drawn.
fn whole(count: f64) -> u32 {
    (1..MOST_BOUNCES).find(|number| f64::from(*number) >= count).unwrap_or(MOST_BOUNCES)
}
