//! The server of mail, by which people sign in.

use clap::Args;

use crate::course_pages::Post;
use crate::web::Settings;

use super::super::super::failure::Failure;

/// The server of mail, where links to sign in are sent by one.
#[derive(Args, Debug)]
pub(super) struct Mail {
    /// The server that takes letters with links to sign in, such as `smtps://name:password@mail.example.edu`
    #[arg(long, value_name = "URL", env = "MOMENTOUS_SMTP", hide_env_values = true, requires = "mail_from")]
    pub(super) smtp: Option<String>,
    /// Who those letters are from, such as "Momentous <momentous@example.edu>"
    #[arg(long, value_name = "SENDER", requires = "smtp")]
    pub(super) mail_from: Option<String>,
}

impl Mail {
    /// The server of mail, where one is named. Its letters hold links, which need the address of the pages.
    pub(super) fn post(&self, settings: &Settings) -> Result<Option<Post>, Failure> {
        let (Some(server), Some(from)) = (&self.smtp, &self.mail_from) else { return Ok(None) };
        if settings.host.is_none() {
            let message = "letters hold links to this server, and nothing says where readers reach it";
            let help = "name the address of the pages: --base-url https://physics.example.edu";
            return Err(Failure::unusable(format!("{message}\nhelp: {help}")));
        }
        Post::new(server, from).map(Some).map_err(Failure::unusable)
    }

    /// Whether letters go readably through a network: not to this machine, and with no TLS.
    pub(super) fn is_readable(&self) -> bool {
        let Some(server) = self.smtp.as_deref().and_then(|server| server.strip_prefix("smtp://")) else { return false };
        let (address, options) = server.split_once('?').unwrap_or((server, ""));
        let host = address.rsplit('@').next().unwrap_or_default();
        let is_here = ["127.0.0.1", "localhost", "[::1]"].iter().any(|here| host.starts_with(here));
        !is_here && !options.contains("tls=required")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_that_others_can_read_are_told() {
        let cases = [
            ("smtps://mail.example.edu", false),
            ("smtp://name:password@mail.example.edu?tls=required", false),
            ("smtp://127.0.0.1:25", false),
            ("smtp://mail.example.edu", true),
            ("smtp://localhost@mail.example.edu?tls=opportunistic", true),
        ];
        for (server, is_readable) in cases {
            let mail = Mail { smtp: Some(server.to_owned()), mail_from: None };
            assert_eq!(mail.is_readable(), is_readable, "{server}");
        }
    }
}
