//! Calls of the engine by every face of the program: typed requests and responses, with JSON in and out.
//!
//! A face (a page of the web application, a page that works offline) turns what its user does into one of these calls and
//! shows the response. It knows no physics and marks nothing.

mod givens;
mod hint;
mod limits;
mod mark;
mod play;
mod read;
mod refused;
mod sheet;
mod simulate;
mod simulators;
mod solve;
mod variant;
mod work;

use std::sync::Arc;

use serde::Serialize;
use serde::de::DeserializeOwned;

use momentous_problem::Problem;
use momentous_render::Renderer;

pub use givens::{GivenResponse, GivensRequest};
pub use hint::{HintRequest, HintResponse};
pub use limits::Limits;
pub use limits::within;
pub use mark::{MarkRequest, MarkResponse, MarkedPart};
pub use momentous_explain::Detail;
pub use play::{FilmResponse, PlayResponse};
pub use read::{ReadRequest, ReadResponse};
pub use refused::{Refused, RefusedKind};
pub use sheet::{FieldResponse, FigureResponse, SheetRequest, SheetResponse};
pub use simulate::SimulateRequest;
pub use simulators::{
    Amount, Balance, Bars, Bounce, COLLISION, CollisionBody, CollisionResponse, Compared, Control, Curve, DISCS, Disc,
    DiscsResponse, LookedAt, Magnified, Meeting, Offered, Phase, ProblemOf, RESTITUTION, RestitutionResponse, Row,
    Second, SimulatorRequest, Sums, USUAL_STEP,
};
pub use solve::{SolveRequest, SolveResponse, SolvedPart};
pub use variant::VariantRequest;
pub use work::{WorkRequest, WorkResponse};

/// A source in which an engine finds problems by their identities.
pub trait Problems {
    /// The problem, compiled.
    ///
    /// # Errors
    /// [`RefusedKind::Unknown`] where there is none, [`RefusedKind::Fault`] where its file does not load.
    fn problem(&self, id: &str) -> Result<Arc<Problem>, Refused>;

    /// Whether a problem may be solved with numbers of the user's own.
    ///
    /// # Errors
    /// [`RefusedKind::Reserved`] where it may not.
    fn own_numbers(&self, _problem: &Problem) -> Result<(), Refused> {
        Ok(())
    }
}

/// The engine behind every face.
pub struct Engine<'a> {
    /// The source of problems.
    pub problems: &'a dyn Problems,
    /// The renderer that turns solutions into pages.
    pub renderer: &'a Renderer,
    /// How much a call may take.
    pub limits: Limits,
}

/// A call with JSON in and out.
type Call = fn(&Engine<'_>, &[u8]) -> Result<String, Refused>;

/// Every call by its name, as it stands in addresses.
const CALLS: [(&str, Call); 11] = [
    ("collision", |engine, request| json(request, |request| engine.collision(request))),
    ("discs", |engine, request| json(request, |request| engine.discs(request))),
    ("givens", |engine, request| json(request, |request| engine.givens(request))),
    ("hint", |engine, request| json(request, |request| engine.hint(request))),
    ("mark", |engine, request| json(request, |request| engine.mark(request))),
    ("read", |engine, request| json(request, |request| engine.read(request))),
    ("restitution", |engine, request| json(request, |request| engine.restitution(request))),
    ("sheet", |engine, request| json(request, |request| engine.sheet(request))),
    ("simulate", |engine, request| json(request, |request| engine.simulate(request))),
    ("solve", |engine, request| json(request, |request| engine.solve(request))),
    ("work", |engine, request| json(request, |request| engine.work(request))),
];

impl Engine<'_> {
    /// A call by its name, with JSON in and out.
    ///
    /// # Errors
    /// Where there is no such call, the request is not one of its kind, or the call itself refuses.
    pub fn call(&self, name: &str, request: &[u8]) -> Result<String, Refused> {
        within(request.len(), self.limits.request_bytes, "bytes make a request")?;
        let Some((_, call)) = CALLS.iter().find(|(listed, _)| *listed == name) else {
            let names: Vec<&str> = CALLS.iter().map(|(known, _)| *known).collect();
            let refused = Refused::new(RefusedKind::Unknown, format!("there is no call `{name}`"));
            return Err(refused.help(format!("the calls are {}", names.join(", "))));
        };
        call(self, request)
    }
}

/// Reads a request, and writes what becomes of it.
fn json<Request: DeserializeOwned, Response: Serialize>(
    request: &[u8],
    call: impl FnOnce(&Request) -> Result<Response, Refused>,
) -> Result<String, Refused> {
    let mut reader = serde_json::Deserializer::from_slice(request);
    let request: Request = serde_path_to_error::deserialize(&mut reader).map_err(|error| {
        let place = error.path().to_string();
        // `?` stands where the text ends too early for a place.
        let place = if [".", "?"].contains(&place.as_str()) { String::new() } else { format!("`{place}`: ") };
        Refused::new(RefusedKind::Invalid, format!("{place}{}", error.inner()))
    })?;
    let response = call(&request)?;
    serde_json::to_string(&response).map_err(|error| Refused::new(RefusedKind::Fault, error.to_string()))
}
