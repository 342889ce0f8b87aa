//! Points are the same wherever they are shown: on the student's sheet, in the student's list with its sum, in the gradebook, in its CSV,
//! in the statistics, and on the teacher's page of answers. Random histories of a class are played through the pages, and after each step
//! all places are read and compared.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use momentous::bank::Bank;
use momentous::course::{Extension, Moment, ProblemFile, Release};
use momentous::exercise::Exercise;
use momentous::fault::Source;
use momentous::problem::{Problem, compile, load};
use momentous::store::AssignmentWithItems;
use proptest::prelude::*;
use proptest::sample::select;

use super::university::{BEGIN, Browser, DAY, University};

const CARTS: &str = "impact/two-carts";
const PUSH: &str = "impulse/parcel-push";
const STUDENTS: [&str; 2] = ["ada", "bob"];
/// The ways to take a correction in, in the order of the columns of the preview; a page offers some of them.
const WAYS: [&str; 6] = ["remark", "remark_never_lower", "full_marks", "drop", "issue_anew", "issue_anew_never_lower"];
/// Points as pages print them have two decimals.
const ROUNDED: f64 = 0.0051;

/// Something that happens in a class.
#[derive(Clone, Debug)]
enum Step {
    /// A student types something at each part, of these kinds, and hands it in.
    HandIn {
        student: &'static str,
        item: usize,
        kinds: [u8; 3],
    },
    /// Hours go by.
    Wait(i64),
    Extend(&'static str),
    SetByHand {
        student: &'static str,
        item: usize,
        points: &'static str,
    },
    /// The first problem is corrected, and the correction taken in.
    Regrade {
        version: u8,
        way: usize,
    },
}

fn step() -> impl Strategy<Value = Step> {
    let student = || select(&STUDENTS[..]);
    prop_oneof![
        5 => (student(), 0..2_usize, prop::array::uniform3(0..4_u8))
            .prop_map(|(student, item, kinds)| Step::HandIn { student, item, kinds }),
        2 => (1..20_i64).prop_map(Step::Wait),
        1 => student().prop_map(Step::Extend),
        2 => (student(), 0..2_usize, select(&["", "0", "3", "7/3"][..]))
            .prop_map(|(student, item, points)| Step::SetByHand { student, item, points }),
        3 => (0..4_u8, 0..WAYS.len()).prop_map(|(version, way)| Step::Regrade { version, way }),
    ]
}

/// The points of a class as one place has them, by student and item.
type Points = BTreeMap<(&'static str, usize), Option<f64>>;

struct Class<'u> {
    university: &'u University,
    whole: AssignmentWithItems,
    problems: [Arc<Problem>; 2],
    hours: i64,
    count: u32,
    ida: Browser<'u>,
    students: BTreeMap<&'static str, Browser<'u>>,
}

impl<'u> Class<'u> {
    fn new(university: &'u University, verdicts: Release) -> Self {
        let whole =
            university.assignment(&[(CARTS, "forward", 10), (PUSH, "", 4)], |policy| policy.verdicts = verdicts);
        let problem = |id: &str| {
            let source = Bank::built_in().find(id).unwrap().clone();
            Arc::new(compile(load(source).unwrap(), Some(university.course.secret.as_bytes())).unwrap())
        };
        Self {
            whole,
            problems: [problem(CARTS), problem(PUSH)],
            hours: 0,
            count: 0,
            ida: university.browser_of("ida"),
            students: STUDENTS.map(|student| (student, university.browser_of(student))).into(),
            university,
        }
    }

    fn item(&self, item: usize, path: &str) -> String {
        self.university.address(&format!("/items/{}{path}", self.whole.items[item].key))
    }

    fn assignment(&self, path: &str) -> String {
        self.university.address(&format!("/assignments/{}{path}", self.whole.assignment.key))
    }

    fn of_student(&self, student: &str, item: usize, path: &str) -> String {
        self.item(item, &format!("/students/{}{path}", University::member(student)))
    }

    fn wait(&mut self, hours: i64) {
        self.hours += hours;
        self.university.set_clock(self.hours * DAY / 24);
    }

    /// The variant that a student has seen last.
    fn exercise(&self, student: &str, item: usize) -> Exercise {
        let sheets = self.university.wait(async |store| store.sheets_of(University::member(student)).await).unwrap();
        let sheets_of_item = sheets.iter().filter(|sheet| sheet.item == self.whole.items[item].key);
        sheets_of_item.max_by_key(|sheet| sheet.issue).unwrap().issued.draw(&self.problems[item]).unwrap()
    }

