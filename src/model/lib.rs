//! A scene and the laws, turned into a system of equations.

mod acting;
mod altered;
mod alternative;
mod angle_unit;
mod bond;
mod bounce_terms;
mod builder;
mod check;
mod collision;
mod contact_weight;
mod define;
mod directions;
mod displacement;
mod expression;
mod finished;
mod forces;
mod frame;
mod friction;
mod graph_of_push;
mod guide;
mod incline;
mod influence;
mod instance;
mod jerk;
mod leaving_out;
mod left_alone;
mod masses;
mod mistaken;
mod name;
mod overview;
mod pair;
mod passage;
mod place;
mod printed_graph;
mod quantity_kind;
mod read;
mod reason;
mod rotor;
mod shown;
mod single_bounce;
mod slipped;
mod space;
mod speeds;
mod spoken_term;
mod stage;
mod staged;
mod standing;
mod stored;
mod strength;
mod strings;
mod taut_string;
mod tied;
mod timeline;
mod total;
mod turned;
mod unheld;
mod unknown;
mod upright;
mod warning;
mod weight;
mod weight_in_contact;
mod wording;

pub use acting::{ActingForce, Flowing, ForceKind, Slope};
pub use alternative::Alternative;
pub use angle_unit::angle_without_unit;
pub use builder::Builder;
pub use contact_weight::ContactWeight;
pub use finished::Model;
pub use frame::{Direction, Frame, above_or_below, is_reversed};
pub use influence::{Effect, Influence, Moment, Work};
pub use instance::{Agent, Because, Impulse, Instance, Integral, Omission, Omitted, Series, Shown};
pub use mistaken::Mistaken;
pub use name::{Instant, Name, VectorName, component_name};
pub use passage::Passage;
pub use printed_graph::PrintedGraph;
pub use quantity_kind::{QuantityKind, VectorKind};
pub use reason::{Opposing, Reason};
pub use taut_string::TautString;
pub use timeline::Timeline;
pub use warning::Warning;

use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::geometry;
use momentous_laws::kinematics;
use momentous_quantity::Dimension;
use momentous_quantity::with_minus_signs;
use momentous_scene::Scene;
use momentous_solve::Condition;
use momentous_solve::Equation;
use momentous_solve::Relation;
use momentous_solve::Statement;

impl<'s> Builder<'s> {
    /// A model of a scene with the equations of its stages. `given` are names of the author's own with their dimensions; the
    /// place of `unmeasured` ones in a term says theirs.
    ///
    /// # Errors
    /// Everything in the scene that does not fit together.
    pub fn of(
        scene: &'s Scene,
        given: &[(String, Dimension)],
        unmeasured: &BTreeSet<String>,
    ) -> Result<Self, Vec<Fault>> {
        let faults = check::check(scene);
        if !faults.is_empty() {
            return Err(faults);
        }
        let mut builder = Self::with_givens(scene, given, unmeasured);
        builder.times_of_instants();
        Ok(builder)
    }

    /// The symbol of a name that the problem mentions, with its definition added to the model.
    pub fn mention(&mut self, name: &str) -> Option<Symbol> {
        let symbol = self.resolve(name)?;
        self.counts_all_that_turns(symbol);
        self.mentions.insert(name.to_owned(), symbol);
        Some(symbol)
    }

    /// An equation or condition text as a term, its names defined on the way; faults are noted.
    pub fn term(&mut self, text: &str, path: &Path) -> Expr {
        self.read_any(text, path)
    }

    /// The fault of a name that the scene does not make.
    #[must_use]
    pub fn unknown(&mut self, name: &str) -> Fault {
        self.unknown_name(name)
    }

