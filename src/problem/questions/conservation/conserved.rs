//! Whether momentum, kinetic energy or angular momentum is conserved in a stage: in a sudden one by what there is before and
//! after, in one that lasts by what acts from outside all the way.

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_fault::did_you_mean;
use momentous_model::Builder;
use momentous_scene::Stage;

use super::super::super::language::ask::Conservable;
use super::super::super::language::ask::Conserved;
use super::super::super::reading::load::Loaded;
use super::super::choices::choice::ChoicePart;
use super::super::choices::judgement::Case;
use super::super::choices::judgement::Judgement;
use super::super::choices::settled::join;
use super::super::choices::settled::stage;
use super::super::part::PartKind;
use super::super::part::Question;
use super::balance::Balance;
use super::balance::Verdict;
use super::lasting;
use super::misjudged;
use super::verdict::verdict;

/// Whether a quantity is conserved for some bodies in a stage.
pub(crate) fn conserved(loaded: &Loaded, ask: &Conserved, builder: &mut Builder<'_>, path: &Path) -> Option<Question> {
    let stage = stage(ask.stage.as_deref(), builder, path)?;
    check_bodies(ask, builder, path)?;
    let axes = axes(ask, builder, path)?;
    let about = about(ask, builder, path)?;
    keeps_its_mass(ask, stage, builder, path)?;
    let is_sudden = builder.scene().stages.get(stage).is_some_and(takes_no_time);
    let balance = Balance { ask, stage, axes, about: &about, is_sudden };
    let names: Vec<String> = ask.of.iter().map(|body| builder.name_of(body)).collect();
    let whose = join(&names);
    let phrase = builder.phrase_of(stage);
    let what = match (ask.conserved, ask.along) {
        (Conservable::Momentum, Some(axis)) => format!("the momentum of {whose} along {}", axis.letter()),
        (Conservable::Momentum, None) => format!("the momentum of {whose}"),
        (Conservable::Energy, _) => format!("the kinetic energy of {whose}"),
        (Conservable::AngularMomentum, _) => {
            let point = if about == "G" { "their centre of mass" } else { builder.scene().point(&about) };
            format!("the angular momentum of {whose} about {point}")
        }
    };
    let Some(Verdict { tests, because }) = verdict(loaded, &balance, ask.conserved, builder) else {
        let fault = Fault::new(Code::Value, format!("the scene does not determine {what} in {phrase}"));
        let help = "ask about the point about which the bodies rotate, and about all bodies that take part";
        builder.fault(fault.help(help).at_path(path.key("about")));
        return None;
    };
    let question = format!("whether {what} is conserved during {phrase}");
    if let Some(fault) = tests.iter().find_map(|test| test.equality.undecidable(loaded, builder, &question)) {
        builder.fault(fault.at_path(path.key("conserved")));
        return None;
    }
    let behind = misjudged::conserved(loaded, &balance, builder);
    let returns = if is_sudden { Vec::new() } else { lasting::returns(loaded, &balance, builder) };
    let still = lasting::still(&balance, builder);
    let cases = still.into_iter().chain([Case::new(0, tests, because), Case::new(1, Vec::new(), "")]).collect();
    let choice = Judgement::new(&["yes", "no"], cases).with(behind, returns);
    // While bodies touch, even an elastic impact turns kinetic energy into energy of deformation.
    let question = match ask.conserved {
        Conservable::Energy if is_sudden => format!("Is {what} after {phrase} the same as before it?"),
        _ => format!("Is {what} conserved during {phrase}?"),
    };
    Some((question, PartKind::Choice(ChoicePart::Judged(Box::new(choice)))))
}

/// Whether a stage is over before forces of ordinary size have done anything, so that what it leaves decides.
fn takes_no_time(stage: &Stage) -> bool {
    matches!(
        stage,
        Stage::Impact(_) | Stage::Blow(_) | Stage::Taut(_) | Stage::Strike(_) | Stage::Separate(_) | Stage::Interact(_)
    )
}

/// The system is made of bodies of the scene.
fn check_bodies(ask: &Conserved, builder: &mut Builder<'_>, path: &Path) -> Option<()> {
    let bodies: Vec<&str> = builder.bodies().collect();
    let known = format!("the scene has: {}", bodies.join(", "));
    let fault = match ask.of.iter().find(|body| !bodies.contains(&body.as_str())) {
        None if !ask.of.is_empty() => return Some(()),
        None => Fault::new(Code::Value, "`of` names no body").help(known),
        Some(body) => {
            let near = did_you_mean(body, bodies.iter().copied()).map(|near| format!("did you mean `{near}`?"));
            Fault::new(Code::UnknownName, format!("there is no body `{body}` in this scene"))
                .help(near.unwrap_or(known))
        }
    };
    builder.fault(fault.at_path(path.key("of")));
    None
}

/// Matter that leaves a body carries its share away, so that forces do not decide what the rest keeps.
fn keeps_its_mass(ask: &Conserved, stage: usize, builder: &mut Builder<'_>, path: &Path) -> Option<()> {
    let Some(Stage::Push(push)) = builder.scene().stages.get(stage) else { return Some(()) };
    let loses = push.loses.as_ref().filter(|_| push.pushed().any(|pushed| ask.of.iter().any(|body| body == pushed)));
    let Some(loss) = loses else { return Some(()) };
    let message =
        format!("{} that leaves carries its share away, so what the rest keeps is not said by forces", loss.name);
    let help = "ask for a velocity, or compare two: `holds: \"v_A2 > v_A1\"`";
    builder.fault(Fault::new(Code::Value, message).help(help).at_path(path.key("of")));
    None
}

/// The axes along which momentum is meant: the one that is named, or all.
fn axes(ask: &Conserved, builder: &mut Builder<'_>, path: &Path) -> Option<Vec<usize>> {
    let Some(axis) = ask.along else { return Some((0..builder.axis_letters().len()).collect()) };
    let position = builder.axis_letters().iter().position(|letter| *letter == axis.letter());
    if position.is_none() {
        let fault = Fault::new(Code::Value, format!("the scene has no axis {}", axis.letter()));
        let help = format!("its axes are: {}", builder.axis_letters().join(", "));
        builder.fault(fault.help(help).at_path(path.key("along")));
    }
    position.map(|position| vec![position])
}

/// The point about which angular momentum is meant: the one that is named, or the only one.
fn about(ask: &Conserved, builder: &mut Builder<'_>, path: &Path) -> Option<String> {
    let points: Vec<&String> = builder.scene().points.keys().collect();
    let known = || points.iter().map(|point| point.as_str()).chain((builder.axis_letters().len() > 1).then_some("G"));
    let fault = match &ask.about {
        Some(point) if known().any(|letter| letter == point) => return Some(point.clone()),
        Some(point) => {
            let near = did_you_mean(point, known()).map(|near| format!("did you mean `{near}`?"));
            let listed = known().collect::<Vec<_>>().join(", ");
            let help = if listed.is_empty() {
                "name a point under `points` of the scene".to_owned()
            } else {
                near.unwrap_or(format!("the points are: {listed}"))
            };
            Fault::new(Code::UnknownName, format!("there is no point `{point}` in this scene")).help(help)
        }
        None if ask.conserved != Conservable::AngularMomentum => return Some(String::new()),
        None => match points[..] {
            [only] => return Some(only.clone()),
            _ => Fault::new(Code::MissingKey, "the point of the angular momentum is missing")
                .help("name a point of the scene: `about: O`"),
        },
    };
    builder.fault(fault.at_path(path.key("about")));
    None
}
