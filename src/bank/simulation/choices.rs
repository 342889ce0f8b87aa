//! Questions that are not a number, answered from what the simulation finds.

use crate::expr::Expr;
use crate::expr::Symbol;
use crate::problem::Ask;
use crate::problem::ChoicePart;
use crate::problem::Conservable;
use crate::problem::Conserved;
use crate::problem::Count;
use crate::problem::Worked;
use crate::problem::orders;
use crate::problem::split_relation;
use crate::scene::Scene;
use crate::scene::Stage;
use crate::scene::stage::Partners;
use crate::simulate::scene::is_impulsive;
use crate::solve::Bounded;

use super::crossing::holds;
use super::witness::Case;
use super::witness::Seen;
use super::witness::Witness;

/// The share of a momentum or an energy below which a change of it is none: far above errors of runs, far below changes that
/// anybody would ask for.
const UNCHANGED: f64 = 1e-7;

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
        (_, ChoicePart::Holds(claim)) => {
            let seen = [&claim.left, &claim.right].map(|side| witness.evaluated(side));
            if seen.iter().all(Option::is_none) {
                return None;
            }
            let of_side =
                |(side, seen): (&Expr, Option<Seen>)| seen.unwrap_or(Seen { value: said(case, side), error: 0.0 });
            let [left, right] = [(&claim.left, seen[0]), (&claim.right, seen[1])].map(of_side);
            holds(claim.relation, left, right).map(yes)
        }
        (_, ChoicePart::Order(symbols)) => {
            let name = |symbol| case.problem.model().symbols.entry(symbol).name.clone();
            let mut seen = Vec::new();
            for symbol in symbols {
                seen.push((witness.seen(&name(*symbol))?, *symbol));
            }
            seen.sort_by(|one, other| one.0.value.total_cmp(&other.0.value));
            if seen.windows(2).any(|pair| pair[1].0.value - pair[0].0.value <= pair[0].0.error + pair[1].0.error) {
                return None;
            }
            let sorted: Vec<_> = seen.into_iter().map(|(_, symbol)| symbol).collect();
            orders(symbols).iter().position(|order| *order == sorted)
        }
        (Ask::Conserved(ask), _) => is_conserved(case.scene, witness, ask).map(yes),
        (Ask::Classify(ask), _) => kind(case.scene, witness, stage_of(case.scene, witness, ask.stage.as_deref())?),
        (Ask::Impulsive(ask), _) => {
            let stage = stage_of(case.scene, witness, ask.stage.as_deref())?;
            let value = |name: &str| witness.value(name);
            is_impulsive(case.scene, stage, &ask.impulsive, ask.on.as_deref(), &value, tolerance).map(yes)
        }
        _ => None,
    }
}

/// What a term comes to by the variant's own values.
fn said(case: &Case<'_>, side: &Expr) -> f64 {
    side.evaluate(&|symbol| case.variant.value(symbol).map_or(f64::NAN, |value| value.value))
}

fn stage_of(scene: &Scene, witness: &Witness<'_>, name: Option<&str>) -> Option<usize> {
    match name {
        Some(name) => witness.timeline().stage(scene, name),
        None => (scene.stages.len() == 1).then_some(0),
    }
}

