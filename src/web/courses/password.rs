//! Passwords: kept as argon2id writes them, with the memory and time that its authors recommend.

use argon2::Argon2;
use argon2::password_hash::{PasswordHasher, PasswordVerifier};

/// The characters that a password has at least.
pub(super) const SHORTEST: usize = 10;
/// The bytes that a password has at most.
const LONGEST: usize = 1024;

/// What is kept of a password; nothing where the machine cannot make it.
pub(super) fn hash(password: &str) -> Option<String> {
    Argon2::default().hash_password(password.as_bytes()).ok().map(|hash| hash.to_string())
}

/// Whether it is the password of which this was kept. Without one as much time goes by, so that nobody learns who has a password.
pub(super) fn is_right(password: &str, kept: Option<&str>) -> bool {
    // The hash of a text that is no password: shorter than any.
    const NOBODY: &str =
        "$argon2id$v=19$m=19456,t=2,p=1$bW9tZW50b3VzbW9tZW50bw$cYoPSuRRyHuJpoGbTk1RHWPDbpRSMVAPCkk9RYyfb6c";
    let is_right = Argon2::default().verify_password(password.as_bytes(), kept.unwrap_or(NOBODY)).is_ok();
    is_right && kept.is_some()
}

/// What is wrong with a new password, where something is.
pub(super) fn fault(password: &str, again: &str) -> Option<String> {
    if password != again {
        Some("the two passwords are not the same".to_owned())
    } else if password.chars().count() < SHORTEST {
        Some(format!(
            "a password has at least {SHORTEST} characters; a few words are easy to remember and hard to guess"
        ))
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
        assert!(is_right("correct horse battery", Some(&kept)));
        assert!(!is_right("correct horse", Some(&kept)) && !is_right("", None) && !is_right("x", Some("no hash")));
        assert_ne!(hash("the same"), hash("the same"), "each has a salt of its own");
    }

    #[test]
    fn the_hash_of_nobody_takes_the_same_work() {
        let kept = hash("correct horse battery").unwrap();
        let parameters = |text: &str| text.split('$').take(4).collect::<Vec<_>>().join("$");
        assert_eq!(parameters(&kept), "$argon2id$v=19$m=19456,t=2,p=1");
    }

    #[test]
    fn what_is_wrong_with_a_password_is_said() {
        assert_eq!(fault("a few short words", "a few short words"), None);
        for (password, again) in [("short", "short"), ("long enough", "long enoughh")] {
            assert!(fault(password, again).is_some());
        }
    }
}
