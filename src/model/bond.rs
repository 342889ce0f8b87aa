//! Bonds that a stage leaves between bodies, or between a body and what holds it: the next stage finds them.

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_scene::Scene;
use momentous_scene::Stage;
use momentous_scene::list;
use momentous_scene::stage::Ends;
use momentous_scene::stage::Impact;
use momentous_scene::stage::Partners;
use momentous_scene::stage::Place;
use momentous_scene::stage::Slide;

use super::stage::Description;

/// Bodies that a stage leaves bound.
struct Bond<'a> {
    kind: Kind<'a>,
    bodies: Vec<&'a str>,
}

/// The kind of the bond.
#[derive(Clone, Copy)]
enum Kind<'a> {
    /// They stuck together in an impact.
    Stuck,
    /// One of them stuck to a surface.
    OnSurface(&'a str),
    /// They turn together about a point.
    OnArm,
    /// Something joins them in a row.
    Coupled,
    /// A string over a pulley joins them.
    OnString,
    /// A spring presses on them.
    Sprung,
    /// One of them hangs on its cord, or stands on its track, at an angle.
    AtAnAngle,
    /// The first hangs from the second, or lies on its slope, above its lowest place.
    Raised,
    /// The first lies on the second, with friction between them; whether it slides on it.
    LiesOn { slides: bool },
}

/// Why a stage cannot act on these bodies as it does, since an earlier one has left some of them bound.
pub(super) fn broken(scene: &Scene, index: usize, stage: &Stage, acted_on: &[&str]) -> Option<Fault> {
    let bonds = before(scene, index);
    let bond = bonds.iter().find(|bond| {
        bond.bodies.iter().any(|body| acted_on.contains(body)) && bond.is_broken_by(scene, stage, acted_on)
    })?;
    let noun = Description::of(scene, stage).noun;
    let names: Vec<String> = bond.bodies.iter().map(|body| scene.called(body)).collect();
    let [first, second] = [0, 1].map(|place| names.get(place).map_or("", String::as_str));
    let together = list(&names);
    let (message, help) = match bond.kind {
        Kind::Stuck => (
            format!("{together} stay together, so the {noun} acts on them as one body"),
            format!(
                "write `becomes: C` in their impact, and `C` in place of `{}` from then on",
                bond.bodies.join("` and `")
            ),
        ),
        Kind::OnSurface(surface) => (
            format!("{together} stays on {}, which acts on it in the {noun}, too", called_surface(scene, surface)),
            "end the problem there, or let it rebound: `restitution: e` in place of `plastic: true`".to_owned(),
        ),
        Kind::OnArm => (
            format!("{together} turn together, so the {noun} acts on all of them"),
            "use a `strike` or a `rotate` that names all of them (`carries`, `bodies`, `rotor`)".to_owned(),
        ),
        Kind::Coupled => (
            format!("{together} are still joined, so the {noun} acts on both"),
            "write a `tow` with the forces of both, or `separate` first".to_owned(),
        ),
        Kind::OnString => (
            format!("{together} are still joined by the string, so the {noun} acts on both"),
            "let the string carry on: a `connected` with the forces of its ends".to_owned(),
        ),
        Kind::Sprung => (
            format!("the spring still presses on {together} in the {noun}"),
            "write a `spring` that relaxes it first: `from: s`".to_owned(),
        ),
        Kind::AtAnAngle => (
            format!("{together} is at an angle on its circle, where it does not move along the axis of the {noun}"),
            "let it swing to its lowest point first".to_owned(),
        ),
        Kind::Raised => (
            format!("{first} is above its lowest place on {second}, and they act on each other in the {noun}, too"),
            "let it come down first: the same stage with `way: down`".to_owned(),
        ),
        Kind::LiesOn { .. } => (
            format!("{first} lies on {second}, and friction between them acts in the {noun}, too"),
            "write an `interact` of both with `friction`, or one body with the mass of both that move together"
                .to_owned(),
        ),
    };
    Some(Fault::new(Code::Value, message).help(help))
}

/// The bodies on which a bond goes on acting while a stage lasts that names others, each with what acts.
pub(super) fn acting_on_others<'a>(scene: &'a Scene, index: usize, named: &[&str]) -> Vec<(&'a str, &'static str)> {
    let acting = before(scene, index).into_iter().filter_map(|bond| Some((bond.acts_all_the_time()?, bond.bodies)));
    let others = acting.flat_map(|(acts, bodies)| bodies.into_iter().map(move |body| (body, acts)));
    others.filter(|(body, _)| !named.contains(body)).collect()
}

