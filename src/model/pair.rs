//! Two bodies that pull or push each other along one line: their impulses, and the momentum of both.

use momentous_expr::Expr;
use momentous_fault::Path;
use momentous_laws::momentum;
use momentous_scene::Term;

use super::Agent;
use super::Because;
use super::Builder;
use super::Impulse;
use super::Name;
use super::QuantityKind;

/// Two bodies and their velocities along the line through both, before and after.
pub(super) struct Pair<'a> {
    pub index: usize,
    pub bodies: [&'a str; 2],
    pub before: [Expr; 2],
    pub after: [Expr; 2],
    /// The link between them: `the spring`, `the string`.
    pub link: &'a str,
    /// Along what it acts, by another word.
    pub line: &'a str,
    /// The pulley over which they act on each other, so that their impulses are equal along the string only.
    pub pulley: Option<&'a str>,
}

impl Builder<'_> {
    /// The momentum of both together, and for whoever asks the impulse on each, which it returns. `resolve` gives an impulse's
    /// components along the axes.
    pub(super) fn pair(
        &mut self,
        pair: &Pair<'_>,
        component: Option<&str>,
        resolve: &dyn Fn(&Self, &Expr) -> Vec<Expr>,
        duration: Option<&Term>,
        path: &Path,
    ) -> [Expr; 2] {
        let masses = pair.bodies.map(|body| self.mass(body));
        let names = pair.bodies.map(|body| self.called(body));
        let side = |values: &[Expr; 2]| [0, 1].map(|index| (masses[index].clone(), values[index].clone()));
        let sides = momentum::conservation(&side(&pair.before), &side(&pair.after));
        let [first, second] = &names;
        let (law, because) = match pair.pulley {
            None => (
                &momentum::CONSERVATION,
                Because::Fact(format!(
                    "{} exerts equal and opposite impulses on {first} and {second}, and no other impulse acts along {}",
                    pair.link, pair.line
                )),
            ),
            Some(pulley) => (
                &momentum::IMPULSE_MOMENTUM,
                Because::Conclusion(
                    format!(
                        "{} runs freely over {pulley} and pulls both equally, {first} forwards and {second} back along it",
                        pair.link
                    ),
                    "its impulses cancel in the sum".to_owned(),
                ),
            ),
        };
        self.law(law, Some(pair.index), because, sides);
        let impulses = [0, 1].map(|side| {
            let meaning = format!("the impulse on {} from {}", names[side], pair.link);
            let name = Name::of(QuantityKind::Impulse, pair.bodies[side]).along(component);
            let name = name.during(self.stage_label(pair.index));
            Expr::from(self.symbol(name, meaning))
        });
        for side in [0, 1] {
            let impulse = &impulses[side];
            let because = format!("the only impulse on {} alone is that of {}", names[side], pair.link);
            let [before, after] = [&pair.before[side], &pair.after[side]];
            let sides = momentum::impulse_momentum(&masses[side], before, std::slice::from_ref(impulse), after);
            self.law(&momentum::IMPULSE_MOMENTUM, Some(pair.index), because, sides);
            // In a plane the average force is a magnitude: a string draws the second body back along its line.
            let size = if component.is_some() && side == 1 { -impulse.clone() } else { impulse.clone() };
            self.mean_force(pair.index, pair.bodies[side], &size, duration, path);
            let components = resolve(self, impulse);
            self.impulses.push(Impulse {
                stage: pair.index,
                on: pair.bodies[side].to_owned(),
                by: match pair.pulley {
                    None => Agent::Body(pair.bodies[1 - side].to_owned()),
                    Some(_) => Agent::Outside,
                },
                called: pair.link.to_owned(),
                components,
                impulsive: pair.link == "the string",
            });
        }
        let [on_first, on_second] = impulses.clone();
        let because = format!("{} acts on both with the same force", pair.link);
        self.law(&momentum::THIRD_LAW, Some(pair.index), because, (on_second, -on_first));
        impulses
    }
}
