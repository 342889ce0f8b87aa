//! Random tables: every row is read or refused, on its own line, whatever stands in the others.

use std::collections::BTreeSet;
use std::fs;

use momentous::exercise::{Rows, Table};

use crate::room::Room;

/// How many tables are tried; `MOMENTOUS_TABLES=1000000` tries a million.
const TABLES: u64 = 100_000;

/// Numbers that look like chance (`SplitMix64`), always the same.
struct Chance(u64);

impl Chance {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut word = self.0;
        word = (word ^ (word >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        word = (word ^ (word >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        usize::try_from((word ^ (word >> 31)) % bound as u64).unwrap()
    }

    fn one_of<'a>(&mut self, texts: &[&'a str]) -> &'a str {
        texts[self.below(texts.len())]
    }

    fn text(&mut self, pieces: &[&str], most: usize) -> String {
        (0..self.below(most + 1)).map(|_| self.one_of(pieces)).collect()
    }
}

fn tables() -> u64 {
    std::env::var("MOMENTOUS_TABLES").ok().and_then(|count| count.parse().ok()).unwrap_or(TABLES)
}

/// A row as it is written, with the cells that it means.
fn row(chance: &mut Chance, width: usize, may_quote: bool) -> (String, Vec<String>) {
    let plain = ["a", "b", "=", "-", "1", "é", "'", " "];
    let any = ["a", "\"", ",", ";", "\n", "\r\n", "\r", " ", "=", "'"];
    let mut written = Vec::new();
    let mut meant = Vec::new();
    for _ in 0..width {
        if may_quote && chance.below(3) == 0 {
            let text = chance.text(&any, 4);
            written.push(format!("\"{}\"", text.replace('"', "\"\"")));
            meant.push(text);
        } else {
            // A row of nothing but blanks would be no row.
            let text = format!("x{}", chance.text(&plain, 3));
            written.push(text.clone());
            meant.push(text);
        }
    }
    (written.join(","), meant)
}

/// What spreadsheets take for the mark of a text is taken away, also behind a semicolon.
fn unmarked(cell: &str) -> String {
    let plain = |piece: &str| match piece.strip_prefix('\'') {
        Some(rest) if rest.trim_start_matches('\'').starts_with(['=', '-', '\n', '\r']) => rest.to_owned(),
        _ => piece.to_owned(),
    };
    cell.split_inclusive(';').map(plain).collect()
}

#[test]
fn every_row_is_read_or_refused_on_its_own_line() {
    let mut chance = Chance(1);
    for table in 0..tables() {
        let width = 2 + chance.below(3);
        let end = chance.one_of(&["\n", "\r\n", "\r"]);
        // Where a quotation mark is left open, others would close it.
        let is_open = chance.below(2) == 0;
        let mut text = format!("{}{end}", (0..width).map(|column| format!("h{column}")).collect::<Vec<_>>().join(","));
        let mut line = 2;
        let mut expected: Vec<(u64, Option<Vec<String>>)> = Vec::new();
        for _ in 0..chance.below(6) {
            let wrong = chance.below(4) == 0;
            let (mut written, cells) = row(&mut chance, if wrong { width - 1 } else { width }, !is_open && !wrong);
            if is_open && !wrong && chance.below(4) == 0 {
                written = format!("x,\"{written}");
                expected.push((line, None));
            } else {
                expected.push((line, (!wrong).then_some(cells)));
            }
            let ends = written.replace("\r\n", "\n").matches(['\n', '\r']).count() as u64;
            text.push_str(&written);
            text.push_str(end);
            line += 1 + ends;
        }
        let mut read = Table::read(text.as_bytes()).unwrap();
        let mut found = Vec::new();
        while let Some((line, row)) = read.next_row() {
            found.push((line, row.ok().map(|row| row.cells().map(str::to_owned).collect::<Vec<_>>())));
        }
        for (_, cells) in &mut expected {
            cells.iter_mut().flatten().for_each(|cell| *cell = unmarked(cell.trim()));
        }
        assert_eq!(found, expected, "table {table}: {text:?}");
    }
}

#[test]
fn any_bytes_are_rows_or_faults_in_order() {
    let mut chance = Chance(2);
    for table in 0..tables() {
        let text = chance.text(&["a", "\"", "\"\"", ",", ";", "\n", "\r", "\r\n", " ", "\u{feff}", "=1"], 24);
        let mut rows = Rows::read(text.as_bytes()).unwrap();
        let mut lines = Vec::new();
        while let Some((line, _)) = rows.next_row() {
            lines.push(line);
        }
        assert!(lines.windows(2).all(|pair| pair[0] < pair[1]), "table {table}: {text:?}: {lines:?}");
        let physical = text.strip_prefix('\u{feff}').unwrap_or(&text).replace("\r\n", "\n").replace('\r', "\n");
        let filled = physical.lines().filter(|line| !line.trim().is_empty()).count();
        let same = if text.contains('"') { lines.len() <= filled } else { lines.len() == filled };
        assert!(same, "table {table}: {text:?}: {lines:?}");
    }
}

/// A table of twenty thousand rows of all kinds: each line is marked or refused, and the numbers at the end say so.
#[test]
fn what_is_read_is_marked_or_refused() {
    let mut chance = Chance(3);
    let room = Room::empty();
    let mut table = "student,problem,seed,form,attempt,v_A2,v_B2\n".to_owned();
    let count = 20_000;
    for _ in 0..count {
        let cells = [
            format!("s{}", chance.below(3000)),
            chance
                .one_of(&["impact/two-carts", "impact/two-carts", "impact/two-cart", "", "../two-carts.yaml"])
                .to_owned(),
            chance.one_of(&["1", "1", "2", "02", "x", "-1", ""]).to_owned(),
            chance.one_of(&["", "forward", "find-e", "backward"]).to_owned(),
            chance.one_of(&["", "1", "2", "two"]).to_owned(),
            chance.one_of(&["-0.5 m/s", "\"1,5\"", "", "3..2", "\"open", "\"a\"b", "=1+1", "a,b"]).to_owned(),
            chance.one_of(&["4 m/s", "", "\"4 \"\"m\"\"\""]).to_owned(),
        ];
        table.push_str(&cells.join(","));
        table.push('\n');
    }
    fs::write(room.path("class.csv"), table).unwrap();
    let ran = room.run(&["grade", "class.csv", "-o", "marks.csv", "--summary", "class", "--junit", "class.xml"]);
    let summary: serde_json::Value = serde_json::from_str(&room.read("class.json")).unwrap();
    let [read, marked, refused] = ["read", "marked", "refused"].map(|key| summary["rows"][key].as_u64().unwrap());
    assert_eq!(read, marked + refused);
    assert!(read > count * 9 / 10 && marked > 100, "{}", summary["rows"]);
    let mut marks = csv::Reader::from_path(room.path("marks.csv")).unwrap();
    let marked_lines: BTreeSet<u64> = marks.records().map(|row| row.unwrap()[0].parse().unwrap()).collect();
    let place = |line: &str| line.strip_prefix("error: class.csv:")?.split(':').next()?.parse().ok();
    let refused_lines: BTreeSet<u64> = ran.err.lines().filter_map(place).collect();
    assert_eq!((marked_lines.len() as u64, refused_lines.len() as u64), (marked, refused));
    assert!(marked_lines.is_disjoint(&refused_lines));
    assert!(room.names(".").contains(&"class.xml".to_owned()));
}
