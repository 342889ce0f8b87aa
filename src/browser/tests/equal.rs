//! The module for browsers answers every request as the same code does on this machine, byte for byte.
#![allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]

use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, thread};

use momentous_bank::Bank;
use momentous_browser::Desk;
use serde_json::{Value, json};

/// Answers as students type them, right or not, readable or not.
const TYPED: [&str; 20] = [
    "1 m/s",
    "-3.16 m/s",
    "0.8",
    "4,5 N s",
    "12 kg m/s",
    "2.5e3 J",
    "30 deg",
    "(1, 2) m/s",
    "3 i - 4 j",
    "yes",
    "no",
    "A",
    "elastic",
    "m_A v_A1",
    "sqrt(2 g h)",
    "0",
    "3.16 m/s to the left",
    "1/3",
    "25 cm",
    "nothing",
];

/// Seeds of each form, of every problem of the bank; `MOMENTOUS_SEEDS` takes another number.
const SEEDS: u64 = 3;

fn seeds() -> u64 {
    env::var("MOMENTOUS_SEEDS").ok().and_then(|text| text.parse().ok()).unwrap_or(SEEDS)
}

fn call(name: &str, request: &Value) -> Value {
    json!({ "call": { "name": name, "request": request } })
}

/// Requests of a page for every problem: its sheets and solutions, and marks for typed answers.
fn requests(desk: &mut Desk) -> Vec<String> {
    let bank = Bank::built_in();
    let files = bank.sources().map(|source| json!({ "name": *source.name, "text": *source.text }));
    let open = json!({ "open": { "problems": files.collect::<Vec<_>>() } });
    let mut all = vec![open.to_string()];
    desk.answer(open.to_string().as_bytes());
    for problem in bank.ids() {
        for seed in 1..=seeds() {
            let variant = json!({ "problem": problem, "seed": seed });
            let fields = json!([["seed", seed.to_string()]]);
            let sheet = call("sheet", &variant);
            let said: Value = serde_json::from_str(&desk.answer(sheet.to_string().as_bytes())).unwrap();
            let parts = said["value"]["fields"].as_array().unwrap();
            all.push(sheet.to_string());
            for page in ["practice", "solution", "play"] {
                all.push(json!({ "page": { "path": format!("/{page}/{problem}"), "fields": fields } }).to_string());
            }
            for typed in TYPED {
                let answers = parts.iter().map(|part| (part["id"].as_str().unwrap().to_owned(), json!(typed)));
                let answers: Value = answers.collect::<serde_json::Map<_, _>>().into();
                all.push(call("mark", &json!({ "problem": problem, "seed": seed, "answers": answers })).to_string());
            }
        }
    }
    all
}

#[test]
#[ignore = "needs node and the module that `src/browser/build` makes"]
fn the_module_answers_as_this_machine_does() -> Result<(), Box<dyn std::error::Error>> {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let module = env::var_os("MODULE").map_or_else(|| here.join("../../target/engine.wasm.gz"), PathBuf::from);
    let script = here.join("tests/module.mjs");
    let mut node = Command::new("node").arg(script).arg(module).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn()?;
    let (mut to, from) = (node.stdin.take().ok_or("no input")?, node.stdout.take().ok_or("no output")?);
    let mut desk = Desk::default();
    let requests = requests(&mut desk);
    let asked = requests.clone();
    let writer = thread::spawn(move || asked.iter().try_for_each(|request| writeln!(to, "{request}")));
    let mut answered = 0;
    for (request, said) in requests.iter().zip(BufReader::new(from).lines()) {
        assert_eq!(said?, desk.answer(request.as_bytes()), "{request}");
        answered += 1;
    }
    writer.join().map_err(|_| "the writer stopped")??;
    println!("{answered} answers are equal");
    assert_eq!(answered, requests.len());
    Ok(())
}
