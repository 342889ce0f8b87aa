//! Stages that are integrated in time can be watched: what is seen of them keeps its balances, places go on as velocities say, and
//! the end is the one that the laws find.

use std::collections::BTreeMap;
use std::path::Path;

use momentous::problem::{Problem, Sampler, Variant};
use momentous::simulate::Moment;
use momentous::simulate::scene::{Followed, RecordedMotion};
use momentous::witness::{followed, followed_least, staged};

use crate::variants;

/// The tolerance of the integrations.
const TOLERANCE: f64 = 1e-10;

/// What was seen, over all problems.
#[derive(Default)]
struct Seen {
    /// Stages run as worlds, stages followed, and stages that are refused.
    worlds: usize,
    followed: BTreeMap<&'static str, usize>,
    refused: BTreeMap<&'static str, Vec<String>>,
    /// Velocities at the end that the laws know too.
    compared: usize,
    wrong: Vec<String>,
}

fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.map(f64::abs).fold(0.0, f64::max)
}

impl Seen {
    fn problem(&mut self, problem: &Problem) {
        for form in 0..problem.forms().len() {
            let Ok(variant) = Sampler::new(problem, form).unwrap().variant(1) else { continue };
            for (place, found) in staged(problem, &variant).into_iter().enumerate() {
                let stage = &problem.loaded().draft.scene.stages[place];
                let name = format!("{}, {}", variants::form_name(problem, form), stage.key());
                match (found, followed(problem, &variant, place, TOLERANCE)) {
                    (Ok(_), _) => self.worlds += 1,
                    (Err(_), Err(reason)) => self.refused.entry(reason.reason()).or_default().push(name),
                    (Err(_), Ok(reels)) => {
                        *self.followed.entry(stage.key()).or_default() += 1;
                        for reel in &reels {
                            self.balances(&name, reel);
                            // Springs stand for forces that nobody told: what is kept is shown by them, not how it ends.
                            if stage.key() != "interact" {
                                self.end(&name, reel, place, problem, &variant);
                            }
                        }
                    }
                }
            }
        }
    }

    fn balances(&mut self, name: &str, reel: &RecordedMotion) {
        let moments = &reel.record.moments;
        let parts = reel.components.len();
        let momentum = |moment: &Moment, part: usize| {
            let each = moment.velocities.iter().zip(&moment.masses);
            each.map(|(velocity, mass)| velocity[part].abs() * mass).sum::<f64>()
        };
        for part in 0..parts {
            let outside = largest(moments.iter().map(|moment| moment.outside[part]));
            let scale = largest(moments.iter().map(|moment| momentum(moment, part))) + outside;
            let kept = |moment: &Moment| moment.momentum[part] - moment.outside[part];
            let off = largest(moments.iter().map(|moment| kept(moment) - kept(&moments[0])));
            if off > 1e-6 * scale {
                self.wrong.push(format!("{name}: the momentum is off by {off:e} of {scale:e}"));
            }
        }
        let sizes = |moment: &Moment| moment.kinetic + moment.potential.abs() + moment.work.abs() + moment.lost;
        let (scale, start) = (largest(moments.iter().map(sizes)), moments[0].balance());
        let off = largest(moments.iter().map(|moment| moment.balance() - start));
        if off > 1e-6 * scale {
            self.wrong.push(format!("{name}: the energy is off by {off:e} of {scale:e}"));
        }
        for body in 0..reel.record.bodies.len() {
            for part in 0..parts {
                let (mut way, mut off) = (0.0_f64, 0.0_f64);
                for pair in moments.windows(2) {
                    let gone = pair[1].positions[body][part] - pair[0].positions[body][part];
                    let speed = f64::midpoint(pair[0].velocities[body][part], pair[1].velocities[body][part]);
                    let time = pair[1].time - pair[0].time;
                    way += gone.abs() + speed.abs() * time;
                    off += (gone - speed * time).abs();
                }
                // The trapezoidal rule over a hundred parts of a smooth motion.
                if off > 2e-3 * way {
                    self.wrong.push(format!("{name}: places go on by {off:e} otherwise than velocities, of {way:e}"));
                }
            }
        }
    }

