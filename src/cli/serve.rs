//! `momentous serve`

use std::net::SocketAddr;
use std::path::PathBuf;

use clap::Args;

use crate::exercise::calls::Limits;
use crate::web::NotServed;
use crate::web::Settings;
use crate::web::serve;

use super::exit::Exit;
use super::failure::Failure;
use super::output::Output;

const HELP: &str = "\
Examples:
  momentous serve                                    practice and simulators on http://127.0.0.1:8080
  momentous serve --bind 0.0.0.0:80                  for everybody who reaches this machine
  momentous serve --base-url https://physics.example.edu/momentous
  momentous serve --watch problem_bank               an author's preview: pages follow the files as they are saved

Ctrl-C stops it.";

/// Serve practice, solutions and simulators as web pages
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub(super) struct Serve {
    /// The address on which to listen
    #[arg(long, value_name = "ADDRESS", default_value = "127.0.0.1:8080")]
    bind: SocketAddr,
    /// Where readers reach the pages, where a proxy stands before them
    #[arg(long, value_name = "URL", default_value = "", value_parser = base_path)]
    base_url: String,
    /// Follow the problem files of this folder as they are saved
    #[arg(long, value_name = "FOLDER")]
    watch: Option<PathBuf>,
    /// Take templates from this folder in place of the built-in ones
    #[arg(long, value_name = "FOLDER")]
    templates: Option<PathBuf>,
}

impl Serve {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        let settings = Settings {
            limits: Limits::default(),
            bind: self.bind,
            base_path: self.base_url.clone(),
            watch: self.watch.clone(),
            templates: self.templates.clone(),
        };
        let base = self.base_url.clone();
        let told = serve(settings, |address| {
            // Where nobody reads standard output there is nobody to tell.
            let _ = Output::whole(None, &format!("momentous serves http://{address}{base}/\nCtrl-C stops it.\n"));
        });
        told.map_err(|reason| match reason {
            NotServed::Faults(faults) => Failure::from(faults),
            NotServed::Address(..) => {
                Failure::unusable(format!("{reason}\nhelp: choose another with --bind, such as 127.0.0.1:8081"))
            }
            NotServed::Broken(_) => Failure::unusable(reason.to_string()),
        })?;
        Ok(Exit::Fine)
    }
}

/// The path of an address, without a slash at its end.
fn base_path(text: &str) -> Result<String, String> {
    let rest = text.strip_prefix("https://").or_else(|| text.strip_prefix("http://"));
    let path = match rest {
        Some(rest) => rest.find('/').map_or("", |slash| &rest[slash..]),
        None if text.is_empty() || text.starts_with('/') => text,
        None => return Err("write an address such as https://physics.example.edu/momentous".to_owned()),
    };
    let path = path.trim_end_matches('/');
    let is_plain = |letter: char| letter.is_ascii_alphanumeric() || "/-_.~".contains(letter);
    if path.chars().all(is_plain) && !path.contains("//") {
        Ok(path.to_owned())
    } else {
        Err("its path has letters, digits, `-`, `_`, `.` and `~` only".to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_path_of_an_address_is_found() {
        for (text, path) in [("", ""), ("/", ""), ("https://a.b/c/", "/c"), ("http://a.b", ""), ("/c/d", "/c/d")] {
            assert_eq!(base_path(text).as_deref(), Ok(path), "{text}");
        }
        assert!(["a.b/c", "https://a.b/c d", "/{x}", "/a//b"].iter().all(|text| base_path(text).is_err()));
    }
}
