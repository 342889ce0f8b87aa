//! How a body moves while known forces act on it: where it is at the end, its acceleration and net force at both ends.

use crate::Builder;
use crate::Integral;
use crate::Name;
use crate::QuantityKind;
use crate::Reason;
use momentous_expr::Expr;
use momentous_laws::motion;
use momentous_scene::Axis;
use momentous_scene::stage::Push;

use super::push::Pushed;

impl Builder<'_> {
    /// Place, acceleration and net force along one axis, along which these forces act.
    pub(crate) fn motion_along(&mut self, pushed: &Pushed<'_>, axis: Axis, forces: &[Expr]) {
        let net = Expr::sum(forces.iter().cloned()).simplify();
        let at = |time: &Expr| net.substitute(&|symbol| (symbol == pushed.clock).then(|| time.clone()));
        self.rates_along(pushed, axis, [at(&pushed.start), at(&pushed.end)]);
        let (index, body) = (pushed.index, pushed.body);
        let mass = self.mass(body);
        let [from, to] = [index + 1, index + 2].map(|instant| self.place(body, instant, axis));
        let [before, after] = [index + 1, index + 2].map(|instant| self.velocity(body, instant, axis));
        if !net.contains(pushed.clock) {
            let after = if pushed.stops { Expr::zero() } else { after };
            let time = pushed.end.clone() - pushed.start.clone();
            if self.only_axis().is_some() {
                let since = Expr::from(pushed.clock) - pushed.start.clone();
                self.notes_displacement(pushed, &(before.clone() + net / mass * since));
            }
            return self.moves_evenly((index, body), axis, [&before, &after], &time);
        }
        let Some(gained) = net.definite(pushed.clock, &pushed.start, &pushed.clock.into()) else { return };
        let velocity = before + gained.simplify() / mass;
        if self.only_axis().is_some() {
            self.notes_displacement(pushed, &velocity);
            if pushed.stops {
                self.stays_so(index, velocity.clone().powi(2), Reason::TurnsBack(self.called(body)));
            }
        }
        let Some((because, gone, integral)) = self.displaced_by(pushed, velocity, &pushed.start) else { return };
        self.integral(&motion::DISPLACEMENT, index, because, (to - from, gone), integral);
    }

    /// The displacement of a body from a time of a push to its end, by its velocity at each time; why, and the integral that it is.
    pub(super) fn displaced_by(
        &self,
        pushed: &Pushed<'_>,
        velocity: Expr,
        since: &Expr,
    ) -> Option<(String, Expr, Integral)> {
        let gone = velocity.definite(pushed.clock, since, &pushed.end)?.simplify();
        let name = self.called(pushed.body);
        let because = format!("the impulse up to each time gives the velocity of {name} at that time");
        let (low, high) = (since.clone(), pushed.end.clone());
        Some((because, gone, Integral { integrand: velocity, variable: pushed.clock, low, high }))
    }

    /// The number zero for a value that the author wrote as `0 s`, so that nothing is carried along that is not there.
    pub(crate) fn zero_if_so_written(&self, value: Expr) -> Expr {
        let zero =
            self.literals.iter().any(|(literal, written)| Expr::from(*literal) == value && written.value.is_zero());
        if zero { Expr::zero() } else { value }
    }

    /// A body that nothing holds back moves at both ends in the `direction` that its push tells; over a distance it does so anyway.
    pub(super) fn goes_as_told(&mut self, pushed: &Pushed<'_>, stage: &Push) {
        let (Some(axis), Some(_), None) = (self.only_axis(), &stage.direction, &pushed.over) else { return };
        let [before, after] = [pushed.index + 1, pushed.index + 2]
            .map(|instant| Expr::integer(pushed.sign) * self.velocity(pushed.body, instant, axis));
        let after = if pushed.stops { Expr::zero() } else { after };
        self.moves_along(pushed.index, pushed.body, [&before, &after], None);
    }

    /// Acceleration and net force at both ends, where all forces add up to these.
    pub(super) fn rates_along(&mut self, pushed: &Pushed<'_>, axis: Axis, [start, end]: [Expr; 2]) {
        let (name, mass) = (self.called(pushed.body), self.mass(pushed.body));
        let along = self.along(axis);
        let first = usize::from(self.scene.follows_a_force(pushed.index, pushed.body));
        let ends = [(pushed.index + 1, start), (pushed.index + 2, end)];
        for (instant, there) in ends.into_iter().skip(first) {
            let [force, acceleration] = self.net_force_and_acceleration(pushed.body, instant, axis);
            let because = format!("these are all the forces on {name}{along}");
            self.law(&motion::ALL_FORCES, Some(pushed.index), because, (force.clone(), there));
            self.net_force_accelerates(pushed, &mass, [&force, &acceleration]);
        }
    }

    /// Newton's second law for the net force on a body of a mass and its acceleration at one instant.
    pub(super) fn net_force_accelerates(
        &mut self,
        pushed: &Pushed<'_>,
        mass: &Expr,
        [force, acceleration]: [&Expr; 2],
    ) {
        let because = format!("the net force on {} accelerates it", self.called(pushed.body));
        let sides = motion::net_force(mass, acceleration, force);
        self.law(&motion::NET_FORCE, Some(pushed.index), because, sides);
    }

    /// The net force on a body along an axis at an instant, and its acceleration there.
    pub(super) fn net_force_and_acceleration(&mut self, body: &str, instant: usize, axis: Axis) -> [Expr; 2] {
        let (name, along, when) = (self.called(body), self.along(axis), self.when(instant));
        let meanings = [
            (QuantityKind::Force, format!("the net force on {name}{along} {when}")),
            (QuantityKind::Acceleration, format!("the acceleration of {name}{along} {when}")),
        ];
        meanings.map(|(kind, meaning)| {
            let name = Name::of(kind, body).at(instant).along(self.letter(axis));
            Expr::from(self.symbol(name, meaning))
        })
    }
}
