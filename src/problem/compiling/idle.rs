//! Givens of which a problem makes no use.

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_fault::did_you_mean;
use momentous_model::Model;
use momentous_model::QuantityKind;
use momentous_solve::Condition;
use momentous_solve::Equation;

use super::super::language::known::Known;
use super::super::language::known::Origin;
use super::super::language::text::Text;
use super::super::reading::load::Loaded;
use super::form_draft::FormDraft;

/// A given that no equation, condition or text refers to is a slip of the pen.
pub(super) fn faults(
    loaded: &Loaded,
    asked_anew: bool,
    (model, known): (&Model, &[Known]),
    forms: &[FormDraft],
    require: &[Condition],
) -> Vec<Fault> {
    let mut used = model.mentioned();
    let conditions = forms.iter().flat_map(|form| &form.conditions).chain(require);
    used.extend(conditions.flat_map(|condition| [condition.left.symbols(), condition.right.symbols()]).flatten());
    used.extend(forms.iter().flat_map(|form| &form.counts).flat_map(Equation::symbols));
    used.extend(forms.iter().flat_map(FormDraft::mentioned));
    let worked_with = used.clone();
    let texts = std::iter::once(&loaded.draft.text).chain(loaded.questions.iter().map(|question| &question.text));
    let texts = texts.filter(|_| !asked_anew);
    used.extend(texts.flat_map(Text::placeholders).filter_map(|placeholder| model.symbol_of(&placeholder.name)));
    let names: Vec<&str> = used.iter().map(|symbol| model.symbols.entry(*symbol).name.as_str()).collect();
    // Asked anew, a problem may leave some of its own givens aside; that its text says a value that was typed makes no use of it.
    let aside = |known: &Known| asked_anew && loaded.draft.given.get(&known.name).is_some();
    // A quantity of the scene that must not matter may be one that no equation needs.
    let any = |known: &Known| matches!(known.origin, Origin::Any) && model.symbols.is_described(known.symbol);
    // A text may mention a value that no equation needs, but not under the name of a quantity that it is not.
    let misnamed = |known: &Known| {
        let advice = model.belongs_to_no_stage(known.symbol).or_else(|| of_nobody(loaded, model, known))?;
        (!worked_with.contains(&known.symbol)).then_some(advice)
    };
    let is_idle = |known: &Known| !used.contains(&known.symbol) || misnamed(known).is_some();
    let idle = known.iter().filter(|known| is_idle(known) && !aside(known) && !any(known));
    let fault = |known: &Known| {
        let fault = Fault::new(Code::UnknownName, format!("nothing in the scene uses `{}`", known.name));
        let near = || {
            let near = did_you_mean(&known.name, names.iter().copied());
            near.map_or_else(|| "remove it, or use it".to_owned(), |near| format!("did you mean `{near}`?"))
        };
        fault.help(misnamed(known).unwrap_or_else(near)).at_path(Path::root().key("given").name(known.name.as_str()))
    };
    idle.map(fault).collect()
}

/// Advice for the name of a quantity of a body at an instant, where there is no such body.
fn of_nobody(loaded: &Loaded, model: &Model, known: &Known) -> Option<String> {
    let (name, scene) = (model.name(known.symbol), &loaded.draft.scene);
    let is_of_motion = matches!(
        name.kind,
        QuantityKind::Velocity
            | QuantityKind::Speed
            | QuantityKind::Position
            | QuantityKind::KineticEnergy
            | QuantityKind::Momentum
    );
    let subject = name.subject.as_str();
    let somebody = subject.is_empty()
        || name.is_of_mass_centre()
        || scene.bodies.contains_key(subject)
        || scene.points.contains_key(subject);
    (is_of_motion && name.instant.is_some() && !somebody && !model.symbols.is_described(known.symbol)).then(|| {
        format!(
            "there is no body `{subject}`; name one of the scene, or choose a name that no quantity of a motion has"
        )
    })
}
