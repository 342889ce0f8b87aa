//! What the variants of the bank certify: each is solved and held against the truth once, for every test that asks.

use std::sync::LazyLock;

use momentous::problem::{PartKind, Problem, Sampler, Variant, Worked};
use momentous::solve::Bounded;
use rayon::prelude::*;

use crate::variants::truth::{Long, Truth, is_true, long_f64, rough};
use crate::variants::{bank, form_name, seeds};

/// A bound may be this share of the value, and that much beside it.
pub const SHARE: f64 = 5e-14;
pub const BESIDE: f64 = 1e-60;

/// The error and the certificate of an answer, relative to it.
pub type Pair = (f64, f64);

/// What a form shows over the seeds.
pub struct Looked {
    pub problem: String,
    pub form: usize,
    /// Everything that is claimed beyond the truth; the first few.
    pub faults: Vec<String>,
    /// Each number that is asked for, by its name.
    pub answers: Vec<(String, Vec<Pair>)>,
}

/// Every form of the bank, over 200 seeds.
pub fn whole_bank() -> &'static [Looked] {
    static LOOKED: LazyLock<Vec<Looked>> = LazyLock::new(|| {
        let bank = bank();
        let forms: Vec<(&Problem, usize)> =
            bank.iter().flat_map(|problem| (0..problem.forms().len()).map(move |form| (problem, form))).collect();
        forms.par_iter().map(|(problem, form)| look(problem, *form)).collect()
    });
    &LOOKED
}

fn look(problem: &Problem, form: usize) -> Looked {
    let mut sampler = Sampler::new(problem, form).unwrap();
    let mut looked = Looked { problem: problem.id().to_owned(), form, faults: Vec::new(), answers: Vec::new() };
    for seed in 0..seeds(200) {
        match sampler.variant(seed) {
            Ok(variant) => looked.add(problem, &variant),
            Err(fault) => looked.faults.push(format!("{} seed {seed}: {fault}", form_name(problem, form))),
        }
    }
    looked.faults.truncate(5);
    looked
}

impl Looked {
    fn add(&mut self, problem: &Problem, variant: &Variant) {
        let truth = Truth::of(problem, variant);
        self.faults.extend(faults(problem, variant, &truth));
        let worked = Worked::new(problem, variant).unwrap();
        for part in &worked.form.parts {
            let PartKind::Number(number) = &part.kind else { continue };
            let (computed, exact) = (worked.answer(number), truth.answer(number));
            let size = rough(&exact).abs();
            if size == 0.0 {
                continue;
            }
            let pair = (rough(&(long_f64(computed.value) - exact)).abs() / size, computed.error / size);
            match self.answers.iter_mut().find(|(id, _)| *id == part.id) {
                Some((_, pairs)) => pairs.push(pair),
                None => self.answers.push((part.id.clone(), vec![pair])),
            }
        }
    }
}

/// Everything that a variant claims beyond the truth.
pub fn faults(problem: &Problem, variant: &Variant, truth: &Truth) -> Vec<String> {
    let place = format!("{} seed {:?}", form_name(problem, variant.form()), variant.seed());
    let mut faults = Vec::new();
    let mut judge = |what: &str, bounded: Bounded, truth: &Long, tight: bool| {
        if !is_true(bounded, truth) {
            faults.push(format!("{place}: {what} is {}, not {bounded:?}", rough(truth)));
        } else if tight && bounded.error > SHARE * bounded.value.abs() + BESIDE {
            faults.push(format!("{place}: the bound of {what} is worth little: {bounded:?}"));
        }
    };
    for (symbol, entry) in problem.model().symbols.iter() {
        if let (Some(bounded), Some(truth)) = (variant.value(symbol), truth.value(symbol)) {
            judge(&entry.name, bounded, truth, false);
        }
    }
    let worked = Worked::new(problem, variant).unwrap();
    for part in &worked.form.parts {
        if let PartKind::Number(number) = &part.kind {
            judge(&part.id, worked.answer(number), &truth.answer(number), true);
        }
    }
    faults
}
