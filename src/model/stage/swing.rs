//! A swing on a cord: conservation of energy, the height on the circle, the tension.

use crate::Builder;
use crate::Effect;
use crate::Influence;
use crate::Name;
use crate::Passage;
use crate::QuantityKind;
use crate::Reason;
use crate::VectorKind;
use crate::builder::LAW_COST;
use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::energy;
use momentous_laws::force;
use momentous_laws::geometry;
use momentous_quantity::Dimension;
use momentous_scene::Stage;
use momentous_scene::stage::Place;
use momentous_scene::stage::Swing;
use momentous_scene::stage::UpOrDown;
use momentous_solve::Relation;

/// The cost of an equation that puts two laws and the height on the circle together.
const COST_OF_BOTH: u32 = 3 * LAW_COST + 1;

/// One end of a swing: the angle of the cord there, zero at the lowest place, and the velocity; relative to what the cord is fixed to.
pub(super) struct End {
    pub angle: Expr,
    pub velocity: Vec<Expr>,
    pub is_lowest: bool,
}

/// How far below the fixed end of the cord an end of the swing is.
fn below(length: &Expr, end: &End) -> Expr {
    length.clone() * end.angle.clone().cos().simplify()
}

impl Builder<'_> {
    pub(crate) fn swing(&mut self, index: usize, stage: &Swing, path: &Path) {
        let body = stage.body.as_str();
        let name = self.called(body);
        if let (Some(_), Some(_)) = (&stage.length, &stage.radius) {
            let fault = Fault::new(Code::OverDetermined, "a cord and a track cannot both hold a body");
            let help = "remove `length`, that of a cord, or `radius`, that of a track";
            self.faults.push(fault.help(help).at_path(path.key("radius")));
        }
        let length = stage.arm().map(|term| {
            let (meaning, key) = match &stage.radius {
                Some(_) => ("the radius of the track".to_owned(), "radius"),
                None => (format!("the length of the cord of {name}"), "length"),
            };
            self.read_positive(term, Dimension::LENGTH, &meaning, &path.key(key))
        });
        if length.is_none() && (stage.from.is_some() || stage.to.is_some()) {
            let fault = Fault::new(Code::MissingKey, "an angle of a swing needs the length of the cord");
            self.faults.push(fault.help("write `length: L`").at_path(path.clone()));
        }
        if stage.on.is_some() {
            return self.swing_on(index, stage, length.as_ref(), path);
        }
        self.nothing_carries(stage.until, path);
        if stage.stops() {
            self.comes_to_rest(index, body);
        }
        let ends = [0, 1].map(|side| self.swing_end(index, side, stage, path));
        let height = self.swing_height(index, stage, length.as_ref(), &ends, path);
        // From one angle to another the height counts downwards, unless it is said to go up.
        let difference = match (&length, stage.goes_between_angles(), stage.way) {
            (Some(length), true, None) => below(length, &ends[1]) - below(length, &ends[0]),
            _ => height.clone(),
        };
        let raised = self.gravity() * difference;
        let [start, end] = ends.each_ref().map(|end| energy::specific_kinetic(&end.velocity));
        if !stage.stops() {
            // Only then does it come to the end of its way, asked how fast or not.
            let worked = if stage.goes_up() { -raised.clone() } else { raised.clone() };
            self.goes_the_whole_way(&name, start.clone(), [worked]);
        }
        let sides = if stage.goes_up() { (start, end + raised) } else { (start + raised, end) };
        let holds = stage.held_by();
        let force = if stage.radius.is_some() { "the push of the track" } else { "the pull of the cord" };
        let because = format!("{force} is at right angles to the motion of {name} and does no work; the mass cancels");
        self.law(&energy::CONSERVATION, Some(index), because, sides);
        if let Some(length) = &length {
            self.holds_at(index, stage, length, &ends[0]);
            self.stays_taut(index, stage, length, &height, &ends[1]);
            for (side, end) in ends.iter().enumerate() {
                self.tension(index, side, stage, length, end);
            }
            self.where_it_pulls_so(index, stage, length, &ends);
            self.passes_the_top(index, stage, length, &ends);
        }
        self.acts(Influence::outside(index, body, holds).workless());
        let words =
            format!("weight does work as the height changes, while {holds}, at right angles to the motion, does none");
        self.acts(Influence::outside(index, body, "weight").works(Effect::Open, &words));
        self.note_impulse(index, body, holds, Vec::new());
        if stage.radius.is_some() {
            self.neglect("friction", "the track is smooth");
        } else {
            self.neglect("the mass of the cord", "it is light");
        }
        self.neglect("air resistance", "the problem gives none");
    }

    /// Whether the body is at its lowest point at the start (0) or at the end (1), and the angle there.
    pub(super) fn swing_angle(&mut self, index: usize, side: usize, stage: &Swing, path: &Path) -> (bool, Expr) {
        let (body, instant) = (stage.body.as_str(), index + 1 + side);
        let name = self.called(body);
        match stage.places()[side] {
            Place::Lowest => (true, Expr::zero()),
            Place::Angle(term) => {
                let since = self.timeline.naming_instant(body, instant);
                let line = if stage.radius.is_some() { "radius to" } else { "cord of" };
                let meaning = format!("the angle that the {line} {name} makes with the vertical {}", self.when(since));
                let angle = match term {
                    Some(term) => {
                        let key = path.key(if side == 0 { "from" } else { "to" });
                        let angle = self.read_positive(term, Dimension::NONE, &meaning, &key);
                        self.needs_unit(&angle, &key);
                        angle
                    }
                    None => self
                        .positive(Name::of(QuantityKind::Direction(VectorKind::Velocity), body).at(since), meaning)
                        .into(),
                };
                (false, angle)
            }
        }
    }

    /// The angle and the velocity at the start (0) or at the end (1).
    fn swing_end(&mut self, index: usize, side: usize, stage: &Swing, path: &Path) -> End {
        let (body, instant) = (stage.body.as_str(), index + 1 + side);
        let (is_lowest, angle) = self.swing_angle(index, side, stage, path);
        let velocity = self.velocities(body, instant);
        let velocity = if side == 1 && stage.stops() { vec![Expr::zero(); velocity.len()] } else { velocity };
        if is_lowest {
            self.moves_level(index, stage, &velocity, path);
        } else if let (1, false, [along]) = (side, stage.stops(), &velocity[..]) {
            self.swings_on(stage, along, path);
        }
        End { angle, velocity, is_lowest }
    }

    /// At its lowest place the body moves horizontally, the way that the stage says.
    fn moves_level(&mut self, index: usize, stage: &Swing, velocity: &[Expr], path: &Path) {
        let name = self.called(&stage.body);
        let sign = self.sense(stage.direction.as_ref(), path);
        for (position, component) in velocity.iter().enumerate() {
            if self.downwards(position).is_some() {
                let because = format!(
                    "at the lowest point, {}",
                    self.does(&stage.body, ["moves horizontally", "move horizontally"])
                );
                self.law(&geometry::ARC, Some(index), because, (component.clone(), Expr::zero()));
            } else {
                let along = Expr::integer(sign) * component.clone();
                let reason = match stage.radius {
                    Some(_) => Reason::MovesBack(name.clone()),
                    None => Reason::SwingsBack(name.clone()),
                };
                self.require(along, Relation::AtLeast, Expr::zero(), reason);
            }
        }
    }

    /// A swing up that ends on its way goes on as it began: along one axis the velocity is counted along the path.
    fn swings_on(&mut self, stage: &Swing, velocity: &Expr, path: &Path) {
        if stage.from.is_none() {
            let along = Expr::integer(self.sense(stage.direction.as_ref(), path)) * velocity.clone();
            let name = self.called(&stage.body);
            let reason = match stage.radius {
                Some(_) => Reason::MovesBack(name),
                None => Reason::AlreadySwingsBack(name),
            };
            self.require(along, Relation::AtLeast, Expr::zero(), reason);
        }
    }

    /// The height between the ends, and how it follows from the angles.
    pub(super) fn swing_height(
        &mut self,
        index: usize,
        stage: &Swing,
        length: Option<&Expr>,
        ends: &[End; 2],
        path: &Path,
    ) -> Expr {
        let between = stage.goes_between_angles();
        let on_track = usize::from(stage.radius.is_some());
        let goes = self.does(&stage.body, [["swings", "swing"], ["slides", "slide"]][on_track]);
        let meaning = match (between, ends[0].is_lowest) {
            (true, _) => match stage.way {
                None => format!("the height between the two ends of {}", self.stage_phrase(index)),
                Some(UpOrDown::Up) => format!("the height by which {goes} up"),
                Some(UpOrDown::Down) => format!("the height by which {goes} down"),
            },
            (false, true) => format!("the height to which {goes} up"),
            (false, false) => format!("the height from which {goes} down"),
        };
        let name = self.in_stage(QuantityKind::Height, &stage.body, index);
        if let (true, Some(_), None) = (between, &stage.height, stage.way) {
            let message = "a `height` between two angles does not tell which of them is the higher";
            let help = "write `way: up` or `way: down` beside it";
            self.faults.push(Fault::new(Code::MissingKey, message).help(help).at_path(path.key("height")));
        }
        let height = match &stage.height {
            Some(term) => self.read(term, Dimension::LENGTH, &meaning, &path.key("height")),
            None => self.symbol(name, meaning).into(),
        };
        if let (false, Expr::Symbol(symbol)) = (between, &height) {
            self.system.positive.insert(*symbol);
        }
        if let Some(length) = length {
            // The lower end stands first; at the lowest place the whole cord hangs down.
            let [lower, upper] = if stage.goes_up() { [0, 1] } else { [1, 0] };
            let difference = below(length, &ends[lower]) - below(length, &ends[upper]);
            let sides = match (between, stage.way) {
                (true, None) => (height.clone(), Expr::apply(Function::Abs, difference)),
                (true, Some(way)) => {
                    let reason = Reason::EndsOnOtherSide(self.called(&stage.body), way);
                    self.require(height.clone(), Relation::AtLeast, Expr::zero(), reason);
                    (height.clone(), difference)
                }
                (false, _) => (height.clone(), difference),
            };
            let because = ["the cord is straight", "the track is a circle"][on_track];
            self.law(&geometry::HEIGHT_ON_CIRCLE, Some(index), because, sides);
        }
        height
    }

    /// The cord must pull to the end of the swing.
    fn stays_taut(&mut self, index: usize, stage: &Swing, length: &Expr, height: &Expr, end: &End) {
        if end.is_lowest {
            return;
        }
        let reason = self.lets_go(index, stage);
        if stage.stops() && stage.from.is_none() {
            self.require(height.clone(), Relation::AtMost, length.clone(), reason);
            return;
        }
        if let Some(pull) = self.told_pull(index, stage, end) {
            self.require(pull, Relation::AtLeast, Expr::zero(), reason);
            return;
        }
        self.holds_at(index, stage, length, end);
    }

    /// Away from the lowest place, the cord or the track holds the body only where it goes fast enough.
    fn holds_at(&mut self, index: usize, stage: &Swing, length: &Expr, end: &End) {
        if end.is_lowest {
            return;
        }
        // The pull of the cord, or the push of the track, for each unit of mass.
        let pull = Expr::integer(2) * energy::specific_kinetic(&end.velocity) / length.clone();
        let pull = pull + self.gravity() * end.angle.clone().cos();
        let reason = self.lets_go(index, stage);
        self.require(pull, Relation::AtLeast, Expr::zero(), reason);
    }

    /// On its way to an angle the body may pass the top, where it must be fast enough to be held, or on a rod to get there.
    fn passes_the_top(&mut self, index: usize, stage: &Swing, length: &Expr, ends: &[End; 2]) {
        if ends[1].is_lowest || stage.stops() {
            return;
        }
        let place = self.running_time();
        let there = Expr::from(place).cos();
        let fallen = Expr::integer(2)
            * self.gravity()
            * length.clone()
            * (there.clone() - ends[0].angle.clone().cos().simplify());
        let square = Expr::integer(2) * energy::specific_kinetic(&ends[0].velocity) + fallen;
        // A body that is just held at the top passes it.
        let spare = Expr::ratio(1, 1_000_000);
        let pull = square.clone() / length.clone() + self.gravity() * (there + spare);
        let whole = Reason::TurnsBack(self.called(&stage.body));
        let held = self.lets_go(index, stage);
        for (kinetic, reason) in [(pull, held), (square, whole)] {
            let ends = ends.each_ref().map(|end| end.angle.clone());
            self.passages.push(Passage { place, ends, kinetic, reason, way: None });
        }
    }

    /// The reason to give where nothing holds the body on its circle.
    fn lets_go(&self, index: usize, stage: &Swing) -> Reason {
        match stage.radius {
            Some(_) => Reason::LeavesTrack(self.called(&stage.body), self.stage_phrase(index)),
            None => Reason::CordSlack(self.does(&stage.body, ["comes", "come"]), self.stage_phrase(index)),
        }
    }

    /// The pull of the cord or the push of the track at the end, where it is given and tells at which angle the end is.
    fn told_pull(&mut self, index: usize, stage: &Swing, end: &End) -> Option<Expr> {
        let Expr::Symbol(angle) = end.angle else { return None };
        let (name, _) = self.name_of_pull(index, 1, stage);
        let is_told = self.is_literal(angle) || self.given.contains(&self.symbols.entry(angle).name);
        let tells = !is_told && self.given.contains(&name.to_string());
        tells.then(|| self.quantity(name)).flatten().map(Expr::from)
    }

    /// Finds the angle at which the pull at the end is as given: the speed there is that which energy leaves, for no block of the
    /// equations has a formula otherwise.
    fn where_it_pulls_so(&mut self, index: usize, stage: &Swing, length: &Expr, ends: &[End; 2]) {
        let Some(pull) = self.told_pull(index, stage, &ends[1]).filter(|_| ends[0].is_lowest) else { return };
        let (mass, gravity) = (self.mass(&stage.body), self.gravity());
        let weight = mass.clone() * gravity;
        let at_start = mass * Expr::integer(2) * energy::specific_kinetic(&ends[0].velocity) / length.clone();
        let cosine = ends[1].angle.clone().cos();
        let sides = (pull + Expr::integer(2) * weight.clone() - at_start, Expr::integer(3) * weight * cosine);
        let law = if stage.radius.is_some() { &force::TRACK } else { &force::CORD };
        let because = "by conservation of energy, the square of the speed there is less by twice g times the height, and both terms with the cosine stand on one side";
        self.law_at(COST_OF_BOTH, law, Some(index), because, sides);
    }

    /// Whether a body swings on cords of several lengths, as at a peg: then its tension changes between two swings.
    fn changes_cord(&self, stage: &Swing) -> bool {
        let length = |swing: &Swing| swing.arm().map(|term| term.0.trim().to_owned());
        let arm = length(stage);
        self.scene
            .stages
            .iter()
            .any(|other| matches!(other, Stage::Swing(other) if other.body == stage.body && length(other) != arm))
    }

    /// The name of the tension of the cord, or of the normal force of the track, at the start (0) or at the end (1), and when it is so.
    fn name_of_pull(&self, index: usize, side: usize, stage: &Swing) -> (Name, String) {
        let kind = if stage.radius.is_some() { QuantityKind::NormalForce } else { QuantityKind::Tension };
        let since = self.timeline.naming_instant(&stage.body, index + 1 + side);
        let (when, label) = if self.changes_cord(stage) {
            (format!("at the {} of {}", ["start", "end"][side], self.stage_phrase(index)), self.stage_label(index))
        } else {
            (self.when(since), None)
        };
        (Name::of(kind, &stage.body).at(since).during(label), when)
    }

    /// The tension of the cord, or the normal force of the track, at the start (0) or at the end (1).
    pub(super) fn tension(&mut self, index: usize, side: usize, stage: &Swing, length: &Expr, end: &End) {
        let (holds, carrier) = (stage.held_by(), stage.on.as_deref().map(|on| self.called(on)));
        let (pull, when) = self.name_of_pull(index, side, stage);
        let body = stage.body.as_str();
        let (name, on_track) = (self.called(body), stage.radius.is_some());
        let (law, meaning) = if on_track {
            (&force::TRACK, format!("the normal force of the track on {name} {when}"))
        } else {
            (&force::CORD, format!("the tension of the cord of {name} {when}"))
        };
        let tension = Expr::from(self.symbol(pull, meaning));
        let (mass, gravity) = (self.mass(body), self.gravity());
        let cosine = end.angle.clone().cos().simplify();
        let sides = force::tension(&tension, [&mass, &gravity], &cosine, &end.velocity, length);
        let centre = match (on_track, &carrier) {
            (true, _) => "the centre of the track",
            (false, None) => "the fixed end of the cord",
            (false, Some(_)) => "the upper end of the cord",
        };
        let frame = carrier.map_or_else(String::new, |on| {
            format!("relative to {on}, which has no acceleration when {holds} acts vertically, ")
        });
        let because = format!("{frame}{} on a circle about {centre}", self.does(body, ["moves", "move"]));
        self.law(law, None, because, sides);
    }
}
