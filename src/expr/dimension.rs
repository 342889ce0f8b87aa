//! The dimension of a term, found from those of its symbols.

use std::fmt;

use momentous_quantity::Dimension;
use momentous_quantity::Rational;

use super::{Expr, Function, Symbol, SymbolTable};

/// Roots of the degrees 2, 3, 4, 6 and 12 are whole powers of twelfths.
const TWELFTHS: i8 = 12;

/// Why a term has no dimension.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum DimensionClash {
    /// Two terms of a sum, of the pieces of a function, or of its bounds, that cannot stand together.
    Sum {
        /// A term and its dimension.
        left: Box<(Expr, Dimension)>,
        /// A later term and its dimension.
        right: Box<(Expr, Dimension)>,
    },
    /// A part that must be a pure number, and what needs it.
    NotPure {
        /// The part.
        part: Expr,
        /// Its dimension.
        dimension: Dimension,
        /// The place: `sin`, `exp`, `an exponent`.
        place: &'static str,
    },
    /// A root of a quantity that has none: the square root of a length.
    Root {
        /// The term under the root.
        base: Expr,
        /// Its dimension.
        dimension: Dimension,
        /// The exponent.
        exponent: Expr,
    },
}

impl Expr {
    /// The dimension of the term. Numbers and angles are pure, and zero is of any dimension (it is reported as pure).
    ///
    /// # Errors
    /// The first parts that cannot stand together, from the left.
    ///
    /// ```
    /// use momentous_expr::{Expr, SymbolEntry, SymbolTable};
    /// use momentous_quantity::Dimension;
    /// let mut table = SymbolTable::default();
    /// let mut add = |name: &str, dimension| {
    ///     Expr::from(table.intern(SymbolEntry { name: name.into(), dimension, meaning: String::new() }))
    /// };
    /// let (m, v) = (add("m", Dimension::MASS), add("v", Dimension::VELOCITY));
    /// let momentum = m * v.clone();
    /// assert_eq!(momentum.dimension(&table), Ok(Dimension::MOMENTUM));
    /// assert!((momentum + v).dimension(&table).is_err());
    /// ```
    pub fn dimension(&self, symbols: &SymbolTable) -> Result<Dimension, DimensionClash> {
        match find(self, &|symbol| Ok(symbols.entry(symbol).dimension)) {
            // The root of a length is none, but that of a length times that of another is: in twelfths they all are.
            Err(clash @ DimensionClash::Root { .. }) => {
                let twelfths = |symbol| symbols.entry(symbol).dimension.power(TWELFTHS).ok_or_else(|| clash.clone());
                find(self, &twelfths)
                    .ok()
                    .and_then(|dimension| dimension.unwrap_or(Dimension::NONE).root(TWELFTHS))
                    .ok_or(clash)
            }
            dimension => Ok(dimension?.unwrap_or(Dimension::NONE)),
        }
    }

    /// Whether two terms may stand on both sides of an equation, and which dimension they share.
    ///
    /// # Errors
    /// The sides themselves, or parts within one of them, that cannot stand together.
    pub fn common_dimension(&self, other: &Self, symbols: &SymbolTable) -> Result<Dimension, DimensionClash> {
        let dimension = common([self, other].into_iter(), &|symbol| Ok(symbols.entry(symbol).dimension));
        Ok(dimension?.unwrap_or(Dimension::NONE))
    }
}

impl DimensionClash {
    /// The clash in a sentence, with `unit` naming the usual unit of a dimension.
    ///
    /// `cannot add m_A*v_A1 (kg m/s) to v_B1 (m/s)`
    #[must_use]
    pub fn sentence(&self, symbols: &SymbolTable, unit: &dyn Fn(Dimension) -> String) -> String {
        let shown = |term: &Expr, dimension: Dimension| {
            let unit = unit(dimension);
            let unit = if unit.is_empty() { "a pure number".to_owned() } else { unit };
            format!("{} ({unit})", term.text(symbols))
        };
        match self {
            Self::Sum { left, right } => {
                format!("cannot add {} to {}", shown(&left.0, left.1), shown(&right.0, right.1))
            }
            Self::NotPure { part, dimension, place } => {
                format!("{place} needs a pure number, not {}", shown(part, *dimension))
            }
            Self::Root { base, dimension, exponent } => {
                format!("{} has no power {}", shown(base, *dimension), exponent.text(symbols))
            }
        }
    }
}

/// The dimension of a symbol, where it has one that can be computed with.
type Of<'a> = &'a dyn Fn(Symbol) -> Result<Dimension, DimensionClash>;

/// `None` for zero, which is of any dimension.
type CommonDimension = Result<Option<Dimension>, DimensionClash>;

fn find(term: &Expr, dimensions: Of) -> CommonDimension {
    match term {
        Expr::Number(value) if value.is_zero() => Ok(None),
        Expr::Number(_) | Expr::Pi => Ok(Some(Dimension::NONE)),
        Expr::Symbol(symbol) => dimensions(*symbol).map(Some),
        Expr::Sum(terms) => common(terms.iter(), dimensions),
        Expr::Product(factors) => factors.iter().try_fold(Some(Dimension::NONE), |product, factor| {
            let factor = find(factor, dimensions)?;
            Ok(product.zip(factor).map(|(product, factor)| product * factor))
        }),
        Expr::Power(pair) => power(&pair.0, &pair.1, dimensions),
        Expr::Apply(function, arguments) => apply(*function, arguments, dimensions),
        Expr::Piecewise(piecewise) => {
            let bounds = piecewise.pieces.iter().filter_map(|(until, _)| until.as_ref());
            common(std::iter::once(&piecewise.variable).chain(bounds), dimensions)?;
            common(piecewise.pieces.iter().map(|(_, value)| value), dimensions)
        }
    }
}

