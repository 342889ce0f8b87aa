//! SVG as PNG.

use super::super::failure::Failure;
use super::page::{Page, Theme};

/// Pixels of the picture for a pixel of the page: enough for a sharp print.
#[cfg(feature = "png")]
const SHARPNESS: f32 = 2.0;

/// The page as a picture.
#[cfg(feature = "png")]
pub(crate) fn png(page: &Page, theme: Theme) -> Result<Vec<u8>, Failure> {
    use resvg::{tiny_skia, usvg};

    let failed = |what: String| Failure::unusable(format!("the picture cannot be made: {what}\nhelp: {INSTEAD}"));
    let mut options = usvg::Options::default();
    let fonts = options.fontdb_mut();
    fonts.load_system_fonts();
    if fonts.is_empty() {
        return Err(failed("there is no font on this machine".to_owned()));
    }
    let tree = usvg::Tree::from_str(&page.svg(theme), &options).map_err(|error| failed(error.to_string()))?;
    let size = tree.size().to_int_size().scale_by(SHARPNESS);
    let pixels = size.and_then(|size| tiny_skia::Pixmap::new(size.width(), size.height()));
    let mut pixels = pixels.ok_or_else(|| failed("it is too large".to_owned()))?;
    resvg::render(&tree, tiny_skia::Transform::from_scale(SHARPNESS, SHARPNESS), &mut pixels.as_mut());
    pixels.encode_png().map_err(|error| failed(error.to_string()))
}

/// Without the feature there is no picture.
#[cfg(not(feature = "png"))]
pub(crate) fn png(_: &Page, _: Theme) -> Result<Vec<u8>, Failure> {
    Err(Failure::unusable(format!(
        "this program was built without PNG\nhelp: {INSTEAD}, or build it with `cargo build --release --features png`"
    )))
}

/// The way out that is always there.
const INSTEAD: &str = "take --format svg, which every browser shows";
