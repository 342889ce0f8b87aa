//! Variants as JSON, one object a line, in memory that does not grow with their number.

use std::io::Write;

use rayon::prelude::*;

use crate::cli::failure::Failure;
use crate::cli::failure::tell;
use crate::cli::output::Output;
use crate::cli::pages;
use crate::cli::progress;

use super::Generate;
use super::destination::Destination;
use super::job::Job;

/// Variants that are made at once, by all cores, before they are written in order.
const CHUNK: usize = 512;

impl Generate {
    /// Writes every variant in order: into one stream, or a file for each into a folder.
    pub(super) fn stream(
        &self,
        mut jobs: impl Iterator<Item = Job>,
        count: u64,
        destination: &Destination,
    ) -> Result<(), Failure> {
        let renderer = pages::renderer()?;
        let make = |job: &Job| self.record(job, &renderer);
        if let Destination::Folder(folder) = destination {
            if self.is_for_students() {
                tell(&format!(
                    "note: JSON contains the answers; it is written to {}",
                    destination.for_teacher()?.display()
                ));
            }
            return jobs.try_for_each(|job| {
                let (name, text) = (format!("{}.json", job.file_stem()), format!("{}\n", make(&job)?));
                if self.is_for_students() {
                    destination.write_for_teacher(&name, &text)
                } else {
                    Output::whole(Some(&folder.join(name)), &text)
                }
            });
        }
        let bar = progress::bar(count, *destination == Destination::Stdout);
        let mut output = Output::to(destination.file())?;
        loop {
            let chunk: Vec<Job> = jobs.by_ref().take(CHUNK).collect();
            let lines: Vec<Result<String, Failure>> = match chunk.as_slice() {
                [] => break,
                // Threads for a single variant would take longer than the variant.
                [only] => vec![make(only)],
                chunk => chunk.par_iter().map(make).collect(),
            };
            for line in lines {
                writeln!(output, "{}", line?)?;
            }
            bar.inc(chunk.len() as u64);
        }
        output.finish()
    }
}
