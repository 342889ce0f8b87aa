//! How a server is set up.

use std::net::SocketAddr;
use std::path::PathBuf;

use ipnet::IpNet;

use momentous_exercise::calls::Limits;

/// How a server is set up.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Settings {
    /// The address on which it listens.
    pub bind: SocketAddr,
    /// The path at which its pages begin, as a reader's browser sees it: the one that a proxy puts before them, without a slash
    /// at its end.
    pub base_path: String,
    /// The host and port of that address, where a proxy stands before the server: forms come from there.
    pub host: Option<String>,
    /// Whether readers reach it by TLS: cookies then go no other way.
    pub is_secure: bool,
    /// The proxies before the server: for whom they ask is believed.
    pub trusted_proxies: Vec<IpNet>,
    /// A folder of problems that is followed as its files are saved.
    pub watch: Option<PathBuf>,
    /// A folder of templates in place of the built-in ones.
    pub templates: Option<PathBuf>,
    /// The address on which operators read what is measured; it is measured for nobody without one.
    pub metrics: Option<SocketAddr>,
    /// Whether each request is told on standard error.
    pub log: bool,
    /// The program that checks problem files; the running one where none is named.
    pub program: Option<PathBuf>,
    /// How much a request may take.
    pub limits: Limits,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            bind: SocketAddr::from(([127, 0, 0, 1], 8080)),
            base_path: String::new(),
            host: None,
            is_secure: false,
            trusted_proxies: Vec::new(),
            watch: None,
            templates: None,
            program: None,
            metrics: None,
            log: false,
            limits: Limits::default(),
        }
    }
}

impl Settings {
    /// How readers reach the pages.
    #[must_use]
    pub const fn scheme(&self) -> &'static str {
        if self.is_secure { "https" } else { "http" }
    }

    /// The address at which this machine reaches the pages.
    #[must_use]
    pub fn local(&self) -> SocketAddr {
        match self.bind.ip() {
            ip if !ip.is_unspecified() => self.bind,
            _ => SocketAddr::from(([127, 0, 0, 1], self.bind.port())),
        }
    }
}
