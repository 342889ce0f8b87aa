//! Why nothing is served, with the way out.

use crate::web::NotServed;

use super::super::failure::Failure;

/// The folder in which a program with courses keeps them where no other is named.
pub(super) const FOLDER: &str = "momentous-data";

/// The reason as the program says it.
pub(super) fn failure(reason: NotServed) -> Failure {
    match reason {
        NotServed::Faults(faults) => Failure::from(faults),
        NotServed::Address(..) => {
            Failure::unusable(format!("{reason}\nhelp: choose another with --bind, such as 127.0.0.1:8081"))
        }
        NotServed::Data(_) | NotServed::Broken(_) => Failure::unusable(reason.to_string()),
    }
}
