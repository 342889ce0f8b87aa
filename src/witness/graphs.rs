//! Graphs that are offered, held against the motion that is watched.

use momentous_problem::Curve;
use momentous_problem::Graph;
use momentous_problem::Plotted;
use momentous_problem::Worked;
use momentous_simulate::Moment;
use momentous_simulate::Recorded;
use momentous_simulate::scene::RecordedMotion;

use super::simulation::Witness;

/// The share of the height by which a curve may be off what is watched, between two of its points; and that by which a force may be,
/// which is the mean of one over a short time.
const OFF: [f64; 2] = [1e-3, 2e-2];

/// The share of a force's times at which it may jump.
const JUMPS: f64 = 0.05;

/// The share of the whole time by which an end is looked at from inside.
const INSIDE: f64 = 1e-6;

/// Whether a curve is what the simulation finds at both ends of each stage, and all the way where it lasts; none where it finds
/// nothing of that.
pub(super) fn fits(witness: &Witness<'_>, graph: &Graph, curve: &Curve, worked: &Worked<'_>) -> Option<bool> {
    let spans = graph.spans(&|symbol| worked.value_of(symbol));
    let [low, high] = curve.reach();
    let height = high - low;
    let first = curve.points().next()?[0];
    let inside = INSIDE * (curve.points().last()?[0] - first);
    let mut all = true;
    for (stage, [begin, end]) in spans {
        if !witness.has_run(stage) {
            return None;
        }
        if graph.plotted != Plotted::Force {
            // Before and after what is sudden, within what lasts.
            let [before, after] =
                if end > begin { [begin + inside, end - inside] } else { [begin - inside, end + inside] };
            for (instant, time) in [(stage + 1, before), (stage + 2, after)] {
                let carried = witness.carried(graph.plotted.letter(), &graph.body, instant, letter(graph))?;
                all &= (carried - curve.at(time)?).abs() <= OFF[0] * height;
            }
        }
        if end > begin {
            all &= follows(witness, &witness.watched(stage)?, graph, curve, [begin, end])?;
        }
    }
    Some(all)
}

fn letter(graph: &Graph) -> &'static str {
    graph.along.map_or("", |axis| axis.letter())
}

/// Whether a curve follows what is watched of a stage.
fn follows(
    witness: &Witness<'_>,
    motions: &[RecordedMotion],
    graph: &Graph,
    curve: &Curve,
    [begin, end]: [f64; 2],
) -> Option<bool> {
    let [low, high] = curve.reach();
    let height = high - low;
    let moves =
        |body: &Recorded| body.name == graph.body || witness.scene().members(&body.name).contains(&graph.body.as_str());
    let motion_and_body =
        motions.iter().find_map(|motion| Some((motion, motion.record.bodies.iter().position(moves)?)));
    let (motion, body) = motion_and_body?;
    let component = match graph.along {
        Some(axis) => motion.components.iter().position(|component| component.letter == axis.letter())?,
        None => 0,
    };
    let moments = &motion.record.moments;
    let (first, last) = (moments.first()?.time, moments.last()?.time);
    let at = |time: f64| curve.at(begin + (end - begin) * (time - first) / (last - first));
    let state = |moment: &Moment| -> Option<f64> {
        let velocity = *moment.velocities.get(body)?.get(component)?;
        Some(if graph.plotted == Plotted::Velocity { velocity } else { moment.masses.get(body)? * velocity })
    };
    let (mut count, mut off) = (0.0, 0.0);
    for pair in moments.windows(2) {
        let [one, other] = pair else { continue };
        let lasts = other.time - one.time;
        if lasts <= 0.0 {
            continue;
        }
        let middle = f64::midpoint(one.time, other.time);
        let (value, allowed) = match graph.plotted {
            Plotted::Force => ((state(other)? - state(one)?) / lasts, OFF[1]),
            Plotted::Velocity | Plotted::Momentum => (f64::midpoint(state(one)?, state(other)?), OFF[0]),
        };
        count += 1.0;
        off += if (value - at(middle)?).abs() > allowed * height { 1.0 } else { 0.0 };
    }
    Some(off <= JUMPS * count)
}
