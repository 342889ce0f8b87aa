//! Slips of the pen in one line, whatever its law: a factor, a power, a term. A law's own wrong forms go before them; a slip is
//! looked for only in an answer that none of these explains.

use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_expr::SymbolTable;
use momentous_quantity::Dimension;
use momentous_quantity::Rational;

use super::Misconception;
use crate::Sides;

/// A number that belongs to the law.
pub const NUMBER: Misconception = Misconception {
    id: "slip-number",
    does: "leaves out a number that belongs to a law, or adds one",
    ask: "Which numbers stand in the laws that you use: one half, two, pi? Does each of them stand in your lines, and no other?",
    hint: "Write each law down in letters, with its numbers, before you put in values.",
};
/// A square or a root.
pub const POWER: Misconception = Misconception {
    id: "slip-power",
    does: "forgets a square or a root",
    ask: "Which quantity is squared in this law, and where is a root taken?",
    hint: "The units of both sides agree only with the right powers.",
};
/// A factor.
pub const FACTOR: Misconception = Misconception {
    id: "slip-factor",
    does: "leaves a factor out of one line",
    ask: "Which quantities belong in this law? Does each of them stand in your line?",
    hint: "Compare the units of both sides: a factor that is missing shows there.",
};
/// A factor for a divisor.
pub const DIVISOR: Misconception = Misconception {
    id: "slip-divisor",
    does: "multiplies where the law divides, or divides where it multiplies",
    ask: "Do you multiply where you should divide? Which units has your result?",
    hint: "Compare the units of both sides: with a factor on the wrong side they do not agree.",
};
/// A term.
pub const TERM: Misconception = Misconception {
    id: "slip-term",
    does: "leaves a term out of one line",
    ask: "How many terms has this law here? Does each of them stand in your line?",
    hint: "Write the law down in letters first, and put in values term by term.",
};
/// Another value of the same kind.
pub const VALUE: Misconception = Misconception {
    id: "slip-value",
    does: "uses another value of the same kind in one line",
    ask: "Several values of the same kind occur in this problem. Is the one that you put in the one that belongs here?",
    hint: "Write next to each value to which body, instant or part of the motion it belongs.",
};

/// A line of the solution, with what a slip needs to know.
#[derive(Clone, Copy)]
pub struct Line<'a> {
    /// The two sides.
    pub sides: &'a Sides,
    /// The quantities.
    pub symbols: &'a SymbolTable,
    /// The quantities that are given, without those that are zero.
    pub told: &'a BTreeSet<Symbol>,
    /// The quantities of all lines.
    pub others: &'a BTreeSet<Symbol>,
    /// One unit of a dimension: a factor of one unit leaves no trace.
    pub unit: &'a dyn Fn(Dimension) -> Expr,
}

/// A kind of slip.
#[derive(Debug)]
pub struct LineSlip {
    /// The mistake.
    pub of: &'static Misconception,
    /// The lines that come of it, one for each place at which it can be made.
    pub write: fn(&Line<'_>) -> Vec<Sides>,
}

/// Every kind of slip, those that are made most first.
pub const LINE_SLIPS: &[LineSlip] = &[
    LineSlip { of: &NUMBER, write: number },
    LineSlip { of: &POWER, write: power },
    LineSlip { of: &FACTOR, write: factor },
    LineSlip { of: &TERM, write: term },
    LineSlip { of: &DIVISOR, write: divisor },
    LineSlip { of: &VALUE, write: value },
];

impl Line<'_> {
    /// The line with one part of it replaced: every part, by everything that is in its place.
    fn in_one_place(&self, instead: &dyn Fn(&Expr) -> Vec<Expr>) -> Vec<Sides> {
        let (left, right) = self.sides;
        let lefts = replaced_once(left, instead).into_iter().map(|other| (other, right.clone()));
        let rights = replaced_once(right, instead).into_iter().map(|other| (left.clone(), other));
        lefts.chain(rights).collect()
    }

    /// The line without a quantity wherever it is a factor; nothing where it does not stand, or stands by itself, too.
    #[must_use]
    pub fn without_factor(&self, symbol: Symbol) -> Option<Sides> {
        let unit = (self.unit)(self.symbols.entry(symbol).dimension);
        self.wherever_a_factor(symbol, &unit)
    }

    /// The line with a quantity replaced wherever it is a factor; nothing where it stands by itself, too.
    fn wherever_a_factor(&self, symbol: Symbol, other: &Expr) -> Option<Sides> {
        let (left, right) = self.sides;
        let sides = [left, right];
        if !sides.iter().any(|side| side.contains(symbol)) || sides.iter().any(|side| stands_alone(side, symbol)) {
            return None;
        }
        let put = |side: &Expr| side.substitute(&|part| (part == symbol).then(|| other.clone()));
        Some((put(left), put(right)))
    }

    fn unit_of(&self, term: &Expr) -> Option<Expr> {
        term.dimension(self.symbols).ok().map(self.unit)
    }

    fn quantities(&self) -> BTreeSet<Symbol> {
        let mut all = self.sides.0.symbols();
        all.extend(self.sides.1.symbols());
        all
    }
}

/// Each number alone, and all of a term.
fn number(line: &Line<'_>) -> Vec<Sides> {
    let is_number = |factor: &Expr| match factor {
        Expr::Number(number) => ![Rational::ONE, -Rational::ONE].contains(number),
        Expr::Pi => true,
        Expr::Power(pair) => pair.0 == Expr::Pi,
        _ => false,
    };
    line.in_one_place(&|part| match part {
        Expr::Product(factors) => {
            let mut ways = without_one(factors, &is_number);
            if ways.len() > 1 {
                ways.push(Expr::product(factors.iter().filter(|factor| !is_number(factor)).cloned()));
            }
            ways
        }
        _ => Vec::new(),
    })
}

