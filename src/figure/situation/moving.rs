//! A body with the vectors that are given of it.

use crate::body::{Attach, Body, label_arrow};
use crate::input::{Form, LabelledVector};
use crate::place::Canvas;
use crate::scale::Scale;
use crate::{Point, Role};
use momentous_expr::Math;

use super::angle::{AngleMark, Vertex, draw_angle};

/// A body of a problem sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct MovingBody {
    /// The name inside its outline.
    pub name: Math,
    /// Its outline.
    pub form: Form,
    /// Its given velocities and forces.
    pub vectors: Vec<Moving>,
    /// The parts of which it consists until it comes apart, from back to front; empty for one body.
    pub parts: Vec<(Math, Form)>,
}

/// A given vector of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct Moving {
    /// The vector; an unknown value draws nothing.
    pub vector: LabelledVector,
    /// [`Role::Velocity`] or [`Role::Force`] as a rule; each role has a scale of its own.
    pub role: Role,
    /// The angle that gives its direction.
    pub angle: Option<AngleMark>,
    /// On which side of the body it is drawn, where the layout leaves that open.
    pub attach: Attach,
    /// Whether it is the velocity of a stream, whose edges are drawn.
    pub stream: bool,
    /// Whether its size is asked for: only its direction is drawn, if that is known, and it has no part in the scale.
    pub asked: bool,
}

impl MovingBody {
    /// A disc of that name, at rest as far as the figure tells.
    #[must_use]
    pub fn new(name: Math) -> Self {
        Self { name, form: Form::Disc, vectors: Vec::new(), parts: Vec::new() }
    }

    /// The same body with one more vector.
    #[must_use]
    pub fn with(mut self, vector: Moving) -> Self {
        self.vectors.push(vector);
        self
    }

    /// The same body with another outline.
    #[must_use]
    pub fn shaped(mut self, form: Form) -> Self {
        self.form = form;
        self
    }

    /// The same body as what these are together, one ahead of the other.
    #[must_use]
    pub fn joined(mut self, parts: Vec<(Math, Form)>) -> Self {
        self.parts = parts;
        self
    }

    /// Whether a vector of it is given.
    #[must_use]
    pub fn is_told(&self) -> bool {
        self.vectors.iter().any(|moving| !moving.asked)
    }

    pub(crate) fn outline(&self) -> Body {
        match &self.parts[..] {
            [] => Body::new(&self.name, self.form, Point::ORIGIN),
            parts => Body::joined(&self.name, parts),
        }
    }
}

impl Moving {
    /// A velocity.
    #[must_use]
    pub fn velocity(vector: LabelledVector) -> Self {
        Self { vector, role: Role::Velocity, angle: None, attach: Attach::Leaving, stream: false, asked: false }
    }

    /// A force.
    #[must_use]
    pub fn force(vector: LabelledVector) -> Self {
        Self { role: Role::Force, ..Self::velocity(vector) }
    }

    /// A momentum.
    #[must_use]
    pub fn momentum(vector: LabelledVector) -> Self {
        Self { role: Role::Momentum, ..Self::velocity(vector) }
    }

    /// An impulse.
    #[must_use]
    pub fn impulse(vector: LabelledVector) -> Self {
        Self { role: Role::Impulse, ..Self::velocity(vector) }
    }

    /// The same vector with its tip at the body: how the body comes.
    #[must_use]
    pub fn arriving(mut self) -> Self {
        self.attach = Attach::Arriving;
        self
    }

    /// The same vector, of which the size is asked for.
    #[must_use]
    pub fn asked(mut self) -> Self {
        self.asked = true;
        self
    }

    /// The same vector in the middle of the stream whose velocity it is.
    #[must_use]
    pub fn in_stream(mut self) -> Self {
        self.stream = true;
        self
    }

    /// The same vector with the angle that gives its direction.
    #[must_use]
    pub fn at_angle(mut self, from: f64, label: Math) -> Self {
        self.angle = Some(AngleMark { from, label });
        self
    }
}

/// From the middle of a stream to its edges.
const STREAM_HALF: f64 = 6.0;

/// The scales of a figure, one a role.
pub(crate) struct Scales {
    velocity: Scale,
    force: Scale,
    other: Scale,
}

impl Scales {
    pub(crate) fn of<'a>(bodies: impl IntoIterator<Item = &'a MovingBody>, longest: f64) -> Self {
        let vectors: Vec<&Moving> = bodies.into_iter().flat_map(|body| &body.vectors).collect();
        let vectors = |is_own: &dyn Fn(Role) -> bool| -> Vec<Point> {
            let drawn = vectors.iter().filter(|moving| is_own(moving.role) && !moving.asked);
            drawn.filter_map(|moving| moving.vector.vector()).collect()
        };
        Self {
            velocity: Scale::sketching(vectors(&|role| role == Role::Velocity), longest),
            force: Scale::sketching(vectors(&|role| role == Role::Force), longest),
            other: Scale::fitting(vectors(&claims_scale), longest),
        }
    }

    fn of_role(&self, role: Role) -> Scale {
        match role {
            Role::Velocity => self.velocity,
            Role::Force => self.force,
            _ => self.other,
        }
    }

    pub(crate) fn arrow(&self, moving: &Moving) -> Option<Point> {
        let (scale, vector) = (self.of_role(moving.role), moving.vector.vector()?);
        if moving.asked { scale.sketch(vector) } else { scale.arrow(vector) }
    }
}

/// Whether arrows of a role are there to be compared: momenta and impulses, which a reader may add, and displacements.
fn claims_scale(role: Role) -> bool {
    !matches!(role, Role::Velocity | Role::Force)
}

/// Draws a vector at the body; a zero vector is noted as such, one that is asked for as that, an unknown one left out.
pub(crate) fn draw_vector(canvas: &mut Canvas, body: &mut Body, moving: &Moving, scales: &Scales, attach: Attach) {
    let Some(arrow) = scales.arrow(moving) else {
        if moving.asked {
            body.draw_note(canvas, &moving.vector.label, moving.role);
        } else if moving.vector.vector().is_some() {
            body.draw_note(canvas, &moving.vector.equals(Math::Number("0".to_owned())), moving.role);
        }
        return;
    };
    if claims_scale(moving.role) {
        canvas.tell_scale(scales.other);
    }
    let (from, to) = body.attach(arrow, attach);
    canvas.arrow(from, to, moving.role);
    if moving.stream {
        let aside = arrow.turned() * (STREAM_HALF / arrow.length().max(1e-9));
        for edge in [aside, -aside] {
            canvas.line([from + edge, to + edge], Role::Path, false);
        }
    }
    // The angle is small and has one good place; the arrow's label finds another.
    if let Some(mark) = &moving.angle {
        draw_angle_at(canvas, body, [from, to], attach, mark);
    }
    label_arrow(canvas, [from, to], attach, &moving.vector.label, moving.role);
}

fn draw_angle_at(canvas: &mut Canvas, body: &Body, [from, to]: [Point; 2], attach: Attach, mark: &AngleMark) {
    let arrow = to - from;
    let at_body = match attach {
        Attach::Arriving => Vertex { room: arrow.length(), ..Vertex::open(from, 0.0) },
        // About the centre, so that the reference does not start inside the outline of the body.
        Attach::Leaving => Vertex::open(body.centre(), body.reach(Point::polar(1.0, mark.from))),
    };
    let beyond = if attach == Attach::Leaving { to } else { from - arrow };
    draw_angle(canvas, &[at_body, Vertex::open(beyond, 0.0)], arrow, mark);
}
