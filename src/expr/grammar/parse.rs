//! Terms read from text, by operator precedence (a Pratt parser).

use super::super::{Expr, Function, Symbol};
use super::parse_fault::ParseFault;
use super::token::{Kind, Token, tokens};

/// Texts longer than this, in bytes, are not read.
pub const MAX_LENGTH: usize = 2000;
/// Brackets, functions and powers nested deeper than this are not read.
pub const MAX_DEPTH: usize = 100;

/// The names that a problem gives to its quantities.
pub trait Names {
    /// The symbol of that name: `v_A1.x`, `J_A[hit]`, `angle(v_A2, v_B2)`.
    fn symbol(&mut self, name: &str) -> Option<Symbol>;
    /// A known symbol without a name of its own, for a number with its unit: `9.81 m/s^2`. `None` where the unit is not
    /// one: shorter readings are tried then.
    fn literal(&mut self, number_with_unit: &str) -> Option<Symbol>;
}

/// The functions by name, with the number of their arguments; `sqrt` is a power and `atan` an `atan2`, and stand apart.
const FUNCTIONS: [(&str, Function, usize); 9] = [
    ("sin", Function::Sin, 1),
    ("cos", Function::Cos, 1),
    ("tan", Function::Tan, 1),
    ("asin", Function::Asin, 1),
    ("acos", Function::Acos, 1),
    ("atan2", Function::Atan2, 2),
    ("exp", Function::Exp, 1),
    ("ln", Function::Ln, 1),
    ("abs", Function::Abs, 1),
];

/// How tightly operators bind; a prefix minus is weaker than a power and stronger than a product.
const SUM: u8 = 10;
const PRODUCT: u8 = 20;
const PREFIX: u8 = 30;
const POWER: u8 = 40;

/// Reads a term.
///
/// ```
/// use momentous_expr::{Expr, Names, Symbol, parse};
/// struct Nobody;
/// impl Names for Nobody {
///     fn symbol(&mut self, _: &str) -> Option<Symbol> { None }
///     fn literal(&mut self, _: &str) -> Option<Symbol> { None }
/// }
/// assert_eq!(parse("2*(0.5 + 3)^2", &mut Nobody).unwrap().evaluate(&|_| 0.0), 24.5);
/// assert_eq!(parse("2*x", &mut Nobody).unwrap_err().message, "`x` is not known here");
/// ```
///
/// # Errors
/// Where the text is not a term: what was not understood, and where.
pub fn parse(text: &str, names: &mut dyn Names) -> Result<Expr, ParseFault> {
    if text.len() > MAX_LENGTH {
        let message = format!("a term of {} bytes; the limit is {MAX_LENGTH}", text.len());
        return Err(ParseFault { start: 0, end: text.len(), message, help: None });
    }
    let mut parser = Parser { text, tokens: tokens(text)?, next: 0, depth: 0, names };
    let term = parser.term(0)?;
    match parser.peek() {
        None => Ok(term),
        Some(token) => Err(Parser::unexpected(&token)),
    }
}

struct Parser<'a> {
    text: &'a str,
    tokens: Vec<Token<'a>>,
    next: usize,
    depth: usize,
    names: &'a mut dyn Names,
}

