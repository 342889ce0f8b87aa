//! The computed lines of a solution, and the figures with which each can be computed again from what is printed.
//!
//! A quantity is printed in one form throughout a solution: with the usual figures, and with more where a line would otherwise
//! not come out. Lines are looked at from the last to the first, since a result that needs more figures asks more of what it
//! is computed from.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_quantity::first_place;

use super::entry::Entry;
use super::entry::Item;
use super::entry::LAST;

/// The most figures that a value in a solution gets.
const MOST: usize = 8;

/// Numbers below a million are printed without a power of ten, and so to the unit at least.
const LARGEST_PLAIN: i32 = 5;

/// How far beyond half a unit a result may seem to lie because doubles are rounded.
const SLACK: f64 = 1e-7;

/// A share of half a unit: what moves a result by less is not why its line does not come out.
const LITTLE: f64 = 0.1;

/// The number of figures that the numbers of a solution have.
#[derive(Clone, Debug, Default)]
pub(crate) struct Figures {
    pub numbers: Vec<(Item, usize)>,
    /// The results that no number of figures gives.
    pub stubborn: Vec<Item>,
    /// The quantities computed from the givens as they are told, since the steps before have too few figures.
    pub from_givens: Vec<Symbol>,
}

impl Figures {
    /// The figures of a number; none where no line asks for more than the usual ones.
    pub(crate) fn of(&self, item: Item) -> Option<usize> {
        self.numbers.iter().find(|(counted, _)| *counted == item).map(|(_, figures)| *figures)
    }
}

/// How a line computes.
enum Rule {
    /// By a term whose quantities stand in these entries.
    Term(Expr),
    /// By the formula for quadratic equations, with the greater or the smaller root.
    Root { greater: bool },
    /// By another unit.
    Same,
    /// It is compared: the operand is printed as less, or as not greater.
    Above { strictly: bool },
}

struct Line {
    rule: Rule,
    /// The places of what it computes from.
    operands: Vec<usize>,
    result: usize,
}

/// The numbers of a solution and the lines between them.
#[derive(Default)]
pub(crate) struct Ledger {
    entries: Vec<Entry>,
    lines: Vec<Line>,
    /// The place of each quantity that is entered, by its index.
    places: Vec<Option<usize>>,
}

impl Ledger {
    /// Enters a number that is printed exactly.
    pub(crate) fn exact(&mut self, item: Item, value: f64, unit: f64, half: f64) {
        self.enter(Entry::exact(item, value, unit, half));
    }

    /// Enters a number with at least so many figures.
    pub(crate) fn rounded(&mut self, item: Item, value: f64, unit: f64, figures: usize) {
        self.asked(item, value, unit, at_least(figures, value / unit));
    }

    /// Enters a number with that many figures, be they fewer than stand before the point.
    pub(crate) fn asked(&mut self, item: Item, value: f64, unit: f64, figures: usize) {
        self.enter(Entry::rounded(item, value, unit, figures, MOST.max(figures)));
    }

    fn enter(&mut self, entry: Entry) {
        if let Item::Quantity(symbol) = entry.item {
            self.put(symbol, Some(self.entries.len()));
        }
        self.entries.push(entry);
    }

    fn place(&self, item: Item) -> Option<usize> {
        match item {
            Item::Quantity(symbol) => self.places.get(symbol.index()).copied().flatten(),
            item => self.entries.iter().position(|entry| entry.item == item),
        }
    }

    /// Whether a number is entered.
    pub(crate) fn knows(&self, item: Item) -> bool {
        self.place(item).is_some()
    }

    /// A result that is the value of a term of some quantities; nothing where one of them is not entered.
    pub(crate) fn term(&mut self, term: &Expr, mentions: &[Symbol], result: Item) {
        let operands = mentions.iter().map(|symbol| self.place(Item::Quantity(*symbol))).collect();
        self.line(Rule::Term(term.clone()), operands, result);
    }