    fn hand_in(&mut self, student: &'static str, item: usize, kinds: [u8; 3]) {
        let address = self.item(item, "");
        self.students.get_mut(student).unwrap().get(&address).text(200);
        let exercise = self.exercise(student, item);
        self.count += 1;
        let mut fields = vec![("request".to_owned(), format!("request {}", self.count))];
        for (part, kind) in exercise.worked().form.parts.iter().zip(kinds) {
            let text = match kind {
                0 => String::new(),
                1 => exercise.printed(part),
                2 => format!("{} m/s", 90 + self.count),
                _ => format!("{}..2 m/s", self.count),
            };
            fields.push((format!("answer.{}", part.id), text));
        }
        let fields: Vec<(&str, &str)> = fields.iter().map(|(name, text)| (name.as_str(), text.as_str())).collect();
        let status = self.students.get_mut(student).unwrap().post(&address, &fields).status;
        assert!([303, 422].contains(&status), "{status}");
    }

    /// Publishes a version of the first problem and takes it in, where it is another than the one that counts. Where nobody was to have
    /// fewer points, nobody has; and everybody has what the preview said.
    fn regrade(&mut self, version: u8, way: usize) {
        let text = Bank::built_in().find(CARTS).unwrap().text.to_string();
        let part = "v_A2, unit: m/s, points: 2";
        let text = match version {
            0 => text,
            1 => text.replace(part, "v_A2, unit: m/s, points: 9"),
            2 => text.replace(part, "v_A2, unit: m/s, points: 1"),
            _ => text.replace(part, "v_A2, unit: km/h, points: 2"),
        };
        self.count += 1;
        let published = Moment::from_millis(BEGIN + i64::from(self.count));
        let digest = load(Source::new(CARTS, &text)).unwrap().digest;
        let course = Some(self.university.course.key);
        let (problem, saved) = (CARTS.to_owned(), published);
        let file = ProblemFile { digest, problem, text, course, published: Some(published), saved };
        self.university.wait(async |store| store.save_problem_file(&file, None).await).unwrap();
        let page = self.ida.get(&self.assignment("/regrade")).text(200);
        let offered: Vec<&str> = WAYS.into_iter().filter(|way| page.contains(&format!("value=\"{way}\""))).collect();
        let Some(column) = offered.iter().position(|offered_way| *offered_way == WAYS[way]) else { return };
        let before = self.csv().0;
        let hidden = |name: &str| between(&page, &format!("name=\"{name}\" value=\""), "\"").unwrap().to_owned();
        let [revision, item, digest] = ["revision", "item", "digest"].map(hidden);
        let fields = [
            ("revision", revision.as_str()),
            ("item", &item),
            ("digest", &digest),
            ("choice", WAYS[way]),
            ("reason", "a slip of mine"),
        ];
        self.ida.post(&self.assignment("/regrade"), &fields).to();
        let after = self.csv().0;
        for student in STUDENTS {
            let row = format!("<th scope=\"row\">{student} &lt;script&gt;</th>");
            let said = page.split(&row).nth(1).map(|rest| {
                let cell = rest.split("<td>").nth(column + 2).unwrap().split("</td>").next().unwrap();
                cell.parse::<f64>().ok()
            });
            let now = after.get(&(student, 0)).copied().flatten();
            if let Some(said) = said {
                assert!(is_same(said, now), "{student}: the preview said {said:?}, and it is {now:?}");
            }
            if WAYS[way].ends_with("never_lower") {
                assert!(now >= before[&(student, 0)], "{student}: {before:?} {after:?}");
            }
        }
    }

    fn play(&mut self, step: &Step) {
        match *step {
            Step::HandIn { student, item, kinds } => self.hand_in(student, item, kinds),
            Step::Wait(hours) => self.wait(hours),
            Step::Extend(student) => {
                let at = |hours: i64| Moment::from_millis(BEGIN + hours * DAY / 24);
                let extension = Extension {
                    assignment: self.whole.assignment.key,
                    member: University::member(student),
                    due: at(40),
                    late_until: Some(at(100)),
                    closes: at(110),
                    reason: "was ill".into(),
                };
                let entry = University::entry(u8::try_from(100 + self.count).unwrap());
                self.count += 1;
                self.university.wait(async |store| store.extend(&[(extension, entry)]).await).unwrap();
            }
            Step::SetByHand { student, item, points } => {
                let fields = [("points", points), ("reason", "viva"), ("comment", "Well said.")];
                self.ida.post(&self.of_student(student, item, "/points"), &fields).to();
            }
            Step::Regrade { version, way } => self.regrade(version, way),
        }
    }

