//! Values that the givens of a form have together: formulas are compared near them, where the scene goes the same way.

use std::sync::Arc;

use momentous_expr::Symbol;

use super::super::compiling::on_demand::Sample;
use super::super::language::known::Origin;
use super::sampler::Sampler;
use super::variant::Worked;

/// The number of variants wanted.
const WANTED: usize = 16;
/// The number of seeds tried, for some variants go another way.
const TRIED: u64 = 64;

impl Worked<'_> {
    /// Values that these givens have together in variants that go the way of this one.
    #[must_use]
    pub fn samples(&self, givens: &[Symbol]) -> Arc<[Sample]> {
        let key = (self.variant.leaf(), self.variant.roots().to_vec(), givens.to_vec());
        let samples = &self.form.samples.0;
        if let Some(known) = samples.read().ok().and_then(|known| known.get(&key).cloned()) {
            return known;
        }
        let drawn = self.drawn(givens);
        if let Ok(mut known) = samples.write() {
            known.insert(key, Arc::clone(&drawn));
        }
        drawn
    }

    fn drawn(&self, givens: &[Symbol]) -> Arc<[Sample]> {
        let Ok(mut sampler) = Sampler::new(self.problem, self.variant.form()) else { return Arc::default() };
        let any = |symbol: Symbol| {
            let known = self.form.known.iter().find(|known| known.symbol == symbol);
            known.is_some_and(|known| matches!(known.origin, Origin::Any))
        };
        let variants = (1..=TRIED).map_while(|seed| sampler.variant(seed).ok());
        let same =
            variants.filter(|variant| variant.leaf() == self.variant.leaf() && variant.roots() == self.variant.roots());
        let value = |symbol: &Symbol, variant: &super::super::Variant| {
            variant.value(*symbol).filter(|_| !any(*symbol)).map(|number| number.value)
        };
        same.take(WANTED).map(|variant| givens.iter().map(|symbol| value(symbol, &variant)).collect()).collect()
    }
}
