//! Why a method does not treat a scene. A refusal has a name; it stands where a number that nobody could stand behind would.

/// The names of the laws that can be chosen for simultaneous impacts, as a message offers them.
const LAWS_FOR_SIMULTANEOUS_IMPACTS: &str = "Newton's law at every contact at once, or one pair after another";

/// Why there is no result.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Refusal {
    /// Contacts that share a body are struck at the same instant, and no law was chosen for that.
    #[error("law required: simultaneous impact of {} (choose: {LAWS_FOR_SIMULTANEOUS_IMPACTS})", contacts.join(" and "))]
    LawRequired {
        /// The contacts.
        contacts: Vec<String>,
    },
    /// Bodies that lose energy in every impact hit each other infinitely often in a finite time.
    #[error("inelastic collapse: the impacts of {} accumulate at t = {time} s", contacts.join(" and "))]
    Collapse {
        /// The contacts that are struck again and again.
        contacts: Vec<String>,
        /// When, in s.
        time: f64,
    },
    /// Bodies stay in contact and press on each other, which is no impact.
    #[error("lasting contact of {contact} from t = {time} s on: this method handles only impacts")]
    LastingContact {
        /// The contact.
        contact: String,
        /// Since when, in s.
        time: f64,
    },
    /// The motion between impacts is not known exactly.
    #[error("no exact motion under {force}")]
    NoExactMotion {
        /// The force.
        force: String,
    },
    /// The contacts are not known before the run.
    #[error("no formula for the whole run: bodies may meet")]
    NoFormula,
    /// The method solves the impact of bodies that touch, and none do.
    #[error("nothing touches: this method solves only the impact itself, not the motion before it")]
    NothingTouches,
    /// Bodies are inside each other, or further apart than their cord is long.
    #[error("overlap of {contact}: bodies are inside each other, or a cord is too short")]
    Overlap {
        /// The contact.
        contact: String,
    },
    /// The step is too long for the stiffness of the contact.
    #[error("unstable: step times frequency of the contact is {product}, and must be below 2")]
    Unstable {
        /// The product of the step and the natural frequency.
        product: f64,
    },
    /// A spring and a dashpot cannot make this coefficient of restitution.
    #[error("no calibration: a spring and a dashpot cannot reproduce e = {restitution}")]
    NoCalibration {
        /// The coefficient.
        restitution: f64,
    },
    /// No motion agrees with friction at the contact (Painlevé's paradox).
    #[error("jamming: friction presses the contact together faster than it can separate, and no motion is consistent")]
    Jamming,
    /// A rule would create energy.
    #[error("energy gain: {rule} would create {gain} J")]
    EnergyGain {
        /// The rule.
        rule: String,
        /// The energy, in J.
        gain: f64,
    },
    /// A number ran out of its range, or a step became too small to be taken.
    #[error("breakdown at t = {time} s: {what}")]
    Breakdown {
        /// When, in s.
        time: f64,
        /// The event.
        what: String,
    },
    /// The numbers make no scene.
    #[error("no scene: {what}")]
    Invalid {
        /// The fault.
        what: String,
    },
}

impl Refusal {
    /// Whether it is about the scene, which has no answer, or more than one: no other method can have a right one.
    #[must_use]
    pub fn is_of_the_scene(&self) -> bool {
        match self {
            Self::LawRequired { .. }
            | Self::Collapse { .. }
            | Self::Overlap { .. }
            | Self::Jamming
            | Self::EnergyGain { .. }
            | Self::Invalid { .. } => true,
            Self::LastingContact { .. }
            | Self::NoExactMotion { .. }
            | Self::NoFormula
            | Self::NothingTouches
            | Self::Unstable { .. }
            | Self::NoCalibration { .. }
            | Self::Breakdown { .. } => false,
        }
    }

    /// The name of the refusal, as tables print it.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::LawRequired { .. } => "law required",
            Self::Collapse { .. } => "inelastic collapse",
            Self::LastingContact { .. } => "lasting contact",
            Self::NoExactMotion { .. } => "no exact motion",
            Self::NoFormula => "no formula",
            Self::NothingTouches => "nothing touches",
            Self::Overlap { .. } => "overlap",
            Self::Unstable { .. } => "unstable",
            Self::NoCalibration { .. } => "no calibration",
            Self::Jamming => "jamming",
            Self::EnergyGain { .. } => "energy gain",
            Self::Breakdown { .. } => "breakdown",
            Self::Invalid { .. } => "no scene",
        }
    }
}
