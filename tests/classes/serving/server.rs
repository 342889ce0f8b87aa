//! The program as a process.

use std::fs::File;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};

use tempfile::TempDir;

/// A server, until it is dropped.
pub struct Server {
    child: Child,
    pub address: String,
}

/// A folder of a test's own, with a bank of one problem: a check compiles all of a bank.
pub fn folder() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let topic = folder.path().join("problem_bank/impact");
    std::fs::create_dir_all(&topic).unwrap();
    std::fs::write(topic.join("two-carts.yaml"), include_str!("../../../problem_bank/impact/two-carts.yaml")).unwrap();
    folder
}

/// The program with arguments, in a folder.
pub fn program(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_momentous"));
    command.args(arguments).current_dir(folder).env_remove("MOMENTOUS_DATA");
    command
}

/// Runs a command to its end: its exit code, and what it printed.
pub fn run(folder: &Path, arguments: &[&str]) -> (i32, String) {
    let output = program(folder, arguments).output().unwrap();
    let text = [output.stdout, output.stderr].concat();
    (output.status.code().unwrap(), String::from_utf8(text).unwrap())
}

impl Server {
    /// A server whose data are in `data` of a folder; its log goes to a file `log` there.
    pub fn start(folder: &Path) -> Self {
        let log = File::create(folder.join("log")).unwrap();
        let mut command = program(folder, &["serve", "--bind", "127.0.0.1:0", "--data", "data"]);
        let mut child = command.stdout(Stdio::piped()).stderr(log).spawn().unwrap();
        let mut told = String::new();
        BufReader::new(child.stdout.as_mut().unwrap()).read_line(&mut told).unwrap();
        let address = told.trim().rsplit("http://").next().unwrap().trim_end_matches('/').to_owned();
        Self { child, address }
    }

    /// The whole response to a request for a path.
    pub fn get(&self, path: &str) -> String {
        let mut stream = TcpStream::connect(&self.address).unwrap();
        write!(stream, "GET {path} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n\r\n", self.address).unwrap();
        let mut response = String::new();
        stream.read_to_string(&mut response).unwrap();
        response
    }

    /// Ends it as an operator does, so that the log is whole.
    pub fn stop(mut self) {
        let id = self.child.id().to_string();
        assert!(Command::new("kill").arg(id).status().unwrap().success());
        assert!(self.child.wait().unwrap().success());
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        // One that has ended already cannot be killed.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
