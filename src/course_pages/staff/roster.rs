//! The roster of a course: what a table would change, and who takes part.

use serde::Serialize;

use momentous_course::{Course, Role, RosterChange, RosterRow, roster_changes, roster_records};
use momentous_pages::words;
use momentous_store::Membership;

use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::session;
use super::super::visit::Visit;
use super::class::Class;
use super::form::{Form, sentences};
use super::person_form;
use super::requests::Requests;

/// The fields of the form that adds staff.
pub(super) const STAFF_FIELDS: [&str; 3] = ["login", "name", "role"];

#[derive(Serialize)]
struct RosterPage {
    title: &'static str,
    members: Vec<Listed>,
    /// The number of students.
    students: usize,
    /// The number of them that can be given links.
    unlinked: usize,
    /// Whether links lead to this machine only.
    only_here: bool,
    /// The table that was sent.
    text: String,
    /// Its faults.
    faults: Vec<String>,
    /// The form that adds staff.
    staff: Form,
    /// The code of the course, and who asks for a place by it.
    requests: Requests,
    done: bool,
}

#[derive(Serialize)]
struct Listed {
    key: String,
    login: String,
    name: String,
    section: String,
    role: &'static str,
    is_staff: bool,
    left: bool,
    has_password: bool,
    /// Why no link can be made here; nothing where one can.
    no_link: Option<&'static str>,
}

#[derive(Serialize)]
struct PreviewPage {
    title: &'static str,
    changes: Vec<ShownChange>,
    text: String,
    shown: String,
}

/// A change as a row of a table.
#[derive(Debug, PartialEq, Eq, Serialize)]
struct ShownChange {
    kind: &'static str,
    login: String,
    name: String,
    from: String,
    to: String,
}

/// Shows the members, and the forms that change them.
pub(crate) async fn page(visit: &Visit) -> Result<Reply, NotShown> {
    let empty = no_staff();
    with(visit, &Class::of(visit).await?, (String::new(), Vec::new()), empty).await
}

/// The empty form that adds staff.
fn no_staff() -> Form {
    Form::new(STAFF_FIELDS.map(|name| (name, String::new())))
}

pub(super) async fn with(
    visit: &Visit,
    class: &Class,
    (text, faults): (String, Vec<String>),
    staff: Form,
) -> Result<Reply, NotShown> {
    let listed = |membership: &Membership| Listed {
        key: membership.member.key.to_string(),
        login: membership.person.login.clone(),
        name: membership.person.shown().to_owned(),
        section: membership.member.section.clone(),
        role: membership.member.role.name(),
        is_staff: membership.member.role.is_staff(),
        left: membership.member.left.is_some(),
        has_password: class.has_password(membership),
        no_link: class.may_link(membership).err(),
    };
    let members: Vec<Listed> = class.members.iter().map(listed).collect();
    let is_wrong = !faults.is_empty() || staff.is_wrong();
    let page = RosterPage {
        title: words::ROSTER,
        students: members.iter().filter(|listed| !listed.is_staff && !listed.left).count(),
        unlinked: class.unlinked().count(),
        only_here: visit.leads_here_only(),
        members,
        text,
        faults,
        staff,
        requests: Requests::of(visit, class).await?,
        done: !is_wrong && visit.fields.get("done").is_some(),
    };
    let page = visit.page("courses/staff/roster", page).await?;
    Ok(if is_wrong { page.wrong() } else { page })
}

impl Class {
    /// Those who have no password and can be given a link here.
    pub(super) fn unlinked(&self) -> impl Iterator<Item = &Membership> {
        self.members.iter().filter(|membership| !self.has_password(membership) && self.may_link(membership).is_ok())
    }

