//! Sheets that students were given, and their hand-ins. Nothing of it is ever changed: what comes later is added.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;

use momentous_exercise::Issued;

use super::assignment::Item;
use super::key::Key;
use super::moment::Moment;
use super::people::{Member, Person};

/// A sheet that a student was given: written when it is first seen.
#[derive(Clone, Debug, Deserialize, Eq, PartialEq, Serialize)]
pub struct Sheet {
    /// The key by which other records name it.
    pub key: Key<Sheet>,
    /// The item.
    pub item: Key<Item>,
    /// The student.
    pub member: Key<Member>,
    /// Which issue of the item's sheets it is.
    pub issue: u32,
    /// The variant as it was shown.
    pub issued: Issued,
    /// When it was first seen.
    pub seen: Moment,
}

/// An attempt: everything that a student handed in at once.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct Attempt {
    /// The sheet.
    pub sheet: Key<Sheet>,
    /// Its number, from 1.
    pub number: u32,
    /// When the server had it.
    pub received: Moment,
    /// The typed answers, by part.
    pub answers: BTreeMap<String, String>,
    /// The report of marking at that time, as the rules of hand-ins write it.
    pub report: Box<RawValue>,
    /// The key by which a repeated request is known.
    pub request: String,
}

/// A hint that was shown.
#[derive(Clone, Debug, Deserialize, Eq, PartialEq, Serialize)]
pub struct HintShown {
    /// The sheet.
    pub sheet: Key<Sheet>,
    /// The part whose diagnosis it belongs to; nothing where it is one of the author's.
    pub part: Option<String>,
    /// Its number among those, from 1.
    pub number: u32,
    /// When it was shown.
    pub at: Moment,
}

/// Answers that were typed and not handed in.
#[derive(Clone, Debug, Deserialize, Eq, PartialEq, Serialize)]
pub struct Draft {
    /// The sheet.
    pub sheet: Key<Sheet>,
    /// The typed answers, by part.
    pub answers: BTreeMap<String, String>,
    /// When it was saved.
    pub saved: Moment,
    /// When it was handed in at the close, or found to hold nothing that could be.
    #[serde(default)]
    pub settled: Option<Moment>,
}

/// Points that were set by hand, or kept by a regrade.
#[derive(Clone, Debug, Deserialize, Eq, PartialEq, Serialize)]
pub struct Override {
    /// The sheet.
    pub sheet: Key<Sheet>,
    /// The points; nothing where those of marking count again.
    pub points: Option<String>,
    /// How they count beside those of marking.
    #[serde(default)]
    pub rule: OverrideRule,
    /// Why; the student is told.
    pub reason: String,
    /// A further remark to the student; empty where there is none.
    #[serde(default)]
    pub comment: String,
    /// The person who set them.
    pub by: Key<Person>,
    /// When.
    pub at: Moment,
}

/// How points that were set count beside those of marking.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum OverrideRule {
    /// In their place; the last ones for a sheet count.
    #[default]
    Exactly,
    /// The least points that the student has for the item, whatever marking finds, in this issue of its sheets and in later ones.
    AtLeast,
}
