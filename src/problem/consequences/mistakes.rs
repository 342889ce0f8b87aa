//! The common mistakes in one form of a problem, each as the program that makes it. They are planned once, when the first
//! wrong answer asks for them; right answers never do.

use std::collections::BTreeSet;
use std::sync::Arc;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_laws::wrong::Misconception;
use momentous_laws::wrong::data::OTHER_ROOT;
use momentous_laws::wrong::reading::DEGREES;
use momentous_laws::wrong::reading::MISREADINGS;
use momentous_laws::wrong::reading::SLIPS;
use momentous_quantity::Rational;
use momentous_quantity::Unit;
use momentous_solve::BatchWriter;
use momentous_solve::System;

use super::super::compiling::planned::Form;
use super::super::compiling::planned::Problem;
use super::super::compiling::regimes::Leaf;
use super::super::sampling::variant::Worked;
use super::mistake::Made;
use super::mistake::Misread;
use super::mistake::Mistake;
use super::mistake::Mistakes;
use super::mistake::Planned;
use super::mistake::WrongSystem;
use super::restricted::Restricted;
use super::solver::Solver;
use super::taken::taken;

/// How the mistakes of one way in which a scene can go are planned.
pub(super) type Plans = fn(&Problem, &Form, &Leaf) -> Planned;

impl Mistakes {
    pub(super) fn of_leaf(&self, plans: Plans, problem: &Problem, form: &Form, leaf: usize) -> Option<&Planned> {
        let all = self.0.get_or_init(|| form.solver.leaves().iter().map(|leaf| plans(problem, form, leaf)).collect());
        all.get(leaf)
    }
}

/// The equations from which the answers follow.
pub(super) fn used(leaf: &Leaf) -> BTreeSet<usize> {
    leaf.answer_steps().iter().flat_map(|step| step.equations.iter().copied()).collect()
}

fn planned(problem: &Problem, form: &Form, leaf: &Leaf) -> Planned {
    let used = used(leaf);
    let wanted: Vec<Symbol> = form.wanted().collect();
    let inputs: Vec<Symbol> = form.told.iter().copied().collect();
    let mut batch = BatchWriter::new(&inputs);
    let mut mistakes: Vec<Mistake> = Vec::new();
    let laws = problem.model().mistaken(&leaf.system, &used, &form.told, problem.units());
    let data = problem.model().altered(&leaf.system, &used, &form.told, problem.units());
    for mistaken in laws.into_iter().chain(data) {
        let ways = solved(&mistaken.system, &mistaken.wrong, (&form.told, &wanted), &mut batch);
        let (of, instance, places) = (mistaken.of, mistaken.instance, mistaken.places);
        mistakes.extend(ways.map(|made| Mistake { of, instance, places, made }));
    }
    let restricted = Restricted::new(&leaf.system, used);
    if let Some(right) = Solver::new(&restricted.system, &form.told, &wanted).map(Arc::new) {
        if right.chooses() {
            let made = Made::OtherRoot(Arc::clone(&right));
            mistakes.push(Mistake { of: &OTHER_ROOT, instance: None, places: 1, made });
        }
        for (of, read, unit) in misread(problem, form) {
            for (system, wrong) in in_one_place(problem, leaf, (&restricted.places, of), &read) {
                let made = solved(&system, &wrong, (&form.told, &wanted), &mut batch);
                mistakes.extend(made.map(|made| Mistake { of, instance: None, places: 1, made }));
            }
            let exactly = |(symbol, factor): &(Symbol, f64)| Some((*symbol, Rational::try_from(*factor).ok()?));
            let exactly: Option<Vec<_>> = read.iter().map(exactly).collect();
            let batched = exactly.and_then(|read| right.batched(&restricted.system, &read, &mut batch));
            let made = Made::Misread(Misread { right: Arc::clone(&right), read, unit, batched });
            mistakes.push(Mistake { of, instance: None, places: 1, made });
        }
    }
    mistakes.extend(taken(problem.model(), &wanted));
    mistakes.extend(SLIPS.iter().map(|slip| Mistake {
        of: slip.of,
        instance: None,
        places: 1,
        made: Made::Written(slip.to, slip.written),
    }));
    let directed = wanted.into_iter().filter(|symbol| problem.senses(*symbol).is_some()).collect();
    Planned { list: mistakes, inputs, batch: batch.finish(), directed }
}

