//! The closed motion of particles by the kinds of what acts on them.
//!
//! | what acts | the motion |
//! |---|---|
//! | weight, and forces that are polynomials in the time | a polynomial |
//! | forces of the time alone whose integrals have a formula | these integrals |
//! | and springs | sums of sines |
//! | and resistances in proportion to the speed | sums of exponentials |
//! | a resistance in proportion to its square, against what stays as it is | tangents, hyperbolic or not |
//! | a circle round an upright axis that neither rises nor sinks | that circle |
//! | anything else | followed by its equations |

use super::formula::{
    CIRCLE, COUPLED, CURVE, Course, DRIVEN, EXPONENTIALS, INTEGRALS, MIXED, POLYNOMIAL, SINES, SQUARES, STRENGTH,
};
use super::in_time::Sums;
use super::modes::{Pulling, modes};
use super::particles::{Constraint, Force, Strength, velocity};
use super::square::Square;
use super::system::System;
use super::turned::steady_circle;
use super::vector::dot;

/// A force whose integrals are known, what a unit of it does to the particles, and where the state counts its impulse.
struct Known<const N: usize> {
    answer: [f64; N],
    impulse: Option<usize>,
    integrals: Sums,
}

/// The forces of a system by their kinds, with their places in its list.
#[derive(Default)]
struct Kinds {
    timed: Vec<usize>,
    springs: Vec<usize>,
    linear: Vec<usize>,
    square: Vec<usize>,
    mixed: bool,
}

impl Kinds {
    fn of(forces: &[Force]) -> Self {
        let mut kinds = Self::default();
        for (index, force) in forces.iter().enumerate() {
            match force.strength {
                Strength::InTime(_) => kinds.timed.push(index),
                Strength::Spring { .. } => kinds.springs.push(index),
                Strength::Resistance { linear, quadratic: 0.0 } => {
                    kinds.linear.extend((linear != 0.0).then_some(index));
                }
                Strength::Resistance { linear, .. } => {
                    kinds.square.push(index);
                    kinds.mixed |= linear != 0.0;
                }
            }
        }
        let depending = [&kinds.springs, &kinds.linear, &kinds.square];
        kinds.mixed |= depending.into_iter().filter(|list| !list.is_empty()).count() > 1;
        kinds
    }
}