    /// A root of the quadratic equation of an unknown.
    pub(crate) fn root(&mut self, unknown: Symbol, greater: bool, result: Item) {
        let operands = [0, 1, 2].map(|place| self.place(Item::Coefficient(unknown, place)));
        self.line(Rule::Root { greater }, operands.into_iter().collect(), result);
    }

    /// The same number in another unit, or with other figures.
    pub(crate) fn same(&mut self, item: Item, result: Item) {
        self.line(Rule::Same, self.place(item).map(|place| vec![place]), result);
    }

    /// Two numbers of which the first is said to be less than the second, or not greater.
    pub(crate) fn ordered(&mut self, [low, high]: [Item; 2], strictly: bool) {
        self.line(Rule::Above { strictly }, self.place(low).map(|place| vec![place]), high);
    }

    /// The symbol of a quantity that is printed as another one.
    pub(super) fn alias(&mut self, symbol: Symbol, other: Symbol) {
        let place = self.place(Item::Quantity(other));
        self.put(symbol, place);
    }

    fn put(&mut self, symbol: Symbol, place: Option<usize>) {
        if self.places.len() <= symbol.index() {
            self.places.resize(symbol.index() + 1, None);
        }
        self.places[symbol.index()] = place;
    }

    fn line(&mut self, rule: Rule, operands: Option<Vec<usize>>, result: Item) {
        if let (Some(operands), Some(result)) = (operands, self.place(result)) {
            self.lines.push(Line { rule, operands, result });
        }
    }

    /// Gives results from which only an answer is computed the figures of answers, where those of their operands give no more, or where
    /// with one more they would look half-way between two answers.
    fn lower_last_results(&mut self) {
        for place in 0..self.lines.len() {
            let line = &self.lines[place];
            let is_last = matches!(line.rule, Rule::Term(_) | Rule::Root { .. })
                && self.lines.iter().all(|other| {
                    !other.operands.contains(&line.result)
                        || matches!(other.rule, Rule::Same)
                            && matches!(self.entries[other.result].item, Item::Answer(_))
                            && self.entries[other.result].figures <= LAST
                });
            let is_out = || {
                let shown = |other: &&Line| matches!(other.rule, Rule::Same) && other.operands.contains(&line.result);
                let mut lines = self.lines.iter().filter(shown).chain([line]);
                lines.any(|line| !line.holds(&self.entries, &self.places))
            };
            if is_last && is_out() {
                let result = line.result;
                self.entries[result].lower();
            }
        }
    }

    /// The quantities that are equal, as pairs of places. One that is computed from an equal one would always need more figures.
    fn equals(&self) -> Vec<[usize; 2]> {
        let pairs = (0..self.entries.len()).flat_map(|place| (0..place).map(move |before| [before, place]));
        let are_equal = |[one, other]: &[usize; 2]| self.entries[*one].is_printed_like(&self.entries[*other]);
        let equal: Vec<[usize; 2]> = pairs.filter(are_equal).collect();
        let follows = |[one, other]: &&[usize; 2]| self.comes_from(*one, *other) || self.comes_from(*other, *one);
        let following: Vec<usize> = equal.iter().filter(follows).flatten().copied().collect();
        equal.into_iter().filter(|pair| !pair.iter().any(|place| following.contains(place))).collect()
    }

    /// Whether a number is computed from another one, by however many lines.
    fn comes_from(&self, place: usize, source: usize) -> bool {
        let mut from = vec![place];
        let mut next = 0;
        while let Some(place) = from.get(next).copied() {
            for line in self.lines.iter().filter(|line| line.result == place) {
                let operands = line.operands.iter().filter(|operand| !from.contains(operand));
                let operands: Vec<usize> = operands.copied().collect();
                from.extend(operands);
            }
            next += 1;
        }
        from.contains(&source)
    }

    /// Gives equal quantities the same figures; whether any got more.
    fn print_alike(&mut self, equals: &[[usize; 2]]) -> bool {
        let mut changed = false;
        for [one, other] in equals {
            let most = self.entries[*one].figures.max(self.entries[*other].figures);
            for place in [*one, *other] {
                while self.entries[place].figures < most && self.entries[place].raise() {
                    changed = true;
                }
            }
        }
        changed
    }

