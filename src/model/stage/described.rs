//! What the rest of the room knows of each kind of stage: one description, in place of a question for each purpose.

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
    /// What it is called.
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
    /// That of every body.
    All,
    /// That of the bodies that it does not name.
    Others,
    /// That of none.
    None,
}

impl<'a> Description<'a> {
    /// The description of a stage.
    #[allow(clippy::too_many_lines, reason = "one arm for each kind of stage")]
    pub(crate) fn of(scene: &'a Scene, stage: &'a Stage) -> Self {
        match stage {
            Stage::Impact(own) => Self {
                bodies: match own.partners() {
                    Some(Partners::Bodies(first, second)) => between([first, second]),
                    Some(Partners::Surface(body, _)) => alone(body),
                    None => Vec::new(),
                },
                fills_space: own.between.is_some() && own.line_of_impact.is_none(),
                ..Self::sudden("impact")
            },
            Stage::Push(own) => {
                let fills_space = own.over.is_none() && own.incline.is_none();
                let usual = if own.is_motion() { "motion" } else { "push" };
                let noun = own.called.as_deref().unwrap_or(usual);
                let key = if own.body.is_some() { "body" } else { "bodies" };
                let bodies = own.pushed().map(|body| (body, Some(key))).collect();
                Self { bodies, fills_space, ..Self::lasting(noun) }
            }
            Stage::Slide(own) => Self { bodies: carried(&own.body, own.on.as_deref()), ..Self::lasting("slide") },
            Stage::Spring(own) => Self {
                bodies: match own.ends() {
                    Some(Ends::Fixed(body)) => alone(body),
                    Some(Ends::Free(first, second)) => between([first, second]),
                    None => Vec::new(),
                },
                ..Self::lasting("motion with the spring")
            },
            Stage::Swing(own) => {
                let noun = if own.radius.is_some() { "slide" } else { "swing" };
                Self { bodies: carried(&own.body, own.on.as_deref()), ..Self::lasting(noun) }
            }
            Stage::Taut(own) => {
                let [key, noun] = match &own.strings[..] {
                    [] => ["between", "jerk of the string"],
                    _ => ["strings", "jerk of the strings"],
                };
                Self { bodies: own.jerked().into_iter().map(|body| (body, Some(key))).collect(), ..Self::sudden(noun) }
            }
            Stage::Connected(own) => Self {
                bodies: vec![(&own.trailing.body, Some("trailing")), (&own.leading.body, Some("leading"))],
                ..Self::lasting("motion on the string")
            },
            Stage::Tow(own) => Self {
                bodies: vec![(&own.front.body, Some("front")), (&own.rear.body, Some("rear"))],
                ..Self::lasting("common motion")
            },
            Stage::Blow(own) => Self { bodies: alone(&own.body), fills_space: true, ..Self::sudden("blow") },
            Stage::Rotate(own) => Self {
                bodies: own
                    .held()
                    .into_iter()
                    .map(|(body, _)| (body, None))
                    .chain(own.rotor.iter().map(|rotor| (rotor.as_str(), Some(ROTOR))))
                    .collect(),
                about: Some(&own.about),
                axes: &[1],
                ..Self::lasting("motion")
            },
            Stage::Moment(own) => Self {
                bodies: scene.rotors().map(|body| (body, Some(ROTOR))).collect(),
                changes: Some(scene.bodies.keys().map(String::as_str).collect()),
                fills_space: true,
                about: Some(&own.about),
                axes: &[2, 3],
                ..Self::lasting("turning")
            },
            Stage::Strike(own) => Self {
                bodies: own
                    .carries
                    .keys()
                    .chain([&own.body])
                    .map(|body| (body.as_str(), None))
                    .chain(own.rotor.iter().map(|rotor| (rotor.as_str(), Some(ROTOR))))
                    .collect(),
                about: Some(&own.about),
                axes: &[1],
                ..Self::sudden("impact")
            },
            Stage::Conical(own) => Self {
                bodies: vec![(&own.body, None)],
                ends: Span::Around,
                about: Some(&own.about),
                axes: &[1],
                ..Self::lasting("change of the cord")
            },
            Stage::Bowl(own) => Self {
                bodies: vec![(&own.body, None)],
                ends: Span::Own(["at the first level", "at the second level"]),
                about: Some(&own.about),
                axes: &[0],
                ..Self::lasting("slide")
            },
            Stage::Interact(own) if own.friction.is_some() => Self {
                bodies: own.between.iter().map(|body| (body.as_str(), Some("between"))).collect(),
                axes: &[1, 2, 3],
                ..Self::lasting("slide")
            },
            Stage::Interact(own) => Self {
                bodies: own.between.iter().map(|body| (body.as_str(), None)).collect(),
                ends: Span::Around,
                fills_space: true,
                axes: &[1, 2, 3],
                ..Self::lasting("encounter")
            },
            Stage::Central(own) => Self {
                bodies: vec![(&own.body, None)],
                ends: Span::Own(["at the first position", "at the second position"]),
                about: Some(&own.about),
                axes: &[0],
                ..Self::lasting("motion")
            },
            Stage::Fall(own) => Self { bodies: alone(&own.body), leaves: Leaves::Others, ..Self::lasting("fall") },
            Stage::Bounces(own) => Self {
                bodies: alone(&own.body),
                ends: Span::Own(["just before the first bounce", "after the bounces"]),
                ..Self::lasting("bouncing")
            },
            Stage::Stream(own) => Self {
                bodies: alone(&own.body),
                ends: Span::With(&own.by),
                changes: Some(Vec::new()),
                leaves: Leaves::All,
                ..Self::lasting("stream")
            },
            Stage::Thrust(own) => Self { bodies: alone(&own.body), ..Self::lasting("burn") },
            Stage::Drift(_) => Self { fills_space: true, ..Self::lasting("free motion") },
            // The parts need not be there before: `check` looks at them.
            Stage::Separate(own) => Self {
                changes: Some(own.into.iter().map(String::as_str).collect()),
                fills_space: true,
                ..Self::sudden(own.called.as_deref().unwrap_or("separation"))
            },
            Stage::SlideOff(own) => {
                Self { bodies: vec![(&own.body, Some("body")), (&own.on, Some("on"))], ..Self::lasting("slide") }
            }
            // From rest to rest.
            Stage::Walk(own) => Self {
                bodies: vec![(&own.body, Some("body")), (&own.on, Some("on"))],
                ends: Span::Around,
                changes: Some(Vec::new()),
                ..Self::lasting("walk")
            },
            Stage::Flight(own) => Self {
                bodies: own
                    .body
                    .iter()
                    .map(|body| (body.as_str(), Some("body")))
                    .chain(own.bodies.iter().map(|body| (body.as_str(), Some("bodies"))))
                    .collect(),
                leaves: Leaves::Others,
                fills_space: true,
                ..Self::lasting("flight")
            },
            Stage::Motion(own) => Self { bodies: alone(&own.body), ..Self::lasting("motion") },
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
            Leaves::Others => self.bodies.iter().all(|(own, _)| *own != body),
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
