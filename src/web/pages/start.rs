//! The start page: every problem by topic, with a search.

use serde::Serialize;

use momentous_bank::Card;
use momentous_exercise::calls::Refused;

use super::super::app::App;
use super::super::parameters::Parameters;

#[derive(Serialize)]
struct StartPage<'a> {
    title: &'static str,
    search: &'a str,
    level: &'a str,
    found: usize,
    topics: Vec<Topic<'a>>,
}

#[derive(Serialize)]
struct Topic<'a> {
    name: &'a str,
    problems: Vec<&'a Card>,
}

/// The start page; `search` and `level` narrow the list.
pub(crate) fn start(app: &App, fields: &Parameters) -> Result<String, Refused> {
    let cards = app.library.cards()?;
    let search = fields.text("search");
    let level = fields.text("level");
    let found: Vec<&Card> = cards.iter().filter(|card| card.is_found(search, level)).collect();
    let mut topics: Vec<Topic> = Vec::new();
    for card in &found {
        match topics.last_mut() {
            Some(topic) if topic.name == card.topic => topic.problems.push(card),
            _ => topics.push(Topic { name: &card.topic, problems: vec![card] }),
        }
    }
    app.page("start", &StartPage { title: "Momentous", search, level, found: found.len(), topics })
}
