//! The answers, each in a sentence with its unit and its direction in words.

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::Operator;
use momentous_expr::Symbol;
use momentous_model::Instant;
use momentous_problem::AskedUnit;
use momentous_problem::ChoicePart;
use momentous_problem::Decision;
use momentous_problem::FormulaPart;
use momentous_problem::NumberPart;
use momentous_problem::OptionFeedback;
use momentous_problem::Part;
use momentous_problem::PartKind;
use momentous_problem::orders;
use momentous_quantity::Printed;
use momentous_quantity::Unit;
use momentous_scene::Senses;
use momentous_scene::Stage;
use momentous_scene::stage::Place;
use momentous_solve::Bounded;

use super::super::Block;
use super::super::Detail;
use super::super::Inline;
use super::super::terms::display::Display;
use super::super::terms::entry::Item;
use super::super::terms::printed;
use super::super::wording::capitalised;
use super::super::working::naming;
use super::interval;

/// One paragraph for each part.
pub(crate) fn answers(display: Display<'_>, detail: Detail) -> Vec<Block> {
    display.worked.form.parts.iter().map(|part| Block::Paragraph(sentence(display, part, detail))).collect()
}

/// The answer to a part; in full also why other options are wrong.
fn sentence(display: Display<'_>, part: &Part, detail: Detail) -> Vec<Inline> {
    match &part.kind {
        PartKind::Choice(ChoicePart::Order(symbols)) => {
            let right = ChoicePart::Order(symbols.clone()).decided(&display.worked).right;
            let order = orders(symbols).into_iter().nth(right).unwrap_or_default();
            let names = order.into_iter().map(|symbol| display.name(symbol));
            let mut words = Inline::line(&format!("{} ", part.label));
            words.extend([Inline::Math(Math::chain(names, Operator::Less)), Inline::Text(".".into())]);
            words
        }
        PartKind::Choice(choice) => {
            let Decision { options, right, because, feedback, .. } = choice.decided(&display.worked);
            let option = options.get(right).map_or("", String::as_str).trim_end_matches('.');
            let mistaken = options.iter().zip(&feedback).filter_map(|(option, feedback)| match feedback {
                OptionFeedback::Mistake(mistake) => Some(format!(" {} {}.", capitalised(option), mistake.does)),
                OptionFeedback::Own(_) | OptionFeedback::Confused(_) | OptionFeedback::Nothing => None,
            });
            let mistaken: String = mistaken.filter(|_| detail == Detail::Full).collect();
            let mut words = Inline::line(&format!("{} ", part.label));
            words.extend(Inline::line(&capitalised(option)).into_iter().map(|inline| match inline {
                Inline::Text(text) => Inline::Strong(text),
                other => other,
            }));
            words.push(Inline::Text(format!(": {because}.{mistaken}")));
            words
        }
        PartKind::Formula(formula) => formula_sentence(display, part, formula),
        PartKind::Range(range) => interval::sentence(display, part, range),
        PartKind::Vector(vector) => {
            let is = vec![
                display.worked.problem.math_of_vector(&part.id, vector),
                Math::Operator(Operator::Equals),
                printed::printed_vector(display.worked, vector),
            ];
            let mut words = Inline::line(&format!("{}: ", capitalised(&part.label)));
            let along = format!(", the components along {}.", vector.axes_in_words());
            words.extend([Inline::Math(Math::Row(is)), Inline::Text(along)]);
            words
        }
        PartKind::Number(number) => {
            let mut words = Inline::line(&format!("{}: ", capitalised(&part.label)));
            for (index, answer) in display.worked.answers(number).into_iter().enumerate() {
                let name = display.worked.problem.math_of(number.symbol);
                let mut equal = vec![name, Math::Operator(Operator::Equals)];
                equal.extend(other_name(display, number, detail).filter(|_| index == 0).into_iter().flatten());
                if index == 0 && is_converted(display, number) && display.has_number(number.symbol) {
                    equal.extend([display.quantity(number.symbol), Math::Operator(Operator::Equals)]);
                    equal.extend(to_the_unit(display, number, answer));
                }
                equal.push(printed::answer(display, number, answer));
                words.extend((index > 0).then(|| Inline::Text(" or ".into())));
                words.push(Inline::Math(Math::Row(equal)));
            }
            words.extend(printed::as_taught(display, number));
            if let Some(direction) = direction(display, number) {
                words.push(Inline::Text(", ".into()));
                words.extend(direction);
            }
            words.push(Inline::Text(".".into()));
            words
        }
    }
}

