//! The same scene for another observer: who moves along an axis, who sees it in a mirror, who measures in other units.
//!
//! For one who moves with -u, every velocity has u more: p has m u more and T has u p + m u²/2 more, while impulses, times, tensions and
//! what is lost are the same. In a mirror and in other units all is the same.

use std::panic::{AssertUnwindSafe, catch_unwind};

use rayon::prelude::*;

use super::draw::{Drawn, draw};
use super::system::{Questions, Solved, asked_all, exchanged, totals};
use super::table::Table;
use super::{number, only};

/// Scenes of each kind that are tried with every change.
const EACH: u64 = 4;

/// By how much the moving observer's velocities are larger, in m/s.
const SHIFT: f64 = 2.0;

/// By which share of its size a value may differ from what another observer finds.
const APART: f64 = 1e-9;

/// The keys of each kind of stage with which nothing holds on to what is fixed: its friction, its resistance, its places.
const FREE: &[(&str, &[&str])] = &[
    (
        "impact",
        &[
            "between",
            "restitution",
            "elastic",
            "loss",
            "plastic",
            "perfectly_inelastic",
            "becomes",
            "line_of_impact",
            "duration",
            "include",
            "name",
        ],
    ),
    (
        "push",
        &[
            "body",
            "bodies",
            "during",
            "forces",
            "forces-plane",
            "forces-two",
            "forces-two-plane",
            "forces-space",
            "direction",
            "name",
            "called",
        ],
    ),
    ("spring", &["between", "stiffness", "from", "to", "to-name", "until"]),
    ("taut", &["between", "along", "duration", "name"]),
    ("tow", &["front", "rear", "by", "incline", "duration"]),
    ("blow", &["body", "by", "duration", "include", "name"]),
    (
        "separate",
        &[
            "from",
            "into",
            "into-two",
            "energy",
            "relative",
            "relative-plane",
            "force",
            "duration",
            "duration-long",
            "name",
            "called",
        ],
    ),
    ("interact", &["between", "between-two", "elastic", "loss", "friction", "until", "during", "name", "direction"]),
    ("drift", &["during", "name"]),
    ("flight", &["body", "bodies", "during", "incline", "name"]),
    ("thrust", &["body", "mass", "mass-two", "exhaust", "exhaust-one", "flow", "force", "during", "direction", "name"]),
];

/// What an observer asks of a scene.
fn questions(table: &Table, scene: &Drawn) -> Questions {
    let mut all = totals(table, scene);
    all.extend(exchanged(table, scene));
    all
}

/// The scene for the observer who moves; none where something in it is fixed.
fn shifted(scene: &Drawn) -> Option<Drawn> {
    let is_free = |kind: &str, key: &str, value: &str| {
        let row = FREE.iter().find(|(listed, _)| *listed == kind);
        row.is_some_and(|(_, keys)| keys.contains(&key)) && (kind != "tow" || !value.contains("friction"))
    };
    let mut keys = scene.stages.iter().flat_map(|stage| stage.keys.iter().map(|key| (&stage.kind, key)));
    if !keys.all(|(kind, (key, value))| is_free(kind, key, value)) {
        return None;
    }
    let along = scene.components()[0];
    let mut other = scene.clone();
    for (name, value) in &mut other.given {
        if name.starts_with("v_") && name.ends_with(along) {
            let number: f64 = value.split_whitespace().next()?.parse().ok()?;
            *value = format!("{} m/s", number + SHIFT);
        }
    }
    Some(other)
}

