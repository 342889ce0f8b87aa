//! A body that rises or sinks on another one which gives way: momentum along the level axis, and the energy of both.

use crate::Builder;
use crate::Effect;
use crate::Influence;
use crate::Reason;
use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::energy;
use momentous_laws::kinematics;
use momentous_laws::momentum;
use momentous_laws::separation;
use momentous_quantity::Dimension;
use momentous_scene::Stage;
use momentous_scene::Term;
use momentous_scene::stage::Halt;
use momentous_scene::stage::Place;
use momentous_scene::stage::Slide;
use momentous_scene::stage::Swing;
use momentous_scene::stage::UpOrDown;
use momentous_solve::Relation;

use super::swing::End;

/// Two bodies of which one rises or sinks on the other; at both ends it moves neither up nor down.
struct Carried<'a> {
    index: usize,
    /// The body that rises or sinks, and what carries it.
    bodies: [&'a str; 2],
    names: [String; 2],
    rises: bool,
    /// Their velocities, at the start and at the end.
    velocities: [[Expr; 2]; 2],
    /// At which of the two both move together.
    together: [bool; 2],
    /// Whether the body moves along the axis (1) or against it (-1), relative to what carries it.
    sense: i64,
}

impl Carried<'_> {
    /// How fast the body moves on what carries it, at the start (0) or at the end (1).
    fn relative(&self, side: usize) -> Expr {
        let [carried, carrier] = self.velocities[side].clone();
        carried - carrier
    }
}

impl<'s> Builder<'s> {
    /// A slide up or down a smooth body of any shape.
    pub(super) fn slide_on(&mut self, index: usize, stage: &Slide, path: &Path) {
        let told = [
            ("friction", stage.friction.is_some()),
            ("distance", stage.distance.is_some()),
            ("duration", stage.duration.is_some()),
            ("incline", stage.incline.is_some()),
        ];
        for (key, _) in told.into_iter().filter(|(_, told)| *told) {
            let fault =
                Fault::new(Code::Value, format!("`{key}` cannot be used beside `on`, where only a height counts"));
            let help = "remove it; a body that rubs on a level one takes part in an `interact` with `friction`";
            self.faults.push(fault.help(help).at_path(path.key(key)));
        }
        let rises = stage.way == Some(UpOrDown::Up);
        let ends_together = self.may_end_together(stage.until, rises, path);
        let Some(height) = &stage.height else {
            let fault = Fault::new(Code::MissingKey, "a slide on a body that gives way needs a height");
            self.faults.push(fault.help("write `height: h`, with `way: up` or `way: down`").at_path(path.clone()));
            return;
        };
        let together = [false, ends_together];
        let Some(both) = self.carried(index, rises, together, stage.direction.as_ref(), path) else { return };
        let [name, other] = &both.names;
        let meaning = format!("the height between the two ends of {}", self.stage_phrase(index));
        let height = self.read_positive(height, Dimension::LENGTH, &meaning, &path.key("height"));
        self.conserved_by_both(&both, height, [other, name], &Reason::SlidesOtherWay(name.clone(), other.clone()));
        self.neglect(format!("friction between {name} and {other}"), "they are smooth");
    }

    /// A swing on a cord whose end gives way, or inside a circular track that does.
    pub(super) fn swing_on(&mut self, index: usize, stage: &Swing, length: Option<&Expr>, path: &Path) {
        let places = stage.places();
        let rises = matches!(places[0], Place::Lowest);
        let ends_together = self.may_end_together(stage.until, rises, path);
        if matches!(places, [Place::Angle(_), Place::Angle(_)]) {
            let message = "where the other end gives way, a swing starts or ends at its lowest point";
            self.faults.push(Fault::new(Code::Value, message).help("remove `from` or `to`").at_path(path.key("to")));
        } else if stage.to.is_some() && !ends_together {
            let message = "at an angle on its way, the body also moves upwards, which no axis of the scene tells";
            let help = "write `until: together` if that is its highest point";
            self.faults.push(Fault::new(Code::MissingKey, message).help(help).at_path(path.key("to")));
        }
        let Some(both) = self.carried(index, rises, [!rises, rises], stage.direction.as_ref(), path) else { return };
        let [name, other] = &both.names;
        let ends = [0, 1].map(|side| {
            let (is_lowest, angle) = self.swing_angle(index, side, stage, path);
            let velocity = if is_lowest { both.relative(side) } else { Expr::zero() };
            End { angle, velocity: vec![velocity], is_lowest }
        });
        let height = self.swing_height(index, stage, length, &ends, path);
        let on_track = stage.radius.is_some();
        if let Some(length) = length {
            let (comes, phrase) = (self.does(&stage.body, ["comes", "come"]), self.stage_phrase(index));
            let slack = Reason::CordSlack(comes, phrase.clone());
            let reason = if on_track { Reason::LeavesTrack(name.clone(), phrase) } else { slack };
            self.require(height.clone(), Relation::AtMost, length.clone(), reason);
            for (side, end) in ends.iter().enumerate().filter(|(_, end)| end.is_lowest) {
                self.tension(index, side, stage, length, end);
            }
        }
        if on_track {
            self.conserved_by_both(&both, height, [other, name], &Reason::MovesBack(name.clone()));
            self.neglect(format!("friction between {name} and {other}"), "they are smooth");
        } else {
            self.conserved_by_both(&both, height, ["the cord"; 2], &Reason::SwingsBack(name.clone()));
            self.neglect("the mass of the cord", "it is light");
        }
    }

