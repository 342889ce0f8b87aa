//! A body on a smooth ramp of any shape.

use momentous_figure::Drawing;
use momentous_figure::Layout;
use momentous_figure::Ramp;
use momentous_figure::Situation;
use momentous_figure::Wording;
use momentous_scene::stage::Slide;
use momentous_scene::stage::UpOrDown;

use super::super::super::wording::capitalised;
use super::super::compass::Compass;
use super::super::quantities::Quantities;
use super::super::quantities::Scope;
use super::super::words::sentences;

/// The body where it starts, in a solution also where it ends, there with its velocities.
pub(in super::super) fn drawing(
    quantities: &Quantities<'_>,
    compass: &Compass,
    index: usize,
    stage: &Slide,
) -> Drawing {
    let falls = stage.way != Some(UpOrDown::Up);
    let forwards = if quantities.is_backwards(stage.direction.as_ref()) { -1.0 } else { 1.0 };
    let rightwards = (compass.place([forwards, 0.0])[0] > 0.0) == falls;
    let vectors = |instant: usize| quantities.motion(compass, &stage.body, instant);
    let [start, end] = [index + 1, index + 2].map(vectors);
    let end = (quantities.scope() == Scope::Solved || !end.is_empty()).then_some(end);
    let (top, foot) = if falls { (Some(start), end) } else { (end, Some(start)) };
    let height = stage.height.as_ref().and_then(|height| quantities.label_of(height));
    let name = quantities.called(&stage.body);
    let told =
        height.as_ref().map_or_else(String::new, |height| format!("the height of the ramp is {}", height.plain()));
    let at_ends = if quantities.scope() == Scope::Solved { ", with its velocity at both ends" } else { "" };
    let wording = Wording {
        title: capitalised(&format!("{name} on the ramp")),
        description: sentences([format!("{name} on a smooth ramp{at_ends}"), told]),
        caption: sentences([format!("{name} on the ramp{at_ends}")]),
    };
    let ramp = Ramp { body: quantities.body(&stage.body, Vec::new()), top, foot, rightwards, height };
    Situation { wording, layout: Layout::Ramp(ramp), axes: compass.marks() }.drawing()
}
