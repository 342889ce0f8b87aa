//! A page of panels as SVG, readable on light and on dark pages.

use std::fmt::Write;

use super::marks::COLOURS;
use super::panel::{Panel, WIDTH};
use super::table::Table;

/// A page: rows of panels and tables, one below the other.
#[derive(Clone, Debug)]
pub(crate) struct Page {
    /// Its title, for screen readers.
    pub title: String,
    /// The parts on it, from the top, and in each row from the left.
    pub rows: Vec<Vec<Part>>,
}

/// The parts of a page.
#[derive(Clone, Debug)]
pub(crate) enum Part {
    Panel(Panel),
    Table(Table),
}

impl From<Panel> for Part {
    fn from(panel: Panel) -> Self {
        Self::Panel(panel)
    }
}

impl From<Table> for Part {
    fn from(table: Table) -> Self {
        Self::Table(table)
    }
}

impl Part {
    fn svg(&self) -> (String, f64) {
        match self {
            Self::Panel(panel) => (panel.svg(), panel.height),
            Self::Table(table) => (table.svg(), table.height()),
        }
    }
}

/// For which surroundings a page is coloured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Theme {
    /// Whichever the reader prefers, as a browser tells.
    Either,
    Light,
    Dark,
}

impl Page {
    /// The page as an SVG document.
    pub(crate) fn svg(&self, theme: Theme) -> String {
        let mut parts = String::new();
        let (mut top, mut width) = (0.0, WIDTH);
        for row in &self.rows {
            let (mut left, mut tallest) = (0.0, 0.0_f64);
            for part in row {
                let (svg, height) = part.svg();
                let _ = write!(parts, "<g transform=\"translate({left} {top})\">\n{svg}</g>\n");
                left += WIDTH;
                tallest = tallest.max(height);
            }
            top += tallest;
            width = width.max(left);
        }
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" viewBox=\"0 0 {width} {top}\" width=\"{width}\" \
             height=\"{top}\">\n<title>{}</title>\n<style>\n{}</style>\n\
             <rect class=\"page\" width=\"{width}\" height=\"{top}\"/>\n{parts}</svg>\n",
            super::escaped(&self.title),
            style_sheet(theme)
        )
    }
}

/// The rules for light pages come first, those for dark ones replace them.
fn style_sheet(theme: Theme) -> String {
    let mut light = String::from(
        "text{font:13px system-ui,'DejaVu Sans',sans-serif;fill:#222}\n.page{fill:#fff}\n.grid{stroke:#ddd}\n\
         .axis{stroke:#555;fill:none}\n.m path{stroke-width:1.6;fill:none;stroke-linejoin:round}\n\
         .m .spread{stroke-width:1;opacity:.55}\n.m .dashed{stroke-dasharray:6 4}\n\
         .name{font-size:16px;font-weight:600}\n.small{font-size:11px}\n",
    );
    let mut dark = String::from("text{fill:#ddd}\n.page{fill:#15171c}\n.grid{stroke:#33363d}\n.axis{stroke:#aaa}\n");
    for ((on_light, on_dark), index) in COLOURS.iter().zip(0..) {
        let _ = writeln!(light, ".m{index} *{{stroke:{on_light}}}\n.m{index} .f{{fill:{on_light}}}");
        let _ = writeln!(dark, ".m{index} *{{stroke:{on_dark}}}\n.m{index} .f{{fill:{on_dark}}}");
    }
    match theme {
        Theme::Either => format!("{light}@media (prefers-color-scheme:dark){{\n{dark}}}\n"),
        Theme::Light => light,
        Theme::Dark => format!("{light}{dark}"),
    }
}
