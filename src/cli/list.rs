//! `momentous list`

use std::io::Write;

use clap::Args;
use rayon::prelude::*;

use crate::bank::Bank;
use crate::bank::Card;
use crate::fault::Source;
use crate::problem::load;

use super::exit::Exit;
use super::failure::Failure;
use super::format::Listing;
use super::output::Output;
use super::style::Style;

const HELP: &str = "\
Examples:
  momentous list
  momentous list --topic impact
  momentous list --format json | jq -r 'select(.level == \"intro\").id'";

/// List the problems of the bank
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub(super) struct List {
    /// Only problems of this topic: the part before the slash
    #[arg(long, value_name = "TOPIC")]
    topic: Option<String>,
    /// For people, or one JSON object per line
    #[arg(long, value_name = "FORMAT", default_value = "text")]
    format: Listing,
}

impl List {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        let bank = Bank::here()?;
        let sources: Vec<&Source> = match &self.topic {
            Some(topic) => bank.topic(topic)?,
            None => bank.sources().collect(),
        };
        let loaded: Vec<_> = sources.into_par_iter().map(|source| load(source.clone())).collect();
        let mut cards = Vec::new();
        let mut failures = Vec::new();
        for loaded in loaded {
            match loaded {
                Ok(loaded) => cards.push(Card::of(&loaded)),
                Err(faults) => failures.push(Failure::from(faults)),
            }
        }
        let mut output = Output::to(None)?;
        match self.format {
            Listing::Text => write_table(&mut output, &cards)?,
            Listing::Json => {
                for card in &cards {
                    serde_json::to_writer(&mut output, card)?;
                    writeln!(output)?;
                }
            }
        }
        output.finish()?;
        if failures.is_empty() { Ok(Exit::Fine) } else { Err(Failure::all(failures)) }
    }
}

fn write_table(output: &mut Output, cards: &[Card]) -> Result<(), Failure> {
    let style = Style::of_stdout();
    let head = ["PROBLEM", "LEVEL", "TITLE", "FORMS", "TAGS"].map(str::to_owned);
    let row = |card: &Card| {
        [card.id.clone(), card.level.to_owned(), card.title.clone(), card.forms.join(" "), card.tags.join(" ")]
    };
    let rows: Vec<[String; 5]> = std::iter::once(head).chain(cards.iter().map(row)).collect();
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths = [width(0), width(1), width(2), width(3)];
    for (index, [id, level, title, forms, tags]) in rows.iter().enumerate() {
        let [a, b, c, d] = widths;
        let line = format!("{id:a$}  {level:b$}  {title:c$}  {forms:d$}  {tags}");
        writeln!(output, "{}", if index == 0 { style.strong(line.trim_end()) } else { line.trim_end().to_owned() })?;
    }
    Ok(())
}
