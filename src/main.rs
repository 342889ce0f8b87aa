//! The program: arguments in, exit code out; all else is the library.

use std::process::ExitCode;

use mimalloc::MiMalloc;

/// Marking allocates little things by the million, on every core: this takes half the time that the system's memory takes.
#[global_allocator]
static MEMORY: MiMalloc = MiMalloc;

fn main() -> ExitCode {
    momentous::cli::run(std::env::args_os()).into()
}
