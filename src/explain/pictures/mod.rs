//! Figures of a variant, filled from its numbers: the diagrams of a solution, and the figure on the problem sheet.

mod angular;
mod arm;
mod besides;
mod compass;
mod flow;
mod moment;
mod momentum;
mod oblique;
mod plot;
mod quantities;
mod sheet;
mod snapshot;
mod string;
mod vectors;
mod words;

use crate::figure::Drawing;
use crate::problem::Sampler;
use crate::problem::Variant;
use crate::problem::Worked;
use crate::scene::Plane;
use crate::scene::Stage;

use super::cache::SolutionCache;

pub(super) use compass::Compass;
pub(super) use momentum::Plan;
use quantities::Quantities;
use quantities::Scope;

/// The figures of the worked solution: the diagrams of every stage, or of the single instant.
pub(super) fn solution(worked: Worked<'_>) -> Vec<Drawing> {
    let sibling = solved_sibling(worked);
    let worked = sibling.as_ref().and_then(|variant| Worked::new(worked.problem, variant)).unwrap_or(worked);
    let quantities = Quantities::new(worked, Scope::Solved);
    let cache = SolutionCache::of(worked);
    let compass = cache.compass(worked);
    let stages = &quantities.scene().stages;
    if stages.is_empty() {
        return snapshot::drawing(&quantities, compass).into_iter().collect();
    }
    let drawings = stages.iter().enumerate().flat_map(|(index, stage)| match stage {
        Stage::Rotate(rotate) if rotate.is_arm() => vec![arm::rotation(&quantities, index, rotate)],
        Stage::Rotate(rotate) => vec![angular::rotation(&quantities, index, rotate)],
        Stage::Strike(strike) => vec![arm::strike(&quantities, index, strike)],
        Stage::Conical(conical) => vec![Some(angular::conical(&quantities, index, conical))],
        Stage::Bowl(bowl) => vec![Some(angular::bowl(&quantities, index, bowl))],
        Stage::Moment(moment) => vec![moment::diagram(&quantities, compass, index, moment)],
        Stage::Central(central) => vec![Some(angular::central(&quantities, index, central))],
        Stage::Bounces(bounces) => vec![sheet::fall::bouncing(&quantities, bounces)],
        Stage::Push(_) => {
            let plot = plot::force_plot(&quantities, index);
            let place = snapshot::in_space(&quantities, compass).filter(|_| index == 0);
            [place, plot, momentum::diagram(&quantities, compass, index)].into_iter().collect()
        }
        Stage::Slide(slide) if slide.is_ramp() => vec![Some(sheet::ramp::drawing(&quantities, compass, index, slide))],
        Stage::Swing(swing) => vec![Some(sheet::swing::drawing(&quantities, compass, index, swing))],
        Stage::Connected(connected) => vec![string::diagram(&quantities, index, connected)],
        Stage::Stream(stream) => vec![
            sheet::stream::drawing(&quantities, compass, index, stream),
            flow::arriving(&quantities, compass, index, stream),
        ],
        Stage::Thrust(thrust) => {
            [sheet::stream::rocket(&quantities, compass, index, thrust), flow::leaving(&quantities, compass, thrust)]
                .to_vec()
        }
        // What a ball gains before it bounces on is not asked for; the figure of the bounces shows its fall.
        Stage::Fall(_) if matches!(stages.get(index + 1), Some(Stage::Bounces(_))) => Vec::new(),
        Stage::Walk(walk) => vec![sheet::ride::walk(&quantities, compass, index, walk)],
        Stage::Interact(own) if own.at_rest => vec![snapshot::displacements(&quantities, compass, index, &own.between)],
        Stage::Drift(_) => Vec::new(),
        Stage::Flight(_) if quantities.scene().plane == Plane::Horizontal => Vec::new(),
        Stage::Impact(_)
        | Stage::Spring(_)
        | Stage::Taut(_)
        | Stage::Tow(_)
        | Stage::Blow(_)
        | Stage::Motion(_)
        | Stage::Fall(_)
        | Stage::Separate(_)
        | Stage::Slide(_)
        | Stage::SlideOff(_)
        | Stage::Interact(_)
        | Stage::Flight(_) => {
            vec![momentum::diagram(&quantities, compass, index)]
        }
    });
    // What nobody asks for may be solved without its forces.
    drawings.flatten().filter(Drawing::is_known).collect()
}

/// The same numbers in a form that solves something, for a form that only asks for concepts and has nothing to draw.
fn solved_sibling(worked: Worked<'_>) -> Option<Variant> {
    if worked.form.wanted().next().is_some() {
        return None;
    }
    let forms = worked.problem.forms();
    let solving = forms.iter().position(|form| form.reveal.is_empty() && form.wanted().next().is_some())?;
    let mut sampler = Sampler::new(worked.problem, solving).ok()?;
    sampler.with_values(worked.variant.seed().unwrap_or(0), worked.variant.all_given()).ok()
}

/// The figure of the problem sheet, which shows only what is given; none where that is no more than outlines of bodies.
#[must_use]
pub fn situation(worked: Worked<'_>) -> Option<Drawing> {
    let quantities = Quantities::new(worked, Scope::Given);
    let cache = SolutionCache::of(worked);
    sheet::drawing(&quantities, cache.compass(worked)).filter(|drawing| !drawing.is_bare())
}
