//! Which way something acts that may change in time, and the moments of which a figure may show that.

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_figure::Moment;
use momentous_scene::Strength;
use momentous_scene::Term;
use momentous_scene::stage::During;

use super::quantities::Quantities;

/// At so many instants it is looked at, up to its end, or for a brief time in s where nobody may know the end.
const INSTANTS: u8 = 32;
const BRIEF: f64 = 1e-3;
/// The share of the greatest value below which a value counts as zero.
const ZERO: f64 = 1e-9;

impl Quantities<'_> {
    /// When something begins, and when it ends as far as that may be told.
    pub(super) fn ends(&self, during: Option<&During>) -> Option<(f64, Option<f64>)> {
        let number = |term: &Term| self.evaluate(&self.term(term)?);
        match during {
            Some(During::For(end)) => Some((0.0, number(end))),
            Some(During::Between([start, end])) => Some((number(start)?, number(end))),
            None => Some((0.0, None)),
        }
    }

    /// A value with the sign that a term has all the time; none where it turns round, or may not be known.
    pub(super) fn sense(&self, term: &Expr, (start, end): (f64, Option<f64>)) -> Option<f64> {
        let Some(clock) = self.model().symbols.find("t").filter(|clock| term.contains(*clock)) else {
            return self.evaluate(term);
        };
        let step = end.map_or(BRIEF, |end| end - start) / f64::from(INSTANTS);
        let at = |instant: u8| {
            let time = start + step * f64::from(instant);
            let known = |symbol| if symbol == clock { Some(time) } else { self.value(symbol) };
            term.evaluate(&|symbol| known(symbol).unwrap_or(f64::NAN))
        };
        let values: Vec<f64> = (0..=INSTANTS).map(at).collect();
        let least = values.iter().copied().fold(0.0, f64::min);
        let greatest = values.iter().copied().fold(0.0, f64::max);
        let small = ZERO * greatest.max(-least);
        let told = values.iter().all(|value| value.is_finite());
        match (least < -small, greatest > small) {
            (true, false) if told => Some(least),
            (false, true) if told => Some(greatest),
            _ => None,
        }
    }
}

/// The moment on an arm, where all of it is given; one that changes is shown where it turns one way all the time, one that is
/// asked for in the sense in which it counts.
pub(super) fn given_moment(
    quantities: &Quantities<'_>,
    strength: &Strength,
    during: Option<&During>,
) -> Option<Moment> {
    let Strength::Term(term) = strength else { return None };
    let term = quantities.term(term)?;
    if let Some(label) = quantities.asked(&term) {
        return Some(Moment { label, value: 1.0 });
    }
    let value = quantities.sense(&term, quantities.ends(during)?)?;
    let changes = quantities.model().symbols.find("t").is_some_and(|clock| term.contains(clock));
    let label = if changes { Math::Identifier("M".to_owned()) } else { quantities.unsigned(&term) };
    Some(Moment { label, value })
}
