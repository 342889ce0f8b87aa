//! A body on a cord: on a sheet where it is and what is given of its swing, in a solution both ends with the velocities.

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::name_math;
use momentous_figure::Drawing;
use momentous_figure::Layout;
use momentous_figure::Moving;
use momentous_figure::Situation;
use momentous_figure::SwingBy;
use momentous_figure::SwingEnd;
use momentous_figure::Wording;
use momentous_scene::Stage;
use momentous_scene::Term;
use momentous_scene::stage::Place;
use momentous_scene::stage::Swing;

use super::super::super::wording::capitalised;
use super::super::compass::Compass;
use super::super::quantities::Quantities;
use super::super::quantities::SKETCHED;
use super::super::quantities::Scope;
use super::super::words::sentences;

/// The places of a body on its cord, with what may be told of them.
pub(in super::super) fn drawing(
    quantities: &Quantities<'_>,
    compass: &Compass,
    index: usize,
    stage: &Swing,
) -> Drawing {
    let length = stage.arm().and_then(|term| quantities.label_of(term));
    let height = height(quantities, index, stage);
    let ends = [0, 1].map(|side| end(quantities, compass, index, stage, side));
    let telling = |end: &SwingEnd| end.label.is_some() || !end.vectors.is_empty();
    let shows_both = quantities.scope() == Scope::Solved || height.is_some() || telling(&ends[1]);
    let ends = ends.into_iter().take(if shows_both { 2 } else { 1 }).collect();
    let name = quantities.called(&stage.body);
    let phrase = quantities.model().phrase(quantities.scene(), index);
    let on_cord = length.as_ref().map_or_else(String::new, |length| format!(" of length {}", length.plain()));
    let rises = height.as_ref().map_or_else(String::new, |height| {
        format!("the difference in height between the two positions is {}", height.plain())
    });
    let on_track = stage.radius.is_some();
    let place = if on_track { format!("{name} on the circular track") } else { format!("{name} on the cord") };
    let holds = if on_track {
        let radius = length.as_ref().map_or_else(String::new, |length| format!(" of radius {}", length.plain()));
        let slides = quantities.scene().does(&stage.body, ["slides", "slide"]);
        format!("{slides} on the inside of a circular track{radius}")
    } else {
        format!("{} on a cord{on_cord}", quantities.scene().does(&stage.body, ["hangs", "hang"]))
    };
    let what = match quantities.scope() {
        Scope::Given => place.clone(),
        Scope::Solved => format!("{phrase}: the velocity of {name} at its start and at its end"),
    };
    let wording =
        Wording { title: capitalised(&place), description: sentences([holds, rises]), caption: sentences([what]) };
    let body = quantities.body(&stage.body, Vec::new());
    let height = height.filter(|_| shows_both);
    let by = if on_track { track(quantities, index, stage) } else { cord(quantities, compass, index, stage) };
    let swing = momentous_figure::Swing { body, ends, length, height, by };
    Situation { wording, layout: Layout::Swing(swing), axes: compass.marks() }.drawing()
}

/// The body that it runs into at its lowest point, where that one hangs too, belongs to the picture of a sheet.
fn cord(quantities: &Quantities<'_>, compass: &Compass, index: usize, stage: &Swing) -> SwingBy {
    let stages = &quantities.scene().stages;
    let (Some(Stage::Impact(impact)), [Place::Angle(_), Place::Lowest], Scope::Given) =
        (stages.get(index + 1), stage.places(), quantities.scope())
    else {
        return SwingBy::Cord;
    };
    let swings =
        |body: &&String| stages.iter().any(|later| matches!(later, Stage::Swing(swing) if swing.body == **body));
    let other = impact.between.iter().flatten().find(|body| **body != stage.body).filter(swings);
    other.map_or(SwingBy::Cord, |other| {
        SwingBy::CordBeside(quantities.body(other, quantities.motion(compass, other, index + 1)))
    })
}

