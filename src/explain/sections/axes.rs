//! Which way the axes point, and what is given, in the units of the calculation.

use std::collections::BTreeSet;

use momentous_expr::Math;
use momentous_expr::Operator;
use momentous_expr::Symbol;
use momentous_model::Frame;
use momentous_problem::PartKind;
use momentous_problem::Worked;
use momentous_quantity::Decimal;
use momentous_quantity::Printed;
use momentous_quantity::Unit;
use momentous_quantity::with_minus_signs;
use momentous_scene::Scene;
use momentous_scene::Stage;
use momentous_scene::stage::Partners;
use momentous_solve::Closed;
use momentous_solve::Statement;

use super::super::Block;
use super::super::Inline;
use super::super::cache::WayCache;
use super::super::terms::display::Display;
use super::super::terms::display::number_math;
use super::super::terms::display::printed;
use super::super::terms::display::with_unit;
use super::super::wording::capitalised;
use super::super::wording::join;
use super::super::working::script;

/// The section's blocks; none where there is nothing to say.
pub(crate) fn axes(display: Display<'_>, way: &WayCache) -> Vec<Block> {
    let used = way.used.get_or_init(|| used(display.worked));
    let mut blocks: Vec<Block> = directions(display, used).into_iter().map(Block::Paragraph).collect();
    let literals = &display.worked.problem.model().literals;
    let told = display.worked.variant.all_given().iter();
    let mut told: Vec<Vec<Inline>> = told
        .filter(|(symbol, ..)| used.contains(symbol) && !literals.iter().any(|(literal, _)| literal == symbol))
        .map(|given| {
            let is_open = display.is_open(given.0);
            vec![Inline::Math(if is_open { display.name(given.0) } else { value(display, given) })]
        })
        .collect();
    let steps = display.worked.leaf().answer_steps().iter();
    let printed = steps.filter_map(|step| script::printed(display, step));
    told.extend(printed.filter_map(|symbol| Some(vec![Inline::Math(as_printed(display, symbol)?)])));
    told.extend(renamed(display));
    if !told.is_empty() {
        let given = [vec![Inline::Text("Given: ".into())], join(told), vec![Inline::Text(".".into())]];
        blocks.push(Block::Paragraph(given.concat()));
    }
    blocks
}

/// Quantities that are givens under another name: `r_A2 = d`.
fn renamed(display: Display<'_>) -> impl Iterator<Item = Vec<Inline>> {
    let steps = display.worked.leaf().answer_steps().iter();
    let renamed = steps.filter_map(move |step| script::renamed(display, step));
    let renamed = renamed.filter(move |(symbol, _)| !display.has_other_name(*symbol));
    renamed.map(move |(symbol, given)| vec![Inline::Math(display.equation(&symbol.into(), given))])
}

/// The directions of the axes of the scene along which something is counted, and of those of its contacts.
fn directions(display: Display<'_>, used: &BTreeSet<Symbol>) -> Vec<Vec<Inline>> {
    let scene = &display.worked.problem.loaded().draft.scene;
    let mut axes = scene.axes.rectangular();
    let has_rotor = axes.len() == 2 && scene.rotors().next().is_some();
    let finds = display.worked.form.wanted().next().is_some();
    let is_along = |symbol: &Symbol| {
        let manner = &display.manner(*symbol).senses;
        let senses = display.worked.problem.turns_with(*symbol).or_else(|| manner.clone());
        let is_component = display.worked.problem.model().name(*symbol).component.is_some();
        is_component || senses.is_some_and(|senses| axes.iter().any(|(_, axis)| axis.positive == senses.positive))
    };
    if finds && !used.iter().any(is_along) {
        axes.clear();
    }
    let mut sentences = match &axes[..] {
        [] => Vec::new(),
        [(_, senses)] if senses.is_of_a_turn() => {
            vec![vec![words(format!("{} is positive.", capitalised(&senses.positive)))]]
        }
        [(first, senses), others @ ..] => {
            let pointing = |letter, points: String| vec![letter, words(format!(" axis {points}"))];
            let first = pointing(letter(first.letter()), format!("points {}", senses.positive));
            let others = others.iter().map(|(other, senses)| {
                [vec![words("the ")], pointing(letter(other.letter()), senses.positive.clone())].concat()
            });
            let all = join([first].into_iter().chain(others).collect());
            vec![[vec![words("The ")], all, vec![words(".")]].concat()]
        }
    };
    if has_rotor {
        sentences.push(vec![words("Counter-clockwise is positive.")]);
    }
    // Where nothing is worked out, nothing is counted along n and t.
    if axes.len() > 1 && finds {
        let frames = display.worked.problem.model().frames.iter().zip(&scene.stages);
        sentences.extend(frames.filter_map(|(frame, stage)| contact(display, scene, frame.as_ref()?, stage)));
    }
    sentences
}

