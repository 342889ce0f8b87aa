//! Pushes and motions against a resistance, and what comes out of them by hand.

use super::row::{BOTH, RIGHT, Row, SPACE, UP};

/// Rows like those of all other stages.
pub(super) const PUSHES: &[Row] = &[
    (
        RIGHT,
        r#"{"push":{"body":"A","during":["0 s","3 s"],"forces":[{"value":"10*t*1 N/s"},{"friction":{"static":0.5,"kinetic":0.4}}]}}"#,
        "m_A 2",
        "t_start 1, v_A2 12",
    ),
    (
        UP,
        r#"{"push":{"body":"A","over":"d","direction":"downwards","until":"rest","forces":[{"value":"100 N","direction":"upwards"}]}}"#,
        "m_A 2, v_A1 -5",
        "d 0.3125, dt 0.125",
    ),
    (
        RIGHT,
        r#"{"push":{"body":"A","during":"2 s","forces":[{"value":"3*t^2*1 N/s^2"}]}}"#,
        "m_A 4, v_A1 1",
        "v_A2 3, J_A 8",
    ),
    (
        RIGHT,
        r#"{"push":{"body":"A","over":"d","until":"rest","resistance":{"linear":"1.5 kg/s"},"forces":[]}}"#,
        "m_A 2, v_A1 3",
        "d 4, v_A2 0, w 0",
    ),
    (
        UP,
        r#"{"push":{"body":"A","during":"2 s","resistance":{"linear":"1 kg/s"},"forces":[]}}"#,
        "m_A 2, v_A1 0",
        "v_A2 -12.64241117657115, w -20",
    ),
    (
        RIGHT,
        r#"{"push":{"body":"A","during":"4 s","gains":{"name":"the sand","flow":"1 kg/s"},"forces":[]}}"#,
        "m_A 2, v_A1 3, r_A1 1",
        "v_A2 1, m_A2 6, r_A2 7.591673732008658, a_A1 -1.5, F_A2 0, J_A 0",
    ),
    (
        RIGHT,
        r#"{"push":{"body":"A","gains":{"name":"the sand","flow":"1 kg/s","mass":"4 kg","velocity":"1 m/s"},"forces":[{"value":"2 N"}]}}"#,
        "m_A 2, v_A1 0",
        "v_A2 2, dt 4, a_A1 1.5, J_A 8",
    ),
    (
        RIGHT,
        r#"{"push":{"body":"A","during":"4 s","loses":{"name":"the sand","flow":"0.5 kg/s"},"forces":[{"value":"1 N"}]}}"#,
        "m_A 4, v_A1 1, r_A1 0",
        "v_A2 2.386294361119891, m_A2 2, r_A2 6.454822555520437, a_A2 0.5",
    ),
    (
        RIGHT,
        r#"{"push":{"body":"A","until":"rest","gains":{"name":"the sand","flow":"1 kg/s"},"forces":[{"value":"3 N","direction":"to the left"}]}}"#,
        "m_A 2, v_A1 3",
        "dt 2, m_A2 4, v_A2 0",
    ),
    (
        SPACE,
        r#"{"push":{"body":"A","during":"2 s","forces":[{"value":{"x":"6 N","y":"3*t*1 N/s"}}]}}"#,
        "m_A 2, v_A1.x 1, v_A1.y 0, v_A1.z 4, r_A1.x 1, r_A1.y 2, r_A1.z 3",
        "v_A2.x 7, v_A2.y 3, v_A2.z -16, J_A.z -40, H_rate_O1.x -40, H_rate_O1.y 38, H_rate_O1.z -12",
    ),
    (
        BOTH,
        r#"{"push":{"bodies":["A","B"],"during":"2 s","forces":[{"on":"A","value":"6 N"},{"on":"B","value":{"x":"-1 N","y":"3*t*1 N/s"}}]}}"#,
        "m_A 2, m_B 3, v_A1.x 1, v_A1.y 0, v_B1.x 0, v_B1.y 1, r_A1.x 1, r_A1.y 2, r_B1.x 3, r_B1.y 4",
        "v_A2.x 7, v_B2.y -17, J.x 10, J.y -94, J_B.y -54, H_rate_O1 -118, p_rate_1.x 5, p_rate_2.y -44",
    ),
    (
        BOTH,
        r#"{"flight":{"body":"A","until":"top","resistance":{"linear":"1 kg/s"}}}"#,
        "m_A 5, v_A1.x 20, v_A1.y 30, r_A1.x 0, r_A1.y 0",
        "dt 2.3500181462286776, v_A2.x 12.5, r_A2.x 37.5, w.y -50",
    ),
];