/// The programs for a system with wrong equations; nothing where no answer depends on these.
pub(super) fn solved(
    system: &System,
    wrong: &BTreeSet<usize>,
    (told, wanted): (&BTreeSet<Symbol>, &[Symbol]),
    batch: &mut BatchWriter,
) -> Option<Made> {
    let solvers = Solver::each(system, told, wanted).into_iter();
    let solvers = solvers.filter_map(|solver| solver.of_what_depends(system, wrong));
    let ways = solvers.map(|solver| WrongSystem { batched: solver.batched(system, &[], batch), solver });
    let ways: Vec<WrongSystem> = ways.collect();
    if ways.is_empty() { None } else { Some(Made::Solved(ways)) }
}

/// A larger factor leaves nothing beside a term, and a smaller one than its inverse nothing of it, which is another mistake.
const MOST_IN_ONE_PLACE: f64 = 100.0;

/// The systems in which a given is misread in one equation. Angles that are misread are so in every calculation.
fn in_one_place(
    problem: &Problem,
    leaf: &Leaf,
    (used, of): (&[usize], &'static Misconception),
    read: &[(Symbol, f64)],
) -> Vec<(System, BTreeSet<usize>)> {
    let &[(given, factor)] = read else { return Vec::new() };
    if *of == DEGREES || factor.max(factor.recip()) >= MOST_IN_ONE_PLACE {
        return Vec::new();
    }
    let Ok(factor) = Rational::try_from(factor) else { return Vec::new() };
    let used = used.iter().copied().collect();
    problem.model().misread_in_one_place(&leaf.system, &used, given, &Expr::Number(factor))
}

/// A mistake about a unit: the givens that are misread with their factors, and the unit with the factor.
type Overlooked = (&'static Misconception, Vec<(Symbol, f64)>, (Unit, f64));

/// Every unit that some given has and that is often overlooked: of all its givens, of each alone where that is told from
/// other mistakes, and by how much.
fn misread(problem: &Problem, form: &Form) -> Vec<Overlooked> {
    let mut readings = Vec::new();
    for row in MISREADINGS {
        let (Ok(given), Ok(taken)) = (Unit::parse(row.given), Unit::parse(row.taken)) else { continue };
        let factor = taken.in_terms_of(&given).to_f64();
        let told =
            form.told.iter().filter(|symbol| problem.unit_told(form, **symbol).is_some_and(|unit| unit == given));
        let read: Vec<(Symbol, f64)> = told.map(|symbol| (*symbol, factor)).collect();
        if read.len() > 1 && row.alone {
            readings.extend(read.iter().map(|result| (row.of, vec![*result], (given.clone(), factor))));
        }
        if !read.is_empty() {
            readings.push((row.of, read, (given, factor)));
        }
    }
    readings
}

impl Problem {
    /// The unit in which a form tells a quantity.
    fn unit_told(&self, form: &Form, symbol: Symbol) -> Option<Unit> {
        let revealed = form.reveal.iter().find(|reveal| reveal.symbol == symbol).map(|reveal| reveal.unit.clone());
        revealed.or_else(|| self.unit_given(symbol))
    }
}

impl<'a> Worked<'a> {
    /// The common mistakes that can be made with this variant's form. They are planned when this is first called.
    #[must_use]
    pub fn mistakes(&self) -> &'a [Mistake] {
        self.planned().map_or(&[], |planned| planned.list.as_slice())
    }

    pub(super) fn planned(&self) -> Option<&'a Planned> {
        self.form.mistakes.of_leaf(planned, self.problem, self.form, self.variant.leaf())
    }
}
