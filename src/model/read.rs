//! Reading an author's terms against the names of the scene.

use momentous_expr::Expr;
use momentous_expr::Names;
use momentous_expr::Symbol;
use momentous_expr::SymbolEntry;
use momentous_expr::parse;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_fault::Span;
use momentous_fault::did_you_mean;
use momentous_quantity::Dimension;
use momentous_quantity::Quantity;
use momentous_quantity::Rational;
use momentous_quantity::UnitSystem;
use momentous_quantity::coherent_unit;
use momentous_quantity::dimension_name;
use momentous_scene::Stage;
use momentous_scene::Term;

use super::Builder;
use super::Name;
use super::QuantityKind;
use super::VectorName;
use super::name::is_bare_name;
use super::wording::of_several_stages;
use super::wording::quoted;

/// Keys of stages by which an author names a quantity.
const KEYS: &[&str] = &["distance", "during", "duration", "height", "length"];

/// Which potential energies have names.
const POTENTIAL_ENERGIES: &str = "`V_A1` is the potential energy of the weight of a body, in a vertical plane with an axis that points up or down; `V_spring1` is that of the spring of a `spring` stage or of a `central` one, and where one spring follows another it needs the stage: `V_spring2[2]`";

/// Resolves the names of one term; names that the scene does not make are noted.
struct Resolver<'b, 's> {
    builder: &'b mut Builder<'s>,
    unknown: Vec<String>,
}

impl Names for Resolver<'_, '_> {
    fn symbol(&mut self, name: &str) -> Option<Symbol> {
        let symbol = self.builder.resolve(name).or_else(|| self.builder.unmeasured_symbol(name));
        if symbol.is_none() {
            self.unknown.push(name.to_owned());
        }
        symbol
    }

    fn literal(&mut self, text: &str) -> Option<Symbol> {
        self.builder.literal(text)
    }
}