fn called_surface(scene: &Scene, surface: &str) -> String {
    let name = scene.surfaces.get(surface).and_then(|surface| surface.name.clone());
    name.unwrap_or_else(|| format!("the {surface}"))
}

/// Whether strings that are jerked pull bodies straight off a surface, which can only push.
fn lifts_off(scene: &Scene, stage: &Stage, surface: &str, bodies: &[&str]) -> bool {
    let Stage::Taut(taut) = stage else { return false };
    let Some(normal) = scene.surfaces.get(surface).and_then(|surface| scene.axes.pointed(&surface.normal.0)) else {
        return false;
    };
    let first_axis = scene.axes.rectangular().first().map(|(axis, _)| (*axis, 1));
    taut.pulls().into_iter().all(|([first, second], along)| {
        let Some((axis, sign)) = along.map_or(first_axis, |along| scene.axes.pointed(&along.0)) else { return false };
        let lifts = |sign| (axis, sign) == normal;
        (!bodies.contains(&first) || lifts(sign)) && (!bodies.contains(&second) || lifts(-sign))
    })
}

/// The bonds that the stages before one have left.
fn before(scene: &Scene, index: usize) -> Vec<Bond<'_>> {
    let mut bonds: Vec<Bond<'_>> = Vec::new();
    for stage in scene.stages.iter().take(index) {
        bonds.retain(|bond| !bond.is_released_by(scene, stage));
        for bond in &mut bonds {
            bond.goes_through(scene, stage);
        }
        bonds.extend(left(stage));
    }
    bonds
}

/// The bond that a stage leaves.
fn left(stage: &Stage) -> Option<Bond<'_>> {
    if let Stage::Impact(impact @ Impact { plastic: true, becomes: None, .. }) = stage {
        return Some(match impact.partners()? {
            Partners::Bodies(first, second) => Bond { kind: Kind::Stuck, bodies: vec![first, second] },
            Partners::Surface(body, surface) => Bond { kind: Kind::OnSurface(surface), bodies: vec![body] },
        });
    }
    if let Stage::Strike(strike) = stage
        && strike.plastic
    {
        let on_arm = strike.carries.keys().chain(&strike.rotor).chain([&strike.body]);
        return Some(Bond { kind: Kind::OnArm, bodies: on_arm.map(String::as_str).collect() });
    }
    if let Stage::Rotate(rotate) = stage
        && rotate.turning().len() > 1
    {
        return Some(Bond { kind: Kind::OnArm, bodies: rotate.turning() });
    }
    if let Stage::Tow(tow) = stage {
        return Some(Bond { kind: Kind::Coupled, bodies: tow.both().map(|towed| towed.body.as_str()).into() });
    }
    if let Stage::Connected(connected) = stage {
        return Some(Bond { kind: Kind::OnString, bodies: vec![&connected.trailing.body, &connected.leading.body] });
    }
    if let Stage::Spring(spring) = stage
        && !spring.releases()
    {
        let bodies = match spring.ends()? {
            Ends::Fixed(body) => vec![body],
            Ends::Free(first, second) => vec![first, second],
        };
        return Some(Bond { kind: Kind::Sprung, bodies });
    }
    if let Stage::Swing(swing) = stage
        && matches!(swing.places(), [_, Place::Angle(_)])
    {
        return Some(match &swing.on {
            Some(on) => Bond { kind: Kind::Raised, bodies: vec![&swing.body, on] },
            None => Bond { kind: Kind::AtAnAngle, bodies: vec![&swing.body] },
        });
    }
    if let Stage::Slide(Slide { body, on: Some(on), until: Some(_), .. }) = stage {
        return Some(Bond { kind: Kind::Raised, bodies: vec![body, on] });
    }
    if let Stage::Walk(walk) = stage {
        return Some(Bond { kind: Kind::LiesOn { slides: false }, bodies: vec![&walk.body, &walk.on] });
    }
    if let Stage::Interact(interact) = stage
        && interact.friction.is_some()
    {
        // One that slides a distance may have reached the end of the other.
        let slides = interact.until.is_none();
        let stays = !slides || interact.distance.is_none();
        return stays.then(|| Bond {
            kind: Kind::LiesOn { slides },
            bodies: interact.between.iter().map(String::as_str).collect(),
        });
    }
    None
}

