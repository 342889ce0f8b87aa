//! Every sheet and worked solution of the bank, set by a real pdfLaTeX.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use momentous::exercise::Exercise;
use momentous::explain::Audience;
use momentous::explain::Detail;
use momentous::render::{Format, Page, Renderer, Solution};

use crate::pdflatex;
use crate::problems;

/// A line may run over the margin by so many points: no reader sees it.
const GROSS: f64 = 5.0;

/// Forms in one document: a start of pdfLaTeX takes longer than a page.
const TOGETHER: usize = 6;

#[test]
fn every_sheet_and_solution_of_the_bank_is_set() {
    if !pdflatex::is_installed() {
        return;
    }
    let exercises = problems::exercises(2);
    let batches: Vec<&[Exercise]> = exercises.chunks(TOGETHER).collect();
    let next = AtomicUsize::new(0);
    let work = || {
        let mut wrong = Vec::new();
        while let Some(batch) = batches.get(next.fetch_add(1, Ordering::Relaxed)) {
            wrong.extend(faults(batch));
        }
        wrong
    };
    let threads = thread::available_parallelism().map_or(1, usize::from).min(batches.len());
    let wrong: Vec<String> = thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        workers.into_iter().flat_map(|worker| worker.join().unwrap()).collect()
    });
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// What is wrong with the document of some forms; where something is, each form is set alone to tell which it is.
fn faults(exercises: &[Exercise]) -> Vec<String> {
    let pages: Vec<Page> = exercises.iter().flat_map(pages).collect();
    let text = Renderer::new(None).unwrap().render(&pages, Format::Latex).unwrap().text;
    let wrong = match pdflatex::compile(&text) {
        Ok(lines) => lines.into_iter().filter(|line| line.points > GROSS).map(|line| line.report).collect(),
        Err(log) => vec![log],
    };
    match exercises {
        _ if wrong.is_empty() => Vec::new(),
        [only] => wrong.iter().map(|fault| format!("{}: {fault}", problems::name(only))).collect(),
        several => several.iter().flat_map(|exercise| faults(std::slice::from_ref(exercise))).collect(),
    }
}

/// The sheet and the solution with all that an instructor sees.
fn pages(exercise: &Exercise) -> [Page; 2] {
    let (outline, identity) = (exercise.outline(Audience::Instructor, Detail::Full), exercise.identity());
    let solution = Solution { outline, identity, audience: Audience::Instructor, faded: None };
    [Page::Sheet(exercise.sheet()), Page::Solution(solution)]
}
