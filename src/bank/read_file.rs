//! One file read as a source, or the fault that it cannot be.

use std::io;
use std::path::Path;

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Faults;
use momentous_fault::Input;
use momentous_fault::Source;
use momentous_problem::LONGEST_FILE;

pub(super) fn read_file(path: &Path) -> Result<Source, Faults> {
    let text =
        Input::open(path).and_then(|file| file.text(LONGEST_FILE as u64)).map_err(|error| unreadable(path, &error))?;
    Ok(Source::new(&path.display().to_string(), &text))
}

pub(super) fn unreadable(path: &Path, error: &io::Error) -> Faults {
    let source = Source::new(&path.display().to_string(), "");
    Faults { source, list: vec![Fault::new(Code::Unreadable, format!("this cannot be read: {error}"))] }
}
