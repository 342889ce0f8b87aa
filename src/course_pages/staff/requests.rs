//! Requests for a place in a course, and the code by which they are made.

use std::collections::{BTreeMap, BTreeSet};

use serde::Serialize;

use momentous_course::{Asker, Code, CourseCode, Key, Member, Person, PlaceRequest, Role};

use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::session;
use super::super::visit::Visit;
use super::class::Class;
use super::person_form;

/// For how many days a code can be good.
const DAYS: [u32; 4] = [1, 7, 14, 60];
/// The milliseconds of a day.
const DAY: i64 = 86_400_000;

/// The part of the roster's page that is about requests.
#[derive(Serialize)]
pub(super) struct Requests {
    code: Option<ShownCode>,
    days: [u32; 4],
    waiting: Vec<Waiting>,
}

#[derive(Serialize)]
struct ShownCode {
    code: String,
    /// The page on which it is typed, as an address that others can open.
    page: String,
    until: String,
}

/// Somebody who waits.
#[derive(Serialize)]
struct Waiting {
    key: String,
    login: String,
    name: String,
    at: String,
    /// The objection to a place, or a remark on it.
    note: &'static str,
    /// Whether the request can be confirmed.
    may: bool,
}

impl Requests {
    pub(super) async fn of(visit: &Visit, class: &Class) -> Result<Self, NotShown> {
        let course = visit.course()?;
        let code = visit.store().code_of(course.key, visit.now).await?.map(|code| ShownCode {
            code: code.code.to_string(),
            page: visit.public("/join"),
            until: code.expires.shown(&course.zone),
        });
        let waiting = read(visit, class).await?.iter().map(|request| request.shown(&course.zone)).collect();
        Ok(Self { code, days: DAYS, waiting })
    }
}

/// A request, and the person whom it would bring into the course.
struct ReadRequest {
    request: PlaceRequest,
    /// Nobody where the person was erased meanwhile.
    person: Option<Person>,
    against: Against,
}

/// The objection to a request.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Against {
    Nothing,
    /// Somebody has the login: a person of the server, who would have asked after signing in.
    TakenLogin,
    /// Others ask for the same login.
    SameLogin,
    /// The person is in the course, or no longer on the server.
    Settled,
}

impl Against {
    const fn note(self) -> &'static str {
        match self {
            Self::Nothing => "",
            Self::TakenLogin => {
                "Somebody signs in by this login already. Who asks has to sign in first, and ask again."
            }
            Self::SameLogin => "Several ask for this login. Find out who it is, confirm one, and decline the others.",
            Self::Settled => "This person is in the course by now, or no longer on this server.",
        }
    }
}

impl ReadRequest {
    fn shown(&self, zone: &str) -> Waiting {
        let (login, name) =
            self.person.as_ref().map_or(("", "(erased)"), |person| (person.login.as_str(), person.shown()));
        Waiting {
            key: self.request.key.to_string(),
            login: login.to_owned(),
            name: name.to_owned(),
            at: self.request.at.shown(zone),
            note: self.against.note(),
            may: matches!(self.against, Against::Nothing | Against::SameLogin),
        }
    }
}

/// The requests of the course. Everybody is read at once, however many ask.
async fn read(visit: &Visit, class: &Class) -> Result<Vec<ReadRequest>, NotShown> {
    let requests = visit.store().place_requests(visit.course()?.key).await?;
    if requests.is_empty() {
        return Ok(Vec::new());
    }
    let people = visit.store().people().await?;
    let by_key: BTreeMap<Key<Person>, &Person> = people.iter().map(|person| (person.key, person)).collect();
    let logins: BTreeSet<&str> = people.iter().map(|person| person.login.as_str()).collect();
    let is_here = |person: Key<Person>| {
        class.members.iter().any(|membership| membership.person.key == person && membership.member.left.is_none())
    };
    let mut same: BTreeMap<&str, usize> = BTreeMap::new();
    for request in &requests {
        if let Asker::New { login, .. } = &request.asker {
            *same.entry(login).or_default() += 1;
        }
    }
    let read = |request: &PlaceRequest| {
        let (person, against) = match &request.asker {
            Asker::Known(key) => match by_key.get(key) {
                Some(person) if !is_here(*key) => (Some((*person).clone()), Against::Nothing),
                other => (other.map(|person| (*person).clone()), Against::Settled),
            },
            Asker::New { login, name, .. } => {
                let (login, name) = (login.clone(), name.clone());
                let against = match same.get(login.as_str()) {
                    _ if logins.contains(login.as_str()) => Against::TakenLogin,
                    Some(count) if *count > 1 => Against::SameLogin,
                    _ => Against::Nothing,
                };
                (Some(Person { key: session::key(), login, name, operator: false, erased: None }), against)
            }
        };
        ReadRequest { request: request.clone(), person, against }
    };
    Ok(requests.iter().map(read).collect())
}

