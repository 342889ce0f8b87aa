//! Formulas in other notations, by kind: no verdict is wrong, and few are asked back.

use std::collections::BTreeMap;
use std::path::Path;

use momentous::grade::{DecimalMark, judge, read};

use super::judged::expected;

/// At most so many in a hundred are asked back.
const MOST_ASKED_BACK: usize = 3;

#[test]
fn formulas_in_other_notations_are_read_and_judged() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/answers/formulas_of_kinds.csv");
    let mut rows = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(path).unwrap();
    let (mut wrong, mut asked_back, mut kinds) = (Vec::new(), Vec::new(), BTreeMap::new());
    for row in rows.records().map(Result::unwrap) {
        let [kind, given, right, answer, verdict] = [0, 1, 2, 3, 4].map(|place| &row[place]);
        *kinds.entry(kind.to_owned()).or_insert(0) += 1;
        let expected = expected(given, right);
        match read(answer, &expected.kind, DecimalMark::Point) {
            Err(fault) => asked_back.push(format!("{kind}: {answer} for {right}: {fault}")),
            Ok(answer_read) => {
                let found = judge(&expected, &answer_read).verdict;
                if found.is_right() != (verdict == "right") {
                    wrong.push(format!("{kind}: {answer} for {right}: {}, not {verdict}", found.code()));
                }
            }
        }
    }
    let count: usize = kinds.values().sum();
    assert!(kinds.len() > 8 && kinds.values().all(|count| *count >= 10), "{kinds:?}");
    assert!(wrong.is_empty(), "{} of {count}\n{}", wrong.len(), wrong.join("\n"));
    assert!(
        100 * asked_back.len() <= MOST_ASKED_BACK * count,
        "{} of {count}\n{}",
        asked_back.len(),
        asked_back.join("\n")
    );
}
