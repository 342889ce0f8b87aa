//! A problem file as its author wrote it: every key of the language, with its description.

use schemars::JsonSchema;
use serde::Deserialize;

use momentous_quantity::UnitSystem;
use momentous_scene::{Scene, Term};

use super::ask::Ask;
use super::course::CourseSymbols;
use super::entries::Entries;
use super::given::GivenEntry;
use super::intended::Intended;
use super::rubric::Rubric;
use super::text::Text;

/// A problem file: keys with their values, from `id` and `title` to what is asked.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Draft {
    /// The problem's identity, `topic/name` in lower-case letters, digits and hyphens: `impact/two-carts`. Drawn numbers depend on it.
    #[schemars(regex(pattern = r"^[a-z0-9]+(-[a-z0-9]+)*(/[a-z0-9]+(-[a-z0-9]+)*)*$"))]
    pub id: String,
    /// The identity that it had before it was renamed. Its numbers stay the same: `impulse/lift-cable`.
    #[serde(default)]
    pub was: Option<String>,
    /// The title on the sheet.
    pub title: String,
    /// How demanding the problem is.
    pub level: Level,
    /// Words by which the problem is found.
    #[serde(default)]
    pub tags: Vec<String>,
    /// Where the problem comes from: a book, a page, a person.
    #[serde(default)]
    pub source: Option<String>,
    /// The unit system for defaults such as gravity. Default: `SI`.
    #[serde(default)]
    pub units: Units,
    /// The letters that the course uses for some quantities: `{ momentum: L, impulse: I }`. Names in the file keep the usual ones.
    #[serde(default)]
    pub symbols: CourseSymbols,
    /// What is there and what happens: axes, bodies and stages.
    pub scene: Scene,
    /// What is known: each name of the scene with a range, a choice, a value, an expression of other givens, or `any`.
    #[serde(default)]
    pub given: Entries<GivenEntry>,
    /// Conditions that drawn values must satisfy, or they are drawn again: `v_A1 > v_B1`.
    #[serde(default)]
    pub require: Vec<String>,
    /// Laws of the author's own, each with its reason.
    #[serde(default)]
    pub relations: Vec<Relation>,
    /// The story, in Markdown with placeholders: `Cart A ({{ m_A }}) moves {{ v_A1 | motion }}.`
    #[schemars(with = "String")]
    pub text: Text,
    /// The forms in which the problem is asked, each under a name. A problem with one form may write its keys at the top instead.
    #[serde(default)]
    pub forms: Entries<Form>,
    /// What is asked, of a problem without `forms`.
    #[serde(default)]
    pub ask: Vec<Ask>,
    /// Names that are solved first and then given, rounded as they are printed; of a problem without `forms`.
    #[serde(default)]
    pub reveal: Vec<String>,
    /// Conditions that choose the intended solution if several are true, in every form.
    #[serde(default, rename = "where")]
    pub conditions: Vec<Intended>,
    /// `all` if every true solution is asked for, in every form.
    #[serde(default)]
    pub roots: Option<Roots>,
    /// What this problem intends although it would otherwise be refused or reported, by its name, in every form: `passes-through`, `one-sheet`.
    #[serde(default)]
    pub allow: Vec<String>,
    /// What `momentous check` notes of this problem, in every form, and its author knows, by the name of the promise, with the reason: `{ sharp: rounding is what it is about }`.
    #[serde(default)]
    pub acknowledge: Entries<String>,
    /// `unphysical` if the problem is meant to end in something impossible, in every form.
    #[serde(default)]
    pub expect: Option<Expect>,
    /// Hints, shown one by one, in every form.
    #[serde(default)]
    #[schemars(with = "Vec<String>")]
    pub hints: Vec<Text>,
    /// A message to a student who made a common mistake, by the mistake's name: `momentous diagnose --list` lists them.
    #[serde(default)]
    #[schemars(with = "Entries<String>")]
    pub feedback: Entries<Text>,
    /// Common mistakes, by their names, that must change some answer: if they do not, the numbers are drawn again.
    #[serde(default)]
    pub discriminate: Vec<String>,
    /// Significant figures of printed answers. Default: 3.
    #[serde(default)]
    #[schemars(range(min = 1, max = 12))]
    pub figures: Option<u8>,
    /// How far an answer may lie from the true one: `2 %`, `0.05 m/s`; `to figures` for half a unit of its last figure.
    #[serde(default)]
    pub tolerance: Option<Term>,
    /// Points of each part that does not say its own. Default: 1.
    #[serde(default)]
    #[schemars(range(min = 0, max = 1000))]
    pub points: Option<u32>,
    /// What a partly right answer is worth, and what attempts and hints cost.
    #[serde(default)]
    pub rubric: Rubric,
}

