//! Floors inside rooms: the files of a room stand one above the other, so that each can be read once those below it are known.
//! A file stands above those whose items it names; an item that a `mod.rs` or `lib.rs` hands on is of the file that defines it.

use std::collections::{BTreeMap, BTreeSet};

use super::words::{code_of, mentions};
use super::{Source, sources};

/// The cycles that stay: a file of each, of how many files it is at most, and what ties them.
const STANDING: &[(&str, usize, &str)] = &[
    ("src/expr/calculus/integral.rs", 2, "a term of pieces is integrated piece by piece, and each piece is a term"),
    ("src/web/app.rs", 2, "what stands beside the pages answers requests with the state of the pages, which hold it"),
];

/// A module or an item, by its names from its room's.
type Path = Vec<String>;

#[test]
fn no_file_of_a_room_needs_one_that_needs_it() {
    let tree = Tree::of(&sources(&["src"]));
    let cycles = tree.cycles();
    let is =
        |(file, most, _): &(&str, usize, &str), cycle: &BTreeSet<&str>| cycle.contains(file) && cycle.len() <= *most;
    let new = cycles.iter().filter(|cycle| !STANDING.iter().any(|known| is(known, cycle)));
    let new: Vec<String> = new.map(|cycle| tree.ties(cycle)).collect();
    assert!(
        new.is_empty(),
        "files that need each other:\n{}\nGive what both need a place of its own.\n",
        new.join("\n\n")
    );
    for known in STANDING {
        assert!(
            cycles.iter().any(|cycle| is(known, cycle)),
            "{} stands in no such cycle: take it from the list",
            known.0
        );
    }
}

/// The files of all rooms as modules.
struct Tree {
    modules: BTreeMap<Path, Module>,
}

/// A file as a module.
#[derive(Default)]
struct Module {
    file: String,
    /// What its imports call by which name; those that it hands on among them.
    names: BTreeMap<String, Path>,
    /// The paths of what it uses; an import that is only handed on is none of it.
    used: Vec<Path>,
}

impl Tree {
    fn of(sources: &[Source]) -> Self {
        let path = |source: &Source| {
            let inside = source.file.trim_start_matches("src/").trim_end_matches(".rs");
            let inside = inside.trim_end_matches("/mod").trim_end_matches("/lib");
            inside.split('/').map(str::to_owned).collect::<Path>()
        };
        let places: BTreeSet<Path> = sources.iter().map(path).collect();
        let module = |source: &Source| (path(source), Module::of(source, &path(source), &places));
        Self { modules: sources.iter().map(module).collect() }
    }

    /// The module in which the item of a path is defined, and the item; none where the path is that of a module.
    fn defined(&self, path: &Path) -> Option<(&Module, String)> {
        let (mut path, mut depth) = (path.clone(), 0);
        // What is handed on may be handed on again.
        for _ in 0..path.len() + self.modules.len() {
            let next = path.get(depth)?.clone();
            if self.modules.contains_key(&path[..=depth]) {
                depth += 1;
                continue;
            }
            let module = self.modules.get(&path[..depth])?;
            let Some(other) = module.names.get(&next) else { return Some((module, next)) };
            path = other.iter().chain(&path[depth + 1..]).cloned().collect();
            depth = 0;
        }
        None
    }

    /// The files of the same room that a file needs, each with an item of it that is used.
    fn needs(&self, module: &Module) -> BTreeMap<&str, String> {
        let room = |file: &str| file.split('/').nth(1).map(str::to_owned);
        let found = module.used.iter().filter_map(|path| self.defined(path));
        let of_room = found.filter(|(other, _)| other.file != module.file && room(&other.file) == room(&module.file));
        of_room.map(|(other, item)| (other.file.as_str(), item)).collect()
    }

    /// The groups of files each of which needs all others of its group, if only through others.
    fn cycles(&self) -> BTreeSet<BTreeSet<&str>> {
        let needs: BTreeMap<&str, BTreeMap<&str, String>> =
            self.modules.values().map(|module| (module.file.as_str(), self.needs(module))).collect();
        let reached = |file: &str| {
            let mut reached: BTreeSet<&str> = BTreeSet::new();
            let mut waiting: Vec<&str> = needs[file].keys().copied().collect();
            while let Some(next) = waiting.pop() {
                if reached.insert(next) {
                    waiting.extend(needs[next].keys());
                }
            }
            reached
        };
        let reached: BTreeMap<&str, BTreeSet<&str>> = needs.keys().map(|file| (*file, reached(file))).collect();
        let group = |file: &&str| {
            reached[file].iter().copied().filter(|other| reached[other].contains(file)).collect::<BTreeSet<&str>>()
        };
        needs.keys().map(group).filter(|group| !group.is_empty()).collect()
    }

    /// Which item ties which files of a cycle.
    fn ties(&self, cycle: &BTreeSet<&str>) -> String {
        let within = self.modules.values().filter(|module| cycle.contains(module.file.as_str()));
        let needs = within.flat_map(|module| self.needs(module).into_iter().map(move |need| (&module.file, need)));
        let ties = needs.filter(|(_, (other, _))| cycle.contains(other));
        ties.map(|(file, (other, item))| format!("{file} needs {item} of {other}")).collect::<Vec<_>>().join("\n")
    }
}

