//! The two simulators: each a request with the values of its controls, and a response with everything that its page shows.

mod amount;
mod bounces;
mod collision;
mod compared;
mod controls;
mod curve;
mod magnified;
mod restitution;

use serde::Serialize;

use momentous_explain::Detail;
use momentous_simulate::Refusal;

use super::refused::{Refused, RefusedKind};
use super::solve::SolveResponse;
use super::variant::VariantRequest;
use super::{Engine, Limits};

pub use amount::Amount;
pub use bounces::Bounce;
pub use collision::{Balance, CollisionBody, CollisionResponse, Meeting};
pub use compared::{Compared, Offered, Row, USUAL_STEP};
pub use controls::{COLLISION, Control, RESTITUTION, SimulatorRequest};
pub use curve::Curve;
pub use magnified::Magnified;
pub use restitution::{LookedAt, RestitutionResponse, Sums};

/// What a body does until a time.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Phase {
    /// Until when, in s.
    pub until: f64,
    /// What it does, in words.
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
    /// Why the values leave no solution, where they do.
    fn impossible(&self) -> Option<&String> {
        self.reason.as_ref().filter(|_| !self.hidden)
    }
}

impl Engine<'_> {
    /// The problem with these values, solved by the laws.
    fn problem_of(&self, id: &'static str, set: Vec<(&'static str, String)>) -> Result<ProblemOf, Refused> {
        let variant = VariantRequest {
            set: set.iter().map(|(name, text)| ((*name).to_owned(), text.clone())).collect(),
            ..VariantRequest::drawn(id, None, 1)
        };
        let mut problem = ProblemOf { id, set, solved: None, reason: None, hidden: false };
        match self.draw(&variant) {
            Ok(exercise) => problem.solved = Some(self.solution_of(&exercise, None, Detail::Short)?),
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
        Ok(problem)
    }
}

/// A scene that no method runs, as a refusal of its values.
fn not_run(reason: &Refusal) -> Refused {
    Refused::new(RefusedKind::Values, reason.to_string())
}
