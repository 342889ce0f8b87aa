//! R/exams: for each form an Rmd file that holds its variants as data, and prints one of them.

use std::io::Write;

use momentous_render::Markup;

use super::Export;
use super::NotWritten;
use super::band::{Band, bands};
use super::field::{Asked, Field};
use super::package::Package;
use super::printable;
use super::question::{Asking, Pictures, Question};

const MARKUP: Markup = Markup::Markdown;

/// What stands before the variants. Text of problems stands only in strings of R, where knitr runs no code in it.
const HEAD: &str = "```{r variants, echo = FALSE, results = \"hide\"}\nvariants <- list(\n";

/// What stands behind them.
const REST: &str = "\
)
variant <- variants[[sample(length(variants), 1)]]
for (name in names(variant$figures)) writeLines(variant$figures[[name]], name, useBytes = TRUE)
```

Question
========

```{r question, echo = FALSE, results = \"asis\"}
cat(variant$question)
```

Answerlist
----------

```{r answers, echo = FALSE, results = \"asis\"}
cat(paste(\"*\", variant$answers), sep = \"\\n\")
```

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
}

/// Begins a package.
pub(super) fn begin(out: Box<dyn Write + '_>) -> Box<dyn Export + '_> {
    Box::new(RExams { package: Package::new(out), form: String::new() })
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
            self.form = form;
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
        let meta = [
            ("exname", self.form.clone()),
            ("extype", "cloze".to_owned()),
            ("exclozetype", "`r variant$types`".to_owned()),
            ("exsolution", "`r variant$right`".to_owned()),
            ("extol", "`r variant$tolerance`".to_owned()),
        ];
        let meta = meta.map(|(name, value)| format!("{name}: {value}\n")).concat();
        Ok(self.package.write_all(format!("\n{REST}{meta}").as_bytes())?)
    }
}

/// A variant as a list of R.
fn variant(question: &Question<'_>) -> Result<String, NotWritten> {
    let mut pictures = Pictures::named(&question.item.code);
    let mut text = question.statement(MARKUP, &mut pictures)? + &question.code(MARKUP, None);
    let labelled = question.asked.len() > 1;
    for asking in &question.asked {
        text.push_str(&MARKUP.paragraph(&asking.question(MARKUP, labelled)));
    }
    let solution = question.solution(MARKUP, &mut pictures)?;
    let fields: Vec<Answer> = question.fields().map(|(asking, field)| answer(asking, field)).collect();
    let joined = |of: fn(&Answer) -> &str| string(&fields.iter().map(of).collect::<Vec<_>>().join("|"));
    let listed: Vec<String> = fields.iter().flat_map(|own| &own.listed).map(|text| string(text)).collect();
    let figures: Vec<String> =
        pictures.files.iter().map(|(name, svg)| format!("{} = {}", string(name), string(svg))).collect();
    Ok(format!(
        "list(question = {},\n  solution = {},\n  answers = c({}),\n  types = {}, right = {}, tolerance = {},\n  \
         figures = list({}))",
        string(&text),
        string(&solution),
        listed.join(", "),
        joined(|own| own.kind),
        joined(|own| &own.right),
        joined(|own| &own.tolerance),
        figures.join(",\n    "),
    ))
}

/// What R/exams is told of a field.
struct Answer {
    kind: &'static str,
    /// What stands in the list of answers.
    listed: Vec<String>,
    right: String,
    tolerance: String,
}

fn answer(asking: &Asking<'_>, field: &Field<'_>) -> Answer {
    match &field.asked {
        Asked::Number(number) => {
            let bands = bands(number, asking.part.field.points);
            let right = bands.iter().find(|own| own.is_full());
            let [middle, reach] = [Band::middle, Band::reach].map(|of| right.map_or(0.0, of).to_string());
            let label = format!("({}) {}", field.name, field.caption);
            let listed = format!("{} {}", MARKUP.text(label.trim()), asking.unit(MARKUP));
            Answer { kind: "num", listed: vec![listed.trim_end().to_owned()], right: middle, tolerance: reach }
        }
        Asked::Choice(options) => Answer {
            kind: "schoice",
            listed: options.iter().map(|own| MARKUP.line(own.text)).collect(),
            right: options.iter().map(|own| if own.right { '1' } else { '0' }).collect(),
            tolerance: "0".to_owned(),
        },
    }
}

/// A string of R; what JSON writes is one, too.
fn string(text: &str) -> String {
    serde_json::Value::from(printable(text).as_ref()).to_string()
}
