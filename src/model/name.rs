//! The grammar of names: `v_A1.x`, `T_lost[hit]`, `v_A@top`, `F_avg_A`.

use std::fmt;

use super::QuantityKind;

/// The mass centre as it stands in names.
pub(super) const MASS_CENTRE: &str = "G";

/// Names of symbols, taken apart. Which names a scene has is decided elsewhere.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// The kind of quantity.
    pub kind: QuantityKind,
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

/// The names of what has no place in the grammar of other names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VectorName<'a> {
    /// `angle(v_A2, v_B2)`.
    AngleBetween([&'a str; 2]),
    /// `magnitude(H_O1)`.
    Magnitude(&'a str),
}

impl<'a> VectorName<'a> {
    /// Takes such a name apart.
    #[must_use]
    pub fn parse(text: &'a str) -> Option<Self> {
        let inner = |start: &str| text.strip_prefix(start)?.strip_suffix(')');
        if let Some((one, other)) = inner("angle(").and_then(|pair| pair.split_once(',')) {
            return Some(Self::AngleBetween([one.trim(), other.trim()]));
        }
        Some(Self::Magnitude(inner("magnitude(")?.trim()))
    }
}

/// The meaning of a quantity, as a noun and what belongs to it: `the velocity`, `of cart A just before the impact`.
#[derive(Clone, Debug)]
pub(super) struct Meaning {
    pub noun: &'static str,
    pub of: String,
}

impl fmt::Display for Meaning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.noun.is_empty() { f.write_str(&self.of) } else { write!(f, "{} {}", self.noun, self.of) }
    }
}

impl Name {
    /// The quantity of a body, of a point, or of the system where the subject is empty.
    #[must_use]
    pub fn of(kind: QuantityKind, subject: &str) -> Self {
        Self { kind, subject: subject.to_owned(), instant: None, component: None, stage: None }
    }

    /// The same at an instant.
    #[must_use]
    pub fn at(self, instant: usize) -> Self {
        Self { instant: Some(Instant::Number(instant)), ..self }
    }

