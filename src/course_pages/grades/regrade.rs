//! A corrected problem is taken into an assignment: first what would change, then the change as one step.

use std::collections::BTreeMap;

use serde::Serialize;

use momentous_course::{
    Accounts, Attempt, Correction, CorrectionChoice, Effect, GradeMark, Item, Key, Override, OverrideRule, Person,
    Regrading, Remarked,
};
use momentous_grade::Points;
use momentous_store::{AssignmentWithItems, Regrade, StoreFault};

use super::super::ledger::Records;
use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::session;
use super::super::visit::Visit;
use super::class::{assignment, titles};
use super::correction::{Corrected, corrected};

/// A way to take a correction in.
struct Way {
    regrading: Regrading,
    /// Its name in forms.
    name: &'static str,
    says: &'static str,
}

const fn way(choice: CorrectionChoice, never_lower: bool, name: &'static str, says: &'static str) -> Way {
    Way { regrading: Regrading { choice, never_lower }, name, says }
}

/// Every way.
const WAYS: [Way; 6] = [
    way(CorrectionChoice::Remark, false, "remark", "Mark what was submitted by the corrected problem"),
    way(
        CorrectionChoice::Remark,
        true,
        "remark_never_lower",
        "Mark it by the corrected problem, and lower nobody's points",
    ),
    way(CorrectionChoice::FullMarks, false, "full_marks", "Give everybody full marks"),
    way(CorrectionChoice::Drop, false, "drop", "Drop the item: it no longer counts"),
    way(CorrectionChoice::IssueAnew, false, "issue_anew", "Issue new sheets: what was submitted no longer counts"),
    way(
        CorrectionChoice::IssueAnew,
        true,
        "issue_anew_never_lower",
        "Issue new sheets, and lower nobody's points: those so far are the least",
    ),
];

/// The text in the field of the reason at first.
const USUAL_REASON: &str = "The problem was corrected.";

