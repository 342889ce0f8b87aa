//! The reference tasks by the names that are typed: small letters, and hyphens for spaces.

use crate::fault::did_you_mean;
use crate::simulate::CONTACT;
use crate::simulate::IN_THE_PLANE;
use crate::simulate::ON_A_LINE;
use crate::simulate::points_of;
use crate::simulate::sweep;

use super::super::failure::Failure;
use super::super::progress;
use super::points::Row;

/// The name of a task as it is typed.
pub(super) fn typed(name: &str) -> String {
    name.to_lowercase().replace(' ', "-")
}

fn names() -> impl Iterator<Item = &'static str> {
    let all = ON_A_LINE.iter().map(|task| task.name).chain(IN_THE_PLANE.iter().map(|task| task.name));
    all.filter(|name| *name != CONTACT)
}

/// The description of a task.
pub(super) fn about(name: &str) -> Option<&'static str> {
    let line = ON_A_LINE.iter().map(|task| (task.name, task.about));
    let plane = IN_THE_PLANE.iter().map(|task| (task.name, task.about));
    line.chain(plane).find(|(task, _)| *task == name).map(|(_, about)| about)
}

/// The tasks of these names; all of them where none is named.
pub(super) fn chosen(wanted: &[String]) -> Result<Vec<&'static str>, Failure> {
    if wanted.is_empty() {
        return Ok(names().collect());
    }
    let find = |text: &String| {
        let text = typed(text);
        names().find(|name| typed(name) == text).ok_or_else(|| {
            let all: Vec<String> = names().map(typed).collect();
            let help = match did_you_mean(&text, all.iter().map(String::as_str)) {
                Some(near) => format!("did you mean `{near}`?"),
                None => format!("the tasks are {}", all.join(", ")),
            };
            Failure::unusable(format!("there is no task `{text}`\nhelp: {help}"))
        })
    };
    wanted.iter().map(find).collect()
}

/// Runs tasks through every method, with a bar that shows how far it is.
pub(super) fn measure(wanted: &[String], repetitions: usize, finest_step: f64) -> Result<Vec<Row>, Failure> {
    let chosen = chosen(wanted)?;
    let line = ON_A_LINE.iter().filter(|task| chosen.contains(&task.name));
    let plane = IN_THE_PLANE.iter().filter(|task| chosen.contains(&task.name));
    let bar = progress::bar((chosen.len() * points_of(finest_step)) as u64, false);
    let mut done = || bar.inc(1);
    let mut points = Vec::new();
    for task in line {
        points.extend(sweep(task, repetitions, finest_step, &mut done));
    }
    for task in plane {
        points.extend(sweep(task, repetitions, finest_step, &mut done));
    }
    Ok(points.into_iter().map(Row::from).collect())
}
