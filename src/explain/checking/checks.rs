//! Checks that a student can copy: both sides of every balance, the energy, the extremes.

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::Operator;
use momentous_expr::Symbol;
use momentous_laws::angular;
use momentous_laws::bouncing;
use momentous_laws::force;
use momentous_laws::mass_centre;
use momentous_laws::momentum;
use momentous_laws::orbit;
use momentous_laws::restitution;
use momentous_laws::variable_mass;
use momentous_quantity::Dimension;
use momentous_solve as solve;
use momentous_solve::Equation;
use momentous_solve::Relation;
use momentous_solve::Statement;

use super::super::Block;
use super::super::Inline;
use super::super::terms::display::Display;
use super::super::terms::display::has_pieces;
use super::super::terms::entry::Item;
use super::super::terms::ledger::Ledger;
use super::super::terms::term::Measured;
use super::super::terms::term::Term;
use super::super::wording::capitalised;
use super::super::working::derivation::is_definition;
use super::energy;
use super::energy::Loss;
use super::limits;

/// The most balances that are shown.
const MOST: usize = 4;

/// Laws whose two sides are shown to agree, by their ids, with what the two sides are.
const BALANCES: &[(&str, &str)] = &[
    (momentum::CONSERVATION.id, "Momentum before and after:"),
    (momentum::IMPULSE_MOMENTUM.id, "Initial momentum plus impulse, and final momentum:"),
    (force::IMPULSE.id, "Impulse, and the integral of the force over time:"),
    (variable_mass::GAINING.id, "Initial momentum plus impulse, and final momentum with the load:"),
    (mass_centre::MOTION.id, "Initial momentum plus impulse, and final momentum:"),
    (restitution::RESTITUTION.id, "Velocity of separation, and e times the velocity of approach:"),
    (restitution::RESTITUTION_SURFACE.id, "Velocity away from the surface, and e times the velocity towards it:"),
    (angular::ANGULAR_MOMENTUM.id, "Angular momentum, as found and by its definition:"),
    (angular::ANGULAR_IMPULSE.id, "Initial angular momentum plus angular impulse, and final angular momentum:"),
    (angular::CENTRAL.id, "Radius times transverse velocity, before and after:"),
    (orbit::ORBIT_ENERGY.id, "Energy per unit mass, before and after:"),
    (bouncing::BOUNCE_TIME.id, "The time, and the sum of the times of flight:"),
];

/// The checks of the solutions of a way, before the numbers are known.
pub(crate) struct Checks {
    balances: Vec<Balance>,
    losses: Vec<Loss>,
    conditions: Vec<Condition>,
}

/// Two sides that must be equal, and what they are.
struct Balance {
    words: Block,
    sides: [Term; 2],
}

/// A condition between two terms, in words and symbols.
struct Condition {
    words: String,
    sides: [Term; 2],
    relation: Relation,
    /// The unit in which both are printed.
    unit: Measured,
}

impl Checks {
    pub(crate) fn new(display: Display<'_>) -> Self {
        Self { balances: balances(display), losses: energy::losses(display), conditions: conditions(display) }
    }

    /// The checks of a variant; none for a form that only asks for concepts.
    pub(crate) fn blocks(&self, display: Display<'_>) -> Vec<Block> {
        if display.worked.form.wanted().next().is_none() {
            return Vec::new();
        }
        let mut blocks = vec![Block::text("Check:")];
        for (place, Balance { words, sides }) in self.shown_balances(display) {
            let result = result(display, place, sides);
            let lines = sides.iter().map(|side| evaluated(display, side, result)).collect();
            blocks.extend([words.clone(), Block::Equation { lines, number: None }]);
        }
        let means: Vec<Vec<Inline>> = means(display).map(|mean| lies_between(display, mean)).collect();
        blocks.extend((!means.is_empty()).then_some(Block::List(means)));
        blocks.extend(self.losses.iter().filter_map(|loss| loss.blocks(display)).flatten());
        blocks.extend(self.shown_conditions(display).map(|(place, condition)| condition.block(display, place)));
        blocks.extend(limits::limits(display));
        if blocks.len() > 1 { blocks } else { Vec::new() }
    }

