//! What an operator relies on: the check of a set-up, what is measured and told, and that `docs/serving.md` names what exists.

mod check;
mod documents;
mod measured;
mod retention;
mod server;
