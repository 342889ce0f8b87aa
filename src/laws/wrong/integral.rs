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
/// Two thirds of the peak.
pub const PARABOLA: Misconception = Misconception {
    id: "two-thirds-of-the-peak",
    does: "takes two thirds of the peak as the average, as for a parabola",
    ask: "Which shape does the graph have: a parabola, or straight lines?",
    hint: "Two thirds of the peak is the average over time of a parabola that begins and ends at zero.",
};
/// A growth that never ends.
pub const FIRST_PIECE: Misconception = Misconception {
    id: "first-piece-all-the-time",
    does: "lets the force go on as it begins, although its graph has a corner",
    ask: "Does the force go on growing until the end? What happens at the corner of its graph?",
    hint: "Each part of the graph has a formula of its own, which holds from its first moment to its last.",
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

/// Two thirds of a value where pieces meet, times the time.
pub(super) fn two_thirds_of_peak(law: &Taught<'_>) -> Vec<Wrong> {
    let Some(graph) = Graph::of(law) else { return Vec::new() };
    let share = |time: &Expr| Expr::product([Expr::ratio(2, 3), graph.at(time), graph.duration()]);
    graph.corners().iter().map(|time| Wrong::from((law.left(), share(time)))).collect()
}

/// The first piece of a graph as if it went on to the end.
pub(super) fn first_piece(law: &Taught<'_>) -> Vec<Wrong> {
    fn first(term: &Expr) -> Expr {
        match term {
            Expr::Piecewise(graph) => graph.pieces.first().map_or_else(|| term.clone(), |(_, value)| value.clone()),
            other => other.map_children(first),
        }
    }
    let Some((value, time, [low, high])) = law.integral else { return Vec::new() };
    let begun = first(value);
    if begun == *value {
        return Vec::new();
    }
    let area = begun.definite(time, low, high);
    area.map(|area| Wrong::from((law.left(), area.simplify()))).into_iter().collect()
}

/// Half of the greatest value half-way, times the time.
pub(super) fn half_of_middle(law: &Taught<'_>) -> Vec<Wrong> {
    let Some(graph) = Graph::of(law).filter(|graph| graph.corners().is_empty()) else { return Vec::new() };
    one((law.left(), Expr::product([Expr::ratio(1, 2), graph.at(&graph.middle()), graph.duration()])))
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

/// Each triangle under a graph in pieces taken for a rectangle; all of them are the peak for the whole time, as a rule.
pub(super) fn not_halved(law: &Taught<'_>) -> Vec<Wrong> {
    let mut ways = altered_pieces(law, &|piece| {
        let ends = [piece.first.is_zero(), piece.last.is_zero()];
        (ends[0] != ends[1]).then(|| (piece.first.clone() + piece.last.clone()) * piece.duration())
    });
    if ways.len() > 1 {
        ways.remove(0);
    }
    ways
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
        self.formula_at(self.value, time)
    }

    fn formula_at(&self, formula: &Expr, time: &Expr) -> Expr {
        formula.substitute(&|symbol| (symbol == self.variable).then(|| time.clone()))
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
        // Each piece by its own formula: letters do not tell which of them holds at an end.
        let formula = |place: usize| match self.value {
            Expr::Piecewise(graph) if graph.pieces.len() + 1 == ends.len() => &graph.pieces[place].1,
            _ => self.value,
        };
        let piece = |(place, ends): (usize, &[Expr])| match ends {
            [from, to] => Some(Piece {
                from: from.clone(),
                to: to.clone(),
                first: self.formula_at(formula(place), from).simplify(),
                last: self.formula_at(formula(place), to).simplify(),
            }),
            _ => None,
        };
        ends.windows(2).enumerate().filter_map(piece).collect()
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
