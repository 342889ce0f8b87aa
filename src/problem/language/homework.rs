//! What a file of homework says: `homework/week-3.yaml`.

use schemars::JsonSchema;
use serde::Deserialize;

use super::entries::Entries;

/// Problems that are handed out together on one sheet.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HomeworkDraft {
    /// The title on the sheet.
    pub title: String,
    /// The course that the sheet names at its head.
    #[serde(default)]
    pub course: Option<String>,
    /// How many ruled lines the sheet has for each answer. Default: none.
    #[serde(default)]
    pub room: Option<u8>,
    /// What the sheet says of its date, in any words: `due 14 October 2026`.
    #[serde(default)]
    pub date: Option<String>,
    /// The problems, in the order of the sheet. One that stands here twice is drawn twice, with other numbers.
    pub problems: Vec<SlotDraft>,
}

/// One problem of a homework.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SlotDraft {
    /// The identity of the problem: `impact/two-carts`.
    pub problem: String,
    /// The form in which it is asked; the first one if none is named.
    #[serde(default)]
    pub form: Option<String>,
    /// What the whole problem is worth; what its parts are worth in its own file, or by their weights, if nothing is said.
    #[serde(default)]
    pub points: Option<u32>,
    /// How much its parts count beside each other: `{ v_A2: 2, e: 1 }`. A part that is not named counts as in the problem's file.
    #[serde(default)]
    pub weights: Entries<u32>,
}
