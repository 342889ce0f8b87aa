//! A body that goes round a vertical axis: on a cord, or inside a cone or a bowl.

use momentous_expr::name_math;
use momentous_figure::Across;
use momentous_figure::Bowl;
use momentous_figure::Conical;
use momentous_figure::Drawing;
use momentous_figure::Layout;
use momentous_figure::MovingBody;
use momentous_figure::Situation;
use momentous_figure::Wall;
use momentous_figure::Wording;
use momentous_scene::stage;
use momentous_scene::stage::UpOrDown;

use super::super::super::wording::capitalised;
use super::super::labels::body_math;
use super::super::quantities::Quantities;
use super::super::quantities::SKETCHED;
use super::super::words::sentences;

/// How far a level lies from the other one in a sketch, as a part of the size of the bowl.
const RISE: f64 = 0.45;

/// The steady circle at the start.
pub(in super::super) fn conical(quantities: &Quantities<'_>, stage: &stage::Conical) -> Drawing {
    let body = stage.body.as_str();
    let angle = quantities.model().symbol_of(&format!("angle_{body}1"));
    let angle = angle.map_or((SKETCHED, None), |angle| quantities.angle_or_sketch(&angle.into()));
    let (name, centre) = (quantities.called(body), quantities.point(&stage.about));
    let length = quantities.label_of(stage.length.ends()[0]);
    let velocity = across(quantities, &quantities.velocity_name(body, 1));
    let said = [
        length.as_ref().map(|length| format!("the cord is {} long", length.plain())),
        angle.1.as_ref().map(|angle| format!("its angle with the vertical is {}", angle.plain())),
        velocity.as_ref().map(across_in_words),
    ];
    let what = format!("{name} on the cord from {centre}, seen from the side");
    let wording = wording(&format!("{name} and {centre}"), &what, said.into_iter().flatten());
    let conical = Conical { centre: body_math(&stage.about), body: particle(body), angle, length, velocity };
    Situation { wording, layout: Layout::Conical(conical), axes: Vec::new() }.drawing()
}

/// The body at the first of its two levels.
pub(in super::super) fn bowl(quantities: &Quantities<'_>, stage: &stage::Bowl) -> Drawing {
    let body = stage.body.as_str();
    let name = quantities.called(body);
    let first = format!("r_{body}1");
    let distance = quantities.named(&first);
    let number = |term: &momentous_scene::Term| quantities.evaluate(&quantities.term(term)?);
    let size = stage.sphere.as_ref().and_then(number);
    let label = distance.map(|_| name_math(&first));
    let wall = match (&stage.cone, &stage.sphere) {
        (Some(term), _) => {
            let angle = quantities.term(term).map_or((SKETCHED, None), |angle| quantities.angle_or_sketch(&angle));
            Wall::Cone(angle.0, angle.1)
        }
        (None, Some(term)) => Wall::Sphere(quantities.label_of(term)),
        (None, None) => Wall::Sphere(None),
    };
    let share = match (distance, size) {
        (Some(distance), Some(size)) => distance / size,
        _ if stage.way == UpOrDown::Up => 0.6,
        _ => 0.95,
    };
    // At the rim the radius says it all.
    let label = label.filter(|_| share < 1.0 - 1e-9 || size.is_none());
    let height = stage.height.as_ref().and_then(|term| Some((number(term)?, quantities.label_of(term)?)));
    let rise = height.map(|(height, label)| {
        let level = match &wall {
            Wall::Sphere(_) => size,
            Wall::Cone(angle, _) => distance.map(|distance| distance / libm::tan(*angle)),
        };
        let part = level.map_or(RISE, |level| height / level);
        (if stage.way == UpOrDown::Up { part } else { -part }, label)
    });
    let velocity = across(quantities, &format!("{}.theta", quantities.velocity_name(body, 1)));
    let said = [
        match &wall {
            Wall::Sphere(label) => label.as_ref().map(|label| format!("its radius is {}", label.plain())),
            Wall::Cone(_, label) => {
                label.as_ref().map(|label| format!("the wall makes {} with the axis", label.plain()))
            }
        },
        label.as_ref().map(|label| format!("the distance of {name} from the axis is {}", label.plain())),
        rise.as_ref().map(|(_, label)| format!("the other level lies {} from it", label.plain())),
        velocity.as_ref().map(across_in_words),
    ];
    let surface = if stage.cone.is_some() { "cone" } else { "bowl" };
    let what = format!("{name} in the {surface}, cut through its axis");
    let wording = wording(&format!("{name} in the {surface}"), &what, said.into_iter().flatten());
    let bowl = Bowl { body: particle(body), wall, share, distance: label, rise, velocity };
    Situation { wording, layout: Layout::Bowl(bowl), axes: Vec::new() }.drawing()
}

/// A body without arrows.
fn particle(body: &str) -> MovingBody {
    MovingBody::new(body_math(body))
}

/// A velocity along the circle, on its right-hand side: counter-clockwise, as seen from above, is away from the reader.
fn across(quantities: &Quantities<'_>, name: &str) -> Option<Across> {
    let value = quantities.named(name).filter(|value| *value != 0.0)?;
    Some(Across { label: name_math(name), away: value > 0.0 })
}

fn wording(title: &str, what: &str, said: impl Iterator<Item = String>) -> Wording {
    Wording {
        title: capitalised(title),
        description: sentences([what.to_owned()].into_iter().chain(said)),
        caption: sentences([what.to_owned()]),
    }
}

fn across_in_words(velocity: &Across) -> String {
    let sense = if velocity.away { "away from" } else { "towards" };
    format!("the velocity {} points {sense} the reader", velocity.label.plain())
}