impl<'a> Parser<'a> {
    fn peek(&self) -> Option<Token<'a>> {
        self.tokens.get(self.next).cloned()
    }

    fn fault<T>(token: &Token, message: String, help: Option<String>) -> Result<T, ParseFault> {
        Err(ParseFault { start: token.start, end: token.end, message, help })
    }

    fn unexpected(token: &Token) -> ParseFault {
        let written = token.written;
        let (message, help) = match token.kind {
            Kind::Close => ("this bracket was never opened".to_owned(), None),
            Kind::Comma => ("a comma outside a function".to_owned(), Some("write decimals with a point".to_owned())),
            Kind::Name | Kind::Number(_) | Kind::Open => {
                let help = "write every product with `*`, and a unit directly after its number";
                (format!("an operator is missing before `{written}`"), Some(help.to_owned()))
            }
            Kind::Operator(_) => (format!("`{written}` needs a term on its left"), None),
        };
        ParseFault { start: token.start, end: token.end, message, help }
    }

    fn end_fault<T>(&self, message: &str) -> Result<T, ParseFault> {
        let end = self.text.trim_end().len();
        let start = self.tokens.last().map_or(0, |token| token.start);
        Err(ParseFault { start, end, message: message.to_owned(), help: None })
    }

    /// A term whose operators bind tighter than `floor`.
    fn term(&mut self, floor: u8) -> Result<Expr, ParseFault> {
        self.depth += 1;
        if self.depth > MAX_DEPTH
            && let Some(token) = self.peek()
        {
            return Self::fault(&token, format!("nested more than {MAX_DEPTH} deep"), None);
        }
        let mut left = self.prefix()?;
        while let Some(token) = self.peek()
            && let Kind::Operator(operator) = token.kind
        {
            let strength = match operator {
                '+' | '-' => SUM,
                '^' => POWER,
                _ => PRODUCT,
            };
            if strength <= floor {
                break;
            }
            self.next += 1;
            // a power binds to the right: 2^3^2 is 2^9
            let right = self.term(if operator == '^' { POWER - 1 } else { strength })?;
            left = match operator {
                '+' => left + right,
                '-' => left - right,
                '*' => left * right,
                '^' => left.power(right),
                _ if right.is_zero() => return Self::fault(&token, "a division by zero".to_owned(), None),
                _ => left / right,
            };
        }
        self.depth -= 1;
        Ok(left)
    }

    fn prefix(&mut self) -> Result<Expr, ParseFault> {
        let Some(token) = self.peek() else {
            return self.end_fault(if self.tokens.is_empty() { "an empty term" } else { "the term ends too early" });
        };
        self.next += 1;
        match &token.kind {
            Kind::Number(value) => match self.literal(&token)? {
                Some(symbol) => Ok(Expr::Symbol(symbol)),
                None => Ok(Expr::Number(value.clone())),
            },
            Kind::Operator('-') => Ok(-self.term(PREFIX)?),
            Kind::Operator('+') => self.term(PREFIX),
            Kind::Open => {
                let inner = self.term(0)?;
                self.close(&token)?;
                Ok(inner)
            }
            Kind::Name => self.name(&token),
            Kind::Operator(_) | Kind::Close | Kind::Comma => {
                let message = format!("a term is missing before `{}`", token.written);
                Self::fault(&token, message, None)
            }
        }
    }

    fn close(&mut self, open: &Token) -> Result<(), ParseFault> {
        match self.peek() {
            Some(token) if token.kind == Kind::Close => {
                self.next += 1;
                Ok(())
            }
            Some(token) => Err(Self::unexpected(&token)),
            None => Self::fault(open, "this bracket is never closed".to_owned(), None),
        }
    }

    /// The number with the longest unit that may follow it: words side by side, or joined by `/`, with whole powers.
    fn literal(&mut self, number: &Token) -> Result<Option<Symbol>, ParseFault> {
        let mut ends = Vec::new();
        let mut at = self.next;
        while self.is_name(at) {
            at += 1;
            ends.push(at);
            let power = self.is_operator(at, '^').then(|| at + 1 + usize::from(self.is_operator(at + 1, '-')));
            if let Some(power) = power
                && matches!(self.tokens.get(power), Some(Token { kind: Kind::Number(value), .. }) if value.is_int())
            {
                at = power + 1;
                ends.push(at);
            }
            if self.is_operator(at, '/') && self.is_name(at + 1) {
                at += 1;
            }
        }
        let Some(first) = self.tokens.get(self.next).filter(|_| !ends.is_empty()).cloned() else { return Ok(None) };
        for end in ends.into_iter().rev() {
            let last = self.tokens.get(end - 1);
            let written = last.and_then(|last| self.text.get(number.start..last.end));
            if let Some(symbol) = written.and_then(|written| self.names.literal(written)) {
                self.next = end;
                return Ok(Some(symbol));
            }
        }
        let message = format!("`{}` after a number is not a known unit", first.written);
        Self::fault(&first, message, Some("write a product with `*`".to_owned()))
    }

    fn is_name(&self, at: usize) -> bool {
        matches!(self.tokens.get(at), Some(Token { kind: Kind::Name, .. }))
    }

    fn is_operator(&self, at: usize, operator: char) -> bool {
        matches!(self.tokens.get(at), Some(Token { kind: Kind::Operator(written), .. }) if *written == operator)
    }

    fn name(&mut self, token: &Token) -> Result<Expr, ParseFault> {
        let name = token.written;
        let open = self.peek().filter(|token| token.kind == Kind::Open);
        let function = FUNCTIONS.iter().find(|(known, ..)| *known == name);
        match (name, function, open) {
            ("pi", _, None) => Ok(Expr::Pi),
            ("sqrt", _, Some(open)) => Ok(self.arguments(token, &open, 1)?.swap_remove(0).sqrt()),
            ("atan", _, Some(open)) => Ok(self.arguments(token, &open, 1)?.swap_remove(0).atan2(Expr::one())),
            (_, Some((_, function, count)), Some(open)) => {
                Ok(Expr::Apply(*function, self.arguments(token, &open, *count)?.into()))
            }
            ("sqrt" | "atan", _, None) | (_, Some(_), None) => Self::fault(
                token,
                format!("`{name}` needs its argument in brackets"),
                Some(format!("write `{name}(x)`")),
            ),
            (_, None, Some(open)) => self.call(token, &open),
            (_, None, None) => self.symbol(token, name),
        }
    }

    fn symbol(&mut self, token: &Token, name: &str) -> Result<Expr, ParseFault> {
        match self.names.symbol(name) {
            Some(symbol) => Ok(Expr::Symbol(symbol)),
            None => Self::fault(token, format!("`{name}` is not known here"), None),
        }
    }

    fn arguments(&mut self, name: &Token, open: &Token, count: usize) -> Result<Vec<Expr>, ParseFault> {
        self.next += 1;
        let mut arguments = vec![self.term(0)?];
        while let Some(Token { kind: Kind::Comma, .. }) = self.peek() {
            self.next += 1;
            arguments.push(self.term(0)?);
        }
        self.close(open)?;
        if arguments.len() != count {
            let message = format!("`{}` takes {count} argument(s), not {}", name.written, arguments.len());
            return Self::fault(name, message, None);
        }
        Ok(arguments)
    }

    /// A name with names in brackets is a name: `angle(v_A2, v_B2)`.
    fn call(&mut self, name: &Token, open: &Token) -> Result<Expr, ParseFault> {
        let called = name.written;
        if self.names.symbol(called).is_some() {
            let help = format!("write `{called}*(...)`");
            return Self::fault(open, format!("an operator is missing between `{called}` and the bracket"), Some(help));
        }
        let is_within = |token: &&Token| matches!(token.kind, Kind::Name | Kind::Comma | Kind::Operator('+' | '-'));
        let inside: Vec<Token> = self.tokens.iter().skip(self.next + 1).take_while(is_within).cloned().collect();
        let end = self.next + 1 + inside.len();
        // A direction along an axis is a name with its sign.
        let named = |part: &[Token]| match part {
            [name] if name.kind == Kind::Name => Some(name.written.to_owned()),
            [sign, name] if sign.kind != Kind::Name && name.kind == Kind::Name => {
                Some(format!("{}{}", sign.written, name.written))
            }
            _ => None,
        };
        let parts: Option<Vec<String>> = inside.split(|token| token.kind == Kind::Comma).map(named).collect();
        let last = self.tokens.get(end).filter(|token| token.kind == Kind::Close).cloned();
        let (Some(last), Some(parts)) = (last, parts) else {
            let help = "functions are sqrt, sin, cos, tan, asin, acos, atan, atan2, exp, ln and abs";
            return Self::fault(name, format!("`{called}` is not a function"), Some(help.to_owned()));
        };
        let whole = format!("{called}({})", parts.join(", "));
        let place = Token { end: last.end, ..name.clone() };
        self.next = end + 1;
        self.symbol(&place, &whole)
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::testing::AnyName;

    #[test]
    fn precedence_is_the_usual_one() {
        for (text, value) in [
            ("1 + 2*3", 7.0),
            ("2^3^2", 512.0),
            ("-2^2", -4.0),
            ("2^-1", 0.5),
            ("2 - 3 - 4", -5.0),
            ("12/3/2", 2.0),
            ("2**3*2", 16.0),
            ("-(1 + 2)*3", -9.0),
            ("1.2e3 + .5 + 3.", 1203.5),
            ("sqrt(16) + abs(-3) + atan2(0, 1)", 7.0),
            ("tan(atan(3/4))", 0.75),
            ("7 \u{2212} 2\u{b7}3", 1.0),
            ("cos(pi)", -1.0),
        ] {
            assert!((AnyName::default().term(text).evaluate(&|_| f64::NAN) - value).abs() < 1e-12, "{text}");
        }
    }

    #[test]
    fn names_and_literals_are_taken_whole() {
        for (text, expected) in [
            ("m_A*v_A1.x", vec!["m_A", "v_A1.x"]),
            ("J_A[hit].x + v_A@top", vec!["J_A[hit].x", "v_A@top"]),
            ("angle(v_A2,v_B2)/2", vec!["angle(v_A2, v_B2)"]),
            ("angle(v_A2, +z) - angle(-x, v_A1)", vec!["angle(v_A2, +z)", "angle(-x, v_A1)"]),
            ("9.81 m/s^2*t", vec!["9.81 m/s^2", "t"]),
            ("2 m/t_2", vec!["2 m", "t_2"]),
            ("2 kg m/s - 3 s", vec!["2 kg m/s", "3 s"]),
            ("e*1.2e3", vec!["e"]),
        ] {
            let mut names = AnyName::default();
            assert!(names.read(text).is_ok(), "{text}");
            let found: Vec<_> = names.0.iter().map(|(_, entry)| entry.name.as_str()).collect();
            assert_eq!(found, expected, "{text}");
        }
    }

    #[test]
    fn faults_say_where_and_what() {
        let deep = "(".repeat(150);
        let long = "1+".repeat(1500);
        for (text, place, message) in [
            ("", 0..0, "an empty term"),
            ("1 +", 2..3, "the term ends too early"),
            ("2*unknown", 2..9, "`unknown` is not known here"),
            ("a b", 2..3, "an operator is missing before `b`"),
            ("unknown(b + 1)", 0..7, "`unknown` is not a function"),
            ("a(b + 1)", 1..2, "an operator is missing between `a` and the bracket"),
            ("sin a", 0..3, "`sin` needs its argument in brackets"),
            ("sin(a, b)", 0..3, "`sin` takes 1 argument(s), not 2"),
            ("(a + b", 0..1, "this bracket is never closed"),
            ("a)", 1..2, "this bracket was never opened"),
            ("2 furlong", 2..9, "`furlong` after a number is not a known unit"),
            ("3..2", 0..4, "`3..2` is not a number"),
            ("1_200", 0..5, "`1_200` is not a number"),
            ("3,14", 1..2, "a comma outside a function"),
            ("a = b", 2..3, "`=` has no meaning in a term"),
            ("a/0", 1..2, "a division by zero"),
            ("1e999", 0..5, "a power of ten beyond 300"),
            ("\u{221a}2", 0..3, "`\u{221a}` has no meaning in a term"),
            (deep.as_str(), 100..101, "nested more than 100 deep"),
            (long.as_str(), 0..3000, "a term of 3000 bytes; the limit is 2000"),
        ] {
            let fault = AnyName::default().read(text).err();
            let found = fault.map(|fault| (fault.start..fault.end, fault.message));
            assert_eq!(found, Some((place, message.to_owned())), "{text}");
        }
    }

    #[test]
    fn towers_of_powers_cost_nothing() {
        let tower = AnyName::default().term("9^9^9^9");
        assert!(tower.as_number().is_none() && !tower.simplify().evaluate(&|_| 0.0).is_finite());
    }
}
