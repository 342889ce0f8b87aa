//! The server that takes letters.

use std::error::Error;
use std::time::Duration;

use lettre::message::Mailbox;
use lettre::message::header::ContentType;
use lettre::{AsyncSmtpTransport, AsyncTransport, Message, Tokio1Executor};

use momentous_course::MailAddress;

use super::super::session;

/// The longest time that a server of mail may take for one letter.
const PATIENCE: Duration = Duration::from_secs(20);

/// A letter.
pub(super) struct Letter {
    pub(super) to: MailAddress,
    pub(super) subject: String,
    pub(super) text: String,
}

/// The server that takes letters, and who writes them.
#[derive(Clone, Debug)]
pub struct Post {
    transport: AsyncSmtpTransport<Tokio1Executor>,
    from: Mailbox,
}

impl Post {
    /// Letters by the server at an address such as `smtps://name:password@mail.example.edu`, from a sender such as
    /// `Momentous <momentous@example.edu>`. Nothing is sent yet.
    ///
    /// # Errors
    /// Where one of them cannot be read: why, and how it is written.
    ///
    /// ```
    /// use momentous_course_pages::Post;
    ///
    /// assert!(Post::new("smtps://mail.example.edu", "Momentous <momentous@example.edu>").is_ok());
    /// assert!(Post::new("mail.example.edu", "momentous@example.edu").is_err());
    /// ```
    pub fn new(server: &str, from: &str) -> Result<Self, String> {
        let transport = AsyncSmtpTransport::<Tokio1Executor>::from_url(server).map_err(|_| {
            "the server of mail is written as smtps://name:password@mail.example.edu, smtp://mail.example.edu?tls=required, or \
             smtp://127.0.0.1:25 on this machine"
                .to_owned()
        })?;
        let from = from.parse().map_err(|_| {
            "the sender of letters is written as momentous@example.edu, or Momentous <momentous@example.edu>".to_owned()
        })?;
        Ok(Self { transport: transport.timeout(Some(PATIENCE)).build(), from })
    }

    /// Whether the server answers, and takes the name and password.
    ///
    /// # Errors
    /// Where it does not: why.
    pub async fn answers(&self) -> Result<(), String> {
        match self.transport.test_connection().await {
            Ok(true) => Ok(()),
            Ok(false) => Err("the server of mail takes no letters".to_owned()),
            Err(error) => Err(reason(&error)),
        }
    }

    /// Sends a letter.
    pub(super) async fn send(&self, letter: Letter) -> Result<(), String> {
        let number = session::secret();
        let message = Message::builder()
            .message_id(Some(format!("<{number}@{}>", self.from.email.domain())))
            .from(self.from.clone())
            .to(Mailbox::new(None, letter.to.address().clone()))
            .subject(letter.subject)
            .header(ContentType::TEXT_PLAIN)
            .body(letter.text)
            .map_err(|error| reason(&error))?;
        self.transport.send(message).await.map(|_| ()).map_err(|error| reason(&error))
    }
}

/// An error with what led to it.
fn reason(error: &dyn Error) -> String {
    let mut all = error.to_string();
    let mut next = error.source();
    while let Some(error) = next {
        let said = error.to_string();
        if !all.contains(&said) {
            all = format!("{all}: {said}");
        }
        next = error.source();
    }
    all
}
