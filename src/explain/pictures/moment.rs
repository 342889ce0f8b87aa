//! A moment in space: the angular momentum as a vector before, the angular impulse, and the angular momentum after.

use std::sync::Arc;

use momentous_expr::Math;
use momentous_expr::name_math;
use momentous_figure as figure;
use momentous_figure::AngularImpulse;
use momentous_figure::Arm;
use momentous_figure::BodyMomentum;
use momentous_figure::Drawing;
use momentous_figure::Form;
use momentous_figure::LabelledVector;
use momentous_figure::Layout;
use momentous_figure::Line;
use momentous_figure::MomentumDiagram;
use momentous_figure::Moving;
use momentous_figure::MovingBody;
use momentous_figure::Role;
use momentous_figure::Situation;
use momentous_figure::TurnDiagram;
use momentous_figure::Wording;
use momentous_scene::Components;
use momentous_scene::Strength;
use momentous_scene::stage::Moment;

use super::super::wording::capitalised;
use super::arm::is_disc;
use super::arm::turning as turning_of_arm;
use super::compass::Compass;
use super::labels::body_math;
use super::quantities::Quantities;
use super::sense::given_moment;
use super::words::OBLIQUE;
use super::words::sentences;
use super::words::turning_arrows;
use momentous_scene::list;

/// The bodies that turn, all at once.
fn turning(quantities: &Quantities<'_>, index: usize) -> (String, Math) {
    let alive = quantities.timeline.alive(index + 1);
    let names: Vec<String> = alive.iter().map(|body| quantities.called(body)).collect();
    (list(&names), body_math(&alive.concat()))
}

/// The angular momentum at one end, along the axes.
fn momentum(quantities: &Quantities<'_>, about: &str, instant: usize) -> Option<[f64; 3]> {
    let mut all = [0.0; 3];
    for (component, axis) in all.iter_mut().zip(&quantities.axes) {
        *component = quantities.named(&format!("H_{about}{instant}.{}", axis.letter()))?;
    }
    Some(all)
}

/// The body with what is given of its angular momentum and of the moment.
pub(super) fn sheet(quantities: &Quantities<'_>, compass: &Compass, stage: &Moment) -> Drawing {
    let (names, body) = turning(quantities, 0);
    let Strength::Components(components) = &stage.value else { return arcs(quantities, &names, stage) };
    let name = format!("H_{}1", stage.about);
    let mut vectors: Vec<Moving> = momentum(quantities, &stage.about, 1)
        .and_then(|value| quantities.along_axes(&value))
        .map(|value| Moving::momentum(LabelledVector::known(name_math(&name), value)))
        .into_iter()
        .collect();
    vectors.extend(moments(quantities, components));
    let body = MovingBody { vectors, ..MovingBody::new(body).shaped(Form::Block) };
    let centre = quantities.centre(&stage.about);
    let words = format!("{names} with the angular momentum and the moment about {centre}");
    let wording = Wording {
        title: capitalised(&names),
        description: sentences([words.clone(), list(&turning_arrows(&body))]),
        caption: sentences([words, OBLIQUE.to_owned()]),
    };
    let line = Line { bodies: vec![body], ..Line::default() };
    Situation { wording, layout: Layout::Line(line), axes: compass.marks() }.drawing()
}

/// The components of a moment that are given; one that changes has no one length.
fn moments(quantities: &Quantities<'_>, components: &Components) -> Vec<Moving> {
    let clock = quantities.model().symbols.find("t");
    let component = |(position, axis): (usize, &momentous_scene::Axis)| {
        let term = quantities.term(components.get(*axis)?)?;
        if let Some(label) = quantities.asked(&term) {
            return Some(Moving::force(LabelledVector::known(label, quantities.along(position, 1.0))).asked());
        }
        let changes = clock.is_some_and(|clock| term.contains(clock));
        let at = |time: f64| {
            let value_at_time = |symbol| if Some(symbol) == clock { Some(time) } else { quantities.value(symbol) };
            let value = term.evaluate(&|symbol| value_at_time(symbol).unwrap_or(f64::NAN));
            value.is_finite().then_some(value)
        };
        let value = if changes { at(1.0)?.signum() } else { at(0.0)? };
        let label = if changes { name_math(&format!("M.{}", axis.letter())) } else { quantities.unsigned(&term) };
        Some(Moving::force(LabelledVector::known(label, quantities.along(position, value))))
    };
    quantities.axes.iter().enumerate().filter_map(component).collect()
}

