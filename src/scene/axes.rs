//! Axes and the words for their directions.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;

/// The axes of a scene.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Axes {
    /// The word `polar`: radius and transverse direction about a point.
    Polar(Polar),
    /// Rectangular axes, each with where it points.
    #[schemars(extend("propertyNames" = { "enum": ["x", "y", "z"] }))]
    Rectangular(BTreeMap<Axis, Sense>),
}

/// The word `polar`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Polar {
    /// Radius and transverse direction.
    Polar,
}

/// A component of a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Axis {
    /// The first rectangular axis.
    X,
    /// The second rectangular axis.
    Y,
    /// The third rectangular axis.
    Z,
}

impl Axis {
    /// The axis as it stands in names, after the point.
    #[must_use]
    pub fn letter(self) -> &'static str {
        match self {
            Self::X => "x",
            Self::Y => "y",
            Self::Z => "z",
        }
    }
}

/// Where an axis points: one phrase (`to the right`), or two where the opposite is not known to us (`[uphill, downhill]`).
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Sense {
    /// The positive direction.
    Positive(String),
    /// The positive and the negative direction.
    Both([String; 2]),
}

/// Adverbial phrases for the two directions of an axis: "moves to the right", "moves to the left".
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Senses {
    /// Along the axis.
    pub positive: String,
    /// Against the axis.
    pub negative: String,
}

/// Words for a direction, how it is said, and the word for its opposite.
const OPPOSITES: &[(&str, &str, &str, &str)] = &[
    ("right", "to the right", "left", "to the left"),
    ("east", "east", "west", "west"),
    ("north", "north", "south", "south"),
    ("up", "upwards", "down", "downwards"),
    ("upwards", "upwards", "downwards", "downwards"),
    ("forwards", "forwards", "backwards", "backwards"),
    ("forward", "forwards", "backward", "backwards"),
    ("up the slope", "up the slope", "down the slope", "down the slope"),
    ("up the incline", "up the incline", "down the incline", "down the incline"),
    ("uphill", "uphill", "downhill", "downhill"),
    ("ahead", "ahead", "back", "back"),
    ("along the track", "forwards along the track", "back along the track", "back along the track"),
    ("along the floor", "forwards along the floor", "back along the floor", "back along the floor"),
];

/// The two senses of a turn, which are no directions of a straight axis; counter-clockwise is positive where nothing else is said.
const TURNING: [&str; 2] = ["counter-clockwise", "clockwise"];

impl Senses {
    /// The senses of a turn, counter-clockwise positive.
    #[must_use]
    pub fn of_a_turn() -> Self {
        let [positive, negative] = TURNING.map(str::to_owned);
        Self { positive, negative }
    }

    /// Whether they are the senses of a turn, so that the axis runs along a circle.
    #[must_use]
    pub fn is_of_a_turn(&self) -> bool {
        TURNING.contains(&self.positive.as_str())
    }

    /// Whether the axis points up (1) or down (-1), where it is vertical.
    #[must_use]
    pub fn rise(&self) -> Option<i64> {
        match self.positive.as_str() {
            "upwards" => Some(1),
            "downwards" => Some(-1),
            _ => None,
        }
    }

    /// The direction of the axis, to the right, upwards and towards the reader: those of the four winds lie on the ground, north
    /// away from the reader.
    fn in_space(&self) -> Option<[i64; 3]> {
        Some(match self.positive.as_str() {
            "to the right" | "east" => [1, 0, 0],
            "to the left" | "west" => [-1, 0, 0],
            "upwards" => [0, 1, 0],
            "downwards" => [0, -1, 0],
            "towards you" | "south" => [0, 0, 1],
            "away from you" | "north" => [0, 0, -1],
            _ => return None,
        })
    }

    /// Whether the axis runs up (1) or down (-1) a slope, where its words say so.
    #[must_use]
    pub fn climb(&self) -> Option<i64> {
        let begins = |words: [&str; 2]| words.into_iter().any(|word| self.positive.starts_with(word));
        if begins(["up ", "uphill"]) { Some(1) } else { begins(["down ", "downhill"]).then_some(-1) }
    }
}

