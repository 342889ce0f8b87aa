//! Rows of a stage by hand.

pub(super) const RIGHT: &str = r#"{"x":"to the right"}"#;
pub(super) const UP: &str = r#"{"y":"upwards"}"#;
pub(super) const UPHILL: &str = r#"{"x":"up the slope"}"#;
pub(super) const BOTH: &str = r#"{"x":"to the right","y":"upwards"}"#;
pub(super) const SLOPE: &str = r#"{"x":"down the slope","y":"away from the slope"}"#;
pub(super) const POLAR: &str = r#""polar""#;
pub(super) const SPACE: &str = r#"{"x":"to the right","y":"away from you","z":"upwards"}"#;

/// Axes, a stage, what is given, and what comes out.
pub(super) type Row = (&'static str, &'static str, &'static str, &'static str);
