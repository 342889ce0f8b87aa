//! The answer plan: the cheapest equations that determine what is wanted, in blocks, each closed by a tactic.

use std::collections::BTreeSet;

use momentous_expr::Symbol;

use super::super::structure::bits::Bits;
use super::super::structure::blocks::blocks;
use super::super::structure::freedom::{Freedom, gradients};
use super::super::structure::incidence::Structure;
use super::super::structure::rank::dependent;
use super::super::structure::sample::Samples;
use super::super::{Equation, Plan, System};
use super::audit::{Audit, extended};
use super::search::Search;
use super::stuck::{Reason, Stuck, enough};
use super::tactics::{Attempts, Block, Refusal, close, divides_by_nothing};

/// At how many places equations are looked at before something is said not to follow from them.
const PLACES: u32 = 4;

/// How many costs of sets of equations are looked through for a plan that divides by nothing that is zero.
const MOST_BATCHES: usize = 8;

/// Plans how to find `wanted` from `known`.
///
/// Of all sets of equations that determine what is wanted, the one with the least sum of [`super::super::Equation::cost`] is
/// taken; of several, the one whose largest block is smallest, then the one with the least to rearrange, then the
/// earliest equations. Where a block cannot be closed, the next set is tried.
///
/// # Errors
///
/// [`Stuck`], where no set of equations determines what is wanted, or none can be closed.
///
/// ```
/// use std::collections::BTreeSet;
/// use momentous_expr::{Expr, SymbolEntry, SymbolTable};
/// use momentous_quantity::Dimension;
/// use momentous_solve::{Equation, Statement, System, plan};
///
/// let mut table = SymbolTable::default();
/// let [m, v, p] = ["m", "v", "p"].map(|name| {
///     table.intern(SymbolEntry { name: name.into(), dimension: Dimension::NONE, meaning: name.into() })
/// });
/// let momentum = Statement::Equal { left: Expr::from(p), right: Expr::from(m) * Expr::from(v) };
/// let system = System { equations: vec![Equation { statement: momentum, tag: 0, cost: 1 }], ..System::default() };
/// let plan = plan(&system, &BTreeSet::from([m, p]), &[v]).unwrap();
/// assert_eq!(plan.steps.len(), 1);
/// ```
pub fn plan(system: &System, known: &BTreeSet<Symbol>, wanted: &[Symbol]) -> Result<Plan, Stuck> {
    Planner::default().plan(system, known, wanted)
}

/// Plans again and again, and does no algebra twice: for systems in which the same symbols are positive, and the same values known
/// beforehand.
#[derive(Clone, Debug, Default)]
pub struct Planner {
    attempts: Attempts,
    samples: Samples,
}

impl Planner {
    /// The same as [`plan`].
    ///
    /// # Errors
    ///
    /// [`Stuck`], where no set of equations determines what is wanted, or none can be closed.
    pub fn plan(&mut self, system: &System, known: &BTreeSet<Symbol>, wanted: &[Symbol]) -> Result<Plan, Stuck> {
        let first = planned(system, known, wanted, self);
        let is_open = |plan: &Result<Plan, Stuck>| {
            matches!(plan, Err(Stuck { reason: Reason::Underdetermined { .. }, .. }))
                && has_enough(system, known, wanted)
        };
        if !is_open(&first) {
            return first;
        }
        // At the place where the equations were looked at, some may say the same that say different things elsewhere.
        let elsewhere = (1..PLACES).find_map(|starts| {
            let mut other = Self { attempts: std::mem::take(&mut self.attempts), samples: Samples::from(starts) };
            let plan = planned(system, known, wanted, &mut other);
            self.attempts = other.attempts;
            plan.ok()
        });
        elsewhere.map_or(first, Ok)
    }

    /// The plan of a system some of whose statements differ from those of `example`, after the example's plan: the same blocks in the
    /// same order, those that differ closed anew. Where one statement of many is changed, that is much less than a search. None where
    /// the blocks are no longer the same; [`Self::plan`] searches for others.
    #[must_use]
    pub fn plan_like(&mut self, example: (&System, &Plan), system: &System, known: &BTreeSet<Symbol>) -> Option<Plan> {
        let (former, plan) = example;
        if former.equations.len() != system.equations.len() {
            return None;
        }
        let is_as_before = |place: &usize| {
            let [before, now] = [former, system].map(|system| system.equations.get(*place));
            before.zip(now).is_some_and(|(before, now)| before.statement == now.statement)
        };
        let mut solved = known.clone();
        let mut steps = Vec::new();
        for step in &plan.steps {
            let next = if step.equations.iter().all(is_as_before) {
                step.clone()
            } else {
                let equations = step.equations.iter().filter_map(|place| system.equations.get(*place));
                let mentioned: BTreeSet<Symbol> = equations.flat_map(Equation::symbols).collect();
                if !mentioned.difference(&solved).eq(step.unknowns.iter().collect::<BTreeSet<_>>()) {
                    return None;
                }
                let block = Block { system, equations: step.equations.clone(), unknowns: step.unknowns.clone() };
                let closed = close(&block, &mut self.attempts).ok()?;
                if divides_by_nothing(&block, &closed) {
                    return None;
                }
                closed
            };
            solved.extend(next.unknowns.iter().copied());
            steps.push(next);
        }
        Some(Plan { steps })
    }

