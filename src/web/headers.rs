//! Headers that every response has.

use axum::http::HeaderName;
use axum::http::HeaderValue;
use axum::http::header;

/// Headers of every response. Pages load nothing from elsewhere and hold no code and no style of their own.
pub(super) const HEADERS: [(HeaderName, HeaderValue); 5] = [
    (
        header::CONTENT_SECURITY_POLICY,
        HeaderValue::from_static(
            "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; font-src 'self'; \
             connect-src 'self'; form-action 'self'; base-uri 'none'; frame-ancestors 'none'",
        ),
    ),
    (header::X_CONTENT_TYPE_OPTIONS, HeaderValue::from_static("nosniff")),
    (header::REFERRER_POLICY, HeaderValue::from_static("same-origin")),
    (HeaderName::from_static("cross-origin-opener-policy"), HeaderValue::from_static("same-origin")),
    (
        HeaderName::from_static("permissions-policy"),
        HeaderValue::from_static("camera=(), geolocation=(), microphone=()"),
    ),
];

/// The header for readers who come by TLS: their browsers come no other way for two years.
pub(super) const BY_TLS: (HeaderName, HeaderValue) =
    (header::STRICT_TRANSPORT_SECURITY, HeaderValue::from_static("max-age=63072000"));

/// For pages: they follow their bank.
pub(super) const ANEW: HeaderValue = HeaderValue::from_static("no-cache");

/// For files whose address changes with their contents.
pub(super) const FOR_EVER: HeaderValue = HeaderValue::from_static("public, max-age=31536000, immutable");

/// For pictures of the gallery: who may see them may change.
pub(super) const A_WHILE: HeaderValue = HeaderValue::from_static("private, max-age=3600");

/// The policy of a picture, which holds its own style and nothing else.
pub(super) const OF_PICTURES: HeaderValue = HeaderValue::from_static("default-src 'none'; style-src 'unsafe-inline'");
