//! The numbers that stand on a sheet, as tables and records keep them.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use momentous_problem::Literal;
use momentous_problem::NoVariant;
use momentous_problem::PrintedNumber;
use momentous_problem::Problem;

use super::Exercise;

/// The name of each quantity that a sheet tells, with its value as it is printed: `m_A = 2.0 kg; v_A1 = 3 m/s`.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct SheetNumbers(Vec<(String, String)>);

impl fmt::Display for SheetNumbers {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, (name, value)) in self.0.iter().enumerate() {
            let separator = if place == 0 { "" } else { "; " };
            write!(out, "{separator}{name} = {value}")?;
        }
        Ok(())
    }
}

impl FromStr for SheetNumbers {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |text: &str| {
            let split = text.split_once('=').map(|(name, value)| (name.trim().to_owned(), value.trim().to_owned()));
            split.ok_or_else(|| format!("`{}` is not of the form `m_A = 2 kg`", super::excerpt(text)))
        };
        text.split(';').filter(|text| !text.trim().is_empty()).map(number).collect::<Result<_, _>>().map(Self)
    }
}

impl SheetNumbers {
    /// The same by the symbols of a problem.
    pub(super) fn printed(&self, problem: &Problem) -> Result<Vec<PrintedNumber>, NoVariant> {
        let printed = |(name, value): &(String, String)| {
            let symbol = problem.model().symbols.find(name)?;
            // Courses kept the typographic minus of the sheet.
            let Literal { components, unit } = Literal::read(&value.replace('−', "-")).ok()??;
            let [number] = <[_; 1]>::try_from(components).ok()?;
            Some((symbol, number, unit))
        };
        let read = |pair: &(String, String)| printed(pair).ok_or_else(|| NoVariant::OtherSheet(pair.0.clone()));
        self.0.iter().map(read).collect()
    }
}

impl Exercise {
    /// The numbers that stand on its sheet.
    #[must_use]
    pub fn sheet_numbers(&self) -> SheetNumbers {
        let symbols = &self.problem.model().symbols;
        let given = self.variant.all_given().iter();
        let number = |(symbol, value, unit): &PrintedNumber| {
            (symbols.entry(*symbol).name.clone(), format!("{value} {unit}").trim_end().to_owned())
        };
        SheetNumbers(given.map(number).collect())
    }
}
