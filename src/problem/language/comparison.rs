//! Comparisons as authors write them: `v_A1 > v_B1`.

use momentous_solve::Relation;

/// Signs of comparison, longest first.
const RELATIONS: &[(&str, Relation)] = &[
    ("<=", Relation::AtMost),
    (">=", Relation::AtLeast),
    ("!=", Relation::Differs),
    ("<", Relation::Less),
    (">", Relation::Greater),
    ("==", Relation::Equals),
    ("=", Relation::Equals),
];

/// The two sides of a comparison and how they compare.
#[must_use]
pub fn split_relation(text: &str) -> Option<(&str, Relation, &str)> {
    RELATIONS.iter().find_map(|(sign, relation)| {
        let (left, right) = text.split_once(sign)?;
        Some((left.trim(), *relation, right.trim()))
    })
}