    /// Enters what the checks compute into the ledger of a solution.
    pub(crate) fn enter(&self, display: Display<'_>, ledger: &mut Ledger) {
        if display.worked.form.wanted().next().is_none() {
            return;
        }
        for (place, Balance { sides, .. }) in self.shown_balances(display) {
            let result = result(display, place, sides);
            if result == Item::Balance(place) {
                display.enter_value(ledger, &sides[0].expr, display.size(&sides[0].unit), result);
            }
            for side in sides {
                display.enter_term(ledger, side, result);
            }
        }
        for mean in means(display) {
            for symbol in mean {
                display.enter(ledger, symbol);
            }
            let [least, centre, greatest] = mean.map(Item::Quantity);
            ledger.ordered([least, centre], false);
            ledger.ordered([centre, greatest], false);
        }
        limits::enter(display, ledger);
        for loss in &self.losses {
            loss.enter(display, ledger);
        }
        for (place, Condition { sides, unit, .. }) in self.shown_conditions(display) {
            for (side, term) in sides.iter().enumerate() {
                display.enter_value(ledger, &term.expr, display.size(unit), Item::Side(place, side));
            }
        }
    }

    /// The balances whose numbers are known, each with its place.
    fn shown_balances(&self, display: Display<'_>) -> impl Iterator<Item = (usize, &Balance)> {
        let balances = self.balances.iter().enumerate();
        balances.filter(move |(_, balance)| has_numbers(display, &balance.sides)).take(MOST)
    }

    /// The conditions whose numbers are known, each with its place.
    fn shown_conditions(&self, display: Display<'_>) -> impl Iterator<Item = (usize, &Condition)> {
        let is_real = move |sides: &[Term; 2]| !sides.iter().any(|side| display.value_of(&side.expr).is_nan());
        let conditions = self.conditions.iter().enumerate();
        conditions.filter(move |(_, condition)| has_numbers(display, &condition.sides) && is_real(&condition.sides))
    }
}

fn has_numbers(display: Display<'_>, sides: &[Term; 2]) -> bool {
    sides.iter().all(|side| side.is_multiple && side.mentions.iter().all(|symbol| display.has_number(*symbol)))
}

/// The value of both sides of a balance: a quantity that is printed exactly, where one of them is nothing else.
fn result(display: Display<'_>, place: usize, sides: &[Term; 2]) -> Item {
    let named = sides.iter().find_map(|side| match &side.expr {
        Expr::Symbol(symbol) if display.exact(*symbol).is_some() => Some(Item::Quantity(*symbol)),
        _ => None,
    });
    named.unwrap_or(Item::Balance(place))
}

/// The balances between quantities that the reader knows, where that is more than reading off a step.
fn balances(display: Display<'_>) -> Vec<Balance> {
    let leaf = display.worked.leaf();
    let known = display.known_to_the_reader();
    let steps = leaf.answer_steps();
    let is_read_off = |place: usize, left: &Expr, right: &Expr| {
        steps.iter().any(|step| step.equations == [place] && is_definition(step, left, right))
    };
    let balance = |(place, equation): (usize, &Equation)| {
        let Statement::Equal { left, right } = &equation.statement else { return None };
        let words = words_of(display, equation)?;
        let told = |side: &Expr| side.symbols().is_subset(&known);
        // A side that is nothing tells nothing.
        let is_nothing = left.is_zero() || right.is_zero();
        let computes = !is_nothing && [left, right].into_iter().any(|side| !matches!(side, Expr::Symbol(_)));
        // Which piece of a force counts is settled in the steps.
        let in_pieces = has_pieces(left) || has_pieces(right);
        let is_shown = told(left) && told(right) && computes && !in_pieces && !is_read_off(place, left, right);
        let sides = || [left, right].map(|side| display.term(side.clone()));
        is_shown.then(|| Balance { words: Block::text(words), sides: sides() })
    };
    let all = &leaf.system.equations;
    // The end of one stage and the start of the next state the same.
    let is_new = |(place, equation): &(usize, &Equation)| {
        !all.iter().take(*place).any(|other| other.statement == equation.statement)
    };
    all.iter().enumerate().filter(is_new).filter_map(balance).collect()
}

