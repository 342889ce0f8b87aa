//! Faded solutions: the first steps are shown, the rest is the student's.

use momentous_explain::Audience;
use momentous_explain::Block;
use momentous_explain::Outline;
use momentous_explain::Section;

/// The heading of the section whose displayed equations are the steps that fade.
const SOLVING: &str = "Laws";

/// Ruled lines left for each step that is taken away, and for the final answer.
const LINES_PER_STEP: u32 = 3;

/// The outline with only its first `steps` displayed equations of the solving section.
///
/// The sections before it stay whole. What follows the last step shown is replaced by ruled space, and so is all of
/// every later section, since it holds the answer; the instructor's sections go. The solving section is the one headed
/// "Laws", or else the last with an equation.
#[must_use]
pub fn fade(outline: &Outline, steps: usize) -> Outline {
    let sections = for_everyone(outline);
    let solving = solving(&sections);
    let fade_one = |(index, section): (usize, &&Section)| {
        let blocks = match solving {
            Some(at) if index == at => first_steps(&section.blocks, steps),
            Some(at) if index > at => vec![Block::Space { lines: LINES_PER_STEP }],
            _ => section.blocks.clone(),
        };
        Section { blocks, ..(*section).clone() }
    };
    Outline { title: outline.title.clone(), sections: sections.iter().enumerate().map(fade_one).collect() }
}

/// The number of steps of an outline that can fade.
#[must_use]
pub fn steps(outline: &Outline) -> usize {
    let sections = for_everyone(outline);
    let solving = solving(&sections).and_then(|at| sections.get(at));
    solving.map_or(0, |section| section.blocks.iter().filter(|block| is_step(block)).count())
}

fn for_everyone(outline: &Outline) -> Vec<&Section> {
    outline.sections.iter().filter(|section| section.audience == Audience::Everyone).collect()
}

/// The position of the solving section.
fn solving(sections: &[&Section]) -> Option<usize> {
    let headed = sections.iter().position(|section| section.heading == SOLVING);
    headed.or_else(|| sections.iter().rposition(|section| section.blocks.iter().any(is_step)))
}

fn is_step(block: &Block) -> bool {
    matches!(block, Block::Equation { .. })
}

/// The blocks up to the last step shown, then space for those that are not.
fn first_steps(blocks: &[Block], steps: usize) -> Vec<Block> {
    let places: Vec<usize> = (0..blocks.len()).filter(|&place| is_step(&blocks[place])).collect();
    let hidden = places.len().saturating_sub(steps);
    if hidden == 0 {
        return blocks.to_vec();
    }
    let kept = if steps == 0 { 0 } else { places[steps - 1] + 1 };
    let lines = LINES_PER_STEP.saturating_mul(u32::try_from(hidden).unwrap_or(u32::MAX)).min(20);
    let mut shown = blocks[..kept].to_vec();
    shown.push(Block::Space { lines });
    shown
}