    /// The changes that a table would make.
    fn changes(&self, text: &str) -> Result<Vec<RosterChange>, Vec<String>> {
        let said = |message: String| sentences(&message);
        let mut rows = RosterRow::all(text).map_err(|faults| faults.into_iter().map(said).collect::<Vec<_>>())?;
        // A name is the same in all courses: the roster of one renames nobody who is known in another.
        for row in rows.iter_mut().filter(|row| self.is_known_elsewhere(&row.login)) {
            row.name.clear();
        }
        roster_changes(&rows, &self.pairs()).map_err(|staff| {
            let membership =
                |login: String| format!("`{login}` teaches this course. Leave the row out; staff are changed below.");
            staff.into_iter().map(membership).collect()
        })
    }

    fn shown(&self, change: &RosterChange) -> ShownChange {
        let login = |key| self.member(key).map(|membership| membership.person.login.clone()).unwrap_or_default();
        let name = |key| self.member(key).map(|membership| membership.person.shown().to_owned()).unwrap_or_default();
        let (kind, login, name, from, to) = match change.clone() {
            RosterChange::New { row } => ("new", row.login, row.name, String::new(), row.section),
            RosterChange::Back { row, .. } => ("back", row.login, row.name, String::new(), row.section),
            RosterChange::Renamed { member, from, to } => ("renamed", login(member), to.clone(), from, to),
            RosterChange::Moved { member, from, to } => ("moved", login(member), name(member), from, to),
            RosterChange::Gone { member, name } => ("gone", login(member), name, String::new(), String::new()),
        };
        ShownChange { kind, login, name, from, to }
    }
}

/// A seal for a table and the changes that it makes: where either differs from what was shown, so does the seal.
fn seal(text: &str, changes: &[RosterChange]) -> String {
    let changes = format!("{changes:?}");
    session::hash(&format!("{}\0{changes}\0{text}", changes.len()))
}

/// Browsers send the ends of lines in their own way.
fn table(visit: &Visit) -> String {
    visit.fields.text("table").replace("\r\n", "\n")
}

/// Shows the changes that a table would make. Nothing is changed yet.
pub(crate) async fn preview(visit: &Visit) -> Result<Reply, NotShown> {
    let (class, text) = (Class::of(visit).await?, table(visit));
    match class.changes(&text) {
        Err(faults) => with(visit, &class, (text, faults), no_staff()).await,
        Ok(changes) => {
            let shown = seal(&text, &changes);
            let changes = changes.iter().map(|change| class.shown(change)).collect();
            visit.page("courses/staff/preview", PreviewPage { title: words::ROSTER, changes, text, shown }).await
        }
    }
}

/// Makes the changes that were shown, and no others.
pub(crate) async fn apply(visit: &Visit) -> Result<Reply, NotShown> {
    let (class, text) = (Class::of(visit).await?, table(visit));
    let changes = match class.changes(&text) {
        Ok(changes) => changes,
        Err(faults) => return with(visit, &class, (text, faults), no_staff()).await,
    };
    if visit.fields.get("shown") != Some(seal(&text, &changes).as_str()) {
        let message = "the roster is no longer as it was when these changes were shown";
        return Err(NotShown::Conflict(message.to_owned()));
    }
    let Course { key, .. } = *visit.course()?;
    let others = visit.store().people().await?;
    let mut random = session::random;
    let records = roster_records(&changes, (key, &class.pairs()), &others, visit.now, &mut random);
    let count = |kind: &str| changes.iter().filter(|change| class.shown(change).kind == kind).count();
    let counts = ["new", "back", "renamed", "moved", "gone"].map(|kind| (count(kind), kind)).into_iter();
    let told = counts.filter(|(count, _)| *count > 0).map(|(count, kind)| format!("{count} {kind}"));
    let detail = told.collect::<Vec<_>>().join(", ");
    let entry = visit.entry("roster changed", detail);
    person_form::unless_taken(visit.store().save_members(&records.people, &records.members, &entry).await)?;
    Ok(Reply::To(visit.in_course("/roster?done=yes")?))
}

/// The roles of staff.
pub(super) fn staff_role(name: &str) -> Option<Role> {
    Role::named(name).filter(|role| role.is_staff())
}