impl Builder<'_> {
    /// A value with a unit, as a symbol that is known.
    pub(super) fn literal(&mut self, text: &str) -> Option<Symbol> {
        let quantity = Quantity::parse(text).ok()?;
        let entry = SymbolEntry { name: text.to_owned(), dimension: quantity.unit.dimension(), meaning: String::new() };
        let symbol = self.symbols.intern(entry);
        if symbol.index() == self.names.len() {
            self.names.push(Name::of(QuantityKind::Value(text.to_owned()), ""));
        }
        if !self.literals.iter().any(|(literal, _)| *literal == symbol) {
            if quantity.unit.dimension() == Dimension::NONE {
                self.system.fixed.insert(symbol, Expr::measured(&quantity.value, &quantity.unit));
            }
            self.literals.push((symbol, quantity));
        }
        Some(symbol)
    }

    /// Reads a term that stands for a quantity of a dimension. A bare name that is not known yet becomes one, with the
    /// meaning of the place where it stands.
    pub(super) fn read(&mut self, term: &Term, dimension: Dimension, meaning: &str, path: &Path) -> Expr {
        let text = term.0.trim();
        let fraction = fraction_with_a_unit(text, dimension);
        let text = fraction.as_deref().unwrap_or(text);
        if is_bare_name(text) && self.resolve(text).is_none() {
            let symbol = self.symbol_of(Name::written(text), dimension, meaning);
            self.free.insert(symbol);
            self.named_at(symbol, path);
            return symbol.into();
        }
        let expr = self.read_any(text, path);
        self.measure(&expr, dimension);
        let misread = self.misread(&expr, text);
        if let Expr::Symbol(symbol) = expr {
            if self.symbols.entry(symbol).meaning.is_empty() {
                self.symbols.describe(symbol, meaning.to_owned());
                self.named_at(symbol, path);
            } else {
                self.not_the_running_time(symbol, path);
            }
        }
        match expr.dimension(&self.symbols) {
            Ok(measured) if measured == dimension || expr.is_zero() => {}
            Ok(measured) => {
                let message = format!(
                    "{meaning} must be {}, but `{text}` is {}",
                    dimension_name(dimension),
                    dimension_name(measured)
                );
                let help = match misread {
                    Some(help) => help,
                    None if dimension == Dimension::NONE => {
                        "write a number without a unit, or a ratio in which the units cancel".to_owned()
                    }
                    None => format!("write it in a unit such as `{}`", coherent_unit(dimension, UnitSystem::Si)),
                };
                self.faults.push(Fault::new(Code::Dimension, message).help(help).at_path(path.clone()));
            }
            Err(clash) => {
                let unit = |dimension| coherent_unit(dimension, UnitSystem::Si).to_string();
                let message = format!("{meaning} has no dimension: {}", clash.sentence(&self.symbols, &unit));
                self.faults.push(
                    Fault::new(Code::Dimension, message)
                        .help("check the units of what it contains")
                        .at_path(path.clone()),
                );
            }
        }
        expr
    }

    /// The reading for which a text of the wrong dimension was taken, where it may mean something else: a name of the scene, or
    /// `2m` for `2*m`.
    fn misread(&self, expr: &Expr, text: &str) -> Option<String> {
        let Expr::Symbol(symbol) = expr else { return None };
        let Some((_, quantity)) = self.literals.iter().find(|(literal, _)| literal == symbol) else {
            let meaning = &self.symbols.entry(*symbol).meaning;
            let is_of_the_scene = !meaning.is_empty() && !self.free.contains(symbol);
            return is_of_the_scene.then(|| format!("`{text}` stands for {meaning}: choose another name"));
        };
        let unit = quantity.unit.to_string();
        (self.given.contains(&unit) && !quantity.value.is_zero()).then(|| {
            let number = &quantity.value;
            format!(
                "{number} {unit} is a value with a unit: for {number} times a quantity `{unit}` write `{number}*{unit}`"
            )
        })
    }

    /// A name that is asked and whose dimension is not said yet; a pure number, unless its place says otherwise.
    pub fn unmeasured_symbol(&mut self, name: &str) -> Option<Symbol> {
        self.unmeasured.contains(name).then(|| self.symbol_of(Name::written(name), Dimension::NONE, ""))
    }

    /// Gives a name the dimension that a term of a known one needs, where its dimension is the only one that is not said.
    pub(super) fn measure(&mut self, term: &Expr, dimension: Dimension) {
        let is_open = |symbol: &Symbol| self.unmeasured.contains(&self.symbols.entry(*symbol).name);
        let [open] = term.symbols().into_iter().filter(is_open).collect::<Vec<_>>()[..] else { return };
        let slope = term.differentiate(open);
        if let (false, Ok(measured)) = (slope.contains(open), slope.dimension(&self.symbols)) {
            self.unmeasured.remove(&self.symbols.entry(open).name);
            self.symbols.measure(open, dimension / measured);
        }
    }

    /// The same, for a quantity that is positive.
    pub(super) fn read_positive(&mut self, term: &Term, dimension: Dimension, meaning: &str, path: &Path) -> Expr {
        let expr = self.read(term, dimension, meaning, path);
        self.system.positive.extend(multiplied(&expr));
        expr
    }

    /// Whether a text is a term in quantities of the scene.
    pub fn is_term(&mut self, text: &str) -> bool {
        parse(text, &mut Resolver { builder: self, unknown: Vec::new() }).is_ok()
    }

    /// Reads a term of any dimension; faults are noted, and zero is returned in their place.
    pub(super) fn read_any(&mut self, text: &str, path: &Path) -> Expr {
        let mut resolver = Resolver { builder: self, unknown: Vec::new() };
        let parsed = parse(text, &mut resolver);
        let unknown = resolver.unknown;
        match parsed {
            Ok(expr) if is_beyond_numbers(&expr) => {
                let fault = Fault::new(Code::Value, format!("a part of `{}` has no value", text.trim()));
                let help = "write numbers below 1e300 in magnitude, and do not divide by zero";
                self.faults.push(fault.help(help).at_path(path.clone()));
                Expr::zero()
            }
            Ok(expr) => {
                self.need_units(&expr, path);
                expr
            }
            Err(fault) => {
                let mut report = match unknown.last() {
                    Some(name) => {
                        self.early.insert(name.clone());
                        self.unknown_name(name)
                    }
                    None => Fault::new(Code::Syntax, fault.message.clone()),
                };
                if report.help.is_none() {
                    report.help = fault.help;
                }
                self.faults.push(report.at_path(path.clone()).within(Span { start: fault.start, end: fault.end }));
                Expr::zero()
            }
        }
    }

    /// The fault of a name that the scene does not make.
    pub(super) fn unknown_name(&mut self, name: &str) -> Fault {
        if let Some(fault) = self.about_a_moving_point(name).or_else(|| self.no_vector(name)) {
            return fault;
        }
        let fault = Fault::new(Code::UnknownName, format!("the name `{name}` is not known in this scene"));
        let is_stored = |name: &Name| name.kind == QuantityKind::PotentialEnergy && name.instant.is_some();
        if Name::parse(name).as_ref().is_some_and(is_stored) {
            return fault.help(POTENTIAL_ENERGIES);
        }
        if let Some(help) = self.not_alone(name) {
            return fault.help(help);
        }
        if let Some(help) = self.extreme_distance(name) {
            return fault.help(help);
        }
        let known: Vec<&str> = self.symbols.iter().map(|(_, entry)| entry.name.as_str()).collect();
        match did_you_mean(name, known.iter().copied()) {
            Some(near) => fault.help(format!("did you mean `{near}`?")),
            None if Name::parse(name).is_some_and(|name| self.is_said_by_a_key(&name)) => fault.help(
                "the stage itself gives it a name, which stands without brackets: `distance: s`, and ask for `s`",
            ),
            None if is_bare_name(name) && !name.contains('_') => {
                fault.help("give it under `given`, or name it at its place in the scene, as `restitution: e` does")
            }
            None => fault.help("give it under `given`, or use a name that the scene defines, such as `v_A1`"),
        }
    }
}

