//! How fast forces change the angular momentum of bodies, seen on its motion just after they begin to act.

use momentous_scene::stage::{During, Push};

use crate::scene::measure::{self, Asked, centre, turning};
use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::{place, velocity};
use crate::scene::rate::{Rate, rate};
use crate::scene::stage_run::StageRun;
use crate::scene::values::Values;
use crate::scene::vector::{Vector, ZERO, add, cross, less, times};

/// For how long the motion is looked at, in s.
const SOON: f64 = 1e-4;

impl StageRun<'_> {
    /// Notes the rates about every point of the scene; whether there was one.
    pub(super) fn note_rates(&mut self, stage: &Push) -> Result<bool, NothingToSimulate> {
        let mut pushed = Vec::new();
        for body in stage.pushed() {
            let mass = self.values.mass(body)?;
            let (Ok(at), Ok(moving)) = (measure::place(self.values, body), measure::velocity(self.values, body)) else {
                return Ok(false);
            };
            pushed.push((mass, self.pulled(stage, body, at, moving)?));
        }
        let start = match &stage.during {
            Some(During::Between([from, _])) => self.values.term(from)?,
            _ => 0.0,
        };
        let integrator = self.integrator(SOON);
        let instant = self.values.index + 1;
        let points = self.values.fixed_points();
        for (point, point_place) in &points {
            let mut momentum_rate = Rate { value: ZERO, off: 0.0 };
            for (mass, system) in &pushed {
                let later = rate(SOON, |time| -> Result<Vector, NothingToSimulate> {
                    let end =
                        integrator.until(start, system.state(), start + time, &|at, state| system.slope(at, state))?;
                    Ok(times(*mass, cross(less(place(&end, 0), *point_place), velocity(&end, 0))))
                })?;
                momentum_rate =
                    Rate { value: add(momentum_rate.value, later.value), off: momentum_rate.off + later.off };
            }
            self.note_turning(point, instant, momentum_rate);
        }
        Ok(!points.is_empty())
    }

    /// Notes how fast the angular momentum about a point changes, which is the moment of all forces about it.
    pub(super) fn note_turning(&mut self, point: &str, instant: usize, turns: Rate) {
        for component in [None, Some("x"), Some("y"), Some("z")] {
            let asked = Asked { base: "H", subject: point, instant, component };
            let letter = component.map_or_else(String::new, |letter| format!(".{letter}"));
            if let Some(rate) = turning(self.values, asked, turns.value) {
                self.note(&format!("H_rate_{point}{instant}{letter}"), rate, turns.off / self.tolerance);
                self.note(&format!("M_{point}{instant}{letter}"), rate, turns.off / self.tolerance);
            }
        }
    }
}

impl Values<'_> {
    /// The fixed points of the scene, and where they are.
    pub(super) fn fixed_points(&self) -> Vec<(String, Vector)> {
        let at = |point: &String| Some((point.clone(), centre(self, &[], point, &|_| None)?));
        self.scene.points.keys().filter_map(at).collect()
    }
}
