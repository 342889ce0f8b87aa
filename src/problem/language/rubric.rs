//! How a problem's answers are marked: what a partly right answer is worth, and what attempts and hints cost.

use schemars::JsonSchema;
use serde::Deserialize;

use momentous_laws::Law;
use momentous_laws::chapter_of;
use momentous_quantity::Decimal;
use momentous_quantity::Rational;
use momentous_scene::Term;

use super::entries::Entries;

/// What a partly right answer is worth, and what attempts and hints cost. Fractions are written `50 %`, `0.5` or `1/2`.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Rubric {
    /// The right number without its unit. Default: `50 %`.
    #[serde(default)]
    pub unit_missing: Option<Term>,
    /// The right number with another unit of the same dimension. Default: `50 %`.
    #[serde(default)]
    pub unit_wrong: Option<Term>,
    /// The right number with a unit that measures something else. Default: `50 %`.
    #[serde(default)]
    pub unit_wrong_dimension: Option<Term>,
    /// Off by the factor of a prefix: grams for kilograms. Default: `50 %`.
    #[serde(default)]
    pub unit_prefix: Option<Term>,
    /// Right, but in another unit than that of the question, with `other_units: refuse`. Default: `50 %`.
    #[serde(default)]
    pub unit_not_asked: Option<Term>,
    /// Off by a power of ten that is not a usual prefix. Default: `0 %`.
    #[serde(default)]
    pub order_of_magnitude: Option<Term>,
    /// The right magnitude without the sign or the word that gives the direction. Default: `50 %`.
    #[serde(default)]
    pub sense: Option<Term>,
    /// The right magnitude in the opposite direction. Default: `0 %`.
    #[serde(default)]
    pub sense_reversed: Option<Term>,
    /// Right to one figure fewer than asked. Default: `50 %`.
    #[serde(default)]
    pub rounding_slip: Option<Term>,
    /// The right value with too few, too many or wrong figures, with `writing: require`. Default: `75 %`.
    #[serde(default)]
    pub figures: Option<Term>,
    /// Wrong, but it follows from an earlier answer of the student's own. Default: `100 %`.
    #[serde(default)]
    pub follow_through: Option<Term>,
    /// The same, where the earlier answer makes something impossible happen. Default: `50 %`.
    #[serde(default)]
    pub follow_through_unphysical: Option<Term>,
    /// What is made of the figures with which a right value is written. Default: `advise`.
    #[serde(default)]
    pub writing: Option<Writing>,
    /// Whether other units of the same dimension will do. Default: `accept`.
    #[serde(default)]
    pub other_units: Option<OtherUnits>,
    /// How many attempts at a part count. Default: any number.
    #[serde(default)]
    #[schemars(range(min = 1, max = 100))]
    pub attempts: Option<u32>,
    /// What each attempt before costs, of the part's points. Default: `0 %`.
    #[serde(default)]
    pub attempt_penalty: Option<Term>,
    /// What each of the problem's hints that was shown costs, of the part's points. Default: `0 %`.
    #[serde(default)]
    pub hint_penalty: Option<Term>,
    /// What each further hint on a wrong answer costs, of the part's points. Default: `0 %`.
    #[serde(default)]
    pub further_hint_penalty: Option<Term>,
    /// Which of several attempts counts. Default: `best`.
    #[serde(default)]
    pub keep: Option<Keep>,
    /// The points for the work: for each law of a chapter (`momentum`, `restitution`, `energy`, ...) or for a law by its id that the answers
    /// need, and under `answer` for each answer. Whatever is not listed is worth none. Default: one point for each law and each answer.
    #[serde(default)]
    pub work: Option<Entries<u32>>,
}

/// The name in `work` of the points for an answer.
pub const ANSWER: &str = "answer";
/// The points for a law or an answer where the rubric lists none.
const EACH: u32 = 1;
/// The points for a law or an answer that the rubric leaves out.
const NOT_LISTED: u32 = 0;
/// The most points for a law or an answer.
pub(crate) const MOST_POINTS: u32 = 100;

/// What is made of the figures with which a right value is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Writing {
    /// Nothing.
    Ignore,
    /// The student is told.
    Advise,
    /// The student is told, and it costs points.
    Require,
}

/// Whether other units of the same dimension will do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum OtherUnits {
    /// They are as good.
    Accept,
    /// The unit of the question is asked.
    Refuse,
}

/// Which of several attempts counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Keep {
    /// The one with the most points.
    Best,
    /// The last that could be read.
    Last,
}

impl Rubric {
    /// Every fraction that is written, with its key.
    pub fn fractions(&self) -> impl Iterator<Item = (&'static str, &Term)> {
        let all = [
            ("unit_missing", &self.unit_missing),
            ("unit_wrong", &self.unit_wrong),
            ("unit_wrong_dimension", &self.unit_wrong_dimension),
            ("unit_prefix", &self.unit_prefix),
            ("unit_not_asked", &self.unit_not_asked),
            ("order_of_magnitude", &self.order_of_magnitude),
            ("sense", &self.sense),
            ("sense_reversed", &self.sense_reversed),
            ("rounding_slip", &self.rounding_slip),
            ("figures", &self.figures),
            ("follow_through", &self.follow_through),
            ("follow_through_unphysical", &self.follow_through_unphysical),
            ("attempt_penalty", &self.attempt_penalty),
            ("hint_penalty", &self.hint_penalty),
            ("further_hint_penalty", &self.further_hint_penalty),
        ];
        all.into_iter().filter_map(|(key, term)| Some((key, term.as_ref()?)))
    }

    /// The points for a law that the answers need and the work holds. A law by its id goes before its chapter.
    #[must_use]
    pub fn points_for_law(&self, law: &Law) -> u32 {
        let chapter = chapter_of(law).map_or("", |chapter| chapter.id);
        self.points_for_work(&[law.id, chapter])
    }

    /// The points for an answer that the work gives.
    #[must_use]
    pub fn points_for_answer(&self) -> u32 {
        self.points_for_work(&[ANSWER])
    }

    fn points_for_work(&self, names: &[&str]) -> u32 {
        let Some(work) = &self.work else { return EACH };
        names.iter().find_map(|name| work.get(name)).map_or(NOT_LISTED, |points| *points)
    }

    /// The fraction under a key; `None` where it is not written.
    #[must_use]
    pub fn fraction(&self, key: &str) -> Option<Rational> {
        self.fractions().find(|(listed, _)| *listed == key).and_then(|(_, term)| fraction(term))
    }
}

/// A fraction from 0 to 1: `50 %`, `0.5`, `1/2`.
#[must_use]
pub fn fraction(term: &Term) -> Option<Rational> {
    let text = term.0.trim();
    let number = |text: &str| Decimal::parse(text.trim()).ok().map(|number| number.to_rational());
    let value = match (text.strip_suffix('%'), text.split_once('/')) {
        (Some(percent), _) => number(percent)? / Rational::from(100),
        (None, Some((above, below))) => {
            let below = number(below).filter(|below| *below != Rational::ZERO)?;
            number(above)? / below
        }
        (None, None) => number(text)?,
    };
    (Rational::ZERO..=Rational::ONE).contains(&value).then_some(value)
}
