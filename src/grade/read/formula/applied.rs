//! Functions, roots and fractions with their arguments. Without brackets an argument may end in more than one place: then it is
//! asked back.

use momentous_expr::Expr;
use momentous_quantity::Rational;

use super::super::unreadable::{At, UnreadableKind};
use super::grammar::{Grammar, Term, is_small};
use super::named::Named;
use super::token::Token;

/// The operator before an argument.
struct Operator<'a> {
    /// The function of the argument.
    of: &'a dyn Fn(Expr) -> Expr,
    /// Whether the argument is an angle.
    angle: bool,
    /// Whether the argument is a pure number.
    pure: bool,
}

impl Grammar<'_> {
    /// A function, a root or a fraction, which is next.
    pub(super) fn applied(&mut self) -> At<Term> {
        let at = self.at();
        let token = self.peek();
        self.advance();
        match token {
            Some(Token::Function(Named::PointAngle)) => {
                self.count(Named::PointAngle.cost())?;
                let [y, x] = self.two_arguments()?;
                Ok(Term::of(y.atan2(x)))
            }
            Some(Token::Function(Named::Pow)) => {
                let [base, exponent] = self.two_arguments()?;
                let number = exponent.as_number().filter(|number| is_small(number));
                let number = number.ok_or((at, UnreadableKind::TooLarge))?;
                if base.is_zero() && *number <= Rational::ZERO {
                    return Err((at, UnreadableKind::Undefined));
                }
                let is_root = !number.is_int() && *number.denominator() != 2_u8.into();
                self.count(if is_root { 2 } else { 0 })?;
                Ok(Term::of(base.power(exponent)))
            }
            Some(Token::Function(named)) => self.function(*named, at),
            Some(Token::Root(degree)) => self.root(*degree),
            Some(Token::IndexedRoot) => {
                let degree = self.nested(Self::bracket)?.value;
                let whole = degree.as_number().filter(|degree| degree.is_int());
                let degree = whole.and_then(|degree| u32::try_from(degree.numerator().clone()).ok());
                match degree {
                    Some(degree @ 2..=12) => self.root(degree),
                    _ => Err((at, UnreadableKind::TooLarge)),
                }
            }
            _ => {
                let above = self.nested(Self::bracket)?;
                let below = self.nested(Self::bracket)?;
                if below.value.is_zero() {
                    return Err((at, UnreadableKind::Undefined));
                }
                Ok(Term { bare: above.bare && below.bare, value: above.value / below.value })
            }
        }
    }

    fn root(&mut self, degree: u32) -> At<Term> {
        self.count(if degree == 2 { 0 } else { 2 })?;
        let of = |radicand: Expr| radicand.power(Expr::ratio(1, degree));
        self.not_indexed()?;
        self.argument(&Operator { of: &of, angle: false, pure: false }).map(|argument| Term::of(of(argument)))
    }

    /// `sqrt[3](x)` is a product as it stands, and meant for a cube root.
    fn not_indexed(&mut self) -> At<()> {
        let (at, mark) = (self.at(), self.mark());
        if self.peek() != Some(&Token::Open(']')) {
            return Ok(());
        }
        let index = self.nested(Self::bracket)?.value;
        let indexed = index.as_number().is_some_and(Rational::is_int) && matches!(self.peek(), Some(Token::Open(_)));
        if indexed {
            let radicand = self.nested(Self::bracket)?.value;
            let root = radicand.clone().power(index.clone().powi(-1));
            return self.two_readings(at, [&(index.sqrt() * radicand), &root]);
        }
        self.back_to(mark);
        Ok(())
    }

    fn function(&mut self, named: Named, at: usize) -> At<Term> {
        if named == Named::Log {
            return Err((at, UnreadableKind::Logarithm));
        }
        self.count(named.cost())?;
        // `sin^2 x` is the square of the sine, `sin^-1 x` the inverse function.
        let mut exponent = None;
        if self.peek() == Some(&Token::Power) {
            exponent = Some(self.exponent(&|exponent| exponent, false)?);
        }
        let mut named = named;
        if exponent.as_ref().and_then(Expr::as_number).is_some_and(|power| *power == -Rational::ONE) {
            named = match named.inverse() {
                Some(inverse) => inverse,
                None => return Err((at, UnreadableKind::InverseOrReciprocal)),
            };
            exponent = None;
        }
        let of = |argument: Expr| {
            let value = named.of(argument);
            exponent.clone().map_or(value.clone(), |exponent| value.power(exponent))
        };
        let operator = Operator { of: &of, angle: named.takes_angle(), pure: named.takes_pure() };
        self.argument(&operator).map(|argument| Term::of(of(argument)))
    }

    /// The argument that follows, in brackets or without.
    fn argument(&mut self, operator: &Operator) -> At<Expr> {
        let at = self.at();
        if matches!(self.peek(), Some(Token::Open(_) | Token::Bar)) {
            let argument = self.nested(Self::bracket)?;
            return angle(argument, operator, at);
        }
        let Some(next) = self.peek().filter(|next| next.begins_argument()) else {
            return self.fault(UnreadableKind::NoArgument);
        };
        let is_function = matches!(next, Token::Function(_) | Token::Root(_) | Token::IndexedRoot | Token::Fraction);
        let mut short = self.primary()?;
        // No angle is a plain number: it belongs to what stands behind it, `sin 2θ`.
        if operator.angle && short.bare && matches!(self.peek(), Some(Token::Name(_) | Token::Pi)) {
            let factor = self.primary()?;
            short = Term::of(short.value * factor.value);
        }
        let open = match self.peek() {
            Some(Token::Power) => !is_function,
            Some(Token::Times | Token::Over) => true,
            Some(next) => self.is_factor(next),
            None => false,
        };
        let behind = self.ahead(usize::from(matches!(self.peek(), Some(Token::Times | Token::Over))));
        let is_apart = matches!(behind, Some(Token::Function(_) | Token::Root(_) | Token::IndexedRoot));
        if !open || is_apart {
            return angle(short, operator, at);
        }
        let mark = self.mark();
        let long = self.rest_of_product(short.clone())?.value;
        self.back_to(mark);
        if operator.pure && !self.is_pure(&long) && self.is_pure(&short.value) {
            return angle(short, operator, at);
        }
        let apart = self.rest_of_product(Term::of((operator.of)(short.value)))?.value;
        self.two_readings(at, [&apart, &(operator.of)(long)])
    }

    /// A product whose first factor, perhaps with a power behind it, is read.
    fn rest_of_product(&mut self, first: Term) -> At<Term> {
        let first = self.raised(first)?;
        self.product_from(first)
    }

    /// Two arguments in brackets, with a comma between them.
    fn two_arguments(&mut self) -> At<[Expr; 2]> {
        let at = self.at();
        let Some(Token::Open(close)) = self.peek() else { return self.fault(UnreadableKind::NoArgument) };
        self.advance();
        let first = self.nested(Self::sum)?;
        if !self.take(&Token::Comma) {
            return self.fault(UnreadableKind::NotAFormula);
        }
        let second = self.nested(Self::sum)?;
        if !self.take(&Token::Close(*close)) {
            return Err((at, UnreadableKind::OpenBracket));
        }
        Ok([first.value, second.value])
    }
}

/// An argument; of what takes an angle, one with its unit.
fn angle(argument: Term, operator: &Operator, at: usize) -> At<Expr> {
    if operator.angle && argument.bare { Err((at, UnreadableKind::AngleUnit)) } else { Ok(argument.value) }
}
