//! A corrected problem is taken into an assignment: first what would change, then the change as one step.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::course::{Attempt, Correction, CorrectionChoice, Effect, Item, Remarked, Score};
use crate::grade::Points;
use crate::store::{AssignmentWithItems, Regrade, StoreFault};

use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::session;
use super::super::visit::Visit;
use super::class::assignment;
use super::correction::{Corrected, corrected};

/// The choices, with their names in forms and what they say.
const CHOICES: [(CorrectionChoice, &str, &str); 4] = [
    (CorrectionChoice::Remark, "remark", "Mark what was handed in by the corrected problem"),
    (CorrectionChoice::FullMarks, "full_marks", "Give everybody full marks"),
    (CorrectionChoice::Drop, "drop", "Drop the item: it no longer counts"),
    (CorrectionChoice::IssueAnew, "issue_anew", "Issue new sheets: what was handed in no longer counts"),
];

#[derive(Serialize)]
struct RegradePage {
    title: String,
    assignment: String,
    revision: i64,
    items: Vec<ItemShown>,
}

#[derive(Serialize)]
struct ItemShown {
    key: String,
    problem: String,
    digest: String,
    fault: Option<String>,
    /// Sheets, and those of them that the file draws otherwise now.
    sheets: usize,
    differ: usize,
    redacted: usize,
    choices: Vec<ChoiceShown>,
    changes: Vec<Change>,
}

#[derive(Serialize)]
struct ChoiceShown {
    name: &'static str,
    says: &'static str,
    /// For how many students it changes something.
    changes: usize,
}

/// A student whose points change.
#[derive(Serialize)]
struct Change {
    name: String,
    before: String,
    /// The points after each choice, in their order.
    after: Vec<String>,
}

/// What would change for whom.
pub(in crate::web::courses) async fn regrade(visit: &Visit) -> Result<Reply, NotShown> {
    let whole = assignment(visit).await?;
    let decided = visit.store().corrections(whole.assignment.key).await?;
    let members = visit.store().members(visit.course()?.key).await?;
    let names: BTreeMap<_, _> = members.iter().map(|own| (own.member.key, own.person.shown().to_owned())).collect();
    let items = corrected(visit, &whole, &decided).await?;
    let name = |effect: &Effect| names.get(&effect.member).cloned().unwrap_or_default();
    let page = RegradePage {
        title: format!("Regrade: {}", whole.assignment.title),
        assignment: whole.assignment.key.to_string(),
        revision: whole.revision,
        items: items.iter().map(|own| shown(own, name)).collect(),
    };
    visit.page("courses/grades/regrade", page).await
}

fn shown(own: &Corrected, name: impl Fn(&Effect) -> String) -> ItemShown {
    let choices = own.choices();
    let count = |is: &dyn Fn(&Effect) -> bool| own.effects.iter().filter(|effect| is(effect)).count();
    let points = |score: Option<Score>| {
        score.map_or_else(|| "\u{2013}".to_owned(), |score| Points(score.scaled(own.item.points).points).to_string())
    };
    let change = |effect: &Effect| Change {
        name: name(effect),
        before: points(effect.before.clone()),
        after: choices.iter().map(|choice| points(effect.score(*choice))).collect(),
    };
    let is_changed = |effect: &&Effect| choices.iter().any(|choice| effect.changes(*choice));
    let mut changes: Vec<Change> = own.effects.iter().filter(is_changed).map(change).collect();
    changes.sort_by_cached_key(|own| own.name.to_lowercase());
    let offered = CHOICES.into_iter().filter(|(choice, ..)| choices.contains(choice));
    ItemShown {
        key: own.item.key.to_string(),
        problem: own.item.problem.clone(),
        digest: own.file.digest.clone(),
        fault: own.fault.clone(),
        sheets: own.effects.len(),
        differ: count(&|effect| effect.after == Remarked::Differs),
        redacted: count(&|effect| effect.after == Remarked::Redacted),
        choices: offered
            .map(|(choice, name, says)| ChoiceShown { name, says, changes: count(&|effect| effect.changes(choice)) })
            .collect(),
        changes,
    }
}

