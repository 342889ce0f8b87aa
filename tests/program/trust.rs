//! What `docs/trust.md` promises of files, texts and secrets, tried by those who would break it.

mod check;
mod files;
mod promises;
mod secrets;
mod texts;
