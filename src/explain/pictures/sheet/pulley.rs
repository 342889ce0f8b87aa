//! Two bodies on a string over a pulley.

use momentous_expr::name_math;
use momentous_figure::Drawing;
use momentous_figure::LabelledVector;
use momentous_figure::Layout;
use momentous_figure::Moving;
use momentous_figure::Pulley;
use momentous_figure::PulleySide;
use momentous_figure::Rest;
use momentous_figure::Situation;
use momentous_scene::stage::Connected;
use momentous_scene::stage::Strand;

use super::super::quantities::Quantities;
use super::super::quantities::SKETCHED;
use super::super::words::sentences;
use super::super::words::situation_wording;

/// A body on its side of the pulley, as the drawing has it.
pub(in super::super) struct Side<'a> {
    pub body: &'a str,
    pub rest: Rest,
    /// The direction in which it moves when the string runs forwards, as a unit vector.
    pub forwards: [f64; 2],
    /// Whether the string pulls it forwards (1) or back (-1).
    pub pull: f64,
    /// On how many strands of the string it hangs.
    pub strands: u8,
}

/// The trailing body lies to the left and is drawn towards the pulley; the leading one, to the right, moves away from it.
fn sides<'a>(trailing: (&'a str, Rest), leading: (&'a str, Rest)) -> [Side<'a>; 2] {
    let unit = |rest: &Rest| [libm::cos(rest.angle()), libm::sin(rest.angle())];
    let [x, y] = unit(&trailing.1);
    let forwards = unit(&leading.1);
    [
        Side { body: trailing.0, rest: trailing.1, forwards: [x, -y], pull: 1.0, strands: 1 },
        Side { body: leading.0, rest: leading.1, forwards, pull: -1.0, strands: 1 },
    ]
}

fn rest(quantities: &Quantities<'_>, strand: &Strand) -> Rest {
    match strand.on.as_ref().map(|term| (term, term.0.trim())) {
        None | Some((_, "hanging")) => Rest::Hanging,
        Some((_, "level")) => Rest::Level,
        Some((term, _)) => {
            let angle = quantities.term(term).map(|angle| quantities.angle_or_sketch(&angle));
            let (angle, label) = angle.unwrap_or((SKETCHED, None));
            Rest::Slope(angle, label)
        }
    }
}

/// The two sides of a string that stays taut.
pub(in super::super) fn sides_of<'a>(quantities: &Quantities<'_>, stage: &'a Connected) -> [Side<'a>; 2] {
    let [trailing, leading] =
        [&stage.trailing, &stage.leading].map(|strand| (strand.body.as_str(), rest(quantities, strand)));
    let [one, other] = sides(trailing, leading);
    [Side { strands: stage.trailing.strands(), ..one }, Side { strands: stage.leading.strands(), ..other }]
}

/// The bodies on their string at the start.
pub(in super::super) fn connected(quantities: &Quantities<'_>, index: usize, stage: &Connected) -> Drawing {
    situation(quantities, index, sides_of(quantities, stage))
}

/// Two bodies that hang on a slack string over a pulley.
pub(in super::super) fn taut(quantities: &Quantities<'_>, index: usize, between: &[String; 2]) -> Drawing {
    let [trailing, leading] = between.each_ref().map(|body| (body.as_str(), Rest::Hanging));
    situation(quantities, index, sides(trailing, leading))
}

fn situation(quantities: &Quantities<'_>, index: usize, sides: [Side<'_>; 2]) -> Drawing {
    let forwards = sides.each_ref().map(|side| side.forwards);
    let sides = sides.map(|side| {
        let name = quantities.velocity_name(side.body, index + 1);
        let along =
            |label, speed: f64| Moving::velocity(LabelledVector::known(label, side.forwards.map(|part| part * speed)));
        let told = quantities.named(&name).map(|speed| along(name_math(&name), speed));
        let velocity = told.or_else(|| Some(along(quantities.asked_name(&name)?, 1.0).asked()));
        (
            side.body.to_owned(),
            PulleySide {
                body: quantities.body(side.body, velocity.into_iter().collect()),
                rest: side.rest,
                strands: side.strands,
            },
        )
    });
    let bodies = sides.each_ref().map(|(name, side)| (name.clone(), side.body.clone()));
    let mut wording = situation_wording(quantities, &bodies, &quantities.when(index + 1));
    let [trailing, leading] = bodies.each_ref().map(|(name, _)| quantities.called(name));
    let held = sides.each_ref().map(|(name, side)| match side.strands {
        1 => format!("{} is on one end of it", quantities.called(name)),
        many => format!("{} hangs on {many} strands of it, by a movable pulley", quantities.called(name)),
    });
    let ends = if sides.iter().all(|(_, side)| side.strands == 1) {
        "they are on the ends of a string that runs over a pulley".to_owned()
    } else {
        format!("a string runs over a pulley; {}", held.join("; "))
    };
    wording.description = format!("{} {}", wording.description, sentences([ends]));
    // No axis of the drawing says so.
    let [from, to] = [0, 1].map(|place| in_words(&sides[place].1, forwards[place]));
    let counted = format!("the velocity of {trailing} is positive {from}, that of {leading} {to}");
    wording.caption = format!("{} {}", wording.caption, sentences([counted]));
    let pulley = Pulley { sides: sides.map(|(_, side)| side) };
    Situation { wording, layout: Layout::Pulley(pulley), axes: Vec::new() }.drawing()
}

/// The direction in which a body moves when the string runs forwards, in words.
fn in_words(side: &PulleySide, forwards: [f64; 2]) -> &'static str {
    let rises = forwards[1] > 0.0;
    match (&side.rest, rises) {
        (Rest::Level, _) => "to the right",
        (Rest::Hanging, true) => "upwards",
        (Rest::Hanging, false) => "downwards",
        (Rest::Slope(..), true) => "up the slope",
        (Rest::Slope(..), false) => "down the slope",
    }
}
