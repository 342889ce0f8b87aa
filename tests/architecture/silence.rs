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
    ("src/explain/pictures/sheet/ride.rs", "what is not told is sketched, without a number"),
    ("src/figure/force_plot.rs", "beside its curve a force is none"),
    ("src/grade/statistics.rs", "nobody has answered"),
    ("src/simulate/methods/kind.rs", "a method without a setting"),
    ("src/simulate/methods/rapier.rs", "a vector of fewer dimensions has no part along others"),
    ("src/simulate/scene/bounces.rs", "places and times that nobody tells are counted from the start"),
    ("src/simulate/scene/impulsive.rs", "how an impulse grows with the time does not depend on the size of the force"),
    ("src/simulate/scene/stage/spring.rs", "the force is the spring that was made first"),
    ("src/simulate/scene/stage/swing.rs", "what is let go is at rest"),
    ("src/simulate/scene/state.rs", "a clock that nobody sets begins at zero"),
    ("src/simulate/scene/touch.rs", "the force is the spring that was made first"),
    ("src/simulate/scene/values.rs", "the motion does not depend on the mass"),
    ("src/simulate/sweep.rs", "a method without a setting"),
    ("src/solve/structure/sample.rs", "what no equation contains may have any value"),
    ("src/witness/together.rs", "nothing acts from outside; a motion without that axis"),
    ("src/witness/turning.rs", "a motion without that axis"),
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

/// Files, and rooms, that take what is empty for what is not there, other than in [`PARTS`].
const DEFAULTS: &[(&str, &str)] = &[
    ("src/bank/course.rs", "a course without settings has the usual letters"),
    ("src/bank/repeat.rs", "an answer that is not given"),
    ("src/cli/", "a column or a word that stays empty"),
    ("src/course/", "a field that is left empty"),
    ("src/exercise/", "a field or an answer that is left empty; a number without a unit; a course without a secret"),
    ("src/explain/checking/energy.rs", "energies without numbers"),
    ("src/explain/lines.rs", "what comes from no line, and what is divided by nothing"),
    ("src/explain/pictures/offered_graph.rs", "a motion along a line has no letter"),
    ("src/explain/pictures/words.rs", "a sentence that need not be said"),
    ("src/explain/sections/answers.rs", "a place among all orders"),
    ("src/explain/terms/display.rs", "no letter is left open; terms whose dimensions were judged before"),
    ("src/explain/working/derivation.rs", "what is found from no line"),
    ("src/explain/working/steps.rs", "no letter is left open"),
    ("src/export/", "a form, a seed or a caption that there is not; cells of a row that is too short"),
    ("src/expr/testing.rs", "names of tests"),
    ("src/figure/angular_diagram.rs", "an arrow without a length"),
    ("src/figure/extent.rs", "nothing is drawn"),
    ("src/figure/momentum_diagram.rs", "no surface is drawn"),
    ("src/figure/panels.rs", "nothing is drawn"),
    ("src/figure/place.rs", "nothing is drawn"),
    ("src/figure/situation/space.rs", "a leg without a length"),
    ("src/figure/situation/swing.rs", "an arrow without a length"),
    ("src/grade/frequent.rs", "an answer without a diagnosis"),
    ("src/grade/judge/vector.rs", "an answer without a unit"),
    ("src/grade/points.rs", "bounds that are numbers"),
    ("src/grade/read/calculation.rs", "an answer without a unit"),
    ("src/grade/read/components.rs", "an answer without a unit"),
    ("src/grade/read/formula/lexer.rs", "behind the last sign stands nothing"),
    ("src/grade/read/formula/resolve.rs", "the only reading of a word"),
    ("src/grade/read/interval.rs", "an open end; a name without an index"),
    ("src/grade/read/numeral.rs", "the first piece of a text"),
    ("src/grade/read/vector.rs", "an answer without a unit"),
    ("src/model/collision.rs", "a name that stands at no place of the file"),
    ("src/model/lib.rs", "a term whose dimension is judged where it is stated"),
    ("src/model/stage/flight.rs", "a slope that has a fault already"),
    ("src/problem/compiling/compile.rs", "what may be anything needs no unit"),
    ("src/problem/compiling/planned.rs", "the only form has no name"),
    ("src/problem/compiling/regimes.rs", "numbers without a solution"),
    ("src/problem/deciding/offered.rs", "numbers that were refused; numbers of somebody's own have no seed"),
    ("src/problem/language/form.rs", "the only form has no name and no text of its own"),
    ("src/problem/language/given.rs", "a number without a unit"),
    ("src/problem/questions/equality/mod.rs", "a stage that does not say how long it lasts"),
    ("src/problem/questions/pictures/graph_read.rs", "a sense without words"),
    ("src/problem/reading/check.rs", "what cannot be read has a fault already"),
    ("src/problem/reading/document.rs", "a file without lines"),
    ("src/problem/reading/load.rs", "a text without faults"),
    ("src/problem/reading/shape.rs", "no key is required"),
    ("src/problem/sampling/sampler.rs", "nothing is solved before, and nothing is weighed"),
    ("src/problem/sampling/say.rs", "behind the last word nothing stands"),
    ("src/problem/sampling/stream.rs", "a course without a secret; a word of a block"),
    ("src/quantity/decimal.rs", "digits that it wrote itself"),
    ("src/quantity/dimension_name.rs", "exponents that fit a dimension fit a unit"),
    ("src/render/latex.rs", "a link that was opened"),
    ("src/render/markdown.rs", "places that the reader of Markdown tells"),
    ("src/render/markup.rs", "an equation without a number"),
    ("src/render/mathml.rs", "an element without children"),
    ("src/render/press.rs", "fonts that are inside, as a test says"),
    ("src/render/templates.rs", "a format without a style; a template without a name"),
    ("src/render/typst.rs", "a link or a code that was opened"),
    ("src/simulate/scene/mod.rs", "a run that moves nothing"),
    ("src/simulate/scene/stage/by_hand.rs", "a test of what moves nothing"),
    ("src/store/", "a hint on the whole sheet; an address without a question mark"),
    ("src/pages/", "a field that is left empty"),
    ("src/web/", "a header that is not there; nothing that is watched"),
    ("src/course_pages/", "a field that is left empty; a clock before 1970"),
    ("src/witness/trial.rs", "what is no expression has no parts"),
];