fn common<'a>(terms: impl Iterator<Item = &'a Expr>, dimensions: Of) -> CommonDimension {
    let mut first: Option<(&Expr, Dimension)> = None;
    for term in terms {
        let Some(dimension) = find(term, dimensions)? else { continue };
        match first {
            None => first = Some((term, dimension)),
            Some((other, known)) if known != dimension => {
                return Err(DimensionClash::Sum {
                    left: Box::new((other.clone(), known)),
                    right: Box::new((term.clone(), dimension)),
                });
            }
            Some(_) => {}
        }
    }
    Ok(first.map(|(_, dimension)| dimension))
}

fn pure(part: &Expr, place: &'static str, dimensions: Of) -> Result<(), DimensionClash> {
    match find(part, dimensions)? {
        None | Some(Dimension::NONE) => Ok(()),
        Some(dimension) => Err(DimensionClash::NotPure { part: part.clone(), dimension, place }),
    }
}

fn power(base: &Expr, exponent: &Expr, dimensions: Of) -> CommonDimension {
    pure(exponent, "an exponent", dimensions)?;
    let Some(dimension) = find(base, dimensions)? else { return Ok(None) };
    if dimension == Dimension::NONE {
        return Ok(Some(dimension));
    }
    let raised = exponent.as_number().and_then(|exponent| raise(dimension, exponent));
    let clash = || DimensionClash::Root { base: base.clone(), dimension, exponent: exponent.clone() };
    raised.map(Some).ok_or_else(clash)
}

/// A fractional power, where every exponent divides.
fn raise(dimension: Dimension, exponent: &Rational) -> Option<Dimension> {
    let times = i8::try_from(exponent.numerator().clone()).ok()?;
    let degree = i8::try_from(exponent.denominator().clone()).ok()?;
    dimension.power(times)?.root(degree)
}

fn apply(function: Function, arguments: &[Expr], dimensions: Of) -> CommonDimension {
    match function {
        Function::Abs => common(arguments.iter(), dimensions),
        Function::Atan2 => common(arguments.iter(), dimensions).map(|_| Some(Dimension::NONE)),
        other => {
            arguments.iter().try_for_each(|argument| pure(argument, other.name(), dimensions))?;
            Ok(Some(Dimension::NONE))
        }
    }
}

impl fmt::Display for DimensionClash {
    /// Without the terms, which only a symbol table can name.
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sum { .. } => write!(out, "terms of different dimensions are added"),
            Self::NotPure { place, .. } => write!(out, "{place} needs a pure number"),
            Self::Root { .. } => write!(out, "a power that the dimension does not have"),
        }
    }
}

impl std::error::Error for DimensionClash {}

#[cfg(test)]
mod tests {
    use super::super::testing::AnyName;
    use super::*;

    #[test]
    fn laws_have_dimensions() {
        for (text, expected) in [
            ("m*v^2/2 + F*x", Dimension::ENERGY),
            ("sqrt(2*x*F/m)", Dimension::VELOCITY),
            ("v_A*0 + 0", Dimension::NONE),
            ("0 + v", Dimension::VELOCITY),
            ("m*abs(v)*sin(pi*t/t_2)", Dimension::MOMENTUM),
            ("atan2(v_y, v_x) + exp(-t/t_2)", Dimension::NONE),
            ("e^n*x", Dimension::LENGTH),
            ("sqrt(2)*sqrt(x)*sqrt(x_2)", Dimension::LENGTH),
            ("v*sqrt(m)/sqrt(m_A + m_B)", Dimension::VELOCITY),
            ("x^(1/3)*x^(2/3) + x", Dimension::LENGTH),
        ] {
            let mut names = AnyName::default();
            let term = names.term(text);
            assert_eq!(term.dimension(&names.0), Ok(expected), "{text}");
        }
    }

    #[test]
    fn clashes_name_their_parts() {
        let unit = |dimension| match dimension {
            Dimension::MOMENTUM => "kg m/s".to_owned(),
            Dimension::VELOCITY => "m/s".to_owned(),
            Dimension::TIME => "s".to_owned(),
            Dimension::LENGTH => "m".to_owned(),
            _ => String::new(),
        };
        for (text, expected) in [
            ("m_A*v_A1 + v_B1", "cannot add m_A*v_A1 (kg m/s) to v_B1 (m/s)"),
            ("1 + v", "cannot add 1 (a pure number) to v (m/s)"),
            ("exp(t)", "exp needs a pure number, not t (s)"),
            ("2^t", "an exponent needs a pure number, not t (s)"),
            ("sqrt(x)", "x (m) has no power 1/2"),
            ("x^n", "x (m) has no power n"),
        ] {
            let mut names = AnyName::default();
            let clash = names.term(text).dimension(&names.0).map_err(|clash| clash.sentence(&names.0, &unit));
            assert_eq!(clash, Err(expected.to_owned()), "{text}");
        }
    }
}
