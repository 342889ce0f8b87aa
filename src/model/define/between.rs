//! The angle between two velocities: `angle(v_A2, v_B2)`.

use crate::expr::Expr;
use crate::expr::Function;
use crate::expr::Symbol;
use crate::laws::geometry;
use crate::quantity::Dimension;

use super::super::Builder;
use super::super::Name;
use super::super::builder::SECOND_COST;

impl Builder<'_> {
    /// The angle between two velocities, with the equations that relate it to their components.
    pub(super) fn angle_between(&mut self, text: &str) -> Option<Symbol> {
        let (one, other) = text.strip_prefix("angle(")?.strip_suffix(')')?.split_once(',')?;
        let names = [one, other].map(|name| Name::parse(name.trim()).filter(|name| name.base == "v"));
        let [Some(one), Some(other)] = names else { return None };
        let ends = [&one, &other].map(|name| self.body_at(name));
        let [Some((first, start)), Some((second, end))] = ends else { return None };
        if self.axes.len() < 2 {
            return None;
        }
        let owners = [(&first, start), (&second, end)]
            .map(|(body, instant)| format!("that of {} {}", self.called(body), self.when(instant)));
        let meaning = format!("the angle between two velocities: {} and {}", owners[0], owners[1]);
        let angle = self.positive(format!("angle(v_{first}{start}, v_{second}{end})"), Dimension::NONE, meaning);
        if !self.defined.insert(format!("between {first}{start} {second}{end}")) {
            return Some(angle);
        }
        let speeds = [(&first, start), (&second, end)].map(|(body, at)| self.resolve(&format!("speed_{body}{at}")));
        let [Some(u), Some(v)] = speeds else { return None };
        let sizes = Expr::from(u) * Expr::from(v);
        let pairs = self.velocities(&first, start).into_iter().zip(self.velocities(&second, end));
        let product = Expr::sum(pairs.map(|(one, other)| one * other));
        let because = "the scalar product of two vectors is the product of their magnitudes and the cosine of the angle between them";
        let value = Expr::apply(Function::Acos, product.clone() / sizes.clone());
        self.law(&geometry::BETWEEN, None, because, (angle.into(), value));
        let sides = (product, sizes * Expr::from(angle).cos());
        self.law_at(SECOND_COST, &geometry::BETWEEN, None, because, sides);
        if self.axes.len() == 2 {
            let [one, other] =
                [(&first, start), (&second, end)].map(|(body, at)| self.resolve(&format!("angle_{body}{at}")));
            let apart = Expr::from(one?) - Expr::from(other?);
            let because = "it is the difference of the directions, whichever way round it is counted";
            self.law_at(SECOND_COST, &geometry::BETWEEN, None, because, (apart.cos(), Expr::from(angle).cos()));
        }
        Some(angle)
    }
}
