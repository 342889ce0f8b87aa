//! Checks of an author's words on common mistakes: `feedback` and `discriminate` name mistakes that exist, and tell no answer.

use std::collections::BTreeSet;

use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_fault::did_you_mean;
use momentous_laws::wrong;
use momentous_model::Model;

use super::super::compiling::planned::Form;
use super::super::reading::load::Loaded;

/// The faults of both keys.
pub(crate) fn check(loaded: &Loaded, model: &Model, forms: &[Form]) -> Vec<Fault> {
    let root = Path::root();
    let feedback = loaded.draft.feedback.names().map(|name| (name, root.key("feedback").name(name)));
    let listed = loaded.draft.discriminate.iter().enumerate();
    let listed = listed.map(|(index, name)| (name.as_str(), root.key("discriminate").index(index)));
    let mut faults: Vec<Fault> = feedback.chain(listed).filter_map(|(name, path)| unknown(name, path)).collect();
    let asked: BTreeSet<Symbol> = forms.iter().flat_map(Form::wanted).collect();
    for (name, text) in loaded.draft.feedback.iter() {
        let path = root.key("feedback").key(name);
        for placeholder in text.placeholders() {
            let message = match model.symbol_of(&placeholder.name) {
                Some(symbol) if asked.contains(&symbol) => {
                    format!("the feedback prints `{}`, which a form asks for", placeholder.name)
                }
                Some(symbol) if forms.iter().all(|form| form.told.contains(&symbol)) => continue,
                _ => format!("the feedback prints `{}`, which not every form gives", placeholder.name),
            };
            let help = "feedback may print only what every form gives";
            faults.push(Fault::new(Code::Text, message).help(help).at_path(path.clone()).within(placeholder.span));
        }
    }
    faults
}

fn unknown(name: &str, path: Path) -> Option<Fault> {
    if wrong::find(name).is_some() {
        return None;
    }
    let names: Vec<&str> = wrong::all().into_iter().flat_map(|(_, kinds)| kinds).map(|kind| kind.id).collect();
    let near = did_you_mean(name, names).map(|near| format!("did you mean `{near}`?"));
    let help = near.unwrap_or_else(|| "`momentous diagnose --list` lists them".to_owned());
    Some(Fault::new(Code::UnknownName, format!("there is no common mistake `{name}`")).help(help).at_path(path))
}
