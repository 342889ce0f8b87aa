//! The impulse-momentum diagram: for each body, momentum before + impulses = momentum after.

use std::f64::consts::FRAC_PI_2;
use std::sync::LazyLock;

use momentous_expr::Math;

use super::body::{Attach, Body};
use super::drawing::unknown;
use super::input::{AxisMark, Form, LabelledVector, MARGIN, Wording};
use super::panels::{Row, assemble};
use super::place::Canvas;
use super::scale::Scale;
use super::surface::draw_surface;
use super::{Drawing, Point, Role};

/// Lengths of the longest arrow, tried in this order until the figure is not too wide.
const LONGEST: [f64; 4] = [76.0, 62.0, 48.0, 38.0];
/// The width of a line of text on a sheet of paper, about.
const WIDEST: f64 = 440.0 + 2.0 * MARGIN;
const LINE_OVERHANG: f64 = 16.0;
const SURFACE_HALF: f64 = 26.0;

/// Input of an impulse-momentum diagram. All vectors are in one unit: momentum and impulse have the same dimension.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MomentumDiagram {
    /// Title, description, caption.
    pub wording: Wording,
    /// One row of panels each, from top to bottom.
    pub bodies: Vec<BodyMomentum>,
    /// The axes to name.
    pub axes: Vec<AxisMark>,
}

/// The balance that a diagram shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Quantity {
    /// Momentum, by impulses.
    Momentum,
    /// Angular momentum as a vector, by angular impulses.
    AngularMomentum,
}

impl Quantity {
    /// How its parts are called: before, what changes it, after.
    fn headings(self, several: bool) -> &'static [Math; 3] {
        static HEADINGS: LazyLock<[[Math; 3]; 3]> = LazyLock::new(|| {
            [
                ["momentum before", "impulse", "momentum after"],
                ["momentum before", "impulses", "momentum after"],
                ["angular momentum before", "angular impulse", "angular momentum after"],
            ]
            .map(|row| row.map(|words| Math::Text(words.to_owned())))
        });
        let [one, many, angular] = &*HEADINGS;
        match (self, several) {
            (Self::Momentum, false) => one,
            (Self::Momentum, true) => many,
            (Self::AngularMomentum, _) => angular,
        }
    }
}

/// The row of one body.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyMomentum {
    /// The name inside its outline.
    pub name: Math,
    /// Its outline.
    pub form: Form,
    /// A fixed surface that it touches while the impulses act: the angle of its normal in radians, towards the body.
    pub surface: Option<f64>,
    /// The line of impact: its angle in radians.
    pub line_of_impact: Option<f64>,
    /// Its momentum before.
    pub before: LabelledVector,
    /// The impulses on it, in the order of their labels; none where no impulse acts.
    pub impulses: Vec<LabelledVector>,
    /// Its momentum after.
    pub after: LabelledVector,
}

impl MomentumDiagram {
    /// The diagram: one scale for all arrows, the longest as long as fits; the caption tells of any that had to be longer to be seen.
    ///
    /// ```
    /// use momentous_expr::Math;
    /// use momentous_figure::{BodyMomentum, Form, LabelledVector, MomentumDiagram, overlaps};
    ///
    /// let vector = |label: &str, x| LabelledVector::known(Math::Identifier(label.into()), [x, 0.0]);
    /// let cart = BodyMomentum {
    ///     name: Math::Identifier("A".into()),
    ///     form: Form::Block,
    ///     surface: None,
    ///     line_of_impact: None,
    ///     before: vector("p", 6.0),
    ///     impulses: vec![vector("J", -8.0)],
    ///     after: vector("q", -2.0),
    /// };
    /// let drawing = MomentumDiagram { bodies: vec![cart], ..MomentumDiagram::default() }.drawing();
    /// assert!(overlaps(&drawing).is_empty());
    /// ```
    #[must_use]
    pub fn drawing(&self) -> Drawing {
        self.balance(Quantity::Momentum)
    }

    /// The same for angular momenta as vectors, which angular impulses change.
    #[must_use]
    pub fn of_angular_momentum(&self) -> Drawing {
        self.balance(Quantity::AngularMomentum)
    }

    fn balance(&self, quantity: Quantity) -> Drawing {
        let [longest @ .., shortest] = LONGEST;
        let drawing = |longest: f64| self.wording.drawing(self.canvas(quantity, longest));
        let fits = |drawing: &Drawing| drawing.high.x - drawing.low.x <= WIDEST;
        longest.into_iter().map(drawing).find(fits).unwrap_or_else(|| drawing(shortest))
    }

