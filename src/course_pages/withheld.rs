//! Problems of open assignments, which are shown nowhere else meanwhile.

use std::collections::BTreeSet;

use momentous_course::{Course, Key, Kind, Reserved};
use momentous_exercise::calls::{Refused, RefusedKind};
use momentous_problem::Problem;
use momentous_store::StoreFault;

use super::outcome::NotShown;
use super::state::Courses;
use super::visit::Visit;
use super::visitor::Visitor;
use momentous_web::App;

/// The problems that practice, own numbers, solutions, playing and calls refuse to a visitor: those of open assignments, unless the
/// visitor teaches their courses.
#[derive(Debug, Default)]
pub(super) struct Withheld {
    reserved: Reserved,
    /// The kinds of problems that are solved for nobody with numbers of their own.
    hidden: Vec<Kind>,
}

impl Withheld {
    /// The problems withheld from a visitor, or from somebody who is not known.
    pub(super) async fn from(courses: &Courses, app: &App, visitor: Option<&Visitor>) -> Result<Self, StoreFault> {
        let (store, now) = (&courses.store, courses.clock.now());
        let hidden = courses.hidden.at(&app.pages.library, store, now).await;
        let open = store.open_assignments(now).await?;
        let taught: BTreeSet<Key<Course>> = match visitor {
            Some(visitor) if !open.is_empty() => {
                let places = visitor.places(store).await?.into_iter();
                places
                    .filter(|membership| membership.member.role.is_staff())
                    .map(|membership| membership.course.key)
                    .collect()
            }
            _ => BTreeSet::new(),
        };
        let mut reserved = Reserved::default();
        for (whole, extensions) in open.iter().filter(|(whole, _)| !taught.contains(&whole.assignment.course)) {
            reserved.add(&whole.assignment, &whole.items, extensions, now);
        }
        let hidden =
            hidden.iter().filter(|kind| !taught.contains(&kind.course)).map(|kind| kind.kind.clone()).collect();
        Ok(Self { reserved, hidden })
    }

    /// The same for simulators, which show every scene, without the records, too: what they must not solve.
    pub(super) async fn of_simulators(courses: &Courses, app: &App, visitor: Option<&Visitor>) -> Self {
        // Simulators ask often, and as a rule nothing is hidden.
        let all = courses.hidden.at(&app.pages.library, &courses.store, courses.clock.now()).await;
        if all.is_empty() {
            return Self::default();
        }
        let hidden = match Self::from(courses, app, visitor).await {
            Ok(withheld) => withheld.hidden,
            // Where nobody can say who teaches, it is hidden from everybody.
            Err(_) => all.iter().map(|kind| kind.kind.clone()).collect(),
        };
        Self { reserved: Reserved::default(), hidden }
    }

    /// The problems withheld from somebody who may see what practice refuses: those of open assignments in which that person is a
    /// student.
    pub(super) async fn from_student(visit: &Visit) -> Result<Self, NotShown> {
        let person = visit.person()?.key;
        let places = visit.store().courses_of(person).await?.into_iter();
        let attended: BTreeSet<Key<Course>> = places
            .filter(|membership| !membership.member.role.is_staff())
            .map(|membership| membership.course.key)
            .collect();
        let mut reserved = Reserved::default();
        if !attended.is_empty() {
            for (whole, extensions) in visit.store().open_assignments(visit.now).await? {
                if attended.contains(&whole.assignment.course) {
                    reserved.add(&whole.assignment, &whole.items, &extensions, visit.now);
                }
            }
        }
        Ok(Self { reserved, hidden: Vec::new() })
    }
}

impl momentous_pages::Withheld for Withheld {
    /// Refuses a problem that is withheld.
    fn check(&self, problem: &str) -> Result<(), Refused> {
        if !self.reserved.refuses(problem, false) {
            return Ok(());
        }
        let message = "this problem is part of an assignment that is open now";
        Err(Refused::new(RefusedKind::Reserved, message)
            .help("it can be practised again when the assignment has closed"))
    }

    /// Refuses numbers of one's own for a problem of a kind that is hidden.
    fn check_own_numbers(&self, problem: &Problem) -> Result<(), Refused> {
        let is_hidden = || {
            let kind = Kind::of(problem.loaded());
            self.hidden.iter().any(|hidden| hidden.is_like(&kind))
        };
        if self.hidden.is_empty() || !is_hidden() {
            return Ok(());
        }
        let message = "problems of this kind are not solved with own numbers while an assignment with one is open";
        Err(Refused::new(RefusedKind::Reserved, message).help("they are again when it has closed"))
    }
}
