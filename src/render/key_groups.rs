//! The rows of a key by problem: sheets beneath each other, their parts in columns.

use super::page::{Identity, Key, KeyRow};

/// The answers to one problem of a key.
pub(super) struct Group<'a> {
    /// The identity of its first sheet.
    pub identity: &'a Identity,
    /// The labels of its parts.
    pub parts: Vec<&'a str>,
    /// The answers of each sheet.
    pub rows: Vec<Vec<&'a KeyRow>>,
}

/// The mark by which problems of a key are told apart: what is asked, and where on its sheet it stands.
fn problem(row: &KeyRow) -> (&str, Option<&str>, &str) {
    let number = row.part.trim_end_matches(|letter: char| !letter.is_ascii_digit());
    (&row.identity.problem, row.identity.form.as_deref(), number)
}

/// The answers by problem, in the order in which these come.
pub(super) fn groups(key: &Key) -> Vec<Group<'_>> {
    let mut groups: Vec<Group<'_>> = Vec::new();
    for row in &key.rows {
        let is_own =
            |group: &Group<'_>| group.rows.iter().flatten().next().is_some_and(|other| problem(other) == problem(row));
        let place = groups.iter().position(is_own).unwrap_or_else(|| {
            groups.push(Group { identity: &row.identity, parts: Vec::new(), rows: Vec::new() });
            groups.len() - 1
        });
        let group = &mut groups[place];
        if !group.parts.contains(&row.part.as_str()) {
            group.parts.push(&row.part);
        }
        let is_same = |other: &&KeyRow| other.identity == row.identity && other.student == row.student;
        let same_sheet = |sheet: &&mut Vec<&KeyRow>| sheet.iter().all(|cell| is_same(cell) && cell.part != row.part);
        match group.rows.last_mut().filter(same_sheet) {
            Some(last) => last.push(row),
            None => group.rows.push(vec![row]),
        }
    }
    groups
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(problem: &str, student: &str, part: &str) -> KeyRow {
        KeyRow {
            identity: Identity { problem: problem.to_owned(), ..Identity::default() },
            student: Some(student.to_owned()),
            part: part.to_owned(),
            answer: Vec::new(),
        }
    }

    #[test]
    fn each_problem_has_a_row_for_each_sheet_and_a_column_for_each_part() {
        let sheet = |student| {
            [row("a", student, "1a"), row("a", student, "1b"), row("b", student, "2a"), row("a", student, "3a")]
        };
        let key = Key { title: String::new(), rows: ["Ann", "Ben"].into_iter().flat_map(sheet).collect() };
        let groups = groups(&key);
        let shown: Vec<_> = groups
            .iter()
            .map(|group| (group.identity.problem.as_str(), group.parts.clone(), group.rows.len()))
            .collect();
        assert_eq!(shown, [("a", vec!["1a", "1b"], 2), ("b", vec!["2a"], 2), ("a", vec!["3a"], 2)]);
    }
}