impl Sense {
    /// How both directions of the axis are said; unknown phrases are kept, and their opposite is "in the negative x direction".
    ///
    /// ```
    /// use momentous_scene::{Axis, Sense};
    /// let senses = Sense::Positive("to the left".into()).senses(Axis::X);
    /// assert_eq!((senses.positive.as_str(), senses.negative.as_str()), ("to the left", "to the right"));
    /// assert_eq!(Sense::Positive("towards the net".into()).senses(Axis::X).negative, "away from the net");
    /// ```
    #[must_use]
    pub fn senses(&self, axis: Axis) -> Senses {
        let phrase = match self {
            Self::Both([positive, negative]) => {
                return Senses { positive: positive.clone(), negative: negative.clone() };
            }
            Self::Positive(phrase) => phrase.as_str(),
        };
        let word = phrase.trim_start_matches("to the ").trim_start_matches("due ").trim();
        let row = OPPOSITES.iter().find_map(|&(word_a, said_a, word_b, said_b)| {
            if word == word_a || phrase == said_a {
                Some((said_a, said_b))
            } else {
                (word == word_b || phrase == said_b).then_some((said_b, said_a))
            }
        });
        let reversed = |from: &str, to: &str| phrase.strip_prefix(from).map(|target| format!("{to}{target}"));
        match row {
            Some((positive, negative)) => Senses { positive: positive.into(), negative: negative.into() },
            None => {
                let negative = reversed("towards ", "away from ").or_else(|| reversed("away from ", "towards "));
                let negative = negative.unwrap_or_else(|| format!("in the negative {} direction", axis.letter()));
                Senses { positive: phrase.into(), negative }
            }
        }
    }
}

impl Axes {
    /// The rectangular axes in order, with the words for their directions; none for polar axes.
    #[must_use]
    pub fn rectangular(&self) -> Vec<(Axis, Senses)> {
        match self {
            Self::Polar(_) => Vec::new(),
            Self::Rectangular(map) => map.iter().map(|(axis, sense)| (*axis, sense.senses(*axis))).collect(),
        }
    }

    /// The axis along which (1) or against which (-1) words point: `to the left`, `up`, `-x`.
    ///
    /// ```
    /// use momentous_scene::{Axes, Axis};
    /// let axes: Axes = serde_json::from_str(r#"{ "x": "to the right", "y": "upwards" }"#).unwrap();
    /// assert_eq!(axes.pointed("left"), Some((Axis::X, -1)));
    /// assert_eq!(axes.pointed("+y"), Some((Axis::Y, 1)));
    /// assert_eq!(axes.pointed("30 deg above +x"), None);
    /// ```
    #[must_use]
    pub fn pointed(&self, text: &str) -> Option<(Axis, i64)> {
        let text = text.trim();
        self.rectangular().into_iter().find_map(|(axis, senses)| {
            let said = |phrase: &str, sign: char| {
                text == phrase
                    || phrase.strip_prefix("to the ") == Some(text)
                    || phrase.strip_suffix("wards") == Some(text)
                    || text.strip_prefix(sign) == Some(axis.letter())
            };
            if text == axis.letter() || said(&senses.positive, '+') {
                Some((axis, 1))
            } else {
                said(&senses.negative, '-').then_some((axis, -1))
            }
        })
    }

    /// Whether the axes are known to be left-handed: two of a plane where the turn from x to y is clockwise as the plane is usually seen,
    /// from the front or from above, or three in space.
    ///
    /// ```
    /// use momentous_scene::Axes;
    /// let axes = |text: &str| serde_json::from_str::<Axes>(text).unwrap();
    /// assert!(axes(r#"{ "x": "to the right", "y": "downwards" }"#).are_left_handed());
    /// assert!(!axes(r#"{ "x": "to the right", "y": "away from you" }"#).are_left_handed());
    /// assert!(!axes(r#"{ "x": "east", "y": "north" }"#).are_left_handed());
    /// ```
    #[must_use]
    pub fn are_left_handed(&self) -> bool {
        let known: Option<Vec<[i64; 3]>> = self.rectangular().iter().map(|(_, senses)| senses.in_space()).collect();
        let cross = |[a, b, c]: [i64; 3], [d, e, f]: [i64; 3]| [b * f - c * e, c * d - a * f, a * e - b * d];
        match known.as_deref() {
            // Seen from the front, from above, or on a map from the south.
            Some([x, y]) => [[0, 0, -1], [0, -1, 0]].contains(&cross(*x, *y)),
            Some([x, y, z]) => cross(*x, *y).iter().zip(z).map(|(one, other)| one * other).sum::<i64>() < 0,
            _ => false,
        }
    }
}
