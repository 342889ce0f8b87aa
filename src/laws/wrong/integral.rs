//! Mistakes about what adds up over time: one value for all of it, a part of the area under a graph.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_quantity::Dimension;
use momentous_quantity::Rational;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::rewrite::all_but_one;
use super::rewrite::one;

/// One value of a changing force.
pub const VALUE_TIMES_TIME: Misconception = Misconception {
    id: "value-times-time",
    does: "multiplies one value of what changes with time by the whole time",
    ask: "Does it have this value all the time? What does the graph against time look like?",
    hint: "The integral is the area under the curve: a rectangle only if the curve is level.",
};
/// The mean of first and last.
pub const ENDS_AVERAGED: Misconception = Misconception {
    id: "ends-averaged",
    does: "takes the mean of the first and the last value as the average over time",
    ask: "Is the graph against time a straight line?",
    hint: "The mean of the two end values is the average over time only for a straight line.",
};
/// The mean of zero and the peak.
pub const HALF_PEAK: Misconception = Misconception {
    id: "half-of-the-peak",
    does: "takes half of the peak as the average force",
    ask: "Which shape does the graph of the force have? Is it a triangle that begins and ends at zero?",
    hint: "Half of the peak is the average over time only if the graph is a triangle on the time axis.",
};
/// A part of the area under a graph.
pub const PART: Misconception = Misconception {
    id: "part-of-the-area",
    does: "counts only a part of the area under the graph of the force",
    ask: "From which moment to which does the force act? Which parts of the area under its graph have you counted?",
    hint: "Divide the area into pieces from the first moment to the last, and add all of them.",
};

/// A triangle as a rectangle.
pub const NOT_HALVED: Misconception = Misconception {
    id: "triangle-not-halved",
    does: "takes a triangle under the graph for the rectangle around it",
    ask: "Which shape has each part of the area under the graph? Which of them are triangles?",
    hint: "A triangle has half the area of the rectangle around it.",
};
/// An instant for a duration.
pub const INSTANT_FOR_DURATION: Misconception = Misconception {
    id: "instant-for-duration",
    does: "multiplies by an instant where a duration belongs",
    ask: "When does each part of the graph begin, and when does it end? How long does it last?",
    hint: "A duration is the difference of two instants.",
};

/// A value of what changes, times the whole time: that at the end, at the start, half-way, and where its pieces meet.
pub(super) fn value_times_time(law: &Taught<'_>) -> Vec<Wrong> {
    let Some(graph) = Graph::of(law) else { return Vec::new() };
    let [low, high] = graph.ends;
    let times = [high.clone(), low.clone(), graph.middle()].into_iter().chain(graph.corners());
    // Nobody takes a force for zero all the time.
    let values = times.map(|time| graph.at(&time).simplify()).filter(|value| !value.is_zero());
    values.map(|value| Wrong::from((law.left(), value * graph.duration()))).collect()
}

/// The mean of the values at both ends, times the time.
pub(super) fn ends_averaged(law: &Taught<'_>) -> Vec<Wrong> {
    let Some(graph) = Graph::of(law) else { return Vec::new() };
    let [low, high] = graph.ends;
    let mean = (Expr::ratio(1, 2) * (graph.at(low) + graph.at(high))).simplify();
    if mean.is_zero() {
        return Vec::new();
    }
    one((law.left(), mean * graph.duration()))
}

/// Half of a value where pieces meet, times the time; of a force that rises and falls in one piece, half of that half-way.
pub(super) fn half_peak(law: &Taught<'_>) -> Vec<Wrong> {
    let Some(graph) = Graph::of(law) else { return Vec::new() };
    let mut tops = graph.corners();
    if tops.is_empty() && graph.ends.iter().all(|end| graph.at(end).simplify().is_zero()) {
        tops.push(graph.middle());
    }
    let half = |time: &Expr| Expr::product([Expr::ratio(1, 2), graph.at(time), graph.duration()]);
    tops.iter().map(|time| Wrong::from((law.left(), half(time)))).collect()
}

/// Half of the area, as up to the middle of a graph that rises and falls alike; of a graph in pieces, each piece alone, and all without
/// one of them.
pub(super) fn part_of_the_area(law: &Taught<'_>) -> Vec<Wrong> {
    let Some(graph) = Graph::of(law) else { return Vec::new() };
    let pieces: Vec<Expr> = graph.pieces().iter().map(Piece::area).collect();
    if pieces.len() < 2 {
        return one((law.left(), Expr::ratio(1, 2) * law.right()));
    }
    let without_one = if pieces.len() > 2 { all_but_one(&Expr::Sum(pieces.clone().into())) } else { Vec::new() };
    pieces.into_iter().chain(without_one).map(|part| Wrong::from((law.left(), part))).collect()
}

/// The triangles under a graph in pieces taken for rectangles: all of them, and each alone.
pub(super) fn not_halved(law: &Taught<'_>) -> Vec<Wrong> {
    altered_pieces(law, &|piece| {
        let ends = [piece.first.is_zero(), piece.last.is_zero()];
        (ends[0] != ends[1]).then(|| (piece.first.clone() + piece.last.clone()) * piece.duration())
    })
}

