//! Every kind of stage crossed with every place that must know it. The kinds are those of the published schema, so that a new one is
//! missing everywhere until it is written.

use std::collections::BTreeSet;
use std::path::Path;

use momentous::bank::{Bank, Seeds, audit, files_under};
use momentous::explain::{self, Audience, Block};
use momentous::fault::Source;
use momentous::problem::{Problem, Sampler, Worked, compile, json_schema, load};
use momentous::render::Renderer;
use momentous::scene::Stage;

use crate::blocks::blocks;
use crate::pages::language;

/// What the schema calls another word for a kind: for `moment`.
const OTHER_WORD: &str = "torque";

/// The keys that introduce stages.
fn kinds() -> Vec<String> {
    let kinds = json_schema().pointer("/$defs/Stage/oneOf").unwrap().as_array().unwrap();
    kinds.iter().map(|kind| kind["required"][0].as_str().unwrap().to_owned()).filter(|key| key != OTHER_WORD).collect()
}

/// A problem of the bank or a scene that is not in it, with the file it was read from.
struct Read {
    source: Source,
    problem: Problem,
}

impl Read {
    fn has(&self, kind: &str) -> bool {
        self.problem.loaded().draft.scene.stages.iter().any(|stage| stage.key() == kind)
    }

    /// Whether nothing else happens: what is seen of the problem is seen of the stage.
    fn has_only(&self, kind: &str) -> bool {
        self.problem.loaded().draft.scene.stages.iter().all(|stage| stage.key() == kind)
    }
}

fn all() -> Vec<Read> {
    let bank = Bank::in_folder(Path::new("problem_bank")).unwrap();
    let scenes = files_under(Path::new("tests/fixtures/pictures")).unwrap();
    let scenes = scenes.iter().map(|path| bank.open(&path.to_string_lossy()).unwrap());
    let sources = bank.select(&[]).unwrap().into_iter().chain(scenes);
    let read = |source: Source| Read { problem: compile(load(source.clone()).unwrap(), None).unwrap(), source };
    sources.map(read).collect()
}

/// Whether a variant of some form is so.
fn some_variant(problem: &Problem, is_so: impl Fn(Worked<'_>) -> bool) -> bool {
    (0..problem.forms().len()).any(|form| {
        let variant = Sampler::new(problem, form).unwrap().variant(1).unwrap();
        is_so(Worked::new(problem, &variant).unwrap())
    })
}

fn has_figure(worked: Worked<'_>) -> bool {
    let sections = explain::solution(worked, Audience::Everyone, explain::Detail::Full).sections;
    let is_figure = |block: &Block| matches!(block, Block::Figure(_));
    explain::situation(worked).is_some() || sections.iter().flat_map(|section| &section.blocks).any(is_figure)
}

/// What the examples of the language have, one example for each problem that is written out.
fn examples() -> BTreeSet<&'static str> {
    let whole = blocks(&language()).into_iter().filter(|block| block.language == "yaml");
    let loaded = whole.filter_map(|block| load(Source::new("language.yaml", &block.text)).ok());
    loaded.flat_map(|loaded| loaded.draft.scene.stages.iter().map(Stage::key).collect::<Vec<_>>()).collect()
}

#[test]
fn every_kind_of_stage_is_known_wherever_it_must_be() {
    let (all, examples, renderer) = (all(), examples(), Renderer::new(None).unwrap());
    let headings: String = language().lines().filter(|line| line.starts_with("## ")).collect();
    let kinds = kinds();
    let mut missing = Vec::new();
    for kind in &kinds {
        let having: Vec<&Read> = all.iter().filter(|read| read.has(kind)).collect();
        // Alone where there is such a problem: a figure may be that of another stage.
        let alone: Vec<&Read> = having.iter().copied().filter(|read| read.has_only(kind)).collect();
        let seen = if alone.is_empty() { &having } else { &alone };
        let phrase = |worked: Worked<'_>| {
            let scene = &worked.problem.loaded().draft.scene;
            let place = scene.stages.iter().position(|stage| stage.key() == kind);
            place.is_some_and(|place| !worked.problem.model().phrase(scene, place).is_empty())
        };
        let once = Seeds { drawn: 1, simulated: 1 };
        let witnessed =
            |read: &&Read| audit(&read.source, once, &renderer).forms.iter().any(|form| form.simulation.is_whole());
        for (place, is_known) in [
            (
                "src/scene/stage: what the author writes",
                Path::new("src/scene/stage").join(format!("{kind}.rs")).is_file(),
            ),
            ("src/model/stage: its equations", Path::new("src/model/stage").join(format!("{kind}.rs")).is_file()),
            ("src/model: its words", having.iter().any(|read| some_variant(&read.problem, phrase))),
            ("src/simulate: what judges its answers", having.iter().any(witnessed)),
            ("src/explain: its figure", seen.iter().any(|read| some_variant(&read.problem, has_figure))),
            ("docs/language: its section", headings.contains(&format!("`{kind}`"))),
            ("docs/language: an example", examples.contains(kind.as_str())),
            ("the bank or tests/fixtures/pictures: a problem", !having.is_empty()),
        ] {
            if !is_known {
                missing.push(format!("{place} is missing for `{kind}`"));
            }
        }
    }
    assert!(kinds.len() > 20, "{kinds:?}");
    assert!(missing.is_empty(), "{}", missing.join("\n"));
}
