//! The names that the sheet gives, in whatever spelling: `m_A`, `mA`, `m_{A}`, `μ_k`, `mu_k`.

use momentous_expr::Symbol;
use momentous_expr::name_math;
use momentous_fault::did_you_mean;

use super::super::unreadable::UnreadableKind;
use super::named::Named;
use super::signs;
use super::token::{Letter, Place, Token};
use super::vocabulary::Vocabulary;

/// Names side by side in one word have together no more letters.
const LONGEST_PRODUCT: usize = 4;

/// The names that a formula may contain, and that of what is asked.
pub(super) struct Names<'a> {
    known: Vec<Known>,
    vocabulary: &'a Vocabulary<'a>,
}

/// A name, by its letters alone: Greek ones as such, without what joins them.
struct Known {
    letters: Vec<char>,
    meant: Meant,
}

/// The meaning of a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Meant {
    /// A quantity of the sheet.
    Given(Symbol),
    /// The quantity that is asked.
    Asked,
    /// The ratio of a circle's circumference to its diameter.
    Pi,
}

impl<'a> Names<'a> {
    pub(super) fn new(vocabulary: &'a Vocabulary<'a>) -> Self {
        let spelt = |symbol: Symbol, meant: Meant| {
            let name = vocabulary.symbols.entry(symbol).name.as_str();
            letters(name).into_iter().map(move |letters| Known { letters, meant })
        };
        let mut known: Vec<Known> =
            vocabulary.names.iter().flat_map(|symbol| spelt(*symbol, Meant::Given(*symbol))).collect();
        known.extend(vocabulary.asked.into_iter().flat_map(|asked| spelt(asked, Meant::Asked)));
        known.extend(turned(&known));
        known.extend(without_instants(&known, vocabulary));
        known.push(Known { letters: vec!['π'], meant: Meant::Pi });
        Self { known, vocabulary }
    }

    /// The name of a quantity, as the problem has it.
    pub(super) fn printed(&self, meant: Meant) -> &'a str {
        let symbol = match meant {
            Meant::Given(symbol) => Some(symbol),
            Meant::Asked => self.vocabulary.asked,
            Meant::Pi => None,
        };
        symbol.map_or("pi", |symbol| &self.vocabulary.symbols.entry(symbol).name)
    }

    /// Whether `e` alone cannot be Euler's number: some quantity of the problem is called so.
    pub(super) fn has_own_e(&self) -> bool {
        self.vocabulary.symbols.iter().any(|(_, entry)| {
            let mut rest = entry.name.chars();
            matches!(rest.next(), Some('e' | 'ε')) && !rest.next().is_some_and(char::is_alphabetic)
                || entry.name.starts_with("epsilon")
        })
    }

    /// The names that stand at a place of a word, with the number of letters that each takes.
    pub(super) fn at<'s>(&'s self, word: &'s [Letter], at: usize) -> impl Iterator<Item = (Meant, usize)> + 's {
        let rest = word.get(at..).unwrap_or_default();
        self.known.iter().filter_map(move |known| matched(&known.letters, rest).map(|length| (known.meant, length)))
    }

    /// The meaning of a whole word, where it is one name.
    pub(super) fn whole(&self, word: &[Letter]) -> Option<Meant> {
        self.at(word, 0).find(|(_, length)| *length == word.len()).map(|(meant, _)| meant)
    }

    /// Whether a short word is several names side by side: `gL`.
    pub(super) fn is_several(&self, word: &[Letter]) -> bool {
        word.len() <= LONGEST_PRODUCT && self.whole(word).is_none() && self.is_names(word)
    }

    fn is_names(&self, word: &[Letter]) -> bool {
        word.is_empty() || self.at(word, 0).any(|(_, length)| length > 0 && self.is_names(&word[length..]))
    }

    /// A word that is one name, in a line of work: there it is no product of others.
    pub(super) fn alone(&self, word: &[Letter]) -> Option<Token> {
        match self.whole(word).filter(|_| self.vocabulary.asked.is_none())? {
            Meant::Given(symbol) => Some(Token::Name(symbol)),
            Meant::Pi => Some(Token::Pi),
            Meant::Asked => None,
        }
    }

    /// Whether a word is the letter of what is asked without its index, and names nothing else.
    pub(super) fn is_letter_of_asked(&self, word: &[Letter]) -> bool {
        let first = |known: &&Known| {
            known.meant == Meant::Asked && known.letters.first() == word.first().map(|letter| &letter.sign)
        };
        word.len() == 1 && self.whole(word).is_none() && self.known.iter().any(|known| first(&known))
    }

    /// The fault of a word in which no names are found.
    pub(super) fn unknown(&self, text: &str) -> UnreadableKind {
        if text == "e" {
            return UnreadableKind::NotEuler;
        }
        if Named::find(text).is_some() {
            return UnreadableKind::NoArgument;
        }
        let printed = self.vocabulary.names.iter().map(|symbol| self.printed(Meant::Given(*symbol)));
        let near = did_you_mean(text, printed).map(str::to_owned);
        // A Greek letter without its index.
        let begins =
            |known: &&Known| known.letters.first() == text.chars().next().as_ref() && !known.letters[0].is_ascii();
        let longer = self.known.iter().filter(begins).find(|known| known.letters.len() > 1);
        let near = near.or_else(|| longer.map(|known| self.printed(known.meant).to_owned()));
        UnreadableKind::UnknownName { name: text.to_owned(), near }
    }
}

