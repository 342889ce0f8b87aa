//! Motions that were simulated axis by axis, or body by body, as one motion: for whoever draws it.

use momentous_simulate::Moment;
use momentous_simulate::Record;
use momentous_simulate::RecordedImpact;
use momentous_simulate::RecordedWall;

use super::brief::brief;
use super::film::Film;
use super::shoot::Shot;

/// An instant, and whether it is looked at just after what happens then.
type Instant = (f64, bool);

impl Shot {
    /// The same with one film for each stage wherever its films are parts of one motion: each along an axis of its own, or of
    /// bodies of its own. A film that another one of the stage goes beyond is left out, and a contact whose duration is not given is an
    /// instant.
    #[must_use]
    pub fn together(self) -> Self {
        let mut films: Vec<Film> = Vec::new();
        for stage in self.films.chunk_by(|one, next| one.stage == next.stage) {
            let mut parts: Vec<&Film> = Vec::new();
            for film in stage {
                parts.retain(|other| !(is_same(other, film) && end(other) <= end(film)));
                parts.push(film);
            }
            let whole = joined(&parts).map_or_else(|| parts.iter().copied().cloned().collect(), |film| vec![film]);
            films.extend(whole.into_iter().map(|film| brief(&film).unwrap_or(film)));
        }
        Self { films, nothing: self.nothing }
    }
}

fn letters(film: &Film) -> impl Iterator<Item = &'static str> {
    film.axes.iter().map(|axis| axis.letter)
}

fn names(film: &Film) -> impl Iterator<Item = &str> {
    film.record.bodies.iter().map(|body| body.name.as_str())
}

fn is_same(one: &Film, other: &Film) -> bool {
    letters(one).eq(letters(other)) && names(one).eq(names(other))
}

fn start(film: &Film) -> f64 {
    film.record.moments.first().map_or(0.0, |moment| moment.time)
}

fn end(film: &Film) -> f64 {
    film.record.moments.last().map_or(0.0, |moment| moment.time)
}

/// One film of several on lines, where every body has one along every axis.
fn joined(parts: &[&Film]) -> Option<Film> {
    let first = *parts.first()?;
    if parts.len() < 2 {
        return None;
    }
    let mut whole = Film { axes: Vec::new(), record: Record::default(), ..first.clone() };
    for part in parts {
        whole.axes.extend(part.axes.iter().filter(|axis| !whole.axes.contains(axis)).cloned().collect::<Vec<_>>());
        for note in &part.notes {
            if !whole.notes.contains(note) {
                whole.notes.push(note);
            }
        }
        for body in &part.unweighed {
            if !whole.unweighed.contains(body) {
                whole.unweighed.push(body.clone());
            }
        }
        for body in &part.record.bodies {
            if whole.record.bodies.iter().all(|other| other.name != body.name) {
                whole.record.bodies.push(body.clone());
            }
        }
    }
    // For each body and axis the part that has it, and the body's place there.
    let mut sources: Vec<Vec<(&Film, usize)>> = Vec::new();
    for body in &whole.record.bodies {
        let mut along = Vec::new();
        for axis in &whole.axes {
            let is_here =
                |part: &&&Film| part.axes.as_slice() == [axis.clone()] && names(part).any(|name| name == body.name);
            let part = *parts.iter().find(is_here)?;
            along.push((part, names(part).position(|name| name == body.name)?));
        }
        sources.push(along);
    }
    let from = parts.iter().map(|part| start(part)).fold(f64::NEG_INFINITY, f64::max);
    let until = parts.iter().map(|part| end(part)).fold(f64::INFINITY, f64::min);
    let finest = parts.iter().max_by_key(|part| part.record.impacts.len())?;
    for instant in instants(finest, from, until) {
        whole.record.moments.push(moment(parts, &sources, instant)?);
    }
    for part in parts {
        let place = whole.axes.iter().position(|axis| part.axes.contains(axis))?;
        let spread = |value: f64| (0..whole.axes.len()).map(|axis| if axis == place { value } else { 0.0 }).collect();
        for wall in &part.record.walls {
            let normal = spread(wall.normal.first().copied()?);
            whole.record.walls.push(RecordedWall { normal, ..wall.clone() });
        }
        for impact in &part.record.impacts {
            let impact = RecordedImpact { impulse: spread(impact.impulse.first().copied()?), ..impact.clone() };
            add(&mut whole.record.impacts, impact);
        }
    }
    whole.record.impacts.sort_by(|one, other| one.time.total_cmp(&other.time));
    Some(whole)
}

