//! Filling an author's text: how a quantity is said in a sentence.

use momentous_expr::Leaf;
use momentous_expr::LeafKind;
use momentous_expr::Symbol;
use momentous_model::Name;
use momentous_model::PrintedGraph;
use momentous_quantity::Decimal;
use momentous_quantity::Printed;
use momentous_quantity::Unit;
use momentous_quantity::with_minus_signs;
use momentous_scene::Senses;

use super::super::compiling::planned::Problem;
use super::super::language::given::Given;
use super::super::language::text::Filter;
use super::super::language::text::Piece;
use super::super::language::text::Placeholder;
use super::super::language::text::Text;
use super::sense::senses_of;
use super::variant::Variant;
use super::variant::Worked;

/// Verbs after which only "at 2 m/s to the right" may follow: stem, and its endings.
const VERBS_OF_MOTION: &[(&str, &[&str])] = &[
    ("mov", &["e", "es", "ed", "ing"]),
    ("travel", &["", "s", "led", "ling"]),
    ("slid", &["e", "es", "ing"]),
    ("roll", &["", "s", "ed", "ing"]),
    ("run", &["", "s", "ning"]),
    ("fl", &["y", "ies", "ying"]),
    ("go", &["es", "ing"]),
    ("glid", &["e", "es", "ing"]),
    ("drift", &["", "s", "ed", "ing"]),
    ("walk", &["", "s", "ing"]),
    ("skat", &["e", "es", "ing"]),
    ("driv", &["e", "es", "ing"]),
    ("com", &["e", "es", "ing"]),
    ("rebound", &["", "s"]),
    ("leav", &["e", "es", "ing"]),
    ("arriv", &["e", "es", "ing"]),
    ("approach", &["es", "ing"]),
    ("ris", &["e", "es", "ing"]),
    ("fall", &["", "s", "ing"]),
    ("coast", &["", "s", "ing"]),
    ("sail", &["", "s", "ing"]),
    ("swim", &["", "s", "ming"]),
    ("spin", &["s", "ning"]),
    ("thrown", &[""]),
    ("kicked", &[""]),
    ("launched", &[""]),
    ("fired", &[""]),
];

/// Marks that end a clause, after which a new verb is needed.
const CLAUSE_ENDS: &[char] = &['.', ';', ':', '!', '?', '\n'];
/// Words that begin a new clause behind a comma.
const CLAUSE_STARTS: &[&str] = &["and", "but", "while", "whereas", "when", "so"];
/// Words that begin a clause with a verb of its own wherever they stand.
const SUBORDINATORS: &[&str] = &["which", "who", "while", "whereas", "when", "until"];
/// Words of several bodies, after which the verb is a plural: `both`, `the two of them together`.
const PLURALS: &[&str] = &["they", "both", "together", "two", "three"];
/// Words of one of several bodies.
const SINGULARS: &[&str] = &["each", "it", "everything", "one"];
/// Words straight after which a verb must follow.
const CONJUNCTIONS: &[&str] = &["and", "but", "or", "then"];

/// The text with every placeholder said for this variant.
pub(crate) fn fill(text: &Text, problem: &Problem, variant: &Variant) -> String {
    fill_and_mark(text, problem, variant).0
}

/// The same, with the place at which each piece of the text ends in it.
pub(crate) fn fill_and_mark(text: &Text, problem: &Problem, variant: &Variant) -> (String, Vec<usize>) {
    let mut filled = String::new();
    let mut ends = Vec::with_capacity(text.pieces().len());
    for piece in text.pieces() {
        match piece {
            Piece::Text(words) => filled.push_str(words),
            Piece::Placeholder(placeholder) => {
                let said = problem.model().symbol_of(&placeholder.name).map(|symbol| {
                    let speaker = Speaker { problem, variant, symbol, name: &placeholder.name };
                    speaker.say(placeholder.filter, &filled)
                });
                filled.push_str(&said.unwrap_or_else(|| placeholder.name.clone()));
            }
        }
        ends.push(filled.len());
    }
    (filled, ends)
}