    /// Adds an equation that the problem states: `left = right`.
    pub fn relation(&mut self, equation: &str, because: &str, path: &Path) {
        let Some((left, right)) = equation.split_once('=') else {
            let fault = Fault::new(Code::Syntax, format!("`{equation}` is not an equation"));
            self.faults.push(fault.help("write two sides with `=` between them").at_path(path.clone()));
            return;
        };
        let sides = (self.read_any(left, path), self.read_any(right, path));
        if let Expr::Symbol(symbol) = sides.0
            && !self.unmeasured.contains(&self.symbols.entry(symbol).name)
        {
            self.measure(&sides.1, self.symbols.entry(symbol).dimension);
        }
        self.law(&geometry::RELATION, None, Because::written(because), sides);
    }

    /// Takes a quantity of the author's own, given by positive values only, to be positive. Quantities that the scene makes
    /// may be of either sign, whatever is given.
    pub fn assume_positive(&mut self, name: &str, symbol: Symbol) {
        let dimension = self.symbols.entry(symbol).dimension;
        if !check::is_structural(self.scene, name) && !check::is_angular_impulse(self.scene, name, dimension) {
            self.system.positive.insert(symbol);
        }
    }

    /// Whether a quantity has no meaning below zero.
    #[must_use]
    pub fn is_positive(&self, symbol: Symbol) -> bool {
        self.system.positive.contains(&symbol)
    }

    /// A whole number that only a question names, where the scene uses the name for nothing else.
    pub fn number_counted(&mut self, name: &str) -> Option<Symbol> {
        if !name::is_bare_name(name) || check::is_structural(self.scene, name) {
            return None;
        }
        let symbol = self.symbol_of(Name::written(name), Dimension::NONE, "");
        self.counts.insert(symbol);
        self.mentions.insert(name.to_owned(), symbol);
        Some(symbol)
    }

    /// Whether a quantity is a number of something.
    #[must_use]
    pub fn is_count(&self, symbol: Symbol) -> bool {
        self.counts.contains(&symbol)
    }

    /// A name of the author's own that stands for a term: its dimension is the term's.
    pub fn declare(&mut self, name: &str, text: &str, meaning: &str, path: &Path) {
        let term = self.read_any(text, path);
        let dimension = term.dimension(&self.symbols).unwrap_or_default();
        self.symbol_of(Name::written(name), dimension, meaning);
    }

    /// A condition on terms; it is not added to the system.
    pub fn compare(&mut self, left: Expr, relation: Relation, right: Expr, reason: Reason) -> Condition {
        self.condition(left, relation, right, reason)
    }

    /// A term with every quantity that a law writes in terms of `symbol` replaced by what the law says.
    #[must_use]
    pub fn written_out(&self, term: &Expr, symbol: Symbol) -> Expr {
        term.substitute(&|part| {
            self.system.equations.iter().find_map(|equation| match &equation.statement {
                Statement::Equal { left, right } if *left == Expr::from(part) && right.contains(symbol) => {
                    Some(right.clone())
                }
                _ => None,
            })
        })
    }

    /// Why a law writes some quantity of a term in terms of `symbol`.
    #[must_use]
    pub fn reason_of(&self, term: &Expr, symbol: Symbol) -> Option<&Because> {
        let defines = |left: &Expr, right: &Expr| {
            matches!(left, Expr::Symbol(symbol) if term.contains(*symbol)) && right.contains(symbol)
        };
        let equation =
            self.system.equations.iter().find(
                |equation| matches!(&equation.statement, Statement::Equal { left, right } if defines(left, right)),
            )?;
        self.instances.get(equation.tag).map(|instance| &instance.because)
    }

    /// The equation that `unknown` is the first integer, from `from` upwards, for which the comparison holds; `because`
    /// says why the comparison is written as it is.
    pub fn first_integer(
        &mut self,
        because: Option<&str>,
        unknown: Symbol,
        from: i64,
        left: Expr,
        relation: Relation,
        right: Expr,
    ) -> Equation {
        let sought = "find the smallest whole number for which";
        let because = because.map_or_else(|| sought.to_owned(), |because| format!("{because}; {sought}"));
        let tag = self.instance(&kinematics::COUNT, None, because, None);
        Equation {
            statement: Statement::FirstInteger { unknown, from, left, relation, right },
            tag,
            cost: builder::LAW_COST,
        }
    }

