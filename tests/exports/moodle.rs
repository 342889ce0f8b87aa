//! A reader of Moodle XML that marks as Moodle does: tolerance, fraction, units, the notation of gaps.

use super::xml::{Node, decoded};

/// One answer that earns something or has something said of it.
#[derive(Clone, Debug)]
pub struct Answer {
    pub text: String,
    pub tolerance: f64,
    pub fraction: f64,
    pub feedback: String,
}

impl Answer {
    /// Moodle keeps fourteen digits of the value and of the tolerance, and adds a unit of the last one.
    fn takes(&self, number: f64) -> bool {
        let kept = |number: f64| format!("{number:.13e}").parse::<f64>().unwrap();
        let (value, tolerance) = (kept(self.text.parse().unwrap()), kept(self.tolerance));
        let tolerance = tolerance + 1e-14 * tolerance.max(value.abs());
        (value - tolerance..=value + tolerance).contains(&number)
    }
}

/// One field.
#[derive(Clone, Debug, Default)]
pub struct Field {
    pub is_choice: bool,
    pub weight: u32,
    pub answers: Vec<Answer>,
    pub units: Vec<(String, f64)>,
    pub penalty: f64,
}

/// The fields of a question.
pub fn fields(question: &Node) -> Vec<Field> {
    if question.attribute("type") == "cloze" {
        return gaps(question.text_at(&["questiontext", "text"]));
    }
    let answer = |node: &Node| Answer {
        text: match question.attribute("type") {
            "numerical" => node.text_at(&["text"]).to_owned(),
            _ => decoded(node.text_at(&["text"])),
        },
        tolerance: node.text_at(&["tolerance"]).parse().unwrap_or(0.0),
        fraction: node.attribute("fraction").parse().unwrap(),
        feedback: decoded(node.text_at(&["feedback", "text"])),
    };
    let unit = |unit: &Node| (unit.text_at(&["unit_name"]).to_owned(), unit.text_at(&["multiplier"]).parse().unwrap());
    vec![Field {
        is_choice: question.attribute("type") == "multichoice",
        weight: question.text_at(&["defaultgrade"]).parse().unwrap(),
        answers: question.all("answer").map(answer).collect(),
        units: question.at(&["units"]).map(|node| node.all("unit").map(unit).collect()).unwrap_or_default(),
        penalty: question.text_at(&["unitpenalty"]).parse().unwrap_or(0.0),
    }]
}

/// The place of the first of these signs that is not escaped.
fn bare(text: &str, signs: &[char]) -> Option<usize> {
    let mut before = ' ';
    for (place, sign) in text.char_indices() {
        if signs.contains(&sign) && before != '\\' && before != '&' && !text[..place].ends_with("&amp;") {
            return Some(place);
        }
        before = sign;
    }
    None
}

fn gaps(text: &str) -> Vec<Field> {
    let mut all = Vec::new();
    let mut rest = text;
    while let Some(start) = rest.find('{') {
        let inside = &rest[start + 1..];
        let end = bare(inside, &['}']).unwrap();
        let (gap, after) = (&inside[..end], &inside[end + 1..]);
        let mut pieces = gap.splitn(3, ':');
        let [weight, kind, mut alternatives] = [(); 3].map(|()| pieces.next().unwrap());
        let mut field =
            Field { is_choice: kind.starts_with("MULTICHOICE"), weight: weight.parse().unwrap(), ..Field::default() };
        loop {
            let cut = bare(alternatives, &['~']);
            let one = &alternatives[..cut.unwrap_or(alternatives.len())];
            let (fraction, one) = match one.strip_prefix('=') {
                Some(one) => (100.0, one),
                None => {
                    let (share, one) = one.strip_prefix('%').unwrap().split_once('%').unwrap();
                    (share.parse().unwrap(), one)
                }
            };
            let (answer, feedback) = bare(one, &['#']).map_or((one, ""), |cut| (&one[..cut], &one[cut + 1..]));
            let (text, tolerance) = match answer.split_once(':').filter(|_| !field.is_choice) {
                Some((text, tolerance)) => (text, tolerance.parse().unwrap()),
                None => (answer, 0.0),
            };
            field.answers.push(Answer { text: decoded(text), tolerance, fraction, feedback: decoded(feedback) });
            match cut {
                Some(cut) => alternatives = &alternatives[cut + 1..],
                None => break,
            }
        }
        all.push(field);
        rest = after;
    }
    assert!(!rest.contains('}'), "the rest of a gap fell out: {rest}");
    all
}

impl Field {
    /// What a typed number earns, from 0 to 1, and what is said of it.
    pub fn mark(&self, typed: &str) -> (f64, &str) {
        let typed: String = typed.split(' ').collect();
        let typed = typed.replacen("×10^", "e", 1).replacen("x10^", "e", 1);
        let (number, unit) = (0..=typed.len())
            .rev()
            .find_map(|cut| Some((typed.get(..cut)?.parse::<f64>().ok()?, typed.get(cut..)?)))
            .unwrap_or_else(|| panic!("{typed} is no number"));
        let known = self.units.iter().find(|(name, _)| name == unit);
        let in_default = known.map(|(_, multiplier)| number / multiplier);
        let find = |number: f64| self.answers.iter().find(|answer| answer.takes(number));
        let penalty = if self.units.is_empty() { 0.0 } else { self.penalty };
        let fits = in_default.and_then(find).map(|fit| (fit, 0.0)).or(find(number).map(|answer| (answer, penalty)));
        fits.map_or((0.0, ""), |(answer, penalty)| (answer.fraction / 100.0 * (1.0 - penalty), &answer.feedback))
    }

    /// What a number in the unit of the question earns.
    pub fn mark_number(&self, number: f64) -> (f64, &str) {
        let unit = self.units.first().map_or("", |(name, _)| name);
        self.mark(&format!("{number}{unit}"))
    }
}
