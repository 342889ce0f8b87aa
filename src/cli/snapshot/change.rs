//! Changes in the snapshots of each problem, and in a line what kind of change it is.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use similar::{ChangeTag, TextDiff};

use super::page::Kind;

/// Texts by their names below the folder.
pub(super) type Files = BTreeMap<String, String>;

/// The change of one problem.
#[derive(Clone, Debug)]
pub(super) struct Change {
    /// The problem's identity.
    pub(super) problem: String,
    /// The changed files, each with the text before and now.
    pub(super) files: Vec<Changed>,
}

/// A file that has changed.
#[derive(Clone, Debug)]
pub(super) struct Changed {
    pub(super) kind: Kind,
    pub(super) name: String,
    pub(super) before: Option<String>,
    pub(super) now: Option<String>,
}

/// The kind of a change.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Character {
    /// The problem had no snapshots.
    New,
    /// No problem makes these snapshots any more.
    Gone,
    /// The number of sheets with other numbers or answers, of so many.
    Numbers(usize, usize),
    /// Some typical answers earn something else.
    Marks(usize),
    /// Nothing but words, and figures with them.
    Words,
    /// Nothing but figures.
    Figures,
}

impl Change {
    /// The changes between two states, problem by problem.
    pub(super) fn all(before: &Files, now: &Files) -> Vec<Self> {
        let names: BTreeSet<&String> = before.keys().chain(now.keys()).collect();
        let mut changes: BTreeMap<String, Vec<Changed>> = BTreeMap::new();
        for name in names.into_iter().filter(|name| before.get(*name) != now.get(*name)) {
            let Some((kind, problem)) = Kind::of(name) else { continue };
            let [before, now] = [before, now].map(|files| files.get(name).cloned());
            changes.entry(problem.to_owned()).or_default().push(Changed { kind, name: name.clone(), before, now });
        }
        let change = |(problem, mut files): (String, Vec<Changed>)| {
            files.sort_by_key(|file| file.kind);
            Self { problem, files }
        };
        changes.into_iter().map(change).collect()
    }

    /// The kind of change: the weightiest of what has changed.
    pub(super) fn character(&self) -> Character {
        let Some(first) = self.files.first() else { return Character::Words };
        match (first.kind, &first.before, &first.now) {
            (Kind::Numbers, None, _) => Character::New,
            (Kind::Numbers, _, None) => Character::Gone,
            (Kind::Numbers, Some(before), Some(now)) => {
                let rows = |text: &str| text.lines().count().saturating_sub(1);
                Character::Numbers(changed_lines(before, now), rows(now).max(rows(before)))
            }
            (Kind::Marks, before, now) => {
                let text = |text: &Option<String>| text.clone().unwrap_or_default();
                Character::Marks(changed_lines(&text(before), &text(now)))
            }
            (Kind::Words, ..) => Character::Words,
            (Kind::Figures, ..) => Character::Figures,
        }
    }
}

/// The number of lines that are other ones.
fn changed_lines(before: &str, now: &str) -> usize {
    let diff = TextDiff::from_lines(before, now);
    let count = |tag| diff.iter_all_changes().filter(|change| change.tag() == tag).count();
    count(ChangeTag::Insert).max(count(ChangeTag::Delete))
}

impl fmt::Display for Character {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::New => out.write_str("new"),
            Self::Gone => out.write_str("no problem makes it any more"),
            Self::Numbers(changed, all) => write!(out, "in numbers: {changed} of {all} sheets"),
            Self::Marks(answers) => write!(out, "in marks: {}", said_answers(*answers)),
            Self::Words => out.write_str("in words only"),
            Self::Figures => out.write_str("in figures only"),
        }
    }
}

/// All changes in a line: `3 problems changed: 1 in numbers (40 of 40 sheets), 2 in words only`.
pub(super) fn summary(changes: &[Change]) -> String {
    let characters: Vec<Character> = changes.iter().map(Change::character).collect();
    let count = |wanted: Character| characters.iter().filter(|character| **character == wanted).count();
    let numbers: Vec<[usize; 2]> = characters.iter().filter_map(|character| character.sheets()).collect();
    let answers: Vec<usize> = characters.iter().filter_map(|character| character.answers()).collect();
    let [changed, all] = [0, 1].map(|place| numbers.iter().map(|pair| pair[place]).sum::<usize>());
    let said = [
        (numbers.len(), format!("in numbers ({changed} of {all} sheets)")),
        (answers.len(), format!("in marks ({})", said_answers(answers.iter().sum()))),
        (count(Character::Words), Character::Words.to_string()),
        (count(Character::Figures), Character::Figures.to_string()),
        (count(Character::New), Character::New.to_string()),
        (count(Character::Gone), "without a problem".to_owned()),
    ];
    let said = said.into_iter().filter(|(count, _)| *count > 0).map(|(count, what)| format!("{count} {what}"));
    let problems = if changes.len() == 1 { "1 problem".to_owned() } else { format!("{} problems", changes.len()) };
    format!("{problems} changed: {}", said.collect::<Vec<_>>().join(", "))
}

impl Character {
    /// How many sheets have other numbers, and how many there are.
    fn sheets(self) -> Option<[usize; 2]> {
        if let Self::Numbers(changed, all) = self { Some([changed, all]) } else { None }
    }

    /// How many answers earn something else.
    fn answers(self) -> Option<usize> {
        if let Self::Marks(answers) = self { Some(answers) } else { None }
    }
}

fn said_answers(count: usize) -> String {
    if count == 1 { "1 answer".to_owned() } else { format!("{count} answers") }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn files(texts: &[(&str, &str)]) -> Files {
        texts.iter().map(|(name, text)| ((*name).to_owned(), (*text).to_owned())).collect()
    }

    #[test]
    fn the_weightiest_change_gives_the_character() {
        let before = files(&[
            ("a/b.numbers.csv", "h\n1\n2\n3\n"),
            ("a/b.words.md", "x"),
            ("a/c.words.md", "x"),
            ("a/d.marks.csv", "h\nr\n"),
        ]);
        let now = files(&[
            ("a/b.numbers.csv", "h\n1\n5\n3\n"),
            ("a/b.words.md", "y"),
            ("a/c.words.md", "y"),
            ("a/d.marks.csv", "h\ns\n"),
            ("a/e.numbers.csv", "h\n"),
        ]);
        let changes = Change::all(&before, &now);
        let characters: Vec<_> = changes.iter().map(|change| (change.problem.as_str(), change.character())).collect();
        let expected = [
            ("a/b", Character::Numbers(1, 3)),
            ("a/c", Character::Words),
            ("a/d", Character::Marks(1)),
            ("a/e", Character::New),
        ];
        assert_eq!(characters, expected);
        let said = "4 problems changed: 1 in numbers (1 of 3 sheets), 1 in marks (1 answer), 1 in words only, 1 new";
        assert_eq!(summary(&changes), said);
    }
}
