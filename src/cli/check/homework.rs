//! Whether every homework is in order: its problems and forms are there, and its points can be divided.

use std::io::Write;

use crate::bank::{Bank, HOMEWORK_FOLDER, Homework, course_folder, files_under};
use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::fault::{Faults, Source};

use super::count::count;

/// Findings on the files of homework.
#[derive(Debug, Default)]
pub(super) struct Homeworks {
    /// Those that are in order, each in a line.
    sound: Vec<String>,
    /// The faults of the others.
    pub(super) unusable: Vec<Faults>,
}

impl Homeworks {
    /// Takes the files of homework out of those that were named; where none was named, those of the course are read.
    pub(super) fn among(sources: &mut Vec<Source>, names: &[String], bank: &Bank) -> Result<Self, Failure> {
        let mut files: Vec<Source> = sources.extract_if(.., |source| Homework::is(source)).collect();
        let mut checked = Self::default();
        let folder = course_folder().join(HOMEWORK_FOLDER);
        if names.is_empty() && folder.is_dir() {
            for path in files_under(&folder)? {
                match bank.open(&path.display().to_string()) {
                    Ok(source) => files.push(source),
                    Err(faults) => checked.unusable.push(faults),
                }
            }
        }
        for source in files {
            match Homework::of(&source, bank, None) {
                Ok(homework) => {
                    let points = crate::grade::Points(homework.points());
                    let problems = count(homework.slots.len(), "problem");
                    checked.sound.push(format!("{}  {}: {problems}, {points} points", source.name, homework.title));
                }
                Err(faults) => checked.unusable.push(faults),
            }
        }
        Ok(checked)
    }

    /// Says of each that is in order what it holds.
    pub(super) fn write(&self, output: &mut Output) -> Result<(), Failure> {
        for line in &self.sound {
            writeln!(output, "{line}")?;
        }
        Ok(())
    }
}
