//! More time for one student, or for a section.

use std::collections::BTreeSet;

use serde::Serialize;

use momentous_course::{Extension, ExtensionForm, FieldFault, Role};
use momentous_pages::words;
use momentous_store::Membership;

use super::super::super::outcome::NotShown;
use super::super::super::reply::Reply;
use super::super::super::visit::Visit;
use super::super::form::Form;

/// The fields.
const FIELDS: [&str; 5] = ["member", "due", "late_until", "closes", "reason"];

/// The prefix of the name of a section that is chosen as a whole.
const SECTION: &str = "section ";

#[derive(Serialize)]
struct ExtensionsPage {
    title: &'static str,
    assignment: String,
    key: String,
    due: String,
    closes: String,
    zone: String,
    form: Form,
    /// Sections as a whole.
    sections: Vec<Chosen>,
    students: Vec<Chosen>,
    extensions: Vec<Listed>,
    saved: bool,
}

#[derive(Serialize)]
struct Chosen {
    key: String,
    name: String,
}

#[derive(Serialize)]
struct Listed {
    name: String,
    due: String,
    late_until: String,
    closes: String,
    reason: String,
}

/// The extensions of an assignment, and a form for another.
pub(crate) async fn extensions(visit: &Visit) -> Result<Reply, NotShown> {
    let assignment = super::assignment_of(visit).await?.assignment;
    let zone = &visit.course()?.zone;
    let dates = assignment.policy.form(zone);
    let fields = [("due", dates.due), ("late_until", dates.late_until), ("closes", dates.closes)];
    let empty = ["member", "reason"].map(|name| (name, String::new()));
    with(visit, Form::new(fields.into_iter().chain(empty))).await
}

async fn with(visit: &Visit, form: Form) -> Result<Reply, NotShown> {
    let assignment = super::assignment_of(visit).await?.assignment;
    let course = visit.course()?;
    let members = visit.store().members(course.key).await?;
    let name = |membership: &Membership| format!("{} ({})", membership.person.shown(), membership.person.login);
    let extensions = visit.store().extensions(assignment.key).await?.into_iter().map(|extension| Listed {
        name: members.iter().find(|other| other.member.key == extension.member).map(name).unwrap_or_default(),
        due: extension.due.shown(&course.zone),
        late_until: extension.late_until.map(|until| until.shown(&course.zone)).unwrap_or_default(),
        closes: extension.closes.shown(&course.zone),
        reason: extension.reason,
    });
    let extensions = extensions.collect();
    let students = members.iter().filter(|membership| is_student(membership));
    let mut students: Vec<Chosen> =
        students.map(|membership| Chosen { key: membership.member.key.to_string(), name: name(membership) }).collect();
    students.sort_by(|one, other| one.name.cmp(&other.name));
    let sections: BTreeSet<&str> = members
        .iter()
        .filter(|membership| is_student(membership))
        .map(|membership| membership.member.section.as_str())
        .collect();
    let sections = sections.into_iter().filter(|section| !section.is_empty());
    let sections = sections
        .map(|section| Chosen { key: format!("{SECTION}{section}"), name: format!("section {section}") })
        .collect();
    let is_wrong = form.is_wrong();
    let page = ExtensionsPage {
        title: words::EXTENSIONS,
        assignment: assignment.title,
        key: assignment.key.to_string(),
        due: assignment.policy.due.shown(&course.zone),
        closes: assignment.policy.closes.shown(&course.zone),
        zone: course.zone.clone(),
        form,
        sections,
        students,
        extensions,
        saved: !is_wrong && visit.fields.get("saved").is_some(),
    };
    let page = visit.page("courses/staff/extensions", page).await?;
    Ok(if is_wrong { page.wrong() } else { page })
}

fn is_student(membership: &Membership) -> bool {
    membership.member.role == Role::Student && membership.member.left.is_none()
}

/// Gives a student, or everybody of a section, more time; a second extension takes the place of the first.
pub(crate) async fn extend(visit: &Visit) -> Result<Reply, NotShown> {
    let assignment = super::assignment_of(visit).await?.assignment;
    let course = visit.course()?;
    let form = Form::sent(visit, &FIELDS);
    let members = visit.store().members(course.key).await?;
    let is_chosen = |membership: &&Membership| match form.value("member").strip_prefix(SECTION) {
        Some(section) => membership.member.section == section,
        None => membership.member.key.to_string() == form.value("member"),
    };
    let chosen: Vec<&Membership> =
        members.iter().filter(|membership| is_student(membership)).filter(is_chosen).collect();
    if chosen.is_empty() {
        let fault = FieldFault { field: "member", message: "choose a student or a section of the list".to_owned() };
        return with(visit, form.with(&[fault])).await;
    }
    let typed = |name: &str| form.value(name).to_owned();
    let fields = ExtensionForm {
        due: typed("due"),
        late_until: typed("late_until"),
        closes: typed("closes"),
        reason: typed("reason"),
    };
    let read = |membership: &&Membership| Extension::read(&fields, &assignment, membership.member.key, &course.zone);
    match chosen.iter().map(read).collect::<Result<Vec<_>, _>>() {
        Err(faults) => with(visit, form.with(&faults)).await,
        Ok(extensions) => {
            let with_entry = |extension: Extension| {
                let detail = format!("{} until {}, closes {}", extension.member, extension.due, extension.closes);
                let entry = visit.entry("extension given", detail);
                (extension, entry)
            };
            visit.store().extend(&extensions.into_iter().map(with_entry).collect::<Vec<_>>()).await?;
            Ok(Reply::To(visit.in_course(&format!("/assignments/{}/extensions?saved=yes", assignment.key))?))
        }
    }
}
