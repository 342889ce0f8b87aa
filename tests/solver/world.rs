//! Systems written as text, for the tests of the solver.

use std::collections::BTreeSet;

use momentous::expr::{Expr, Names, Symbol, SymbolEntry, SymbolTable, parse};
use momentous::quantity::Dimension;
use momentous::solve::{Condition, Equation, Relation, Statement, System};

/// A table of symbols and a system over it.
#[derive(Default)]
pub struct World {
    pub table: SymbolTable,
    pub system: System,
}

impl Names for World {
    fn symbol(&mut self, name: &str) -> Option<Symbol> {
        let entry = SymbolEntry { name: name.into(), dimension: Dimension::NONE, meaning: name.into() };
        Some(self.table.intern(entry))
    }

    fn literal(&mut self, _: &str) -> Option<Symbol> {
        None
    }
}

impl World {
    /// A world of equations; each may start with its cost: `3: a = b`.
    pub fn new(equations: &[&str]) -> Self {
        let mut world = Self::default();
        for text in equations {
            world.equation(text);
        }
        world
    }

    pub fn expr(&mut self, text: &str) -> Expr {
        parse(text, self).unwrap_or_else(|fault| panic!("{text}: {}", fault.message))
    }

    pub fn symbol(&mut self, name: &str) -> Symbol {
        Names::symbol(self, name).expect("any name is a symbol here")
    }

    pub fn symbols(&mut self, names: &str) -> Vec<Symbol> {
        names.split_whitespace().map(|name| self.symbol(name)).collect()
    }

    pub fn set(&mut self, names: &str) -> BTreeSet<Symbol> {
        self.symbols(names).into_iter().collect()
    }

    pub fn equation(&mut self, text: &str) {
        let (cost, text) = match text.split_once(':') {
            Some((cost, rest)) => (cost.trim().parse().expect("a cost"), rest),
            None => (1, text),
        };
        let (left, right) = text.split_once('=').expect("two sides");
        let statement = Statement::Equal { left: self.expr(left), right: self.expr(right) };
        let tag = self.system.equations.len();
        self.system.equations.push(Equation { statement, tag, cost });
    }

    pub fn first_integer(&mut self, unknown: &str, from: i64, left: &str, relation: Relation, right: &str) {
        let unknown = self.symbol(unknown);
        let (left, right) = (self.expr(left), self.expr(right));
        let tag = self.system.equations.len();
        let statement = Statement::FirstInteger { unknown, from, left, relation, right };
        self.system.equations.push(Equation { statement, tag, cost: 1 });
    }

    pub fn condition(&mut self, left: &str, relation: Relation, right: &str) {
        let (left, right) = (self.expr(left), self.expr(right));
        let tag = self.system.conditions.len();
        self.system.conditions.push(Condition { left, relation, right, tag });
    }

    pub fn positive(&mut self, names: &str) {
        let symbols = self.set(names);
        self.system.positive.extend(symbols);
    }

    pub fn plan(&mut self, known: &str, wanted: &str) -> Result<momentous::solve::Plan, momentous::solve::Stuck> {
        let (known, wanted) = (self.set(known), self.symbols(wanted));
        momentous::solve::plan(&self.system, &known, &wanted)
    }

    /// A two-body impact along a line, with everything that laws say about it.
    pub fn impact() -> Self {
        let mut world = Self::new(&[
            "m_A*v_A1 + J_A = m_A*v_A2",
            "m_B*v_B1 + J_B = m_B*v_B2",
            "J_B = -J_A",
            "m_A*v_A1 + m_B*v_B1 = m_A*v_A2 + m_B*v_B2",
            "v_B2 - v_A2 = e*(v_A1 - v_B1)",
            "T_1 = 1/2*m_A*v_A1^2 + 1/2*m_B*v_B1^2",
            "T_2 = 1/2*m_A*v_A2^2 + 1/2*m_B*v_B2^2",
            "T_lost = T_1 - T_2",
            "p_1 = m_A*v_A1 + m_B*v_B1",
            "v_c = p_1/(m_A + m_B)",
        ]);
        world.condition("e", Relation::AtLeast, "0");
        world.condition("e", Relation::AtMost, "1");
        world.condition("v_B2 - v_A2", Relation::AtLeast, "0");
        world.condition("T_lost", Relation::AtLeast, "0");
        world.positive("m_A m_B");
        world
    }
}
