//! Pictures to choose from: the right one, and those that usual mistakes lead to.

use std::collections::BTreeSet;

use crate::expr::Expr;
use crate::expr::Symbol;
use crate::laws::wrong::Misconception;
use crate::laws::wrong::concept;
use crate::laws::wrong::momentum;

use super::super::sampling::variant::Worked;
use super::decision::Decision;
use super::decision::OptionFeedback;
use super::offered::shuffled;

/// A choice between impulse-momentum diagrams of one stage.
#[derive(Clone, Debug)]
pub struct Pictured {
    /// The name of the random stream from which their order comes.
    pub(in crate::problem) stream: String,
    /// The stage, counted from 0.
    pub stage: usize,
    /// The bodies of the diagram.
    pub(in crate::problem) rows: Vec<Ends>,
    /// What has to be solved.
    pub(in crate::problem) quantities: Vec<Symbol>,
}

/// The momenta of a body at both ends of the stage, along each axis.
#[derive(Clone, Debug)]
pub(in crate::problem) struct Ends {
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

/// A picture that is offered.
#[derive(Clone, Debug)]
pub struct Picture {
    /// What it is called: `diagram A`.
    pub name: String,
    /// What it shows.
    pub rows: Vec<Balance>,
    /// The mistake that leads to it; none of the right one.
    pub mistake: Option<&'static Misconception>,
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

/// How many pictures are offered at most, and at least.
const OFFERED: [usize; 2] = [4, 3];

/// Two arrows that differ by less than this share of the longest arrow look alike.
const ALIKE: f64 = 0.2;

impl Pictured {
    /// Everything on which the pictures depend.
    pub(in crate::problem) fn symbols(&self) -> BTreeSet<Symbol> {
        self.rows.iter().flat_map(|row| row.before.iter().chain(&row.after)).flat_map(Expr::symbols).collect()
    }

    /// The pictures, in the order in which they are offered.
    #[must_use]
    pub fn pictures(&self, worked: &Worked<'_>) -> Vec<Picture> {
        let found = self.found(worked);
        let order = shuffled(worked, &self.stream, found.len());
        let own = order.into_iter().filter_map(|place| found.get(place));
        let named = own.zip('A'..='Z').map(|((mistake, rows), letter)| Picture {
            name: format!("diagram {letter}"),
            rows: rows.clone(),
            mistake: *mistake,
        });
        named.collect()
    }

    /// The right picture, and wrong ones that look different from it and from each other.
    fn found(&self, worked: &Worked<'_>) -> Vec<(Option<&'static Misconception>, Vec<Balance>)> {
        let [most, _] = OFFERED;
        let right: Vec<Balance> = self.rows.iter().map(|row| Balance::of(row, worked)).collect();
        let mut found = vec![(None, right.clone())];
        for (mistake, change) in WRONG {
            let mut rows = right.clone();
            change(&mut rows);
            if found.len() < most && !found.iter().any(|(_, other)| looks_like(&rows, other)) {
                found.push((Some(mistake), rows));
            }
        }
        found
    }

    /// Why the pictures cannot be offered with the numbers of a variant.
    pub(in crate::problem) fn refused(&self, worked: &Worked<'_>) -> Option<String> {
        let found = self.found(worked);
        let [_, least] = OFFERED;
        let is_drawn =
            found.iter().flat_map(|(_, rows)| rows).flat_map(Balance::arrows).flatten().all(|own| own.is_finite());
        (found.len() < least || !is_drawn).then(|| "the diagrams of usual mistakes look like the right one".to_owned())
    }

    pub(in crate::problem) fn decided(&self, worked: &Worked<'_>) -> Decision {
        let pictures = self.pictures(worked);
        let third_law = if self.rows.len() == 2 { ", so the two impulses are equal and opposite" } else { "" };
        Decision {
            right: pictures.iter().position(|own| own.mistake.is_none()).unwrap_or(0),
            because: format!(
                "each momentum is the mass times the velocity found above, and each impulse is the momentum after minus the momentum before{third_law}"
            ),
            behind: None,
            feedback: pictures
                .iter()
                .map(|own| own.mistake.map_or(OptionFeedback::Nothing, OptionFeedback::Mistake))
                .collect(),
            options: pictures.into_iter().map(|own| own.name).collect(),
        }
    }
}

impl Balance {
    fn of(ends: &Ends, worked: &Worked<'_>) -> Self {
        let value = |symbol| worked.variant.value(symbol).map_or(f64::NAN, |own| own.value);
        let [before, after] =
            [&ends.before, &ends.after].map(|own| own.iter().map(|part| part.evaluate(&value)).collect::<Vec<f64>>());
        let impulse = after.iter().zip(&before).map(|(after, before)| after - before).collect();
        Self { body: ends.body.clone(), before, impulse, after }
    }

    fn arrows(&self) -> [&[f64]; 3] {
        [&self.before, &self.impulse, &self.after]
    }

    /// What moves back is drawn as if it moved on, and the impulse is the difference of the lengths.
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
fn looks_like(one: &[Balance], other: &[Balance]) -> bool {
    let arrows = |rows: &[Balance]| rows.iter().flat_map(Balance::arrows).map(<[f64]>::to_vec).collect::<Vec<_>>();
    let length = |arrow: &Vec<f64>| libm::sqrt(arrow.iter().map(|part| part * part).sum());
    let (one, other) = (arrows(one), arrows(other));
    let [first, second] = [&one, &other].map(|all| all.iter().map(length).fold(f64::MIN_POSITIVE, f64::max));
    one.iter().zip(&other).all(|(one, other)| {
        let apart = one.iter().zip(other).map(|(one, other)| one / first - other / second).collect();
        length(&apart) < ALIKE
    })
}