    /// The equation of the boundary between where a comparison holds and where it does not; it is not added to the system.
    pub fn boundary(&mut self, left: Expr, right: Expr) -> Equation {
        let because = "the condition just ceases to hold where its two sides are equal";
        self.stated(builder::LAW_COST, &geometry::BOUNDARY, None, because, (left, right), None)
    }

    /// A direction counted from an axis of the author's choice: the angle itself, or one that follows from it. `None`
    /// where `from` is not an axis of the scene.
    pub fn counted_from(&mut self, angle: Symbol, from: &str, clockwise: bool) -> Option<Symbol> {
        let start = self.axis_direction(from)?;
        if start.quarters == 0 && !clockwise {
            return Some(angle);
        }
        let (name, meaning) = (self.name(angle).clone(), self.symbols.entry(angle).meaning.clone());
        let sense = if clockwise { "clockwise" } else { "counter-clockwise" };
        let kind = match name.kind {
            QuantityKind::Direction(vector) => QuantityKind::CountedDirection(vector),
            other => QuantityKind::OwnAngle(format!("phi_{}", other.spelling())),
        };
        let symbol = self.symbol(Name { kind, ..name }, meaning);
        let (law, because, value) = match self.directions.get(&angle) {
            Some([x, y]) => {
                let [along, across] = start.from_axis(x, y);
                let across = if clockwise { -across } else { across };
                (&geometry::DIRECTION, "the components give the angle", across.atan2(along))
            }
            None => {
                let turned = Expr::from(angle) - self.whole_angle(&start);
                (&geometry::COUNTED, "the question asks for the angle", if clockwise { -turned } else { turned })
            }
        };
        let because = format!("{because}, measured {sense} from {}", with_minus_signs(from));
        self.law(law, None, because, (symbol.into(), value));
        Some(symbol)
    }

    /// Notes a fault found by the caller.
    pub fn fault(&mut self, fault: Fault) {
        self.faults.push(fault);
    }

    /// The finished model.
    ///
    /// # Errors
    /// Every fault noted on the way, and every equation whose sides differ in dimension.
    pub fn finish(mut self) -> Result<Model, Vec<Fault>> {
        if !self.faults.is_empty() {
            return Err(each_once(self.faults));
        }
        let stated = self.choices.iter().flatten().flat_map(|way| &way.equations);
        for equation in self.system.equations.iter().chain(stated) {
            let Statement::Equal { left, right } = &equation.statement else { continue };
            let law = self.instances.get(equation.tag).map_or("an equation", |instance| instance.law.name);
            match (left.clone() - right.clone()).dimension(&self.symbols) {
                Ok(_) => {}
                Err(clash) => self.faults.push(
                    Fault::new(Code::Dimension, format!("the dimensions of {law} do not agree: {clash}"))
                        .help("check the units of what is given"),
                ),
            }
        }
        if !self.faults.is_empty() {
            return Err(self.faults);
        }
        Ok(Model {
            symbols: self.symbols,
            names: self.names,
            system: self.system,
            choices: self.choices,
            distances: self.distances,
            instances: self.instances,
            reasons: self.reasons,
            reasons_of_stages: self.reasons_of_stages,
            omissions: self.omissions,
            impulses: self.impulses,
            weights: self.weights,
            forces: self.forces,
            flowing: self.flowing,
            literals: self.literals,
            frames: self.frames,
            strings: self.strings,
            slopes: self.slopes,
            passages: self.passages,
            graph: self.graph,
            free: self.free,
            expressions: self.expressions,
            mentions: self.mentions,
        })
    }
}

/// The faults without repetition: a term that is read for several laws is wrong once.
fn each_once(faults: Vec<Fault>) -> Vec<Fault> {
    let mut kept: Vec<Fault> = Vec::new();
    for fault in faults {
        if !kept.contains(&fault) {
            kept.push(fault);
        }
    }
    kept
}
