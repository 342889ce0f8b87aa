//! `momentous templates`

use std::io::Write;
use std::path::PathBuf;

use clap::Args;

use crate::fault::did_you_mean;
use crate::render::built_in_templates;

use super::exit::Exit;
use super::failure::Failure;
use super::output::Output;

const HELP: &str = "\
Examples:
  momentous templates                              the names of the built-in templates
  momentous templates html/sheet.tera --write      write that one into templates/, to change it
  momentous templates --write --folder looks       write all of them

The folder templates/ of a course takes the place of the built-in ones, file by file. A file that exists is not changed.";

/// List the built-in templates, or write them into a folder to change them
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub(super) struct Templates {
    /// The templates that are meant; all if none is named
    #[arg(value_name = "NAME")]
    names: Vec<String>,
    /// Write them into the folder
    #[arg(long)]
    write: bool,
    /// The folder
    #[arg(long, value_name = "FOLDER", default_value = "templates", requires = "write")]
    folder: PathBuf,
}

impl Templates {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        let known: Vec<(&str, &str)> = built_in_templates().collect();
        if let Some(unknown) = self.names.iter().find(|name| known.iter().all(|(listed, _)| listed != name)) {
            let near = did_you_mean(unknown, known.iter().map(|(name, _)| *name));
            let near = near.map(|near| format!("\nhelp: did you mean `{near}`?")).unwrap_or_default();
            return Err(Failure::unusable(format!("there is no template `{unknown}`{near}")));
        }
        let is_meant = |name: &str| self.names.is_empty() || self.names.iter().any(|named| named == name);
        let mut output = Output::to(None)?;
        for (name, text) in known.into_iter().filter(|(name, _)| is_meant(name)) {
            let path = self.folder.join(name);
            match (self.write, path.exists()) {
                (false, _) => writeln!(output, "{name}")?,
                (true, true) => writeln!(output, "{} exists; it was not changed", path.display())?,
                (true, false) => {
                    Output::whole(Some(&path), text)?;
                    writeln!(output, "{} has been written", path.display())?;
                }
            }
        }
        output.finish()?;
        Ok(Exit::Fine)
    }
}
