//! Figures of a variant, filled from its numbers: the diagrams of a solution, and the figure on the problem sheet.

mod angular;
mod arm;
mod asked;
mod balance;
mod besides;
mod cache;
mod compass;
mod curve;
mod diagram_plan;
mod flow;
mod free_body;
mod graph;
mod labels;
mod legend;
mod masses;
mod moment;
mod momentum;
mod oblique;
mod offered_graph;
mod participants;
mod plot;
mod principle;
mod quantities;
mod resisted;
mod sense;
mod sheet;
mod snapshot;
mod stages;
mod string;
mod vectors;
mod words;

use momentous_figure::Drawing;
use momentous_problem::Pictured;
use momentous_problem::Subject;

pub(super) use cache::PictureCache;
pub(super) use quantities::Quantities;
pub(super) use quantities::Scope;

/// The figures of the worked solution: the diagrams of that many stages, or a figure of the single instant.
pub(super) fn solution(quantities: &Quantities<'_>, count: usize) -> Vec<Drawing> {
    let compass = quantities.compass();
    let stages = &quantities.scene().stages;
    let mut drawings = Vec::new();
    if stages.is_empty() {
        drawings.extend(snapshot::drawing(quantities, compass));
    } else if count == 0 {
        drawings.extend(stages::sheet(quantities, compass));
    }
    for (index, stage) in stages.iter().enumerate().take(count) {
        // What nobody asks for may be solved without its forces.
        let drawings_of_stage = stages::solution(quantities, compass, index, stage).into_iter().flatten();
        drawings.extend(drawings_of_stage.filter(Drawing::is_known));
        drawings.extend(free_body::at_instants(quantities, compass, index, stage));
    }
    legend::tell(quantities, &mut drawings);
    drawings
}

/// The figure of the problem sheet, which shows only what is given; none where that is no more than outlines of bodies.
pub(super) fn situation(quantities: &Quantities<'_>) -> Option<Drawing> {
    let mut drawing = stages::sheet(quantities, quantities.compass()).filter(|drawing| !drawing.is_bare())?;
    legend::tell(quantities, std::slice::from_mut(&mut drawing));
    Some(drawing)
}

/// The pictures that are offered in a choice, in their order.
pub(super) fn offered(quantities: &Quantities<'_>, pictured: &Pictured) -> Vec<Drawing> {
    let pictures = pictured.pictures(&quantities.worked);
    match &pictured.subject {
        Subject::Diagram(diagram) => {
            pictures.iter().filter_map(|picture| stages::offered(quantities, diagram.stage, picture)).collect()
        }
        Subject::Graph(graph) => offered_graph::drawings(quantities, graph, &pictures),
    }
}
