//! Courses, request by request, without a network: SQLite in a folder of the test's own, and a clock that the test sets.

mod access;
mod corrected;
mod early;
mod editor;
mod five_places;
mod grades;
mod handed;
mod hidden;
mod homework;
mod joining;
mod letter_box;
mod links;
mod mail;
mod old_data;
mod print;
mod problems;
mod refused;
mod sign_in;
mod staff;
mod student;
mod typed;
mod university;
