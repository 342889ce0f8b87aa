//! `momentous export`

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;
use std::path::PathBuf;
use std::sync::Arc;

use clap::Args;
use clap::ValueEnum;
use clap::builder::PossibleValue;
use clap::builder::PossibleValuesParser;
use clap::builder::TypedValueParser;

use crate::bank::Slot;
use crate::exercise::Drawer;
use crate::export::Coded;
use crate::export::FEATURES;
use crate::export::Feature;
use crate::export::Place;
use crate::export::Question;
use crate::export::TARGETS;
use crate::export::Target;
use crate::problem::Problem;
use crate::render::Markup;

use super::exit::Exit;
use super::failure::Failure;
use super::failure::tell;
use super::open;
use super::open::Secret;
use super::output::Output;
use super::output::keep_apart;

const HELP: &str = "\
Examples:
  momentous export moodle impact/two-carts --count 50 -o two-carts.xml   a bank of 50 variants
  momentous export moodle impact --seed 100 -o impact.xml                a whole topic
  momentous export qti3 impact/two-carts --count 20 -o two-carts.zip     a package of QTI 3.0
  momentous export moodle homework/week-3.yaml --count 20 -o week-3.xml   the problems of a homework, in its forms
  momentous export --targets                                             what goes along to each target

The file contains answers and worked solutions. What did not go along is said on standard error.";

/// Write variants as questions for other programs: answers, usual mistakes with their feedback, worked solutions
#[derive(Args, Debug)]
#[command(after_help = HELP, arg_required_else_help = true)]
pub(super) struct Export {
    /// The program that reads the file
    #[arg(required_unless_present = "targets", value_parser = target())]
    target: Option<&'static Target>,
    /// Identities, topics, files or folders; or the file of one homework
    #[arg(required_unless_present = "targets", value_name = "PROBLEM|FILE")]
    problems: Vec<String>,
    /// The form in which problems are asked; the first of each if none is named
    #[arg(long, value_name = "FORM")]
    form: Option<String>,
    /// The seed that draws the numbers
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
    /// How many variants of each problem: the seed and those after it
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u64).range(1..))]
    count: u64,
    /// How the quiz is called where the file is one; its problems and the code of its first variant if nothing is said
    #[arg(long, value_name = "TITLE")]
    title: Option<String>,
    /// How mathematics is written, where the target leaves a choice
    #[arg(long, value_name = "HOW")]
    math: Option<Mathematics>,
    /// Write what the codes in the questions stand for to this file, by which `momentous grade` reads responses
    #[arg(long, value_name = "FILE")]
    codes: Option<PathBuf>,
    #[command(flatten)]
    secret: Secret,
    /// Write to this file instead of printing
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// List what goes along to each target, and what stands for the rest
    #[arg(long, exclusive = true)]
    targets: bool,
}

/// A problem with the form in which it is asked, and its place in a homework.
struct Asked {
    problem: Arc<Problem>,
    form: usize,
    slot: Option<Slot>,
}

/// How mathematics is written.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Mathematics {
    /// TeX, for a page that typesets it
    Tex,
    /// MathML
    Mathml,
}

impl Mathematics {
    fn markup(self) -> Markup {
        match self {
            Self::Tex => Markup::Tex,
            Self::Mathml => Markup::MathMl,
        }
    }
}

/// Reads the name of a target.
fn target() -> impl TypedValueParser<Value = &'static Target> {
    let known = TARGETS.iter().map(|target| PossibleValue::new(target.name).help(target.about));
    PossibleValuesParser::new(known).try_map(|name| Target::named(&name).ok_or("no such target"))
}

