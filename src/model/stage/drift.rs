//! Free motion: every place changes by velocity times time.

use crate::expr::Expr;
use crate::fault::Code;
use crate::fault::Fault;
use crate::fault::Path;
use crate::laws::kinematics;
use crate::model::Builder;
use crate::quantity::Dimension;
use crate::scene::Axis;
use crate::scene::stage::Drift;

impl Builder<'_> {
    pub(in crate::model) fn drift(&mut self, index: usize, stage: &Drift, path: &Path) {
        let phrase = self.stage_phrase(index);
        let meaning = format!("the duration of {phrase}");
        let time = match &stage.during {
            Some(term) => self.read_positive(term, Dimension::TIME, &meaning, &path.key("during")),
            None => self.positive(format!("dt{}", self.stage_suffix(index)), Dimension::TIME, meaning).into(),
        };
        self.lasting[index] = Some(time.clone());
        let bodies: Vec<String> = self.timeline.alive(index + 1).into_iter().map(str::to_owned).collect();
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        for body in &bodies {
            for (position, axis) in axes.iter().enumerate() {
                if self.downwards(position).is_some() {
                    let fault = Fault::new(Code::Value, "bodies do not go on evenly where weight acts");
                    self.faults.push(fault.help("leave `plane: vertical` out, or use `fall`").at_path(path.clone()));
                    return;
                }
                let [before, after] = [index + 1, index + 2].map(|instant| self.place(body, instant, *axis));
                if let Some(part) = self.parts_of(body).first().filter(|_| self.timeline.is_new(body, index + 1)) {
                    let sides = (before.clone(), self.place(part, index, *axis));
                    let because = format!("{} starts where the two met", self.called(body));
                    self.law(&kinematics::SAME_PLACE, Some(index), because, sides);
                }
                let velocity = self.velocity(body, index + 1, *axis);
                let because = format!("nothing acts on {} during {phrase}", self.called(body));
                let sides = (after, before + velocity * time.clone());
                self.law(&kinematics::EVEN_MOTION, Some(index), because, sides);
            }
        }
        if let Some(until) = &stage.until {
            let at = path.key("until");
            let Some((left, right)) = until.split_once('=') else {
                let fault = Fault::new(Code::Syntax, format!("`{until}` is not an equation"));
                self.faults.push(fault.help("write `x_A = d`, or `x_A = x_B`").at_path(at));
                return;
            };
            self.places_at = Some(index + 2);
            let sides = (self.read_any(left, &at), self.read_any(right, &at));
            self.places_at = None;
            let because = format!("this is when {phrase} ends");
            self.law(&kinematics::UNTIL, Some(index), because, sides);
        }
        self.omit("friction and air resistance", "the problem does not mention any");
    }

    /// The place of a body at an instant, under the instant since which it is there.
    pub(in crate::model) fn place(&mut self, body: &str, instant: usize, axis: Axis) -> Expr {
        let since = self.timeline.placed_since(body, instant).unwrap_or(instant);
        let (owner, when) = (self.called(body), self.when(since));
        let (letter, part) = match self.axes.len() {
            1 => (String::new(), String::new()),
            _ => (format!(".{}", axis.letter()), format!("the {}-component of ", axis.letter())),
        };
        let meaning = format!("{part}the position of {owner} {when}");
        self.symbol(format!("r_{body}{since}{letter}"), Dimension::LENGTH, meaning).into()
    }
}
