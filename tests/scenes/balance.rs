//! The balances of mechanics on what the simulation shows of random scenes: what momentum gains is the impulse from outside, the mass
//! centre moves as the momentum says, what angular momentum gains is the angular impulse, and what kinetic energy gains is the work. What
//! the laws say of the system and of each body, asked for or not, is what the film shows.

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};

use momentous::exercise::Exercise;
use momentous::scene::{Scene, Stage};
use momentous::simulate::least::Request;
use momentous::witness::{Shot, shoot};
use rayon::prelude::*;

use super::draw::draw;
use super::film::{broken, ends, fastest};
use super::system::{asked_all, said, solved, totals};
use super::table::Table;
use super::{number, only};

/// Scenes of each kind that are tried with every change.
const EACH: u64 = 6;

/// By which share of its size a quantity of the laws may differ from what a film shows.
const APART: f64 = 1e-6;

/// What becomes of a scene: which quantities of the laws were compared with its film, and what does not agree.
struct Looked {
    compared: usize,
    wrong: Vec<String>,
}

/// Kinds of stage whose films show forces in place of those that are not given: only what is true of all together, whatever they are, is
/// compared.
const FORCES_ASSUMED: &[&str] = &["interact"];

/// Kinds of stage whose films show a change that takes time in place of one without a duration.
const DURATION_ASSUMED: &[&str] = &["conical"];

/// What the laws say of the bodies of a stage at its start and at its end, beside the film.
fn compared(exercise: &Exercise, shot: &Shot) -> Looked {
    let mut looked = Looked { compared: 0, wrong: Vec::new() };
    let scene = &exercise.problem().loaded().draft.scene;
    let axes = endings(scene);
    for (number, stage) in (1..).zip(&scene.stages) {
        let is = |kinds: &[&str]| kinds.contains(&stage.key());
        let films = || shot.films.iter().filter(|film| film.stage == number);
        if is(DURATION_ASSUMED) || films().any(|film| !film.unweighed.is_empty()) {
            continue;
        }
        // What is known of a body is known as well as the largest of the film.
        let fastest = films().map(|film| fastest(&film.record)).fold(0.0, f64::max);
        // An orbit is shown once round, wherever on it the stage ends.
        let is_round = matches!(stage, Stage::Central(central) if central.orbit.is_some());
        for (bodies, at) in ends(films(), &axes).iter().zip([number, number + 1]).take(if is_round { 1 } else { 2 }) {
            let mass: f64 = bodies.values().map(|body| body.mass).sum();
            let energies: Option<Vec<f64>> = bodies.values().map(|body| body.energy(&axes)).collect();
            let energy = energies.map(|all| all.iter().sum::<f64>());
            let mut compare = |name: String, shown: Option<f64>| {
                let Some((said, shown)) = said(exercise, &name).zip(shown) else { return };
                looked.compared += 1;
                let size = match name.as_bytes().first() {
                    Some(b'T') => mass * fastest * fastest,
                    Some(b'p') => mass * fastest,
                    _ => fastest,
                };
                if (said - shown).abs() > APART * size {
                    looked.wrong.push(format!("`{name}` is {said} by the laws and {shown} in the film"));
                }
            };
            if !is(FORCES_ASSUMED) {
                for (name, body) in bodies {
                    compare(format!("T_{name}{at}"), body.energy(&axes));
                    for ending in &axes {
                        let momentum = body.momentum(ending);
                        compare(format!("p_{name}{at}{ending}"), momentum);
                        compare(format!("v_{name}{at}{ending}"), momentum.map(|part| part / body.mass));
                    }
                }
            }
            if !scene.bodies.keys().all(|body| bodies.contains_key(body)) {
                continue;
            }
            if !is(FORCES_ASSUMED) {
                compare(format!("T_{at}"), energy);
            }
            // Across a guide, what the guide gives differs with the forces between the bodies.
            let is_guided = scene.bodies.values().any(|body| body.guide.is_some());
            let free = if is(FORCES_ASSUMED) && is_guided { &axes[..1] } else { &axes };
            for ending in free {
                let sum: Option<f64> = bodies.values().map(|body| body.momentum(ending)).sum();
                compare(format!("p_{at}{ending}"), sum);
                compare(format!("v_G{at}{ending}"), sum.map(|sum| sum / mass));
            }
        }
    }
    looked
}

/// The endings of the names of components along the axes of a scene.
fn endings(scene: &Scene) -> Vec<String> {
    match &scene.axes.rectangular()[..] {
        [_] => vec![String::new()],
        axes => axes.iter().map(|(axis, _)| format!(".{}", axis.letter())).collect(),
    }
}

/// Where a film does not keep its balances, or shows something else than the laws say.
fn looked_at(exercise: &Exercise) -> Option<Looked> {
    let shot = shoot(exercise.problem(), exercise.variant(), &Request::default()).ok()?;
    let mut looked = compared(exercise, &shot);
    looked.wrong.extend(shot.films.iter().flat_map(broken));
    Some(looked)
}

/// The balances of a random scene; none where it is refused or where there is no film of it.
fn drawn(table: &Table, kind: &str, seed: u64) -> Option<Looked> {
    let scene = draw(table, kind, seed);
    let whole = asked_all(&scene, &totals(table, &scene), &|file| file).ok()?;
    let mut looked = looked_at(&whole.exercise)?;
    for wrong in &mut looked.wrong {
        *wrong = format!("{kind} {seed}: {wrong}\n{}", whole.file);
    }
    Some(looked)
}

/// Looks at so many scenes of every kind, prints how many had a film, and says what is wrong.
fn wrong(first: u64, each: u64) -> Vec<String> {
    let table = Table::read();
    let mut wrong = Vec::new();
    for kind in table.stages.iter().filter(|kind| only(&kind.name)) {
        let look = |seed| {
            let looked = catch_unwind(AssertUnwindSafe(|| drawn(&table, &kind.name, seed)));
            looked
                .unwrap_or_else(|_| Some(Looked { compared: 0, wrong: vec![format!("{} {seed}: a panic", kind.name)] }))
        };
        let all: Vec<Looked> = (first..first + each).into_par_iter().filter_map(look).collect();
        let compared: usize = all.iter().map(|looked| looked.compared).sum();
        println!("{:10} {} of {each} shown, {compared} quantities compared", kind.name, all.len());
        wrong.extend(all.into_iter().flat_map(|looked| looked.wrong));
    }
    wrong
}

#[test]
fn balances_hold_in_what_is_shown_of_scenes() {
    let wrong = wrong(0, EACH);
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

#[test]
fn balances_hold_in_what_is_shown_of_scenes_worked_by_hand() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/hand");
    let files = fs::read_dir(folder).unwrap().map(|file| file.unwrap().path());
    let scenes: Vec<PathBuf> =
        files.filter(|path| path.extension().is_some_and(|extension| extension == "yaml")).collect();
    let wrong = |path: &PathBuf| {
        let exercise = solved(&fs::read_to_string(path).unwrap()).ok();
        let wrong = exercise.and_then(|exercise| looked_at(&exercise)).map_or_else(Vec::new, |looked| looked.wrong);
        wrong.into_iter().map(|fault| format!("{}: {fault}", path.display())).collect::<Vec<_>>()
    };
    let wrong: Vec<String> = scenes.par_iter().flat_map_iter(wrong).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// `.ci/soak scenes` looks at others, from the seed `FIRST` on.
#[test]
#[ignore = "takes an hour"]
fn balances_hold_in_what_is_shown_of_thousands_of_scenes() {
    let wrong = wrong(number("FIRST", 1_000), number("SCENES", 20_000).div_ceil(26));
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}
