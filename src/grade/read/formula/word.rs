//! A run of letters with their indices: `m_A`, `v_{A1}`, `mA`, `\theta`, `μₖ`, `v0exp`.

use super::super::unreadable::{At, UnreadableKind};
use super::latex::{Command, command};
use super::lexer::Lexer;
use super::signs::{self, NOTHING};
use super::token::{Letter, Place, Token};

/// The longest index in round brackets.
const LONGEST_INDEX: usize = 4;

impl Lexer<'_> {
    /// Reads the letters that stand side by side.
    pub(super) fn word(&mut self) -> At<Vec<Letter>> {
        let mut letters: Vec<Letter> = Vec::new();
        loop {
            let at = self.at;
            let Some(sign) = self.peek(0) else { return Ok(letters) };
            if sign == '\\' {
                if !self.letter_or_wrapper(&mut letters, Place::Beside) {
                    return Ok(letters);
                }
                continue;
            }
            self.at += 1;
            let place = Place::Beside;
            match sign {
                NOTHING => {}
                '_' => self.below(&mut letters)?,
                '\'' => letters.push(Letter { sign, place: Place::Below, at }),
                '}' if self.braces.last() == Some(&true) => {
                    self.braces.pop();
                }
                // A component, `v_A1.x`, or a product.
                '.' if self.peek(0).is_some_and(char::is_alphabetic) => {
                    letters.push(Letter { sign: self.signs[self.at], place: Place::Point, at: self.at });
                    self.at += 1;
                }
                ' ' if letters.last().is_some_and(|last| last.sign == 'Δ') && self.letter_behind_spaces() => {}
                _ => {
                    if let Some(lower) = signs::unlowered(sign) {
                        letters.push(Letter { sign: lower, place: Place::Below, at });
                    } else if (sign.is_alphabetic() || sign.is_ascii_digit()) && signs::unraised(sign).is_none() {
                        letters.push(Letter { sign, place, at });
                    } else {
                        self.at = at;
                        return Ok(letters);
                    }
                }
            }
        }
    }

    /// Takes the letter behind the space of a difference `Δ t`.
    fn letter_behind_spaces(&mut self) -> bool {
        let rest = self.signs[self.at..].iter();
        let spaces = rest.take_while(|sign| **sign == ' ').count();
        let letter = self.peek(spaces).is_some_and(char::is_alphabetic);
        self.at += if letter { spaces } else { 0 };
        letter
    }

    /// A letter that is a command, or a command that says how letters look; whether one of them stood here.
    fn letter_or_wrapper(&mut self, letters: &mut Vec<Letter>, place: Place) -> bool {
        let at = self.at;
        if let Some((sign, length)) = self.letter_command(1) {
            self.at += 1 + length;
            letters.push(Letter { sign, place, at });
            // The space only ends the command.
            let spaces = self.signs[self.at..].iter().take_while(|next| **next == ' ').count();
            if self.peek(spaces).is_some_and(char::is_alphabetic) || self.peek(spaces) == Some('\\') {
                self.at += spaces;
            }
            return true;
        }
        self.at += 1;
        if command(&self.command_name()) == Some(Command::Wrapper) {
            self.wrapper();
            return true;
        }
        self.at = at;
        false
    }

    /// The index behind an underscore: one letter, or what stands in braces.
    fn below(&mut self, letters: &mut Vec<Letter>) -> At<()> {
        let start = self.at;
        if self.peek(0) == Some('\\') && self.letter_command(1).is_none() {
            self.at += 1;
            if command(&self.command_name()) != Some(Command::Wrapper) {
                return Err((start, UnreadableKind::NotAFormula));
            }
        }
        if let Some(length) = self.index_in_brackets() {
            self.at += 1;
            for _ in 0..length {
                self.index(letters)?;
            }
            self.at += 1;
            return Ok(());
        }
        let grouped = self.peek(0) == Some('{');
        if !grouped {
            return self.index(letters);
        }
        self.at += 1;
        let mut open = 1;
        while open > 0 {
            match self.peek(0) {
                None => return Err((start, UnreadableKind::OpenBracket)),
                Some('{') => {
                    open += 1;
                    self.at += 1;
                }
                Some('}') => {
                    open -= 1;
                    self.at += 1;
                }
                Some(' ' | ',' | '.' | '_' | ';' | NOTHING) => self.at += 1,
                Some('\\') if self.letter_command(1).is_none() => {
                    self.at += 1;
                    let meant = command(&self.command_name());
                    if !matches!(meant, Some(Command::Wrapper | Command::Space | Command::Nothing)) {
                        return Err((start, UnreadableKind::NotAFormula));
                    }
                }
                Some(_) => self.index(letters)?,
            }
        }
        Ok(())
    }

    /// `v_(A1)`: how long the index in round brackets is.
    fn index_in_brackets(&self) -> Option<usize> {
        let inside = self.signs.get(self.at..)?.strip_prefix(&['('])?;
        let length = inside.iter().take_while(|sign| sign.is_alphanumeric()).count();
        (length > 0 && length <= LONGEST_INDEX && inside.get(length) == Some(&')')).then_some(length)
    }

    /// `v^2_A`: the index behind the power belongs to the name before it; whether one stands there.
    pub(super) fn index_behind_power(&mut self, at: usize) -> At<bool> {
        let start = self.at;
        let group = self.signs[start..].iter().position(|sign| *sign == '}').filter(|_| self.peek(0) == Some('{'));
        let digit = self.peek(0).is_some_and(|sign| sign.is_ascii_digit());
        let end = start + group.map_or(1, |close| close + 1);
        if self.signs.get(end) != Some(&'_') || !digit && group.is_none() {
            return Ok(false);
        }
        let Some(Token::Word(letters)) = self.found.last().map(|lexeme| lexeme.token.clone()) else { return Ok(false) };
        let mut letters = letters;
        self.at = end + 1;
        self.below(&mut letters)?;
        let behind = self.at;
        if let Some(last) = self.found.last_mut() {
            last.token = Token::Word(letters);
        }
        self.push(Token::Power, at);
        self.within(start, end)?;
        self.at = behind;
        Ok(true)
    }

    fn index(&mut self, letters: &mut Vec<Letter>) -> At<()> {
        let at = self.at;
        if let Some((sign, length)) = self.letter_command(1).filter(|_| self.peek(0) == Some('\\')) {
            self.at += 1 + length;
            letters.push(Letter { sign, place: Place::Below, at });
            return Ok(());
        }
        match self.peek(0) {
            Some(sign) if sign.is_alphanumeric() => {
                self.at += 1;
                letters.push(Letter { sign, place: Place::Below, at });
                Ok(())
            }
            _ => Err((at, UnreadableKind::NotAFormula)),
        }
    }
}
