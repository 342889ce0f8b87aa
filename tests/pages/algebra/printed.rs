//! Terms as they are printed: the LaTeX of a worked solution.

use super::term::Term;

/// What stands for quantities: their LaTeX, and their typed names.
pub type Names = Vec<(String, String)>;

/// The two sides of a displayed equation: of one with a series, what the series adds up to.
pub fn equation(latex: &str, names: &Names) -> Result<[Term; 2], String> {
    let plain = [r"\begin{aligned}", r"\end{aligned}", "\\text{\u{2003}}{}", r"\\", "&"];
    let text = plain.iter().fold(latex.to_owned(), |text, mark| text.replace(mark, " "));
    let text = text.split(r"\tag").next().unwrap_or_default();
    let (left, right) = text.split_once('=').ok_or("no equation")?;
    let right = right.rsplit('=').next().filter(|_| right.contains(r"\text{...}")).unwrap_or(right);
    Ok([read(left, names)?, read(right, names)?])
}

/// The term that a piece of LaTeX says.
pub fn read(latex: &str, names: &Names) -> Result<Term, String> {
    let mut names: Vec<&(String, String)> = names.iter().collect();
    names.sort_by_key(|(latex, _)| std::cmp::Reverse(latex.len()));
    let mut reader = Reader { rest: latex, names };
    let term = reader.sum()?;
    reader.gap();
    if reader.rest.is_empty() { Ok(term) } else { Err(format!("unread: {}", reader.rest)) }
}

struct Reader<'a> {
    rest: &'a str,
    names: Vec<&'a (String, String)>,
}

const FUNCTIONS: [(&str, &str); 8] = [
    (r"\sin", "sin"),
    (r"\cos", "cos"),
    (r"\tan", "tan"),
    (r"\arcsin", "asin"),
    (r"\arccos", "acos"),
    (r"\arctan", "atan"),
    (r"\exp", "exp"),
    (r"\ln", "ln"),
];

/// Brackets, and what closes them.
const BRACKETS: [(&str, &str); 6] = [
    (r"\left(", r"\right)"),
    (r"\left[", r"\right]"),
    (r"\text{[}", r"\text{]}"),
    ("(", ")"),
    ("[", "]"),
    (r"\lvert", r"\rvert"),
];

