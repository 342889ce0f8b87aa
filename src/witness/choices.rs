//! Questions that are not a number, answered from what the simulation finds.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_problem::Ask;
use momentous_problem::ChoicePart;
use momentous_problem::Claim;
use momentous_problem::Count;
use momentous_problem::Worked;
use momentous_problem::orders;
use momentous_problem::split_relation;
use momentous_scene::Scene;
use momentous_scene::Stage;
use momentous_scene::stage::Partners;
use momentous_simulate::scene::is_impulsive;
use momentous_simulate::scene::part_along;
use momentous_solve::Bounded;

use super::case::Case;
use super::conserved::is_conserved;
use super::crossing::holds;
use super::pictures;
use super::simulation::Measurement;
use super::simulation::UNCHANGED;
use super::simulation::Witness;
use super::worlds;

/// The kinds of impact in the order in which they are offered.
const ELASTIC: usize = 0;
const INELASTIC: usize = 1;
const PLASTIC: usize = 2;

/// Which phrase is right, by the simulation; none where it finds nothing of it.
pub(super) fn chosen(
    case: &Case<'_>,
    witness: &Witness<'_>,
    ask: &Ask,
    choice: &ChoicePart,
    tolerance: f64,
) -> Option<usize> {
    let yes = |holds: bool| usize::from(!holds);
    match (ask, choice) {
        (_, ChoicePart::Holds(claim)) => claimed(case, witness, claim).map(yes),
        (_, ChoicePart::Order(symbols)) => {
            let name = |symbol| case.problem.model().symbols.entry(symbol).name.clone();
            let mut reached = Vec::new();
            for symbol in symbols {
                reached.push((witness.seen(&name(*symbol))?, *symbol));
            }
            reached.sort_by(|one, other| one.0.value.total_cmp(&other.0.value));
            if reached.windows(2).any(|pair| pair[1].0.value - pair[0].0.value <= pair[0].0.error + pair[1].0.error) {
                return None;
            }
            let sorted: Vec<_> = reached.into_iter().map(|(_, symbol)| symbol).collect();
            orders(symbols).iter().position(|order| *order == sorted)
        }
        (_, ChoicePart::Offered(offer)) => {
            let worked = Worked::new(case.problem, case.variant)?;
            let name = |symbol: &Symbol| &case.problem.model().symbols.entry(*symbol).name;
            match offer.always_right() {
                // What the option prints is compared as a quantity; here it must only be one that the simulation finds.
                Some([]) => None,
                Some(printed) => {
                    let is_found = printed.iter().all(|symbol| witness.seen(name(symbol)).is_some());
                    is_found.then(|| choice.decided(&worked).right)
                }
                None => offer.right_by(&worked, &|claim| claimed(case, witness, claim)),
            }
        }
        (_, ChoicePart::Pictured(pictured)) => {
            pictures::fitting(witness, pictured, &Worked::new(case.problem, case.variant)?)
        }
        (Ask::Enough(ask), _) => worlds::settle(case, &ask.enough, tolerance).map(yes),
        (Ask::Conserved(ask), _) => is_conserved(case, witness, ask).map(yes),
        (Ask::Classify(ask), _) => kind(case.scene, witness, witness.stage_of(ask.stage.as_deref())?),
        (Ask::Impulsive(ask), _) => {
            let stage = witness.stage_of(ask.stage.as_deref())?;
            let value = |name: &str| witness.value(name);
            is_impulsive(case.scene, stage, &ask.impulsive, ask.on.as_deref(), &value, tolerance).map(yes)
        }
        _ => None,
    }
}

/// Whether a claim holds of what the simulation finds; none where it finds nothing of it.
fn claimed(case: &Case<'_>, witness: &Witness<'_>, claim: &Claim) -> Option<bool> {
    let sides = [&claim.left, &claim.right].map(|side| witness.evaluated(side));
    if sides.iter().all(Option::is_none) {
        return None;
    }
    let of_side = |(side, measurement): (&Expr, Option<Measurement>)| {
        measurement.unwrap_or(Measurement { value: said(case, side), error: 0.0 })
    };
    let [mut left, right] = [(&claim.left, sides[0]), (&claim.right, sides[1])].map(of_side);
    left.value -= claim.whole_turns(left.value - right.value);
    holds(claim.relation, left, right)
}

