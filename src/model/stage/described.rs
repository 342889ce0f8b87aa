//! A description of each kind of stage for the rest of the room, in place of a question for each purpose.

#![deny(clippy::wildcard_enum_match_arm)]

use momentous_scene::Scene;
use momentous_scene::Stage;
use momentous_scene::stage::Ends;
use momentous_scene::stage::Partners;

/// A body that a stage names, and the key under which it does; none where that is the stage itself.
type Named<'a> = (&'a str, Option<&'static str>);

/// The key under which a stage names a body that turns about its point.
pub(crate) const ROTOR: &str = "rotor";

/// A stage as the rest of the room sees it.
pub(crate) struct Description<'a> {
    /// Its noun.
    pub noun: &'a str,
    /// How its start and its end are said.
    pub ends: Span<'a>,
    /// The bodies that it names, which must be there when it begins.
    pub bodies: Vec<Named<'a>>,
    /// The bodies whose velocities it changes, where they are not those that it names.
    pub changes: Option<Vec<&'a str>>,
    /// Whose place it leaves as it was.
    pub leaves: Leaves,
    /// Whether its equations hold in three dimensions.
    pub fills_space: bool,
    /// The point about which its moments are taken.
    pub about: Option<&'a str>,
    /// How many axes its equations may have, polar axes counting as none; empty where that is said elsewhere.
    pub axes: &'static [usize],
}

