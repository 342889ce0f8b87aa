//! Settings of a course: its title, its time zone, how its students write decimals, and for how long answers are kept.

use serde::Serialize;

use momentous_course::{Course, FieldFault, zone};
use momentous_grade::DecimalMark;

use super::form::Form;
use super::person_form::text_fault;

/// The days of the longest retention: a hundred years.
const MOST_DAYS: u32 = 36_525;

/// Its fields.
pub(super) const FIELDS: [&str; 4] = ["title", "zone", "decimal", "retention"];

/// The values of the fields.
pub(super) struct CourseForm {
    pub(super) title: String,
    pub(super) zone: String,
    pub(super) decimal: DecimalMark,
    pub(super) retention_days: Option<u32>,
}

/// The decimal marks, each with its name in forms and what it is called.
const DECIMALS: [(DecimalMark, &str, &str); 3] = [
    (DecimalMark::Either, "either", "point or comma"),
    (DecimalMark::Point, "point", "point: 3.14"),
    (DecimalMark::Comma, "comma", "comma: 3,14"),
];

/// One of several that can be chosen.
#[derive(Serialize)]
pub(super) struct Choice {
    pub(super) name: &'static str,
    pub(super) said: &'static str,
}

/// The decimal marks that can be chosen.
pub(super) fn decimals() -> Vec<Choice> {
    DECIMALS.map(|(_, name, said)| Choice { name, said }).into()
}

impl CourseForm {
    /// Reads the fields.
    ///
    /// # Errors
    /// Every fault, with its field.
    pub(super) fn read(form: &Form) -> Result<Self, Vec<FieldFault>> {
        let mut faults = Vec::new();
        let mut say = |field, message: String| faults.push(FieldFault { field, message });
        let title = form.value("title").to_owned();
        if title.is_empty() {
            say("title", "a course has a title".to_owned());
        }
        if let Some(message) = text_fault(&title) {
            say("title", message);
        }
        let typed = form.value("zone");
        if let Err(reason) = zone(typed) {
            say("zone", reason.to_string());
        }
        let chosen = DECIMALS.into_iter().find(|(_, name, _)| *name == form.value("decimal")).map(|(mark, ..)| mark);
        if chosen.is_none() {
            say("decimal", "choose one of the list".to_owned());
        }
        let retention_days = match form.value("retention") {
            "" => None,
            text => {
                let days = text.parse().ok().filter(|days| (1..=MOST_DAYS).contains(days));
                if days.is_none() {
                    say(
                        "retention",
                        format!("write days, from 1 to {MOST_DAYS}, or nothing to keep answers without end"),
                    );
                }
                days
            }
        };
        let zone = typed.to_owned();
        match chosen {
            Some(decimal) if faults.is_empty() => Ok(Self { title, zone, decimal, retention_days }),
            _ => Err(faults),
        }
    }

    /// The fields as they are for a course.
    pub(super) fn of(course: &Course) -> Form {
        let decimal = DECIMALS.into_iter().find(|(mark, ..)| *mark == course.decimal).map_or("", |(_, name, _)| name);
        Form::new([
            ("title", course.title.clone()),
            ("zone", course.zone.clone()),
            ("decimal", decimal.to_owned()),
            ("retention", course.retention_days.map(|days| days.to_string()).unwrap_or_default()),
        ])
    }
}
