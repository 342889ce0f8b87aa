//! The names and functions in the words of a formula. Where a word can be read in two ways, both are shown, and none is taken.

use momentous_quantity::Rational;

use super::super::unreadable::{At, UnreadableKind};
use super::named::{self, Named};
use super::names::{self, Meant, Names};
use super::token::{Letter, Lexeme, Place, Token};

/// The most letters side by side: every way to part them is tried.
const MAX_LETTERS: usize = 64;
/// Readings beyond this are not told apart.
const MANY: u8 = 2;

/// The tokens without their words: names, functions and units of angles in their place.
pub(super) fn resolve(mut lexemes: Vec<Lexeme>, names: &Names) -> At<Vec<Lexeme>> {
    let start = behind_the_name(&lexemes, names)?;
    let mut resolved: Vec<Lexeme> = Vec::with_capacity(lexemes.len());
    lexemes.drain(..start);
    take_indices(&mut lexemes, names);
    let mut rest = lexemes.into_iter().peekable();
    while let Some(lexeme) = rest.next() {
        let Token::Word(word) = &lexeme.token else {
            resolved.push(lexeme);
            continue;
        };
        let next = rest.peek();
        let spelt = names::text(word);
        let measures = matches!(
            resolved.last().map(|lexeme| &lexeme.token),
            Some(Token::Number { .. } | Token::Written { .. } | Token::Close(_))
        );
        if let Some(unit) = angle_unit(&spelt).filter(|_| measures && names.whole(word).is_none()) {
            resolved.push(Lexeme { token: unit, ..lexeme });
            continue;
        }
        if matches!(spelt.as_str(), "frac" | "dfrac") && next.is_some_and(|next| next.token == Token::Open('}')) {
            resolved.push(Lexeme { token: Token::Fraction, ..lexeme });
            continue;
        }
        let apart = lexeme.gap && next.is_some_and(|next| next.gap);
        if apart && matches!(spelt.as_str(), "x" | "X") && names.whole(word).is_none() {
            resolved.push(Lexeme { token: Token::Times, ..lexeme });
            continue;
        }
        if let Some(token) = names.alone(word) {
            resolved.push(Lexeme { token, ..lexeme });
            continue;
        }
        let reader = Word { names, letters: word, next: next.map(|next| &next.token) };
        let mut gap = lexeme.gap;
        for (token, at) in reader.read()? {
            resolved.push(Lexeme { token, at, gap: std::mem::take(&mut gap) });
        }
    }
    Ok(resolved)
}

/// Gives words their indices in brackets: `m[1]` and `m(1)`, where these are names and `m` alone is none.
fn take_indices(lexemes: &mut Vec<Lexeme>, names: &Names) {
    let mut at = 0;
    while at < lexemes.len() {
        if let Some(word) = indexed(&lexemes[at..], names) {
            lexemes[at].token = Token::Word(word);
            // The bracket and what stands in it.
            lexemes.drain(at + 1..at + 4);
        }
        at += 1;
    }
}

/// The name that a word and the bracket behind it spell.
fn indexed(lexemes: &[Lexeme], names: &Names) -> Option<Vec<Letter>> {
    let [word, open, inside, close, ..] = lexemes else { return None };
    let (Token::Word(letters), Token::Open(end)) = (&word.token, &open.token) else { return None };
    let below = |(sign, at): (char, usize)| Letter { sign, place: Place::Below, at };
    let index: Vec<Letter> = match &inside.token {
        Token::Number { value, half: None } if value.is_int() => {
            value.numerator().to_string().chars().map(|sign| below((sign, inside.at))).collect()
        }
        Token::Word(word) => word.iter().map(|letter| below((letter.sign, letter.at))).collect(),
        _ => return None,
    };
    let whole = [letters.as_slice(), &index].concat();
    let is_name = names.whole(letters).is_none() && names.whole(&whole).is_some();
    (close.token == Token::Close(*end) && !open.gap && is_name).then_some(whole)
}

