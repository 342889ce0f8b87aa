//! Several values of one quantity: dealt out to the roots that they are right for, and joined into the report on one part.

use momentous_grade as grade;
use momentous_grade::Expected;
use momentous_grade::PartReport;
use momentous_grade::Points;
use momentous_grade::Verdict;
use momentous_problem::Part;
use momentous_problem::PartKind;
use momentous_problem::Worked;
use momentous_quantity::Rational;
use momentous_solve::Bounded;

use super::ROOTS_JOINED;
use super::marker::widen;

/// The roots of a part, where it has several.
pub(super) fn several(worked: Worked<'_>, part: &Part) -> Option<Vec<Bounded>> {
    let PartKind::Number(number) = &part.kind else { return None };
    (number.every_root || worked.variant.has_others()).then(|| worked.answers(number)).filter(|roots| roots.len() > 1)
}

/// The expected answer for each of several roots.
pub(super) fn each_expected(single: &Expected, roots: &[Bounded], worked: Worked<'_>, part: &Part) -> Vec<Expected> {
    let root = |(index, answer): (usize, &Bounded)| {
        let mut root = single.clone();
        if index > 0 {
            root.id = format!("{} ({})", part.id, index + 1);
        }
        if let grade::ExpectedKind::Number(number) = &mut root.kind {
            (number.value, number.error) = (answer.value, answer.error);
        }
        widen(&mut root, worked, part);
        root
    };
    roots.iter().enumerate().map(root).collect()
}

/// What is expected of each of several roots, with the text that answers it. Each root gets the first value that is right for it,
/// whatever the order in which they were typed; what is left goes to the roots that are left, and to further ones of no worth.
pub(super) fn shared_out(
    single: &Expected,
    roots: &[Bounded],
    text: &str,
    worked: Worked<'_>,
    part: &Part,
    mark: grade::DecimalMark,
) -> Vec<(Expected, String)> {
    let roots = each_expected(single, roots, worked, part);
    let mut values = grade::read_several(text);
    let mut dealt: Vec<Option<String>> = vec![None; roots.len()];
    // What is right comes first, then what is worth anything.
    for wanted in [|verdict: Verdict| verdict.is_right(), |verdict: Verdict| verdict.usual_fraction().0 > 0] {
        for (root, given) in roots.iter().zip(&mut dealt).filter(|(_, given)| given.is_none()) {
            let place = values.iter().position(|value| {
                let read = grade::read(value, &root.kind, mark);
                read.is_ok_and(|answer| wanted(grade::judge(root, &answer).verdict))
            });
            *given = place.map(|position| values.remove(position));
        }
    }
    let mut left = values.into_iter();
    let surplus = roots.last().cloned();
    let mut pairs: Vec<(Expected, String)> = Vec::new();
    for (root, given) in roots.into_iter().zip(dealt) {
        pairs.push((root, given.or_else(|| left.next()).unwrap_or_default()));
    }
    if let Some(last) = surplus {
        pairs.extend(left.map(|value| (last.clone(), value)));
    }
    pairs
}

/// The reports on parts, those on the roots of one part joined into one. `places` says of each to which part it belongs.
pub(super) fn joined(reports: Vec<PartReport>, places: &[usize], worked: Worked<'_>) -> Vec<PartReport> {
    let mut groups: Vec<(usize, Vec<PartReport>)> = Vec::new();
    for (report, place) in reports.into_iter().zip(places) {
        match groups.last_mut() {
            Some((first_place, group)) if first_place == place => group.push(report),
            _ => groups.push((*place, vec![report])),
        }
    }
    let join = |(place, mut group): (usize, Vec<PartReport>)| {
        let part = worked.form.parts.get(place)?;
        let roots = several(worked, part).map_or(1, |roots| roots.len());
        if group.len() == 1 {
            return group.pop();
        }
        one(&group, roots, part)
    };
    groups.into_iter().filter_map(join).collect()
}

/// The report on all roots of a part: each right value counts, and each wrong one takes away a right one.
fn one(group: &[PartReport], roots: usize, part: &Part) -> Option<PartReport> {
    let is = |verdict: Verdict| move |report: &&PartReport| report.verdict == verdict;
    let read: Vec<&str> = group.iter().filter_map(|report| report.understood.as_deref()).collect();
    let understood = (!read.is_empty()).then(|| read.join(ROOTS_JOINED));
    if group.iter().any(|report| report.verdict == Verdict::Unreadable)
        || group.iter().all(|report| is(Verdict::Unanswered)(&report))
    {
        let told = group.iter().find(is(Verdict::Unreadable)).or(group.first())?.clone();
        return Some(PartReport { id: part.id.clone(), ..told });
    }
    let worth: Rational = group.iter().take(roots).fold(Rational::ZERO, |sum, report| sum + &report.points.0);
    let is_wrong = |report: &&PartReport| report.verdict != Verdict::Unanswered && report.points.0 == Rational::ZERO;
    let surplus = group.len().saturating_sub(roots);
    let wrong = group.iter().take(roots).filter(is_wrong).count() + surplus;
    let whole = |count: usize| Rational::from(u64::try_from(count).unwrap_or(u64::MAX));
    let points = (worth - whole(wrong) * Rational::from(part.points)) / whole(roots);
    let points = Points(points.max(Rational::ZERO));
    let first = group.first()?;
    let alike = surplus == 0 && group.iter().all(|report| report.verdict == first.verdict);
    let all_right = surplus == 0 && group.iter().all(|report| report.verdict.is_right());
    // Signs are right or wrong, whether they are written or not.
    let signs =
        surplus == 0 && group.iter().all(|report| matches!(report.verdict, Verdict::Sense | Verdict::SenseReversed));
    let none_right = group.iter().all(|report| is_wrong(&report) || report.verdict == Verdict::Unanswered);
    let shown = if alike || none_right || signs {
        group.iter().find(|report| report.diagnosis.is_some()).or(group.iter().find(is_wrong)).unwrap_or(first)
    } else if all_right {
        group.iter().find(|report| report.verdict != Verdict::Right).unwrap_or(first)
    } else {
        let (verdict, message) = grade::some_values();
        return Some(PartReport { id: part.id.clone(), verdict, points, understood, message, ..first.clone() });
    };
    Some(PartReport { id: part.id.clone(), points, understood, ..shown.clone() })
}
