//! A target of the tests as libFuzzer wants it: bytes are a number, and a text behind it.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

#[allow(dead_code, reason = "each target runs one of them")]
#[path = "../tests/program/fuzz/targets.rs"]
mod targets;

#[allow(dead_code, reason = "each target has its own seeds")]
#[path = "../tests/program/fuzz/seeds.rs"]
mod seeds;

use targets::Target;

/// Writes the seeds into the folder of the corpus, and the pieces of such texts into a dictionary beside it.
pub fn prepare(name: &str) {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let corpus = here.join("corpus").join(name);
    fs::create_dir_all(&corpus).expect("a folder for the corpus");
    for (number, text) in seeds::of(name, &here.join("..")).iter().enumerate() {
        let bytes = [&[(number % 256) as u8], text.as_bytes()].concat();
        fs::write(corpus.join(format!("seed-{number}")), bytes).expect("a seed");
    }
    let mut dictionary = String::new();
    for piece in Target::named(name).pieces().iter().filter(|piece| !piece.is_empty()) {
        let escaped = piece.bytes().fold(String::new(), |mut text, byte| {
            let _ = write!(text, "\\x{byte:02x}");
            text
        });
        let _ = writeln!(dictionary, "\"{escaped}\"");
    }
    fs::write(here.join("corpus").join(format!("{name}.dict")), dictionary).expect("a dictionary");
}

/// Runs the target; what is no UTF-8 is replaced.
pub fn run(name: &str, bytes: &[u8]) {
    let [chosen, rest @ ..] = bytes else { return };
    (Target::named(name).run)(*chosen, &String::from_utf8_lossy(rest));
}
