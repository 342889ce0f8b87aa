//! A small file beside those of problems, read into its type by its schema.

use momentous_fault::Faults;
use momentous_fault::Source;
use serde::de::DeserializeOwned;

use super::check::check;
use super::document::Document;
use super::load::typed;
use super::position::Index;
use super::shape::Shapes;

/// Reads the file, or returns every fault of its form.
pub(super) fn read<T: DeserializeOwned>(source: &Source, shapes: &Shapes<'_>) -> Result<T, Faults> {
    let Document { root, mut faults } = Document::read(source);
    let Some(root) = root else { return Err(Index::new(source, None).locate_all(faults)) };
    let (value, of_form) = check(&root, shapes);
    faults.extend(of_form);
    if faults.is_empty() {
        match typed(value) {
            Ok(read) => return Ok(read),
            Err(fault) => faults.push(fault),
        }
    }
    Err(Index::new(source, Some(root)).locate_all(faults))
}
