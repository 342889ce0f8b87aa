//! Which force of a push a sheet prints as a graph, and whether it can.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_quantity::Rational;

use super::Builder;
use super::printed_graph::PrintedGraph;
use super::stage::Acting;

impl Builder<'_> {
    /// Notes the one graph among the forces of a push.
    pub(super) fn print_graph(&mut self, index: usize, acting: &[Acting], end: &Expr, path: &Path) {
        let mut graphs = acting.iter().filter(|force| !force.points.is_empty());
        let (Some(force), None) = (graphs.next(), graphs.next()) else {
            let fault = Fault::new(Code::Value, "the sheet's graph tells the one force that is given by points");
            let help = "give one force of this push by points: `value: { points: [[0 s, 0 N], [2 s, F], [3 s, 0 N]] }`";
            self.faults.push(fault.help(help).at_path(path.clone()));
            return;
        };
        if self.graph.is_some() {
            let fault = Fault::new(Code::Value, "a sheet has one graph, and an earlier push has it");
            self.faults.push(fault.help("tell this force in the text").at_path(path.clone()));
            return;
        }
        let points: Vec<[Expr; 2]> =
            force.points.iter().map(|point| point.clone().map(|coordinate| coordinate.simplify())).collect();
        if !points.iter().flatten().all(is_plain) {
            let fault = Fault::new(Code::Value, "a graph prints values, names and multiples of them");
            let help = "write each time and each force as `2 s`, `F` or `2*F`; what is more than that has a name under `given`";
            self.faults.push(fault.help(help).at_path(path.clone()));
            return;
        }
        if self.goes_on_after(&points, end) {
            let fault = Fault::new(Code::Value, "the sheet's graph goes on after the push has ended");
            let help = "end both at the same time: write the time of the last point in `during`, or leave out the points after the end";
            self.faults.push(fault.help(help).at_path(path.clone()));
            return;
        }
        self.graph = Some(PrintedGraph { stage: index, called: force.name.clone(), points, path: path.clone() });
    }

    /// Whether the last point lies after the end, or the graph alone tells an end that is not its last point.
    fn goes_on_after(&self, points: &[[Expr; 2]], end: &Expr) -> bool {
        let Some([last, _]) = points.last() else { return false };
        let written = |symbol: Symbol| {
            let (_, value) = self.literals.iter().find(|(literal, _)| *literal == symbol)?;
            Some(Expr::measured(&value.value, &value.unit))
        };
        let rest = (last.clone() - end.clone()).substitute(&written).simplify();
        let is_drawn = |symbol: &Symbol| points.iter().any(|[time, _]| time.contains(*symbol));
        match self.sign_of(&rest) {
            _ if rest.is_zero() => false,
            Some(sign) => sign > 0,
            None => end.symbols().iter().all(is_drawn),
        }
    }
}

/// Whether a coordinate is zero, a quantity, or a multiple of one by a number with few digits.
fn is_plain(coordinate: &Expr) -> bool {
    match coordinate {
        Expr::Number(number) => number.is_zero(),
        Expr::Symbol(_) => true,
        Expr::Product(factors) => match &factors[..] {
            [Expr::Number(factor), Expr::Symbol(_)] => (factor.clone() * Rational::from(1000)).denominator().is_one(),
            _ => false,
        },
        Expr::Sum(_) | Expr::Pi | Expr::Power(_) | Expr::Apply(..) | Expr::Piecewise(_) => false,
    }
}
