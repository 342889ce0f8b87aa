//! Conservation in a stage that lasts: the influences from outside decide, at every moment.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_model::Builder;
use momentous_model::Effect;
use momentous_model::Influence;
use momentous_model::Moment;
use momentous_model::Work;
use momentous_scene::Stage;
use momentous_scene::stage::Connected;

use super::super::super::language::ask::Conservable;
use super::super::super::reading::load::Loaded;
use super::super::choices::judgement::Case;
use super::super::choices::judgement::Test;
use super::super::choices::settled::join;
use super::super::equality::Equality;
use super::super::equality::Place;
use super::balance::Balance;
use super::balance::Verdict;

/// The time that a stage counts from its own start.
const CLOCK: &str = "t";

pub(crate) fn momentum(loaded: &Loaded, balance: &Balance<'_>, builder: &Builder<'_>) -> Verdict {
    let outside = from_outside(balance, builder);
    let mut tests = Vec::new();
    // Polar axes have no fixed directions: along some, whatever acts from outside gives an impulse.
    let axes = if balance.axes.is_empty() { &[0][..] } else { &balance.axes };
    for position in axes {
        let acting = outside.iter().map(|influence| (influence.along(*position), impulse(influence, builder)));
        tests.extend(net(loaded, balance, builder, acting));
    }
    let because = if tests.is_empty() {
        "the impulses within the system cancel in pairs, and no external impulse acts along the axis"
    } else {
        "the external forces along the axis cancel at every moment"
    };
    Verdict { tests, because: because.into() }
}

pub(crate) fn energy(loaded: &Loaded, balance: &Balance<'_>, builder: &Builder<'_>) -> Verdict {
    let acting = on_system(balance, builder);
    let mut tests = Vec::new();
    let by_force: Vec<&Influence> = (acting.iter().copied())
        .filter(|influence| {
            matches!(influence.work, Work::OfForce | Work::Balances) && !influence.is_within(&balance.ask.of)
        })
        .collect();
    for position in 0..builder.axis_letters().len() {
        for moving in moving_alike(&by_force, balance, builder) {
            let acting = moving.into_iter().map(|influence| (influence.along(position), work(influence, builder)));
            tests.extend(net(loaded, balance, builder, acting));
        }
    }
    for influence in &acting {
        if let Work::Where(effect, words) = &influence.work {
            let words = if words.is_empty() { work(influence, builder) } else { words.clone() };
            tests.extend(net(loaded, balance, builder, std::iter::once((effect, words))));
        }
    }
    let mut round = None;
    for influence in &acting {
        if let Work::UnlessRound(gaps) = &influence.work {
            let words = work(influence, builder);
            let test =
                |gap: &Expr| net(loaded, balance, builder, std::iter::once((&Effect::Of(gap.clone()), words.clone())));
            let [radii, rest @ ..] = gaps.each_ref().map(test);
            // Where the distance changes, nothing else need be known.
            let changes = radii.as_ref().is_some_and(|test| matches!(test.equality, Equality::Never));
            tests.extend(rest.into_iter().flatten().filter(|_| !changes));
            tests.extend(radii.filter(|test| test.equality.quantities().is_empty()));
            round = Some(format!(
                "the path is a circle: {} is perpendicular to it at every moment and does no work",
                influence.called
            ));
        }
    }
    let mut within: Vec<&str> = (acting.iter())
        .filter(|influence| matches!(influence.work, Work::OfForce) && influence.is_within(&balance.ask.of))
        .map(|influence| influence.called.as_str())
        .collect();
    within.dedup();
    if let ([link], Some(first)) = (&within[..], tests.first().map(|test| test.otherwise.clone())) {
        for test in tests.iter_mut().filter(|test| test.otherwise == first) {
            test.otherwise = format!("the work of {link} on one body cancels that on the other, but {first}");
        }
    }
    let across: Vec<String> = (acting.iter())
        .filter(|influence| {
            matches!(influence.work, Work::Nothing | Work::Balances) && !influence.is_within(&balance.ask.of)
        })
        .map(|influence| influence.called.clone())
        .collect();
    let straight = || {
        let (all, others) = if tests.is_empty() {
            ("no force does work", "no force does work")
        } else {
            (
                "the total power of the forces is zero at every moment",
                "the total power of the other forces is zero at every moment",
            )
        };
        match &across[..] {
            [] => all.to_owned(),
            [one] => format!("{one} acts at right angles to the motion, and {others}"),
            several => format!("{} act at right angles to the motion, and {others}", join(several)),
        }
    };
    let because = round.unwrap_or_else(straight);
    Verdict { tests, because }
}

