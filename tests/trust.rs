//! What `docs/trust.md` promises of files, texts and secrets, tried by those who would break it.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test says bluntly what it expects")]

#[path = "trust/check.rs"]
mod check;
#[path = "trust/files.rs"]
mod files;
#[path = "trust/promises.rs"]
mod promises;
#[path = "cli/room.rs"]
#[allow(dead_code, reason = "the other tests of the program use the rest")]
mod room;
#[path = "trust/secrets.rs"]
mod secrets;
#[path = "trust/texts.rs"]
mod texts;
