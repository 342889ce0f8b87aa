//! The energy that an impact loses, as a check: what it is before and after, and what a formula of its own says.

use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::Operator;
use momentous_expr::Symbol;
use momentous_laws::energy;
use momentous_laws::restitution;
use momentous_model::Instance;
use momentous_problem::Closeness;
use momentous_scene::Stage;
use momentous_solve::Equation;
use momentous_solve::Statement;

use super::super::Block;
use super::super::terms::display::Display;
use super::super::terms::entry::Item;
use super::super::terms::ledger::Ledger;
use super::super::terms::term::Term;

/// The energy that an impact loses, before the numbers are known.
pub(super) struct Loss {
    lost: Symbol,
    words: Block,
    /// The difference of the energies before and after.
    difference: Term,
    /// The quantity by a formula of its own.
    formula: Option<Term>,
}

/// Every impact whose loss of energy the reader can work out.
pub(super) fn losses(display: Display<'_>) -> Vec<Loss> {
    let known = display.known_to_the_reader();
    let equations = || display.worked.leaf().system.equations.iter();
    // An energy that nobody asks for is worked out on the spot, from masses and velocities.
    let energies = equations().filter_map(|equation| {
        let law = instance(display, equation)?.law.id;
        match &equation.statement {
            Statement::Equal { left: Expr::Symbol(energy), right } if law == energy::KINETIC.id => {
                right.symbols().is_subset(&known).then_some(*energy)
            }
            _ => None,
        }
    });
    let known: BTreeSet<Symbol> = energies.chain(known.iter().copied()).collect();
    let told = |loss: &Loss| loss.difference.expr.symbols().is_subset(&known);
    equations().filter_map(|equation| loss(display, equation)).filter(told).collect()
}

fn instance<'a>(display: Display<'a>, equation: &Equation) -> Option<&'a Instance> {
    display.worked.problem.model().instances.get(equation.tag)
}

fn loss(display: Display<'_>, equation: &Equation) -> Option<Loss> {
    let instance = instance(display, equation).filter(|instance| instance.law.id == energy::LOSS.id)?;
    let Statement::Equal { left: Expr::Symbol(lost), right } = &equation.statement else { return None };
    let stage = instance.stage?;
    let phrase = display.worked.problem.model().phrase(&display.worked.problem.loaded().draft.scene, stage);
    (!display.is_open(*lost)).then(|| Loss {
        lost: *lost,
        words: Block::text(&format!("Kinetic energy lost in {phrase}:")),
        difference: display.term(right.clone()),
        formula: formula(display, stage)
            .filter(|formula| display.worked.are_equal(right, formula))
            .map(|formula| display.term(formula)),
    })
}

impl Loss {
    /// Enters the loss into the ledger of a solution.
    pub(crate) fn enter(&self, display: Display<'_>, ledger: &mut Ledger) {
        for term in [Some(&self.difference), self.formula.as_ref()].into_iter().flatten() {
            display.enter_term(ledger, term, Item::Quantity(self.lost));
        }
    }

    /// `T_1 - T_2 = 50.06 J - 16.31 J = 33.75 J`, that it is not negative, and what else it equals.
    pub(crate) fn blocks(&self, display: Display<'_>) -> Option<Vec<Block>> {
        if !self.difference.is_multiple || !self.difference.mentions.iter().all(|symbol| display.has_number(*symbol)) {
            return None;
        }
        display.worked.variant.value(self.lost)?;
        let equals = || Math::Operator(Operator::Equals);
        let equation = |parts: Vec<Math>| Block::Equation { lines: vec![Math::Row(parts)], number: None };
        let numbers = display.substituted(&self.difference).map(|numbers| vec![equals(), numbers]);
        let sum = [vec![self.difference.symbols.clone()], numbers.unwrap_or_default()].concat();
        let result = display.quantity(self.lost);
        let gains = display.worked.variant.value(self.lost).is_some_and(|lost| lost.value < -lost.error);
        if gains {
            let words =
                Block::text("It is negative: kinetic energy is gained, so something supplies energy in the impact.");
            return Some(vec![self.words.clone(), equation([sum, vec![equals(), result]].concat()), words]);
        }
        let mut blocks = vec![self.words.clone(), equation([sum, vec![equals(), result]].concat())];
        let lost = display.worked.closeness_to_zero(&self.difference.expr);
        let is_elastic = lost.is_equal();
        blocks.push(Block::text(match (lost, &self.formula) {
            (Closeness::Exact, _) => "None is lost: the impact is elastic.",
            (Closeness::WithinData, _) => "Within the precision of the data none is lost: the impact is elastic.",
            (_, None) => "It is not negative, as it must be where nothing supplies energy.",
            (_, Some(_)) => "It is not negative, as it must be where nothing supplies energy, and equals",
        }));
        if let Some(formula) = self.formula.as_ref().filter(|_| !is_elastic) {
            blocks.push(equation(vec![formula.symbols.clone(), equals(), display.quantity(self.lost)]));
        }
        Some(blocks)
    }
}

/// `1/2 m_A m_B / (m_A + m_B) (1 - e^2) (approach)^2`, for an impact of two bodies whose restitution the reader knows.
fn formula(display: Display<'_>, stage: usize) -> Option<Expr> {
    let worked = display.worked;
    let Some(Stage::Impact(impact)) = worked.problem.loaded().draft.scene.stages.get(stage) else { return None };
    let [first, second] = impact.between.as_ref()?;
    // A guide takes part in the impact, so that the two masses alone do not decide.
    let scene = &worked.problem.loaded().draft.scene;
    let is_guided = |body: &String| {
        scene.members(body).into_iter().any(|member| scene.bodies.get(member).is_some_and(|body| body.guide.is_some()))
    };
    if is_guided(first) || is_guided(second) {
        return None;
    }
    let stated = worked.leaf().system.equations.iter().find(|equation| {
        instance(display, equation)
            .is_some_and(|instance| instance.stage == Some(stage) && instance.law.id == restitution::RESTITUTION.id)
    })?;
    let Statement::Equal { right: Expr::Product(factors), .. } = &stated.statement else { return None };
    let [e @ Expr::Symbol(coefficient), approach] = &factors[..] else { return None };
    let mass = |body: &String| -> Option<Symbol> {
        let written = scene.mass_term(body, stage + 1).map(|term| term.0.trim().to_owned());
        let named = || {
            scene.mass_since(body, stage + 1).map_or_else(|| format!("m_{body}"), |since| format!("m_{body}{since}"))
        };
        worked.problem.model().symbol_of(&written.unwrap_or_else(named))
    };
    let [a, b] = [Expr::from(mass(first)?), Expr::from(mass(second)?)];
    let known = display.known_to_the_reader();
    let is_known = [&a, &b, approach].into_iter().all(|term| term.symbols().is_subset(&known));
    if !is_known || !known.contains(coefficient) {
        return None;
    }
    Some(energy::lost_in_impact([&a, &b], e, approach))
}
