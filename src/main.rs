//! The program: arguments in, exit code out; all else is the library.

use std::process::ExitCode;

use mimalloc::MiMalloc;

/// Marking takes and gives back small pieces of memory by the million, on every core.
#[global_allocator]
static MEMORY: MiMalloc = MiMalloc;

fn main() -> ExitCode {
    momentous::cli::run(std::env::args_os()).into()
}
