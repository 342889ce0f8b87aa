//! A form between its file and its plan: what is asked, told and required of it as symbols.

use std::collections::BTreeSet;

use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_model::Builder;
use momentous_model::Model;
use momentous_solve::Condition;
use momentous_solve::Equation;
use momentous_solve::Planner;

use super::super::consequences::following::Followings;
use super::super::consequences::mistake::Mistakes;
use super::super::language::allowed::Allowed;
use super::super::language::condition::condition;
use super::super::language::form::Question;
use super::super::language::known::Known;
use super::super::questions::enough;
use super::super::questions::enough::Sought;
use super::super::questions::number::unit_for;
use super::super::questions::part::Part;
use super::super::questions::part::PartKind;
use super::super::questions::parts;
use super::super::questions::range;
use super::super::reading::load::Loaded;
use super::super::sampling::neglected;
use super::form_cache::FormCache;
use super::lacking;
use super::on_demand::Formulas;
use super::on_demand::Samples;
use super::on_demand::Sensitivities;
use super::planned::Form;
use super::planned::Reveal;
use super::regimes::Regimes;

/// A form whose names are symbols, but which is not planned yet.
pub(super) struct FormDraft {
    question: Question,
    parts: Vec<Part>,
    wanted: Vec<Symbol>,
    pub(crate) counts: Vec<Equation>,
    reveal: Vec<Reveal>,
    pub(crate) conditions: Vec<Condition>,
    sought: Vec<Sought>,
    allowed: Allowed,
}

impl FormDraft {
    pub(crate) fn read(loaded: &Loaded, question: &Question, builder: &mut Builder<'_>) -> Self {
        let changed;
        let loaded = if question.given.is_empty() {
            loaded
        } else {
            changed = loaded.with(&question.given);
            &changed
        };
        let read = parts::read(loaded, question, builder);
        let figures = loaded.draft.significant_figures();
        let mut reveal = Vec::new();
        for (index, name) in question.reveal.iter().enumerate() {
            match builder.mention(name) {
                Some(symbol) if read.wanted.contains(&symbol) => {
                    let fault =
                        Fault::new(Code::Duplicate, format!("`{name}` is asked for, so it cannot be given as well"));
                    let help = "remove it from `reveal`, or ask for something else";
                    builder.fault(fault.help(help).at_path(question.path.key("reveal").index(index)));
                }
                Some(symbol) => {
                    let dimension = builder.symbols().entry(symbol).dimension;
                    let unit = unit_for(loaded, name, dimension);
                    reveal.push(Reveal { name: name.clone(), symbol, unit, figures });
                }
                None => {
                    let fault = builder.unknown(name).at_path(question.path.key("reveal").index(index));
                    builder.fault(fault);
                }
            }
        }
        let conditions = question.conditions.iter();
        let conditions = conditions
            .filter_map(|(path, intended)| {
                condition(builder, intended.text(), intended.reason(), &intended.place(path))
            })
            .chain(read.conditions)
            .collect();
        Self {
            question: question.clone(),
            parts: read.parts,
            wanted: read.wanted,
            counts: read.counts,
            reveal,
            conditions,
            sought: read.sought,
            allowed: Allowed::read(question, builder),
        }
    }

    /// Whether it asks for a quantity, or tells it.
    pub(crate) fn speaks_of(&self, symbol: Symbol) -> bool {
        self.wanted.contains(&symbol) || self.reveal.iter().any(|reveal| reveal.symbol == symbol)
    }

    /// The symbols to which its parts refer.
    pub(crate) fn mentioned(&self) -> impl Iterator<Item = Symbol> {
        self.parts.iter().flat_map(|part| match &part.kind {
            PartKind::Choice(choice) => choice.mentioned(),
            _ => BTreeSet::new(),
        })
    }

