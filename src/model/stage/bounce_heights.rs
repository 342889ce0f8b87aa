//! Heights of bounces by their numbers, after a drop: `h_1`, `h_2`.

use crate::Builder;
use crate::Instant;
use crate::Name;
use crate::QuantityKind;
use crate::wording::counted;
use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_fault::Path;
use momentous_laws::bouncing;
use momentous_scene::Scene;
use momentous_scene::Stage;
use momentous_scene::stage::Bounces;

/// Whether the height of a drop says how the body arrives: of the fall just before, or `h_0`.
pub(super) fn is_dropped(scene: &Scene, index: usize, stage: &Bounces) -> bool {
    let before = index.checked_sub(1).and_then(|before| scene.stages.get(before));
    let falls = matches!(before, Some(Stage::Fall(fall)) if fall.body == stage.body);
    scene.axes.rectangular().len() == 1 && stage.incline.is_none() && (falls || before.is_none())
}

/// The bounces of which `h_1` is a height; none where the heights are not those of one drop.
fn of_heights(scene: &Scene) -> Option<(usize, &Bounces)> {
    let all = scene.stages.iter().enumerate();
    let mut dropped = all.filter_map(|(index, stage)| {
        let Stage::Bounces(bounces) = stage else { return None };
        is_dropped(scene, index, bounces).then_some((index, bounces))
    });
    let only = dropped.next()?;
    dropped.next().is_none().then_some(only)
}

/// Whether it is the height after a bounce, by its number.
pub(crate) fn is_height_of_a_bounce(scene: &Scene, name: &Name) -> bool {
    number(name).is_some() && of_heights(scene).is_some()
}

/// The number of the bounce whose height a name is.
fn number(name: &Name) -> Option<usize> {
    let bare = name.subject.is_empty() && name.component.is_none() && name.stage.is_none();
    match name.instant {
        Some(Instant::Number(number)) if bare && number > 0 && name.kind == QuantityKind::Height => Some(number),
        _ => None,
    }
}

/// The height after a bounce, by the height of the drop and by those of other bounces.
pub(crate) fn height_of_a_bounce(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let which = number(name)?;
    let (index, stage) = of_heights(builder.scene)?;
    let path = Path::root().key("scene").key("stages").index(index).key("bounces").key("restitution");
    let e = builder.restitution_coefficient(&stage.restitution, &path);
    let others: Vec<(usize, Symbol)> =
        builder.symbols.iter().filter_map(|(symbol, _)| Some((number(builder.name(symbol))?, symbol))).collect();
    let (body, bounce) = (builder.called(&stage.body), counted(which, "bounce"));
    let symbol = builder.positive(name.clone(), format!("the height that {body} reaches after {bounce}"));
    let drop = builder.drop_height(index, &stage.body);
    let because = "each bounce multiplies the speed by e, hence the height by the square of e";
    let from_drop = bouncing::bounce_height(&e, &count(which), &drop);
    builder.law(&bouncing::BOUNCE_HEIGHT, Some(index), because, (symbol.into(), from_drop));
    for (number, other) in others {
        let ((first, from), (last, to)) =
            if number < which { ((number, other), (which, symbol)) } else { ((which, symbol), (number, other)) };
        let between = bouncing::bounce_height(&e, &count(last - first), &from.into());
        builder.law(&bouncing::BOUNCE_HEIGHT, Some(index), because, (to.into(), between));
    }
    Some(symbol)
}

fn count(number: usize) -> Expr {
    Expr::integer(i64::try_from(number).unwrap_or(i64::MAX))
}
