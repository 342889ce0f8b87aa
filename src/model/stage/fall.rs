//! Free fall through a height.

use crate::Builder;
use crate::Effect;
use crate::Influence;
use crate::QuantityKind;
use crate::Reason;
use momentous_expr::Expr;
use momentous_fault::Path;
use momentous_laws::kinematics;
use momentous_quantity::Dimension;
use momentous_scene::Axis;
use momentous_scene::stage::Fall;
use momentous_solve::Relation;

impl Builder<'_> {
    pub(crate) fn fall(&mut self, index: usize, stage: &Fall, path: &Path) {
        let body = stage.body.as_str();
        let name = self.called(body);
        let phrase = self.stage_phrase(index);
        let meaning = format!("the height through which {name} falls");
        let height = self.read_positive(&stage.height, Dimension::LENGTH, &meaning, &path.key("height"));
        let gravity = self.gravity();
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        let on_string = self.scene.sinks(index, body).filter(|_| axes.len() == 1);
        let downwards: Vec<Option<i64>> =
            (0..axes.len()).map(|position| self.downwards(position).or(on_string)).collect();
        let mut impulse = vec![Expr::zero(); axes.len()];
        for (position, (axis, down)) in axes.iter().zip(&downwards).enumerate() {
            let [before, after] = [index + 1, index + 2].map(|instant| self.velocity(body, instant, *axis));
            let Some(down) = *down else {
                let because = format!("weight has no component along {}", axis.letter());
                self.law(&momentous_laws::momentum::NO_IMPULSE, Some(index), because, (after, before));
                continue;
            };
            let way = (Expr::integer(down) * height.clone()).simplify();
            self.comes_so_far((index, body), *axis, way, format!("{name} comes so far"));
            let because = format!("weight is the only force on {name} during {phrase}");
            let sides = kinematics::fall_speed(&gravity, &height, &before, &after);
            self.law(&kinematics::FALL_SPEED, Some(index), because.clone(), sides);
            let downward = Expr::integer(down) * after.clone();
            let reason = Reason::Downwards(self.does(&stage.body, ["moves", "move"]), phrase.clone());
            self.require(downward, Relation::AtLeast, Expr::zero(), reason);
            let meaning = format!("the duration of {phrase}");
            let time = self.positive(self.in_stage(QuantityKind::Duration, "", index), meaning);
            self.lasting[index] = Some(time.into());
            let gained = Expr::product([Expr::integer(down), gravity.clone(), time.into()]);
            impulse[position] = self.mass(body) * gained.clone();
            self.law(&kinematics::FALL_TIME, Some(index), because, (before + gained, after));
        }
        let weight = self.weight_on(index, body);
        // Along a string over a pulley no axis points down.
        let along_string =
            on_string.map(|down| vec![Effect::Of(Expr::product([Expr::integer(down), self.mass(body), gravity]))]);
        let force = along_string.unwrap_or(weight.force);
        self.acts(Influence { force, ..weight });
        self.note_impulse(index, body, "weight", impulse);
        self.neglect("air resistance", "the problem gives none");
    }
}
