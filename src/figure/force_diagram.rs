//! The free-body diagram: the forces on a body = its mass times its acceleration.

use std::f64::consts::FRAC_PI_2;
use std::sync::LazyLock;

use momentous_expr::Math;

use super::body::{Attach, Body};
use super::input::{AxisMark, Form, LabelledVector, Wording};
use super::panels::{Row, assemble};
use super::place::Canvas;
use super::scale::Scale;
use super::surface::draw_surface;
use super::{Drawing, Point, Role};

const LONGEST: f64 = 62.0;
const SURFACE_HALF: f64 = 26.0;

/// The forces on a body at an instant, and what they make of it. All vectors are in one unit.
#[derive(Clone, Debug, PartialEq)]
pub struct ForceDiagram {
    /// Title, description, caption.
    pub wording: Wording,
    /// The name inside its outline.
    pub name: Math,
    /// Its outline.
    pub form: Form,
    /// A surface that it touches: the angle of its normal in radians, towards the body.
    pub surface: Option<f64>,
    /// The forces on it.
    pub forces: Vec<LabelledVector>,
    /// Its mass times its acceleration, by components; none where the forces balance.
    pub effect: Vec<LabelledVector>,
    /// The axes to name.
    pub axes: Vec<AxisMark>,
}

impl ForceDiagram {
    /// The diagram: one scale for all arrows.
    ///
    /// ```
    /// use momentous_expr::Math;
    /// use momentous_figure::{ForceDiagram, Form, LabelledVector, Wording, overlaps};
    ///
    /// let vector = |label: &str, y| LabelledVector::known(Math::Identifier(label.into()), [0.0, y]);
    /// let diagram = ForceDiagram {
    ///     wording: Wording::default(),
    ///     name: Math::Identifier("A".into()),
    ///     form: Form::Block,
    ///     surface: None,
    ///     forces: vec![vector("S", 5.0), vector("W", -3.0)],
    ///     effect: vec![vector("R", 2.0)],
    ///     axes: Vec::new(),
    /// };
    /// assert!(overlaps(&diagram.drawing()).is_empty());
    /// ```
    #[must_use]
    pub fn drawing(&self) -> Drawing {
        static HEADINGS: LazyLock<[Math; 2]> =
            LazyLock::new(|| ["forces", "mass times acceleration"].map(|words| Math::Text(words.to_owned())));
        let vectors = self.forces.iter().chain(&self.effect).filter_map(LabelledVector::vector);
        let scale = Scale::fitting(vectors, LONGEST);
        let normal = self.surface.filter(|angle| angle.is_finite()).map(|angle| Point::polar(1.0, angle));
        let panels = vec![self.panel(&self.forces, normal, scale), self.panel(&self.effect, None, scale)];
        let mut canvas = assemble(&*HEADINGS, vec![Row { panels }], &self.axes);
        canvas.tell_scale(scale);
        self.wording.drawing(canvas)
    }

    fn panel(&self, vectors: &[LabelledVector], normal: Option<Point>, scale: Scale) -> Canvas {
        let mut canvas = Canvas::default();
        let turn = normal.map_or(0.0, |normal| {
            let angle = normal.angle();
            angle - libm::round(angle / FRAC_PI_2) * FRAC_PI_2
        });
        let mut body = Body::new(&self.name, self.form, Point::ORIGIN).turned(turn);
        body.draw(&mut canvas);
        if let Some(normal) = normal {
            let (foot, half) = (-normal * body.support(normal), normal.turned() * SURFACE_HALF);
            draw_surface(&mut canvas, foot + half, foot - half);
        }
        let arrows = vectors.iter().filter_map(|vector| Some((vector, scale.arrow(vector.vector()?)?)));
        let arrows: Vec<(&LabelledVector, Point)> = arrows.collect();
        if arrows.is_empty() {
            body.draw_note(&mut canvas, &Math::Number("0".to_owned()), Role::Force);
        }
        for (vector, arrow) in arrows {
            let into = normal.is_some_and(|normal| arrow.dot(normal) < -0.1 * arrow.length());
            let attach = if into { Attach::Arriving } else { Attach::Leaving };
            body.draw_arrow(&mut canvas, arrow, attach, &vector.label, Role::Force);
        }
        canvas.settled()
    }
}
