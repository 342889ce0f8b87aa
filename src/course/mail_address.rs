//! The address to which letters go.

use std::fmt;

use lettre::Address;

/// The address of a person, to which links to sign in are sent. Large and small letters are the same.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct MailAddress(Address);

impl MailAddress {
    /// Reads an address as it is typed.
    ///
    /// # Errors
    /// Where it is none.
    ///
    /// ```
    /// use momentous_course::MailAddress;
    ///
    /// let address = MailAddress::read(" Ada@Example.edu ").expect("an address");
    /// assert_eq!(address.to_string(), "ada@example.edu");
    /// assert!(MailAddress::read("ada at example").is_err());
    /// ```
    pub fn read(text: &str) -> Result<Self, NoMailAddress> {
        text.trim().to_lowercase().parse().map(Self).map_err(|_| NoMailAddress)
    }

    /// The address as those take it who send letters.
    #[must_use]
    pub const fn address(&self) -> &Address {
        &self.0
    }
}

impl fmt::Display for MailAddress {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(formatter)
    }
}

/// A text that is no address.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("this is no e-mail address; write one such as ada@example.edu")]
pub struct NoMailAddress;
