//! Impulses and losses of single bounces, which exist because somebody mentions them: `J_1`, `J_n`, `T_lost_1`, `T_lost_n`; and
//! the loss in all of them, `T_lost`.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_laws::Law;
use momentous_laws::bouncing;

use super::Builder;
use super::Instant;
use super::Name;
use super::QuantityKind;
use super::bounce_terms::BounceTerms;
use super::wording::counted;

impl Builder<'_> {
    /// The bounces of the stage that a name says, or the only ones.
    fn bouncing_of(&self, name: &Name) -> Option<BounceTerms> {
        let is_meant = |bouncing: &&BounceTerms| name.stage.is_none() || self.stage_label(bouncing.stage) == name.stage;
        let mut all = self.bounce_terms.iter().filter(is_meant);
        let only = all.next()?;
        all.next().is_none().then(|| only.clone())
    }

    /// Which bounce a name says: its number, and the words for it.
    fn bounce_named(name: &Name, bouncing: &BounceTerms) -> Option<(Expr, String)> {
        match (name.subject.as_str(), &name.instant) {
            ("", Some(Instant::Number(number))) if *number > 0 => {
                let number = (i64::try_from(*number).ok()?, counted(*number, "bounce"));
                Some((Expr::integer(number.0), number.1))
            }
            ("n", None) => Some((bouncing.count.clone()?, "the n-th bounce".to_owned())),
            _ => None,
        }
    }

    /// A quantity of one bounce by a law, under the name as it is written.
    fn of_a_bounce(
        &mut self,
        name: &Name,
        bouncing: &BounceTerms,
        what: &str,
        (law, because, value): (&'static Law, &str, Expr),
    ) -> Symbol {
        let meaning =
            format!("{what} {}", Self::bounce_named(name, bouncing).map_or_else(String::new, |(_, words)| words));
        let symbol = self.positive(name.clone(), meaning);
        self.law(law, Some(bouncing.stage), because, (symbol.into(), value));
        symbol
    }

    /// The impulse of the floor in one bounce.
    pub(super) fn impulse_of_a_bounce(&mut self, name: &Name) -> Option<Symbol> {
        let bouncing = self.bouncing_of(name).filter(|_| name.component.is_none())?;
        let (number, _) = Self::bounce_named(name, &bouncing)?;
        let (mass, body) = (self.mass(&bouncing.body), self.called(&bouncing.body));
        let value = bouncing::bounce_impulse(&mass, &bouncing.e, &number, &bouncing.squared.clone().sqrt());
        let because = format!(
            "the bounces before have multiplied the speed of {body} by e each, and this one stops {body} and sends it back with e times the speed with which it came"
        );
        let what = format!("the impulse on {body} in");
        Some(self.of_a_bounce(name, &bouncing, &what, (&bouncing::BOUNCE_IMPULSE, &because, value)))
    }

    /// The kinetic energy lost in one bounce.
    pub(super) fn loss_of_a_bounce(&mut self, name: &Name) -> Option<Symbol> {
        let bouncing = self.bouncing_of(name)?;
        let (number, _) = Self::bounce_named(name, &bouncing)?;
        let mass = self.mass(&bouncing.body);
        let value = bouncing::bounce_loss(&mass, &bouncing.e, &number, &bouncing.squared);
        let because = "each bounce multiplies the speed by e, hence the kinetic energy of the motion towards the floor by the square of e";
        Some(self.of_a_bounce(name, &bouncing, "the kinetic energy lost in", (&bouncing::BOUNCE_LOSS, because, value)))
    }

    /// The kinetic energy lost in all bounces of a stage.
    pub(super) fn loss_in_all_bounces(&mut self, stage: usize) -> Option<Symbol> {
        let bouncing = self.bounce_terms.iter().find(|bouncing| bouncing.stage == stage)?.clone();
        let (mass, body) = (self.mass(&bouncing.body), self.called(&bouncing.body));
        let symbol =
            self.positive(self.in_stage(QuantityKind::EnergyLost, "", stage), "the kinetic energy lost in all bounces");
        let because = format!("at the end of all bounces {body} no longer moves towards the floor or away from it");
        let value = bouncing::loss_in_all(&mass, &bouncing.squared);
        self.law(&bouncing::BOUNCE_LOSS, Some(stage), because, (symbol.into(), value));
        Some(symbol)
    }
}
