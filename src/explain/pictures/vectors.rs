//! Velocities, momenta and impulses of a stage as labelled vectors of a drawing.

use std::sync::Arc;

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::name_math;
use momentous_figure::Form;
use momentous_figure::LabelledVector;
use momentous_model::ActingForce;
use momentous_model::Agent;
use momentous_model::ForceKind;
use momentous_model::Impulse;
use momentous_scene::Axis;
use momentous_scene::Stage;
use momentous_solve::Statement;

use super::compass::Compass;
use super::labels::factor;
use super::labels::product;
use super::quantities::Quantities;

/// Words in the name of a body that is drawn as a disc; other bodies are drawn as blocks.
const ROUND: &[&str] = &[
    "ball",
    "puck",
    "disc",
    "disk",
    "stone",
    "marble",
    "bead",
    "coin",
    "particle",
    "satellite",
    "planet",
    "bullet",
    "egg",
    "bob",
];

/// A vector along x and y with its label.
#[derive(Clone, Debug)]
pub(super) struct Labelled {
    pub label: Math,
    pub value: Option<[f64; 2]>,
}

impl Labelled {
    /// The same vector as the drawing has it.
    pub(super) fn placed(&self, compass: &Compass) -> LabelledVector {
        LabelledVector { label: self.label.clone(), value: self.value.map(|value| compass.place(value)) }
    }
}

