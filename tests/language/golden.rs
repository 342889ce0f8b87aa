//! The promise that a variant has the same numbers for ever: frozen problems, and the values and answers of some seeds.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use assert_cmd::Command;
use momentous::exercise::{Drawer, Exercise};
use momentous::fault::Source;
use momentous::problem::{Problem, Scheme, compile, load};
use serde_json::Value;

const PROBLEMS: &[&str] = &["two_carts", "hockey_pucks", "crate", "rubber_ball", "softball"];
const SECRETS: &[Option<&str>] = &[None, Some("course 2026")];
const SEEDS: &[u64] = &[0, 1, 2, 4_294_967_296, u64::MAX];

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/golden")
}

fn problem(name: &str, secret: Option<&str>) -> Arc<Problem> {
    let file = format!("{name}.yaml");
    let text = fs::read_to_string(folder().join(&file)).unwrap();
    let loaded = load(Source::new(&file, &text)).unwrap_or_else(|faults| panic!("{faults}"));
    Arc::new(compile(loaded, secret.map(str::as_bytes)).unwrap_or_else(|faults| panic!("{faults}")))
}

/// A variant in two lines: what is given as it is printed, and the answers to nine figures.
fn lines(exercise: &Exercise) -> String {
    let record = exercise.record(None);
    let given = |(name, given): (&String, &Value)| {
        format!("{name} = {} {}", given["value"].as_str().unwrap(), given["unit"].as_str().unwrap())
            .trim_end()
            .to_owned()
    };
    let answer = |part: &Value| {
        let value = part["value"].as_f64().map_or_else(|| part["value"].to_string(), |value| format!("{value:.8e}"));
        format!("{} = {value} {}", part["id"].as_str().unwrap(), part["unit"].as_str().unwrap_or_default())
            .trim_end()
            .to_owned()
    };
    let given: Vec<String> = record["given"].as_object().unwrap().iter().map(given).collect();
    let answers: Vec<String> = record["ask"].as_array().unwrap().iter().map(answer).collect();
    format!("    given: {}\n    answer: {}\n", given.join(", "), answers.join(", "))
}

fn variants(scheme: Scheme) -> String {
    let mut text = String::new();
    for name in PROBLEMS {
        for secret in SECRETS {
            let problem = problem(name, *secret);
            for (index, form) in problem.forms().iter().enumerate() {
                let form = form.question.name.as_deref().unwrap_or("the only form");
                let key = secret.map(|secret| format!(", secret {secret}")).unwrap_or_default();
                writeln!(text, "{name}, {form}{key}:").unwrap();
                let mut drawer = Drawer::new(&problem, index).unwrap();
                for seed in SEEDS {
                    let exercise = drawer.draw_by(*seed, scheme).unwrap_or_else(|reason| panic!("{reason}"));
                    write!(text, "  {seed}:\n{}", lines(&exercise)).unwrap();
                }
            }
        }
    }
    text
}

#[test]
fn every_variant_has_the_numbers_that_it_always_had() {
    for scheme in Scheme::ALL {
        let expected = fs::read_to_string(folder().join(format!("scheme_{scheme}.txt"))).unwrap();
        let drawn = variants(scheme);
        let differs = expected.lines().zip(drawn.lines()).find(|(expected, drawn)| expected != drawn);
        assert!(expected == drawn, "scheme {scheme}, the first line that differs: {differs:?}\nall of it:\n{drawn}");
    }
}

#[test]
fn a_secret_changes_the_numbers_and_another_secret_changes_them_again() {
    let given = |secret: Option<&str>| -> Vec<Value> {
        let problem = problem("two_carts", secret);
        let given = |seed| Exercise::draw(&problem, 0, seed).unwrap().record(None)["given"].clone();
        (0..20).map(given).collect()
    };
    let all = [None, Some(""), Some("course 2026"), Some("course 2027")].map(given);
    for (place, one) in all.iter().enumerate() {
        for other in &all[..place] {
            let same = one.iter().zip(other).filter(|(one, other)| one == other).count();
            assert_eq!(same, 0, "no seed may keep its numbers");
        }
    }
}

/// `seeds.csv` holds the tables of one roster, without and with a secret, as the first version of the derivation made them.
#[test]
fn students_have_the_seeds_that_they_always_had() {
    let room = tempfile::tempdir().unwrap();
    let at = |name: &str| room.path().join(name);
    fs::write(at("class.csv"), "id,name\ns17,Ada Example\ns18,Ben Example\nÅsa/3,Åsa Larsen\n").unwrap();
    fs::write(at("secret.txt"), "course 2026").unwrap();
    fs::copy(folder().join("two_carts.yaml"), at("carts.yaml")).unwrap();
    let mut found = String::new();
    for (sheets, secret) in [("open/", &[][..]), ("closed/", &["--secret", "secret.txt"])] {
        let arguments =
            ["generate", "carts.yaml", "--form", "forward", "--roster", "class.csv", "--derivation", "1", "-o", sheets];
        let mut command = Command::cargo_bin("momentous").unwrap();
        command.current_dir(room.path()).args(arguments).args(secret).assert().success();
        // Later versions of the program say more behind the seed, and write it as a word; the digest is no number.
        let table =
            fs::read_to_string(at(&format!("{}-teacher", sheets.trim_end_matches('/'))).join("seeds.csv")).unwrap();
        let seeds = |row: &str| {
            let cells: Vec<&str> = row.split(',').take(6).collect();
            format!(
                "{},{},{}\n",
                cells[..3].join(","),
                cells[4],
                cells[5].strip_prefix('s').filter(|seed| *seed != "eed").unwrap_or(cells[5])
            )
        };
        found.extend(table.lines().map(seeds));
    }
    assert_eq!(found, fs::read_to_string(folder().join("seeds.csv")).unwrap());
}
