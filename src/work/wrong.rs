//! The systems that come of the usual mistakes, and which of them a line follows from.

use std::collections::BTreeMap;
use std::collections::BTreeSet;
use std::sync::Arc;
use std::sync::OnceLock;
use std::sync::RwLock;

use momentous_expr::Symbol;
use momentous_laws::wrong::Misconception;
use momentous_model::Mistaken;
use momentous_problem::Worked;
use momentous_solve::Bounded;
use momentous_solve::Equation;
use momentous_solve::Real;
use momentous_solve::Statement;
use momentous_solve::evaluate;

use super::ground::{Ground, Place};
use super::holds::{At, Difference, Holds, RESULT, RESULT_OF_MISTAKE};
use super::meaning::Meanings;
use super::planning::Planning;
use super::way::{Values, Way};
use super::written::Written;

/// Other variants at which a mistaken line has to hold, too.
const VARIANTS: usize = 3;
/// In so many variants a line has to be the same multiple of a wrong equation.
const ENOUGH: usize = 3;
/// Multiples are the same within this share.
const SAME: f64 = 1e-7;
/// A line that follows from more different mistakes names none of them.
const MOST: usize = 3;

/// A system with one mistake, and the values that follow from it.
#[derive(Debug)]
struct WrongSystem {
    mistaken: Mistaken,
    /// The quantities in its equations.
    quantities: BTreeSet<Symbol>,
    /// The steps of the right plan that stand on an equation that is none of its own.
    shaken: BTreeSet<usize>,
    /// The way to all that the answers need.
    whole: OnceLock<Option<Arc<Way>>>,
    /// The ways to other quantities, as far as a line has asked.
    parts: RwLock<BTreeMap<BTreeSet<Symbol>, Option<Arc<Way>>>>,
}

/// All of them.
#[derive(Debug)]
pub(crate) struct WrongSystems {
    systems: Vec<WrongSystem>,
    planning: Planning,
}

/// A mistake from which a line follows.
#[derive(Clone, Debug)]
pub(crate) struct Follows {
    /// The mistake.
    pub(crate) of: &'static Misconception,
    /// The law that is got wrong, as it is used; none where the laws are right.
    pub(crate) instance: Option<usize>,
    /// In how many places the same is got wrong.
    pub(crate) places: usize,
    /// Whether the line is the wrong equation itself, but for what is right, and no other multiple of it.
    pub(crate) is_itself: bool,
}

impl WrongSystem {
    fn follows(&self) -> Follows {
        let Mistaken { of, instance, places, .. } = &self.mistaken;
        Follows { of, instance: *instance, places: *places, is_itself: false }
    }

    fn way(&self, planning: &Planning, wanted: &BTreeSet<Symbol>) -> Option<Arc<Way>> {
        if !wanted.is_subset(&self.quantities) {
            return None;
        }
        let whole = self.whole.get_or_init(|| planning.whole(&self.mistaken.system).map(Arc::new));
        if let Some(whole) = whole
            && wanted.iter().all(|symbol| whole.finds(*symbol))
        {
            return Some(Arc::clone(whole));
        }
        if let Some(known) = self.parts.read().ok().and_then(|parts| parts.get(wanted).cloned()) {
            return known;
        }
        let way = planning.searched(&self.mistaken.system, wanted).map(Arc::new);
        if let Ok(mut parts) = self.parts.write() {
            parts.insert(wanted.clone(), way.clone());
        }
        way
    }

