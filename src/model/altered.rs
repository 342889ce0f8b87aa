//! The system of a student who gets what is given wrong: a given left out, or in the place of another. The laws are right.

use std::collections::BTreeMap;
use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_laws::force::WEIGHT;
use momentous_laws::restitution::RESTITUTION;
use momentous_laws::restitution::RESTITUTION_SURFACE;
use momentous_laws::wrong::data::ALTERED;
use momentous_laws::wrong::data::Alteration;
use momentous_laws::wrong::data::Givens;
use momentous_quantity::Dimension;
use momentous_quantity::UnitSystem;
use momentous_solve::Condition;
use momentous_solve::Equation;
use momentous_solve::Statement;
use momentous_solve::System;

use super::Mistaken;
use super::Model;
use super::Name;
use super::QuantityKind;
use super::mistaken::one_unit;

/// The powers of length and time in forces and how fast they grow, in impulses, and in moments and how fast they grow.
const FORCES: [(i8, i8); 5] = [(1, -2), (1, -3), (1, -1), (2, -2), (2, -3)];

/// So many mistakes it counts for that a given is right in some equations and wrong in one.
const IN_ONE_ONLY: usize = 2;

/// The expression in the place of each given.
type InPlace = BTreeMap<Symbol, Expr>;

impl Model {
    /// Every system that comes of one common mistake about what is told.
    #[must_use]
    pub fn altered(
        &self,
        system: &System,
        used: &BTreeSet<usize>,
        told: &BTreeSet<Symbol>,
        units: UnitSystem,
    ) -> Vec<Mistaken> {
        let mut mistaken = Vec::new();
        for row in ALTERED {
            let is_zero = |symbol: &Symbol| system.values.get(symbol).is_some_and(Expr::is_zero);
            let groups = self.givens(row.givens, system, told).into_iter();
            let groups = groups.map(|group| group.into_iter().filter(|symbol| !is_zero(symbol)).collect::<Vec<_>>());
            let unit = one(row.givens, units);
            for in_place in groups.flat_map(|group| self.alterations(&group, row.how, &unit, told)) {
                for changed in self.places(row.givens, system, used, &in_place) {
                    let (system, wrong) = altered(system, used, &changed, &in_place);
                    if !wrong.is_empty() {
                        // Whoever has a given right in one equation and wrong in another makes no simple mistake.
                        let places = in_place.len() + if row.givens.is_of_one_equation() { IN_ONE_ONLY } else { 0 };
                        mistaken.push(Mistaken { of: row.of, instance: None, places, wrong, system });
                    }
                }
            }
        }
        mistaken
    }

    /// Every system in which a given is too large by a factor in one of the equations, where it stands in several.
    #[must_use]
    pub fn misread_in_one_place(
        &self,
        system: &System,
        used: &BTreeSet<usize>,
        given: Symbol,
        factor: &Expr,
    ) -> Vec<(System, BTreeSet<usize>)> {
        let in_place = InPlace::from([(given, factor.clone() * Expr::from(given))]);
        let holds =
            |place: &&usize| system.equations.get(**place).is_some_and(|equation| equation.symbols().contains(&given));
        let places: Vec<usize> = used.iter().filter(holds).copied().collect();
        let places = if places.len() > 1 { places } else { Vec::new() };
        places.into_iter().map(|place| altered(system, used, &BTreeSet::from([place]), &in_place)).collect()
    }

    /// The sets of equations in which givens are got wrong: all together, or each by itself.
    fn places(
        &self,
        givens: Givens,
        system: &System,
        used: &BTreeSet<usize>,
        in_place: &InPlace,
    ) -> Vec<BTreeSet<usize>> {
        if !givens.is_of_one_equation() {
            return vec![used.clone()];
        }
        let is_touched = |place: &&usize| {
            let equation = system.equations.get(**place);
            let law = equation.and_then(|equation| self.instances.get(equation.tag)).map(|instance| instance.law);
            equation.is_some_and(|equation| equation.symbols().iter().any(|symbol| in_place.contains_key(symbol)))
                && law != Some(&WEIGHT)
        };
        used.iter().filter(is_touched).map(|place| BTreeSet::from([*place])).collect()
    }

