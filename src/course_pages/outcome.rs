//! Why a page is not shown.

use momentous_exercise::calls::{Refused, RefusedKind};
use momentous_fault::Faults;
use momentous_store::StoreFault;

use momentous_web::NotDone;

/// Why a page is not shown.
#[derive(Debug)]
pub(crate) enum NotShown {
    /// Something in the request, with the way out.
    Refused(Refused),
    /// Whoever asks has to sign in first.
    SignIn,
    /// Whoever asks may not see it: why.
    Forbidden(&'static str),
    /// A form that did not come from a page of this server.
    Origin,
    /// A form whose end did not come in time.
    Slow,
    /// Too many in a short time.
    TooMany,
    /// The state has changed since the page was made: how.
    Conflict(String),
    /// It cannot be done as things stand: why.
    NotPossible(String),
    /// There are no workers free, or work broke off.
    NotDone(NotDone),
    /// The database; the log has the reason.
    Store(StoreFault),
}

impl NotShown {
    /// There is nothing of that name.
    pub(super) fn missing(message: impl Into<String>) -> Self {
        Self::Refused(Refused::new(RefusedKind::Unknown, message).help("your courses are listed on the page Courses"))
    }

    /// A field cannot be read: what is wrong.
    pub(super) fn field(message: impl Into<String>) -> Self {
        Self::Refused(Refused::new(RefusedKind::Invalid, message))
    }
}

impl From<Refused> for NotShown {
    fn from(refused: Refused) -> Self {
        Self::Refused(refused)
    }
}

impl From<StoreFault> for NotShown {
    fn from(fault: StoreFault) -> Self {
        Self::Store(fault)
    }
}

impl From<NotDone> for NotShown {
    fn from(reason: NotDone) -> Self {
        Self::NotDone(reason)
    }
}

impl From<Faults> for NotShown {
    fn from(faults: Faults) -> Self {
        Self::Refused(Refused::fault(&faults))
    }
}