    /// Whether the equations leave a quantity no freedom, judged by their derivatives where all of them hold: where counting finds too
    /// few equations for the others, they may fix it nevertheless.
    #[must_use]
    pub fn is_fixed(&self, system: &System, known: &BTreeSet<Symbol>, symbol: Symbol) -> bool {
        let structure = Structure::new(system, known);
        structure
            .column(symbol)
            .is_some_and(|column| Freedom::new(system, &structure, &mut Samples::default()).fixes(column, &[]))
    }

    /// The same as [`super::super::audit`].
    #[must_use]
    pub fn audit(&mut self, system: &System, known: &BTreeSet<Symbol>, plan: &Plan) -> Audit {
        extended(system, known, plan, &mut self.attempts)
    }
}

/// Whether there are equations enough for what is wanted, by counting alone: where there are not, no plan is found, and finding out why
/// takes much longer.
#[must_use]
pub fn has_enough(system: &System, known: &BTreeSet<Symbol>, wanted: &[Symbol]) -> bool {
    let structure = Structure::new(system, known);
    let determined = structure.determined(&Bits::empty(structure.unknowns.len()));
    let is_known = |symbol: &Symbol| known.contains(symbol);
    let is_found = |symbol: &Symbol| structure.column(*symbol).is_some_and(|column| determined.contains(column));
    wanted.iter().all(|symbol| is_known(symbol) || is_found(symbol))
}

fn planned(system: &System, known: &BTreeSet<Symbol>, wanted: &[Symbol], memory: &mut Planner) -> Result<Plan, Stuck> {
    let remaining: Vec<Symbol> = wanted.iter().filter(|symbol| !known.contains(symbol)).copied().collect();
    if remaining.is_empty() {
        return Ok(Plan::default());
    }
    let stuck = |reason| Stuck { known: known.clone(), remaining: remaining.clone(), reason };
    let mut structure = Structure::new(system, known);
    let columns: Option<Vec<usize>> = remaining.iter().map(|symbol| structure.column(*symbol)).collect();
    let Some(columns) = columns else {
        let wanted = remaining.iter().filter(|symbol| structure.column(**symbol).is_none()).copied().collect();
        return Err(stuck(Reason::Underdetermined { wanted, enough: Vec::new() }));
    };
    let wanted = Bits::of(structure.unknowns.len(), columns);
    let determined = structure.determined(&Bits::empty(structure.unknowns.len()));
    if !determined.covers(&wanted) {
        let lost: Vec<usize> = wanted.iter().filter(|column| !determined.contains(*column)).collect();
        return Err(stuck(underdetermined(
            &structure,
            &Freedom::new(system, &structure, &mut memory.samples),
            &wanted,
            &lost,
        )));
    }
    let whole = structure.clone();
    structure.prune(&determined, &wanted);
    let sought = structure.narrow(&wanted);

    let gradients = gradients(system, &structure, &mut memory.samples);
    let mut closer =
        Closer { system, structure: &structure, asked: &remaining, attempts: &mut memory.attempts, divides: false };
    let mut search = Search::new(&structure, &gradients, &sought);
    let (mut obstacle, mut freedom) = (None, None);
    let (mut spare, mut batches) = (None, 0);
    let (mut avoided, mut tried) = (Bits::empty(structure.rows.len()), BTreeSet::new());
    loop {
        // A plan that divides by zero is a last resort: others say why there is no solution, or give it.
        batches += usize::from(spare.is_some());
        if batches > MOST_BATCHES {
            break;
        }
        let mut batch = search.next_batch();
        if batch.is_empty() {
            // What counting alone allows says at least why there is no plan, or is one where the search gave up.
            match structure.sufficient(&sought, &Bits::empty(structure.unknowns.len()), &avoided) {
                Some(rows) if tried.insert(rows.clone()) => batch.insert(rows),
                _ => break,
            };
        }
        for candidate in ranked(&structure, &sought, batch) {
            match closer.close_all(&candidate) {
                Ok(plan) if closer.divides => spare = Some(spare.take().unwrap_or(plan)),
                Ok(plan) => return Ok(plan),
                Err((block, Refusal::Contradiction)) => {
                    return Err(stuck(Reason::Contradiction { equations: closer.equations(&block) }));
                }
                Err((block, refusal)) => {
                    if let Some(rows) = dependent(&structure, &gradients, &block) {
                        // Of equations that say the same twice, the dearest is the one to do without.
                        if let Some(row) = rows.iter().max_by_key(|row| structure.rows[*row].cost) {
                            avoided.insert(row);
                        }
                        search.forbid(rows);
                        let freedom = freedom.get_or_insert_with(|| Freedom::new(system, &whole, &mut memory.samples));
                        let lost: Vec<usize> = wanted.iter().filter(|column| !freedom.fixes(*column, &[])).collect();
                        if !lost.is_empty() && spare.is_none() {
                            return Err(stuck(underdetermined(&whole, freedom, &wanted, &lost)));
                        }
                    }
                    obstacle = obstacle.or_else(|| closer.reason(&block, refusal));
                }
            }
        }
    }
    if let Some(plan) = spare {
        return Ok(plan);
    }
    let reason = obstacle.unwrap_or_else(|| {
        let freedom = freedom.unwrap_or_else(|| Freedom::new(system, &whole, &mut memory.samples));
        let open = wanted.iter().any(|column| !freedom.fixes(column, &[]));
        let lost: Vec<usize> = wanted.iter().filter(|column| !open || !freedom.fixes(*column, &[])).collect();
        underdetermined(&whole, &freedom, &wanted, &lost)
    });
    Err(stuck(reason))
}