    /// How many times a line is one of the wrong equations, but for what is right: where the scene is right, right equations vanish,
    /// so the differences of its sides are then the same multiple of those of the wrong equation in every variant.
    fn multiple(&self, differences: &[(Place<'_>, Difference)]) -> Option<f64> {
        self.mistaken.wrong.iter().filter_map(|place| self.mistaken.system.equations.get(*place)).find_map(|equation| {
            let Statement::Equal { left, right } = &equation.statement else { return None };
            let mut ratios: Vec<f64> = Vec::new();
            for (place, difference) in differences {
                let value = |symbol: Symbol| place.value(symbol).unwrap_or_else(Bounded::not_real);
                let [left, right]: [Bounded; 2] = [left, right].map(|side| evaluate(side, &value));
                let wrong = Difference { value: left.value - right.value, size: left.value.abs() + right.value.abs() };
                match (difference.is_nothing(), wrong.is_nothing()) {
                    (true, true) => {}
                    (false, false) if wrong.value.is_finite() => ratios.push(difference.value / wrong.value),
                    _ => return None,
                }
            }
            let first = ratios.first().copied()?;
            let is_same = ratios.iter().all(|ratio| (ratio - first).abs() <= SAME * first.abs());
            (ratios.len() >= ENOUGH && is_same).then_some(first)
        })
    }
}

impl WrongSystems {
    fn new(ground: &Ground, worked: Worked<'_>) -> Self {
        let model = worked.problem.model();
        let used = ground.used();
        let laws = model.mistaken(&ground.system, &used, &ground.told, worked.problem.units());
        let data = model.altered(&ground.system, &used, &ground.told, worked.problem.units());
        let planning = Planning::new(ground);
        let system = |mut mistaken: Mistaken| {
            // A wrong value need not be a possible one: conditions do not judge it.
            mistaken.system.conditions.clear();
            let quantities = mistaken.system.equations.iter().flat_map(Equation::symbols).collect();
            let shaken = planning.shaken(&mistaken.system);
            WrongSystem { mistaken, quantities, shaken, whole: OnceLock::new(), parts: RwLock::default() }
        };
        Self { systems: laws.into_iter().chain(data).map(system).collect(), planning }
    }

    /// The mistakes from which a line follows that does not follow from the scene: those made in the fewest places, of laws before
    /// those of data, and those of earlier lines before all others.
    pub(crate) fn of(
        ground: &Ground,
        worked: Worked<'_>,
        place: Place<'_>,
        (line, meanings): (&Written, &[Meanings]),
        at: &At<'_>,
        before: &[(&'static str, usize)],
    ) -> Vec<Follows> {
        let Self { systems, planning } = &*ground.wrong.get(|| Self::new(ground, worked));
        let formula = line.without_results();
        let wanted: BTreeSet<Symbol> = line.quantities().difference(&ground.told).copied().collect();
        let apart = differences(ground, place, (&formula, meanings), at);
        let direct = systems.iter().filter_map(|system| {
            let multiple = apart.iter().find_map(|line| system.multiple(line))?;
            Some((system, Follows { is_itself: (multiple.abs() - 1.0).abs() <= SAME, ..system.follows() }))
        });
        let direct: Vec<(&WrongSystem, Follows)> = direct.collect();
        // Better those from which it follows without the law that they replace.
        let fails = |system: &WrongSystem, way: &Way| {
            way.uses(&system.mistaken.wrong)
                && meanings.iter().all(|set| holds(way, place, (line, set, at)) == Holds::No)
        };
        let stands = |system: &WrongSystem| !system.way(planning, &wanted).is_some_and(|way| fails(system, &way));
        let standing = direct.iter().filter(|(system, _)| stands(system)).map(|(_, follows)| follows.clone());
        let standing: Vec<Follows> = standing.collect();
        if !standing.is_empty() {
            return likeliest(standing);
        }
        if !direct.is_empty() {
            return likeliest(direct.into_iter().map(|(_, follows)| follows).collect());
        }
        let mut follows: Vec<Follows> = Vec::new();
        for system in systems.iter().filter(|system| planning.touches(&system.shaken, &wanted)) {
            let way = system.way(planning, &wanted);
            let Some(way) = way.filter(|way| way.uses(&system.mistaken.wrong)) else { continue };
            let holds = meanings.iter().any(|set| {
                let here = holds(&way, place, (line, set, at));
                let elsewhere = || {
                    let places = ground.places().take(VARIANTS);
                    let holds_there: Vec<Holds> = places.map(|place| holds(&way, place, (&formula, set, at))).collect();
                    holds_there.iter().all(|holds| matches!(holds, Holds::Yes | Holds::Open))
                };
                match here {
                    Holds::Yes | Holds::AsFigures if set.is_general(&formula) => elsewhere(),
                    Holds::Yes | Holds::AsFigures => true,
                    Holds::Open | Holds::No => false,
                }
            });
            if holds {
                follows.push(system.follows());
            }
        }
        // What was got wrong before explains more than another mistake would.
        let is_before = |follows: &Follows| before.iter().any(|(id, _)| *id == follows.of.id);
        if follows.iter().any(is_before) {
            follows.retain(is_before);
        }
        let follows = likeliest(follows);
        if follows.len() > MOST { Vec::new() } else { follows }
    }
}

/// Whether a line holds at a place, with the mistake made there.
fn holds(way: &Way, place: Place<'_>, (line, meanings, at): (&Written, &Meanings, &At<'_>)) -> Holds {
    let solutions: Vec<Values> = way.solve(&|symbol| place.value(symbol));
    let within = |solution: &Values| {
        let value =
            |symbol: Symbol| -> Option<Bounded> { solution.get(&symbol).copied().or_else(|| place.value(symbol)) };
        At { value: &value, units: at.units, turned: at.turned, share: RESULT_OF_MISTAKE }.line(line, meanings)
    };
    solutions.iter().map(within).min().unwrap_or(Holds::Open)
}

/// Those made in the fewest places, of laws before those of data, and those that stand in the line before multiples; each once.
fn likeliest(mut follows: Vec<Follows>) -> Vec<Follows> {
    let rank = |follows: &Follows| (follows.places, follows.instance.is_none(), !follows.is_itself);
    follows.sort_by_key(rank);
    let first = follows.first().map(rank);
    let mut named = BTreeSet::new();
    follows.retain(|follows| Some(rank(follows)) == first && named.insert(follows.of.id));
    follows
}

/// How far the sides of the line's statements are apart in the student's variant and in others, for each meaning of its numbers that
/// is the same in all.
fn differences<'g>(
    ground: &'g Ground,
    place: Place<'g>,
    (line, meanings): (&Written, &[Meanings]),
    at: &At<'_>,
) -> Vec<Vec<(Place<'g>, Difference)>> {
    let places: Vec<Place<'g>> = std::iter::once(place).chain(ground.places()).collect();
    let mut combinations = Vec::new();
    for set in meanings.iter().filter(|set| set.is_general(line)) {
        for statement in line.statements() {
            let each = places.iter().map(|place| {
                let value = |symbol: Symbol| place.value(symbol);
                let at = At { value: &value, units: at.units, turned: at.turned, share: RESULT };
                Some((*place, at.difference(line, statement, set)?))
            });
            combinations.extend(each.collect::<Option<Vec<_>>>());
        }
    }
    combinations
}
