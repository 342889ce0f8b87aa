//! What is missing is told, or its type does not let it be missing. Where a number or an empty text stands in its place
//! nevertheless, these lists say what that means.

use super::{Source, Violation, listed, sources};

/// Files that take 0 or 1 for a number that is missing.
const NUMBERS: &[(&str, &str)] = &[
    ("src/exercise/calls/simulators/collision.rs", "a motion along a line has one component"),
    (
        "src/exercise/calls/simulators/compared.rs",
        "a motion along a line has one component; a method without a setting",
    ),
    ("src/exercise/calls/simulators/restitution.rs", "a motion along a line has one component"),
    ("src/explain/pictures/arm.rs", "what is not told is sketched, without a number"),
    ("src/explain/pictures/sheet/ramp.rs", "arrows of one body are compared with each other only"),
    ("src/explain/pictures/sheet/ride.rs", "what is not told is sketched, without a number"),
    ("src/explain/pictures/sheet/swing.rs", "arrows of one body are compared with each other only"),
    ("src/export/moodle/answer.rs", "the nearest of a table of fractions"),
    ("src/figure/force_plot.rs", "beside its curve a force is none"),
    ("src/grade/statistics.rs", "nobody has answered"),
    ("src/simulate/methods/kind.rs", "a method without a setting"),
    ("src/simulate/methods/rapier.rs", "a vector of fewer dimensions has no part along others"),
    ("src/simulate/scene/bounces.rs", "places and times that nobody tells are counted from the start"),
    ("src/simulate/scene/impulsive.rs", "how an impulse grows with the time does not depend on the size of the force"),
    ("src/simulate/scene/stage/central.rs", "a velocity of which one component is told has no other"),
    ("src/simulate/scene/stage/impact.rs", "what does not move has no mass and no energy"),
    ("src/simulate/scene/stage/interact.rs", "what does not move has no mass and no share"),
    ("src/simulate/scene/stage/separate.rs", "what does not move has no mass and no energy"),
    ("src/simulate/scene/stage/spring.rs", "the force is the spring that was made first"),
    ("src/simulate/scene/stage/swing.rs", "what is let go is at rest"),
    ("src/simulate/scene/state.rs", "a clock that nobody sets begins at zero"),
    ("src/simulate/scene/touch.rs", "the force is the spring that was made first"),
    ("src/simulate/scene/values.rs", "the motion does not depend on the mass"),
    ("src/simulate/sweep.rs", "a method without a setting"),
    ("src/solve/structure/sample.rs", "what no equation contains may have any value"),
    ("src/witness/choices.rs", "a surface that does not move"),
    ("src/witness/together.rs", "nothing acts from outside; a motion without that axis"),
    ("src/witness/turning.rs", "a motion without that axis"),
    ("src/witness/worlds.rs", "a table that is never empty"),
];

/// Files that take nothing for a part of a text or a list that is not there.
const PARTS: &[(&str, &str)] = &[
    ("src/exercise/submission/mod.rs", "places that it noted itself"),
    ("src/grade/read/formula/lexer.rs", "places of tokens that it read"),
    ("src/grade/read/formula/names.rs", "behind the last letter nothing stands"),
    ("src/grade/read/formula/resolve.rs", "places of letters that it read"),
    ("src/grade/read/unit.rs", "the place of a fault in the text"),
    ("src/problem/reading/document.rs", "places that the reader of YAML tells"),
    ("src/problem/reading/position.rs", "places that the reader of YAML tells"),
    ("src/render/markdown.rs", "places that the reader of Markdown tells"),
    ("src/solve/replay/outcome.rs", "places of a replay that it noted itself"),
];

#[test]
fn no_number_stands_silently_for_what_is_missing() {
    hold(NUMBERS, &|line| line.contains("unwrap_or(0.0)") || line.contains("unwrap_or(1.0)"));
}

#[test]
fn no_text_stands_silently_for_a_part_that_is_not_there() {
    hold(PARTS, &is_part);
}

/// A part of a text or a list by its places, or nothing: `text.get(start..end).unwrap_or_default()`.
fn is_part(line: &str) -> bool {
    let default = line.find(".unwrap_or_default()").unwrap_or(0);
    line.find(".get(").is_some_and(|at| at < default && line[at..default].contains(".."))
}

/// Only the files of the list have such lines, and each of them has.
fn hold(list: &[(&str, &str)], breaks: &dyn Fn(&str) -> bool) {
    let broken = |source: &Source| -> Vec<Violation> {
        let code = source.text.split("#[cfg(test)]").next().unwrap_or_default();
        let lines = code.lines().enumerate().filter(|(_, line)| breaks(line));
        let rule = |line: &str| format!("takes something for what is missing: {}", line.trim());
        lines.map(|(at, line)| Violation { file: source.file.clone(), line: at + 1, rule: rule(line) }).collect()
    };
    let all = sources(&["src"]);
    let (known, others): (Vec<_>, Vec<_>) =
        all.iter().partition(|source| list.iter().any(|(file, _)| *file == source.file));
    let found: Vec<Violation> = others.into_iter().flat_map(broken).collect();
    assert!(
        found.is_empty(),
        "\n{}\nLet the type say that it is there, or tell who asks that it is not.\n",
        listed(&found)
    );
    for (file, what) in list {
        let is_used = known.iter().any(|source| source.file == *file && !broken(source).is_empty());
        assert!(is_used, "{file} has no such line ({what}): take it from the list");
    }
}

#[test]
fn what_is_taken_for_the_missing_is_noticed() {
    assert!(is_part("let rest = text.get(at + 1..).unwrap_or_default();"));
    assert!(!is_part("let forms = fields.get(name).unwrap_or_default(); 0..9"));
}
