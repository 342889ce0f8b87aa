//! The server as a process of its own.

use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};

use momentous::store::Address;

/// A server as a process of its own, until it is killed or dropped.
pub struct Server {
    pub process: Child,
    /// Host and port.
    pub address: String,
}

impl Server {
    /// A server in a folder, over these data.
    pub fn start(folder: &Path, data: &Address) -> Self {
        Self::at(folder, data, "127.0.0.1:0")
    }

    /// The same at a given host and port.
    pub fn at(folder: &Path, data: &Address, address: &str) -> Self {
        Self::run(Command::new(env!("CARGO_BIN_EXE_momentous")), folder, data, address)
    }

    /// The same, whose files can be kept from growing: it is told so, and does not end.
    #[allow(dead_code, reason = "a bench needs no such server")]
    pub fn bounded(folder: &Path, data: &Address) -> Self {
        let mut command = Command::new("/bin/sh");
        command.args(["-c", "trap '' XFSZ; exec \"$@\"", "sh", env!("CARGO_BIN_EXE_momentous")]);
        Self::run(command, folder, data, "127.0.0.1:0")
    }

    fn run(mut command: Command, folder: &Path, data: &Address, address: &str) -> Self {
        let data = match data {
            Address::Folder(folder) => folder.display().to_string(),
            Address::Postgres(url) => url.clone(),
        };
        command.args(["serve", "--quiet", "--bind", address, "--data", &data]).current_dir(folder);
        let mut process = command.stdout(Stdio::piped()).spawn().unwrap();
        let mut told = String::new();
        BufReader::new(process.stdout.as_mut().unwrap()).read_line(&mut told).unwrap();
        let address = told.trim().rsplit("http://").next().unwrap().trim_end_matches('/').to_owned();
        Self { process, address }
    }

    /// By SIGKILL: it has no time to do anything more.
    pub fn kill(&mut self) {
        // One that has ended already cannot be killed.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        self.kill();
    }
}
