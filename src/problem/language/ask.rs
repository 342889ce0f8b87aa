//! What is asked of the student.

use schemars::JsonSchema;
use serde::Deserialize;

use momentous_scene::{Axis, Term};

use super::entries::Entries;

/// One part of a question. Its first key says which kind it is.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Ask {
    /// The value of a quantity.
    Find(Find),
    /// The first whole number that satisfies a condition.
    Count(Count),
    /// Whether a quantity is conserved.
    Conserved(Conserved),
    /// Of which kind an impact is.
    Classify(Classify),
    /// Whether a force is impulsive.
    Impulsive(Impulsive),
    /// Whether something holds of the numbers.
    Holds(Holds),
    /// In which order some quantities are.
    Order(Order),
    /// For which values of a quantity something holds.
    Range(Range),
    /// Which root of an equation is possible.
    Physical(WhichRoot),
    /// Which of the author's own options is right.
    Choose(Choose),
    /// Whether there is enough information to find a quantity.
    Enough(Enough),
}

/// The value of a quantity is asked.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Find {
    /// The name of the quantity: `v_A2`, `T_lost`, `J_A[hit]`; or, with an `id`, an expression of several: `v_B2 - v_A2`.
    pub find: String,
    /// The name under which an expression is answered: `gap`. It needs a `label` as well.
    #[serde(default)]
    pub id: Option<String>,
    /// How it is answered. Default: by a number.
    #[serde(default, rename = "as")]
    pub answered: Answered,
    /// The unit of the answer, or the name of a quantity in terms of which it is asked: `m/s`, `v_A1`.
    #[serde(default)]
    pub unit: Option<String>,
    /// How many points the part is worth: `2`.
    #[serde(default)]
    #[schemars(range(min = 0, max = 1000))]
    pub points: Option<u32>,
    /// How far an answer may lie from the true one: `2 %`, `0.05 m/s`; `to figures` for half a unit of its last figure.
    #[serde(default)]
    pub tolerance: Option<Term>,
    /// Significant figures of the printed answer.
    #[serde(default)]
    #[schemars(range(min = 1, max = 12))]
    pub figures: Option<u8>,
    /// `every` if all values that the equations give for it are asked for, possible or not.
    #[serde(default)]
    pub roots: Option<AskedRoots>,
    /// Of an angle: the direction from which it is measured: `+x`.
    #[serde(default)]
    pub from: Option<String>,
    /// Of an angle: the sense in which it is measured.
    #[serde(default)]
    pub sense: Option<Turn>,
    /// The name of the part on the sheet. Default: the meaning of the name.
    #[serde(default)]
    pub label: Option<String>,
    /// What marking must say of answers to the sheet of seed 1, by the codes of verdicts: `{ "3.1 m/s": right, "-3.1 m/s": sense }`.
    #[serde(default)]
    pub expect: Entries<String>,
}

impl Find {
    /// What the part is called in answers.
    #[must_use]
    pub fn name(&self) -> &str {
        self.id.as_deref().unwrap_or(&self.find)
    }
}

/// How the value of a quantity is answered.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Answered {
    /// By a number with its unit.
    #[default]
    Number,
    /// By a formula in the symbols of what is given.
    Formula,
}

/// The first whole number that satisfies a condition is asked.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Count {
    /// The number and its condition: `first n with h_n < h_min`, or `last n with x_n < d` for the last before it fails.
    pub count: String,
    /// How many points the part is worth: `2`.
    #[serde(default)]
    #[schemars(range(min = 0, max = 1000))]
    pub points: Option<u32>,
    /// The name of the part on the sheet.
    #[serde(default)]
    pub label: Option<String>,
}

