//! Random scenes of every kind of stage: each is solved and witnessed, or refused with a reason that is true.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test says bluntly what it expects")]

mod draw;
mod end;
mod table;

use std::collections::BTreeMap;

use momentous::render::Renderer;
use rayon::prelude::*;

use draw::draw;
use end::{End, asked};
use table::Table;

/// How many scenes of each kind ended how.
#[test]
#[ignore = "by hand"]
fn tally() {
    let table = Table::read();
    let renderer = Renderer::new(None).unwrap();
    let each: u64 = std::env::var("SCENES").map_or(20, |text| text.parse().unwrap());
    let only = std::env::var("KIND").ok();
    let verbose = std::env::var("SHOW").unwrap_or_default();
    for kind in table.stages.iter().filter(|kind| only.as_ref().is_none_or(|only| *only == kind.name)) {
        let drawn = (0..each).into_par_iter().map(|seed| draw(&table, &kind.name, seed));
        let ends: Vec<(String, End)> = drawn
            .map(|drawn| {
                let start = std::time::Instant::now();
                let (file, end) = asked(&drawn, &renderer);
                if start.elapsed().as_secs() > 10 {
                    println!("SLOW {:?} {end:?}\n{file}", start.elapsed());
                }
                (file, end)
            })
            .collect();
        let mut counts = BTreeMap::<&str, usize>::new();
        for (file, end) in &ends {
            let (name, text) = match end {
                End::Witnessed => ("witnessed", ""),
                End::Unwitnessed(why) => ("unwitnessed", why.as_str()),
                End::Refused(why) => ("refused", why.as_str()),
                End::Fault(why) => ("fault", why.as_str()),
            };
            *counts.entry(name).or_default() += 1;
            if verbose.contains(name) {
                println!("=== {name} {}: {text}\n{file}", kind.name);
            }
        }
        println!("{:12} {counts:?}", kind.name);
    }
}
