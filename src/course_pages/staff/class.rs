//! Who takes part in a course, and for whom its instructors may make links to sign in.

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
        let order = |own: &Membership| {
            let (member, person) = (&own.member, &own.person);
            (member.left.is_some(), !member.role.is_staff(), member.section.clone(), person.shown().to_owned())
        };
        members.sort_by_cached_key(order);
        let with_password = visit.store().with_password(course).await?;
        let mut elsewhere: BTreeMap<Key<Person>, Vec<Member>> = BTreeMap::new();
        for own in visit.store().elsewhere(course).await? {
            elsewhere.entry(own.person.key).or_default().push(own.member);
        }
        Ok(Self { members, with_password, elsewhere })
    }

    /// A member of the course.
    pub(super) fn member(&self, key: Key<Member>) -> Option<&Membership> {
        self.members.iter().find(|own| own.member.key == key)
    }

    /// Members with the people behind them, as the rules of rosters take them.
    pub(super) fn pairs(&self) -> Vec<(Member, Person)> {
        self.members.iter().map(|own| (own.member.clone(), own.person.clone())).collect()
    }

    pub(super) fn has_password(&self, own: &Membership) -> bool {
        self.with_password.contains(&own.person.key)
    }

    /// Whether instructors of this course may make a link for a member. Such a link opens this course and no other; still nobody makes
    /// one for somebody who can do more.
    pub(super) fn may_link(&self, own: &Membership) -> Result<(), &'static str> {
        let elsewhere = self.elsewhere.get(&own.person.key).map_or(&[][..], Vec::as_slice);
        let has_password = self.has_password(own);
        if own.person.erased.is_some() || own.member.left.is_some() {
            Err("this person is no longer in the course")
        } else if own.person.operator {
            Err("this person runs the server")
        } else if elsewhere.iter().any(|member| member.role.is_staff()) {
            Err("this person teaches another course")
        } else if has_password && own.member.role.is_staff() {
            Err("this person teaches this course, too")
        } else {
            Ok(())
        }
    }

    /// Whether whoever signs in by this name takes part in another course, too, or runs the server.
    pub(super) fn is_known_elsewhere(&self, login: &str) -> bool {
        let mut people = self.members.iter().map(|own| &own.person);
        people.any(|own| own.login == login && (own.operator || self.elsewhere.contains_key(&own.key)))
    }

    /// Whether somebody else than this member teaches the course.
    pub(super) fn is_taught_without(&self, key: Key<Member>) -> bool {
        use momentous_course::Role::Instructor;
        let teaches = |own: &&Membership| own.member.role == Instructor && own.member.left.is_none();
        self.members.iter().filter(teaches).any(|own| own.member.key != key)
    }
}
