//! `momentous chart`: the points as a table, the drawing, the stability table, and names that are not there.

use crate::room::Room;

const QUICK: [&str; 4] = ["--finest-step", "0.02", "--repetitions", "1"];

fn quick(room: &Room, arguments: &[&str]) -> String {
    room.fine(&[&["chart"], arguments, &QUICK].concat())
}

#[test]
fn the_points_are_a_table_with_every_method() {
    let table = quick(&Room::empty(), &["head-on", "Bounce-with-drag", "--format", "csv"]);
    let mut lines = table.lines();
    let head =
        "task,method,setting,seconds,evaluations,low_error,median_error,high_error,greatest_error,failures,refusal";
    assert_eq!(lines.next(), Some(head));
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    assert!(rows.iter().all(|row| row.len() == 11 && row[3].parse::<f64>().unwrap() > 0.0), "{table}");
    for method in ["closed form", "event driven", "Runge-Kutta 5(4)", "penalty"] {
        assert!(rows.iter().any(|row| row[..2] == ["head-on", method]), "{method}");
    }
    let exact = rows.iter().find(|row| row[..2] == ["head-on", "event driven"]).unwrap();
    assert!(exact[8].parse::<f64>().unwrap() < 1e-14, "{exact:?}");
    let refused = rows.iter().find(|row| row[..2] == ["bounce with drag", "event driven"]).unwrap();
    assert_eq!((refused[6], &refused[9..]), ("", ["32", "no exact motion"].as_slice()));
}

#[test]
fn a_measured_table_can_be_drawn_again() {
    let room = Room::empty();
    quick(&room, &["head-on", "bounce-with-drag", "--format", "csv", "-o", "points.csv"]);
    let drawing = room.fine(&["chart", "--from", "points.csv"]);
    assert!(
        drawing.contains("head-on: one impact of two bodies")
            && drawing.contains("evaluations of forces")
            && drawing.contains("\u{d7} no exact motion")
    );
    assert_eq!(drawing, room.fine(&["chart", "--from", "points.csv"]), "drawing measures nothing");
    let one = room.fine(&["chart", "head-on", "--from", "points.csv"]);
    assert!(!one.contains("bounce with drag") && one.contains("head-on"));
}

#[test]
fn drift_is_measured_and_drawn_for_every_motion() {
    let room = Room::empty();
    room.fine(&["chart", "--drift", "1000", "--format", "csv", "-o", "drift.csv"]);
    let table = room.read("drift.csv");
    let rows: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(rows[0], ["motion", "method", "setting", "periods", "seconds", "energy", "momentum", "refusal"]);
    let drift = |motion: &str, method: &str, column: usize| -> f64 {
        rows.iter().find(|row| row[..2] == [motion, method]).unwrap()[column].parse().unwrap()
    };
    for motion in ["bounces", "tied balls", "orbits"] {
        assert!(drift(motion, "event driven", 5) < 1e-11, "{table}");
    }
    // Impulses are equal and opposite in every method; only what comes of rounding is left.
    for method in ["event driven", "explicit Euler", "symplectic Euler", "Moreau-Jean", "sequential impulses"] {
        assert!(drift("tied balls", method, 6) < 1e-11, "{method}\n{table}");
    }
    assert!(drift("orbits", "explicit Euler", 5) > drift("orbits", "symplectic Euler", 5), "{table}");
    let drawing = room.fine(&["chart", "--drift", "--from", "drift.csv"]);
    assert!(drawing.contains("tied balls: momentum") && drawing.contains("orbits: angular momentum"));
}

#[test]
fn the_stability_table_is_the_one_that_is_tested() {
    let room = Room::empty();
    let table = include_str!("../../fixtures/stability.txt").split_once("\n\n").unwrap().1;
    assert_eq!(room.fine(&["chart", "--stability"]).trim(), table.trim());
    let csv = room.fine(&["chart", "--stability", "--format", "csv"]);
    assert!(csv.starts_with("scene,method,verdict\n") && csv.contains("tunnelling at 50 m/s,event driven,right\n"));
    let page = include_str!("../../../docs/methods.md");
    assert!(page.contains(table.trim()), "docs/methods.md holds another stability table");
}

#[test]
fn what_cannot_be_charted_is_told() {
    let room = Room::with(&[("bad.csv", "task,method\nbounce,event driven\n")]);
    for (arguments, said) in [
        (&["chart", "bounse"][..], "did you mean `bounce`?"),
        (&["chart", "--from", "bad.csv"], "bad.csv cannot be read as points"),
        (&["chart", "--from", "none.csv"], "none.csv cannot be read as points"),
        (&["chart", "--stability", "--format", "svg"], "is text or csv"),
        (&["chart", "bounce", "--finest-step", "0"], "from 1e-9 to 1"),
    ] {
        let ran = room.run(arguments);
        assert!(ran.code == 2 && ran.err.contains(said), "{arguments:?}: {}", ran.err);
    }
}
