//! Text of any kind, as problem files, answers, formulas, tables, rosters and requests: nothing panics, nothing hangs, and what is refused is
//! refused with a reason. `.ci/soak` runs the same under a fuzzer for as long as one likes.

use std::path::Path;

use momentous::bank::Bank;
use momentous::fault::Source;
use proptest::prelude::*;

mod seeds;
mod targets;

use targets::{TARGETS, Target};

/// How many random texts each target is tried with.
const CASES: u32 = 10_000;

/// How many random requests: each takes as long as many texts.
const REQUESTS: u32 = 1_000;

fn few_bytes() -> impl Strategy<Value = Vec<u8>> {
    proptest::collection::vec(any::<u8>(), 0..24)
}

/// Runs a target over texts that are made of random bytes.
fn try_random(name: &str, text: impl Fn(&[u8], &[String]) -> String) {
    try_so_many(CASES, name, text);
}

fn try_so_many(cases: u32, name: &str, text: impl Fn(&[u8], &[String]) -> String) {
    let target = Target::named(name);
    let pieces = target.pieces();
    let config = ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() };
    proptest!(config, |(chosen: u8, bytes in few_bytes())| {
        (target.run)(chosen, &text(&bytes, &pieces));
    });
}

/// Text made of pieces, one for each byte but a few, which stand for themselves.
fn pieced(bytes: &[u8], pieces: &[String]) -> String {
    let piece = |byte: &u8| pieces.get(usize::from(*byte)).cloned().unwrap_or_else(|| char::from(*byte).to_string());
    bytes.iter().map(piece).collect()
}

/// The nearest boundary of characters at or below a place.
fn boundary(text: &str, at: usize) -> usize {
    (0..=at.min(text.len())).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0)
}

/// A file of the bank with a few places cut out, doubled, or filled with pieces of other files.
fn spoilt(bytes: &[u8], sources: &[Source], pieces: &[String]) -> String {
    let [chosen, edits @ ..] = bytes else { return String::new() };
    let Some(source) = sources.get(usize::from(*chosen) % sources.len().max(1)) else { return String::new() };
    let mut text = source.text.to_string();
    for edit in edits.chunks_exact(4).take(8) {
        let [high, low, length, piece] = [edit[0], edit[1], edit[2], edit[3]].map(usize::from);
        let from = boundary(&text, (high << 8 | low) % (text.len() + 1));
        let to = boundary(&text, from + length % 64).max(from);
        let piece = pieces.get(piece).cloned().unwrap_or_else(|| text[from..to].repeat(2));
        text.replace_range(from..to, &piece);
    }
    text
}

#[test]
fn problem_files() {
    let sources: Vec<Source> = Bank::built_in().sources().cloned().collect();
    try_random("problem_file", |bytes, pieces| spoilt(bytes, &sources, pieces));
}

#[test]
fn answers() {
    try_random("answer", pieced);
}

#[test]
fn formulas() {
    try_random("formula", pieced);
}

#[test]
fn tables() {
    try_random("table", pieced);
    try_random("table", |bytes, pieces| format!("student,problem,seed,form,v_A2\n{}", pieced(bytes, pieces)));
    try_random("table", |bytes, pieces| format!("{{\"problem\":\"impact/two-carts\",{}", pieced(bytes, pieces)));
}

#[test]
fn rosters() {
    try_random("roster", pieced);
    try_random("roster", |bytes, pieces| format!("id,name\n{}", pieced(bytes, pieces)));
    let head = "student,problem,digest,form,seed,derivation";
    try_random("roster", |bytes, pieces| format!("{head}\n{}", pieced(bytes, pieces)));
}

#[test]
fn routes() {
    try_so_many(REQUESTS, "route", pieced);
    let calls = ["read", "mark", "sheet", "solve", "simulate", "hint", "givens", "collision", "restitution"];
    try_so_many(REQUESTS, "route", |bytes, pieces| {
        let call = calls[usize::from(*bytes.first().unwrap_or(&0)) % calls.len()];
        format!("/api/{call}\n{{\"problem\":\"impact/two-carts\",{}", pieced(bytes, pieces))
    });
}

/// What a fuzzer starts from holds as well.
#[test]
fn seeds_of_the_fuzzer() {
    for target in TARGETS {
        let seeds = seeds::of(target.name, Path::new(env!("CARGO_MANIFEST_DIR")));
        assert!(seeds.len() > 5, "{} has too few", target.name);
        for (text, chosen) in seeds.iter().zip((0..=u8::MAX).cycle()) {
            (target.run)(chosen, text);
        }
    }
}
