//! Particles under forces and a constraint, said as data, and Newton's second law for all of them together.

use std::borrow::Cow;
use std::sync::Arc;

use super::component::Frame;
use super::integrate::End;
use super::reel::{Look, Seen};
use super::values::OfTime;
use super::vector::{Vector, ZERO, add, dot, less, times, within};

/// A particle, and how it starts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Particle<'a> {
    pub name: &'a str,
    /// Its mass; none where it is too heavy to be moved.
    pub mass: Option<f64>,
    pub place: Vector,
    pub velocity: Vector,
    /// Its acceleration in free fall.
    pub falls: Vector,
    /// The one direction in which a guide lets it move.
    pub guide: Option<Vector>,
}

/// Particles by their places in a list, each with a vector: for a force, what a unit of its strength does to each; for something
/// stretched between them, how much longer it gets for a metre that each moves.
pub(super) type Lines = Vec<(usize, Vector)>;

/// What acts on particles.
pub(super) struct Force {
    pub on: Lines,
    pub strength: Strength,
}

/// How strong a force is.
pub(super) enum Strength {
    /// As the time says.
    InTime(OfTime),
    /// As a spring pulls, which is deformed by so much where all particles are at the origin.
    Spring { stiffness: f64, deformed: f64 },
}

/// What particles cannot leave.
pub(super) enum Constraint {
    /// A cord or a coupling that keeps its length, or a straight face that one body slides along on another.
    Length(Lines),
    Surface(Surface),
}

/// The surface round a centre on which `x² s_x + y² s_y + z² s_z` is constant, for squares `s`: a sphere or a circle, or a cone with
/// its tip in the centre.
#[derive(Clone, Copy, Debug)]
pub(super) struct Surface {
    pub on: usize,
    /// The particle that carries the surface, where it is not fixed.
    pub carrier: Option<usize>,
    pub centre: Vector,
    pub squares: Vector,
    /// Half the second derivative of the constant by the time.
    pub changes: f64,
}

/// Particles, and all that acts on them. A state holds place and velocity of each particle, and behind them the impulses of the
/// first forces, as many as it has room for: its length `N` is six for each particle, and one for each impulse.
pub(super) struct System<'a, const N: usize> {
    pub frame: Frame,
    pub particles: Vec<Particle<'a>>,
    pub forces: Vec<Force>,
    pub constraint: Option<Constraint>,
    /// When the motion starts.
    pub start: f64,
    /// Times at which a force changes its law.
    pub changes: Vec<f64>,
    /// The energy that was lost before.
    pub lost: f64,
}

/// The place of a particle in a state.
pub(super) fn place(state: &[f64], particle: usize) -> Vector {
    within(state, 6 * particle)
}

/// The velocity of a particle in a state, or its acceleration in a slope.
pub(super) fn velocity(state: &[f64], particle: usize) -> Vector {
    within(state, 6 * particle + 3)
}

impl<'a> Particle<'a> {
    /// A particle at the origin that nothing guides, and that does not fall.
    pub(super) fn free(name: &'a str, mass: f64, velocity: Vector) -> Self {
        Self { name, mass: Some(mass), place: ZERO, velocity, falls: ZERO, guide: None }
    }

    /// What a force does to it: the acceleration, and what its guide adds to the force.
    pub(super) fn yields(&self, force: Vector) -> (Vector, Vector) {
        let Some(mass) = self.mass else { return (ZERO, ZERO) };
        let felt = self.let_through(force);
        (felt.map(|part| part / mass), less(felt, force))
    }

    fn let_through(&self, vector: Vector) -> Vector {
        self.guide.map_or(vector, |along| times(dot(along, vector), along))
    }
}

impl Force {
    /// A force in the time of the stage.
    pub(super) fn in_time(on: Lines, strength: OfTime) -> Self {
        Self { on, strength: Strength::InTime(strength) }
    }

    /// A force on one particle that stays what it is.
    pub(super) fn steady(on: usize, force: Vector) -> Self {
        Self::in_time(vec![(on, force)], Arc::new(|_| 1.0))
    }

    /// A spring that is deformed by so much where all particles are at the origin.
    pub(super) fn spring(on: Lines, stiffness: f64, deformed: f64) -> Self {
        Self { on, strength: Strength::Spring { stiffness, deformed } }
    }

    fn strength(&self, time: f64, state: &[f64]) -> f64 {
        match &self.strength {
            Strength::InTime(strength) => strength(time),
            Strength::Spring { stiffness, .. } => -stiffness * self.deformation(state).unwrap_or(0.0),
        }
    }

    /// How far a spring is deformed.
    pub(super) fn deformation(&self, state: &[f64]) -> Option<f64> {
        let Strength::Spring { deformed, .. } = self.strength else { return None };
        Some(self.on.iter().fold(deformed, |sum, (own, along)| sum + dot(*along, place(state, *own))))
    }
}

