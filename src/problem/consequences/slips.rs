//! Slips in one line of a solution. They are planned when an answer is wrong and no common mistake leads to it.

use momentous_expr::Symbol;
use momentous_laws::wrong::line_slip::NUMBER;
use momentous_laws::wrong::reading::SlipOf;
use momentous_solve::BatchWriter;

use super::super::compiling::planned::Form;
use super::super::compiling::planned::Problem;
use super::super::compiling::regimes::Leaf;
use super::super::sampling::variant::Worked;
use super::mistake::Made;
use super::mistake::Mistake;
use super::mistake::Planned;
use super::mistakes::solved;
use super::mistakes::used;
use super::simulated::Simulated;

fn planned(problem: &Problem, form: &Form, leaf: &Leaf) -> Planned {
    let wanted: Vec<Symbol> = form.wanted().collect();
    let inputs: Vec<Symbol> = form.told.iter().copied().collect();
    let mut batch = BatchWriter::new(&inputs);
    let slips = problem.model().slipped(&leaf.system, &used(leaf), &form.told, problem.units());
    let list = slips.into_iter().filter_map(|slip| {
        let made = solved(&slip.system, &slip.wrong, (&form.told, &wanted), &mut batch)?;
        Some(Mistake { of: slip.of, instance: slip.instance, places: slip.places, made })
    });
    let mut list: Vec<Mistake> = list.collect();
    // A factor of two may have slipped in anywhere.
    let written: [fn(f64) -> f64; 2] = [|value| 2.0 * value, |value| value / 2.0];
    list.extend(written.map(|written| Mistake {
        of: &NUMBER,
        instance: None,
        places: 1,
        made: Made::Written(SlipOf::Size, written),
    }));
    Planned { list, inputs, batch: batch.finish(), directed: Vec::new() }
}

impl<'a> Worked<'a> {
    /// The consequences of every slip in one line with the numbers of this variant.
    #[must_use]
    pub fn slips(&self) -> Simulated<'a> {
        Simulated::new(*self, self.form.slips.of_leaf(planned, self.problem, self.form, self.variant.leaf()))
    }
}
