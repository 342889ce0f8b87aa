//! One variant simulated stage by stage, with everything about it that can be compared with the laws.

use std::cell::Cell;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_model::Instant;
use momentous_model::Name;
use momentous_model::QuantityKind;
use momentous_model::Timeline;
use momentous_model::VectorKind;
use momentous_scene::Scene;
use momentous_scene::Stage;
use momentous_simulate::scene::Asked;
use momentous_simulate::scene::NothingToSimulate;
use momentous_simulate::scene::Procedure;
use momentous_simulate::scene::Reached;
use momentous_simulate::scene::RecordedMotion;
use momentous_simulate::scene::angle_from;
use momentous_simulate::scene::follow;
use momentous_simulate::scene::measure;
use momentous_simulate::scene::value_of;
use momentous_simulate::scene::watch;

use super::case::Case;

/// The share of a momentum or an energy below which a change of it is none: far above errors of runs, far below changes that
/// anybody would ask for.
pub(super) const UNCHANGED: f64 = 1e-7;

/// A simulation of a variant.
pub(super) struct Witness<'a> {
    case: &'a Case<'a>,
    timeline: Timeline,
    tolerance: f64,
    found: BTreeMap<String, Reached>,
    /// The sums that bodies carry together after a stage, each with the bodies.
    sums: Vec<(Vec<String>, Reached)>,
    terms: Vec<Reached>,
    ways: BTreeSet<Procedure>,
    /// Why a stage was not simulated.
    pub nothing: Option<NothingToSimulate>,
    run: BTreeSet<usize>,
    used: RefCell<BTreeSet<Symbol>>,
    missing: RefCell<BTreeSet<Symbol>>,
    watched: Cell<bool>,
}

/// The values that the laws state and the simulation finds.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Comparison {
    pub stated: f64,
    pub found: f64,
    /// The error that the run and the stated value may have; the errors of inputs come on top.
    pub error: f64,
    /// Whether only the direction matters.
    pub turns: bool,
}

impl Comparison {
    /// How far what is found lies from what is said.
    pub(super) fn apart(&self) -> f64 {
        let apart = self.found - self.stated;
        let whole = core::f64::consts::TAU;
        if self.turns { apart - whole * libm::round(apart / whole) } else { apart }
    }
}

/// A value with the error that the simulation gives it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Measurement {
    pub value: f64,
    pub error: f64,
}

impl<'a> Witness<'a> {
    /// Simulates all stages, one after another, each from what is said of its start, or else from where the one before ended.
    pub(super) fn new(case: &'a Case<'a>, tolerance: f64) -> Self {
        let mut witness = Self {
            case,
            timeline: Timeline::new(case.scene),
            tolerance,
            found: BTreeMap::new(),
            sums: Vec::new(),
            terms: Vec::new(),
            ways: BTreeSet::new(),
            nothing: None,
            run: BTreeSet::new(),
            used: RefCell::default(),
            missing: RefCell::default(),
            watched: Cell::default(),
        };
        for stage in 0..case.scene.stages.len() {
            if witness.nothing.is_none() {
                witness.missing.borrow_mut().clear();
            }
            match witness.observed(stage) {
                Ok(observed) => {
                    witness.run.insert(stage);
                    witness.ways.extend(observed.ways);
                    let bodies = witness.interacting(stage);
                    witness.sums.extend(observed.sums.into_iter().map(|sum| (bodies.clone(), sum)));
                    witness.terms.extend(observed.terms);
                    witness.found.extend(observed.found.into_iter().map(|reached| (reached.name.clone(), reached)));
                }
                Err(reason) => witness.nothing = Some(reason),
            }
        }
        witness
    }

    /// The bodies that act on each other in a stage.
    fn interacting(&self, stage: usize) -> Vec<String> {
        if let Some(Stage::Interact(interact)) = self.case.scene.stages.get(stage) {
            return interact.between.clone();
        }
        self.timeline.alive(stage + 2).into_iter().map(str::to_owned).collect()
    }

    /// A stage as it is watched from its start to its end.
    pub(super) fn watched(&self, stage: usize) -> Option<Vec<RecordedMotion>> {
        follow(self.case.scene, stage, &|name| self.value(name), self.tolerance).ok()
    }