pub(crate) fn angular(loaded: &Loaded, balance: &Balance<'_>, builder: &mut Builder<'_>) -> Verdict {
    let acting: Vec<Influence> = from_outside(balance, builder).into_iter().cloned().collect();
    let known = builder.moment_while(balance.stage, balance.about, &acting);
    let builder: &Builder<'_> = builder;
    let outside = from_outside(balance, builder);
    let mut tests = Vec::new();
    let mut passing: Vec<String> = Vec::new();
    let named = builder.scene().points.get(balance.about);
    let point = named.map_or("the point", |entry| entry.name.as_str());
    if let Some(moments) = &known {
        let mut words: Vec<String> =
            outside.iter().map(|influence| format!("{} has a moment about {point}", influence.called)).collect();
        words.dedup();
        for moment in moments {
            let effect = Effect::Of(moment.clone());
            tests.extend(net(loaded, balance, builder, std::iter::once((&effect, words.join(", and ")))));
        }
    }
    for influence in outside.iter().filter(|_| known.is_none()) {
        let words = || format!("{} has a moment about {point}", influence.called);
        match &influence.moment {
            Moment::Through(through) if through == balance.about => passing.push(influence.called.clone()),
            Moment::About(moments) => {
                for moment in moments {
                    let effect = Effect::Of(moment.clone());
                    tests.extend(net(loaded, balance, builder, std::iter::once((&effect, words()))));
                }
            }
            Moment::Through(_) | Moment::OfForce => {
                for position in 0..builder.axis_letters().len().max(1) {
                    tests.extend(net(loaded, balance, builder, std::iter::once((influence.along(position), words()))));
                }
            }
        }
    }
    passing.dedup();
    let because = match &passing[..] {
        [] if known.is_some() && !outside.is_empty() => {
            format!("the external forces have no moment in all about {point} at any time")
        }
        [] => format!("no force has a moment about {point}"),
        [one] => format!("{one} has no moment about {point} at any time"),
        _ => format!("{} have no moment about {point} at any time", join(&passing)),
    };
    Verdict { tests, because }
}

/// Whether what changes on the way has its value again at the end.
pub(crate) fn returns(loaded: &Loaded, balance: &Balance<'_>, builder: &mut Builder<'_>) -> Vec<Equality> {
    let (bodies, stage) = (&balance.ask.of, balance.stage);
    let pairs: Vec<[Expr; 2]> = match balance.ask.conserved {
        Conservable::Momentum => {
            let ends = |position: &usize| {
                let [before, after] = [1, 2].map(|side| builder.total_momentum(bodies, stage + side, *position));
                Some([before?, after?])
            };
            balance.axes.iter().filter_map(ends).collect()
        }
        Conservable::Energy => vec![[0, 1].map(|side| builder.total_kinetic(bodies, stage, side))],
        Conservable::AngularMomentum => {
            let [before, after] = [1, 2].map(|side| builder.total_moment(bodies, balance.about, stage, side));
            before.into_iter().flatten().zip(after.into_iter().flatten()).map(|(from, to)| [from, to]).collect()
        }
    };
    pairs.into_iter().map(|sides| Equality::at_the_end(loaded, builder, stage, sides)).collect()
}

