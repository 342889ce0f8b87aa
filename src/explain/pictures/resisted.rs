//! The free-body diagram of a body that flies against a resistance.

use momentous_expr::Math;
use momentous_figure::Drawing;
use momentous_figure::LabelledVector;
use momentous_figure::Layout;
use momentous_figure::Line;
use momentous_figure::Moving;
use momentous_figure::Situation;
use momentous_figure::Wording;
use momentous_scene::Plane;
use momentous_scene::stage::Flight;
use momentous_scene::stage::Resistance;

use super::super::wording::capitalised;
use super::compass::Compass;
use super::labels::factor;
use super::labels::product;
use super::quantities::Quantities;
use super::words::arrows;
use super::words::sentences;

/// Weight and resistance at the start of a flight; none where one of them is not known.
pub(super) fn drawing(
    quantities: &Quantities<'_>,
    compass: &Compass,
    index: usize,
    flight: &Flight,
) -> Option<Drawing> {
    let (Resistance::Linear(term), Some(body)) = (flight.resistance.as_ref()?, flight.flying().next()) else {
        return None;
    };
    let coefficient = quantities.term(term)?;
    let against = -quantities.evaluate(&coefficient)?;
    let velocity = quantities.velocity(body, index + 1)?.map(|part| against * part);
    let speed = Math::Identifier("v".to_owned());
    let label = product([factor(&coefficient, quantities.symbolic(&coefficient)), speed]);
    let mut forces = vec![Moving::force(LabelledVector::known(label, compass.place(velocity)))];
    if quantities.scene().plane == Plane::Vertical {
        let weight = quantities.mass(body, index + 1)? * quantities.named("g")?;
        let label = quantities.weight_math(body, index);
        forces.push(Moving::force(LabelledVector::known(label, [0.0, -weight])));
    }
    let moving = quantities.body(body, forces);
    let (name, when) = (quantities.called(body), quantities.when(index + 1));
    let wording = Wording {
        title: capitalised(&format!("free-body diagram of {name}")),
        description: sentences([format!("the forces on {name} {when}"), arrows(&moving, true).join(", ")]),
        caption: sentences([format!("the forces on {name} {when}: the resistance is opposite to the velocity")]),
    };
    let line = Line { angle: compass.axis_angle(0), bodies: vec![moving], ..Line::default() };
    Some(Situation { wording, layout: Layout::Line(line), axes: compass.marks() }.drawing())
}
