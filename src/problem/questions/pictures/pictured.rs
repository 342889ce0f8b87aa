//! Pictures to choose from: the right one, and those that usual mistakes lead to.

use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_laws::wrong::Misconception;

use super::curve::Curve;
use super::diagram::Balance;
use super::diagram::Diagram;
use super::graph::Graph;

/// A choice between pictures.
#[derive(Clone, Debug)]
pub struct Pictured {
    /// The name of the random stream from which their order comes.
    pub(crate) stream: String,
    /// The subject of the pictures.
    pub subject: Subject,
    /// The quantities that have to be solved.
    pub(crate) quantities: Vec<Symbol>,
}

/// The subjects of pictures.
#[derive(Clone, Debug)]
pub enum Subject {
    /// The momenta and impulses of a stage.
    Diagram(Diagram),
    /// A quantity of a body against time.
    Graph(Graph),
}

/// A picture that is offered.
#[derive(Clone, Debug)]
pub struct Picture {
    /// Its name: `diagram A`.
    pub name: String,
    /// The drawing on it.
    pub shows: Shows,
    /// The mistake that leads to it; none of the right one.
    pub mistake: Option<&'static Misconception>,
}

/// The drawing on a picture.
#[derive(Clone, Debug, PartialEq)]
pub enum Shows {
    /// The rows of a diagram.
    Diagram(Vec<Balance>),
    /// The curve of a graph.
    Graph(Curve),
}

impl Subject {
    /// Everything on which the pictures depend.
    pub(crate) fn symbols(&self) -> BTreeSet<Symbol> {
        match self {
            Self::Diagram(diagram) => diagram.terms().flat_map(Expr::symbols).collect(),
            Self::Graph(graph) => graph.symbols(),
        }
    }
}
