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
    /// What they are pictures of.
    pub subject: Subject,
    /// What has to be solved.
    pub(crate) quantities: Vec<Symbol>,
}

/// What pictures are of.
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
    /// What it is called: `diagram A`.
    pub name: String,
    /// What it shows.
    pub shows: Shows,
    /// The mistake that leads to it; none of the right one.
    pub mistake: Option<&'static Misconception>,
}

/// What a picture shows.
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