    /// The givens of a kind, those together that can be compared with each other.
    fn givens(&self, givens: Givens, system: &System, told: &BTreeSet<Symbol>) -> Vec<Vec<Symbol>> {
        let told_that =
            |is: &dyn Fn(Symbol) -> bool| told.iter().copied().filter(|symbol| is(*symbol)).collect::<Vec<_>>();
        let measured = |dimension: Dimension| told_that(&|symbol| self.symbols.entry(symbol).dimension == dimension);
        let weights = || told_that(&|symbol| self.name(symbol).kind == QuantityKind::Weight);
        match givens {
            Givens::Masses => vec![measured(Dimension::MASS), weights()],
            Givens::MassesOfOneEquation => vec![self.unknown_too(system, Dimension::MASS)],
            Givens::VelocitiesOfOneEquation => vec![self.unknown_too(system, Dimension::VELOCITY)],
            Givens::Velocities => vec![measured(Dimension::VELOCITY), measured(Dimension::new(0, 0, -1))],
            Givens::Gravity if weights().is_empty() => {
                vec![told_that(&|symbol| self.name(symbol).kind == QuantityKind::Gravity)]
            }
            Givens::Gravity => Vec::new(),
            Givens::Angles => vec![told_that(&|symbol| self.is_direction(symbol))],
            Givens::Durations => vec![measured(Dimension::TIME)],
            Givens::Forces => {
                // Energies have the dimension of moments, but do not act for a time.
                let acts = |given: &Symbol| {
                    let beside =
                        system.equations.iter().map(Equation::symbols).filter(|all| all.contains(given)).flatten();
                    let energy = Dimension::new(1, 2, -2);
                    self.symbols.entry(*given).dimension != energy
                        || beside.into_iter().any(|other| self.symbols.entry(other).dimension == Dimension::TIME)
                };
                let groups = FORCES.map(|(length, time)| measured(Dimension::new(1, length, time)));
                groups.map(|group| group.into_iter().filter(acts).collect()).into()
            }
            Givens::Restitutions => vec![self.restitutions(system, told)],
            Givens::RestitutionOfHeights => {
                let is_counted = |equation: &&Equation| matches!(equation.statement, Statement::FirstInteger { .. });
                vec![self.pure_numbers(system, told, &is_counted)]
            }
        }
    }

    /// Every quantity of a dimension in the equations, given or not.
    fn unknown_too(&self, system: &System, dimension: Dimension) -> Vec<Symbol> {
        let all = system.equations.iter().flat_map(Equation::symbols).collect::<BTreeSet<_>>();
        all.into_iter().filter(|symbol| self.symbols.entry(*symbol).dimension == dimension).collect()
    }

    /// The same quantity of a group at other instants, or of other bodies at the same instant, for each of them.
    fn elsewhere(&self, group: &[Symbol], is_elsewhere: &dyn Fn(&Name, &Name) -> bool) -> Vec<InPlace> {
        let is_taken = |symbol: Symbol, other: Symbol| {
            let (name, taken) = (self.name(symbol), self.name(other));
            name.kind == taken.kind && name.component == taken.component && is_elsewhere(name, taken)
        };
        let pairs = group.iter().flat_map(|symbol| group.iter().map(move |other| (*symbol, *other)));
        let taken = pairs.filter(|(symbol, other)| is_taken(*symbol, *other));
        taken.map(|(symbol, other)| InPlace::from([(symbol, Expr::from(other))])).collect()
    }

    /// The coefficients of restitution: the pure numbers in the law of restitution.
    fn restitutions(&self, system: &System, told: &BTreeSet<Symbol>) -> Vec<Symbol> {
        let is_restitution = |equation: &&Equation| {
            let law = self.instances.get(equation.tag).map(|instance| instance.law);
            law.is_some_and(|law| [&RESTITUTION, &RESTITUTION_SURFACE].contains(&law))
        };
        self.pure_numbers(system, told, &is_restitution)
    }

    /// The given pure numbers in some equations, without angles.
    fn pure_numbers(
        &self,
        system: &System,
        told: &BTreeSet<Symbol>,
        is_sought: &dyn Fn(&&Equation) -> bool,
    ) -> Vec<Symbol> {
        let symbols = system.equations.iter().filter(is_sought).flat_map(Equation::symbols);
        let numbers =
            symbols.filter(|symbol| told.contains(symbol) && self.symbols.entry(*symbol).dimension == Dimension::NONE);
        numbers.filter(|symbol| !self.is_direction(*symbol)).collect::<BTreeSet<_>>().into_iter().collect()
    }

    /// Whether a quantity is an angle that turns an arrow.
    fn is_direction(&self, symbol: Symbol) -> bool {
        matches!(
            self.name(symbol).kind,
            QuantityKind::OwnAngle(_)
                | QuantityKind::AngleBetween(_)
                | QuantityKind::Direction(_)
                | QuantityKind::CountedDirection(_)
        )
    }

