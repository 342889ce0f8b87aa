//! The pictures that a variant offers: the right one, and those that usual mistakes lead to.

use momentous_expr::Symbol;
use momentous_laws::wrong::Misconception;
use momentous_quantity::Dimension;
use momentous_quantity::Unit;
use momentous_quantity::coherent_unit;

use super::super::questions::choices::decision::Decision;
use super::super::questions::choices::decision::OptionFeedback;
use super::super::questions::pictures::diagram;
use super::super::questions::pictures::diagram::Balance;
use super::super::questions::pictures::graph::Graph;
use super::super::questions::pictures::pictured::Picture;
use super::super::questions::pictures::pictured::Pictured;
use super::super::questions::pictures::pictured::Shows;
use super::super::questions::pictures::pictured::Subject;
use super::super::sampling::variant::Worked;
use super::offered::shuffled;

/// The number of pictures that are offered at most, and at least.
const OFFERED: [usize; 2] = [4, 3];

impl Subject {
    /// The noun for its pictures.
    fn noun(&self) -> &'static str {
        match self {
            Self::Diagram(_) => "diagram",
            Self::Graph(_) => "graph",
        }
    }

    /// The right picture, then those of usual mistakes.
    fn drawn(&self, worked: &Worked<'_>) -> Vec<(Option<&'static Misconception>, Shows)> {
        let value = |symbol| worked.value_of(symbol);
        match self {
            Self::Diagram(diagram) => shown(diagram.drawn(&value), Shows::Diagram),
            Self::Graph(graph) => shown(graph.drawn(&value), Shows::Graph),
        }
    }
}

fn shown<T>(
    drawn: Vec<(Option<&'static Misconception>, T)>,
    shows: fn(T) -> Shows,
) -> Vec<(Option<&'static Misconception>, Shows)> {
    drawn.into_iter().map(|(mistake, picture)| (mistake, shows(picture))).collect()
}

impl Shows {
    fn looks_like(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Diagram(one), Self::Diagram(other)) => diagram::looks_like(one, other),
            (Self::Graph(one), Self::Graph(other)) => one.looks_like(other),
            (Self::Diagram(_), Self::Graph(_)) | (Self::Graph(_), Self::Diagram(_)) => false,
        }
    }

    fn is_drawn(&self) -> bool {
        match self {
            Self::Diagram(rows) => rows.iter().all(Balance::is_drawn),
            Self::Graph(curve) => curve.is_finite(),
        }
    }
}

impl Pictured {
    /// The pictures, in the order in which they are offered.
    #[must_use]
    pub fn pictures(&self, worked: &Worked<'_>) -> Vec<Picture> {
        let shown = self.found(worked);
        let order = shuffled(worked, &self.stream, shown.len());
        let pictures = order.into_iter().filter_map(|place| shown.get(place));
        let named = pictures.zip('A'..='Z').map(|((mistake, shows), letter)| Picture {
            name: format!("{} {letter}", self.subject.noun()),
            shows: shows.clone(),
            mistake: *mistake,
        });
        named.collect()
    }

    /// The right picture, and wrong ones that look different from it and from each other.
    fn found(&self, worked: &Worked<'_>) -> Vec<(Option<&'static Misconception>, Shows)> {
        let [most, _] = OFFERED;
        let mut shown: Vec<(Option<&'static Misconception>, Shows)> = Vec::new();
        for (mistake, shows) in self.subject.drawn(worked) {
            if shown.len() < most && !shown.iter().any(|(_, other)| shows.looks_like(other)) {
                shown.push((mistake, shows));
            }
        }
        shown
    }

    /// Why the pictures cannot be offered with the numbers of a variant.
    pub(crate) fn refused(&self, worked: &Worked<'_>) -> Option<String> {
        let shown = self.found(worked);
        let [_, least] = OFFERED;
        let noun = self.subject.noun();
        if shown.is_empty() {
            return Some(format!("the right {noun} does not fit what is solved"));
        }
        let is_drawn = shown.iter().all(|(_, shows)| shows.is_drawn());
        (shown.len() < least || !is_drawn).then(|| format!("the {noun}s of usual mistakes look like the right one"))
    }

    pub(crate) fn decided(&self, worked: &Worked<'_>) -> Decision {
        let pictures = self.pictures(worked);
        Decision {
            right: pictures.iter().take_while(|picture| picture.mistake.is_some()).count(),
            because: match &self.subject {
                Subject::Diagram(diagram) => diagram.because(),
                Subject::Graph(graph) => {
                    let [_, unit] = worked.units_of(graph);
                    let unit = Some(&unit).filter(|_| worked.form.free.is_empty());
                    graph.because(&|symbol| worked.value_of(symbol), unit)
                }
            },
            behind: None,
            feedback: pictures
                .iter()
                .map(|picture| picture.mistake.map_or(OptionFeedback::Nothing, OptionFeedback::Mistake))
                .collect(),
            options: pictures.into_iter().map(|picture| picture.name).collect(),
        }
    }
}

impl Worked<'_> {
    /// The value of a quantity in SI units; not a number where it has none.
    #[must_use]
    pub fn value_of(&self, symbol: Symbol) -> f64 {
        self.variant.value(symbol).map_or(f64::NAN, |number| number.value)
    }

    /// The units of the time and of the quantity of a graph: as the problem gives such, or else the system's own.
    #[must_use]
    pub fn units_of(&self, graph: &Graph) -> [Unit; 2] {
        let symbols = graph.symbols();
        [Dimension::TIME, graph.plotted.dimension()].map(|dimension| {
            let is_like = |symbol: &&Symbol| self.problem.model().symbols.entry(**symbol).dimension == dimension;
            let given = symbols.iter().filter(is_like).find_map(|symbol| self.problem.unit_given(*symbol));
            given.unwrap_or_else(|| coherent_unit(dimension, self.problem.units()))
        })
    }
}
