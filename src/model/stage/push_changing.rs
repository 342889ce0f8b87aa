//! A body on a level line whose mass changes at a steady rate while forces act on it: sand that falls into a cart, or runs out of it.

use crate::Builder;
use crate::Effect;
use crate::Influence;
use crate::Integral;
use crate::QuantityKind;
use crate::Reason;
use crate::forces::Acts;
use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::kinematics;
use momentous_laws::motion;
use momentous_laws::variable_mass;
use momentous_quantity::Dimension;
use momentous_scene::Axis;
use momentous_scene::Force;
use momentous_scene::stage::MassChange;
use momentous_scene::stage::Push;
use momentous_solve::Relation;

use super::push::Pushed;
use super::thrust::FLOW;

/// A change of mass, read.
struct Changing<'a> {
    pushed: &'a Pushed<'a>,
    gains: bool,
    /// The matter that joins or leaves.
    what: &'a str,
    axis: Axis,
    name: String,
    masses: [Expr; 2],
    velocities: [Expr; 2],
    flow: Expr,
    /// The velocity with which it arrives.
    arrives: Expr,
    /// The forces along the axis.
    force: Expr,
    /// The impulse of each of them along the axis.
    impulses: Vec<Expr>,
    lasts: Expr,
}

impl Changing<'_> {
    /// The mass at a time of the stage.
    fn mass_at(&self, time: &Expr) -> Expr {
        let changed = self.flow.clone() * (time.clone() - self.pushed.start.clone());
        self.masses[0].clone() + if self.gains { changed } else { -changed }
    }

    /// An integral over the time of the stage.
    fn over_time(&self, integrand: Expr) -> Integral {
        let Pushed { clock, start, end, .. } = self.pushed;
        Integral { integrand, variable: *clock, low: start.clone(), high: end.clone() }
    }
}

/// The mass that has joined or left in all, and the laws that name it and the mass at the end.
struct Changed {
    whole: Expr,
    laws: Vec<usize>,
}

