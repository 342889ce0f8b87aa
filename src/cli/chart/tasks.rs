//! The reference tasks by the names that are typed: small letters, and hyphens for spaces.

use crate::fault::did_you_mean;
use crate::simulate::IN_THE_PLANE;
use crate::simulate::ON_A_LINE;
use crate::simulate::sweep;

use super::super::failure::Failure;
use super::points::Row;

/// The name of a task as it is typed.
pub(super) fn typed(name: &str) -> String {
    name.to_lowercase().replace(' ', "-")
}

fn names() -> impl Iterator<Item = &'static str> {
    ON_A_LINE.iter().map(|task| task.name).chain(IN_THE_PLANE.iter().map(|task| task.name))
}

/// What a task asks for, with its unit.
pub(super) fn asks(name: &str) -> Option<&'static str> {
    let line = ON_A_LINE.iter().map(|task| (task.name, task.asks));
    let plane = IN_THE_PLANE.iter().map(|task| (task.name, task.asks));
    line.chain(plane).find(|(own, _)| *own == name).map(|(_, asks)| asks)
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

/// Runs tasks through every method.
pub(super) fn measure(wanted: &[String], repetitions: usize, finest_step: f64) -> Result<Vec<Row>, Failure> {
    let chosen = chosen(wanted)?;
    let line = ON_A_LINE.iter().filter(|task| chosen.contains(&task.name));
    let plane = IN_THE_PLANE.iter().filter(|task| chosen.contains(&task.name));
    let points = line.flat_map(|task| sweep(task, repetitions, finest_step));
    Ok(points.chain(plane.flat_map(|task| sweep(task, repetitions, finest_step))).map(Row::from).collect())
}
