//! Titles, descriptions and captions of figures.

use momentous_expr::Math;
use momentous_figure::Depth;
use momentous_figure::Moment;
use momentous_figure::Moving;
use momentous_figure::MovingBody;
use momentous_figure::Role;
use momentous_figure::Target;
use momentous_figure::Wording;
use momentous_model::ActingForce;
use momentous_quantity::Dimension;
use momentous_quantity::coherent_unit;

use super::super::terms::display::printed;
use super::super::wording::capitalised;
use super::balance::Balance;
use super::compass::Compass;
use super::quantities::Quantities;
use super::quantities::Scope;
use super::vectors::Labelled;
use momentous_scene::list;

/// Below this part of the largest vector of a figure a vector counts as zero.
const NOTHING: f64 = 1e-9;
/// How all impulses on a body in one are written in a caption.
const RESULTANT: &str = "\u{222b}\u{3a3}F\u{2009}dt";
/// How a drawing of three axes is to be read.
pub(super) const OBLIQUE: &str = "oblique projection: lengths along the slanting axis are drawn shorter";
/// The longest arrow of a diagram that is offered, in words.
const LONGEST: f64 = 10.0;
/// Figures of the numbers in descriptions.
const FIGURES: usize = 3;

/// A sentence with a full stop, or nothing.
fn sentence(words: &str) -> String {
    if words.is_empty() { String::new() } else { format!("{}.", capitalised(words)) }
}

/// Sentences one after another.
pub(super) fn sentences(words: impl IntoIterator<Item = String>) -> String {
    words.into_iter().map(|words| sentence(&words)).filter(|words| !words.is_empty()).collect::<Vec<_>>().join(" ")
}

/// Whether a vector is the impulse of all forces in one.
fn is_resultant(impulse: &Labelled) -> bool {
    matches!(&impulse.label, Math::Integral(_, _, force, _) if matches!(**force, Math::Row(_)))
}

/// The words for a momentum diagram.
pub(super) fn diagram_wording(
    quantities: &Quantities<'_>,
    compass: &Compass,
    stage: usize,
    balances: &[Balance],
) -> Wording {
    let scene = quantities.scene();
    let phrase = quantities.model().phrase(scene, stage);
    let names: Vec<String> = balances.iter().map(|balance| quantities.called(&balance.body)).collect();
    let whom = if names.len() > 2 { "each body".to_owned() } else { list(&names) };
    let unit = balances.iter().all(|balance| quantities.mass(&balance.body, stage + 1).is_some());
    let unit = (unit && quantities.has_numbers())
        .then(|| coherent_unit(Dimension::MOMENTUM, quantities.worked.problem.units()));
    let largest = largest(balances);
    let unit = unit.map(|unit| (unit.factor().to_f64(), unit.unicode()));
    let speak = Speak { compass, unit: unit.as_ref().map(|(size, name)| (*size, name.as_str())), largest };
    let rows = balances.iter().map(|balance| speak.balance(&quantities.called(&balance.body), balance));
    let several = balances.iter().any(|balance| balance.impulses.len() > 1);
    let impulses = if several { "impulses" } else { "impulse" };
    let in_one = balances.iter().flat_map(|balance| &balance.impulses).any(is_resultant);
    let duration = balances.iter().find_map(|balance| quantities.nameless_duration(stage, &balance.body));
    Wording {
        title: format!("Impulse-momentum diagram of {phrase}"),
        description: sentences(rows),
        caption: sentences([
            format!("{phrase}: momentum before + {impulses} = momentum after, for {whom}"),
            duration.unwrap_or_default(),
            if compass.is_oblique() { OBLIQUE.to_owned() } else { String::new() },
            if in_one { format!("{RESULTANT} is the total impulse of all forces") } else { String::new() },
        ]),
    }
}

/// The words for a diagram that is offered among others: as much as the eye sees of each, and not which is right.
pub(super) fn offered_wording(
    quantities: &Quantities<'_>,
    compass: &Compass,
    balances: &[Balance],
    name: &str,
) -> Wording {
    let largest = largest(balances);
    let speak = Speak { compass, unit: Some((largest / LONGEST, "units long")), largest };
    let rows = balances.iter().map(|balance| speak.balance(&quantities.called(&balance.body), balance));
    let scale = format!("the longest arrow is {LONGEST} units long");
    let name = capitalised(name);
    Wording { title: name.clone(), description: sentences(std::iter::once(scale).chain(rows)), caption: name }
}

fn largest(balances: &[Balance]) -> f64 {
    balances.iter().flat_map(Balance::all).filter_map(|vector| vector.value).map(size).fold(0.0, f64::max)
}

