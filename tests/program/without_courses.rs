//! A program that was built without courses says so wherever somebody asks for them.

use crate::room::Room;

/// An address that nothing can listen on, so that a server that should be refused ends all the same.
const NOWHERE: &str = "192.0.2.1:1";

#[test]
fn serve_refuses_where_courses_are() {
    let room = Room::with(&[("momentous-data/courses.sqlite", "")]);
    for (options, why) in [
        (&["serve"][..], "the folder `momentous-data` holds courses"),
        (&["serve", "--data", "postgres://db/courses"], "it cannot serve those of --data"),
        (&["serve", "user", "add", "ada"], "`momentous serve user` works on courses"),
        (&["serve", "backup", "copy.sqlite"], "`momentous serve backup` works on courses"),
    ] {
        let ran = room.run(&[options, if options.len() == 2 { &["--bind", NOWHERE] } else { &[] }].concat());
        assert!(ran.code != 0 && ran.err.contains(why), "{options:?}: {}\n{}", ran.code, ran.err);
        assert!(ran.err.contains("`--features courses`"), "{options:?}: {}", ran.err);
    }
}

#[test]
fn serve_goes_on_where_courses_are_left_out() {
    let room = Room::with(&[("momentous-data/courses.sqlite", "")]);
    let ran = room.run(&["serve", "--no-courses", "--bind", NOWHERE]);
    assert!(ran.err.contains("192.0.2.1:1 cannot be used"), "{}", ran.err);
}
