//! The canonical form of terms: polynomials, their quotients, and what is proven with them.

pub(super) mod canonical;
pub(super) mod coprime;
pub(super) mod factor;
pub(super) mod functions;
pub(super) mod gcd;
pub(super) mod monomial;
pub(super) mod polynomial;
pub(super) mod polynomial_in;
pub(super) mod quotient;
pub(super) mod readable;
pub(super) mod simplify;
