//! Strings that have gone taut: until their ends approach each other they stay so, and whoever pulls one end away pulls the other along.

use momentous_scene::Stage;
use momentous_solve::Relation;

use super::Builder;
use super::Reason;
use super::guide::dot;
use super::taut_string::TautString;

impl Builder<'_> {
    /// After a stage that changes the velocity of an end of a taut string, the ends do not move apart along it.
    pub(super) fn strings_hold(&mut self, index: usize, stage: &Stage) {
        // A motion on the string has its pull among its forces, and what comes apart may be cut loose.
        if matches!(stage, Stage::Connected(_) | Stage::Tow(_) | Stage::Separate(_)) {
            return;
        }
        for string in self.taut_strings(index) {
            let ends: Option<Vec<String>> = string.ends.iter().map(|body| self.moves_with(body, index + 2)).collect();
            let Some([first, second]) =
                ends.as_deref().filter(|ends| ends.iter().any(|body| self.is_changed_in(body, index)))
            else {
                continue;
            };
            if first == second {
                continue;
            }
            let line = self.components(&string.direction);
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

    /// Whether a string that was jerked before is still taut between two bodies when a stage begins.
    pub(crate) fn is_string_taut(&self, index: usize, bodies: [&str; 2]) -> bool {
        let joins = |string: &TautString| string.ends.iter().all(|end| bodies.contains(&end.as_str()));
        self.taut_strings(index).iter().any(joins)
    }

    /// The strings that are taut when a stage begins, but for those that are jerked again in it. One that has been taut for a time is so
    /// while neither end changes its velocity; while no time passes, none goes slack.
    fn taut_strings(&self, index: usize) -> Vec<TautString> {
        let jerked_again = |string: &&TautString| {
            let is_same = |now: &TautString| now.ends == string.ends && now.direction == string.direction;
            self.strings.iter().any(|now| now.jerk == index && is_same(now))
        };
        let lasting = |jerk: usize| {
            let stages = self.scene.stages.iter().enumerate().take(index).skip(jerk + 1);
            stages.filter(|(_, stage)| stage.takes_time()).map(|(position, _)| position)
        };
        let since_jerk =
            |body: &str, jerk: usize, position: usize| self.timeline.since(body, position + 2) == Some(jerk + 2);
        let stays_taut = |string: &&TautString| {
            lasting(string.jerk).all(|at| string.ends.iter().all(|body| since_jerk(body, string.jerk, at)))
        };
        let earlier = self.strings.iter().filter(|string| string.jerk < index);
        earlier.filter(stays_taut).filter(|string| !jerked_again(string)).cloned().collect()
    }
}