#[test]
fn no_number_stands_silently_for_what_is_missing() {
    hold(NUMBERS, &|line| line.contains("unwrap_or(0.0)") || line.contains("unwrap_or(1.0)"));
}

#[test]
fn no_text_stands_silently_for_a_part_that_is_not_there() {
    hold(PARTS, &is_part);
}

#[test]
fn nothing_stands_silently_for_what_is_not_there() {
    hold(DEFAULTS, &|line| line.contains(".unwrap_or_default()") && !is_part(line));
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
        all.iter().partition(|source| list.iter().any(|(file, _)| is_in(&source.file, file)));
    let found: Vec<Violation> = others.into_iter().flat_map(broken).collect();
    assert!(
        found.is_empty(),
        "\n{}\nLet the type say that it is there, or tell who asks that it is not.\n",
        listed(&found)
    );
    for (file, what) in list {
        let is_used = known.iter().any(|source| is_in(&source.file, file) && !broken(source).is_empty());
        assert!(is_used, "{file} has no such line ({what}): take it from the list");
    }
}

/// Whether a file is the one that is listed, or lies in the room that is.
fn is_in(file: &str, listed: &str) -> bool {
    file == listed || listed.ends_with('/') && file.starts_with(listed)
}

#[test]
fn what_is_taken_for_the_missing_is_noticed() {
    assert!(is_part("let rest = text.get(at + 1..).unwrap_or_default();"));
    assert!(!is_part("let forms = fields.get(name).unwrap_or_default(); 0..9"));
}
