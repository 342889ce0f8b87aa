//! R/exams: for each form an Rmd file that holds its variants as data, and prints one of them.

use std::io::Write;

use momentous_render::Markup;
use momentous_render::latex_sign;

use super::Export;
use super::NotWritten;
use super::band::{bands, printed};
use super::field::{Asked, Field};
use super::package::Package;
use super::printable;
use super::question::{Asking, Pictures, Question, TypedUnit};

const MARKUP: Markup = Markup::Markdown;

/// Signs that LaTeX prints as they are.
const LATIN: std::ops::RangeInclusive<char> = '\0'..='\u{ff}';
const EM_SPACE: char = '\u{2003}';

/// The text before the variants. Text of problems stands only in strings of R, where knitr runs no code in it.
const HEAD: &str = "```{r variants, echo = FALSE, results = \"hide\"}\nvariants <- list(\n";

/// Behind the variants: one of them is drawn. LaTeX reads no SVG, so that there the figures are made of `TikZ`.
const DRAWN: &str = "\
)
variant <- variants[[sample(length(variants), 1)]]
is_latex <- identical(exams::match_exams_device(), \"pdf\")
for (name in names(variant$figures)) {
  figure <- variant$figures[[name]]
  if (is_latex) exams::include_tikz(figure$tikz, name = name, format = \"pdf\", markup = \"none\")
  else writeLines(figure$svg, paste0(name, \".svg\"), useBytes = TRUE)
}
if (is_latex) for (text in c(\"question\", \"solution\", \"answers\"))
  variant[[text]] <- gsub(\"(momentous-[a-z]+-[0-9]+)[.]svg\", \"\\\\1.pdf\", variant[[text]])
```

Question
========

```{r question, echo = FALSE, results = \"asis\"}
cat(variant$question)
```

";

/// The fields of a question, one or several, and the options of a choice.
const ANSWERS: &str = "\
Answerlist
----------

```{r answers, echo = FALSE, results = \"asis\"}
cat(paste(\"*\", variant$answers), sep = \"\\n\")
```

";

/// The text at the end.
const REST: &str = "\
Solution
========

```{r solution, echo = FALSE, results = \"asis\"}
cat(variant$solution)
```

Meta-information
================
";

/// A package on its way.
struct RExams<W: Write> {
    package: Package<W>,
    form: String,
    kind: Kind,
}

/// Which of the kinds of R/exams a question is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// One number.
    Number,
    /// One choice.
    Choice,
    /// Several fields.
    Cloze,
}

impl Kind {
    fn of(question: &Question<'_>) -> Self {
        let mut fields = question.fields().map(|(_, field)| &field.asked);
        match (fields.next(), fields.next()) {
            (Some(Asked::Number(_)), None) => Self::Number,
            (Some(Asked::Choice(_)), None) => Self::Choice,
            _ => Self::Cloze,
        }
    }

    /// Its name.
    fn name(self) -> &'static str {
        match self {
            Self::Number => "num",
            Self::Choice => "schoice",
            Self::Cloze => "cloze",
        }
    }
}

/// Begins a package.
pub(super) fn begin(out: Box<dyn Write + '_>) -> Box<dyn Export + '_> {
    Box::new(RExams { package: Package::new(out), form: String::new(), kind: Kind::Cloze })
}

impl<W: Write> Export for RExams<W> {
    fn write(&mut self, question: &Question<'_>) -> Result<(), NotWritten> {
        let form = question.name();
        if form == self.form {
            self.package.write_all(b",\n")?;
        } else {
            self.end_form()?;
            self.package.begin(&format!("{form}.Rmd"))?;
            self.package.write_all(HEAD.as_bytes())?;
            (self.form, self.kind) = (form, Kind::of(question));
        }
        self.package.write_all(variant(question)?.as_bytes())?;
        Ok(())
    }

    fn finish(mut self: Box<Self>) -> Result<(), NotWritten> {
        self.end_form()?;
        self.package.finish()
    }
}

impl<W: Write> RExams<W> {
    fn end_form(&mut self) -> Result<(), NotWritten> {
        if self.form.is_empty() {
            return Ok(());
        }
        let is_cloze = self.kind == Kind::Cloze;
        let meta = [
            ("exname", Some("`r variant$name`")),
            ("extype", Some(self.kind.name())),
            ("exclozetype", Some("`r variant$types`").filter(|_| is_cloze)),
            ("exsolution", Some("`r variant$right`")),
            ("extol", Some("`r variant$tolerance`").filter(|_| self.kind != Kind::Choice)),
            ("expoints", Some("`r variant$points`")),
        ];
        let meta = meta.into_iter().filter_map(|(name, value)| Some(format!("{name}: {}\n", value?)));
        let answers = if self.kind == Kind::Number { "" } else { ANSWERS };
        let rest = format!("\n{DRAWN}{answers}{REST}{}", meta.collect::<String>());
        Ok(self.package.write_all(rest.as_bytes())?)
    }
}

/// A variant as a list of R.
fn variant(question: &Question<'_>) -> Result<String, NotWritten> {
    let mut pictures = Pictures::named(format!("momentous-{}", question.item.code));
    let mut text = question.statement(MARKUP, &mut pictures)?;
    text += &(question.writing(MARKUP, TypedUnit::Never) + &question.code(MARKUP, None));
    let labelled = question.asked.len() > 1;
    let is_one_number = Kind::of(question) == Kind::Number;
    for asking in &question.asked {
        let unit = Some(asking.unit(MARKUP)).filter(|unit| is_one_number && !unit.is_empty());
        let unit = unit.map(|unit| format!(" (in {unit}).")).unwrap_or_default();
        text.push_str(&MARKUP.paragraph(&(asking.question(MARKUP, labelled) + &unit)));
    }
    let solution = question.solution(MARKUP, &mut pictures)?;
    let fields: Vec<Answer> = question.fields().map(|(asking, field)| answer(asking, field)).collect();
    let joined = |text: fn(&Answer) -> &str| string(&fields.iter().map(text).collect::<Vec<_>>().join("|"));
    let listed: Vec<String> = fields.iter().flat_map(|answer| &answer.listed).map(|text| string(text)).collect();
    let figure = |((name, svg), tikz): (&(String, String), &String)| {
        let name = name.trim_end_matches(".svg");
        format!("{} = list(svg = {},\n    tikz = {})", string(name), string(svg), string(tikz))
    };
    let figures: Vec<String> = pictures.files.iter().zip(&pictures.tikz).map(figure).collect();
    Ok(format!(
        "list(name = {},\n  question = {},\n  solution = {},\n  answers = c({}),\n  \
         types = {}, right = {}, tolerance = {}, points = {},\n  figures = list({}))",
        string(&question.title().replace('`', "")),
        string(&for_latex(&text)),
        string(&for_latex(&solution)),
        listed.join(", "),
        joined(|answer| answer.kind),
        joined(|answer| &answer.right),
        joined(|answer| &answer.tolerance),
        joined(|answer| &answer.points),
        figures.join(",\n    "),
    ))
}

/// A text in which signs that LaTeX's fonts for text lack are mathematics.
fn for_latex(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for sign in text.chars() {
        match latex_sign(sign).filter(|_| !LATIN.contains(&sign)) {
            Some(command) => out.extend(["$", command, "$"]),
            None if sign == EM_SPACE => out.push_str("\u{a0}\u{a0}"),
            None => out.push(sign),
        }
    }
    out
}

/// The parameters of R/exams for a field.
struct Answer {
    kind: &'static str,
    /// The entries in the list of answers.
    listed: Vec<String>,
    right: String,
    tolerance: String,
    points: String,
}

fn answer(asking: &Asking<'_>, field: &Field<'_>) -> Answer {
    let points = asking.weight.to_string();
    match &field.asked {
        Asked::Number(number) => {
            let bands = bands(number, asking.part.field.points);
            let right = bands.iter().find(|band| band.is_full());
            // The right value as it is printed; everything that is right lies within the tolerance of it.
            let printed = printed(number);
            let value: f64 = printed.parse().unwrap_or(number.right);
            let reach = right.map_or(0.0, |band| band.reach_from(value)).to_string();
            let label = format!("({}) {}", field.name, field.caption);
            let listed = format!("{} {}", MARKUP.text(label.trim()), asking.unit(MARKUP));
            Answer { kind: "num", listed: vec![listed.trim_end().to_owned()], right: printed, tolerance: reach, points }
        }
        Asked::Choice(options) => Answer {
            kind: "schoice",
            listed: options.iter().map(|option| option.shown(MARKUP)).collect(),
            right: options.iter().map(|option| if option.right { '1' } else { '0' }).collect(),
            tolerance: "0".to_owned(),
            points,
        },
    }
}

/// A string of R; what JSON writes is one, too.
fn string(text: &str) -> String {
    serde_json::Value::from(printable(text).as_ref()).to_string()
}
