//! What a variant leaves out, as a share of what it keeps.

use crate::model::ContactWeight;

use super::variant::Worked;

/// From this share on, what is left out is worth a word.
const WORTH_SAYING: f64 = 0.02;

impl<'a> Worked<'a> {
    /// The weights that short contacts leave out, each with its impulse as a share of the change of momentum, where that is
    /// worth a word.
    #[must_use]
    pub fn neglected(&self) -> Vec<(&'a ContactWeight, f64)> {
        let value = |symbol| self.variant.value(symbol).map_or(f64::NAN, |own| own.value);
        let weights = self.problem.model().weights.iter().filter(|weight| !weight.included);
        let shares = weights.map(|weight| (weight, weight.share(&|term| term.evaluate(&value))));
        shares.filter(|(_, share)| *share >= WORTH_SAYING && share.is_finite()).collect()
    }
}
