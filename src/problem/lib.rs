//! Problem files: their language, how they are read, and how their numbers are drawn.

mod compiling;
mod consequences;
mod deciding;
mod language;
mod questions;
mod reading;
mod sampling;

pub use compiling::ad_hoc::{ad_hoc, typed};
pub use compiling::compile::{compile, compile_ad_hoc};
pub use compiling::form_cache::FormCache;
pub use compiling::on_demand::Sample;
pub use compiling::planned::{Form as PlannedForm, Problem, Reveal};
pub use compiling::regimes::{Dead, Leaf, Regimes};
pub use consequences::follow::{Candidate, Consequence};
pub use consequences::mistake::Mistake;
pub use consequences::simulated::Simulated;
pub use deciding::closeness::Closeness;
pub use deciding::interval::{End, Interval, Trial};
pub use language::allowed::{Meant, NOTED};
pub use language::ask::{
    Answered, Ask, AskedRoots, Choose, Classifiable, Classify, Conservable, Conserved, Count, Enough, Find, Holds,
    Impulsive, Order, Pictures, Range, Turn, WhichRoot,
};
pub use language::comparison::split_relation;
pub use language::course::CourseSymbols;
pub use language::domain::{Domain, Grid};
pub use language::draft::{Draft, Expect, Form, Level, Relation, Roots, USUAL_FIGURES, Units};
pub use language::entries::Entries;
pub use language::form::Question;
pub use language::given::{ChoiceEntry, Given, GivenEntry, RangeEntry, ValueEntry};
pub use language::homework::{HomeworkDraft, SlotDraft};
pub use language::known::{Known, Origin};
pub use language::literal::Literal;
pub use language::rubric::{Keep, OtherUnits, Rubric, Writing};
pub use language::settings::Course;
pub use language::text::{Filter, Piece, Placeholder, Text, is_name};
pub use questions::choices::choice::{ChoicePart, orders};
pub use questions::choices::claim::Claim;
pub use questions::choices::decision::{Decision, OptionFeedback};
pub use questions::choices::judgement::Judgement;
pub use questions::choices::offered::Offer;
pub use questions::part::{AskedUnit, FormulaPart, NumberPart, Part, PartKind, RangePart, VectorPart, part_letter};
pub use questions::pictures::curve::Curve;
pub use questions::pictures::diagram::{Balance, Diagram};
pub use questions::pictures::graph::{Graph, Plotted};
pub use questions::pictures::pictured::{Picture, Pictured, Shows, Subject};
pub use reading::digest::{Digests, digest, is_digest};
pub use reading::document::{Document, Entry, Kind, Mapping, Node, Scalar, Style};
pub use reading::limits::LONGEST_FILE;
pub use reading::load::{Loaded, load};
pub use reading::position::Index;
pub use reading::schema::{course_schema, homework_schema, json_schema};
pub use sampling::issued::PrintedNumber;
pub use sampling::no_variant::{MOST_ATTEMPTS, NoVariant, Rejection};
pub use sampling::rounding::Judged;
pub use sampling::sampler::Sampler;
pub use sampling::say::quantity as say_quantity;
pub use sampling::secret::{guesses, is_guessable, secret_mark};
pub use sampling::sign::Sign;
pub use sampling::stream::{Scheme, Streams, Words};
pub use sampling::variant::{Variant, Worked};
