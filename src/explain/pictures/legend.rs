//! The legend of letters in figures, said where no name contains them.

use std::collections::BTreeSet;

use momentous_expr::Math;
use momentous_figure::Drawing;
use momentous_figure::Role;
use momentous_figure::Shape;

use super::labels::ORIGIN;
use super::labels::body_math;
use super::quantities::Quantities;
use momentous_scene::list;

/// Each letter is told in the caption of the first figure in which it stands for a body or a point.
pub(super) fn tell(quantities: &Quantities<'_>, drawings: &mut [Drawing]) {
    let names = names(quantities);
    let mut told: BTreeSet<&str> = BTreeSet::new();
    for drawing in drawings {
        let shown = names.iter().filter(|(letter, _)| is_named(drawing, &body_math(letter)));
        let new: Vec<&(String, String)> = shown.filter(|(letter, _)| told.insert(letter)).collect();
        let words: Vec<String> = new
            .iter()
            .map(|(letter, name)| {
                let parts = quantities.scene().division_of(letter);
                let shown = !parts.is_empty() && parts.iter().all(|part| is_named(drawing, &body_math(part)));
                let parts = || list(&parts.iter().map(|part| (*part).to_owned()).collect::<Vec<_>>());
                if shown { format!("{letter}: {} together", parts()) } else { format!("{letter}: {name}") }
            })
            .collect();
        if !words.is_empty() {
            drawing.caption = format!("{}. {}.", drawing.caption.trim_end_matches('.'), words.join(", "));
        }
    }
}

/// The letters that no name explains, each with what it stands for.
fn names(quantities: &Quantities<'_>) -> Vec<(String, String)> {
    let scene = quantities.scene();
    let instants = 1..=quantities.timeline.last();
    let bodies: BTreeSet<&str> = instants.flat_map(|instant| quantities.timeline.alive(instant)).collect();
    let bodies = bodies.into_iter().map(|body| (body.to_owned(), quantities.called(body)));
    let points = scene.points.iter().map(|(letter, point)| (letter.clone(), point.name.clone()));
    let mut names: Vec<(String, String)> = bodies.chain(points).collect();
    if names.iter().all(|(letter, _)| letter != ORIGIN) {
        names.push((ORIGIN.to_owned(), "the origin".to_owned()));
    }
    // A body that is called by its letter needs no more.
    let explains =
        |name: &str, letter: &str| name.split(|sign: char| !sign.is_alphanumeric()).any(|word| word == letter);
    names.retain(|(letter, name)| !explains(name, letter));
    names
}

/// Whether a body or a point of that name is in a figure.
fn is_named(drawing: &Drawing, name: &Math) -> bool {
    let is_own = |shape: &Shape| matches!(shape, Shape::Label { text, role: Role::Body, .. } if text == name);
    drawing.shapes.iter().any(is_own)
}
