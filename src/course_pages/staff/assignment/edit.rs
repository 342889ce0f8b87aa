//! Writing an assignment: the fields stay as they were typed until all of them are right.

use momentous_course::{FieldFault, Item};
use momentous_store::AssignmentWithItems;

use super::super::super::items;
use super::super::super::outcome::NotShown;
use super::super::super::reply::Reply;
use super::super::super::visit::Visit;
use super::catalogue::Catalogue;
use super::draft::Draft;
use super::editor;
use super::homework;
use super::read::read;

/// The editor for a new assignment.
pub(crate) async fn new(visit: &Visit) -> Result<Reply, NotShown> {
    editor::page(visit, Draft::empty(visit.now, &visit.course()?.zone), &Catalogue::of(visit).await?, None).await
}

/// Makes it, or shows what its buttons change in the fields.
pub(crate) async fn make(visit: &Visit) -> Result<Reply, NotShown> {
    keep(visit, None).await
}

/// The editor for an assignment that is kept.
pub(crate) async fn edit(visit: &Visit) -> Result<Reply, NotShown> {
    let whole = current(visit).await?;
    let draft = Draft::of(&whole, &visit.course()?.zone);
    editor::page(visit, draft, &Catalogue::of(visit).await?, Some(&whole)).await
}

/// Keeps what became of it.
pub(crate) async fn save(visit: &Visit) -> Result<Reply, NotShown> {
    let whole = current(visit).await?;
    keep(visit, Some(whole)).await
}

/// The assignment of the address; its problems are pinned from the moment when it opens.
async fn current(visit: &Visit) -> Result<AssignmentWithItems, NotShown> {
    items::pinned(visit, super::assignment_of(visit).await?).await
}

/// The heading over the fields where they were not kept.
const CHANGED: &str = "this assignment has changed since you opened it\nhelp: look at it in another tab; kept again, your fields take its place";

async fn keep(visit: &Visit, before: Option<AssignmentWithItems>) -> Result<Reply, NotShown> {
    let catalogue = Catalogue::of(visit).await?;
    if before.is_none() && visit.fields.get("do") == Some("homework") {
        return match homework::filled_in(visit, &catalogue).await? {
            Ok(draft) => editor::page(visit, draft, &catalogue, None).await,
            Err(refused) => editor::refused(visit, refused, &catalogue).await,
        };
    }
    let mut draft = Draft::sent(visit)?;
    with_points(visit, &mut draft).await?;
    if visit.fields.get("do") != Some("save") {
        return editor::page(visit, draft, &catalogue, before.as_ref()).await;
    }
    if draft.revision != revision(before.as_ref()) {
        return changed(visit, draft, &catalogue, before).await;
    }
    let mut whole = match read(&draft, visit.course()?, &catalogue, before.as_ref()) {
        Ok(whole) => whole,
        Err((fields, rows)) => {
            draft.say(&fields, &rows);
            return editor::page(visit, draft, &catalogue, before.as_ref()).await;
        }
    };
    let wrong = weighed_wrongly(visit, &whole.items).await?;
    if !wrong.is_empty() {
        draft.say(&[], &wrong);
        return editor::page(visit, draft, &catalogue, before.as_ref()).await;
    }
    if whole.assignment.pinned.is_some() {
        for item in whole.items.iter_mut().filter(|item| item.digest.is_none()) {
            items::pin(visit, item).await?;
        }
    }
    let what = if before.is_some() { "assignment changed" } else { "assignment created" };
    let entry = visit.entry(what, format!("{}: {}", whole.assignment.key, summary(&whole.items)));
    if !visit.store().save_assignment(&whole, &entry).await? {
        return changed(visit, draft, &catalogue, Some(current(visit).await?)).await;
    }
    visit.courses.hidden.forget();
    Ok(Reply::To(visit.in_course(&format!("/assignments/{}/edit?saved=yes", whole.assignment.key))?))
}

/// Gives problems that were just added the points of their parts.
async fn with_points(visit: &Visit, draft: &mut Draft) -> Result<(), NotShown> {
    for row in draft.rows.iter_mut().filter(|row| row.key.is_empty() && row.points.is_empty()) {
        // Whatever is no problem is told where the row is read.
        let parts = items::parts(visit, &items::unpinned(&row.problem)).await.ok().flatten();
        let points = parts.map(|parts| parts.iter().map(|part| part.points).sum::<u32>());
        row.points = points.map(|points| points.to_string()).unwrap_or_default();
    }
    Ok(())
}

/// The faults of the weights of items that students have not seen, by their places.
async fn weighed_wrongly(visit: &Visit, items: &[Item]) -> Result<Vec<(usize, String)>, NotShown> {
    let mut wrong = Vec::new();
    let is_new = |item: &Item| item.digest.is_none() && !item.weights.is_empty();
    for (place, item) in items.iter().enumerate().filter(|(_, item)| is_new(item)) {
        let parts = items::parts(visit, item).await?.unwrap_or_default();
        wrong.extend(item.weights.fault(&parts).map(|fault| (place, fault)));
    }
    Ok(wrong)
}

/// The editor with the fields as they were typed, beside an assignment that has changed meanwhile.
async fn changed(
    visit: &Visit,
    mut draft: Draft,
    catalogue: &Catalogue,
    now: Option<AssignmentWithItems>,
) -> Result<Reply, NotShown> {
    draft.say(&[FieldFault { field: "items", message: CHANGED.to_owned() }], &[]);
    draft.revision = revision(now.as_ref());
    editor::page(visit, draft, catalogue, now.as_ref()).await
}

fn revision(saved: Option<&AssignmentWithItems>) -> String {
    saved.map_or_else(String::new, |whole| whole.revision.to_string())
}

/// The content of an assignment, for the trail.
fn summary(items: &[Item]) -> String {
    let said = |Item { problem, form, points, .. }: &Item| {
        let form = form.as_ref().map(|form| format!(" ({form})")).unwrap_or_default();
        format!("{problem}{form} {points} {}", if *points == 1 { "point" } else { "points" })
    };
    items.iter().map(said).collect::<Vec<_>>().join(", ")
}
