//! Inputs of the diagrams: plain numbers and finished labels, without a notion of where they come from.

use momentous_expr::Math;
use momentous_expr::Operator;

use super::place::Canvas;
use super::{Drawing, Point};

/// Free space around a figure, so that line widths and fonts wider than estimated are not cut.
pub(super) const MARGIN: f64 = 6.0;

/// The title of a figure and the words about it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Wording {
    /// Short title, for screen readers.
    pub title: String,
    /// Its description in a sentence or two, for screen readers.
    pub description: String,
    /// The caption beneath it.
    pub caption: String,
}

impl Wording {
    /// The finished drawing, just large enough.
    pub(super) fn drawing(&self, canvas: Canvas) -> Drawing {
        let canvas = canvas.settled();
        let frame = canvas.frame().grown(MARGIN);
        let Self { title, description, caption } = self.clone();
        let caption = match canvas.notes() {
            [] => caption,
            notes => format!("{}. {}", caption.trim_end_matches('.'), notes.join(" ")),
        };
        Drawing { title, description, caption, low: frame.low, high: frame.high, shapes: canvas.into_shapes() }
    }
}

/// A vector with its label: `m_A v_A1` and (6, 0), in any one unit for all vectors of a kind in a figure.
#[derive(Clone, Debug, PartialEq)]
pub struct LabelledVector {
    /// The label beside its arrow.
    pub label: Math,
    /// Its components to the right and upwards; `None` where it is not known.
    pub value: Option<[f64; 2]>,
}

impl LabelledVector {
    /// A known vector.
    #[must_use]
    pub fn known(label: Math, value: [f64; 2]) -> Self {
        Self { label, value: Some(value) }
    }

    /// A vector that is not known.
    #[must_use]
    pub fn unknown(label: Math) -> Self {
        Self { label, value: None }
    }

    /// The value as a vector of the drawing, where it is known and finite.
    pub(super) fn vector(&self) -> Option<Point> {
        let [x, y] = self.value?;
        (x.is_finite() && y.is_finite()).then_some(Point::new(x, y))
    }

    /// `label = what`.
    pub(super) fn equals(&self, what: Math) -> Math {
        Math::relation(self.label.clone(), Operator::Equals, what)
    }
}

/// How a body is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Form {
    /// A disc: a puck, a ball, a particle. A long name turns it into a block.
    #[default]
    Disc,
    /// A block: a cart, a crate.
    Block,
    /// A belt on its rollers.
    Belt,
    /// A length of rope, with its name beside it.
    Strand,
}

/// A direction with a name: the axis x, to the right.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisMark {
    /// Its name.
    pub name: Math,
    /// Its angle in radians, counter-clockwise from the right.
    pub angle: f64,
    /// How long its unit is drawn: 1 but where it is foreshortened.
    pub length: f64,
}

impl AxisMark {
    /// An axis by its letter.
    #[must_use]
    pub fn new(name: &str, angle: f64) -> Self {
        Self { name: Math::Identifier(name.to_owned()), angle, length: 1.0 }
    }

    /// An axis by its letter, with its unit on the drawing.
    #[must_use]
    pub fn along(name: &str, [right, up]: [f64; 2]) -> Self {
        Self { length: libm::hypot(right, up), ..Self::new(name, libm::atan2(up, right)) }
    }
}
