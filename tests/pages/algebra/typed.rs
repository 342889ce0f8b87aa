//! Terms as they are typed: the sides of lines in the JSON of a solution.

use super::term::Term;

/// The term that a text says.
pub fn read(text: &str) -> Result<Term, String> {
    let letters: Vec<char> = text.chars().collect();
    let mut reader = Reader { letters, place: 0 };
    let term = reader.sum()?;
    reader.gap();
    if reader.place < reader.letters.len() { Err(format!("unread from {}", reader.place)) } else { Ok(term) }
}

struct Reader {
    letters: Vec<char>,
    place: usize,
}

impl Reader {
    fn gap(&mut self) {
        while self.letters.get(self.place) == Some(&' ') {
            self.place += 1;
        }
    }

    fn takes(&mut self, sign: char) -> bool {
        self.gap();
        let found = self.letters.get(self.place) == Some(&sign);
        self.place += usize::from(found);
        found
    }

    fn expects(&mut self, sign: char) -> Result<(), String> {
        if self.takes(sign) { Ok(()) } else { Err(format!("no `{sign}` at {}", self.place)) }
    }

    fn word(&mut self, belongs: impl Fn(char) -> bool) -> String {
        self.gap();
        let word: String = self.letters.iter().skip(self.place).take_while(|letter| belongs(**letter)).collect();
        self.place += word.chars().count();
        word
    }

    fn sum(&mut self) -> Result<Term, String> {
        let mut sum = self.product()?;
        loop {
            if self.takes('+') {
                sum = Term::Sum(Box::new(sum), Box::new(self.product()?));
            } else if self.takes('-') {
                sum = Term::Sum(Box::new(sum), Box::new(Term::Minus(Box::new(self.product()?))));
            } else {
                return Ok(sum);
            }
        }
    }

    fn product(&mut self) -> Result<Term, String> {
        if self.takes('-') {
            return Ok(Term::Minus(Box::new(self.product()?)));
        }
        let mut product = self.power()?;
        loop {
            if self.takes('*') {
                product = Term::Product(Box::new(product), Box::new(self.power()?));
            } else if self.takes('/') {
                product = Term::Quotient(Box::new(product), Box::new(self.power()?));
            } else {
                return Ok(product);
            }
        }
    }

    fn power(&mut self) -> Result<Term, String> {
        let base = self.atom()?;
        if !self.takes('^') {
            return Ok(base);
        }
        let exponent = if self.takes('-') { Term::Minus(Box::new(self.power()?)) } else { self.power()? };
        Ok(Term::Power(Box::new(base), Box::new(exponent)))
    }

    fn atom(&mut self) -> Result<Term, String> {
        if let Some(literal) = self.literal() {
            return Ok(Term::Name(literal));
        }
        if self.takes('(') {
            let inner = self.sum()?;
            self.expects(')')?;
            return Ok(inner);
        }
        if self.takes('{') {
            return self.pieces();
        }
        let number = self.word(|letter| letter.is_ascii_digit() || letter == '.');
        if !number.is_empty() {
            return number.parse().map(Term::Number).map_err(|_| format!("`{number}` is no number"));
        }
        let name = self.word(|letter| letter.is_alphanumeric() || "_.'[]".contains(letter));
        if name.is_empty() {
            return Err(format!("nothing readable at {}", self.place));
        }
        if !self.takes('(') {
            return Ok(if name == "pi" { Term::Number(std::f64::consts::PI) } else { Term::Name(name) });
        }
        // Names of quantities that are written like functions of vectors.
        if name == "magnitude" || name == "angle" {
            let inner = self.word(|letter| letter != ')');
            self.expects(')')?;
            return Ok(Term::Name(format!("{name}({inner})")));
        }
        let mut parts = vec![self.sum()?];
        while self.takes(',') {
            parts.push(self.sum()?);
        }
        self.expects(')')?;
        Ok(Term::Call(name, parts))
    }

    /// A number with its unit in brackets: `(60 deg)`.
    fn literal(&mut self) -> Option<String> {
        self.gap();
        let rest: String = self.letters.iter().skip(self.place).collect();
        let inside = rest.strip_prefix('(')?.split_once(')')?.0;
        let (number, unit) = inside.split_once(' ')?;
        let is_number = number.parse::<f64>().is_ok();
        let is_unit = unit.starts_with(|letter: char| letter.is_alphabetic() || letter == '°');
        (is_number && is_unit && !unit.contains(['(', '+', '-'])).then(|| {
            self.place += inside.chars().count() + 2;
            inside.to_owned()
        })
    }

    fn pieces(&mut self) -> Result<Term, String> {
        let mut pieces = Vec::new();
        loop {
            let value = self.sum()?;
            self.gap();
            let rest: String = self.letters.iter().skip(self.place).take(6).collect();
            let bound = if rest == "while " {
                self.place += 6;
                let variable = self.sum()?;
                self.expects('<')?;
                self.expects('=')?;
                Some((variable, self.sum()?))
            } else {
                None
            };
            pieces.push((bound, value));
            if !self.takes(';') {
                self.expects('}')?;
                return Ok(Term::Pieces(pieces));
            }
        }
    }
}
