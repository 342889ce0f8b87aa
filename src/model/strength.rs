//! Strengths that change with time, as an author states them: a term in `t`, pieces, the points of a graph, components.

use std::sync::Arc;

use momentous_expr::Expr;
use momentous_expr::Piecewise;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_quantity::Dimension;
use momentous_scene::Axis;
use momentous_scene::Components;
use momentous_scene::Graph;
use momentous_scene::Strength;
use momentous_scene::Term;

use super::Builder;
use super::Reason;

impl Builder<'_> {
    /// A strength as a function of the time `t`.
    pub(super) fn strength(&mut self, strength: &Strength, dimension: Dimension, meaning: &str, path: &Path) -> Expr {
        let clock = Expr::from(self.running_time());
        match strength {
            Strength::Term(term) => self.read(term, dimension, meaning, path),
            Strength::Pieces(pieces) => {
                if pieces.is_empty() {
                    let fault = Fault::new(Code::MissingKey, format!("{meaning} has no pieces"));
                    self.faults.push(fault.help("write one, such as `{ is: 3 N }`").at_path(path.clone()));
                }
                let pieces: Vec<(Option<Expr>, Expr)> = pieces
                    .iter()
                    .enumerate()
                    .map(|(position, piece)| {
                        let at = path.index(position);
                        let until = piece.until.as_ref().map(|term| {
                            self.read_positive(
                                term,
                                Dimension::TIME,
                                "the time at which the force changes to its next piece",
                                &at.key("until"),
                            )
                        });
                        (until, self.read(&piece.is, dimension, meaning, &at.key("is")))
                    })
                    .collect();
                let ends: Vec<Expr> = pieces.iter().filter_map(|(until, _)| until.clone()).collect();
                for pair in ends.windows(2) {
                    self.in_order(&pair[0], &pair[1], Reason::PiecesInOrder);
                }
                Expr::Piecewise(Arc::new(Piecewise { variable: clock, pieces }))
            }
            Strength::Components(_) => {
                let fault = Fault::new(Code::Value, format!("{meaning} has one component here"));
                self.faults.push(fault.help("write it as a single term, such as `3*t`").at_path(path.clone()));
                Expr::zero()
            }
            Strength::Graph(graph) => {
                let points = self.points(graph, dimension, meaning, path);
                through(&points, clock)
            }
        }
    }

    /// The points of a graph: time and strength.
    pub(super) fn points(&mut self, graph: &Graph, dimension: Dimension, meaning: &str, path: &Path) -> Vec<[Expr; 2]> {
        let read = |builder: &mut Self, term: &Term, (dimension, meaning): (_, &str), position: usize, side: usize| {
            let value = builder.read(term, dimension, meaning, &path.key("points").index(position).index(side));
            builder.zero_if_so_written(value)
        };
        let points: Vec<[Expr; 2]> = graph
            .points
            .iter()
            .enumerate()
            .map(|(position, [time, force])| {
                let time = read(self, time, (Dimension::TIME, "the time of a point of the graph"), position, 0);
                [time, read(self, force, (dimension, meaning), position, 1)]
            })
            .collect();
        if points.len() < 2 {
            let fault = Fault::new(Code::MissingKey, "a graph needs at least two points");
            let help = "write pairs of time and force: `[[0 s, 0 N], [2 s, 6 N]]`";
            self.faults.push(fault.help(help).at_path(path.key("points")));
        }
        for pair in points.windows(2) {
            self.in_order(&pair[0][0], &pair[1][0], Reason::PointsInOrder);
        }
        points
    }

    /// Components along the axes in their order, each as a function of the time `t`; those left out are zero.
    pub(super) fn strengths(
        &mut self,
        components: &Components,
        dimension: Dimension,
        meaning: &str,
        path: &Path,
    ) -> Vec<Expr> {
        self.running_time();
        if let Some(stranger) = components.axes().find(|axis| self.axes.iter().all(|(listed, _)| listed != axis)) {
            let fault = Fault::new(Code::Value, format!("the scene has no axis {}", stranger.letter()));
            let help = format!("its axes are: {}", self.axis_letters().join(", "));
            self.faults.push(fault.help(help).at_path(path.key(stranger.letter())));
        }
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        let read = |axis: &Axis| {
            let meaning = format!("the {}-component of {meaning}", axis.letter());
            let value = self.read(components.get(*axis)?, dimension, &meaning, &path.key(axis.letter()));
            Some(self.zero_if_so_written(value))
        };
        axes.iter().map(read).map(|value| value.unwrap_or_else(Expr::zero)).collect()
    }
}

/// Straight lines between the points of a graph. Two points at one time are a step, over which no time passes.
pub(super) fn through(points: &[[Expr; 2]], clock: Expr) -> Expr {
    let pieces = points.windows(2).filter(|pair| pair[0][0] != pair[1][0]).map(|pair| {
        let [[t0, f0], [t1, f1]] = [pair[0].clone(), pair[1].clone()];
        let slope = (f1 - f0.clone()) / (t1.clone() - t0.clone());
        (Some(t1), (f0 + slope * (clock.clone() - t0)).simplify())
    });
    let pieces = pieces.collect();
    Expr::Piecewise(Arc::new(Piecewise { variable: clock, pieces }))
}
