//! Repeated bounces on a level floor, in closed form.

use crate::expr::Expr;
use crate::fault::Path;
use crate::laws::Law;
use crate::laws::kinematics;
use crate::model::Agent;
use crate::model::Builder;
use crate::model::Impulse;
use crate::quantity::Dimension;
use crate::scene::Stage;
use crate::scene::stage::Bounces;

impl Builder<'_> {
    pub(in crate::model) fn bounces(&mut self, index: usize, stage: &Bounces, path: &Path) {
        let name = self.called(&stage.body);
        let e = self.restitution_coefficient(&stage.restitution, &path.key("restitution"));
        let gravity = self.gravity();
        let drop = self.drop_height(index, &stage.body);
        let first = kinematics::first_fall(&gravity, &drop);
        let speeds = format!("{name} is dropped, and each bounce multiplies its speed by e");
        let heights = format!("{speeds}, hence the height that it reaches by the square of e");
        let times = format!("{speeds}, hence the time of each flight by e");
        let law =
            |builder: &mut Self, (law, because): (&'static Law, &str), symbol: (&str, Dimension, String), value| {
                let symbol = builder.positive(symbol.0, symbol.1, symbol.2);
                builder.law(law, Some(index), because, (symbol.into(), value));
            };
        if let Some(term) = &stage.count {
            let count = self.read_positive(term, Dimension::NONE, "the number of bounces", &path.key("count"));
            let height = kinematics::bounce_height(&e, &count, &drop);
            law(
                self,
                (&kinematics::BOUNCE_HEIGHT, &heights),
                ("h_n", Dimension::LENGTH, format!("the height that {name} reaches after the n-th bounce")),
                height,
            );
            let speed = kinematics::bounce_speed(&e, &count, &gravity, &drop);
            law(
                self,
                (&kinematics::BOUNCE_SPEED, &speeds),
                ("v_n", Dimension::VELOCITY, format!("the speed of {name} just after the n-th bounce")),
                speed,
            );
            let time = kinematics::bounce_time(&e, &count, &first);
            law(
                self,
                (&kinematics::BOUNCE_TIME, &times),
                ("t_n", Dimension::TIME, "the time of the n-th bounce, counted from the release".into()),
                time,
            );
        }
        let total = kinematics::total_time(&e, &first);
        law(
            self,
            (&kinematics::BOUNCE_TIME, &times),
            ("t_total", Dimension::TIME, format!("the time after which {name} lies still, counted from the release")),
            total,
        );
        let path_length = kinematics::total_path(&e, &drop);
        law(
            self,
            (&kinematics::BOUNCE_PATH, &heights),
            ("path_total", Dimension::LENGTH, format!("the whole path of {name}")),
            path_length,
        );
        self.impulses.push(Impulse {
            stage: index,
            on: stage.body.clone(),
            by: Agent::Outside,
            called: "the floor".into(),
            components: Vec::new(),
            impulsive: true,
        });
        self.omit("air resistance", "the problem does not mention any");
        self.omit("the duration of each contact", "it is short beside the time in the air");
    }

    /// The height of the fall just before, or `h_0`.
    fn drop_height(&mut self, index: usize, body: &str) -> Expr {
        let before = index.checked_sub(1).and_then(|before| Some((before, self.scene.stages.get(before)?)));
        let meaning = format!("the height from which {} is dropped", self.called(body));
        match before {
            Some((before, Stage::Fall(fall))) if fall.body == body => {
                let path = Path::root().key("scene").key("stages").index(before).key("fall").key("height");
                self.read_positive(&fall.height, Dimension::LENGTH, &meaning, &path)
            }
            _ => self.positive("h_0", Dimension::LENGTH, meaning).into(),
        }
    }
}
