//! PDF: every document of the bank, text of any kind, and what readers need beside the text.

#![allow(clippy::unwrap_used)] // a test that cannot go on should stop

mod bank;
mod hostile;
#[path = "../support/poppler.rs"]
mod poppler;
#[path = "../support/problems.rs"]
mod problems;
mod whole;

use std::sync::LazyLock;

use momentous::render::{Format, Page, Press, Renderer};

static PRESS: LazyLock<Press> = LazyLock::new(|| Press::new(None).unwrap());
static RENDERER: LazyLock<Renderer> = LazyLock::new(|| Renderer::new(None).unwrap().wide());

/// The pages as PDF; a warning is a failure, too.
fn print(pages: &[Page]) -> Vec<u8> {
    let document = RENDERER.render(pages, Format::Typst).unwrap().text;
    PRESS.pdf(&document).unwrap_or_else(|faults| panic!("{faults}"))
}
