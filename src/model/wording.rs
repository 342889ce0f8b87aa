//! Phrases for stages and instants.

use std::borrow::Cow;

use momentous_scene::Scene;
use momentous_scene::Stage;

use super::stage::Description;
use super::stage::Span;

/// Nouns that are forces themselves: a force called by any other name is the force *of* that.
const FORCES: &[&str] = &[
    "attraction",
    "drag",
    "force",
    "friction",
    "gravity",
    "lift",
    "load",
    "pull",
    "push",
    "reaction",
    "repulsion",
    "resistance",
    "tension",
    "thrust",
    "traction",
    "weight",
];

/// A force by the author's name for it: `the pull of the cable` as it is, `the table` as `the force of the table`.
pub(crate) fn force_of(name: &str) -> Cow<'_, str> {
    let is_force = name.split_whitespace().any(|word| FORCES.contains(&word));
    if is_force { name.into() } else { format!("the force of {name}").into() }
}

const ORDINALS: &[&str] =
    &["first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth"];

/// One of several, counted from 1: `the second bounce`, `bounce 12`.
pub(super) fn counted(number: usize, noun: &str) -> String {
    match number.checked_sub(1).and_then(|before| ORDINALS.get(before)) {
        Some(ordinal) => format!("the {ordinal} {noun}"),
        None => format!("{noun} {number}"),
    }
}

/// A stage as a noun phrase: `the impact`; `the second impact` where there are several.
pub(super) fn stage(scene: &Scene, index: usize) -> String {
    let Some(entry) = scene.stages.get(index) else { return "the stage".into() };
    let noun = Description::of(scene, entry).noun;
    let alike = |stage: &&Stage| Description::of(scene, stage).noun == noun;
    let before = scene.stages.iter().take(index).filter(alike).count();
    if scene.stages.iter().filter(alike).count() < 2 {
        return format!("the {noun}");
    }
    counted(before + 1, noun)
}

/// When an instant is, as an adverbial phrase: in the author's words where there are some.
pub(super) fn when(scene: &Scene, instant: usize) -> String {
    if let Some(words) = instant.checked_sub(1).and_then(|index| scene.instants.get(index)?.words()) {
        return words.to_owned();
    }
    let after = instant.checked_sub(2).and_then(|index| Some((index, scene.stages.get(index)?)));
    let before = instant.checked_sub(1).and_then(|index| Some((index, scene.stages.get(index)?)));
    let (side, index, entry) = match (after, before) {
        (Some((index, entry)), _) => (1, index, entry),
        (None, Some((index, entry))) => (0, index, entry),
        (None, None) => return "at the instant considered".into(),
    };
    let phrase = stage(scene, index);
    match Description::of(scene, entry).ends {
        Span::Sudden => format!("{} {phrase}", ["just before", "just after"][side]),
        // Where nothing else happens, it need not be said of what it is the end.
        Span::Lasting if scene.stages.len() == 1 => ["at the start", "at the end"][side].into(),
        Span::Lasting => format!("{} {phrase}", ["at the start of", "at the end of"][side]),
        Span::Around => format!("{} {phrase}", ["before", "after"][side]),
        Span::With(what) => format!("with {what} arriving"),
        Span::Own(words) => words[side].into(),
    }
}

/// Advice on how to write a quantity that several stages have.
pub(super) fn of_several_stages(names: impl IntoIterator<Item = String>) -> String {
    format!("several stages have this quantity: write {}", quoted(names, " or "))
}

/// Names in quotation marks, with a conjunction between them.
pub(super) fn quoted(names: impl IntoIterator<Item = String>, conjunction: &str) -> String {
    names.into_iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(conjunction)
}

/// The reason why momentum is conserved in a short impact of two bodies; `line` says along which, as in ` along x`.
pub(crate) fn only_between([one, other]: [&str; 2], line: &str) -> String {
    format!(
        "the impulses that {one} and {other} exert on each other cancel, and in the short impact any other{line} is negligible"
    )
}

/// The reason why only the impulse of a contact counts for one of its bodies.
pub(crate) fn only_contact(name: &str) -> String {
    format!("in the short impact, any impulse on {name} alone but that of the contact is negligible")
}
