//! The masses of bodies, as they are from one instant to another.

use momentous_expr::Expr;
use momentous_fault::Path;
use momentous_quantity::Dimension;
use momentous_scene::Stage;
use momentous_scene::Term;
use momentous_scene::stage::StageMass;

use super::Builder;
use super::Name;
use super::QuantityKind;
use super::name::is_bare_name;

impl Builder<'_> {
    /// The mass of a body when the stage begins that is being written.
    pub(super) fn mass(&mut self, body: &str) -> Expr {
        self.mass_at(body, self.begins)
    }

    /// The mass of a body at an instant; of a union, the sum of its parts.
    pub(super) fn mass_at(&mut self, body: &str, instant: usize) -> Expr {
        let told = self.scene.stage_mass(body, instant);
        if let Some(StageMass::Burn { stage, side, term }) = told {
            return self.burning_mass(stage, body, side, term);
        }
        let parts = self.parts_of(body);
        if !parts.is_empty() {
            let masses: Vec<Expr> = parts.iter().map(|part| self.mass_at(part, instant)).collect();
            return Expr::sum(masses);
        }
        if let Some(StageMass::Since(since)) = told {
            let meaning = format!("the mass of {} {}", self.called(body), self.when(since));
            return self.positive(Name::of(QuantityKind::Mass, body).at(since), meaning).into();
        }
        let whole_time = self.scene.stage_mass(body, self.timeline.last()).is_none();
        let at_first = if whole_time { String::new() } else { format!(" {}", self.when(1)) };
        let meaning = format!("the mass of {}{at_first}", self.called(body));
        let term = self.scene.bodies.get(body).and_then(|entry| entry.mass.clone());
        match term {
            Some(term) => {
                let path = Path::root().key("scene").key("bodies").key(body).key("mass");
                self.read_positive(&term, Dimension::MASS, &meaning, &path)
            }
            None if !self.given.contains(&format!("m_{body}")) && !self.scene.division_of(body).is_empty() => {
                let scene = self.scene;
                Expr::sum(
                    scene.division_of(body).into_iter().map(|part| self.mass_at(part, instant)).collect::<Vec<_>>(),
                )
            }
            None => self.positive(Name::of(QuantityKind::Mass, body), meaning).into(),
        }
    }

    /// The mass of a body at the start of a burn (0) or at its end (1), as the burn says it.
    pub(super) fn burning_mass(&mut self, stage: usize, body: &str, side: usize, term: &Term) -> Expr {
        let meaning = format!("the mass of {} {}", self.called(body), self.when(stage + 1 + side));
        let at = Path::root().key("scene").key("stages").index(stage).key("thrust").key("mass");
        let both =
            matches!(self.scene.stages.get(stage), Some(Stage::Thrust(thrust)) if thrust.mass.at_end().is_some());
        self.read_positive(term, Dimension::MASS, &meaning, &if both { at.index(side) } else { at })
    }

    /// Makes the masses that are names of their own, where another mass is given in terms of them: `m` before `2*m`.
    pub(super) fn masses_by_name(&mut self) {
        let scene = self.scene;
        let is_name = |term: &Term| is_bare_name(term.0.trim());
        let masses = || scene.bodies.iter().filter_map(|(body, entry)| Some((body, entry.mass.as_ref()?)));
        if masses().any(|(_, term)| !is_name(term)) {
            for (body, _) in masses().filter(|(_, term)| is_name(term)) {
                self.mass_at(body, 1);
            }
        }
    }
}
