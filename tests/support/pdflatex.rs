//! Documents compiled by a real pdfLaTeX.

use std::fs;
use std::process::Command;

/// A line that runs over the margin.
#[derive(Debug, PartialEq)]
pub struct Overfull {
    /// By how many points.
    pub points: f64,
    /// What the log says of it.
    pub report: String,
}

/// Whether pdfLaTeX is there. Where it is not, the test says that it was skipped; under CI it must be there.
pub fn is_installed() -> bool {
    let installed = Command::new("pdflatex").arg("--version").output().is_ok();
    if !installed {
        assert!(std::env::var_os("CI").is_none(), "pdflatex must be there under CI");
        eprintln!("skipped: pdflatex is not installed");
    }
    installed
}

/// Compiles a document: the lines that run over the margin, or the log where it does not compile.
pub fn compile(text: &str) -> Result<Vec<Overfull>, String> {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("document.tex"), text).unwrap();
    let output = Command::new("pdflatex")
        .args(["-interaction=nonstopmode", "-halt-on-error", "-no-shell-escape", "document.tex"])
        .current_dir(folder.path())
        .output()
        .unwrap();
    let log = String::from_utf8_lossy(&output.stdout).into_owned();
    if output.status.success() { Ok(log.lines().filter_map(overfull).collect()) } else { Err(log) }
}

/// Reads `Overfull \hbox (12.3pt too wide) in paragraph at lines 39--40`.
fn overfull(line: &str) -> Option<Overfull> {
    let rest = line.strip_prefix("Overfull \\hbox (")?;
    let points = rest.split_once("pt")?.0.parse().unwrap();
    Some(Overfull { points, report: line.to_owned() })
}
