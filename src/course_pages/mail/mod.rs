//! Signing in by mail: a link is sent to the address of a person, works once, for a quarter of an hour, in the browser that asked for it.
//!
//! An address is set by the person, who shows by such a link that it is theirs, or by whoever runs the server; never by a course. What a
//! page answers is the same whether somebody has the address or nobody.

mod address;
mod address_form;
mod letter;
mod post;
mod sign_in;

pub(super) use address::change;
pub(super) use address_form::AddressForm;
pub use post::Post;
pub(super) use sign_in::{ask, asked_page, link, link_page};
