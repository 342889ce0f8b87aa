//! Asking for a place in a course, by its code. Nothing opens before whoever teaches the course has confirmed it.

use serde::Serialize;

use momentous_course::{Asker, Code, Course, FieldFault, Key, PlaceRequest};
use momentous_pages::words;

use super::outcome::NotShown;
use super::password;
use super::reply::Reply;
use super::session;
use super::staff::{Form, person_form};
use super::visit::Visit;

/// Requests that may wait in a course: more than any course has students who have not been confirmed.
const MANY: i64 = 1000;

/// The fields of somebody whom nobody knows yet, which are shown again where one is at fault. A password never is.
const FIELDS: [&str; 3] = ["login", "name", "new"];

#[derive(Serialize)]
struct JoinPage {
    title: &'static str,
    /// The code as it was typed.
    code: String,
    /// The fault of the code.
    fault: Option<&'static str>,
    /// The course of the code.
    course: Option<Joined>,
}

#[derive(Serialize)]
struct Joined {
    title: String,
    standing: Standing,
}

/// How somebody stands to a course.
#[derive(Serialize)]
#[serde(tag = "kind", content = "of", rename_all = "snake_case")]
enum Standing {
    /// Nobody knows who it is.
    New(Form),
    /// Somebody who has signed in.
    Known,
    /// Somebody who has asked.
    Asked,
    /// Somebody who is in the course, with its key.
    Member(String),
}

/// The page on which a code is typed.
pub(super) async fn page(visit: &Visit) -> Result<Reply, NotShown> {
    match visit.fields.get("code").filter(|typed| !typed.trim().is_empty()) {
        None => shown(visit, String::new(), None, None).await,
        Some(typed) => match Code::read(typed) {
            Some(code) => Ok(Reply::To(visit.address(&format!("/join/{}", code.plain())))),
            None => unknown(visit, typed).await,
        },
    }
}

/// The page of a code: a form for those whom nobody knows, a button for others.
pub(super) async fn ask_page(visit: &Visit) -> Result<Reply, NotShown> {
    let Some(course) = course(visit).await? else { return unknown(visit, visit.part("code")).await };
    let standing = if visit.fields.get("asked").is_some() { Standing::Asked } else { standing(visit, &course).await? };
    joined(visit, course, standing).await
}

/// Keeps the request.
pub(super) async fn ask(visit: &Visit) -> Result<Reply, NotShown> {
    let Some(course) = course(visit).await? else { return unknown(visit, visit.part("code")).await };
    if visit.visitor.is_none() {
        visit.courses.limits.tried(visit.from)?;
    }
    if visit.store().waiting(course.key).await? >= MANY {
        let message = "many people wait for a place in this course; tell whoever teaches it";
        return Err(NotShown::NotPossible(message.to_owned()));
    }
    let asker = match standing(visit, &course).await? {
        Standing::New(_) => {
            let mut form = Form::sent(visit, &FIELDS);
            form.fill("new", String::new());
            let mut faults = person_form::faults(&form);
            if form.value("name").is_empty() {
                let message = "there is no name\nhelp: whoever teaches the course has to know who asks".to_owned();
                faults.push(FieldFault { field: "name", message });
            }
            let (new, again) = (visit.fields.text("new").to_owned(), visit.fields.text("again"));
            let of_password = password::fault(&new, again, form.value("login"));
            faults.extend(of_password.map(|message| FieldFault { field: "new", message }));
            if !faults.is_empty() {
                return joined(visit, course, Standing::New(form.with(&faults))).await.map(Reply::wrong);
            }
            let (login, name) = (form.value("login").to_owned(), form.value("name").to_owned());
            let password = visit.work(move |_| Ok(password::hash(&new))).await?;
            let password = password.ok_or_else(|| NotShown::field("the password cannot be kept; take another"))?;
            Asker::New { login, name, password }
        }
        Standing::Known => Asker::Known(visit.person()?.key),
        standing @ (Standing::Asked | Standing::Member(_)) => return joined(visit, course, standing).await,
    };
    let request = PlaceRequest { key: session::key(), course: course.key, asker, at: visit.now };
    visit.store().ask_for_place(&request).await?;
    Ok(Reply::To(visit.address(&format!("/join/{}?asked=yes", visit.part("code")))))
}

/// The course of the code in the address.
async fn course(visit: &Visit) -> Result<Option<Course>, NotShown> {
    let Some(code) = Code::read(visit.part("code")) else { return Ok(None) };
    let key: Option<Key<Course>> = visit.store().course_of_code(&code, visit.now).await?;
    match key {
        Some(key) => Ok(visit.store().course(key).await?),
        None => Ok(None),
    }
}

/// How whoever asks stands to a course. A session of another course says nothing of who somebody is here.
async fn standing(visit: &Visit, course: &Course) -> Result<Standing, NotShown> {
    let Some(visitor) = visit.visitor.as_ref().filter(|visitor| visitor.reaches(course.key)) else {
        return Ok(Standing::New(Form::new(FIELDS.map(|name| (name, String::new())))));
    };
    let person = visitor.person.key;
    if visit.store().membership(course.key, person).await?.is_some() {
        return Ok(Standing::Member(course.key.to_string()));
    }
    let waiting = visit.store().place_requests(course.key).await?;
    let has_asked = waiting.iter().any(|request| request.asker == Asker::Known(person));
    Ok(if has_asked { Standing::Asked } else { Standing::Known })
}

async fn joined(visit: &Visit, course: Course, standing: Standing) -> Result<Reply, NotShown> {
    shown(visit, visit.part("code").to_owned(), None, Some(Joined { title: course.title, standing })).await
}

async fn unknown(visit: &Visit, typed: &str) -> Result<Reply, NotShown> {
    let fault =
        "This code is not known, or its time is over. Compare it with what you were given, or ask for a new one.";
    shown(visit, typed.to_owned(), Some(fault), None).await.map(Reply::wrong)
}

async fn shown(
    visit: &Visit,
    code: String,
    fault: Option<&'static str>,
    course: Option<Joined>,
) -> Result<Reply, NotShown> {
    visit.page("courses/join", JoinPage { title: words::ASK_FOR_PLACE, code, fault, course }).await
}
