//! Variants drawn: one by itself, or many of one form, one after the other.

use std::sync::Arc;

use momentous_problem::NoVariant;
use momentous_problem::Problem;
use momentous_problem::Sampler;
use momentous_problem::Scheme;

use super::Exercise;
use super::sheet_numbers::SheetNumbers;

/// Draws variants of one form with memory of its own, which is faster than drawing each by itself; each thread takes its own.
///
/// ```
/// use std::sync::Arc;
/// use momentous_bank::Bank;
/// use momentous_exercise::{Drawer, Exercise};
/// use momentous_problem::{compile, load};
///
/// let source = Bank::built_in().find("impact/two-carts")?.clone();
/// let problem = Arc::new(compile(load(source)?, None)?);
/// let mut drawer = Drawer::new(&problem, 0)?;
/// let alone = Exercise::draw(&problem, 0, 7)?;
/// assert_eq!(drawer.draw(7)?.record(None), alone.record(None));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Drawer<'p> {
    problem: &'p Arc<Problem>,
    sampler: Sampler<'p>,
}

impl<'p> Drawer<'p> {
    /// A drawer for the form at that position.
    ///
    /// # Errors
    /// [`NoVariant::NoForm`] where there is none.
    pub fn new(problem: &'p Arc<Problem>, form: usize) -> Result<Self, NoVariant> {
        Ok(Self { problem, sampler: Sampler::new(problem, form)? })
    }

    /// The variant of a seed.
    ///
    /// # Errors
    /// [`NoVariant`] where the seed has no admissible numbers.
    pub fn draw(&mut self, seed: u64) -> Result<Exercise, NoVariant> {
        self.draw_by(seed, Scheme::default())
    }

    /// The variant of a seed as it was drawn by a version of the program.
    ///
    /// # Errors
    /// [`NoVariant`] where the seed has no admissible numbers.
    pub fn draw_by(&mut self, seed: u64, scheme: Scheme) -> Result<Exercise, NoVariant> {
        Ok(Exercise { problem: Arc::clone(self.problem), variant: self.sampler.variant_by(seed, scheme)? })
    }

    /// The variant of a sheet that was handed out, with the numbers that stand on it: the problem may have got other ranges since.
    ///
    /// # Errors
    /// [`NoVariant`] where the numbers cannot be those of the problem as it is now.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use momentous_bank::Bank;
    /// use momentous_exercise::Drawer;
    /// use momentous_fault::Source;
    /// use momentous_problem::{Scheme, compile, load};
    /// let file = Bank::built_in().find("impact/two-carts")?.clone();
    /// let wider = Source::new("carts.yaml", &file.text.replace("m_B: { min: 1, max: 6", "m_B: { min: 1, max: 9"));
    /// let [before, now] = [Arc::new(compile(load(file)?, None)?), Arc::new(compile(load(wider)?, None)?)];
    /// let handed_out = Drawer::new(&before, 0)?.draw(7)?;
    /// let again = Drawer::new(&now, 0)?.issued(7, Scheme::default(), &handed_out.sheet_numbers())?;
    /// assert_eq!(again.sheet_numbers(), handed_out.sheet_numbers());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn issued(&mut self, seed: u64, scheme: Scheme, sheet: &SheetNumbers) -> Result<Exercise, NoVariant> {
        let printed = sheet.printed(self.problem)?;
        Ok(Exercise { problem: Arc::clone(self.problem), variant: self.sampler.issued(seed, scheme, &printed)? })
    }
}

impl Exercise {
    /// Draws the numbers of a seed and solves them.
    ///
    /// # Errors
    /// [`NoVariant`] where the seed has no admissible numbers.
    pub fn draw(problem: &Arc<Problem>, form: usize, seed: u64) -> Result<Self, NoVariant> {
        Drawer::new(problem, form)?.draw(seed)
    }
}
