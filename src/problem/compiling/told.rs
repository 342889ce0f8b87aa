//! Checks of a text: it must tell every number that the solution needs, drawn or not, and nothing that is asked.

use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::geometry;
use momentous_laws::kinematics;
use momentous_model::Model;
use momentous_model::PrintedGraph;
use momentous_quantity::Decimal;
use momentous_quantity::Quantity;
use momentous_quantity::Unit;
use momentous_solve::Equation;
use momentous_solve::Statement;

use super::super::language::given::Given;
use super::super::language::known::Known;
use super::super::language::known::Origin;
use super::super::language::text::Placeholder;
use super::super::language::text::Text;
use super::super::questions::choices::choice::ChoicePart;
use super::super::questions::part::Part;
use super::super::questions::part::PartKind;
use super::super::reading::load::Loaded;
use super::super::reading::numerals::goes_without_saying;
use super::super::reading::numerals::tells;
use super::any;
use super::graph_told;
use super::planned::Form;
use super::planned::Problem;
use super::regimes::Leaf;

/// The faults of one form's text.
pub(crate) fn check(loaded: &Loaded, model: &Model, form: &Form) -> Vec<Fault> {
    let story = Path::root().key("text");
    let texts = [(story.clone(), &loaded.draft.text), (form.question.path.key("text"), &form.question.text)];
    let asked = asked(loaded, model, form);
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
                let fault =
                    Fault::new(Code::Text, format!("the text prints `{}`, which is asked for", placeholder.name));
                let help = "remove it from the text of this form, or ask for something else";
                faults.push(fault.help(help).at_path(path.clone()).within(placeholder.span));
            } else if let Some(fault) = without_a_value("the text", model, form, placeholder) {
                faults.push(fault.at_path(path.clone()).within(placeholder.span));
            } else if !form.told.contains(&symbol) && !solved_from_given(form, symbol) {
                let message = format!("the text prints `{}`, which this form does not give", placeholder.name);
                let help = format!("write `reveal: [{}]` to have it solved first and then given", placeholder.name);
                faults.push(Fault::new(Code::Text, message).help(help).at_path(path.clone()).within(placeholder.span));
            }
        }
    }
    if let Some(graph) = &model.graph {
        printed.extend(graph.symbols());
        faults.extend(graph_told::check(model, form, graph));
    }
    faults.extend(form.parts.iter().enumerate().filter_map(|(index, part)| {
        let PartKind::Choice(ChoicePart::Offered(offer)) = &part.kind else { return None };
        let open = |placeholder| without_a_value("an option", model, form, placeholder);
        let fault = offer.texts().flat_map(Text::placeholders).find_map(open)?;
        Some(fault.at_path(form.question.path.key("ask").index(index).key("options")))
    }));
    faults.extend(form.question.hints.iter().filter_map(|(path, hint)| lost(model, form, path, hint)));
    for (index, reveal) in form.reveal.iter().enumerate() {
        if let Some(open) = any::behind(model, form, reveal.symbol) {
            let message = format!(
                "the form reveals `{}`, which depends on `{}`, and that may be anything",
                reveal.name, open.name
            );
            let fault = Fault::new(Code::Text, message).help(format!("give `{}` a value", open.name));
            faults.push(fault.at_path(form.question.path.key("reveal").index(index)));
        }
    }
    let needed = form.needed();
    let revealed = form.reveal.iter().map(|reveal| (reveal.name.as_str(), reveal.symbol));
    let prose = prose(loaded, form);
    let fixed = |known: &&Known| match &known.origin {
        Origin::Drawn(_) => true,
        Origin::Fixed(value) => is_given(loaded, known) && !is_said(&prose, value, &known.unit),
        Origin::Any => false,
    };
    let given = form.known.iter().filter(fixed).map(|known| (known.name.as_str(), known.symbol));
    for (name, symbol) in given.chain(revealed) {
        if needed.contains(&symbol) && !printed.contains(&symbol) {
            let message = format!("the text never prints `{name}`, which the solution needs");
            let help = format!("put `{{{{ {name} }}}}` where the reader should learn it");
            faults.push(Fault::new(Code::Text, message).help(help).at_path(story.clone()));
        }
    }
    faults.extend(untold_expressions(loaded, model, form, &printed, &prose));
    faults
}