/// What the observer who moves should find of a quantity, by what the one at rest finds; none of what has no simple rule.
fn for_moving(scene: &Drawn, solved: &Solved, name: &str) -> Option<f64> {
    let value = solved.value(name)?;
    let (kind, rest) = name.split_once('_').unwrap_or((name, ""));
    let along = scene.components()[0];
    let subject: String = rest.chars().take_while(|letter| letter.is_alphabetic()).collect();
    let given = |body: &String| {
        let mass = scene.given.iter().find(|(name, _)| *name == format!("m_{body}"))?;
        mass.1.split_whitespace().next()?.parse::<f64>().ok()
    };
    let parts: Vec<String> =
        if subject.is_empty() || subject == "G" { scene.bodies.clone() } else { vec![subject.clone()] };
    let mass = || parts.iter().map(given).sum::<Option<f64>>();
    match kind {
        "v" => Some(value + if name.ends_with(along) { SHIFT } else { 0.0 }),
        "p" => Some(value + if name.ends_with(along) { mass()? * SHIFT } else { 0.0 }),
        "T" if rest.starts_with("lost") || rest.starts_with("gained") => {
            // The same for both where nothing acts from outside.
            let stage = rest.split(['[', ']']).nth(1).map_or(Some(1), |stage| stage.parse::<usize>().ok())?;
            let [before, after] = [stage, stage + 1].map(|at| solved.value(&format!("p_{at}{along}")));
            let given = SHIFT * (after? - before?);
            Some(if rest.starts_with("lost") { value - given } else { value + given })
        }
        "T" => Some(value + SHIFT * solved.value(&format!("p_{rest}{along}"))? + mass()? * SHIFT * SHIFT / 2.0),
        "J" | "dt" | "tension" => Some(value),
        _ => None,
    }
}

/// Where two observers do not find what they should of a scene.
fn differing(
    one: &Solved,
    found: &dyn Fn(&str) -> Option<f64>,
    expected: &dyn Fn(&str) -> Option<f64>,
    other: &Solved,
) -> Vec<String> {
    let differs = |name: &String| {
        let (found, expected) = (found(name)?, expected(name)?);
        let size = one.largest(&name[..1]).max(expected.abs());
        let is_apart = (found - expected).abs() > APART * (size + 1.0);
        is_apart.then(|| format!("`{name}` is {found}, not {expected}\n{}\n{}", one.file, other.file))
    };
    one.asked.iter().filter_map(differs).take(1).collect()
}

fn to_the_other_side(file: &str) -> String {
    file.replace("to the right", "to no side")
        .replace("to the left", "to the right")
        .replace("to no side", "to the left")
}

/// Units with others for the same quantity, and how many of them make one.
const OTHER_UNITS: &[(&str, &str, f64)] = &[
    ("kg", "g", 1000.0),
    ("m/s", "cm/s", 100.0),
    ("m", "cm", 100.0),
    ("s", "ms", 1000.0),
    ("N", "mN", 1000.0),
    ("J", "kJ", 0.001),
    ("N/m", "N/cm", 0.01),
    ("m^3/s^2", "cm^3/s^2", 1e6),
    ("N m", "kN m", 0.001),
];

/// How many times as heavy everything is of another world, in which all forces, energies and impulses are so much greater.
const HEAVIER: [f64; 2] = [1e-27, 1e24];

/// The scene with everything so many times as heavy; none where a stage tells a mass, a force or an energy by its number.
fn heavier(scene: &Drawn, times: f64) -> Option<Drawn> {
    let is_weighed =
        |unit: &str| ["kg", "N", "J"].iter().any(|part| unit.split([' ', '/', '^']).any(|symbol| symbol == *part));
    let words = |value: &str| value.split([' ', ',', ']', '}']).map(str::to_owned).collect::<Vec<_>>();
    let tells_weight = |value: &str| {
        let words = words(value);
        words.windows(2).any(|pair| pair[0].parse::<f64>().is_ok_and(|number| number != 0.0) && is_weighed(&pair[1]))
    };
    if scene.stages.iter().flat_map(|stage| &stage.keys).any(|(_, value)| tells_weight(value)) {
        return None;
    }
    let mut other = scene.clone();
    for (_, value) in &mut other.given {
        if let Some((number, unit)) = value.split_once(' ').filter(|(_, unit)| is_weighed(unit)) {
            *value = format!("{:e} {unit}", number.parse::<f64>().unwrap() * times);
        }
    }
    Some(other)
}

