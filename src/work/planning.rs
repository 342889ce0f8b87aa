//! The ways through wrong systems, each planned after the way through the right one, from which it differs in few places.

use std::collections::BTreeMap;
use std::collections::BTreeSet;
use std::sync::Mutex;
use std::sync::PoisonError;

use momentous_expr::Symbol;
use momentous_solve::Equation;
use momentous_solve::Plan;
use momentous_solve::Planner;
use momentous_solve::System;
use momentous_solve::has_enough;

use super::ground::Ground;
use super::way::Way;

/// The right plan of a form, and what is kept from one wrong system to the next.
#[derive(Debug)]
pub(super) struct Planning {
    planner: Mutex<Planner>,
    told: BTreeSet<Symbol>,
    /// All quantities that the right equations give.
    sought: BTreeSet<Symbol>,
    /// The right equations that the answers need, and the plan of all quantities in them.
    right: Option<(System, Plan)>,
    /// For each quantity the steps of that plan on which it rests.
    rests_on: BTreeMap<Symbol, BTreeSet<usize>>,
}

impl Planning {
    /// The planning on a ground.
    pub(super) fn new(ground: &Ground) -> Self {
        let used = ground.used().into_iter().filter_map(|place| ground.system.equations.get(place).cloned());
        let right = System { conditions: Vec::new(), ..ground.system.with(used.collect()) };
        let (told, sought, mut planner) = (ground.told.clone(), ground.sought(), Planner::default());
        let plan = planner.plan(&right, &told, &listed(&sought)).ok();
        let mut rests_on: BTreeMap<Symbol, BTreeSet<usize>> = BTreeMap::new();
        for (place, step) in plan.iter().flat_map(|plan| plan.steps.iter().enumerate()) {
            let equations = step.equations.iter().filter_map(|equation| right.equations.get(*equation));
            let earlier = equations.flat_map(Equation::symbols).filter_map(|symbol| rests_on.get(&symbol)).flatten();
            let steps: BTreeSet<usize> = earlier.copied().chain([place]).collect();
            rests_on.extend(step.unknowns.iter().map(|unknown| (*unknown, steps.clone())));
        }
        let right = plan.map(|plan| (right, plan));
        Self { planner: Mutex::new(planner), told, sought, right, rests_on }
    }

    /// The steps of the right plan that do not stand in a system as they are.
    pub(super) fn shaken(&self, system: &System) -> BTreeSet<usize> {
        let Some((right, plan)) = &self.right else { return BTreeSet::new() };
        let stands = |place: &usize| {
            let stated = right.equations.get(*place).map(|equation| &equation.statement);
            system.equations.iter().any(|equation| Some(&equation.statement) == stated)
        };
        let steps = plan.steps.iter().enumerate();
        steps.filter(|(_, step)| !step.equations.iter().all(stands)).map(|(place, _)| place).collect()
    }

    /// Whether some of these quantities may be other ones where those steps are shaken: those that rest on other steps alone are as in
    /// the scene.
    pub(super) fn touches(&self, shaken: &BTreeSet<usize>, wanted: &BTreeSet<Symbol>) -> bool {
        let is_touched = |symbol: &Symbol| self.rests_on.get(symbol).is_none_or(|steps| !steps.is_disjoint(shaken));
        wanted.iter().any(is_touched)
    }

    /// The way to all that the answers need.
    pub(super) fn whole(&self, system: &System) -> Option<Way> {
        let like = self.right.as_ref().and_then(|(right, plan)| {
            let mut planner = self.planner.lock().unwrap_or_else(PoisonError::into_inner);
            planner.plan_like((right, plan), system, &self.told)
        });
        match like {
            Some(plan) => Way::of(system, plan, &self.told, &listed(&self.sought)),
            None => self.searched(system, &self.sought),
        }
    }

    /// The way to some quantities.
    pub(super) fn searched(&self, system: &System, wanted: &BTreeSet<Symbol>) -> Option<Way> {
        let wanted = listed(wanted);
        if !has_enough(system, &self.told, &wanted) {
            return None;
        }
        let mut planner = self.planner.lock().unwrap_or_else(PoisonError::into_inner);
        let plan = planner.plan(system, &self.told, &wanted).ok()?;
        Way::of(system, plan, &self.told, &wanted)
    }
}

fn listed(symbols: &BTreeSet<Symbol>) -> Vec<Symbol> {
    symbols.iter().copied().collect()
}
