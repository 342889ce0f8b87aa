//! Fields of a form that is refused, as the page that refuses it shows them: nothing is typed twice.

use serde::Serialize;

use super::parameters::Parameters;

/// Fields that pages fill in, and nobody types.
const OF_PAGES: [&str; 17] = [
    "request", "shown", "revision", "do", "to", "member", "person", "remove", "add", "part", "seed", "form", "key",
    "hints", "further", "next", "failures",
];
/// Fields whose value is shown nowhere.
const PASSWORDS: [&str; 4] = ["password", "old", "new", "again"];
/// The prefix of a part's name, in the names of fields.
const ANSWER: &str = "answer.";

/// A form that can be sent again.
#[derive(Debug, Serialize)]
pub struct Again {
    /// Its address.
    to: String,
    fields: Vec<Field>,
}

#[derive(Debug, PartialEq, Eq, Serialize)]
struct Field {
    name: String,
    value: String,
    label: String,
    kind: Kind,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
enum Kind {
    Hidden,
    Password,
    Line,
    Text,
}

impl Again {
    /// The typed texts, to be sent again to an address below `base`; `None` where there are none.
    pub fn of(base: &str, to: &str, typed: &Parameters) -> Option<Self> {
        // Requests for nested pages may have lost it already.
        let to = format!("{base}{}", to.strip_prefix(base).unwrap_or(to));
        let fields: Vec<Field> = typed.pairs().iter().map(Field::of).collect();
        fields.iter().any(|field| field.kind != Kind::Hidden).then_some(Self { to, fields })
    }
}

impl Field {
    fn of((name, value): &(String, String)) -> Self {
        // The fields of a row are `item.0.key`, `item.0.points`.
        let last_name = name.rsplit('.').next().unwrap_or(name);
        let kind = if OF_PAGES.contains(&last_name) && !name.starts_with(ANSWER) {
            Kind::Hidden
        } else if PASSWORDS.contains(&name.as_str()) {
            Kind::Password
        } else if value.contains('\n') {
            Kind::Text
        } else {
            Kind::Line
        };
        let label = name.strip_prefix(ANSWER).unwrap_or(name).to_owned();
        let value = if kind == Kind::Password { String::new() } else { value.clone() };
        Self { name: name.clone(), value, label, kind }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;

    #[test]
    fn what_was_typed_is_held_but_for_passwords() {
        let pair = |(name, value): (&str, &str)| (name.to_owned(), value.to_owned());
        let typed = [("request", "ab12"), ("answer.v_A2", "1 m/s"), ("table", "id\nada"), ("password", "secret")];
        let again = Again::of("/b", "/x", &Parameters::all_of(typed.map(pair).into())).unwrap();
        let shown: Vec<_> =
            again.fields.iter().map(|field| (field.label.as_str(), field.value.as_str(), field.kind)).collect();
        let expected = [
            ("request", "ab12", Kind::Hidden),
            ("v_A2", "1 m/s", Kind::Line),
            ("table", "id\nada", Kind::Text),
            ("password", "", Kind::Password),
        ];
        assert_eq!(shown, expected);
        assert_eq!(
            (again.to.as_str(), Again::of("/b", "/b/x", &Parameters::all_of(vec![pair(("a", "1"))])).unwrap().to),
            ("/b/x", "/b/x".to_owned())
        );
        assert!(Again::of("/b", "/x", &Parameters::all_of(vec![pair(("request", "ab12"))])).is_none());
    }
}
