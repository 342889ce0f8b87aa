//! A moment about a fixed point or the centre of mass: the angular momentum of all bodies before and after.

use crate::expr::Expr;
use crate::fault::Path;
use crate::laws::angular;
use crate::model::Builder;
use crate::quantity::Dimension;
use crate::scene::Strength;
use crate::scene::stage::Moment;

impl Builder<'_> {
    pub(in crate::model) fn moment(&mut self, index: usize, stage: &Moment, path: &Path) {
        let Some(centre) = self.centre(&stage.about) else { return };
        let (start, end) = self.duration(index, &stage.during, &path.key("during"));
        self.lasting[index] = Some(end.clone() - start.clone());
        let letters = self.axis_letters();
        let meaning = format!("the moment about {centre}");
        let at = path.key("value");
        let moments: Vec<(String, Expr)> = match (&stage.value, &letters[..]) {
            (Strength::Components(components), [_, _, _]) => {
                let moments = self.strengths(components, Dimension::ENERGY, &meaning, &at);
                letters.iter().map(|letter| format!(".{letter}")).zip(moments).collect()
            }
            (value, [_, _]) => vec![(String::new(), self.strength(value, Dimension::ENERGY, &meaning, &at))],
            _ => {
                let fault = crate::fault::Fault::new(crate::fault::Code::Value, "a moment in space is a vector");
                self.faults.push(fault.help("write its components: `value: { x: 3 N*m, z: M }`").at_path(at));
                return;
            }
        };
        for (letter, moment) in moments {
            let [before, after] = [index + 1, index + 2]
                .map(|instant| self.resolve(&format!("H_{}{instant}{letter}", stage.about)).map(Expr::from));
            let (Some(before), Some(after)) = (before, after) else { return };
            self.told_throughout(&meaning, &moment, &end);
            let along = letter.trim_start_matches('.');
            let (law, because) = if moment.is_zero() {
                (&angular::CONSERVATION, format!("the moment about {centre} has no {along}-component"))
            } else {
                (&angular::ANGULAR_IMPULSE, format!("only the moment changes the angular momentum about {centre}"))
            };
            let gained =
                (!moment.is_zero()).then(|| self.angular_impulse(index, (&centre, &letter), &moment, &start, &end));
            self.law(law, Some(index), because, (Expr::sum([before].into_iter().chain(gained)), after));
        }
        if self.weight_acts_across() {
            self.not_needed(
                "weight and everything else that acts across the motion",
                "it has no moment about the axis",
            );
        }
    }
}
