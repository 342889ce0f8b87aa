//! The mass that a stream brings to a body, or that a body throws away, in a short time: its momentum before + impulse =
//! momentum after, as seen from the body.

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::Operator;
use momentous_expr::name_math;
use momentous_figure::BodyMomentum;
use momentous_figure::Drawing;
use momentous_figure::Form;
use momentous_figure::MomentumDiagram;
use momentous_figure::Wording;
use momentous_scene::stage::Exhaust;
use momentous_scene::stage::Stream;
use momentous_scene::stage::Thrust;

use super::compass::Compass;
use super::labels::factor;
use super::labels::product;
use super::quantities::Quantities;
use super::vectors::Labelled;
use super::words::sentences;

/// The flowing matter, and what happens to it.
struct Flow<'a> {
    /// Its name.
    what: &'a str,
    /// The body from which it is seen.
    body: &'a str,
    /// The clause that says what it does in the time of the diagram.
    does: &'a str,
    /// The labels at its speeds before and after, and these as vectors along x and y.
    before: (Math, [f64; 2]),
    after: (Math, [f64; 2]),
    /// The label at its impulse.
    impulse: Math,
}

/// The mass of a stream that arrives.
pub(super) fn arriving(
    quantities: &Quantities<'_>,
    compass: &Compass,
    index: usize,
    stage: &Stream,
) -> Option<Drawing> {
    let flowing = quantities.model().flowing_in(index)?;
    let speed = quantities.evaluate(&flowing.relative)?;
    let label = || factor(&flowing.relative, quantities.unsigned(&flowing.relative));
    let along = quantities.direction(&flowing.direction)?;
    let after = match (&flowing.leaving, &stage.restitution) {
        (None, _) if flowing.normal.is_some() => {
            let shares = flowing.after.iter().map(|share| quantities.evaluate(share)).collect::<Option<Vec<f64>>>()?;
            (Math::subscripted("v", "after"), times(quantities.along_axes(&shares)?, speed))
        }
        (Some(leaving), _) => (label(), times(quantities.direction(leaving)?, speed)),
        (None, Some(term)) => {
            let e = quantities.term(term)?;
            match quantities.evaluate(&e)? {
                0.0 => at_rest(),
                share => (product([factor(&e, quantities.symbolic(&e)), label()]), times(along, -share * speed)),
            }
        }
        // It stays, or it spreads evenly to all sides.
        (None, None) => at_rest(),
    };
    let flow = Flow {
        what: &stage.by,
        body: &stage.body,
        does: "arrives",
        before: (label(), times(along, speed)),
        after,
        // The body's force on it is the reaction of its own on the body, which is counted along the axes.
        impulse: Math::Row(vec![
            Math::Operator(Operator::Minus),
            in_short_time(name_math(&format!("F_{}", stage.body))),
        ]),
    };
    Some(flow.diagram(quantities, compass))
}

/// The mass that a body throws away.
pub(super) fn leaving(quantities: &Quantities<'_>, compass: &Compass, stage: &Thrust) -> Option<Drawing> {
    let Exhaust::Speed(term) = &stage.exhaust else { return None };
    let exhaust = quantities.term(term)?;
    let forwards = if quantities.is_backwards(stage.direction.as_ref()) { -1.0 } else { 1.0 };
    let along = quantities.along_axes(&[-forwards])?;
    let force = stage.force.as_ref().and_then(|force| quantities.term(force));
    let flow = Flow {
        what: "the exhaust",
        body: &stage.body,
        does: "is expelled",
        before: (Math::subscripted("v", "before"), [0.0, 0.0]),
        after: (factor(&exhaust, quantities.symbolic(&exhaust)), times(along, quantities.evaluate(&exhaust)?)),
        // A thrust is a magnitude, as the speed of the exhaust is: the arrows tell which way they point.
        impulse: in_short_time(force.map_or_else(
            || name_math(&format!("F_{}", stage.body)),
            |force: Expr| factor(&force, quantities.symbolic(&force)),
        )),
    };
    Some(flow.diagram(quantities, compass))
}

impl Flow<'_> {
    fn diagram(&self, quantities: &Quantities<'_>, compass: &Compass) -> Drawing {
        let momentum = |(speed, value): &(Math, [f64; 2])| Labelled {
            label: product([delta("m"), speed.clone()]),
            value: Some(*value),
        };
        let (before, after) = (momentum(&self.before), momentum(&self.after));
        let gain = [0, 1].map(|axis| self.after.1[axis] - self.before.1[axis]);
        let impulse = Labelled { label: self.impulse.clone(), value: Some(gain) };
        let (what, body) = (self.what, quantities.called(self.body));
        let said =
            [("momentum before", &before), ("impulse", &impulse), ("momentum after", &after)].map(|(name, vector)| {
                let value = vector.value.filter(|value| *value != [0.0, 0.0]);
                let way = value.map_or_else(|| ", zero".to_owned(), |value| format!(", {}", compass.words(value)));
                format!("{name}: {}{way}", vector.label.plain())
            });
        let wording = Wording {
            title: format!("Impulse-momentum diagram of {what}"),
            description: sentences([format!("for {what}, relative to {body}, {}", said.join("; "))]),
            caption: sentences([format!(
                "{what}, relative to {body}: momentum before + impulse = momentum after, for the mass \u{394}m that {} in the time \u{394}t",
                self.does
            )]),
        };
        let row = BodyMomentum {
            name: delta("m"),
            form: Form::Disc,
            surface: None,
            line_of_impact: None,
            before: before.placed(compass),
            impulses: vec![impulse.placed(compass)],
            after: after.placed(compass),
        };
        MomentumDiagram { wording, bodies: vec![row], axes: compass.marks() }.drawing()
    }
}

/// A flow without velocity along the line.
fn at_rest() -> (Math, [f64; 2]) {
    (Math::subscripted("v", "after"), [0.0, 0.0])
}

fn delta(letter: &str) -> Math {
    Math::Row(["\u{394}", letter].map(|letter| Math::Identifier(letter.to_owned())).to_vec())
}

/// The impulse of a force in the time of the diagram.
fn in_short_time(force: Math) -> Math {
    product([force, delta("t")])
}

fn times([x, y]: [f64; 2], factor: f64) -> [f64; 2] {
    [x * factor, y * factor]
}