impl Variant {
    /// The story and the question of its form, placeholders filled in.
    #[must_use]
    pub fn text(&self, problem: &Problem) -> String {
        let story = fill(&problem.loaded().draft.text, problem, self);
        let question = problem.forms().get(self.form).map(|form| fill(&form.question.text, problem, self));
        match question.filter(|question| !question.trim().is_empty()) {
            Some(question) => format!("{}\n\n{}", story.trim_end(), question.trim()),
            None => story.trim_end().to_owned(),
        }
    }

    /// The author's words to a student who made the mistake of that name, placeholders filled in.
    #[must_use]
    pub fn feedback(&self, problem: &Problem, mistake: &str) -> Option<String> {
        let text = problem.loaded().draft.feedback.get(mistake)?;
        Some(fill(text, problem, self).trim().to_owned())
    }

    /// The hints of its form, placeholders filled in.
    #[must_use]
    pub fn hints(&self, problem: &Problem) -> Vec<String> {
        let hints = problem.forms().get(self.form).into_iter().flat_map(|form| &form.question.hints);
        hints.map(|(_, hint)| fill(hint, problem, self)).collect()
    }

    /// The quantities whose sizes the story and the question of its form print.
    fn told_in_words<'p>(&self, problem: &'p Problem) -> Vec<(&'p str, Symbol)> {
        let question = problem.forms().get(self.form()).map(|form| &form.question.text);
        let texts = [&problem.loaded().draft.text].into_iter().chain(question);
        let tells =
            |placeholder: &&Placeholder| placeholder.filter.tells_size() || placeholder.filter == Filter::Motion;
        (texts.flat_map(Text::placeholders).filter(tells))
            .filter_map(|placeholder| Some((placeholder.name.as_str(), problem.model().symbol_of(&placeholder.name)?)))
            .collect()
    }

    /// Whether a printed number only says what follows from others that are printed.
    #[must_use]
    pub fn follows_from_printed(&self, problem: &Problem, name: &str) -> bool {
        let told = self.told_in_words(problem);
        let is_literal = |symbol: &Symbol| problem.model().literals.iter().any(|(literal, _)| literal == symbol);
        let is_told = |symbol: &Symbol| is_literal(symbol) || told.iter().any(|(_, said)| said == symbol);
        let is_derived = problem.loaded().given.get(name).is_some_and(Given::is_derived);
        let symbol = problem.model().symbol_of(name).filter(|_| is_derived);
        let stated = symbol.and_then(|symbol| problem.model().stated(symbol));
        stated.is_some_and(|stated| stated.symbols().iter().all(is_told))
    }

    /// The numbers that the story and the question of its form print, each once by the name of its quantity, as they would be
    /// typed: what is written as a calculation is left out.
    #[must_use]
    pub fn printed_numbers(&self, problem: &Problem) -> Vec<(String, String)> {
        let mut numbers: Vec<(String, String)> = Vec::new();
        for (name, symbol) in self.told_in_words(problem) {
            let speaker = Speaker { problem, variant: self, symbol, name };
            if speaker.constant().is_none() && numbers.iter().all(|(listed, _)| listed != name) {
                let (Some(value), unit) = (self.printed_value(problem, symbol), self.unit(problem, symbol)) else {
                    continue;
                };
                let typed = Printed::written(&value).plain().replace(" × 10^", "e");
                numbers.push((name.to_owned(), format!("{typed} {unit}").trim_end().to_owned()));
            }
        }
        let graph = problem.model().graph.iter().flat_map(PrintedGraph::symbols);
        for (symbol, (value, unit)) in graph.filter_map(|symbol| Some((symbol, self.given(symbol)?))) {
            let name = &problem.model().symbols.entry(symbol).name;
            if numbers.iter().all(|(listed, _)| listed != name) {
                numbers.push((name.clone(), format!("{value} {unit}").trim_end().to_owned()));
            }
        }
        numbers
    }
}

