//! Texts from which a search for new paths starts: the fixtures of the other tests, and tables that are as they should be.

use std::fs;
use std::path::{Path, PathBuf};

use momentous::exercise::Rows;

/// The longest problem file that is a seed: in a short one a change is more likely to matter.
const LONGEST: u64 = 1200;

/// The seeds of a target.
pub fn of(target: &str, root: &Path) -> Vec<String> {
    match target {
        "problem_file" => files(root),
        "answer" => rows(root, |name| !name.starts_with("formulas")),
        "formula" => rows(root, |name| name.starts_with("formulas")),
        "route" => ROUTES.iter().map(|text| (*text).to_owned()).collect(),
        _ => TABLES.iter().map(|text| (*text).to_owned()).collect(),
    }
}

/// Files of problems, good and bad ones.
fn files(root: &Path) -> Vec<String> {
    let folders =
        ["bad_problems", "found", "pictures", "problems"].map(|folder| root.join("tests/fixtures").join(folder));
    let short = |path: &PathBuf| path.metadata().is_ok_and(|file| file.is_file() && file.len() < LONGEST);
    let paths = folders.iter().flat_map(|folder| listed(folder)).filter(short);
    paths.filter_map(|path| fs::read_to_string(path).ok()).collect()
}

/// What is answered in the tables of answers with such names.
fn rows(root: &Path, is_wanted: impl Fn(&str) -> bool) -> Vec<String> {
    let mut texts = Vec::new();
    for path in listed(&root.join("tests/fixtures/answers")) {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let bytes = fs::read(&path).unwrap_or_default();
        let Some(mut table) = Rows::read(bytes.as_slice()).ok().filter(|_| is_wanted(&name)) else { continue };
        let mut column = None;
        while let Some((_, row)) = table.next_row() {
            let Some(row) = row.ok().filter(|row| !row.cell(0).starts_with('#')) else { continue };
            match column {
                Some(column) => texts.push(row.cell(column).to_owned()),
                None => column = row.cells().position(|heading| ["text", "answer"].contains(&heading)),
            }
        }
    }
    texts
}

/// What lies in a folder, in the order of the names.
fn listed(folder: &Path) -> Vec<PathBuf> {
    let mut paths: Vec<PathBuf> =
        fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path()).collect();
    paths.sort();
    paths
}

/// Tables of submissions, of students and of sheets, and submissions as JSON and YAML.
const TABLES: [&str; 6] = [
    "student,problem,digest,seed,form,attempt,hints,v_A2\ns1,impact/two-carts,,7-kmbtrs,forward,1,0,\"-0,4 \"\"m/s\"\"\"\r\n\ns1,impact/two-carts,,7,,2,,'=1\n",
    "\u{feff}Name;ID\nAda;a\n\"Bob\nBobson\";b\n",
    "student,name,problem,digest,form,seed,derivation,secret,file\ns1,Ada,impact/two-carts,1f,forward,96136557916552,2,kmbtrs,s1-a\n",
    "{\"problem\":\"a/b\",\"seed\":7,\"student\":\"s\",\"attempt\":2,\"answers\":{\"v\":\"3 m/s\",\"w\":0.500,\"x\":null}}\n",
    "problem: a/b\nseed: 1\nstudent: s\nhints: 2\nanswers:\n  v: 0.500\n  w: \"3 m/s\"\n  x: [1, 2]\n",
    "student: &s !!str s\nproblem: a/b\nseed: 0x7\nanswers: { v: | \n  3 m/s\n}\n",
];

/// Requests: an address, and behind the end of the line a body.
const ROUTES: [&str; 15] = [
    "/?search=spring&level=core",
    "/practice/impact/two-carts?form=forward&seed=7",
    "/practice/impact/two-carts?set.m_A=3+kg&set.e=0.5",
    "/practice/impact/two-carts\nform=forward&seed=7&answer.v_A2=1,39+m/s&answer.T_lost=x&do=hint&hints=1&further=2",
    "/solution/impact/two-carts?seed=7&steps=2",
    "/solve/impact/two-carts?set.m_A=3+kg&find=v_A2+v_B2",
    "/play/vectors/drone-in-wind?seed=2",
    "/simulators/collision?m_A=3&v_A=3&m_B=2&v_B=-2&e=0.7&method=penalty&step=0.01",
    "/simulators/restitution?h=4&e=1&n=3&v_t=20",
    "/static/0/site.css",
    "/api/mark\n{\"problem\":\"impact/two-carts\",\"seed\":7,\"answers\":{\"v_A2\":\"1 m/s\"}}",
    "/api/work\n{\"problem\":\"impact/two-carts\",\"seed\":7,\"work\":\"m_A v_A1 = 6 kg m/s\",\"next\":1}",
    "/api/read\n{\"problem\":\"impact/two-carts\",\"set\":{\"e\":\"0.5\"},\"part\":\"v_A2\",\"text\":\"-0.4 m/s\"}",
    "/api/simulate\n{\"problem\":\"bouncing/rubber-ball\",\"form\":\"heights\",\"together\":true}",
    "/api/collision\n{\"values\":{\"m_A\":3,\"e\":0.7},\"method\":\"moreau-jean\",\"step\":0.05}",
];