/// Whether a quantity is conserved is asked; the answer is read from the scene.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Conserved {
    /// The quantity.
    pub conserved: Conservable,
    /// The bodies that make up the system.
    pub of: Vec<String>,
    /// The axis along which a component is meant; of momentum only. Default: every axis.
    #[serde(default)]
    pub along: Option<Axis>,
    /// The fixed point about which angular momentum is taken.
    #[serde(default)]
    pub about: Option<String>,
    /// The name of the stage. Default: the only one.
    #[serde(default)]
    #[schemars(with = "Option<Term>")]
    pub stage: Option<String>,
    /// How many points the part is worth: `2`.
    #[serde(default)]
    #[schemars(range(min = 0, max = 1000))]
    pub points: Option<u32>,
    /// The name of the part on the sheet.
    #[serde(default)]
    pub label: Option<String>,
}

/// Of which kind something is, is asked; the answer is read from the scene.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Classify {
    /// What is to be classified.
    pub classify: Classifiable,
    /// The name of the stage. Default: the only one.
    #[serde(default)]
    #[schemars(with = "Option<Term>")]
    pub stage: Option<String>,
    /// How many points the part is worth: `2`.
    #[serde(default)]
    #[schemars(range(min = 0, max = 1000))]
    pub points: Option<u32>,
    /// The name of the part on the sheet.
    #[serde(default)]
    pub label: Option<String>,
}

/// Whether a force is impulsive in a stage is asked; the answer is read from the scene.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Impulsive {
    /// The force, as it is called in the scene: `weight`, `normal force`, `the thrust`.
    pub impulsive: String,
    /// The body on which it acts. Default: the only one.
    #[serde(default)]
    pub on: Option<String>,
    /// The name of the stage. Default: the only one.
    #[serde(default)]
    #[schemars(with = "Option<Term>")]
    pub stage: Option<String>,
    /// How many points the part is worth: `2`.
    #[serde(default)]
    #[schemars(range(min = 0, max = 1000))]
    pub points: Option<u32>,
    /// The name of the part on the sheet.
    #[serde(default)]
    pub label: Option<String>,
}

/// Whether something holds of the numbers is asked; the answer is yes or no, and may differ from variant to variant.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Holds {
    /// What may hold: `v_B3 > v_A3`. What it compares is solved.
    pub holds: String,
    /// How many points the part is worth: `2`.
    #[serde(default)]
    #[schemars(range(min = 0, max = 1000))]
    pub points: Option<u32>,
    /// The question as the sheet puts it: `Will the carts meet again?`. Default: whether the one quantity is greater than the other.
    #[serde(default)]
    pub label: Option<String>,
}

/// The order of some quantities is asked, from the least to the greatest.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Order {
    /// Two to four quantities of one kind, which are solved: `[v_A2, v_B2, v_C2]`.
    #[schemars(length(min = 2, max = 4))]
    pub order: Vec<String>,
    /// How many points the part is worth: `2`.
    #[serde(default)]
    #[schemars(range(min = 0, max = 1000))]
    pub points: Option<u32>,
    /// The question as the sheet puts it.
    #[serde(default)]
    pub label: Option<String>,
}

/// The values of a quantity for which something holds are asked; the answer is an interval or a condition.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Range {
    /// The quantity, which the form does not tell: `e`.
    pub range: String,
    /// What is to hold: `v_A2 < 0 m/s`. At the boundary both sides are equal.
    #[serde(rename = "where")]
    pub condition: String,
    /// The unit of the boundary.
    #[serde(default)]
    pub unit: Option<String>,
    /// How many points the part is worth: `2`.
    #[serde(default)]
    #[schemars(range(min = 0, max = 1000))]
    pub points: Option<u32>,
    /// How far the boundary of an answer may lie from the true one: `2 %`.
    #[serde(default)]
    pub tolerance: Option<Term>,
    /// Significant figures of the printed boundary.
    #[serde(default)]
    #[schemars(range(min = 1, max = 12))]
    pub figures: Option<u8>,
    /// The question as the sheet puts it: `For which e does A bounce back?`.
    #[serde(default)]
    pub label: Option<String>,
    /// What marking must say of answers to the sheet of seed 1, by the codes of verdicts: `{ "3.1 m/s": right, "-3.1 m/s": sense }`.
    #[serde(default)]
    pub expect: Entries<String>,
}