    /// The points of the table and the sums.
    fn csv(&mut self) -> (Points, BTreeMap<&'static str, f64>) {
        let text = self.ida.get(&self.assignment("/gradebook.csv")).text(200);
        let mut lines = text.lines();
        let head: Vec<&str> = lines.next().unwrap().split(',').collect();
        let items: Vec<usize> =
            head[3..head.len() - 2].iter().map(|heading| heading[..1].parse::<usize>().unwrap() - 1).collect();
        let (mut points, mut sums) = (Points::new(), BTreeMap::new());
        for line in lines {
            let cells: Vec<&str> = line.split(',').collect();
            let student = STUDENTS.into_iter().find(|student| *student == cells[0]).unwrap();
            for (item, cell) in items.iter().zip(&cells[3..]) {
                points.insert((student, *item), cell.parse().ok());
            }
            sums.insert(student, cells[cells.len() - 2].parse().unwrap());
        }
        (points, sums)
    }

    /// Reads every place, and compares it with the table. A student is shown points once they are `released`.
    fn compare(&mut self, released: impl Fn(&str, i64) -> bool) {
        let (points, sums) = self.csv();
        let items: Vec<usize> = (0..2).filter(|item| points.contains_key(&("ada", *item))).collect();
        let book = self.ida.get(&self.assignment("/gradebook")).text(200);
        let statistics = self.ida.get(&self.assignment("/statistics")).text(200);
        for student in STUDENTS {
            let row = between(&book, &format!("{student} &lt;script&gt;</a></th>"), "</tr>").unwrap();
            let sum = between(row, "<td><strong>", "<").unwrap();
            assert!(is_same(sum.parse().ok(), sums.get(student).copied()), "{student}: {row}");
            for item in &items {
                let expected = points[&(student, *item)];
                let cell = between(row, &format!("/items/{}/", self.whole.items[*item].key), "</a>").unwrap();
                assert!(is_same(cell.rsplit('>').next().unwrap().parse().ok(), expected), "{student} {item}: {cell}");
                let answers = self.ida.get(&self.of_student(student, *item, "")).text(200);
                let has = between(&answers, "<p class=\"total\"><strong>", " of").unwrap();
                assert!(is_same(has.parse().ok(), expected), "{student} {item}: {has} beside {expected:?}");
                let sheet = self.item(*item, "");
                let sheet = self.students.get_mut(student).unwrap().get(&sheet).text(200);
                let has = between(&sheet, "<p class=\"total\" role=\"status\"><strong>", " of");
                let told = released(student, self.hours).then_some(expected).flatten();
                assert!(
                    is_same(has.map(|expected| expected.parse().unwrap()), told),
                    "{student} {item}: {has:?} beside {told:?}"
                );
            }
            let list = self.assignment("");
            let list = self.students.get_mut(student).unwrap().get(&list).text(200);
            for item in &items {
                let cell = between(&list, &format!("/items/{}\"", self.whole.items[*item].key), "</tr>").unwrap();
                let cell = cell.rsplit("<td>").next().unwrap();
                let told = released(student, self.hours).then_some(points[&(student, *item)]).flatten();
                assert!(is_same(cell.split(" of").next().unwrap().parse().ok(), told), "{student} {item}: {cell}");
            }
            let together = between(&list, "Total</th><td></td><td>", " of").map(|points| points.parse().unwrap());
            let told = released(student, self.hours).then(|| sums[student]);
            assert!(is_same(together, told), "{student}: {together:?} beside {told:?}");
        }
        for item in items {
            let all: Vec<f64> = STUDENTS.into_iter().filter_map(|student| points[&(student, item)]).collect();
            let row = between(&statistics, &format!("<tr><th scope=\"row\">{}. ", item + 1), "</tr>");
            let said = row.and_then(|row| row.rsplit("<td>").next()?.split(" of").next()?.parse().ok());
            #[expect(clippy::cast_precision_loss, reason = "two students")]
            let mean = (!all.is_empty()).then(|| all.iter().sum::<f64>() / all.len() as f64);
            assert!(is_same(said, mean), "{item}: {said:?} beside {mean:?}");
        }
    }
}

/// Whether two places have the same points, where one or both are rounded.
fn is_same(one: Option<f64>, other: Option<f64>) -> bool {
    match (one, other) {
        (Some(one), Some(other)) => (one - other).abs() < ROUNDED,
        (one, other) => one.is_none() && other.is_none(),
    }
}

fn between<'a>(text: &'a str, before: &str, after: &str) -> Option<&'a str> {
    text.split_once(before)?.1.split(after).next()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    #[test]
    fn points_are_the_same_in_every_place(
        steps in prop::collection::vec(step(), 4..12),
        verdicts in select(&Release::ALL[..]),
    ) {
        let university = University::new();
        let mut class = Class::new(&university, verdicts);
        let mut extended = BTreeSet::new();
        for step in &steps {
            class.play(step);
            if let Step::Extend(student) = step {
                extended.insert(*student);
            }
            let closes = |student: &str| if extended.contains(student) { 110 } else { 72 };
            class.compare(|student, hours| verdicts == Release::AtOnce || hours > closes(student));
        }
        class.wait(120);
        class.compare(|_, _| true);
    }
}