/// The positions and velocities of centres of mass, each between the least and the greatest of those of its bodies.
fn means(display: Display<'_>) -> impl Iterator<Item = [Symbol; 3]> {
    let model = display.worked.problem.model();
    let known = display.known_to_the_reader();
    let stated = display.worked.leaf().system.equations.iter().filter(|equation| {
        model.instances.get(equation.tag).is_some_and(|instance| instance.law.id == mass_centre::MASS_CENTRE.id)
    });
    stated.filter_map(move |equation| {
        let Statement::Equal { left: Expr::Product(left), right: Expr::Sum(terms) } = &equation.statement else {
            return None;
        };
        let Expr::Symbol(centre) = left.last()? else { return None };
        let dimension = model.symbols.entry(*centre).dimension;
        let mut parts: Vec<Symbol> = terms
            .iter()
            .flat_map(Expr::symbols)
            .filter(|symbol| model.symbols.entry(*symbol).dimension == dimension)
            .collect();
        let value = |symbol: Symbol| display.value_of(&symbol.into());
        parts.sort_by(|a, b| value(*a).total_cmp(&value(*b)));
        let (least, greatest) = (*parts.first()?, *parts.last()?);
        let mean = [least, *centre, greatest];
        let told = mean.iter().all(|symbol| known.contains(symbol) && display.has_number(*symbol));
        (told && value(least) < value(greatest)).then_some(mean)
    })
}

fn lies_between(display: Display<'_>, [least, centre, greatest]: [Symbol; 3]) -> Vec<Inline> {
    let shown = |symbol: Symbol| Inline::Math(display.quantity(symbol));
    let is_place = display.worked.problem.model().symbols.entry(centre).dimension == Dimension::LENGTH;
    let what = if is_place { "position" } else { "velocity" };
    vec![
        Inline::Math(display.name(centre)),
        Inline::Text(format!(" lies between the least {what}, ")),
        shown(least),
        Inline::Text(", and the greatest, ".into()),
        shown(greatest),
        Inline::Text(", as an average must.".into()),
    ]
}

fn words_of(display: Display<'_>, equation: &Equation) -> Option<&'static str> {
    let instance = display.worked.problem.model().instances.get(equation.tag)?;
    let (_, words) = BALANCES.iter().find(|(id, _)| *id == instance.law.id)?;
    // What the momenta of the bodies of an impact say together need not be said again of each.
    let again = instance.law.id == momentum::IMPULSE_MOMENTUM.id && {
        let system = &display.worked.leaf().system;
        let instances = &display.worked.problem.model().instances;
        let same = |other: &Equation| {
            instances
                .get(other.tag)
                .is_some_and(|other| other.stage == instance.stage && other.law.id == momentum::CONSERVATION.id)
        };
        system.equations.iter().any(same)
    };
    (!again).then_some(words)
}

/// A term in symbols, with numbers, and its value.
fn evaluated(display: Display<'_>, side: &Term, item: Item) -> Math {
    let value = display.evaluated(&side.expr, &side.unit, item);
    let numbers = display.substituted(side).filter(|numbers| *numbers != value);
    let mut parts = vec![side.symbols.clone()];
    if let Some(numbers) = numbers.filter(|_| !matches!(side.expr, Expr::Symbol(_))) {
        parts.extend([Math::Operator(Operator::Equals), numbers]);
    }
    parts.extend([Math::Operator(Operator::Equals), value]);
    Math::Row(parts)
}

/// The conditions that the bodies do not pass through each other, where the reader knows how they move.
fn conditions(display: Display<'_>) -> Vec<Condition> {
    let known = display.known_to_the_reader();
    let reasons = &display.worked.problem.model().reasons;
    let condition = |condition: &solve::Condition| {
        let kept = reasons.get(condition.tag)?.what_holds()?;
        let told = [&condition.left, &condition.right].iter().all(|side| side.symbols().is_subset(&known));
        let (unit, _) = display.measure(&(condition.left.clone() - condition.right.clone()));
        told.then(|| Condition {
            unit,
            relation: condition.relation,
            words: format!("{}: ", capitalised(&kept)),
            sides: [&condition.left, &condition.right].map(|side| display.term(side.clone())),
        })
    };
    display.worked.leaf().system.conditions.iter().filter_map(condition).collect()
}

impl Condition {
    /// The condition with the numbers.
    fn block(&self, display: Display<'_>, place: usize) -> Block {
        let in_symbols = self.sides.each_ref().map(|side| side.symbols.clone());
        let number = |side: usize| display.evaluated(&self.sides[side].expr, &self.unit, Item::Side(place, side));
        let in_numbers = [number(0), number(1)];
        let holds = |[left, right]: [Math; 2]| Inline::Math(Math::relation(left, self.relation.operator(), right));
        Block::Paragraph(vec![
            Inline::Text(self.words.clone()),
            holds(in_symbols),
            Inline::Text(", since ".into()),
            holds(in_numbers),
            Inline::Text(".".into()),
        ])
    }
}
