//! Of which kind an impact is: elastic, inelastic or perfectly plastic, as the coefficient of restitution of a variant says.

use std::collections::BTreeSet;

use crate::expr::Expr;
use crate::expr::Symbol;
use crate::fault::Code;
use crate::fault::Fault;
use crate::fault::Path;
use crate::laws::wrong::Misconception;
use crate::model::Builder;
use crate::scene::Stage;
use crate::scene::stage::Impact;

use super::ask::Classify;
use super::comparing::to_solve;
use super::concept::Question;
use super::concept::stage;
use super::decision::ChoicePart;
use super::decision::Decision;
use super::decision::compared;
use super::decision::value;
use super::load::Loaded;
use super::part::PartKind;
use super::variant::Worked;

/// The kinds of impact, in the order in which they are offered.
const KINDS: [&str; 3] = ["elastic", "inelastic", "perfectly plastic"];

/// What the coefficient of restitution says of an impact.
#[derive(Clone, Debug)]
pub(super) enum ImpactKind {
    /// The scene says it: one of [`KINDS`].
    Stated(usize),
    /// The coefficient says it, and it may differ from variant to variant.
    Of {
        /// The coefficient.
        restitution: Expr,
        /// What of it is to be solved.
        quantities: Vec<Symbol>,
    },
}

/// A choice that the kind of an impact settles.
#[derive(Clone, Debug)]
pub struct OfImpact {
    kind: ImpactKind,
    /// The phrases.
    options: Vec<String>,
    /// For each kind the position of the right phrase, and why it is right.
    verdicts: [(usize, &'static str); 3],
    /// The mistake that leads to the first phrase where it is wrong.
    behind: Option<&'static Misconception>,
}

impl ImpactKind {
    /// The kind of an impact; faults are those of its coefficient, which the model tells.
    pub(super) fn of(loaded: &Loaded, impact: &Impact, builder: &mut Builder<'_>, path: &Path) -> Self {
        match &impact.restitution {
            _ if impact.plastic => Self::Stated(2),
            _ if impact.elastic => Self::Stated(0),
            Some(term) => {
                let restitution = builder.term(&term.0, path);
                Self::Of { quantities: to_solve(loaded, builder, restitution.symbols()), restitution }
            }
            None => Self::Stated(1),
        }
    }

    /// Whether kinetic energy is conserved, with the mistake that takes it for conserved.
    pub(super) fn keeps_energy(self, behind: Option<&'static Misconception>) -> OfImpact {
        let verdicts = [
            (0, "the impact is elastic (e = 1)"),
            (1, "with e below 1 part of the kinetic energy is lost in the impact"),
            (1, "the bodies stay together, and part of the kinetic energy goes into deforming and heating them"),
        ];
        OfImpact { kind: self, options: ["yes", "no"].map(str::to_owned).to_vec(), verdicts, behind }
    }

    fn classified(self) -> OfImpact {
        let verdicts = [
            (0, "e = 1: no kinetic energy is lost"),
            (1, "e lies between 0 and 1: the bodies separate, and some kinetic energy is lost"),
            (2, "the bodies stay together (e = 0)"),
        ];
        OfImpact { kind: self, options: KINDS.map(str::to_owned).to_vec(), verdicts, behind: None }
    }
}

impl OfImpact {
    /// The quantities that have to be solved for it.
    pub(super) fn quantities(&self) -> &[Symbol] {
        match &self.kind {
            ImpactKind::Of { quantities, .. } => quantities,
            ImpactKind::Stated(_) => &[],
        }
    }

    /// Everything on which it depends.
    pub(super) fn symbols(&self) -> BTreeSet<Symbol> {
        match &self.kind {
            ImpactKind::Of { restitution, .. } => restitution.symbols(),
            ImpactKind::Stated(_) => BTreeSet::new(),
        }
    }

    pub(super) fn decided(&self, worked: &Worked<'_>) -> Decision {
        let kind = match &self.kind {
            ImpactKind::Stated(kind) => *kind,
            ImpactKind::Of { restitution, .. } => {
                let e = value(worked, restitution);
                if compared(e, 1.0).is_eq() {
                    0
                } else if compared(e, 0.0).is_eq() {
                    2
                } else {
                    1
                }
            }
        };
        let (right, because) = self.verdicts[kind.min(2)];
        let behind = self.behind.filter(|_| right != 0);
        Decision { options: self.options.clone(), right, because: because.into(), behind }
    }
}

/// Of which kind an impact is.
pub(super) fn classify(loaded: &Loaded, ask: &Classify, builder: &mut Builder<'_>, path: &Path) -> Option<Question> {
    let index = stage(ask.stage.as_deref(), builder, path)?;
    let Some(Stage::Impact(impact)) = loaded.draft.scene.stages.get(index) else {
        let fault = Fault::new(Code::Value, format!("{} is not an impact", builder.phrase_of(index)));
        builder.fault(fault.help("name a stage that is an impact: `stage: hit`").at_path(path.key("classify")));
        return None;
    };
    let kind = ImpactKind::of(loaded, impact, builder, path);
    let label = format!("Of which kind is {}?", builder.phrase_of(index));
    Some((label, PartKind::Choice(ChoicePart::OfImpact(Box::new(kind.classified())))))
}
