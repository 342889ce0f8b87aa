//! A contact whose duration is not given, for whoever draws it: an instant between two uniform motions. An arm that is struck turns about
//! its pivot.

use momentous_simulate::scene::{CONTACT_IN_SECONDS, Component};
use momentous_simulate::{Moment, Pivot, Record, RecordedImpact, Tie};

use super::film::Film;

/// The instants before and after the contact.
const INSTANTS: u32 = 60;

/// The distance that the fastest body comes and goes, in m, where no arm gives a length.
const WAY: f64 = 1.0;

/// The same in lengths of the arm, and the greatest angle by which that turns, in radians.
const WAY_IN_ARMS: f64 = 1.6;
const ANGLE: f64 = 1.4;

/// The number of times longer that one side is watched than the other at most.
const LONGEST: f64 = 8.0;

/// Velocities that differ by less than this share of the greatest are the same.
const SAME: f64 = 1e-6;

/// Told beside what is drawn.
const INSTANT: &str =
    "How long the contact lasts is not given: it is drawn as an instant, with uniform motion before and after it.";
const ARM: &str =
    "It is seen along the pivot: the arm turns freely before and after the contact, and what it carries is not drawn.";

/// The velocities of all bodies on one side of the contact, and for how long they are watched there.
struct Side<'a> {
    moment: &'a Moment,
    length: f64,
}

/// The film with its contact as an instant, where its duration is not given; none where it is.
pub(super) fn brief(film: &Film) -> Option<Film> {
    if !film.notes.contains(&CONTACT_IN_SECONDS) {
        return None;
    }
    let (first, last) = (film.record.moments.first()?, film.record.moments.last()?);
    let lever = film.record.lever;
    let whole = [first, last].map(|moment| length(moment, lever, fastest(first).max(fastest(last))));
    // What follows slowly is not watched so long that what came fast is not seen.
    let shorter = whole[0].min(whole[1]);
    let [before, after] = [(first, whole[0]), (last, whole[1])]
        .map(|(moment, length)| Side { moment, length: length.min(LONGEST * shorter) });
    let (before, after) = (&before, &after);
    let axes = match lever {
        None => film.axes.clone(),
        Some(_) => [("x", [1.0, 0.0]), ("y", [0.0, 1.0])]
            .map(|(letter, on_page)| Component { letter, vertical: false, positive: None, on_page })
            .to_vec(),
    };
    let mut moments = Vec::new();
    for step in 0..=INSTANTS {
        let ago = before.length * f64::from(INSTANTS - step) / f64::from(INSTANTS);
        moments.push(moment(film, before, -ago, before.length - ago)?);
    }
    for step in 0..=INSTANTS {
        let since = after.length * f64::from(step) / f64::from(INSTANTS);
        moments.push(moment(film, after, since, before.length + since)?);
    }
    if lever.is_some() {
        // What the pivot gives while the arm turns.
        let start = moments.first()?.momentum.clone();
        for each in &mut moments {
            each.outside = each.momentum.iter().zip(&start).map(|(now, then)| now - then).collect();
        }
    }
    let contact = film.record.bodies.iter().map(|body| body.name.as_str()).collect::<Vec<_>>().join("-");
    let change = |axis: usize| {
        let speed = |moment: &Moment| Some(moment.masses.last()? * moment.velocities.last()?.get(axis)?);
        Some(speed(last)? - speed(first)?)
    };
    let mut impulse = (0..film.axes.len()).map(change).collect::<Option<Vec<f64>>>()?;
    impulse.resize(axes.len(), 0.0);
    let impact = RecordedImpact {
        time: before.length,
        contact,
        impulse,
        energy_before: first.kinetic,
        energy_after: last.kinetic,
    };
    let pivot = match lever {
        None => film.record.pivot.clone(),
        Some(length) => Some(Pivot { at: vec![0.0, length], tie: Tie::Arm(film.record.bodies.len().checked_sub(1)?) }),
    };
    let record = Record { pivot, moments, impacts: vec![impact], ..film.record.clone() };
    let mut notes: Vec<&'static str> = vec![INSTANT];
    notes.extend(lever.map(|_| ARM));
    notes.extend(film.notes.iter().filter(|note| **note != CONTACT_IN_SECONDS));
    Some(Film { axes, record, notes, ..film.clone() })
}

/// For how long a side is watched: until the fastest has gone its way, or the arm has turned enough. Speeds that rounding leaves beside the
/// greatest of both sides are none.
fn length(moment: &Moment, lever: Option<f64>, greatest: f64) -> f64 {
    let least = SAME * greatest;
    let arm = moment.velocities.last().map(|velocity| size(velocity));
    let (fastest, arm) = (fastest(moment).max(least), arm.map(|arm| arm.max(least)));
    match (lever, arm) {
        (Some(lever), Some(arm)) => (WAY_IN_ARMS * lever / fastest).min(ANGLE * lever / arm),
        _ => WAY / fastest,
    }
}

fn fastest(moment: &Moment) -> f64 {
    moment.velocities.iter().map(|velocity| size(velocity)).fold(0.0, f64::max)
}

fn size(vector: &[f64]) -> f64 {
    libm::sqrt(vector.iter().map(|part| part * part).sum())
}

/// The bodies so long after the contact, or before it where that is negative.
fn moment(film: &Film, side: &Side<'_>, since: f64, time: f64) -> Option<Moment> {
    let moment = side.moment;
    let (mut positions, mut velocities): (Vec<Vec<f64>>, Vec<Vec<f64>>) = moment
        .velocities
        .iter()
        .map(|velocity| (velocity.iter().map(|part| part * since).collect(), velocity.clone()))
        .unzip();
    if let Some(lever) = film.record.lever {
        let speed = *moment.velocities.last()?.first()?;
        let (sine, cosine) = libm::sincos(speed * since / lever);
        let tip = (vec![lever * sine, lever * (1.0 - cosine)], vec![speed * cosine, speed * sine]);
        let fastest = fastest(moment);
        for (place, velocity) in positions.iter_mut().zip(&mut velocities) {
            // What sticks in the arm turns with it.
            let sticks = since >= 0.0 && (velocity.first()? - speed).abs() <= SAME * fastest;
            if sticks {
                (*place, *velocity) = tip.clone();
            } else {
                place.push(0.0);
                velocity.push(0.0);
            }
        }
        (*positions.last_mut()?, *velocities.last_mut()?) = tip;
    }
    let axes = positions.first()?.len();
    let weighed = |vectors: &[Vec<f64>], axis: usize| -> Option<f64> {
        moment.masses.iter().zip(vectors).map(|(mass, vector)| Some(mass * vector.get(axis)?)).sum()
    };
    let total: f64 = moment.masses.iter().sum();
    Some(Moment {
        time,
        centre: (0..axes).map(|axis| Some(weighed(&positions, axis)? / total)).collect::<Option<_>>()?,
        momentum: (0..axes).map(|axis| weighed(&velocities, axis)).collect::<Option<_>>()?,
        outside: moment.outside.iter().copied().chain([0.0]).take(axes).collect(),
        positions,
        velocities,
        ..moment.clone()
    })
}
