//! `momentous gallery`

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::PathBuf;
use std::sync::Arc;

use clap::Args;
use rayon::prelude::*;

use crate::exercise::Exercise;
use crate::explain::Audience;
use crate::explain::Block;
use crate::explain::Detail;
use crate::figure::Drawing;
use crate::figure::svg_file;
use crate::problem::Problem;

use super::exit::Exit;
use super::failure::Failure;
use super::open;
use super::output::Output;
use super::plot::escaped;

const HELP: &str = "\
Examples:
  momentous gallery -o gallery/                    every figure of the bank at seed 1
  momentous gallery impact central-force --seed 7 -o gallery/

Open gallery/index.html: by topic, the sheet's figure and the solution's figures of each form.";

/// The page with every figure.
const PAGE: &str = "index.html";

/// Draw every figure of sheets and solutions, with one page to look at them
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub(super) struct Gallery {
    /// Identities, topics, files or folders; the whole bank if nothing is named
    #[arg(value_name = "PATH|PROBLEM")]
    problems: Vec<String>,
    /// The seed that draws the numbers
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
    /// The folder that the figures and their page are written into
    #[arg(short, long, value_name = "FOLDER")]
    output: PathBuf,
}

impl Gallery {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        if self.output.exists() && !self.output.is_dir() {
            return Err(Failure::unusable(format!(
                "{} is not a folder\nhelp: name a folder, which need not exist",
                self.output.display()
            )));
        }
        let problems = open::problems(&self.problems, None)?;
        let rooms: Vec<Vec<Form>> =
            problems.par_iter().map(|problem| self.forms(problem)).collect::<Result<_, Failure>>()?;
        let mut topics: BTreeMap<&str, Vec<&Form>> = BTreeMap::new();
        for (problem, forms) in problems.iter().zip(&rooms) {
            let topic = problem.id().split_once('/').map_or("", |(topic, _)| topic);
            topics.entry(topic).or_default().extend(forms);
        }
        let all = || rooms.iter().flatten();
        for figure in all().flat_map(|form| &form.figures) {
            Output::whole(Some(&self.output.join(&figure.file)), &svg_file(&figure.drawing))?;
        }
        Output::whole(Some(&self.output.join(PAGE)), &page(&topics, self.seed))?;
        let figures: usize = all().map(|form| form.figures.len()).sum();
        let mut output = Output::to(None)?;
        writeln!(output, "{figures} figures of {} forms: {}", all().count(), self.output.join(PAGE).display())?;
        output.finish()?;
        Ok(Exit::Fine)
    }

    fn forms(&self, problem: &Arc<Problem>) -> Result<Vec<Form>, Failure> {
        let form = |(position, _)| {
            let drawn = Exercise::draw(problem, position, self.seed);
            drawn
                .map(|exercise| Form::of(&exercise, position + 1))
                .map_err(|reason| Failure::no_variant(problem.id(), self.seed, &reason))
        };
        problem.forms().iter().enumerate().map(form).collect()
    }
}

/// The figures of one form.
struct Form {
    id: String,
    title: String,
    name: String,
    figures: Vec<Figure>,
}

struct Figure {
    /// The place of the figure: `sheet`, or `solution 1`.
    place: String,
    file: String,
    drawing: Drawing,
}

impl Form {
    fn of(exercise: &Exercise, number: usize) -> Self {
        let identity = exercise.identity();
        let name = identity.form.unwrap_or_default();
        let outline = exercise.outline(Audience::Everyone, Detail::Short);
        let blocks = outline.sections.into_iter().flat_map(|section| section.blocks);
        let drawings =
            blocks.filter_map(|block| if let Block::Figure(drawing) = block { Some(*drawing) } else { None });
        let solution = drawings.zip(1..).map(|(drawing, count)| (format!("solution {count}"), drawing));
        let sheet = exercise.sheet().figure.map(|drawing| ("sheet".to_owned(), *drawing));
        let figures = sheet.into_iter().chain(solution).map(|(place, drawing)| {
            let file = format!("{}/form-{number}-{}.svg", identity.problem, place.replace(' ', "-"));
            Figure { place, file, drawing }
        });
        Self { figures: figures.collect(), id: identity.problem, title: exercise.problem().title().to_owned(), name }
    }
}

/// One page with all figures, by topic.
fn page(topics: &BTreeMap<&str, Vec<&Form>>, seed: u64) -> String {
    let mut page = format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Figures at seed {seed}</title>\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n<style>\n\
         body {{ font-family: sans-serif; margin: 1rem }}\n\
         section > div {{ display: flex; flex-wrap: wrap; gap: 1rem; align-items: end }}\n\
         figure {{ margin: 0; max-width: 30rem }} img {{ max-width: 100% }} figcaption {{ font-size: small }}\n\
         </style></head><body>\n<h1>Figures at seed {seed}</h1>\n"
    );
    // Writing to a string cannot fail.
    for (topic, forms) in topics {
        let _ = writeln!(page, "<h2>{}</h2>", escaped(topic));
        for form in forms {
            let heading = [&*form.title, &form.id, &form.name].map(escaped).join(" · ");
            let heading = heading.trim_end_matches(" · ");
            let _ = writeln!(page, "<section><h3>{heading}</h3>");
            let none = if form.figures.is_empty() { "no figure" } else { "" };
            let _ = writeln!(page, "<div>{none}");
            for Figure { place, file, drawing } in &form.figures {
                let (caption, alternative) =
                    (escaped(&drawing.caption), escaped(&drawing.description).replace('"', "&quot;"));
                let _ = writeln!(
                    page,
                    "<figure><img src=\"{file}\" alt=\"{alternative}\"><figcaption>{place}: {caption}</figcaption></figure>"
                );
            }
            page.push_str("</div></section>\n");
        }
    }
    page.push_str("</body></html>\n");
    page
}