    /// By which ways something was found.
    pub(super) fn ways(&self) -> impl Iterator<Item = Procedure> {
        self.ways.iter().copied().chain(self.watched.get().then_some(Procedure::Measured))
    }

    /// The quantities of the variant that the simulation started from.
    pub(super) fn inputs(&self) -> BTreeSet<Symbol> {
        self.used.borrow().clone()
    }

    /// The place of a stage that a question names, or of the only one.
    pub(super) fn stage_of(&self, name: Option<&str>) -> Option<usize> {
        match name {
            Some(name) => self.timeline.stage(self.case.scene, name),
            None => (self.case.scene.stages.len() == 1).then_some(0),
        }
    }

    pub(super) fn scene(&self) -> &Scene {
        self.case.scene
    }

    pub(super) fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// The conditions by which the author picks among the solutions of the form.
    pub(super) fn conditions(&self) -> impl Iterator<Item = &str> {
        let form = self.case.problem.forms().get(self.case.variant.form());
        form.into_iter().flat_map(|form| &form.question.conditions).map(|(_, intended)| intended.text())
    }

    fn symbol(&self, name: &str) -> Option<Symbol> {
        self.case.problem.model().symbol_of(name)
    }

    /// The value of a quantity that the variant states, or that is put in its place.
    fn stated(&self, symbol: Symbol) -> Option<f64> {
        let other = self.case.replaced.iter().rev().find(|(known, _)| *known == symbol);
        let is_known = self.case.known.is_none_or(|known| known.contains(&symbol));
        other.map(|(_, value)| *value).or_else(|| Some(self.case.variant.value(symbol).filter(|_| is_known)?.value))
    }

    fn stated_by_name(&self, name: &str) -> Option<(Symbol, f64)> {
        let symbol = self.symbol(&self.since(name))?;
        Some((symbol, self.stated(symbol)?))
    }

    /// The stated value of a quantity, which is noted as one that was looked at.
    fn started_from(&self, name: &str) -> Option<f64> {
        let (symbol, value) = self.stated_by_name(name)?;
        self.used.borrow_mut().insert(symbol);
        Some(value)
    }

    /// The value from which the simulation starts: the stated one, else what a stage before reached.
    pub(super) fn value(&self, name: &str) -> Option<f64> {
        let reached = || self.found_as(name).map(|reached| reached.value);
        let value = self.started_from(name).or_else(reached).or_else(|| self.component(&self.since(name)));
        if value.is_none() && self.nothing.is_none() {
            self.missing.borrow_mut().extend(self.symbol(&self.since(name)));
        }
        value
    }

    /// The quantities without whose values a stage could not be simulated.
    pub(super) fn missing(&self) -> BTreeSet<Symbol> {
        self.missing.borrow().clone()
    }

    /// A component of a velocity of which speed and direction are said.
    fn component(&self, name: &str) -> Option<f64> {
        let name = Name::parse(name).filter(|name| name.kind == QuantityKind::Velocity)?;
        let (Some(Instant::Number(at)), Some(letter), 2) =
            (name.instant, name.component, self.case.scene.axes.rectangular().len())
        else {
            return None;
        };
        let said = |kind| self.stated_by_name(&Name::of(kind, &name.subject).at(at).to_string());
        let angle = said(QuantityKind::Direction(VectorKind::Velocity))?;
        let speed = said(QuantityKind::Speed)?;
        self.used.borrow_mut().extend([angle.0, speed.0]);
        match letter.as_str() {
            "x" => Some(speed.1 * libm::cos(angle.1)),
            "y" => Some(speed.1 * libm::sin(angle.1)),
            _ => None,
        }
    }

    /// A velocity under the name of the instant since which the body has it.
    pub(super) fn since(&self, name: &str) -> String {
        match Name::parse(name) {
            Some(name @ Name { kind: QuantityKind::Velocity, instant: Some(Instant::Number(at)), stage: None, .. }) => {
                let since = self.timeline.naming_instant(&name.subject, at);
                name.at(since).to_string()
            }
            _ => name.to_owned(),
        }
    }

    /// The value that the simulation finds of a quantity by name: itself, or measured on what it finds of the bodies.
    pub(super) fn seen(&self, name: &str) -> Option<Measurement> {
        let exact = self.found_as(name);
        exact
            .map(|reached| Measurement { value: reached.value, error: reached.error })
            .or_else(|| self.measured(name))
            .or_else(|| self.magnitude(name))
            .or_else(|| self.exchanged(name))
    }

