//! Directions of a scene on the drawing.

use std::f64::consts::FRAC_PI_2;

use momentous_figure::AxisMark;
use momentous_scene::Axis;
use momentous_scene::Scene;
use momentous_scene::Senses;

use super::oblique::Oblique;

/// Words with a direction on paper, in quarter turns from the right, counter-clockwise.
const QUARTERS: &[(&str, u8)] = &[
    ("to the right", 0),
    ("east", 0),
    ("upwards", 1),
    ("north", 1),
    ("to the left", 2),
    ("west", 2),
    ("downwards", 3),
    ("south", 3),
];

/// By how much a cosine may differ from 1, or a part from 0, along an axis.
const ALIGNED: f64 = 1e-9;

/// The directions of x and y (radial and transverse, for polar axes) on the drawing.
#[derive(Clone, Debug)]
pub(in super::super) struct Compass {
    x: [f64; 2],
    y: [f64; 2],
    named: Vec<(Axis, Senses, u8)>,
    /// By how much the axes are turned from what their words say, for a motion along a slope.
    tilt: f64,
    /// The axes of a scene in space; its vectors come as they lie on paper.
    oblique: Option<Oblique>,
}

impl Compass {
    /// Axes whose words have no direction on paper are laid at 90 degrees to the other one; x goes to the right.
    pub(in super::super) fn of(scene: &Scene) -> Self {
        let axes = scene.axes.rectangular();
        if let Some(oblique) = Oblique::of(&axes) {
            let named = axes.into_iter().map(|(axis, senses)| (axis, senses, 0)).collect();
            return Self { named, oblique: Some(oblique), ..Self::paper() };
        }
        let words = |position: usize| axes.get(position).and_then(|(_, senses)| quarter(senses));
        let single = axes.len() == 1;
        let (x, y) = match &axes[..] {
            [(Axis::Y, _)] => (0, words(0).unwrap_or(1)),
            _ => match (words(0), words(1)) {
                (Some(x), Some(y)) if x % 2 != y % 2 => (x, y),
                // On a single level axis up stays up, whichever way it points.
                (Some(x), _) if single && x % 2 == 0 => (x, 1),
                (None, Some(y)) => ((y + 3) % 4, y),
                (x, _) => (x.unwrap_or(0), (x.unwrap_or(0) + 1) % 4),
            },
        };
        let place = |position: usize, axis: Axis| if position == 1 || single && axis == Axis::Y { y } else { x };
        let named =
            axes.into_iter().enumerate().map(|(position, (axis, senses))| (axis, senses, place(position, axis)));
        Self { x: unit(x), y: unit(y), named: named.collect(), tilt: 0.0, oblique: None }
    }

    /// The same axes, x rising along a slope of that angle.
    pub(super) fn tilted(&self, rise: f64) -> Self {
        let tilt = if self.x[0] < 0.0 { -rise } else { rise };
        let [x, y] = [self.x, self.y].map(|axis| turned(axis, tilt));
        Self { x, y, named: self.named.clone(), tilt: self.tilt + tilt, oblique: self.oblique.clone() }
    }

    /// The directions of the paper itself, for bodies each of which has an axis of its own.
    pub(super) fn paper() -> Self {
        let senses = |positive: &str, negative: &str| Senses { positive: positive.into(), negative: negative.into() };
        let named =
            vec![(Axis::X, senses("to the right", "to the left"), 0), (Axis::Y, senses("upwards", "downwards"), 1)];
        Self { x: unit(0), y: unit(1), named, tilt: 0.0, oblique: None }
    }

    /// Whether three axes lie on the drawing, so that no direction on it is one of the scene.
    pub(super) fn is_oblique(&self) -> bool {
        self.oblique.is_some()
    }