/// The faults of givens such as `1/3` or `sqrt(2)/2`, which no drawn value enters and which the sheet tells nowhere.
fn untold_expressions<'a>(
    loaded: &'a Loaded,
    model: &'a Model,
    form: &'a Form,
    printed: &'a BTreeSet<Symbol>,
    prose: &str,
) -> impl Iterator<Item = Fault> + 'a {
    let bare = |text: &str| text.split_whitespace().collect::<String>();
    let said = bare(prose);
    let is_constant = |symbol: Symbol| {
        let literals: BTreeSet<Symbol> = model.literals.iter().map(|(symbol, _)| *symbol).collect();
        model.stated(symbol).is_some_and(|value| value.symbols().is_subset(&literals))
    };
    let is_used = |symbol: Symbol| {
        let mut steps = form.solver.leaves().iter().flat_map(Leaf::answer_steps);
        steps.any(|step| step.unknowns.contains(&symbol))
    };
    loaded.given.iter().filter_map(move |(name, given)| {
        let Given::Expression(text) = given else { return None };
        let symbol = model.symbol_of(name)?;
        if printed.contains(&symbol) || said.contains(&bare(text)) || !is_constant(symbol) || !is_used(symbol) {
            return None;
        }
        let message = format!("the text never prints `{name}`, which the solution needs");
        let help = format!("put `{{{{ {name} }}}}` where the reader should learn it");
        Some(Fault::new(Code::Text, message).help(help).at_path(Path::root().key("text")))
    })
}

/// The fault of a placeholder that needs a value, or a formula in its place, where the quantity depends on what may be anything.
fn without_a_value(
    speaker: &str,
    model: &Model,
    form: &Form,
    Placeholder { name, filter, .. }: &Placeholder,
) -> Option<Fault> {
    let symbol = model.symbol_of(name).filter(|_| filter.needs_value())?;
    let by_formula = form.by_formula.contains(&symbol);
    if by_formula && filter.takes_formula() {
        return None;
    }
    if form.is_any(symbol) {
        let fault = Fault::new(Code::Text, format!("{speaker} prints `{name}`, which may be anything"));
        return Some(fault.help(format!("print its symbol: `{{{{ {name} | symbol }}}}`, or give it a value")));
    }
    let open = any::behind(model, form, symbol)?;
    let message = format!("{speaker} prints `{name}`, which depends on `{}`, and that may be anything", open.name);
    let formula = if by_formula { format!("its formula with `{{{{ {name} }}}}`, ") } else { String::new() };
    let help = format!("print {formula}its symbol with `{{{{ {name} | symbol }}}}`, or give `{}` a value", open.name);
    Some(Fault::new(Code::Text, message).help(help))
}

/// The fault of a hint that prints what the form neither tells nor finds.
fn lost(model: &Model, form: &Form, path: &Path, hint: &Text) -> Option<Fault> {
    let open =
        |placeholder: &Placeholder| Some((placeholder.span, without_a_value("a hint", model, form, placeholder)?));
    if let Some((span, fault)) = hint.placeholders().find_map(open) {
        return Some(fault.at_path(path.clone()).within(span));
    }
    let is_lost = |placeholder: &&Placeholder| {
        placeholder.filter.needs_value() && !model.symbol_of(&placeholder.name).is_some_and(|symbol| form.finds(symbol))
    };
    let placeholder = hint.placeholders().find(is_lost)?;
    let message = format!("a hint prints `{}`, which does not follow from what is given", placeholder.name);
    let help = "a hint may print what the form gives, what it asks for, and what is found on the way";
    Some(Fault::new(Code::Text, message).help(help).at_path(path.clone()).within(placeholder.span))
}

