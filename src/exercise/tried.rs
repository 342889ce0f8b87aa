//! Typical answers to a part, right and wrong, by which can be seen what marks are given.

use momentous_problem::NumberPart;
use momentous_problem::Part;
use momentous_problem::PartKind;
use momentous_quantity::Printed;

use super::Exercise;

/// By how many per cent wrong answers are off.
const OFF: [u32; 5] = [1, 2, 5, 10, 20];

/// The figures with which these are typed.
const FIGURES: usize = 6;

impl Exercise {
    /// Answers to a part as students type them, each with what it is: the right one, those off by some per cent, without the unit,
    /// with the other sign, every option, and what comes of the usual mistakes.
    #[must_use]
    pub fn tried_answers(&self, part: &Part) -> Vec<(String, String)> {
        let right = self.printed(part);
        let expected = part.expected.iter().map(|(typed, code)| (format!("expected: {code}"), typed.to_owned()));
        let mut tried: Vec<(String, String)> = expected.collect();
        tried.push(("the answer of the key".to_owned(), right));
        match &part.kind {
            PartKind::Number(number) if !number.whole && self.worked().answers(number).len() == 1 => {
                tried.extend(self.numbers_off(number));
            }
            PartKind::Choice(choice) => {
                let options = choice.decided(&self.worked()).options;
                tried.extend(options.into_iter().map(|option| ("an option".to_owned(), option)));
            }
            PartKind::Number(_) | PartKind::Vector(_) | PartKind::Formula(_) | PartKind::Range(_) => {}
        }
        tried.extend(self.mistaken_answers(part).into_iter().map(|(code, text)| (code.to_owned(), text)));
        let is_new = |place: usize| !tried[..place].iter().any(|(_, text)| *text == tried[place].1);
        (0..tried.len()).filter(|place| is_new(*place)).map(|place| tried[place].clone()).collect()
    }

    fn numbers_off(&self, number: &NumberPart) -> Vec<(String, String)> {
        let value = self.worked().answer(number).for_print();
        if value == 0.0 || !value.is_finite() {
            return Vec::new();
        }
        let unit = self.problem.unit_name(number);
        let typed = |value: f64, unit: &str| {
            let number = Printed::new(value, FIGURES).map_or_else(|| value.to_string(), |printed| printed.plain());
            format!("{number} {unit}").trim_end().to_owned()
        };
        let off = OFF
            .map(|percent| (format!("off by {percent} %"), typed(value * (1.0 + f64::from(percent) / 100.0), &unit)));
        let others = [("with the other sign", typed(-value, &unit)), ("without the unit", typed(value, ""))];
        off.into_iter().chain(others.map(|(what, text)| (what.to_owned(), text))).collect()
    }
}
