//! How the time to read a problem file grows with the file: twice the file may take 2.5 times the time.
//!
//!     cargo bench --bench loading
//!
//! Each row is a file that somebody may type, at a size and at twice that size, up to the longest that is read.

#![allow(clippy::unwrap_used, reason = "a measurement that fails has nothing to say")]

use std::fmt::Write;
use std::hint::black_box;
use std::time::{Duration, Instant};

use momentous::fault::Source;
use momentous::problem::{LONGEST_FILE, compile, load};

/// The most that twice the file may take.
const AIM: f64 = 2.5;
/// How often each is read; the shortest time counts.
const TIMES: usize = 5;

/// A problem, of which a part is written out.
const BEFORE: &str = "id: own/carts\ntitle: Carts\nlevel: intro\nscene:\n  axes: { x: to the right }\n  bodies:\n    A: { name: cart A, mass: m_A }\n    B: { name: cart B, mass: m_B }\n  stages:\n    - impact: { between: [A, B], restitution: 1 }\n";
const GIVEN: &str = "given:\n  m_A: { min: 4, max: 8, step: 1, unit: kg }\n  m_B: { min: 1, max: 3, step: 1, unit: kg }\n  v_A1: { min: 2, max: 5, step: 1, unit: m/s }\n  v_B1: 0 m/s\n";
const TEXT: &str = "text: >\n  Cart A ({{ m_A }}) moves {{ v_A1 | motion }}; cart B ({{ m_B }}) {{ v_B1 | motion }}.\n";
const ASK: &str = "ask:\n  - { find: v_A2, unit: m/s, points: 2 }\n";

/// What is repeated, how often for the smaller file, and the file around it.
type Row = (&'static str, usize, fn(usize) -> String);

const ROWS: [Row; 9] = [
    ("unknown keys", 8000, |count| format!("{}{}", whole(), repeated(count, |number| format!("k{number}: 1\n")))),
    ("the same key again", 8000, |count| format!("{}{}", whole(), "level: core\n".repeat(count))),
    ("keys of a body", 4000, |count| {
        let keys = repeated(count, |number| format!("      k{number}: 1\n"));
        format!("{}{GIVEN}{TEXT}{ASK}", BEFORE.replacen("A: { name: cart A, mass: m_A }\n", &format!("A:\n{keys}"), 1))
    }),
    ("`one_of` with values", 16_000, |count| one_of(&repeated(count, |number| format!("{}, ", number + 4)))),
    ("`one_of` with one value", 16_000, |count| one_of(&"4, ".repeat(count))),
    ("placeholders", 4000, |count| text(&"{{ m_A }} ".repeat(count))),
    ("nested `{{`", 10_000, |count| text(&format!("{}m_A{}", "{{ ".repeat(count), " }}".repeat(count)))),
    ("placeholders of unknown names", 4000, |count| text(&repeated(count, |number| format!("{{{{ x_{number} }}}} ")))),
    ("a long text", 10_000, |count| text(&"words and ".repeat(count))),
];

fn whole() -> String {
    format!("{BEFORE}{GIVEN}{TEXT}{ASK}")
}

fn repeated(count: usize, of: impl Fn(usize) -> String) -> String {
    (0..count).fold(String::new(), |mut text, number| {
        // Writing to a string cannot fail.
        let _ = write!(text, "{}", of(number));
        text
    })
}

fn one_of(values: &str) -> String {
    let given =
        GIVEN.replacen("{ min: 4, max: 8, step: 1, unit: kg }", &format!("{{ one_of: [{values}], unit: kg }}"), 1);
    format!("{BEFORE}{given}{TEXT}{ASK}")
}

fn text(more: &str) -> String {
    format!("{BEFORE}{GIVEN}{TEXT}  {more}\n{ASK}")
}

/// How long a file takes to be read and compiled, or to be refused with every fault printed.
fn time(text: &str) -> Duration {
    let once = || {
        let start = Instant::now();
        let problem = load(Source::new("a.yaml", text)).and_then(|loaded| compile(loaded, None));
        black_box(problem.map_or_else(|faults| faults.to_string(), |problem| problem.id().to_owned()));
        start.elapsed()
    };
    (0..TIMES).map(|_| once()).min().unwrap()
}

fn main() {
    println!("{:<30}  {:>9}  {:>9}  {:>9}  {:>6}", "", "bytes", "ms", "twice ms", "ratio");
    for (name, count, of) in ROWS {
        let (once, twice) = (of(count), of(2 * count));
        assert!(twice.len() <= LONGEST_FILE, "{name}: {} bytes are more than are read", twice.len());
        let [small, large] = [&once, &twice].map(|text| time(text).as_secs_f64() * 1e3);
        let ratio = large / small;
        let said = if ratio > AIM { "  more than the aim" } else { "" };
        println!("{name:<30}  {:>9}  {small:>9.1}  {large:>9.1}  {ratio:>6.2}{said}", once.len());
    }
}
