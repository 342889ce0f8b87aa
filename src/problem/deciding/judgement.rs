//! Which phrase is right where it hangs on whether terms are equal.

use super::super::questions::choices::decision::Decision;
use super::super::questions::choices::decision::OptionFeedback;
use super::super::questions::choices::judgement::Behind;
use super::super::questions::choices::judgement::Case;
use super::super::questions::choices::judgement::Judgement;
use super::super::questions::choices::judgement::Test;
use super::super::questions::equality::Equality;
use super::super::sampling::variant::Worked;
use super::closeness::Closeness;

impl Case {
    fn is_open(&self, worked: &Worked<'_>) -> bool {
        self.ways.iter().all(|(choice, what)| worked.leaf().words.get(*choice) == Some(what))
    }
}

impl Test {
    fn holds(&self, worked: &Worked<'_>) -> bool {
        self.equality.closeness(worked).is_equal()
    }
}

impl Judgement {
    /// Two values that are neither equal within the data nor clearly different, in words.
    pub(super) fn unclear(&self, worked: &Worked<'_>) -> Option<String> {
        let between = |equality: &&Equality| equality.closeness(worked) == Closeness::Between;
        let open = self.equalities().find(between)?;
        Some(open.in_words(worked).unwrap_or_else(|| "its two sides".to_owned()))
    }

    /// Whether values are taken as equal that are so only within the precision of the data.
    pub(super) fn is_within_data(&self, worked: &Worked<'_>) -> bool {
        self.equalities().any(|equality| equality.closeness(worked) == Closeness::WithinData)
    }

    pub(crate) fn decided(&self, worked: &Worked<'_>) -> Decision {
        let mut passed: Vec<&Test> = Vec::new();
        for case in self.cases.iter().filter(|case| case.is_open(worked)) {
            let failing: Vec<&Test> = case.tests.iter().filter(|test| !test.holds(worked)).collect();
            if !failing.is_empty() {
                passed.extend(failing);
                continue;
            }
            let because = if case.because.is_empty() { self.refused(worked, &passed) } else { accepted(worked, case) };
            let applies = |behind: &&Behind| {
                behind.right == case.right
                    && (behind.unless.is_empty() || !behind.unless.iter().all(|test| test.holds(worked)))
            };
            let behind = self.behind.as_ref().filter(applies).map(|behind| behind.mistake);
            return Decision {
                options: self.options.clone(),
                right: case.right,
                because,
                behind,
                feedback: self.confused_with(case.right),
            };
        }
        Decision { options: self.options.clone(), right: 0, because: String::new(), behind: None, feedback: Vec::new() }
    }

    /// What leads to each phrase where another one is right; nothing where no mistake is known.
    fn confused_with(&self, right: usize) -> Vec<OptionFeedback> {
        let mistaken = |chosen: usize| {
            let known = self.confusions.iter().find(|known| known.chosen == chosen && known.right == right);
            known.map_or(OptionFeedback::Nothing, |known| OptionFeedback::Confused(known.mistake))
        };
        if self.confusions.is_empty() { Vec::new() } else { (0..self.options.len()).map(mistaken).collect() }
    }

    /// Why a case does not hold: what its tests say, after what is the same nevertheless.
    fn refused(&self, worked: &Worked<'_>, failing: &[&Test]) -> String {
        let mut words: Vec<String> = Vec::new();
        for test in failing {
            let said = match test.equality.in_words(worked) {
                Some(values) => format!("{}: {values}", test.otherwise),
                None => test.otherwise.clone(),
            };
            if !words.contains(&said) {
                words.push(said);
            }
        }
        let words = words.join(", and ");
        let returns =
            !self.returns.is_empty() && self.returns.iter().all(|equality| equality.closeness(worked).is_equal());
        if returns { format!("its final value equals its initial value, but {words}") } else { words }
    }
}

/// Why a case holds, with the values that are equal within the precision of the data.
fn accepted(worked: &Worked<'_>, case: &Case) -> String {
    let nearly = case.tests.iter().find(|test| test.equality.closeness(worked) == Closeness::WithinData);
    match nearly.map(|test| test.equality.in_words(worked)) {
        None => case.because.clone(),
        Some(None) => format!("{}, within the precision of the data", case.because),
        Some(Some(values)) => format!("{}: {values} are equal within the precision of the data", case.because),
    }
}