impl Surface {
    /// A fixed sphere round the origin, for one particle.
    pub(super) fn sphere() -> Self {
        Self { on: 0, carrier: None, centre: ZERO, squares: [1.0; 3], changes: 0.0 }
    }

    /// A fixed circle in the plane of x and y.
    pub(super) fn circle(centre: Vector) -> Self {
        Self { centre, squares: [1.0, 1.0, 0.0], ..Self::sphere() }
    }

    /// A fixed cone whose wall is so far from its axis for each metre of height.
    pub(super) fn cone(tangent: f64) -> Self {
        Self { squares: [1.0, 1.0, -tangent * tangent], ..Self::sphere() }
    }

    fn weighed(&self, vector: Vector) -> Vector {
        [0, 1, 2].map(|own| self.squares[own] * vector[own])
    }
}

impl Constraint {
    /// Along which lines it acts on the particles, and what their accelerations along these lines must add up to.
    fn lines(&self, state: &[f64]) -> (Cow<'_, [(usize, Vector)]>, f64) {
        match self {
            Self::Length(lines) => (Cow::Borrowed(lines), 0.0),
            Self::Surface(own) => {
                let seen = |of: fn(&[f64], usize) -> Vector| {
                    own.carrier.map_or(of(state, own.on), |carrier| less(of(state, own.on), of(state, carrier)))
                };
                let (normal, moving) = (own.weighed(less(seen(place), own.centre)), seen(velocity));
                let back = own.carrier.map(|carrier| (carrier, times(-1.0, normal)));
                let lines = [(own.on, normal)].into_iter().chain(back).collect();
                (Cow::Owned(lines), own.changes - dot(moving, own.weighed(moving)))
            }
        }
    }
}

impl<'a, const N: usize> System<'a, N> {
    /// Particles on which nothing acts.
    pub(super) fn new(frame: Frame, particles: Vec<Particle<'a>>) -> Self {
        Self { frame, particles, forces: Vec::new(), constraint: None, start: 0.0, changes: Vec::new(), lost: 0.0 }
    }

    /// Starts again where it ended.
    pub(super) fn go_on_from(&mut self, end: &End<N>) {
        self.start = end.time;
        for (own, particle) in self.particles.iter_mut().enumerate() {
            (particle.place, particle.velocity) = (place(&end.state, own), velocity(&end.state, own));
        }
    }

    /// The state at the start.
    pub(super) fn state(&self) -> [f64; N] {
        let mut state = [0.0; N];
        for (part, particle) in state.chunks_exact_mut(6).zip(&self.particles) {
            part[..3].copy_from_slice(&particle.place);
            part[3..].copy_from_slice(&particle.velocity);
        }
        state
    }

    /// How the state changes.
    pub(super) fn slope(&self, time: f64, state: &[f64; N]) -> [f64; N] {
        let mut slope = self.free(time, state);
        if let Some((lines, pull)) = self.pull(state, &slope) {
            self.push(&mut slope, &lines, pull);
        }
        slope
    }

    /// How strongly the constraint acts along its lines: the tension of a cord that pulls along unit vectors.
    pub(super) fn tension(&self, time: f64, state: &[f64; N]) -> f64 {
        self.pull(state, &self.free(time, state)).map_or(0.0, |(_, pull)| pull)
    }

    /// How the state would change without the constraint.
    fn free(&self, time: f64, state: &[f64; N]) -> [f64; N] {
        let mut slope = [0.0; N];
        for (own, (part, particle)) in slope.chunks_exact_mut(6).zip(&self.particles).enumerate() {
            part[..3].copy_from_slice(&velocity(state, own));
            part[3..].copy_from_slice(&particle.let_through(particle.falls));
        }
        for (own, force) in self.forces.iter().enumerate() {
            let strength = force.strength(time, state);
            self.push(&mut slope, &force.on, strength);
            if let Some(impulse) = slope.get_mut(6 * self.particles.len() + own) {
                *impulse = strength;
            }
        }
        slope
    }

    /// Adds the accelerations by a force.
    fn push(&self, slope: &mut [f64; N], on: &[(usize, Vector)], strength: f64) {
        for (own, along) in on {
            let (gained, _) = self.particles[*own].yields(times(strength, *along));
            let changed = add(velocity(slope, *own), gained);
            slope[6 * own + 3..6 * own + 6].copy_from_slice(&changed);
        }
    }

    /// The lines of the constraint, and how strongly it acts along them so that the particles stay where it holds them.
    fn pull(&self, state: &[f64; N], free: &[f64; N]) -> Option<(Cow<'_, [(usize, Vector)]>, f64)> {
        let (lines, mut missing) = self.constraint.as_ref()?.lines(state);
        let mut gained = 0.0;
        for (own, along) in lines.iter() {
            missing -= dot(*along, velocity(free, *own));
            gained += dot(*along, self.particles[*own].yields(*along).0);
        }
        Some((lines, missing / gained))
    }

