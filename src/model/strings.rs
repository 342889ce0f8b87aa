//! Strings that have gone taut: until their ends approach each other they stay so, and whoever pulls one end away pulls the other along.

use momentous_scene::Scene;
use momentous_scene::Stage;
use momentous_solve::Relation;

use super::Builder;
use super::Reason;
use super::guide::dot;

/// A taut string: the stage in which it went taut, and the bodies at its ends, the second ahead of the first.
type Taut<'s> = (usize, [&'s str; 2]);

impl Builder<'_> {
    /// After a stage that changes the velocity of an end of a taut string, the ends do not move apart along it.
    pub(super) fn strings_hold(&mut self, index: usize, stage: &Stage) {
        // A motion on the string has its pull among its forces, and what comes apart may be cut loose.
        if matches!(stage, Stage::Connected(_) | Stage::Tow(_) | Stage::Separate(_)) {
            return;
        }
        for (jerk, bodies) in self.taut_strings(self.scene, index) {
            let ends: Option<Vec<String>> = bodies.iter().map(|body| self.moves_with(body, index + 2)).collect();
            let Some([first, second]) =
                ends.as_deref().filter(|ends| ends.iter().any(|own| self.is_changed_in(own, index)))
            else {
                continue;
            };
            let Some(frame) = self.frames.get(jerk).cloned().flatten().filter(|_| first != second) else { continue };
            let line = self.components(&frame.normal);
            let reason = Reason::StringStretches(self.called(first), self.called(second));
            let [behind, ahead] = [first, second].map(|body| dot(&self.velocities(body, index + 2), &line));
            self.require(behind, Relation::AtLeast, ahead, reason);
            if let Stage::Taut(_) = stage {
                let [first, second] = [first, second].map(|body| self.called(body));
                let what = format!("the string between {first} and {second}, which is taut already");
                self.neglect(what, "its ends do not move apart in this jerk: it slackens, and does not pull");
            }
        }
    }

    /// The strings that are taut when a stage begins. One that has been taut for a time is so while neither end changes its velocity; while
    /// no time passes, none goes slack.
    fn taut_strings<'s>(&self, scene: &'s Scene, index: usize) -> Vec<Taut<'s>> {
        let mut taut: Vec<Taut<'s>> = Vec::new();
        for (position, stage) in scene.stages.iter().enumerate().take(index) {
            if let Stage::Taut(own) = stage {
                taut.push((position, own.between.each_ref().map(String::as_str)));
            }
            if stage.takes_time() {
                let since_jerk = |body: &str, jerk: usize| self.timeline.since(body, position + 2) == Some(jerk + 2);
                taut.retain(|(jerk, bodies)| bodies.iter().all(|body| since_jerk(body, *jerk)));
            }
        }
        taut
    }
}
