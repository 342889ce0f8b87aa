//! Members of a course, and those for whom its instructors may make links to sign in.

use std::collections::{BTreeMap, BTreeSet};

use momentous_course::{Key, Member, Person};
use momentous_store::Membership;

use super::super::outcome::NotShown;
use super::super::visit::Visit;

/// Everybody in a course, by section and name, those who left included.
pub(super) struct Class {
    pub(super) members: Vec<Membership>,
    with_password: BTreeSet<Key<Person>>,
    elsewhere: BTreeMap<Key<Person>, Vec<Member>>,
}

impl Class {
    pub(super) async fn of(visit: &Visit) -> Result<Self, NotShown> {
        let course = visit.course()?.key;
        let mut members = visit.store().members(course).await?;
        let order = |membership: &Membership| {
            let (member, person) = (&membership.member, &membership.person);
            (member.left.is_some(), !member.role.is_staff(), member.section.clone(), person.shown().to_owned())
        };
        members.sort_by_cached_key(order);
        let with_password = visit.store().with_password(course).await?;
        let mut elsewhere: BTreeMap<Key<Person>, Vec<Member>> = BTreeMap::new();
        for membership in visit.store().elsewhere(course).await? {
            elsewhere.entry(membership.person.key).or_default().push(membership.member);
        }
        Ok(Self { members, with_password, elsewhere })
    }

    /// A member of the course.
    pub(super) fn member(&self, key: Key<Member>) -> Option<&Membership> {
        self.members.iter().find(|membership| membership.member.key == key)
    }

    /// Members with the people behind them, as the rules of rosters take them.
    pub(super) fn pairs(&self) -> Vec<(Member, Person)> {
        self.members.iter().map(|membership| (membership.member.clone(), membership.person.clone())).collect()
    }

    pub(super) fn has_password(&self, membership: &Membership) -> bool {
        self.with_password.contains(&membership.person.key)
    }

    /// Whether instructors of this course may make a link for a member. Such a link opens this course and no other; still nobody makes
    /// one for somebody who can do more.
    pub(super) fn may_link(&self, membership: &Membership) -> Result<(), &'static str> {
        let elsewhere = self.elsewhere.get(&membership.person.key).map_or(&[][..], Vec::as_slice);
        let has_password = self.has_password(membership);
        if membership.person.erased.is_some() || membership.member.left.is_some() {
            Err("this person is no longer in the course")
        } else if membership.person.operator {
            Err("this person runs the server")
        } else if elsewhere.iter().any(|member| member.role.is_staff()) {
            Err("this person teaches another course")
        } else if has_password && membership.member.role.is_staff() {
            Err("this person teaches this course, too")
        } else {
            Ok(())
        }
    }

    /// Whether whoever signs in by this name takes part in another course, too, or runs the server.
    pub(super) fn is_known_elsewhere(&self, login: &str) -> bool {
        let mut people = self.members.iter().map(|membership| &membership.person);
        people.any(|person| person.login == login && (person.operator || self.elsewhere.contains_key(&person.key)))
    }

    /// Whether somebody else than this member teaches the course.
    pub(super) fn is_taught_without(&self, key: Key<Member>) -> bool {
        use momentous_course::Role::Instructor;
        let teaches =
            |membership: &&Membership| membership.member.role == Instructor && membership.member.left.is_none();
        self.members.iter().filter(teaches).any(|membership| membership.member.key != key)
    }
}