    /// The ways of altering some givens.
    fn alterations(&self, group: &[Symbol], how: Alteration, one: &Expr, told: &BTreeSet<Symbol>) -> Vec<InPlace> {
        let each = |change: &dyn Fn(Symbol) -> Expr| {
            group.iter().map(|symbol| InPlace::from([(*symbol, change(*symbol))])).collect::<Vec<_>>()
        };
        match how {
            Alteration::Exchanged => {
                let pairs = group
                    .iter()
                    .enumerate()
                    .flat_map(|(place, first)| group.iter().skip(place + 1).map(move |second| (*first, *second)));
                pairs.map(|(first, second)| InPlace::from([(first, second.into()), (second, first.into())])).collect()
            }
            Alteration::Equal => match group {
                [first, others @ ..] if !others.is_empty() => {
                    vec![others.iter().map(|symbol| (*symbol, Expr::from(*first))).collect()]
                }
                _ => Vec::new(),
            },
            Alteration::Missing if group.len() > 1 => each(&|_| Expr::zero()),
            Alteration::Together if group.len() > 1 => {
                each(&|_| Expr::sum(group.iter().map(|symbol| Expr::from(*symbol))))
            }
            Alteration::Missing | Alteration::Together => Vec::new(),
            Alteration::Copied => {
                let pairs = group.iter().flat_map(|symbol| group.iter().map(move |other| (*symbol, *other)));
                let unlike = pairs.filter(|(symbol, other)| symbol != other);
                unlike.map(|(symbol, other)| InPlace::from([(symbol, Expr::from(other))])).collect()
            }
            Alteration::AtAnotherInstant => {
                self.elsewhere(group, &|one, other| one.subject == other.subject && one.instant != other.instant)
            }
            Alteration::OfAnotherBody => {
                self.elsewhere(group, &|one, other| one.subject != other.subject && one.instant == other.instant)
            }
            Alteration::Zero => {
                let mut ways = each(&|_| Expr::zero());
                if group.len() > 1 {
                    let zero = |symbol: &Symbol| (*symbol, Expr::zero());
                    ways.push(group.iter().map(zero).collect());
                    // All but one: with two, that is each of them alone.
                    let kept = group.iter().filter(|_| group.len() > 2);
                    ways.extend(kept.map(|kept| group.iter().filter(|symbol| *symbol != kept).map(zero).collect()));
                }
                ways
            }
            Alteration::OnlyChange => group.iter().map(|symbol| self.only_change(*symbol, told)).collect(),
            Alteration::Weighed => {
                let weighed = |symbol: &Symbol| (*symbol, Expr::ratio(981, 100) * Expr::from(*symbol));
                vec![group.iter().map(weighed).collect()]
            }
            Alteration::Reversed => each(&|symbol| -Expr::from(symbol)),
            Alteration::One => each(&|_| one.clone()),
            Alteration::Squared => each(&|symbol| Expr::from(symbol).powi(2)),
            Alteration::Rooted => each(&|symbol| Expr::from(symbol).sqrt()),
        }
    }

    /// A given that is zero, and the same quantity at other instants with the opposite sign.
    fn only_change(&self, given: Symbol, told: &BTreeSet<Symbol>) -> InPlace {
        let given_name = self.name(given);
        let is_later = |symbol: &Symbol| {
            let name = self.name(*symbol);
            let alike = name.kind == given_name.kind
                && name.subject == given_name.subject
                && name.component == given_name.component;
            alike && !told.contains(symbol)
        };
        let later = self.symbols.iter().map(|(symbol, _)| symbol).filter(is_later);
        later.map(|symbol| (symbol, -Expr::from(symbol))).chain([(given, Expr::zero())]).collect()
    }
}

/// One unit of some givens.
fn one(givens: Givens, units: UnitSystem) -> Expr {
    match givens {
        Givens::Gravity => one_unit(Dimension::ACCELERATION, units),
        Givens::Masses
        | Givens::MassesOfOneEquation
        | Givens::Velocities
        | Givens::VelocitiesOfOneEquation
        | Givens::Angles
        | Givens::Durations
        | Givens::Forces
        | Givens::Restitutions
        | Givens::RestitutionOfHeights => Expr::one(),
    }
}

/// The used equations with other things in the place of givens, and which of them that changes.
fn altered(
    system: &System,
    used: &BTreeSet<usize>,
    changed: &BTreeSet<usize>,
    in_place: &InPlace,
) -> (System, BTreeSet<usize>) {
    let change = |side: &Expr| side.substitute(&|symbol| in_place.get(&symbol).cloned()).simplify();
    let (mut equations, mut wrong) = (Vec::new(), BTreeSet::new());
    for (place, equation) in used.iter().filter_map(|place| Some((place, system.equations.get(*place)?))) {
        let is_touched =
            changed.contains(place) && equation.symbols().iter().any(|symbol| in_place.contains_key(symbol));
        match &equation.statement {
            Statement::Equal { left, right } if is_touched => {
                let statement = Statement::Equal { left: change(left), right: change(right) };
                wrong.insert(equations.len());
                equations.push(Equation { statement, ..equation.clone() });
            }
            Statement::FirstInteger { unknown, from, left, relation, right } if is_touched => {
                let (left, right) = (change(left), change(right));
                let statement =
                    Statement::FirstInteger { unknown: *unknown, from: *from, left, relation: *relation, right };
                wrong.insert(equations.len());
                equations.push(Equation { statement, ..equation.clone() });
            }
            Statement::Equal { .. } | Statement::FirstInteger { .. } => equations.push(equation.clone()),
        }
    }
    let judged = |condition: &Condition| Condition {
        left: change(&condition.left),
        right: change(&condition.right),
        ..condition.clone()
    };
    let conditions = system.conditions.iter().map(judged).collect();
    (System { conditions, ..system.with(equations) }, wrong)
}