/// Adds an impact; what happens between the same bodies at the same time is one impact.
fn add(all: &mut Vec<RecordedImpact>, impact: RecordedImpact) {
    let turned = impact.contact.split_once('-').map(|(one, other)| format!("{other}-{one}"));
    let same = all.iter_mut().find(|other| {
        other.time.total_cmp(&impact.time).is_eq()
            && (other.contact == impact.contact || Some(&other.contact) == turned.as_ref())
    });
    let Some(other) = same else { return all.push(impact) };
    let sign = if other.contact == impact.contact { 1.0 } else { -1.0 };
    for (sum, part) in other.impulse.iter_mut().zip(&impact.impulse) {
        *sum += sign * part;
    }
    other.energy_before += impact.energy_before;
    other.energy_after += impact.energy_after;
}

fn instants(film: &Film, from: f64, until: f64) -> Vec<Instant> {
    let times: Vec<f64> = film.record.moments.iter().map(|moment| moment.time.clamp(from, until)).collect();
    let mut all: Vec<Instant> = Vec::new();
    for time in times {
        let again = all.last().is_some_and(|(last, _)| last.total_cmp(&time).is_eq());
        all.push((time, again));
    }
    all.dedup();
    all
}

/// A value of a film at an instant, between two moments on the line that joins them.
fn at(film: &Film, (time, after): Instant, value: &dyn Fn(&Moment) -> f64) -> Option<f64> {
    let moments = &film.record.moments;
    let next = moments.partition_point(|moment| moment.time < time || after && moment.time <= time);
    // Just after an instant counts what stands at it last; just before it, what stands at it first.
    let exact = if after { next.checked_sub(1).and_then(|last| moments.get(last)) } else { moments.get(next) };
    if let Some(moment) = exact.filter(|moment| moment.time.total_cmp(&time).is_eq()) {
        return Some(value(moment));
    }
    match (next.checked_sub(1).and_then(|last| moments.get(last)), moments.get(next)) {
        (Some(one), Some(other)) => {
            let share = (time - one.time) / (other.time - one.time);
            Some(value(one) + share * (value(other) - value(one)))
        }
        (one, other) => one.or(other).map(value),
    }
}

fn moment(parts: &[&Film], sources: &[Vec<(&Film, usize)>], instant: Instant) -> Option<Moment> {
    let sum = |value: &dyn Fn(&Moment) -> f64| parts.iter().map(|part| at(part, instant, value)).sum::<Option<f64>>();
    let vectors = |value: &dyn Fn(&Moment, usize) -> f64| -> Option<Vec<Vec<f64>>> {
        let of_body = |along: &Vec<(&Film, usize)>| {
            along.iter().map(|(part, body)| at(part, instant, &|moment| value(moment, *body))).collect()
        };
        sources.iter().map(of_body).collect()
    };
    let first = |vectors: &[Vec<f64>], body: usize| {
        vectors.get(body).and_then(|velocity| velocity.first()).copied().unwrap_or(f64::NAN)
    };
    let positions = vectors(&|moment, body| first(&moment.positions, body))?;
    let velocities = vectors(&|moment, body| first(&moment.velocities, body))?;
    let masses: Vec<f64> = vectors(&|moment, body| moment.masses.get(body).copied().unwrap_or(f64::NAN))?
        .iter()
        .map(|velocity| velocity.first().copied().unwrap_or(f64::NAN))
        .collect();
    let count = sources.first().map_or(0, Vec::len);
    let weighed = |vectors: &[Vec<f64>]| -> Vec<f64> {
        let along = |axis: usize| {
            masses.iter().zip(vectors).map(|(mass, velocity)| mass * velocity.get(axis).unwrap_or(&0.0)).sum()
        };
        (0..count).map(along).collect()
    };
    let total: f64 = masses.iter().sum();
    let mut outside = vec![0.0; count];
    let axes: Vec<&str> = sources.first()?.iter().filter_map(|(part, _)| letters(part).next()).collect();
    for part in parts {
        let place = axes.iter().position(|letter| letters(part).next() == Some(letter))?;
        *outside.get_mut(place)? += at(part, instant, &|moment| moment.outside.first().copied().unwrap_or(0.0))?;
    }
    Some(Moment {
        time: instant.0,
        centre: weighed(&positions).into_iter().map(|sum| sum / total).collect(),
        momentum: weighed(&velocities),
        outside,
        kinetic: sum(&|moment| moment.kinetic)?,
        potential: sum(&|moment| moment.potential)?,
        lost: sum(&|moment| moment.lost)?,
        work: sum(&|moment| moment.work)?,
        masses,
        positions,
        velocities,
    })
}
