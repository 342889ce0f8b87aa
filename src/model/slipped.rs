//! The system of a student who makes one slip in one line.

use std::collections::BTreeMap;
use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_laws::Sides;
use momentous_laws::geometry::COUNTED;
use momentous_laws::geometry::DIRECTION;
use momentous_laws::wrong::Misconception;
use momentous_laws::wrong::line_slip::FACTOR;
use momentous_laws::wrong::line_slip::LINE_SLIPS;
use momentous_laws::wrong::line_slip::Line;
use momentous_quantity::Dimension;
use momentous_quantity::UnitSystem;
use momentous_quantity::coherent_unit;
use momentous_solve::Equation;
use momentous_solve::Statement;
use momentous_solve::System;

use super::Mistaken;
use super::Model;

impl Model {
    /// Every system that comes of one slip in one of these equations of a system.
    #[must_use]
    pub fn slipped(
        &self,
        system: &System,
        used: &BTreeSet<usize>,
        told: &BTreeSet<Symbol>,
        units: UnitSystem,
    ) -> Vec<Mistaken> {
        let unit = |dimension: Dimension| {
            let factor = coherent_unit(dimension, units).factor();
            Expr::Number(factor.rational) * Expr::Pi.powi(i64::from(factor.pi))
        };
        let is_zero = |symbol: &&Symbol| system.values.get(symbol).is_some_and(Expr::is_zero);
        let told: BTreeSet<Symbol> = told.iter().filter(|symbol| !is_zero(symbol)).copied().collect();
        let others: BTreeSet<Symbol> =
            used.iter().filter_map(|place| system.equations.get(*place)).flat_map(Equation::symbols).collect();
        let lines: Vec<(&Equation, Sides)> = used
            .iter()
            .filter_map(|place| system.equations.get(*place))
            .map(|equation| match &equation.statement {
                Statement::Equal { left, right } => (equation, (left.clone(), right.clone())),
                Statement::FirstInteger { .. } => (equation, (Expr::zero(), Expr::zero())),
            })
            .collect();
        let line = |sides| Line { sides, symbols: &self.symbols, told: &told, others: &others, unit: &unit };
        let mut mistaken = Vec::new();
        let mut add = |of: &'static Misconception, wrong: BTreeMap<usize, Sides>| {
            let Some((equation, _)) = wrong.keys().next().and_then(|first| lines.get(*first)) else { return };
            let equations = lines.iter().enumerate().map(|(place, (right, _))| match wrong.get(&place) {
                Some((left, other)) => Equation {
                    statement: Statement::Equal { left: left.clone(), right: other.clone() },
                    ..(*right).clone()
                },
                None => (*right).clone(),
            });
            let system = system.with(equations.collect());
            let (instance, places) = (Some(equation.tag), wrong.len());
            mistaken.push(Mistaken { of, instance, places, wrong: wrong.into_keys().collect(), system });
        };
        // How a direction is counted has mistakes of its own.
        let is_direction = |equation: &Equation| {
            let law = self.instances.get(equation.tag).map(|instance| instance.law);
            law == Some(&DIRECTION) || law == Some(&COUNTED)
        };
        for (place, (_, sides)) in lines.iter().enumerate().filter(|(_, (equation, _))| !is_direction(equation)) {
            for slip in LINE_SLIPS {
                for wrong in (slip.write)(&line(sides)) {
                    add(slip.of, BTreeMap::from([(place, wrong)]));
                }
            }
        }
        // Whoever leaves a factor out of one component leaves it out of the others.
        let law = |place: usize| {
            self.instances.get(lines.get(place)?.0.tag).map(|instance| (instance.law.id, instance.stage))
        };
        for symbol in &told {
            let without = lines.iter().map(|(_, sides)| line(sides).without_factor(*symbol)).enumerate();
            let mut by_law: BTreeMap<_, BTreeMap<usize, Sides>> = BTreeMap::new();
            for (place, wrong) in without.filter_map(|(place, wrong)| Some((place, wrong?))) {
                by_law.entry(law(place)).or_default().insert(place, wrong);
            }
            for wrong in by_law.into_values().filter(|wrong| wrong.len() > 1) {
                add(&FACTOR, wrong);
            }
        }
        mistaken
    }
}
