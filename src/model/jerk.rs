//! The strings of a jerk: one, or several that are jerked at the same time.

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_scene::stage::JerkedString;
use momentous_scene::stage::Taut;

/// Whatever is said of a jerk that has no meaning.
pub(super) fn faults(stage: &Taut, at: &Path) -> Vec<Fault> {
    let beside_strings: Vec<(&str, &str)> = [
        ("between", stage.between.is_some(), "name its two bodies as one of the `strings`"),
        ("along", stage.along.is_some(), "give each of the `strings` a direction of its own"),
        ("over", stage.over.is_some(), "only a string `between` two bodies can run over a pulley"),
    ]
    .into_iter()
    .filter_map(|(key, is_written, help)| is_written.then_some((key, help)))
    .collect();
    match (&stage.strings[..], &stage.between) {
        ([], Some([one, other])) => twice(one, other, &at.key("between")).into_iter().collect(),
        ([], None) => {
            let fault = Fault::new(Code::MissingKey, "a jerk needs the two bodies at the ends of the string");
            let help =
                "write `between: [A, B]`; of several strings `strings: [{ between: [A, B] }, { between: [B, C] }]`";
            vec![fault.help(help).at_path(at.clone())]
        }
        (strings, _) => {
            let mut faults: Vec<Fault> = beside_strings
                .into_iter()
                .map(|(key, help)| {
                    let message = format!("`{key}` and `strings` cannot be used together");
                    Fault::new(Code::Value, message).help(help).at_path(at.key(key))
                })
                .collect();
            for (position, string) in strings.iter().enumerate() {
                let [one, other] = string.ends();
                let at = at.key("strings").index(position).key("between");
                faults.extend(twice(one, other, &at));
                let is_same = |earlier: &JerkedString| earlier.ends() == [one, other] || earlier.ends() == [other, one];
                if strings[..position].iter().any(is_same) {
                    let message = format!("two of the strings join `{one}` and `{other}`");
                    faults.push(Fault::new(Code::Duplicate, message).help("name each string once").at_path(at.clone()));
                }
                let joined = [one, other].concat();
                if stage.jerked().contains(&joined.as_str()) {
                    let message =
                        format!("the impulse of this string would be called `J_{joined}`, as that on `{joined}`");
                    faults.push(
                        Fault::new(Code::Duplicate, message).help("give that body another short name").at_path(at),
                    );
                }
            }
            faults
        }
    }
}

/// A string from a body to itself.
fn twice(one: &str, other: &str, at: &Path) -> Option<Fault> {
    let fault = || Fault::new(Code::Value, format!("`{one}` cannot be at both ends of a string"));
    (one == other).then(|| fault().help("name the other body").at_path(at.clone()))
}
