//! The numbers that a figure may show: on a problem sheet what is given, in a solution also what was solved.

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::Names;
use momentous_expr::Symbol;
use momentous_expr::parse;
use momentous_model::Direction;
use momentous_model::Model;
use momentous_model::Name;
use momentous_model::QuantityKind;
use momentous_model::Timeline;
use momentous_model::VectorKind;
use momentous_model::is_reversed;
use momentous_problem::Worked;
use momentous_scene::Axis;
use momentous_scene::Scene;
use momentous_scene::Stage;
use momentous_scene::Term;
use momentous_solve::Equation;
use momentous_solve::Statement;

use super::super::terms::display::Display;
use super::super::terms::display::PrintedTerms;
use super::super::terms::manner::MannerCache;
use super::cache::PictureCache;
use super::compass::Compass;
use super::oblique::Oblique;

/// How much a figure may show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scope {
    /// The values that the sheet tells.
    Given,
    /// Those, and every value that was solved.
    Solved,
}

/// Quantities for the figures of a variant. Under [`Scope::Given`] nothing that was solved passes, so no sheet can tell it.
#[derive(Clone)]
pub(crate) struct Quantities<'a> {
    pub(super) worked: Worked<'a>,
    manners: &'a MannerCache,
    pub(super) pictures: &'a PictureCache,
    pub(super) timeline: Timeline,
    pub(super) axes: Vec<Axis>,
    scope: Scope,
    /// The values that a figure assumes of quantities that nobody needs to know, such as a mass that cancels.
    assumed: Vec<(Symbol, f64)>,
}

/// How far the definitions of quantities are followed that the plan had no need to solve.
const DEEPEST: usize = 4;
/// The angle of a slope or a cord that is not given, as a sketch has it.
pub(super) const SKETCHED: f64 = 0.42;

/// The names of a model, for terms that an author wrote.
struct Known<'a>(&'a Model);

impl Names for Known<'_> {
    fn symbol(&mut self, name: &str) -> Option<Symbol> {
        self.0.symbol_of(name)
    }

    fn literal(&mut self, text: &str) -> Option<Symbol> {
        self.0.symbols.find(text)
    }
}

impl<'a> Quantities<'a> {
    pub(crate) fn new(worked: Worked<'a>, scope: Scope, manners: &'a MannerCache, pictures: &'a PictureCache) -> Self {
        let scene = &worked.problem.loaded().draft.scene;
        let axes = scene.axes.rectangular().into_iter().map(|(axis, _)| axis).collect();
        Self { worked, manners, pictures, timeline: Timeline::new(scene), axes, scope, assumed: Vec::new() }
    }

