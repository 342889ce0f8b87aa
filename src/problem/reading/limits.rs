//! How much one problem file may ask for.

use serde_yaml::Value;

use momentous_fault::{Code, Fault, Path, Source, Span};

/// The longest file in bytes: a hundred times what the longest of the bank has.
pub const LONGEST_FILE: usize = 256 * 1024;
/// The most forms of a file.
const MOST_FORMS: usize = 64;
/// The most questions of a form, as many as a student's sheet takes answers.
const MOST_QUESTIONS: usize = 64;
/// The most bodies of a scene.
const MOST_BODIES: usize = 64;
/// The most stages of a scene.
const MOST_STAGES: usize = 64;
/// The most quantities that are known at one place.
const MOST_GIVENS: usize = 512;

/// The fault of a file that is too long to be read.
pub(super) fn length(source: &Source) -> Option<Fault> {
    let length = source.text.len();
    (length > LONGEST_FILE).then(|| {
        let message = format!("the file has {length} bytes, and a problem has at most {LONGEST_FILE}");
        Fault::new(Code::Unreadable, message).help("make several problems of it").at(Span::default())
    })
}

/// The faults of whatever there is too much of.
pub(super) fn counts(value: &Value) -> Vec<Fault> {
    let root = Path::root();
    let scene = root.key("scene");
    let mut faults = Vec::new();
    let mut count = |value: Option<&Value>, at: &Path, key: &str, most: usize, what: &str, way_out: &str| {
        let count = match value.and_then(|value| value.get(key)) {
            Some(Value::Mapping(mapping)) => mapping.len(),
            Some(Value::Sequence(sequence)) => sequence.len(),
            _ => 0,
        };
        if count > most {
            let fault = Fault::new(Code::Range, format!("these are {count} {what}, and there may be at most {most}"));
            faults.push(fault.help(way_out).at_path(at.name(key)));
        }
    };
    let several = "make several problems of it";
    let of_scene = value.get("scene");
    count(of_scene, &scene, "bodies", MOST_BODIES, "bodies", several);
    count(of_scene, &scene, "stages", MOST_STAGES, "stages", several);
    count(Some(value), &root, "forms", MOST_FORMS, "forms", several);
    count(Some(value), &root, "given", MOST_GIVENS, "quantities", several);
    count(Some(value), &root, "ask", MOST_QUESTIONS, "questions", "ask for less, or make several forms of it");
    let forms = value.get("forms").and_then(Value::as_mapping).into_iter().flatten();
    for (name, form) in forms.take(MOST_FORMS).filter_map(|(name, form)| Some((name.as_str()?, form))) {
        let path = root.key("forms").key(name);
        count(Some(form), &path, "ask", MOST_QUESTIONS, "questions", "ask for less, or make several forms of it");
        count(Some(form), &path, "given", MOST_GIVENS, "quantities", several);
    }
    faults
}