/// The diagram.
pub(super) fn diagram(quantities: &Quantities<'_>, compass: &Compass, index: usize, stage: &Moment) -> Option<Drawing> {
    let (names, name) = turning(quantities, index);
    if quantities.axes.len() < 3 {
        return turns(quantities, index, stage, &names);
    }
    let [before, after] = [1, 2].map(|side| momentum(quantities, &stage.about, index + side));
    let (before, after) = (before?, after?);
    let gained = [0, 1, 2].map(|axis| after[axis] - before[axis]);
    let placed = |label: Math, vector: [f64; 3]| LabelledVector { label, value: quantities.along_axes(&vector) };
    let [first, second] = [1, 2].map(|side| name_math(&format!("H_{}{}", stage.about, index + side)));
    let impulse = impulse(stage);
    let wording = wording(quantities, index, stage, &names, [&first, &second]);
    let wording = Wording { caption: sentences([wording.caption, OBLIQUE.to_owned()]), ..wording };
    let row = BodyMomentum {
        name,
        form: Form::Block,
        surface: None,
        line_of_impact: None,
        before: placed(first, before),
        impulses: vec![placed(impulse, gained)],
        after: placed(second, after),
    };
    let diagram = MomentumDiagram { wording, bodies: vec![row], axes: compass.marks() };
    Some(diagram.of_angular_momentum())
}

fn wording(quantities: &Quantities<'_>, index: usize, stage: &Moment, names: &str, ends: [&Math; 2]) -> Wording {
    let (phrase, centre) = (quantities.model().phrase(quantities.scene(), index), quantities.centre(&stage.about));
    let [first, second] = ends.map(Math::plain);
    let balance = "angular momentum before + angular impulse = angular momentum after";
    Wording {
        title: format!("Angular impulse-momentum diagram of {phrase}"),
        description: sentences([format!("for {names}, {first} + the angular impulse = {second}")]),
        caption: format!("For {names}, {balance}, about {centre}"),
    }
}

/// In a plane: what is given of the angular momentum and the moment, as arcs.
fn arcs(quantities: &Quantities<'_>, names: &str, stage: &Moment) -> Drawing {
    let name = format!("H_{}1", stage.about);
    let first = quantities.named(&name).filter(|value| *value != 0.0);
    let first = first.map(|value| (figure::Moment { label: name_math(&name), value }, Role::Momentum));
    let first = first.or_else(|| turning_of_arm(quantities, 1));
    let moment = given_moment(quantities, &stage.value, Some(&stage.during)).map(|moment| (moment, Role::Force));
    let turns: Vec<(figure::Moment, Role)> = first.into_iter().chain(moment).collect();
    let words = format!("the moment on {names} about {}", quantities.centre(&stage.about));
    let each = turns.iter().map(|(turn, role)| {
        let sense = if turn.value < 0.0 { "clockwise" } else { "counter-clockwise" };
        let what = if *role == Role::Velocity { "the angular velocity " } else { "" };
        format!("{what}{} is {sense}", turn.label.plain())
    });
    let wording = Wording {
        title: capitalised(names),
        description: sentences([words.clone()].into_iter().chain(each)),
        caption: sentences([words]),
    };
    let disc = quantities.timeline.alive(1).into_iter().any(|body| is_disc(quantities, body)).then_some(1.0);
    let arm = Arm { centre: body_math(&stage.about), particles: Vec::new(), disc, turns };
    Situation { wording, layout: Layout::Arm(arm), axes: Vec::new() }.drawing()
}

/// In a plane: the diagram in arcs.
fn turns(quantities: &Quantities<'_>, index: usize, stage: &Moment, names: &str) -> Option<Drawing> {
    let ends = [1, 2].map(|side| format!("H_{}{}", stage.about, index + side));
    let [before, after] = [quantities.named(&ends[0])?, quantities.named(&ends[1])?];
    let [first, second] = ends.map(|name| name_math(&name));
    let wording = wording(quantities, index, stage, names, [&first, &second]);
    let wording = Wording { caption: sentences([wording.caption]), ..wording };
    // As the solution calls it, where it has a name.
    let gained = quantities.named("I_M").map_or_else(|| impulse(stage), |_| name_math("I_M"));
    let terms = [(first, before), (gained, after - before), (second, after)];
    let terms = terms.map(|(label, value)| AngularImpulse { label, value: Some(value) });
    Some(TurnDiagram { wording, centre: body_math(&stage.about), terms }.drawing())
}

/// The integral of the moment over the time.
fn impulse(stage: &Moment) -> Math {
    let bound = || Arc::new(Math::Row(Vec::new()));
    let moment = name_math(&format!("M_{}", stage.about));
    Math::Integral(bound(), bound(), Arc::new(moment), Arc::new(Math::Identifier("t".to_owned())))
}

impl Quantities<'_> {
    /// The name of a fixed point or the centre of mass in a sentence.
    fn centre(&self, about: &str) -> String {
        if about == "G" { "the centre of mass".to_owned() } else { self.point(about) }
    }
}
