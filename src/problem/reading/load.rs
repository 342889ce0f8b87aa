//! From the text of a problem file to its draft, or to all its faults.

use std::borrow::Borrow;

use serde::de::DeserializeOwned;
use serde_yaml::{Value, with::singleton_map_recursive};

use momentous_fault::{Code, Fault, Faults, Path, Source};

use super::super::language::draft::Draft;
use super::super::language::entries::Entries;
use super::super::language::form::Question;
use super::super::language::given::{Given, GivenEntry};
use super::super::language::spoken::Spoken;
use super::super::language::text::Text;
use super::check::check;
use super::digest::{Digests, digest};
use super::document::Document;
use super::limits;
use super::position::Index;
use super::schema::SHAPES;

/// A problem file that holds together by itself: keys, kinds of value, givens and placeholders are right.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// The file.
    pub source: Source,
    /// The digest of its bytes.
    pub digest: String,
    /// The digests of what its numbers, marks and words depend on.
    pub digests: Digests,
    /// The keys, as they were written.
    pub draft: Draft,
    /// The givens, in the order of the file.
    pub given: Entries<Given>,
    /// The forms in which the problem is asked, each complete; at least one.
    pub questions: Vec<Question>,
    /// The words of its scene and relations.
    pub(crate) spoken: Spoken,
}

impl Loaded {
    /// The same with other values of some givens.
    pub(crate) fn with(&self, values: &Entries<Given>) -> Self {
        let given = self.given.iter().map(|(name, given)| (name.to_owned(), values.get(name).unwrap_or(given).clone()));
        Self { given: given.collect(), ..self.clone() }
    }

    /// Faults found later, by path, with their places in the file.
    #[must_use]
    pub fn locate(&self, faults: Vec<Fault>) -> Faults {
        Index::of(&self.source).locate_all(faults)
    }
}

/// Reads a problem file.
///
/// # Errors
/// Every fault of the file that can be seen without knowing the scene's names: of YAML, of keys and kinds of value, of
/// givens and of placeholders.
///
/// ```
/// use momentous_fault::Source;
/// let file = "ask: [{ find: v_A1 }]\nid: a\ntitle: A\nlevel: intro\nscene: { axes: { x: east }, bodies: { A: { nam: cart A } } }\ntext: What?\n";
/// let faults = momentous_problem::load(Source::new("a.yaml", file)).unwrap_err();
/// assert_eq!(faults.list[0].help.as_deref(), Some("did you mean `name`? Other keys here: `mass`, `inertia` and `guide`."));
/// ```
pub fn load(source: Source) -> Result<Loaded, Faults> {
    if let Some(fault) = limits::length(&source) {
        return Err(Faults { source, list: vec![fault] });
    }
    let Document { root, mut faults } = Document::read(&source);
    let Some(root) = root else { return Err(Index::new(&source, None).locate_all(faults)) };
    let (value, of_form) = check(&root, &SHAPES);
    faults.extend(of_form);
    faults.extend(["id", "was"].into_iter().filter_map(|key| id_fault(&value, key)));
    faults.extend(forms_faults(&value));
    faults.extend(text_faults(&value));
    faults.extend(limits::counts(&value));
    let refuse = |root, faults| Err(Index::new(&source, Some(root)).locate_all(faults));
    if !faults.is_empty() {
        faults.extend(givens(written(&value), &Path::root()).1);
        return refuse(root, faults);
    }
    let draft = match typed::<Draft>(value) {
        Ok(mut draft) => {
            draft.scene.tell_defaults();
            draft
        }
        Err(fault) => {
            let (value, _) = check(&root, &SHAPES);
            return refuse(root, givens(written(&value), &Path::root()).1.into_iter().chain([fault]).collect());
        }
    };
    let (given, mut of_given) = givens(draft.given.iter(), &Path::root());
    for (name, form) in draft.forms.iter() {
        of_given.extend(givens(form.given.iter(), &Path::root().key("forms").key(name)).1);
    }
    if !of_given.is_empty() {
        return refuse(root, of_given);
    }
    Ok(Loaded {
        digest: digest(&source),
        digests: Digests::new(&root, draft.drawn_as()),
        questions: Question::all(&draft),
        spoken: Spoken::of(&root),
        source,
        draft,
        given,
    })
}

/// A checked value in its type. The check knows every rule of the schema; what it lets pass and the type does not is
/// told in the words of the type.
pub(super) fn typed<T: DeserializeOwned>(value: Value) -> Result<T, Fault> {
    let mut track = serde_path_to_error::Track::new();
    let tracked = serde_path_to_error::Deserializer::new(value, &mut track);
    let read = singleton_map_recursive::deserialize(tracked);
    read.map_err(|error| {
        use serde_path_to_error::Segment;
        let path = track.path().iter().fold(Path::root(), |path, segment| match segment {
            Segment::Seq { index } => path.index(*index),
            Segment::Map { key } => path.key(key.as_str()),
            Segment::Enum { .. } | Segment::Unknown => path,
        });
        Fault::new(Code::Value, error.to_string()).at_path(path)
    })
}