    /// What is seen of it.
    pub(super) fn look(&self, time: f64, state: &[f64; N]) -> Look {
        let now = |(own, particle): (usize, &Particle<'a>)| {
            (Particle { place: place(state, own), velocity: velocity(state, own), ..*particle }, ZERO, 0.0)
        };
        let mut look = self.frame.look(self.particles.iter().enumerate().map(now));
        let mut outside = ZERO;
        for force in &self.forces {
            let strength = force.strength(time, state);
            outside = add(outside, self.unbalanced(&force.on, strength));
            match (&force.strength, force.deformation(state)) {
                (Strength::Spring { stiffness, .. }, Some(deformation)) => {
                    look.potential += stiffness * deformation * deformation / 2.0;
                    // What a spring takes from an end that nothing moves.
                    look.power -= strength * self.grows(&force.on, state, false);
                }
                _ => look.power += strength * self.grows(&force.on, state, true),
            }
        }
        if let Some((lines, pull)) = self.pull(state, &self.free(time, state)) {
            outside = add(outside, self.unbalanced(&lines, pull));
            // What keeps its length or its shape does no work.
            if matches!(&self.constraint, Some(Constraint::Surface(own)) if own.changes != 0.0) {
                look.power += pull * self.grows(&lines, state, true);
            }
        }
        for (sum, part) in look.outside.iter_mut().zip(self.frame.split(outside)) {
            *sum += part;
        }
        Look { lost: self.lost, ..look }
    }

    /// What a force comes to on all particles together: nothing where it acts between them, but for what guides take up.
    fn unbalanced(&self, on: &[(usize, Vector)], strength: f64) -> Vector {
        let movable = on.iter().filter(|(own, _)| self.particles[*own].mass.is_some());
        movable.fold(ZERO, |all, (own, along)| add(all, self.particles[*own].let_through(times(strength, *along))))
    }

    /// How fast that gets longer which lies along lines, by the motion of what can be moved or of what cannot.
    fn grows(&self, on: &[(usize, Vector)], state: &[f64; N], movable: bool) -> f64 {
        let of = on.iter().filter(|(own, _)| self.particles[*own].mass.is_some() == movable);
        of.map(|(own, along)| dot(*along, velocity(state, *own))).sum()
    }
}

impl Frame {
    /// What is seen of particles, each with the force from outside on it besides its weight, and the power of all but its weight.
    pub(super) fn look<'a>(&self, all: impl Iterator<Item = (Particle<'a>, Vector, f64)>) -> Look {
        let (mut outside, mut look) = (ZERO, Look::default());
        for (own, force, power) in all {
            let Some(mass) = own.mass else { continue };
            outside = add(outside, add(force, times(mass, own.let_through(own.falls))));
            look.potential -= mass * dot(own.falls, own.place);
            look.power += power;
            look.bodies.push(Seen { mass, place: self.split(own.place), velocity: self.split(own.velocity) });
        }
        look.outside = self.split(outside);
        look
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// At rest on a cone of 45°, half of the weight is felt along the wall: the acceleration is that of a slope.
    #[test]
    fn a_cone_is_a_slope_for_what_does_not_turn() {
        let rests = Particle { place: [1.0, 0.0, 1.0], falls: [0.0, 0.0, -10.0], ..Particle::free("A", 2.0, ZERO) };
        let cone = Some(Constraint::Surface(Surface::cone(1.0)));
        let system = System::<6> { constraint: cone, ..System::new(Frame::upright_space(), vec![rests]) };
        let slope = system.slope(0.0, &system.state());
        assert!(
            (slope[3] + 5.0).abs() < 1e-12 && (slope[5] + 5.0).abs() < 1e-12 && slope[..3] == [0.0; 3],
            "{slope:?}"
        );
    }

    /// 1 kg and 3 kg on one string, the heavier hanging: both with 7.5 m/s², a tension of 7.5 N, and what falls gains energy.
    #[test]
    fn a_cord_pulls_both_ends_alike() {
        let ahead = [1.0, 0.0, 0.0];
        let hangs = Particle { falls: [10.0, 0.0, 0.0], ..Particle::free("B", 3.0, ahead) };
        let mut system = System::<12>::new(Frame::line("s"), vec![Particle::free("A", 1.0, ahead), hangs]);
        system.constraint = Some(Constraint::Length(vec![(0, ahead), (1, times(-1.0, ahead))]));
        let (slope, look) = (system.slope(0.0, &system.state()), system.look(0.0, &system.state()));
        assert!((slope[3] - 7.5).abs() < 1e-12 && (slope[9] - 7.5).abs() < 1e-12, "{slope:?}");
        assert!((system.tension(0.0, &system.state()) - 7.5).abs() < 1e-12);
        assert!((look.outside[0] - 30.0).abs() < 1e-12 && look.power.abs() < 1e-12, "the tension is from inside");
    }
}
