//! Problems of open assignments, which are shown nowhere else meanwhile.

use std::collections::BTreeSet;

use crate::course::{Course, Key, Reserved};
use crate::exercise::calls::{Problems, Refused, RefusedKind};
use crate::problem::Problem;
use crate::store::StoreFault;

use super::super::app::App;
use super::outcome::NotShown;
use super::visit::Visit;
use super::visitor::Visitor;

/// The problems that practice, own numbers, solutions, playing and calls refuse to a visitor: those of open assignments, unless the
/// visitor teaches their courses.
#[derive(Debug, Default)]
pub(in crate::web) struct Withheld(Reserved);

impl Withheld {
    /// What is withheld from a visitor, or from somebody who is not known.
    pub(in crate::web) async fn from(app: &App, visitor: Option<&Visitor>) -> Result<Self, StoreFault> {
        let Some(courses) = &app.courses else { return Ok(Self::default()) };
        let (store, now) = (&courses.store, courses.clock.now());
        let open = store.open_assignments(now).await?;
        let taught: BTreeSet<Key<Course>> = match visitor {
            Some(visitor) if !open.is_empty() => {
                let places = visitor.places(store).await?.into_iter();
                places.filter(|own| own.member.role.is_staff()).map(|own| own.course.key).collect()
            }
            _ => BTreeSet::new(),
        };
        let mut reserved = Reserved::default();
        for (whole, extensions) in open.iter().filter(|(whole, _)| !taught.contains(&whole.assignment.course)) {
            reserved.add(&whole.assignment, &whole.items, extensions, now);
        }
        Ok(Self(reserved))
    }

    /// What is withheld from somebody who may see what practice refuses: problems of open assignments in which that person is a student.
    pub(super) async fn from_student(visit: &Visit) -> Result<Self, NotShown> {
        let person = visit.person()?.key;
        let places = visit.store().courses_of(person).await?.into_iter();
        let attended: BTreeSet<Key<Course>> =
            places.filter(|own| !own.member.role.is_staff()).map(|own| own.course.key).collect();
        let mut reserved = Reserved::default();
        if !attended.is_empty() {
            for (whole, extensions) in visit.store().open_assignments(visit.now).await? {
                if attended.contains(&whole.assignment.course) {
                    reserved.add(&whole.assignment, &whole.items, &extensions, visit.now);
                }
            }
        }
        Ok(Self(reserved))
    }

    /// Refuses a problem that is withheld.
    pub(in crate::web) fn check(&self, problem: &str) -> Result<(), Refused> {
        if !self.0.refuses(problem, false) {
            return Ok(());
        }
        let message = "this problem is part of an assignment that is open now";
        Err(Refused::new(RefusedKind::Reserved, message)
            .help("it can be practised again when the assignment has closed"))
    }
}

/// Problems without those that are withheld.
pub(in crate::web) struct Rest<'a> {
    /// All of them.
    pub(in crate::web) problems: &'a dyn Problems,
    /// Those that are not given.
    pub(in crate::web) withheld: &'a Withheld,
}

impl Problems for Rest<'_> {
    fn problem(&self, id: &str) -> Result<std::sync::Arc<Problem>, Refused> {
        self.withheld.check(id)?;
        self.problems.problem(id)
    }
}
