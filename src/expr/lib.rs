//! Symbolic terms with exact rational constants.
//!
//! A term ([`Expr`]) is read from text ([`parse`]) and keeps the order in which it was written. Algebra goes through a
//! canonical form: a quotient of polynomials whose atoms are symbols, roots and functions. It decides equality ([`equal`]),
//! and is written readably again ([`Expr::simplify`]). For print a term is laid out as [`Math`], which prints itself as
//! plain text, `LaTeX`, Typst or `MathML`.

mod algebra;
mod calculus;
mod dimension;
mod evaluate;
mod grammar;
#[cfg(test)]
mod properties;
mod sign;
mod symbol;
#[cfg(test)]
mod testing;
mod tree;
mod typeset;

pub use algebra::canonical::{equal, equal_rational, equal_where};
pub use calculus::curvature::is_curved;
pub use dimension::DimensionClash;
pub use grammar::parse::{MAX_DEPTH, MAX_LENGTH, Names, parse};
pub use grammar::parse_fault::ParseFault;
pub use symbol::{Symbol, SymbolEntry, SymbolTable};
pub use tree::{Expr, Function, Piecewise};
pub use typeset::arrangement::{Arrangement, Leaf, LeafKind};
pub use typeset::math::subscript_parts;
pub use typeset::math::{Math, Operator};
pub use typeset::name::name_math;
pub use typeset::notation::Notation;
pub use typeset::typst::{TypstMath, quoted};
