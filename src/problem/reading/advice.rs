//! Keys that authors try for what is written otherwise, and how it is written.

/// The keys, and what to write in their place.
const ADVICE: &[(&[&str], &str)] = &[
    (
        &["greatest", "least", "maximum", "minimum", "maximise", "minimise"],
        "state in a relation what holds there, and ask for both quantities: `relations: [ { equation: \"m_B^2 = m_A*m_C\", because: the derivative is zero there } ]`",
    ),
    (
        &["limit", "tends_to"],
        "ask for the formula, `as: formula`, or for the limit as a choice: `choose: What is the velocity, if $m_B$ is very large?`",
    ),
    (
        &["scene", "stages", "bodies"],
        "all forms share the scene of the file: a history of its own is a problem of its own",
    ),
    (&["gravity", "g"], "give it under `given`: `g: 9.81 m/s^2`"),
];

/// What to write in place of a key that there is not.
pub(super) fn advice(key: &str) -> Option<&'static str> {
    ADVICE.iter().find(|(keys, _)| keys.contains(&key)).map(|(_, advice)| *advice)
}
