//! Mathematics that stands in many places, with what its writers made of it.

use std::fmt;
use std::sync::Arc;
use std::sync::OnceLock;

use super::Math;

/// Mathematics of which there is one for many documents, and what its writers made of it: each writes it once.
#[derive(Default)]
pub struct Shared {
    math: Math,
    plain: OnceLock<String>,
    latex: OnceLock<String>,
    typst: OnceLock<String>,
    mathml: OnceLock<String>,
    label: OnceLock<String>,
    widths: OnceLock<Vec<f64>>,
    size: OnceLock<[f64; 3]>,
}

impl Shared {
    /// On one line of plain text.
    pub(super) fn plain(&self) -> &str {
        self.plain.get_or_init(|| self.math.plain())
    }

    /// As LaTeX.
    pub(super) fn latex(&self) -> &str {
        self.latex.get_or_init(|| self.math.latex())
    }

    /// As Typst.
    pub(super) fn typst(&self) -> &str {
        self.typst.get_or_init(|| self.math.typst())
    }

    /// As an element of `MathML`.
    pub(super) fn mathml(&self) -> &str {
        self.mathml.get_or_init(|| self.math.element())
    }

    /// As a label of a drawing, written by whoever draws it first.
    pub(crate) fn label(&self, write: impl FnOnce(&Math) -> String) -> &str {
        self.label.get_or_init(|| write(&self.math))
    }

    /// Its size as a label, measured by whoever draws it first.
    pub(crate) fn size(&self, measure: impl FnOnce(&Math) -> [f64; 3]) -> [f64; 3] {
        *self.size.get_or_init(|| measure(&self.math))
    }

    /// The widths of its parts, in widths of a digit.
    pub(crate) fn widths(&self) -> &[f64] {
        self.widths.get_or_init(|| {
            let mut widths = Vec::new();
            self.math.spread(&mut |part| widths.push(part.width()));
            widths
        })
    }
}

/// As the mathematics alone.
impl fmt::Debug for Shared {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.math.fmt(out)
    }
}

impl Math {
    /// The same, to be held in many places and written once.
    #[must_use]
    pub fn shared(self) -> Self {
        match self {
            Self::Shared(_) => self,
            math => Self::Shared(Arc::new(Shared { math, ..Shared::default() })),
        }
    }

    /// What it is, shared or not.
    #[must_use]
    pub fn bare(&self) -> &Self {
        match self {
            Self::Shared(shared) => &shared.math,
            math => math,
        }
    }
}
