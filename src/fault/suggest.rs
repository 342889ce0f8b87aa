//! "Did you mean": the known name nearest to one that is not known, and what is said of such a name.

/// The candidate nearest to `name`, where one is near enough to be meant.
///
/// ```
/// use momentous_fault::did_you_mean;
/// assert_eq!(did_you_mean("resitution", ["between", "restitution"]), Some("restitution"));
/// assert_eq!(did_you_mean("m_b", ["m_A", "m_B"]), Some("m_B"));
/// assert_eq!(did_you_mean("w", ["x", "y"]), None);
/// assert_eq!(did_you_mean("mass", ["between", "restitution"]), None);
/// ```
pub fn did_you_mean<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let length = name.chars().count();
    let most = 1 + length / 4;
    // The distance is at least the difference of the lengths; one that is far is not compared letter by letter.
    let may_be_near = |candidate: &&str| candidate.chars().count().abs_diff(length) <= most;
    // Of names equally far, the one that differs in capital letters alone is nearer.
    let near = |candidate: &'a str| {
        (strsim::damerau_levenshtein(name, candidate), !name.eq_ignore_ascii_case(candidate), candidate)
    };
    let (distance, _, best) = candidates.into_iter().filter(may_be_near).map(near).min()?;
    (distance <= most && distance < length).then_some(best)
}

/// Says of an unknown name which known one is nearest, or lists them all.
///
/// ```
/// use momentous_fault::unknown_name;
/// let said = unknown_name("v_A", "part of this question", &["v_A2", "T"]);
/// assert_eq!(said, "`v_A` is not a part of this question\nhelp: did you mean `v_A2`?");
/// ```
#[must_use]
pub fn unknown_name(name: &str, what: &str, known: &[&str]) -> String {
    let help = match did_you_mean(name, known.iter().copied()) {
        Some(near) => format!("did you mean `{near}`?"),
        None if known.is_empty() => "there are none".to_owned(),
        None => format!("choose one of {}", known.join(", ")),
    };
    format!("`{name}` is not a {what}\nhelp: {help}")
}
