//! `momentous simulate`: the table of impacts, the plots, the balances, and what cannot be simulated.

use serde_json::Value;

use crate::room::Room;

fn json(room: &Room, arguments: &[&str]) -> Value {
    serde_json::from_str(&room.fine(&[&["simulate"], arguments, &["--format", "json"]].concat())).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

#[test]
fn the_table_of_impacts_is_the_solution_of_the_problem() {
    let room = Room::empty();
    let text = room.fine(&["simulate", "impact/two-carts", "--seed", "7"]);
    assert!(
        text.starts_with("impact/two-carts, seed 7\n\nstage 1: A, B along x\n  event driven, the cheapest"),
        "{text}"
    );
    assert!(text.contains("time in s  between  impulse in N s  energy before in J  energy after in J"), "{text}");

    let film = json(&room, &["impact/two-carts", "--seed", "7"])["stages"][0].clone();
    let solved = room.fine(&[
        "solve",
        "impact/two-carts",
        "--seed",
        "7",
        "--find",
        "T_lost",
        "--find",
        "J_B",
        "--format",
        "json",
    ]);
    let solved: Value = serde_json::from_str(&solved).unwrap();
    let find = |id: &str| {
        let part = solved["ask"].as_array().unwrap().iter().find(|part| part["id"] == id);
        number(&part.unwrap_or_else(|| panic!("{solved}"))["value"])
    };
    let impact = &film["impacts"][0];
    let lost = number(&impact["energy_before"]) - number(&impact["energy_after"]);
    assert!((lost - find("T_lost")).abs() < 1e-12 * lost, "{impact}");
    assert!((number(&impact["impulse"][0]) - find("J_B")).abs() < 1e-12, "{impact}");
    assert!(number(&impact["time"]).abs() < 1e-12);
}

/// Momentum and energy are the same at all instants, but for what comes from outside.
#[test]
fn the_balances_hold_in_what_is_plotted() {
    let room = Room::empty();
    for problem in ["impact/two-carts", "impact/hockey-pucks", "bouncing/rubber-ball"] {
        let all = json(&room, &[problem, "--seed", "3"]);
        for film in all["stages"].as_array().unwrap() {
            let moments = film["moments"].as_array().unwrap();
            let kept = |moment: &Value| {
                let part = |name: &str| number(&moment[name]);
                let energy = part("kinetic_energy") + part("potential_energy") + part("energy_lost") - part("work");
                (number(&moment["momentum"][0]) - number(&moment["impulse_from_outside"][0]), energy)
            };
            let first = kept(&moments[0]);
            assert!(moments.len() > 200, "{problem}");
            for moment in moments {
                let now = kept(moment);
                assert!((now.0 - first.0).abs() < 1e-9 * (1.0 + first.0.abs()), "{problem}: {moment}");
                assert!((now.1 - first.1).abs() < 1e-9 * (1.0 + first.1.abs()), "{problem}: {moment}");
            }
        }
    }
}

#[test]
fn the_plots_show_what_was_asked_for() {
    let room = Room::empty();
    let drawing = room.fine(&["simulate", "impact/two-carts", "--format", "svg"]);
    for part in
        ["place x", "velocity along x", "momentum along x", "energy", "impacts", "centre of mass", "lost in impacts"]
    {
        assert!(drawing.contains(part), "{part}");
    }
    let ball = room.fine(&["simulate", "bouncing/rubber-ball", "--format", "svg"]);
    assert!(ball.contains("height y") && ball.contains("potential") && !ball.contains("centre of mass"));
    assert!(room.fine(&["simulate", "impact/two-carts", "--format", "csv"]).starts_with("stage,time,between,"));
}

/// With the feature a picture, without it the way out.
#[test]
fn a_picture_is_made_where_the_program_can() {
    let room = Room::empty();
    for arguments in [
        &["simulate", "impact/two-carts", "--format", "png", "-o", "a.png"][..],
        &[
            "chart",
            "head-on",
            "--finest-step",
            "0.02",
            "--repetitions",
            "1",
            "--format",
            "png",
            "--dark",
            "-o",
            "a.png",
        ],
    ] {
        let ran = room.run(arguments);
        if cfg!(feature = "png") {
            assert_eq!(ran.code, 0, "{}", ran.err);
            assert!(std::fs::read(room.path("a.png")).unwrap().starts_with(b"\x89PNG"));
        } else {
            assert!(
                ran.code == 2 && ran.err.contains("--format svg") && ran.err.contains("--features png"),
                "{}",
                ran.err
            );
        }
    }
}

#[test]
fn a_method_can_be_chosen_and_then_errs_as_it_does() {
    let room = Room::empty();
    let exact = json(&room, &["impact/two-carts"]);
    let coarse = json(&room, &["impact/two-carts", "--method", "penalty", "--accuracy", "0.5"]);
    let after =
        |run: &Value| number(&run["stages"][0]["moments"].as_array().unwrap().last().unwrap()["velocities"][0][0]);
    assert_eq!(coarse["stages"][0]["method"], "penalty");
    let apart = (after(&exact) - after(&coarse)).abs();
    assert!(apart > 1e-9 && apart < 0.5 * after(&exact).abs().max(1.0), "{apart}");
}

/// A stage that is no world is followed by its formula, or integrated in time; nothing else follows it.
#[test]
fn a_rocket_is_followed() {
    let room = Room::empty();
    let film = json(&room, &["streams/heavy-rocket"])["stages"][0].clone();
    assert_eq!((&film["method"], &film["class"]), (&"closed form".into(), &"closed form".into()));
    let integrated = json(&room, &["streams/heavy-rocket", "--method", "runge-kutta"])["stages"][0].clone();
    assert_eq!(integrated["method"], "Runge-Kutta 5(4)");
    let moments = film["moments"].as_array().unwrap();
    let mass = |moment: &Value| number(&moment["masses"][0]);
    assert!(mass(moments.last().unwrap()) < 0.5 * mass(&moments[0]));
    let drawing = room.fine(&["simulate", "streams/heavy-rocket", "--format", "svg"]);
    assert!(drawing.contains("height y") && drawing.contains("what the exhaust carries away"));
    let ran = room.run(&["simulate", "streams/heavy-rocket", "--method", "penalty"]);
    assert!(
        ran.code == 2 && ran.err.contains("only closed form and Runge-Kutta 5(4) follow such a motion"),
        "{}",
        ran.err
    );
}

#[test]
fn what_cannot_be_simulated_says_why() {
    let room = Room::empty();
    for (arguments, said) in [
        (&["impact/two-carts", "--method", "penalti"][..], "did you mean `penalty`?"),
        (&["impact/two-carts", "--accuracy", "2"], "between 0 and 1"),
        (&["impact/two-carts", "--budget", "3 kg"], "a budget is a time"),
        (&["impact/two-carts", "--budget", "1e-12 s"], "no method of the table meets this"),
        (&["impact/two-carts", "--accuracy", "1e-30"], "no method of the table meets this"),
        (&["impact/two-carts", "--method", "linear-solve"], "linear solve is not applicable: nothing touches"),
        (&["rocket/no-such"], "rocket/no-such"),
    ] {
        let ran = room.run(&[&["simulate"], arguments].concat());
        assert!(ran.code == 2 && ran.err.contains(said), "{arguments:?}: {}", ran.err);
    }
}
