//! Free flights and even motion: every body from its place with its velocity, until a time or an equation in the places.

use std::sync::Arc;

use crate::scene::stage::{Drift, Flight};
use crate::scene::{Axis, Term};

use crate::simulate::scene::bench::Bench;
use crate::simulate::scene::nothing::NothingToSimulate;
use crate::simulate::scene::rate::rate;
use crate::simulate::scene::reel::{Look, Motion, Seen};
use crate::simulate::scene::values::OfSeveral;
use crate::simulate::scene::vector::{Vector, ZERO, add, cross, less, size, times, unit};

/// The time after which it is looked on which side of its end a motion that starts on it has gone.
const SOON: f64 = 1e-6;

/// One component of the motion of one body.
struct Track {
    body: String,
    axis: Axis,
    place: Option<f64>,
    speed: f64,
    falls: f64,
}

/// The share of its time over which it is looked at how fast something changes.
const SOON_AFTER: f64 = 1e-3;

/// What ends a motion.
enum Ends {
    Time(f64),
    Top,
    /// Where this is zero, in the places in the order of the tracks.
    Meets(OfSeveral),
}

impl Track {
    fn place_at(&self, time: f64) -> f64 {
        self.place.unwrap_or(f64::NAN) + self.way(time)
    }

    fn way(&self, time: f64) -> f64 {
        time * (self.speed + time * self.falls / 2.0)
    }
}

