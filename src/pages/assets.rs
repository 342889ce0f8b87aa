//! Scripts, styles and fonts: in the program, under an address that changes with their contents, so that a browser keeps them.

use std::borrow::Cow;
use std::fmt::Write;
use std::path::Path;

use sha2::Digest;
use sha2::Sha256;

use momentous_fault::{Code, Fault, Faults, Input, Source};
use momentous_figure::style_sheet;
use momentous_render::MATH_FONT;

macro_rules! built_in {
    ($($name:literal),* $(,)?) => {
        [$(($name, include_bytes!(concat!("../../templates/web/static/", $name)))),*]
    };
}

/// Every file of `templates/web/static/`.
const BUILT_IN: &[(&str, &[u8])] = &built_in![
    "address.js",
    "announcer.js",
    "bars.js",
    "clock.js",
    "engine.js",
    "icon.svg",
    "collision.js",
    "controls.js",
    "discs.js",
    "drag.js",
    "play.js",
    "plot.js",
    "handed-in.js",
    "practice.js",
    "preview.js",
    "reading.js",
    "reach.js",
    "refused.js",
    "restitution.js",
    "scene.js",
    "simulator.js",
    "stage.js",
    "told.js",
    "watch.js",
    "work.js",
    "zone.js"
];

/// The style of documents, on which that of the pages builds.
const DOCUMENTS: &str = include_str!("../../templates/html/style.css");

/// The style of the pages.
const PAGES: &[u8] = include_bytes!("../../templates/web/static/site.css");

/// The tokens of Open Props on which that style builds: sizes, type, greys and the accent.
const TOKENS: &str = include_str!("../../templates/web/static/open-props.css");

/// The name of the style sheet of all pages.
const STYLE: &str = "site.css";

/// The font of mathematics, to which the style refers by this name.
const FONT: &str = "momentous-math.woff2";

/// The folder of these files in a folder of templates.
const FOLDER: &str = "web/static";

/// The longest of them that is read from a folder, in bytes.
const LONGEST: u64 = 1 << 20;

/// The digits of the digest that stand in addresses.
const DIGITS: usize = 16;

/// The kinds of files, by their endings.
const KINDS: [(&str, &str); 4] = [
    (".css", "text/css; charset=utf-8"),
    (".js", "text/javascript; charset=utf-8"),
    (".woff2", "font/woff2"),
    (".svg", "image/svg+xml"),
];

/// The files to which pages refer.
pub struct Assets {
    files: Vec<(&'static str, Cow<'static, [u8]>)>,
    /// The digest of all of them: one changes, and every address does, since scripts name each other.
    pub digest: String,
}

impl Assets {
    /// The built-in files, or those of the same name in `web/static/` of a folder of templates.
    ///
    /// # Errors
    /// Where a file of that folder cannot be read.
    pub fn new(overrides: Option<&Path>) -> Result<Self, Faults> {
        let file_of = |name: &str, built_in: &'static [u8]| match overrides {
            None => Ok(Cow::Borrowed(built_in)),
            Some(folder) => overridden(&folder.join(FOLDER).join(name), built_in),
        };
        let pages = file_of(STYLE, PAGES)?;
        let style = [TOKENS.as_bytes(), DOCUMENTS.as_bytes(), style_sheet().as_bytes(), &pages].join(&b'\n');
        let mut files = vec![(STYLE, Cow::Owned(style)), (FONT, file_of(FONT, MATH_FONT)?)];
        for (name, bytes) in BUILT_IN {
            files.push((name, file_of(name, bytes)?));
        }
        let mut hasher = Sha256::new();
        for (name, bytes) in &files {
            hasher.update(name.as_bytes());
            hasher.update((bytes.len() as u64).to_be_bytes());
            hasher.update(bytes);
        }
        let digest = hasher.finalize().iter().fold(String::new(), |mut text, byte| {
            // Writing to a string cannot fail.
            let _ = write!(text, "{byte:02x}");
            text
        });
        Ok(Self { files, digest: digest.chars().take(DIGITS).collect() })
    }

    /// Every file: its name, kind and contents.
    pub fn all(&self) -> impl Iterator<Item = (&'static str, &'static str, &[u8])> {
        self.files.iter().filter_map(|(name, bytes)| {
            let (_, kind) = KINDS.iter().find(|(ending, _)| name.ends_with(ending))?;
            Some((*name, *kind, bytes.as_ref()))
        })
    }

    /// A file with its kind.
    #[must_use]
    pub fn find(&self, name: &str) -> Option<(&'static str, &[u8])> {
        self.all().find(|(file, ..)| *file == name).map(|(_, kind, bytes)| (kind, bytes))
    }
}

/// A file of a folder, or the built-in one where the folder has none of that name.
fn overridden(path: &Path, built_in: &'static [u8]) -> Result<Cow<'static, [u8]>, Faults> {
    if !path.exists() {
        return Ok(Cow::Borrowed(built_in));
    }
    let read = Input::open(path).and_then(|file| file.bytes(LONGEST));
    read.map(Cow::Owned).map_err(|error| Faults {
        source: Source::new(&path.display().to_string(), ""),
        list: vec![Fault::new(Code::Unreadable, format!("this file cannot be read: {error}"))],
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The font that the style names, and that pages ask for before they read the style, is there.
    #[test]
    fn the_font_is_found_where_the_pages_look_for_it() {
        let assets = Assets::new(None).unwrap_or_else(|faults| panic!("{faults}"));
        let (_, style) = assets.find(STYLE).unwrap_or_else(|| panic!("no style"));
        let style = String::from_utf8_lossy(style);
        let layout = include_str!("../../templates/web/layout.tera");
        let in_style: Vec<&str> = style.split("url(\"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
        let in_layout =
            layout.split("rel=\"preload\" href=\"{{ assets }}/").nth(1).and_then(|rest| rest.split('"').next());
        assert_eq!(in_style, [FONT]);
        assert_eq!(in_layout, Some(FONT));
        assert_eq!(assets.find(FONT), Some(("font/woff2", MATH_FONT)));
    }
}
