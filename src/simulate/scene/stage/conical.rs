//! A conical pendulum whose cord is drawn in: two steady circles, and the motion between them.

use core::f64::consts::TAU;

use momentous_scene::stage::Conical;

use crate::scene::course::Until;
use crate::scene::integrate::Integrator;
use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::{Constraint, Surface};
use crate::scene::revolution::{Circle, around, distance};
use crate::scene::stage_run::StageRun;
use crate::scene::vector::{add, times, unit};

/// The tolerance of a motion of which nothing is read off: its steps are short enough, and what would rise and fall is only rounding.
const SHOWN: f64 = 0.01;

impl StageRun<'_> {
    pub(super) fn conical(&mut self, stage: &Conical) -> Result<(), NothingToSimulate> {
        let [axis] = self.values.axes()[..] else { return Err(NothingToSimulate::Unread) };
        let (body, first, gravity) = (stage.body.as_str(), self.values.index + 1, self.values.named("g")?);
        let [from, to] = stage.length.ends();
        let [long, short] = [self.values.term(from)?, self.values.term(to)?];
        let told = self.values.velocity_before(body, axis);
        let turn = self.values.named(&format!("omega_{body}{first}"));
        let rate = turn.map(f64::abs).or_else(|_| Ok(TAU / self.values.named(&format!("period_{body}{first}"))?));
        let circle = match (self.values.named(&format!("angle_{body}{first}")), &told, rate) {
            (Ok(angle), ..) => Circle::steady(long, angle, gravity),
            (Err(_), Ok(speed), _) => Circle::with(long, gravity, speed.abs(), &|circle| circle.speed),
            (Err(_), Err(_), Ok(rate)) => Circle::with(long, gravity, rate, &|circle| circle.speed / circle.radius()),
            (Err(_), Err(_), Err(missing)) => return Err(missing),
        };
        let sense = told.or(turn).map_or(1.0, f64::signum);
        // The cord is drawn in evenly within a turn; what the particle is like meanwhile nobody asks.
        let turn = TAU * circle.radius() / circle.speed;
        let drawn = (short - long) / turn;
        let mut system = circle.system(body, self.values.any_mass(body), gravity);
        let stretch = times(drawn / long, system.particles[0].place);
        system.particles[0].velocity = add(system.particles[0].velocity, stretch);
        // The length is linear in the time: half the second derivative of its square is the square of its rate.
        system.constraint = Some(Constraint::Surface(Surface { changes: drawn * drawn, ..Surface::sphere() }));
        let integrator = self.integrator(turn / 64.0);
        // A circle that lasts is only shown.
        let integrator = if drawn == 0.0 { Integrator { tolerance: SHOWN, ..integrator } } else { integrator };
        let end = self.go(&system, integrator, &Until::Time(turn))?.state;
        self.about(vec![0.0; 3], true);
        self.remark("How fast the cord is drawn in is not given: it is drawn in at a constant rate, within one turn. Positions are measured from the pivot.");
        let swept = around(&end) * distance(&end);
        let drawn_in = || Circle::with(short, gravity, swept, &|circle| circle.speed * circle.radius());
        let after = if drawn == 0.0 { circle } else { drawn_in() };
        for (instant, circle) in [(first, circle), (first + 1, after)] {
            self.note(&format!("angle_{body}{instant}"), circle.angle, 1.0);
            self.note(&format!("r_{body}{instant}"), circle.radius(), 0.0);
            let rate = circle.speed / circle.radius();
            self.note(&format!("omega_{body}{instant}"), sense * rate, 0.0);
            self.note(&format!("period_{body}{instant}"), TAU / rate, 0.0);
            if let Ok(mass) = self.values.mass(body) {
                self.note(&format!("tension_{body}{instant}"), mass * circle.pull(gravity), 0.0);
                let moment = sense * mass * circle.speed * circle.radius();
                self.note(&format!("H_{}{instant}", stage.about), moment, 0.0);
            }
        }
        self.note(&self.values.start_name(body, axis), sense * circle.speed, 0.0);
        self.note_velocity(body, times(sense * after.speed, unit(axis)), 0.0);
        Ok(())
    }
}
