//! The kind of an impact: elastic, inelastic or perfectly plastic, as its kinetic energies and velocities say.

use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::wrong::concept::ELASTIC_BY_SEPARATION;
use momentous_laws::wrong::concept::PLASTIC_BY_LOSS;
use momentous_model::Builder;
use momentous_scene::Stage;

use super::super::super::language::ask::Classify;
use super::super::super::reading::load::Loaded;
use super::super::equality::Equality;
use super::super::equality::Place;
use super::super::part::PartKind;
use super::super::part::Question;
use super::choice::ChoicePart;
use super::judgement::Case;
use super::judgement::Confusion;
use super::judgement::Judgement;
use super::judgement::Test;
use super::settled::stage;

/// The kinds of impact, in the order in which they are offered; a perfectly plastic one is inelastic, too.
const KINDS: [&str; 3] = ["elastic", "inelastic, but not perfectly", "perfectly plastic"];

/// What is taken for what, by the places of the kinds.
const CONFUSIONS: &[Confusion] = &[
    Confusion { chosen: 0, right: 1, mistake: &ELASTIC_BY_SEPARATION },
    Confusion { chosen: 2, right: 1, mistake: &PLASTIC_BY_LOSS },
];

/// Asks of which kind an impact is.
pub(crate) fn classify(loaded: &Loaded, ask: &Classify, builder: &mut Builder<'_>, path: &Path) -> Option<Question> {
    let index = stage(ask.stage.as_deref(), builder, path)?;
    let Some(Stage::Impact(impact)) = loaded.draft.scene.stages.get(index) else {
        let fault = Fault::new(Code::Value, format!("{} is not an impact", builder.phrase_of(index)));
        builder.fault(fault.help("name a stage that is an impact: `stage: hit`").at_path(path.key("classify")));
        return None;
    };
    let place = Place { stage: index, clock: None };
    let energies = builder.energies_of_impact(index)?;
    let keeps_energy = Equality::of(loaded, builder, place, energies);
    let apart = builder.parting_velocity(index);
    let together: Vec<Equality> =
        apart.into_iter().map(|difference| Equality::of(loaded, builder, place, [difference, Expr::zero()])).collect();
    let tests = |all: Vec<Equality>| all.into_iter().map(|equality| Test::new(equality, "")).collect::<Vec<_>>();
    let told = impact.restitution.is_some() || impact.elastic;
    let because = if told {
        [
            "e = 1: no kinetic energy is lost",
            "e lies between 0 and 1: the bodies separate, and some kinetic energy is lost",
        ]
    } else {
        ["no kinetic energy is lost", "the bodies separate, and some kinetic energy is lost"]
    };
    let cases = vec![
        Case::new(0, tests(vec![keeps_energy]), because[0]),
        Case::new(2, tests(together), "the bodies stay together (e = 0)"),
        Case::new(1, Vec::new(), because[1]),
    ];
    let question = format!("the kind of {}", builder.phrase_of(index));
    let mut undecided = cases.iter().flat_map(|case| &case.tests);
    let fault = undecided.find_map(|test| test.equality.undecidable(loaded, builder, &question));
    if let Some(fault) = fault {
        builder.fault(fault.at_path(path.key("classify")));
        return None;
    }
    let label = format!("Of what kind is {}?", builder.phrase_of(index));
    let choice = Judgement::new(&KINDS, cases).confused(CONFUSIONS);
    Some((label, PartKind::Choice(ChoicePart::Judged(Box::new(choice)))))
}
