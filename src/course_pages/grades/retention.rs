//! Until when answers are kept, and their end.

use serde::Serialize;

use momentous_pages::words;
use momentous_store::Records;

use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::visit::Visit;
use crate::retention::{DELETED, Retained};

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

/// The data that the course keeps now.
async fn retained(visit: &Visit) -> Result<Retained, NotShown> {
    Ok(Retained::of(visit.store(), visit.course()?.clone(), visit.now).await?)
}

/// Shows what would be deleted, and when.
pub(crate) async fn retention(visit: &Visit) -> Result<Reply, NotShown> {
    page(visit, None).await
}

async fn page(visit: &Visit, fault: Option<&'static str>) -> Result<Reply, NotShown> {
    let Retained { course, closes, until, is_over, records } = retained(visit).await?;
    let page = RetentionPage {
        title: words::RETENTION,
        days: course.retention_days,
        closes: closes.map(|closes| closes.shown(&course.zone)),
        ends: until.map(|until| until.shown(&course.zone)),
        is_over,
        records,
        fault,
    };
    visit.page("courses/grades/retention", page).await
}

/// Deletes what students handed in, once it was kept long enough.
pub(crate) async fn forget(visit: &Visit) -> Result<Reply, NotShown> {
    let retained = retained(visit).await?;
    if !retained.is_over {
        return Ok(page(visit, Some("the answers have not been kept as long as the course says")).await?.wrong());
    }
    if visit.fields.get("sure") != Some("yes") {
        return Ok(page(visit, Some("say that you have saved the gradebooks: their marks are deleted, too"))
            .await?
            .wrong());
    }
    visit.store().forget_answers(retained.course.key, &visit.entry(DELETED, retained.detail())).await?;
    Ok(Reply::To(visit.in_course("/retention")?))
}
