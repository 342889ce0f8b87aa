//! Until when answers are kept, and their end.

use serde::Serialize;

use crate::course::Moment;
use crate::store::Records;

use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::visit::Visit;

/// The milliseconds of a day.
const DAY: i64 = 86_400_000;

#[derive(Serialize)]
struct RetentionPage {
    title: &'static str,
    days: Option<u32>,
    closes: Option<String>,
    /// From when on the answers may be deleted.
    ends: Option<String>,
    is_over: bool,
    records: Records,
    fault: Option<&'static str>,
}

/// When the last assignment closes for anybody, and when answers have been kept long enough.
async fn ends(visit: &Visit) -> Result<(Option<Moment>, Option<Moment>), NotShown> {
    let course = visit.course()?;
    let closes = visit.store().last_close(course.key).await?;
    let kept = course.retention_days.map(|days| i64::from(days).saturating_mul(DAY));
    Ok((closes, closes.zip(kept).map(|(closes, kept)| closes.after(kept))))
}

/// What would be deleted, and when.
pub(in crate::web::courses) async fn retention(visit: &Visit) -> Result<Reply, NotShown> {
    page(visit, None).await
}

async fn page(visit: &Visit, fault: Option<&'static str>) -> Result<Reply, NotShown> {
    let course = visit.course()?;
    let (closes, ends) = ends(visit).await?;
    let page = RetentionPage {
        title: "Retention",
        days: course.retention_days,
        closes: closes.map(|closes| closes.shown(&course.zone)),
        ends: ends.map(|ends| ends.shown(&course.zone)),
        is_over: ends.is_some_and(|ends| visit.now > ends),
        records: visit.store().records_of(course.key).await?,
        fault,
    };
    visit.page("courses/grades/retention", page).await
}

/// Deletes what students handed in, once it was kept long enough.
pub(in crate::web::courses) async fn forget(visit: &Visit) -> Result<Reply, NotShown> {
    let (_, ends) = ends(visit).await?;
    if ends.is_none_or(|ends| visit.now <= ends) {
        return Ok(page(visit, Some("the answers have not been kept as long as the course says")).await?.wrong());
    }
    if visit.fields.get("sure") != Some("yes") {
        return Ok(page(visit, Some("say that you have saved the gradebooks: their marks are deleted, too"))
            .await?
            .wrong());
    }
    let records = visit.store().records_of(visit.course()?.key).await?;
    let detail = format!("{} sheets with {} attempts", records.sheets, records.attempts);
    visit.store().forget_answers(visit.course()?.key, &visit.entry("answers deleted", detail)).await?;
    Ok(Reply::To(visit.in_course("/retention")?))
}
