//! Participants in the diagram of a stage, and the arrows between the momenta.

/// A participant in a stage, and the body with which it moves at either end.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Participant {
    pub body: String,
    pub before: String,
    pub after: String,
}

impl Participant {
    /// A body that stays itself.
    pub(super) fn alone(body: &str) -> Self {
        Self::between(body, body, body)
    }

    /// A body that moves with one body before, and with another after.
    pub(super) fn between(body: &str, before: &str, after: &str) -> Self {
        let [body, before, after] = [body, before, after].map(str::to_owned);
        Self { body, before, after }
    }
}

/// The content of the diagram of a stage.
pub(super) struct Drawn {
    pub participants: Vec<Participant>,
    /// The arrows between the momenta.
    pub arrows: Arrows,
    /// Whether two bodies act on each other, with equal and opposite impulses.
    pub mutual: bool,
}

/// The arrows of what changes a momentum.
#[derive(Clone, Copy)]
pub(super) enum Arrows {
    /// Each impulse.
    Impulses,
    /// The impulse of each force.
    Forces,
    /// The impulse of weight.
    Weight,
    /// All impulses in one.
    Resultant,
}
