//! `momentous schema`

use std::io::Write;

use clap::Args;

use crate::problem::course_schema;
use crate::problem::homework_schema;
use crate::problem::json_schema;

use super::exit::Exit;
use super::failure::Failure;
use super::output::Output;

const HELP: &str = "\
An editor that knows the schema completes keys and checks them as you type. In VS Code with the YAML extension:

  momentous schema > momentous.schema.json

and as the first line of a problem file:

  # yaml-language-server: $schema=../../momentous.schema.json";

/// Print the JSON Schema of problem files, with a description of every key
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub(super) struct Schema {
    /// The schema of `course.yaml`, the settings of a course
    #[arg(long)]
    course: bool,
    /// The schema of a file of homework
    #[arg(long, conflicts_with = "course")]
    homework: bool,
}

impl Schema {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        let mut output = Output::to(None)?;
        let schema = match (self.course, self.homework) {
            (true, _) => course_schema(),
            (false, true) => homework_schema(),
            (false, false) => json_schema(),
        };
        serde_json::to_writer_pretty(&mut output, schema)?;
        writeln!(output)?;
        output.finish()?;
        Ok(Exit::Fine)
    }
}