/// By how much a quantity is greater where everything is so many times as heavy.
fn weighed(table: &Table, name: &str, times: f64) -> f64 {
    let unit = table.unit(name);
    if ["kg", "N", "J"].iter().any(|part| unit.split([' ', '/', '^']).any(|symbol| symbol == *part)) {
        times
    } else {
        1.0
    }
}

fn in_other_units(scene: &Drawn) -> Drawn {
    let mut other = scene.clone();
    for (_, value) in &mut other.given {
        let Some((number, unit)) = value.split_once(' ') else { continue };
        let Some((_, unit, many)) = OTHER_UNITS.iter().find(|(listed, ..)| *listed == unit) else { continue };
        let number: f64 = number.parse().unwrap();
        *value = format!("{} {unit}", (number * many * 1e9).round() / 1e9);
    }
    other
}

/// What observers find of a scene: how many of them were there, and on what they disagree.
fn observed(table: &Table, kind: &str, seed: u64) -> (usize, Vec<String>) {
    let scene = draw(table, kind, seed);
    let questions = questions(table, &scene);
    let Ok(whole) = asked_all(&scene, &questions, &|file| file) else { return (0, Vec::new()) };
    let (mut observers, mut wrong) = (0, Vec::new());
    let mut compare = |who: &str,
                       other: Result<Solved, String>,
                       expected: &dyn Fn(&str) -> Option<f64>,
                       scale: &dyn Fn(&str) -> f64| match other {
        Ok(other) => {
            observers += 1;
            let found = |name: &str| other.value(name).map(|value| value / scale(name));
            wrong
                .extend(differing(&whole, &found, expected, &other).into_iter().map(|fault| format!("{who}: {fault}")));
        }
        // What is counted counter-clockwise has no place in a mirror.
        Err(refusal) if refusal.contains("counter-clockwise") => {}
        Err(refusal) => wrong.push(format!("{who}, of a scene that is solved otherwise: {refusal}")),
    };
    let same = |name: &str| whole.value(name);
    if let Some(moving) = shifted(&scene) {
        compare(
            "who moves",
            asked_all(&moving, &questions, &|file| file),
            &|name| for_moving(&scene, &whole, name),
            &|_| 1.0,
        );
    }
    if whole.file.contains("to the right") {
        compare("in a mirror", asked_all(&scene, &questions, &|file| to_the_other_side(&file)), &same, &|_| 1.0);
    }
    compare("in other units", asked_all(&in_other_units(&scene), &questions, &|file| file), &same, &|_| 1.0);
    for times in HEAVIER {
        if let Some(heavier) = heavier(&scene, times) {
            let who = format!("{times} times as heavy");
            compare(&who, asked_all(&heavier, &questions, &|file| file), &same, &|name| weighed(table, name, times));
        }
    }
    let wrong = wrong.into_iter().map(|fault| format!("{kind} {seed}: {fault}")).collect();
    (observers, wrong)
}

fn wrong(first: u64, each: u64) -> Vec<String> {
    let table = Table::read();
    let mut wrong = Vec::new();
    for kind in table.stages.iter().filter(|kind| only(&kind.name)) {
        let observe = |seed| {
            let observed = catch_unwind(AssertUnwindSafe(|| observed(&table, &kind.name, seed)));
            observed.unwrap_or_else(|_| (0, vec![format!("{} {seed}: a panic", kind.name)]))
        };
        let all: Vec<_> = (first..first + each).into_par_iter().map(observe).collect();
        let observers: usize = all.iter().map(|(observers, _)| observers).sum();
        println!("{:10} {observers} other observers of {each} scenes", kind.name);
        wrong.extend(all.into_iter().flat_map(|(_, wrong)| wrong));
    }
    wrong
}

#[test]
fn other_observers_agree_about_scenes() {
    let wrong = wrong(0, EACH);
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

/// `.ci/soak scenes` looks at others, from the seed `FIRST` on.
#[test]
#[ignore = "takes an hour"]
fn other_observers_agree_about_thousands_of_scenes() {
    let wrong = wrong(number("FIRST", 1_000), number("SCENES", 20_000).div_ceil(26));
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}
