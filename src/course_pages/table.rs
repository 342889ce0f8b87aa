//! Every page of courses: its address, who may see it, and what makes it. The router is built from this table, and nothing is served
//! that is not in it.

use std::pin::Pin;

use momentous_course::Role::{Assistant, Instructor, Student};

use super::account;
use super::courses;
use super::gate::Who;
use super::grades;
use super::joining;
use super::mail;
use super::outcome::NotShown;
use super::reply::Reply;
use super::staff::{assignment, members, new_course, people, print, problems, requests, roster, settings};
use super::student;
use super::visit::Visit;

/// The function that makes a page.
pub(super) type Make = for<'v> fn(&'v Visit) -> Pin<Box<dyn Future<Output = Result<Reply, NotShown>> + Send + 'v>>;

/// The effect of a request.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Does {
    /// It shows something.
    Shows,
    /// It changes something.
    Changes,
}

/// One row: what it does at which address, who may, and how it is made.
pub(super) struct Row {
    pub(super) does: Does,
    pub(super) address: &'static str,
    pub(super) who: Who,
    pub(super) make: Make,
}

/// Rows of the table, as they are read best.
macro_rules! rows {
    ($($does:ident $address:literal $who:expr, $make:path;)*) => {
        &[$(Row { does: Does::$does, address: $address, who: $who, make: |visit| Box::pin($make(visit)) }),*]
    };
}

const STUDENT: Who = Who::Member(Student);
const ASSISTANT: Who = Who::Member(Assistant);
const INSTRUCTOR: Who = Who::Member(Instructor);

