//! The small figure of a problem in the gallery.

use momentous_exercise::calls::{Refused, VariantRequest};
use momentous_figure::svg_file;

use super::view::View;

/// The figure of a problem's first sheet as SVG, or what it asks for where nothing is drawn on the sheet.
pub(super) fn figure(view: &View<'_>, problem: &str) -> Result<String, Refused> {
    let exercise = view.engine().draw(&VariantRequest::drawn(problem, None, 1))?;
    Ok(svg_file(&exercise.thumbnail()))
}
