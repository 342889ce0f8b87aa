//! Free motion: every place changes by velocity times time.

use std::collections::BTreeMap;

use crate::Builder;
use crate::QuantityKind;
use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::kinematics;
use momentous_quantity::Dimension;
use momentous_scene::Axis;
use momentous_scene::stage::Drift;

impl Builder<'_> {
    pub(crate) fn drift(&mut self, index: usize, stage: &Drift, path: &Path) {
        let phrase = self.stage_phrase(index);
        let meaning = format!("the duration of {phrase}");
        let time = match &stage.during {
            Some(term) => self.read_positive(term, Dimension::TIME, &meaning, &path.key("during")),
            None => self.positive(self.in_stage(QuantityKind::Duration, "", index), meaning).into(),
        };
        self.lasting[index] = Some(time.clone());
        let bodies: Vec<String> = self.timeline.alive(index + 1).into_iter().map(str::to_owned).collect();
        let mut moved = BTreeMap::new();
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        for body in &bodies {
            for (position, axis) in axes.iter().enumerate() {
                if self.downwards(position).is_some() {
                    let fault = Fault::new(Code::Value, "bodies do not keep their velocity when weight acts");
                    let help = if self.guided(body).is_some() {
                        "use a `push` with `forces: []` for a body that a guide holds, a `flight` for others, or remove `plane: vertical`"
                    } else {
                        "use `flight`, or remove `plane: vertical`"
                    };
                    self.faults.push(fault.help(help).at_path(path.clone()));
                    return;
                }
                let [before, after] = [index + 1, index + 2].map(|instant| self.place(body, instant, *axis));
                let velocity = self.velocity(body, index + 1, *axis);
                let because = format!("no net force acts on {} during {phrase}", self.called(body));
                let sides = kinematics::uniform(&before, &velocity, &time, &after);
                if let Expr::Symbol(place) = after {
                    moved.insert(place, sides.1.clone());
                }
                self.law(&kinematics::UNIFORM, Some(index), because, sides);
            }
        }
        if let Some(until) = &stage.until {
            let bodies: Vec<&str> = bodies.iter().map(String::as_str).collect();
            // Put in, the time follows from one equation even where a body stands still.
            self.end_of_flight(index, &bodies, until, &|place| moved.get(&place).cloned(), &path.key("until"));
        }
        self.neglect("friction and air resistance", "the problem gives none");
    }
}
