//! The lives of bodies: which exist when, and since when each has had its present velocity.

use std::collections::BTreeMap;

use momentous_scene::Scene;
use momentous_scene::Stage;
use momentous_scene::stage::Partners;
use momentous_scene::stage::Separate;

use super::stage::Description;

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
            changed: scene.stages.iter().map(|stage| changed(scene, stage)).collect(),
            lives,
            names: scene.instants.iter().map(|instant| instant.name().to_owned()).collect(),
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

    /// The instant by which a quantity of a body is named: the first from which on it has been as it is at `instant`, so that
    /// what does not change has one name. What names a body where it is not keeps its instant, and is refused as unknown.
    #[must_use]
    pub fn naming_instant(&self, body: &str, instant: usize) -> usize {
        self.since(body, instant).unwrap_or(instant)
    }

    /// The number of a named instant.
    #[must_use]
    pub fn instant(&self, name: &str) -> Option<usize> {
        self.names.iter().position(|known| known == name).map(|index| index + 1)
    }

    /// The position of the stage of that name, or of that key or noun where only one such stage could be meant, or of that number.
    #[must_use]
    pub fn stage(&self, scene: &Scene, name: &str) -> Option<usize> {
        let named = self.stage_names.iter().position(|stage_name| stage_name.as_deref() == Some(name));
        let is_meant = |stage: &Stage| stage.key() == name || Description::of(scene, stage).noun == name;
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
        let (ended, begun): (Vec<&str>, Vec<&str>) = if let Stage::Impact(impact) = stage
            && let (Some(union), Some(Partners::Bodies(first, second))) = (&impact.becomes, impact.partners())
        {
            (vec![first, second], vec![union])
        } else if let Stage::Separate(Separate { from: Some(whole), into, .. }) = stage {
            (vec![whole], into.iter().map(String::as_str).collect())
        } else {
            continue;
        };
        if let Stage::Separate(Separate { from: Some(whole), .. }) = stage {
            // A whole that nothing made was there from the beginning.
            lives.entry(whole.clone()).or_insert_with(|| vec![(1, last)]);
        }
        for body in ended {
            if let Some(life) = lives.get_mut(body).and_then(|lives| lives.last_mut()) {
                life.1 = index + 1;
            }
        }
        for body in begun {
            let lives = lives.entry(body.to_owned()).or_default();
            // A declared body that begins as a part was not there before, unless it ended before.
            lives.retain(|(_, to)| *to < last);
            lives.push((index + 2, last));
        }
    }
    lives
}

/// The bodies whose velocities a stage changes.
fn changed(scene: &Scene, stage: &Stage) -> Vec<String> {
    Description::of(scene, stage).changed().into_iter().map(str::to_owned).collect()
}