/// A new code, in place of the one before.
pub(crate) async fn new_code(visit: &Visit) -> Result<Reply, NotShown> {
    let days = visit.fields.get("days").and_then(|text| text.parse().ok()).filter(|days| DAYS.contains(days));
    let days = days.ok_or_else(|| NotShown::field("choose for how many days the code is good"))?;
    let course = visit.course()?.key;
    let expires = visit.now.after(i64::from(days) * DAY);
    let code = CourseCode { course, code: Code::drawn(session::random()), expires };
    visit.store().save_code(&code, &visit.entry("join code created", format!("{days} days"))).await?;
    Ok(Reply::To(visit.in_course("/roster?done=yes#requests")?))
}

/// Ends the code.
pub(crate) async fn end_code(visit: &Visit) -> Result<Reply, NotShown> {
    visit.store().end_code(visit.course()?.key, &visit.entry("join code ended", "")).await?;
    Ok(Reply::To(visit.in_course("/roster?done=yes#requests")?))
}

/// The requests that a form names.
async fn chosen(visit: &Visit, class: &Class) -> Result<Vec<ReadRequest>, NotShown> {
    let keys: BTreeSet<&str> = visit.fields.all("request").collect();
    if keys.is_empty() {
        return Err(NotShown::field("nobody was chosen; tick those whom you mean"));
    }
    let all = read(visit, class).await?;
    let chosen: Vec<ReadRequest> =
        all.into_iter().filter(|request| keys.contains(request.request.key.to_string().as_str())).collect();
    if chosen.len() == keys.len() { Ok(chosen) } else { Err(settled_meanwhile()) }
}

fn settled_meanwhile() -> NotShown {
    NotShown::Conflict("one of these requests was settled a moment ago".to_owned())
}

/// Takes those who were chosen into the course, as students. They sign in by the password that they chose.
pub(crate) async fn confirm(visit: &Visit) -> Result<Reply, NotShown> {
    let class = Class::of(visit).await?;
    let chosen = chosen(visit, &class).await?;
    let course = visit.course()?.key;
    let (mut people, mut members, mut logins) = (Vec::new(), Vec::new(), BTreeSet::new());
    for request in &chosen {
        let (Some(person), Against::Nothing | Against::SameLogin) = (&request.person, request.against) else {
            let name = request.person.as_ref().map_or("(erased)", Person::shown);
            return Err(NotShown::NotPossible(format!("{name}: {}", request.against.note())));
        };
        if !logins.insert(person.login.as_str()) {
            let message = format!("two of those whom you chose ask for the login {}; choose one of them", person.login);
            return Err(NotShown::NotPossible(message));
        }
        if let Asker::New { password, .. } = &request.request.asker {
            people.push((person.clone(), password.clone()));
        }
        let before = class.members.iter().find(|before| before.person.key == person.key);
        members.push(match before {
            // Whoever taught it and left comes back as a student.
            Some(before) => Member { role: Role::Student, left: None, ..before.member.clone() },
            None => {
                let (key, section) = (session::key(), String::new());
                Member { key, course, person: person.key, role: Role::Student, section, left: None }
            }
        });
    }
    let requests: Vec<_> = chosen.iter().map(|request| request.request.key).collect();
    let entry = visit.entry("places confirmed", format!("{} students", members.len()));
    let settled = visit.store().settle_requests(&requests, &people, &members, &entry).await;
    done(visit, person_form::unless_taken(settled)?)
}

/// Takes requests away. Who asked is told nothing.
pub(crate) async fn decline(visit: &Visit) -> Result<Reply, NotShown> {
    let class = Class::of(visit).await?;
    let requests: Vec<_> = chosen(visit, &class).await?.iter().map(|request| request.request.key).collect();
    let entry = visit.entry("places declined", format!("{} requests", requests.len()));
    done(visit, visit.store().settle_requests(&requests, &[], &[], &entry).await?)
}

fn done(visit: &Visit, is_settled: bool) -> Result<Reply, NotShown> {
    if is_settled { Ok(Reply::To(visit.in_course("/roster?done=yes#requests")?)) } else { Err(settled_meanwhile()) }
}
