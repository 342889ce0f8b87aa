//! Checking the rubric: every fraction can be read, and points for work are given to laws of the scene.

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_fault::did_you_mean;
use momentous_laws::CHAPTERS;
use momentous_laws::chapter_of;
use momentous_model::Builder;

use super::super::language::entries::Entries;
use super::super::language::rubric::{ANSWER, MOST_POINTS, Rubric, fraction};

/// Notes the faults of a rubric in the builder. It is the same for all forms, so its faults are told once.
pub(super) fn check(rubric: &Rubric, builder: &mut Builder<'_>) {
    let path = Path::root().key("rubric");
    for (key, term) in rubric.fractions().filter(|(_, term)| fraction(term).is_none()) {
        let fault = Fault::new(Code::Value, format!("`{}` is not a fraction of the points", term.0));
        builder.fault(fault.help("write a fraction from 0 to 1: `50 %`, `0.5` or `1/2`").at_path(path.key(key)));
    }
    if let Some(work) = &rubric.work {
        check_work(work, builder, &path.key("work"));
    }
}

fn check_work(work: &Entries<u32>, builder: &mut Builder<'_>, path: &Path) {
    let mut known: Vec<&str> = CHAPTERS.iter().map(|chapter| chapter.id).collect();
    known.retain(|id| builder.laws().any(|law| chapter_of(law).is_some_and(|chapter| chapter.id == *id)));
    known.push(ANSWER);
    let laws: Vec<&str> = builder.laws().map(|law| law.id).collect();
    let mut faults = Vec::new();
    for (name, points) in work.iter() {
        let path = path.key(name);
        if !known.contains(&name) && !laws.contains(&name) {
            let help = match did_you_mean(name, known.iter().chain(&laws).copied()) {
                Some(near) => format!("did you mean `{near}`?"),
                None => format!("name one of {}, or a law by its id", known.join(", ")),
            };
            let message = format!("no law of this scene is or belongs to `{name}`");
            faults.push(Fault::new(Code::UnknownName, message).help(help).at_path(path));
        } else if *points > MOST_POINTS {
            let message = format!("{points} points for each law are more than {MOST_POINTS}");
            faults.push(Fault::new(Code::Value, message).help("give fewer").at_path(path));
        }
    }
    if work.iter().all(|(_, points)| *points == 0) {
        let fault = Fault::new(Code::Value, "the work is worth no points");
        let help = "give points to a law or to `answer`, or remove `work`: then each law and each answer is worth one";
        faults.push(fault.help(help).at_path(path.clone()));
    }
    for fault in faults {
        builder.fault(fault);
    }
}
