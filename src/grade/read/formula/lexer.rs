//! From characters to tokens: Unicode, LaTeX and plain text alike. Names are not yet told apart.

use momentous_quantity::Rational;

use super::super::numeral::{self, DecimalMark};
use super::super::unreadable::{At, UnreadableKind};
use super::latex::{Command, command};
use super::named::Named;
use super::signs::{self, NOTHING};
use super::systems::without_libraries;
use super::token::{Letter, Lexeme, MAX_DEPTH, Place, Token};

/// A decimal of so many figures may be a rounded number.
const ROUNDED_FIGURES: usize = 3;

/// The tokens of a formula; `own_e` says that `e` is a quantity of the problem, so that `2e3` may be a product.
pub(super) fn lexemes(answer: &str, mark: DecimalMark, own_e: bool) -> At<Vec<Lexeme>> {
    let mut signs: Vec<char> = answer.chars().map(signs::plain).collect();
    without_libraries(&mut signs, own_e);
    let mut lexer = Lexer::new(&signs, mark, own_e);
    while lexer.at < signs.len() {
        lexer.step()?;
    }
    Ok(lexer.found)
}

pub(super) struct Lexer<'a> {
    pub(super) signs: &'a [char],
    pub(super) at: usize,
    gap: bool,
    depth: usize,
    mark: DecimalMark,
    own_e: bool,
    /// The open braces, and whether each only holds together what LaTeX is to show in some way.
    pub(super) braces: Vec<bool>,
    pub(super) found: Vec<Lexeme>,
}

impl<'a> Lexer<'a> {
    fn new(signs: &'a [char], mark: DecimalMark, own_e: bool) -> Self {
        Self { signs, at: 0, gap: false, depth: 0, mark, own_e, braces: Vec::new(), found: Vec::new() }
    }

    pub(super) fn peek(&self, ahead: usize) -> Option<char> {
        self.signs.get(self.at + ahead).copied()
    }

    pub(super) fn skip_spaces(&mut self) {
        while matches!(self.peek(0), Some(' ' | NOTHING)) {
            self.at += 1;
        }
    }

    pub(super) fn push(&mut self, token: Token, at: usize) {
        let gap = std::mem::take(&mut self.gap);
        self.found.push(Lexeme { token, at, gap });
    }

    /// Reads one token, or what says nothing.
    fn step(&mut self) -> At<()> {
        let at = self.at;
        let Some(sign) = self.peek(0) else { return Ok(()) };
        if sign.is_ascii_digit() || sign == '.' && self.peek(1).is_some_and(|next| next.is_ascii_digit()) {
            return self.number();
        }
        if let Some((above, below)) = signs::fraction(sign) {
            self.at += 1;
            self.vulgar(Rational::from(above) / Rational::from(below), at);
            return Ok(());
        }
        if signs::unraised(sign).is_some() {
            return self.raised();
        }
        if self.begins_word() {
            let letters = self.word()?;
            self.push(Token::Word(letters), at);
            return Ok(());
        }
        self.at += 1;
        let glued = self.peek(0);
        let token = match sign {
            ' ' => {
                self.gap = true;
                return Ok(());
            }
            NOTHING | '$' => return Ok(()),
            '.' if self.signs[self.at..].iter().all(|next| matches!(*next, ' ' | '.' | NOTHING)) => return Ok(()),
            '\\' => return self.command(at),
            '{' => return self.brace(at),
            '}' if self.braces.pop() == Some(true) => return Ok(()),
            '+' if glued == Some('/') && self.peek(1) == Some('-') => {
                self.at += 1;
                self.pair(Token::PlusMinus)
            }
            '+' if glued == Some('-') => self.pair(Token::PlusMinus),
            '-' if glued == Some('+') => self.pair(Token::PlusMinus),
            '*' if glued == Some('*') => self.pair(Token::Power),
            '^' if self.takes_circle() => Token::Degree,
            '^' if self.index_behind_power(at)? => return Ok(()),
            '+' => Token::Plus,
            '-' => Token::Minus,
            '±' => Token::PlusMinus,
            '*' => Token::Times,
            '/' | ':' => Token::Over,
            '^' => Token::Power,
            '(' => Token::Open(')'),
            '[' => Token::Open(']'),
            ')' | ']' | '}' => Token::Close(sign),
            '|' => Token::Bar,
            '√' => Token::Root(2),
            '∛' => Token::Root(3),
            '∜' => Token::Root(4),
            '°' => Token::Degree,
            ',' | ';' => Token::Comma,
            '=' => Token::Equals,
            _ => return Err((at, UnreadableKind::NotAFormula)),
        };
        self.push(token, at);
        Ok(())
    }

