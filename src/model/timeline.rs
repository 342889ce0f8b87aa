//! Who exists when, and since when a body has had its present velocity.

use std::collections::BTreeMap;

use crate::scene::Scene;
use crate::scene::Stage;
use crate::scene::stage::Ends;
use crate::scene::stage::Partners;
use crate::scene::stage::Separate;

use super::wording::noun;

/// Instants 1 to n + 1 around n stages, and which stage changes which body.
#[derive(Clone, Debug)]
pub struct Timeline {
    changed: Vec<Vec<String>>,
    /// From which instant to which a body exists; twice where it was part of another in between.
    lives: BTreeMap<String, Vec<(usize, usize)>>,
    names: Vec<String>,
    stage_names: Vec<Option<String>>,
}

impl Timeline {
    /// The timeline of a scene.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        let lives = lives(scene);
        Self {
            changed: scene.stages.iter().map(|stage| changed_bodies(scene, stage)).collect(),
            lives,
            names: scene.instants.clone(),
            stage_names: scene.stages.iter().map(|stage| stage.name().map(str::to_owned)).collect(),
        }
    }

    /// The last instant.
    #[must_use]
    pub fn last(&self) -> usize {
        self.changed.len() + 1
    }

    /// The bodies that exist at an instant.
    #[must_use]
    pub fn alive(&self, instant: usize) -> Vec<&str> {
        self.lives
            .iter()
            .filter(|(_, lives)| lives.iter().any(|(from, to)| (*from..=*to).contains(&instant)))
            .map(|(body, _)| body.as_str())
            .collect()
    }

    /// Every body, those that impacts make included.
    pub fn bodies(&self) -> impl Iterator<Item = &str> {
        self.lives.keys().map(String::as_str)
    }

    /// The instant since which a body has had the velocity that it has at `instant`; `None` where it does not exist then.
    #[must_use]
    pub fn since(&self, body: &str, instant: usize) -> Option<usize> {
        let lives = self.lives.get(body)?;
        let (from, _) = *lives.iter().find(|(from, to)| (*from..=*to).contains(&instant))?;
        let changes = self.changed.iter().enumerate().filter(|(_, bodies)| bodies.iter().any(|name| name == body));
        Some(changes.map(|(stage, _)| stage + 2).filter(|after| *after <= instant).max().unwrap_or(from).max(from))
    }

    /// The number of a named instant.
    #[must_use]
    pub fn instant(&self, name: &str) -> Option<usize> {
        self.names.iter().position(|own| own == name).map(|index| index + 1)
    }

    /// The position of the stage of that name, or of that key or noun where only one such stage could be meant, or of that number.
    #[must_use]
    pub fn stage(&self, scene: &Scene, name: &str) -> Option<usize> {
        let named = self.stage_names.iter().position(|own| own.as_deref() == Some(name));
        let is_meant = |stage: &Stage| stage.key() == name || noun(stage) == name;
        let of_kind: Vec<usize> =
            scene.stages.iter().enumerate().filter(|(_, stage)| is_meant(stage)).map(|(index, _)| index).collect();
        let counted = || name.parse::<usize>().ok()?.checked_sub(1).filter(|index| *index < scene.stages.len());
        named.or_else(|| if let [only] = of_kind[..] { Some(only) } else { None }).or_else(counted)
    }
}

/// From when to when each body exists. Bodies end where they become one or come apart, and begin where that makes them.
fn lives(scene: &Scene) -> BTreeMap<String, Vec<(usize, usize)>> {
    let last = scene.stages.len() + 1;
    let mut lives: BTreeMap<String, Vec<(usize, usize)>> =
        scene.bodies.keys().map(|body| (body.clone(), vec![(1, last)])).collect();
    for (index, stage) in scene.stages.iter().enumerate() {
        let (ended, begun): (Vec<&str>, Vec<&str>) = match stage {
            Stage::Impact(impact) => match (&impact.becomes, impact.partners()) {
                (Some(union), Some(Partners::Bodies(first, second))) => (vec![first, second], vec![union]),
                _ => continue,
            },
            Stage::Separate(separate) => match &separate.from {
                Some(whole) => (vec![whole], separate.into.iter().map(String::as_str).collect()),
                None => continue,
            },
            _ => continue,
        };
        if let Stage::Separate(Separate { from: Some(whole), .. }) = stage {
            // A whole that nothing made was there from the beginning.
            lives.entry(whole.clone()).or_insert_with(|| vec![(1, last)]);
        }
        for body in ended {
            if let Some(life) = lives.get_mut(body).and_then(|own| own.last_mut()) {
                life.1 = index + 1;
            }
        }
        for body in begun {
            let own = lives.entry(body.to_owned()).or_default();
            // A declared body that begins as a part was not there before, unless it ended before.
            own.retain(|(_, to)| *to < last);
            own.push((index + 2, last));
        }
    }
    lives
}

fn changed_bodies(scene: &Scene, stage: &Stage) -> Vec<String> {
    match stage {
        Stage::Impact(impact) => match impact.partners() {
            Some(Partners::Bodies(first, second)) => vec![first.to_owned(), second.to_owned()],
            Some(Partners::Surface(body, _)) => vec![body.to_owned()],
            None => Vec::new(),
        },
        Stage::Push(stage) => vec![stage.body.clone()],
        Stage::Slide(stage) => vec![stage.body.clone()],
        Stage::Spring(stage) => match stage.ends() {
            Some(Ends::Fixed(body)) => vec![body.to_owned()],
            Some(Ends::Free(first, second)) => vec![first.to_owned(), second.to_owned()],
            None => Vec::new(),
        },
        Stage::Swing(stage) => vec![stage.body.clone()],
        Stage::Taut(stage) => stage.between.to_vec(),
        Stage::Tow(stage) => stage.both().map(|own| own.body.clone()).to_vec(),
        Stage::Connected(stage) => vec![stage.trailing.body.clone(), stage.leading.body.clone()],
        Stage::Blow(stage) => vec![stage.body.clone()],
        Stage::Motion(stage) => vec![stage.body.clone()],
        Stage::Rotate(stage) => stage.held().into_iter().map(|(body, _)| body.to_owned()).collect(),
        Stage::Moment(_) => scene.bodies.keys().cloned().collect(),
        Stage::Strike(stage) => stage.carries.keys().chain([&stage.body]).cloned().collect(),
        Stage::Conical(stage) => vec![stage.body.clone()],
        Stage::Bowl(stage) => vec![stage.body.clone()],
        Stage::Interact(stage) => stage.between.clone(),
        Stage::Central(stage) => vec![stage.body.clone()],
        Stage::Fall(stage) => vec![stage.body.clone()],
        Stage::Bounces(stage) => vec![stage.body.clone()],
        Stage::Separate(stage) => stage.into.clone(),
        Stage::SlideOff(stage) => vec![stage.body.clone(), stage.on.clone()],
        Stage::Thrust(stage) => vec![stage.body.clone()],
        // All keep the velocities that they had; a walk goes from rest to rest.
        Stage::Stream(_) | Stage::Drift(_) | Stage::Walk(_) => Vec::new(),
        Stage::Flight(stage) => stage.flying().map(str::to_owned).collect(),
    }
}
