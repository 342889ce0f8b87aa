//! The program: arguments in, exit code out; all else is the library.

use std::process::ExitCode;

fn main() -> ExitCode {
    momentous::cli::run(std::env::args_os()).into()
}