/// Every page of courses.
pub(super) const ROWS: &[Row] = rows! {
    Shows   "/sign-in"                       Who::Anyone, account::sign_in_page;
    Changes "/sign-in"                       Who::Anyone, account::sign_in;
    Shows   "/sign-in/{token}"               Who::Anyone, account::link_page;
    Changes "/sign-in/{token}"               Who::Anyone, account::link;
    Changes "/mail"                          Who::Anyone, mail::ask;
    Shows   "/mail"                          Who::Anyone, mail::asked_page;
    Shows   "/mail/{token}"                  Who::Anyone, mail::link_page;
    Changes "/mail/{token}"                  Who::Anyone, mail::link;
    Shows   "/join"                          Who::Anyone, joining::page;
    Shows   "/join/{code}"                   Who::Anyone, joining::ask_page;
    Changes "/join/{code}"                   Who::Anyone, joining::ask;
    Changes "/sign-out"                      Who::SignedIn, account::sign_out;
    Shows   "/courses"                       Who::SignedIn, courses::page;
    Changes "/account/password"              Who::SignedIn, courses::change_password;
    Changes "/account/mail"                  Who::SignedIn, mail::change;
    Shows   "/courses/{course}"              STUDENT, student::course;
    Shows   "/courses/{course}/assignments/{assignment}" STUDENT, student::assignment;
    Shows   "/courses/{course}/items/{item}" STUDENT, student::item;
    Changes "/courses/{course}/items/{item}" STUDENT, student::hand_in;
    Changes "/courses/{course}/items/{item}/draft" STUDENT, student::draft;
    Changes "/courses/{course}/items/{item}/read" STUDENT, student::read;
    Changes "/courses/{course}/items/{item}/hint" STUDENT, student::hint;
    Changes "/courses/{course}/items/{item}/further/{part}" STUDENT, student::further;
    Shows   "/courses/{course}/items/{item}/solution" STUDENT, student::solution;
    Shows   "/courses/{course}/assignments/{assignment}/gradebook" ASSISTANT, grades::gradebook;
    Shows   "/courses/{course}/assignments/{assignment}/gradebook.csv" ASSISTANT, grades::gradebook_csv;
    Shows   "/courses/{course}/assignments/{assignment}/statistics" ASSISTANT, grades::statistics;
    Shows   "/courses/{course}/assignments/{assignment}/regrade" INSTRUCTOR, grades::regrade;
    Changes "/courses/{course}/assignments/{assignment}/regrade" INSTRUCTOR, grades::regrade_apply;
    Shows   "/courses/{course}/items/{item}/students/{member}" ASSISTANT, grades::answers;
    Changes "/courses/{course}/items/{item}/students/{member}/points" INSTRUCTOR, grades::set_points;
    Changes "/courses/{course}/items/{item}/students/{member}/redact" INSTRUCTOR, grades::redact;
    Shows   "/courses/{course}/members/{member}" ASSISTANT, grades::member;
    Shows   "/courses/{course}/members/{member}/data" STUDENT, grades::data;
    Changes "/courses/{course}/members/{member}/erase" INSTRUCTOR, grades::erase;
    Shows   "/courses/{course}/gradebook"    ASSISTANT, grades::course_gradebook;
    Changes "/courses/{course}/gradebook"    INSTRUCTOR, grades::save_grading;
    Shows   "/courses/{course}/gradebook.csv" ASSISTANT, grades::course_gradebook_csv;
    Shows   "/courses/{course}/trail"        INSTRUCTOR, grades::trail;
    Shows   "/courses/{course}/retention"    INSTRUCTOR, grades::retention;
    Changes "/courses/{course}/retention"    INSTRUCTOR, grades::forget;
    Shows   "/people"                        Who::Operator, people::page;
    Changes "/people"                        Who::Operator, people::add;
    Changes "/people/link"                   Who::Operator, people::new_link;
    Changes "/people/mail"                   Who::Operator, people::set_address;
    Shows   "/courses/new"                   Who::Operator, new_course::page;
    Changes "/courses/new"                   Who::Operator, new_course::make;
    Shows   "/courses/{course}/settings"     INSTRUCTOR, settings::page;
    Changes "/courses/{course}/settings"     INSTRUCTOR, settings::save;
    Shows   "/courses/{course}/roster"       INSTRUCTOR, roster::page;
    Changes "/courses/{course}/roster/preview" INSTRUCTOR, roster::preview;
    Changes "/courses/{course}/roster/apply" INSTRUCTOR, roster::apply;
    Changes "/courses/{course}/roster/staff" INSTRUCTOR, members::add_staff;
    Changes "/courses/{course}/roster/remove" INSTRUCTOR, members::remove;
    Changes "/courses/{course}/roster/link"  INSTRUCTOR, members::member_link;
    Changes "/courses/{course}/roster/links" INSTRUCTOR, members::link_table;
    Changes "/courses/{course}/roster/code"  INSTRUCTOR, requests::new_code;
    Changes "/courses/{course}/roster/code/end" INSTRUCTOR, requests::end_code;
    Changes "/courses/{course}/roster/confirm" INSTRUCTOR, requests::confirm;
    Changes "/courses/{course}/roster/decline" INSTRUCTOR, requests::decline;
    Shows   "/courses/{course}/problems"     INSTRUCTOR, problems::list;
    Shows   "/courses/{course}/problems/new" INSTRUCTOR, problems::new;
    Changes "/courses/{course}/problems/new" INSTRUCTOR, problems::save;
    Changes "/courses/{course}/problems/preview" INSTRUCTOR, problems::preview;
    Shows   "/courses/{course}/problems/{digest}" INSTRUCTOR, problems::show;
    Changes "/courses/{course}/problems/{digest}/check" INSTRUCTOR, problems::check;
    Changes "/courses/{course}/problems/{digest}/publish" INSTRUCTOR, problems::publish;
    Shows   "/courses/{course}/assignments/{assignment}/print" INSTRUCTOR, print::page;
    Shows   "/courses/{course}/assignments/{assignment}/print/sheets" INSTRUCTOR, print::sheets;
    Shows   "/courses/{course}/assignments/{assignment}/print/key" INSTRUCTOR, print::key;
    Shows   "/courses/{course}/look"         INSTRUCTOR, assignment::look;
    Shows   "/courses/{course}/assignments/new" INSTRUCTOR, assignment::new;
    Changes "/courses/{course}/assignments/new" INSTRUCTOR, assignment::make;
    Shows   "/courses/{course}/assignments/{assignment}/edit" INSTRUCTOR, assignment::edit;
    Changes "/courses/{course}/assignments/{assignment}/edit" INSTRUCTOR, assignment::save;
    Shows   "/courses/{course}/assignments/{assignment}/extensions" INSTRUCTOR, assignment::extensions;
    Changes "/courses/{course}/assignments/{assignment}/extensions" INSTRUCTOR, assignment::extend;
};

/// An address of the table: for tests that try every one as everybody.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Address {
    /// Whether it takes a form (`POST`) or shows something (`GET`).
    pub changes: bool,
    /// The address, with the names of its parts in braces.
    pub pattern: &'static str,
    /// The people who may see it.
    pub who: Who,
}

/// Every address of the pages of courses.
pub fn addresses() -> impl Iterator<Item = Address> {
    ROWS.iter().map(|row| Address { changes: row.does == Does::Changes, pattern: row.address, who: row.who })
}
