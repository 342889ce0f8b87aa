//! Single members of a course: staff who are added, members who are taken out, links to sign in.

use std::io;

use momentous_course::{FieldFault, Member, Role};
use momentous_exercise::defused;
use momentous_store::Membership;

use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::session;
use super::super::visit::Visit;
use super::class::Class;
use super::form::Form;
use super::links::{LinkPage, link, links};
use super::person_form;
use super::person_form::Named;
use super::roster;

/// Adds somebody who teaches, or gives somebody in the course another role.
pub(crate) async fn add_staff(visit: &Visit) -> Result<Reply, NotShown> {
    let form = Form::sent(visit, &roster::STAFF_FIELDS);
    let mut faults = person_form::faults(&form);
    let role = roster::staff_role(form.value("role"));
    if role.is_none() {
        faults.push(FieldFault { field: "role", message: "choose assistant or instructor".to_owned() });
    }
    let class = Class::of(visit).await?;
    let (Some(role), true) = (role, faults.is_empty()) else {
        return roster::with(visit, &class, (String::new(), Vec::new()), form.with(&faults)).await;
    };
    let Named { person, is_new } = person_form::named(visit, &form).await?;
    let before = class
        .members
        .iter()
        .find(|membership| membership.person.key == person.key)
        .map(|membership| membership.member.clone());
    if let Some(member) = before.as_ref().filter(|member| member.role > role && !class.is_taught_without(member.key)) {
        let message = format!("this person is the only {} of the course\nhelp: add another first", member.role.name());
        let fault = FieldFault { field: "login", message };
        return roster::with(visit, &class, (String::new(), Vec::new()), form.with(&[fault])).await;
    }
    let course = visit.course()?.key;
    let section = String::new();
    let fresh = || Member { key: session::key(), course, person: person.key, role, section, left: None };
    let member = before.map_or_else(fresh, |member| Member { role, left: None, ..member });
    let entry = visit.entry("staff added", format!("{} {}", role.name(), member.key));
    let new = if is_new { std::slice::from_ref(&person) } else { &[] };
    person_form::unless_taken(visit.store().save_members(new, std::slice::from_ref(&member), &entry).await)?;
    let class = Class::of(visit).await?;
    let membership = class
        .member(member.key)
        .filter(|membership| !class.has_password(membership) && class.may_link(membership).is_ok());
    let link = match membership {
        Some(membership) => Some(link(visit, &membership.person).await?),
        None => None,
    };
    LinkPage::new(visit, "Added", &person, link, visit.in_course("/roster")?).reply(visit).await
}

/// The member whom a button names.
fn chosen<'c>(visit: &Visit, class: &'c Class) -> Result<&'c Membership, NotShown> {
    let key = visit.fields.get("member").and_then(|text| text.parse().ok());
    let membership = key.and_then(|key| class.member(key));
    membership.ok_or_else(|| NotShown::missing("there is no such member of this course"))
}

/// Takes somebody out of the course. What was handed in stays.
pub(crate) async fn remove(visit: &Visit) -> Result<Reply, NotShown> {
    let class = Class::of(visit).await?;
    let membership = chosen(visit, &class)?;
    if membership.member.role == Role::Instructor && !class.is_taught_without(membership.member.key) {
        let message = "this is the only instructor of the course; add another first";
        return Err(NotShown::NotPossible(message.to_owned()));
    }
    let member = Member { left: Some(visit.now), ..membership.member.clone() };
    let entry = visit.entry("member removed", member.key.to_string());
    visit.store().save_members(&[], &[member], &entry).await?;
    Ok(Reply::To(visit.in_course("/roster?done=yes")?))
}

/// A new link for one member.
pub(crate) async fn member_link(visit: &Visit) -> Result<Reply, NotShown> {
    let class = Class::of(visit).await?;
    let membership = chosen(visit, &class)?;
    if let Err(reason) = class.may_link(membership) {
        let message = format!("{reason}; whoever runs the server makes a new link");
        return Err(NotShown::NotPossible(message));
    }
    let link = Some(link(visit, &membership.person).await?);
    LinkPage::new(visit, "New link", &membership.person, link, visit.in_course("/roster")?).reply(visit).await
}

/// A table of links for those who have no password yet.
pub(crate) async fn link_table(visit: &Visit) -> Result<Reply, NotShown> {
    let class = Class::of(visit).await?;
    let members: Vec<&Membership> = class.unlinked().collect();
    let people: Vec<_> = members.iter().map(|membership| membership.person.clone()).collect();
    let links = links(visit, &people).await?;
    let bytes =
        written(&members, &links).map_err(|error| NotShown::field(format!("the table cannot be written: {error}")))?;
    Ok(Reply::Download { name: "sign-in-links.csv".to_owned(), kind: "text/csv; charset=utf-8", bytes })
}

/// The table begins with the mark of UTF-8, without which Excel reads names in another encoding.
fn written(members: &[&Membership], links: &[String]) -> io::Result<Vec<u8>> {
    let mut table = csv::Writer::from_writer("\u{feff}".as_bytes().to_vec());
    table.write_record(["id", "name", "section", "role", "link"])?;
    for (membership, link) in members.iter().zip(links) {
        let cells = [
            &membership.person.login,
            membership.person.shown(),
            &membership.member.section,
            membership.member.role.name(),
            link,
        ];
        table.write_record(cells.map(|cell| defused(cell).into_owned()))?;
    }
    table.into_inner().map_err(csv::IntoInnerError::into_error)
}
