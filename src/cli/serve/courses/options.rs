//! The options that say where courses are, and a server with them.

use std::net::SocketAddr;

use clap::Args;

use crate::course_pages::{self, Clock};
use crate::store::StoreFault;
use crate::web::{self, NotServed, Settings};

use super::super::super::failure::Failure;
use super::super::unserved::failure;
use super::data::Data;
use super::mail::Mail;

/// Where the data of courses are, unless there are to be none.
#[derive(Args, Debug)]
pub(in crate::cli::serve) struct Courses {
    #[command(flatten)]
    pub(super) data: Data,
    /// Serve practice and simulators only, and keep nothing
    #[arg(long = "no-courses")]
    pub(super) practice_only: bool,
    #[command(flatten)]
    pub(super) mail: Mail,
}

impl Courses {
    /// Serves the pages with courses, unless they are left out.
    pub(in crate::cli::serve) fn serve(
        &self,
        settings: Settings,
        ready: impl FnOnce(SocketAddr, Option<String>),
    ) -> Result<(), Failure> {
        let post = self.mail.post(&settings)?;
        let served = if self.practice_only {
            web::serve(settings, async { Ok(None) }, |address| ready(address, None))
        } else {
            course_pages::serve(settings, &self.data.address, post, Clock::default(), ready)
        };
        served.map_err(|reason| match reason {
            NotServed::Data(fault) => match fault.downcast::<StoreFault>() {
                Ok(fault) => self.data.failure(&fault),
                Err(other) => Failure::unusable(other.to_string()),
            },
            other => failure(other),
        })
    }
}
