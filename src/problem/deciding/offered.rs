//! Options of the author's own for a variant: which of them is right, in which order they are offered, and what is said of each.

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_model::Model;

use super::super::compiling::planned::Form;
use super::super::language::text::Text;
use super::super::questions::choices::choice::ChoicePart;
use super::super::questions::choices::claim::Claim;
use super::super::questions::choices::decision::Decision;
use super::super::questions::choices::decision::OptionFeedback;
use super::super::questions::choices::offered::Offer;
use super::super::questions::choices::offered::Offered;
use super::super::questions::choices::offered::Truth;
use super::super::questions::part::Part;
use super::super::questions::part::PartKind;
use super::super::reading::numerals::alike;
use super::super::sampling::say;
use super::super::sampling::variant::Worked;

impl Offer {
    /// The place, as it is offered, of the right option where claims are judged so; none where one cannot be judged.
    #[must_use]
    pub fn right_by(&self, worked: &Worked<'_>, holds: &dyn Fn(&Claim) -> Option<bool>) -> Option<usize> {
        let right = self.right(holds)?;
        let [right] = right[..] else { return None };
        self.order(worked).iter().position(|place| *place == right)
    }

    /// Why the options cannot be offered with the numbers of a variant.
    pub(crate) fn refused(&self, worked: &Worked<'_>) -> Option<String> {
        let texts: Vec<String> = self.options.iter().map(|option| filled(&option.text, worked)).collect();
        let same = |(place, text): &(usize, &String)| texts.iter().take(*place).any(|other| alike(other, text));
        if let Some((_, text)) = texts.iter().enumerate().find(same) {
            return Some(format!("two options print `{text}`"));
        }
        if let Some(reason) = self.claims().find_map(|claim| claim.refused(worked)) {
            return Some(reason);
        }
        match self.right_for(worked)[..] {
            [_] => None,
            [] => Some("no option is right".to_owned()),
            [one, other, ..] => Some(format!("both `{}` and `{}` are right", texts[one], texts[other])),
        }
    }

    pub(crate) fn decided(&self, worked: &Worked<'_>) -> Decision {
        let order = self.order(worked);
        let in_order = || order.iter().filter_map(|place| self.options.get(*place));
        let right = self.right_for(worked).first().copied();
        Decision {
            options: in_order().map(|option| filled(&option.text, worked)).collect(),
            right: order.iter().take_while(|place| Some(**place) != right).count(),
            because: right
                .and_then(|place| self.options.get(place))
                .map(|option| option.why(worked))
                .unwrap_or_default(),
            behind: None,
            feedback: in_order()
                .map(|option| {
                    option
                        .feedback
                        .as_ref()
                        .map_or(OptionFeedback::Nothing, |text| OptionFeedback::Own(filled(text, worked)))
                })
                .collect(),
        }
    }

    /// The places in the file of the options that are right, where claims are judged so.
    fn right(&self, holds: &dyn Fn(&Claim) -> Option<bool>) -> Option<Vec<usize>> {
        let mut right = Vec::new();
        for (place, option) in self.options.iter().enumerate() {
            let is_right = match &option.truth {
                Truth::Always => true,
                Truth::Never => false,
                Truth::When(claim) => holds(claim)?,
                Truth::Otherwise => right.is_empty(),
            };
            right.extend(is_right.then_some(place));
        }
        Some(right)
    }

    fn right_for(&self, worked: &Worked<'_>) -> Vec<usize> {
        self.right(&|claim| claim.holds(worked)).unwrap_or_default()
    }

    /// The places in the file, in the order in which the options are offered.
    fn order(&self, worked: &Worked<'_>) -> Vec<usize> {
        let moved = self.options.iter().filter(|option| !matches!(option.truth, Truth::Otherwise)).count();
        let mut order = shuffled(worked, &self.stream, moved);
        order.extend(moved..self.options.len());
        order
    }
}

impl Offered {
    /// Why it is right, as a sentence without a full stop.
    fn why(&self, worked: &Worked<'_>) -> String {
        if let Some(because) = &self.because {
            return filled(because, worked).trim_end_matches('.').to_owned();
        }
        match &self.truth {
            Truth::When(claim) => claim.decided(worked).because,
            _ => "none of the other options is right".to_owned(),
        }
    }
}

/// A fault for each option that prints what neither the answers nor their checks find.
pub(crate) fn check(model: &Model, form: &Form) -> Vec<Fault> {
    let lost = |(index, part): (usize, &Part)| {
        let PartKind::Choice(ChoicePart::Offered(offer)) = &part.kind else { return None };
        let symbol = offer.printed.iter().find(|symbol| !form.finds(**symbol))?;
        let name = &model.symbols.entry(*symbol).name;
        let fault =
            Fault::new(Code::Text, format!("an option prints `{name}`, which does not follow from what is given"));
        let help = format!("give `{name}` as an expression of what is given: `{name}: m_A*v_A1/(m_A + m_B)`");
        Some(fault.help(help).at_path(form.question.path.key("ask").index(index).key("options")))
    };
    form.parts.iter().enumerate().filter_map(lost).collect()
}

/// The places in an order that each seed draws by itself.
pub(super) fn shuffled(worked: &Worked<'_>, stream: &str, count: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    // Numbers of somebody's own have no seed, and the order of the file may tell which is right.
    let mut word = worked.problem.streams().word_of(stream, worked.variant.seed().unwrap_or_default());
    for place in (1..count).rev() {
        let choices = place as u64 + 1;
        order.swap(place, usize::try_from(word % choices).unwrap_or(place));
        word /= choices;
    }
    order
}

/// A text on one line with its placeholders said for a variant.
fn filled(text: &Text, worked: &Worked<'_>) -> String {
    say::fill(text, worked.problem, worked.variant).split_whitespace().collect::<Vec<_>>().join(" ")
}
