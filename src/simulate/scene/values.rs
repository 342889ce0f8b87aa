//! The numbers of a scene by their names, and terms worked out with them.

use std::collections::BTreeMap;
use std::sync::Arc;

use momentous_expr::{Expr, Names, Symbol, SymbolEntry, SymbolTable, parse};
use momentous_quantity::{Dimension, Quantity};
use momentous_scene::stage::StageMass;
use momentous_scene::{Axis, Plane, Scene, Term};

use crate::force::HIGHEST_POWER;

use super::in_time::{Integrals, Law, OfTime};
use super::nothing::NothingToSimulate;

/// The clock of a stage in the strength of a force.
const CLOCK: &str = "t";

/// A scene, the values of its quantities, and the stage that is looked at.
pub(super) struct Values<'a> {
    pub scene: &'a Scene,
    pub value: &'a dyn Fn(&str) -> Option<f64>,
    pub index: usize,
}

/// A term in several variables.
pub(super) type OfSeveral = Arc<dyn Fn(&[f64]) -> f64 + Send + Sync>;

/// The names of one term, with the values of those that are not variables.
struct Reader<'a> {
    known: &'a dyn Fn(&str) -> Option<f64>,
    variables: &'a [String],
    places: BTreeMap<Symbol, usize>,
    table: SymbolTable,
    found: BTreeMap<Symbol, f64>,
    missing: bool,
}

/// A term that was read: the places of its variables, and the values of its other names.
struct ReadTerm {
    expr: Expr,
    places: BTreeMap<Symbol, usize>,
    found: BTreeMap<Symbol, f64>,
}

impl ReadTerm {
    /// It as a function of its one variable.
    fn of_time(self) -> OfTime {
        let Self { expr, places, found } = self;
        Arc::new(move |time| {
            expr.evaluate(&|symbol| match found.get(&symbol) {
                Some(value) if !places.contains_key(&symbol) => *value,
                _ => time,
            })
        })
    }

    /// An antiderivative in its one variable, and one of that, where both have a formula.
    fn integrals(self) -> Option<[OfTime; 2]> {
        let clock = *self.places.keys().next()?;
        let once = self.expr.integrate(clock)?;
        let twice = once.integrate(clock)?;
        let of_time = |expr: Expr| Self { expr, places: self.places.clone(), found: self.found.clone() }.of_time();
        Some([of_time(once), of_time(twice)])
    }
}

impl Reader<'_> {
    fn note(&mut self, name: &str, value: f64) -> Symbol {
        let entry = SymbolEntry { name: name.to_owned(), dimension: Dimension::NONE, meaning: String::new() };
        let symbol = self.table.intern(entry);
        self.found.insert(symbol, value);
        symbol
    }
}

impl Names for Reader<'_> {
    fn symbol(&mut self, name: &str) -> Option<Symbol> {
        if let Some(place) = self.variables.iter().position(|variable| variable == name) {
            let symbol = self.note(name, f64::NAN);
            self.places.insert(symbol, place);
            return Some(symbol);
        }
        let value = (self.known)(name);
        self.missing |= value.is_none();
        Some(self.note(name, value?))
    }

    fn literal(&mut self, text: &str) -> Option<Symbol> {
        let quantity = Quantity::parse(text).ok()?;
        Some(self.note(text, quantity.value.to_f64() * quantity.unit.factor().to_f64()))
    }
}