/// The wanted columns `lost` do not follow; what would help.
fn underdetermined(structure: &Structure, freedom: &Freedom, wanted: &Bits, lost: &[usize]) -> Reason {
    let lost = lost.iter().map(|column| structure.unknowns[*column]).collect();
    Reason::Underdetermined { wanted: lost, enough: enough(structure, freedom, wanted) }
}

/// Candidates of one cost in order of preference, each as its blocks; one with a block that nothing needs is left out.
fn ranked(structure: &Structure, wanted: &Bits, batch: BTreeSet<Vec<usize>>) -> Vec<Vec<Vec<usize>>> {
    let mut candidates: Vec<_> = batch
        .into_iter()
        .filter_map(|rows| {
            let blocks = blocks(structure, &rows).filter(|blocks| structure.needs_all(blocks, wanted))?;
            let largest = blocks.iter().map(Vec::len).max().unwrap_or(0);
            Some((largest, structure.rearranged(&blocks), rows, blocks))
        })
        .collect();
    candidates.sort();
    candidates.into_iter().map(|(_, _, _, blocks)| blocks).collect()
}

/// Closes blocks.
struct Closer<'a> {
    system: &'a System,
    structure: &'a Structure,
    asked: &'a [Symbol],
    attempts: &'a mut Attempts,
    /// Whether the last plan divides by what is zero for the values that are known beforehand.
    divides: bool,
}

impl Closer<'_> {
    /// The plan of these blocks; or the first block that is refused, as rows.
    fn close_all(&mut self, blocks: &[Vec<usize>]) -> Result<Plan, (Vec<usize>, Refusal)> {
        let mut solved = Bits::empty(self.structure.unknowns.len());
        self.divides = false;
        let mut plan = Plan::default();
        for rows in blocks {
            let mut columns = self.structure.columns(rows);
            columns.subtract(&solved);
            solved.join(&columns);
            let mut unknowns: Vec<Symbol> = columns.iter().map(|column| self.structure.unknowns[column]).collect();
            let rank = |symbol: &Symbol| self.asked.iter().position(|asked| asked == symbol).unwrap_or(usize::MAX);
            unknowns.sort_by_key(rank);
            let block = Block { system: self.system, equations: self.equations(rows), unknowns };
            let step = close(&block, self.attempts).map_err(|refusal| (rows.clone(), refusal))?;
            self.divides |= divides_by_nothing(&block, &step);
            plan.steps.push(step);
        }
        Ok(plan)
    }

    fn equations(&self, rows: &[usize]) -> Vec<usize> {
        rows.iter().map(|row| self.structure.rows[*row].equation).collect()
    }

    /// The reason why a block was refused; `None` where its equations say the same twice.
    fn reason(&self, rows: &[usize], refusal: Refusal) -> Option<Reason> {
        let equations = self.equations(rows);
        match refusal {
            Refusal::Dependent | Refusal::Contradiction => None,
            Refusal::NotApplicable => {
                let columns = rows.iter().flat_map(|row| self.structure.rows[*row].finds.iter());
                let columns = Bits::of(self.structure.unknowns.len(), columns);
                let unknowns = columns.iter().map(|column| self.structure.unknowns[column]).collect();
                Some(Reason::NoTactic { equations, unknowns })
            }
        }
    }
}