    fn measured(&self, name: &str) -> Option<Measurement> {
        let entering = RefCell::new(BTreeMap::new());
        let value = |name: &str| {
            let entry = self.found_as(name).map(|reached| (reached.name.clone(), reached.error));
            entering.borrow_mut().extend(entry);
            self.found_as(name).map(|reached| reached.value).or_else(|| self.value(name))
        };
        let measured_value = self.asked(name, &|asked, alive| {
            // What nothing simulated enters would only repeat a formula.
            let measured = measure(self.case.scene, alive, asked, &value).filter(|_| !entering.borrow().is_empty());
            // Where no stage has been yet, the bodies are watched.
            let watched = || watch(self.case.scene, alive, asked, &value).filter(|_| asked.instant == 1);
            measured.or_else(|| watched().inspect(|_| self.watched.set(true)))
        });
        let measurement = self.as_seen(measured_value?);
        let entered: Vec<(String, f64)> = entering.borrow().clone().into_iter().collect();
        let off = |(moved, error): &(String, f64)| {
            let value = |name: &str| {
                let reached = self.found_as(name)?;
                Some(reached.value + if reached.name == *moved { *error } else { 0.0 })
            };
            let value = |name: &str| value(name).or_else(|| self.value(name));
            let other = self.asked(name, &|asked, alive| measure(self.case.scene, alive, asked, &value));
            other.map_or(0.0, |(other, _)| (other - measurement.value).abs())
        };
        Some(Measurement { error: measurement.error + entered.iter().map(off).sum::<f64>(), ..measurement })
    }