/// The beginning of the formula, behind `v_B2 =`.
fn behind_the_name(lexemes: &[Lexeme], names: &Names) -> At<usize> {
    let Some(equals) = lexemes.iter().position(|lexeme| lexeme.token == Token::Equals).filter(|at| *at <= 1) else {
        return Ok(0);
    };
    match lexemes.first().map(|lexeme| &lexeme.token) {
        Some(Token::Word(word)) if names.whole(word) == Some(Meant::Asked) || names.is_letter_of_asked(word) => {
            Ok(equals + 1)
        }
        Some(Token::Word(word)) if names.whole(word).is_none() => {
            Err((0, UnreadableKind::OtherName(names.printed(Meant::Asked).to_owned())))
        }
        Some(Token::Equals) => Ok(1),
        _ => Ok(0),
    }
}

fn angle_unit(word: &str) -> Option<Token> {
    match word {
        "deg" | "degs" | "degree" | "degrees" => Some(Token::Degree),
        "rad" | "rads" | "radian" | "radians" => Some(Token::Radian),
        _ => None,
    }
}

/// A part of a word.
#[derive(Clone, Debug)]
enum Piece {
    Name(Meant),
    Function(Named),
    Euler,
    Number(u64),
}

struct Word<'a> {
    names: &'a Names<'a>,
    letters: &'a [Letter],
    /// The token behind it.
    next: Option<&'a Token>,
}

