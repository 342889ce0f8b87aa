//! The place of the data of courses.

use clap::Args;
use tokio::runtime::{Builder, Runtime};

use crate::store::Address;
use crate::store::Store;
use crate::store::StoreFault;

use super::super::super::failure::Failure;
use super::super::unserved::FOLDER;

/// Where the data of courses are.
#[derive(Args, Debug)]
pub(super) struct Data {
    /// The folder of the data, or the address of a database of PostgreSQL
    #[arg(long = "data", value_name = "FOLDER|URL", default_value = FOLDER, value_parser = address, env = "MOMENTOUS_DATA", hide_env_values = true)]
    pub(super) address: Address,
}

impl Data {
    /// Does something with the data, beside the server that may work on them.
    pub(super) fn beside<T>(&self, work: impl AsyncFnOnce(Store) -> Result<T, StoreFault>) -> Result<T, Failure> {
        let done = runtime()?.block_on(async { work(Store::beside(&self.address).await?).await });
        done.map_err(|fault| self.failure(&fault))
    }

    /// The fault of the data, and the way out.
    pub(super) fn failure(&self, fault: &StoreFault) -> Failure {
        let help = match fault {
            StoreFault::Locked(_) => "stop the other server, or choose another folder with --data",
            StoreFault::Folder(..) => {
                "choose a folder that you may write with --data, or serve practice and simulators only with --no-courses"
            }
            StoreFault::Database(_) => "see whether the database runs, and whether --data names it rightly",
            StoreFault::NotEmpty => "name another folder or database with --data",
            _ => return Failure::unusable(fault.to_string()),
        };
        Failure::unusable(format!("{}: {fault}\nhelp: {help}", self.address))
    }
}

/// The runtime that waits for a database, or for a server of mail.
pub(super) fn runtime() -> Result<Runtime, Failure> {
    let runtime = Builder::new_multi_thread().enable_all().build();
    runtime.map_err(|error| Failure::unusable(format!("the program cannot go on: {error}")))
}

fn address(text: &str) -> Result<Address, String> {
    text.parse().map_err(|fault: StoreFault| fault.to_string())
}
