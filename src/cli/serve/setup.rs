//! How the server is set up: the options that `momentous serve` and `momentous serve check` share.

use std::net::IpAddr;
use std::net::SocketAddr;
use std::path::PathBuf;

use clap::Args;
use ipnet::IpNet;

use crate::web::Settings;

use super::base_url::BaseUrl;
use super::courses::Courses;

/// How the server is set up.
#[derive(Args, Debug)]
pub(super) struct Setup {
    /// The address on which to listen
    #[arg(long, value_name = "ADDRESS", default_value = "127.0.0.1:8080")]
    pub(super) bind: SocketAddr,
    /// Where readers reach the pages, where a proxy stands before them
    #[arg(long, value_name = "URL", default_value = "")]
    pub(super) base_url: BaseUrl,
    /// A proxy before the server, by its address or network: the readers' addresses are taken from its `X-Forwarded-For`. More than one
    /// can be given
    #[arg(long, value_name = "ADDRESS", value_parser = proxy)]
    pub(super) trusted_proxy: Vec<IpNet>,
    #[command(flatten)]
    pub(super) courses: Courses,
    /// The address on which operators read `/metrics`: one that no proxy leads to, such as 127.0.0.1:9464
    #[arg(long, value_name = "ADDRESS")]
    pub(super) metrics: Option<SocketAddr>,
    /// Follow the problem files of this folder as they are saved
    #[arg(long, value_name = "FOLDER")]
    pub(super) watch: Option<PathBuf>,
    /// Take templates from this folder in place of the built-in ones
    #[arg(long, value_name = "FOLDER")]
    pub(super) templates: Option<PathBuf>,
}

impl Setup {
    /// The settings of the server.
    pub(super) fn settings(&self) -> Settings {
        Settings {
            bind: self.bind,
            base_path: self.base_url.path.clone(),
            host: self.base_url.host.clone(),
            is_secure: self.base_url.is_secure,
            trusted_proxies: self.trusted_proxy.clone(),
            metrics: self.metrics,
            watch: self.watch.clone(),
            templates: self.templates.clone(),
            ..Settings::default()
        }
    }
}

/// An address, or a network such as `10.0.0.0/8`.
fn proxy(text: &str) -> Result<IpNet, String> {
    let address = || text.parse::<IpAddr>().map(|address| IpNet::from(address.to_canonical()));
    text.parse::<IpNet>()
        .or_else(|_| address())
        .map_err(|_| "write an address such as 127.0.0.1, or a network such as 10.0.0.0/8".to_owned())
}
