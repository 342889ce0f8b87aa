//! Somebody asks for a page.

use std::str::FromStr;
use std::sync::Arc;

use serde::Serialize;

use crate::course::{Course, Key, Moment, Person};
use crate::store::{Entry, Membership, Store};

use super::super::app::{App, SharedApp};
use super::super::parameters::Parameters;
use super::around::{Around, AroundCourse};
use super::outcome::NotShown;
use super::reply::Reply;
use super::session;
use super::state::Courses;

/// Somebody asks for a page, or sends a form.
pub(super) struct Visit {
    pub(super) app: SharedApp,
    pub(super) courses: Arc<Courses>,
    /// The host and port that the browser asked, or that was said at the start.
    pub(super) host: String,
    /// When the server had the request.
    pub(super) now: Moment,
    /// Who asks, once signed in.
    pub(super) person: Option<Person>,
    /// The place of that person in the course of the address.
    pub(super) place: Option<Membership>,
    /// The hash of the session's token.
    pub(super) session: Option<String>,
    /// The parts of the address that are names: `course`, `item`.
    pub(super) path: Vec<(String, String)>,
    /// The fields of the address, or of the form.
    pub(super) fields: Parameters,
}

impl Visit {
    pub(super) fn store(&self) -> &Store {
        &self.courses.store
    }

    /// Who asks.
    pub(super) fn person(&self) -> Result<&Person, NotShown> {
        self.person.as_ref().ok_or(NotShown::SignIn)
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
        self.path.iter().find(|(own, _)| own == name).map_or("", |(_, value)| value)
    }

    /// A part of the address that is a key.
    pub(super) fn key<Of>(&self, name: &str) -> Result<Key<Of>, NotShown> {
        Key::from_str(self.part(name)).map_err(|_| NotShown::missing(format!("there is no such {name}")))
    }

    /// An address of a page of this server.
    pub(super) fn address(&self, path: &str) -> String {
        format!("{}{path}", self.app.settings.base_path)
    }

    /// The address of a page of this server as it is sent to others.
    pub(super) fn public(&self, path: &str) -> String {
        let scheme = if self.app.settings.is_secure { "https" } else { "http" };
        format!("{scheme}://{}{}", self.host, self.address(path))
    }

    /// The address of a page of the course.
    pub(super) fn in_course(&self, path: &str) -> Result<String, NotShown> {
        Ok(self.address(&format!("/courses/{}{path}", self.course()?.key)))
    }

    /// What is noted of something that is done here.
    pub(super) fn entry(&self, what: &str, detail: impl Into<String>) -> Entry {
        Entry {
            key: session::key(),
            at: self.now,
            by: self.person.as_ref().map(|person| person.key),
            course: self.place.as_ref().map(|place| place.course.key),
            what: what.to_owned(),
            detail: detail.into(),
        }
    }

    /// Does what takes a processor's time on a worker.
    pub(super) async fn work<T: Send + 'static>(
        &self,
        work: impl FnOnce(&App) -> Result<T, NotShown> + Send + 'static,
    ) -> Result<T, NotShown> {
        let app = SharedApp::clone(&self.app);
        self.app.workers.work(move || work(&app)).await?
    }

    /// A page through the template of that name.
    pub(super) async fn page(&self, template: &'static str, page: impl Serialize) -> Result<Reply, NotShown> {
        let around = self.around();
        // As a value it may outlive what it was made of.
        let page = serde_json::to_value(page).map_err(|error| NotShown::Store(error.into()))?;
        let text = self.work(move |app| Ok(app.page_for(&around, template, &page)?)).await?;
        Ok(Reply::Page(text))
    }

    /// What every page of a course knows besides its own.
    pub(super) fn around(&self) -> Around {
        Around {
            signed_in: self.person.as_ref().map(|person| person.shown().to_owned()),
            operator: self.person.as_ref().is_some_and(|person| person.operator),
            course: self.place.as_ref().map(|place| AroundCourse {
                key: place.course.key.to_string(),
                title: place.course.title.clone(),
                role: place.member.role.name(),
                staff: place.member.role.is_staff(),
            }),
        }
    }
}
