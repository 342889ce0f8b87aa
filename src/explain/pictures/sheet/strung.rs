//! Bodies in a plane that are joined by strings, before these are jerked at the same time.

use momentous_figure::Drawing;
use momentous_figure::Layout;
use momentous_figure::Moving;
use momentous_figure::MovingBody;
use momentous_figure::Situation;
use momentous_figure::Strung;
use momentous_scene::Stage;
use momentous_scene::stage::Taut;

use super::super::compass::Compass;
use super::super::quantities::Quantities;
use super::super::words::sentences;
use super::super::words::situation_wording;
use momentous_scene::list;

/// The strings that are jerked in a stage, or in the one after a blow.
pub(in super::super) fn jerked(stages: &[Stage], first: usize) -> Option<(usize, &Taut)> {
    let stage = |index: usize| stages.get(index);
    let jerk = first + usize::from(matches!(stage(first), Some(Stage::Blow(_))));
    if let Some(Stage::Taut(taut)) = stage(jerk) {
        return (!taut.strings.is_empty()).then_some((jerk, taut));
    }
    None
}

/// The bodies where their strings hold them when a stage begins; none on a line, or where a direction may not be known.
pub(in super::super) fn drawing(
    quantities: &Quantities<'_>,
    compass: &Compass,
    first: usize,
    (jerk, taut): (usize, &Taut),
) -> Option<Drawing> {
    if quantities.axes.len() != 2 {
        return None;
    }
    let names = taut.jerked();
    let directions: Vec<_> = quantities.model().strings.iter().filter(|string| string.jerk == jerk).collect();
    let lines: Vec<[f64; 2]> =
        directions.iter().map(|string| quantities.direction(&string.direction)).collect::<Option<_>>()?;
    let place = |body: &str| names.iter().position(|name| *name == body);
    let joined: Vec<[usize; 2]> =
        taut.ends().into_iter().map(|[one, other]| Some([place(one)?, place(other)?])).collect::<Option<_>>()?;
    let places = places(names.len(), &joined, &lines)?;
    let bodies: Vec<(String, MovingBody)> = names
        .iter()
        .map(|body| {
            let mut vectors: Vec<Moving> = quantities.motion(compass, body, first + 1);
            vectors.extend(quantities.impulses_on(compass, body, first));
            ((*body).to_owned(), quantities.body(body, vectors))
        })
        .collect();
    let mut wording = situation_wording(quantities, &bodies, &quantities.when(first + 1));
    let tied: Vec<String> = (taut.ends().into_iter())
        .map(|[one, other]| format!("{} and {}", quantities.called(one), quantities.called(other)))
        .collect();
    let strings = if tied.len() == 1 { "a string joins" } else { "strings join" };
    wording.description = format!("{} {}", wording.description, sentences([format!("{strings} {}", list(&tied))]));
    let marks = directions.iter().map(|string| quantities.angle_mark(compass, &string.direction));
    let strung = Strung {
        bodies: bodies.into_iter().zip(&places).map(|((_, body), at)| (body, compass.place(*at))).collect(),
        strings: joined.into_iter().zip(marks).collect(),
    };
    Some(Situation { wording, layout: Layout::Strung(strung), axes: compass.marks() }.drawing())
}

/// The places of the bodies, each string as long as the others; none where not all of them are tied to each other.
fn places(count: usize, joined: &[[usize; 2]], lines: &[[f64; 2]]) -> Option<Vec<[f64; 2]>> {
    let mut places: Vec<Option<[f64; 2]>> = vec![None; count];
    *places.first_mut()? = Some([0.0, 0.0]);
    for _ in 0..count {
        for ([first, second], [x, y]) in joined.iter().zip(lines) {
            match (places[*first], places[*second]) {
                (Some(at), None) => places[*second] = Some([at[0] + x, at[1] + y]),
                (None, Some(at)) => places[*first] = Some([at[0] - x, at[1] - y]),
                _ => {}
            }
        }
    }
    places.into_iter().collect()
}