impl Builder<'_> {
    /// The fault of a magnitude or an angle of what is no vector: of a name that is not known, or of one number.
    fn no_vector(&mut self, name: &str) -> Option<Fault> {
        let vectors = match VectorName::parse(name)? {
            VectorName::AngleBetween([one, other]) => vec![one, other],
            VectorName::Magnitude(vector) => vec![vector],
        };
        let wrong = vectors
            .into_iter()
            .find(|vector| self.axis_direction(vector).is_none() && self.components_of(vector).is_none())?;
        if self.resolve(wrong).is_none() {
            return Some(self.unknown_name(wrong));
        }
        let fault = Fault::new(Code::UnknownName, format!("`{wrong}` has no components here, so there is no `{name}`"));
        Some(fault.help(format!("it is one number: ask for `{wrong}`")))
    }

    /// The part that a name lacks where several quantities have it in common: the stage, or the component.
    fn not_alone(&mut self, name: &str) -> Option<String> {
        let parsed = Name::parse(name)?;
        if parsed.instant.is_some() && parsed.stage.is_some() {
            let bare = Name { stage: None, ..parsed };
            let is_known = self.symbols.find(&self.canonical(&bare).to_string()).is_some();
            return is_known.then(|| format!("its instant says when it is so: write `{bare}`"));
        }
        let in_stages = self.names_in_stages(name);
        if in_stages.len() > 1 {
            return Some(of_several_stages(in_stages));
        }
        let parts: Vec<String> = self.axes.iter().map(|(axis, _)| format!("{name}.{}", axis.letter())).collect();
        let is_vector = parts.len() > 1 && parts.iter().all(|part| self.symbols.find(part).is_some());
        is_vector.then(|| format!("it is a vector here, which is named by its components: {}", quoted(parts, " and ")))
    }

    /// The facts that the least or the greatest distance of a body lacks that moves under gravity on an orbit of no stated shape.
    fn extreme_distance(&self, name: &str) -> Option<&'static str> {
        let name = Name::parse(name).filter(|name| name.kind == QuantityKind::Position && name.instant.is_none())?;
        name.component.as_deref().filter(|which| ["min", "max"].contains(which))?;
        let is_shapeless = |stage: &Stage| matches!(stage, Stage::Central(central) if central.body == name.subject && central.gravity.is_some() && central.orbit.is_none());
        let help = "write `orbit: ellipse` or `orbit: parabola` in the stage";
        self.scene.stages.iter().any(is_shapeless).then_some(help)
    }

    /// Whether a name is that of a key of a stage of the scene.
    fn is_said_by_a_key(&self, name: &Name) -> bool {
        let is_stage = name.stage.as_ref().is_some_and(|stage| self.timeline.stage(self.scene, stage).is_some());
        is_stage && matches!(&name.kind, QuantityKind::Own(key) if KEYS.contains(&key.as_str()))
    }

    /// The fault of a moment about a body, which moves.
    fn about_a_moving_point(&self, name: &str) -> Option<Fault> {
        let is_moment = |kind: &QuantityKind| {
            matches!(kind, QuantityKind::AngularMomentum | QuantityKind::Moment | QuantityKind::AngularMomentumRate)
        };
        let name = Name::parse(name).filter(|name| is_moment(&name.kind))?;
        let instant = name.instant.is_some() && self.timeline.bodies().any(|body| body == name.subject);
        instant.then(|| moving_point(&self.called(&name.subject)))
    }
}

