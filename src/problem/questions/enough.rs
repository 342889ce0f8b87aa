//! Whether what a sheet tells is enough to find a quantity: the planner answers, and says why.

use std::collections::BTreeMap;
use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::wrong::concept;
use momentous_model::Builder;
use momentous_model::Model;
use momentous_model::PrintedGraph;
use momentous_solve::Condition;
use momentous_solve::Equation;
use momentous_solve::Plan;
use momentous_solve::Planner;
use momentous_solve::Reason;
use momentous_solve::System;
use momentous_solve::Ties;

use super::super::language::ask;
use super::super::language::entries::Entries;
use super::super::language::form::Question;
use super::super::language::known::Known;
use super::super::language::known::Origin;
use super::super::language::text::Text;
use super::super::reading::load::Loaded;
use super::choices::settled::join;
use super::choices::settled::yes_or_no;
use super::part::Part;

/// Ways out that are told in a reason.
const TOLD: usize = 2;

/// A question about a quantity that the planner has not answered yet.
#[derive(Clone, Debug)]
pub(crate) struct Sought {
    /// Its place among the parts.
    pub at: usize,
    pub id: String,
    pub label: String,
    pub points: u32,
    symbol: Symbol,
    path: Path,
}

/// The planner's answers to the questions of a form.
#[derive(Default)]
pub(crate) struct Answered {
    /// The parts, each with its place among all.
    pub parts: Vec<(usize, Part)>,
    /// The symbols that can be found: the worked solution shows how.
    pub found: Vec<Symbol>,
}

/// What the planner says of one way in which the scene can go.
struct Way {
    /// The laws by which what is sought follows there.
    laws: Option<String>,
    /// What would be enough to know beside what is told.
    enough: Vec<Vec<Symbol>>,
    /// Whether what is told decides if it is the way that is taken.
    is_judged: bool,
}

impl Way {
    /// A way in which what is sought does not follow.
    fn open(enough: Vec<Vec<Symbol>>) -> Self {
        Self { laws: None, enough, is_judged: false }
    }
}

/// Reads which quantity is meant.
pub(crate) fn read(
    ask: &ask::Enough,
    at: usize,
    (id, points): (&str, u32),
    builder: &mut Builder<'_>,
    path: &Path,
) -> Option<Sought> {
    let path = path.key("enough");
    let Some(symbol) = builder.mention(&ask.enough) else {
        let fault = builder.unknown(&ask.enough).at_path(path);
        builder.fault(fault);
        return None;
    };
    let label = ask.label.clone().unwrap_or_else(|| {
        let entry = builder.symbols().entry(symbol);
        let what = if entry.meaning.is_empty() { &entry.name } else { &entry.meaning };
        format!("Is there enough information to find {what}?")
    });
    Some(Sought { at, id: id.to_owned(), label, points, symbol, path })
}

/// The quantities whose values the text of a sheet prints, or the graph on it.
pub(crate) fn printed(loaded: &Loaded, question: &Question, model: &Model) -> BTreeSet<Symbol> {
    [&loaded.draft.text, &question.text]
        .into_iter()
        .flat_map(Text::printed_names)
        .filter_map(|name| model.symbol_of(&name))
        .chain(model.graph.iter().flat_map(PrintedGraph::symbols))
        .collect()
}

/// The values that the words and numbers of a sheet tell: what is drawn and not printed is not known, nor is what may be
/// anything.
pub(crate) fn on_the_sheet(
    question: &Question,
    printed: &BTreeSet<Symbol>,
    known: &[Known],
    told: &BTreeSet<Symbol>,
) -> BTreeSet<Symbol> {
    let is_secret = |known: &&Known| match known.origin {
        Origin::Drawn(_) => !printed.contains(&known.symbol),
        Origin::Any => true,
        Origin::Fixed(_) => question.elsewhere.contains(&known.name),
    };
    told - &known.iter().filter(is_secret).map(|known| known.symbol).collect()
}

