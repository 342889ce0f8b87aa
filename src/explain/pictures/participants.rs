//! Who takes part in the diagram of a stage, and what is drawn between the momenta.

/// Who takes part in a stage, and with which body it moves at either end.
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

/// What the diagram of a stage shows.
pub(super) struct Drawn {
    pub participants: Vec<Participant>,
    /// What is drawn between the momenta.
    pub arrows: Arrows,
    /// Whether two bodies act on each other, with equal and opposite impulses.
    pub mutual: bool,
}

/// What changes a momentum.
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
