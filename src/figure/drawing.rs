//! The drawing model: what a figure consists of, before any format.

use momentous_expr::Math;

/// A drawing in its own units (about one point each), y upwards.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing {
    /// Short title, for screen readers.
    pub title: String,
    /// Its description in a sentence or two, for screen readers.
    pub description: String,
    /// The caption beneath it.
    pub caption: String,
    /// Lower left corner.
    pub low: Point,
    /// Upper right corner.
    pub high: Point,
    /// The shapes, in the order in which they are drawn.
    pub shapes: Vec<Shape>,
}

/// A point of the drawing.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Point {
    /// Rightwards.
    pub x: f64,
    /// Upwards.
    pub y: f64,
}

/// The role of a shape; it decides line width and colour, in one table for both writers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Role {
    /// A body's outline.
    Body,
    /// A momentum arrow.
    Momentum,
    /// An impulse arrow.
    Impulse,
    /// A velocity arrow.
    Velocity,
    /// A force arrow.
    Force,
    /// A radius, or another length.
    Length,
    /// A fixed surface: floor, wall, vane.
    Surface,
    /// Axes, the line of impact.
    Axis,
    /// A path or a cord.
    Path,
    /// A curve in a plot.
    Curve,
    /// A dimension or guide line.
    Guide,
}

/// A shape of a drawing.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A line through points.
    Line {
        /// Its points.
        points: Vec<Point>,
        /// Its role.
        role: Role,
        /// Whether it is dashed.
        dashed: bool,
    },
    /// An arrow.
    Arrow {
        /// Its tail.
        from: Point,
        /// Its tip.
        to: Point,
        /// Its role.
        role: Role,
    },
    /// A circle.
    Circle {
        /// Its centre.
        centre: Point,
        /// Its radius.
        radius: f64,
        /// Its role.
        role: Role,
    },
    /// A rectangle, turned by `angle` radians about its centre.
    Rectangle {
        /// Its centre.
        centre: Point,
        /// Its size along its own axes.
        size: Point,
        /// Its turn, counter-clockwise.
        angle: f64,
        /// Its role.
        role: Role,
    },
    /// An arc, counter-clockwise.
    Arc {
        /// Its centre.
        centre: Point,
        /// Its radius.
        radius: f64,
        /// Start angle in radians.
        from: f64,
        /// End angle in radians.
        to: f64,
        /// Whether it has an arrow head at its end.
        arrow: bool,
        /// Its role.
        role: Role,
    },
    /// A closed, lightly filled region without an outline; labels may lie on it.
    Area {
        /// Its corners.
        points: Vec<Point>,
        /// Its role.
        role: Role,
    },
    /// A label, centred on a point.
    Label {
        /// Its centre.
        at: Point,
        /// Its text.
        text: Math,
        /// Colour follows this role.
        role: Role,
    },
}

/// The sign in place of a value that is not known.
pub(super) fn unknown() -> Math {
    Math::Text("?".to_owned())
}

impl Role {
    /// Every role, in order.
    pub(super) const ALL: [Self; 11] = [
        Self::Body,
        Self::Momentum,
        Self::Impulse,
        Self::Velocity,
        Self::Force,
        Self::Length,
        Self::Surface,
        Self::Axis,
        Self::Path,
        Self::Curve,
        Self::Guide,
    ];
}

impl Drawing {
    /// Says what it says in other words.
    pub fn reword(&mut self, reworded: &dyn Fn(&str) -> String) {
        for words in [&mut self.title, &mut self.description, &mut self.caption] {
            *words = reworded(words);
        }
    }

    /// Whether a shape has that role.
    pub(super) fn has(&self, role: Role) -> bool {
        self.shapes.iter().any(|shape| shape.role() == role)
    }

    /// Whether everything that it shows has a value.
    #[must_use]
    pub fn is_known(&self) -> bool {
        let is_unknown = |text: &Math| matches!(text, Math::Row(parts) if parts.last() == Some(&unknown()));
        !self.shapes.iter().any(|shape| matches!(shape, Shape::Label { text, .. } if is_unknown(text)))
    }

    /// Whether it shows nothing but outlines of bodies and axes: less than any text says.
    ///
    /// ```
    /// use momentous_figure::{Drawing, Point, Role, Shape};
    /// let circle = Shape::Circle { centre: Point::ORIGIN, radius: 1.0, role: Role::Body };
    /// let mut drawing = Drawing { shapes: vec![circle], ..Drawing::default() };
    /// assert!(drawing.is_bare());
    /// drawing.shapes.push(Shape::Arrow { from: Point::ORIGIN, to: Point::new(3.0, 0.0), role: Role::Velocity });
    /// assert!(!drawing.is_bare());
    /// ```
    #[must_use]
    pub fn is_bare(&self) -> bool {
        let is_outline = |shape: &Shape| match shape {
            Shape::Label { .. } => true,
            other => matches!(other.role(), Role::Body | Role::Axis),
        };
        self.shapes.iter().all(is_outline)
    }
}

impl Shape {
    /// The shape somewhere else.
    pub(super) fn moved(self, by: Point) -> Self {
        let all = |points: Vec<Point>| points.into_iter().map(|point| point + by).collect();
        match self {
            Self::Line { points, role, dashed } => Self::Line { points: all(points), role, dashed },
            Self::Arrow { from, to, role } => Self::Arrow { from: from + by, to: to + by, role },
            Self::Circle { centre, radius, role } => Self::Circle { centre: centre + by, radius, role },
            Self::Rectangle { centre, size, angle, role } => Self::Rectangle { centre: centre + by, size, angle, role },
            Self::Arc { centre, radius, from, to, arrow, role } => {
                Self::Arc { centre: centre + by, radius, from, to, arrow, role }
            }
            Self::Area { points, role } => Self::Area { points: all(points), role },
            Self::Label { at, text, role } => Self::Label { at: at + by, text, role },
        }
    }

    /// The role of the shape.
    fn role(&self) -> Role {
        match self {
            Self::Line { role, .. }
            | Self::Arrow { role, .. }
            | Self::Circle { role, .. }
            | Self::Rectangle { role, .. }
            | Self::Arc { role, .. }
            | Self::Area { role, .. }
            | Self::Label { role, .. } => *role,
        }
    }
}
