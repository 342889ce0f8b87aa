//! Ways under steady forces, which a body has to go through to the end.

use crate::Builder;
use crate::Reason;
use momentous_expr::Expr;
use momentous_solve::Relation;

impl Builder<'_> {
    /// Requires that steady forces leave a body some kinetic energy over its whole way, also where nobody asks how fast it is at the end.
    pub(super) fn goes_the_whole_way(&mut self, name: &str, start: Expr, works: impl IntoIterator<Item = Expr>) {
        let left = Expr::sum([start].into_iter().chain(works));
        self.require(left, Relation::AtLeast, Expr::zero(), Reason::TurnsBack(name.to_owned()));
    }
}
