//! No key is ignored: without it, or with another value, the equations of a scene are others, and its simulation with them, or the scene
//! is refused.

use std::collections::BTreeSet;

use momentous::fault::Source;
use momentous::problem::{compile, load};
use momentous::render::Renderer;
use rayon::prelude::*;

use super::draw::{Drawn, draw};
use super::end::{End, end};
use super::table::{Table, plain};

/// Scenes of each kind whose keys are taken away and changed.
const EACH: u64 = 6;

/// Keys that change no equation of some scene, with the reason.
const WITHOUT_EFFECT: &[(&str, &str)] = &[
    ("name", "what the stage is called"),
    ("called", "what it is called in sentences"),
    ("direction", "two ways to write one direction, or the one that holds without the key"),
    ("connected.trailing", "a body for which nothing is said hangs"),
    ("impact.duration", "only an average force, where it is asked, depends on it"),
    ("rotate.during", "a time that begins at zero; without a moment it does not matter how long the arm turns"),
    ("stream.stays", "a chain that comes down stays"),
    ("swing.way", "a swing goes up where nothing else is said"),
    ("thrust.mass", "the mass at the end, with and without a name of its own"),
];

/// The equations of a scene, whatever is asked; none where it is refused.
fn equations(scene: &Drawn, question: usize) -> Option<String> {
    let loaded = load(Source::new("scene.yaml", scene.file(question).as_str())).ok()?;
    let problem = compile(loaded, None).ok()?;
    let model = problem.model();
    Some(format!("{:?} {:?} {:?} {:?}", model.system, model.choices, model.impulses, model.literals))
}

/// The scene without each of its keys, and with each in every other way of the table: the stage or the body and the key, and the scene.
fn changes(table: &Table, scene: &Drawn) -> Vec<(String, Drawn)> {
    let mut changes = of_bodies(scene);
    for (stage, written) in scene.stages.iter().enumerate() {
        for (place, (key, value)) in written.keys.iter().enumerate() {
            let name = format!("{}.{}", written.kind, plain(key));
            let mut without = scene.clone();
            without.stages[stage].keys.remove(place);
            changes.push((name.clone(), without));
            let ways = table.kind(&written.kind).keys[key].iter().filter(|way| *way != value);
            for way in ways {
                let mut other = scene.clone();
                other.stages[stage].keys[place].1.clone_from(way);
                changes.push((name.clone(), other));
            }
        }
    }
    changes
}

/// The scene without the guide of its body or with one across it, and with no inertia or another.
fn of_bodies(scene: &Drawn) -> Vec<(String, Drawn)> {
    let mut changes = Vec::new();
    if let Some((body, _)) = &scene.guided {
        for guided in [None, Some((body.clone(), "y"))] {
            changes.push(("body.guide".to_owned(), Drawn { guided, ..scene.clone() }));
        }
    }
    if scene.inertia.is_some() {
        for inertia in [Some(""), Some(", inertia: 2*I_R")] {
            changes.push(("body.inertia".to_owned(), Drawn { inertia, ..scene.clone() }));
        }
    }
    changes
}

fn is_without_effect(key: &str) -> bool {
    let is = |(listed, _): &(&str, &str)| key == *listed || key.ends_with(&format!(".{listed}"));
    WITHOUT_EFFECT.iter().any(is)
}

#[test]
fn no_key_is_ignored() {
    let (table, renderer) = (Table::read(), Renderer::new(None).unwrap());
    let scenes: Vec<(&str, u64)> =
        table.stages.iter().flat_map(|kind| (0..EACH).map(|seed| (kind.name.as_str(), seed))).collect();
    let found = |(kind, seed): &(&str, u64)| {
        let scene = draw(&table, kind, *seed);
        let asked = (0..scene.questions.len()).find_map(|question| Some((question, equations(&scene, question)?)));
        let Some((question, whole)) = asked else { return Vec::new() };
        let is_known = |position: &usize| equations(&scene, *position).is_some();
        let known: Vec<_> =
            (0..scene.questions.len()).filter(is_known).map(|index| scene.questions[index].clone()).collect();
        let wrong = |(key, other): (String, Drawn)| {
            let changed = equations(&other, question)?;
            if changed == whole {
                return (!is_without_effect(&key)).then(|| format!("`{key}` is ignored:\n{}", other.file(question)));
            }
            // The laws have changed, and the simulation has to follow them in whatever can be asked; were it to pass a key over, they
            // would not agree any more.
            [other.asking(&known), other.file(question)].into_iter().find_map(|file| match end(&file, &renderer) {
                End::Fault(why) => Some(format!("`{key}`: {why}\n{file}")),
                End::Witnessed | End::Unwitnessed(_) | End::Refused(..) => None,
            })
        };
        changes(&table, &scene).into_iter().filter_map(wrong).collect::<Vec<_>>()
    };
    let found: BTreeSet<String> = scenes.par_iter().flat_map_iter(found).collect();
    assert!(found.is_empty(), "{}", found.into_iter().collect::<Vec<_>>().join("\n"));
}