/// A track that the body leaves at the lowest point ends level there; on a sheet with what the body then runs into.
fn track(quantities: &Quantities<'_>, index: usize, stage: &Swing) -> SwingBy {
    let next = quantities.scene().stages.get(index + 1);
    if !matches!(stage.places(), [Place::Angle(_), Place::Lowest]) {
        return SwingBy::Track;
    }
    if let Some(Stage::Impact(impact)) = next {
        let other = impact.between.iter().flatten().find(|body| **body != stage.body);
        let other = other.filter(|_| quantities.scope() == Scope::Given);
        return SwingBy::LevelTrack(other.map(|other| quantities.body(other, Vec::new())));
    }
    let goes_on = matches!(next, Some(Stage::Slide(_) | Stage::Flight(_)));
    if goes_on { SwingBy::LevelTrack(None) } else { SwingBy::Track }
}

/// The notation of the height between both ends, where it may be shown.
pub(super) fn height(quantities: &Quantities<'_>, index: usize, stage: &Swing) -> Option<Math> {
    let named = quantities.staged(&format!("h_{}", stage.body), index);
    match &stage.height {
        Some(term) => quantities.label_of(term),
        None => quantities.named(&named).map(|_| name_math(&named)).or_else(|| quantities.asked_name(&named)),
    }
}

/// One end of the swing: the angle of the cord on the drawing, and the vectors of the body there.
fn end(quantities: &Quantities<'_>, compass: &Compass, index: usize, stage: &Swing, side: usize) -> SwingEnd {
    let (angle, label) = angle(quantities, compass, index, stage, side);
    SwingEnd { angle, label, vectors: vectors(quantities, compass, &stage.body, index + 1 + side, angle) }
}

/// The angle of the cord on the drawing, counter-clockwise from straight down, and how it is written.
pub(in super::super) fn angle(
    quantities: &Quantities<'_>,
    compass: &Compass,
    index: usize,
    stage: &Swing,
    side: usize,
) -> (f64, Option<Math>) {
    let places = stage.places();
    let instant = index + 1 + side;
    let (size, label) = match &places[side] {
        Place::Lowest => (0.0, None),
        Place::Angle(Some(term)) => match quantities.term(term) {
            Some(angle) => quantities.angle_or_sketch(&angle),
            None => (SKETCHED, None),
        },
        Place::Angle(None) => {
            let since = quantities.timeline.naming_instant(&stage.body, instant);
            let angle = quantities.model().symbol_of(&format!("angle_{}{since}", stage.body));
            let angle = angle.map(|symbol| quantities.angle_or_sketch(&Expr::from(symbol)));
            angle.filter(|(_, label)| label.is_some()).unwrap_or_else(|| (from_height(quantities, index, stage), None))
        }
    };
    // It swings up to the side to which it moves, and comes down from the other one.
    let forwards = if quantities.is_backwards(stage.direction.as_ref()) { -1.0 } else { 1.0 };
    let sense = compass.place([forwards, 0.0])[0];
    let comes = side == 0 || matches!(places[0], Place::Angle(_)) && !stage.stops();
    (if comes { -sense * size } else { sense * size }, label)
}

/// The angle to which a height leads, where cord and height are known.
fn from_height(quantities: &Quantities<'_>, index: usize, stage: &Swing) -> f64 {
    let value = |term: Option<&Term>| quantities.evaluate(&quantities.term(term?)?);
    let height = value(stage.height.as_ref())
        .or_else(|| quantities.named(&quantities.staged(&format!("h_{}", stage.body), index)));
    let angle = height.zip(value(stage.arm())).map(|(height, length)| libm::acos(1.0 - height / length));
    angle.filter(|angle| angle.is_finite()).unwrap_or(SKETCHED)
}

/// Velocities, of which energy speaks; along one axis they turn with the cord.
fn vectors(quantities: &Quantities<'_>, compass: &Compass, body: &str, instant: usize, angle: f64) -> Vec<Moving> {
    let mut vectors = quantities.motion(compass, body, instant);
    if quantities.axes.len() == 1 {
        for [x, y] in vectors.iter_mut().filter_map(|moving| moving.vector.value.as_mut()) {
            let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
            (*x, *y) = (*x * cosine - *y * sine, *x * sine + *y * cosine);
        }
    }
    vectors
}