impl<const N: usize> System<'_, N> {
    /// The course from a state on, until the next change of a force.
    pub(super) fn course(&self, time: f64, state: &[f64; N]) -> Course<N> {
        let found = match self.constraint {
            Some(Constraint::Surface(_)) => {
                steady_circle(self, time, state).map(|at| Course::formula(CIRCLE, at)).ok_or(CURVE)
            }
            _ => self.straight(time, state),
        };
        found.unwrap_or_else(Course::Equations)
    }

    /// The course of particles whose constraint, if any, always acts along the same lines.
    fn straight(&self, time: f64, state: &[f64; N]) -> Result<Course<N>, &'static str> {
        let kinds = Kinds::of(&self.forces);
        if kinds.mixed {
            return Err(MIXED);
        }
        let (falls, mut driven) = (self.falling(), vec![self.falling()]);
        let (mut known, mut polynomial) = (Vec::new(), true);
        for index in kinds.timed {
            let force = &self.forces[index];
            let Strength::InTime(strength) = &force.strength else { continue };
            let Some(law) = strength.law(time) else { continue };
            let answer = self.answer(index);
            let coefficients = law.polynomial_since(time);
            polynomial &= coefficients.is_some();
            for (power, value) in coefficients.into_iter().flatten().enumerate() {
                driven.resize(driven.len().max(power + 1), [0.0; N]);
                for (sum, part) in driven[power].iter_mut().zip(&answer) {
                    *sum += value * part;
                }
            }
            known.push(self.known(index, answer, law.integrals_since(time).ok_or(STRENGTH)?));
        }
        let mut why = if polynomial { POLYNOMIAL } else { INTEGRALS };
        for (list, reason, swings) in [(&kinds.springs, SINES, true), (&kinds.linear, EXPONENTIALS, false)] {
            if list.is_empty() {
                continue;
            }
            if !polynomial {
                return Err(DRIVEN);
            }
            why = reason;
            let pulling: Vec<Pulling> = list.iter().map(|index| self.pulling(*index, list, state, &driven)).collect();
            let all = list.iter().zip(modes(&pulling, swings));
            known.extend(all.map(|(index, integrals)| self.known(*index, self.answer(*index), integrals)));
        }
        for index in &kinds.square {
            let Pulling { coefficient, starts: [_, speed], driven, answers } =
                self.pulling(*index, &kinds.square, state, &driven);
            let ([drive], [answer], true) = (&driven[..], &answers[..], polynomial) else { return Err(COUPLED) };
            why = SQUARES;
            if *answer > 0.0 {
                let (square, answer) = (Square { drive: *drive, rate: coefficient * answer, speed }, *answer);
                let integrals = Box::new(move |gone| square.integrals(gone).map(|sum| sum / answer));
                known.push(self.known(*index, self.answer(*index), integrals));
            }
        }
        let (particles, start) = (self.particles.len(), *state);
        Ok(Course::formula(why, move |now| along(particles, (time, &start), &falls, &known, now)))
    }

    fn known(&self, index: usize, answer: [f64; N], integrals: Sums) -> Known<N> {
        let impulse = Some(6 * self.particles.len() + index).filter(|place| *place < N);
        Known { answer, impulse, integrals }
    }

    /// What changes along the line of a force among those of its kind, of which a square only knows those that it feels.
    fn pulling(&self, index: usize, kind: &[usize], state: &[f64; N], driven: &[[f64; N]]) -> Pulling {
        let force = &self.forces[index];
        let along = |slope: &[f64]| force.on.iter().map(|(on, line)| dot(*line, velocity(slope, *on))).sum::<f64>();
        let (coefficient, deformed, square) = match force.strength {
            Strength::Spring { stiffness, deformed } => (stiffness, force.stretched(deformed, state), false),
            Strength::Resistance { linear, quadratic } => (linear + quadratic, 0.0, quadratic != 0.0),
            Strength::InTime(_) => (0.0, 0.0, false),
        };
        let answers = kind.iter().map(|other| (*other, along(&self.answer(*other))));
        Pulling {
            coefficient,
            starts: [deformed, along(state)],
            driven: driven.iter().map(|slope| along(slope)).collect(),
            answers: answers
                .filter(|(other, answer)| !square || *other == index || *answer != 0.0)
                .map(|each| each.1)
                .collect(),
        }
    }
}