impl Builder<'_> {
    /// A push of a body that gains or loses mass all the time.
    pub(super) fn push_changing(&mut self, pushed: &Pushed<'_>, change: &MassChange<'_>, stage: &Push, path: &Path) {
        self.check_changing(pushed, change, stage, path);
        let Some((axis, _)) = self.axes.first().cloned() else { return };
        let (index, body, at) = (pushed.index, pushed.body, path.key(change.key()));
        let name = self.called(body);
        let masses = [index + 1, index + 2].map(|instant| self.mass_at(body, instant));
        let [start, end] = [index + 1, index + 2].map(|instant| self.velocity(body, instant, axis));
        let velocities = [start, if pushed.stops { Expr::zero() } else { end }];
        let (gains, what) = (change.gains, change.name);
        let meaning =
            format!("the mass of {what} that {} {name} per unit time", if gains { "joins" } else { "leaves" });
        let flow = match change.flow {
            Some(term) => self.read_positive(term, FLOW, &meaning, &at.key("flow")),
            None => self.positive(self.in_stage(QuantityKind::MassFlow, body, index), meaning).into(),
        };
        let arrives = change.velocity.map_or_else(Expr::zero, |term| {
            let meaning = format!("the velocity with which {what} arrives");
            let velocity = self.read(term, Dimension::VELOCITY, &meaning, &at.key("velocity"));
            self.zero_if_so_written(velocity)
        });
        let (mut forces, mut impulses) = (Vec::new(), Vec::new());
        for force in &pushed.acting {
            let part = self.components(&force.direction).into_iter().next().unwrap_or_else(Expr::zero);
            forces.push(force.strength.clone() * part.clone());
            impulses.push(self.impulse_of(index, force, pushed.clock, [&pushed.start, &pushed.end]) * part);
        }
        let force = Expr::sum(forces).simplify();
        let lasts = (pushed.end.clone() - pushed.start.clone()).simplify();
        let changing =
            Changing { pushed, gains, what, axis, name, masses, velocities, flow, arrives, force, impulses, lasts };
        let changed = self.change_of_mass(&changing, change, &at);
        if gains {
            self.velocity_of_gaining(&changing, &changed.whole);
        } else {
            self.velocity_of_losing(&changing, &changed.laws);
        }
        self.way_of_changing(&changing, &changed.laws);
        self.rates_of_changing(&changing);
        self.note_changing(&changing);
    }

    /// The mass at the end, by the flow and by what joins or leaves in all.
    fn change_of_mass(&mut self, changing: &Changing<'_>, change: &MassChange<'_>, at: &Path) -> Changed {
        let (index, [before, after]) = (Some(changing.pushed.index), changing.masses.each_ref());
        let (joins, flows) = if changing.gains { ("joins", "arrives") } else { ("leaves", "leaves") };
        let steady = changing.flow.clone() * changing.lasts.clone();
        let because = format!("{} {flows} at a steady rate", changing.what);
        let whole = match change.mass {
            Some(term) => {
                let meaning = format!("the whole mass of {} that {joins} {}", changing.what, changing.name);
                self.read_positive(term, Dimension::MASS, &meaning, &at.key("mass"))
            }
            None => steady.clone(),
        };
        let first = self.instances.len();
        let changed = if changing.gains { whole.clone() } else { -whole.clone() };
        let so_much =
            if change.mass.is_some() { format!("this mass {joins} {}", changing.name) } else { because.clone() };
        self.law(&variable_mass::USED, index, so_much, variable_mass::changed([before, after], &changed));
        if change.mass.is_some() {
            self.law(&variable_mass::USED, index, because, (whole.clone(), steady));
        }
        let laws = (first..self.instances.len()).collect();
        if !changing.gains {
            let reason = Reason::RunsOutOfMass(changing.name.clone(), changing.what.to_owned());
            self.require(before.clone(), Relation::Greater, whole.clone(), reason);
        }
        Changed { whole, laws }
    }

    fn velocity_of_gaining(&mut self, changing: &Changing<'_>, arrived: &Expr) {
        let Changing { pushed, what, name, .. } = changing;
        let given = changing.impulses.iter().cloned().chain([arrived.clone() * changing.arrives.clone()]);
        let given = given.filter(|impulse| !impulse.is_zero());
        let brings = if changing.arrives.is_zero() {
            format!(
                "{what} falls straight down, brings no momentum along the motion, and takes on the velocity of {name}"
            )
        } else {
            format!("{what} brings its momentum, and takes on the velocity of {name}")
        };
        let nothing = if pushed.acting.is_empty() { "; no force acts along the motion" } else { "" };
        let [masses, velocities] = [&changing.masses, &changing.velocities].map(<[Expr; 2]>::each_ref);
        let sides = variable_mass::gaining(masses, velocities, given);
        self.law(&variable_mass::GAINING, Some(pushed.index), format!("{brings}{nothing}"), sides);
    }

    fn velocity_of_losing(&mut self, changing: &Changing<'_>, ends: &[usize]) {
        let (what, name) = (changing.what, &changing.name);
        let keeps = format!("{what} leaves with the velocity of {name} and pushes on nothing");
        let [start, end] = changing.velocities.each_ref();
        if changing.force.is_zero() {
            let because = format!("{keeps}, and no force acts along the motion");
            let sides = (end.clone(), start.clone());
            return self.law(&variable_mass::LOSING, Some(changing.pushed.index), because, sides);
        }
        let because = format!("{keeps}, and at each time the force accelerates what is left");
        let sides = variable_mass::losing(&changing.force, &changing.flow, changing.masses.each_ref(), [start, end]);
        let integral = changing.over_time(changing.force.clone() / changing.mass_at(&changing.pushed.clock.into()));
        self.integral_between(&variable_mass::LOSING, (changing.pushed.index, ends), because, sides, integral);
    }

    /// The place of the body at the end, as far as there is a formula.
    fn way_of_changing(&mut self, changing: &Changing<'_>, ends: &[usize]) {
        let Changing { pushed, force, flow, arrives, lasts, .. } = changing;
        let (index, clock) = (pushed.index, pushed.clock);
        if force.contains(clock) {
            return;
        }
        let [from, to] = [index + 1, index + 2].map(|instant| self.place(pushed.body, instant, changing.axis));
        let [[before, after], [start, end]] = [&changing.masses, &changing.velocities].map(<[Expr; 2]>::each_ref);
        let because =
            format!("the same holds up to each earlier time, which gives the velocity of {} then", changing.name);
        let then = changing.mass_at(&clock.into());
        let (velocity, value) = if changing.gains {
            let drive = (force.clone() + flow.clone() * arrives.clone()).simplify();
            let time = Expr::from(clock) - pushed.start.clone();
            let velocity = variable_mass::velocity_gaining(&drive, [before, &then], start, &time);
            (velocity, variable_mass::way_gaining(&drive, flow, [before, after], start, lasts))
        } else if force.is_zero() {
            let because = format!("the velocity of {} stays the same", changing.name);
            let sides = kinematics::mean_velocity([&from, &to], [start, end], lasts);
            return self.law(&kinematics::MEAN_VELOCITY, Some(index), because, sides);
        } else {
            let even = force.clone() / flow.clone();
            let velocity = start.clone() + variable_mass::gained(&even, [before, &then]);
            (velocity, start.clone() * lasts.clone() + variable_mass::way(&even, [before, after], lasts))
        };
        let integral = changing.over_time(velocity);
        self.integral_between(&motion::DISPLACEMENT, (index, ends), because, (to - from, value), integral);
    }

    /// Acceleration and net force at both ends.
    fn rates_of_changing(&mut self, changing: &Changing<'_>) {
        let Changing { pushed, what, name, .. } = changing;
        let first = usize::from(self.scene.follows_a_force(pushed.index, pushed.body));
        let ends = [&pushed.start, &pushed.end].into_iter().zip(&changing.masses).zip(&changing.velocities);
        for (side, ((time, mass), velocity)) in ends.enumerate().skip(first) {
            let [force, acceleration] =
                self.net_force_and_acceleration(pushed.body, pushed.index + 1 + side, changing.axis);
            let there = changing.force.substitute(&|symbol| (symbol == pushed.clock).then(|| time.clone()));
            let because = format!("these are all the forces on {name} with its load along the motion");
            self.law(&motion::ALL_FORCES, Some(pushed.index), because, (force.clone(), there));
            let (because, given) = if changing.gains {
                let slower = if changing.arrives.is_zero() {
                    -(changing.flow.clone() * velocity.clone())
                } else {
                    changing.flow.clone() * (changing.arrives.clone() - velocity.clone())
                };
                (format!("{what} has to be brought to the velocity of {name}"), slower)
            } else {
                (format!("{what} leaves with the velocity of {name} and pushes on nothing"), Expr::zero())
            };
            let sides = (mass.clone() * acceleration, force + given);
            self.law(&variable_mass::CHANGING, Some(pushed.index), because, sides);
        }
    }

    /// Notes the influences of the stage, and its omissions.
    fn note_changing(&mut self, changing: &Changing<'_>) {
        let Changing { pushed, what, name, .. } = changing;
        let acts = Acts { stage: pushed.index, on: pushed.body, during: [&pushed.start, &pushed.end] };
        for (force, impulse) in pushed.acting.iter().zip(&changing.impulses) {
            self.note_pull(acts, &force.name, &force.strength, &force.direction);
            self.note_impulse(pushed.index, pushed.body, force.name.as_str(), vec![impulse.clone()]);
        }
        if changing.gains {
            let relative = changing.arrives.clone() - changing.velocities[0].clone();
            let brings = Influence::outside(pushed.index, pushed.body, *what)
                .force(vec![changing.flow.clone() * changing.arrives.clone()]);
            let dragged = format!("{what} is brought to the velocity of {name}, which changes kinetic energy");
            self.acts(brings.works(Effect::Of(relative), &dragged));
        }
        self.leave_out_what_acts_across();
        self.neglect("friction", "the problem gives none");
    }

    /// Refuses quantities that have no formula while the mass changes.
    fn check_changing(&mut self, pushed: &Pushed<'_>, change: &MassChange<'_>, stage: &Push, path: &Path) {
        let key = change.key();
        let letter = self.axes.first().map_or("", |(axis, _)| axis.letter());
        let changes = pushed.acting.iter().any(|force| force.strength.contains(pushed.clock));
        let rubs = stage.forces.iter().any(|force| matches!(force, Force::Friction(_)));
        let level = self.axes.len() == 1 && self.downwards(0).is_none() && stage.incline.is_none();
        let members = self.scene.members(pushed.body).len() > 1 || !self.scene.division_of(pushed.body).is_empty();
        let unmoved = pushed.stops && pushed.acting.is_empty() && change.velocity.is_none();
        let faults = [
            (
                stage.gains.is_some() && stage.loses.is_some(),
                "a body cannot gain and lose mass in the same stage",
                "leave one of `gains` and `loses`",
                key,
            ),
            (
                !level,
                "a body whose mass changes moves along one level axis",
                "leave one axis, along which no weight acts, and no `incline`",
                key,
            ),
            (
                members,
                "the mass of a body that consists of others, or comes apart, cannot change",
                "let the mass of one of the bodies change, in a stage before they join",
                key,
            ),
            (
                stage.resistance.is_some(),
                "a `resistance` cannot act on a body whose mass changes",
                "leave one of the two, or divide the motion into stages",
                "resistance",
            ),
            (
                rubs,
                "`friction` cannot act on a body whose mass changes",
                "write a resistance that stays the same as one of the forces",
                "forces",
            ),
            (
                stage.over.is_some(),
                "`over` cannot be used while the mass changes",
                "say how long the stage lasts, `during: dt`, or give the position at its end",
                "over",
            ),
            (
                stage.depends_on_place(letter),
                "a force on a body whose mass changes must not depend on its position",
                "write forces that stay the same",
                "forces",
            ),
            (
                !change.gains && changes,
                "a force on a body that loses mass must not change with time: there is no formula for its motion in general",
                "write forces that stay the same, in several stages where they change in steps",
                "forces",
            ),
            (
                unmoved,
                "a body does not come to rest where no force acts along its motion",
                "remove `until: rest`",
                "until",
            ),
        ];
        for (_, message, help, key) in faults.into_iter().filter(|(is_so, ..)| *is_so) {
            self.faults.push(Fault::new(Code::Value, message).help(help).at_path(path.key(key)));
        }
    }
}
