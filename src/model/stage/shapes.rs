//! The area under a graph of straight lines, from the shapes that a student sees in it.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_scene::list;

/// `a triangle, a rectangle and a triangle`, `two triangles`.
pub(super) fn in_words(shapes: &[(Shape, Expr)]) -> String {
    let names: Vec<&str> = shapes.iter().map(|(shape, _)| shape.called()).collect();
    match &names[..] {
        ["a triangle", "a triangle"] => "two triangles".to_owned(),
        _ => list(&names),
    }
}

/// A part of an area, between two times.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shape {
    Triangle,
    Rectangle,
    Trapezium,
}

impl Shape {
    /// With its article.
    fn called(self) -> &'static str {
        match self {
            Self::Triangle => "a triangle",
            Self::Rectangle => "a rectangle",
            Self::Trapezium => "a trapezium",
        }
    }
}

/// The shapes under what is told piece by piece, each with its area; none where a piece is no straight line, or one of the pieces ends
/// elsewhere than at the end.
pub(super) fn under(value: &Expr, clock: Symbol, [start, end]: [&Expr; 2]) -> Option<Vec<(Shape, Expr)>> {
    let Expr::Piecewise(piecewise) = value else { return None };
    if piecewise.variable != Expr::from(clock) {
        return None;
    }
    let mut from = start.clone();
    let mut shapes = Vec::new();
    for (until, piece) in &piecewise.pieces {
        let to = until.as_ref().unwrap_or(end);
        let width = (to.clone() - from.clone()).simplify();
        if width.is_zero() {
            continue;
        }
        if piece.differentiate(clock).simplify().contains(clock) {
            return None;
        }
        let at = |time: &Expr| piece.substitute(&|symbol| (symbol == clock).then(|| time.clone())).simplify();
        shapes.extend(shape(&width, [at(&from), at(to)]));
        from = to.clone();
    }
    ((from - end.clone()).simplify().is_zero() && shapes.iter().any(|(shape, _)| *shape != Shape::Rectangle))
        .then_some(shapes)
}

/// The shapes under a straight line between these heights; none under one at zero.
fn shape(width: &Expr, [low, high]: [Expr; 2]) -> Option<(Shape, Expr)> {
    let half = |height: Expr| Expr::product([Expr::ratio(1, 2), width.clone(), height]);
    match (low.is_zero(), high.is_zero()) {
        (true, true) => None,
        (true, false) => Some((Shape::Triangle, half(high))),
        (false, true) => Some((Shape::Triangle, half(low))),
        (false, false) if (low.clone() - high.clone()).simplify().is_zero() => {
            Some((Shape::Rectangle, width.clone() * low))
        }
        (false, false) => Some((Shape::Trapezium, half(low + high))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use momentous_expr::Piecewise;
    use momentous_expr::SymbolEntry;
    use momentous_expr::SymbolTable;
    use momentous_quantity::Dimension;

    #[test]
    fn a_trapezoidal_push_is_a_triangle_a_rectangle_and_a_triangle() {
        let mut table = SymbolTable::default();
        let [t, f, a, b, c] = ["t", "F", "a", "b", "c"].map(|name| {
            table.intern(SymbolEntry { name: name.into(), dimension: Dimension::NONE, meaning: String::new() })
        });
        let [clock, force, first, second, last] = [t, f, a, b, c].map(Expr::from);
        let falling = force.clone() * (last.clone() - clock.clone()) / (last.clone() - second.clone());
        let pieces = vec![
            (Some(first.clone()), force.clone() * clock.clone() / first),
            (Some(second), force),
            (Some(last.clone()), falling),
        ];
        let push = Expr::Piecewise(std::sync::Arc::new(Piecewise { variable: clock, pieces }));
        let zero = Expr::zero();
        let shapes = under(&push, t, [&zero, &last]).unwrap();
        assert_eq!(
            shapes.iter().map(|shape| shape.0).collect::<Vec<_>>(),
            [Shape::Triangle, Shape::Rectangle, Shape::Triangle]
        );
        let value = |symbol| match symbol {
            symbol if symbol == f => 10.0,
            symbol if symbol == a => 1.0,
            symbol if symbol == b => 3.0,
            _ => 5.0,
        };
        // 10/2 + 10*2 + 2*10/2
        assert!((shapes.iter().map(|shape| shape.1.evaluate(&value)).sum::<f64>() - 35.0).abs() < 1e-12);
        // Where the push is not followed to its end, its last piece is cut.
        assert_eq!(under(&push, t, [&zero, &b.into()]), None);
    }
}
