//! A small figure that stands for a problem in a gallery.

use momentous_explain::situation;
use momentous_expr::Math;
use momentous_figure::{Drawing, Point, Role, Shape};

use super::Exercise;

/// Half the size of the drawing in which a letter stands: with it a letter is as large as those of other figures.
const HALF: Point = Point { x: 80.0, y: 48.0 };

impl Exercise {
    /// The figure of its sheet; else the letter of what is asked first. It shows only what is given.
    #[must_use]
    pub fn thumbnail(&self) -> Drawing {
        situation(self.worked()).unwrap_or_else(|| self.asked_letter())
    }

    fn asked_letter(&self) -> Drawing {
        let symbol = self.worked().form.wanted().next();
        let text = symbol.map_or_else(|| Math::Text("?".to_owned()), |symbol| self.problem().math_of(symbol));
        let (low, high) = (Point::default() - HALF, HALF);
        let shapes = vec![Shape::Label { at: Point::default(), text, role: Role::Body }];
        Drawing { low, high, shapes, ..Drawing::default() }
    }
}
