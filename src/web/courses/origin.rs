//! Whether a form was sent from a page of this server.

use axum::http::{HeaderMap, header};

/// Whether a request that changes something was sent from a page of this server: browsers say where a form came from, and no page
/// of another site can make them say something else.
///
/// `host` is the host of the server as readers see it, where it was said at the start.
pub(super) fn is_own(headers: &HeaderMap, host: Option<&str>) -> bool {
    let text = |name: &header::HeaderName| headers.get(name).and_then(|value| value.to_str().ok());
    let own = host.or_else(|| text(&header::HOST));
    match text(&header::ORIGIN) {
        Some(origin) => {
            let from = origin.split_once("://").map(|(_, from)| from);
            from.is_some() && from == own
        }
        None => headers.get("sec-fetch-site").is_some_and(|site| site == "same-origin"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forms_of_other_sites_are_known() {
        let cases: [(&[(&'static str, &str)], bool); 8] = [
            (&[("origin", "http://a.b:80"), ("host", "a.b:80")], true),
            (&[("origin", "https://a.b"), ("host", "a.b")], true),
            (&[("origin", "https://evil.b"), ("host", "a.b")], false),
            (&[("origin", "null"), ("host", "a.b")], false),
            (&[("host", "a.b")], false),
            (&[("sec-fetch-site", "same-origin"), ("host", "a.b")], true),
            (&[("sec-fetch-site", "same-site"), ("host", "a.b")], false),
            (&[("sec-fetch-site", "same-origin"), ("origin", "https://evil.b"), ("host", "a.b")], false),
        ];
        for (given, expected) in cases {
            let headers: HeaderMap =
                given.iter().filter_map(|(name, value)| Some((name.parse().ok()?, value.parse().ok()?))).collect();
            assert_eq!(is_own(&headers, None), expected, "{given:?}");
        }
        let behind: HeaderMap = [("origin", "https://a.b"), ("host", "127.0.0.1:8080")]
            .into_iter()
            .filter_map(|(name, value)| Some((name.parse::<header::HeaderName>().ok()?, value.parse().ok()?)))
            .collect();
        assert!(is_own(&behind, Some("a.b")) && !is_own(&behind, None));
    }
}
