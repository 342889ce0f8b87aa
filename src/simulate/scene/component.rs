//! The components of positions and velocities, and where each points on a page.

use momentous_scene::{Axis, Plane, Scene};

use super::values::Values;
use super::vector::{Vector, part};

/// To the right and upwards on the page.
const RIGHT: [f64; 2] = [1.0, 0.0];
const UP: [f64; 2] = [0.0, 1.0];
/// Away from the reader where what is drawn has three axes: aslant, and shortened.
const AWAY: [f64; 2] = [0.46, 0.34];

/// Words for the positive direction of an axis of a scene with one or two axes, and where they point on a page.
const WORDS: &[(&str, [f64; 2])] = &[
    ("to the right", RIGHT),
    ("east", RIGHT),
    ("to the left", [-1.0, 0.0]),
    ("west", [-1.0, 0.0]),
    ("upwards", UP),
    ("north", UP),
    ("up the page", UP),
    ("away from you", UP),
    ("downwards", [0.0, -1.0]),
    ("south", [0.0, -1.0]),
    ("towards you", [0.0, -1.0]),
];

/// A component of positions and velocities.
#[derive(Clone, Debug, PartialEq)]
pub struct Component {
    /// Its letter: x.
    pub letter: &'static str,
    /// Whether it is the height.
    pub vertical: bool,
    /// Its positive direction, in words; none where the motion has axes of its own.
    pub positive: Option<String>,
    /// The direction of its unit on a page: to the right, and upwards.
    pub on_page: [f64; 2],
}

impl Component {
    /// The component along an axis of a scene.
    ///
    /// ```
    /// use momentous_scene::{Axis, Scene};
    /// use momentous_simulate::scene::Component;
    ///
    /// let scene: Scene = serde_json::from_str(r#"{
    ///     "axes": { "x": "to the left", "y": "towards the net" }, "bodies": { "A": { "name": "the ball" } }
    /// }"#).unwrap();
    /// assert_eq!(Component::along(&scene, Axis::X).on_page, [-1.0, 0.0]);
    /// assert_eq!(Component::along(&scene, Axis::Y).on_page, [0.0, 1.0]);
    /// ```
    #[must_use]
    pub fn along(scene: &Scene, axis: Axis) -> Self {
        let axes = scene.axes.rectangular();
        let words: Vec<&str> = axes.iter().map(|(_, senses)| senses.positive.as_str()).collect();
        let place = axes.iter().position(|(other, _)| *other == axis);
        let positive = place.and_then(|place| words.get(place));
        let steep = positive.is_some_and(|words| ["upwards", "downwards"].contains(words));
        Self {
            letter: axis.letter(),
            vertical: steep && scene.plane == Plane::Vertical,
            positive: positive.map(|words| (*words).to_owned()),
            on_page: place.and_then(|place| on_page(&words).get(place).copied()).unwrap_or(RIGHT),
        }
    }

    /// A component of a motion with axes of its own.
    pub(super) fn of_letter(letter: &'static str, vertical: bool, on_page: [f64; 2]) -> Self {
        Self { letter, vertical, positive: None, on_page }
    }

    /// The only component of a motion on a line of its own.
    #[must_use]
    pub fn only(letter: &'static str) -> Self {
        Self::of_letter(letter, false, RIGHT)
    }
}

/// The axes along which a motion is seen.
#[derive(Clone, Debug)]
pub(super) struct Frame {
    axes: Vec<Axis>,
    pub components: Vec<Component>,
}

impl Frame {
    fn of_components(components: Vec<Component>) -> Self {
        Self { axes: [Axis::X, Axis::Y, Axis::Z][..components.len()].to_vec(), components }
    }

    /// A line of its own.
    pub(super) fn line(letter: &'static str) -> Self {
        Self::of_components(vec![Component::only(letter)])
    }

    /// A plane of its own: across, and in height where it stands upright.
    pub(super) fn plane(upright: bool) -> Self {
        Self::of_components(vec![Component::only("x"), Component::of_letter("y", upright, UP)])
    }

    /// Space, with the height last.
    pub(super) fn upright_space() -> Self {
        Self::of_components(vec![
            Component::only("x"),
            Component::of_letter("y", false, AWAY),
            Component::of_letter("z", true, UP),
        ])
    }

    /// The components of a vector.
    pub(super) fn split(&self, vector: Vector) -> Vec<f64> {
        self.axes.iter().map(|axis| part(vector, *axis)).collect()
    }
}

impl Values<'_> {
    /// The axes of the scene.
    pub(super) fn frame(&self) -> Frame {
        let axes = self.axes();
        Frame { components: axes.iter().map(|axis| Component::along(self.scene, *axis)).collect(), axes }
    }
}

/// The directions on a page of axes with these positive directions.
fn on_page(words: &[&str]) -> Vec<[f64; 2]> {
    if let [_, _, _] = words {
        return in_space(words);
    }
    let said = |words: &str| WORDS.iter().find(|(words_of_unit, _)| *words_of_unit == words).map(|(_, units)| *units);
    let mut units: Vec<Option<[f64; 2]>> = words.iter().map(|words| said(words)).collect();
    if let [first, second] = units.as_mut_slice() {
        let turned = |[x, y]: [f64; 2]| [-y, x];
        match (*first, *second) {
            (None, None) => (*first, *second) = (Some(RIGHT), Some(UP)),
            (None, Some([x, _])) => *first = Some(if x == 0.0 { RIGHT } else { UP }),
            (Some(direction), other) => {
                let across = other.filter(|other| direction[0] * other[0] + direction[1] * other[1] == 0.0);
                *second = across.or(Some(if direction[0] == 0.0 { RIGHT } else { turned([direction[0].abs(), 0.0]) }));
            }
        }
    }
    units.into_iter().map(|units| units.unwrap_or(RIGHT)).collect()
}

/// The same in space, right-handed, with what is upright drawn so.
fn in_space(words: &[&str]) -> Vec<[f64; 2]> {
    let upright = words.iter().position(|words| ["upwards", "downwards"].contains(words)).unwrap_or(2);
    let sign = if words.get(upright) == Some(&"downwards") { -1.0 } else { 1.0 };
    let (up, away) = ([0.0, sign], AWAY.map(|part| sign * part));
    match upright {
        0 => vec![up, RIGHT, away],
        1 => vec![RIGHT, up, away.map(|part| -part)],
        _ => vec![RIGHT, away, up],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_point_where_their_words_say_and_never_along_each_other() {
        let cases: [(&[&str], &[[f64; 2]]); 6] = [
            (&["downwards"], &[[0.0, -1.0]]),
            (&["down the track"], &[RIGHT]),
            (&["to the right", "downwards"], &[RIGHT, [0.0, -1.0]]),
            (&["down the slope", "away from the slope"], &[RIGHT, UP]),
            (&["north", "towards the quay"], &[UP, RIGHT]),
            (&["to the right", "east"], &[RIGHT, UP]),
        ];
        for (words, units) in cases {
            assert_eq!(on_page(words), units, "{words:?}");
        }
        assert_eq!(on_page(&["to the right", "upwards", "towards you"]), [RIGHT, UP, [-0.46, -0.34]]);
    }
}
