//! One letter has one meaning in a piece of work: the one with which a line held.

use momentous_expr::Expr;
use momentous_expr::Symbol;

use super::found::LineFinding;
use super::judge::Judge;
use super::verdict::Verdict;
use super::written::Written;

impl Judge<'_> {
    /// Whether an earlier line held with a meaning of a short name.
    pub(crate) fn has_meaning(&self, short: Symbol) -> bool {
        self.meant.iter().any(|(known, _)| *known == short)
    }

    /// What a short name stands for: as a line has it, or else as everywhere.
    fn meaning<'m>(&'m self, short: Symbol, instead: &'m [(Symbol, Expr)]) -> Option<&'m Expr> {
        instead.iter().chain(&self.alphabet.short).find(|(known, _)| *known == short).map(|(_, meaning)| meaning)
    }

    /// Keeps what the short names of a line stand for, where it says something of the scene.
    pub(crate) fn keep_meanings(&mut self, found: &LineFinding, line: &Written) {
        if !matches!(found.verdict, Verdict::Follows | Verdict::Answer | Verdict::AsFigures) {
            return;
        }
        for short in &line.shorts {
            if let Some(meaning) = self.meaning(*short, &line.instead).cloned()
                && !self.has_meaning(*short)
            {
                self.meant.push((*short, meaning));
            }
        }
    }

    /// The question about a letter with which a line holds only where it stands for something else than before; `None` where there is none.
    pub(crate) fn meant_otherwise(&self, instead: &[(Symbol, Expr)], line: &Written) -> Option<LineFinding> {
        let changed = self.meant.iter().find(|(short, before)| {
            line.shorts.contains(short) && self.meaning(*short, instead).is_some_and(|meaning| meaning != before)
        });
        let (short, before) = changed?;
        let letter = &self.alphabet.symbols.entry(*short).name;
        let known = self.worked.problem.model().symbols.len();
        let is_of_scene = before.symbols().iter().all(|symbol| symbol.index() < known);
        let before = if is_of_scene { self.text(before, false) } else { "something else".to_owned() };
        let question = format!("`{letter}` stood for {before} before. What does it stand for here?");
        Some(LineFinding::of(Verdict::Unreadable).because(question))
    }
}
