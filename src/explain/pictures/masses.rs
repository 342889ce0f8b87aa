//! Masses of bodies at instants: their values, their symbols, and how they are written.

use std::sync::Arc;

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::Operator;
use momentous_expr::Symbol;
use momentous_expr::name_math;
use momentous_model::Name;
use momentous_model::QuantityKind;
use momentous_scene::Term;

use super::labels::factor;
use super::labels::product;
use super::quantities::Quantities;

impl<'a> Quantities<'a> {
    /// The mass of a body at an instant, from its weight if need be.
    pub(super) fn mass(&self, body: &str, instant: usize) -> Option<f64> {
        let parts = self.scene().parts_of(body);
        if !parts.is_empty() && self.mass_term(body, instant).is_none() {
            return parts.iter().map(|part| self.mass(part, instant)).sum();
        }
        let mass = match self.mass_term(body, instant) {
            Some(term) => self.evaluate(&self.term(term)?),
            None => self.named(&self.mass_name(body, instant)),
        };
        // No body is without mass: where the equations leave only that, the mass is not known.
        let mass = mass.filter(|mass| *mass > 0.0);
        let parts = self.scene().division_of(body);
        let sum =
            || parts.iter().map(|part| self.mass(part, instant)).sum::<Option<f64>>().filter(|_| !parts.is_empty());
        let mass = mass.or_else(sum);
        mass.or_else(|| Some(self.named(&format!("W_{body}"))? / self.named("g")?))
    }

    /// The symbol of the mass of a body at an instant, where it is one.
    pub(super) fn mass_symbol(&self, body: &str, instant: usize) -> Option<Symbol> {
        match self.mass_term(body, instant) {
            Some(term) => match self.term(term)? {
                Expr::Symbol(symbol) => Some(symbol),
                _ => None,
            },
            None => self.model().symbol_of(&self.mass_name(body, instant)),
        }
    }

    /// The notation of the mass of a body at an instant.
    pub(super) fn mass_math(&self, body: &str, instant: usize) -> Math {
        let mut members = self.scene().members(body);
        let parts = self.scene().division_of(body);
        let named = self.model().symbol_of(&self.mass_name(body, instant)).is_some();
        if !named && self.mass_term(body, instant).is_none() && !parts.is_empty() {
            members = parts;
        }
        if members.len() > 1 && self.mass_term(body, instant).is_none() {
            return sum(members.into_iter().map(|member| self.mass_math(member, instant)));
        }
        let term = self.mass_term(body, instant).and_then(|term| self.term(term));
        term.map_or_else(|| name_math(&self.mass_name(body, instant)), |term| factor(&term, self.symbolic(&term)))
    }

    /// The mass as the author wrote it.
    fn mass_term(&self, body: &str, instant: usize) -> Option<&'a Term> {
        self.scene().mass_term(body, instant)
    }

    fn mass_name(&self, body: &str, instant: usize) -> String {
        let name = Name::of(QuantityKind::Mass, body);
        self.scene().mass_since(body, instant).map_or_else(|| name.clone(), |since| name.clone().at(since)).to_string()
    }
}

/// A sum in brackets; equal terms as a multiple of one, which needs no brackets where there is no other.
fn sum(terms: impl Iterator<Item = Math>) -> Math {
    let mut counted: Vec<(Math, usize)> = Vec::new();
    for term in terms {
        match counted.iter_mut().find(|(listed, _)| *listed == term) {
            Some((_, count)) => *count += 1,
            None => counted.push((term, 1)),
        }
    }
    let multiple = |(term, count): (Math, usize)| match count {
        1 => term,
        _ => product([Math::Number(count.to_string()), term]),
    };
    let mut terms: Vec<Math> = counted.into_iter().map(multiple).collect();
    if terms.len() == 1 {
        return terms.remove(0);
    }
    let plus = |(place, term)| [(place > 0).then_some(Math::Operator(Operator::Plus)), Some(term)];
    Math::Bracketed(Arc::new(Math::Row(terms.into_iter().enumerate().flat_map(plus).flatten().collect())))
}
