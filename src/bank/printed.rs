//! Whether all that can be asked to be printed of a form can be.

use std::sync::Arc;

use momentous_exercise::Drawer;
use momentous_exercise::Exercise;
use momentous_explain::Audience;
use momentous_explain::Detail;
use momentous_fault::Faults;
use momentous_problem::Problem;
use momentous_render::Format;
use momentous_render::Key;
use momentous_render::Page;
use momentous_render::Renderer;
use momentous_render::Solution;

use super::promise::Outcome;

/// Seeds whose documents are written whole, in every format. The author's texts are read with all seeds; what else stands in
/// a document is escaped by the writer, and no number in it can be at fault.
const WRITTEN: u64 = 4;

/// The texts of every seed can be printed, and the documents of the first seeds in every format.
pub(super) fn prints(problem: &Arc<Problem>, form: usize, seeds: u64, renderer: &Renderer) -> Outcome {
    let Ok(mut drawer) = Drawer::new(problem, form) else { return Outcome::NotChecked("there is no such form") };
    for seed in 1..=seeds {
        // What draws nothing is told elsewhere.
        let Ok(exercise) = drawer.draw(seed) else { continue };
        let read = exercise.printable();
        let written = read.and_then(|()| if seed <= WRITTEN { write(&exercise, renderer) } else { Ok(()) });
        if let Err(faults) = written {
            return Outcome::Broken(format!("with seed {seed}\n{faults}"));
        }
    }
    Outcome::Kept
}

fn write(exercise: &Exercise, renderer: &Renderer) -> Result<(), Faults> {
    let solution = |audience, detail| {
        let (outline, identity) = (exercise.outline(audience, detail), exercise.identity());
        Page::Solution(Solution { outline, identity, audience, faded: None })
    };
    let pages = [
        Page::Sheet(exercise.sheet()),
        solution(Audience::Everyone, Detail::Short),
        solution(Audience::Instructor, Detail::Full),
        Page::Key(Key { title: String::new(), rows: exercise.key() }),
    ];
    Format::ALL.into_iter().try_for_each(|format| renderer.render(&pages, format).map(|_| ()))
}