    fn end(&mut self, name: &str, reel: &RecordedMotion, place: usize, problem: &Problem, variant: &Variant) {
        let last = reel.record.moments.last().unwrap();
        let speed = |body: usize| last.velocities[body].iter().map(|part| part * part).sum::<f64>().sqrt();
        for (body, recorded) in reel.record.bodies.iter().enumerate() {
            for (part, component) in reel.components.iter().enumerate() {
                let letter = if reel.components.len() > 1 { format!(".{}", component.letter) } else { String::new() };
                let quantity = format!("v_{}{}{letter}", recorded.name, place + 2);
                let solved = problem.model().symbol_of(&quantity).and_then(|symbol| variant.value(symbol));
                let Some(solved) = solved else { continue };
                self.compared += 1;
                let off = (last.velocities[body][part] - solved.value).abs();
                let before = reel.record.moments[0].velocities[body][part].abs();
                if off > 1e-6 * (speed(body) + before) {
                    self.wrong.push(format!("{name}: {quantity} is {}, off by {off:e}", solved.value));
                }
            }
        }
    }
}

#[test]
fn what_is_integrated_can_be_watched() {
    let mut seen = Seen::default();
    for problem in variants::bank() {
        seen.problem(&problem);
    }
    for entry in std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/pictures")).unwrap() {
        let path = entry.unwrap().path();
        seen.problem(&variants::problem(&path.display().to_string(), &std::fs::read_to_string(&path).unwrap()));
    }
    println!("{} as worlds, followed {:?}, {} compared", seen.worlds, seen.followed, seen.compared);
    println!("refused {:#?}", seen.refused);
    assert!(seen.wrong.is_empty(), "{}", seen.wrong.join("\n"));
    for stage in [
        "blow",
        "bowl",
        "central",
        "connected",
        "drift",
        "impact",
        "push",
        "rotate",
        "separate",
        "slide",
        "slide_off",
        "spring",
        "stream",
        "swing",
        "taut",
        "thrust",
        "walk",
    ] {
        assert!(seen.followed.contains_key(stage), "no stage `{stage}` was followed");
    }
    assert!(seen.compared > 50, "only {} compared", seen.compared);
}

/// Every motion that is taken from a formula is the one that its equations of motion give when they are integrated.
#[test]
fn a_formula_gives_the_motion_that_is_integrated() {
    let (mut reasons, mut integrated, mut wrong) = (BTreeMap::new(), BTreeMap::new(), Vec::new());
    for problem in variants::bank() {
        for form in 0..problem.forms().len() {
            let Ok(variant) = Sampler::new(&problem, form).unwrap().variant(2) else { continue };
            for place in 0..problem.loaded().draft.scene.stages.len() {
                let name = format!("{}, stage {}", variants::form_name(&problem, form), place + 1);
                let (Ok(formulas), Ok(truths)) = (
                    followed_least(&problem, &variant, place, TOLERANCE, 0.0),
                    followed(&problem, &variant, place, TOLERANCE / 10.0),
                ) else {
                    continue;
                };
                assert_eq!(formulas.len(), truths.len(), "{name}");
                for (formula, truth) in formulas.iter().zip(&truths) {
                    match formula.followed {
                        Followed::Formula(why) => *reasons.entry(why).or_insert(0) += 1,
                        Followed::Equations(what) => *integrated.entry(what).or_insert(0) += 1,
                    }
                    let apart = formula.record.apart(&truth.record, false);
                    if apart.is_none_or(|apart| apart > 1e-7) {
                        wrong.push(format!("{name}: {apart:?}, {:?}", formula.followed));
                    }
                }
            }
        }
    }
    println!("{reasons:#?} {integrated:#?}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(reasons.len() >= 9 && reasons.values().sum::<u32>() > 150, "{reasons:#?}");
}

/// Coils drive two sliders apart for 20 to 40 ms: they are seen for that time, and nothing is said to be assumed.
#[test]
fn parts_are_driven_apart_for_the_time_that_is_told() {
    let problem = variants::bank_problem("conservation/magnets-let-go");
    let variant = Sampler::new(&problem, 0).unwrap().variant(7).unwrap();
    let reels = followed(&problem, &variant, 0, TOLERANCE).unwrap();
    let duration = problem.model().symbol_of("T").and_then(|symbol| variant.value(symbol)).unwrap().value;
    assert!((reels[0].record.moments.last().unwrap().time - duration).abs() <= f64::EPSILON * duration);
    assert!(reels[0].notes.is_empty(), "{:?}", reels[0].notes);
}
