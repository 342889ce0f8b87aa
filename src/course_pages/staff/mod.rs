//! Pages for operators and those who teach.

pub(super) mod assignment;
mod class;
mod course_form;
mod form;
mod links;
pub(super) mod members;
pub(super) mod new_course;
pub(super) mod people;
pub(super) mod person_form;
pub(super) mod print;
pub(super) mod problems;
pub(super) mod requests;
pub(super) mod roster;
pub(super) mod settings;

pub(super) use form::Form;
