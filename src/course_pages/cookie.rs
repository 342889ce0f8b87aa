//! Cookies: random tokens that a browser sends along.

use axum::http::{HeaderMap, HeaderValue, header};

use momentous_web::Settings;

use super::session;

/// A cookie. Scripts cannot read it, and other sites cannot send it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Cookie {
    /// The session of somebody who has signed in.
    Session,
    /// The browser that has asked for a link by mail.
    Browser,
}

impl Cookie {
    const fn name(self) -> &'static str {
        match self {
            Self::Session => "momentous-session",
            Self::Browser => "momentous-browser",
        }
    }

    /// The milliseconds for which a browser keeps it.
    const fn lasts(self) -> i64 {
        match self {
            Self::Session => session::SESSION,
            Self::Browser => session::MAILED,
        }
    }

    /// The token that a browser sends.
    pub(super) fn sent(self, headers: &HeaderMap) -> Option<&str> {
        let cookies = headers.get_all(header::COOKIE).iter().filter_map(|value| value.to_str().ok());
        let mut pairs = cookies.flat_map(|text| text.split(';')).filter_map(|pair| pair.trim().split_once('='));
        pairs.find(|(name, _)| *name == self.name()).map(|(_, value)| value)
    }

    /// The header that gives a browser a token; without one, the browser forgets the one it has.
    pub(super) fn header(self, token: Option<&str>, settings: &Settings) -> Option<HeaderValue> {
        let path = if settings.base_path.is_empty() { "/" } else { &settings.base_path };
        let age = if token.is_some() { self.lasts() / 1000 } else { 0 };
        let secure = if settings.is_secure { "; Secure" } else { "" };
        let (name, token) = (self.name(), token.unwrap_or_default());
        let text = format!("{name}={token}; Path={path}; Max-Age={age}; HttpOnly; SameSite=Lax{secure}");
        HeaderValue::from_str(&text).ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cookie_is_read_as_it_is_written() {
        let settings = Settings { base_path: "/momentous".to_owned(), is_secure: true, ..Settings::default() };
        let cookie = Cookie::Session.header(Some("t0k3n"), &settings).unwrap();
        let text = cookie.to_str().unwrap();
        assert_eq!(text, "momentous-session=t0k3n; Path=/momentous; Max-Age=1209600; HttpOnly; SameSite=Lax; Secure");
        let mut headers = HeaderMap::new();
        headers.insert(header::COOKIE, HeaderValue::from_static("momentous-browser=a; momentous-session=t0k3n; c=d"));
        assert_eq!(Cookie::Session.sent(&headers), Some("t0k3n"));
        assert_eq!(Cookie::Browser.sent(&headers), Some("a"));
    }
}