    /// The value of a quantity at the start by what is told of the bodies: part of something that is found.
    pub(super) fn started_with(&self, name: &str) -> Option<Measurement> {
        let value = |name: &str| self.value(name);
        let at_start = |asked: Asked<'_>, alive: &[&str]| {
            measure(self.case.scene, alive, asked, &value).filter(|_| asked.instant == 1)
        };
        self.asked(name, &at_start).map(|value| self.as_seen(value))
    }

    fn as_seen(&self, (value, scale): (f64, f64)) -> Measurement {
        Measurement { value, error: self.tolerance * value.abs().max(scale) }
    }

    /// Measures a quantity by its name, with the bodies that exist at its instant.
    fn asked<T>(&self, name: &str, measure: &dyn Fn(Asked<'_>, &[&str]) -> Option<T>) -> Option<T> {
        let parsed = Name::parse(name)?;
        let instant = match &parsed.instant {
            Some(Instant::Number(at)) => *at,
            Some(Instant::Named(named)) => self.timeline.instant(named)?,
            None => return None,
        };
        let component = parsed.component.as_deref();
        let base = &parsed.kind.spelling();
        measure(Asked { base, subject: &parsed.subject, instant, component }, &self.timeline.alive(instant))
    }

    /// The value of a term by what the simulation finds; `None` where it finds nothing in it.
    pub(super) fn evaluated(&self, expr: &Expr) -> Option<Measurement> {
        let model = self.case.problem.model();
        let finds = |symbol: &Symbol| self.seen(&model.symbols.entry(*symbol).name).is_some();
        expr.symbols().iter().any(finds).then(|| self.worked_out(expr))
    }

    /// The value of a term by what the simulation finds, and otherwise by what is stated.
    fn worked_out(&self, expr: &Expr) -> Measurement {
        let known = |symbol| {
            let name = &self.case.problem.model().symbols.entry(symbol).name;
            let said = || Measurement { value: self.stated(symbol).unwrap_or(f64::NAN), error: self.error_of(symbol) };
            self.seen(name).or_else(|| self.started_with(name)).unwrap_or_else(said)
        };
        let all: BTreeMap<_, Measurement> = expr.symbols().into_iter().map(|symbol| (symbol, known(symbol))).collect();
        let value = |symbol| all.get(&symbol).map_or(f64::NAN, |known| known.value);
        let mut error = 0.0;
        expr.slopes(&value, 1.0, &mut |symbol, slope| {
            error += slope.abs() * all.get(&symbol).map_or(0.0, |known| known.error);
        });
        Measurement { value: expr.evaluate(&value), error }
    }

    fn error_of(&self, symbol: Symbol) -> f64 {
        self.case.variant.value(symbol).map_or(0.0, |number| number.error)
    }

    /// A quantity of the variant with what the simulation finds of it.
    pub(super) fn comparison(&self, symbol: Symbol) -> Option<Comparison> {
        let name = &self.case.problem.model().symbols.entry(symbol).name;
        // An expression that a question names is what its parts make of it.
        let expression = || self.case.problem.model().expressions.get(&symbol).map(|term| self.worked_out(term));
        let measurement = self.seen(name).or_else(expression)?;
        Some(self.compared(symbol, self.stated(symbol)?, measurement))
    }

    fn compared(&self, symbol: Symbol, said: f64, measurement: Measurement) -> Comparison {
        let turns = matches!(
            self.case.problem.model().name(symbol).kind,
            QuantityKind::Direction(_) | QuantityKind::CountedDirection(_) | QuantityKind::AngleBetween(_)
        );
        Comparison { stated: said, found: measurement.value, error: measurement.error + self.error_of(symbol), turns }
    }

    /// A direction that is counted from somewhere.
    pub(super) fn direction(&self, symbol: Symbol, from: &str, clockwise: bool) -> Option<Comparison> {
        let name = self.case.problem.model().name(symbol);
        let velocity = Name { kind: QuantityKind::Velocity, ..name.clone() };
        velocity.instant.as_ref()?;
        let part = |letter: &str| self.seen(&velocity.clone().along(letter).to_string());
        let (x, y) = (part("x")?, part("y")?);
        let angle = angle_from(self.case.scene, from, [x.value, y.value, 0.0], &|name| self.value(name))?;
        let error = (x.error + y.error) / libm::hypot(x.value, y.value) + self.tolerance;
        let measurement = Measurement { value: if clockwise { -angle } else { angle }, error };
        Some(self.compared(symbol, self.stated(symbol)?, measurement))
    }

    /// Everything that is both said and found, under a name each.
    pub(super) fn comparisons(&self) -> BTreeMap<String, Comparison> {
        let mut all = BTreeMap::new();
        for (symbol, entry) in self.case.problem.model().symbols.iter() {
            all.extend(self.comparison(symbol).map(|comparison| (entry.name.clone(), comparison)));
        }
        for reached in self.found.values() {
            if let Some((symbol, said)) = self.stated_by_name(&reached.name) {
                let measurement = Measurement { value: reached.value, error: reached.error };
                all.insert(reached.name.clone(), self.compared(symbol, said, measurement));
            }
        }
        for (bodies, sum) in &self.sums {
            // The bodies as the problem says they end; the others of the scene have no part in it.
            let bodies: Vec<&str> = bodies.iter().map(String::as_str).collect();
            let said = |name: &str| self.started_from(name);
            if let Some((said, _)) = self.asked(&sum.name, &|asked, _| measure(self.case.scene, &bodies, asked, &said))
            {
                let comparison = Comparison { stated: said, found: sum.value, error: sum.error, turns: false };
                all.insert(format!("{} of all together", sum.name), comparison);
            }
        }
        for term in &self.terms {
            if let Some(said) = value_of(self.case.scene, &term.name, &|name| self.value(name)) {
                let comparison = Comparison { stated: said, found: term.value, error: term.error, turns: false };
                all.insert(format!("`{}` of the scene", term.name), comparison);
            }
        }
        all
    }

    /// Whether a stage was simulated.
    pub(super) fn has_run(&self, stage: usize) -> bool {
        self.run.contains(&stage)
    }

    /// The velocity (`v`), momentum (`p`) or kinetic energy (`T`) of a body at an instant, alone or within another.
    pub(super) fn carried(&self, base: &str, body: &str, instant: usize, letter: &str) -> Option<f64> {
        let component = Some(letter).filter(|letter| !letter.is_empty());
        let asked = Asked { base, subject: body, instant, component };
        Some(measure(self.case.scene, &[body], asked, &|name| self.known(name))?.0)
    }

    /// A value as it is found, else as it is told.
    pub(super) fn known(&self, name: &str) -> Option<f64> {
        self.found_as(name).map(|reached| reached.value).or_else(|| self.value(name))
    }

    fn found_as(&self, name: &str) -> Option<&Reached> {
        self.found.get(&self.since(name)).or_else(|| self.found.get(name))
    }
}
