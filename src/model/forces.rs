//! The forces of a stage, noted one by one for diagrams and for what stays the same; the equations need only their sums.

use momentous_expr::Expr;

use super::Agent;
use super::Builder;
use super::Impulse;
use super::acting::ActingForce;
use super::acting::ForceKind;
use super::frame::Direction;
use super::incline::Incline;
use super::influence::Influence;

/// The place and the span in which the forces of one push act.
#[derive(Clone, Copy)]
pub(super) struct Acts<'a> {
    pub stage: usize,
    pub on: &'a str,
    pub during: [&'a Expr; 2],
}

impl Acts<'_> {
    pub(super) fn force(self, kind: ForceKind, called: &str, strength: Expr, direction: Direction) -> ActingForce {
        let (on, during) = (self.on.to_owned(), self.during.map(Clone::clone));
        ActingForce { stage: self.stage, on, kind, called: called.to_owned(), strength, direction, during }
    }
}

impl Builder<'_> {
    /// The components of a force when it begins to act, or at its end.
    pub(super) fn components_at(&self, force: &ActingForce, at_end: bool) -> Vec<Expr> {
        let clock = self.symbols.find("t");
        let time = &force.during[usize::from(at_end)];
        let strength = force.strength.substitute(&|symbol| (Some(symbol) == clock).then(|| time.clone()));
        let parts = self.components(&force.direction).into_iter();
        parts.map(|part| if part.is_zero() { part } else { strength.clone() * part }.simplify()).collect()
    }

    /// Notes a push or a pull.
    pub(super) fn note_pull(&mut self, acts: Acts<'_>, called: &str, strength: &Expr, direction: &Direction) {
        self.forces.push(acts.force(ForceKind::Pull, called, strength.clone(), direction.clone()));
    }

    /// Notes the weight of a body, where it acts in the plane of the scene.
    pub(super) fn note_weight(&mut self, acts: Acts<'_>) {
        let Some((position, down)) = (0..self.axes.len()).find_map(|place| Some((place, self.downwards(place)?)))
        else {
            return;
        };
        let strength = self.mass(acts.on) * self.gravity();
        let direction = Direction::axis(self.axis_place(position), down < 0);
        self.forces.push(acts.force(ForceKind::Weight, "weight", strength, direction));
    }

    /// Notes what a floor has to do with a body that slides on it along the axis, or `backwards`.
    pub(super) fn note_floor(
        &mut self,
        acts: Acts<'_>,
        incline: &Incline,
        weight: Expr,
        normal: Expr,
        kinetic: Expr,
        backwards: bool,
    ) {
        let friction = kinetic * normal.clone();
        self.forces.push(acts.force(ForceKind::Weight, "weight", weight, incline.downwards()));
        self.forces.push(acts.force(ForceKind::Normal, "the normal force", normal, Direction::axis(1, false)));
        if !friction.is_zero() {
            let against = Direction::axis(0, !backwards);
            self.forces.push(acts.force(ForceKind::Friction, "friction", friction, against));
        }
    }

    /// Notes an impulse from outside the scene on a body during a stage that lasts.
    pub(super) fn note_impulse(&mut self, stage: usize, on: &str, called: impl Into<String>, components: Vec<Expr>) {
        let (on, called) = (on.to_owned(), called.into());
        self.impulses.push(Impulse { stage, on, by: Agent::Outside, called, components, impulsive: false });
    }

    /// The same, where only the impulse of all forces together is of use.
    pub(super) fn note_impulse_of_all(&mut self, stage: usize, on: &str, components: Vec<Expr>) {
        self.note_impulse(stage, on, "all forces together", components);
    }

    /// Notes what acts during a stage that lasts.
    pub(super) fn acts(&mut self, influence: Influence) {
        self.influences.push(influence);
    }

    /// The forces that a push or a slide has noted, as influences.
    pub(super) fn acts_as_noted(&mut self, stage: usize) {
        let one_axis = self.axes.len() == 1;
        let here = || self.forces.iter().filter(|force| force.stage == stage);
        let on_floor = one_axis && here().any(|force| force.kind == ForceKind::Normal);
        let noted = |force: &ActingForce| {
            let parts = match force.kind {
                // What a floor has to do with a body is counted along it and away from it, whatever the axis is called.
                ForceKind::Weight | ForceKind::Normal | ForceKind::Friction if on_floor => {
                    let [along, _] = force.direction.cosine_and_sine();
                    vec![along]
                }
                _ => self.components(&force.direction),
            };
            let part = |part: Expr| if part.is_zero() { part } else { (force.strength.clone() * part).simplify() };
            let influence = Influence::outside(stage, &force.on, force.called.as_str());
            let influence = influence.force(parts.into_iter().map(part).collect());
            if force.kind == ForceKind::Normal { influence.workless() } else { influence }
        };
        let influences: Vec<Influence> = here().map(noted).collect();
        self.influences.extend(influences);
        self.guides_balance(stage);
    }
}