/// How vectors are spoken of in one figure.
struct Speak<'a> {
    compass: &'a Compass,
    /// The size of the unit of momentum in SI units, and how it is written.
    unit: Option<(f64, &'a str)>,
    largest: f64,
}

impl Speak<'_> {
    fn balance(&self, name: &str, balance: &Balance) -> String {
        let impulses: Vec<String> = balance.impulses.iter().map(|impulse| self.vector(impulse)).collect();
        let impulses = if impulses.is_empty() { "none".to_owned() } else { list(&impulses) };
        let noun = if balance.impulses.len() > 1 { "impulses" } else { "impulse" };
        let (before, after) = (self.vector(&balance.before), self.vector(&balance.after));
        format!("for {name}, momentum before: {before}; {noun}: {impulses}; momentum after: {after}")
    }

    /// `m_A v_A1, 8.00 kg m/s to the right`.
    fn vector(&self, vector: &Labelled) -> String {
        let name = match vector.label {
            Math::Integral(..) if is_resultant(vector) => "the total impulse of all forces".to_owned(),
            Math::Integral(..) => "the integral of F over time".to_owned(),
            _ => vector.label.plain(),
        };
        let Some(value) = vector.value else { return format!("{name}, unknown") };
        if size(value) <= NOTHING * self.largest {
            return format!("{name}, zero");
        }
        // On a drawing of three axes no length and no direction is that of the vector.
        if self.compass.is_oblique() {
            return name;
        }
        let direction = self.compass.words(value);
        match self.unit {
            Some((one, unit)) => {
                let number = printed(size(value) / one, FIGURES);
                format!("{name}, {number} {unit} {direction}")
            }
            None => format!("{name}, {direction}"),
        }
    }
}

impl Quantities<'_> {
    /// The meaning of a duration that the diagram can only call by the difference sign.
    fn nameless_duration(&self, stage: usize, body: &str) -> Option<String> {
        let nameless = |force: &&ActingForce| {
            let [start, end] = &force.during;
            let moving =
                self.evaluate(start).is_some_and(|start| start != 0.0) && force.stage == stage && force.on == body;
            moving.then(|| [start.clone(), end.clone()])
        };
        let [start, end] = self.model().forces.iter().find_map(|force| nameless(&force))?;
        let duration = if start == self.start_of(stage) {
            "\u{394}t is how long it lasts".to_owned()
        } else {
            format!("\u{394}t runs from {} to {}", self.what_time(&start), self.what_time(&end))
        };
        Some(format!("{duration}; meanwhile the momentum of {} changes", self.called(body)))
    }
}

fn size([x, y]: [f64; 2]) -> f64 {
    libm::hypot(x, y)
}

/// The words for bodies with given vectors.
pub(super) fn situation_wording(quantities: &Quantities<'_>, bodies: &[(String, MovingBody)], when: &str) -> Wording {
    let names: Vec<String> = bodies.iter().map(|(body, _)| quantities.called(body)).collect();
    let names = list(&names);
    let flat = quantities.axes.len() < 3;
    let told = bodies.iter().map(|(body, moving)| {
        let name = quantities.called(body);
        let arrows = arrows(moving, flat);
        if arrows.is_empty() { name } else { format!("{name} with {}", list(&arrows)) }
    });
    Wording {
        title: capitalised(&names),
        description: sentences(told),
        caption: sentences([format!("{names} {when}"), if flat { String::new() } else { OBLIQUE.to_owned() }]),
    }
}

/// The arrows of a body in words: `v_A1 to the right`.
pub(super) fn arrows(moving: &MovingBody, flat: bool) -> Vec<String> {
    arrows_called(moving, flat, KINDS)
}

/// The arrows of what turns in space: angular momentum, and moments.
pub(super) fn turning_arrows(moving: &MovingBody) -> Vec<String> {
    arrows_called(moving, false, TURNING_KINDS)
}

fn arrows_called(moving: &MovingBody, flat: bool, kinds: &[(Role, &str)]) -> Vec<String> {
    let arrow = |moving: &Moving| {
        let kind = kinds.iter().find(|(role, _)| *role == moving.role).map_or("", |(_, kind)| kind);
        let label = moving.vector.label.plain();
        let direction = match moving.vector.value {
            Some([0.0, 0.0]) => ", which is zero".to_owned(),
            // The label ends with its question mark.
            _ if moving.asked => String::new(),
            Some(value) if flat => format!(" {}", on_paper(value)),
            _ => String::new(),
        };
        let angle =
            moving.angle.as_ref().map_or_else(String::new, |angle| format!(", at an angle {}", angle.label.plain()));
        format!("the {kind} {label}{direction}{angle}")
    };
    moving.vectors.iter().map(arrow).collect()
}

