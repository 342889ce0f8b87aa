//! Symbolic terms with exact rational constants.
//!
//! A term ([`Expr`]) is read from text ([`parse`]) and keeps the order in which it was written. Algebra goes through a
//! canonical form: a quotient of polynomials whose atoms are symbols, roots and functions. It decides equality ([`equal`]),
//! and is written readably again ([`Expr::simplify`]). For print a term is laid out as [`Math`], which prints itself as
//! plain text, `LaTeX`, Typst or `MathML`.

mod arrangement;
mod canonical;
mod coprime;
mod curvature;
mod derivative;
mod dimension;
mod evaluate;
mod factor;
mod functions;
mod gcd;
mod integral;
mod layout;
mod math;
mod math_latex;
mod math_mathml;
mod math_plain;
mod math_typst;
mod math_width;
mod monomial;
mod name;
mod notation;
mod parse;
mod pieces;
mod polynomial;
mod polynomial_in;
#[cfg(test)]
mod properties;
mod quotient;
mod readable;
mod sign;
mod simplify;
mod slopes;
mod symbol;
#[cfg(test)]
mod testing;
mod text;
mod token;
mod tree;

pub use arrangement::{Arrangement, Leaf, LeafKind};
pub use canonical::{equal, equal_rational, equal_where};
pub use curvature::is_curved;
pub use dimension::DimensionClash;
pub(crate) use math::subscript_parts;
pub use math::{Math, Operator};
pub(crate) use math_typst::{TypstMath, quoted};
pub use name::name_math;
pub use notation::Notation;
pub use parse::{MAX_DEPTH, MAX_LENGTH, Names, ParseFault, parse};
pub use symbol::{Symbol, SymbolEntry, SymbolTable};
pub use tree::{Expr, Function, Piecewise};