/// The state of so many particles at a time, by what falls and by what the forces have added up to.
fn along<const N: usize>(
    particles: usize,
    (begun, start): (f64, &[f64; N]),
    falls: &[f64; N],
    known: &[Known<N>],
    now: f64,
) -> [f64; N] {
    let (gone, mut state) = (now - begun, *start);
    let mut gain = |answer: &[f64; N], [once, twice]: [f64; 2]| {
        for particle in (0..particles).map(|index| 6 * index) {
            for part in particle..particle + 3 {
                state[part] += twice * answer[part + 3];
                state[part + 3] += once * answer[part + 3];
            }
        }
    };
    gain(falls, [gone, gone * gone / 2.0]);
    let sums: Vec<[f64; 2]> = known.iter().map(|force| (force.integrals)(gone)).collect();
    for (force, sums) in known.iter().zip(&sums) {
        gain(&force.answer, *sums);
    }
    for part in (0..particles).flat_map(|index| 6 * index..6 * index + 3) {
        state[part] += start[part + 3] * gone;
    }
    for (force, [once, _]) in known.iter().zip(sums) {
        if let Some(impulse) = force.impulse {
            state[impulse] += once;
        }
    }
    state
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;
    use crate::scene::component::Frame;
    use crate::scene::formula::Followed;
    use crate::scene::in_time::InTime;
    use crate::scene::integrate::Integrator;
    use crate::scene::particles::{Particle, Surface};

    const AHEAD: [f64; 3] = [1.0, 0.0, 0.0];
    const UP: [f64; 3] = [0.0, 1.0, 0.0];

    /// Two particles, of which the second falls, with room for the impulses of three forces.
    fn pair(forces: Vec<Force>, constraint: Option<Constraint>) -> System<'static, 15> {
        let first = Particle { place: [0.3, 0.0, 0.0], ..Particle::free("A", 2.0, [1.0, 0.5, 0.0]) };
        let second = Particle { falls: [9.0, 0.0, 0.0], ..Particle::free("B", 3.0, [-0.5, 0.0, 0.0]) };
        System { forces, constraint, ..System::new(Frame::plane(false), vec![first, second]) }
    }

    fn wave() -> Force {
        Force::in_time(vec![(1, UP)], InTime::waves(5.0, 1.0, 2.0))
    }

    /// Forces by their kinds, alone and on a string over a pulley: the formula is what integration finds, and each kind says why
    /// there is one or what it lacks.
    #[test]
    fn the_formula_is_what_is_integrated() {
        let between = || vec![(0, AHEAD), (1, times_minus(AHEAD))];
        let both = || vec![(0, AHEAD), (1, AHEAD)];
        let string = || Some(Constraint::Length(vec![(0, AHEAD), (1, times_minus(AHEAD))]));
        let spring = || Force::spring(between(), 7.0, 0.2);
        let wall = || Force::spring(vec![(0, AHEAD)], 3.0, -0.1);
        let thick = |coefficients| Force::resistance(0, AHEAD, coefficients);
        let cases: Vec<(Vec<Force>, Option<Constraint>, Followed)> = vec![
            (vec![Force::steady(0, AHEAD)], None, Followed::Formula(POLYNOMIAL)),
            (vec![Force::steady(0, AHEAD)], string(), Followed::Formula(POLYNOMIAL)),
            (vec![wave(), Force::steady(0, UP)], string(), Followed::Formula(INTEGRALS)),
            (vec![spring(), wall(), Force::steady(1, UP)], None, Followed::Formula(SINES)),
            (vec![wall(), Force::spring(both(), 2.0, 0.0)], string(), Followed::Formula(SINES)),
            (vec![thick([4.0, 0.0]), Force::damper(between(), 2.0)], None, Followed::Formula(EXPONENTIALS)),
            (vec![thick([4.0, 0.0])], string(), Followed::Formula(EXPONENTIALS)),
            (vec![thick([0.0, 4.0]), Force::steady(0, AHEAD)], None, Followed::Formula(SQUARES)),
            (vec![thick([0.0, 4.0]), Force::resistance(0, UP, [0.0, 4.0])], string(), Followed::Formula(SQUARES)),
            (vec![thick([0.0, 4.0]), Force::resistance(1, AHEAD, [0.0, 4.0])], string(), Followed::Equations(COUPLED)),
            (vec![spring(), wave()], None, Followed::Equations(DRIVEN)),
            (vec![spring(), thick([4.0, 0.0])], None, Followed::Equations(MIXED)),
            (vec![thick([1.0, 4.0])], None, Followed::Equations(MIXED)),
        ];
        let fine = Integrator { tolerance: 1e-12, longest: 0.1 };
        for (index, (forces, constraint, expected)) in cases.into_iter().enumerate() {
            let mut system = pair(forces, constraint);
            if system.constraint.is_some() {
                system.particles[1].velocity = AHEAD;
            }
            let (start, begun) = (system.state(), 0.25);
            let course = system.course(begun, &start);
            assert_eq!(course.followed(), expected, "case {index}");
            let Some(formula) = course.known() else { continue };
            for now in [begun, 0.3, 1.0, 1.75] {
                let truth = fine.until(begun, start, now, &|time, state| system.slope(time, state)).unwrap();
                let state = (formula.at)(now);
                let off = state.iter().zip(&truth).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max);
                assert!(off < 1e-9, "case {index} at {now}: {state:?}, not {truth:?}");
            }
        }
    }

    /// A particle at rest on a circle that hangs, and one that runs round without weight.
    #[test]
    fn only_a_steady_circle_has_a_formula() {
        let on_circle = |falls, velocity| {
            let bead = Particle { place: [2.0, 0.0, 0.0], falls, ..Particle::free("A", 1.0, velocity) };
            let circle = Some(Constraint::Surface(Surface::circle([0.0; 3])));
            System::<6> { constraint: circle, ..System::new(Frame::plane(true), vec![bead]) }
        };
        let runs = on_circle([0.0; 3], [0.0, 3.0, 0.0]);
        let state = (runs.course(1.0, &runs.state()).known().unwrap().at)(1.0 + core::f64::consts::PI / 3.0);
        assert!(state.iter().zip([0.0, 2.0, 0.0, -3.0, 0.0, 0.0]).all(|(one, other)| (one - other).abs() < 1e-14));
        let swings = on_circle([0.0, -9.0, 0.0], [0.0, 3.0, 0.0]);
        assert_eq!(swings.course(0.0, &swings.state()).followed(), Followed::Equations(CURVE));
    }

    fn times_minus(vector: [f64; 3]) -> [f64; 3] {
        vector.map(|part| -part)
    }
}