/// Which of the two values that the equations give for a quantity is possible, and why; the answer is read from the conditions
/// of the scene.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WhichRoot {
    /// The quantity, whose equation has two roots: `v_B2`.
    pub physical: String,
    /// How many points the part is worth: `2`.
    #[serde(default)]
    #[schemars(range(min = 0, max = 1000))]
    pub points: Option<u32>,
    /// The question as the sheet puts it.
    #[serde(default)]
    pub label: Option<String>,
}

/// Whether the sheet tells enough to find a quantity is asked; the answer is found by planning how to find it.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Enough {
    /// The quantity: `v_A2`. Drawn numbers that the sheet does not print are not known.
    pub enough: String,
    /// How many points the part is worth: `2`.
    #[serde(default)]
    #[schemars(range(min = 0, max = 1000))]
    pub points: Option<u32>,
    /// The question as the sheet puts it.
    #[serde(default)]
    pub label: Option<String>,
}

/// Which of several options of the author's own is right is asked; each seed has an order of its own.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Choose {
    /// The question as the sheet puts it: `What does trolley A do after the impact?`.
    pub choose: String,
    /// The options: with `last` 2 to 8.
    #[serde(default)]
    pub options: Vec<Offered>,
    /// In place of `options`: pictures, the right one and those of usual mistakes, which the program draws from the scene.
    #[serde(default)]
    pub pictures: Option<Pictures>,
    /// The name of the stage of which the pictures are. Default: the only one; of a graph, all stages.
    #[serde(default)]
    #[schemars(with = "Option<Term>")]
    pub stage: Option<String>,
    /// Of a graph: the body. Default: the only one.
    #[serde(default)]
    pub of: Option<String>,
    /// Of a graph: the axis along which it is counted. Default: the only one.
    #[serde(default)]
    pub along: Option<Axis>,
    /// What is offered last in every order, and is right where no other option is: `{ text: none of these }`.
    #[serde(default)]
    pub last: Option<LastOffered>,
    /// How many points the part is worth: `2`.
    #[serde(default)]
    #[schemars(range(min = 0, max = 1000))]
    pub points: Option<u32>,
}

/// An option of the author's own.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Offered {
    /// What it says, with mathematics between dollars: `the kinetic energy $T$`; it may print quantities: `it moves at {{ v_A1 }}`.
    pub text: String,
    /// `true` if it is the right one.
    #[serde(default)]
    pub right: bool,
    /// What must hold of the numbers for it to be the right one: `v_A2 < 0 m/s`.
    #[serde(default)]
    pub holds: Option<String>,
    /// Why it is right, as a sentence for the worked solution. Default, with `holds`: how the two sides compare.
    #[serde(default)]
    pub because: Option<String>,
    /// What is said to a student who chose it wrongly.
    #[serde(default)]
    pub feedback: Option<String>,
}

/// The option that is right where no other is.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LastOffered {
    /// What it says: `none of these`.
    pub text: String,
    /// Why it is right where it is. Default: that no other option is right.
    #[serde(default)]
    pub because: Option<String>,
    /// What is said to a student who chose it wrongly.
    #[serde(default)]
    pub feedback: Option<String>,
}

/// What the options of a choice between pictures show.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Pictures {
    /// Momentum before, impulse and momentum after of each body.
    ImpulseMomentum,
    /// The velocity of a body against time.
    VelocityTime,
    /// The momentum of a body against time.
    MomentumTime,
    /// The net force on a body against time.
    ForceTime,
}

/// Which values of a quantity are asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum AskedRoots {
    /// Every value that the equations give, possible or not.
    Every,
}

/// A sense of rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Turn {
    /// From x towards y.
    CounterClockwise,
    /// From y towards x.
    Clockwise,
}

/// A quantity that may be conserved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Conservable {
    /// Linear momentum.
    Momentum,
    /// Kinetic energy.
    Energy,
    /// Angular momentum.
    AngularMomentum,
}

/// What can be classified.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Classifiable {
    /// An impact: elastic, inelastic or plastic; direct or oblique.
    Impact,
}
