//! Problem files: their language, how they are read, and how their numbers are drawn.

mod compiling;
mod consequences;
mod language;
mod questions;
mod reading;
mod sampling;

pub use compiling::ad_hoc::{ad_hoc, typed};
pub use compiling::compile::{compile, compile_ad_hoc};
pub use compiling::form_cache::FormCache;
pub use compiling::planned::{Form as PlannedForm, Problem, Reveal};
pub use compiling::regimes::{Dead, Leaf, Regimes};
pub use consequences::follow::{Candidate, Consequence};
pub use consequences::mistakes::Mistake;
pub use consequences::simulated::Simulated;
pub use language::allowed::Meant;
pub use language::ask::{
    Answered, Ask, AskedRoots, Choose, Classifiable, Classify, Conservable, Conserved, Count, Enough, Find, Holds,
    Impulsive, Order, Pictures, Range, Turn, WhichRoot,
};
pub use language::comparison::split_relation;
pub use language::course::CourseSymbols;
pub use language::domain::{Domain, Grid};
pub use language::draft::{Draft, Expect, Form, Level, Relation, Roots, Units};
pub use language::entries::Entries;
pub use language::form::Question;
pub use language::given::{ChoiceEntry, Given, GivenEntry, RangeEntry, ValueEntry};
pub use language::known::{Known, Origin};
pub use language::literal::Literal;
pub use language::rubric::{Keep, OtherUnits, Rubric, Writing};
pub use language::settings::Course;
pub use language::text::{Filter, Piece, Placeholder, Text, is_name};
pub use questions::curve::Curve;
pub use questions::decision::{ChoicePart, Claim, Decision, OptionFeedback, orders};
pub use questions::diagram::{Balance, Diagram};
pub use questions::equality::Closeness;
pub use questions::formula::FormulaPart;
pub use questions::graph::{Graph, Plotted};
pub use questions::judgement::Judgement;
pub use questions::offered::Offer;
pub use questions::part::{AskedUnit, NumberPart, Part, PartKind};
pub use questions::pictured::{Picture, Pictured, Shows, Subject};
pub use questions::range::{End, Interval, RangePart, Trial};
pub use questions::vector::VectorPart;
pub use reading::document::{Document, Entry, Kind, Node, Scalar, Style};
pub use reading::load::{Loaded, digest, load};
pub use reading::position::Index;
pub use reading::schema::{course_schema, json_schema};
pub use sampling::no_variant::{MOST_ATTEMPTS, NoVariant, Rejection};
pub use sampling::rounding::Judged;
pub use sampling::sampler::Sampler;
pub use sampling::samples::Sample;
pub use sampling::say::quantity as say_quantity;
pub use sampling::secret::{is_guessable, secret_mark};
pub use sampling::sign::Sign;
pub use sampling::stream::{Scheme, Streams, Words};
pub use sampling::variant::{Variant, Worked};
