//! Saying what a model leaves out: once, with all stages in which it is left out.

use super::builder::Builder;
use super::instance::Omission;
use super::instance::Omitted;

impl Builder<'_> {
    /// Says, once, what is small or idealised away.
    pub(super) fn neglect(&mut self, what: impl Into<String>, why: impl Into<String>) {
        self.omit(Omitted::Neglected, what.into(), why.into());
    }

    /// Says, once, what acts or happens but has no part in what is asked.
    pub(super) fn not_needed(&mut self, what: impl Into<String>, why: impl Into<String>) {
        self.omit(Omitted::NotNeeded, what.into(), why.into());
    }

    fn omit(&mut self, kind: Omitted, what: String, why: String) {
        let stage = self.begins.saturating_sub(1);
        let known = self
            .omissions
            .iter_mut()
            .find(|omission| (omission.kind, &omission.what, &omission.why) == (kind, &what, &why));
        match known {
            Some(omission) => {
                omission.stages.insert(stage);
            }
            None => self.omissions.push(Omission { kind, what, why, stages: [stage].into() }),
        }
    }
}