/// The directions of n and t at the contact of an impact.
fn contact(display: Display<'_>, scene: &Scene, frame: &Frame, stage: &Stage) -> Option<Vec<Inline>> {
    let Stage::Impact(impact) = stage else { return None };
    let name = |body: &str| scene.called(body);
    let line = match impact.partners()? {
        Partners::Bodies(first, second) => {
            format!("along the line of impact, from {} towards {}", name(first), name(second))
        }
        Partners::Surface(_, surface) => {
            let name = scene.surfaces.get(surface).and_then(|entry| entry.name.clone());
            format!("perpendicularly away from {}", name.unwrap_or_else(|| format!("the {surface}")))
        }
    };
    let quarters = f64::from(frame.normal.quarters % 4);
    if frame.normal.turn.is_zero() {
        let axis = ["+x", "+y", "\u{2212}x", "\u{2212}y"][usize::from(frame.normal.quarters % 4)];
        return Some(vec![words(format!("The normal of the contact points {line}: along {axis}."))]);
    }
    let is_open = frame.normal.turn.symbols().iter().any(|symbol| display.is_open(*symbol));
    let (angle, sense) = if is_open && frame.normal.quarters.is_multiple_of(4) {
        (Inline::Math(display.symbolic(&frame.normal.turn)), "counter-clockwise")
    } else {
        angle_in_degrees(display, frame, quarters)
    };
    Some(vec![
        words("At the contact, "),
        letter("n"),
        words(format!(" points {line}, at ")),
        angle,
        words(format!(" {sense} from +x; ")),
        letter("t"),
        words(" is at 90° to it, counter-clockwise."),
    ])
}

/// The angle from +x to the normal of a contact, half a turn at most, and its sense.
fn angle_in_degrees(display: Display<'_>, frame: &Frame, quarters: f64) -> (Inline, &'static str) {
    let turn = display.value_of(&frame.normal.turn) * 180.0 / std::f64::consts::PI + 90.0 * quarters;
    let turn = turn - 360.0 * (turn / 360.0).round();
    let sense = if turn < 0.0 { "clockwise" } else { "counter-clockwise" };
    let angle = printed(turn.abs(), 4);
    let angle = if angle.contains('.') { angle.trim_end_matches('0').trim_end_matches('.') } else { &angle };
    (words(format!("{angle}°")), sense)
}

fn words(text: impl Into<String>) -> Inline {
    Inline::Text(text.into())
}

fn letter(name: &str) -> Inline {
    Inline::Math(Math::Identifier(name.into()))
}

/// Every quantity that a step of the answer mentions, or on which a choice depends.
fn used(worked: Worked<'_>) -> BTreeSet<Symbol> {
    let leaf = worked.leaf();
    let steps = leaf.answer_steps();
    let stated = steps.iter().flat_map(|step| &step.equations).filter_map(|place| leaf.system.equations.get(*place));
    let mut used: BTreeSet<Symbol> = stated
        .flat_map(|equation| match &equation.statement {
            Statement::Equal { left, right } | Statement::FirstInteger { left, right, .. } => {
                left.symbols().into_iter().chain(right.symbols())
            }
        })
        .collect();
    let roots = steps.iter().flat_map(|step| &step.roots).flat_map(|root| &root.values);
    used.extend(roots.flat_map(|(_, closed): &(Symbol, Closed)| closed.symbols()));
    let choices = worked.form.parts.iter().filter_map(|part| match &part.kind {
        PartKind::Choice(choice) => Some(choice.depends_on()),
        _ => None,
    });
    used.extend(choices.flatten());
    used
}

/// `m = 360 g = 0.36 kg`; `e = 0.8`; `e = 4/5 = 0.8`.
fn value(display: Display<'_>, (symbol, value, unit): &(Symbol, Decimal, Unit)) -> Math {
    let mut parts = vec![display.name(*symbol), Math::Operator(Operator::Equals)];
    if let Some(calculation) = calculation(display, *symbol) {
        parts.extend([calculation, Math::Operator(Operator::Equals)]);
    } else if unit != display.unit(*symbol) && !value.is_zero() {
        parts.extend([with_unit(number_math(Printed::written(value).plain()), unit), Math::Operator(Operator::Equals)]);
    }
    parts.push(display.quantity(*symbol));
    Math::Row(parts)
}

/// The value of what the author derives from other givens, as the sheet prints it.
fn as_printed(display: Display<'_>, symbol: Symbol) -> Option<Math> {
    let (variant, problem) = (display.worked.variant, display.worked.problem);
    let value = number_math(Printed::written(&variant.printed_value(problem, symbol)?).plain());
    let printed = with_unit(value, &variant.unit(problem, symbol));
    let calculation = calculation(display, symbol).map(|math| [math, Math::Operator(Operator::Equals)]);
    let parts = [display.name(symbol), Math::Operator(Operator::Equals)].into_iter();
    Some(Math::Row(parts.chain(calculation.into_iter().flatten()).chain([printed]).collect()))
}

/// The calculation by which a number is given, as the sheet prints it: `4/5`, `arctan(3/4)`.
fn calculation(display: Display<'_>, symbol: Symbol) -> Option<Math> {
    let problem = display.worked.problem;
    let name = &problem.model().symbols.entry(symbol).name;
    let given = problem.loaded().given.get(name).filter(|_| display.worked.form.question.given.get(name).is_none())?;
    match given.constant() {
        Some(written) => Some(Math::Text(with_minus_signs(written))),
        None => {
            let stated = problem.model().stated(symbol).filter(|stated| stated.symbols().is_empty())?;
            Some(display.symbolic(stated))
        }
    }
}