/// Says one quantity.
struct Speaker<'a> {
    problem: &'a Problem,
    variant: &'a Variant,
    symbol: Symbol,
    name: &'a str,
}

impl Speaker<'_> {
    fn say(&self, filter: Filter, before: &str) -> String {
        if let (Some(constant), true) = (self.constant(), filter.tells_size()) {
            return match filter {
                Filter::Named => format!("{} = {constant}", self.in_symbols()),
                _ => constant,
            };
        }
        let unit = self.variant.unit(self.problem, self.symbol);
        let value = self.variant.printed_value(self.problem, self.symbol);
        match (filter, value) {
            (Filter::Unit, _) => unit.to_string(),
            (Filter::Symbol, _) | (_, None) => self.in_symbols(),
            (Filter::Quantity, Some(value)) => quantity(&value, &unit),
            (Filter::Value, Some(value)) => number(&value),
            (Filter::Magnitude, Some(value)) => quantity(&value.abs(), &unit),
            (Filter::Direction, Some(value)) => self.direction(&value),
            (Filter::Motion, Some(value)) => self.motion(&value, &unit, before),
            (Filter::Named, Some(value)) => format!("{} = {}", self.in_symbols(), quantity(&value, &unit)),
        }
    }

    fn in_symbols(&self) -> String {
        format!("${}$", self.problem.math_of(self.symbol).latex())
    }

    /// A number that is given as a calculation, as `1/3` or `atan(3/4)`: it is printed as it is written, since its decimals would be
    /// rounded. So is an expression of what may be anything, which has no value.
    fn constant(&self) -> Option<String> {
        let form = self.problem.forms().get(self.variant.form());
        let is_changed = form.is_some_and(|form| form.question.given.get(self.name).is_some());
        if form.is_some_and(|form| form.by_formula.contains(&self.symbol)) {
            return self.formula();
        }
        let given = self.problem.loaded().given.get(self.name).filter(|_| !is_changed)?;
        match given.constant() {
            Some(written) => Some(with_minus_signs(written)),
            None if given.is_derived() && self.problem.model().stated(self.symbol)?.symbols().is_empty() => {
                self.formula()
            }
            None => None,
        }
    }

    /// The expression by which it is given, typeset; a pure number that the sheet tells without a name stands in it as a number.
    fn formula(&self) -> Option<String> {
        let worked = Worked::new(self.problem, self.variant)?;
        let told = |symbol| {
            worked.form.known.iter().find(|known| known.symbol == symbol).and_then(|known| worked.told_as_number(known))
        };
        let expression = self.problem.model().stated(self.symbol)?.substitute(&told);
        let named = |symbol| Leaf { math: self.problem.math_of(symbol), kind: LeafKind::Name };
        Some(format!("${}$", expression.layout(&named).latex()))
    }

    fn senses(&self) -> Option<Senses> {
        senses_of(&self.problem.loaded().draft.scene, self.name)
    }

    /// Whether the body whose quantity it is has a plural as its name.
    fn moves_as_several(&self) -> bool {
        Name::parse(self.name).is_some_and(|name| self.problem.loaded().draft.scene.is_several(&name.subject))
    }

    fn direction(&self, value: &Decimal) -> String {
        let Some(senses) = self.senses() else { return String::new() };
        if value.is_negative() { senses.negative } else { senses.positive }
    }

    fn motion(&self, value: &Decimal, unit: &Unit, before: &str) -> String {
        let last = before.split(|letter: char| !letter.is_alphabetic()).rfind(|word| !word.is_empty());
        let says = |words: &[&str]| last.is_some_and(|last| words.contains(&last.to_lowercase().as_str()));
        let is_plural = says(PLURALS) || self.moves_as_several() && !says(SINGULARS);
        let [is, moves] = if is_plural { ["are", "move"] } else { ["is", "moves"] };
        if value.is_zero() {
            return format!("{is} at rest");
        }
        let speed = quantity(&value.abs(), unit);
        let how = match self.direction(value) {
            direction if direction.is_empty() => format!("at {speed}"),
            direction => format!("at {speed} {direction}"),
        };
        if has_verb_of_motion(before) { how } else { format!("{moves} {how}") }
    }
}

