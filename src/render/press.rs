//! From a document in Typst to PDF, with nothing but the fonts that are inside or were put beside the user's templates.

use std::collections::BTreeSet;
use std::path::Path;

use typst::diag::{FileError, FileResult, SourceDiagnostic};
use typst::foundations::{Bytes, Datetime, Duration, Smart};
use typst::syntax::{DiagSpan, FileId, RootedPath, Source as TypstSource, VirtualPath, VirtualRoot};
use typst::text::{Font, FontBook};
use typst::utils::LazyHash;
use typst::{Library, LibraryExt, World, WorldExt};
use typst_layout::PagedDocument;
use typst_pdf::{PdfOptions, PdfStandard, PdfStandards};

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Faults;
use momentous_fault::Input;
use momentous_fault::Source;
use momentous_fault::Span;

use super::font::MATH_FONT;

/// The fonts of text, subsets of STIX Two Text (`templates/fonts/`).
const TEXT_FONTS: [&[u8]; 3] = [
    include_bytes!("../../templates/fonts/momentous-serif-regular.woff2"),
    include_bytes!("../../templates/fonts/momentous-serif-italic.woff2"),
    include_bytes!("../../templates/fonts/momentous-serif-bold.woff2"),
];
/// The folder of a user's own fonts, below that of the templates.
const FONTS: &str = "fonts";
/// The endings of fonts that Typst reads.
const ENDINGS: [&str; 4] = ["otf", "ttf", "otc", "ttc"];
/// The longest font that is read, in bytes.
const LARGEST: u64 = 64 << 20;
/// Documents for which what was made of one is kept for the next. They have much in common, and memory must not grow.
const KEPT: usize = 2;
/// The longest line that is shown of a document: those of figures are of no use to anybody.
const WIDEST: usize = 400;

/// Makes PDF of documents in [`super::Format::Typst`]: tagged, with fonts, as PDF/UA-1 wants it, and the same bytes each time.
///
/// ```
/// use momentous_render::{Format, Press, Renderer, Sheet};
///
/// let sheet = Sheet { title: "Two carts".into(), statement: "Cart A moves at $v$.".into(), ..Sheet::default() };
/// let document = Renderer::new(None)?.render_sheets(&[sheet], Format::Typst)?;
/// assert!(Press::new(None)?.pdf(&document.text)?.starts_with(b"%PDF-"));
/// # Ok::<(), momentous_fault::Faults>(())
/// ```
pub struct Press {
    library: LazyHash<Library>,
    book: LazyHash<FontBook>,
    fonts: Vec<Font>,
}

impl Press {
    /// A press with the fonts that are inside. Signs that these lack are taken from those in `fonts/` of the user's templates.
    ///
    /// # Errors
    /// Where one of the user's fonts cannot be read.
    pub fn new(overrides: Option<&Path>) -> Result<Self, Faults> {
        let mut fonts = Vec::new();
        for packed in TEXT_FONTS.into_iter().chain([MATH_FONT]) {
            let unpacked = wuff::decompress_woff2(packed).unwrap_or_default();
            fonts.extend(Font::iter(Bytes::new(unpacked)));
        }
        if let Some(fonts_folder) = overrides.map(|folder| folder.join(FONTS)).filter(|folder| folder.is_dir()) {
            add_fonts(&fonts_folder, &mut fonts)?;
        }
        let book = LazyHash::new(FontBook::from_fonts(&fonts));
        Ok(Self { library: LazyHash::new(Library::default()), book, fonts })
    }

    /// The document as PDF.
    ///
    /// # Errors
    /// Where the templates wrote what Typst cannot read or warns of, or no font has a sign of the text.
    pub fn pdf(&self, document: &str) -> Result<Vec<u8>, Faults> {
        let path = VirtualPath::new("document.typ").map_err(|error| faults_of(document, &format!("{error:?}")))?;
        let main = RootedPath::new(VirtualRoot::Project, path).intern();
        let job = Job { press: self, source: TypstSource::new(main, document.to_owned()) };
        let compiled = typst::compile::<PagedDocument>(&job);
        let printed = match compiled.output {
            Ok(pages) if compiled.warnings.is_empty() => {
                let standards = PdfStandards::new(&[PdfStandard::Ua_1]);
                let standards = standards.map_err(|error| faults_of(document, error.message()))?;
                let creator = Smart::Custom(Some(format!("momentous {}", env!("CARGO_PKG_VERSION"))));
                typst_pdf::pdf(&pages, &PdfOptions { standards, creator, ..PdfOptions::default() })
            }
            Ok(_) => Err(compiled.warnings),
            Err(errors) => Err(errors),
        };
        typst::comemo::evict(KEPT);
        printed.map_err(|said| Faults {
            source: source(document),
            list: said.iter().map(|said| fault(said, document, &job)).collect(),
        })
    }
}

