//! Rights to see a page.

use momentous_course::Role;

use super::outcome::NotShown;
use super::visit::Visit;

/// The people who may see a page, and do what it offers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Who {
    /// Everybody.
    Anyone,
    /// Whoever has signed in.
    SignedIn,
    /// Whoever has at least this role in the course of the address.
    Member(Role),
    /// The operator of the server.
    Operator,
}

impl Who {
    /// Whether a visitor may see the page. Somebody who is not in a course is not told that there is one.
    pub(super) fn admits(self, visit: &Visit) -> Result<(), NotShown> {
        let Some(person) = visit.visitor.as_ref().map(|visitor| &visitor.person) else {
            return if self == Self::Anyone { Ok(()) } else { Err(NotShown::SignIn) };
        };
        match self {
            Self::Anyone | Self::SignedIn => Ok(()),
            Self::Operator if person.operator => Ok(()),
            Self::Operator => Err(NotShown::Forbidden("this page is for those who run the server")),
            Self::Member(least) => match &visit.place {
                None => Err(NotShown::missing("there is no such course, or you are not in it")),
                Some(place) if place.member.role >= least => Ok(()),
                Some(_) => Err(NotShown::Forbidden("this page is for those who teach the course")),
            },
        }
    }
}