/// The instants at which the pieces of a graph end taken for their durations.
pub(super) fn instant_for_duration(law: &Taught<'_>) -> Vec<Wrong> {
    let mut ways = altered_pieces(law, &|piece| (!piece.from.is_zero()).then(|| piece.mean() * piece.to.clone()));
    ways.truncate(1);
    ways
}

/// The area under a graph in pieces with another one in the place of some of them: of all of these, and of each alone.
fn altered_pieces(law: &Taught<'_>, other: &dyn Fn(&Piece) -> Option<Expr>) -> Vec<Wrong> {
    let Some(graph) = Graph::of(law) else { return Vec::new() };
    let pieces = graph.pieces();
    let others: Vec<Option<Expr>> = pieces.iter().map(other).collect();
    let altered: Vec<usize> = (0..pieces.len()).filter(|place| others[*place].is_some()).collect();
    if pieces.len() < 2 || altered.is_empty() {
        return Vec::new();
    }
    let area = |is_altered: &dyn Fn(usize) -> bool| {
        let areas = pieces.iter().zip(&others).enumerate();
        Expr::sum(areas.map(|(place, (piece, other))| match other {
            Some(other) if is_altered(place) => other.clone(),
            _ => piece.area(),
        }))
    };
    let alone = altered.iter().filter(|_| altered.len() > 1);
    let each = alone.map(|chosen| area(&|place| place == *chosen));
    std::iter::once(area(&|_| true)).chain(each).map(|sum| Wrong::from((law.left(), sum))).collect()
}

/// A piece of a graph, as if its ends were joined by a line.
struct Piece {
    from: Expr,
    to: Expr,
    first: Expr,
    last: Expr,
}

impl Piece {
    fn duration(&self) -> Expr {
        self.to.clone() - self.from.clone()
    }

    fn mean(&self) -> Expr {
        (Expr::ratio(1, 2) * (self.first.clone() + self.last.clone())).simplify()
    }

    fn area(&self) -> Expr {
        self.mean() * self.duration()
    }
}

/// What changes, against time or position.
struct Graph<'a> {
    value: &'a Expr,
    variable: Symbol,
    ends: [&'a Expr; 2],
}

impl<'a> Graph<'a> {
    fn of(law: &Taught<'a>) -> Option<Self> {
        law.integral.map(|(value, variable, ends)| Self { value, variable, ends })
    }

    fn at(&self, time: &Expr) -> Expr {
        self.value.substitute(&|symbol| (symbol == self.variable).then(|| time.clone()))
    }

    fn duration(&self) -> Expr {
        let [low, high] = self.ends;
        high.clone() - low.clone()
    }

    fn middle(&self) -> Expr {
        let [low, high] = self.ends;
        Expr::ratio(1, 2) * (low.clone() + high.clone())
    }

    /// Its pieces in order; one where it has no corner.
    fn pieces(&self) -> Vec<Piece> {
        let [low, high] = self.ends;
        let ends: Vec<Expr> = std::iter::once(low.clone()).chain(self.corners()).chain([high.clone()]).collect();
        let piece = |ends: &[Expr]| match ends {
            [from, to] => Some(Piece {
                from: from.clone(),
                to: to.clone(),
                first: self.at(from).simplify(),
                last: self.at(to).simplify(),
            }),
            _ => None,
        };
        ends.windows(2).filter_map(piece).collect()
    }

    /// The places at which one piece ends and another begins.
    fn corners(&self) -> Vec<Expr> {
        fn collect(term: &Expr, found: &mut Vec<Expr>) {
            if let Expr::Piecewise(own) = term {
                found.extend(own.pieces.iter().filter_map(|(until, _)| until.clone()));
            }
            term.children().for_each(|part| collect(part, found));
        }
        let mut found = Vec::new();
        collect(self.value, &mut found);
        found.retain(|time| !self.ends.contains(&time));
        found
    }
}

/// What grows by a given rate counts with its value at the end: `F_0 T + k T^2` for `F_0 T + k T^2/2`.
pub(super) fn growth_not_halved(law: &Taught<'_>) -> Vec<Wrong> {
    fn at_the_end(law: &Taught<'_>, term: &Expr) -> Expr {
        let rates = [Dimension::new(1, 1, -3), Dimension::new(1, 1, -4), Dimension::new(1, 2, -3)];
        match term {
            Expr::Product(parts) if rates.iter().any(|rate| parts.iter().any(|factor| is_of(law, factor, *rate))) => {
                Expr::product(parts.iter().filter(|part| !is_share(part)).cloned())
            }
            other => other.map_children(|part| at_the_end(law, part)),
        }
    }
    law.both(|side| at_the_end(law, side))
}

/// Whether a factor is a quantity of that dimension by itself.
fn is_of(law: &Taught<'_>, factor: &Expr, dimension: Dimension) -> bool {
    matches!(factor, Expr::Symbol(symbol) if law.is(*symbol, dimension))
}

/// Whether a factor is a number between zero and one: that of an integral.
fn is_share(factor: &Expr) -> bool {
    matches!(factor, Expr::Number(number) if (Rational::ZERO..Rational::ONE).contains(number))
}
