//! What does work on a body that is pushed, in words.

use momentous_scene::list;

/// `only the rope and friction do work on the sledge`: the forces of those names, and weight and friction where they do.
pub(super) fn only<'a>(names: impl Iterator<Item = &'a str>, [weighs, rubs]: [bool; 2], body: &str) -> String {
    let others = [(weighs, "weight"), (rubs, "friction")].into_iter().filter(|(works, _)| *works);
    let mut workers: Vec<&str> = Vec::new();
    for worker in names.chain(others.map(|(_, other)| other)) {
        if !workers.contains(&worker) {
            workers.push(worker);
        }
    }
    let workers_in_words = list(&workers);
    match workers.len() {
        0 => format!("nothing does work on {body}"),
        1 => format!("only {workers_in_words} does work on {body}"),
        _ => format!("only {workers_in_words} do work on {body}"),
    }
}
