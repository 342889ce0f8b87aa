//! Random scenes of every kind of stage: each is solved and witnessed, or refused with a reason.
//!
//! `stages.txt` says how they are drawn, `draw.rs` draws them and `end.rs` looks at them as `momentous check` does. A broken promise is a
//! fault of the program: its laws and its simulation disagree, a line of its solution does not reproduce, a right answer is marked wrong.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test says bluntly what it expects")]

mod draw;
mod end;
mod keys;
mod knock_out;
mod table;

use std::collections::BTreeMap;
use std::fmt;

use momentous::render::Renderer;
use rayon::prelude::*;

use draw::draw;
use end::{End, asked};
use table::Table;

/// Scenes of each kind that are tried with every change.
const EACH: u64 = 12;

/// How many scenes ended how.
#[derive(Default)]
struct Counts {
    witnessed: usize,
    unwitnessed: usize,
    refused: usize,
    faults: Vec<String>,
}

impl Counts {
    fn add(&mut self, file: &str, end: &End) {
        match end {
            End::Witnessed => self.witnessed += 1,
            End::Unwitnessed(_) => self.unwitnessed += 1,
            End::Refused(_) => self.refused += 1,
            End::Fault(why) => self.faults.push(format!("{why}\n{file}")),
        }
    }
}

impl fmt::Display for Counts {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { witnessed, unwitnessed, refused, faults } = self;
        let faults = faults.len();
        write!(out, "{witnessed} witnessed, {unwitnessed} solved alone, {refused} refused, {faults} at fault")
    }
}

/// The ends of so many scenes of every kind, from a seed on. Where `SHOW` names an end (`witnessed`, `unwitnessed`, `refused`), its scenes
/// are printed; `KIND` names the only kind that is tried.
fn tally(first: u64, each: u64) -> BTreeMap<String, Counts> {
    let (table, renderer) = (Table::read(), Renderer::new(None).unwrap());
    let (show, only) = (std::env::var("SHOW").unwrap_or_default(), std::env::var("KIND").ok());
    let mut tally = BTreeMap::new();
    for kind in table.stages.iter().filter(|kind| only.as_ref().is_none_or(|only| *only == kind.name)) {
        let scenes = (first..first + each).into_par_iter().map(|seed| draw(&table, &kind.name, seed));
        let ends: Vec<(String, End)> = scenes.map(|scene| asked(&scene, &renderer)).collect();
        let mut counts = Counts::default();
        for (file, end) in &ends {
            counts.add(file, end);
            if show.split(',').any(|name| name == end.name()) {
                println!("=== {} {}: {}\n{file}", end.name(), kind.name, end.reason());
            }
        }
        println!("{:10} {counts}", kind.name);
        tally.insert(kind.name.clone(), counts);
    }
    tally
}

fn faults(tally: &BTreeMap<String, Counts>) -> Vec<&str> {
    tally.values().flat_map(|counts| &counts.faults).map(String::as_str).collect()
}

#[test]
fn scenes_are_solved_and_witnessed_or_refused() {
    let tally = tally(0, EACH);
    assert!(faults(&tally).is_empty(), "{}", faults(&tally).join("\n\n"));
    let solved: usize = tally.values().map(|counts| counts.witnessed).sum();
    let all = tally.len() * usize::try_from(EACH).unwrap();
    assert!(4 * solved >= all, "only {solved} of {all} scenes were solved");
}

/// `.ci/soak scenes` draws others, from the seed `FIRST` on.
#[test]
#[ignore = "takes an hour"]
fn thousands_of_scenes_are_solved_and_witnessed_or_refused() {
    let number = |name: &str, else_: u64| std::env::var(name).map_or(else_, |text| text.parse().unwrap());
    let tally = tally(number("FIRST", 1_000), number("SCENES", 20_000).div_ceil(26));
    assert!(faults(&tally).is_empty(), "{}", faults(&tally).join("\n\n"));
}
