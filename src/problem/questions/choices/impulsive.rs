//! Whether a force is impulsive, answered from the scene.

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_fault::did_you_mean;
use momentous_laws::wrong::concept;
use momentous_model::Agent;
use momentous_model::Builder;
use momentous_model::ContactWeight;
use momentous_model::Impulse;
use momentous_model::Reason;
use momentous_solve::Condition;
use momentous_solve::Relation;

use super::super::super::language::ask::Impulsive;
use super::super::part::Question;
use super::settled::stage;
use super::settled::yes_or_no;

/// Forces that never have time to act in a short impact, whatever the scene.
const ORDINARY: &[(&str, &str)] = &[
    ("weight", "it stays as large as before, so its impulse is negligible in so short a contact"),
    ("gravity", "it stays as large as before, so its impulse is negligible in so short a contact"),
    ("friction", "it is bounded by the ordinary normal force, so in the short contact its impulse is negligible"),
    ("normal force", "nothing impulsive presses the body into the ground, so it hardly changes"),
    ("spring force", "it depends on the spring's length, which hardly changes during the short contact"),
    ("air resistance", "it stays small during the short contact, so its impulse is negligible"),
];

/// Whether a force is impulsive in a stage.
pub(crate) fn impulsive(
    ask: &Impulsive,
    builder: &mut Builder<'_>,
    path: &Path,
    conditions: &mut Vec<Condition>,
) -> Option<Question> {
    let stage = stage(ask.stage.as_deref(), builder, path)?;
    conditions.extend(is_weak(ask, builder, stage));
    let force = ask.impulsive.trim();
    let phrase = builder.phrase_of(stage);
    let bare = force.trim_start_matches("the ");
    let acts = |impulse: &&Impulse| {
        let named = impulse.called.trim_start_matches("the ");
        let touches = matches!(&impulse.by, Agent::Body(other) if builder.name_of(other) == bare);
        impulse.stage == stage && (named == bare || touches || bare == "contact force")
    };
    let from_scene = builder.impulses().iter().find(acts).map(|impulse| impulse.impulsive);
    let ordinary = ORDINARY.iter().find(|(name, _)| *name == bare);
    let verdict = match (ordinary, from_scene) {
        (Some((_, why)), _) => (false, (*why).to_owned()),
        (None, Some(true)) => {
            (true, "it becomes very large for a very short time, so its impulse is not negligible".into())
        }
        (None, Some(false)) => (false, "it stays of ordinary size for an ordinary time".into()),
        (None, None) => {
            let known: Vec<&str> = builder
                .impulses()
                .iter()
                .filter(|impulse| impulse.stage == stage)
                .map(|impulse| impulse.called.as_str())
                .collect();
            let all: Vec<&str> = ORDINARY.iter().map(|row| row.0).chain(known).collect();
            let help = did_you_mean(bare, all.iter().copied()).map(|near| format!("did you mean `{near}`?"));
            let help = help.unwrap_or_else(|| format!("the forces here are: {}", all.join(", ")));
            let fault = Fault::new(Code::UnknownName, format!("no force called `{force}` acts in {phrase}"));
            builder.fault(fault.help(help).at_path(path.key("impulsive")));
            return None;
        }
    };
    let behind = Some(if verdict.0 { &concept::IMPULSIVE_AS_ORDINARY } else { &concept::ORDINARY_AS_IMPULSIVE });
    let owner = ask.on.as_ref().map(|body| builder.name_of(body));
    let named = impulsive_force(force, from_scene == Some(true), owner.as_deref());
    Some((format!("Is {named} impulsive during {phrase}?"), yes_or_no(verdict, behind)))
}

/// The tests by which a force is too weak to be impulsive: the impulse of weight is small where it is given how long the contact
/// lasts.
fn is_weak(ask: &Impulsive, builder: &mut Builder<'_>, stage: usize) -> Vec<Condition> {
    if !["weight", "gravity"].contains(&ask.impulsive.trim().trim_start_matches("the ")) {
        return Vec::new();
    }
    let meant =
        |weight: &&ContactWeight| weight.stage == stage && ask.on.as_ref().is_none_or(|body| *body == weight.on);
    let weights: Vec<ContactWeight> = builder.weights().iter().filter(meant).cloned().collect();
    let weak = |weight: ContactWeight| {
        let [weight, change] = weight.squares();
        builder.compare(weight, Relation::Less, change, Reason::WeightNotSmall)
    };
    weights.into_iter().map(weak).collect()
}

/// A force as the subject of a sentence: what gives an impulse, such as a bat, is not itself a force.
fn impulsive_force(force: &str, is_giver: bool, owner: Option<&str>) -> String {
    let bare = ["gravity", "friction", "air resistance"].contains(&force) || force.starts_with("the ");
    let named = if bare { force.to_owned() } else { format!("the {force}") };
    let is_giver = is_giver && !force.contains("force") && !force.contains("contact");
    let named = if is_giver { format!("the force of {named}") } else { named };
    match owner {
        Some(owner) if force == "weight" => format!("{named} of {owner}"),
        Some(owner) => format!("{named} on {owner}"),
        None => named,
    }
}
