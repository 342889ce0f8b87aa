//! Quantities that a sheet asks for, where its figure has a place for them: named with a question mark, and without their values.

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::Operator;
use momentous_expr::Symbol;
use momentous_expr::name_math;
use momentous_figure::LabelledVector;
use momentous_figure::Moving;
use momentous_model::QuantityKind;
use momentous_model::VectorKind;
use momentous_scene::Term;

use super::compass::Compass;
use super::quantities::Quantities;
use super::quantities::Scope;

impl Quantities<'_> {
    /// The notation of a term, where its value may be shown or is asked for.
    pub(super) fn label_of(&self, term: &Term) -> Option<Math> {
        let term = self.term(term)?;
        match self.evaluate(&term) {
            Some(_) => Some(self.symbolic(&term)),
            None => self.asked(&term),
        }
    }

    /// `h = ?` for a quantity that the sheet asks for.
    pub(super) fn asked(&self, term: &Expr) -> Option<Math> {
        let Expr::Symbol(symbol) = term else { return None };
        self.is_asked(*symbol).then(|| with_question_mark(self.symbolic(term)))
    }

    /// The same for the quantity of that name.
    pub(super) fn asked_name(&self, name: &str) -> Option<Math> {
        self.is_asked(self.model().symbol_of(name)?).then(|| with_question_mark(name_math(name)))
    }

    fn is_asked(&self, symbol: Symbol) -> bool {
        let wanted = || self.worked.form.wanted().any(|wanted| wanted == symbol);
        self.scope() == Scope::Given && self.value(symbol).is_none() && wanted()
    }

    /// The parts asked of the velocity of a body at an instant: components along the axes in the sense in which they count, a
    /// speed in the direction that is given. Which way a body goes later is part of the answer: there is no arrow then.
    pub(super) fn asked_motion(&self, compass: &Compass, body: &str, instant: usize) -> Vec<Moving> {
        let name = self.velocity_name(body, instant);
        let arrow = |label: Math, along: [f64; 2]| {
            let value = (instant == 1).then(|| compass.place(along));
            Moving::velocity(LabelledVector { label, value }).asked()
        };
        if let [_] = self.axes[..] {
            let label = self.asked_name(&name);
            return label.zip(self.along_axes(&[1.0])).map(|(label, along)| arrow(label, along)).into_iter().collect();
        }
        let components = self.axes.iter().enumerate().map(|(position, axis)| {
            let label = self.asked_name(&format!("{name}.{}", axis.letter()))?;
            Some(arrow(label, self.along(position, 1.0)))
        });
        let speed = || {
            let label = self.asked_name(&self.since(QuantityKind::Speed, body, instant).to_string())?;
            let name = self.since(QuantityKind::Direction(VectorKind::Velocity), body, instant).to_string();
            let angle = self.named(&name)?;
            let arrow = arrow(label, [libm::cos(angle), libm::sin(angle)]);
            Some(arrow.at_angle(compass.axis_angle(0), name_math(&name)))
        };
        let components: Vec<Moving> = components.flatten().collect();
        if components.is_empty() { speed().into_iter().collect() } else { components }
    }
}

fn with_question_mark(name: Math) -> Math {
    Math::relation(name, Operator::Equals, Math::Text("?".to_owned()))
}
