//! What bytes of any kind are turned into, and what must hold of it. The tests run each a bounded number of times; the crate in `fuzz/`
//! runs the same functions for hours under a fuzzer that looks for new paths through the program.

use std::collections::BTreeMap;
use std::sync::{Arc, LazyLock};

use momentous::bank::Bank;
use momentous::exercise::{Column, Exercise, Listed, Place, Submission, Table};
use momentous::fault::{Faults, Source};
use momentous::grade::{DecimalMark, Verdict};
use momentous::problem::{Part, PartKind, compile, load};

/// Pieces of problem files, between and in place of which others are put.
const OF_FILES: &str = include_str!("files.txt");

/// Pieces of answers.
const OF_ANSWERS: &str = include_str!("answers.txt");

/// Pieces of formulas.
const OF_FORMULAS: &str = include_str!("formulas.txt");

/// Pieces of tables and of lines of JSON.
const OF_TABLES: &str = include_str!("tables.txt");

/// The pieces of a list, one on each line, where `⏎` is the end of a line and `␣` a space.
fn pieces(list: &str) -> Vec<String> {
    list.lines().map(|line| line.replace('⏎', "\n").replace('␣', " ")).collect()
}

/// Text made of pieces, one for each byte but a few, which stand for themselves.
fn pieced(bytes: &[u8], list: &str) -> String {
    let pieces = pieces(list);
    let piece = |byte: &u8| pieces.get(usize::from(*byte)).cloned().unwrap_or_else(|| char::from(*byte).to_string());
    bytes.iter().map(piece).collect()
}

/// The nearest boundary of characters at or below a place.
fn boundary(text: &str, at: usize) -> usize {
    (0..=at.min(text.len())).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0)
}

/// A file of the bank with a few places cut out, doubled, or filled with pieces of other files.
fn spoilt(bytes: &[u8]) -> String {
    let bank = Bank::built_in();
    let sources: Vec<&Source> = bank.sources().collect();
    let [chosen, edits @ ..] = bytes else { return String::new() };
    let Some(source) = sources.get(usize::from(*chosen) % sources.len().max(1)) else { return String::new() };
    let mut text = source.text.to_string();
    let pieces = pieces(OF_FILES);
    for edit in edits.chunks_exact(4).take(8) {
        let [high, low, length, piece] = [edit[0], edit[1], edit[2], edit[3]].map(usize::from);
        let from = boundary(&text, (high << 8 | low) % (text.len() + 1));
        let to = boundary(&text, from + length % 64).max(from);
        let piece = pieces.get(piece).cloned().unwrap_or_else(|| text[from..to].repeat(2));
        text.replace_range(from..to, &piece);
    }
    text
}

fn within(faults: &Faults, length: usize) {
    assert!(!faults.list.is_empty() && !faults.to_string().is_empty());
    for fault in &faults.list {
        assert!(fault.span.is_none_or(|span| span.start <= span.end && span.end <= length), "{fault:?}");
    }
}

/// A problem file loads, compiles and draws, or says what is wrong and where.
pub fn problem_file(bytes: &[u8]) {
    let text = spoilt(bytes);
    let loaded = match load(Source::new("fuzz.yaml", &text)) {
        Ok(loaded) => loaded,
        Err(faults) => return within(&faults, text.len()),
    };
    match compile(loaded, None) {
        Ok(problem) => drop(Exercise::draw(&Arc::new(problem), 0, 1)),
        Err(faults) => within(&faults, text.len()),
    }
}

/// One variant of every form of the bank.
static BANK: LazyLock<Vec<Exercise>> = LazyLock::new(|| {
    let mut exercises = Vec::new();
    for source in Bank::built_in().sources() {
        let Some(problem) = load(source.clone()).ok().and_then(|loaded| compile(loaded, None).ok()).map(Arc::new)
        else {
            continue;
        };
        exercises.extend((0..problem.forms().len()).filter_map(|form| Exercise::draw(&problem, form, 1).ok()));
    }
    exercises
});

/// Marks a text as the answer to a part of the bank: it gets a verdict, and its marks lie between none and all.
fn mark(text: &str, chosen: u8, asks: impl Fn(&Part) -> bool) {
    let parts: Vec<(&Exercise, &Part)> = BANK
        .iter()
        .flat_map(|exercise| exercise.worked().form.parts.iter().map(move |part| (exercise, part)))
        .filter(|(_, part)| asks(part))
        .collect();
    let Some((exercise, part)) = parts.get(usize::from(chosen) * parts.len() / 256) else { return };
    for decimal in [DecimalMark::Point, DecimalMark::Comma] {
        let report = exercise.grade(&BTreeMap::from([(part.id.clone(), text.to_owned())]), decimal);
        let own = report.parts.iter().find(|own| own.id == part.id).expect("every part is reported");
        let points = own.points.0.to_f64().value();
        assert!((0.0..=f64::from(own.out_of)).contains(&points), "{text:?}: {points} of {}", own.out_of);
        assert!(own.verdict != Verdict::Unreadable || !own.message.is_empty(), "{text:?}");
    }
}

/// An answer that is no formula is marked, or it is said why it cannot be read.
pub fn answer(bytes: &[u8]) {
    let [chosen, rest @ ..] = bytes else { return };
    mark(&pieced(rest, OF_ANSWERS), *chosen, |part| !matches!(part.kind, PartKind::Formula(_)));
}

/// The same for a formula.
pub fn formula(bytes: &[u8]) {
    let [chosen, rest @ ..] = bytes else { return };
    mark(&pieced(rest, OF_FORMULAS), *chosen, |part| matches!(part.kind, PartKind::Formula(_)));
}

/// Every row of a table of submissions is a submission, or is refused with a reason; the same for lines of JSON.
pub fn table(bytes: &[u8]) {
    let text = format!("student,problem,seed,form,v_A2\n{}", pieced(bytes, OF_TABLES));
    submissions(&text);
    submissions(&pieced(bytes, OF_TABLES));
    for (number, line) in (1..).zip(text.lines().skip(1)) {
        match Submission::of_json(Place::Line(number), &format!("{{\"problem\":\"impact/two-carts\",{line}")) {
            Ok(submission) => assert!(submission.answers().count() <= line.len()),
            Err(reason) => assert!(!reason.is_empty(), "{line:?}"),
        }
    }
}

fn submissions(text: &str) {
    let Ok(mut table) = Table::read(text.as_bytes()) else { return };
    let columns = Column::all(table.headings());
    let mut last = 1;
    while let Some((line, row)) = table.next_row() {
        assert!(line > last, "{text:?}: line {line} after line {last}");
        last = line;
        match (row.as_ref(), columns.as_ref()) {
            (Ok(row), Ok(columns)) => drop(Submission::of_row(Place::Line(line), columns, row.cells())),
            (Ok(_), Err(reason)) | (Err(reason), _) => assert!(!reason.is_empty(), "{text:?}"),
        }
    }
}

/// A list of who has which sheet is read, or every fault of it is said.
pub fn roster(bytes: &[u8]) {
    let text = format!("student,problem,digest,form,seed,derivation\n{}", pieced(bytes, OF_TABLES));
    let Ok(table) = Table::read(text.as_bytes()) else { return };
    if let Err(faults) = Listed::read(table) {
        assert!(!faults.is_empty() && faults.iter().all(|fault| !fault.is_empty()), "{text:?}");
    }
}
