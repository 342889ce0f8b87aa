//! Forces of known law over a time: their impulses, weight, and friction with its normal force.

use crate::Agent;
use crate::Because;
use crate::Builder;
use crate::Impulse;
use crate::Integral;
use crate::Name;
use crate::Opposing;
use crate::QuantityKind;
use crate::Reason;
use crate::Shown;
use crate::forces::Acts;
use crate::frame::Direction;
use crate::incline::Incline;
use crate::strength::through;
use crate::wording;
use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::energy;
use momentous_laws::force;
use momentous_laws::momentum;
use momentous_quantity::Dimension;
use momentous_scene::Axis;
use momentous_scene::Force;
use momentous_scene::Plane;
use momentous_scene::Pull;
use momentous_scene::Strength;
use momentous_scene::stage::During;
use momentous_scene::stage::Push;
use momentous_scene::stage::ToldBy;
use momentous_scene::stage::Until;
use momentous_solve::Relation;

use super::shapes;
use super::works;

/// A force of a push, read.
pub(crate) struct Acting {
    pub name: String,
    pub strength: Expr,
    pub direction: Direction,
    /// The points of its graph, where it is told by one.
    pub points: Vec<[Expr; 2]>,
}

/// The terms that are the same all through a push.
pub(crate) struct Pushed<'a> {
    pub index: usize,
    pub body: &'a str,
    pub acting: Vec<Acting>,
    pub clock: Symbol,
    pub start: Expr,
    pub end: Expr,
    pub incline: Incline,
    pub over: Option<Expr>,
    pub stops: bool,
    /// Whether the body moves along its axis (1) or against it (-1).
    pub sign: i64,
}

