//! Documents: sheets, worked solutions and answer keys as Markdown, LaTeX and HTML.
//!
//! The words and the layout are tera files under `templates/`, which a user's own folder overrides file by file.
//! What reaches them is already in the tongue of the format: escaped text, typeset mathematics, drawn figures.

mod authored;
mod depth;
mod document;
mod equation;
mod fade;
mod font;
mod fragment;
mod html;
mod latex;
mod latex_text;
mod markdown;
mod markup;
mod page;
mod renderer;
mod site;
mod templates;
mod view;
mod writer;

pub use authored::text_faults;
pub use document::{BesideFile, Document, Figures, Format};
pub use fade::{fade, steps};
pub use font::{MATH_FONT, base64};
pub use fragment::Fragment;
pub use markup::Markup;
pub use page::{Identity, Key, KeyRow, Page, Sheet, SheetPart, Solution};
pub use renderer::Renderer;
pub use site::Site;