/// Answers the questions of a form from what its sheet tells.
pub(crate) fn answered(
    planner: &mut Planner,
    model: &Model,
    sought: &[Sought],
    (equations, conditions): (&[Equation], &[Condition]),
    (known, told): (&[Known], &BTreeSet<Symbol>),
) -> Result<Answered, Vec<Fault>> {
    let mut answered = Answered::default();
    // What is always zero may take an unknown quantity with it: a body at rest has no momentum, whatever its mass.
    let fixed = known.iter().filter(|known| told.contains(&known.symbol)).filter_map(|known| match &known.origin {
        Origin::Fixed(value) => Some((known.symbol, Expr::measured(value, &known.unit))),
        Origin::Drawn(_) | Origin::Any => None,
    });
    let fixed: BTreeMap<Symbol, Expr> = fixed.collect();
    // Where no example with all values is found, those that are zero matter most.
    let zeros: BTreeMap<Symbol, Expr> =
        fixed.iter().filter(|(_, value)| value.is_zero()).map(|(symbol, value)| (*symbol, value.clone())).collect();
    let any = known.iter().filter(|known| matches!(known.origin, Origin::Any)).map(|known| known.symbol);
    let with_any: BTreeSet<Symbol> = told.iter().copied().chain(any).collect();
    for sought in sought {
        let name = &model.symbols.entry(sought.symbol).name;
        let fault =
            |code, message: String, help: &str| vec![Fault::new(code, message).help(help).at_path(sought.path.clone())];
        if told.contains(&sought.symbol) {
            let help = "ask about a quantity that has to be found";
            return Err(fault(Code::Text, format!("the sheet tells `{name}` itself"), help));
        }
        let mut ways = Vec::new();
        for (_, mut system) in model.systems() {
            system.equations.extend(equations.iter().cloned());
            system.conditions.extend(conditions.iter().cloned());
            let plan = planner.plan(&system, told, &[sought.symbol]);
            let ties_with =
                |fixed: &BTreeMap<Symbol, Expr>| Ties::new(&System { fixed: fixed.clone(), ..system.clone() });
            let ties = Some(ties_with(&fixed)).filter(|ties| !ties.are_unknown()).unwrap_or_else(|| ties_with(&zeros));
            let way = match plan {
                Ok(_) if ties.leave_open(sought.symbol, told) => Way::open(Vec::new()),
                Ok(plan) => Way { laws: Some(laws(model, &system, &plan)), ..Way::open(Vec::new()) },
                Err(_) if ties.fix(sought.symbol, told) => {
                    let Ok(plan) = planner.plan(&system, &with_any, &[sought.symbol]) else {
                        let message = format!("`{name}` follows from what is given, but no known method shows how");
                        return Err(fault(Code::Stuck, message, "ask about another quantity that follows as well"));
                    };
                    Way { laws: Some(laws(model, &system, &plan)), ..Way::open(Vec::new()) }
                }
                Err(stuck) if ties.leave_open(sought.symbol, told) => match stuck.reason {
                    Reason::Underdetermined { enough, .. } => Way::open(enough),
                    Reason::NoTactic { .. } | Reason::Contradiction { .. } => Way::open(Vec::new()),
                },
                Err(stuck) => match stuck.reason {
                    Reason::Underdetermined { enough, .. } => Way::open(enough),
                    Reason::NoTactic { .. } | Reason::Contradiction { .. } => {
                        let help = "describe the scene by other quantities, or ask about another";
                        let message = format!("it cannot be decided whether `{name}` can be found");
                        return Err(fault(Code::Stuck, message, help));
                    }
                },
            };
            // Only the way that its conditions tell from the others matters, where they can be judged.
            let compared: Vec<Symbol> = system
                .conditions
                .iter()
                .skip(model.system.conditions.len())
                .flat_map(|condition| [condition.left.symbols(), condition.right.symbols()])
                .flatten()
                .filter(|symbol| !told.contains(symbol))
                .collect();
            let is_judged = compared.is_empty() || planner.plan(&system, told, &compared).is_ok();
            ways.push(Way { is_judged, ..way });
        }
        let open = ways.iter().find(|way| way.laws.is_none());
        let verdict = match (ways.iter().find_map(|way| way.laws.as_ref()), open) {
            (Some(laws), None) => {
                answered.found.push(sought.symbol);
                (true, format!("it follows from what is given by {laws}"))
            }
            (Some(_), Some(_)) if ways.iter().any(|way| way.laws.is_some() && way.is_judged) => {
                let message = format!("whether `{name}` can be found depends on which way the scene goes");
                return Err(fault(Code::Stuck, message, "ask about another quantity"));
            }
            (_, Some(open)) => (false, lacking(model, sought.symbol, &open.enough)),
            (None, None) => continue,
        };
        let behind = if verdict.0 { &concept::ENOUGH_OVERLOOKED } else { &concept::EQUATIONS_NOT_COUNTED };
        let kind = yes_or_no(verdict, Some(behind));
        let part = Part {
            id: sought.id.clone(),
            label: sought.label.clone(),
            points: sought.points,
            expected: Entries::default(),
            kind,
        };
        answered.parts.push((sought.at, part));
    }
    Ok(answered)
}

/// The laws of a plan, each once.
fn laws(model: &Model, system: &System, plan: &Plan) -> String {
    let mut laws: Vec<String> = Vec::new();
    for position in plan.steps.iter().flat_map(|step| &step.equations) {
        let tag = system.equations.get(*position).map(|equation| equation.tag);
        if let Some(law) = tag.and_then(|tag| model.instances.get(tag)).map(|instance| instance.law.name.to_owned())
            && !laws.contains(&law)
        {
            laws.push(law);
        }
    }
    join(&laws)
}

/// Why a quantity does not follow, with what would have to be known as well.
fn lacking(model: &Model, sought: Symbol, enough: &[Vec<Symbol>]) -> String {
    let has_words = |set: &&Vec<Symbol>| {
        set.iter().all(|symbol| *symbol != sought && !model.symbols.entry(*symbol).meaning.is_empty())
    };
    let said = |set: &Vec<Symbol>| {
        let words: Vec<String> = set.iter().map(|symbol| model.symbols.entry(*symbol).meaning.clone()).collect();
        join(&words)
    };
    let sets: Vec<String> = enough.iter().filter(has_words).take(TOLD).map(said).collect();
    let without = "there are more unknown quantities than equations to find them from";
    if sets.is_empty() {
        without.to_owned()
    } else {
        format!("{without}; it could be found if one also knew {}, for instance", sets.join(", or "))
    }
}
