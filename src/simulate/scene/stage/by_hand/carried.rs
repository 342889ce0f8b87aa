//! A body that rises or sinks on another one: momentum, and energy as that of the relative motion with the reduced mass, by hand.

use super::row::{RIGHT, Row};

pub(super) const CARRIED: &[Row] = &[
    (
        RIGHT,
        r#"{"slide":{"body":"A","on":"B","height":"h","way":"up","until":"together"}}"#,
        "m_A 1, m_B 3, v_A1 4, v_B1 0",
        "h 0.6, v_A2 1, v_B2 1",
    ),
    (
        RIGHT,
        r#"{"slide":{"body":"A","on":"B","height":"0.6 m","direction":"to the left"}}"#,
        "m_A 1, m_B 3, v_A1 1, v_B1 1",
        "v_A2 -2, v_B2 2",
    ),
    (
        RIGHT,
        r#"{"slide":{"body":"A","on":"B","height":"0.45 m","way":"up"}}"#,
        "m_A 1, m_B 3, v_A1 4, v_B1 0",
        "v_A2 2.5, v_B2 0.5",
    ),
    (
        RIGHT,
        r#"{"slide":{"body":"A","on":"B","height":"0.45 m"}}"#,
        "m_A 1, m_B 3, v_A1 2.5, v_B1 0.5",
        "v_A2 4, v_B2 0",
    ),
    (
        RIGHT,
        r#"{"swing":{"body":"A","on":"B","length":"1.2 m"}}"#,
        "m_A 1, m_B 3, v_A1 4, v_B1 0",
        "h_A 0.6, angle_A2 1.0471975511965976, tension_A1 23.333333333333332, v_A2 1, v_B2 1",
    ),
    (
        RIGHT,
        r#"{"swing":{"body":"A","on":"B","radius":"0.6 m","from":"90 deg"}}"#,
        "m_A 1, m_B 3, v_A1 0, v_B1 0",
        "v_A2 3, v_B2 -1, N_A2 36.666666666666664",
    ),
];
