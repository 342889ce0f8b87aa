//! The balance of a body: momentum before + impulses = momentum after, and what follows of it that was not solved.

use momentous_problem::Picture;
use momentous_problem::Shows;

use super::quantities::Quantities;
use super::vectors::Labelled;

/// One body in one stage, along x and y of the scene.
#[derive(Clone, Debug)]
pub(super) struct Balance {
    pub body: String,
    pub before: Labelled,
    pub impulses: Vec<Labelled>,
    pub after: Labelled,
}

/// Completes a plan that is no longer than needed: the last unknown of each body follows from the others, and the impulse on one
/// of two bodies from that on the other.
pub(super) fn complete(balances: &mut [Balance], act_on_each_other: bool) {
    balances.iter_mut().for_each(Balance::complete);
    if let (true, [first, second]) = (act_on_each_other, &mut *balances) {
        second.take_reaction(first);
        first.take_reaction(second);
        balances.iter_mut().for_each(Balance::complete);
    }
}

impl Balance {
    fn vectors(&mut self) -> Vec<(f64, &mut Option<[f64; 2]>)> {
        let impulses = self.impulses.iter_mut().map(|impulse| (1.0, &mut impulse.value));
        let ends = [(1.0, &mut self.before.value), (-1.0, &mut self.after.value)];
        ends.into_iter().chain(impulses).collect()
    }

    /// The one vector that is missing; momentum before + impulses - momentum after = 0.
    fn complete(&mut self) {
        let mut vectors = self.vectors();
        let sum = vectors.iter().filter_map(|(sign, value)| Some((*sign, (**value)?)));
        let [x, y] = sum.fold([0.0, 0.0], |[x, y], (sign, value)| [x + sign * value[0], y + sign * value[1]]);
        let mut missing = vectors.iter_mut().filter(|(_, value)| value.is_none());
        if let (Some((sign, value)), None) = (missing.next(), missing.next()) {
            **value = Some([-*sign * x, -*sign * y]);
        }
    }

    /// Has the arrows of a picture.
    pub(super) fn take(&mut self, quantities: &Quantities<'_>, picture: &Picture) {
        let Shows::Diagram(rows) = &picture.shows else { return };
        let Some(row) = rows.iter().find(|row| row.body == self.body) else { return };
        self.before.value = quantities.along_axes(&row.before);
        self.after.value = quantities.along_axes(&row.after);
        for impulse in &mut self.impulses {
            impulse.value = quantities.along_axes(&row.impulse);
        }
    }

    fn take_reaction(&mut self, other: &Self) {
        // The first impulse is the one that the two give each other; a guide may add another.
        if let ([one, ..], [other, ..]) = (&mut self.impulses[..], &other.impulses[..]) {
            one.value = one.value.or(other.value.map(|[x, y]| [-x, -y]));
        }
    }

    /// Momenta and impulses, in their order.
    pub(super) fn all(&self) -> impl Iterator<Item = &Labelled> {
        [&self.before, &self.after].into_iter().chain(&self.impulses)
    }
}
