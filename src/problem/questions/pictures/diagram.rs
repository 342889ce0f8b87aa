//! Impulse-momentum diagrams to choose from.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_laws::wrong::Misconception;
use momentous_laws::wrong::concept;
use momentous_laws::wrong::momentum;

/// The impulse-momentum diagram of a stage.
#[derive(Clone, Debug)]
pub struct Diagram {
    /// The stage, counted from 0.
    pub stage: usize,
    /// The bodies of the diagram.
    pub(crate) rows: Vec<Ends>,
}

/// The momenta of a body at both ends of the stage, along each axis.
#[derive(Clone, Debug)]
pub(crate) struct Ends {
    pub body: String,
    pub before: Vec<Expr>,
    pub after: Vec<Expr>,
}

/// The row of a body in a diagram, along each axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Balance {
    /// The short name of the body.
    pub body: String,
    /// Its momentum before.
    pub before: Vec<f64>,
    /// The impulse on it.
    pub impulse: Vec<f64>,
    /// Its momentum after.
    pub after: Vec<f64>,
}

/// A mistake, and what it makes of the rows of the right diagram.
type Wrong = (&'static Misconception, fn(&mut [Balance]));

/// The mistakes, those that teach most first.
const WRONG: [Wrong; 6] = [
    (&momentum::SIGN_LOST, |rows| rows.iter_mut().for_each(Balance::lose_sign)),
    (&momentum::IMPULSE_REVERSED, |rows| rows.iter_mut().for_each(|row| turn(&mut row.impulse))),
    (&momentum::START_FORGOTTEN, |rows| rows.iter_mut().for_each(|row| row.impulse.clone_from(&row.after))),
    (&momentum::SAME_SIGN, |rows| {
        if let [_, second] = rows {
            turn(&mut second.impulse);
        }
    }),
    (&concept::AFTER_REVERSED, |rows| rows.iter_mut().for_each(|row| turn(&mut row.after))),
    (&concept::MOMENTUM_KEPT, |rows| rows.iter_mut().for_each(|row| row.after.clone_from(&row.before))),
];

/// Two arrows that differ by less than this share of the longest arrow look alike.
const ALIKE: f64 = 0.2;

impl Diagram {
    /// The terms on which it depends.
    pub(crate) fn terms(&self) -> impl Iterator<Item = &Expr> {
        self.rows.iter().flat_map(|row| row.before.iter().chain(&row.after))
    }

    /// The right diagram, then those of the mistakes.
    pub(crate) fn drawn(&self, value: &dyn Fn(Symbol) -> f64) -> Vec<(Option<&'static Misconception>, Vec<Balance>)> {
        let right: Vec<Balance> = self.rows.iter().map(|row| Balance::of(row, value)).collect();
        let mistaken = WRONG.iter().map(|(mistake, change)| {
            let mut rows = right.clone();
            change(&mut rows);
            (Some(*mistake), rows)
        });
        std::iter::once((None, right.clone())).chain(mistaken).collect()
    }

    /// Why the right one is right, as a sentence without a full stop.
    pub(crate) fn because(&self) -> String {
        let third_law = if self.rows.len() == 2 { ", so the two impulses are equal and opposite" } else { "" };
        format!(
            "each momentum is the mass times the velocity found above, and each impulse is the momentum after minus the momentum before{third_law}"
        )
    }
}

impl Balance {
    fn of(ends: &Ends, value: &dyn Fn(Symbol) -> f64) -> Self {
        let [before, after] = [&ends.before, &ends.after]
            .map(|vector| vector.iter().map(|part| part.evaluate(value)).collect::<Vec<f64>>());
        let impulse = after.iter().zip(&before).map(|(after, before)| after - before).collect();
        Self { body: ends.body.clone(), before, impulse, after }
    }

    /// Whether all its arrows have a length.
    pub(crate) fn is_drawn(&self) -> bool {
        self.arrows().into_iter().flatten().all(|part| part.is_finite())
    }

    fn arrows(&self) -> [&[f64]; 3] {
        [&self.before, &self.impulse, &self.after]
    }

    /// A body that moves back is drawn as if it moved on, and the impulse is the difference of the lengths.
    fn lose_sign(&mut self) {
        let product =
            |left: &[f64], right: &[f64]| left.iter().zip(right).map(|(left, right)| left * right).sum::<f64>();
        let (along, length) = (product(&self.before, &self.after), product(&self.before, &self.before));
        if along < 0.0 {
            for (after, before) in self.after.iter_mut().zip(&self.before) {
                *after -= 2.0 * along / length * before;
            }
            for (place, impulse) in self.impulse.iter_mut().enumerate() {
                *impulse = self.after[place] - self.before[place];
            }
        }
    }
}

fn turn(arrow: &mut [f64]) {
    for part in arrow {
        *part = -*part;
    }
}

/// Whether two diagrams look alike, each drawn to its own scale.
pub(crate) fn looks_like(one: &[Balance], other: &[Balance]) -> bool {
    let arrows = |rows: &[Balance]| rows.iter().flat_map(Balance::arrows).map(<[f64]>::to_vec).collect::<Vec<_>>();
    let length = |arrow: &Vec<f64>| libm::sqrt(arrow.iter().map(|part| part * part).sum());
    let (one, other) = (arrows(one), arrows(other));
    let [first, second] = [&one, &other].map(|all| all.iter().map(length).fold(f64::MIN_POSITIVE, f64::max));
    one.iter().zip(&other).all(|(one, other)| {
        let apart = one.iter().zip(other).map(|(one, other)| one / first - other / second).collect();
        length(&apart) < ALIKE
    })
}
