//! A moment about a point: a couple pushes two particles, which stand for all that turns, along tracks on both sides of it.

use std::sync::Arc;

use crate::scene::stage::{During, Moment};
use crate::scene::{Axis, Strength};

use crate::simulate::scene::bench::Bench;
use crate::simulate::scene::floor::{Slide, Until};
use crate::simulate::scene::nothing::NothingToSimulate;
use crate::simulate::scene::values::OfTime;

/// Half the distance of the tracks, in m.
const ARM: f64 = 0.5;

/// The mass of each particle, in kg.
const MASS: f64 = 1.0;

impl Bench<'_> {
    pub(super) fn moment(&mut self, stage: &Moment) -> Result<(), NothingToSimulate> {
        let [start, end] = self.during(Some(&stage.during))?;
        let turnings: Vec<(String, OfTime, Vec<f64>)> = match &stage.value {
            Strength::Components(components) => {
                let each = [Axis::X, Axis::Y, Axis::Z].into_iter().map(|axis| {
                    let moment = match components.get(axis) {
                        Some(term) => self.values.of_time(term)?,
                        None => Arc::new(|_| 0.0),
                    };
                    Ok((format!(".{}", axis.letter()), moment, Vec::new()))
                });
                each.collect::<Result<_, _>>()?
            }
            value => {
                let (moment, changes) = self.values.strength(value)?;
                vec![(String::new(), moment, changes)]
            }
        };
        for (letter, moment, changes) in turnings {
            // Each particle feels one force of the couple.
            let drive: OfTime = Arc::new(move |time| moment(time) / (2.0 * ARM) / MASS);
            let pushed = Slide { drive, grip: Arc::new(|_| 0.0), changes, start, speed: 0.0, body: None };
            let gained = 2.0 * ARM * MASS * pushed.run(self, 1.0, Until::Time(end))?.speed;
            self.note_here(&format!("I_M{letter}"), gained, 0.0);
            let [before, after] = [1, 2].map(|own| format!("H_{}{}{letter}", stage.about, self.values.index + own));
            if let Ok(before) = self.values.named(&before) {
                self.note(&after, before + gained, before);
            }
        }
        let term = match &stage.during {
            During::For(term) => Some(term),
            During::Between(_) => None,
        };
        self.note_duration(term, end - start);
        Ok(())
    }
}
