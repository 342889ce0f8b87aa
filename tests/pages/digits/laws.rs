//! Each equation of a short solution holds, in symbols and with the numbers that are put into it.

use std::sync::Arc;

use momentous::bank::Bank;
use momentous::exercise::{Drawer, Exercise};
use momentous::explain::{Audience, Block, Detail};
use momentous::expr::{Math, Operator};
use momentous::problem::{compile, load};

use super::printed::{flatten, side};

/// By how much, relative to the largest summand, the sides may differ where numbers are printed to four figures.
const ROUNDING: f64 = 3e-3;

/// The names of quantities as they are typeset, the longest first, and their values in base units.
type Names = Vec<(Vec<Math>, f64)>;

fn names(exercise: &Exercise) -> Names {
    let worked = exercise.worked();
    let symbols = worked.problem.model().symbols.iter();
    let mut names: Names = symbols
        .filter_map(|(symbol, _)| {
            let mut flat = Vec::new();
            flatten(&worked.problem.math_of(symbol), &mut flat);
            Some((flat, worked.variant.value(symbol)?.or_zero()))
        })
        .collect();
    names.sort_by_key(|(flat, _)| std::cmp::Reverse(flat.len()));
    names
}

/// A part of a line with values in place of names.
fn valued(part: &Math, names: &Names) -> Math {
    let inner = |part: &Arc<Math>| Arc::new(Math::Row(row(part, names)));
    match part {
        Math::Fraction(above, below) => Math::Fraction(inner(above), inner(below)),
        Math::Bracketed(part) => Math::Bracketed(inner(part)),
        Math::Squared(part) => Math::Squared(inner(part)),
        Math::Root(part) => Math::Root(inner(part)),
        Math::Sup(base, exponent) if !matches!(&**base, Math::Function(_)) => Math::Sup(inner(base), exponent.clone()),
        other => other.clone(),
    }
}

/// The parts of a line with values in place of names.
fn row(line: &Math, names: &Names) -> Vec<Math> {
    let mut flat = Vec::new();
    flatten(line, &mut flat);
    let (mut rest, mut parts) = (flat.as_slice(), Vec::new());
    while let [first, after @ ..] = rest {
        match names.iter().find(|(name, _)| rest.starts_with(name)) {
            Some((name, value)) => {
                let sign = (*value < 0.0).then_some(Math::Operator(Operator::Minus));
                let size = Math::Number(format!("{:e}", value.abs()));
                parts.push(Math::Bracketed(Arc::new(Math::Row(sign.into_iter().chain([size]).collect()))));
                rest = &rest[name.len()..];
            }
            None => {
                parts.push(valued(first, names));
                rest = after;
            }
        }
    }
    parts
}

/// The value of a side, and that of the sum of the sizes of its terms; nothing where it holds what cannot be read, such as an integral.
fn value(parts: &[Math]) -> Option<(f64, f64)> {
    let number = |parts: &[Math]| Some(side(parts)?.values.first()?.to_f64().value());
    let magnitude = number(parts)?;
    let sizes: Vec<Math> = parts.iter().map(added).collect();
    // Not every sum is the cosine of an angle.
    let is_inverse = |part: &Math| ["arc", "ln"].iter().any(|name| part.plain().contains(name));
    Some((magnitude, if parts.iter().any(is_inverse) { magnitude.abs() } else { number(&sizes)?.abs() }))
}

/// A part with every minus turned into a plus.
fn added(part: &Math) -> Math {
    let inner = |part: &Arc<Math>| Arc::new(added(part));
    match part {
        Math::Operator(Operator::Minus) => Math::Operator(Operator::Plus),
        Math::Row(parts) => Math::Row(parts.iter().map(added).collect()),
        Math::Bracketed(part) => Math::Bracketed(inner(part)),
        Math::Squared(part) => Math::Squared(inner(part)),
        Math::Fraction(above, below) => Math::Fraction(inner(above), inner(below)),
        other => other.clone(),
    }
}

/// Whether an angle is in another quadrant than its arctangent in symbols says.
fn leaves_the_arctangent(line: &Math) -> bool {
    line.plain().contains("180\u{b0}")
}

#[test]
fn every_equation_of_the_bank_holds() {
    let (mut read, mut wrong) = (0, Vec::new());
    for source in Bank::built_in().sources() {
        let problem = Arc::new(compile(load(source.clone()).unwrap(), None).unwrap());
        for form in 0..problem.forms().len() {
            let mut drawer = Drawer::new(&problem, form).unwrap();
            for exercise in [1, 2, 3].into_iter().filter_map(|seed| drawer.draw(seed).ok()) {
                let names = names(&exercise);
                let outline = exercise.outline(Audience::Everyone, Detail::Short);
                let blocks = outline.sections.iter().flat_map(|section| &section.blocks);
                for line in blocks
                    .flat_map(|block| if let Block::Equation { lines, .. } = block { lines.as_slice() } else { &[] })
                {
                    if leaves_the_arctangent(line) {
                        continue;
                    }
                    let mut flat = Vec::new();
                    for part in &row(line, &names) {
                        flatten(part, &mut flat);
                    }
                    let sides: Vec<_> =
                        flat.split(|part| matches!(part, Math::Operator(Operator::Equals))).map(value).collect();
                    for pair in sides.windows(2) {
                        let [Some((left, most)), Some((right, too))] = pair else { continue };
                        read += 1;
                        if (left - right).abs() > ROUNDING * most.max(*too) {
                            wrong.push(format!("{} form {form}: {}", problem.id(), line.plain()));
                        }
                    }
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{} of {read}\n{}", wrong.len(), wrong.join("\n"));
    assert!(read > 4000, "{read}");
}
