//! A practice page: problems together with the engine that draws, marks and solves them, for a browser without a server.

mod scorm;

use std::io::Write;
use std::path::Path;

use base64::Engine as _;
use base64::engine::general_purpose::{STANDARD, URL_SAFE_NO_PAD};
use serde::Serialize;
use sha2::{Digest, Sha256};

use momentous_render::Site;

use super::NotWritten;
use super::package::Package;

/// The page in a folder or a package.
pub const PAGE_FILE: &str = "index.html";
/// The engine beside it.
pub const ENGINE_FILE: &str = "engine.wasm.gz";

/// The style of the page around the frame in which problems are shown.
const STYLE: &str = include_str!("../../../templates/page/page.css");

macro_rules! script {
    ($name:literal) => {
        include_str!(concat!("../../../templates/page/", $name, ".js"))
    };
}

/// The scripts of the page, each after those that it uses.
const SCRIPTS: [&str; 4] = [script!("engine"), script!("memory"), script!("assets"), script!("shell")];
/// The script that tells a learning platform.
const PLATFORM: &str = script!("platform");
/// The script that opens the page.
const START: &str = script!("start");
/// The scripts in frames in place of those that ask a server.
const IN_FRAMES: [(&str, &str); 2] =
    [("address.js", script!("in_frames/address")), ("engine.js", script!("in_frames/engine"))];

/// A problem of a page.
#[derive(Clone, Debug, Serialize)]
pub struct PageProblem {
    /// The name of its file.
    pub name: String,
    /// The file.
    pub text: String,
    /// The settings of its course.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub course: Option<String>,
    /// Its identity.
    #[serde(skip)]
    pub id: String,
}

/// Messages to a learning platform.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reported {
    /// Which problems were right, and that all were.
    Completion,
    /// The share of them, too. Whoever has the page can forge it.
    Score,
}

/// Problems and the engine.
#[derive(Clone, Debug)]
pub struct PracticePage<'a> {
    /// The title of the page.
    pub title: String,
    /// The problems, in the order of their identities.
    pub problems: Vec<PageProblem>,
    /// The module of WebAssembly that `src/browser/build` makes, compressed with gzip.
    pub engine: &'a [u8],
    /// The folder with the templates of a course, where there is one.
    pub templates: Option<&'a Path>,
}

/// The place of the engine.
#[derive(Clone, Copy, PartialEq, Eq)]
enum EnginePlace {
    Inside,
    Beside,
}

#[derive(Serialize)]
struct Values<'a> {
    title: &'a str,
    style: &'a str,
    /// The address that is shown first.
    start: String,
    /// A name for what a browser keeps of these problems.
    key: String,
    /// The identities of the problems, as JSON.
    ids: String,
    problems: String,
    engine: String,
    beside: Option<&'a str>,
    in_frames: [(&'a str, &'a str); 2],
    scripts: Vec<&'a str>,
    /// Whether a platform is told a score.
    is_scored: bool,
}

impl PracticePage<'_> {
    /// The page as one file.
    ///
    /// # Errors
    /// The template is at fault.
    pub fn one_file(&self) -> Result<String, NotWritten> {
        self.filled(EnginePlace::Inside, None)
    }

    /// The page that loads its engine from [`ENGINE_FILE`] beside it, for a web space.
    ///
    /// # Errors
    /// The template is at fault.
    pub fn beside_its_engine(&self) -> Result<String, NotWritten> {
        self.filled(EnginePlace::Beside, None)
    }

    /// The page as a package of SCORM 1.2.
    ///
    /// # Errors
    /// The template is at fault, or nothing can be written.
    pub fn scorm(&self, out: impl Write, reported: Reported) -> Result<(), NotWritten> {
        let mut package = Package::new(out);
        package.put("imsmanifest.xml", &scorm::manifest(&self.title, &self.key(), PAGE_FILE, ENGINE_FILE))?;
        package.put(PAGE_FILE, &self.filled(EnginePlace::Beside, Some(reported))?)?;
        package.begin(ENGINE_FILE)?;
        package.write_all(self.engine)?;
        package.finish()
    }

    fn filled(&self, place: EnginePlace, reported: Option<Reported>) -> Result<String, NotWritten> {
        let start = match &*self.problems {
            [only] => format!("/practice/{}?seed=1", only.id),
            _ => "/".to_owned(),
        };
        let platform = reported.map(|_| PLATFORM);
        let is_inside = place == EnginePlace::Inside;
        let ids: Vec<&str> = self.problems.iter().map(|problem| &*problem.id).collect();
        let values = Values {
            title: &self.title,
            style: STYLE,
            start,
            key: self.key(),
            ids: as_json(&ids)?,
            problems: as_json(&self.problems)?,
            engine: if is_inside { STANDARD.encode(self.engine) } else { String::new() },
            beside: (!is_inside).then_some(ENGINE_FILE),
            in_frames: IN_FRAMES,
            scripts: SCRIPTS.into_iter().chain(platform).chain([START]).collect(),
            is_scored: reported == Some(Reported::Score),
        };
        Ok(Site::practice_page(self.templates)?.page("page", &values)?)
    }

    /// A name that changes with the problems.
    fn key(&self) -> String {
        let hashed = |hasher: Sha256, problem: &PageProblem| hasher.chain_update(&problem.text);
        let digest = self.problems.iter().fold(Sha256::new(), hashed).finalize();
        format!("momentous-{}", URL_SAFE_NO_PAD.encode(digest))
    }
}

/// JSON that may stand in a script of a page: it ends no element.
fn as_json(value: &impl Serialize) -> Result<String, NotWritten> {
    let text = serde_json::to_string(value).map_err(std::io::Error::from)?;
    Ok(text.replace('<', "\\u003c"))
}
