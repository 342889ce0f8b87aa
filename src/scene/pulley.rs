//! Which way a string over a pulley leads down.

use super::{Scene, Stage};

impl Scene {
    /// Whether a body that falls in a stage moves along the string (1) or back along it (-1), where velocities are counted along the string
    /// over a pulley on which it hangs later: the string leads down to the second of two bodies, and up from the first.
    #[must_use]
    pub fn sinks(&self, stage: usize, body: &str) -> Option<i64> {
        self.stages.iter().skip(stage + 1).find_map(|stage| {
            let ends = if let Stage::Taut(taut) = stage {
                taut.over.as_ref()?;
                taut.between.as_ref()?.each_ref().map(String::as_str)
            } else if let Stage::Connected(connected) = stage {
                [&connected.trailing.body, &connected.leading.body].map(String::as_str)
            } else {
                return None;
            };
            ends.iter().position(|end| *end == body).map(|end| if end == 1 { 1 } else { -1 })
        })
    }
}
