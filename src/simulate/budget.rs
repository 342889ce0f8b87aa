//! How long a run may go on, in the scene's time, in impacts and in steps, and what it keeps.

/// The limits of a run. Every run ends at the first that it reaches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Budget {
    /// The scene's time, in s.
    pub until: f64,
    /// The number of impacts after which the run is complete.
    pub impacts: usize,
    /// The number of steps (of events, where a method has no steps) after which it gives up.
    pub steps: usize,
    /// The states that the trajectory keeps.
    pub keep: Keep,
}

/// The states that a trajectory keeps of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Keep {
    /// Every segment and every impact.
    #[default]
    Everything,
    /// The same, and the state at the end of each step of a method that has steps.
    Steps,
    /// The impacts, and the last state.
    Impacts,
    /// The number of impacts, and the last state.
    Count,
}

impl Keep {
    /// Whether segments are kept.
    #[must_use]
    pub(super) fn has_paths(self) -> bool {
        matches!(self, Self::Everything | Self::Steps)
    }
}

impl Budget {
    /// A run until a time, with at most a million impacts and ten million steps.
    #[must_use]
    pub fn until(time: f64) -> Self {
        Self { until: time, impacts: 1_000_000, steps: 10_000_000, keep: Keep::Everything }
    }

    /// A run until so many impacts have happened, however long that takes.
    #[must_use]
    pub fn impacts(count: usize) -> Self {
        Self { impacts: count, ..Self::until(f64::INFINITY) }
    }

    /// The same run with another limit of impacts.
    #[must_use]
    pub fn at_most(mut self, impacts: usize) -> Self {
        self.impacts = impacts;
        self
    }

    /// The same run with another limit of steps.
    #[must_use]
    pub fn steps(mut self, steps: usize) -> Self {
        self.steps = steps;
        self
    }

    /// The same run, keeping less.
    #[must_use]
    pub fn keep(mut self, keep: Keep) -> Self {
        self.keep = keep;
        self
    }
}
