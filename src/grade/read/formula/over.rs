//! `\over`: a fraction bar through the whole group in which it stands.

use super::super::unreadable::{At, UnreadableKind};
use super::grammar::{Grammar, Term};
use super::token::Token;

impl Grammar<'_> {
    /// A sum, or two with `\over` between them. Outside braces that bar is also typed for a plain one.
    pub(super) fn group(&mut self, braced: bool) -> At<Term> {
        let start = self.mark();
        let above = self.sum()?;
        let at = self.at();
        if !self.take(&Token::WholeOver) {
            return Ok(above);
        }
        self.part()?;
        let below = self.sum()?.value;
        if below.is_zero() {
            return Err((at, UnreadableKind::Undefined));
        }
        let whole = above.value / below;
        if !braced {
            self.back_to(start);
            self.plain_bars = true;
            let plain = self.sum()?.value;
            self.plain_bars = false;
            if plain != whole {
                return self.two_readings(at, [&plain, &whole]);
            }
        }
        Ok(Term::of(whole))
    }
}