    /// Gives every number as many figures as the lines need.
    pub(crate) fn settle(mut self) -> Figures {
        self.lower_last_results();
        let equals = self.equals();
        let mut stubborn = Vec::new();
        let mut changed = true;
        while changed {
            changed = self.print_alike(&equals);
            stubborn.clear();
            for line in self.lines.iter().rev() {
                while !line.holds(&self.entries, &self.places) {
                    if !line.refine(&mut self.entries, &self.places) {
                        stubborn.push(self.entries[line.result].item);
                        break;
                    }
                    changed = true;
                }
            }
        }
        let figures = self.entries.iter().filter(|entry| entry.most > 0).map(|entry| (entry.item, entry.figures));
        Figures { numbers: figures.collect(), stubborn, from_givens: Vec::new() }
    }
}

/// Raises the figures to that number, or to all that stand before the point.
pub(crate) fn at_least(figures: usize, shown: f64) -> usize {
    let place = first_place(shown);
    let before_the_point = usize::try_from(place + 1).unwrap_or(0);
    if place <= LARGEST_PLAIN { figures.max(before_the_point) } else { figures }
}

impl Line {
    /// The value of the line with what is printed, one operand perhaps unrounded.
    fn computed(&self, entries: &[Entry], places: &[Option<usize>], unrounded: Option<usize>) -> f64 {
        let value = |place: usize| {
            let entry = &entries[place];
            if unrounded == Some(place) { entry.value } else { entry.printed }
        };
        match &self.rule {
            Rule::Term(term) => term.evaluate(&|symbol| {
                let place = places.get(symbol.index()).copied().flatten();
                place.map_or(f64::NAN, value)
            }),
            Rule::Root { greater } => {
                let [a, b, c] = [0, 1, 2].map(|place| self.operands.get(place).map_or(f64::NAN, |place| value(*place)));
                let root = (b * b - 4.0 * a * c).sqrt();
                let root = if *greater == (a > 0.0) { root } else { -root };
                (root - b) / (2.0 * a)
            }
            Rule::Same | Rule::Above { .. } => self.operands.first().map_or(f64::NAN, |place| value(*place)),
        }
    }

    fn holds(&self, entries: &[Entry], places: &[Option<usize>]) -> bool {
        let result = &entries[self.result];
        if let Rule::Above { strictly } = self.rule {
            let low = self.computed(entries, places, None);
            return if strictly { low < result.printed } else { low <= result.printed };
        }
        let off = (self.computed(entries, places, None) - result.printed).abs();
        // 2.915 looks as if it were 2.92; only a number that is half-way itself may be rounded either way.
        let is_half_way = |off: f64| off >= result.half * (1.0 - SLACK);
        if let (Rule::Same, [operand]) = (&self.rule, &self.operands[..])
            && is_half_way(off)
            && !is_half_way((entries[*operand].value - result.printed).abs())
        {
            return false;
        }
        off <= result.half * (1.0 + SLACK) + f64::EPSILON * result.value.abs()
    }

    /// One figure more for the operand that moves the result most; for the result itself where it lies close to half-way
    /// between two printed numbers. Whether there was anything to refine.
    fn refine(&self, entries: &mut [Entry], places: &[Option<usize>]) -> bool {
        if matches!(self.rule, Rule::Above { .. }) {
            let mut raised = false;
            for place in self.operands.iter().copied().chain([self.result]) {
                raised |= entries[place].raise();
            }
            return raised;
        }
        let printed = self.computed(entries, places, None);
        let moved = |place: usize| {
            let moved = (printed - self.computed(entries, places, Some(place))).abs();
            if moved.is_nan() { f64::INFINITY } else { moved }
        };
        let rounded = self.operands.iter().copied().filter(|place| entries[*place].most > 0);
        let moving: Vec<(usize, f64)> = rounded.map(|place| (place, moved(place))).collect();
        let total: f64 = moving.iter().map(|(_, moved)| moved).sum();
        let worst = moving.iter().filter(|(place, _)| entries[*place].figures < entries[*place].most);
        let worst = worst.max_by(|one, other| one.1.total_cmp(&other.1)).map(|(place, _)| *place);
        let little = total < LITTLE * entries[self.result].half;
        let is_same = matches!(self.rule, Rule::Same);
        let candidates = if is_same {
            [worst, Some(self.result)]
        } else if little {
            [Some(self.result), worst]
        } else {
            [worst, None]
        };
        candidates.into_iter().flatten().any(|place| entries[place].raise())
    }
}

