//! One file read as a source, or the fault that it cannot be.

use std::io;
use std::path::Path;

use crate::fault::Code;
use crate::fault::Fault;
use crate::fault::Faults;
use crate::fault::Input;
use crate::fault::Source;

/// The longest file that is read as a problem, in bytes: a hundred times what the longest of the bank has.
const LARGEST: u64 = 256 * 1024;

pub(super) fn read_file(path: &Path) -> Result<Source, Faults> {
    let text = Input::open(path).and_then(|file| file.text(LARGEST)).map_err(|error| unreadable(path, &error))?;
    Ok(Source::new(&path.display().to_string(), &text))
}

pub(super) fn unreadable(path: &Path, error: &io::Error) -> Faults {
    let source = Source::new(&path.display().to_string(), "");
    Faults { source, list: vec![Fault::new(Code::Unreadable, format!("this cannot be read: {error}"))] }
}
