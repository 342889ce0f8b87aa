//! Influences on bodies during a stage that lasts: they decide what stays the same all the way, and not only at both ends.

use momentous_expr::Expr;

/// Something that acts on a body from the first moment of a stage to the last.
#[derive(Clone, Debug)]
pub struct Influence {
    /// The stage, counted from 0.
    pub stage: usize,
    /// The short name of the body on which it acts.
    pub on: String,
    /// The bodies that give it, and feel the opposite; none where it comes from outside the scene.
    pub by: Vec<String>,
    /// Its name: `weight`, `the cord`.
    pub called: String,
    /// Its force along each axis of the scene.
    pub force: Vec<Effect>,
    /// Its effect on the kinetic energy.
    pub work: Work,
    /// Its effect on angular momentum.
    pub moment: Moment,
}

/// A part in a balance, at any moment of a stage.
#[derive(Clone, Debug)]
pub enum Effect {
    /// A term, perhaps in the time `t`; zero where there is none.
    Of(Expr),
    /// It is there, and nothing else in the scene makes up for it.
    Open,
}

/// The effect of an influence on the kinetic energy of bodies.
#[derive(Clone, Debug)]
pub enum Work {
    /// It acts at right angles to the motion.
    Nothing,
    /// The same, where it makes up for what the other forces, which are all known, would give the body there.
    Balances,
    /// Work where its force is not zero.
    OfForce,
    /// Work where this is not zero, and how that is said.
    Where(Effect, String),
    /// No work where all of these are zero, for then the body moves round a circle about the centre of the force.
    UnlessRound([Expr; 3]),
}

/// The effect of an influence on angular momentum.
#[derive(Clone, Debug)]
pub enum Moment {
    /// The moment of its force.
    OfForce,
    /// No moment about a fixed point of that name, through which its line always passes.
    Through(String),
    /// A moment about every point, in the order of the axes; one in a plane.
    About(Vec<Expr>),
}

impl Influence {
    /// An influence from outside with a force along every axis that does work and has a moment.
    pub(super) fn outside(stage: usize, on: &str, called: impl Into<String>) -> Self {
        let called = called.into();
        let work = Work::Where(Effect::Open, String::new());
        Self { stage, on: on.to_owned(), by: Vec::new(), called, force: Vec::new(), work, moment: Moment::OfForce }
    }

    /// The same from other bodies.
    pub(super) fn by(self, bodies: &[&str]) -> Self {
        Self { by: bodies.iter().map(|body| (*body).to_owned()).collect(), ..self }
    }

    /// The same with a force that is known, which does work.
    pub(super) fn force(self, along: Vec<Expr>) -> Self {
        Self { force: along.into_iter().map(Effect::Of).collect(), work: Work::OfForce, ..self }
    }

    /// The same at right angles to the motion.
    pub(super) fn workless(self) -> Self {
        Self { work: Work::Nothing, ..self }
    }

    /// The same where that does work as the words say, unless the term is zero.
    pub(super) fn works(self, unless: Effect, words: &str) -> Self {
        Self { work: Work::Where(unless, words.to_owned()), ..self }
    }

    /// The same along a line through a fixed point.
    pub(super) fn through(self, point: &str) -> Self {
        Self { moment: Moment::Through(point.to_owned()), ..self }
    }

    /// The same with a moment of its own.
    pub(super) fn moment(self, about: Vec<Expr>) -> Self {
        Self { moment: Moment::About(about), ..self }
    }

    /// The force along the axis of that position.
    #[must_use]
    pub fn along(&self, position: usize) -> &Effect {
        self.force.get(position).unwrap_or(&Effect::Open)
    }

    /// Whether the bodies of a system give it to one another.
    #[must_use]
    pub fn is_within(&self, system: &[String]) -> bool {
        !self.by.is_empty() && self.by.iter().all(|body| system.contains(body))
    }
}
