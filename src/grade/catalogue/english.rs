//! The words of marking in English.

use std::borrow::Cow;
use std::fmt;

use super::super::messages::Message;
use super::super::read::Unreadable;
use super::super::verdict::Verdict;
use super::Catalogue;
use super::english_input;

/// English.
#[derive(Clone, Copy, Debug, Default)]
pub struct English;

impl Catalogue for English {
    fn message(&self, message: &Message) -> Cow<'static, str> {
        let plain = match message {
            Message::Right => "Right.",
            Message::RightRounded => "Right within the rounding of intermediate values.",
            Message::Agrees => "Right: it agrees numerically with the expected formula (not proven).",
            Message::ValueForFormula => "The value is right, but the question asks for a formula.",
            Message::RoundedNumber => "A number in it is rounded.",
            Message::NoValue => "This formula has no value: check its roots, divisions and functions.",
            Message::CannotBeJudged => {
                "This formula cannot be judged: it is defined at too few points of the problem's range. Write it in another form."
            }
            Message::NegativeMagnitude => "This quantity is a magnitude: write it without a minus sign.",
            Message::PoundsAsMass => "Pounds and ounces are read as masses here (`lbm`); elsewhere they are forces.",
            Message::LastFigure => "The last figure is off: keep one more significant figure in intermediate steps.",
            Message::RoundingSlip => {
                "Nearly right: where did you round? Keep one more significant figure until the end."
            }
            Message::SomeValues => "Some of these values are right. Are any missing, and is each of them a solution?",
            Message::Sense(None) => "The magnitude is right. What is its sign?",
            Message::SenseReversed => "The magnitude is right. Check the direction.",
            Message::SignReversed => "The magnitude is right. Check the sign.",
            Message::NumberRight => "The number is right.",
            Message::UnitMissing => "The unit is missing.",
            Message::UnitPrefix => {
                "This is off by the factor of a prefix. Check the units: grams or kilograms, metres or kilometres?"
            }
            Message::OrderOfMagnitude => "The digits are right. Check the decimal point.",
            Message::NotWhole => "The answer is a whole number.",
            Message::Wrong => "Not right.",
            Message::ChoiceWrong => "Not this one.",
            Message::Unanswered => "No answer.",
            Message::NotIssued => "This is not the sheet that you were given: check the seed at its foot.",
            Message::NoAttemptLeft => "No attempts were left: this one does not count.",
            Message::EarlierStands => "Your earlier answer stands.",
            Message::RightBefore => "This part was right before: the new answer is not marked.",
            Message::OtherSide => {
                "The boundary is right. On which side of it does the condition hold? Try a value on each side."
            }
            Message::BodiesSwapped => "Which body does this belong to?",
            Message::ComponentsExchanged { of_contact: false } => "Which component belongs to which axis?",
            Message::ComponentsExchanged { of_contact: true } => {
                "Which component is along the line of impact, and which is across it?"
            }
            Message::Slip(verdict) => slip(*verdict),
            other => return self.filled(other).into(),
        };
        plain.into()
    }

    fn unreadable(&self, fault: &Unreadable) -> String {
        format!("Character {}: {}", fault.at + 1, english_input::sentence(&fault.kind))
    }
}

/// In English.
impl fmt::Display for Message {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&English.message(self))
    }
}

/// The message that the student sees, with the place.
impl fmt::Display for Unreadable {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&English.unreadable(self))
    }
}

/// Slips that have nothing to fill in: each a question.
fn slip(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::AngleReversed => "This points the opposite way. Which way does the arrow point?",
        Verdict::AngleOtherSense => "The size of the angle is right. In which sense is it measured?",
        Verdict::AngleSupplement => "From which end of the axis is the angle measured?",
        Verdict::AngleComplement | Verdict::AngleOtherAxis => "From which axis is the angle measured?",
        Verdict::ComponentSign => "The sizes of the components are right. Which of them points the other way?",
        Verdict::DirectionWrong => "The magnitude is right. Check the direction.",
        Verdict::IntervalEnds => "The end points are right. Are they themselves part of the interval?",
        Verdict::IntervalHalf => "One end point is right. What limits the other?",
        Verdict::FormulaFactor => "The formula is right except for a constant factor. Where does it come from?",
        _ => "Not right.",
    }
}

impl English {
    /// Messages with something to fill in.
    fn filled(self, message: &Message) -> String {
        match message {
            Message::RightBecause(because) => format!("Right: {because}."),
            Message::TooFewFigures(asked) => format!("Write {asked} significant figures."),
            Message::FiguresWanted(asked) => {
                format!("Not marked yet: write {asked} significant figures, also where the last ones are zeros.")
            }
            Message::TooManyFigures(asked) => format!("The data support no more than {asked} significant figures."),
            Message::Sense(Some([plus, minus])) => {
                format!("The magnitude is right. State its direction, too: by a sign, or \"{plus}\" or \"{minus}\".")
            }
            Message::UnitNotAsked(unit) => format!("Right, but the question asks for the answer in {unit}."),
            Message::UnitWrong(unit) => format!("The unit is not {unit}."),
            Message::UnitWrongDimension { given, asked } => {
                format!("Check the unit: this is {given}, but the question asks for {asked}.")
            }
            Message::NoMultiple { of, unit } => {
                let unit = unit.as_ref().map_or_else(String::new, |unit| format!(" or with {unit} behind it"));
                format!("The question asks for a multiple of `{of}`: write a number and `{of}`, without a unit{unit}.")
            }
            Message::BareMultiple(of) => format!("It stands for this times `{of}`: write `{of}` as well."),
            Message::FormulaDimension { given, asked } => {
                format!("Check the dimensions: this formula is {given}, but the question asks for {asked}.")
            }
            Message::FormulaClash(sentence) => format!("Check the dimensions: {sentence}."),
            Message::Reduced(percent) => format!("Earlier attempts and hints cost {percent} % of the points."),
            Message::Late(percent) => format!("It was handed in late, which costs {percent} % of the points."),
            Message::Unreadable(fault) => self.unreadable(fault),
            // Every message without anything to fill in has its words above.
            _ => String::new(),
        }
    }
}
