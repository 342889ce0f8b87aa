//! A server with courses.

use std::net::SocketAddr;
use std::sync::{Arc, OnceLock};

use momentous_store::{Store, StoreFault};
use momentous_web::{Companion, NotServed, Settings};

use super::clock::Clock;
use super::invite;
use super::mail::Post;
use super::state::Courses;

/// The name by which the first operator signs in.
const FIRST: &str = "operator";

/// Serves as [`momentous_web::serve`] does, with the courses whose data are at an address. `post` sends letters, where there is one;
/// `clock` says what is in time; `ready` hears the address of the pages, and the path of a link for the first operator where nobody can
/// sign in yet.
///
/// # Errors
/// Those of [`momentous_web::serve`]; [`NotServed::Data`] with a [`StoreFault`] where the data cannot be used.
pub fn serve(
    settings: Settings,
    data: &momentous_store::Address,
    post: Option<Post>,
    clock: Clock,
    ready: impl FnOnce(SocketAddr, Option<String>),
) -> Result<(), NotServed> {
    let link = OnceLock::new();
    let companion = async {
        let (courses, first) = open(data, clock).await.map_err(|fault| NotServed::Data(Box::new(fault)))?;
        // It is set once, here.
        let _ = link.set(first);
        let companion: Arc<dyn Companion> = Arc::new(courses.with_post(post));
        Ok(Some(companion))
    };
    momentous_web::serve(settings, companion, |address| ready(address, link.get().cloned().flatten()))
}

/// The courses at an address, and the path of a link for the first operator where nobody can sign in yet.
async fn open(data: &momentous_store::Address, clock: Clock) -> Result<(Courses, Option<String>), StoreFault> {
    let store = Store::serve(data).await?;
    let first =
        if store.is_empty().await? { invite::add(&store, FIRST, "Operator", true, &clock).await? } else { None };
    Ok((Courses::new(store, clock), first))
}
