//! Answers as they were understood.

use momentous_expr::Expr;
use momentous_quantity::Printed;
use momentous_quantity::Unit;

use super::super::number::Number;

/// The figures with which a computed value is echoed.
const ECHO_FIGURES: usize = 6;

/// An answer that was read.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// A number with its unit and direction.
    Number(NumberAnswer),
    /// A vector.
    Vector(VectorAnswer),
    /// A formula.
    Formula(FormulaAnswer),
    /// An interval or a condition.
    Interval(IntervalAnswer),
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
    /// A direction that was written in words, without doubt: `36° from +x towards +y`.
    pub heading: Option<String>,
    /// A direction beside a value of which the size alone is asked, and judged.
    pub unjudged: Option<String>,
}

/// A vector, by its components along the axes of the question.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VectorAnswer {
    /// The components as they were written, or as they follow from magnitude and direction.
    pub components: Vec<Number>,
    /// How they, or the magnitude, were written.
    pub written: Vec<Written>,
    /// The unit of all, where there is one.
    pub unit: Option<Unit>,
    /// The magnitude and the direction in words, where the vector was written by them.
    pub heading: Option<(Number, String)>,
}

/// A formula in the symbols of the sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct FormulaAnswer {
    /// The formula.
    pub formula: Expr,
    /// The formula in the names of the problem, with every sign of multiplication: `m_A*v_A1/(m_A + m_B)`.
    pub text: String,
    /// For each decimal in it of three figures or more, which may be a rounded number, the formula with half a unit of its last
    /// place more.
    pub shifted: Vec<Expr>,
}

/// An interval or a condition.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct IntervalAnswer {
    /// The name of the quantity.
    pub name: String,
    /// The lower end, where there is one.
    pub low: Option<EndAnswer>,
    /// The upper end, where there is one.
    pub high: Option<EndAnswer>,
    /// The unit of both, where there is one.
    pub unit: Option<Unit>,
}

/// An end of an interval.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EndAnswer {
    /// Its value.
    pub number: Number,
    /// How it was written.
    pub written: Written,
    /// Whether it belongs to the interval; it does where words such as `between` do not say it.
    pub closed: bool,
}

/// How a number was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Written {
    /// Written as a decimal, with this many significant figures. In an integer such as `1200` trailing zeros may or may not
    /// count.
    Figures {
        /// The fewest that the writing can mean.
        least: usize,
        /// The most that the writing can mean.
        most: usize,
    },
    /// Written as a calculation or a fraction, which has no figures.
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
    /// The reading in words: `3.1 metres per second to the left`.
    #[must_use]
    pub fn echo(&self) -> String {
        match self {
            Self::Number(answer) => answer.echo(),
            Self::Vector(answer) => answer.echo(),
            Self::Formula(answer) => answer.text.clone(),
            Self::Interval(answer) => answer.echo(),
            Self::Choice(answer) => answer.text.clone(),
        }
    }
}

impl VectorAnswer {
    fn echo(&self) -> String {
        let number = |(number, written): (&Number, &Written)| echo_number(number, *written);
        let value = match &self.heading {
            Some((size, _)) => number((size, self.written.first().unwrap_or(&Written::Computed))),
            None => {
                let components: Vec<String> = self.components.iter().zip(&self.written).map(number).collect();
                format!("({})", components.join(", "))
            }
        };
        let words = [Some(value), self.unit.as_ref().map(|unit| unit.spoken(true))];
        let heading = self.heading.as_ref().map(|(_, words)| words.clone());
        join(words.into_iter().chain([heading]).flatten())
    }
}

impl IntervalAnswer {
    /// Whether it is a boundary without a side: both ends are the same value.
    #[must_use]
    pub fn is_one_value(&self) -> bool {
        self.low.as_ref().zip(self.high.as_ref()).is_some_and(|(low, high)| low.number == high.number)
    }

    fn echo(&self) -> String {
        let sign = |end: &EndAnswer| if end.closed { "<=" } else { "<" };
        let low = self.low.as_ref().map(|end| format!("{} {}", echo_number(&end.number, end.written), sign(end)));
        let high = self.high.as_ref().map(|end| format!("{} {}", sign(end), echo_number(&end.number, end.written)));
        let unit = self.unit.as_ref().map(|unit| unit.spoken(true));
        if let (Some(only), Some(_)) = (self.low.as_ref().filter(|_| self.is_one_value()), &self.high) {
            return join(
                [self.name.clone(), "=".into(), echo_number(&only.number, only.written)].into_iter().chain(unit),
            );
        }
        join([low, Some(self.name.clone()), high, unit].into_iter().flatten())
    }
}

pub(super) fn join(words: impl Iterator<Item = String>) -> String {
    words.filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ")
}

/// A number with the figures with which it was written.
pub(super) fn echo_number(number: &Number, written: Written) -> String {
    match written {
        Written::Figures { most, .. } => Printed::exact(&number.value(), most).plain(),
        Written::Computed => {
            let printed = Printed::exact(&number.value(), ECHO_FIGURES).plain();
            let (mantissa, power) = printed.split_at(printed.find(' ').unwrap_or(printed.len()));
            let short = if mantissa.contains('.') { mantissa.trim_end_matches('0') } else { mantissa };
            format!("{}{power}", short.trim_end_matches('.'))
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
        if let Some(heading) = &self.heading {
            return heading.clone();
        }
        let number = echo_number(&self.number, self.written);
        let unit = self.unit.as_ref().map(|unit| unit.spoken(number.trim_start_matches('-') != "1"));
        let sense = self.sense.as_ref().map(|sense| sense.word.clone());
        let unjudged = self.unjudged.as_ref().map(|words| format!("(the size alone is judged, not \"{words}\")"));
        join([Some(number), unit, sense, unjudged].into_iter().flatten())
    }
}
