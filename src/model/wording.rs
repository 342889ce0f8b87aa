//! Phrases for stages and instants.

use std::borrow::Cow;

use crate::scene::Scene;
use crate::scene::Stage;
use crate::scene::stage::Separate;

/// What a kind of stage is called, and when its two ends are: key, noun, before, after. `{}` stands for the noun phrase.
const KINDS: &[(&str, &str, &str, &str)] = &[
    ("impact", "impact", "just before {}", "just after {}"),
    ("push", "push", "at the start of {}", "at the end of {}"),
    ("slide", "slide", "at the start of {}", "at the end of {}"),
    ("spring", "motion with the spring", "at the start of {}", "at the end of {}"),
    ("swing", "swing", "at the start of {}", "at the end of {}"),
    ("taut", "jerk of the string", "just before {}", "just after {}"),
    ("connected", "motion on the string", "at the start of {}", "at the end of {}"),
    ("tow", "common motion", "at the start of {}", "at the end of {}"),
    ("blow", "blow", "just before {}", "just after {}"),
    ("rotate", "motion", "at the start of {}", "at the end of {}"),
    ("moment", "turning", "before {}", "after {}"),
    ("strike", "impact", "just before {}", "just after {}"),
    ("conical", "change of the cord", "before {}", "after {}"),
    ("bowl", "slide", "at the first level", "at the second level"),
    ("interact", "encounter", "before {}", "after {}"),
    ("central", "motion", "at the first position", "at the second position"),
    ("fall", "fall", "at the start of {}", "at the end of {}"),
    ("slide_off", "slide", "at the start of {}", "at the end of {}"),
    ("motion", "motion", "at the start of {}", "at the end of {}"),
    ("walk", "walk", "before {}", "after {}"),
    ("stream", "stream", "while {} flows", "while {} flows"),
    ("thrust", "burn", "at the start of {}", "at the end of {}"),
    ("drift", "free motion", "at the start of {}", "at the end of {}"),
    ("flight", "flight", "at the start of {}", "at the end of {}"),
    ("separate", "separation", "just before {}", "just after {}"),
    ("bounces", "bouncing", "just before the first bounce", "after the bounces"),
];

/// Nouns that are forces themselves: a force called by any other name is the force *of* that.
const FORCES: &[&str] = &[
    "attraction",
    "drag",
    "force",
    "friction",
    "gravity",
    "lift",
    "load",
    "pull",
    "push",
    "reaction",
    "repulsion",
    "resistance",
    "tension",
    "thrust",
    "traction",
    "weight",
];

/// A force by the author's name for it: `the pull of the cable` as it is, `the table` as `the force of the table`.
pub(in crate::model) fn force_of(name: &str) -> Cow<'_, str> {
    let is_force = name.split_whitespace().any(|word| FORCES.contains(&word));
    if is_force { name.into() } else { format!("the force of {name}").into() }
}

const ORDINALS: &[&str] =
    &["first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth"];

fn kind(stage: &Stage) -> (&'static str, &'static str, &'static str) {
    let row = KINDS.iter().find(|row| row.0 == stage.key());
    row.map_or(("stage", "before {}", "after {}"), |row| (row.1, row.2, row.3))
}

/// What a stage is called: by its kind, or as the author calls it.
pub(super) fn noun(stage: &Stage) -> &str {
    match stage {
        Stage::Separate(Separate { called: Some(noun), .. }) => noun,
        _ => kind(stage).0,
    }
}

/// A stage as a noun phrase: `the impact`; `the second impact` where there are several.
pub(super) fn stage(scene: &Scene, index: usize) -> String {
    let Some(own) = scene.stages.get(index) else { return "the stage".into() };
    let noun = noun(own);
    let alike = |stage: &&Stage| self::noun(stage) == noun;
    let before = scene.stages.iter().take(index).filter(alike).count();
    if scene.stages.iter().filter(alike).count() < 2 {
        return format!("the {noun}");
    }
    let ordinal = ORDINALS.get(before).copied().unwrap_or("next");
    format!("the {ordinal} {noun}")
}

/// When an instant is, as an adverbial phrase.
pub(super) fn when(scene: &Scene, instant: usize) -> String {
    let after = instant.checked_sub(2).and_then(|index| Some((index, scene.stages.get(index)?)));
    let before = instant.checked_sub(1).and_then(|index| Some((index, scene.stages.get(index)?)));
    let (index, phrase) = match (after, before) {
        (Some((index, own)), _) => (index, kind(own).2),
        (None, Some((index, own))) => (index, kind(own).1),
        (None, None) => return "at the instant considered".into(),
    };
    // Where nothing else happens, it need not be said of what it is the end.
    let phrase = if scene.stages.len() == 1 { phrase.trim_end_matches(" of {}") } else { phrase };
    phrase.replace("{}", &stage(scene, index))
}