/// The plural nouns for the arrows of a role.
const KINDS: &[(Role, &str)] =
    &[(Role::Velocity, "velocity"), (Role::Force, "force"), (Role::Impulse, "impulse"), (Role::Momentum, "momentum")];

/// The same for what turns.
const TURNING_KINDS: &[(Role, &str)] = &[(Role::Force, "moment"), (Role::Momentum, "angular momentum")];

/// The direction of an arrow on the drawing, in words.
fn on_paper([x, y]: [f64; 2]) -> String {
    let part = |value: f64, names: [&str; 2]| {
        let relevant = value.abs() > 1e-9 * size([x, y]);
        relevant.then(|| names[usize::from(value < 0.0)].to_owned())
    };
    let parts: Vec<String> =
        [part(y, ["up", "down"]), part(x, ["to the right", "to the left"])].into_iter().flatten().collect();
    parts.join(" and ")
}

/// The words for a body that begins a free flight.
pub(super) fn launch_wording(
    quantities: &Quantities<'_>,
    body: &str,
    (moving, instant): (&MovingBody, usize),
    (target, to_scale): (&Target, bool),
) -> Wording {
    let told = |words: &str, label: Option<&Math>| {
        label.map_or_else(String::new, |label| format!("{words} {}", label.plain()))
    };
    let ground = |depth: &Depth| match depth {
        Depth::Nothing => "it starts on level ground".to_owned(),
        Depth::Below(height) => format!("the ground lies below the start{}", told(", by", height.as_ref())),
    };
    let lies = match target {
        Target::Top => String::new(),
        Target::Ground(depth) => ground(depth),
        Target::Slope(_, angle) => format!("it starts on a slope{}", told(" at an angle", angle.as_ref())),
        Target::Wall(distance, depth) => {
            let wall = format!("there is a wall in the path{}", told(", at a distance", distance.as_ref()));
            depth.as_ref().map_or_else(|| wall.clone(), |depth| format!("{wall}; {}", ground(depth)))
        }
    };
    let when = if instant == 1 { "at the start of the flight".to_owned() } else { quantities.when(instant) };
    let wording = situation_wording(quantities, &[(body.to_owned(), moving.clone())], &when);
    let path = if to_scale { "drawn to scale" } else { "only sketched" };
    Wording {
        description: format!("{} {}", wording.description, sentence(&lies)).trim_end().to_owned(),
        caption: format!("{}; the path is {path}.", wording.caption.trim_end_matches('.')),
        ..wording
    }
}

/// The words for a body about a fixed point.
pub(super) fn about_wording(
    quantities: &Quantities<'_>,
    [body, about]: [&str; 2],
    radius: Option<&Math>,
    moving: &MovingBody,
    moment: Option<&Moment>,
) -> Wording {
    let (name, centre) = (quantities.called(body), quantities.point(about));
    let distance = radius.map_or_else(String::new, |radius| format!(" at a distance {}", radius.plain()));
    let arrows = arrows(moving, true);
    let with = if arrows.is_empty() { String::new() } else { format!(", with {}", list(&arrows)) };
    let moment = moment.map_or_else(String::new, |moment| {
        let sense = if moment.value < 0.0 { "clockwise" } else { "counter-clockwise" };
        format!("the moment {} acts {sense} about {centre}", moment.label.plain())
    });
    Wording {
        title: capitalised(&format!("{name} and {centre}")),
        description: sentences([format!("{name}, relative to {centre}{distance}{with}"), moment]),
        caption: sentences([format!("{name} about {centre}")]),
    }
}

/// The words for a fall and its bounces.
pub(super) fn fall_wording(quantities: &Quantities<'_>, body: &str, height: Option<&Math>, bounces: u32) -> Wording {
    let name = quantities.called(body);
    let height = height.map_or_else(String::new, |height| format!(" from a height {}", height.plain()));
    let bounces = if bounces > 0 { ", then bounces, rising less each time" } else { "" };
    let solved = quantities.scope() == Scope::Solved;
    let how = if solved { "" } else { " (not to scale)" };
    let (what, sideways) = match bounces {
        "" if solved => (format!("the fall of {name}"), ", with the velocities at its start and at its end"),
        "" => (format!("the fall of {name}"), ""),
        _ => (format!("the fall of {name} and the bounces"), ", drawn side by side"),
    };
    Wording {
        title: capitalised(&what),
        description: sentences([format!("{name} falls{height}{bounces}")]),
        caption: sentences([format!("{what}{sideways}{how}")]),
    }
}
