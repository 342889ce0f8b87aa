//! Bodies that a guide lets move along one direction only, and the momentum of what they belong to.

use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::momentum;
use momentous_laws::separation;
use momentous_scene::Axis;
use momentous_scene::Stage;

use super::Agent;
use super::Builder;
use super::Effect;
use super::Impulse;
use super::Influence;
use super::QuantityKind;
use super::Work;
use super::frame::Direction;

/// The guide of a body, read.
#[derive(Clone, Debug)]
pub(super) struct Guided {
    /// The body.
    pub body: String,
    /// The guide, as it is called in a sentence.
    pub by: String,
    /// The direction in which the body can move.
    pub along: Direction,
}

impl Guided {
    /// Whether another guide runs along the same line, one way or the other.
    fn is_parallel_to(&self, other: &Self) -> bool {
        self.along.turn == other.along.turn && self.along.quarters % 2 == other.along.quarters % 2
    }

    /// The direction at right angles to the guide, counter-clockwise.
    fn across(&self) -> Direction {
        Direction::turned(self.along.quarters + 1, self.along.turn.clone())
    }
}

/// The bodies of a stage with mass and velocities, before or after.
pub(super) type Carriers = Vec<(Expr, Vec<Expr>)>;

impl Builder<'_> {
    /// The guide of a body, or of one of the bodies of which it consists.
    pub(super) fn guided(&mut self, body: &str) -> Option<Guided> {
        if self.axes.len() != 2 {
            return None;
        }
        let scene = self.scene;
        let members: Vec<String> = scene.members(body).into_iter().map(str::to_owned).collect();
        let (member, guide) =
            members.iter().find_map(|member| Some((member, scene.bodies.get(member)?.guide.as_ref()?)))?;
        let path = Path::root().key("scene").key("bodies").key(member.as_str()).key("guide").key("along");
        let along = self.direction(&guide.along, &path);
        let by = guide.by.clone().unwrap_or_else(|| "the ground".into());
        Some(Guided { body: body.to_owned(), by, along })
    }

    /// A guide holds its body before, between and behind the stages, too, and where no stage names the body.
    pub(super) fn hold_the_guided(&mut self) {
        for instant in 1..=self.timeline.last() {
            let alive: Vec<String> = self.timeline.alive(instant).into_iter().map(str::to_owned).collect();
            for body in alive {
                if let Some(guide) = self.guided(&body) {
                    self.hold(&guide, instant, None);
                }
            }
        }
    }

    /// Requires that a guided body does not move at right angles to its guide; `stage` is the one that brought it to that
    /// instant.
    pub(super) fn hold(&mut self, guide: &Guided, instant: usize, stage: Option<usize>) {
        let since = self.timeline.naming_instant(&guide.body, instant);
        if !self.defined.insert(format!("guided {}{since}", guide.body)) {
            return;
        }
        let across = self.components(&guide.across());
        let velocity = self.velocities(&guide.body, instant);
        let because = format!("held by {}, {} can move along one line only", guide.by, self.called(&guide.body));
        self.law(&separation::GUIDE, stage, because, (dot(&velocity, &across), Expr::zero()));
    }

    /// Impulse and momentum of one guided body: along its guide, by the impulses that act on it; across the guide, by what the
    /// guide adds to them, so that it does not move that way. `acting` holds the components of each impulse.
    pub(super) fn momentum_along_guide(&mut self, guide: &Guided, stage: usize, acting: &[Vec<Expr>], because: &str) {
        let (name, mass) = (self.called(&guide.body), self.mass_at(&guide.body, stage + 1));
        self.hold(guide, stage + 1, None);
        self.hold(guide, stage + 2, Some(stage));
        let [before, after] = [stage + 1, stage + 2].map(|instant| self.velocities(&guide.body, instant));
        let [along, across] = [guide.along.clone(), guide.across()].map(|direction| self.components(&direction));
        let felt = |direction: &[Expr]| -> Vec<Expr> {
            let parts = acting.iter().map(|impulse| dot(impulse, direction).simplify());
            parts.filter(|part| !part.is_zero()).collect()
        };
        let impulses = felt(&along);
        let line = if impulses.is_empty() {
            format!("no impulse acts on {name} along {}", guide.by)
        } else {
            format!("{because}, and {} exerts no impulse along the line on which {name} can move", guide.by)
        };
        let sides = momentum::impulse_momentum(&mass, &dot(&before, &along), &impulses, &dot(&after, &along));
        self.law(&momentum::IMPULSE_MOMENTUM, Some(stage), line, sides);
        let reaction = self.guide_impulse(guide, stage, &across);
        let line = format!("across it, {} balances the other impulses on {name}", guide.by);
        let balanced: Vec<Expr> = felt(&across).into_iter().chain([reaction]).collect();
        let sides = momentum::impulse_momentum(&mass, &Expr::zero(), &balanced, &Expr::zero());
        self.law(&momentum::IMPULSE_MOMENTUM, Some(stage), line, sides);
    }

    /// Two guides that cross take up momentum along every line.
    fn guides_cross(&mut self, stage: usize, guides: [&Guided; 2]) {
        let [one, other] = guides.map(|guided| self.called(&guided.body));
        let message =
            format!("the guides of {one} and {other} cross, so that their momentum is conserved along no line");
        let help = "give an impact its `line_of_impact` and `restitution`, along which each body is looked at alone";
        let key = self.scene.stages.get(stage).map_or("", Stage::key);
        let path = Path::root().key("scene").key("stages").index(stage).key(key);
        self.faults.push(Fault::new(Code::Value, message).help(help).at_path(path));
    }

    /// The impulse that a guide gives its body at right angles to its line, as a quantity and among the impulses of the stage.
    fn guide_impulse(&mut self, guide: &Guided, stage: usize, across: &[Expr]) -> Expr {
        let name = self.called(&guide.body);
        let reaction = self.in_stage(QuantityKind::GuideImpulse, &guide.body, stage);
        let meaning = format!("the impulse of {} on {name}", guide.by);
        let reaction = Expr::from(self.symbol(reaction, meaning));
        let components =
            across.iter().map(|part| if part.is_zero() { part.clone() } else { reaction.clone() * part.clone() });
        let lasts = self.scene.stages.get(stage).is_some_and(Stage::takes_time);
        self.impulses.push(Impulse {
            stage,
            on: guide.body.clone(),
            by: Agent::Guide,
            called: guide.by.clone(),
            components: components.collect(),
            impulsive: true,
        });
        if lasts {
            let force = across.iter().map(|part| if part.is_zero() { Effect::Of(part.clone()) } else { Effect::Open });
            let holds = Influence::outside(stage, &guide.body, guide.by.as_str()).workless();
            self.acts(Influence { force: force.collect(), ..holds });
        }
        self.neglect(format!("friction with {}", guide.by), "the problem gives none");
        reaction
    }

    /// The force of a guide makes up for what the others, where all of them are known, would give its body across its line.
    pub(super) fn guides_balance(&mut self, stage: usize) {
        for place in 0..self.influences.len() {
            let influence = self.influences[place].clone();
            let Some(guide) =
                Some(&influence.on).filter(|_| influence.stage == stage).and_then(|body| self.guided(body))
            else {
                continue;
            };
            if influence.called != guide.by || !matches!(influence.work, Work::Nothing) {
                continue;
            }
            let across = self.components(&guide.across());
            let others = self.influences.iter().enumerate();
            let others = others.filter(|(at, other)| *at != place && other.stage == stage && other.on == influence.on);
            let known = |other: &Influence| -> Option<Vec<Expr>> {
                let term = |effect: &Effect| if let Effect::Of(term) = effect { Some(term.clone()) } else { None };
                (0..across.len()).map(|position| term(other.along(position))).collect()
            };
            let Some(others) = others.map(|(_, other)| known(other)).collect::<Option<Vec<_>>>() else { continue };
            let pressed = Expr::sum(others.iter().map(|force| dot(force, &across)));
            let force = across.iter().map(|part| Effect::Of((-(pressed.clone() * part.clone())).simplify()));
            self.influences[place] = Influence { force: force.collect(), work: Work::Balances, ..influence };
        }
    }

    /// Mass and velocities of bodies at an instant.
    pub(super) fn carrying(&mut self, bodies: &[&str], instant: usize) -> Carriers {
        bodies.iter().map(|body| (self.mass_at(body, instant), self.velocities(body, instant))).collect()
    }

    /// The momentum of the bodies of a stage before and after it: conserved along every axis; where one of them is guided,
    /// conserved along the guide, and changed across it by the impulse of the guide.
    pub(super) fn momentum_of_all(&mut self, stage: usize, because: &str, [before, after]: [&[&str]; 2]) {
        let [start, end] =
            [(before, stage + 1), (after, stage + 2)].map(|(bodies, instant)| self.carrying(bodies, instant));
        let guided: Vec<Guided> = after.iter().filter_map(|body| self.guided(body)).collect();
        let Some(guide) = guided.first().cloned() else {
            let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
            let is_told_alone = matches!(self.scene.stages.get(stage), Some(Stage::Interact(_)));
            let others =
                if is_told_alone { "the problem tells of no impulse from outside" } else { "no other impulse acts" };
            for (position, axis) in axes.iter().enumerate() {
                let along = self.along(*axis);
                let because = format!("{because}, and {others}{along}");
                let [from, to] = [&start, &end].map(|carriers| component(carriers, position));
                self.law(&momentum::CONSERVATION, Some(stage), because, momentum::conservation(&from, &to));
            }
            return;
        };
        if let Some(crossing) = guided.iter().find(|other| !other.is_parallel_to(&guide)) {
            return self.guides_cross(stage, [&guide, crossing]);
        }
        for held in &guided {
            self.hold(held, stage + 2, Some(stage));
        }
        for body in before {
            if let Some(held) = self.guided(body) {
                self.hold(&held, stage + 1, None);
            }
        }
        let [along, across] = [guide.along.clone(), guide.across()].map(|direction| self.components(&direction));
        let name = self.called(&guide.body);
        let line = format!("{because}, and no impulse of {} acts along the line on which {name} can move", guide.by);
        let [from, to] = [&start, &end].map(|carriers| projected(carriers, &along));
        self.law(&momentum::CONSERVATION, Some(stage), line, momentum::conservation(&from, &to));
        let reactions: Vec<Expr> = guided.iter().map(|guided| self.guide_impulse(guided, stage, &across)).collect();
        let line = match &guided[..] {
            [_] => {
                format!("across the line on which {name} can move, it receives an external impulse from {}", guide.by)
            }
            _ => "across their lines, the guides exert external impulses".to_owned(),
        };
        let [from, to] = [&start, &end].map(|carriers| projected(carriers, &across));
        self.law(&momentum::SYSTEM, Some(stage), line, momentum::system(&from, &Expr::sum(reactions), &to));
    }
}

/// The part of a vector along a direction.
pub(super) fn dot(vector: &[Expr], direction: &[Expr]) -> Expr {
    let parts = vector.iter().zip(direction).filter(|(_, part)| !part.is_zero());
    Expr::sum(parts.map(|(share, part)| if part.is_one() { share.clone() } else { share.clone() * part.clone() }))
}

fn component(carriers: &Carriers, position: usize) -> Vec<(Expr, Expr)> {
    let at = |(mass, velocity): &(Expr, Vec<Expr>)| Some((mass.clone(), velocity.get(position)?.clone()));
    carriers.iter().filter_map(at).collect()
}

pub(super) fn projected(carriers: &Carriers, direction: &[Expr]) -> Vec<(Expr, Expr)> {
    carriers.iter().map(|(mass, velocity)| (mass.clone(), dot(velocity, direction))).collect()
}