impl Builder<'_> {
    pub(crate) fn push(&mut self, index: usize, stage: &Push, path: &Path) {
        let clock = self.running_time();
        let (start, end) = match &stage.during {
            Some(during) => self.duration(index, during, &path.key("during")),
            None => (Expr::zero(), self.stage_duration(index, None, path)),
        };
        self.lasting[index] = Some((end.clone() - start.clone()).simplify());
        for body in stage.pushed() {
            self.push_body(index, stage, body, (clock, &start, &end), path);
        }
        self.acts_as_noted(index);
        if stage.is_of_several() {
            self.rates_of_system(index, stage);
        }
    }

    fn push_body(
        &mut self,
        index: usize,
        stage: &Push,
        body: &str,
        (clock, start, end): (Symbol, &Expr, &Expr),
        path: &Path,
    ) {
        let place = self.varying_place(stage);
        let mut acting = Vec::new();
        let mut friction = None;
        for (position, entry) in stage.forces_on(body) {
            let at = path.key("forces").index(position);
            match entry {
                Force::Pull(pull) => acting.extend(self.pull(pull, &at)),
                Force::Friction(entry) => friction = Some((&entry.friction, at.key("friction"))),
            }
        }
        for force in &acting {
            self.told_throughout(&force.name, &force.strength, end);
            if let Some([first, _]) = force.points.first() {
                self.in_order(first, start, Reason::PrecedesForce(force.name.clone()));
            }
        }
        if stage.told == Some(ToldBy::Graph) {
            self.print_graph(index, &acting, end, &path.key("told"));
        }
        let incline = self.incline(index, stage.incline.as_ref(), path);
        let over = stage.over.as_ref().map(|term| {
            let meaning = format!("the distance over which {} is pushed", self.called(body));
            self.read_positive(term, Dimension::LENGTH, &meaning, &path.key("over"))
        });
        let stops = stage.until == Some(Until::Rest);
        if stops {
            self.comes_to_rest(index, body);
        }
        let sign = self.sense(stage.direction.as_ref(), path);
        let [start, end] = [start, end].map(Clone::clone);
        let pushed = Pushed { index, body, acting, clock, start, end, incline, over, stops, sign };
        if let Some(change) = stage.mass_change() {
            return self.push_changing(&pushed, &change, stage, path);
        }
        if let Some(place) = place {
            return self.push_by_place(&pushed, place, stage, friction, path);
        }
        if let Some(resistance) = &stage.resistance {
            return self.push_against_resistance(&pushed, resistance, stage, friction, path);
        }
        self.check_over(&pushed, path);
        match friction {
            Some((friction, at)) => self.push_against_friction(&pushed, friction, &at),
            None => self.push_freely(&pushed, stage),
        }
    }

    /// Work is force times distance only where the force stays the same, and along one axis.
    pub(super) fn check_over(&mut self, pushed: &Pushed<'_>, path: &Path) {
        let changes = pushed.acting.iter().any(|force| force.strength.contains(pushed.clock));
        if pushed.over.is_some() && (changes || self.axes.len() != 1) {
            let fault = Fault::new(Code::Value, "`over` needs forces that do not change with time, along one axis");
            self.faults.push(fault.help("say for how long they act: `during: dt`").at_path(path.key("over")));
        }
    }

    /// A push without friction: impulse and momentum along every axis, work and energy where a distance is used.
    fn push_freely(&mut self, pushed: &Pushed<'_>, stage: &Push) {
        let on_slope = stage.incline.is_some();
        self.goes_as_told(pushed, stage);
        let (index, body, [start, end]) = (pushed.index, pushed.body, [&pushed.start, &pushed.end]);
        let mass = self.mass(body);
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        let parts: Vec<Vec<Expr>> = pushed.acting.iter().map(|force| self.components(&force.direction)).collect();
        let impulses: Vec<Expr> =
            pushed.acting.iter().map(|force| self.impulse_of(index, force, pushed.clock, [start, end])).collect();
        match self.guided(body) {
            Some(guide) => self.push_along_guide(pushed, &guide, &impulses, &parts),
            None => self.push_along_axes(pushed, on_slope, &impulses, &parts),
        }
        if let ([axis], Some(distance)) = (&axes[..], &pushed.over) {
            let forces = pushed.acting.iter().zip(&parts).map(|(force, part)| force.strength.clone() * part[0].clone());
            let mut forces: Vec<Expr> = forces.collect();
            forces.push(self.weight_on_slope(body, &pushed.incline));
            let ends = [index + 1, index + 2].map(|instant| self.velocity(body, instant, *axis));
            self.push_over(pushed, forces, distance, ends, None);
        }
        let acts = Acts { stage: index, on: body, during: [start, end] };
        if on_slope {
            let weight = mass * self.gravity();
            let normal = weight.clone() * pushed.incline.press.clone();
            self.note_floor(acts, &pushed.incline, weight, normal, Expr::zero(), false);
            self.neglect("friction", "the slope is smooth");
        } else {
            self.note_weight(acts);
        }
        for ((force, impulse), part) in pushed.acting.iter().zip(&impulses).zip(&parts) {
            self.note_pull(acts, &force.name, &force.strength, &force.direction);
            self.impulses.push(Impulse {
                stage: index,
                on: body.to_owned(),
                by: Agent::Outside,
                called: force.name.clone(),
                components: times(impulse, part),
                impulsive: false,
            });
        }
        if self.scene.plane == Plane::Horizontal && !on_slope {
            self.leave_out_what_acts_across();
            let what = if self.axes.len() < 3 { "friction and other resistance" } else { "other resistance" };
            self.neglect(what, "the problem gives none");
        }
    }

    /// Impulse and momentum of a body that nothing guides, along every axis.
    fn push_along_axes(&mut self, pushed: &Pushed<'_>, on_slope: bool, impulses: &[Expr], parts: &[Vec<Expr>]) {
        let (index, body, [start, end]) = (pushed.index, pushed.body, [&pushed.start, &pushed.end]);
        let (mass, name) = (self.mass(body), self.called(body));
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        for (position, axis) in axes.iter().enumerate() {
            let mut along: Vec<Expr> =
                impulses.iter().zip(parts).map(|(impulse, part)| impulse.clone() * part[position].clone()).collect();
            if on_slope {
                along.push(self.weight_on_slope(body, &pushed.incline) * (end.clone() - start.clone()));
            } else {
                along.extend(self.weight_impulse(&mass, position, start, end));
            }
            let along: Vec<Expr> = along.into_iter().filter(|impulse| !impulse.is_zero()).collect();
            let [before, after] = [index + 1, index + 2].map(|instant| self.velocity(body, instant, *axis));
            let after = if pushed.stops { Expr::zero() } else { after };
            let still = || Because::Fact(format!("no impulse acts on {name} along {}", axis.letter()));
            let because = if along.is_empty() { still() } else { Because::Definition };
            let sides = momentum::impulse_momentum(&mass, &before, &along, &after);
            self.law(&momentum::IMPULSE_MOMENTUM, Some(index), because, sides);
            let weight = match (on_slope, self.downwards(position)) {
                (true, _) => Some(self.weight_on_slope(body, &pushed.incline)),
                (false, down) => down.map(|down| Expr::integer(down) * mass.clone() * self.gravity()),
            };
            let pulls = pushed.acting.iter().zip(parts);
            let pulls = pulls.map(|(force, part)| force.strength.clone() * part[position].clone());
            let forces: Vec<Expr> = pulls.chain(weight).collect();
            self.motion_along(pushed, *axis, &forces);
        }
    }

    /// The part of the weight along the axis.
    pub(crate) fn weight_on_slope(&mut self, body: &str, incline: &Incline) -> Expr {
        if incline.is_level() {
            return Expr::zero();
        }
        -(self.mass(body) * self.gravity() * incline.rise())
    }

    /// Work and energy over a distance of motion along the axis.
    pub(crate) fn push_over(
        &mut self,
        pushed: &Pushed<'_>,
        forces: Vec<Expr>,
        distance: &Expr,
        [before, after]: [Expr; 2],
        opposing: Option<Opposing>,
    ) {
        let name = self.called(pushed.body);
        let mass = self.mass(pushed.body);
        let works = forces.into_iter().map(|force| Expr::integer(pushed.sign) * force * distance.clone());
        let works: Vec<Expr> = works.filter(|work| !work.is_zero()).collect();
        let end = if pushed.stops { Expr::zero() } else { after };
        let [start, stop] = [&before, &end].map(|speed| energy::kinetic(&mass, std::slice::from_ref(speed)));
        let names = pushed.acting.iter().map(|force| force.name.as_str());
        let because = works::only(names, [!pushed.incline.is_level(), opposing.is_some()], &name);
        self.law(&energy::WORK_ENERGY, Some(pushed.index), because, energy::work_energy(start, works, stop));
        let time = pushed.end.clone() - pushed.start.clone();
        let [before, end] = [before, end].map(|velocity| (Expr::integer(pushed.sign) * velocity).simplify());
        self.comes_evenly(pushed.index, &name, distance, [&before, &end], &time);
        self.moves_along(pushed.index, pushed.body, [&before, &end], opposing);
    }
    /// The impulse of weight along the axis of that position, in a vertical plane.
    pub(crate) fn weight_impulse(&mut self, mass: &Expr, position: usize, start: &Expr, end: &Expr) -> Option<Expr> {
        let down = self.downwards(position)?;
        let gravity = self.gravity();
        Some(Expr::product([Expr::integer(down), mass.clone(), gravity, end.clone() - start.clone()]))
    }

    /// Whether the axis of that position points down (1) or up (-1), where weight acts in the plane of the scene.
    pub(crate) fn downwards(&self, position: usize) -> Option<i64> {
        if self.scene.plane == Plane::Horizontal {
            return None;
        }
        self.axes.get(position)?.1.rise().map(|rise| -rise)
    }

    /// Whether weight has a component along some axis.
    pub(crate) fn weight_has_a_component(&self) -> bool {
        (0..self.axes.len()).any(|position| self.downwards(position).is_some())
    }

    /// Start and end of a stage's own clock.
    pub(crate) fn duration(&mut self, index: usize, during: &During, path: &Path) -> (Expr, Expr) {
        let phrase = self.stage_phrase(index);
        match during {
            During::For(term) => {
                let meaning = format!("the duration of {phrase}");
                (Expr::zero(), self.read_positive(term, Dimension::TIME, &meaning, path))
            }
            During::Between([from, to]) => {
                let start =
                    self.read(from, Dimension::TIME, &format!("the time at which {phrase} starts"), &path.index(0));
                let end = self.read_positive(
                    to,
                    Dimension::TIME,
                    &format!("the time at which {phrase} ends"),
                    &path.index(1),
                );
                let start = self.zero_if_so_written(start);
                self.in_order(&start, &end, Reason::EndsEarly(phrase));
                (start, end)
            }
        }
    }

    /// Two times of which the second must not lie before the first.
    pub(crate) fn in_order(&mut self, earlier: &Expr, later: &Expr, reason: Reason) {
        if earlier.is_zero() {
            return;
        }
        self.require(later.clone(), Relation::AtLeast, earlier.clone(), reason);
    }

    /// A force whose law ends at some time is not known after it, so the stage must not last longer.
    pub(crate) fn told_throughout(&mut self, name: &str, strength: &Expr, end: &Expr) {
        let Expr::Piecewise(pieces) = strength else { return };
        if let Some((Some(last), _)) = pieces.pieces.last() {
            self.in_order(end, last, Reason::OutlastsForce(name.to_owned()));
        }
    }

    /// A force, or as many as it has components.
    fn pull(&mut self, pull: &Pull, path: &Path) -> Vec<Acting> {
        let unnamed = || match &pull.on {
            Some(body) => format!("the force on {}", self.called(body)),
            None => "the force".to_owned(),
        };
        let name = pull.name.clone().unwrap_or_else(unnamed);
        let at = path.key("value");
        if let Strength::Components(components) = &pull.value {
            if pull.direction.is_some() {
                let fault = Fault::new(Code::Value, format!("{name} has components, which already give its direction"));
                self.faults.push(fault.help("remove `direction`").at_path(path.key("direction")));
            }
            let parts = self.strengths(components, Dimension::FORCE, &name, &at).into_iter().enumerate();
            let parts = parts.filter(|(_, strength)| !strength.is_zero()).map(|(position, strength)| {
                let letter = self.axes.get(position).map_or("", |(axis, _)| axis.letter());
                let direction = Direction::axis(self.axis_place(position), false);
                Acting { name: format!("{name} along {letter}"), strength, direction, points: Vec::new() }
            });
            return parts.collect();
        }
        let meaning = wording::force_of(&name);
        let (strength, points) = match &pull.value {
            Strength::Graph(graph) => {
                let points = self.points(graph, Dimension::FORCE, &meaning, &at);
                (through(&points, self.running_time().into()), points)
            }
            other @ (Strength::Term(_) | Strength::Pieces(_) | Strength::Components(_)) => {
                (self.strength(other, Dimension::FORCE, &meaning, &at), Vec::new())
            }
        };
        let direction = match &pull.direction {
            Some(term) => self.direction(term, &path.key("direction")),
            None => self.first_axis(),
        };
        vec![Acting { name, strength, direction, points }]
    }

    /// The impulse of a force over the stage: force times time, or a symbol with its integral.
    pub(crate) fn impulse_of(&mut self, index: usize, force: &Acting, clock: Symbol, [start, end]: [&Expr; 2]) -> Expr {
        if !force.strength.contains(clock) {
            return force.strength.clone() * (end.clone() - start.clone());
        }
        let of_force = Name::of(QuantityKind::TimeIntegral, "F");
        let is_alike = |name: &&Name| name.kind == of_force.kind && name.subject == of_force.subject;
        let count = self.names.iter().filter(is_alike).count();
        let name = if count == 0 { of_force } else { of_force.at(count + 1) };
        let meaning = format!("the impulse of {}", force.name);
        let symbol = self.symbol(name.during(self.stage_label(index)), meaning);
        let Some(value) = force.strength.definite(clock, start, end) else {
            let fault =
                Fault::new(Code::Stuck, format!("{} cannot be integrated over time", wording::force_of(&force.name)));
            let help = "use polynomials, sines, exponentials, pieces or points of a graph; powers of long sums are expanded only up to a limit";
            let path = Path::root().key("scene").key("stages").index(index);
            self.faults.push(fault.help(help).at_path(path));
            return symbol.into();
        };
        let integral =
            Integral { integrand: force.strength.clone(), variable: clock, low: start.clone(), high: end.clone() };
        let areas = shapes::under(&force.strength, clock, [start, end]);
        let because = match &areas {
            Some(shapes) => format!(
                "the impulse is the area under the graph of {}, {}",
                wording::force_of(&force.name),
                shapes::in_words(shapes)
            ),
            None => format!("{} changes with time", wording::force_of(&force.name)),
        };
        self.integral(&force::IMPULSE, index, because, (symbol.into(), value.simplify()), integral);
        if let Some(shapes) = areas {
            self.shows(Shown::Areas(shapes.into_iter().map(|(_, area)| area).collect()));
        }
        symbol.into()
    }
}

/// A vector as its strength times the components of its direction.
pub(super) fn times(strength: &Expr, direction: &[Expr]) -> Vec<Expr> {
    direction.iter().map(|part| strength.clone() * part.clone()).collect()
}