    /// The directions of the scene on drawings.
    pub(super) fn compass(&self) -> &'a Compass {
        self.pictures.compass(self.scene())
    }

    pub(super) fn scope(&self) -> Scope {
        self.scope
    }

    pub(super) fn scene(&self) -> &'a Scene {
        &self.worked.problem.loaded().draft.scene
    }

    pub(super) fn model(&self) -> &'a Model {
        self.worked.problem.model()
    }

    /// The value of a quantity in SI units, where it may be shown.
    pub(super) fn value(&self, symbol: Symbol) -> Option<f64> {
        let form = self.worked.form;
        // What is drawn and not printed belongs to another form of the problem.
        let on_sheet = || form.on_sheet.contains(&symbol) || form.printed.contains(&symbol);
        let told = || on_sheet() || self.is_any(symbol) || self.is_assumed(symbol);
        if self.scope == Scope::Given && !told() {
            return None;
        }
        self.known(symbol, DEEPEST)
    }

    /// The value that was solved or assumed, or that follows at once from an equation that was not needed.
    fn known(&self, symbol: Symbol, depth: usize) -> Option<f64> {
        let assumed = self.assumed.iter().find(|(assumed, _)| *assumed == symbol).map(|(_, value)| *value);
        let solved = || self.worked.variant.value(symbol).map(|bounded| bounded.value);
        let value = assumed.or_else(solved).filter(|value| value.is_finite());
        if value.is_some() || depth == 0 || self.scope == Scope::Given {
            return value;
        }
        let symbolic = Expr::from(symbol);
        let definition = |equation: &Equation| match &equation.statement {
            Statement::Equal { left, right } if *left == symbolic => Some(right.clone()),
            Statement::Equal { left, right } if *right == symbolic => Some(left.clone()),
            _ => None,
        };
        self.model().system.equations.iter().filter_map(definition).find_map(|term| {
            let value = term.evaluate(&|symbol| self.known(symbol, depth - 1).unwrap_or(f64::NAN));
            value.is_finite().then_some(value)
        })
    }

    /// The same quantities with one more value, for a figure that needs it and an explanation that does not.
    pub(super) fn assuming(&self, symbol: Symbol, value: f64) -> Self {
        let mut assuming = self.clone();
        assuming.assumed.push((symbol, value));
        assuming
    }

    /// Whether a quantity has a value only because a figure needs one.
    pub(super) fn is_assumed(&self, symbol: Symbol) -> bool {
        self.assumed.iter().any(|(assumed, _)| *assumed == symbol)
    }

    /// The name of a quantity of a stage, as the model makes it: `dt`, `dt[skid]`.
    pub(super) fn staged(&self, base: &str, stage: usize) -> String {
        let stages = &self.scene().stages;
        match stages.get(stage).and_then(Stage::name) {
            _ if stages.len() < 2 => base.to_owned(),
            Some(name) => format!("{base}[{name}]"),
            None => format!("{base}[{}]", stage + 1),
        }
    }

    /// The slope of the floor in a stage: its angle, positive where the first axis rises, and how it is written. An angle
    /// that may not be shown is sketched and has no label.
    pub(super) fn slope(&self, stage: usize) -> Option<(f64, Option<Math>)> {
        let slope = self.model().slopes.iter().find(|slope| slope.stage == stage)?;
        let (angle, label) = self.angle_or_sketch(&slope.angle);
        Some((if slope.rises { angle } else { -angle }, label))
    }

    /// An angle with its label, or the angle of a sketch without one, or with a question mark.
    pub(super) fn angle_or_sketch(&self, angle: &Expr) -> (f64, Option<Math>) {
        match self.evaluate(angle) {
            Some(value) => (value, Some(self.symbolic(angle))),
            None => (SKETCHED, self.asked(angle)),
        }
    }

    /// Whether words point against the only axis.
    pub(super) fn is_backwards(&self, direction: Option<&Term>) -> bool {
        let words = direction.map_or("", |term| term.0.trim());
        is_reversed(words) || self.scene().axes.rectangular().iter().any(|(_, senses)| senses.negative == words)
    }

    /// Whether a quantity stands for any value, so that no number of the problem means anything by itself.
    pub(super) fn is_any(&self, symbol: Symbol) -> bool {
        self.worked.form.free.contains(&symbol)
    }

    /// Whether a symbol is a value that the author wrote into a term.
    pub(super) fn is_literal(&self, symbol: Symbol) -> bool {
        self.model().literals.iter().any(|(literal, _)| *literal == symbol)
    }

    /// Whether the numbers of the figure mean something.
    pub(super) fn has_numbers(&self) -> bool {
        self.worked.form.free.is_empty()
    }

    /// The value of the quantity of that name.
    pub(super) fn named(&self, name: &str) -> Option<f64> {
        self.value(self.model().symbol_of(name)?)
    }

    /// The value of a term all of whose quantities may be shown.
    pub(super) fn evaluate(&self, expr: &Expr) -> Option<f64> {
        let value = expr.evaluate(&|symbol| self.value(symbol).unwrap_or(f64::NAN));
        value.is_finite().then_some(value)
    }

    /// A term of the author's, read again.
    pub(super) fn term(&self, term: &Term) -> Option<Expr> {
        parse(term.0.trim(), &mut Known(self.model())).ok()
    }

    /// A term in symbols.
    pub(super) fn symbolic(&self, expr: &Expr) -> Math {
        Display { worked: self.worked, manners: self.manners, shown: &PrintedTerms::default() }.symbolic(expr)
    }

    /// A term in symbols without the sign in front of it, where an arrow shows the sense.
    pub(super) fn unsigned(&self, expr: &Expr) -> Math {
        let math = self.symbolic(expr);
        if math.begins_with_minus() { self.symbolic(&-expr.clone()) } else { math }
    }

    /// A direction as a unit vector along x and y.
    pub(super) fn direction(&self, direction: &Direction) -> Option<[f64; 2]> {
        if direction.across {
            return Some(self.along(2, if direction.quarters == 0 { 1.0 } else { -1.0 }));
        }
        let [cosine, sine] = direction.cosine_and_sine();
        let plane = [self.evaluate(&cosine)?, self.evaluate(&sine)?];
        Some(self.oblique().map_or(plane, |oblique| oblique.place([plane[0], plane[1], 0.0])))
    }

    /// How a scene in space lies on paper.
    fn oblique(&self) -> Option<Oblique> {
        if self.axes.len() == 3 { Oblique::of(&self.scene().axes.rectangular()) } else { None }
    }

    /// A component along the axis of that position, as a vector.
    pub(super) fn along(&self, position: usize, value: f64) -> [f64; 2] {
        let mut components = [0.0; 3];
        components[position.min(2)] = value;
        self.oblique().map_or([components[0], components[1]], |oblique| oblique.place(components))
    }

    /// Components along the scene's axes as a vector along x and y, or as it lies on paper where there are three.
    pub(super) fn along_axes(&self, components: &[f64]) -> Option<[f64; 2]> {
        match (components, &self.axes[..]) {
            ([only], [Axis::Y]) => Some([0.0, *only]),
            ([only], [_]) => Some([*only, 0.0]),
            ([x, y], [_, _]) => Some([*x, *y]),
            ([x, y, z], [_, _, _]) => Some(self.oblique()?.place([*x, *y, *z])),
            _ => None,
        }
    }

    /// A quantity of a body at an instant, under the instant since which the body has its velocity.
    pub(super) fn since(&self, kind: QuantityKind, body: &str, instant: usize) -> Name {
        Name::of(kind, body).at(self.timeline.naming_instant(body, instant))
    }

    /// The name of a body's velocity at an instant, without a component.
    pub(super) fn velocity_name(&self, body: &str, instant: usize) -> String {
        self.since(QuantityKind::Velocity, body, instant).to_string()
    }

    /// A body's velocity along x and y (radially and transversely, for polar axes), from whichever components, along the
    /// axes or along a line of impact, or from its speed and direction.
    pub(super) fn velocity(&self, body: &str, instant: usize) -> Option<[f64; 2]> {
        let name = self.velocity_name(body, instant);
        match &self.axes[..] {
            [] => {
                // What only turns has no component away from the centre.
                let radial = self.model().symbol_of(&format!("{name}.r"));
                Some([radial.map_or(Some(0.0), |radial| self.value(radial))?, self.named(&format!("{name}.theta"))?])
            }
            [_] => self.along_axes(&[self.named(&name)?]),
            axes => {
                let components = axes.iter().map(|axis| self.named(&format!("{name}.{}", axis.letter())));
                let components: Option<Vec<f64>> = components.collect();
                let along_axes = components.and_then(|components| self.along_axes(&components));
                along_axes.or_else(|| self.turned_velocity(&name)).or_else(|| self.polar_velocity(body, instant))
            }
        }
    }

    /// From components along and across a line of impact.
    fn turned_velocity(&self, name: &str) -> Option<[f64; 2]> {
        self.model().frames.iter().enumerate().find_map(|(stage, frame)| {
            let [cosine, sine] = self.direction(&frame.as_ref()?.normal)?;
            let component = |letter: &str| {
                let plain = self.named(&format!("{name}.{letter}[{}]", stage + 1));
                plain.or_else(|| self.named(&format!("{name}.{letter}")))
            };
            let (along, across) = (component("n")?, component("t")?);
            Some([along * cosine - across * sine, along * sine + across * cosine])
        })
    }

    /// From speed and direction.
    fn polar_velocity(&self, body: &str, instant: usize) -> Option<[f64; 2]> {
        let value = |kind| self.named(&self.since(kind, body, instant).to_string());
        let speed = value(QuantityKind::Speed)?;
        let angle = value(QuantityKind::Direction(VectorKind::Velocity))?;
        Some([speed * libm::cos(angle), speed * libm::sin(angle)])
    }

    /// A body's place at an instant, from the origin.
    pub(super) fn position(&self, body: &str, instant: usize) -> Option<[f64; 2]> {
        let components = match &self.axes[..] {
            [_] => vec![self.named(&format!("r_{body}{instant}"))?],
            axes => {
                let component = |axis: &Axis| self.named(&format!("r_{body}{instant}.{}", axis.letter()));
                axes.iter().map(component).collect::<Option<_>>()?
            }
        };
        self.along_axes(&components)
    }

    /// When an instant is, as an adverbial phrase.
    pub(super) fn when(&self, instant: usize) -> String {
        self.model().when(self.scene(), instant)
    }

    /// The name of a body in a sentence.
    pub(super) fn called(&self, body: &str) -> String {
        self.scene().called(body)
    }
}
