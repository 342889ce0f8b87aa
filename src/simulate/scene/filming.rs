//! How a motion that is integrated is watched: its bodies at common instants, and what acts on them meanwhile.

use crate::record::{GAUSS, Moment, Pivot, Record, Recorded, Tie};

use super::component::Component;
use super::formula::Course;
use super::integrate::{Integrator, Slope};
use super::nothing::NothingToSimulate;
use super::recorded_motion::{Look, RecordedMotion, SeenBody};
use super::stage_run::StageRun;

/// The evenly spaced instants of a motion.
const INSTANTS: u32 = 120;

/// The share of what forces give in a time by which two ways to add it up may be apart; the finer one is off by far less.
const OFF: f64 = 1e-7;

/// The number of times that the time between two instants is halved, at most, until that is so.
const HALVINGS: u32 = 6;

/// A motion to be watched: how its state goes on from a start to an end, and what is seen of it.
pub(super) struct Motion<'a, const N: usize> {
    pub names: &'a [&'a str],
    pub components: Vec<Component>,
    pub start: (f64, [f64; N]),
    pub end: f64,
    pub slope: Slope<'a, N>,
    pub course: &'a Course<N>,
    pub look: &'a dyn Fn(f64, &[f64; N]) -> Look,
}

impl StageRun<'_> {
    /// Watches a motion, where anybody does. One that goes on where the last one ended continues it; any other takes its place.
    pub(super) fn film<const N: usize>(&mut self, motion: &Motion<'_, N>) -> Result<(), NothingToSimulate> {
        let tolerance = self.tolerance;
        let Some(motions) = self.motions.as_mut().filter(|_| motion.end > motion.start.0) else { return Ok(()) };
        let ended = |recorded: &RecordedMotion| {
            recorded.record.moments.last().is_some_and(|last| last.time.total_cmp(&motion.start.0).is_eq())
        };
        let same = |recorded: &mut RecordedMotion| {
            recorded.record.bodies.iter().map(|body| body.name.as_str()).eq(motion.names.iter().copied())
        };
        let before = motions.pop_if(same);
        let followed = motion.course.followed();
        let mut recorded = before.filter(ended).unwrap_or_else(|| RecordedMotion {
            components: motion.components.clone(),
            record: Record::default(),
            followed,
            notes: Vec::new(),
        });
        recorded.followed = recorded.followed.and(followed);
        let longest = (motion.end - motion.start.0) / f64::from(INSTANTS);
        motion.watch(Integrator { tolerance, longest }, &mut recorded.record)?;
        motions.push(recorded);
        Ok(())
    }

    /// Notes what the bodies of the last motion that was watched move about.
    pub(super) fn about(&mut self, at: Vec<f64>, cord: bool) {
        if let Some(motion) = self.motions.as_mut().and_then(|motions| motions.last_mut()) {
            let tie = if cord { Tie::Cords } else { Tie::Nothing };
            motion.record.pivot = Some(Pivot { at, tie });
        }
    }

    /// Notes how far the point of an arm that the last motion shows is from the arm's pivot.
    pub(super) fn lever(&mut self, length: f64) {
        if let Some(motion) = self.motions.as_mut().and_then(|motions| motions.last_mut()) {
            motion.record.lever = Some(length);
        }
    }

    /// Notes what a reader of the last motion that was watched must know.
    pub(super) fn remark(&mut self, note: &'static str) {
        if let Some(motion) = self.motions.as_mut().and_then(|motions| motions.last_mut())
            && !motion.notes.contains(&note)
        {
            motion.notes.push(note);
        }
    }
}

