//! The common mistakes in one form of a problem, each as the program that makes it. They are planned once, when the first
//! wrong answer asks for them; right answers never do.

use std::collections::BTreeSet;
use std::sync::Arc;

use momentous_expr::Symbol;
use momentous_laws::wrong::Misconception;
use momentous_laws::wrong::reading::MISREADINGS;
use momentous_laws::wrong::reading::SLIPS;
use momentous_quantity::Rational;
use momentous_quantity::Unit;
use momentous_solve::BatchWriter;

use super::super::compiling::planned::Form;
use super::super::compiling::planned::Problem;
use super::super::compiling::regimes::Leaf;
use super::super::sampling::variant::Worked;
use super::mistake::Made;
use super::mistake::Mistake;
use super::mistake::Mistakes;
use super::mistake::Planned;
use super::mistake::WrongSystem;
use super::restricted::Restricted;
use super::solver::Solver;
use super::taken::taken;

impl Mistakes {
    fn of_leaf(&self, problem: &Problem, form: &Form, leaf: usize) -> Option<&Planned> {
        let all = self.0.get_or_init(|| form.solver.leaves().iter().map(|leaf| planned(problem, form, leaf)).collect());
        all.get(leaf)
    }
}

fn planned(problem: &Problem, form: &Form, leaf: &Leaf) -> Planned {
    let used: BTreeSet<usize> = leaf.answer_steps().iter().flat_map(|step| step.equations.iter().copied()).collect();
    let wanted: Vec<Symbol> = form.wanted().collect();
    let inputs: Vec<Symbol> = form.told.iter().copied().collect();
    let mut batch = BatchWriter::new(&inputs);
    let mut mistakes: Vec<Mistake> = Vec::new();
    let laws = problem.model().mistaken(&leaf.system, &used, &form.told, problem.units());
    let data = problem.model().altered(&leaf.system, &used, &form.told, problem.units());
    for mistaken in laws.into_iter().chain(data) {
        let solvers = Solver::each(&mistaken.system, &form.told, &wanted).into_iter();
        let solvers = solvers.filter_map(|solver| solver.of_what_depends(&mistaken.system, &mistaken.wrong));
        let ways: Vec<WrongSystem> = solvers
            .map(|solver| WrongSystem { batched: solver.batched(&mistaken.system, &[], &mut batch), solver })
            .collect();
        if !ways.is_empty() {
            let (of, instance, places) = (mistaken.of, mistaken.instance, mistaken.places);
            mistakes.push(Mistake { of, instance, places, made: Made::Solved(ways) });
        }
    }
    let restricted = Restricted::new(&leaf.system, used);
    if let Some(right) = Solver::new(&restricted.system, &form.told, &wanted).map(Arc::new) {
        for (of, read) in misread(problem, form) {
            let exactly = |(symbol, factor): &(Symbol, f64)| Some((*symbol, Rational::try_from(*factor).ok()?));
            let exactly: Option<Vec<_>> = read.iter().map(exactly).collect();
            let place = exactly.and_then(|read| right.batched(&restricted.system, &read, &mut batch));
            let made = Made::Misread(Arc::clone(&right), read, place);
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

/// Every unit that some given has and that is often overlooked: of all its givens, of each alone where that is told from
/// other mistakes, and by how much.
fn misread(problem: &Problem, form: &Form) -> Vec<(&'static Misconception, Vec<(Symbol, f64)>)> {
    let mut readings = Vec::new();
    for row in MISREADINGS {
        let (Ok(given), Ok(taken)) = (Unit::parse(row.given), Unit::parse(row.taken)) else { continue };
        let factor = taken.in_terms_of(&given).to_f64();
        let told =
            form.told.iter().filter(|symbol| problem.unit_told(form, **symbol).is_some_and(|unit| unit == given));
        let read: Vec<(Symbol, f64)> = told.map(|symbol| (*symbol, factor)).collect();
        if read.len() > 1 && row.alone {
            readings.extend(read.iter().map(|result| (row.of, vec![*result])));
        }
        if !read.is_empty() {
            readings.push((row.of, read));
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
        self.form.mistakes.of_leaf(self.problem, self.form, self.variant.leaf())
    }
}