    /// A vector along x and y as one of the drawing.
    pub(super) fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [x * self.x[0] + y * self.y[0], x * self.x[1] + y * self.y[1]]
    }

    /// The angle on the drawing of a vector along x and y.
    pub(super) fn angle(&self, vector: [f64; 2]) -> f64 {
        let [right, up] = self.place(vector);
        libm::atan2(up, right)
    }

    /// The axes to be named in a figure.
    pub(super) fn marks(&self) -> Vec<AxisMark> {
        if let Some(oblique) = &self.oblique {
            let marks = self.named.iter().zip(oblique.units());
            return marks.map(|((axis, ..), unit)| AxisMark::along(axis.letter(), unit)).collect();
        }
        self.named
            .iter()
            .map(|(axis, _, quarter)| AxisMark::new(axis.letter(), radians(*quarter) + self.tilt))
            .collect()
    }

    /// The angle on the drawing of the axis of that position.
    pub(super) fn axis_angle(&self, position: usize) -> f64 {
        self.named.get(position).map_or(0.0, |(_, _, quarter)| radians(*quarter) + self.tilt)
    }

    /// A direction in words: `to the right`; `at 34.2\u{b0} to the x axis, towards +y` where it lies along no axis.
    pub(super) fn words(&self, vector: [f64; 2]) -> String {
        let size = libm::hypot(vector[0], vector[1]);
        let [right, up] = self.place(vector);
        let aligned = self.named.iter().find_map(|(_, senses, quarter)| {
            let axis = turned(unit(*quarter), self.tilt);
            let cosine = (axis[0] * right + axis[1] * up) / size;
            let sense = if cosine > 0.0 { &senses.positive } else { &senses.negative };
            (cosine.abs() > 1.0 - ALIGNED).then(|| sense.clone())
        });
        if let Some(words) = aligned {
            return words;
        }
        if let [_, (axis, ..)] = &self.named[..] {
            let degrees = libm::acos((vector[0] / size).clamp(-1.0, 1.0)).to_degrees();
            let sign = if vector[1] < 0.0 { "-" } else { "+" };
            return format!("at {degrees:.1}\u{b0} to the x axis, towards {sign}{}", axis.letter());
        }
        let vertical = if up < 0.0 { "downwards" } else { "upwards" };
        if right.abs() < ALIGNED * size { vertical.to_owned() } else { format!("slanting {vertical}") }
    }
}

fn quarter(senses: &Senses) -> Option<u8> {
    let find = |phrase: &str| QUARTERS.iter().find(|(words, _)| *words == phrase).map(|(_, quarter)| *quarter);
    find(&senses.positive).or_else(|| find(&senses.negative).map(|opposite| (opposite + 2) % 4))
}

fn unit(quarter: u8) -> [f64; 2] {
    match quarter % 4 {
        0 => [1.0, 0.0],
        1 => [0.0, 1.0],
        2 => [-1.0, 0.0],
        _ => [0.0, -1.0],
    }
}

/// A vector turned counter-clockwise.
fn turned([x, y]: [f64; 2], angle: f64) -> [f64; 2] {
    let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
    [x * cosine - y * sine, x * sine + y * cosine]
}

fn radians(quarter: u8) -> f64 {
    FRAC_PI_2 * f64::from(quarter)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;
    use momentous_scene::Axes;
    use momentous_scene::Plane;
    use momentous_scene::Sense;

    /// The directions of x and y, in degrees.
    fn angles(axes: &[(Axis, &str)]) -> [String; 2] {
        let axes = axes.iter().map(|(axis, words)| (*axis, Sense::Positive((*words).to_owned()))).collect();
        let compass = Compass::of(&Scene {
            axes: Axes::Rectangular(axes),
            plane: Plane::Horizontal,
            bodies: BTreeMap::new(),
            surfaces: BTreeMap::new(),
            points: BTreeMap::new(),
            stages: Vec::new(),
            instants: Vec::new(),
        });
        [[1.0, 0.0], [0.0, 1.0]].map(|axis| format!("{:.0}", compass.angle(axis).to_degrees()))
    }

    #[test]
    fn axes_point_where_their_words_say() {
        use Axis::{X, Y};
        assert_eq!(angles(&[(X, "to the left")]), ["180", "90"]);
        assert_eq!(angles(&[(Y, "downwards")]), ["0", "-90"]);
        assert_eq!(angles(&[(X, "east"), (Y, "north")]), ["0", "90"]);
        assert_eq!(angles(&[(X, "south"), (Y, "east")]), ["-90", "0"]);
    }

    #[test]
    fn an_axis_of_unknown_direction_stands_at_right_angles_to_the_other() {
        use Axis::{X, Y};
        assert_eq!(angles(&[(X, "along the rail")]), ["0", "90"]);
        assert_eq!(angles(&[(X, "towards the wall"), (Y, "to the left")]), ["90", "180"]);
        assert_eq!(angles(&[(X, "to the left"), (Y, "into the page")]), ["180", "-90"]);
    }
}
