//! The classes of scenes, from the least model to the largest, and why a scene belongs to its class.

use std::fmt;

use crate::budget::{Budget, Keep};
use crate::force::Force;
use crate::method::Method;
use crate::methods::{ClosedForm, EventDriven, MethodKind};
use crate::refusal::Refusal;
use crate::scene::Followed;
use crate::world::World;

/// The class of a scene: the methods that it needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Class {
    /// There is a formula for the whole run.
    ClosedForm,
    /// Bodies touch, and only the impact is asked for.
    LinearSolve,
    /// Formulas between impacts, which have to be found one after another.
    Piecewise,
    /// The motion between impacts has no formula.
    OdeNeeded,
    /// Newton's law alone does not say what happens.
    LawRequired,
}

impl Class {
    /// All of them.
    pub const ALL: [Self; 5] =
        [Self::ClosedForm, Self::LinearSolve, Self::Piecewise, Self::OdeNeeded, Self::LawRequired];

    /// Its name, as tables print it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::ClosedForm => "closed form",
            Self::LinearSolve => "linear solve",
            Self::Piecewise => "piecewise",
            Self::OdeNeeded => "ODE needed",
            Self::LawRequired => "law required",
        }
    }
}

/// The class of a scene, with the reason.
#[derive(Clone, Debug, PartialEq)]
pub struct Classified {
    /// The class.
    pub class: Class,
    /// Why, as a clause.
    pub reason: String,
    /// The methods that there are for it; any where none are listed.
    pub methods: &'static [MethodKind],
}

impl Classified {
    fn new(class: Class, reason: String) -> Self {
        Self { class, reason, methods: &[] }
    }

    /// A motion that no world of spheres and walls describes, by what it follows from.
    #[must_use]
    pub fn followed(followed: Followed) -> Self {
        match followed {
            Followed::Formula(why) => Self {
                methods: &[MethodKind::ClosedForm, MethodKind::RungeKutta],
                ..Self::new(Class::ClosedForm, why.to_owned())
            },
            Followed::Equations(what) => Self {
                methods: &[MethodKind::RungeKutta],
                ..Self::new(Class::OdeNeeded, format!("there is no formula here for {what}"))
            },
        }
    }
}

impl fmt::Display for Classified {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}: {}", self.class.name(), self.reason)
    }
}

/// The least class that treats a scene for as long as the budget says.
///
/// ```
/// use momentous_simulate::least::{Class, classify};
/// use momentous_simulate::{Budget, ON_A_LINE};
///
/// let drag = (ON_A_LINE[1].jittered)(0.0);
/// let found = classify(&drag.world, &drag.budget).unwrap();
/// assert_eq!(found.class, Class::OdeNeeded);
/// assert_eq!(found.reason, "no formula here gives the motion under quadratic drag");
/// ```
///
/// # Errors
/// The numbers make no scene.
pub fn classify<const D: usize>(world: &World<D>, budget: &Budget) -> Result<Classified, Refusal> {
    let (state, contacts) = world.prepare()?;
    let said = |class, reason: &str| Ok(Classified::new(class, reason.to_owned()));
    let touching = world.touching(&contacts, &state);
    if touching.iter().any(|struck| struck.rate < 0.0) {
        let struck = world.collide(&touching, &mut state.velocities.clone());
        if let Err(Refusal::LawRequired { contacts }) = struck {
            let reason = format!("simultaneous impact of {}", contacts.join(" and "));
            return Ok(Classified::new(Class::LawRequired, reason));
        }
        if budget.impacts <= touching.len() {
            return said(Class::LinearSolve, "bodies touch, and only their impact is asked for");
        }
    }
    // No event is needed to see whether the motion has a formula.
    let glance = budget.steps(0).keep(Keep::Count);
    let central = world.forces.iter().any(|force| matches!(force, Force::Central { .. }));
    match EventDriven.run(world, &glance) {
        Err(Refusal::NoExactMotion { force }) => {
            let reason = format!("no formula here gives the motion under {force}");
            return Ok(Classified::new(Class::OdeNeeded, reason));
        }
        Ok(_) if central => return said(Class::ClosedForm, "an orbit about one centre is a conic section"),
        _ => {}
    }
    match ClosedForm.run(world, &glance) {
        Ok(_) if contacts.is_empty() => {
            said(Class::ClosedForm, "nothing collides, and the motion is a polynomial in time")
        }
        Ok(_) => said(Class::ClosedForm, "the bounces of one body on a level floor are a geometric sequence"),
        Err(_) => said(Class::Piecewise, "between impacts, the motion is a polynomial in time"),
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;
    use crate::task::{IN_THE_PLANE, ON_A_LINE};
    use crate::world::Body;

    #[test]
    fn the_reference_tasks_have_their_classes() {
        let expected = [
            ("bounce", Class::ClosedForm),
            ("bounce with drag", Class::OdeNeeded),
            ("half-sine force", Class::OdeNeeded),
            ("head-on", Class::Piecewise),
            ("contact", Class::LinearSolve),
            ("chain", Class::Piecewise),
            ("ramp force", Class::ClosedForm),
            ("oblique", Class::Piecewise),
            ("Kepler", Class::ClosedForm),
        ];
        let line = ON_A_LINE.iter().map(|task| {
            let case = (task.jittered)(0.0);
            (task.name, classify(&case.world, &case.budget).unwrap().class)
        });
        let plane = IN_THE_PLANE.iter().map(|task| {
            let case = (task.jittered)(0.0);
            (task.name, classify(&case.world, &case.budget).unwrap().class)
        });
        assert_eq!(line.chain(plane).collect::<Vec<_>>(), expected);
    }

    #[test]
    fn balls_that_touch_in_a_row_need_a_law() {
        let mut world = World::<1>::new(1.0);
        for (name, place, velocity) in [("A", 0.0, 1.0), ("B", 1.0, 0.0), ("C", 2.0, 0.0)] {
            world.bodies.push(Body::sphere(name, 1.0, 0.5, [place], [velocity]));
        }
        let found = classify(&world, &Budget::until(1.0)).unwrap();
        assert_eq!(found.to_string(), "law required: simultaneous impact of A-B and B-C");
    }
}
