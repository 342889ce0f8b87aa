//! The fields of an address or of a form.

use std::collections::BTreeMap;

use momentous_exercise::calls::{Limits, Refused, RefusedKind, VariantRequest, within};
use momentous_grade::DecimalMark;

/// Names with their values, in the order in which they came.
#[derive(Clone, Debug, Default)]
pub struct Parameters(Vec<(String, String)>);

impl Parameters {
    /// The fields, where there are not too many.
    ///
    /// # Errors
    /// There are more than the limits allow.
    pub fn new(fields: Vec<(String, String)>, limits: &Limits) -> Result<Self, Refused> {
        within(fields.len(), limits.fields, "fields are read")?;
        Ok(Self(fields))
    }

    /// The fields as they are, to be shown again.
    #[must_use]
    pub const fn all_of(fields: Vec<(String, String)>) -> Self {
        Self(fields)
    }

    /// Every field.
    #[must_use]
    pub fn pairs(&self) -> &[(String, String)] {
        &self.0
    }

    /// The value of a name; nothing where it is empty.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<&str> {
        self.0.iter().find(|(key, _)| key == name).map(|(_, value)| value.as_str()).filter(|value| !value.is_empty())
    }

    /// The text in a field; empty where it is not there.
    #[must_use]
    pub fn text(&self, name: &str) -> &str {
        self.get(name).unwrap_or_default()
    }

    /// Whether a name is there, but without a value.
    #[must_use]
    pub fn is_empty(&self, name: &str) -> bool {
        self.0.iter().find(|(key, _)| key == name).is_some_and(|(_, value)| value.trim().is_empty())
    }

    /// Every value of a name that may come several times.
    pub fn all(&self, name: &str) -> impl Iterator<Item = &str> {
        self.0.iter().filter(move |(key, _)| key == name).map(|(_, value)| value.as_str())
    }

    /// A whole number, where there is one.
    ///
    /// # Errors
    /// The field holds anything else.
    pub fn number(&self, name: &str) -> Result<Option<u64>, Refused> {
        let Some(text) = self.get(name) else { return Ok(None) };
        let wrong = |_| {
            let message = format!("`{name}` is a whole number from 0 to {}, not `{text}`", u64::MAX);
            Refused::new(RefusedKind::Invalid, message)
        };
        text.trim().parse().map(Some).map_err(wrong)
    }

    /// A small whole number, 0 where there is none.
    ///
    /// # Errors
    /// The field holds anything else.
    pub fn count(&self, name: &str) -> Result<usize, Refused> {
        Ok(usize::try_from(self.number(name)?.unwrap_or(0)).unwrap_or(usize::MAX))
    }

    /// The fields behind a prefix: `set.m_A` as `m_A`. Empty values are left out.
    #[must_use]
    pub fn behind(&self, prefix: &str) -> BTreeMap<String, String> {
        let entry = |(name, value): &(String, String)| {
            let name = name.strip_prefix(prefix)?;
            (!value.trim().is_empty()).then(|| (name.to_owned(), value.clone()))
        };
        self.0.iter().filter_map(entry).collect()
    }

    /// The variant of a problem that the fields name: `form`, `seed`, values of the reader's own as `set.m_A`, and in `find` names
    /// between spaces or commas.
    pub(super) fn variant(&self, problem: String) -> Result<VariantRequest, Refused> {
        let names = self.text("find").split([' ', ',']).filter(|name| !name.is_empty());
        let find = names.map(str::to_owned).collect();
        let form = self.get("form").map(str::to_owned);
        Ok(VariantRequest { problem, form, seed: self.number("seed")?.unwrap_or(1), set: self.behind("set."), find })
    }

    /// The decimal mark that the reader writes.
    #[must_use]
    pub fn decimal(&self) -> DecimalMark {
        match self.get("decimal") {
            Some("point") => DecimalMark::Point,
            Some("comma") => DecimalMark::Comma,
            _ => DecimalMark::Either,
        }
    }
}
