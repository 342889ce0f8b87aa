//! What people say behind a value that is no part of it, and counts in words, by closed lists: `298 mm into the target`,
//! `173 N upwards` of a size, `3 bounces`. A word that is in no list is asked back.

use momentous_quantity::Dimension;
use momentous_quantity::Rational;

use super::super::number::Number;
use super::answer::{NumberAnswer, Written};
use super::direction::{self, Phrase};
use super::plain::ENDS;
use super::value::Asked;

/// The most words of a comment.
const MOST_WORDS: usize = 6;
/// Behind any value.
const OF_ALL: [&str; 4] = ["in total", "altogether", "in all", "overall"];
/// Behind a time.
const OF_TIMES: [&str; 9] = [
    "later",
    "afterwards",
    "after release",
    "after the release",
    "after being released",
    "after it is released",
    "after the start",
    "after the impact",
    "after the collision",
];
/// Behind a length.
const OF_LENGTHS: [&str; 22] = [
    "deep",
    "high",
    "long",
    "tall",
    "wide",
    "in depth",
    "in height",
    "in length",
    "above the ground",
    "above the floor",
    "apart",
    "away",
    "lower",
    "less",
    "further",
    "further on",
    "farther",
    "from the start",
    "from where it started",
    "from where it stood",
    "from its start",
    "in diameter",
];
/// Behind an energy.
const OF_ENERGIES: [&str; 5] = ["of energy", "of kinetic energy", "of mechanical energy", "of heat", "as heat"];
/// Behind the size of a vector, which has no direction of its own here.
const OF_SIZES: [&str; 12] = [
    "against the motion",
    "against its motion",
    "opposite to the motion",
    "opposite to its motion",
    "opposing the motion",
    "along the motion",
    "in the direction of motion",
    "in the direction of the motion",
    "in the same direction",
    "same direction",
    "in the opposite direction",
    "opposite direction",
];
/// The dimensions of what never points anywhere.
const WITHOUT_DIRECTION: [Dimension; 4] = [Dimension::NONE, Dimension::ENERGY, Dimension::TIME, Dimension::MASS];
/// Points of the compass between its sides, of a vector whose size is asked.
const BETWEEN_SIDES: [&str; 12] = [
    "north-east",
    "northeast",
    "ne",
    "north-west",
    "northwest",
    "nw",
    "south-east",
    "southeast",
    "se",
    "south-west",
    "southwest",
    "sw",
];
/// The ways along which one moves.
const ALONG: [&str; 12] =
    ["track", "road", "floor", "ice", "table", "slope", "ramp", "ground", "bench", "rail", "rails", "line"];
/// The things into which one gets.
const INTO: [&str; 14] = [
    "target", "ground", "soil", "earth", "sand", "snow", "clay", "mud", "wood", "block", "straw", "gel", "wall",
    "material",
];
/// The things that are counted.
const COUNTED: [&str; 17] = [
    "bounce",
    "bounces",
    "rebound",
    "rebounds",
    "impact",
    "impacts",
    "collision",
    "collisions",
    "hit",
    "hits",
    "jump",
    "jumps",
    "throw",
    "throws",
    "time",
    "times",
    "x",
];
/// Before what is counted by its place.
const BEFORE_PLACES: [&str; 4] = ["after", "the", "on", "at"];
/// Small whole numbers, from nothing on.
const NUMBERS: [&str; 13] =
    ["zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"];
/// The same by their places.
const PLACES: [&str; 13] = [
    "zeroth", "first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth",
    "eleventh", "twelfth",
];
/// How a place ends that is written with digits.
const ENDS_OF_PLACES: [&str; 4] = ["st", "nd", "rd", "th"];

/// The end of the value before a comment, and the direction that it says of a size.
pub(super) fn start<'t>(text: &'t str, asked: Asked<'_>) -> Option<(usize, Option<&'t str>)> {
    let text = text.trim_end_matches(ENDS);
    let starts: Vec<usize> = text.match_indices(' ').map(|(at, _)| at).collect();
    // The longest comment counts.
    let from = starts.len().saturating_sub(MOST_WORDS);
    starts[from..].iter().copied().find_map(|at| {
        let comment = text[at..].trim_matches([' ', '(', ')', ',', '.', ';']);
        let direction = Some(comment).filter(|comment| says_direction_of_size(comment, asked));
        (direction.is_some() || says_nothing(comment, asked)).then_some((at, direction))
    })
}

fn says_nothing(comment: &str, asked: Asked<'_>) -> bool {
    let lower = comment.to_lowercase();
    let is = |words: &[&str]| words.contains(&lower.as_str());
    let dimension = asked.unit.dimension();
    let into = || lower.strip_prefix("into the ").is_some_and(|what| INTO.contains(&what));
    let along = || lower.strip_prefix("along the ").is_some_and(|what| ALONG.contains(&what));
    is(&OF_ALL)
        || dimension == Dimension::TIME && is(&OF_TIMES)
        || dimension == Dimension::ENERGY && is(&OF_ENERGIES)
        || dimension == Dimension::LENGTH && asked.senses.is_none() && (is(&OF_LENGTHS) || into())
        || dimension != Dimension::NONE && asked.senses.is_none() && along()
}

/// Whether a comment is a direction where only a size is asked for.
fn says_direction_of_size(comment: &str, asked: Asked<'_>) -> bool {
    let has_direction = !WITHOUT_DIRECTION.contains(&asked.unit.dimension());
    asked.senses.is_none()
        && asked.in_space.is_none()
        && has_direction
        && (OF_SIZES.contains(&comment.to_lowercase().as_str())
            || is_between_sides(comment)
            || !direction::is_compass_letter(comment) && direction::read(comment, None, None) == Phrase::Other)
}

fn is_between_sides(comment: &str) -> bool {
    let lower = comment.to_lowercase();
    let point = lower.strip_prefix("to the ").or_else(|| lower.strip_prefix("towards the ")).unwrap_or(&lower);
    BETWEEN_SIDES.contains(&point)
}

/// A count with its word, or in words: `3 bounces`, `three`, `after the 3rd bounce`.
pub(super) fn counted(text: &str, asked: Asked<'_>) -> Option<NumberAnswer> {
    if !asked.unit.is_none() {
        return None;
    }
    let lower = text.to_lowercase();
    let mut words = lower.split_whitespace().skip_while(|word| BEFORE_PLACES.contains(word));
    let (number, noun) = (words.next()?, words.next());
    let in_words = || NUMBERS.iter().chain(&PLACES).position(|word| *word == number).map(|place| place % NUMBERS.len());
    let mut ends_of_numbers = ENDS_OF_PLACES.iter().chain(&["x", "×"]);
    let digits = ends_of_numbers.find_map(|end| number.strip_suffix(end)).unwrap_or(number);
    let is_written = digits.len() <= 6 && !digits.is_empty() && digits.bytes().all(|next| next.is_ascii_digit());
    let count = if is_written { digits.parse::<usize>().ok() } else { in_words() }?;
    // `9 bounces on the bench`
    let place: Vec<&str> = words.collect();
    let is_place = place.is_empty() || matches!(place[..], ["on" | "off" | "against", "the", _]);
    let ends = is_place && noun.is_none_or(|noun| COUNTED.contains(&noun));
    ends.then(|| NumberAnswer {
        number: Number::exact(Rational::from(count)),
        written: Written::Computed,
        signed: false,
        unit: None,
        pounds_as_mass: false,
        sense: None,
        heading: None,
        unjudged: None,
    })
}
