//! Graphs that are offered in a choice, all on the same axes.

use momentous_expr::Math;
use momentous_expr::name_math;
use momentous_figure::Drawing;
use momentous_figure::ForcePlot;
use momentous_figure::PlotAxis;
use momentous_figure::Wording;
use momentous_problem::Curve;
use momentous_problem::Graph;
use momentous_problem::Picture;
use momentous_problem::Shows;
use momentous_quantity::Unit;

use super::super::terms::display::printed;
use super::super::wording::capitalised;
use super::quantities::Quantities;
use super::words::sentences;

/// The extent of an axis without numbers, in words.
const EXTENT: f64 = 10.0;
/// Figures of the numbers in descriptions.
const FIGURES: usize = 3;
/// The share of an extent by which a line may bend and still be called straight, and below which a value is zero.
const STRAIGHT: f64 = 1e-6;

/// An axis of all graphs of a choice.
struct Measured {
    /// Its unit in SI units.
    size: f64,
    /// The unit in words, and what is written at the axis: nothing where its numbers mean nothing.
    unit: String,
    written: String,
    extent: f64,
}

/// The graphs in their order.
pub(super) fn drawings(quantities: &Quantities<'_>, graph: &Graph, pictures: &[Picture]) -> Vec<Drawing> {
    let curves: Vec<(&str, &Curve)> = pictures
        .iter()
        .filter_map(|picture| match &picture.shows {
            Shows::Graph(curve) => Some((picture.name.as_str(), curve)),
            Shows::Diagram(_) => None,
        })
        .collect();
    let all = || curves.iter().flat_map(|(_, curve)| curve.points());
    let last = all().map(|[time, _]| time).fold(0.0, f64::max);
    let [low, high] = curves
        .iter()
        .map(|(_, curve)| curve.reach())
        .fold([0.0, 0.0], |[low, high]: [f64; 2], curve| [low.min(curve[0]), high.max(curve[1])]);
    let [second, unit] = quantities.worked.units_of(graph);
    let axis = |is_told: bool, unit: Unit, extent: f64| {
        if is_told {
            let size = unit.factor().to_f64();
            Measured { size, unit: unit.unicode(), written: unit.unicode(), extent: extent / size }
        } else {
            Measured { size: extent / EXTENT, unit: "units".to_owned(), written: String::new(), extent: EXTENT }
        }
    };
    let time = axis(graph.has_times() && quantities.has_numbers(), second, last);
    let value = axis(quantities.has_numbers(), unit, high.max(-low));
    let placed = |[at, height]: [f64; 2]| [at / time.size, height / value.size];
    let component = graph.along.map(|axis| format!(".{}", axis.letter())).unwrap_or_default();
    let letter = graph.plotted.letter();
    let symbol = quantities.worked.problem.notation().math(&format!("{letter}_{}{component}", graph.body));
    let room = [[0.0, low], [last, high]].map(placed);
    let drawn = |(name, curve): (&str, &Curve)| {
        let pieces = curve.pieces.iter().map(|piece| piece.iter().copied().map(placed).collect());
        let pieces = joined(pieces.collect(), value.extent);
        let name = capitalised(name);
        let description = sentences([course(&pieces, graph.plotted.noun(), [&time, &value])]);
        let plot = ForcePlot {
            wording: Wording { title: name.clone(), description, caption: name },
            time: time.axis(name_math("t")),
            force: value.axis(symbol.clone()),
            points: pieces.concat(),
            area: None,
            marks: Vec::new(),
        };
        plot.with_room_for(&room)
    };
    curves.into_iter().map(drawn).collect()
}

impl Measured {
    fn axis(&self, symbol: Math) -> PlotAxis {
        // Told is then the origin alone.
        let told = if self.written.is_empty() { vec![(0.0, Math::Number("0".to_owned()))] } else { Vec::new() };
        PlotAxis { symbol, unit: self.written.clone(), told }
    }

    fn said(&self, value: f64) -> String {
        let number = if value.abs() <= STRAIGHT * self.extent { "0".to_owned() } else { printed(value, FIGURES) };
        format!("{number} {}", self.unit)
    }
}

/// The pieces of a curve as the eye sees them: one line where several go on straight, and no points between the ends of a line.
fn joined(pieces: Vec<Vec<[f64; 2]>>, extent: f64) -> Vec<Vec<[f64; 2]>> {
    let mut drawn_pieces: Vec<Vec<[f64; 2]>> = Vec::new();
    for piece in pieces {
        let both = drawn_pieces.last().map(|before| [&before[..], &piece].concat());
        match (both, drawn_pieces.last_mut()) {
            (Some(both), Some(before)) if is_straight(&both, extent) => *before = both,
            _ => drawn_pieces.push(piece),
        }
    }
    for piece in &mut drawn_pieces {
        if let ([first, .., last], true) = (&piece[..], is_straight(piece, extent)) {
            *piece = vec![*first, *last];
        }
    }
    drawn_pieces
}

/// Whether all points lie on the line from the first to the last.
fn is_straight(points: &[[f64; 2]], extent: f64) -> bool {
    let [[from, first], .., [to, last]] = points else { return false };
    let line = |time: f64| first + (last - first) * (time - from) / (to - from);
    points.iter().all(|[time, height]| (height - line(*time)).abs() <= STRAIGHT * extent)
}

/// The course of a curve as the eye sees it, in words.
fn course(pieces: &[Vec<[f64; 2]>], noun: &str, [time, value]: [&Measured; 2]) -> String {
    let at = |[instant, height]: [f64; 2]| format!("{} at {}", value.said(height), time.said(instant));
    let mut said = Vec::new();
    let mut before: Option<f64> = None;
    for piece in pieces {
        let ([first, .., last], Some(middle)) = (&piece[..], piece.get(piece.len() / 2)) else { continue };
        let start = value.said(first[1]);
        match before {
            None => said.push(format!("{noun} starts at {start}")),
            Some(before) if (before - first[1]).abs() > STRAIGHT * value.extent => {
                said.push(format!("jumps to {start}"));
            }
            Some(_) => {}
        }
        before = Some(last[1]);
        said.push(if piece.len() > 2 {
            format!("goes along a curve through {} to {}", at(*middle), at(*last))
        } else if (last[1] - first[1]).abs() <= STRAIGHT * value.extent {
            format!("stays there until {}", time.said(last[0]))
        } else {
            format!("goes straight to {}", at(*last))
        });
    }
    said.join(", ")
}
