//! Magnitudes of vectors and angles between them: `magnitude(H_O1)`, `angle(v_A2, v_B2)`, `angle(v_A1, +z)`.

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Symbol;
use momentous_laws::geometry;
use momentous_quantity::Dimension;

use super::super::Because;
use super::super::Builder;
use super::super::Instant;
use super::super::Name;
use super::super::QuantityKind;
use super::super::VectorKind;
use super::super::builder::SECOND_COST;
use super::super::component_name;
use super::super::name::Meaning;

/// A vector that a name stands for, or a direction.
struct Vector {
    /// Its meaning, as a noun phrase.
    meaning: Meaning,
    /// Its components along the axes of the scene.
    components: Vec<Expr>,
    /// Its magnitude; one for a direction.
    magnitude: Expr,
    /// Its dimension.
    dimension: Dimension,
}

impl Builder<'_> {
    /// The components of a vector by its name, with what it is and its dimension.
    pub(crate) fn components_of(&mut self, name: &str) -> Option<(Vec<Expr>, Meaning, Dimension)> {
        let letters = self.axis_letters();
        let symbols: Vec<Symbol> = match &letters[..] {
            [_] => vec![self.resolve(name)?],
            _ => letters.iter().map(|letter| self.resolve(&component_name(name, letter))).collect::<Option<_>>()?,
        };
        let first = self.symbols.entry(*symbols.first()?).clone();
        let known = self.vectors.get(symbols.first()?).cloned();
        let meaning = known.unwrap_or(Meaning { noun: "", of: first.meaning });
        Some((symbols.into_iter().map(Expr::from).collect(), meaning, first.dimension))
    }

    /// The magnitude of a vector that has components.
    pub(super) fn magnitude_of(&mut self, name: &str) -> Option<Symbol> {
        if let Some(velocity) =
            velocity(name).filter(|velocity| !velocity.is_of_mass_centre() && velocity.component.is_none())
            && matches!(velocity.instant, Some(Instant::Number(_)))
        {
            return self.quantity(Name { kind: QuantityKind::Speed, stage: None, ..velocity });
        }
        let (components, meaning, dimension) = self.components_of(name)?;
        let magnitude = Name::of(QuantityKind::Magnitude(name.to_owned()), "");
        let symbol = self.symbol_of(magnitude, dimension, format!("the magnitude of {meaning}"));
        self.system.positive.insert(symbol);
        if self.defined.insert(format!("magnitude {name}")) {
            if let [only] = &components[..] {
                let value = Expr::apply(Function::Abs, only.clone());
                self.law(&geometry::ASKED, None, Because::Definition, (symbol.into(), value));
                return Some(symbol);
            }
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
                meaning: Meaning { noun: "the direction", of: name.to_owned() },
                components,
                magnitude: Expr::one(),
                dimension,
            });
        }
        let (components, meaning, dimension) = self.components_of(name)?;
        let magnitude = self.magnitude_of(name)?.into();
        Some(Vector { meaning, components, magnitude, dimension })
    }

    /// The angle between two vectors, with the equations that relate it to their components.
    pub(super) fn angle_between(&mut self, names: [&str; 2]) -> Option<Symbol> {
        let [one, other] = names.map(|name| self.at_its_instant(name));
        let [first, second] = [&one, &other].map(|name| self.vector(name));
        let (first, second) = (first?, second?);
        let both_velocities = [&first, &second].iter().all(|vector| vector.dimension == Dimension::VELOCITY);
        let meaning = if both_velocities {
            format!("the angle between two velocities: that {} and that {}", first.meaning.of, second.meaning.of)
        } else {
            format!("the angle between {} and {}", first.meaning, second.meaning)
        };
        let angle = self.positive(Name::of(QuantityKind::AngleBetween([one.clone(), other.clone()]), ""), meaning);
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
            let direction = |name: Name| Name { kind: QuantityKind::Direction(VectorKind::Velocity), ..name };
            // A velocity seen from the centre of mass has no direction of its own.
            if let [Some(one), Some(other)] = [one, other].map(|name| self.quantity(direction(velocity(&name)?))) {
                let apart = Expr::from(one) - Expr::from(other);
                let because = "it is the difference between the directions, without its sign";
                self.law_at(SECOND_COST, &geometry::BETWEEN, None, because, (apart.cos(), Expr::from(angle).cos()));
            }
        }
        Some(angle)
    }

    /// The name of a velocity under the instant since which the body has it.
    fn at_its_instant(&self, name: &str) -> String {
        let since = || {
            let velocity = velocity(name)?;
            let (body, since) = self.body_at(&velocity)?;
            Some(Name::of(QuantityKind::Velocity, &body).at(since).to_string())
        };
        since().unwrap_or_else(|| name.to_owned())
    }
}

/// A name that is one of a velocity, taken apart.
fn velocity(name: &str) -> Option<Name> {
    Name::parse(name).filter(|name| name.kind == QuantityKind::Velocity)
}