    /// One component of it; the only one where none is said.
    #[must_use]
    pub fn along<'a>(self, component: impl Into<Option<&'a str>>) -> Self {
        Self { component: component.into().map(str::to_owned), ..self }
    }

    /// The same in a stage; in the only one where none is said.
    #[must_use]
    pub fn during(self, stage: Option<String>) -> Self {
        Self { stage, ..self }
    }

    /// Whether it refers to no body, no instant and no stage, so that authors may use it for anything: `v`, `T`, `v_0`.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        let no_instant = matches!(self.instant, None | Some(Instant::Number(0)));
        let bare = self.subject.is_empty() && self.component.is_none() && self.stage.is_none();
        bare && no_instant && !self.kind.spelling().contains('_')
    }

    /// Whether it would be a quantity of a body at an instant, but for the body, so that authors may use it for anything: `v_2`, `W_1`.
    #[must_use]
    pub fn lacks_a_body(&self) -> bool {
        let needs_one = matches!(
            self.kind,
            QuantityKind::Velocity
                | QuantityKind::Speed
                | QuantityKind::Direction(_)
                | QuantityKind::Impulse
                | QuantityKind::Weight
        );
        needs_one && self.subject.is_empty() && self.instant.is_some()
    }

    /// Whether it is a quantity of the centre of mass.
    #[must_use]
    pub fn is_of_mass_centre(&self) -> bool {
        self.subject == MASS_CENTRE
    }

    /// Takes a name apart; `None` where it does not follow the grammar.
    ///
    /// ```
    /// use momentous_model::{Instant, Name, QuantityKind};
    /// let name = Name::parse("v_A1.x").unwrap();
    /// assert_eq!((name.kind, name.subject.as_str(), name.instant), (QuantityKind::Velocity, "A", Some(Instant::Number(1))));
    /// assert_eq!(Name::parse("T_lost[hit]").unwrap().stage.as_deref(), Some("hit"));
    /// ```
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        // The component stands before the stage or after it.
        let (rest, stage) = match text.split_once('[') {
            Some((rest, tail)) => {
                let (stage, component) = tail.split_once(']')?;
                let joined = format!("{rest}{component}");
                let is_part = component.is_empty() || component.starts_with('.') && !rest.contains('.');
                (is_part.then_some(joined)?, Some(stage.to_owned()))
            }
            None => (text.to_owned(), None),
        };
        let (rest, named) = match rest.split_once('@') {
            Some((before, after)) => {
                let (instant, component) = after.split_once('.').map_or((after, None), |(i, c)| (i, Some(c)));
                (component.map_or_else(|| before.to_owned(), |c| format!("{before}.{c}")), Some(instant.to_owned()))
            }
            None => (rest, None),
        };
        let (rest, component) = match rest.split_once('.') {
            Some((rest, component)) => (rest, Some(component.to_owned())),
            None => (rest.as_str(), None),
        };
        let (kind, tail) = QuantityKind::parse(rest);
        let subject = tail.trim_end_matches(|letter: char| letter.is_ascii_digit());
        let digits = &tail[subject.len()..];
        // What holds an operator is a term of several names.
        let plain = |text: &str| text.chars().all(|letter| letter.is_alphanumeric() || letter == '_');
        if ![named.as_deref(), component.as_deref()].into_iter().flatten().all(plain) {
            return None;
        }
        let instant = match (digits, named) {
            ("", None) => None,
            ("", Some(named)) => Some(Instant::Named(named)),
            (digits, None) => Some(Instant::Number(digits.parse().ok()?)),
            (_, Some(_)) => return None,
        };
        let subject = subject.to_owned();
        let base = kind.spelling();
        (!base.is_empty() && plain(&base) && plain(&subject)).then_some(Self {
            kind,
            subject,
            instant,
            component,
            stage,
        })
    }

    /// Reads a name of the author's own, as far as its letter tells.
    pub(super) fn written(text: &str) -> Self {
        let name_by_author = || Self::of(QuantityKind::Own(text.to_owned()), "");
        Self::parse(text).filter(|name| name.to_string() == text).unwrap_or_else(name_by_author)
    }
}

/// The one spelling under which the symbol of a name is kept.
impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.kind.spelling())?;
        if !self.subject.is_empty() || self.instant.is_some() {
            write!(f, "_{}", self.subject)?;
        }
        match &self.instant {
            Some(Instant::Number(number)) => write!(f, "{number}")?,
            Some(Instant::Named(named)) => write!(f, "@{named}")?,
            None => {}
        }
        if let Some(component) = &self.component {
            write!(f, ".{component}")?;
        }
        if let Some(stage) = &self.stage {
            write!(f, "[{stage}]")?;
        }
        Ok(())
    }
}

/// The name of a component of a vector, which stands before the stage.
///
/// ```
/// use momentous_model::component_name;
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

/// Whether a text is one name: a word that is not the number pi.
pub(super) fn is_bare_name(text: &str) -> bool {
    text.starts_with(|first: char| first.is_alphabetic())
        && text.chars().all(|letter| letter.is_alphanumeric() || letter == '_')
        && text != "pi"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_spelt_as_they_are_read() {
        let names = [
            "v_A1.x",
            "T_lost[hit]",
            "v_A@top.x",
            "F_avg_A.x[2]",
            "v_rel_A1",
            "H_G2.z",
            "angle_J_A[1]",
            "work",
            "T_1",
            "mu_k",
            "theta1",
            "I_F2[pull]",
        ];
        for text in names {
            assert_eq!(Name::parse(text).as_ref().map(ToString::to_string).as_deref(), Some(text));
        }
        assert_eq!(Name::parse("J_A[hit].x"), Name::parse("J_A.x[hit]"));
        let wrong = ["v_A1@top", "T[", "J_A.x[hit].y", "J_A[hit]x", "J_A[1][2]"];
        assert_eq!(wrong.map(Name::parse), [const { None }; 5]);
        assert_eq!(Name::written("5*x").kind, QuantityKind::Own("5*x".to_owned()));
    }
}
