//! A refusal ends in the door: whoever does what its help says is not refused for the same reason again.

use std::collections::BTreeMap;

use momentous::fault::{Code, Fault, Source};
use momentous::problem::{compile, load};
use rayon::prelude::*;

use super::draw::{Drawn, draw};
use super::table::Table;

/// Scenes of each kind whose refusals are followed.
const EACH: u64 = 10;

/// Values that are tried for what is to be given, in the unit of the table.
const TRIED: [&str; 6] = ["2", "0.7", "6", "-1.5", "25", "0.1"];

/// What a help says is to be done.
#[derive(Clone, Debug, PartialEq)]
enum Advice {
    /// Further quantities are to be given, with any values that fit.
    Give(Vec<String>),
    /// A line of `given` is to be written as it stands: `T_1: any J`, `angle_A2: 60 deg`.
    Write(String),
    /// A quantity is to be given in place of another.
    Replace { by: String, given: String },
    /// What happens is to be allowed by name.
    Allow(String),
}

impl Advice {
    /// Everything that a fault advises and that can be done without knowing more of the scene.
    fn of(fault: &Fault) -> Vec<Self> {
        let help = fault.help.as_deref().unwrap_or_default();
        let mut all = Vec::new();
        if let Some(ways) = help.strip_prefix("give also ") {
            let ways = ways.split("; ").next().unwrap_or_default();
            all.extend(ways.split(", or ").map(|way| Self::Give(quoted(way))));
        }
        for part in
            ["its value does not matter: ", "what is asked does not depend on it: give ", "there is a solution with "]
        {
            let Some((_, said)) = help.split_once(part) else { continue };
            let said = said.split("; ").next().unwrap_or_default();
            all.extend(quoted(said).into_iter().map(Self::Write));
        }
        if let Some(ways) = help.strip_prefix("give ").filter(|ways| ways.contains(" in place of ")) {
            let pair = |way: &str| Some((quoted(way).first()?.clone(), quoted(way).get(1)?.clone()));
            all.extend(ways.split(", or ").filter_map(pair).map(|(by, given)| Self::Replace { by, given }));
        }
        if let Some((_, name)) = help.split_once("if it is meant so, write `allow: [") {
            all.extend(name.split(']').next().map(|name| Self::Allow(name.to_owned())));
        }
        all
    }

    fn kind(&self) -> &'static str {
        match self {
            Self::Give(_) => "give",
            Self::Write(_) => "write",
            Self::Replace { .. } => "replace",
            Self::Allow(_) => "allow",
        }
    }

    /// The files of those who do so, with one value after the other; none where the table knows no unit.
    fn done(&self, table: &Table, scene: &Drawn, question: usize) -> Vec<String> {
        let with = |names: &[String], tried: usize, mut other: Drawn| {
            for (place, name) in names.iter().enumerate() {
                let (unit, value) = (table.unit_of(name)?, TRIED[(tried + place) % TRIED.len()]);
                other.given.push((name.clone(), format!("{value} {unit}").trim().to_owned()));
            }
            Some(other.file(question))
        };
        match self {
            Self::Give(names) => (0..TRIED.len()).filter_map(|tried| with(names, tried, scene.clone())).collect(),
            Self::Write(line) => {
                let Some((name, value)) = line.split_once(": ") else { return Vec::new() };
                let mut other = scene.clone();
                other.given.retain(|(listed, _)| listed != name);
                other.given.push((name.to_owned(), value.to_owned()));
                vec![other.file(question)]
            }
            Self::Replace { by, given } => {
                let mut other = scene.clone();
                other.given.retain(|(listed, _)| listed != given);
                let by = [by.clone()];
                (0..TRIED.len()).filter_map(|tried| with(&by, tried, other.clone())).collect()
            }
            Self::Allow(name) => {
                vec![scene.file(question).replace("allow: [", &format!("allow: [{name}, "))]
            }
        }
    }
}

fn quoted(text: &str) -> Vec<String> {
    text.split('`').skip(1).step_by(2).map(str::to_owned).collect()
}

/// Why a file is refused; empty where it is not.
fn refusal(file: &str) -> Vec<Fault> {
    let compiled = load(Source::new("scene.yaml", file)).and_then(|loaded| compile(loaded, None));
    compiled.err().map(|faults| faults.list).unwrap_or_default()
}

/// Why doing what was advised leads nowhere; none where it leads on.
fn dead_end(refused: &Fault, advice: &Advice, files: &[String]) -> Option<String> {
    let ends: Vec<Vec<Fault>> = files.iter().map(|file| refusal(file)).collect();
    let is_same = |fault: &Fault| match advice {
        // Another number may break a condition of the motion: that is another refusal.
        Advice::Give(_) | Advice::Replace { .. } | Advice::Write(_) => {
            let lacks = matches!(fault.code, Code::UnderDetermined | Code::Stuck | Code::UnknownName | Code::Duplicate);
            lacks && !fault.message.contains("admissible solutions") || fault.message == refused.message
        }
        Advice::Allow(_) => fault.message == refused.message,
    };
    if ends.is_empty() || ends.iter().any(|faults| !faults.iter().any(is_same)) {
        return None;
    }
    let (file, faults) = (files.first()?, ends.first()?);
    let said: Vec<String> = faults.iter().map(|fault| format!("{} ({:?})", fault.message, fault.help)).collect();
    Some(format!("{advice:?} after: {}\n  leads to: {}\n{file}", refused.message, said.join("; ")))
}

#[test]
fn whoever_does_what_a_refusal_advises_gets_on() {
    let table = Table::read();
    let scenes: Vec<(&str, u64)> =
        table.stages.iter().flat_map(|kind| (0..EACH).map(|seed| (kind.name.as_str(), seed))).collect();
    let followed: Vec<(&'static str, Option<String>)> = scenes
        .par_iter()
        .flat_map_iter(|(kind, seed)| {
            let scene = draw(&table, kind, *seed);
            let mut ends = Vec::new();
            for question in 0..scene.questions.len() {
                for fault in refusal(&scene.file(question)) {
                    for advice in Advice::of(&fault) {
                        let files = advice.done(&table, &scene, question);
                        ends.push((advice.kind(), dead_end(&fault, &advice, &files)));
                    }
                }
            }
            ends
        })
        .collect();
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for (kind, _) in &followed {
        *counts.entry(kind).or_default() += 1;
    }
    println!("advice that was followed: {counts:?}");
    let dead: Vec<&str> = followed.iter().filter_map(|(_, dead)| dead.as_deref()).collect();
    assert!(dead.is_empty(), "{} dead ends:\n{}", dead.len(), dead.join("\n\n"));
    assert!(counts.len() == 4, "every kind of advice is met: {counts:?}");
}
