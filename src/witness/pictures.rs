//! Pictures that are offered, held against what the simulation finds.

use momentous_problem::Balance;
use momentous_problem::Pictured;
use momentous_problem::Shows;
use momentous_problem::Subject;
use momentous_problem::Worked;

use super::graphs;
use super::simulation::Witness;

/// The share of the longest arrow by which an arrow may be off what the simulation finds.
const OFF: f64 = 1e-6;

/// The only picture whose arrows are those that the simulation finds; none where it finds nothing of them, or another number of
/// pictures fits.
pub(super) fn fitting(witness: &Witness<'_>, pictured: &Pictured, worked: &Worked<'_>) -> Option<usize> {
    let pictures = pictured.pictures(worked);
    let mut fitting = Vec::new();
    for (place, picture) in pictures.iter().enumerate() {
        let fits = match (&pictured.subject, &picture.shows) {
            (Subject::Diagram(diagram), Shows::Diagram(rows)) => {
                let rows = rows.iter().map(|row| fits(witness, diagram.stage, row)).collect::<Option<Vec<bool>>>();
                rows.filter(|_| witness.has_run(diagram.stage))?.into_iter().all(|fits| fits)
            }
            (Subject::Graph(graph), Shows::Graph(curve)) => graphs::fits(witness, graph, curve, worked)?,
            (Subject::Diagram(_), Shows::Graph(_)) | (Subject::Graph(_), Shows::Diagram(_)) => false,
        };
        fitting.extend(fits.then_some(place));
    }
    if let [only] = fitting[..] { Some(only) } else { None }
}

/// Whether the row of a body is what the simulation finds of it.
fn fits(witness: &Witness<'_>, stage: usize, row: &Balance) -> Option<bool> {
    let axes = witness.scene().axes.rectangular();
    let letters: Vec<&str> = axes.iter().map(|(axis, _)| if axes.len() > 1 { axis.letter() } else { "" }).collect();
    let momentum = |instant| -> Option<Vec<f64>> {
        letters.iter().map(|letter| witness.carried("p", &row.body, instant, letter)).collect()
    };
    let (before, after) = (momentum(stage + 1)?, momentum(stage + 2)?);
    let impulse: Vec<f64> = after.iter().zip(&before).map(|(after, before)| after - before).collect();
    let arrows = [&before, &impulse, &after];
    let largest = arrows.iter().flat_map(|arrow| arrow.iter()).fold(0.0, |largest: f64, part| largest.max(part.abs()));
    let near = |(simulated, drawn): (&&Vec<f64>, &&Vec<f64>)| {
        simulated.iter().zip(drawn.iter()).all(|(simulated, drawn)| (simulated - drawn).abs() <= OFF * largest)
    };
    Some(arrows.iter().zip(&[&row.before, &row.impulse, &row.after]).all(near))
}
