//! What an author may write: the keys of a problem file, its values, its questions and its texts.

pub(super) mod allowed;
pub(super) mod ask;
pub(super) mod comparison;
pub(super) mod condition;
pub(super) mod course;
pub(super) mod declared;
pub(super) mod domain;
pub(super) mod draft;
pub(super) mod entries;
pub(super) mod expression;
pub(super) mod form;
pub(super) mod given;
pub(super) mod homework;
pub(super) mod intended;
pub(super) mod known;
pub(super) mod literal;
pub(super) mod other_values;
pub(super) mod rubric;
pub(super) mod settings;
pub(super) mod spoken;
pub(super) mod text;