impl Values<'_> {
    /// The value of a name.
    pub(super) fn named(&self, name: &str) -> Result<f64, NothingToSimulate> {
        (self.value)(name).filter(|value| value.is_finite()).ok_or(NothingToSimulate::ValueMissing)
    }

    /// The value of a term that does not depend on the time.
    pub(super) fn number(&self, text: &str) -> Result<f64, NothingToSimulate> {
        let value = self.of_several(text, &[])?(&[]);
        if value.is_finite() { Ok(value) } else { Err(NothingToSimulate::ValueMissing) }
    }

    /// The same, for a term as the author wrote it.
    pub(super) fn term(&self, term: &Term) -> Result<f64, NothingToSimulate> {
        self.number(&term.0)
    }

    /// The value of a term that may be left out, where it can be worked out.
    pub(super) fn known(&self, term: Option<&Term>) -> Option<f64> {
        self.term(term?).ok()
    }

    /// The value of a term; 0 where it is left out.
    pub(super) fn or_zero(&self, term: Option<&Term>) -> Result<f64, NothingToSimulate> {
        term.map_or(Ok(0.0), |term| self.term(term))
    }

    /// A term that may contain the clock, as a law of the time.
    pub(super) fn law(&self, term: &Term) -> Result<Law, NothingToSimulate> {
        let clock = || -> Result<ReadTerm, NothingToSimulate> { self.read(&term.0, &[CLOCK.to_owned()]) };
        let integrals = match self.polynomial(term, HIGHEST_POWER) {
            Some(coefficients) => Integrals::Polynomial(coefficients),
            None => clock()?.integrals().map_or(Integrals::Unknown, Integrals::Formula),
        };
        Ok(Law { at: clock()?.of_time(), integrals })
    }

    /// A term as the coefficients of 1, t, t², ... in the clock, up to a power; none where it is no such polynomial.
    pub(super) fn polynomial(&self, term: &Term, highest: usize) -> Option<Vec<f64>> {
        let ReadTerm { mut expr, places, found } = self.read(&term.0, &[CLOCK.to_owned()]).ok()?;
        let clock = places.into_keys().next();
        let mut coefficients = Vec::new();
        let mut factorial = 1.0;
        for power in 0..=highest {
            // Taylor's coefficients, of which a polynomial has only so many.
            let value = expr.evaluate(&|symbol| match found.get(&symbol) {
                Some(value) if Some(symbol) != clock => *value,
                _ => 0.0,
            });
            coefficients.push(value / factorial);
            let Some(clock) = clock.filter(|clock| expr.contains(*clock)) else {
                return coefficients.iter().all(|value| value.is_finite()).then_some(coefficients);
            };
            expr = expr.differentiate(clock);
            factorial *= f64::from(u32::try_from(power + 1).ok()?);
        }
        None
    }

    /// A term in variables of these names.
    pub(super) fn of_several(&self, text: &str, variables: &[String]) -> Result<OfSeveral, NothingToSimulate> {
        let ReadTerm { expr, places, found } = self.read(text, variables)?;
        Ok(Arc::new(move |values| {
            expr.evaluate(&|symbol| match places.get(&symbol) {
                Some(place) => values.get(*place).copied().unwrap_or(f64::NAN),
                None => found.get(&symbol).copied().unwrap_or(f64::NAN),
            })
        }))
    }

    fn read(&self, text: &str, variables: &[String]) -> Result<ReadTerm, NothingToSimulate> {
        let table = SymbolTable::default();
        let places = BTreeMap::new();
        let mut reader = Reader { known: self.value, variables, places, table, found: BTreeMap::new(), missing: false };
        let parsed: Result<Expr, _> = parse(text.trim(), &mut reader);
        let Reader { places, found, missing, .. } = reader;
        let expr =
            parsed.map_err(|_| if missing { NothingToSimulate::ValueMissing } else { NothingToSimulate::Unread })?;
        Ok(ReadTerm { expr, places, found })
    }

    /// The axes of the scene, in order.
    pub(super) fn axes(&self) -> Vec<Axis> {
        self.scene.axes.rectangular().into_iter().map(|(axis, _)| axis).collect()
    }

    /// The mass of a body, or of what a body consists of.
    pub(super) fn mass(&self, body: &str) -> Result<f64, NothingToSimulate> {
        let instant = self.index + 1;
        if let Some(StageMass::Burn { term, .. }) = self.scene.stage_mass(body, instant) {
            return self.term(term);
        }
        let mass_of =
            |member: &str| match (self.scene.mass_since(member, instant), self.scene.mass_term(member, instant)) {
                (Some(since), _) => self.named(&format!("m_{member}{since}")),
                (None, Some(term)) => self.term(term),
                _ => self.named(&format!("m_{member}")).or_else(|missing| {
                    let weight = self.named(&format!("W_{member}")).map_err(|_| missing)?;
                    Ok(weight / self.named("g")?)
                }),
            };
        let whole: f64 = self.scene.members(body).into_iter().map(mass_of).sum::<Result<_, _>>()?;
        // A mass that drops out of every equation is written as none.
        if whole > 0.0 { Ok(whole) } else { Err(NothingToSimulate::ValueMissing) }
    }

    /// The moment of inertia of what carries the particles of an arm; none of a light one.
    pub(super) fn inertia(&self, rotor: Option<&String>) -> Result<f64, NothingToSimulate> {
        let body = rotor.and_then(|rotor| self.scene.bodies.get(rotor));
        body.and_then(|body| body.inertia.as_ref()).map_or(Ok(0.0), |term| self.term(term))
    }

    /// The mass of a body whose motion does not depend on it: 1 kg where it is neither given nor solved.
    pub(super) fn any_mass(&self, body: &str) -> f64 {
        self.mass(body).unwrap_or(1.0)
    }

    /// The name of a component of the velocity of a body after the stage.
    pub(super) fn velocity_after(&self, body: &str, axis: Axis) -> String {
        self.velocity_name(body, self.index + 2, axis)
    }

    /// The name of a component of the velocity of a body before the stage.
    pub(super) fn start_name(&self, body: &str, axis: Axis) -> String {
        self.velocity_name(body, self.index + 1, axis)
    }

    fn velocity_name(&self, body: &str, instant: usize, axis: Axis) -> String {
        format!("v_{body}{instant}{}", self.letter(axis))
    }

    /// The ending of the name of a component: `.x`; empty where there is only one axis.
    pub(super) fn letter(&self, axis: Axis) -> String {
        if self.axes().len() > 1 { format!(".{}", axis.letter()) } else { String::new() }
    }

    /// A component of the velocity of a body before the stage.
    pub(super) fn velocity_before(&self, body: &str, axis: Axis) -> Result<f64, NothingToSimulate> {
        self.named(&self.velocity_name(body, self.index + 1, axis))
    }

    /// The components of the velocity of a body before the stage.
    pub(super) fn velocities_before<const D: usize>(
        &self,
        body: &str,
        axes: [Axis; D],
    ) -> Result<[f64; D], NothingToSimulate> {
        let mut all = [0.0; D];
        for (component, axis) in all.iter_mut().zip(axes) {
            *component = self.velocity_before(body, axis)?;
        }
        Ok(all)
    }

    /// The acceleration of free fall along an axis: with its sign, and 0 where weight has no part along it.
    pub(super) fn gravity(&self, axis: Axis) -> Result<f64, NothingToSimulate> {
        let down = self.scene.axes.rectangular().into_iter().find(|(listed, _)| *listed == axis);
        match down.map(|(_, senses)| senses.positive).as_deref() {
            Some("upwards") if self.scene.plane == Plane::Vertical => Ok(-self.named("g")?),
            Some("downwards") if self.scene.plane == Plane::Vertical => self.named("g"),
            _ => Ok(0.0),
        }
    }

    /// The acceleration of a body that falls, along an axis: with its sign; along the string over a pulley on which it hangs later.
    pub(super) fn sinking(&self, body: &str, axis: Axis) -> Result<f64, NothingToSimulate> {
        let component = self.gravity(axis)?;
        let sinks = self.scene.sinks(self.index, body).filter(|_| self.axes().len() == 1);
        match sinks {
            Some(1) if component == 0.0 => self.named("g"),
            Some(_) if component == 0.0 => Ok(-self.named("g")?),
            _ => Ok(component),
        }
    }

    /// The ending of the names of this stage's quantities: `[hit]`, `[2]`; empty where it is the only stage.
    pub(super) fn suffix(&self) -> String {
        let stages = &self.scene.stages;
        match stages.get(self.index).and_then(momentous_scene::Stage::name) {
            Some(name) if stages.len() > 1 => format!("[{name}]"),
            _ if stages.len() > 1 => format!("[{}]", self.index + 1),
            _ => String::new(),
        }
    }

    /// The time for which the stage lasts, where no term says so.
    pub(super) fn duration(&self) -> Result<f64, NothingToSimulate> {
        self.named(&format!("dt{}", self.suffix()))
    }
}
