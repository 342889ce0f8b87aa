//! The simulators: each a request with the values of its controls, and a response with everything that its page shows.

mod amount;
mod balance;
mod bars;
mod bounces;
mod collision;
mod compared;
mod controls;
mod curve;
mod discs;
mod drop;
mod magnified;
mod meeting;
mod restitution;
mod second;

use serde::Serialize;

use momentous_explain::Detail;
use momentous_simulate::Refusal;

use super::super::Exercise;
use super::refused::{Refused, RefusedKind};
use super::solve::{SolveResponse, answers};
use super::variant::VariantRequest;
use super::{Engine, Limits};

pub use amount::Amount;
pub use balance::Balance;
pub use bars::Bars;
pub use bounces::Bounce;
pub use collision::{CollisionBody, CollisionResponse};
pub use compared::{Compared, Offered, Row, USUAL_STEP};
pub use controls::{COLLISION, Control, DISCS, RESTITUTION, SimulatorRequest};
pub use curve::Curve;
pub use discs::{Disc, DiscsResponse};
pub use magnified::Magnified;
pub use meeting::Meeting;
pub use restitution::{LookedAt, RestitutionResponse, Sums};
pub use second::Second;

/// A phase of a body's motion until a time.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Phase {
    /// Until when, in s.
    pub until: f64,
    /// Its description, in words.
    pub words: &'static str,
}

/// The problem of the bank that is the scene of a simulator, with the values of the controls.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ProblemOf {
    /// The problem's identity.
    pub id: &'static str,
    /// The values, as they may be set there.
    pub set: Vec<(&'static str, String)>,
    /// The worked solution; nothing where the values leave none.
    pub solved: Option<SolveResponse>,
    /// Why there is none.
    pub reason: Option<String>,
    /// Whether it is because it may not be solved, whatever the values are.
    #[serde(skip)]
    pub hidden: bool,
}

impl ProblemOf {
    /// The variant with these values.
    fn variant(&self) -> VariantRequest {
        let set = self.set.iter().map(|(name, text)| ((*name).to_owned(), text.clone())).collect();
        VariantRequest { set, ..VariantRequest::drawn(self.id, None, 1) }
    }

    /// Why a scene with these values cannot be run: as the laws say it, where they leave no solution.
    fn refused(&self, reason: &Refusal) -> Refused {
        let impossible = self.impossible().cloned();
        impossible.map_or_else(|| not_run(reason), |reason| Refused::new(RefusedKind::Values, reason))
    }

    /// Why the values leave no solution, where they do.
    fn impossible(&self) -> Option<&String> {
        self.reason.as_ref().filter(|_| !self.hidden)
    }
}

impl Engine<'_> {
    /// The problem with these values, solved by the laws, and a quantity of it that it need not ask for.
    fn problem_with(
        &self,
        id: &'static str,
        set: Vec<(&'static str, String)>,
        name: &str,
    ) -> Result<(ProblemOf, Option<Amount>), Refused> {
        let (problem, exercise) = self.solved(id, set)?;
        let quantity = exercise.and_then(|exercise| {
            let asked = VariantRequest { find: vec![name.to_owned()], ..problem.variant() };
            let exercise = self.typed(exercise.problem(), exercise.variant().form(), &asked).ok()?;
            let answer = answers(&exercise).into_iter().find(|answer| answer.id == name)?;
            Some(Amount::with_text(answer.value?, &answer.printed))
        });
        Ok((problem, quantity))
    }

    /// The problem with these values, solved by the laws.
    fn problem_of(&self, id: &'static str, set: Vec<(&'static str, String)>) -> Result<ProblemOf, Refused> {
        Ok(self.solved(id, set)?.0)
    }

    fn solved(
        &self,
        id: &'static str,
        set: Vec<(&'static str, String)>,
    ) -> Result<(ProblemOf, Option<Exercise>), Refused> {
        let mut problem = ProblemOf { id, set, solved: None, reason: None, hidden: false };
        match self.draw(&problem.variant()) {
            Ok(exercise) => {
                problem.solved = Some(self.solution_of(&exercise, None, Detail::Short)?);
                return Ok((problem, Some(exercise)));
            }
            Err(refused) if refused.kind == RefusedKind::Values => {
                // How often numbers were tried says nothing of values that are typed.
                let reason = refused.message.split_once(" attempts: ").map(|(_, reason)| reason.to_owned());
                problem.reason = Some(reason.unwrap_or(refused.message));
            }
            // The scene is shown all the same.
            Err(refused) if refused.kind == RefusedKind::Reserved => {
                (problem.reason, problem.hidden) = (Some(refused.message), true);
            }
            Err(refused) => return Err(refused),
        }
        Ok((problem, None))
    }
}

/// A scene that no method runs, as a refusal of its values.
fn not_run(reason: &Refusal) -> Refused {
    Refused::new(RefusedKind::Values, reason.to_string())
}