/// The quantities that the text of a form may not give away. A question with options compares what it is about, and some of that
/// may be given as an expression.
fn asked(loaded: &Loaded, model: &Model, form: &Form) -> BTreeSet<Symbol> {
    let is_given = |symbol: &Symbol| loaded.given.get(&model.symbols.entry(*symbol).name).is_some();
    let symbols = |part: &Part| {
        let mut symbols = part.kind.wanted();
        if let PartKind::Choice(_) = &part.kind {
            symbols.retain(|symbol| !is_given(symbol));
        }
        symbols
    };
    form.parts.iter().flat_map(symbols).collect()
}

/// Whether the file gives it, rather than a default that the sheet's note tells.
fn is_given(loaded: &Loaded, known: &Known) -> bool {
    let whole = known.name.split_once('.').map_or(known.name.as_str(), |(whole, _)| whole);
    [known.name.as_str(), whole].iter().any(|name| loaded.given.get(name).is_some())
}

/// Whether words tell a value.
fn is_said(prose: &str, value: &Decimal, unit: &Unit) -> bool {
    goes_without_saying(value, unit) || tells(prose, value, unit)
}

/// The words of a form's sheet, placeholders left out.
fn prose(loaded: &Loaded, form: &Form) -> String {
    let words = |text: &Text| text.fill(&|_| String::new());
    let labels = form.parts.iter().map(|part| part.label.clone());
    let texts = [words(&loaded.draft.text), words(&form.question.text)].into_iter().chain(labels);
    texts.collect::<Vec<_>>().join("\n")
}

impl Problem {
    /// Values that stand in the scene, that the answers of a form need, and that its sheet does not tell in so many words: the
    /// words may tell them in another way, as "for 1 s, and for 3 s more" tells 4 s.
    #[must_use]
    pub fn untold(&self, form: &Form) -> Vec<&str> {
        let model = self.model();
        let prose = prose(self.loaded(), form);
        let needed = in_laws(self, form);
        let drawn: BTreeSet<Symbol> = model.graph.iter().flat_map(PrintedGraph::symbols).collect();
        let untold = |(symbol, value): &&(Symbol, Quantity)| {
            needed.contains(symbol) && !drawn.contains(symbol) && !is_said(&prose, &value.value, &value.unit)
        };
        let name = |(symbol, _): &(Symbol, Quantity)| model.symbols.entry(*symbol).name.as_str();
        model.literals.iter().filter(untold).map(name).collect()
    }
}

/// The quantities to which the laws that lead to the answers refer; what a question compares with, it says itself, and what
/// defines a quantity whose value the text prints need not be told.
fn in_laws(problem: &Problem, form: &Form) -> BTreeSet<Symbol> {
    let model = problem.model();
    let asked = [&geometry::BOUNDARY, &kinematics::COUNT];
    let defines = |equation: &Equation| match &equation.statement {
        Statement::Equal { left: Expr::Symbol(defined), .. } => form.printed.contains(defined),
        _ => false,
    };
    let is_law = |equation: &&Equation| {
        model.instances.get(equation.tag).is_some_and(|instance| {
            asked.iter().all(|law| law.id != instance.law.id)
                && !(instance.law.id == geometry::RELATION.id && defines(equation))
        })
    };
    let equations = form.solver.leaves().iter().flat_map(|leaf| {
        let positions = leaf.answer_steps().iter().flat_map(|step| &step.equations);
        positions.filter_map(|position| leaf.system.equations.get(*position))
    });
    equations.filter(is_law).flat_map(Equation::symbols).collect()
}

/// Whether a quantity follows from what is given without being asked: a given that is an expression of others.
fn solved_from_given(form: &Form, symbol: Symbol) -> bool {
    form.solver.leaves().iter().any(|leaf| leaf.audit.plan.steps.iter().any(|step| step.unknowns.contains(&symbol)))
}
