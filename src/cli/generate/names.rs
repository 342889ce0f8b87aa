//! Names of files: readable, and no two the same.

use std::collections::BTreeMap;
use std::fmt::Write;

use sha2::{Digest, Sha256};

use crate::cli::failure::Failure;
use crate::cli::output::file_stem;

/// The bytes of a digest that are written behind names which would be the same without it.
const DIGEST: usize = 4;

/// A part of a file's name for each text. Where several texts would give the same, each has some digits of its own behind it,
/// so that none hangs on the order of the texts.
pub(super) fn distinct(texts: &[String]) -> Vec<String> {
    let mut times: BTreeMap<String, usize> = BTreeMap::new();
    for text in texts {
        *times.entry(folded(&file_stem(text))).or_insert(0) += 1;
    }
    let name = |text: &String| {
        let stem = file_stem(text);
        if times.get(&folded(&stem)) == Some(&1) { stem } else { format!("{stem}-{}", digits(text)) }
    };
    texts.iter().map(name).collect()
}

/// Folds a name into the form that some file system may take for the same: capitals count as small letters, and a letter beyond
/// ASCII as any other, because it may be written in several ways.
fn folded(name: &str) -> String {
    let mut folded = String::new();
    for letter in name.to_uppercase().to_lowercase().chars() {
        match letter.is_ascii() {
            true => folded.push(letter),
            false if folded.ends_with('?') => {}
            false => folded.push('?'),
        }
    }
    folded
}

fn digits(text: &str) -> String {
    Sha256::digest(text).iter().take(DIGEST).fold(String::new(), |mut digits, byte| {
        // Writing to a string cannot fail.
        let _ = write!(digits, "{byte:02x}");
        digits
    })
}

/// Refuses documents of which two would have one name; each comes with what it is.
pub(super) fn refuse_twins(documents: impl Iterator<Item = (String, String)>) -> Result<(), Failure> {
    let mut named: BTreeMap<String, String> = BTreeMap::new();
    for (name, what) in documents {
        if let Some(other) = named.insert(folded(&name), what.clone()) {
            return Err(Failure::unusable(format!(
                "two documents would be written to `{name}`: {other}, and {what}\n\
                 help: nothing was written; write them in two runs into two folders, or change an identity"
            )));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(texts: &[&str]) -> Vec<String> {
        distinct(&texts.iter().map(|text| (*text).to_owned()).collect::<Vec<_>>())
    }

    #[test]
    fn only_names_that_would_be_the_same_have_digits() {
        // By Python: hashlib.sha256(b"a b").hexdigest()[:8].
        assert_eq!(of(&["a b", "s17", "a/b", "a-b-2"]), ["a-b-c8687a08", "s17", "a-b-c14cddc0", "a-b-2"]);
        assert_eq!(of(&["a/b", "a b"]), ["a-b-c14cddc0", "a-b-c8687a08"]);
    }

    #[test]
    fn what_a_file_system_may_take_for_one_name_is_two() {
        // A capital; a syllable and its letters; the sign of ångström and the letter; a sharp s; what is cut off.
        let long = ["x".repeat(200), "x".repeat(201)];
        let twins = [
            ["S1", "s1"],
            ["\u{d55c}", "\u{1112}\u{1161}\u{11ab}"],
            ["\u{212b}", "\u{e5}"],
            ["Groß", "GROSS"],
            [&long[0], &long[1]],
        ];
        for pair in twins {
            let names = of(&pair);
            let is_named_after =
                |name: &str, text: &str| name.ends_with(&format!("-{}", digits(text))) && name.len() < 120;
            assert!(names.iter().zip(pair).all(|(name, text)| is_named_after(name, text)), "{names:?}");
        }
        assert_eq!(of(&["Ana María", "Zoë"]), ["Ana-María", "Zoë"]);
    }

    #[test]
    fn twins_are_refused_with_what_they_are() {
        let twins = [("A.md", "one"), ("b.md", "two"), ("a.md", "three")];
        let refused = refuse_twins(twins.iter().map(|(name, what)| ((*name).to_owned(), (*what).to_owned())));
        assert!(
            refused
                .unwrap_err()
                .to_string()
                .starts_with("error: two documents would be written to `a.md`: one, and three")
        );
    }
}