#[cfg(test)]
mod tests {
    use super::super::entry::FEWEST;
    use super::*;
    use momentous_expr::SymbolEntry;
    use momentous_expr::SymbolTable;
    use momentous_quantity::Dimension;

    /// Enters `c = a - b`, with these values, to the usual figures.
    fn difference(a: f64, b: f64, c: f64) -> ([Item; 3], Figures) {
        let mut table = SymbolTable::default();
        let symbols = ["a", "b", "c"].map(|name| {
            table.intern(SymbolEntry { name: name.into(), dimension: Dimension::NONE, meaning: String::new() })
        });
        let items = symbols.map(Item::Quantity);
        let mut ledger = Ledger::default();
        for (item, value) in items.into_iter().zip([a, b, c]) {
            ledger.rounded(item, value, 1.0, FEWEST);
        }
        let [a, b, _] = symbols;
        ledger.term(&(Expr::from(a) - Expr::from(b)), &[a, b], items[2]);
        (items, ledger.settle())
    }

    #[test]
    fn operands_get_the_figures_that_their_difference_needs() {
        // 222.7611 - 222.75 = 0.0111 to the four figures of 0.01111111, not 222.8 - 222.8.
        let ([a, b, c], figures) = difference(222.761_111_11, 222.75, 0.011_111_11);
        assert_eq!(figures.stubborn, []);
        assert_eq!(figures.of(c), Some(4));
        assert!(figures.of(a) > Some(6) && figures.of(b) < figures.of(a), "{figures:?}");
    }

    #[test]
    fn what_comes_out_keeps_the_usual_figures() {
        let (items, figures) = difference(50.0625, 16.3125, 33.75);
        assert_eq!(items.map(|item| figures.of(item)), [Some(4); 3]);
    }

    #[test]
    fn what_eight_figures_do_not_give_is_told() {
        let ([.., c], figures) = difference(1.000_000_001_234_5, 0.999_999_999, 2.234_5e-9);
        assert_eq!(figures.stubborn, [c]);
    }

    #[test]
    fn no_number_looks_half_way_to_its_answer() {
        // 2.9146 is 2.91, and is not printed as 2.915, which would seem to be 2.92.
        let ([a, ..], _) = difference(2.9146, 0.0, 2.9146);
        let mut ledger = Ledger::default();
        let Item::Quantity(symbol) = a else { panic!("a quantity") };
        ledger.rounded(a, 2.9146, 1.0, FEWEST);
        ledger.asked(Item::Answer(symbol), 2.9146, 1.0, 3);
        ledger.same(a, Item::Answer(symbol));
        let figures = ledger.settle();
        assert_eq!((figures.of(a), figures.of(Item::Answer(symbol))), (Some(5), Some(3)));
    }

    #[test]
    fn what_is_said_to_be_less_is_printed_as_less() {
        let ([a, b, _], _) = difference(1.399_96, 1.4, 0.0);
        let mut ledger = Ledger::default();
        ledger.rounded(a, 1.399_96, 1.0, FEWEST);
        ledger.exact(b, 1.4, 1.0, 0.05);
        ledger.ordered([a, b], true);
        // 1.400 and 1.4000 are not less.
        assert_eq!(ledger.settle().of(a), Some(6));
    }

    #[test]
    fn large_numbers_have_all_figures_before_the_point() {
        assert_eq!([120_060.0, 99.0, 2.5e6].map(|value| at_least(4, value)), [6, 4, 4]);
    }
}