#[derive(Serialize)]
struct RegradePage {
    title: String,
    assignment: String,
    revision: i64,
    reason: &'static str,
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

/// Shows what would change for whom.
pub(crate) async fn regrade(visit: &Visit) -> Result<Reply, NotShown> {
    let whole = assignment(visit).await?;
    let decided = visit.store().corrections(whole.assignment.key).await?;
    let members = visit.store().members(visit.course()?.key).await?;
    let names: BTreeMap<_, _> =
        members.iter().map(|membership| (membership.member.key, membership.person.shown().to_owned())).collect();
    let items = corrected(visit, &whole, &decided).await?;
    let records = Records::of_class(visit, &whole).await?;
    let accounts = records.accounts();
    let name = |effect: &Effect| names.get(&effect.member).cloned().unwrap_or_default();
    let titles = titles(visit, &whole).await?;
    let page = RegradePage {
        title: format!("Regrade: {}", whole.assignment.title),
        assignment: whole.assignment.key.to_string(),
        revision: whole.revision,
        reason: USUAL_REASON,
        items: items.iter().map(|corrected| shown(corrected, &titles, &accounts, name)).collect(),
    };
    visit.page("courses/grades/regrade", page).await
}

fn shown(
    corrected: &Corrected,
    titles: &BTreeMap<Key<Item>, String>,
    accounts: &Accounts<'_>,
    name: impl Fn(&Effect) -> String,
) -> ItemShown {
    let ways: Vec<&Way> = WAYS.iter().filter(|way| corrected.offers(way.regrading.choice)).collect();
    let count = |is: &dyn Fn(&Effect) -> bool| corrected.effects.iter().filter(|effect| is(effect)).count();
    let before = |effect: &Effect| accounts.standing(effect.member, &corrected.item).mark;
    let after = |effect: &Effect, way: &Way| accounts.regraded(effect, &corrected.item, way.regrading).mark;
    let changes = |effect: &Effect, way: &Way| after(effect, way).points() != before(effect).points();
    let points = |mark: &GradeMark| {
        mark.points().map_or_else(|| "\u{2013}".to_owned(), |points| Points(points.clone()).to_string())
    };
    let change = |effect: &Effect| Change {
        name: name(effect),
        before: points(&before(effect)),
        after: ways.iter().map(|way| points(&after(effect, way))).collect(),
    };
    let is_changed = |effect: &&Effect| ways.iter().any(|way| changes(effect, way));
    let mut changed: Vec<Change> = corrected.effects.iter().filter(is_changed).map(change).collect();
    changed.sort_by_cached_key(|change| change.name.to_lowercase());
    let choice =
        |way: &&Way| ChoiceShown { name: way.name, says: way.says, changes: count(&|effect| changes(effect, way)) };
    ItemShown {
        key: corrected.item.key.to_string(),
        problem: titles.get(&corrected.item.key).unwrap_or(&corrected.item.problem).clone(),
        digest: corrected.file.digest.clone(),
        fault: corrected.fault.clone(),
        sheets: corrected.effects.len(),
        differ: count(&|effect| effect.after == Remarked::Differs),
        redacted: count(&|effect| effect.after == Remarked::Redacted),
        choices: ways.iter().map(choice).collect(),
        changes: changed,
    }
}

/// The change. Where something was decided, corrected or handed in since the page was made, nothing is done.
pub(crate) async fn regrade_apply(visit: &Visit) -> Result<Reply, NotShown> {
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
    let is_asked = |corrected: &&Corrected| corrected.item.key == asked && corrected.file.digest == field("digest");
    let corrected = items.iter().find(is_asked).ok_or_else(changed)?;
    let way = WAYS.iter().find(|way| way.name == field("choice") && corrected.offers(way.regrading.choice));
    let Way { regrading, says, .. } = way.ok_or_else(|| NotShown::field("choose one of the choices of the page"))?;
    let said = |name: &str| field(name).trim().to_owned();
    let correction = Correction {
        item: corrected.item.key,
        from: corrected.item.digest.clone().unwrap_or_default(),
        to: corrected.file.digest.clone(),
        choice: regrading.choice,
        never_lower: regrading.never_lower,
        reason: said("reason"),
        comment: said("comment"),
        // The last one counts, whatever became of the clock.
        at: decided.iter().map(|correction| correction.at.after(1)).fold(visit.now, Ord::max),
    };
    if corrected.file.course.is_none() {
        // The sheets that are drawn from it from now on need its text.
        visit.store().save_problem_file(&corrected.file, None).await?;
    }
    let records = Records::of_class(visit, &whole).await?;
    let kept = kept(corrected, &records.accounts(), *regrading, &correction, visit.person()?.key);
    let (item, attempts) = (after(corrected, regrading.choice), remarked(corrected, regrading.choice)?);
    let step = Regrade {
        item: &item,
        correction: &correction,
        attempts: &attempts,
        kept: &kept,
        revision: whole.revision,
        handed_in,
    };
    let detail =
        format!("{} {} {}: {}. {}", corrected.item.problem, correction.from, correction.to, says, correction.reason);
    if visit.store().regrade(session::key(), &step, &visit.entry("correction applied", detail)).await? {
        Ok(Reply::To(address(visit, &whole)?))
    } else {
        Err(changed())
    }
}

fn address(visit: &Visit, whole: &AssignmentWithItems) -> Result<String, NotShown> {
    visit.in_course(&format!("/assignments/{}/gradebook", whole.assignment.key))
}

fn changed() -> NotShown {
    NotShown::Conflict(
        "somebody changed the assignment, or handed something in, since this page was made; nothing was done"
            .to_owned(),
    )
}

/// The item after a choice. Where old sheets stand that the file does not draw, so does the file from which they were drawn.
fn after(corrected: &Corrected, choice: CorrectionChoice) -> Item {
    let (mut item, digest) = (corrected.item.clone(), Some(corrected.file.digest.clone()));
    match choice {
        CorrectionChoice::Remark => item.digest = digest,
        CorrectionChoice::FullMarks if corrected.draws_alike() => item.digest = digest,
        CorrectionChoice::FullMarks => {}
        CorrectionChoice::Drop => item.dropped = true,
        CorrectionChoice::IssueAnew => {
            item.issue += 1;
            item.digest = digest;
        }
    }
    item
}

/// The points that students keep, each as a record of its own.
fn kept(
    corrected: &Corrected,
    accounts: &Accounts<'_>,
    regrading: Regrading,
    correction: &Correction,
    by: Key<Person>,
) -> Vec<(Key<Override>, Override)> {
    let keeps = |effect: &Effect| {
        let points = accounts.regraded(effect, &corrected.item, regrading).keeps?.to_string();
        let (rule, reason) = (OverrideRule::AtLeast, correction.reason.clone());
        let kept = Override {
            sheet: effect.sheet,
            points: Some(points),
            rule,
            reason,
            comment: String::new(),
            by,
            at: correction.at,
        };
        Some((session::key(), kept))
    };
    corrected.effects.iter().filter_map(keeps).collect()
}

/// The attempts with what marking makes of them now; those of which nothing changes are left out.
fn remarked(corrected: &Corrected, choice: CorrectionChoice) -> Result<Vec<Attempt>, NotShown> {
    let mut changed = Vec::new();
    // Beside full marks it is said what was right by the corrected problem.
    if !matches!(choice, CorrectionChoice::Remark | CorrectionChoice::FullMarks) || !corrected.draws_alike() {
        return Ok(changed);
    }
    for (kept, effect) in corrected.sheets.iter().zip(&corrected.effects) {
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
