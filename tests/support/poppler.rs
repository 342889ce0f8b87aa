//! PDF as a reader of others sees it: the programs of poppler.

use std::fs;
use std::process::Command;

use unicode_normalization::UnicodeNormalization;

/// Whether poppler is there. Where it is not, the test says that it was skipped; under CI it must be there.
pub fn is_installed() -> bool {
    let installed = Command::new("pdftotext").arg("-v").output().is_ok();
    if !installed {
        assert!(std::env::var_os("CI").is_none(), "pdftotext must be there under CI (on Debian: poppler-utils)");
        eprintln!("skipped: pdftotext is not installed");
    }
    installed
}

/// The text of each page in the order in which it was written. Letters of mathematics are those of the alphabet.
pub fn pages(pdf: &[u8]) -> Vec<String> {
    let text: String = run("pdftotext", &["-raw"], pdf, &["-"]).nfkc().collect();
    let mut pages: Vec<String> = text.split('\u{c}').map(str::to_owned).collect();
    pages.pop();
    pages
}

/// What the reader knows of the document: its title, whether it is tagged, how many pages it has.
pub fn info(pdf: &[u8]) -> String {
    run("pdfinfo", &[], pdf, &[])
}

/// The tags, with their text.
pub fn structure(pdf: &[u8]) -> String {
    run("pdfinfo", &["-struct-text"], pdf, &[])
}

/// Every word with the left and the right end of its box, in points.
pub fn boxes(pdf: &[u8]) -> Vec<(f64, f64, String)> {
    let page = run("pdftotext", &["-bbox"], pdf, &["-"]);
    let words = page.lines().filter_map(|line| {
        let line = line.trim().strip_prefix("<word ")?;
        let side = |name: &str| line.split_once(&format!("{name}=\""))?.1.split_once('"')?.0.parse().ok();
        Some((side("xMin")?, side("xMax")?, line.to_owned()))
    });
    words.collect()
}

fn run(program: &str, options: &[&str], pdf: &[u8], rest: &[&str]) -> String {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("document.pdf");
    fs::write(&path, pdf).unwrap();
    let output = Command::new(program).args(options).arg(&path).args(rest).output().unwrap();
    assert!(output.status.success(), "{program}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}
