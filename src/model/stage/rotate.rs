//! A particle on an arm: angular impulse and momentum about a fixed point.

use crate::expr::Expr;
use crate::fault::Path;
use crate::laws::angular;
use crate::model::Agent;
use crate::model::Builder;
use crate::model::Impulse;
use crate::model::Integral;
use crate::quantity::Dimension;
use crate::scene::Term;
use crate::scene::stage::Arm;
use crate::scene::stage::Rotate;

impl Builder<'_> {
    pub(in crate::model) fn rotate(&mut self, index: usize, stage: &Rotate, path: &Path) {
        let (body, point) = (stage.body.as_str(), stage.about.as_str());
        let (name, centre) = (self.called(body), self.point(point));
        let mass = self.mass(body);
        let arms: [&Term; 2] = match &stage.arm {
            Arm::Constant(term) => [term, term],
            Arm::Changing([before, after]) => [before, after],
        };
        let mut momenta = Vec::new();
        for (side, term) in arms.into_iter().enumerate() {
            let instant = index + 1 + side;
            let meaning = format!("the distance of {name} from {centre} {}", self.when(instant));
            let arm = self.read_positive(term, Dimension::LENGTH, &meaning, &path.key("arm"));
            let meaning = format!("the transverse velocity of {name} {}", self.when(instant));
            let velocity = Expr::from(self.symbol(format!("v_{body}{instant}"), Dimension::VELOCITY, meaning));
            let meaning = format!("the angular momentum about {centre} {}", self.when(instant));
            let momentum = Expr::from(self.symbol(format!("H_{point}{instant}"), Dimension::ANGULAR_MOMENTUM, meaning));
            let because = format!("{name} moves at right angles to the radius");
            let moment = Expr::product([mass.clone(), arm.clone(), velocity.clone()]);
            self.law(&angular::ANGULAR_MOMENTUM, Some(index), because, (momentum.clone(), moment));
            self.angular_velocity(index, [body, &centre], instant, &arm, &velocity);
            self.towards_the_centre(index, [body, &centre], instant, &arm, &velocity);
            momenta.push(momentum);
        }
        let moment = stage.moment.as_ref().map(|strength| {
            let meaning = format!("the moment about {centre}");
            self.strength(strength, Dimension::ENERGY, &meaning, &path.key("moment"))
        });
        let mut gained = None;
        if let (Some(moment), Some(during)) = (&moment, &stage.during) {
            let (start, end) = self.duration(index, during, &path.key("during"));
            gained = Some(self.angular_impulse(index, &centre, moment, &start, &end));
        }
        let because = match gained {
            Some(_) => {
                format!(
                    "the force of the arm passes through {centre}, and only the moment changes the angular momentum"
                )
            }
            None => format!("the only force on {name} in the plane passes through {centre} and has no moment about it"),
        };
        if let [before, after] = &momenta[..] {
            let start = Expr::sum([before.clone()].into_iter().chain(gained));
            self.law(&angular::ANGULAR_IMPULSE, Some(index), because, (start, after.clone()));
        }
        self.impulses.push(Impulse {
            stage: index,
            on: body.to_owned(),
            by: Agent::Outside,
            called: match (&moment, &stage.arm) {
                (Some(_), _) => format!("the force of the arm and the moment about {centre}"),
                (None, Arm::Constant(_)) => "the force of the arm".into(),
                (None, Arm::Changing(_)) => format!("the force towards {centre}"),
            },
            components: Vec::new(),
            impulsive: false,
        });
        self.omit(format!("the mass of what holds {name}"), "it is light");
    }

    fn angular_velocity(
        &mut self,
        index: usize,
        [body, centre]: [&str; 2],
        instant: usize,
        arm: &Expr,
        velocity: &Expr,
    ) {
        let meaning = format!("the angular velocity of {} about {centre} {}", self.called(body), self.when(instant));
        let angular = self.symbol(format!("omega_{body}{instant}"), Dimension::new(0, 0, -1), meaning);
        let sides = (velocity.clone(), arm.clone() * Expr::from(angular));
        let because = format!("{} moves at right angles to the radius", self.called(body));
        self.law(&crate::laws::geometry::ARC, Some(index), because, sides);
    }

    /// The acceleration towards the centre.
    fn towards_the_centre(
        &mut self,
        index: usize,
        [body, centre]: [&str; 2],
        instant: usize,
        arm: &Expr,
        velocity: &Expr,
    ) {
        let name = self.called(body);
        let meaning = format!("the acceleration of {name} towards {centre} {}", self.when(instant));
        let turning = self.symbol(format!("a_{body}{instant}.n"), Dimension::ACCELERATION, meaning);
        let because = format!("{name} moves on a circle at that instant");
        let sides = (turning.into(), velocity.clone().powi(2) / arm.clone());
        self.law(&crate::laws::geometry::TURNING, Some(index), because, sides);
    }

    fn angular_impulse(&mut self, index: usize, centre: &str, moment: &Expr, start: &Expr, end: &Expr) -> Expr {
        let clock = self.symbol("t", Dimension::TIME, "the time");
        if !moment.contains(clock) {
            return moment.clone() * (end.clone() - start.clone());
        }
        let suffix = self.stage_suffix(index);
        let symbol = self.symbol(
            format!("I_M{suffix}"),
            Dimension::ANGULAR_MOMENTUM,
            format!("the angular impulse about {centre}"),
        );
        match moment.definite(clock, start, end) {
            Some(value) => {
                let integral =
                    Integral { integrand: moment.clone(), variable: clock, low: start.clone(), high: end.clone() };
                let because = "the moment changes with time";
                self.integral(&angular::MOMENT_IMPULSE, index, because, (symbol.into(), value.simplify()), integral);
            }
            None => self
                .faults
                .push(crate::fault::Fault::new(crate::fault::Code::Stuck, "the moment cannot be integrated over time")),
        }
        symbol.into()
    }
}
