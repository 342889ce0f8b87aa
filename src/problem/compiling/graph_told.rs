//! Values that a graph on a sheet must not print, and those that it cannot.

use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_model::Model;
use momentous_model::PrintedGraph;
use momentous_quantity::Unit;

use super::planned::Form;

/// The faults of a graph in a form.
pub(super) fn check(model: &Model, form: &Form, graph: &PrintedGraph) -> Vec<Fault> {
    let fault = |message: String, help: &str| Fault::new(Code::Text, message).help(help).at_path(graph.path.clone());
    let name = |symbol: Symbol| model.symbols.entry(symbol).name.as_str();
    let mut faults = Vec::new();
    for time in graph.points.iter().flat_map(|[time, _]| time.symbols()) {
        if unit_of(model, form, time).is_none() {
            let message =
                format!("the sheet's graph has no place for the time `{}`, which this form does not give", name(time));
            let help = "give it a value, a range or a choice; a multiple is written at the point, as `2*T`";
            faults.push(fault(message, help));
        }
    }
    for side in 0..2 {
        let units: Vec<Unit> = graph
            .points
            .iter()
            .flat_map(|point| point[side].symbols())
            .filter_map(|symbol| unit_of(model, form, symbol))
            .collect();
        if let Some((one, other)) = units.iter().zip(units.iter().skip(1)).find(|(one, other)| one != other) {
            let message = format!("along one axis, the sheet's graph has values in {one} and in {other}");
            faults.push(fault(message, "write them in one unit"));
        }
    }
    faults
}

/// The unit in which a form tells a quantity.
fn unit_of(model: &Model, form: &Form, symbol: Symbol) -> Option<Unit> {
    let known = form.known.iter().filter(|known| form.told.contains(&known.symbol));
    let known = known.map(|known| (known.symbol, &known.unit));
    let revealed = form.reveal.iter().map(|reveal| (reveal.symbol, &reveal.unit));
    let literals = model.literals.iter().map(|(symbol, value)| (*symbol, &value.unit));
    known.chain(revealed).chain(literals).find(|(told_symbol, _)| *told_symbol == symbol).map(|(_, unit)| unit.clone())
}