impl Bench<'_> {
    pub(super) fn flight(&mut self, stage: &Flight) -> Result<(), NothingToSimulate> {
        let falls = self.values.falls(stage.incline.as_ref())?;
        let mut tracks = Vec::new();
        for body in stage.flying() {
            for (axis, fall) in self.values.axes().into_iter().zip(&falls) {
                tracks.push(self.track(body, axis, *fall)?);
            }
        }
        self.fly(&tracks, stage.until.as_ref(), stage.during.as_ref())
    }

    pub(super) fn drift(&mut self, stage: &Drift) -> Result<(), NothingToSimulate> {
        let mut tracks = Vec::new();
        let named = self.values.scene.bodies.keys().map(String::as_str);
        let unions = self.values.scene.stages.iter().filter_map(|stage| match stage {
            crate::scene::Stage::Impact(impact) => impact.becomes.as_deref(),
            _ => None,
        });
        for body in named.chain(unions) {
            for axis in self.values.axes() {
                tracks.extend(self.track(body, axis, 0.0).ok().filter(|track| track.place.is_some()));
            }
        }
        if tracks.is_empty() {
            return Err(NothingToSimulate::ValueMissing);
        }
        self.fly(&tracks, stage.until.as_ref(), stage.during.as_ref())
    }

    fn track(&self, body: &str, axis: Axis, falls: f64) -> Result<Track, NothingToSimulate> {
        let place = self.values.place_before(body, axis).ok();
        Ok(Track { body: body.to_owned(), axis, place, speed: self.values.velocity_before(body, axis)?, falls })
    }

    fn fly(&mut self, tracks: &[Track], until: Option<&Term>, during: Option<&Term>) -> Result<(), NothingToSimulate> {
        let ends = match until.map(|term| term.0.trim()) {
            None => Ends::Time(during.map_or_else(|| self.values.duration(), |term| self.values.term(term))?),
            Some("top") => Ends::Top,
            Some(text) => Ends::Meets(self.equation(tracks, text)?),
        };
        let time = self.ending(tracks, &ends)?;
        self.film_tracks(tracks, time)?;
        for track in tracks {
            self.note(
                &self.values.velocity_after(&track.body, track.axis),
                track.speed + track.falls * time,
                track.speed,
            );
            if let Some(start) = track.place {
                let name = self.values.place_name(&track.body, self.values.index + 2, track.axis);
                let way = (track.speed * time).abs();
                self.note(&name, track.place_at(time), start.abs().max(way));
            }
        }
        self.note_duration(during, time);
        let first = self.values.index + 1;
        self.note_moments(tracks, first, 0.0, SOON_AFTER * time)?;
        self.note_moments(tracks, first + 1, time, -SOON_AFTER * time)
    }

    /// How fast the angular momentum of all about each point of the scene changes, where they all fly and it is known where.
    fn note_moments(
        &mut self,
        tracks: &[Track],
        instant: usize,
        time: f64,
        width: f64,
    ) -> Result<(), NothingToSimulate> {
        let seen = |body: &str, later: f64, of: &dyn Fn(&Track, f64) -> f64| {
            let own = tracks.iter().filter(|track| track.body == body);
            own.fold(ZERO, |all, track| add(all, times(of(track, time + later), unit(track.axis))))
        };
        let points: Vec<(String, Vector)> = self.values.fixed_points();
        for (point, centre) in points {
            let turns = rate(width, |later| {
                let mut all = ZERO;
                for track in tracks.iter().filter(|track| Some(&track.axis) == self.values.axes().first()) {
                    let place = seen(&track.body, later, &Track::place_at);
                    let velocity = seen(&track.body, later, &|own, time| own.speed + own.falls * time);
                    let Ok(mass) = self.values.mass(&track.body) else { return Ok([f64::NAN; 3]) };
                    all = add(all, times(mass, cross(less(place, centre), velocity)));
                }
                Ok(all)
            })?;
            if size(turns.value).is_finite() {
                self.note_turning(&point, instant, turns);
            }
        }
        Ok(())
    }

    /// All bodies on their tracks, each from where it is known to start, or else from nought.
    fn film_tracks(&mut self, tracks: &[Track], end: f64) -> Result<(), NothingToSimulate> {
        let components = self.values.frame().components;
        let each: Vec<&[Track]> = tracks.chunks(components.len().max(1)).collect();
        let names: Vec<&str> = each.iter().map(|own| own[0].body.as_str()).collect();
        let masses: Vec<f64> = names.iter().map(|name| self.values.any_mass(name)).collect();
        let look = |time: f64, _: &[f64; 0]| {
            let bodies: Vec<Seen> = each
                .iter()
                .zip(&masses)
                .map(|(own, mass)| Seen {
                    mass: *mass,
                    place: own.iter().map(|track| track.place.unwrap_or(0.0) + track.way(time)).collect(),
                    velocity: own.iter().map(|track| track.speed + track.falls * time).collect(),
                })
                .collect();
            let pulls = each
                .iter()
                .zip(&masses)
                .map(|(own, mass)| own.iter().map(|track| mass * track.falls).collect::<Vec<f64>>());
            let sunk = pulls
                .clone()
                .zip(&bodies)
                .map(|(pull, body)| pull.iter().zip(&body.place).map(|(pull, place)| -pull * place).sum::<f64>());
            let potential = sunk.sum();
            let outside = pulls.fold(vec![0.0; components.len()], |sum, pull| {
                sum.iter().zip(pull).map(|(sum, own)| sum + own).collect()
            });
            Look { bodies, outside, potential, ..Look::default() }
        };
        let (start, components) = ((0.0, []), components.clone());
        self.film(&Motion { names: &names, components, start, end, slope: &|_, _| [], look: &look })
    }

    /// The two sides of an equation in places as a function of the places that is zero where they are equal.
    fn equation(&self, tracks: &[Track], text: &str) -> Result<OfSeveral, NothingToSimulate> {
        let (left, right) = text.split_once('=').ok_or(NothingToSimulate::Unread)?;
        let alone = tracks.iter().all(|track| track.body == tracks[0].body);
        let full: Vec<String> = tracks.iter().map(|track| format!("{}_{}", track.axis.letter(), track.body)).collect();
        let short: Vec<String> = tracks.iter().map(|track| track.axis.letter().to_owned()).collect();
        let mut names = full;
        if alone {
            names.extend(short);
        }
        let [left, right] = [left, right].map(|side| self.values.of_several(side, &names));
        let (left, right) = (left?, right?);
        Ok(Arc::new(move |places| {
            let both = [places, places].concat();
            left(&both) - right(&both)
        }))
    }

    /// When the motion ends: the motion is marched in time, and the last step shortened.
    fn ending(&mut self, tracks: &[Track], ends: &Ends) -> Result<f64, NothingToSimulate> {
        let signed: Box<dyn Fn(f64) -> f64> = match ends {
            Ends::Time(time) => return Ok(*time),
            Ends::Top => {
                // Over a slope weight acts along both axes, of which the second points away from it.
                let Some(rising) = tracks.iter().rfind(|track| track.falls != 0.0) else {
                    return Err(NothingToSimulate::NothingChanges);
                };
                let (speed, falls) = (rising.speed, rising.falls);
                Box::new(move |time| speed + falls * time)
            }
            Ends::Meets(apart) => {
                Box::new(move |time| apart(&tracks.iter().map(|track| track.place_at(time)).collect::<Vec<_>>()))
            }
        };
        let first = if signed(0.0) == 0.0 { signed(SOON) } else { signed(0.0) };
        // How long a place needs for a change of the order of itself.
        let spans = tracks.iter().map(|track| {
            let way = track.place.unwrap_or(0.0).abs() + 1.0;
            way / (track.speed.abs() + libm::sqrt(way * track.falls.abs())).max(f64::MIN_POSITIVE)
        });
        let integrator = self.integrator(spans.fold(f64::INFINITY, f64::min).min(1e6) / 8.0);
        let (mut time, mut side) = (0.0, first.signum());
        for _ in 0..=self.crossing {
            (time, _) = integrator.event(time, [time], &|_, _| [1.0], &|time, _| signed(time) * side)?;
            side = -side;
        }
        Ok(time)
    }
}