impl Word<'_> {
    fn read(&self) -> At<Vec<(Token, usize)>> {
        let at = self.letters.first().map_or(0, |first| first.at);
        if self.letters.len() > MAX_LETTERS {
            return Err((at, UnreadableKind::TooManyParts));
        }
        let ways = self.ways();
        let text = || names::text(self.letters);
        match ways.first() {
            None | Some(0) => Err((at, self.names.unknown(&text()))),
            Some(1) => self.tokens(&self.readings(&ways, 1).into_iter().next().unwrap_or_default()),
            Some(_) => {
                let readings: Vec<_> = self.readings(&ways, 2).iter().map(|reading| self.shown(reading)).collect();
                Err((at, UnreadableKind::AmbiguousName { name: text(), readings }))
            }
        }
    }

    fn tokens(&self, reading: &[(Piece, usize)]) -> At<Vec<(Token, usize)>> {
        let token = |(piece, place): &(Piece, usize)| {
            let at = self.letters.get(*place).map_or(0, |letter| letter.at);
            let token = match piece {
                Piece::Name(Meant::Asked) => {
                    let name = self.names.printed(Meant::Asked).to_owned();
                    return Err((at, UnreadableKind::AskedName(name)));
                }
                Piece::Name(Meant::Given(symbol)) => Token::Name(*symbol),
                Piece::Name(Meant::Pi) => Token::Pi,
                Piece::Function(Named::Sqrt) => Token::Root(2),
                Piece::Function(Named::Cbrt) => Token::Root(3),
                Piece::Function(named) => Token::Function(*named),
                Piece::Euler => Token::Euler,
                Piece::Number(value) => Token::Number { value: Rational::from(*value), half: None },
            };
            Ok((token, at))
        };
        reading.iter().map(token).collect()
    }

    fn shown(&self, reading: &[(Piece, usize)]) -> String {
        let mut text = String::new();
        let mut before = false;
        for (position, (piece, place)) in reading.iter().enumerate() {
            text.push_str(if position == 0 {
                ""
            } else if before {
                " "
            } else {
                "*"
            });
            before = matches!(piece, Piece::Function(_));
            match piece {
                Piece::Name(meant) => text.push_str(self.names.printed(*meant)),
                Piece::Euler => text.push('e'),
                Piece::Number(value) => text.push_str(&value.to_string()),
                Piece::Function(_) => {
                    let end = reading.get(position + 1).map_or(self.letters.len(), |(_, next)| *next);
                    text.push_str(&names::text(self.letters.get(*place..end).unwrap_or_default()));
                }
            }
        }
        text
    }

    /// In how many ways the word can be read from each letter to its end, up to a bound.
    fn ways(&self) -> Vec<u8> {
        let mut ways = vec![0_u8; self.letters.len() + 1];
        ways[self.letters.len()] = 1;
        for at in (0..self.letters.len()).rev() {
            let counts = self.pieces(at).into_iter().map(|(_, end)| ways.get(end).copied().unwrap_or(0));
            ways[at] = counts.fold(0, u8::saturating_add).min(MANY);
        }
        ways
    }

    /// The first readings of the word.
    fn readings(&self, ways: &[u8], most: usize) -> Vec<Vec<(Piece, usize)>> {
        let mut readings: Vec<Vec<(Piece, usize)>> = Vec::new();
        let mut open: Vec<(usize, Vec<(Piece, usize)>)> = vec![(0, Vec::new())];
        while let Some((at, reading)) = open.pop()
            && readings.len() < most
        {
            if at == self.letters.len() {
                readings.push(reading);
                continue;
            }
            for (pieces, end) in self.pieces(at) {
                if ways.get(end).is_some_and(|ways| *ways > 0) {
                    open.push((end, [reading.as_slice(), pieces.as_slice()].concat()));
                }
            }
        }
        readings
    }

    /// The pieces that may stand at a letter, with their ends. A number stands behind a function only: `sin2θ`.
    fn pieces(&self, at: usize) -> Vec<(Vec<(Piece, usize)>, usize)> {
        let mut firm = 0;
        let mut ways_on = Vec::new();
        for (spelt, named, own_firm) in named::spellings() {
            let end = at + spelt.len();
            let stands = self.letters.get(at..end).is_some_and(|word| {
                word.iter().zip(spelt.chars()).all(|(letter, sign)| letter.sign == sign)
                    && word.iter().skip(1).all(|letter| letter.place == Place::Beside || letter.sign.is_ascii_digit())
                    && word[0].place != Place::Below
            });
            if !stands {
                continue;
            }
            let digits = self.letters[end..].iter().take_while(|letter| letter.sign.is_ascii_digit()).count();
            let value = names::text(&self.letters[end..end + digits]).parse::<u64>();
            if let (true, Ok(value)) = (named != Named::Log && digits > 0, value) {
                ways_on.push((vec![(Piece::Function(named), at), (Piece::Number(value), end)], end + digits));
            } else if digits == 0 && self.argument_follows(end) {
                ways_on.push((vec![(Piece::Function(named), at)], end));
            } else {
                continue;
            }
            if own_firm {
                firm = firm.max(spelt.len());
            }
        }
        // `atan2(y, x)` is no arctangent of 2, and `log10(x)` none of 10.
        if let Some(longest) = ways_on.iter().filter(|(pieces, _)| pieces.len() == 1).map(|(_, end)| *end).max() {
            ways_on.retain(|(pieces, end)| pieces.len() == 1 || *end > longest);
        }
        let names = self.names.at(self.letters, at).filter(|(_, length)| *length >= firm);
        ways_on.extend(names.map(|(meant, length)| (vec![(Piece::Name(meant), at)], at + length)));
        let is_euler = |letter: &Letter| matches!(letter.sign, 'e' | 'E') && letter.place != Place::Below;
        let last = at + 1 == self.letters.len() && is_euler(&self.letters[at]);
        if last && self.next == Some(&Token::Power) && !self.names.has_own_e() {
            ways_on.push((vec![(Piece::Euler, at)], at + 1));
        }
        ways_on
    }

    fn argument_follows(&self, end: usize) -> bool {
        match self.letters.get(end) {
            Some(next) => next.place != Place::Below,
            None => self.next.is_some_and(|next| next.begins_argument() || *next == Token::Power),
        }
    }
}
