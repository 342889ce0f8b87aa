//! Passwords: kept as argon2id writes them, with the memory and time that its authors recommend.

use argon2::Argon2;
use argon2::password_hash::{PasswordHasher, PasswordVerifier};

use momentous_problem::guesses;

/// The characters that a password has at least.
pub(super) const SHORTEST: usize = 10;
/// The bytes that a password has at most.
const LONGEST: usize = 1024;
/// The tries after which a password may be found, as a power of two: more than the limit of tries allows in years.
const GUESSES: f64 = 20.0;

/// The hash kept of a password; `None` where the machine cannot make it.
pub(super) fn hash(password: &str) -> Option<String> {
    Argon2::default().hash_password(password.as_bytes()).ok().map(|hash| hash.to_string())
}

/// Whether it is the password of which this was kept.
pub(super) fn is_right(password: &str, kept: &str) -> bool {
    Argon2::default().verify_password(password.as_bytes(), kept).is_ok()
}

/// The fault of a new password, where there is one.
pub(super) fn fault(password: &str, again: &str, login: &str) -> Option<String> {
    if password != again {
        Some("the two passwords are not the same".to_owned())
    } else if password.chars().count() < SHORTEST {
        Some(format!(
            "a password has at least {SHORTEST} characters; a few words are easy to remember and hard to guess"
        ))
    } else if guesses(password.as_bytes()) < GUESSES || password.to_lowercase() == login.to_lowercase() {
        Some("this password is among the first that are tried; a few words that nobody says are better".to_owned())
    } else if password.len() > LONGEST {
        Some(format!("a password has at most {LONGEST} bytes"))
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_password_is_known_again_and_no_other() {
        let kept = hash("correct horse battery").unwrap();
        assert!(kept.starts_with("$argon2id$") && !kept.contains("correct"));
        assert!(is_right("correct horse battery", &kept));
        assert!(!is_right("correct horse", &kept) && !is_right("", &kept) && !is_right("x", "no hash"));
        assert_ne!(hash("the same"), hash("the same"), "each has a salt of its own");
    }

    #[test]
    fn what_is_wrong_with_a_password_is_said() {
        assert_eq!(fault("a few short words", "a few short words", "ada"), None);
        let cases = [
            ("short", "short", "at least 10"),
            ("long enough", "long enoughh", "not the same"),
            ("aaaaaaaaaa", "aaaaaaaaaa", "first that are tried"),
            ("1234567890", "1234567890", "first that are tried"),
            ("password12", "password12", "first that are tried"),
            ("Ada.Lovelace", "Ada.Lovelace", "first that are tried"),
        ];
        for (password, again, expected) in cases {
            let fault = fault(password, again, "ada.lovelace").unwrap_or_default();
            assert!(fault.contains(expected), "{password}: {fault}");
        }
    }
}