/// The other name of an answer that a short solution gives nowhere else: `(v_B2)_n =`.
fn other_name(display: Display<'_>, number: &NumberPart, detail: Detail) -> Option<[Math; 2]> {
    let steps = display.worked.leaf().answer_steps().iter();
    let mut others = steps.filter_map(|step| naming::other_name(display, step));
    let other = others.find(|other| other.unknown == number.symbol).filter(|_| detail == Detail::Short)?;
    let is_told_here = naming::stands_with_answer(display, other.unknown)
        && other.symbols != display.worked.problem.math_of(other.unknown);
    is_told_here.then_some([other.symbols, Math::Operator(Operator::Equals)])
}

/// The formula, and its value where the numbers are told.
fn formula_sentence(display: Display<'_>, part: &Part, formula: &FormulaPart) -> Vec<Inline> {
    let is = |math: Math| Inline::Math(Math::relation(display.name(formula.symbol), Operator::Equals, math));
    let mut words = Inline::line(&format!("{}: ", capitalised(&part.label)));
    words.extend(printed::formula(display, formula).map(is));
    if !display.is_open(formula.symbol) {
        let figures = display.worked.problem.loaded().draft.significant_figures();
        let value = Inline::Math(display.quantity_to(formula.symbol, figures));
        words.extend([Inline::Text(", here ".into()), value]);
    }
    words.push(Inline::Text(".".into()));
    words
}

/// Whether the answer is asked in another unit than the steps computed in, and more than the point moves.
fn is_converted(display: Display<'_>, number: &NumberPart) -> bool {
    let measured = &display.manner(number.symbol).measured;
    match &number.unit {
        AskedUnit::Unit(unit) => *unit != measured.unit && !moves_the_point(&measured.unit, unit),
        AskedUnit::InTermsOf(letter, _) => measured.letters != Some(Expr::from(*letter)),
    }
}

/// Whether a value in another unit has the same digits: kilonewtons for newtons.
fn moves_the_point(from: &Unit, to: &Unit) -> bool {
    let power = libm::log10(to.factor().to_f64() / from.factor().to_f64());
    (power - power.round()).abs() < 1e-9
}

/// The answer with more figures than are asked, where it does not come out with those: `32710 km`, which is about 32700 km.
fn to_the_unit(display: Display<'_>, number: &NumberPart, answer: Bounded) -> Vec<Math> {
    let settled = display.shown.figures.get().and_then(|figures| figures.of(Item::Answer(number.symbol)));
    let figures = settled.unwrap_or(number.figures);
    if figures <= number.figures || number.whole {
        return Vec::new();
    }
    let all = printed::answer(display, &NumberPart { figures, ..number.clone() }, answer);
    vec![all, Math::Operator(Operator::Approximately)]
}

/// Whether it is the velocity of a body on its way round a circle, which one axis of the scene counts along the path.
fn is_along_path(display: Display<'_>, symbol: Symbol) -> bool {
    let scene = &display.worked.problem.loaded().draft.scene;
    let name = display.worked.problem.model().name(symbol);
    let (true, None, Some(Instant::Number(instant))) = (name.kind.is_velocity(), &name.component, &name.instant) else {
        return false;
    };
    let swings = |(index, stage): (usize, &Stage)| {
        let Stage::Swing(swing) = stage else { return false };
        let side = instant.checked_sub(index + 1);
        let place = side.and_then(|side| swing.places().get(side).copied());
        swing.body == name.subject && matches!(place, Some(Place::Angle(_)))
    };
    scene.stages.iter().enumerate().any(swings)
}

/// The direction of a signed component in words: "to the left"; "at rest" for zero.
fn direction(display: Display<'_>, number: &NumberPart) -> Option<Vec<Inline>> {
    let senses = display.manner(number.symbol).senses.as_ref()?;
    let along_path = is_along_path(display, number.symbol)
        .then(|| Senses { positive: "along the path".to_owned(), negative: "back along the path".to_owned() });
    let senses = along_path.as_ref().unwrap_or(senses);
    if display.worked.answers(number).len() > 1 {
        return None;
    }
    let said = |words: String| Some(vec![Inline::Text(words)]);
    let value = display.worked.answer(number);
    if value.is_zero() {
        let kind = &display.worked.problem.model().name(number.symbol).kind;
        return if kind.is_velocity() { said("at rest".to_owned()) } else { None };
    }
    if value.value >= 0.0 {
        return said(senses.positive.clone());
    }
    if let AskedUnit::InTermsOf(letter, unit) = &number.unit {
        if !unit.is_none() {
            return said(format!("that is {}", senses.negative));
        }
        let size = printed::multiple(display, printed::shown(number, -value.for_print()), *letter);
        let sense = Inline::Text(format!(" {}", senses.negative));
        return Some(vec![Inline::Text("that is ".into()), Inline::Math(size), sense]);
    }
    let size = Printed::new(-value.for_print(), number.figures)?;
    let unit = number.plain_unit();
    let gap = if unit.is_attached() || unit.is_none() { "" } else { "\u{a0}" };
    said(format!("that is {}{gap}{} {}", size.plain(), unit.unicode(), senses.negative))
}
