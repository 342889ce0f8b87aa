//! Whether a form was sent from a page of this server.

use axum::http::{HeaderMap, header};

use momentous_web::Settings;

/// Whether a request that changes something was sent from a page of this server: browsers say where a form came from, and no page
/// of another site can make them say something else. Where the host of the server as readers see it was not said at the start, it is the
/// one that the request asks.
pub(super) fn is_own(headers: &HeaderMap, settings: &Settings) -> bool {
    let text = |name: &header::HeaderName| headers.get(name).and_then(|value| value.to_str().ok());
    let host = settings.host.as_deref().or_else(|| text(&header::HOST));
    match text(&header::ORIGIN) {
        Some(origin) => {
            let from = origin.strip_prefix(settings.scheme()).and_then(|rest| rest.strip_prefix("://"));
            from.is_some() && from == host
        }
        None => headers.get("sec-fetch-site").is_some_and(|site| site == "same-origin"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// How the server is set up, what a request says, and whether it is the server's own.
    type Case<'a> = (&'a Settings, &'a [(&'static str, &'a str)], bool);

    #[test]
    fn forms_of_other_sites_are_known() {
        let plain = Settings::default();
        let behind = Settings { host: Some("a.b".to_owned()), is_secure: true, ..Settings::default() };
        let cases: [Case<'_>; 12] = [
            (&plain, &[("origin", "http://a.b:80"), ("host", "a.b:80")], true),
            (&plain, &[("origin", "https://a.b"), ("host", "a.b")], false),
            (&plain, &[("origin", "xx://a.b"), ("host", "a.b")], false),
            (&plain, &[("origin", "http://evil.b"), ("host", "a.b")], false),
            (&plain, &[("origin", "null"), ("host", "a.b")], false),
            (&plain, &[("host", "a.b")], false),
            (&plain, &[("sec-fetch-site", "same-origin"), ("host", "a.b")], true),
            (&plain, &[("sec-fetch-site", "same-site"), ("host", "a.b")], false),
            (&plain, &[("sec-fetch-site", "same-origin"), ("origin", "http://evil.b"), ("host", "a.b")], false),
            (&behind, &[("origin", "https://a.b"), ("host", "127.0.0.1:8080")], true),
            (&behind, &[("origin", "http://a.b"), ("host", "127.0.0.1:8080")], false),
            (&plain, &[("origin", "https://a.b"), ("host", "127.0.0.1:8080")], false),
        ];
        for (settings, given, expected) in cases {
            let headers: HeaderMap =
                given.iter().filter_map(|(name, value)| Some((name.parse().ok()?, value.parse().ok()?))).collect();
            assert_eq!(is_own(&headers, settings), expected, "{given:?}");
        }
    }
}