impl Reader<'_> {
    fn gap(&mut self) {
        loop {
            let before = self.rest;
            self.rest = self.rest.trim_start();
            for space in [r"\,", r"\ ", "{}"] {
                self.rest = self.rest.strip_prefix(space).unwrap_or(self.rest);
            }
            if before == self.rest {
                return;
            }
        }
    }

    fn takes(&mut self, mark: &str) -> bool {
        self.gap();
        let after = self.rest.strip_prefix(mark);
        self.rest = after.unwrap_or(self.rest);
        after.is_some()
    }

    fn expects(&mut self, mark: &str) -> Result<(), String> {
        if self.takes(mark) { Ok(()) } else { Err(format!("no {mark} before {}", self.rest)) }
    }

    fn sum(&mut self) -> Result<Term, String> {
        let mut sum = self.signed()?;
        loop {
            if self.takes("+") {
                sum = Term::Sum(Box::new(sum), Box::new(self.signed()?));
            } else if self.takes("-") {
                sum = Term::Sum(Box::new(sum), Box::new(Term::Minus(Box::new(self.product()?))));
            } else {
                return Ok(sum);
            }
        }
    }

    fn signed(&mut self) -> Result<Term, String> {
        if self.takes("-") { Ok(Term::Minus(Box::new(self.product()?))) } else { self.product() }
    }

    fn product(&mut self) -> Result<Term, String> {
        let mut product = self.power()?;
        loop {
            self.gap();
            let ends = ["+", "-", ")", "]", "}", r"\right", r"\rvert", r"\text{]}"];
            if self.rest.is_empty() || ends.iter().any(|mark| self.rest.starts_with(mark)) {
                return Ok(product);
            }
            product = Term::Product(Box::new(product), Box::new(self.power()?));
        }
    }

    fn power(&mut self) -> Result<Term, String> {
        let base = self.atom()?;
        if !self.takes("^") {
            return Ok(base);
        }
        Ok(Term::Power(Box::new(base), Box::new(self.group()?)))
    }

    fn group(&mut self) -> Result<Term, String> {
        self.expects("{")?;
        let inner = self.sum()?;
        self.expects("}")?;
        Ok(inner)
    }

    fn atom(&mut self) -> Result<Term, String> {
        self.gap();
        let belongs = |(latex, _): &&&(String, String)| self.rest.starts_with(latex.as_str());
        if let Some((latex, name)) = self.names.iter().find(belongs) {
            self.rest = &self.rest[latex.len()..];
            return Ok(Term::Name(name.clone()));
        }
        for (open, close) in BRACKETS {
            if self.takes(open) {
                let inner = self.sum()?;
                self.expects(close)?;
                return Ok(if open == r"\lvert" { Term::Call("abs".into(), vec![inner]) } else { inner });
            }
        }
        if self.takes(r"\frac") {
            return Ok(Term::Quotient(Box::new(self.group()?), Box::new(self.group()?)));
        }
        if self.takes(r"\sqrt") {
            return Ok(Term::Call("sqrt".into(), vec![self.group()?]));
        }
        for (command, name) in FUNCTIONS {
            if self.takes(command) {
                let exponent = if self.takes("^") { Some(self.group()?) } else { None };
                let applied = Term::Call(name.into(), vec![self.atom()?]);
                return Ok(match exponent {
                    Some(exponent) => Term::Power(Box::new(applied), Box::new(exponent)),
                    None => applied,
                });
            }
        }
        if self.takes(r"\pi") {
            return Ok(Term::Number(std::f64::consts::PI));
        }
        let length =
            self.rest.find(|letter: char| !letter.is_ascii_digit() && letter != '.').unwrap_or(self.rest.len());
        let (number, rest) = self.rest.split_at(length);
        // A value with its unit that the author wrote into a term.
        let degrees = rest.strip_prefix(r"{}^\circ");
        let with_unit = || {
            rest.strip_prefix(r"\text{")
                .filter(|unit| !unit.starts_with(['[', ']']))
                .and_then(|unit| unit.split_once('}'))
        };
        if let Some(after) = degrees.or_else(|| with_unit().map(|(_, after)| after)) {
            let is_own = |(_, name): &&&(String, String)| name.split_once(' ').is_some_and(|(word, _)| word == number);
            let (_, name) = self.names.iter().find(is_own).ok_or_else(|| format!("no value is {number}"))?;
            self.rest = after;
            return Ok(Term::Name(name.clone()));
        }
        let number = number.parse().map_err(|_| format!("cannot read {}", self.rest))?;
        self.rest = rest;
        Ok(Term::Number(number))
    }
}

#[test]
fn printed_terms_have_their_values() {
    let names: Names = [("m", "m"), ("v_{A1}", "v_A1"), (r"\beta", "beta"), ("(v_{B2})_{x}", "v_B2.x")]
        .map(|(latex, name)| (latex.to_owned(), name.to_owned()))
        .to_vec();
    let values = [("m", 2.0), ("v_A1", 3.0), ("beta", 0.5), ("v_B2.x", -4.0)];
    let values = values.map(|(name, value)| (name.to_owned(), value)).into_iter().collect();
    for (latex, value) in [
        (r"\frac{1}{2}\,m\,v_{A1}^{2} - m\,(v_{B2})_{x}", 17.0),
        (r"-\left[m + \left(-\frac{v_{A1}}{m}\right)^{2}\right]", -4.25),
        (r"(\sin \beta)[m - v_{A1}]\,\cos \beta", -(0.5_f64.sin() * 0.5_f64.cos())),
        (r"m\,\sin^{2} \beta + \sqrt{2 m}", 2.0 * 0.5_f64.sin().powi(2) + 2.0),
        (r"\frac{1}{m}\text{[}\ v_{A1} + \lvert (v_{B2})_{x}\rvert\text{]}", 3.5),
    ] {
        let found = read(latex, &names).unwrap_or_else(|fault| panic!("{latex}: {fault}")).value(&values).value;
        assert!((found - value).abs() < 1e-12, "{latex}: {found}");
    }
}
