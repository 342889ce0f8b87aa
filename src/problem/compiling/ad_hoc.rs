//! A problem asked differently than its file does: values of the user's own, other quantities sought.

use std::collections::BTreeSet;

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_model::Name;
use momentous_model::PrintedGraph;
use momentous_model::QuantityKind;

use super::super::language::ask::Answered;
use super::super::language::ask::Ask;
use super::super::language::ask::Find;
use super::super::language::entries::Entries;
use super::super::language::given::Given;
use super::super::language::literal::Literal;
use super::super::language::text::Text;
use super::super::language::text::is_name;
use super::super::reading::load::Loaded;
use super::planned::Problem;

/// The same scene with other values and another question. Its text is left out, since it may no longer fit.
///
/// # Errors
/// A fault for each value that cannot be read, and where the problem has no such form.
pub fn ad_hoc(loaded: &Loaded, form: usize, set: &[(String, String)], find: &[String]) -> Result<Loaded, Vec<Fault>> {
    let mut changed = changed(loaded, form, set, find)?;
    changed.draft.text = Text::default();
    for question in &mut changed.questions {
        question.text = Text::default();
    }
    Ok(changed)
}

/// The same scene with other values, and its text, which says each of them: those for which it has no place stand at its end, but
/// for those that the sheet's graph prints. Where something else is sought, the story stays without the question of the form.
///
/// # Errors
/// A fault for each value that cannot be read, and where the problem has no such form.
pub fn typed(problem: &Problem, form: usize, set: &[(String, String)], find: &[String]) -> Result<Loaded, Vec<Fault>> {
    let mut changed = changed(problem.loaded(), form, set, find)?;
    let model = problem.model();
    let drawn =
        model.graph.iter().flat_map(PrintedGraph::symbols).map(|symbol| model.symbols.entry(symbol).name.clone());
    let mut told: BTreeSet<String> = drawn.collect();
    told.extend(changed.draft.text.printed_names());
    for question in &mut changed.questions {
        told.extend(question.text.printed_names());
        let untold = set.iter().map(|(name, _)| name).filter(|name| is_name(name) && !told.contains(*name));
        let untold: Vec<String> = untold.map(|name| format!("{{{{ {name} | named }}}}")).collect();
        if !untold.is_empty() {
            question.text = question.text.followed_by(Text::read(&format!("\n\nHere {}.", untold.join(", ")))?);
        }
    }
    Ok(changed)
}

fn changed(loaded: &Loaded, form: usize, set: &[(String, String)], find: &[String]) -> Result<Loaded, Vec<Fault>> {
    let mut changed = loaded.clone();
    let Some(question) = loaded.questions.get(form) else {
        return Err(vec![Fault::new(Code::UnknownName, "the problem has no such form")]);
    };
    let mut question = question.clone();
    let mut faults = Vec::new();
    let loaded_for_question = loaded.with(&question.given);
    let mut given: Vec<(String, Given)> =
        loaded_for_question.given.iter().map(|(name, given)| (name.to_owned(), given.clone())).collect();
    question.given = Entries::default();
    for (index, (name, text)) in set.iter().enumerate() {
        if set.iter().take(index).any(|(earlier, _)| earlier == name) {
            faults.push(Fault::new(Code::Duplicate, format!("`{name}` is set twice")).help("set it once"));
        }
        let literal = match Literal::read(text) {
            Ok(Some(literal)) => Given::Literal(literal),
            Ok(None) => {
                let fault = Fault::new(Code::Value, format!("`{text}` is not a value for `{name}`"));
                faults.push(fault.help(format!("write a number with its unit: `{name}=3 kg`")));
                continue;
            }
            Err(fault) => {
                faults.push(Fault {
                    message: format!("in the value of `{name}`: {}", fault.message),
                    within: None,
                    ..fault
                });
                continue;
            }
        };
        match given.iter_mut().find(|(listed, _)| listed == name) {
            Some((_, value)) => *value = literal,
            None => given.push((name.clone(), literal)),
        }
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    if !find.is_empty() {
        question.text = Text::default();
        question.ask = find.iter().map(|name| asked(&question.ask, name)).collect();
        question.path = Path::root();
    }
    let told = |name: &String| set.iter().any(|(listed, _)| listed == name);
    question.reveal.retain(|name| !told(name) && !find.contains(name));
    question.elsewhere.retain(|name| !told(name));
    changed.given = given.into_iter().collect::<Entries<Given>>();
    changed.questions = vec![question];
    Ok(changed)
}

/// The file's own way of asking for a quantity, or a plain one.
fn asked(parts: &[Ask], name: &str) -> Ask {
    let asked = parts.iter().find(|part| matches!(part, Ask::Find(find) if find.name() == name));
    asked.cloned().unwrap_or_else(|| {
        let is_direction = Name::parse(name).is_some_and(|name| matches!(name.kind, QuantityKind::Direction(_)));
        Ask::Find(Find {
            id: None,
            find: name.to_owned(),
            answered: Answered::Number,
            roots: None,
            unit: None,
            points: None,
            tolerance: None,
            figures: None,
            from: Some("+x".into()).filter(|_| is_direction),
            sense: Some(super::super::language::ask::Turn::CounterClockwise).filter(|_| is_direction),
            label: None,
            expect: Entries::default(),
        })
    })
}
