//! Bodies on one line keep their order: none runs through another while a stage lasts.

use crate::ActingForce;
use crate::Builder;
use crate::Name;
use crate::QuantityKind;
use crate::Reason;
use momentous_expr::Expr;
use momentous_fault::Path;
use momentous_quantity::Dimension;
use momentous_scene::Axis;
use momentous_scene::Stage;
use momentous_scene::stage::Slide;
use momentous_solve::Relation;

impl Builder<'_> {
    /// At the end of a stage, bodies whose places are told lie on the same sides of one another as at first.
    pub(super) fn order_on_the_line(&mut self, index: usize) {
        let stages = &self.scene.stages;
        let is_free =
            |stage: &Stage| matches!(stage, Stage::Drift(_) | Stage::Flight(_) | Stage::Push(_) | Stage::Slide(_));
        let [(axis, _)] = self.axes[..] else { return };
        let placed = self.placed();
        if placed.len() < 2 || !stages.get(index).is_some_and(is_free) {
            return;
        }
        let end = index + 2;
        let is_placed = |body: &str| self.scene.members(body).iter().any(|member| placed.contains(*member));
        let alive = self.timeline.alive(end).into_iter().filter(|body| is_placed(body));
        let alive: Vec<String> = alive.map(str::to_owned).collect();
        for (position, one) in alive.iter().enumerate() {
            for other in alive.iter().skip(position + 1) {
                let both = |instant: &usize| {
                    let alive = self.timeline.alive(*instant);
                    [one, other].iter().all(|body| alive.contains(&body.as_str()))
                };
                let Some(first) = (1..end).find(both) else { continue };
                let [before, after] = [first, end].map(|instant| {
                    let [from, to] = [one, other].map(|body| self.place_by_way(body, instant, axis));
                    to - from
                });
                let reason = Reason::RunsThrough(self.called(one), self.called(other));
                self.require(before.clone() * after, Relation::AtLeast, Expr::zero(), reason.clone());
                let meanwhile = [one, other].map(|body| self.place_during(body, index, axis));
                if let [Some(from), Some(to)] = meanwhile {
                    self.stays_so(index, before * (to - from), reason);
                }
            }
        }
    }

    /// The place of a body at an instant, by its ways since the place that is told.
    fn place_by_way(&mut self, body: &str, instant: usize, axis: Axis) -> Expr {
        let (body, since) = self.place_since(body, instant);
        let spellings = [QuantityKind::Position, QuantityKind::Coordinate(axis)];
        let is_told = spellings.map(|kind| self.given.contains(&Name::of(kind, &body).at(since).to_string()));
        let way =
            since.checked_sub(2).filter(|_| is_told == [false; 2]).and_then(|stage| self.gone(&body, stage, axis));
        match way {
            Some(way) => self.place_by_way(&body, since - 1, axis) + way,
            None => self.place(&body, since, axis),
        }
    }

    /// The place of a body at each time of a push.
    fn place_during(&mut self, body: &str, index: usize, axis: Axis) -> Option<Expr> {
        let gone = self.displacement_during(body, index, axis)?;
        Some(self.place_by_way(body, index + 1, axis) + gone)
    }

    /// How far a body moves in a stage; none where that does not follow from its velocities alone.
    pub(super) fn gone(&mut self, body: &str, index: usize, axis: Axis) -> Option<Expr> {
        let stage = self.scene.stages.get(index)?;
        let evenly = self.mean_velocity(body, index, axis);
        let before = self.velocity(body, index + 1, axis);
        let lasting = self.lasting.get(index).cloned().flatten();
        // Two bodies that slide at the same time are told one after the other: of what a stage did not name, a later one knows nothing.
        let goes_on = self.begins == index + 1;
        if matches!(stage, Stage::Drift(_)) {
            return Some(before * lasting?);
        }
        if let Stage::Flight(flight) = stage {
            let is_even = flight.resistance.is_none() && flight.flying().any(|flying| flying == body);
            return Some(evenly * lasting.filter(|_| is_even)?);
        }
        if let Stage::Push(push) = stage {
            let clock = self.running_time();
            let changes = |force: &ActingForce| force.stage == index && force.strength.contains(clock);
            let is_simple = push.resistance.is_none() && push.mass_change().is_none();
            let is_even = is_simple && !push.depends_on_place(axis.letter()) && !self.forces.iter().any(changes);
            return if push.pushed().any(|pushed| pushed == body) {
                if !is_even {
                    return self.whole_displacement(index, body);
                }
                Some(evenly * lasting.filter(|_| is_even)?)
            } else {
                Some(before * lasting.filter(|_| goes_on)?)
            };
        }
        let Stage::Slide(Slide { body: sliding, on: None, height: None, direction, distance, .. }) = stage else {
            return None;
        };
        let path = Path::root().key("scene").key("stages").index(index).key(stage.key());
        let Some(distance) = distance else {
            let velocity = if sliding == body { Some(evenly) } else { goes_on.then_some(before) };
            return Some(velocity? * lasting?);
        };
        let way = self.read(distance, Dimension::LENGTH, "", &path.key("distance"));
        let way = Expr::integer(self.sense(direction.as_ref(), &path)) * way;
        if sliding == body {
            return Some(way);
        }
        // The velocity of what slides changes evenly, which tells the time.
        let meanwhile = way / self.mean_velocity(sliding, index, axis);
        goes_on.then(|| before * meanwhile)
    }

    fn mean_velocity(&mut self, body: &str, index: usize, axis: Axis) -> Expr {
        let ends = [index + 1, index + 2].map(|instant| self.velocity(body, instant, axis));
        Expr::sum(ends) / Expr::integer(2)
    }
}