fn power(line: &Line<'_>) -> Vec<Sides> {
    line.in_one_place(&|part| match part {
        Expr::Power(pair) => match &pair.1 {
            Expr::Number(exponent) if *exponent == Rational::from(2) => {
                line.unit_of(&pair.0).map(|unit| unit * pair.0.clone()).into_iter().collect()
            }
            Expr::Number(exponent) if *exponent == Rational::from(1) / Rational::from(2) => {
                line.unit_of(part).map(|unit| pair.0.clone() / unit).into_iter().collect()
            }
            _ => Vec::new(),
        },
        _ => Vec::new(),
    })
}

/// A given quantity wherever it is a factor, and each sum and power where it is one.
fn factor(line: &Line<'_>) -> Vec<Sides> {
    // A pure number that is left out has mistakes of its own, as a coefficient of restitution or of friction.
    let has_unit = |symbol: &&Symbol| line.symbols.entry(**symbol).dimension != Dimension::NONE;
    let each = line.told.iter().filter(has_unit).filter_map(|symbol| line.without_factor(*symbol));
    let is_sum = |factor: &Expr| matches!(factor, Expr::Sum(_));
    let sums = line.in_one_place(&|part| match part {
        Expr::Product(factors) => {
            let sums = factors.iter().enumerate().filter(|(_, factor)| is_sum(factor));
            let left_out = sums.filter_map(|(place, sum)| {
                let unit = line.unit_of(sum)?;
                let kept = factors.iter().enumerate();
                Some(Expr::product(kept.map(|(at, factor)| if at == place { unit.clone() } else { factor.clone() })))
            });
            left_out.collect()
        }
        _ => Vec::new(),
    });
    each.chain(sums).collect()
}

fn divisor(line: &Line<'_>) -> Vec<Sides> {
    let measured = |symbol: Symbol| line.symbols.entry(symbol).dimension;
    let inverted = line.told.iter().filter(|symbol| DIVIDED_BY.contains(&measured(**symbol))).filter_map(|symbol| {
        let unit = (line.unit)(measured(*symbol));
        line.wherever_a_factor(*symbol, &(unit.powi(2) / Expr::from(*symbol)))
    });
    inverted.collect()
}

/// By what one divides where one should multiply, or the other way round: masses and durations.
const DIVIDED_BY: [Dimension; 2] = [Dimension::MASS, Dimension::TIME];

fn term(line: &Line<'_>) -> Vec<Sides> {
    line.in_one_place(&|part| match part {
        Expr::Sum(terms) => super::rewrite::all_but_one(&Expr::Sum(terms.clone())),
        _ => Vec::new(),
    })
}

fn value(line: &Line<'_>) -> Vec<Sides> {
    let measured = |symbol: Symbol| line.symbols.entry(symbol).dimension;
    let is_elsewhere = |symbol: &Symbol| ELSEWHERE.contains(&measured(*symbol));
    let quantities = line.quantities();
    let here = quantities.iter().filter(|symbol| !is_elsewhere(symbol));
    let pairs = here.flat_map(|symbol| line.others.iter().map(move |other| (*symbol, *other)));
    let alike = pairs.filter(|(symbol, other)| {
        symbol != other && !quantities.contains(other) && measured(*symbol) == measured(*other)
    });
    let (left, right) = line.sides;
    let put = |side: &Expr, symbol: Symbol, other: Symbol| {
        side.substitute(&|part| (part == symbol).then(|| Expr::from(other)))
    };
    alike.map(|(symbol, other)| (put(left, symbol, other), put(right, symbol, other))).collect()
}

/// Masses and velocities in each other's place are mistakes about the data, with names of their own.
const ELSEWHERE: [Dimension; 3] = [Dimension::MASS, Dimension::VELOCITY, Dimension::NONE];

/// Every term in which one part is replaced.
fn replaced_once(term: &Expr, instead: &dyn Fn(&Expr) -> Vec<Expr>) -> Vec<Expr> {
    let mut all = instead(term);
    // Whoever slips within a piece of a function does so in its graph, which has mistakes of its own.
    if matches!(term, Expr::Piecewise(_)) {
        return all;
    }
    for (place, child) in term.children().enumerate() {
        for other in replaced_once(child, instead) {
            let mut at = 0..;
            all.push(term.map_children(|part| if at.next() == Some(place) { other.clone() } else { part.clone() }));
        }
    }
    all
}

/// Products with one of the chosen factors left out.
fn without_one(factors: &[Expr], is_chosen: &dyn Fn(&Expr) -> bool) -> Vec<Expr> {
    let places = factors.iter().enumerate().filter(|(_, factor)| is_chosen(factor));
    let kept =
        |out: usize| factors.iter().enumerate().filter(move |(at, _)| *at != out).map(|(_, factor)| factor.clone());
    places.map(|(out, _)| Expr::product(kept(out))).collect()
}

/// Whether a quantity is a side, or a term of a sum, by itself.
fn stands_alone(term: &Expr, symbol: Symbol) -> bool {
    match term {
        Expr::Symbol(listed) => *listed == symbol,
        Expr::Sum(terms) => terms.iter().any(|term| stands_alone(term, symbol)),
        Expr::Product(factors) => matches!(&factors[..], [Expr::Number(_), Expr::Symbol(listed)] if *listed == symbol),
        other => other.children().any(|part| matches!(part, Expr::Sum(_)) && stands_alone(part, symbol)),
    }
}