    fn canvas(&self, quantity: Quantity, longest: f64) -> Canvas {
        let scale = Scale::fitting(self.bodies.iter().flat_map(BodyMomentum::vectors), longest);
        let rows = self.bodies.iter().map(|body| body.row(scale)).collect();
        let several = self.bodies.iter().any(|body| body.impulses.len() > 1);
        let mut canvas = assemble(quantity.headings(several), rows, &self.axes);
        canvas.tell_scale(scale);
        canvas
    }
}

impl BodyMomentum {
    fn vectors(&self) -> impl Iterator<Item = Point> {
        let ends = [&self.before, &self.after].into_iter();
        ends.chain(&self.impulses).filter_map(LabelledVector::vector)
    }

    fn row(&self, scale: Scale) -> Row {
        Row {
            panels: vec![
                self.momentum_panel(&self.before, scale),
                self.impulse_panel(scale),
                self.momentum_panel(&self.after, scale),
            ],
        }
    }

    /// Turned with a slanting surface.
    fn body(&self) -> Body {
        let normal = self.surface.filter(|angle| angle.is_finite()).unwrap_or_default();
        let turn = normal - libm::round(normal / FRAC_PI_2) * FRAC_PI_2;
        Body::new(&self.name, self.form, Point::ORIGIN).turned(turn)
    }

    fn momentum_panel(&self, momentum: &LabelledVector, scale: Scale) -> Canvas {
        let (mut canvas, mut body) = (Canvas::default(), self.body());
        body.draw(&mut canvas);
        draw_vector(&mut canvas, &mut body, momentum, scale, Role::Momentum, None);
        canvas.settled()
    }

    fn impulse_panel(&self, scale: Scale) -> Canvas {
        let (mut canvas, mut body) = (Canvas::default(), self.body());
        body.draw(&mut canvas);
        let normal = self.surface.filter(|angle| angle.is_finite()).map(|angle| Point::polar(1.0, angle));
        if let Some(normal) = normal {
            let foot = -normal * body.support(normal);
            let half = normal.turned() * SURFACE_HALF;
            draw_surface(&mut canvas, foot + half, foot - half);
        }
        if let Some(angle) = self.line_of_impact.filter(|angle| angle.is_finite()) {
            self.draw_line_of_impact(&mut canvas, &body, angle, scale);
        }
        if self.impulses.is_empty() {
            body.draw_note(&mut canvas, &Math::Number("0".to_owned()), Role::Impulse);
        }
        for impulse in &self.impulses {
            draw_vector(&mut canvas, &mut body, impulse, scale, Role::Impulse, normal);
        }
        canvas.settled()
    }

    /// Dashed, from the far side of the body to a little beyond the longest impulse along it.
    fn draw_line_of_impact(&self, canvas: &mut Canvas, body: &Body, angle: f64, scale: Scale) {
        let unit = Point::polar(1.0, angle);
        let arrows = self.impulses.iter().filter_map(|impulse| scale.arrow(impulse.vector()?));
        let (forwards, backwards) = arrows.fold((0.0_f64, 0.0_f64), |(forwards, backwards), arrow| {
            (forwards.max(arrow.dot(unit)), backwards.max(-arrow.dot(unit)))
        });
        for (direction, beyond) in [(unit, forwards), (-unit, backwards)] {
            let (start, end) = (body.reach(direction), body.support(direction) + beyond + LINE_OVERHANG);
            canvas.line([direction * start, direction * end], Role::Axis, true);
        }
    }
}

/// An arrow where there is one, else a note: `= 0`, `= ?`. An arrow into the surface is drawn from its other side.
fn draw_vector(
    canvas: &mut Canvas,
    body: &mut Body,
    vector: &LabelledVector,
    scale: Scale,
    role: Role,
    normal: Option<Point>,
) {
    let Some(value) = vector.vector() else {
        return body.draw_note(canvas, &vector.equals(unknown()), role);
    };
    let Some(arrow) = scale.arrow(value) else {
        return body.draw_note(canvas, &vector.equals(Math::Number("0".to_owned())), role);
    };
    let into_surface = normal.is_some_and(|normal| arrow.dot(normal) < -0.1 * arrow.length());
    let attach = if into_surface { Attach::Arriving } else { Attach::Leaving };
    body.draw_arrow(canvas, arrow, attach, &vector.label, role);
}