/// How the start and the end of a stage are said.
#[derive(Clone, Copy)]
pub(crate) enum Span<'a> {
    /// Just before and just after it.
    Sudden,
    /// At its start and at its end.
    Lasting,
    /// Before and after it.
    Around,
    /// With something arriving all the time.
    With(&'a str),
    /// In words of its own.
    Own([&'static str; 2]),
}

/// Whose place a stage leaves as it was.
#[derive(Clone, Copy)]
pub(crate) enum Leaves {
    /// The velocities of every body.
    All,
    /// The velocities of the bodies that it does not name.
    Others,
    /// The velocity of none.
    None,
}

impl<'a> Description<'a> {
    /// The description of a stage.
    #[allow(clippy::too_many_lines, reason = "one arm for each kind of stage")]
    pub(crate) fn of(scene: &'a Scene, stage: &'a Stage) -> Self {
        match stage {
            Stage::Impact(impact) => Self {
                bodies: match impact.partners() {
                    Some(Partners::Bodies(first, second)) => between([first, second]),
                    Some(Partners::Surface(body, _)) => alone(body),
                    None => Vec::new(),
                },
                fills_space: impact.between.is_some() && impact.line_of_impact.is_none(),
                ..Self::sudden("impact")
            },
            Stage::Push(push) => {
                let fills_space = push.over.is_none() && push.incline.is_none();
                let usual = if push.is_motion() { "motion" } else { "push" };
                let noun = push.called.as_deref().unwrap_or(usual);
                let key = if push.body.is_some() { "body" } else { "bodies" };
                let bodies = push.pushed().map(|body| (body, Some(key))).collect();
                Self { bodies, fills_space, ..Self::lasting(noun) }
            }
            Stage::Slide(slide) => Self { bodies: carried(&slide.body, slide.on.as_deref()), ..Self::lasting("slide") },
            Stage::Spring(spring) => Self {
                bodies: match spring.ends() {
                    Some(Ends::Fixed(body)) => alone(body),
                    Some(Ends::Free(first, second)) => between([first, second]),
                    None => Vec::new(),
                },
                ..Self::lasting("motion with the spring")
            },
            Stage::Swing(swing) => {
                let noun = if swing.radius.is_some() { "slide" } else { "swing" };
                Self { bodies: carried(&swing.body, swing.on.as_deref()), ..Self::lasting(noun) }
            }
            Stage::Taut(taut) => {
                let [key, noun] = match &taut.strings[..] {
                    [] => ["between", "jerk of the string"],
                    _ => ["strings", "jerk of the strings"],
                };
                Self { bodies: taut.jerked().into_iter().map(|body| (body, Some(key))).collect(), ..Self::sudden(noun) }
            }
            Stage::Connected(connected) => Self {
                bodies: vec![(&connected.trailing.body, Some("trailing")), (&connected.leading.body, Some("leading"))],
                ..Self::lasting("motion on the string")
            },
            Stage::Tow(tow) => Self {
                bodies: vec![(&tow.front.body, Some("front")), (&tow.rear.body, Some("rear"))],
                ..Self::lasting("common motion")
            },
            Stage::Blow(blow) => Self { bodies: alone(&blow.body), fills_space: true, ..Self::sudden("blow") },
            Stage::Rotate(rotate) => Self {
                bodies: rotate
                    .held()
                    .into_iter()
                    .map(|(body, _)| (body, None))
                    .chain(rotate.rotor.iter().map(|rotor| (rotor.as_str(), Some(ROTOR))))
                    .collect(),
                about: Some(&rotate.about),
                axes: &[1],
                ..Self::lasting("motion")
            },
            Stage::Moment(moment) => Self {
                bodies: scene.rotors().map(|body| (body, Some(ROTOR))).collect(),
                changes: Some(scene.bodies.keys().map(String::as_str).collect()),
                fills_space: true,
                about: Some(&moment.about),
                axes: &[2, 3],
                ..Self::lasting("turning")
            },
            Stage::Strike(strike) => Self {
                bodies: strike
                    .carries
                    .keys()
                    .chain([&strike.body])
                    .map(|body| (body.as_str(), None))
                    .chain(strike.rotor.iter().map(|rotor| (rotor.as_str(), Some(ROTOR))))
                    .collect(),
                about: Some(&strike.about),
                axes: &[1],
                ..Self::sudden("impact")
            },
            Stage::Conical(conical) => {
                let (noun, ends) = if conical.length.is_constant() {
                    ("steady motion", Span::Own(["on the circle"; 2]))
                } else {
                    ("change of the cord", Span::Around)
                };
                Self {
                    bodies: vec![(&conical.body, None)],
                    ends,
                    about: Some(&conical.about),
                    axes: &[1],
                    ..Self::lasting(noun)
                }
            }
            Stage::Bowl(bowl) => Self {
                bodies: vec![(&bowl.body, None)],
                ends: Span::Own(["at the first level", "at the second level"]),
                about: Some(&bowl.about),
                axes: &[0],
                ..Self::lasting("slide")
            },
            Stage::Interact(interact) if interact.friction.is_some() => Self {
                bodies: interact.between.iter().map(|body| (body.as_str(), Some("between"))).collect(),
                axes: &[1, 2, 3],
                ..Self::lasting("slide")
            },
            Stage::Interact(interact) => Self {
                bodies: interact.between.iter().map(|body| (body.as_str(), None)).collect(),
                ends: Span::Around,
                fills_space: true,
                axes: &[1, 2, 3],
                ..Self::lasting("encounter")
            },
            Stage::Central(central) => Self {
                bodies: vec![(&central.body, None)],
                ends: Span::Own(["at the first position", "at the second position"]),
                about: Some(&central.about),
                axes: &[0],
                ..Self::lasting("motion")
            },
            Stage::Fall(fall) => Self { bodies: alone(&fall.body), leaves: Leaves::Others, ..Self::lasting("fall") },
            Stage::Bounces(bounces) => Self {
                bodies: alone(&bounces.body),
                ends: Span::Own(["just before the first bounce", "after the bounces"]),
                ..Self::lasting("bouncing")
            },
            Stage::Stream(stream) => Self {
                bodies: alone(&stream.body),
                ends: Span::With(&stream.by),
                changes: Some(Vec::new()),
                leaves: Leaves::All,
                ..Self::lasting("stream")
            },
            Stage::Thrust(thrust) => Self { bodies: alone(&thrust.body), ..Self::lasting("burn") },
            Stage::Drift(_) => Self { fills_space: true, ..Self::lasting("free motion") },
            // The parts need not be there before: `check` looks at them.
            Stage::Separate(separate) => Self {
                changes: Some(separate.into.iter().map(String::as_str).collect()),
                fills_space: true,
                leaves: if separate.lasts() { Leaves::None } else { Leaves::All },
                ..Self::sudden(separate.called.as_deref().unwrap_or("separation"))
            },
            Stage::SlideOff(slide_off) => Self {
                bodies: vec![(&slide_off.body, Some("body")), (&slide_off.on, Some("on"))],
                ..Self::lasting("slide")
            },
            // From rest to rest.
            Stage::Walk(walk) => Self {
                bodies: vec![(&walk.body, Some("body")), (&walk.on, Some("on"))],
                ends: Span::Around,
                changes: Some(Vec::new()),
                ..Self::lasting("walk")
            },
            Stage::Flight(flight) => Self {
                bodies: flight
                    .body
                    .iter()
                    .map(|body| (body.as_str(), Some("body")))
                    .chain(flight.bodies.iter().map(|body| (body.as_str(), Some("bodies"))))
                    .collect(),
                leaves: Leaves::Others,
                fills_space: true,
                ..Self::lasting("flight")
            },
            Stage::Motion(motion) => Self { bodies: alone(&motion.body), ..Self::lasting("motion") },
        }
    }

    /// The bodies whose velocities it changes.
    pub(crate) fn changed(&self) -> Vec<&'a str> {
        self.changes.clone().unwrap_or_else(|| self.bodies.iter().map(|(body, _)| *body).collect())
    }

    /// Whether a body stays where it was.
    pub(crate) fn leaves(&self, body: &str) -> bool {
        match self.leaves {
            Leaves::All => true,
            Leaves::Others => self.bodies.iter().all(|(moved, _)| *moved != body),
            Leaves::None => false,
        }
    }

    fn lasting(noun: &'a str) -> Self {
        Self {
            noun,
            ends: Span::Lasting,
            bodies: Vec::new(),
            changes: None,
            leaves: Leaves::None,
            fills_space: false,
            about: None,
            axes: &[],
        }
    }

    fn sudden(noun: &'a str) -> Self {
        Self { ends: Span::Sudden, leaves: Leaves::All, ..Self::lasting(noun) }
    }
}

fn alone(body: &str) -> Vec<Named<'_>> {
    vec![(body, Some("body"))]
}

fn carried<'a>(body: &'a str, on: Option<&'a str>) -> Vec<Named<'a>> {
    [(body, Some("body"))].into_iter().chain(on.map(|on| (on, Some("on")))).collect()
}

fn between(bodies: [&str; 2]) -> Vec<Named<'_>> {
    bodies.map(|body| (body, Some("between"))).to_vec()
}
