//! Random scenes of every kind of stage: each is solved and witnessed, or refused with a reason.
//!
//! `stages.txt` says how they are drawn, `draw.rs` draws them and `end.rs` looks at them as `momentous check` does. A broken promise is a
//! fault of the program: its laws and its simulation disagree, a line of its solution does not reproduce, a right answer is marked wrong.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test says bluntly what it expects")]

mod advice;
mod balance;
mod draw;
mod end;
mod film;
mod keys;
mod knock_out;
mod lack;
mod observer;
mod system;
mod table;

use std::collections::BTreeMap;
use std::fmt;

use momentous::render::Renderer;
use rayon::prelude::*;

use end::{End, Ended, Refusal, ended};
use table::Table;

/// Scenes of each kind that are tried with every change.
const EACH: u64 = 12;

/// How many scenes of a kind ended how, and how often they were refused with other numbers or questions.
#[derive(Default)]
struct Counts {
    witnessed: usize,
    unwitnessed: usize,
    refused: BTreeMap<Refusal, usize>,
    on_the_way: BTreeMap<Refusal, usize>,
    shown: usize,
    faults: Vec<String>,
}

impl Counts {
    fn add(&mut self, ended: &Ended) {
        match &ended.end {
            End::Witnessed => self.witnessed += 1,
            End::Unwitnessed(_) => self.unwitnessed += 1,
            End::Refused(refusal, _) => *self.refused.entry(*refusal).or_default() += 1,
            End::Fault(why) => self.faults.push(format!("{why}\n{}", ended.file)),
        }
        for (refusal, ..) in &ended.on_the_way {
            *self.on_the_way.entry(*refusal).or_default() += 1;
        }
        self.shown += ended.shown;
    }

    fn all(&self) -> usize {
        self.witnessed + self.unwitnessed + self.refused.values().sum::<usize>() + self.faults.len()
    }
}

/// The head of the table of counts.
fn head() -> String {
    let refusals = Refusal::ALL.map(|refusal| format!("{:>15}", refusal.name())).concat();
    format!("{:10}{:>10}{:>12}{refusals}{:>12}{:>7}", "kind", "witnessed", "unwitnessed", "two worlds", "fault")
}

impl fmt::Display for Counts {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{:>10}{:>12}", self.witnessed, self.unwitnessed)?;
        for refusal in Refusal::ALL {
            let count = |all: &BTreeMap<Refusal, usize>| all.get(&refusal).copied().unwrap_or_default();
            write!(out, "{:>15}", format!("{} + {}", count(&self.refused), count(&self.on_the_way)))?;
        }
        write!(out, "{:>12}{:>7}", self.shown, self.faults.len())
    }
}

/// The first of them.
const FIRST: u64 = 0;

/// A number in the environment.
fn number(name: &str, else_: u64) -> u64 {
    std::env::var(name).map_or(else_, |text| text.parse().unwrap())
}

/// Whether a kind of stage is to be tried: every one, where `KIND` names none.
fn only(kind: &str) -> bool {
    std::env::var("KIND").map_or(true, |only| only == kind)
}

/// The ends of so many scenes of every kind, from a seed on, printed as a table: behind each number of refused scenes, how often others
/// were refused so before they ended, with other numbers or questions. Where `SHOW` names an end (`witnessed`, `named`, `no-method`), its
/// scenes are printed; `KIND` names the only kind that is tried.
fn tally(first: u64, each: u64) -> BTreeMap<String, Counts> {
    let (table, renderer) = (Table::read(), Renderer::new(None).unwrap());
    let show = std::env::var("SHOW").unwrap_or_default();
    let shows = |end: &str| show.split(',').any(|name| name == end);
    let mut tally = BTreeMap::new();
    println!("{}", head());
    // Scenes of all kinds side by side: a slow one keeps no core waiting.
    let kinds: Vec<_> = table.stages.iter().filter(|kind| only(&kind.name)).collect();
    let scenes: Vec<(usize, u64)> =
        (0..kinds.len()).flat_map(|kind| (first..first + each).map(move |seed| (kind, seed))).collect();
    let all: Vec<(usize, Ended)> =
        scenes.into_par_iter().map(|(kind, seed)| (kind, ended(&table, &kinds[kind].name, seed, &renderer))).collect();
    for (place, kind) in kinds.into_iter().enumerate() {
        let mut counts = Counts::default();
        for (_, ended) in all.iter().filter(|(kind, _)| *kind == place) {
            counts.add(ended);
            if shows(ended.end.name()) {
                println!("=== {} {}: {}\n{}", ended.end.name(), kind.name, ended.end.reason(), ended.file);
            }
            for (refusal, why, file) in ended.on_the_way.iter().filter(|(refusal, ..)| shows(refusal.name())) {
                println!("=== {} {} on the way: {why}\n{file}", refusal.name(), kind.name);
            }
        }
        println!("{:10}{counts}", kind.name);
        tally.insert(kind.name.clone(), counts);
    }
    tally
}

fn faults(tally: &BTreeMap<String, Counts>) -> Vec<&str> {
    tally.values().flat_map(|counts| &counts.faults).map(String::as_str).collect()
}

#[test]
fn scenes_are_solved_and_witnessed_or_refused() {
    let tally = tally(FIRST, EACH);
    assert!(faults(&tally).is_empty(), "{}", faults(&tally).join("\n\n"));
    let solved: usize = tally.values().map(|counts| counts.witnessed).sum();
    let all: usize = tally.values().map(Counts::all).sum();
    assert!(2 * solved >= all, "only {solved} of {all} scenes were solved");
}

/// `.ci/soak scenes` draws others, from the seed `FIRST` on.
#[test]
#[ignore = "takes an hour"]
fn thousands_of_scenes_are_solved_and_witnessed_or_refused() {
    let tally = tally(number("FIRST", 1_000), number("SCENES", 20_000).div_ceil(26));
    assert!(faults(&tally).is_empty(), "{}", faults(&tally).join("\n\n"));
    for (kind, counts) in &tally {
        assert!(10 * counts.witnessed >= 3 * counts.all(), "{kind}: only {} of {}", counts.witnessed, counts.all());
    }
}