    fn pair(&mut self, token: Token) -> Token {
        self.at += 1;
        token
    }

    fn number(&mut self) -> At<()> {
        let start = self.at;
        let belongs = |sign: &&char| sign.is_ascii_digit() || ".,' _eE+-".contains(**sign);
        let text: String = self.signs[start..].iter().take_while(belongs).collect();
        let numeral = numeral::read(&text, self.mark).map_err(|(at, kind)| (start + at, kind))?;
        let written: String = text.chars().take(numeral.length).collect();
        let digits = written.split_once(['e', 'E']).map_or(&written[..], |(digits, _)| digits);
        if self.own_e && digits.len() < written.len() {
            let power = written.replacen(['e', 'E'], "*10^", 1);
            let product = written.replacen(['e', 'E'], "*e*", 1).replace("*+", " + ").replace("*-", " - ");
            let readings = vec![power, product];
            return Err((start, UnreadableKind::AmbiguousName { name: written.clone(), readings }));
        }
        self.at += numeral.length;
        self.lost_product(digits, start)?;
        self.push(Token::Number { value: numeral.decimal.to_rational(), half: half_unit(&written) }, start);
        Ok(())
    }

    /// `3.10^8` is as often meant for 3 × 10^8.
    fn lost_product(&self, digits: &str, start: usize) -> At<()> {
        let raised = self.peek(0).is_some_and(|next| next == '^' || signs::unraised(next).is_some());
        match digits.strip_suffix("10").filter(|_| raised).and_then(|front| front.strip_suffix(['.', ','])) {
            Some(front) if !front.is_empty() => {
                let readings = [format!("({digits})^..."), format!("{front}*10^...")];
                Err((start, UnreadableKind::TwoReadings(readings)))
            }
            _ => Ok(()),
        }
    }

    /// A fraction of one character; a whole number right before it belongs to it.
    fn vulgar(&mut self, value: Rational, at: usize) {
        if let Some(Lexeme { token: Token::Number { value: whole, half: None }, .. }) = self.found.last_mut()
            && !self.gap
            && whole.is_int()
        {
            *whole += value;
            return;
        }
        self.push(Token::Number { value, half: None }, at);
    }

    /// Puts a power that is written above the line into brackets.
    fn raised(&mut self) -> At<()> {
        let start = self.at;
        let raised: Vec<char> = self.signs[start..].iter().map_while(|sign| signs::unraised(*sign)).collect();
        self.at += raised.len();
        self.push(Token::Power, start);
        self.push(Token::Open(')'), start);
        self.lex(&raised, start)?;
        self.push(Token::Close(')'), self.at);
        Ok(())
    }

    /// The tokens of the signs between two places.
    pub(super) fn within(&mut self, start: usize, end: usize) -> At<()> {
        let signs = self.signs;
        self.lex(signs.get(start..end).unwrap_or_default(), start)
    }

    fn lex(&mut self, signs: &[char], start: usize) -> At<()> {
        let mut inner = Lexer::new(signs, self.mark, self.own_e);
        while inner.at < signs.len() {
            inner.step().map_err(|(at, kind)| (start + at, kind))?;
        }
        for mut lexeme in inner.found {
            lexeme.at += start;
            if let Token::Word(letters) = &mut lexeme.token {
                for letter in letters {
                    letter.at += start;
                }
            }
            self.found.push(lexeme);
        }
        Ok(())
    }

    fn brace(&mut self, at: usize) -> At<()> {
        self.skip_spaces();
        if self.peek(0) == Some('}') {
            self.at += 1;
            return Ok(());
        }
        if self.braces.len() >= MAX_DEPTH {
            return Err((at, UnreadableKind::TooDeep));
        }
        self.braces.push(false);
        self.push(Token::Open('}'), at);
        Ok(())
    }

    /// `^\circ`, with braces or without.
    fn takes_circle(&mut self) -> bool {
        let rest: String = self.signs[self.at..].iter().filter(|sign| **sign != ' ').take(8).collect();
        let Some(length) =
            ["{\\circ}", "\\circ"].iter().find(|spelling| rest.starts_with(**spelling)).map(|spelling| spelling.len())
        else {
            return false;
        };
        let mut left = length;
        while left > 0 && self.at < self.signs.len() {
            left -= usize::from(self.peek(0) != Some(' '));
            self.at += 1;
        }
        true
    }