/// The case in which nothing of the system moves all the way, where the scene may go so.
pub(crate) fn still(balance: &Balance<'_>, builder: &Builder<'_>) -> Option<Case> {
    let stage = balance.stage;
    let moving: Vec<&String> = balance.ask.of.iter().filter(|body| builder.is_changed_in(body, stage)).collect();
    let ways = moving.iter().map(|body| builder.stands_still(body, stage));
    let ways: Vec<(usize, String)> =
        ways.map(|way| way.map(|(choice, what)| (choice, what.to_owned()))).collect::<Option<_>>()?;
    let because = join(&ways.iter().map(|(_, what)| what.clone()).collect::<Vec<_>>());
    let because = format!("{because}: the external forces cancel, and nothing moves");
    (!ways.is_empty()).then(|| Case::new(0, Vec::new(), because).only(ways))
}

/// The influences on bodies that have the same velocity all through the stage, for each such group: only there the power of all
/// forces is that of their sum. Bodies in a row, or on a plain string, move alike; any other moves by itself.
fn moving_alike<'i>(acting: &[&'i Influence], balance: &Balance<'_>, builder: &Builder<'_>) -> Vec<Vec<&'i Influence>> {
    let stage = builder.scene().stages.get(balance.stage);
    let is_plain = |string: &Connected| string.trailing.strands() == string.leading.strands();
    if matches!(stage, Some(Stage::Tow(_))) || matches!(stage, Some(Stage::Connected(connected)) if is_plain(connected))
    {
        return vec![acting.to_vec()];
    }
    let mut groups: Vec<Vec<&Influence>> = Vec::new();
    for influence in acting {
        match groups.iter_mut().find(|group| group.iter().any(|other| other.on == influence.on)) {
            Some(group) => group.push(influence),
            None => groups.push(vec![influence]),
        }
    }
    groups
}

/// The influences on bodies of the system.
fn on_system<'b>(balance: &Balance<'_>, builder: &'b Builder<'_>) -> Vec<&'b Influence> {
    let scene = builder.scene();
    let is_in = |influence: &Influence| {
        let bodies = &balance.ask.of;
        bodies.contains(&influence.on)
            || scene.members(&influence.on).iter().any(|member| bodies.iter().any(|body| body == member))
    };
    builder.influences().iter().filter(|influence| influence.stage == balance.stage && is_in(influence)).collect()
}

fn from_outside<'b>(balance: &Balance<'_>, builder: &'b Builder<'_>) -> Vec<&'b Influence> {
    on_system(balance, builder).into_iter().filter(|influence| !influence.is_within(&balance.ask.of)).collect()
}

/// The tests by which effects have no effect together: none is there, or they cancel at every moment.
fn net<'e>(
    loaded: &Loaded,
    balance: &Balance<'_>,
    builder: &Builder<'_>,
    effects: impl Iterator<Item = (&'e Effect, String)>,
) -> Option<Test> {
    let (mut terms, mut words, mut is_open) = (Vec::new(), Vec::new(), false);
    for (effect, said) in effects {
        match effect {
            Effect::Of(term) if term.is_zero() => continue,
            Effect::Of(term) => terms.push(term.clone()),
            Effect::Open => is_open = true,
        }
        if !said.is_empty() && !words.contains(&said) {
            words.push(said);
        }
    }
    let words = words.join(", and ");
    if is_open {
        return Some(Test::new(Equality::Never, words));
    }
    let clock: Option<Symbol> = builder.symbols().find(CLOCK);
    let place = Place { stage: balance.stage, clock };
    (!terms.is_empty())
        .then(|| Test::new(Equality::of(loaded, builder, place, [Expr::sum(terms), Expr::zero()]), words))
}

fn impulse(influence: &Influence, builder: &Builder<'_>) -> String {
    format!("{} exerts an external impulse on {}", influence.called, builder.name_of(&influence.on))
}

/// The words for the work of an influence; none for one at right angles to the motion.
fn work(influence: &Influence, builder: &Builder<'_>) -> String {
    if matches!(influence.work, Work::Balances) {
        return String::new();
    }
    format!("{} does work on {}", influence.called, builder.name_of(&influence.on))
}
