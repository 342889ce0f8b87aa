//! Documents: sheets, worked solutions and answer keys as Markdown, LaTeX, HTML and Typst.
//!
//! The words and the layout are tera files under `templates/`, which a user's own folder overrides file by file.
//! What reaches them is already in the tongue of the format: escaped text, typeset mathematics, drawn figures.

mod authored;
mod breaking;
mod built_in;
mod depth;
mod document;
mod equation;
mod fade;
mod font;
mod fragment;
mod html;
mod key_groups;
mod latex;
mod latex_text;
mod markdown;
mod markup;
mod mathml;
mod mathml_typst;
#[cfg(feature = "files")]
mod overrides;
mod page;
#[cfg(feature = "pdf")]
mod press;
mod renderer;
mod seed_word;
mod site;
mod templates;
mod typst;
mod typst_text;
mod view;
mod writer;
mod writers;

pub use authored::{line_faults, text_faults};
pub use built_in::built_in_templates;
pub use document::{BesideFile, Document, Figures, Format};
pub use fade::{fade, steps};
pub use font::{MATH_FONT, base64};
pub use fragment::Fragment;
pub use latex_text::latex_sign;
pub use markup::Markup;
pub use page::{Heading, Identity, Key, KeyRow, Page, Sheet, SheetPart, SheetPlace, Solution};
#[cfg(feature = "pdf")]
pub use press::Press;
pub use renderer::Renderer;
pub use seed_word::SeedWord;
pub use site::Site;