    /// The name of a command whose backslash is behind us; a sign is a name, too.
    pub(super) fn command_name(&mut self) -> String {
        let letters: String = self.signs[self.at..].iter().take_while(|sign| sign.is_ascii_alphabetic()).collect();
        let name = if letters.is_empty() { self.peek(0).map(String::from).unwrap_or_default() } else { letters };
        self.at += name.chars().count();
        name
    }

    fn command(&mut self, at: usize) -> At<()> {
        let name = self.command_name();
        match command(&name) {
            Some(Command::Space) => self.gap = true,
            Some(Command::Nothing) => {}
            Some(Command::Wrapper) => self.wrapper(),
            Some(Command::Token(Token::Function(Named::Log))) if self.takes_ten() => {
                self.push(Token::Function(Named::Log10), at);
            }
            Some(Command::Token(token)) => self.push(token, at),
            Some(Command::Fraction) => {
                self.push(Token::Fraction, at);
                self.argument()?;
                self.argument()?;
            }
            Some(Command::Root) => {
                self.skip_spaces();
                let indexed = self.peek(0) == Some('[');
                self.push(if indexed { Token::IndexedRoot } else { Token::Root(2) }, at);
            }
            // Letters begin words, and are met there.
            Some(Command::Letter(_)) | None => return Err((at, UnreadableKind::NotAFormula)),
        }
        Ok(())
    }

    /// The base of a logarithm, where it is ten.
    fn takes_ten(&mut self) -> bool {
        let rest: String = self.signs[self.at..].iter().take(5).collect();
        let length = ["_{10}", "_10"].iter().find(|base| rest.starts_with(**base)).map_or(0, |base| base.len());
        self.at += length;
        length > 0
    }

    /// The brace behind a command that says how its argument looks.
    pub(super) fn wrapper(&mut self) {
        self.skip_spaces();
        if self.peek(0) == Some('{') {
            self.at += 1;
            self.braces.push(true);
        }
    }

    /// The argument of a command: what stands in braces, or one sign.
    fn argument(&mut self) -> At<()> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err((self.at, UnreadableKind::TooDeep));
        }
        self.skip_spaces();
        let at = self.at;
        if self.peek(0) == Some('{') {
            let level = self.braces.len();
            self.step()?;
            while self.braces.len() > level && self.at < self.signs.len() {
                self.step()?;
            }
        } else {
            self.push(Token::Open('}'), at);
            self.single()?;
            self.push(Token::Close('}'), self.at);
        }
        self.depth -= 1;
        Ok(())
    }

    fn single(&mut self) -> At<()> {
        let at = self.at;
        match self.peek(0) {
            Some(digit) if digit.is_ascii_digit() => {
                self.at += 1;
                let value = Rational::from(digit.to_digit(10).unwrap_or(0));
                self.push(Token::Number { value, half: None }, at);
            }
            Some(letter) if letter.is_alphabetic() => {
                self.at += 1;
                self.push(Token::Word(vec![Letter { sign: letter, place: Place::Beside, at }]), at);
            }
            _ => self.step()?,
        }
        Ok(())
    }

    /// Whether a letter stands here, be it a command.
    fn begins_word(&self) -> bool {
        match self.peek(0) {
            Some('\\') => self.letter_command(1).is_some(),
            Some(sign) => sign.is_alphabetic() && signs::unraised(sign).is_none(),
            None => false,
        }
    }

    /// The letter that a command at that distance names, and the length of its name.
    pub(super) fn letter_command(&self, ahead: usize) -> Option<(char, usize)> {
        let name: String =
            self.signs.get(self.at + ahead..)?.iter().take_while(|sign| sign.is_ascii_alphabetic()).collect();
        match command(&name) {
            Some(Command::Letter(letter)) if Named::find(&name).is_none() => Some((letter, name.len())),
            _ => None,
        }
    }
}

/// Half a unit of the last place of a decimal that may be rounded.
fn half_unit(written: &str) -> Option<Rational> {
    let (digits, power) = written.split_once(['e', 'E']).unwrap_or((written, "0"));
    let (_, decimals) = digits.rsplit_once(['.', ','])?;
    let figures = digits.trim_start_matches(['0', '.', ',']).chars().filter(char::is_ascii_digit).count();
    let place = power.parse::<isize>().ok()? - isize::try_from(decimals.len()).ok()?;
    (figures >= ROUNDED_FIGURES).then(|| Rational::from(10).pow(place) / Rational::from(2))
}