/// The rule of identities: words of small letters, digits and hyphens, with slashes between them.
fn id_fault(value: &Value, key: &str) -> Option<Fault> {
    let id = value.get(key)?.as_str()?;
    let plain = |letter: char| letter.is_ascii_lowercase() || letter.is_ascii_digit();
    let word = |word: &str| !word.is_empty() && word.chars().all(plain);
    if id.split('/').all(|part| part.split('-').all(word)) {
        return None;
    }
    let fault = Fault::new(Code::Value, format!("`{id}` cannot be the identity of a problem"));
    let help = "write lower-case letters, digits and hyphens, with the topic before a slash: `impact/two-carts`";
    Some(fault.help(help).at_path(Path::root().key(key)))
}

/// The rule of forms: what is asked stands at the top, or under named forms, and is not empty.
fn forms_faults(value: &Value) -> Vec<Fault> {
    let root = Path::root();
    let mut faults = Vec::new();
    if !value.is_mapping() {
        return faults;
    }
    let Some(forms) = value.get("forms") else {
        match value.get("ask") {
            None => faults.push(
                Fault::new(Code::MissingKey, "the file asks for nothing")
                    .help("add `ask:` with a list of parts as `- { find: v_A2, unit: m/s }`, or `forms:`")
                    .at_path(root),
            ),
            Some(ask) => faults.extend(nothing_asked(ask, &root.key("ask"))),
        }
        return faults;
    };
    for key in ["ask", "reveal"] {
        if value.get(key).is_some() {
            let fault = Fault::new(Code::Duplicate, format!("`{key}` is at the top level, beside `forms`"));
            faults.push(fault.help(format!("move `{key}` into the form to which it belongs")).at_path(root.name(key)));
        }
    }
    let forms = forms.as_mapping().into_iter().flatten();
    for (name, form) in forms.filter_map(|(name, form)| Some((name.as_str()?, form))) {
        let path = root.key("forms").key(name);
        faults.extend(form.get("ask").and_then(|ask| nothing_asked(ask, &path.key("ask"))));
    }
    faults
}

fn nothing_asked(ask: &Value, path: &Path) -> Option<Fault> {
    let empty = ask.as_sequence().is_some_and(Vec::is_empty);
    let fault =
        Fault::new(Code::Value, "nothing is asked for here").help("add a part as `- { find: v_A2, unit: m/s }`");
    empty.then(|| fault.at_path(path.clone()))
}

/// The entries of what is known that have the form of one; the others are told of elsewhere.
fn written(value: &Value) -> impl Iterator<Item = (&str, GivenEntry)> {
    let entries = value.get("given").and_then(Value::as_mapping).into_iter().flatten();
    entries.filter_map(|(name, entry)| Some((name.as_str()?, typed(entry.clone()).ok()?)))
}

/// Reads the givens as far as they can be read, with the faults of the rest; `at` is where `given` stands.
fn givens<'e>(
    entries: impl Iterator<Item = (&'e str, impl Borrow<GivenEntry>)>,
    at: &Path,
) -> (Entries<Given>, Vec<Fault>) {
    let mut faults = Vec::new();
    let read = |(name, entry): (&str, _)| {
        let given = Given::read(Borrow::borrow(&entry), &at.key("given").key(name));
        given.map(|given| (name.to_owned(), given)).map_err(|more| faults.extend(more)).ok()
    };
    let given = entries.filter_map(read).collect();
    (given, faults)
}

/// The faults of every text with placeholders.
fn text_faults(value: &Value) -> Vec<Fault> {
    let root = Path::root();
    let mut texts = vec![(root.key("text"), value.get("text"))];
    texts.extend(children(value.get("hints"), &root.key("hints")));
    texts.extend(children(value.get("feedback"), &root.key("feedback")));
    for (path, form) in children(value.get("forms"), &root.key("forms")) {
        texts.push((path.key("text"), form.and_then(|form| form.get("text"))));
        texts.extend(children(form.and_then(|form| form.get("hints")), &path.key("hints")));
    }
    let read = |(path, text): (Path, Option<&Value>)| {
        let faults = text.and_then(Value::as_str).map(Text::read).and_then(Result::err).unwrap_or_default();
        faults.into_iter().map(move |fault| fault.at_path(path.clone())).collect::<Vec<_>>()
    };
    texts.into_iter().flat_map(read).collect()
}

/// The values of a mapping or a list, each with its path.
fn children<'v>(value: Option<&'v Value>, path: &Path) -> Vec<(Path, Option<&'v Value>)> {
    match value {
        Some(Value::Mapping(mapping)) => {
            let child = |(key, value): (&'v Value, &'v Value)| Some((path.key(key.as_str()?), Some(value)));
            mapping.iter().filter_map(child).collect()
        }
        Some(Value::Sequence(items)) => {
            items.iter().enumerate().map(|(index, item)| (path.index(index), Some(item))).collect()
        }
        _ => Vec::new(),
    }
}