/// The change. Where something was decided, corrected or handed in since the page was made, nothing is done.
pub(in crate::web::courses) async fn regrade_apply(visit: &Visit) -> Result<Reply, NotShown> {
    let whole = assignment(visit).await?;
    let field = |name: &str| visit.fields.text(name);
    if field("revision") != whole.revision.to_string() {
        return Err(changed());
    }
    let asked = field("item").parse().map_err(|_| changed())?;
    // Counted before anything is marked: what is handed in from now on makes this step void.
    let handed_in = visit.store().attempts_at(asked).await?;
    let decided = visit.store().corrections(whole.assignment.key).await?;
    let items = corrected(visit, &whole, &decided).await?;
    let is_asked = |own: &&Corrected| own.item.key == asked && own.file.digest == field("digest");
    let own = items.iter().find(is_asked).ok_or_else(changed)?;
    let choice =
        CHOICES.into_iter().find(|(choice, name, _)| *name == field("choice") && own.choices().contains(choice));
    let (choice, name, _) = choice.ok_or_else(|| NotShown::field("choose one of the choices of the page"))?;
    let correction = Correction {
        item: own.item.key,
        from: own.item.digest.clone().unwrap_or_default(),
        to: own.file.digest.clone(),
        choice,
        // The last one counts, whatever became of the clock.
        at: decided.iter().map(|own| own.at.after(1)).fold(visit.now, Ord::max),
    };
    if own.file.course.is_none() {
        // The sheets that are drawn from it from now on need its text.
        visit.store().save_problem_file(&own.file, None).await?;
    }
    let (item, attempts) = (after(&own.item, &own.file.digest, choice), remarked(own, choice)?);
    let step =
        Regrade { item: &item, correction: &correction, attempts: &attempts, revision: whole.revision, handed_in };
    let detail = format!("{} from {} to {}: {name}", own.item.problem, correction.from, correction.to);
    if visit.store().regrade(session::key(), &step, &visit.entry("corrected problem taken in", detail)).await? {
        Ok(Reply::To(of(visit, &whole)?))
    } else {
        Err(changed())
    }
}

fn of(visit: &Visit, whole: &AssignmentWithItems) -> Result<String, NotShown> {
    visit.in_course(&format!("/assignments/{}/gradebook", whole.assignment.key))
}

fn changed() -> NotShown {
    NotShown::Conflict(
        "somebody changed the assignment, or handed something in, since this page was made; nothing was done"
            .to_owned(),
    )
}

/// The item after a choice. Where old sheets stand, so does the file from which they were drawn.
fn after(item: &Item, digest: &str, choice: CorrectionChoice) -> Item {
    let (mut item, digest) = (item.clone(), Some(digest.to_owned()));
    match choice {
        CorrectionChoice::Remark => item.digest = digest,
        CorrectionChoice::FullMarks => {}
        CorrectionChoice::Drop => item.dropped = true,
        CorrectionChoice::IssueAnew => {
            item.issue += 1;
            item.digest = digest;
        }
    }
    item
}

/// The attempts with what marking makes of them now; those of which nothing changes are left out.
fn remarked(own: &Corrected, choice: CorrectionChoice) -> Result<Vec<Attempt>, NotShown> {
    let mut changed = Vec::new();
    if choice != CorrectionChoice::Remark {
        return Ok(changed);
    }
    for (kept, effect) in own.sheets.iter().zip(&own.effects) {
        let Remarked::Same(reports) = &effect.after else { continue };
        for (attempt, report) in kept.attempts.iter().zip(reports) {
            let report = serde_json::value::to_raw_value(report).map_err(StoreFault::Record)?;
            if report.get() != attempt.report.get() {
                changed.push(Attempt { report, ..attempt.clone() });
            }
        }
    }
    Ok(changed)
}
