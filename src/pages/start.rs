//! The start page: a gallery of the problems in the order of a course, with a search.

use serde::Serialize;

use momentous_bank::{AnswerKind, Exhibit, Query, Section};
use momentous_exercise::calls::Refused;
use momentous_render::Fragment;

use super::parameters::Parameters;
use super::view::View;

/// The levels by their names in addresses, and what they are called.
const LEVELS: [(&str, &str); 3] = [("intro", "Introductory"), ("core", "Standard"), ("challenge", "Challenging")];

/// The number of problems of each section on the start page itself; the rest is behind a link, so that the page stays short and
/// small.
const FIRST: usize = 4;

#[derive(Serialize)]
struct StartPage<'a> {
    title: &'static str,
    search: &'a str,
    /// The words that were looked for, where others were typed.
    instead: Option<&'a str>,
    filters: [Filter<'a>; 3],
    /// Whether some problems only are shown, since nobody has said which.
    is_overview: bool,
    found: usize,
    sections: Vec<Shelf<'a>>,
}

/// A list of which one is chosen.
#[derive(Serialize)]
struct Filter<'a> {
    name: &'static str,
    label: &'static str,
    chosen: &'a str,
    options: Vec<(&'a str, &'a str)>,
}

/// A section with its problems.
#[derive(Serialize)]
struct Shelf<'a> {
    name: &'a str,
    title: &'a str,
    /// The number of problems that it has.
    count: usize,
    problems: Vec<ShownExhibit<'a>>,
}

#[derive(Serialize)]
struct ShownExhibit<'a> {
    id: &'a str,
    title: &'a str,
    level: &'a str,
    asks: &'a Fragment,
    /// Whether it is part of an assignment that is open, and so is not practised now.
    reserved: bool,
}

/// The start page; `search`, `topic`, `level` and `answer` narrow the gallery.
pub(super) fn start(view: &View<'_>, fields: &Parameters) -> Result<String, Refused> {
    let exhibits = view.pages.library.exhibits()?;
    let mut all: Vec<&Exhibit> = exhibits.iter().collect();
    // Within a section the easier ones come first.
    all.sort_by_key(|exhibit| {
        (
            exhibit.section.place,
            exhibit.section.name.as_str(),
            LEVELS.iter().position(|(name, _)| *name == exhibit.card.level),
        )
    });
    let [search, topic, level, answer] = ["search", "topic", "level", "answer"].map(|name| fields.text(name));
    let query = Query::of(search, &exhibits);
    let kind = AnswerKind::ALL.into_iter().find(|(_, name, _)| *name == answer).map(|(kind, ..)| kind);
    let is_found = |exhibit: &&&Exhibit| {
        (topic.is_empty() || exhibit.section.name == topic)
            && (level.is_empty() || exhibit.card.level == level)
            && kind.is_none_or(|kind| exhibit.answers.contains(&kind))
            && query.finds(exhibit)
    };
    let matching: Vec<&Exhibit> = all.iter().filter(is_found).copied().collect();
    let mut topics: Vec<&Section> = all.iter().map(|exhibit| &exhibit.section).collect();
    topics.dedup();
    let filter = |name, label, chosen, options| Filter { name, label, chosen, options };
    let is_overview = [search, topic, level, answer].iter().all(|words| words.is_empty());
    let most = if is_overview { FIRST } else { usize::MAX };
    let sections = matching.chunk_by(|one, other| one.section == other.section);
    let page = StartPage {
        title: "Momentous",
        search,
        instead: query.instead.as_deref(),
        filters: [
            filter(
                "topic",
                "Topic",
                topic,
                topics.iter().map(|section| (section.name.as_str(), section.title.as_str())).collect(),
            ),
            filter("level", "Level", level, LEVELS.into()),
            filter("answer", "Kind of answer", answer, AnswerKind::ALL.map(|(_, name, label)| (name, label)).into()),
        ],
        is_overview,
        found: matching.len(),
        sections: sections.map(|exhibits| Shelf::of(view, exhibits, most)).collect(),
    };
    view.page("start", &page)
}

impl<'a> Shelf<'a> {
    fn of(view: &View<'_>, exhibits: &[&'a Exhibit], most: usize) -> Self {
        let section = exhibits.first().map(|exhibit| &exhibit.section);
        let shown = |exhibit: &&'a Exhibit| ShownExhibit {
            id: &exhibit.card.id,
            title: &exhibit.card.title,
            level: LEVELS
                .iter()
                .find(|(name, _)| *name == exhibit.card.level)
                .map_or(exhibit.card.level, |(_, label)| label),
            asks: &exhibit.asks,
            reserved: !view.is_open(&exhibit.card.id),
        };
        Self {
            name: section.map_or("", |section| section.name.as_str()),
            title: section.map_or("", |section| section.title.as_str()),
            count: exhibits.len(),
            problems: exhibits.iter().take(most).map(shown).collect(),
        }
    }
}
