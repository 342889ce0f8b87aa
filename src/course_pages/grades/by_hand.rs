//! Decisions of an instructor about one student's answers: points set by hand, and answers taken out of the records.

use momentous_course::{Override, OverrideRule, Redaction, points_by_hand, redacted};

use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::session;
use super::super::visit::Visit;
use super::answers::{Place, Typed, page};

/// Sets points by hand, or lets those of marking count again. What was set before stays in the records.
pub(crate) async fn set_points(visit: &Visit) -> Result<Reply, NotShown> {
    let place = Place::of(visit).await?;
    let [points, reason, comment] =
        ["points", "reason", "comment"].map(|name| visit.fields.text(name).trim().to_owned());
    let wrong = async |fault: String| {
        let (points, reason, comment) = (points.clone(), reason.clone(), comment.clone());
        let typed = Typed { points, reason, comment, fault: Some(fault) };
        Ok(page(visit, &place, typed).await?.wrong())
    };
    if reason.is_empty() {
        return wrong("say why: it is kept with the marks, and the student reads it".to_owned()).await;
    }
    let read = match points_by_hand(&points, place.item.points) {
        Ok(read) => read,
        Err(fault) => return wrong(fault).await,
    };
    let sheet = &place.issued(visit).await?;
    let by = visit.person()?.key;
    let what = if read.is_some() { "points set by hand" } else { "points of marking count again" };
    let whose = format!("member {}, {}", place.student.member.key, place.item.problem);
    let detail = format!("{whose}: {}", read.as_deref().unwrap_or("as marked"));
    // The last one counts, whatever became of the clock.
    let before = visit.store().set_by_hand(place.whole.assignment.key).await?;
    let last = before.iter().filter(|decision| decision.sheet == sheet.key).map(|decision| decision.at.after(1)).max();
    let at = last.map_or(visit.now, |last| last.max(visit.now));
    let rule = OverrideRule::Exactly;
    let (reason, comment) = (reason.clone(), comment.clone());
    let points = Override { sheet: sheet.key, points: read, rule, reason, comment, by, at };
    visit.store().set_points(session::key(), &points, &visit.entry(what, detail)).await?;
    Ok(Reply::To(place.address(visit)?))
}

/// Takes one answer out of the records. Its points stay.
pub(crate) async fn redact(visit: &Visit) -> Result<Reply, NotShown> {
    let place = Place::of(visit).await?;
    let field = |name: &str| visit.fields.text(name).trim().to_owned();
    let missing = || NotShown::missing("there is no such answer");
    let sheet = place.sheet.as_ref().ok_or_else(missing)?;
    let number: u32 = field("attempt").parse().map_err(|_| missing())?;
    let attempts = visit.store().attempts(sheet.key).await?;
    if !attempts.iter().any(|attempt| attempt.number == number) {
        return Err(missing());
    }
    let order = Redaction {
        sheet: sheet.key,
        number,
        part: field("part"),
        reason: field("reason"),
        by: visit.person()?.key,
        at: visit.now,
    };
    match redacted(&attempts, &order) {
        Ok(changed) => {
            let whose = format!("member {}, {}", place.student.member.key, place.item.problem);
            let detail = format!("{whose}, attempt {number}, part {}: {}", order.part, order.reason);
            visit.store().redact(&changed, &visit.entry("answer redacted", detail)).await?;
            Ok(Reply::To(place.address(visit)?))
        }
        Err(fault) => {
            let typed = Typed { fault: Some(fault.to_string()), ..Typed::default() };
            Ok(page(visit, &place, typed).await?.wrong())
        }
    }
}
