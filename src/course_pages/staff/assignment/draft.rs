//! An assignment as it stands in the fields of its editor: nothing of it need be right.

use std::collections::BTreeMap;

use serde::Serialize;
use serde_json::{Map, Value};

use momentous_course::{FieldFault, Moment, PolicyForm};
use momentous_store::AssignmentWithItems;

use super::super::super::outcome::NotShown;
use super::super::super::visit::Visit;
use super::super::form::Form;
use super::super::form::sentences;

/// The fields of a policy.
pub(super) const POLICY: [&str; 13] = [
    "attempts",
    "attempt_penalty",
    "hint_penalty",
    "further_penalty",
    "opens",
    "due",
    "late_until",
    "late_penalty",
    "closes",
    "verdicts",
    "solutions",
    "unsubmitted",
    "solvers",
];

/// For how long an assignment is open at first, in milliseconds.
const WEEK: i64 = 7 * 24 * 60 * 60 * 1000;

/// The most problems of an assignment.
pub(super) const MOST_ITEMS: usize = 50;

/// An assignment in the fields of its editor.
pub(super) struct Draft {
    pub(super) form: Form,
    pub(super) rows: Vec<Row>,
    /// The date in the file of a homework, where the fields were filled in from one.
    pub(super) date: Option<String>,
    /// The state of the assignment on which the fields build.
    pub(super) revision: String,
}

/// A problem in the fields of the editor.
#[derive(Clone, Debug, Default, Serialize)]
pub(super) struct Row {
    /// The item's key, where it is kept already.
    pub(super) key: String,
    pub(super) problem: String,
    pub(super) form: String,
    pub(super) points: String,
    /// How much its parts count, as it is typed.
    pub(super) weights: String,
    pub(super) order: String,
    pub(super) fault: Option<String>,
}

impl Row {
    /// Says what is wrong with it; a line `help:` says the way out.
    pub(super) fn say(&mut self, message: &str) {
        self.fault = Some(sentences(message));
    }
}

impl Draft {
    /// The fields of a new assignment: it opens today, and is due and closes at the end of a day a week later.
    pub(super) fn empty(now: Moment, zone: &str) -> Self {
        let mut draft = Self::titled(String::new());
        let day = |moment: Moment| moment.typed(zone).split('T').next().map(str::to_owned).unwrap_or_default();
        let end = format!("{}T23:59", day(now.after(WEEK)));
        for (name, value) in [("opens", format!("{}T00:00", day(now))), ("due", end.clone()), ("closes", end)] {
            draft.form.fill(name, value);
        }
        draft
    }

    /// The fields of a new assignment with that title.
    pub(super) fn titled(title: String) -> Self {
        let names = [("title", title), ("items", String::new())].into_iter();
        let form = Form::new(names.chain(POLICY.map(|name| (name, String::new()))));
        Self { form, rows: Vec::new(), date: None, revision: String::new() }
    }

    /// The fields of one that is kept, in a course with this time zone.
    pub(super) fn of(whole: &AssignmentWithItems, zone: &str) -> Self {
        let policy = serde_json::to_value(whole.assignment.policy.form(zone)).unwrap_or_default();
        let field = |name: &str| (name.to_owned(), policy[name].as_str().unwrap_or_default().to_owned());
        let title = ("title".to_owned(), whole.assignment.title.clone());
        let form = Form::new(POLICY.into_iter().map(field).chain([title, ("items".to_owned(), String::new())]));
        let row = |item: &momentous_course::Item| Row {
            key: item.key.to_string(),
            problem: item.problem.clone(),
            form: item.form.clone().unwrap_or_default(),
            points: item.points.to_string(),
            weights: item.weights.to_string(),
            order: (item.position + 1).to_string(),
            fault: None,
        };
        Self { form, rows: whole.items.iter().map(row).collect(), date: None, revision: whole.revision.to_string() }
    }

    /// The fields as they were sent, with what their buttons do: problems are added and taken out.
    pub(super) fn sent(visit: &Visit) -> Result<Self, NotShown> {
        let names: Vec<&str> = ["title", "items"].into_iter().chain(POLICY).collect();
        let form = Form::sent(visit, &names);
        let taken_out = visit.fields.number("remove")?;
        let mut rows: BTreeMap<u64, Row> = BTreeMap::new();
        for (name, value) in visit.fields.behind("item.") {
            let Some((number, field)) = name.split_once('.') else { continue };
            let Ok(number) = number.parse::<u64>() else { continue };
            let row = rows.entry(number).or_default();
            let field = match field {
                "key" => &mut row.key,
                "problem" => &mut row.problem,
                "form" => &mut row.form,
                "points" => &mut row.points,
                "weights" => &mut row.weights,
                "order" => &mut row.order,
                _ => continue,
            };
            *field = value;
        }
        if let Some(number) = taken_out {
            rows.remove(&number);
        }
        let mut rows: Vec<Row> = rows.into_values().collect();
        // What is no number goes last, where it stands already.
        rows.sort_by_key(|row| row.order.trim().parse::<u32>().unwrap_or(u32::MAX));
        // What is ticked is not lost by another search.
        if matches!(visit.fields.get("do"), Some("add" | "search")) {
            rows.extend(visit.fields.all("add").map(|problem| Row { problem: problem.to_owned(), ..Row::default() }));
        }
        rows.truncate(MOST_ITEMS);
        let revision = visit.fields.text("revision").to_owned();
        Ok(Self { form, rows, date: None, revision })
    }

    /// The fields of the policy.
    pub(super) fn policy(&self) -> PolicyForm {
        let field = |name: &str| (name.to_owned(), Value::String(self.form.value(name).to_owned()));
        let fields: Map<String, Value> = POLICY.into_iter().map(field).collect();
        serde_json::from_value(Value::Object(fields)).unwrap_or_default()
    }

    /// Says what is wrong with fields, and with rows by their places.
    pub(super) fn say(&mut self, fields: &[FieldFault], rows: &[(usize, String)]) {
        for fault in fields {
            self.form.say(fault.field, &fault.message);
        }
        for (place, message) in rows {
            if let Some(row) = self.rows.get_mut(*place) {
                row.say(message);
            }
        }
    }

    /// Whether something is wrong.
    pub(super) fn is_wrong(&self) -> bool {
        self.form.is_wrong() || self.rows.iter().any(|row| row.fault.is_some())
    }
}