    /// Both move together only where one carries the other.
    pub(super) fn nothing_carries(&mut self, until: Option<Halt>, path: &Path) {
        if until == Some(Halt::Together) {
            let fault = Fault::new(Code::MissingKey, "`together` is for a body on another one that gives way");
            self.faults.push(fault.help("write `on: B` as well, or `until: rest`").at_path(path.key("until")));
        }
    }

    /// Whether both move together at the end, which is a highest point; neither of them is at rest there.
    fn may_end_together(&mut self, until: Option<Halt>, rises: bool, path: &Path) -> bool {
        let told = match until {
            Some(Halt::Rest) => {
                Some(("at its highest point the body moves on with what carries it", "write `until: together`"))
            }
            Some(Halt::Together) if !rises => {
                Some(("a body that comes down does not end together with what carries it", "remove `until`"))
            }
            Some(Halt::Together) | None => None,
        };
        if let Some((message, help)) = told {
            self.faults.push(Fault::new(Code::Value, message).help(help).at_path(path.key("until")));
        }
        until.is_some()
    }

    fn carried(
        &mut self,
        index: usize,
        rises: bool,
        together: [bool; 2],
        direction: Option<&Term>,
        path: &Path,
    ) -> Option<Carried<'s>> {
        let stages: &'s [Stage] = &self.scene.stages;
        let bodies = stages.get(index)?.carried()?;
        let [body, on] = bodies;
        if body == on {
            let fault = Fault::new(Code::Value, format!("`{body}` cannot carry itself"));
            self.faults.push(fault.help("name another body").at_path(path.key("on")));
            return None;
        }
        let &[(axis, _)] = &self.axes[..] else { return self.not_on_one_axis(path) };
        if self.downwards(0).is_some() {
            return self.not_on_one_axis(path);
        }
        let before = index.checked_sub(1).and_then(|index| stages.get(index));
        let after_together = before.is_some_and(|stage| stage.carried() == Some(bodies) && stage.ends_together());
        // What has risen comes back, or goes on over the top: nothing else says so.
        if after_together && !rises && direction.is_none() {
            let fault = Fault::new(Code::MissingKey, "the stage does not say on which side the body comes down");
            let help = "write `direction` with the words of the axis, for the motion relative to what carries it";
            self.faults.push(fault.help(help).at_path(path.clone()));
        }
        let sense = self.sense(direction, path);
        let velocities = [1, 2].map(|side| bodies.map(|body| self.velocity(body, index + side, axis)));
        let names = bodies.map(|body| self.called(body));
        let together = [together[0] || after_together, together[1]];
        Some(Carried { index, bodies, names, rises, velocities, together, sense })
    }

    fn not_on_one_axis<T>(&mut self, path: &Path) -> Option<T> {
        let fault = Fault::new(Code::Value, "a body on one that gives way needs a scene with one level axis");
        let help = "write `axes: { x: to the right }`; with two axes, `slide_off` is a slide down";
        self.faults.push(fault.help(help).at_path(path.key("on")));
        None
    }

    /// The momentum and the energy of both, and what acts on them.
    fn conserved_by_both(&mut self, both: &Carried<'_>, height: Expr, acting: [&str; 2], reason: &Reason) {
        let Carried { index, bodies, names: [name, other], velocities, .. } = both;
        let masses = bodies.map(|body| self.mass(body));
        let carrying = velocities.each_ref().map(|both| [0, 1].map(|body| (masses[body].clone(), both[body].clone())));
        let because = format!(
            "{name} and {other} act on each other, and nothing else that acts on them has a component along the axis"
        );
        let sides = momentum::conservation(&carrying[0], &carrying[1]);
        self.law(&momentum::CONSERVATION, Some(*index), because, sides);
        let work = Expr::product([masses[0].clone(), self.gravity(), height]);
        let [start, end] = carrying.map(|pairs| {
            let kinetic = |(mass, velocity): &(Expr, Expr)| energy::kinetic(mass, std::slice::from_ref(velocity));
            pairs.iter().map(kinetic).collect::<Vec<_>>()
        });
        let sides = if both.rises {
            let (end, start) = separation::energy(&work, &end, &start);
            (start, end)
        } else {
            separation::energy(&work, &start, &end)
        };
        let because = format!("only the weight of {name} does work on the two of them together");
        self.law(&separation::CARRIED, Some(*index), because, sides);
        for (side, together) in both.together.into_iter().enumerate() {
            let [carried, carrier] = velocities[side].clone();
            if together {
                let because = format!("at the highest point, {name} does not move relative to {other}");
                self.law(&kinematics::TOGETHER, Some(*index), because, (carrier, carried));
            } else {
                let relation = if side == 0 && both.rises { Relation::Greater } else { Relation::AtLeast };
                self.require(Expr::integer(both.sense) * both.relative(side), relation, Expr::zero(), reason.clone());
            }
        }
        let weight = Influence::outside(*index, bodies[0], "weight").force(vec![Expr::zero()]);
        self.acts(weight.works(Effect::Open, "weight does work as the height changes"));
        let support = Influence::outside(*index, bodies[1], "the support").force(vec![Expr::zero()]);
        self.acts(support.workless());
        self.act_on_each_other(*index, *bodies, acting);
        self.neglect(format!("resistance to the motion of {other}"), "the problem gives none");
        self.not_needed(
            format!("the force between {name} and {other}"),
            "its impulses cancel within the system, and so does its work",
        );
    }
}
