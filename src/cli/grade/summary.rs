//! The statistics of a class as JSON and as a page.

use std::path::Path;
use std::path::PathBuf;

use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::cli::pages;
use crate::grade::Statistics;

/// `PATH.json` and `PATH.html`, where the path may already have one of these endings.
pub(super) fn paths(path: &Path) -> [PathBuf; 2] {
    let ends = path.extension().is_some_and(|ending| ending == "html" || ending == "json");
    let stem = if ends { path.with_extension("") } else { path.to_owned() };
    [".json", ".html"].map(|ending| {
        let mut name = stem.clone().into_os_string();
        name.push(ending);
        PathBuf::from(name)
    })
}

/// Writes both.
pub(super) fn write(statistics: &Statistics, path: &Path) -> Result<(), Failure> {
    let [json, html] = paths(path);
    Output::whole(Some(&json), &format!("{}\n", serde_json::to_string_pretty(statistics)?))?;
    Output::whole(Some(&html), &pages::renderer()?.render_statistics(statistics)?)
}
