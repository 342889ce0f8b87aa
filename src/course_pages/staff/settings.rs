//! The settings of a course.

use serde::Serialize;

use momentous_course::{Course, zones};
use momentous_pages::words;

use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::visit::Visit;
use super::course_form;
use super::course_form::{Choice, CourseForm};
use super::form::Form;

#[derive(Serialize)]
struct SettingsPage {
    title: &'static str,
    form: Form,
    decimals: Vec<Choice>,
    zones: Vec<String>,
    saved: bool,
}

/// The settings as they are.
pub(crate) async fn page(visit: &Visit) -> Result<Reply, NotShown> {
    with(visit, CourseForm::of(visit.course()?)).await
}

async fn with(visit: &Visit, form: Form) -> Result<Reply, NotShown> {
    let is_wrong = form.is_wrong();
    let saved = !is_wrong && visit.fields.get("saved").is_some();
    let page = SettingsPage { title: words::SETTINGS, form, decimals: course_form::decimals(), zones: zones(), saved };
    let page = visit.page("courses/staff/settings", page).await?;
    Ok(if is_wrong { page.wrong() } else { page })
}

/// Keeps them.
pub(crate) async fn save(visit: &Visit) -> Result<Reply, NotShown> {
    let form = Form::sent(visit, &course_form::FIELDS);
    match CourseForm::read(&form) {
        Err(faults) => with(visit, form.with(&faults)).await,
        Ok(CourseForm { title, zone, decimal, retention_days }) => {
            let course = Course { title, zone, decimal, retention_days, ..visit.course()?.clone() };
            visit.store().save_course(&course, &visit.entry("settings changed", "")).await?;
            Ok(Reply::To(visit.in_course("/settings?saved=yes")?))
        }
    }
}
