//! Bodies that part at a contact do not run through each other, or through the wall, while nothing is said of another contact.

use crate::Builder;
use crate::Reason;
use crate::stage::Description;
use momentous_expr::Expr;
use momentous_fault::Path;
use momentous_scene::Axis;
use momentous_scene::Force;
use momentous_scene::Stage;
use momentous_scene::stage::Impact;
use momentous_scene::stage::Partners;
use momentous_scene::stage::Separate;
use momentous_solve::Relation;

/// The bodies that part at a contact along a line.
enum Parted {
    /// Two bodies, the second ahead of the first.
    Bodies([String; 2]),
    /// A body and a wall, on whose side along the axis (1) or against it (-1) it lies.
    Wall(String, String, i64),
}

impl Builder<'_> {
    /// At the end of a stage whatever parted at an earlier contact is still on its side.
    pub(super) fn stays_parted(&mut self, index: usize) {
        let scene = self.scene;
        let ([(axis, _)], Some(now)) = (&self.axes[..], scene.stages.get(index)) else { return };
        let axis = *axis;
        let rubs = |stage: &Stage| matches!(stage, Stage::Push(push) if push.forces.iter().any(|force| matches!(force, Force::Friction(_))));
        // Others go on evenly beside what moves without friction only: nobody says whether they rub on the floor.
        let (is_free, is_known) = (matches!(now, Stage::Drift(_)), matches!(now, Stage::Push(_)) && !rubs(now));
        let with_walls = is_free || matches!(now, Stage::Push(_) | Stage::Slide(_));
        for contact in (0..index).rev() {
            for parted in self.parted_at(contact) {
                match parted {
                    Parted::Bodies(both) if is_free || is_known => {
                        let [Some(behind), Some(ahead)] =
                            both.each_ref().map(|body| self.way_since(body, contact, index, axis))
                        else {
                            continue;
                        };
                        let [one, other] = both.each_ref().map(|body| self.called(body));
                        let reason = Reason::RunsThrough(one, other);
                        self.require(ahead, Relation::AtLeast, behind, reason.clone());
                        let meanwhile = both.each_ref().map(|body| self.way_at_each_time(body, contact, index, axis));
                        if let [Some(behind), Some(ahead)] = meanwhile {
                            self.stays_so(index, ahead - behind, reason);
                        }
                    }
                    Parted::Wall(body, wall, side) if with_walls => {
                        let Some(way) = self.way_since(&body, contact, index, axis) else { continue };
                        let reason = Reason::PassesThrough(self.called(&body), wall);
                        self.require(Expr::integer(side) * way, Relation::AtLeast, Expr::zero(), reason.clone());
                        if let Some(way) = self.way_at_each_time(&body, contact, index, axis) {
                            self.stays_so(index, Expr::integer(side) * way, reason);
                        }
                    }
                    Parted::Bodies(_) | Parted::Wall(..) => {}
                }
            }
        }
    }

    /// How far a body has moved since a contact at each time of a push.
    fn way_at_each_time(&mut self, body: &str, contact: usize, index: usize, axis: Axis) -> Option<Expr> {
        let now = self.displacement_during(body, index, axis)?;
        let earlier = if contact + 1 < index { self.way_since(body, contact, index - 1, axis)? } else { Expr::zero() };
        Some(earlier + now)
    }

    /// How far a body has moved since a contact; none where it does not follow, or where it has been in another contact since.
    fn way_since(&mut self, body: &str, contact: usize, index: usize, axis: Axis) -> Option<Expr> {
        let scene = self.scene;
        if [index + 1, index + 2].iter().any(|instant| !self.timeline.alive(*instant).contains(&body)) {
            return None;
        }
        let falls = self.downwards(0).is_some();
        let names = |stage: &Stage| Description::of(scene, stage).bodies.iter().any(|(named, _)| *named == body);
        let mut ways = Vec::new();
        for stage in contact + 1..=index {
            let entry = scene.stages.get(stage)?;
            if !entry.takes_time() {
                if names(entry) || matches!(entry, Stage::Separate(_)) {
                    return None;
                }
                continue;
            }
            // What later stages say of a body may happen at the same time.
            let is_told = |other: &Stage| other.takes_time() && !matches!(other, Stage::Drift(_)) && names(other);
            let is_beside = !matches!(entry, Stage::Drift(_)) && !names(entry);
            // Beside what moves on a slope or upright, weight may move it.
            let is_drawn = falls || matches!(entry, Stage::Push(push) if push.incline.is_some());
            if is_beside && (is_drawn || scene.stages.iter().skip(contact + 1).any(is_told)) {
                return None;
            }
            ways.push(self.gone(body, stage, axis)?);
        }
        Some(Expr::sum(ways))
    }

    /// The bodies that part at a contact along the only axis.
    fn parted_at(&mut self, contact: usize) -> Vec<Parted> {
        let scene = self.scene;
        let Some(stage) = scene.stages.get(contact) else { return Vec::new() };
        if let Stage::Separate(Separate { into, energy: Some(_), .. }) = stage {
            return into.windows(2).map(|pair| Parted::Bodies([pair[0].clone(), pair[1].clone()])).collect();
        }
        let Stage::Impact(impact @ Impact { becomes: None, plastic: false, .. }) = stage else { return Vec::new() };
        match impact.partners() {
            Some(Partners::Bodies(first, second)) => {
                let path = Path::root().key("scene").key("stages").index(contact).key(stage.key());
                let sense = self.sense(impact.line_of_impact.as_ref(), &path);
                let [first, second] = [first.to_owned(), second.to_owned()];
                vec![Parted::Bodies(if sense < 0 { [second, first] } else { [first, second] })]
            }
            Some(Partners::Surface(body, surface)) => {
                let Some(surface) = scene.surfaces.get(surface).filter(|surface| surface.velocity.is_none()) else {
                    return Vec::new();
                };
                let side = self.sense(Some(&surface.normal), &Path::root().key("scene").key("surfaces"));
                let wall = surface.name.clone().unwrap_or_else(|| "the wall".to_owned());
                vec![Parted::Wall(body.to_owned(), wall, side)]
            }
            None => Vec::new(),
        }
    }
}
