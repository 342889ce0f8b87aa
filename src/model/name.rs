//! The grammar of names: `v_A1.x`, `T_lost[hit]`, `v_A@top`, `F_avg_A`.

/// A name, taken apart. Which names a scene has is decided elsewhere.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// The kind of quantity: `v`, `speed`, `T_lost`, `F_avg`.
    pub base: String,
    /// Whose: the short name of a body, of a point, or `G` for the centre of mass; empty for the system.
    pub subject: String,
    /// When, where the name says so.
    pub instant: Option<Instant>,
    /// Which component, without the point.
    pub component: Option<String>,
    /// Which stage, without the brackets.
    pub stage: Option<String>,
}

/// When a quantity is taken.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Instant {
    /// Counted from 1.
    Number(usize),
    /// By the name that the author gave it.
    Named(String),
}

/// Bases that contain an underscore themselves, longest first.
const JOINED: &[&str] =
    &["areal_rate", "H_rate", "T_rel", "v_rel", "T_lost", "T_gained", "J_def", "J_rest", "v_common", "F_avg"];

impl Name {
    /// Whether it refers to no body, no instant and no stage, so that authors may use it for anything: `v`, `T`, `v_0`.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        let no_instant = matches!(self.instant, None | Some(Instant::Number(0)));
        let bare = self.subject.is_empty() && self.component.is_none() && self.stage.is_none();
        bare && no_instant && !self.base.contains('_')
    }

    /// Takes a name apart; `None` where it does not follow the grammar.
    ///
    /// ```
    /// use momentous::model::{Instant, Name};
    /// let name = Name::parse("v_A1.x").unwrap();
    /// assert_eq!((name.base.as_str(), name.subject.as_str(), name.instant), ("v", "A", Some(Instant::Number(1))));
    /// assert_eq!(Name::parse("T_lost[hit]").unwrap().stage.as_deref(), Some("hit"));
    /// ```
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let (rest, stage) = match text.split_once('[') {
            Some((rest, stage)) => (rest, Some(stage.strip_suffix(']')?.to_owned())),
            None => (text, None),
        };
        let (rest, named) = match rest.split_once('@') {
            Some((before, after)) => {
                let (instant, component) = after.split_once('.').map_or((after, None), |(i, c)| (i, Some(c)));
                (component.map_or_else(|| before.to_owned(), |c| format!("{before}.{c}")), Some(instant.to_owned()))
            }
            None => (rest.to_owned(), None),
        };
        let (rest, component) = match rest.split_once('.') {
            Some((rest, component)) => (rest, Some(component.to_owned())),
            None => (rest.as_str(), None),
        };
        let joined = JOINED.iter().find(|base| rest == **base || rest.starts_with(&format!("{base}_")));
        let (base, tail) = match joined {
            Some(base) => (*base, rest[base.len()..].trim_start_matches('_')),
            None => rest.split_once('_').unwrap_or((rest, "")),
        };
        let subject = tail.trim_end_matches(|letter: char| letter.is_ascii_digit());
        let digits = &tail[subject.len()..];
        let instant = match (digits, named) {
            ("", None) => None,
            ("", Some(named)) => Some(Instant::Named(named)),
            (digits, None) => Some(Instant::Number(digits.parse().ok()?)),
            (_, Some(_)) => return None,
        };
        let plain = |text: &str| text.chars().all(|letter| letter.is_alphanumeric() || letter == '_');
        (!base.is_empty() && plain(base) && plain(subject)).then(|| Self {
            base: base.to_owned(),
            subject: subject.to_owned(),
            instant,
            component,
            stage,
        })
    }
}

/// The name of a component of a vector, which stands before the stage.
///
/// ```
/// use momentous::model::component_name;
/// assert_eq!(component_name("v_A2", "x"), "v_A2.x");
/// assert_eq!(component_name("J_A[hit]", "x"), "J_A.x[hit]");
/// ```
#[must_use]
pub fn component_name(vector: &str, axis: &str) -> String {
    match vector.split_once('[') {
        Some((before, stage)) => format!("{before}.{axis}[{stage}"),
        None => format!("{vector}.{axis}"),
    }
}
