//! The pages of the book that are made from tables, and its examples. `UPDATE_DOCS=1 cargo test --test pages book` writes the pages anew; without
//! it, a page that is not what the tables say fails.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use momentous::laws::CHAPTERS;

use crate::blocks::blocks;
use crate::works;

mod bank_page;
mod law_page;

fn docs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs")
}

/// Every page that is made, by its path under `docs/`.
fn made() -> BTreeMap<String, String> {
    let bank = bank_page::Survey::of_the_bank();
    let mut pages = BTreeMap::from([("bank.md".to_owned(), bank.page())]);
    for chapter in CHAPTERS {
        for law in chapter.laws {
            pages.insert(format!("laws/{}.md", law.id), law_page::page(chapter.title, law, &bank));
        }
    }
    let summary = fs::read_to_string(docs().join("SUMMARY.md")).unwrap();
    pages.insert("SUMMARY.md".to_owned(), law_page::listed(&summary));
    pages
}

#[test]
fn pages_are_what_the_tables_say() {
    let made = made();
    let stale: Vec<&String> = made
        .iter()
        .filter(|(path, text)| fs::read_to_string(docs().join(path)).ok().as_ref() != Some(text))
        .map(|(path, _)| path)
        .collect();
    let orphans: Vec<PathBuf> = fs::read_dir(docs().join("laws"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| !made.contains_key(&format!("laws/{}", path.file_name().unwrap().to_string_lossy())))
        .collect();
    if std::env::var_os("UPDATE_DOCS").is_some() {
        for path in stale {
            fs::write(docs().join(path), &made[path]).unwrap();
        }
        for path in orphans {
            fs::remove_file(path).unwrap();
        }
        return;
    }
    assert!(
        stale.is_empty() && orphans.is_empty(),
        "run `UPDATE_DOCS=1 cargo test --test pages book`, read the difference and commit it; stale: {stale:?}, without a law: {orphans:?}"
    );
}

#[test]
fn the_guide_s_problems_work() {
    let guide = fs::read_to_string(docs().join("guide.md")).unwrap();
    let examples: Vec<_> = blocks(&guide).into_iter().filter(|block| block.language == "yaml").collect();
    assert!(examples.len() > 1);
    for example in examples {
        works::works(&format!("docs/guide.md:{}", example.line), &example.text);
    }
}

/// The pieces of the guide's first steps are pieces of the whole file that follows.
#[test]
fn the_guide_s_pieces_are_those_of_its_file() {
    let guide = fs::read_to_string(docs().join("guide.md")).unwrap();
    let all = blocks(&guide);
    let file = &all.iter().find(|block| block.language == "yaml").unwrap().text;
    for piece in all.iter().filter(|block| block.language == "text") {
        assert!(file.contains(&piece.text), "docs/guide.md:{} differs from the file", piece.line);
    }
}

/// A link to a page of the book leads to a page.
#[test]
fn links_lead_somewhere() {
    let mut broken = Vec::new();
    let mut pages: Vec<PathBuf> = fs::read_dir(docs()).unwrap().map(|entry| entry.unwrap().path()).collect();
    pages.extend(fs::read_dir(docs().join("laws")).unwrap().map(|entry| entry.unwrap().path()));
    for page in pages.iter().filter(|path| path.extension().is_some_and(|extension| extension == "md")) {
        let text = fs::read_to_string(page).unwrap();
        for target in text.split("](").skip(1).filter_map(|rest| rest.split_once(')')).map(|(target, _)| target) {
            let target = target.split('#').next().unwrap();
            if !target.is_empty() && !target.contains("://") && !page.parent().unwrap().join(target).exists() {
                broken.push(format!("{}: {target}", page.display()));
            }
        }
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}
