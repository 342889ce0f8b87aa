//! The system of a student who makes one common mistake: the equations that the solution uses, a law among them in a wrong
//! form.

use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_laws::Sides;
use momentous_laws::wrong::Misconception;
use momentous_laws::wrong::Taught;
use momentous_laws::wrong::Wrong;
use momentous_laws::wrong::geometry::ANYWHERE;
use momentous_quantity::Decimal;
use momentous_quantity::Dimension;
use momentous_quantity::UnitSystem;
use momentous_quantity::coherent_unit;
use momentous_solve::Equation;
use momentous_solve::Statement;
use momentous_solve::System;

use super::Instance;
use super::Model;

/// A system with one mistake in it.
#[derive(Clone, Debug)]
pub struct Mistaken {
    /// The mistake.
    pub of: &'static Misconception,
    /// The law that is got wrong, as it is used here: a position in [`Model::instances`]; none where the laws are right.
    pub instance: Option<usize>,
    /// In how many places the same is got wrong.
    pub places: usize,
    /// The positions of the wrong equations in [`Self::system`].
    pub wrong: BTreeSet<usize>,
    /// The equations, and the conditions of every true solution.
    pub system: System,
}

/// One way of getting one equation wrong.
pub(super) struct WrongUse {
    of: &'static Misconception,
    equation: usize,
    instance: usize,
    variant: usize,
    wrong: Wrong,
}

impl WrongUse {
    /// An equation, at a position in its system and of the law at a position among the instances, in a wrong form.
    pub(super) fn new(of: &'static Misconception, (equation, instance): (usize, usize), wrong: Sides) -> Self {
        Self { of, equation, instance, variant: 0, wrong: wrong.into() }
    }
}

impl Model {
    /// Every system that comes of one common mistake in these equations of a system: in one of them, or in each of them.
    #[must_use]
    pub fn mistaken(
        &self,
        system: &System,
        used: &BTreeSet<usize>,
        known: &BTreeSet<Symbol>,
        units: UnitSystem,
    ) -> Vec<Mistaken> {
        let mut ways: Vec<WrongUse> =
            used.iter().flat_map(|equation| self.ways(system, *equation, known, units)).collect();
        ways.sort_by_key(|way| way.of.id);
        let mut mistaken = Vec::new();
        for alike in ways.chunk_by(|one, other| one.of == other.of) {
            let mut add = |chosen: &[&WrongUse]| mistaken.extend(self.with_wrong(system, used, chosen));
            for way in alike {
                add(&[way]);
            }
            let equations: BTreeSet<usize> = alike.iter().map(|way| way.equation).collect();
            let most = alike.iter().map(|way| way.variant + 1).max().unwrap_or(0);
            for variant in (0..most).filter(|_| equations.len() > 1) {
                // Whoever gets a law wrong in one place gets it wrong in the same way in others.
                let mistake_in = |equation: &usize| {
                    let mut ways = alike.iter().filter(|way| way.equation == *equation && way.variant <= variant);
                    ways.next_back()
                };
                add(&equations.iter().filter_map(mistake_in).collect::<Vec<_>>());
            }
        }
        mistaken
    }

    /// The ways of getting one equation wrong.
    fn ways(&self, system: &System, equation: usize, known: &BTreeSet<Symbol>, units: UnitSystem) -> Vec<WrongUse> {
        let Some((tag, instance, sides)) = self.sides(system, equation) else { return Vec::new() };
        let together = |other: &&Equation| {
            self.instances.get(other.tag).is_some_and(|other| other.stage.is_none() || other.stage == instance.stage)
        };
        let beside: Vec<(&'static str, Sides)> = system
            .equations
            .iter()
            .filter(together)
            .filter_map(|other| match &other.statement {
                Statement::Equal { left, right } => {
                    Some((self.instances.get(other.tag)?.law.id, (left.clone(), right.clone())))
                }
                Statement::FirstInteger { .. } => None,
            })
            .collect();
        let unit_acceleration = one_unit(Dimension::ACCELERATION, units);
        let integral = instance.integral.as_ref();
        let law = Taught {
            sides: &sides,
            integral: integral
                .map(|integral| (&integral.integrand, integral.variable, [&integral.low, &integral.high])),
            beside: &beside,
            symbols: &self.symbols,
            known,
            unit_acceleration: &unit_acceleration,
        };
        let of_law = instance.law.wrong;
        let elsewhere = ANYWHERE.iter().filter(|form| !of_law.iter().any(|of_law| of_law.of == form.of));
        let ways = of_law.iter().chain(elsewhere).flat_map(|form| {
            let written = (form.write)(&law).into_iter().enumerate();
            written
                .map(|(variant, wrong)| WrongUse { of: form.of, equation, instance: tag, variant, wrong })
                .collect::<Vec<_>>()
        });
        ways.collect()
    }

    /// The used equations with some of them got wrong in the same way; nothing where none is.
    pub(super) fn with_wrong(&self, system: &System, used: &BTreeSet<usize>, chosen: &[&WrongUse]) -> Option<Mistaken> {
        let first = chosen.first()?;
        let (system, wrong) = self.in_place(system, used, chosen);
        Some(Mistaken { of: first.of, instance: Some(first.instance), places: chosen.len(), wrong, system })
    }

    /// The sides of an equation, with the law that it is and its position among the instances; `None` where it counts.
    pub(super) fn sides(&self, system: &System, equation: usize) -> Option<(usize, &Instance, Sides)> {
        let stated = system.equations.get(equation)?;
        let instance = self.instances.get(stated.tag)?;
        match &stated.statement {
            Statement::Equal { left, right } => Some((stated.tag, instance, (left.clone(), right.clone()))),
            Statement::FirstInteger { .. } => None,
        }
    }

    /// The used equations, with these in their wrong forms, and where those are.
    fn in_place(&self, system: &System, used: &BTreeSet<usize>, chosen: &[&WrongUse]) -> (System, BTreeSet<usize>) {
        let stage_of = |equation: usize| Some(self.instances.get(system.equations.get(equation)?.tag)?.stage);
        let left_aside = |equation: usize| {
            let law = system
                .equations
                .get(equation)
                .and_then(|equation| self.instances.get(equation.tag))
                .map(|instance| instance.law.id);
            chosen.iter().any(|way| {
                law.is_some_and(|law| way.wrong.without.contains(&law)) && stage_of(way.equation) == stage_of(equation)
            })
        };
        let (mut equations, mut wrong) = (Vec::new(), BTreeSet::new());
        for place in used.iter().copied().filter(|place| !left_aside(*place)) {
            let Some(right) = system.equations.get(place) else { continue };
            match chosen.iter().find(|way| way.equation == place) {
                None => equations.push(right.clone()),
                Some(way) => {
                    wrong.extend(equations.len()..equations.len() + way.wrong.equations.len());
                    equations.extend(way.wrong.equations.iter().map(|(left, other)| Equation {
                        statement: Statement::Equal { left: left.clone(), right: other.clone() },
                        ..right.clone()
                    }));
                }
            }
        }
        (system.with(equations), wrong)
    }
}

/// One coherent unit of a dimension, as a multiple of that of the International System.
pub(super) fn one_unit(dimension: Dimension, units: UnitSystem) -> Expr {
    Expr::measured(&Decimal::from_scaled(1, 0), &coherent_unit(dimension, units))
}