impl Export {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        let Some(target) = self.target else {
            Output::whole(None, &targets())?;
            return Ok(Exit::Fine);
        };
        let last = self.seed.checked_add(self.count - 1);
        let last =
            last.ok_or_else(|| Failure::unusable(format!("there are not {} seeds from {} on", self.count, self.seed)))?;
        let markup = self.markup(target)?;
        let read = self.problems.iter().map(Path::new).chain(self.secret.path());
        keep_apart(read, self.output.iter().chain(&self.codes).cloned())?;
        let secret = self.secret.read()?;
        let asked = self.asked(secret.as_deref())?;
        let mut held: BTreeMap<Feature, u64> = BTreeMap::new();
        let mut output = Output::to(self.output.as_deref())?;
        let mut codes = String::new();
        let mut file = target.begin(Box::new(&mut output), markup, &self.title(&asked))?;
        for Asked { problem, form, slot } in &asked {
            let refused = |seed, reason| Failure::no_variant(problem.id(), seed, &reason);
            let mut drawer = Drawer::new(problem, *form).map_err(|reason| refused(self.seed, reason))?;
            for number in self.seed..=last {
                let seed = slot.as_ref().map_or(number, |slot| slot.numbered_seed(number));
                let exercise = drawer.draw(seed).map_err(|reason| refused(seed, reason))?;
                exercise.printable()?;
                let item = exercise.item();
                let question = Question::new(&item);
                for feature in question.features() {
                    *held.entry(feature).or_default() += 1;
                }
                if !question.is_empty() {
                    file.write(&question)?;
                    if self.codes.is_some() {
                        codes.extend([&serde_json::to_string(&Coded::of(&question, target))?, "\n"]);
                    }
                }
            }
        }
        file.finish()?;
        output.finish()?;
        if let Some(path) = &self.codes {
            Output::private(path, &codes)?;
        }
        tell(&report(&held, target));
        Ok(Exit::Fine)
    }

    /// The name of the quiz: no two with different variants in the same way.
    fn title(&self, asked: &[Asked]) -> String {
        let usual = || {
            let first = asked.first()?;
            let form = first.problem.forms().get(first.form).and_then(|form| form.question.name.clone());
            let more = asked.len().checked_sub(1).filter(|more| *more > 0).map(|more| format!("{more} more"));
            let seed = first.slot.as_ref().map_or(self.seed, |slot| slot.numbered_seed(self.seed));
            let title = first.problem.title().to_owned();
            let words = [Some(title), form, more, Some(first.problem.code(first.form, seed))];
            Some(words.into_iter().flatten().collect::<Vec<_>>().join(", "))
        };
        self.title.clone().or_else(usual).unwrap_or_default()
    }

    /// The problems with their forms; those of a homework have its points.
    fn asked(&self, secret: Option<&[u8]>) -> Result<Vec<Asked>, Failure> {
        let Some((source, homework)) = open::homework(&self.problems, secret)? else {
            let problems = open::problems(&self.problems, secret)?;
            let form = |problem: &Arc<Problem>| open::form(problem, self.form.as_deref());
            let asked = |problem| Ok(Asked { form: form(&problem)?, problem, slot: None });
            return problems.into_iter().map(asked).collect();
        };
        if self.form.is_some() {
            return Err(Failure::unusable("--form is for problems\nhelp: name the forms in the file of the homework"));
        }
        let asked = homework.slots.into_iter().map(|slot| {
            let (points, times) = slot.whole_points();
            if times > 1 {
                tell(&format!(
                    "note: {}: the points of {} are multiplied by {times} here, so that those of each part are whole",
                    source.name,
                    slot.problem.id()
                ));
            }
            let problem = Arc::new(Problem::clone(&slot.problem).with_points(slot.form, &points));
            Asked { problem, form: slot.form, slot: Some(slot) }
        });
        Ok(asked.collect())
    }

    fn markup(&self, target: &Target) -> Result<Markup, Failure> {
        let usual = target.markup.first().copied().unwrap_or(Markup::MathMl);
        let wanted = self.math.map_or(usual, Mathematics::markup);
        target.markup.contains(&wanted).then_some(wanted).ok_or_else(|| {
            Failure::unusable(format!("mathematics for {} cannot be written so\nhelp: leave out --math", target.name))
        })
    }
}

/// Tells which features did not go along, in how many questions, and what stands in their place.
fn report(held: &BTreeMap<Feature, u64>, target: &Target) -> String {
    let mut text = String::from("did not go along as it is (questions): what stands in its place");
    for (feature, what, places) in FEATURES {
        let place = TARGETS.iter().zip(places).find(|(listed, _)| listed.name == target.name);
        let (Some(count), Some((_, place))) = (held.get(&feature), place) else { continue };
        let _ = match place {
            Place::Whole(_) => Ok(()),
            Place::Instead(instead) => write!(text, "\n  {what} ({count}): {instead}"),
            Place::LeftOut("") => write!(text, "\n  {what} ({count}): left out"),
            Place::LeftOut(so) => write!(text, "\n  {what} ({count}): left out; {so}"),
        };
    }
    text
}

/// The table of features that go along to each target.
fn targets() -> String {
    let mut text = String::new();
    for (column, target) in TARGETS.iter().enumerate() {
        let _ = writeln!(text, "{}: {}", target.name, target.about);
        for (_, what, places) in FEATURES {
            let _ = match places[column] {
                Place::Whole(place) => writeln!(text, "  goes along  {what}: {place}"),
                Place::Instead(place) => writeln!(text, "  is replaced {what}: {place}"),
                Place::LeftOut("") => writeln!(text, "  is left out {what}"),
                Place::LeftOut(so) => writeln!(text, "  is left out {what}: {so}"),
            };
        }
    }
    text
}
