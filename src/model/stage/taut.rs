//! A string that goes taut: its impulse acts along it, and gives both bodies one velocity along it.

use crate::Builder;
use crate::Reason;
use crate::frame::Frame;
use crate::pair::Pair;
use crate::taut_string::TautString;
use crate::weight_in_contact::Lasting;
use momentous_expr::Expr;
use momentous_fault::Path;
use momentous_laws::kinematics;
use momentous_laws::momentum;
use momentous_scene::Plane;
use momentous_scene::stage::Taut;
use momentous_solve::Relation;

impl Builder<'_> {
    pub(crate) fn taut(&mut self, index: usize, stage: &Taut, path: &Path) {
        let Some(between) = &stage.between else { return self.jerked_together(index, stage, path) };
        let normal = match &stage.along {
            Some(term) => self.direction(term, &path.key("along")),
            None => self.first_axis(),
        };
        let frame = Frame { normal };
        self.frames[index] = Some(frame.clone());
        self.strings.push(TautString { jerk: index, ends: between.clone(), direction: frame.normal.clone() });
        let bodies = between.each_ref().map(String::as_str);
        let [first, second] = bodies.map(|body| self.called(body));
        let before = bodies.map(|body| self.split(body, index + 1, index, &frame));
        let after = bodies.map(|body| self.split(body, index + 2, index, &frame));
        let along = |pair: &[crate::directions::Split; 2]| pair.each_ref().map(|split| split.along.clone());
        let plane = before.iter().any(|split| split.across.is_some());
        let pair = Pair {
            index,
            bodies,
            before: along(&before),
            after: along(&after),
            link: "the string",
            line: "it",
            pulley: stage.over.as_deref(),
        };
        let resolve = |builder: &Self, impulse: &Expr| builder.resolved(impulse, &frame);
        self.pair(&pair, plane.then_some("n"), &resolve, stage.duration.as_ref(), path);
        if stage.over.is_none() {
            self.lies_on_the_string(index, bodies, &frame.normal);
        }
        let because = format!(
            "the string does not stretch: once it is taut, {first} and {second} have the same velocity along it"
        );
        let [one, other] = pair.after.clone();
        self.law(&kinematics::TOGETHER, Some(index), because, (other, one));
        for (body, (start, end)) in bodies.into_iter().zip(before.iter().zip(&after)) {
            let (Some(start), Some(end)) = (&start.across, &end.across) else { continue };
            let because = format!(
                "the string pulls {} along its own direction, and exerts no impulse across it",
                self.called(body)
            );
            self.law(&momentum::NO_IMPULSE, Some(index), because, (end.clone(), start.clone()));
        }
        let reason = Reason::StaysSlack(first.clone(), second.clone());
        self.require(pair.before[1].clone(), Relation::AtLeast, pair.before[0].clone(), reason);
        self.neglect("the mass of the string", "it is light");
        if stage.over.is_some() || self.scene.plane == Plane::Vertical {
            let why =
                "it is not impulsive: its impulse during the short jerk is negligible compared with that of the string";
            self.neglect("weight during the jerk", why);
        }
        let lasting = Lasting { index, duration: stage.duration.as_ref(), include: None, path };
        self.weigh_contact(&lasting, &bodies.map(|body| (body, body)), stage.over.is_some());
        if let Some(pulley) = &stage.over {
            self.neglect(
                format!("the mass and the friction of {pulley}"),
                "it is light and smooth, so that the tension is the same on both sides",
            );
        }
    }
}