/// Significant figures to which answers are expected where nothing is said.
pub const USUAL_FIGURES: usize = 3;

impl Draft {
    /// The identity from which its numbers are drawn: the one before it was renamed.
    #[must_use]
    pub fn drawn_as(&self) -> &str {
        self.was.as_deref().unwrap_or(&self.id)
    }

    /// To how many significant figures answers are printed.
    #[must_use]
    pub fn significant_figures(&self) -> usize {
        self.figures.map_or(USUAL_FIGURES, usize::from)
    }

    /// The points of a part, which may say its own.
    #[must_use]
    pub(crate) fn points_of(&self, points: Option<u32>) -> u32 {
        points.or(self.points).unwrap_or(1)
    }
}

/// One way in which a problem is asked.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Form {
    /// The end of the text, after the story: what is given in this form, and the question.
    #[serde(default)]
    #[schemars(with = "Option<String>")]
    pub text: Option<Text>,
    /// Other values of what the file gives by a value, a range or a choice.
    #[serde(default)]
    pub given: Entries<GivenEntry>,
    /// What is asked.
    pub ask: Vec<Ask>,
    /// Names that are solved first and then given, rounded as they are printed.
    #[serde(default)]
    pub reveal: Vec<String>,
    /// Conditions that choose the intended solution if several are true.
    #[serde(default, rename = "where")]
    pub conditions: Vec<Intended>,
    /// `all` if every true solution is asked for.
    #[serde(default)]
    pub roots: Option<Roots>,
    /// What this form intends although it would otherwise be refused or reported, by its name: `passes-through`, `one-sheet`.
    #[serde(default)]
    pub allow: Vec<String>,
    /// What `momentous check` notes of this form and its author knows, by the name of the promise, with the reason: `{ sharp: rounding is what it is about }`.
    #[serde(default)]
    pub acknowledge: Entries<String>,
    /// `unphysical` if the form is meant to end in something impossible.
    #[serde(default)]
    pub expect: Option<Expect>,
    /// Hints, shown one by one.
    #[serde(default)]
    #[schemars(with = "Vec<String>")]
    pub hints: Vec<Text>,
}

/// A law of the author's own.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Relation {
    /// The equation, checked for its dimensions: `k*x^2/2 = m*v_A2^2/2`.
    pub equation: String,
    /// Why it holds, as the worked solution says it: `all its kinetic energy is stored in the spring`.
    pub because: String,
}

/// How demanding a problem is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Level {
    /// One law, used once.
    Intro,
    /// What every student should be able to do.
    Core,
    /// Several steps, or a turn that must be found.
    Challenge,
}

/// A unit system.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
pub enum Units {
    /// Metre, kilogram, second.
    #[default]
    #[serde(rename = "SI")]
    Si,
    /// Foot, slug, pound-force, second.
    #[serde(rename = "US")]
    Us,
}

impl Units {
    /// The unit system.
    #[must_use]
    pub fn system(self) -> UnitSystem {
        match self {
            Self::Si => UnitSystem::Si,
            Self::Us => UnitSystem::Us,
        }
    }
}

/// Which of several true solutions are asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Roots {
    /// Every one.
    All,
}

/// How a problem is meant to end.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Expect {
    /// In something impossible, which the student is to notice.
    Unphysical,
}