/// The fault of moments taken about what moves.
pub(super) fn moving_point(what: &str) -> Fault {
    let message = format!("{what} moves: angular momentum is taken about a fixed point or the centre of mass");
    let help =
        "declare a fixed point, `points: { O: { name: the post, at: { x: 1 m } } }`, or take the centre of mass `G`";
    Fault::new(Code::Value, message).help(help)
}

/// The quantity of which a term is a positive multiple, so that both are positive: `m` of `3*m`.
fn multiplied(term: &Expr) -> Option<Symbol> {
    let is_number = |factor: &&Expr| factor.as_number().is_some_and(|number| *number > Rational::ZERO);
    match term {
        Expr::Symbol(symbol) => Some(*symbol),
        Expr::Product(factors) => {
            let mut others = factors.iter().filter(|factor| !is_number(factor));
            if let (Some(Expr::Symbol(symbol)), None) = (others.next(), others.next()) { Some(*symbol) } else { None }
        }
        _ => None,
    }
}

/// Whether a part of a term that is made of numbers alone is too large for any use, or has no value.
fn is_beyond_numbers(expr: &Expr) -> bool {
    if expr.symbols().is_empty() {
        let size = expr.evaluate(&|_| 0.0).abs();
        return expr.as_number().is_none() && (size.is_nan() || size >= 1e300);
    }
    expr.children().any(is_beyond_numbers)
}

/// `16/3 J` as `16 J/3`, where that is what is measured so: the unit is that of the whole.
fn fraction_with_a_unit(text: &str, dimension: Dimension) -> Option<String> {
    let (above, rest) = text.split_once('/')?;
    let end = rest.find(|letter: char| !letter.is_ascii_digit() && letter != '.')?;
    let (below, unit) = rest.split_at(end);
    let whole = format!("{} {}", above.trim(), unit.trim());
    let is_meant = |quantity: Quantity| dimension != Dimension::NONE && quantity.unit.dimension() == dimension;
    Quantity::parse(&whole).is_ok_and(is_meant).then(|| format!("{whole}/{below}"))
}
