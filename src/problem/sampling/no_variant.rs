//! Why a seed has no variant, or values have none.

use momentous_model::Reason;
use momentous_model::Warning;
use momentous_quantity::MOST_TOLERANCES;

/// Tries for one seed before the problem is given up as one that cannot be drawn.
pub const MOST_ATTEMPTS: u64 = 256;

/// Why a seed has no variant.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoVariant {
    /// No attempt satisfied what the problem requires and had exactly one admissible solution; why the last one did not.
    #[error("no admissible numbers were found within {MOST_ATTEMPTS} attempts{}", because(.0.as_ref()))]
    Exhausted(Option<Rejection>),
    /// The problem has no form at that position.
    #[error("the problem has no such form")]
    NoForm,
    /// The problem tells this quantity otherwise than a sheet that was handed out.
    #[error("the sheet was made from another version of the problem, which tells `{0}` otherwise")]
    OtherSheet(String),
    /// A newer version of the program drew the numbers, by a scheme of this number.
    #[error("its numbers were drawn by a newer version of the program (scheme {0})")]
    NoScheme(u32),
    /// The values leave no admissible solution, or more than one.
    #[error("with these values the problem has {count} admissible solutions{}", because(.reason.as_ref()))]
    Solutions {
        /// How many.
        count: usize,
        /// Why there is none, where that is known.
        reason: Option<Rejection>,
    },
}

/// Why numbers were rejected.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Rejection {
    /// They say more than can be true: an equation that was not needed does not hold.
    #[error("what is given contradicts {law}, which connects {names}")]
    Contradiction {
        /// The law.
        law: &'static str,
        /// The quantities that it connects.
        names: String,
    },
    /// They break a condition of the scene or of the problem.
    #[error("{}{reason}", within(stage.as_deref()))]
    Condition {
        /// Why it does not hold.
        reason: Reason,
        /// The stage to which it belongs, where there are several and the reason does not say so.
        stage: Option<String>,
        /// The key of that stage which settles it, where there is one.
        key: Option<&'static str>,
    },
    /// The boundary of a range that is asked is beyond what can be.
    #[error(
        "where the condition on `{name}` begins to hold, {reason}: within the possible range, the condition always holds or never holds"
    )]
    Boundary {
        /// The quantity whose range is asked.
        name: String,
        /// Why the numbers at the boundary are rejected.
        reason: Box<Rejection>,
    },
    /// They make a quantity zero in terms of which an answer is asked.
    #[error("`{0}` is zero, so nothing can be given in terms of it")]
    ZeroUnit(String),
    /// They make a vector zero whose direction is asked; the direction in words.
    #[error("{0} is asked for, but that vector is zero and has none; choose other numbers, or ask for its components")]
    NoDirection(String),
    /// They make the solution divide by zero on the way to an answer; the answer's name.
    #[error(
        "`{0}` does not follow from these numbers: on the way to it something is divided by zero, as by the sine of a direction \
         along an axis; give the component that is zero instead of the direction (`v_A2.y: 0 m/s`), or choose other numbers"
    )]
    Undefined(String),
    /// They leave nothing of a mass that is asked.
    #[error("`{0}` would be zero, and no mass is: the other values hold for any mass, and do not determine it")]
    Vanishing(String),
    /// They leave no time for a stage whose duration is asked.
    #[error("`{0}` would be zero, and then nothing has happened: the other values do not determine it")]
    NoTime(String),
    /// They leave a quantity without a value that a text of the form prints; the quantity's name.
    #[error("`{0}` has no value with these numbers, and a text prints it")]
    Unprinted(String),
    /// They leave several solutions.
    #[error("there are {0} solutions; pick one with `where`, or ask for all with `roots: all`")]
    Several(usize),
    /// They let the scene go in two ways, in which what is asked has different values: what happens in the one, and in the other.
    #[error(
        "there is one solution in which {}, and one in which {}",
        words(taken, "it goes so"),
        words(other, "it goes otherwise")
    )]
    GoesOtherwise {
        /// What happens in the way that was taken.
        taken: String,
        /// What happens in the other.
        other: String,
    },
    /// They leave a choice without its one right option.
    #[error("{0}")]
    Options(String),
    /// They let rounding on the way shift the answer to a part so far that it cannot be marked; the part's name.
    #[error(
        "rounding intermediate results shifts `{0}` by more than {MOST_TOLERANCES} tolerances; draw other numbers, ask for more \
         figures (`figures: 4`), or widen its `tolerance`"
    )]
    IllChosen(String),
    /// They leave no real value for these quantities.
    #[error("there is no real solution{}", for_what(.0))]
    NotReal(Vec<String>),
    /// They make a quantity negative that never is; those among which it is.
    #[error("a quantity that must be positive would be negative{}", among(.0))]
    NotPositive(Vec<String>),
}

impl NoVariant {
    /// Why numbers were rejected, where that is known.
    #[must_use]
    pub fn rejection(&self) -> Option<&Rejection> {
        match self {
            Self::Exhausted(reason) | Self::Solutions { reason, .. } => reason.as_ref(),
            Self::NoForm | Self::NoScheme(_) | Self::OtherSheet(_) => None,
        }
    }

    /// The key of the stage by which an author may settle what numbers were rejected for, where there is one.
    #[must_use]
    pub fn settled_by(&self) -> Option<&'static str> {
        if let Some(Rejection::Condition { key, .. }) = self.rejection() { *key } else { None }
    }

    /// Another name that an author may write for what happens with these numbers, where there are words for it.
    #[must_use]
    pub fn way_out(&self) -> Option<&'static str> {
        if let Some(Rejection::Condition { reason, .. }) = self.rejection() { reason.way_out() } else { None }
    }

    /// The names that an author may write for such numbers.
    #[must_use]
    pub fn help(&self) -> String {
        let key = self.settled_by().map(|key| format!("`{key}` in that stage"));
        if let Some(out) = self.way_out() {
            return key.map_or_else(|| out.to_owned(), |key| format!("if it is meant so, write {key}: {out}"));
        }
        let allowed = self.allowed_by().map(|name| format!("`allow: [{name}]`"));
        let meant: Vec<String> = [key, allowed].into_iter().flatten().collect();
        if meant.is_empty() {
            return "give fewer or other values".to_owned();
        }
        format!("give other values; if it is meant so, write {}", meant.join(", or "))
    }

    /// The name under which an author may allow what numbers were rejected for, where there is one.
    #[must_use]
    pub fn allowed_by(&self) -> Option<&'static str> {
        let Rejection::Condition { reason, .. } = self.rejection()? else { return None };
        let warning = reason.warning()?;
        Warning::NAMES.iter().find(|(_, listed)| *listed == warning).map(|(name, _)| *name)
    }
}

fn because(reason: Option<&Rejection>) -> String {
    reason.map_or_else(String::new, |reason| format!(": {reason}"))
}

fn within(stage: Option<&str>) -> String {
    stage.map_or_else(String::new, |stage| format!("in {stage}, "))
}

fn for_what(names: &[String]) -> String {
    if names.is_empty() { String::new() } else { format!(" for {}", names.join(", ")) }
}

fn words<'a>(words: &'a str, otherwise: &'a str) -> &'a str {
    if words.is_empty() { otherwise } else { words }
}

fn among(names: &[String]) -> String {
    if names.is_empty() { String::new() } else { format!(": {}", names.join(", ")) }
}
