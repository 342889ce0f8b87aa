//! Every scene of the stability suite by every method, against the table `tests/fixtures/stability.txt`: right, refused by name, or
//! failing in the known way by the known amount. A method that starts to pass or to fail elsewhere breaks the test.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use momentous::simulate::least::{Request, keep};
use momentous::simulate::stability::{Trial, in_the_plane, on_a_line, run_all};
use momentous::simulate::{Body, Budget, Ending, EventDriven, Method, Refusal, Shown, World};

#[test]
fn every_method_does_what_the_table_says() {
    let mut table = String::new();
    let mut scene = "";
    for row in run_all() {
        if row.scene != scene {
            scene = row.scene;
            writeln!(table, "\n{scene}").unwrap();
        }
        writeln!(table, "    {:22}{}", row.method, row.verdict).unwrap();
    }
    let expected = include_str!("../fixtures/stability.txt").split_once("\n\n").expect("a head and a body").1;
    if table.trim() != expected.trim() {
        for (now, then) in table.trim().lines().zip(expected.trim().lines()).filter(|(now, then)| now != then) {
            println!("now   {now}\ntable {then}");
        }
        panic!("the table says otherwise; all of it is now:\n{table}");
    }
    assert!(include_str!("../../docs/methods.md").contains(expected.trim()), "docs/methods.md has another table");
}

/// What nobody can know of a function from some of its values: a problem's file with such a push is refused by name.
const UNSEEN: &str = "a push of 1 ms in 10 s";

/// The method that is chosen for a user is right, or refused, or says that it was cut off: never wrong without a word.
#[test]
fn what_is_chosen_for_a_user_is_never_silently_wrong() {
    fn chosen<const D: usize>(trial: &Trial<D>, wrong: &mut Vec<String>) -> bool {
        let Ok(shown) = Shown::of(&trial.world, &trial.budget, false) else { return false };
        let Ok(kept) = keep(&shown, &Request::default()) else { return false };
        let value = (trial.measure)(&kept.run);
        let right = value.is_some_and(|value| (value - trial.expected).abs() <= 1e-8 * trial.expected.abs());
        // A number of impacts that was asked for ends what would go on for ever.
        let told = shown.cut_off(&kept.run).is_some() || trial.expected.is_nan() && kept.run.ending == Ending::Impacts;
        if !right && !told && trial.name != UNSEEN {
            wrong.push(format!("{}: {value:?}, not {} by {}", trial.name, trial.expected, kept.choice));
        }
        right
    }
    let mut wrong = Vec::new();
    let line = on_a_line().iter().filter(|trial| chosen(trial, &mut wrong)).count();
    let plane = in_the_plane().iter().filter(|trial| chosen(trial, &mut wrong)).count();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(line >= 35 && plane >= 9, "{line} and {plane} are right");
}

/// A point of a committed chart: method, seconds, median and greatest error.
fn points(task: &str) -> Vec<(String, f64, f64, f64)> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("docs/methods/{task}.csv"));
    let text = fs::read_to_string(path).unwrap();
    let point = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        Some((cells[1].to_owned(), cells[3].parse().ok()?, cells[6].parse().ok()?, cells[8].parse().ok()?))
    };
    text.lines().skip(1).filter_map(point).collect()
}

/// What `docs/methods.md` says of the bounce tasks, in the points behind its charts.
#[test]
fn the_points_of_the_bounce_tasks_are_as_the_page_says() {
    for task in ["bounce", "bounce-with-drag"] {
        let (peers, ours): (Vec<_>, Vec<_>) = points(task).into_iter().partition(|point| point.0 == "Rapier");
        assert!(peers.len() >= 5, "{task}: only {} points of the peer", peers.len());
        for (_, seconds, median, greatest) in peers {
            let better = ours.iter().any(|row| row.1 <= seconds && row.2 <= median && row.3 <= greatest);
            assert!(better, "{task}: nothing of ours is as fast and as right as the peer in {seconds} s");
        }
    }
    let exact = points("bounce").into_iter().find(|point| point.0 == "event driven").unwrap();
    assert!(exact.1 <= 1e-6 && exact.3 < 1e-15, "{exact:?}");
}

/// Equal beads on a line.
fn beads(restitution: f64, beads: &[(f64, f64)]) -> World<1> {
    let mut world = World::new(restitution);
    for (name, (place, velocity)) in ["A", "B", "C", "D", "E"].iter().zip(beads) {
        world.bodies.push(Body::particle(name, 1.0, [*place], [*velocity]));
    }
    world
}

/// Where impacts accumulate, the refusal says when: the limit of the sequence of `McNamara` and Young.
#[test]
fn a_collapse_is_refused_with_its_time() {
    let world = beads(0.05, &[(0.0, 1.0), (1.0, 0.0), (2.5, -1.0)]);
    let Err(Refusal::Collapse { time, contacts }) = EventDriven.run(&world, &Budget::until(10.0)) else {
        panic!("it collapses")
    };
    assert!((time - 1.357_142_9).abs() < 1e-7, "{time}");
    assert_eq!(contacts, ["A-B", "B-C"]);
}

/// Every ball of a cradle, one pair after another, as fractions worked out by hand.
#[test]
fn every_ball_of_a_cradle_ends_as_by_hand() {
    let cases: [(f64, usize, &[f64]); 3] = [
        (0.9, 3, &[381.0 / 8000.0, 399.0 / 8000.0, 361.0 / 400.0]),
        (0.5, 3, &[13.0 / 64.0, 15.0 / 64.0, 9.0 / 16.0]),
        (0.5, 10, &[2521.0 / 16384.0, 2739.0 / 16384.0, 729.0 / 4096.0, 189.0 / 1024.0, 81.0 / 256.0]),
    ];
    for (restitution, impacts, expected) in cases {
        let places = [(0.0, 1.0), (1.0, 0.0), (2.0, 0.0), (3.0, 0.0), (4.0, 0.0)];
        let run = EventDriven.run(&beads(restitution, &places[..expected.len()]), &Budget::until(1e3)).unwrap();
        assert_eq!(run.impact_count, impacts, "e = {restitution}");
        for (velocity, expected) in run.last.velocities.iter().zip(expected) {
            assert!((velocity.x - expected).abs() < 1e-15, "e = {restitution}: {velocity} is not {expected}");
        }
    }
}
