//! The impact of two bodies, and what they do before and after it.

use serde::Serialize;

use super::{Amount, Phase};

/// The impact.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Meeting {
    /// When, from the start of what is shown.
    pub time: Amount,
    /// The impulse on B; that on A is its opposite.
    pub impulse: Amount,
}

/// The phases of the bodies' motion until the end of what is shown.
pub(super) fn phases(meeting: Option<&Meeting>, end: f64) -> Vec<Phase> {
    match meeting {
        None => vec![Phase { until: end, words: "no impact" }],
        Some(meeting) => {
            let (time, contact) = (meeting.time.value, 0.01 * end);
            vec![
                Phase { until: time - contact, words: "approaching" },
                Phase { until: time + contact, words: "contact" },
                Phase { until: end, words: "separating" },
            ]
        }
    }
}