/// Names with the number of their instant before their body, `v_1A` for `v_A1`, where nothing else is called so.
fn turned(known: &[Known]) -> Vec<Known> {
    let turned = |name: &Known| {
        let [stem @ .., body, instant] = name.letters.as_slice() else { return None };
        let fits = body.is_uppercase() && instant.is_ascii_digit() && !stem.is_empty();
        let letters: Vec<char> = stem.iter().copied().chain([*instant, *body]).collect();
        (fits && known.iter().all(|other| other.letters != letters)).then_some(Known { letters, meant: name.meant })
    };
    known.iter().filter_map(turned).collect()
}

/// Names without the number of their instant, `vA` for `v_A1`, where one quantity alone can be meant and it is given.
fn without_instants(known: &[Known], vocabulary: &Vocabulary<'_>) -> Vec<Known> {
    let short = |known: &Known| {
        let (last, rest) = known.letters.split_last()?;
        let is_of_body = rest.len() > 1 && rest.last().is_some_and(|body| body.is_uppercase());
        (last.is_ascii_digit() && is_of_body).then(|| rest.to_vec())
    };
    let is_answer = vocabulary.asked.is_some();
    let given = known.iter().filter(|known| is_answer && matches!(known.meant, Meant::Given(_)));
    let alone = |name: &Known| {
        let letters = short(name)?;
        let is_other = |other: &Known| {
            other.meant != name.meant && (other.letters == letters || short(other).as_ref() == Some(&letters))
        };
        (!known.iter().any(is_other)).then_some(Known { letters, meant: name.meant })
    };
    given.filter_map(alone).collect()
}

/// The letters of a name, Greek ones as such: as the file spells it, and as it is printed where that differs.
pub(super) fn letters(name: &str) -> Vec<Vec<char>> {
    let alone = letters_alone(name);
    if name.contains('(') {
        return vec![alone];
    }
    let printed = letters_alone(&name_math(name).plain());
    if printed == alone { vec![alone] } else { vec![printed, alone] }
}

fn letters_alone(name: &str) -> Vec<char> {
    let parts = name.split(|sign: char| !sign.is_alphanumeric() && sign != '\'').filter(|part| !part.is_empty());
    parts.flat_map(letters_of_part).collect()
}

fn letters_of_part(part: &str) -> Vec<char> {
    let word = part.trim_end_matches(|sign: char| sign.is_ascii_digit());
    match signs::greek(word) {
        Some(letter) => std::iter::once(letter).chain(part.chars().skip(word.len())).collect(),
        None => part.chars().map(signs::plain).collect(),
    }
}

/// How many letters at the start of a word spell a name.
fn matched(name: &[char], word: &[Letter]) -> Option<usize> {
    let mut at = 0;
    for (position, letter) in name.iter().enumerate() {
        let first = word.get(at)?;
        if position == 0 && first.place == Place::Below {
            return None;
        }
        if first.sign == *letter {
            at += 1;
            continue;
        }
        let spelt = signs::spelt(*letter)?;
        let letters = word.get(at..at + spelt.len())?;
        let same = letters.iter().zip(spelt.chars()).all(|(letter, sign)| letter.sign == sign);
        let together =
            letters.iter().skip(1).all(|letter| letter.place == first.place || letter.place == Place::Beside);
        if !(same && together) {
            return None;
        }
        at += spelt.len();
    }
    // An index or a digit behind it would belong to the name.
    let ends = word
        .get(at)
        .is_none_or(|next| next.place == Place::Point || next.place == Place::Beside && !next.sign.is_ascii_digit());
    ends.then_some(at)
}

/// A word as it was typed, more or less.
pub(super) fn text(word: &[Letter]) -> String {
    let mut text = String::new();
    let mut before = Place::Beside;
    for letter in word {
        match letter.place {
            Place::Below if before != Place::Below && letter.sign != '\'' => text.push('_'),
            Place::Point => text.push('.'),
            _ => {}
        }
        text.push(letter.sign);
        before = letter.place;
    }
    text
}
