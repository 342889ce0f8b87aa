//! Bodies that come apart: momentum, the energy released, relative velocities.

use crate::Agent;
use crate::Builder;
use crate::Impulse;
use crate::Integral;
use crate::Name;
use crate::QuantityKind;
use crate::Reason;
use crate::frame::Direction;
use crate::stage::push::Acting;
use crate::weight_in_contact::Lasting;
use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::force;
use momentous_laws::kinematics;
use momentous_laws::momentum;
use momentous_laws::motion;
use momentous_laws::separation;
use momentous_quantity::Dimension;
use momentous_scene::Axis;
use momentous_scene::Plane;
use momentous_scene::Strength;
use momentous_scene::stage::Relative;
use momentous_scene::stage::Separate;
use momentous_scene::stage::When;
use momentous_solve::Relation;

/// Where a relative velocity stands in a separation.
pub(crate) fn place_of_relative(stage: &Separate, position: usize, path: &Path) -> Path {
    let path = path.key("relative");
    if stage.lists_relatives() { path.index(position) } else { path }
}

impl Builder<'_> {
    pub(crate) fn separate(&mut self, index: usize, stage: &Separate, path: &Path) {
        let parts: Vec<&str> = stage.into.iter().map(String::as_str).collect();
        let before: Vec<&str> = stage.from.as_deref().map_or_else(|| parts.clone(), |whole| vec![whole]);
        match &stage.from {
            Some(whole) => self.mass_of_parts(index, whole, &parts),
            None => self.together(index, &parts),
        }
        self.impulses_of_parts(index, stage, &before, &parts, path);
        let because = "the impulses that the parts exert on each other cancel";
        self.momentum_of_all(index, because, [&before, &parts]);
        if let Some(term) = &stage.energy {
            let meaning = "the energy that becomes kinetic energy";
            let released = self.read_positive(term, Dimension::ENERGY, meaning, &path.key("energy"));
            let [start, end] = [(&before, index + 1), (&parts, index + 2)].map(|(bodies, instant)| {
                bodies.iter().map(|body| self.kinetic_term(body, instant)).collect::<Vec<_>>()
            });
            let because = "the energy released becomes kinetic energy of the parts";
            self.law(&separation::ENERGY, Some(index), because, separation::energy(&released, &start, &end));
            self.in_order_along_the_axis(index, &parts);
        }
        if let Some(strength) = &stage.force {
            self.driven_apart(index, stage, strength, path);
        }
        for (position, relative) in stage.relatives().iter().enumerate() {
            self.relative_velocity(index, relative, &before, &place_of_relative(stage, position, path));
        }
        let lasting = Lasting { index, duration: stage.duration.as_ref(), include: None, path };
        let weighed: Vec<(&str, &str)> =
            parts.iter().map(|part| (stage.from.as_deref().unwrap_or(part), *part)).collect();
        self.weigh_contact(&lasting, &weighed, false);
        let phrase = self.stage_phrase(index);
        if self.scene.plane == Plane::Vertical {
            self.neglect(
                format!("weight during {phrase}"),
                "it is not impulsive: its impulse in so short a time is negligible",
            );
        } else if self.weight_acts_across() {
            self.not_needed(
                "weight and any support of the bodies",
                "they have no component along the motion, and nothing impulsive presses on a support",
            );
        }
        self.not_needed("the forces between the parts", "their impulses cancel in pairs, however long they act");
    }

    /// Adds up the masses of the parts, where the whole has a mass of its own.
    fn mass_of_parts(&mut self, index: usize, whole: &str, parts: &[&str]) {
        let (mass, sum) = (self.mass(whole), parts.iter().map(|part| self.mass(part)).collect::<Vec<_>>());
        let sum = Expr::sum(sum);
        if mass != sum {
            let because = format!("{} separates into them", self.called(whole));
            self.law(&separation::MASS, Some(index), because, (sum, mass));
        }
    }

    /// Gives bodies which part one velocity before.
    fn together(&mut self, index: usize, parts: &[&str]) {
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        for (axis, pair) in axes.iter().flat_map(|axis| parts.windows(2).map(move |pair| (axis, pair))) {
            let [first, second] = [0, 1].map(|side| self.velocity(pair[side], index + 1, *axis));
            let [one, other] = [0, 1].map(|side| self.called(pair[side]));
            let because = format!("{one} and {other} move together at first");
            self.law(&separation::TOGETHER, Some(index), because, (second, first));
        }
    }

    /// The impulse of the force between two parts along the axis.
    fn driven_apart(&mut self, index: usize, stage: &Separate, strength: &Strength, path: &Path) {
        let ([_, ahead], 1) = (&stage.into[..], self.axes.len()) else {
            let fault = Fault::new(Code::Value, "a force drives two parts apart, along one axis");
            let help = "give the energy or the relative velocity instead, or use one axis and two parts";
            self.faults.push(fault.help(help).at_path(path.key("force")));
            return;
        };
        let name = "the force between the parts";
        let strength = self.strength(strength, Dimension::FORCE, name, &path.key("force"));
        let end = self.stage_duration(index, stage.duration.as_ref(), path);
        self.told_throughout(name, &strength, &end);
        let clock = self.running_time();
        let force =
            Acting { name: name.to_owned(), strength, direction: Direction::axis(0, false), points: Vec::new() };
        let impulse = self.impulse_of(index, &force, clock, [&Expr::zero(), &end]);
        let impulse_ahead = self.in_stage(QuantityKind::Impulse, ahead, index);
        let meaning = format!("the impulse on {}", self.called(ahead));
        let symbol = Expr::from(self.symbol(impulse_ahead, meaning));
        let because = format!("{name} drives {} forwards throughout", self.called(ahead));
        self.law(&force::IMPULSE, Some(index), because, (symbol, impulse));
        self.lasting[index] = Some(end.clone());
        self.move_meanwhile(index, stage, &force.strength, &end);
    }

    /// How far the parts come along the axis while a force of that strength drives them apart.
    fn move_meanwhile(&mut self, index: usize, stage: &Separate, strength: &Expr, end: &Expr) {
        let ([behind, _], Some(axis)) = (&stage.into[..], self.only_axis()) else { return };
        let clock = self.running_time();
        let Some(gained) = strength.definite(clock, &Expr::zero(), &clock.into()) else { return };
        for part in &stage.into {
            let whole = stage.from.as_deref().unwrap_or(part);
            let [from, to] = [(whole, index + 1), (part, index + 2)].map(|(body, at)| self.place(body, at, axis));
            let (name, before) = (self.called(part), self.velocity(whole, index + 1, axis));
            if !strength.contains(clock) {
                let after = self.velocity(part, index + 2, axis);
                let because = format!("the force on {name} does not change, so the velocity changes evenly");
                let sides = kinematics::mean_velocity([&from, &to], [&before, &after], end);
                self.law(&kinematics::MEAN_VELOCITY, Some(index), because, sides);
                continue;
            }
            let change = gained.clone().simplify() / self.mass(part);
            let velocity = if part == behind { before - change } else { before + change };
            let Some(gone) = velocity.definite(clock, &Expr::zero(), end) else { continue };
            let because = format!("the impulse up to each time gives the velocity of {name} at that time");
            let integral = Integral { integrand: velocity, variable: clock, low: Expr::zero(), high: end.clone() };
            self.integral(&motion::DISPLACEMENT, index, because, (to - from, gone.simplify()), integral);
        }
    }

    /// Named from back to front, parts that are driven apart do not pass through each other.
    fn in_order_along_the_axis(&mut self, index: usize, parts: &[&str]) {
        let [(axis, _)] = self.axes[..] else { return };
        for pair in parts.windows(2) {
            let [behind, ahead] = [0, 1].map(|side| self.velocity(pair[side], index + 2, axis));
            let [name, other] = [0, 1].map(|side| self.called(pair[side]));
            let reason = Reason::PassesThrough(name, other);
            self.require(ahead, Relation::AtLeast, behind, reason);
        }
    }

    /// `v_A - v_B = u` along every axis.
    fn relative_velocity(&mut self, index: usize, relative: &Relative, before: &[&str], path: &Path) {
        let (of, to) = (relative.of.as_str(), relative.to.as_str());
        let [name, other] = [of, to].map(|body| self.called(body));
        let meaning = format!("the velocity of {name} relative to {other}");
        let size = self.read(&relative.velocity, Dimension::VELOCITY, &meaning, &path.key("velocity"));
        let direction = match &relative.direction {
            Some(term) => self.direction(term, &path.key("direction")),
            None => self.first_axis(),
        };
        // Before, the other part moves with the whole.
        let (seen_from, instant, when) = match relative.when {
            When::After => (to, index + 2, "after"),
            When::Before if before.contains(&to) => (to, index + 1, "before"),
            When::Before => (before[0], index + 1, "before"),
        };
        let phrase = self.stage_phrase(index);
        let because = format!("the velocity of {name} is taken relative to that of {other} {when} {phrase}");
        let parts = self.components(&direction);
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        for (axis, part) in axes.iter().zip(parts) {
            let velocity = self.velocity(of, index + 2, *axis);
            let other = self.velocity(seen_from, instant, *axis);
            let value = if part.is_zero() { part } else { size.clone() * part };
            self.law(
                &separation::RELATIVE,
                Some(index),
                because.clone(),
                separation::relative(&velocity, &other, &value),
            );
        }
    }

    /// The impulse on each part, for whoever asks for it, and for the diagram.
    fn impulses_of_parts(&mut self, index: usize, stage: &Separate, before: &[&str], parts: &[&str], path: &Path) {
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        let mut all: Vec<Vec<Expr>> = Vec::new();
        for part in parts {
            let name = self.called(part);
            let whole = if before.contains(part) { part } else { before[0] };
            let (mass, held) = (self.mass(part), self.guided(part).is_some());
            let mut components = Vec::new();
            for axis in &axes {
                let along = self.along(*axis);
                let meaning = format!("the impulse on {name} in {}{along}", self.stage_phrase(index));
                let impulse = Name::of(QuantityKind::Impulse, part).along(self.letter(*axis));
                let impulse = impulse.during(self.stage_label(index));
                let impulse = Expr::from(self.symbol(impulse, meaning));
                let [start, end] =
                    [(whole, index + 1), (part, index + 2)].map(|(body, at)| self.velocity(body, at, *axis));
                // On a part that is guided, its guide acts, too.
                if !held {
                    let because = format!("the impulse on {name} is the change of momentum{along}");
                    let sides = momentum::impulse_momentum(&mass, &start, std::slice::from_ref(&impulse), &end);
                    self.law(&momentum::IMPULSE_MOMENTUM, Some(index), because, sides);
                }
                if axes.len() == 1 {
                    self.mean_force(index, part, &impulse, stage.duration.as_ref(), path);
                }
                components.push(impulse);
            }
            if axes.len() > 1 {
                self.resultant(index, part, &components, &format!("the impulse on {name}"));
            }
            all.push(components);
        }
        if let [on_first, on_second] = &all[..] {
            for (first, second) in on_first.iter().zip(on_second) {
                let sides = (second.clone(), -first.clone());
                self.law(&momentum::THIRD_LAW, Some(index), "they are action and reaction", sides);
            }
        }
        for (position, components) in all.into_iter().enumerate() {
            let other = parts[(position + 1) % parts.len()];
            let called = match parts.len() {
                2 => self.called(other),
                _ => "the other parts".into(),
            };
            self.impulses.push(Impulse {
                stage: index,
                on: parts[position].to_owned(),
                by: Agent::Body(other.to_owned()),
                called,
                components,
                impulsive: true,
            });
        }
    }
}