impl Quantities<'_> {
    /// How a body is drawn.
    pub(super) fn form(&self, body: &str) -> Form {
        let round = |body: &str| self.words(body).iter().any(|word| ROUND.contains(&word.as_str()));
        // What consists of several bodies is round where all of them are.
        let members = self.scene().members(body);
        if members.into_iter().all(round) { Form::Disc } else { Form::Block }
    }

    /// The words of a body's name, in small letters.
    pub(super) fn words(&self, body: &str) -> Vec<String> {
        let name = self.called(body).to_lowercase();
        name.split(|letter: char| !letter.is_alphabetic()).map(str::to_owned).collect()
    }

    /// The momentum of `mass_of` with the velocity that `body` has at an instant; the two differ where bodies have become one.
    pub(super) fn momentum(&self, mass_of: &str, body: &str, instant: usize, scale: Option<f64>) -> Labelled {
        Labelled { label: self.momentum_name(mass_of, body, instant), value: self.momentum_value(body, instant, scale) }
    }

    /// The notation of that momentum.
    pub(super) fn momentum_name(&self, mass_of: &str, body: &str, instant: usize) -> Math {
        product([self.mass_math(mass_of, instant), name_math(&self.velocity_name(body, instant))])
    }

    /// The momentum of a mass with the velocity that a body has at an instant.
    pub(super) fn momentum_value(&self, body: &str, instant: usize, mass: Option<f64>) -> Option<[f64; 2]> {
        let velocity = self.velocity(body, instant);
        let value = velocity.zip(mass).map(|([x, y], mass)| [mass * x, mass * y]);
        // A body at rest has no momentum, whatever its mass.
        value.or(velocity.filter(|velocity| *velocity == [0.0, 0.0]))
    }

    /// The components of a momentum along the axes one by one, to the scale of the velocity; those that are zero left out.
    pub(super) fn momentum_components(&self, body: &str, instant: usize) -> Vec<Labelled> {
        let (name, mass) = (self.velocity_name(body, instant), self.mass_math(body, instant));
        let component = |(position, axis): (usize, &Axis)| {
            let component = format!("{name}.{}", axis.letter());
            let value = self.named(&component).filter(|value| *value != 0.0)?;
            let value = Some(self.along(position, value));
            Some(Labelled { label: product([mass.clone(), name_math(&component)]), value })
        };
        self.axes.iter().enumerate().filter_map(component).collect()
    }

    /// The impulse of an impact or a blow.
    pub(super) fn impulse(&self, impulse: &Impulse) -> Labelled {
        Labelled { label: self.impulse_name(impulse), value: self.impulse_value(impulse) }
    }

    /// The notation of that impulse.
    pub(super) fn impulse_name(&self, impulse: &Impulse) -> Math {
        if impulse.called == "weight" {
            return self.impulse_of_weight(&impulse.on, impulse.stage).label;
        }
        let letter = if impulse.by == Agent::Guide { "R" } else { "J" };
        let subject = self.of_string(impulse).unwrap_or_else(|| impulse.on.clone());
        self.worked.problem.notation().math(&format!("{letter}_{subject}"))
    }

    /// The string in whose name an impulse is given, where several are jerked together.
    fn of_string(&self, impulse: &Impulse) -> Option<String> {
        let Agent::Body(other) = &impulse.by else { return None };
        let jerked: Vec<_> = self.model().strings.iter().filter(|string| string.jerk == impulse.stage).collect();
        let string = jerked.iter().find(|string| string.ends.contains(&impulse.on) && string.ends.contains(other))?;
        (jerked.len() > 1).then(|| string.ends.concat())
    }

    /// The impulse along x and y.
    pub(super) fn impulse_value(&self, impulse: &Impulse) -> Option<[f64; 2]> {
        let components: Option<Vec<f64>> = impulse.components.iter().map(|part| self.evaluate(part)).collect();
        self.along_axes(&components?)
    }

    /// The impulse of a force over the time for which it acts.
    pub(super) fn impulse_of_force(&self, force: &ActingForce) -> Labelled {
        let [start, end] = &force.during;
        let clock = self.model().symbols.find("t");
        let steady = || Some(force.strength.clone() * (end.clone() - start.clone()));
        let size = clock.map_or_else(steady, |clock| force.strength.definite(clock, start, end));
        let value = size.and_then(|size| self.evaluate(&size)).zip(self.direction(&force.direction));
        let label = if clock.is_some_and(|clock| force.strength.contains(clock)) {
            self.integral_name(force)
        } else {
            let strength = match force.kind {
                ForceKind::Weight => self.weight_math(&force.on, force.stage),
                _ => self.size_of(&force.strength),
            };
            product([strength, self.duration(start, end)])
        };
        Labelled { label, value: value.map(|(size, [x, y])| [size * x, size * y]) }
    }

    /// The label at an arrow that shows the sense of a force: its size, `-F` where `F` is negative.
    pub(super) fn size_of(&self, strength: &Expr) -> Math {
        match self.evaluate(strength) {
            Some(value) if value < 0.0 => factor(strength, self.symbolic(&-strength.clone())),
            Some(_) => factor(strength, self.symbolic(strength)),
            None => factor(strength, self.unsigned(strength)),
        }
    }

    /// The impulse of weight over a fall; its value follows from the momenta.
    pub(super) fn impulse_of_weight(&self, body: &str, stage: usize) -> Labelled {
        let entry = self.scene().stages.get(stage);
        let told =
            entry.and_then(|entry| if let Stage::Flight(flight) = entry { flight.during.as_ref() } else { None });
        let told = told.and_then(|term| self.term(term)).map(|time| self.duration(&Expr::zero(), &time));
        let time = told.unwrap_or_else(|| name_math(&self.staged("dt", stage)));
        Labelled { label: product([self.weight_math(body, stage), time]), value: None }
    }

    /// The notation of the weight of a body at the start of a stage.
    pub(super) fn weight_math(&self, body: &str, stage: usize) -> Math {
        let weight = format!("W_{body}");
        match self.named(&weight) {
            Some(_) => name_math(&weight),
            None => product([self.mass_math(body, stage + 1), name_math("g")]),
        }
    }

    /// The name that the model gave to the integral of a force, or the integral itself.
    fn integral_name(&self, force: &ActingForce) -> Math {
        let is_own = |tag: usize| {
            let integral = self.model().instances.get(tag).and_then(|instance| instance.integral.as_ref());
            integral.is_some_and(|integral| integral.integrand == force.strength)
        };
        let named = self.model().system.equations.iter().filter(|equation| is_own(equation.tag)).find_map(|equation| {
            match &equation.statement {
                Statement::Equal { left, .. } => Some(self.symbolic(left)),
                Statement::FirstInteger { .. } => None,
            }
        });
        named.unwrap_or_else(|| {
            let bound = || Arc::new(Math::Row(Vec::new()));
            let letter = |name: &str| Arc::new(Math::Identifier(name.to_owned()));
            Math::Integral(bound(), bound(), letter("F"), letter("t"))
        })
    }

    /// The duration by its own name, or as a difference of times without one.
    pub(super) fn duration(&self, start: &Expr, end: &Expr) -> Math {
        match end.clone() - start.clone() {
            Expr::Symbol(symbol) if !self.is_literal(symbol) => self.symbolic(&symbol.into()),
            _ => name_math("dt"),
        }
    }
}