/// Whether the sum is the same before the stage and after it.
fn is_conserved(scene: &Scene, witness: &Witness<'_>, ask: &Conserved) -> Option<bool> {
    let stage = stage_of(scene, witness, ask.stage.as_deref()).filter(|stage| witness.has_run(*stage))?;
    let total = |base: &str, letter: &str| -> Option<[(f64, f64); 2]> {
        let mut ends = [(0.0, 0.0); 2];
        for (end, instant) in ends.iter_mut().zip([stage + 1, stage + 2]) {
            for body in &ask.of {
                let own = witness.carried(base, body, instant, letter)?;
                *end = (end.0 + own, end.1 + own.abs());
            }
        }
        Some(ends)
    };
    let same = |[before, after]: [(f64, f64); 2]| (after.0 - before.0).abs() <= UNCHANGED * before.1.max(after.1);
    match ask.conserved {
        Conservable::Momentum => {
            let axes = scene.axes.rectangular();
            let asked = axes.iter().map(|(axis, _)| *axis).filter(|axis| ask.along.is_none_or(|own| own == *axis));
            let letters: Vec<&str> = asked.map(|axis| if axes.len() > 1 { axis.letter() } else { "" }).collect();
            letters.into_iter().map(|letter| total("p", letter).map(same)).try_fold(true, |all, own| Some(all && own?))
        }
        Conservable::Energy => total("T", "").map(same),
        Conservable::AngularMomentum => {
            let point = ask.about.clone().or_else(|| scene.points.keys().next().cloned())?;
            let ends = [stage + 1, stage + 2].map(|instant| witness.seen(&format!("H_{point}{instant}")));
            match ends {
                [Some(before), Some(after)] => {
                    Some(same([(before.value, before.value.abs()), (after.value, after.value.abs())]))
                }
                _ => None,
            }
        }
    }
}

/// Of which kind an impact was: whether energy is lost, and whether what touched still moves apart.
fn kind(scene: &Scene, witness: &Witness<'_>, stage: usize) -> Option<usize> {
    let Some(Stage::Impact(impact)) = scene.stages.get(stage).filter(|_| witness.has_run(stage)) else { return None };
    let (bodies, surface): (Vec<&str>, Option<f64>) = match impact.partners()? {
        Partners::Bodies(first, second) => (vec![first, second], None),
        Partners::Surface(body, surface) => {
            let moves = scene.surfaces.get(surface)?.velocity.as_ref();
            (vec![body], Some(moves.map_or(Some(0.0), |term| witness.value(&term.0))?))
        }
    };
    let axes = scene.axes.rectangular();
    let letters: Vec<&str> = axes.iter().map(|(axis, _)| if axes.len() > 1 { axis.letter() } else { "" }).collect();
    let (mut energies, mut parting, mut meeting) = ([0.0; 2], 0.0_f64, 0.0_f64);
    for letter in letters {
        for (instant, widest) in [(stage + 1, &mut meeting), (stage + 2, &mut parting)] {
            let mut speeds = Vec::new();
            for body in &bodies {
                speeds.push(witness.carried("v", body, instant, letter)?);
            }
            speeds.extend(surface);
            let apart = speeds.iter().copied().fold(f64::NEG_INFINITY, f64::max)
                - speeds.iter().copied().fold(f64::INFINITY, f64::min);
            *widest = widest.max(apart);
        }
    }
    for (energy, instant) in energies.iter_mut().zip([stage + 1, stage + 2]) {
        for body in &bodies {
            *energy += witness.carried("T", body, instant, "")?;
        }
    }
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
    let seen = witness.seen(&worked.problem.model().symbols.entry(symbol).name)?.value;
    let roots = worked.every_root(symbol);
    let [one, other] = roots[..] else { return None };
    let apart = |root: &Bounded| (root.value - seen).abs();
    let (near, far) = if apart(&one) < apart(&other) { (one, other) } else { (other, one) };
    Some(usize::from(near.value < far.value))
}

/// Whether a number is the first that satisfies its condition: it does, and the one before does not.
pub(super) fn is_first(worked: &Worked<'_>, scene: &Scene, ask: &Count, answer: f64, tolerance: f64) -> Option<bool> {
    let (name, condition) = ask.count.trim().strip_prefix("first ")?.split_once(" with ")?;
    let (left, relation, right) = split_relation(condition)?;
    let symbol = worked.problem.model().symbol_of(name.trim())?;
    let satisfied = |number: f64| -> Option<bool> {
        let said = vec![(symbol, number)];
        let case = Case { problem: worked.problem, scene, variant: worked.variant, said };
        let witness = Witness::new(&case, tolerance);
        let told = |text: &str| witness.value(text).map(|value| Seen { value, error: 0.0 });
        let side = |text: &str| witness.seen(text).or_else(|| told(text));
        holds(relation, side(left)?, side(right)?)
    };
    Some(satisfied(answer)? && (answer <= 1.0 || !satisfied(answer - 1.0)?))
}