/// A document at the press.
struct Job<'a> {
    press: &'a Press,
    source: TypstSource,
}

impl World for Job<'_> {
    fn library(&self) -> &LazyHash<Library> {
        &self.press.library
    }

    fn book(&self) -> &LazyHash<FontBook> {
        &self.press.book
    }

    fn main(&self) -> FileId {
        self.source.id()
    }

    /// A document reads no other file.
    fn source(&self, id: FileId) -> FileResult<TypstSource> {
        if id == self.source.id() { Ok(self.source.clone()) } else { Err(FileError::AccessDenied) }
    }

    fn file(&self, _: FileId) -> FileResult<Bytes> {
        Err(FileError::AccessDenied)
    }

    fn font(&self, index: usize) -> Option<Font> {
        self.press.fonts.get(index).cloned()
    }

    /// There is no day, so that the same document is the same tomorrow.
    fn today(&self, _: Option<Duration>) -> Option<Datetime> {
        None
    }
}

/// Adds the fonts of a folder, in the order of their names.
fn add_fonts(folder: &Path, fonts: &mut Vec<Font>) -> Result<(), Faults> {
    let unreadable = |path: &Path, why: &dyn std::fmt::Display| Faults {
        source: Source::new(&path.display().to_string(), ""),
        list: vec![Fault::new(Code::Unreadable, format!("this font cannot be read: {why}"))],
    };
    let entries = std::fs::read_dir(folder).map_err(|error| unreadable(folder, &error))?;
    let paths = entries.map(|entry| entry.map(|entry| entry.path())).collect::<Result<BTreeSet<_>, _>>();
    for path in paths.map_err(|error| unreadable(folder, &error))? {
        let ending = path.extension().and_then(|ending| ending.to_str()).map(str::to_lowercase);
        if ending.is_none_or(|ending| !ENDINGS.contains(&ending.as_str())) {
            continue;
        }
        let bytes =
            Input::open(&path).and_then(|file| file.bytes(LARGEST)).map_err(|error| unreadable(&path, &error))?;
        let before = fonts.len();
        fonts.extend(Font::iter(Bytes::new(bytes)));
        if fonts.len() == before {
            return Err(unreadable(&path, &"it is not an OpenType or TrueType font"));
        }
    }
    Ok(())
}

fn source(document: &str) -> Source {
    Source::new("the document in Typst", document)
}

fn faults_of(document: &str, message: &str) -> Faults {
    Faults { source: source(document), list: vec![Fault::new(Code::Template, message)] }
}

/// The message of Typst, at its place where that can be shown.
fn fault(said: &SourceDiagnostic, document: &str, job: &Job) -> Fault {
    let shown = |range: std::ops::Range<usize>| {
        let start = document.get(..range.start)?.rfind('\n').map_or(0, |end| end + 1);
        let end = document.get(range.start..)?.find('\n').map_or(document.len(), |end| range.start + end);
        (end - start <= WIDEST).then_some(Span { start: range.start, end: range.end.min(end) })
    };
    let place = |span: DiagSpan| job.range(span).and_then(shown);
    let mut help: Vec<String> = said.hints.iter().map(|hint| hint.v.to_string()).collect();
    if said.message.contains("could not be displayed") {
        help = vec![format!("put a font that has it into templates/{FONTS}/, or write it in other signs")];
    }
    let fault = Fault::new(Code::Template, said.message.to_string()).at_maybe(place(said.span));
    if help.is_empty() { fault } else { fault.help(help.join("; ")) }
}
