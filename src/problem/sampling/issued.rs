//! A sheet that was handed out: the variant with the numbers that stand on it, whatever the problem draws now.

use momentous_expr::Symbol;
use momentous_quantity::Decimal;
use momentous_quantity::Unit;

use super::super::language::known::Origin;
use super::super::questions::part::PartKind;
use super::no_variant::NoVariant;
use super::sampler::Sampler;
use super::stream::Scheme;
use super::variant::Variant;

/// A quantity with its value as it is printed.
pub type PrintedNumber = (Symbol, Decimal, Unit);

impl Sampler<'_> {
    /// The variant of a seed with the numbers of its sheet. The problem may have got other ranges meanwhile.
    ///
    /// # Errors
    /// [`NoVariant::OtherSheet`] where the problem tells other quantities than the sheet, or fixes another value, and
    /// [`NoVariant::Solutions`] where the numbers leave no admissible solution, or several.
    pub fn issued(&mut self, seed: u64, scheme: Scheme, sheet: &[PrintedNumber]) -> Result<Variant, NoVariant> {
        if let Ok(drawn) = self.variant_by(seed, scheme)
            && drawn.all_given().iter().all(|drawn_number| sheet.iter().any(|number| are_same(number, drawn_number)))
            && sheet.len() == drawn.all_given().len()
        {
            return Ok(drawn);
        }
        let told = self.told_with_fixed();
        let other = |symbol: Symbol| NoVariant::OtherSheet(self.problem.model().symbols.entry(symbol).name.clone());
        if let Some((gone, ..)) =
            sheet.iter().find(|(symbol, ..)| !told.iter().any(|(told_symbol, _)| told_symbol == symbol))
        {
            return Err(other(*gone));
        }
        let mut free = Vec::new();
        for (symbol, fixed) in told {
            match (sheet.iter().find(|(listed, ..)| *listed == symbol), fixed) {
                (Some(number), None) => free.push(number.clone()),
                (Some(number), Some(fixed)) if are_same(number, &fixed) => {}
                _ => return Err(other(symbol)),
            }
        }
        // A choice may be decided by what the sheet conceals.
        let chooses = self.form.parts.iter().any(|part| matches!(part.kind, PartKind::Choice(_)));
        if let (Some(reveal), true) = (self.form.reveal.first(), chooses) {
            return Err(other(reveal.symbol));
        }
        let variant = self.with_values(seed, &free)?;
        Ok(Variant { scheme, seed: Some(seed), ..variant })
    }

    /// Every quantity that a sheet tells, with its value where no seed changes it.
    fn told_with_fixed(&self) -> Vec<(Symbol, Option<PrintedNumber>)> {
        let known = self.told.iter().filter_map(|(_, known)| match &known.origin {
            Origin::Drawn(_) => Some((known.symbol, None)),
            Origin::Fixed(value) => Some((known.symbol, Some((known.symbol, value.clone(), known.unit.clone())))),
            Origin::Any => None,
        });
        let reveals = self.form.reveal.iter().map(|reveal| (reveal.symbol, None));
        let literals = self
            .problem
            .model()
            .literals
            .iter()
            .map(|(symbol, quantity)| (*symbol, Some((*symbol, quantity.value.clone(), quantity.unit.clone()))));
        known.chain(reveals).chain(literals).collect()
    }
}

/// Whether two numbers are one, however many zeros are written: `1.30e20` and `130000000000000000000`.
fn are_same(one: &PrintedNumber, other: &PrintedNumber) -> bool {
    (one.0, &one.2) == (other.0, &other.2) && one.1.compare(&other.1).is_eq()
}
