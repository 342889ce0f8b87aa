//! What a reader sees: sheets, worked solutions, figures, and the pages of the book that are made from tables.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test says bluntly what it expects")]

mod algebra;
mod bank;
#[path = "../support/blocks.rs"]
mod blocks;
mod book;
mod digits;
mod figures;
mod fonts;
mod latex;
mod length;
#[path = "../support/pdflatex.rs"]
mod pdflatex;
mod pictures;
#[path = "../support/problems.rs"]
mod problems;
mod render;
mod sentences;
#[path = "../support/variants.rs"]
mod variants;
#[path = "../support/works.rs"]
mod works;
