//! The statistics of a class as JSON and as a page.

use std::path::Path;

use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::cli::pages;
use crate::grade::Statistics;

/// Writes `PATH.json` and `PATH.html`, where the path may already have one of these endings.
pub(super) fn write(statistics: &Statistics, path: &Path) -> Result<(), Failure> {
    let ends = path.extension().is_some_and(|ending| ending == "html" || ending == "json");
    let stem = if ends { path.with_extension("") } else { path.to_owned() };
    let named = |ending: &str| {
        let mut name = stem.clone().into_os_string();
        name.push(ending);
        std::path::PathBuf::from(name)
    };
    let json = serde_json::to_string_pretty(statistics)?;
    Output::whole(Some(&named(".json")), &format!("{json}\n"))?;
    Output::whole(Some(&named(".html")), &pages::renderer()?.render_statistics(statistics)?)
}