impl<'a> Bond<'a> {
    /// Whether a stage makes the bond anew, or undoes it.
    fn is_released_by(&self, scene: &Scene, stage: &Stage) -> bool {
        if let Stage::Separate(separate) = stage {
            return self.bodies.iter().all(|body| separate.into.iter().any(|part| part == body));
        }
        let named: Vec<&str> = Description::of(scene, stage).bodies.into_iter().map(|(body, _)| body).collect();
        if !self.bodies.iter().any(|body| named.contains(body)) {
            return false;
        }
        let leaves = matches!(stage, Stage::Flight(_) | Stage::Fall(_));
        let goes_on = || self.bodies.iter().all(|body| named.contains(body));
        match self.kind {
            Kind::Stuck | Kind::Coupled => false,
            Kind::OnSurface(surface) => lifts_off(scene, stage, surface, &self.bodies),
            Kind::OnArm => leaves,
            Kind::OnString => {
                matches!(stage, Stage::Impact(_) | Stage::Flight(_) | Stage::Fall(_) | Stage::Slide(_) | Stage::Taut(_))
            }
            Kind::Sprung => matches!(stage, Stage::Spring(_)),
            Kind::AtAnAngle => matches!(stage, Stage::Swing(_)),
            Kind::Raised => leaves || matches!(stage, Stage::Swing(_) | Stage::Slide(_)) && goes_on(),
            Kind::LiesOn { .. } => leaves || matches!(stage, Stage::Interact(_) | Stage::Walk(_)) && goes_on(),
        }
    }

    /// The agent that changes the velocities of its bodies as long as they are bound, where any does.
    fn acts_all_the_time(&self) -> Option<&'static str> {
        match self.kind {
            Kind::Stuck | Kind::OnSurface(_) | Kind::OnArm | Kind::Coupled | Kind::LiesOn { slides: false } => None,
            Kind::OnString => Some("the string still pulls"),
            Kind::Sprung => Some("the spring still presses"),
            Kind::AtAnAngle => Some("weight still acts, at an angle on its circle,"),
            Kind::Raised => Some("weight still acts, above its lowest place,"),
            Kind::LiesOn { slides: true } => Some("friction still acts"),
        }
    }

    /// Carries the bond through a stage that neither makes nor undoes it: a body that becomes part of another is bound as that,
    /// and one that lies on another slides on it once one of the two alone is struck.
    fn goes_through(&mut self, scene: &'a Scene, stage: &'a Stage) {
        let struck = Description::of(scene, stage).changed();
        if let Kind::LiesOn { slides } = &mut self.kind
            && !stage.takes_time()
        {
            *slides |= self.bodies.iter().any(|body| struck.contains(body));
        }
        if let Stage::Impact(Impact { becomes: Some(union), .. }) = stage {
            let joins = |body: &&mut &str| struck.contains(*body);
            self.bodies.iter_mut().filter(joins).for_each(|body| *body = union);
        }
    }

    /// Whether a stage that acts on some of the bodies has no equations for the bond.
    fn is_broken_by(&self, scene: &Scene, stage: &Stage, acted_on: &[&str]) -> bool {
        let acts_on_all = self.bodies.iter().all(|body| acted_on.contains(body));
        let drifts = matches!(stage, Stage::Drift(_));
        let lasts = stage.takes_time();
        if matches!(stage, Stage::Separate(_)) {
            return false;
        }
        match self.kind {
            Kind::OnSurface(surface) => {
                let acts = matches!(
                    stage,
                    Stage::Flight(_)
                        | Stage::Fall(_)
                        | Stage::Bounces(_)
                        | Stage::Impact(_)
                        | Stage::Blow(_)
                        | Stage::Taut(_)
                );
                acts && !lifts_off(scene, stage, surface, &self.bodies)
            }
            Kind::OnArm if matches!(stage, Stage::Rotate(_) | Stage::Strike(_)) => !acts_on_all,
            Kind::OnArm => !drifts && !self.is_released_by(scene, stage),
            Kind::Coupled if matches!(stage, Stage::Tow(_)) || !lasts => !acts_on_all,
            Kind::Stuck | Kind::Coupled => !drifts,
            Kind::OnString if matches!(stage, Stage::Connected(_)) => !acts_on_all,
            Kind::OnString => lasts && !self.is_released_by(scene, stage),
            // A spring is not impulsive: it gives nothing in a sudden stage.
            Kind::Sprung => lasts && !matches!(stage, Stage::Spring(_)),
            Kind::AtAnAngle => !matches!(stage, Stage::Swing(_)),
            Kind::Raised => !self.is_released_by(scene, stage),
            // Nor is friction; and where nothing moves on the other, it gives nothing in a drift.
            Kind::LiesOn { slides } => lasts && (slides || !drifts) && !self.is_released_by(scene, stage),
        }
    }
}
