//! Python, where the machine has it.

use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

/// A script that answers questions as `PrairieLearn` does.
pub const PLAY: &str = include_str!("play.py");

/// The program, or nothing where there is none; where everything is tested, there has to be one.
pub fn found() -> Option<String> {
    let name = "python3".to_owned();
    let answers = Command::new(&name).arg("--version").output().is_ok_and(|output| output.status.success());
    assert!(answers || std::env::var("CI").as_deref() != Ok("true"), "python3 is missing");
    answers.then_some(name)
}

/// Runs a script in a folder: JSON goes in, JSON comes out.
pub fn run(python: &str, folder: &Path, script: &str, input: &serde_json::Value) -> serde_json::Value {
    let mut command = Command::new(python);
    command.args(["-c", script]).current_dir(folder).stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut running = command.spawn().unwrap();
    running.stdin.take().unwrap().write_all(input.to_string().as_bytes()).unwrap();
    let output = running.wait_with_output().unwrap();
    assert!(output.status.success(), "{script}");
    serde_json::from_slice(&output.stdout).unwrap()
}
