//! Somebody asks for a page.

use std::net::IpAddr;
use std::str::FromStr;
use std::sync::Arc;

use serde::Serialize;

use momentous_course::{Course, Key, Moment, Person};
use momentous_store::{Entry, Membership, Store};

use super::around::{CourseFrame, VisitFrame};
use super::outcome::NotShown;
use super::reply::Reply;
use super::session;
use super::state::Courses;
use super::visitor::Visitor;
use momentous_pages::Parameters;
use momentous_web::Lane;
use momentous_web::{App, SharedApp};

/// Somebody asks for a page, or sends a form.
pub(super) struct Visit {
    pub(super) app: SharedApp,
    pub(super) courses: Arc<Courses>,
    /// When the server had the request.
    pub(super) now: Moment,
    /// The place of that person in the course of the address.
    pub(super) place: Option<Membership>,
    /// The session of that person.
    pub(super) visitor: Option<Visitor>,
    /// The token of a browser that has asked for a link by mail.
    pub(super) browser: Option<String>,
    /// From where the request comes.
    pub(super) from: IpAddr,
    /// The parts of the address that are names: `course`, `item`.
    pub(super) path: Vec<(String, String)>,
    /// The fields of the address, or of the form.
    pub(super) fields: Parameters,
}

impl Visit {
    pub(super) fn store(&self) -> &Store {
        &self.courses.store
    }

    /// The person who asks.
    pub(super) fn person(&self) -> Result<&Person, NotShown> {
        self.visitor().map(|visitor| &visitor.person)
    }

    /// The person who asks, with the session.
    pub(super) fn visitor(&self) -> Result<&Visitor, NotShown> {
        self.visitor.as_ref().ok_or(NotShown::SignIn)
    }

    /// The place of who asks in the course of the address.
    pub(super) fn place(&self) -> Result<&Membership, NotShown> {
        self.place.as_ref().ok_or_else(|| NotShown::missing("there is no such course, or you are not in it"))
    }

    /// The course of the address.
    pub(super) fn course(&self) -> Result<&Course, NotShown> {
        self.place().map(|place| &place.course)
    }

    /// A part of the address.
    pub(super) fn part(&self, name: &str) -> &str {
        self.path.iter().find(|(key, _)| key == name).map_or("", |(_, value)| value)
    }

    /// A part of the address that is a key.
    pub(super) fn key<Of>(&self, name: &str) -> Result<Key<Of>, NotShown> {
        Key::from_str(self.part(name)).map_err(|_| NotShown::missing(format!("there is no such {name}")))
    }

    /// An address of a page of this server.
    pub(super) fn address(&self, path: &str) -> String {
        format!("{}{path}", self.app.settings.base_path)
    }

    /// The address of a page of this server as it is sent to others: never one that a browser made up.
    pub(super) fn public(&self, path: &str) -> String {
        let settings = &self.app.settings;
        let host = settings.host.clone().unwrap_or_else(|| settings.local().to_string());
        format!("{}://{host}{}", settings.scheme(), self.address(path))
    }

    /// Whether such an address leads to this machine only, because the server was not told where others reach it.
    pub(super) fn leads_here_only(&self) -> bool {
        self.app.settings.host.is_none() && self.app.settings.local().ip().is_loopback()
    }

    /// The address of a page of the course.
    pub(super) fn in_course(&self, path: &str) -> Result<String, NotShown> {
        Ok(self.address(&format!("/courses/{}{path}", self.course()?.key)))
    }

    /// The entry in the trail for something that is done here.
    pub(super) fn entry(&self, what: &str, detail: impl Into<String>) -> Entry {
        Entry {
            key: session::key(),
            at: self.now,
            by: self.visitor.as_ref().map(|visitor| visitor.person.key),
            course: self.place.as_ref().map(|place| place.course.key),
            what: what.to_owned(),
            detail: detail.into(),
        }
    }

    /// The same of something that happens to a person: in the trail of every course of that person, and in that of the address.
    pub(super) async fn entries(&self, person: Key<Person>, what: &str) -> Result<Vec<Entry>, NotShown> {
        let course_here = self.place.as_ref().map(|place| place.course.key);
        let places = self.store().courses_of(person).await?;
        let mut entries: Vec<Entry> = places
            .iter()
            .map(|place| {
                let course = Some(place.course.key);
                let said = if course == course_here || course_here.is_none() {
                    what.to_owned()
                } else {
                    format!("{what} in another course")
                };
                Entry { course, ..self.entry(&said, format!("member {}", place.member.key)) }
            })
            .collect();
        if places.iter().all(|place| Some(place.course.key) != course_here) {
            entries.push(self.entry(what, ""));
        }
        Ok(entries)
    }

    /// Does what takes a processor's time on a worker.
    pub(super) async fn work<T: Send + 'static>(
        &self,
        work: impl FnOnce(&App) -> Result<T, NotShown> + Send + 'static,
    ) -> Result<T, NotShown> {
        let app = SharedApp::clone(&self.app);
        let lane = if self.visitor.is_some() { Lane::SignedIn } else { Lane::Door };
        self.app.workers.work(lane, move || work(&app)).await?
    }

    /// A page through the template of that name.
    pub(super) async fn page(&self, template: &'static str, page: impl Serialize) -> Result<Reply, NotShown> {
        // The header leaves out what is hidden.
        if self.visitor.is_some() {
            self.courses.hidden.at(&self.app.pages.library, self.store(), self.now).await;
        }
        let frame = self.around();
        // As a value it may outlive what it was made of.
        let page = serde_json::to_value(page).map_err(|error| NotShown::Store(error.into()))?;
        let text = self.work(move |app| Ok(app.page_for(&frame, template, &page)?)).await?;
        Ok(Reply::Page(text))
    }

    /// The values that every page of a course knows besides its own.
    pub(super) fn around(&self) -> VisitFrame {
        VisitFrame {
            signed_in: self.visitor.as_ref().map(|visitor| visitor.person.shown().to_owned()),
            operator: self.visitor.as_ref().is_some_and(|visitor| visitor.person.operator),
            course: self.place.as_ref().map(|place| CourseFrame {
                key: place.course.key.to_string(),
                title: place.course.title.clone(),
                role: place.member.role.name(),
                staff: place.member.role.is_staff(),
            }),
        }
    }
}
