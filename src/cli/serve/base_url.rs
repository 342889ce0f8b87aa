//! Addresses by which readers reach the pages.

use std::str::FromStr;

/// The address by which readers reach the pages: the host where it was said, and the path of the first page without a slash at
/// its end.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct BaseUrl {
    pub(super) host: Option<String>,
    pub(super) is_secure: bool,
    pub(super) path: String,
}

impl FromStr for BaseUrl {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (is_secure, rest) = match (text.strip_prefix("https://"), text.strip_prefix("http://")) {
            (Some(rest), _) => (true, Some(rest)),
            (None, rest) => (false, rest),
        };
        let (host, path) = match rest {
            Some(rest) => {
                let (host, path) = rest.find('/').map_or((rest, ""), |at| rest.split_at(at));
                (Some(host.to_lowercase()), path)
            }
            None if text.is_empty() || text.starts_with('/') => (None, text),
            None => return Err("write an address such as https://physics.example.edu/momentous".to_owned()),
        };
        let path = path.trim_end_matches('/');
        let is_plain = |letter: char| letter.is_ascii_alphanumeric() || "/-_.~".contains(letter);
        if !path.chars().all(is_plain) || path.contains("//") {
            return Err("its path has letters, digits, `-`, `_`, `.` and `~` only".to_owned());
        }
        let is_host = |host: &String| {
            !host.is_empty() && host.chars().all(|sign| sign.is_ascii_alphanumeric() || "-.:[]".contains(sign))
        };
        if !host.as_ref().is_none_or(is_host) {
            return Err("its host has letters, digits, `-`, `.` and a port only".to_owned());
        }
        Ok(Self { host, is_secure, path: path.to_owned() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn host_and_path_of_an_address_are_found() {
        let cases = [
            ("", None, false, ""),
            ("/", None, false, ""),
            ("/c/d", None, false, "/c/d"),
            ("https://a.b/c/", Some("a.b"), true, "/c"),
            ("http://A.b:8080", Some("a.b:8080"), false, ""),
        ];
        for (text, host, is_secure, path) in cases {
            let expected = BaseUrl { host: host.map(str::to_owned), is_secure, path: path.to_owned() };
            assert_eq!(text.parse(), Ok(expected), "{text}");
        }
        for text in ["a.b/c", "https://a.b/c d", "/{x}", "/a//b", "https:///a", "https://u@a.b"] {
            assert!(text.parse::<BaseUrl>().is_err(), "{text}");
        }
    }
}