impl Module {
    /// What a file imports and names, its tests left out. `rustfmt` begins an import of a module at the beginning of a line.
    fn of(source: &Source, here: &Path, places: &BTreeSet<Path>) -> Self {
        let mut module = Self { file: source.file.clone(), ..Self::default() };
        let (mut code, mut statement) = (String::new(), String::new());
        for line in code_of(&source.text).lines() {
            let begins = line.starts_with("use ") || line.starts_with("pub") && line.contains(" use ");
            if !begins && statement.is_empty() {
                code.push_str(line);
                code.push('\n');
                continue;
            }
            statement.push_str(line);
            if let Some(whole) = statement.strip_suffix(';') {
                let (before, tree) = whole.split_once("use ").unwrap_or_default();
                for (path, name) in expanded(tree.trim(), &[]) {
                    let Some(path) = absolute(&path, here, &module.names, places) else { continue };
                    if before.is_empty() {
                        module.used.push(path.clone());
                    }
                    module.names.insert(name, path);
                }
                statement.clear();
            }
        }
        let named = mentions(&code).into_iter().filter(|mention| mention.modules == 0 && mention.path.len() > 1);
        let paths: Vec<Path> =
            named.filter_map(|mention| absolute(&mention.path, here, &module.names, places)).collect();
        module.used.extend(paths);
        module
    }
}

/// The paths of an import with their names: `a::{b, c::d as e}` is `a::b` and `a::c::d`, called `e`.
fn expanded(tree: &str, before: &[String]) -> Vec<(Path, String)> {
    let words =
        |text: &str| text.split("::").map(str::trim).filter(|word| !word.is_empty()).map(str::to_owned).collect();
    let Some((start, group)) = tree.split_once('{') else {
        let (path, name) = tree.split_once(" as ").unwrap_or((tree, ""));
        let mut path: Path = [before.to_vec(), words(path)].concat();
        path.pop_if(|last| last == "self");
        let last = path.last().cloned().unwrap_or_default();
        return vec![(path, if name.is_empty() { last } else { name.trim().to_owned() })];
    };
    let before = [before.to_vec(), words(start)].concat();
    let mut depth = 0;
    let parts = group.trim_end_matches([' ', '}']).split(|sign| {
        depth += i32::from(sign == '{') - i32::from(sign == '}');
        sign == ',' && depth == 0
    });
    parts.map(str::trim).filter(|part| !part.is_empty()).flat_map(|part| expanded(part, &before)).collect()
}

/// A path from its room's name; none for those of other packages and for what is defined in the file itself.
fn absolute(path: &[String], here: &Path, names: &BTreeMap<String, Path>, places: &BTreeSet<Path>) -> Option<Path> {
    let first = path.first()?.as_str();
    let child = [here.as_slice(), &path[..1]].concat();
    match first {
        // The command line is a module of the root package; every other room is a crate.
        "crate" if here.first().is_some_and(|room| room == "cli") => Some(path[1..].to_vec()),
        "crate" => Some([here.get(..1)?, &path[1..]].concat()),
        "self" => Some([here, &path[1..]].concat()),
        "super" => {
            let up = path.iter().take_while(|word| *word == "super").count();
            Some([here.get(..here.len().checked_sub(up)?)?, &path[up..]].concat())
        }
        _ if places.contains(&child) => Some([here, path].concat()),
        name => names.get(name).map(|start| [start.as_slice(), &path[1..]].concat()),
    }
}

#[test]
fn a_cycle_is_noticed_however_it_is_written() {
    let source = |file: &str, text: &str| Source { file: file.to_owned(), text: text.to_owned() };
    let cycles = |files: &[(&str, &str)]| {
        let tree = Tree::of(&files.iter().map(|(file, text)| source(file, text)).collect::<Vec<_>>());
        tree.cycles().into_iter().map(|cycle| cycle.into_iter().collect::<Vec<_>>().join(" ")).collect::<Vec<_>>()
    };
    let both = ["src/r/a.rs src/r/b.rs"];
    let room = ("src/r/lib.rs", "mod a;\nmod b;\npub use a::{A, one as first};\nuse b::B;");
    assert_eq!(cycles(&[room, ("src/r/a.rs", "use super::b::B;"), ("src/r/b.rs", "use crate::{a::A};")]), both);
    assert_eq!(cycles(&[room, ("src/r/a.rs", "use super::B;"), ("src/r/b.rs", "use super::first;")]), both);
    assert_eq!(
        cycles(&[room, ("src/r/a.rs", "use super::b;\nfn f() { b::g() }"), ("src/r/b.rs", "use super::A;")]),
        both
    );
    assert_eq!(
        cycles(&[room, ("src/r/a.rs", "use super::B;"), ("src/r/b.rs", "mod tests {\n    use super::super::A;\n}")]),
        [""; 0]
    );
    assert_eq!(cycles(&[room, ("src/r/a.rs", "use super::b;"), ("src/r/b.rs", "use super::A;")]), [""; 0]);
    assert_eq!(
        cycles(&[("src/r/lib.rs", "mod a;\nfn f() { a::g() }\npub struct T;"), ("src/r/a.rs", "use super::T;")]),
        ["src/r/a.rs src/r/lib.rs"]
    );
}