/// The value of a term by the variant's own values.
fn said(case: &Case<'_>, side: &Expr) -> f64 {
    side.evaluate(&|symbol| case.variant.value(symbol).map_or(f64::NAN, |value| value.value))
}

/// The kind that an impact was: whether energy is lost, and whether what touched still moves apart.
fn kind(scene: &Scene, witness: &Witness<'_>, stage: usize) -> Option<usize> {
    let Some(Stage::Impact(impact)) = scene.stages.get(stage).filter(|_| witness.has_run(stage)) else { return None };
    let partners = impact.partners()?;
    let (first, other) = match partners {
        Partners::Bodies(first, second) => (first, Some(second)),
        Partners::Surface(body, _) => (body, None),
    };
    let axes = scene.axes.rectangular();
    let number = |name: &str| witness.value(name);
    let (mut energies, mut speeds) = ([0.0; 2], [0.0; 2]);
    for (side, (energy, widest)) in energies.iter_mut().zip(&mut speeds).enumerate() {
        let instant = stage + 1 + side;
        let mut apart = [0.0; 3];
        for (axis, _) in &axes {
            let letter = if axes.len() > 1 { axis.letter() } else { "" };
            let part = |body: &str| witness.carried("v", body, instant, letter);
            apart[*axis as usize] = part(first)? - other.map_or(Some(0.0), part)?;
        }
        let square: f64 = apart.iter().map(|difference| difference * difference).sum();
        (*energy, *widest) = match partners {
            Partners::Bodies(first, second) => {
                // Smooth bodies touch along the line of impact only.
                let line = impact.line_of_impact.as_ref();
                let along = line.and_then(|line| part_along(scene, &line.0, apart, &number));
                let energy = |body: &str| witness.carried("T", body, instant, "");
                (energy(first)? + energy(second)?, along.unwrap_or_else(|| libm::sqrt(square)).abs())
            }
            Partners::Surface(_, surface) => {
                // A surface moves along its normal, and energy is lost or not as it sees the body.
                let surface = scene.surfaces.get(surface)?;
                let moves = surface.velocity.as_ref().map_or(Some(0.0), |term| witness.value(&term.0))?;
                let along = part_along(scene, &surface.normal.0, apart, &number)?;
                (square - 2.0 * along * moves + moves * moves, (along - moves).abs())
            }
        };
    }
    let [meeting, parting] = speeds;
    Some(if parting <= UNCHANGED * meeting {
        PLASTIC
    } else if (energies[0] - energies[1]).abs() <= UNCHANGED * energies[0] {
        ELASTIC
    } else {
        INELASTIC
    })
}

/// Which of two roots happens, the greater or the lesser, in the order in which they are offered: the one that the simulation finds.
pub(super) fn taken_root(worked: &Worked<'_>, witness: &Witness<'_>, symbol: Symbol) -> Option<usize> {
    let simulated = witness.seen(&worked.problem.model().symbols.entry(symbol).name)?.value;
    let roots = worked.every_root(symbol);
    let [one, other] = roots[..] else { return None };
    let apart = |root: &Bounded| (root.value - simulated).abs();
    let (near, far) = if apart(&one) < apart(&other) { (one, other) } else { (other, one) };
    Some(usize::from(near.value < far.value))
}

/// Whether a number is the first that satisfies its condition: it does, and the one before does not.
pub(super) fn is_first(worked: &Worked<'_>, scene: &Scene, ask: &Count, answer: f64, tolerance: f64) -> Option<bool> {
    let (name, condition) = ask.count.trim().strip_prefix("first ")?.split_once(" with ")?;
    let (left, relation, right) = split_relation(condition)?;
    let symbol = worked.problem.model().symbol_of(name.trim())?;
    let satisfied = |number: f64| -> Option<bool> {
        let replaced = vec![(symbol, number)];
        let case = Case { problem: worked.problem, scene, variant: worked.variant, replaced, known: None };
        let witness = Witness::new(&case, tolerance);
        let told = |text: &str| witness.value(text).map(|value| Measurement { value, error: 0.0 });
        let side = |text: &str| witness.seen(text).or_else(|| told(text));
        holds(relation, side(left)?, side(right)?)
    };
    Some(satisfied(answer)? && (answer <= 1.0 || !satisfied(answer - 1.0)?))
}
