//! A body inside a smooth cone or bowl: angular momentum about the axis, and energy.

use crate::Builder;
use crate::Effect;
use crate::Influence;
use crate::Name;
use crate::QuantityKind;
use crate::Reason;
use crate::VectorKind;
use crate::builder::SECOND_COST;
use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::angular;
use momentous_laws::energy;
use momentous_laws::geometry;
use momentous_quantity::Dimension;
use momentous_scene::Point;
use momentous_scene::stage::Bowl;
use momentous_scene::stage::UpOrDown;
use momentous_solve::Relation;

impl Builder<'_> {
    pub(crate) fn bowl(&mut self, index: usize, stage: &Bowl, path: &Path) {
        let body = stage.body.as_str();
        let (name, centre) = (self.called(body), self.point(&stage.about));
        let states = [index + 1, index + 2].map(|instant| self.polar_state(body, &stage.about, instant));
        let [(r1, v1), (r2, v2)] = states.clone();
        let axis = self.scene.points.get(&stage.about).map_or(centre, Point::vertical);
        let because = format!("the wall's push and the weight have no moment about {axis}; the mass cancels");
        self.law(&angular::CENTRAL, Some(index), because, (r1.clone() * v1, r2.clone() * v2));
        let speeds = [0, 1].map(|side| self.speed_on_wall(index, side, stage, &states[side].1));
        let [start, end] = speeds.each_ref().map(|speed| energy::specific_kinetic(std::slice::from_ref(speed)));
        let height = self.height_on_wall(index, stage, path);
        let raised = self.gravity() * height.clone();
        let sides = if stage.way == UpOrDown::Up { (start, end + raised) } else { (start + raised, end) };
        let because = format!(
            "the push of the smooth wall is at right angles to the motion of {name} and does no work; the mass cancels"
        );
        self.law(&energy::CONSERVATION, Some(index), because, sides);
        self.wall(index, stage, &states, height, path);
        let words = "weight does work as the height changes";
        let weight = Influence::outside(index, body, "weight").works(Effect::Open, words);
        self.acts(weight.through(&stage.about));
        self.acts(Influence::outside(index, body, "the push of the wall").workless().through(&stage.about));
        self.note_impulse(index, body, "weight and the push of the wall", Vec::new());
        self.neglect("friction", "the wall is smooth");
    }

    /// The speed at one end, by its horizontal part and that along the wall.
    fn speed_on_wall(&mut self, index: usize, side: usize, stage: &Bowl, across: &Expr) -> Expr {
        let (body, instant) = (stage.body.as_str(), index + 1 + side);
        let since = self.timeline.naming_instant(body, instant);
        let (name, when) = (self.called(body), self.when(since));
        let speed = Expr::from(
            self.positive(Name::of(QuantityKind::Speed, body).at(since), format!("the speed of {name} {when}")),
        );
        if stage.is_horizontal(side) {
            let because = format!("{name} moves horizontally {when}");
            let size = Expr::apply(Function::Abs, across.clone());
            self.law(&geometry::SPEED, Some(index), because, (speed.clone(), size));
            return speed;
        }
        let meaning = format!("the velocity of {name} along the slope of the wall {when}");
        let along = Expr::from(self.symbol(Name::of(QuantityKind::Velocity, body).at(since).along("s"), meaning));
        let squares = across.clone().powi(2) + along.powi(2);
        let because = "the horizontal part of the velocity and that along the slope are perpendicular";
        self.law(&geometry::MAGNITUDE, Some(index), because, (speed.clone(), squares.sqrt()));
        let meaning = format!("the angle between the velocity of {name} and the horizontal {when}");
        let angle =
            Expr::from(self.positive(Name::of(QuantityKind::Direction(VectorKind::Velocity), body).at(since), meaning));
        let ratio = Expr::apply(Function::Abs, across.clone()) / speed.clone();
        let because = "the horizontal part of the velocity is its component along the circle";
        self.law(&geometry::COMPONENTS, Some(index), because, (angle, Expr::apply(Function::Acos, ratio)));
        speed
    }

    fn height_on_wall(&mut self, index: usize, stage: &Bowl, path: &Path) -> Expr {
        let meaning = "the height between the two levels";
        match &stage.height {
            Some(term) => self.read_positive(term, Dimension::LENGTH, meaning, &path.key("height")),
            None => self.positive(self.in_stage(QuantityKind::Height, &stage.body, index), meaning).into(),
        }
    }

    /// How the height follows from the distances from the axis.
    fn wall(&mut self, index: usize, stage: &Bowl, ends: &[(Expr, Expr); 2], height: Expr, path: &Path) {
        // From the lower distance to the upper one.
        let [first, second] = ends.each_ref().map(|(distance, _)| distance.clone());
        let radii = if stage.way == UpOrDown::Up { [first, second] } else { [second, first] };
        if stage.cone.is_some() && stage.sphere.is_some() {
            let fault = Fault::new(Code::OverDetermined, "a wall is a cone or a sphere, not both");
            self.faults.push(fault.help("remove `cone` or `sphere`").at_path(path.key("sphere")));
        }
        let level = stage.is_horizontal(0) && stage.is_horizontal(1);
        if let Some(term) = &stage.cone {
            let meaning = "the angle between the axis and the wall of the cone";
            let angle = self.read_positive(term, Dimension::NONE, meaning, &path.key("cone"));
            self.needs_unit(&angle, &path.key("cone"));
            let tangent = Expr::apply(Function::Tan, angle);
            let because = "the wall of the cone is straight";
            let sides = (height * tangent.clone(), radii[1].clone() - radii[0].clone());
            self.law(&geometry::HEIGHT_IN_BOWL, Some(index), because, sides);
            if level {
                let sum = radii[0].clone() + radii[1].clone();
                self.other_level(index, stage, sum * tangent, ends[1].0.clone().powi(2));
            }
        } else if let Some(term) = &stage.sphere {
            let radius = self.read_positive(term, Dimension::LENGTH, "the radius of the bowl", &path.key("sphere"));
            let [first, second] = [0, 1].map(|side| self.depth(index, side, stage, &radius, &ends[side].0));
            let (upper, lower) = match stage.way {
                UpOrDown::Up => (&second, &first),
                UpOrDown::Down => (&first, &second),
            };
            let (because, sides) = if upper.is_zero() {
                ("the upper level is that of the centre of the sphere", (lower.clone(), height))
            } else {
                ("the depths below the centre differ by the height", (height, lower.clone() - upper.clone()))
            };
            self.law(&geometry::HEIGHT_IN_BOWL, Some(index), because, sides);
            if level {
                let square = radius.powi(2) - second.clone().powi(2);
                self.other_level(index, stage, first + second, square);
            }
        }
    }

    /// How deep below the centre of a sphere the body is at one end.
    fn depth(&mut self, index: usize, side: usize, stage: &Bowl, radius: &Expr, distance: &Expr) -> Expr {
        let (body, instant) = (stage.body.as_str(), index + 1 + side);
        let since = self.timeline.naming_instant(body, instant);
        let meaning = format!("the depth of {} below the centre of the bowl {}", self.called(body), self.when(since));
        let depth = Expr::from(self.symbol(Name::of(QuantityKind::Depth, body).at(since), meaning));
        if distance == radius {
            let because = "at that distance from the axis the wall is level with the centre of the sphere";
            self.law(&geometry::HEIGHT_IN_BOWL, Some(index), because, (depth, Expr::zero()));
            return Expr::zero();
        }
        let squares = distance.clone().powi(2) + depth.clone().powi(2);
        let because = "the position is on the sphere, below its centre";
        self.law(&geometry::HEIGHT_IN_BOWL, Some(index), because, (squares, radius.clone().powi(2)));
        let reason = Reason::AboveCentre;
        self.require(depth.clone(), Relation::AtLeast, Expr::zero(), reason);
        depth
    }

    /// The other of the two levels at which the body moves horizontally: angular momentum put into the energy, and the
    /// factor that is zero at the first level divided out, which leaves `v^2 a = 2 g b`.
    fn other_level(&mut self, index: usize, stage: &Bowl, a: Expr, b: Expr) {
        let (_, across) = self.polar_state(&stage.body, &stage.about, index + 1);
        let because = "angular momentum is substituted into the energy balance; the root that is the first level itself is divided out";
        let sides = (across.powi(2) * a, Expr::product([Expr::integer(2), self.gravity(), b]));
        self.law_at(SECOND_COST, &energy::CONSERVATION, Some(index), because, sides);
    }
}
