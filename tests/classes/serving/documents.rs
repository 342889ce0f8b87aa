//! What `docs/serving.md` tells an operator to type exists.

use std::collections::BTreeSet;

use super::server::{folder, run};
use crate::blocks::blocks;

const SERVING: &str = include_str!("../../../docs/serving.md");

/// The words of every command `momentous serve` in the blocks of the page.
fn commands() -> Vec<(usize, Vec<String>)> {
    let of_block = |block: crate::blocks::Block| {
        let text = block.text.replace("\\\n", " ");
        let lines: Vec<String> = text.lines().map(str::to_owned).collect();
        lines.into_iter().filter_map(move |line| {
            let at = format!("{line} ").find("momentous serve ").or_else(|| line.find("momentous\", \"serve"))?;
            let plain = line[at..].replace(['"', ',', '[', ']'], " ");
            let words = plain.split(" #").next().unwrap_or_default();
            Some((block.line, words.split_whitespace().map(str::to_owned).collect()))
        })
    };
    blocks(SERVING).into_iter().filter(|block| block.language != "json").flat_map(of_block).collect()
}

#[test]
fn every_command_and_option_exists() {
    let room = folder();
    let subcommands = ["check", "backup", "restore", "retention", "user"];
    let mut met = BTreeSet::new();
    for (line, words) in commands() {
        let mut asked: Vec<&str> = vec!["serve"];
        asked.extend(words.iter().skip(2).map(String::as_str).take_while(|word| !word.starts_with('-')).take(2));
        let known = match asked.get(1) {
            Some(subcommand) if subcommands.contains(subcommand) => {
                if *subcommand == "user" {
                    3
                } else {
                    2
                }
            }
            Some(other) => panic!("docs/serving.md:{line}: there is no `momentous serve {other}`"),
            None => 1,
        };
        asked.truncate(known);
        met.insert(asked[1..].join(" "));
        asked.push("--help");
        let (code, help) = run(room.path(), &asked);
        assert_eq!(code, 0, "docs/serving.md:{line}: {asked:?}: {help}");
        let offered: BTreeSet<&str> = help.split(|sign: char| !(sign.is_alphanumeric() || sign == '-')).collect();
        for option in words.iter().filter(|word| word.starts_with("--")) {
            let option = option.split('=').next().unwrap();
            assert!(offered.contains(option), "docs/serving.md:{line}: {asked:?} has no {option}");
        }
    }
    let expected =
        ["", "backup", "check", "restore", "retention", "user add", "user link", "user mail"].map(str::to_owned);
    assert_eq!(met, BTreeSet::from(expected), "the page shows every command");
}

#[test]
fn every_option_of_the_server_is_explained() {
    let room = folder();
    for command in [&["serve", "--help"][..], &["serve", "check", "--help"]] {
        let (_, help) = run(room.path(), command);
        let options = help.lines().filter_map(|line| line.trim_start().strip_prefix("--"));
        let names: Vec<&str> = options.filter_map(|line| line.split([' ', '=']).next()).collect();
        assert!(names.len() >= 8, "{help}");
        for name in names {
            assert!(SERVING.contains(&format!("`--{name}")), "docs/serving.md does not say what --{name} does");
        }
    }
}
