//! The README and the pages for a first hour keep their word: commands run, and print what is shown.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use crate::blocks::{Block, blocks};

const README: &str = include_str!("../../README.md");

/// Pages whose commands run, each in a folder of its own, with the files that the page shows and calls by these names.
const PAGES: [(&str, &str, &[&str]); 4] = [
    ("README.md", README, &[]),
    ("docs/first_hour.md", include_str!("../../docs/first_hour.md"), &["class.csv", "submissions.csv"]),
    ("docs/marking.md", include_str!("../../docs/marking.md"), &[]),
    ("docs/students.md", include_str!("../../docs/students.md"), &[]),
];

/// Runs commands in a folder by a shell that finds the program.
fn shell(folder: &Path, commands: &str) -> Output {
    let program = Path::new(env!("CARGO_BIN_EXE_momentous")).parent().unwrap();
    let path = format!("{}:{}", program.display(), std::env::var("PATH").unwrap());
    Command::new("sh").args(["-c", commands]).current_dir(folder).env("PATH", path).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// The block that a page calls by a file's name: the first after the name.
fn file<'a>(page: &str, all: &'a [Block], name: &str) -> &'a str {
    let called = page.lines().position(|line| line.contains(&format!("`{name}`"))).unwrap();
    &all.iter().find(|block| block.line > called).unwrap().text
}

/// Whether a text is as shown, where a line `...` stands for any lines and `...` in a line for the rest of it.
fn is_shown(shown: &str, printed: &str) -> bool {
    let mut printed = printed.lines().peekable();
    let mut shown = shown.lines().peekable();
    while let Some(line) = shown.next() {
        if line == "..." {
            let Some(next) = shown.peek() else { return true };
            while printed.next_if(|printed| printed != next).is_some() {}
            continue;
        }
        let found = printed.next();
        let same = match line.strip_suffix("...") {
            Some(start) => found.is_some_and(|found| found.starts_with(start)),
            None => found == Some(line),
        };
        if !same {
            return false;
        }
    }
    printed.next().is_none()
}

/// Every `sh` block of a page runs in one folder, from the top to the end. A line exits with 0, or with what `# exits with` says.
/// A `text` block right after a `sh` block is what its last line prints.
#[cfg(unix)]
#[test]
fn commands_run_and_print_what_is_shown() {
    let commands: usize = PAGES.iter().map(|(name, page, files)| run(name, page, files)).sum();
    assert!(commands > 14, "only {commands} commands were found");
}

/// Runs the commands of a page; how many there are.
#[cfg(unix)]
fn run(name: &str, page: &str, files: &[&str]) -> usize {
    let all = blocks(page);
    let folder = tempfile::tempdir().unwrap();
    for file_name in files {
        fs::write(folder.path().join(file_name), file(page, &all, file_name)).unwrap();
    }
    let mut commands = 0;
    for (index, block) in all.iter().enumerate().filter(|(_, block)| block.language == "sh") {
        let mut printed = String::new();
        for line in block.text.lines() {
            let expected = line.split_once("# exits with ").map_or(0, |(_, code)| code.trim().parse().unwrap());
            let output = shell(folder.path(), line);
            let (out, err) = (text(&output.stdout), text(&output.stderr));
            assert_eq!(output.status.code(), Some(expected), "{name}:{}: {line}\n{out}{err}", block.line);
            printed = out;
            commands += usize::from(line.starts_with("momentous "));
        }
        let end = block.line + block.text.lines().count() + 1;
        let shown = all.get(index + 1).filter(|next| next.language == "text" && next.line == end + 2);
        if let Some(shown) = shown {
            assert!(is_shown(&shown.text, &printed), "{name}:{} shows something else than\n{printed}", shown.line);
        }
    }
    commands
}

#[test]
fn the_message_for_a_mistake_is_the_one_shown() {
    let all = blocks(include_str!("../../docs/first_hour.md"));
    let shown = &all.iter().find(|block| block.text.starts_with("error: ")).unwrap().text;
    let folder = tempfile::tempdir().unwrap();
    shell(folder.path(), "momentous new impact/my-carts");
    let path = folder.path().join("my-carts.yaml");
    let broken = fs::read_to_string(&path).unwrap().replacen("{{ v_A2 |", "{{ v_A22 |", 1);
    fs::write(&path, broken).unwrap();
    let output = shell(folder.path(), "momentous generate my-carts.yaml");
    assert!(
        text(&output.stderr).contains(shown.as_str()),
        "docs/first_hour.md shows something else than\n{}",
        text(&output.stderr)
    );
}

/// The picture and the two pages beside it are what the program writes today. Like a snapshot, `INSTA_UPDATE=always` takes
/// what is new.
#[test]
fn the_example_documents_are_up_to_date() {
    let all = blocks(README);
    let command =
        all.iter().flat_map(|block| block.text.lines()).find(|line| line.ends_with("-o docs/example/")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    assert!(shell(folder.path(), command).status.success());
    let made = folder.path().join("docs/example");
    let mut names: Vec<_> = fs::read_dir(&made).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    names.sort();
    let committed = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/example");
    assert_eq!(fs::read_dir(&committed).unwrap().count(), names.len());
    for name in names {
        let (made, committed) = (made.join(&name), committed.join(&name));
        if std::env::var_os("INSTA_UPDATE").is_some_and(|update| update == "always") {
            fs::copy(&made, &committed).unwrap();
        }
        let [made, committed] = [made, committed].map(|path| fs::read_to_string(path).unwrap());
        assert!(made == committed, "docs/example/{} is out of date; run {command}", name.display());
    }
}

#[test]
fn every_page_that_is_linked_is_there() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let links = README.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    let local: Vec<&str> = links.filter(|link| !link.starts_with("http")).collect();
    assert!(local.len() > 5);
    for link in local {
        assert!(root.join(link).is_file(), "README.md links to {link}");
    }
}
