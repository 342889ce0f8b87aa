//! Judging lines of work: `cargo bench --bench work`. It prints how long a line takes, the first of a form and any later one, right and wrong,
//! over every form of the bank on one core. With a name, `cargo bench --bench work -- two-carts`, the forms of problems with that in their
//! names alone, and each line by itself.

use std::sync::Arc;
use std::time::Duration;
use std::time::Instant;

use momentous::bank::Bank;
use momentous::exercise::Drawer;
use momentous::explain;
use momentous::grade::DecimalMark;
use momentous::problem::Problem;
use momentous::problem::compile;
use momentous::problem::load;
use momentous::work::Judge;

/// Times in their order.
#[derive(Default)]
struct Times(Vec<Duration>);

impl Times {
    fn add(&mut self, work: impl FnOnce()) {
        let start = Instant::now();
        work();
        self.0.push(start.elapsed());
    }

    fn with(mut self, other: &Self) -> Self {
        self.0.extend(&other.0);
        self
    }

    fn report(mut self, name: &str) {
        self.0.sort_unstable();
        let at = |percent: usize| self.0.get((self.0.len() * percent / 100).min(self.0.len().saturating_sub(1)));
        let milliseconds = |percent| at(percent).map_or(f64::NAN, Duration::as_secs_f64) * 1e3;
        println!(
            "{name:<32} {:>6} lines   median {:>8.3} ms   p99 {:>8.3} ms   most {:>8.3} ms",
            self.0.len(),
            milliseconds(50),
            milliseconds(99),
            milliseconds(100)
        );
    }
}

/// A line with the sign of its last term turned.
fn spoilt(line: &str) -> Option<String> {
    let at = line.rfind(" + ").map(|at| (at, " - ")).or_else(|| line.rfind(" - ").map(|at| (at, " + ")))?;
    Some(format!("{}{}{}", &line[..at.0], at.1, &line[at.0 + 3..]))
}

fn main() {
    let name = std::env::args().skip(1).find(|argument| !argument.starts_with("--"));
    let (mut first, mut right, mut first_wrong, mut wrong) =
        (Times::default(), Times::default(), Times::default(), Times::default());
    let bank = Bank::built_in();
    for source in bank.sources().filter(|source| name.as_ref().is_none_or(|name| source.name.contains(name))) {
        let compiled = load(source.clone()).and_then(|loaded| compile(loaded, None));
        let Ok(problem) = compiled.map(Arc::<Problem>::new) else { continue };
        for form in 0..problem.forms().len() {
            let Some(exercise) = Drawer::new(&problem, form).ok().and_then(|mut drawer| drawer.draw(1).ok()) else {
                continue;
            };
            let worked = exercise.worked();
            let lines: Vec<String> = explain::lines(worked)
                .iter()
                .filter_map(|own| Some(format!("{} = {}", own.left, own.right.as_ref()?)))
                .collect();
            let spoilt: Vec<String> = lines.iter().filter_map(|line| spoilt(line)).collect();
            for (lines, first, later) in [(&lines, &mut first, &mut right), (&spoilt, &mut first_wrong, &mut wrong)] {
                for (place, line) in lines.iter().enumerate() {
                    let times: &mut Times = if place == 0 { first } else { later };
                    times.add(|| {
                        Judge::new(worked, DecimalMark::Point).line(line);
                    });
                    if let (Some(_), Some(time)) = (&name, times.0.last()) {
                        println!("{:>10.3} ms  {line}", time.as_secs_f64() * 1e3);
                    }
                }
            }
        }
    }
    let all = Times::default().with(&right).with(&wrong);
    first.report("right, the first of a form");
    right.report("right");
    first_wrong.report("wrong, the first of a form");
    wrong.report("wrong");
    all.report("right or wrong, any later one");
}