    /// Plans the form: what it reveals from everything given, what it asks from what it tells. What stands under `where`
    /// holds for the whole scene, so it also picks the solution from which something is revealed.
    pub(crate) fn plan(
        mut self,
        planner: &mut Planner,
        (loaded, model): (&Loaded, &Model),
        known: Vec<Known>,
        require: &[Condition],
    ) -> Result<Form, Vec<Fault>> {
        let everything: BTreeSet<Symbol> = inputs(model, &known);
        let mut told = everything.clone();
        for symbol in &self.wanted {
            told.remove(symbol);
        }
        told.extend(self.reveal.iter().map(|reveal| reveal.symbol));
        self.leave_open(planner, model, &mut told);
        // What an answer is a multiple of must be known too, and where it is not told it is solved.
        let multiplied = self.parts.iter().filter_map(|part| part.kind.in_terms_of());
        let mut wanted: Vec<Symbol> =
            self.wanted.iter().copied().chain(multiplied.filter(|symbol| !told.contains(symbol))).collect();
        let extra = |conditions: &[Condition]| [require, conditions].concat();
        let printed = enough::printed(loaded, &self.question, model);
        let sheet = enough::on_the_sheet(&self.question, &printed, &known, &told);
        // Beside a value that is revealed as it is rounded, values that were drawn and not printed would contradict it.
        if !self.reveal.is_empty() && !self.sought.is_empty() {
            let is_drawn = |known: &&Known| known.origin.is_drawn() && !sheet.contains(&known.symbol);
            for secret in known.iter().filter(is_drawn) {
                told.remove(&secret.symbol);
            }
        }
        let rules = (&self.counts[..], &extra(&self.conditions)[..]);
        let answered = enough::answered(planner, model, &self.sought, rules, (&known, &sheet))?;
        for (at, part) in answered.parts {
            self.parts.insert(at.min(self.parts.len()), part);
        }
        wanted.extend(answered.found);
        let revealed: Vec<Symbol> = self.reveal.iter().map(|reveal| reveal.symbol).collect();
        let path = self.question.path.key("ask");
        let forward = if revealed.is_empty() {
            None
        } else {
            let at = self.question.path.key("reveal");
            let planned = Regimes::plan(
                planner,
                model,
                &[],
                &extra(&self.conditions),
                &everything,
                &revealed,
                &self.allowed.warnings,
            );
            Some(planned.map_err(|unplanned| vec![lacking::fault(planner, model, &unplanned).at_path(at)])?)
        };
        let trials = range::trials(planner, model, &self.parts, &told, &self.allowed.warnings)
            .map_err(|fault| vec![fault.at_path(path.clone())])?;
        let given = self.wanted.iter().find(|symbol| everything.contains(symbol));
        let solver = Regimes::plan(
            planner,
            model,
            &self.counts,
            &extra(&self.conditions),
            &told,
            &wanted,
            &self.allowed.warnings,
        )
        .map_err(|unplanned| lacking::fault(planner, model, &unplanned))
        .map_err(|fault| match given.map(|symbol| &model.symbols.entry(*symbol).name) {
            Some(name) => fault.help(format!(
                "`{name}` is listed under `given`, so a form that asks for it must say what it follows from: `reveal: [...]`"
            )),
            None => fault,
        })
        .map_err(|fault| vec![fault.at_path(path)])?;
        let weighed =
            neglected::weighed(planner, model, &extra(&self.conditions), &told, &solver, &self.allowed.warnings);
        Ok(Form {
            trials,
            weighed,
            question: self.question,
            known,
            parts: self.parts,
            meant: self.allowed.meant,
            allowed: self.allowed.warnings,
            told,
            printed,
            on_sheet: sheet,
            free: BTreeSet::new(),
            by_formula: BTreeSet::new(),
            formulas: Formulas::default(),
            samples: Samples::default(),
            reveal: self.reveal,
            forward,
            solver,
            mistakes: Mistakes::default(),
            slips: Mistakes::default(),
            sensitivities: Sensitivities::default(),
            followings: Followings::default(),
            cache: FormCache::default(),
            work: FormCache::default(),
        })
    }
}

impl FormDraft {
    /// A range asks about what may have any value: what only another form tells would settle it, and is left out unless the
    /// claim needs it.
    fn leave_open(&self, planner: &mut Planner, model: &Model, told: &mut BTreeSet<Symbol>) {
        let elsewhere: BTreeSet<Symbol> =
            self.question.elsewhere.iter().filter_map(|name| model.symbol_of(name)).collect();
        let has_range = self.parts.iter().any(|part| matches!(part.kind, PartKind::Range(_)));
        let open = &*told - &elsewhere;
        if has_range && range::trials(planner, model, &self.parts, &open, &self.allowed.warnings).is_ok() {
            *told = open;
        }
    }
}

/// Everything that has a value before anything is solved.
fn inputs(model: &Model, known: &[Known]) -> BTreeSet<Symbol> {
    known.iter().map(|known| known.symbol).chain(model.literals.iter().map(|(symbol, _)| *symbol)).collect()
}
