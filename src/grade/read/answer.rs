//! What was understood of an answer.

use crate::quantity::Printed;
use crate::quantity::Unit;

use super::super::number::Number;

/// The figures with which a computed value is echoed.
const ECHO_FIGURES: usize = 6;

/// An answer that was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    /// A number with its unit and direction.
    Number(NumberAnswer),
    /// One of the options.
    Choice(ChoiceAnswer),
}

/// A number with its unit and direction.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NumberAnswer {
    /// The number as it was written, without what a direction word adds.
    pub number: Number,
    /// How it was written.
    pub written: Written,
    /// Whether a sign was written before it.
    pub signed: bool,
    /// The unit behind it, where there is one.
    pub unit: Option<Unit>,
    /// Whether a pound or ounce, elsewhere a force, was read as a mass.
    pub pounds_as_mass: bool,
    /// The direction word beside it, where there is one.
    pub sense: Option<Sense>,
}

/// How a number was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Written {
    /// As a decimal, with this many significant figures. In an integer such as `1200` trailing zeros may or may not count.
    Figures {
        /// The fewest that the writing can mean.
        least: usize,
        /// The most that the writing can mean.
        most: usize,
    },
    /// As a calculation or a fraction, which has no figures.
    Computed,
}

/// A direction in the words of the question.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sense {
    /// Whether it is the sense in which the quantity is counted positive.
    pub positive: bool,
    /// The word of the question: `to the left`.
    pub word: String,
}

/// One of the options.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ChoiceAnswer {
    /// Its position.
    pub option: usize,
    /// Its text.
    pub text: String,
}

impl Answer {
    /// What was understood, in words: `3.1 metres per second to the left`.
    #[must_use]
    pub fn echo(&self) -> String {
        match self {
            Self::Number(answer) => answer.echo(),
            Self::Choice(answer) => answer.text.clone(),
        }
    }
}

impl NumberAnswer {
    /// The number with the sign that its direction word gives it.
    #[must_use]
    pub fn directed(&self) -> Number {
        match &self.sense {
            Some(Sense { positive: false, .. }) => self.number.clone().negated(),
            _ => self.number.clone(),
        }
    }

    fn echo(&self) -> String {
        let number = self.echo_number();
        let mut words = vec![number];
        if let Some(unit) = &self.unit {
            words.push(unit.spoken(words.iter().all(|number| number.trim_start_matches('-') != "1")));
        }
        words.extend(self.sense.as_ref().map(|sense| sense.word.clone()));
        words.retain(|word| !word.is_empty());
        words.join(" ")
    }

    fn echo_number(&self) -> String {
        let value = self.number.value();
        match self.written {
            Written::Figures { most, .. } => Printed::exact(value, most).plain(),
            Written::Computed => {
                let printed = Printed::exact(value, ECHO_FIGURES).plain();
                let (mantissa, power) = printed.split_at(printed.find(' ').unwrap_or(printed.len()));
                let short = if mantissa.contains('.') { mantissa.trim_end_matches('0') } else { mantissa };
                format!("{}{power}", short.trim_end_matches('.'))
            }
        }
    }
}
