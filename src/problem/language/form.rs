//! The forms of a problem, each complete: what stands at the top of the file holds for every form.

use std::collections::BTreeSet;

use momentous_fault::Path;

use super::ask::Ask;
use super::draft::{Draft, Expect, Form, Roots};
use super::entries::Entries;
use super::given::Given;
use super::intended::Intended;
use super::text::Text;

/// One way in which a problem is asked, with what the file says for all forms.
#[derive(Clone, Debug)]
pub struct Question {
    /// The form's name; `None` where the file has one form without a name.
    pub name: Option<String>,
    /// The place of the form in the file: `forms.forward`, or the whole document.
    pub path: Path,
    /// The end of the text, after the story; empty where the form has none.
    pub text: Text,
    /// Other values of what the file gives; they stand under `given` at the form's path.
    pub given: Entries<Given>,
    /// The questions; the parts stand under `ask` at the form's path.
    pub ask: Vec<Ask>,
    /// Names that are solved first and then given; they stand under `reveal` at the form's path.
    pub reveal: Vec<String>,
    /// Conditions that pick among true solutions, each with its place: those for every form, then the form's own.
    pub conditions: Vec<(Path, Intended)>,
    /// Whether every true solution is asked for.
    pub roots: Option<Roots>,
    /// Warnings that are meant, by their names, each with its place.
    pub allow: Vec<(Path, String)>,
    /// The notes of `momentous check` that the author knows: each promise with its place and the reason.
    pub acknowledge: Vec<(Path, String, String)>,
    /// Whether the problem is meant to end in something impossible.
    pub expect: Option<Expect>,
    /// Hints, each with its place: those for every form, then the form's own.
    pub hints: Vec<(Path, Text)>,
    /// The names of what the texts of other forms tell, and those of this one do not.
    pub elsewhere: BTreeSet<String>,
}

impl Question {
    /// The name of the random stream from which the order of what the part of that letter offers comes.
    pub(crate) fn stream(&self, letter: &str) -> String {
        format!("{}/{letter}", self.name.as_deref().unwrap_or_default())
    }

    /// The forms of a draft, in the order of the file; never empty for a draft that was loaded.
    pub(crate) fn all(draft: &Draft) -> Vec<Self> {
        let root = Path::root();
        if draft.forms.is_empty() {
            let form = Form {
                text: None,
                given: Entries::default(),
                ask: draft.ask.clone(),
                reveal: draft.reveal.clone(),
                conditions: Vec::new(),
                roots: None,
                allow: Vec::new(),
                acknowledge: Entries::default(),
                expect: None,
                hints: Vec::new(),
            };
            return vec![Self::of(draft, None, &form, root)];
        }
        let forms = root.key("forms");
        let forms = draft.forms.iter().map(|(name, form)| Self::of(draft, Some(name), form, forms.key(name)));
        let mut all: Vec<Self> = forms.collect();
        let story = draft.text.printed_names();
        let told: Vec<BTreeSet<String>> = all.iter().map(|question| question.text.printed_names()).collect();
        for (question, here) in all.iter_mut().zip(&told) {
            question.elsewhere =
                told.iter().flatten().filter(|name| !here.contains(*name) && !story.contains(*name)).cloned().collect();
        }
        all
    }

    fn of(draft: &Draft, name: Option<&str>, form: &Form, path: Path) -> Self {
        // The loader has read every given of the file before, so reading cannot fail here.
        let value = |(name, entry): (&str, _)| Some((name.to_owned(), Given::read(entry, &Path::root()).ok()?));
        Self {
            name: name.map(str::to_owned),
            text: form.text.clone().unwrap_or_default(),
            given: form.given.iter().filter_map(value).collect(),
            ask: form.ask.clone(),
            reveal: form.reveal.clone(),
            conditions: placed(&path, "where", &draft.conditions, &form.conditions),
            roots: form.roots.or(draft.roots),
            allow: placed(&path, "allow", &draft.allow, &form.allow),
            acknowledge: [(Path::root(), &draft.acknowledge), (path.clone(), &form.acknowledge)]
                .into_iter()
                .flat_map(|(place, entries)| acknowledged(&place, entries))
                .collect(),
            expect: form.expect.or(draft.expect),
            hints: placed(&path, "hints", &draft.hints, &form.hints),
            path,
            elsewhere: BTreeSet::new(),
        }
    }
}

/// The notes acknowledged there, each with its place.
fn acknowledged(place: &Path, entries: &Entries<String>) -> Vec<(Path, String, String)> {
    let place = place.key("acknowledge");
    entries.iter().map(|(name, reason)| (place.name(name), name.to_owned(), reason.clone())).collect()
}

/// The entries of a list at the top of the file for every form, then the form's own, each with its place.
fn placed<T: Clone>(form: &Path, key: &str, general: &[T], particular: &[T]) -> Vec<(Path, T)> {
    let at = |place: &Path, list: &[T]| {
        let place = place.key(key);
        list.iter().enumerate().map(|(index, item)| (place.index(index), item.clone())).collect::<Vec<_>>()
    };
    [at(&Path::root(), general), at(form, particular)].concat()
}
