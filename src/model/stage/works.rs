//! What does work on a body that is pushed, in words.

/// `only the rope and friction do work on the sledge`: the forces of those names, and weight and friction where they do.
pub(super) fn only<'a>(names: impl Iterator<Item = &'a str>, [weighs, rubs]: [bool; 2], body: &str) -> String {
    let others = [(weighs, "weight"), (rubs, "friction")].into_iter().filter(|(works, _)| *works);
    let mut workers: Vec<&str> = Vec::new();
    for worker in names.chain(others.map(|(_, other)| other)) {
        if !workers.contains(&worker) {
            workers.push(worker);
        }
    }
    match &workers[..] {
        [] => format!("nothing does work on {body}"),
        [only] => format!("only {only} does work on {body}"),
        [several @ .., last] => format!("only {} and {last} do work on {body}", several.join(", ")),
    }
}
