//! What a text must tell and must not tell: every drawn number that the solution needs, and nothing that is asked.

use std::collections::BTreeSet;

use crate::expr::Symbol;
use crate::fault::Code;
use crate::fault::Fault;
use crate::fault::Path;
use crate::model::Model;

use super::known::Known;
use super::load::Loaded;
use super::planned::Form;
use super::text::Text;

/// The faults of one form's text.
pub(super) fn check(loaded: &Loaded, model: &Model, known: &[Known], form: &Form) -> Vec<Fault> {
    let story = Path::root().key("text");
    let texts = [(story.clone(), &loaded.text), (form.question.path.key("text"), &form.question.text)];
    let asked: BTreeSet<Symbol> = form.wanted().collect();
    let mut faults = Vec::new();
    let mut printed = BTreeSet::new();
    let mut looked_at: Option<&Text> = None;
    for (path, text) in texts {
        if looked_at.is_some_and(|before| std::ptr::eq(before, text)) {
            continue;
        }
        looked_at = Some(text);
        for placeholder in text.placeholders() {
            let Some(symbol) = model.symbol_of(&placeholder.name) else { continue };
            printed.insert(symbol);
            // The symbol alone tells nothing.
            if !placeholder.filter.tells() {
                continue;
            }
            if asked.contains(&symbol) {
                let fault = Fault::new(Code::Text, format!("the text prints `{}`, which is asked", placeholder.name));
                let help = "leave it out of the text of this form, or ask for something else";
                faults.push(fault.help(help).at_path(path.clone()).within(placeholder.span));
            } else if !form.told.contains(&symbol) && !solved_from_given(form, symbol) {
                let message = format!("the text prints `{}`, which this form does not give", placeholder.name);
                let help = format!("write `reveal: [{}]` to have it solved first and then given", placeholder.name);
                faults.push(Fault::new(Code::Text, message).help(help).at_path(path.clone()).within(placeholder.span));
            }
        }
    }
    let needed = form.needed();
    let revealed = form.reveal.iter().map(|reveal| (reveal.name.as_str(), reveal.symbol));
    let drawn = known.iter().filter(|known| known.origin.is_drawn()).map(|known| (known.name.as_str(), known.symbol));
    for (name, symbol) in drawn.chain(revealed) {
        if needed.contains(&symbol) && !printed.contains(&symbol) {
            let message = format!("the text never prints `{name}`, which the solution needs");
            let help = format!("put `{{{{ {name} }}}}` where the reader should learn it");
            faults.push(Fault::new(Code::Text, message).help(help).at_path(story.clone()));
        }
    }
    faults
}

/// Whether a quantity follows from what is told without being asked: a given that is an expression of others.
fn solved_from_given(form: &Form, symbol: Symbol) -> bool {
    form.solver.leaves().iter().any(|leaf| leaf.audit.plan.steps.iter().any(|step| step.unknowns.contains(&symbol)))
}