impl<const N: usize> Motion<'_, N> {
    /// The state at a later time.
    fn later(&self, integrator: Integrator, from: (f64, [f64; N]), to: f64) -> Result<[f64; N], NothingToSimulate> {
        match self.course.known() {
            Some(formula) => Ok((formula.at)(to)),
            None => integrator.until(from.0, from.1, to, self.slope),
        }
    }

    fn watch(&self, integrator: Integrator, record: &mut Record) -> Result<(), NothingToSimulate> {
        let (start, mut state) = self.start;
        let first = (self.look)(start, &state);
        let mut given = match record.moments.last() {
            Some(last) => Given { outside: last.outside.clone(), work: last.work, ..Given::default() },
            None => Given { outside: vec![0.0; self.components.len()], ..Given::default() },
        };
        if record.bodies.is_empty() {
            let named = self.names.iter().zip(&first.bodies);
            record.bodies =
                named.map(|(name, body)| Recorded { name: (*name).to_owned(), mass: body.mass, radius: 0.0 }).collect();
        }
        let mut time = start;
        record.moments.push(moment(time, first, &given));
        for step in 1..=INSTANTS {
            // What goes on from here begins at the very end.
            let share = f64::from(step) / f64::from(INSTANTS);
            let next = if step == INSTANTS { self.end } else { start + (self.end - start) * share };
            let (_, roughly) = self.at_nodes(integrator, (time, state), next)?;
            let step = self.gives(integrator, (time, state), next, &roughly, HALVINGS)?;
            (state, time) = (step.0, next);
            given.add(&step.1);
            record.moments.push(moment(time, (self.look)(time, &state), &given));
        }
        Ok(())
    }

    /// The state at an instant, and what forces give until then, by halves until those agree with the whole.
    fn gives(
        &self,
        integrator: Integrator,
        from: (f64, [f64; N]),
        to: f64,
        whole: &Given,
        halvings: u32,
    ) -> Result<([f64; N], Given), NothingToSimulate> {
        let middle = f64::midpoint(from.0, to);
        let (half_way, first) = self.at_nodes(integrator, from, middle)?;
        let (end, second) = self.at_nodes(integrator, (middle, half_way), to)?;
        let mut both = first.clone();
        both.add(&second);
        if halvings == 0 || both.agrees(whole) {
            return Ok((end, both));
        }
        let (half_way, mut both) = self.gives(integrator, from, middle, &first, halvings - 1)?;
        let (end, second) = self.gives(integrator, (middle, half_way), to, &second, halvings - 1)?;
        both.add(&second);
        Ok((end, both))
    }

    /// The same by Gauss' rule for the whole time.
    fn at_nodes(
        &self,
        integrator: Integrator,
        (mut time, mut state): (f64, [f64; N]),
        to: f64,
    ) -> Result<([f64; N], Given), NothingToSimulate> {
        let (middle, half) = (f64::midpoint(time, to), (to - time) / 2.0);
        let mut given = Given { outside: vec![0.0; self.components.len()], ..Given::default() };
        for (place, weight) in GAUSS {
            let node = middle + place * half;
            (state, time) = (self.later(integrator, (time, state), node)?, node);
            let look = (self.look)(time, &state);
            for (sum, force) in given.outside.iter_mut().zip(&look.outside) {
                *sum += force * weight * half;
                given.pushes += force.abs() * weight * half;
            }
            given.work += look.power * weight * half;
            given.works += look.power.abs() * weight * half;
        }
        Ok((self.later(integrator, (time, state), to)?, given))
    }
}

/// The impulse and work that forces give in a time.
#[derive(Clone, Debug, Default)]
struct Given {
    /// The impulse from outside.
    outside: Vec<f64>,
    work: f64,
    /// The impulse that they would give if they acted one way all the time.
    pushes: f64,
    works: f64,
}

impl Given {
    fn add(&mut self, other: &Self) {
        for (sum, outside) in self.outside.iter_mut().zip(&other.outside) {
            *sum += outside;
        }
        self.work += other.work;
        self.pushes += other.pushes;
        self.works += other.works;
    }

    fn agrees(&self, other: &Self) -> bool {
        let off = self.outside.iter().zip(&other.outside).map(|(one, other)| (one - other).abs());
        off.sum::<f64>() <= OFF * self.pushes && (self.work - other.work).abs() <= OFF * self.works
    }
}

fn moment(time: f64, look: Look, given: &Given) -> Moment {
    let outside = &given.outside;
    let total: f64 = look.bodies.iter().map(|body| body.mass).sum();
    let added = |value: &dyn Fn(&SeenBody, usize) -> f64| -> Vec<f64> {
        (0..outside.len()).map(|part| look.bodies.iter().map(|body| body.mass * value(body, part)).sum()).collect()
    };
    let squares = |body: &SeenBody| body.velocity.iter().map(|part| part * part).sum::<f64>();
    Moment {
        time,
        centre: added(&|body, part| body.place[part] / total),
        momentum: added(&|body, part| body.velocity[part]),
        outside: outside.clone(),
        kinetic: look.bodies.iter().map(|body| body.mass * squares(body) / 2.0).sum(),
        potential: look.potential,
        lost: look.lost,
        work: given.work,
        masses: look.bodies.iter().map(|body| body.mass).collect(),
        positions: look.bodies.iter().map(|body| body.place.clone()).collect(),
        velocities: look.bodies.into_iter().map(|body| body.velocity).collect(),
    }
}
