//! Magnitudes of vectors and angles between them: `magnitude(H_O1)`, `angle(v_A2, v_B2)`, `angle(v_A1, +z)`.

use crate::expr::Expr;
use crate::expr::Function;
use crate::expr::Symbol;
use crate::laws::geometry;
use crate::quantity::Dimension;

use super::super::Builder;
use super::super::Instant;
use super::super::Name;
use super::super::builder::SECOND_COST;
use super::super::component_name;

/// A vector that a name stands for, or a direction.
struct Vector {
    /// What it is, as a noun phrase.
    meaning: String,
    /// Its components along the axes of the scene.
    components: Vec<Expr>,
    /// Its magnitude; one for a direction.
    magnitude: Expr,
    /// Its dimension.
    dimension: Dimension,
}

impl Builder<'_> {
    /// The components of a vector by its name, with what it is and its dimension.
    fn components_of(&mut self, name: &str) -> Option<(Vec<Expr>, String, Dimension)> {
        let letters = self.axis_letters();
        if letters.len() < 2 {
            return None;
        }
        let symbols: Vec<Symbol> =
            letters.iter().map(|letter| self.resolve(&component_name(name, letter))).collect::<Option<_>>()?;
        let first = self.symbols.entry(*symbols.first()?).clone();
        let component = format!("the {}-component of ", letters.first()?);
        let meaning = first.meaning.strip_prefix(&component).unwrap_or(&first.meaning).to_owned();
        Some((symbols.into_iter().map(Expr::from).collect(), meaning, first.dimension))
    }

    /// The magnitude of a vector that has components.
    pub(super) fn magnitude_of(&mut self, text: &str) -> Option<Symbol> {
        let name = text.strip_prefix("magnitude(")?.strip_suffix(')')?.trim();
        let velocity = Name::parse(name).filter(|own| own.base == "v" && own.subject != "G" && own.component.is_none());
        if let Some(Name { subject, instant: Some(Instant::Number(number)), .. }) = velocity {
            return self.resolve(&format!("speed_{subject}{number}"));
        }
        let (components, meaning, dimension) = self.components_of(name)?;
        let symbol = self.positive(format!("magnitude({name})"), dimension, format!("the magnitude of {meaning}"));
        if self.defined.insert(format!("magnitude {name}")) {
            let squares = Expr::sum(components.into_iter().map(|component| component.powi(2)));
            let because = "the components of the vector are perpendicular";
            self.law(&geometry::MAGNITUDE, None, because, (symbol.into(), squares.sqrt()));
        }
        Some(symbol)
    }

    /// A vector by its name, or a direction along an axis.
    fn vector(&mut self, name: &str) -> Option<Vector> {
        if let Some(direction) = self.axis_direction(name) {
            let components = self.components(&direction);
            let dimension = Dimension::NONE;
            return Some(Vector {
                meaning: format!("the direction {name}"),
                components,
                magnitude: Expr::one(),
                dimension,
            });
        }
        let (components, meaning, dimension) = self.components_of(name)?;
        let magnitude = self.magnitude_of(&format!("magnitude({name})"))?.into();
        Some(Vector { meaning, components, magnitude, dimension })
    }

    /// The angle between two vectors, with the equations that relate it to their components.
    pub(super) fn angle_between(&mut self, text: &str) -> Option<Symbol> {
        let (one, other) = text.strip_prefix("angle(")?.strip_suffix(')')?.split_once(',')?;
        let [one, other] = [one, other].map(|name| self.at_its_instant(name.trim()));
        let [first, second] = [&one, &other].map(|name| self.vector(name));
        let (first, second) = (first?, second?);
        let both_velocities = [&first, &second].iter().all(|own| own.dimension == Dimension::VELOCITY);
        let meaning = if both_velocities {
            let [a, b] = [&first, &second].map(|own| own.meaning.replacen("the velocity", "that", 1));
            format!("the angle between two velocities: {a} and {b}")
        } else {
            format!("the angle between {} and {}", first.meaning, second.meaning)
        };
        let angle = self.positive(format!("angle({one}, {other})"), Dimension::NONE, meaning);
        if !self.defined.insert(format!("between {one} {other}")) {
            return Some(angle);
        }
        let sizes = first.magnitude * second.magnitude;
        let pairs = first.components.into_iter().zip(second.components);
        let product = Expr::sum(pairs.map(|(a, b)| a * b)).simplify();
        let because = "the scalar product of two vectors is the product of their magnitudes and the cosine of the angle between them";
        let value = Expr::apply(Function::Acos, product.clone() / sizes.clone());
        self.law(&geometry::BETWEEN, None, because, (angle.into(), value));
        self.law_at(SECOND_COST, &geometry::BETWEEN, None, because, (product, sizes * Expr::from(angle).cos()));
        if self.axes.len() == 2 && both_velocities {
            let [one, other] = [one, other].map(|name| self.resolve(&name.replacen("v_", "angle_", 1)));
            let apart = Expr::from(one?) - Expr::from(other?);
            let because = "it is the difference between the directions, without its sign";
            self.law_at(SECOND_COST, &geometry::BETWEEN, None, because, (apart.cos(), Expr::from(angle).cos()));
        }
        Some(angle)
    }

    /// The name of a velocity under the instant since which the body has it.
    fn at_its_instant(&self, name: &str) -> String {
        let since = || {
            let own = Name::parse(name).filter(|own| own.base == "v")?;
            let (body, since) = self.body_at(&own)?;
            Some(format!("v_{body}{since}"))
        };
        since().unwrap_or_else(|| name.to_owned())
    }
}
