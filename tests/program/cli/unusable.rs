//! Input that cannot be used: what is typed, and what must be said of it.

use crate::room::Room;

/// What is typed, files beside it, and what the message must hold.
type Unusable = (&'static [&'static str], &'static str);

const UNUSABLE: &[Unusable] = &[
    (&[], "Usage"),
    (&["explain"], "unrecognized subcommand"),
    (&["generate"], "required"),
    (&["generate", "impact/two-cart"], "did you mean `impact/two-carts`?"),
    (&["generate", "missing.yaml"], "missing.yaml: error: this cannot be read"),
    (&["generate", "bad.yaml"], "bad.yaml"),
    (&["generate", "impact/two-carts", "--form", "find-f"], "did you mean `find-e`?"),
    (&["generate", "impact/two-carts", "--seed", "1.5"], "--seed"),
    (&["generate", "impact/two-carts", "--seed", "-1"], "a seed is a whole number from 0"),
    (&["generate", "impact/two-carts", "--faded", "1"], "add --solution"),
    (&["generate", "impact/two-carts", "--count", "0"], "--count"),
    (&["generate", "impact/two-carts", "--format", "docx"], "markdown"),
    (&["generate", "impact/two-carts", "--roster", "class.csv"], "--output"),
    (&["generate", "impact/two-carts", "--roster", "none.csv", "-o", "a/"], "none.csv cannot be read"),
    (&["generate", "impact/two-carts", "--roster", "good.csv", "-o", "/dev/null"], "has no folder for seeds.csv"),
    (&["generate", "impact/two-carts", "--roster", "class.csv", "-o", "a/"], "class.csv:3: `s1` is already in line 2"),
    (&["generate", "impact/two-carts", "--secret", "empty.txt"], "empty.txt contains no secret"),
    (&["generate", "impact/two-carts", "--secret", "/dev/zero"], "/dev/zero cannot be read: it is not a regular file"),
    (&["generate", "/dev/zero"], "it is not a regular file"),
    (&["generate", "impact/two-carts", "--roster", "/dev/zero", "-o", "a/"], "it is not a regular file"),
    (&["grade", "/dev/zero"], "it is not a regular file"),
    (&["chart", "--from", "/dev/zero"], "it is not a regular file"),
    (&["generate", "impact/two-carts", "-o", "file.txt/deep/a.md"], "cannot be written"),
    (&["gallery"], "--output"),
    (&["gallery", "impact/two-cart", "-o", "gallery"], "did you mean `impact/two-carts`?"),
    (&["gallery", "impact/two-carts", "-o", "file.txt"], "file.txt is not a folder"),
    (&["gallery", "impact/two-carts", "--seed", "many", "-o", "gallery"], "--seed"),
    (&["solve", "impact/two-carts", "--set", "m_A"], "NAME=VALUE"),
    (&["solve", "impact/two-carts", "--set", "m_A=3 kgg"], "`kgg`"),
    (&["solve", "impact/two-carts", "--set", "m_A=3 m"], "m_A"),
    (&["solve", "impact/two-carts", "--set", "m_a=3 kg"], "did you mean `m_A`?"),
    (&["solve", "impact/two-carts", "--set", "e=0.5", "--set", "e=0.6"], "`e` is set twice"),
    (&["solve", "impact/two-carts", "--find", "v_Z9"], "v_Z9"),
    (&["solve", "impact/two-carts", "--set", "v_A1=-9 m/s"], "no admissible"),
    (&["grade"], "required"),
    (&["grade", "--problem", "impact/two-carts"], "required"),
    (&["grade", "--problem", "impact/two-carts", "--seed", "1", "--answer", "v_A3=1 m/s"], "did you mean `v_A2`?"),
    (&["grade", "none.csv"], "none.csv cannot be read"),
    (&["grade", "class.csv", "--format", "json"], "cannot be used with"),
    (&["grade", "class.csv"], "class.csv: there is no column `problem`"),
    (&["check", "impakt"], "there is no problem `impakt`"),
    (&["check", "bad.yaml", "--seeds", "0"], "--seeds"),
    (&["snapshot", "--check", "--accept"], "cannot be used with"),
    (&["list", "--topic", "impakt"], "did you mean `impact`?"),
    (&["new", "a//b"], "cannot be the identity"),
    (&["completions", "tcsh"], "bash"),
];

#[test]
fn input_that_cannot_be_used_is_said_and_ends_with_2() {
    let files = [
        ("bad.yaml", "id: a/b\ntitel: B\nlevel: hard\n"),
        ("class.csv", "id\ns1\ns1\n"),
        ("empty.txt", "\n"),
        ("good.csv", "id\ns1\n"),
        ("file.txt", ""),
    ];
    for (arguments, message) in UNUSABLE {
        let room = Room::with(&files);
        let ran = room.run(arguments);
        assert_eq!(ran.code, 2, "{arguments:?}\n{}{}", ran.out, ran.err);
        assert!(ran.err.contains(message), "{arguments:?} lacks {message}\n{}", ran.err);
        assert!(ran.out.is_empty(), "{arguments:?}\n{}", ran.out);
        assert_eq!(room.names(".").len(), files.len(), "{arguments:?} leaves nothing behind");
    }
}

#[test]
fn a_file_with_faults_shows_all_of_them_with_their_places() {
    let room = Room::with(&[("bad.yaml", "id: a/b\ntitel: B\nlevel: hard\nscene: {}\ntext: What?\nask: []\n")]);
    let ran = room.run(&["check", "bad.yaml"]);
    assert_eq!(ran.code, 2);
    for place in ["bad.yaml:2:1", "bad.yaml:3:8", "bad.yaml:6:6", "did you mean `title`?"] {
        assert!(ran.out.contains(place), "{place}\n{}", ran.out);
    }
}