/// Whether the clause that is being written already has a verb of motion.
fn has_verb_of_motion(before: &str) -> bool {
    let ends = |(at, letter): &(usize, char)| {
        let rest = &before[at + letter.len_utf8()..];
        // A point inside a number does not end a clause.
        let stops = CLAUSE_ENDS.contains(letter) && rest.chars().next().is_none_or(char::is_whitespace);
        let first = rest.split_whitespace().next().unwrap_or_default();
        stops || *letter == ',' && CLAUSE_STARTS.contains(&first)
    };
    let clause =
        before.char_indices().rev().find(ends).map_or(before, |(at, letter)| &before[at + letter.len_utf8()..]);
    let is_verb = |word: &str| {
        let word = word.to_lowercase();
        VERBS_OF_MOTION.iter().any(|(stem, ends)| word.strip_prefix(stem).is_some_and(|end| ends.contains(&end)))
    };
    let words = clause.split(|letter: char| !letter.is_alphabetic()).filter(|word| !word.is_empty());
    let mut last_first = words.rev().peekable();
    if last_first.peek().is_some_and(|last| CONJUNCTIONS.contains(last)) {
        return false;
    }
    last_first.take_while(|word| !SUBORDINATORS.contains(word)).any(is_verb)
}

/// A number as it stands in a sentence.
#[must_use]
pub fn number(value: &Decimal) -> String {
    Printed::written(value).in_a_sentence()
}

/// A value with its unit as it stands in a sentence; a no-break space keeps them together.
#[must_use]
pub fn quantity(value: &Decimal, unit: &Unit) -> String {
    let number = number(value);
    match (unit.is_none(), unit.is_attached()) {
        (true, _) => number,
        (false, true) => format!("{number}{}", unit.unicode()),
        (false, false) => format!("{number}\u{a0}{}", unit.unicode()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_clause_with_a_verb_of_motion_needs_no_other() {
        assert!(has_verb_of_motion("Cart A (2.5 kg) moves along a level track "));
        assert!(!has_verb_of_motion("Cart A moves at 2 m/s to the right; cart B (3 kg) "));
        assert!(!has_verb_of_motion("They collide. Afterwards cart A "));
        assert!(!has_verb_of_motion("Car A moves at 2 m/s to the right, and in front of it car B "));
        assert!(!has_verb_of_motion("A goods wagon B "));
        assert!(!has_verb_of_motion("Cart A moves at 2 m/s ahead and hits cart B, which "));
        assert!(!has_verb_of_motion("Cart A moves at 2 m/s ahead towards cart B which "));
        assert!(!has_verb_of_motion("At the end it leaves the spring and "));
        assert!(has_verb_of_motion("Cart A hits cart B, which rolls "));
        assert!(has_verb_of_motion("It leaves the strings "));
        assert!(!has_verb_of_motion("At the end of the push it "));
    }

    #[test]
    fn numbers_read_as_in_print() {
        let said = |text: &str, unit: &str| quantity(&Decimal::parse(text).unwrap(), &Unit::parse(unit).unwrap());
        assert_eq!(said("2.0", "kg"), "2.0\u{a0}kg");
        assert_eq!(said("0.0", "m"), "0\u{a0}m");
        assert_eq!(said("-0.70", ""), "\u{2212}0.70");
        assert_eq!(said("30", "deg"), "30°");
    }
}
