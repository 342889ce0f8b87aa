//! "Did you mean": the known name nearest to one that is not known.

/// The candidate nearest to `name`, where one is near enough to be meant.
///
/// ```
/// use momentous::fault::did_you_mean;
/// assert_eq!(did_you_mean("resitution", ["between", "restitution"]), Some("restitution"));
/// assert_eq!(did_you_mean("w", ["x", "y"]), None);
/// assert_eq!(did_you_mean("mass", ["between", "restitution"]), None);
/// ```
pub fn did_you_mean<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let near = |candidate: &'a str| (strsim::damerau_levenshtein(name, candidate), candidate);
    let (distance, best) = candidates.into_iter().map(near).min()?;
    let length = name.chars().count();
    (distance <= 1 + length / 4 && distance < length).then_some(best)
}
