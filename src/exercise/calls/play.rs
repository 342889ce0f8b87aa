//! Words of a page about a scene beside its animation: how each part was found, its impacts, and plots that stand still.

use serde::Serialize;

use momentous_expr::Math;
use momentous_figure::{ForcePlot, PlotAxis, Role, Wording};
use momentous_scene::Scene;
use momentous_simulate::least::Request;
use momentous_simulate::scene::Component;
use momentous_witness::{AT_ITS_TIME, Film, IMPACTS};

use super::super::Exercise;
use super::limits::Limits;
use super::refused::Refused;
use super::sheet::FigureResponse;
use super::simulate::shot;

/// The column of the table of impacts that names a contact, as `A-B`.
const BETWEEN: usize = 1;

/// The looks of curves, and how a caption calls them.
const LOOKS: [(Role, &str); 4] = [
    (Role::Curve, "the solid curve"),
    (Role::Momentum, "dashed blue"),
    (Role::Impulse, "dashed red"),
    (Role::Velocity, "dashed green"),
];

/// A scene that was simulated, in words.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PlayResponse {
    /// Its parts in order, as they stand in the record that is simulated `together`.
    pub films: Vec<FilmResponse>,
    /// Stages that were not simulated, each with the reason.
    pub nothing: Vec<(usize, &'static str)>,
}

/// A part of a scene that was simulated.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FilmResponse {
    /// The stage, counted from 1.
    pub stage: usize,
    /// Its kind in a word or two.
    pub kind: &'static str,
    /// Which method ran it, and why.
    pub why: String,
    /// The cautions for the reader.
    pub cautions: Vec<String>,
    /// How it ended, where that is not at its time.
    pub ending: Option<String>,
    /// The headings of the table of impacts.
    pub headings: [&'static str; 5],
    /// The table of impacts.
    pub impacts: Vec<Vec<String>>,
    /// How it goes on after the rows of the table; nothing where the table has all.
    pub weak_impacts: Option<String>,
    /// Plots of the positions against time, one for each axis.
    pub plots: Vec<FigureResponse>,
}

impl PlayResponse {
    /// The words about the simulation of a variant, beside its animation.
    ///
    /// # Errors
    /// Where nothing of it can be simulated.
    pub fn of(exercise: &Exercise, limits: &Limits) -> Result<Self, Refused> {
        let shot = shot(exercise, &Request { steps: Some(limits.scene_steps), ..Request::default() })?.together();
        let scene = &exercise.problem().loaded().draft.scene;
        let films = shot.films.iter().map(|film| {
            let bodies: Vec<String> = film.record.bodies.iter().map(|body| scene.called(&body.name)).collect();
            FilmResponse {
                stage: film.stage,
                kind: film.kind(scene),
                why: film.why(),
                cautions: film.cautions(),
                ending: Some(film.ending.clone()).filter(|ending| ending != AT_ITS_TIME),
                headings: IMPACTS,
                impacts: film.impacts().into_iter().map(|row| named(row, scene)).collect(),
                weak_impacts: film.weak_impacts(),
                plots: film.axes.iter().enumerate().map(|(place, axis)| plot(film, &bodies, place, axis)).collect(),
            }
        });
        Ok(Self { films: films.collect(), nothing: shot.nothing.clone() })
    }
}

/// A row of the table of impacts with the bodies as the problem calls them.
fn named(mut row: Vec<String>, scene: &Scene) -> Vec<String> {
    if let Some(contact) = row.get_mut(BETWEEN) {
        let name = |part: &str| if scene.bodies.contains_key(part) { scene.called(part) } else { part.to_owned() };
        *contact = contact.split('-').map(name).collect::<Vec<_>>().join(" and ");
    }
    row
}

/// The places of all bodies along an axis, against time.
fn plot(film: &Film, bodies: &[String], place: usize, axis: &Component) -> FigureResponse {
    let curve = |body: usize| -> Vec<[f64; 2]> {
        let moments = film.record.moments.iter();
        let points = moments.map(|moment| {
            let value = moment.positions.get(body).and_then(|position| position.get(place)).copied();
            [moment.time, value.unwrap_or(f64::NAN)]
        });
        points.collect()
    };
    let named: Vec<String> =
        bodies.iter().zip(LOOKS.iter().cycle()).map(|(body, (_, look))| format!("{body} ({look})")).collect();
    let what = if axis.vertical { "Height" } else { "Position" };
    let positive = axis.positive.as_ref().map_or_else(String::new, |words| format!(", positive {words}"));
    let caption = match bodies {
        [only] => format!("{what} of {only} against time{positive}"),
        _ => format!("{what} against time{positive}: {}", named.join(", ")),
    };
    let symbol = |name: &str| Math::Identifier(name.into());
    let plot = ForcePlot {
        wording: Wording { title: caption.clone(), description: String::new(), caption },
        time: PlotAxis { symbol: symbol("t"), unit: "s".to_owned(), told: Vec::new() },
        force: PlotAxis { symbol: symbol(axis.letter), unit: "m".to_owned(), told: Vec::new() },
        points: curve(0),
        area: None,
        marks: Vec::new(),
    };
    let others = (1..bodies.len()).zip(LOOKS.iter().cycle().skip(1));
    let others: Vec<(Vec<[f64; 2]>, Role)> = others.map(|(body, (role, _))| (curve(body), *role)).collect();
    FigureResponse::of(&plot.beside(&others))
}
