//! The marks of points and the colours of curves.

/// The shape of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mark {
    Disc,
    Square,
    Diamond,
    Triangle,
    Cross,
    Star,
}

impl Mark {
    /// Its outline about the current point, as SVG path data.
    pub(super) fn path(self) -> &'static str {
        match self {
            Self::Disc => "m-3.2 0a3.2 3.2 0 1 0 6.4 0a3.2 3.2 0 1 0 -6.4 0z",
            Self::Square => "m-3 -3h6v6h-6z",
            Self::Diamond => "m0 -4.2l4.2 4.2l-4.2 4.2l-4.2 -4.2z",
            Self::Triangle => "m0 -4l4 7h-8z",
            Self::Cross => "m-1.2 -4h2.4v2.8h2.8v2.4h-2.8v2.8h-2.4v-2.8h-2.8v-2.4h2.8z",
            Self::Star => "m0 -6.5l1.8 4.7l4.7 1.8l-4.7 1.8l-1.8 4.7l-1.8 -4.7l-4.7 -1.8l4.7 -1.8z",
        }
    }
}

/// The colours of curves on light and on dark pages.
pub(super) const COLOURS: [(&str, &str); 10] = [
    ("#111111", "#ffffff"),
    ("#8a5a00", "#e0b050"),
    ("#006b4f", "#35c99c"),
    ("#0060b0", "#5fb4ff"),
    ("#c02020", "#ff7b72"),
    ("#b0449a", "#f08fdc"),
    ("#b85a00", "#ff9d3c"),
    ("#5f5f70", "#b5b5c8"),
    ("#6640c0", "#b79cff"),
    ("#5a7a00", "#b4d84a"),
];
