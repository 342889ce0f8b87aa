//! The table of diagnoses in `docs/marking.md` is what `momentous diagnose --seeds 1000` prints: a row for each problem of the bank, with
//! their sum below, and two of the rows anew.

use momentous::bank::Bank;

use crate::room::Room;

/// Problems that are quickly diagnosed.
const ANEW: [&str; 2] = ["concepts/two-trains", "mass-centre/walk-along-barge"];

/// The sum below the rows.
const SUM: &str = "in total";

/// The rows of a printed table: the name, and the cells behind it.
fn rows(text: &str) -> Vec<(&str, Vec<&str>)> {
    let row = |line| {
        let line: &str = str::trim(line);
        let end = if line.starts_with(SUM) { SUM.len() } else { line.find(' ')? };
        let (name, cells) = line.split_at(end);
        let cells = cells.split_whitespace().filter(|cell| *cell != "%").collect();
        (name == SUM || name.contains('/')).then_some((name, cells))
    };
    text.lines().filter_map(row).collect()
}

#[test]
fn the_table_of_diagnoses_is_what_the_command_prints() {
    let page = include_str!("../../docs/marking.md");
    let page = page.split("$ momentous diagnose --seeds 1000").nth(1).unwrap().split("\n| column |").next().unwrap();
    let table = rows(page);
    let bank = Bank::built_in();
    assert_eq!(table.len(), bank.ids().count() + 1, "a row for each problem, and the sum");
    let (_, total) = table.last().unwrap();
    // Students, those whose mistake is hidden, the honest and the wronged.
    for column in [1, 6, 7, 8] {
        let number = |cells: &[&str]| cells[column].parse::<u64>().unwrap();
        let sum: u64 = table[..table.len() - 1].iter().map(|(_, cells)| number(cells)).sum();
        assert_eq!(sum, number(total), "column {column}");
    }
    assert_eq!(total[8], "0", "no honest student is wronged");
    for name in ANEW {
        let printed = Room::empty().fine(&["diagnose", name, "--seeds", "1000"]);
        let anew = rows(&printed);
        let row_of = |rows: &[(&str, Vec<&str>)]| rows.iter().find(|row| row.0 == name).map(|row| row.1.join(" "));
        assert_eq!(
            row_of(&table),
            row_of(&anew),
            "{name}: run `momentous diagnose --seeds 1000`, and copy what it prints"
        );
    }
}
