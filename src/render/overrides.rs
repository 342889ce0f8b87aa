//! A course's own templates, which take the place of built-in ones of the same name.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use momentous_fault::{Code, Fault, Faults, Input, Source, did_you_mean};

use super::built_in::{STYLE, built_in_templates};

/// The longest template that is read, in bytes.
const LARGEST: u64 = 1 << 20;

/// Adds the files of a format: each `.tera` file of its folder, and the style sheet.
///
/// # Errors
/// Where a folder or a file cannot be read, and where a name is that of no template: nobody would see that it is not used.
pub(super) fn add(name: &str, folder: &Path, sources: &mut BTreeMap<String, Source>) -> Result<(), Faults> {
    for entry in entries(folder)? {
        if is_unknown_folder(&entry) {
            return Err(misnamed(&entry, &folder_name(&entry), built_in_folders()));
        }
    }
    let override_folder = folder.join(name);
    if !override_folder.is_dir() {
        return Ok(());
    }
    let built_in: Vec<String> = sources.keys().cloned().collect();
    let mut added: Vec<(String, PathBuf)> = Vec::new();
    for path in entries(&override_folder)? {
        let Some(file) = path.file_name().and_then(|file| file.to_str()) else { continue };
        let key = format!("{name}/{file}");
        if !is_template(&path) || file.starts_with('.') {
            continue;
        }
        let text = Input::open(&path).and_then(|file| file.text(LARGEST)).map_err(|error| unreadable(&path, &error))?;
        sources.insert(key.clone(), Source::new(&path.display().to_string(), &text));
        if !built_in.contains(&key) {
            added.push((key, path));
        }
    }
    let is_used = |key: &str| sources.values().any(|source| source.text.contains(&format!("\"{key}\"")));
    match added.iter().find(|(key, _)| !is_used(key)) {
        Some((key, path)) => Err(misnamed(path, key, built_in.iter().map(String::as_str))),
        None => Ok(()),
    }
}

fn entries(folder: &Path) -> Result<Vec<PathBuf>, Faults> {
    let read = fs::read_dir(folder).map_err(|error| unreadable(folder, &error))?;
    let paths: io::Result<Vec<PathBuf>> = read.map(|entry| entry.map(|entry| entry.path())).collect();
    paths.map_err(|error| unreadable(folder, &error))
}

/// Whether templates lie in a folder from which none are taken.
fn is_unknown_folder(path: &Path) -> bool {
    let name = folder_name(path);
    let has_templates = || entries(path).is_ok_and(|files| files.iter().any(|file| is_template(file)));
    path.is_dir() && !name.starts_with('.') && built_in_folders().all(|known| known != name) && has_templates()
}

fn folder_name(path: &Path) -> String {
    path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
}

fn built_in_folders() -> impl Iterator<Item = &'static str> {
    built_in_templates().filter_map(|(path, _)| path.split('/').next())
}

fn is_template(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending == "tera" || ending == "css")
}

fn misnamed<'a>(path: &Path, name: &str, known: impl Iterator<Item = &'a str>) -> Faults {
    let fault = Fault::new(Code::UnknownName, format!("no template is called `{name}`, and none includes it"));
    let help = match did_you_mean(name, known) {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("`momentous templates` lists the built-in ones; the style sheet is `{STYLE}`"),
    };
    Faults { source: Source::new(&path.display().to_string(), ""), list: vec![fault.help(help)] }
}

fn unreadable(path: &Path, error: &io::Error) -> Faults {
    let fault = Fault::new(Code::Unreadable, format!("these templates cannot be read: {error}"));
    Faults { source: Source::new(&path.display().to_string(), ""), list: vec![fault] }
}
