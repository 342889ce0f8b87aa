//! The system of a student who makes one slip in one line.

use std::collections::BTreeMap;
use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_laws::Sides;
use momentous_laws::geometry::COUNTED;
use momentous_laws::geometry::DIRECTION;
use momentous_laws::wrong::line_slip::FACTOR;
use momentous_laws::wrong::line_slip::LINE_SLIPS;
use momentous_laws::wrong::line_slip::Line;
use momentous_quantity::Dimension;
use momentous_quantity::UnitSystem;
use momentous_solve::Equation;
use momentous_solve::System;

use super::Instance;
use super::Mistaken;
use super::Model;
use super::mistaken::WrongUse;
use super::mistaken::one_unit;

/// A line of the solution: its equation, the law that it is, and its sides.
type Stated<'a> = (usize, usize, &'a Instance, Sides);

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
        let unit = |dimension: Dimension| one_unit(dimension, units);
        let is_zero = |symbol: &&Symbol| system.values.get(symbol).is_some_and(Expr::is_zero);
        let told: BTreeSet<Symbol> = told.iter().filter(|symbol| !is_zero(symbol)).copied().collect();
        let others: BTreeSet<Symbol> =
            used.iter().filter_map(|place| system.equations.get(*place)).flat_map(Equation::symbols).collect();
        let line = |sides| Line { sides, symbols: &self.symbols, told: &told, others: &others, unit: &unit };
        let stated = |place: &usize| {
            let (tag, instance, sides) = self.sides(system, *place)?;
            Some((*place, tag, instance, sides))
        };
        let lines: Vec<Stated<'_>> = used.iter().filter_map(stated).collect();
        // How a direction is counted has mistakes of its own.
        let counts_no_direction = |(_, _, instance, _): &&Stated<'_>| ![&DIRECTION, &COUNTED].contains(&instance.law);
        let alone = lines.iter().filter(counts_no_direction).flat_map(|(place, tag, _, sides)| {
            let slips =
                LINE_SLIPS.iter().flat_map(|slip| (slip.write)(&line(sides)).into_iter().map(|wrong| (slip.of, wrong)));
            slips.map(|(of, wrong)| vec![WrongUse::new(of, (*place, *tag), wrong)]).collect::<Vec<_>>()
        });
        // Whoever leaves a factor out of one component leaves it out of the others.
        let in_all = told.iter().flat_map(|symbol| {
            let mut by_law: BTreeMap<_, Vec<WrongUse>> = BTreeMap::new();
            for (place, tag, instance, sides) in &lines {
                if let Some(wrong) = line(sides).without_factor(*symbol) {
                    let law = by_law.entry((instance.law.id, instance.stage)).or_default();
                    law.push(WrongUse::new(&FACTOR, (*place, *tag), wrong));
                }
            }
            by_law.into_values().filter(|wrong| wrong.len() > 1)
        });
        alone
            .chain(in_all)
            .filter_map(|wrong| self.with_wrong(system, used, &wrong.iter().collect::<Vec<_>>()))
            .collect()
    }
}
