//! One fault a file, and for each the whole message that its author reads.

use std::path::Path;

use insta::{assert_snapshot, glob, with_settings};
use momentous::fault::Source;
use momentous::problem::{Loaded, compile, load};

fn load_file(path: &Path) -> Result<Loaded, String> {
    let name = path.file_name().unwrap().to_str().unwrap();
    let text = std::fs::read_to_string(path).unwrap();
    load(Source::new(name, &text)).map_err(|faults| faults.to_string())
}

#[test]
fn message() {
    glob!("../fixtures/bad_problems", "*.yaml", |path| {
        let name = path.file_name().unwrap().to_str().unwrap();
        let source = Source::new(name, &std::fs::read_to_string(path).unwrap());
        let compiled = load(source).and_then(|loaded| compile(loaded, None));
        let message = compiled.map(drop).expect_err("the file has a fault").to_string();
        with_settings!({ omit_expression => true }, { assert_snapshot!(message) });
    });
}

#[test]
fn good_problems_load() {
    glob!("../fixtures/problems", "*.yaml", |path| {
        if let Err(message) = load_file(path) {
            panic!("{message}");
        }
    });
}
