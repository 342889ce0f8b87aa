//! A page for each law, from its row.

use std::fmt::Write;

use momentous::laws::{CHAPTERS, Law};

use super::bank_page::Survey;

const START: &str =
    "<!-- laws: from here to the next mark, written by UPDATE_DOCS=1 cargo test --test pages book -->\n";
const END: &str = "<!-- end -->";

/// The law's name; what it is about stands behind a name that several laws share, as trigonometry is.
fn title(law: &Law) -> String {
    let name = law.name.strip_prefix("the ").unwrap_or(law.name);
    let shared = CHAPTERS.iter().flat_map(|chapter| chapter.laws).filter(|other| other.name == law.name).count() > 1;
    let name = if shared {
        format!("{name}: {}", law.id.replace('-', " ").replace("mass centre", "centre of mass"))
    } else {
        name.to_owned()
    };
    let mut letters = name.chars();
    letters.next().map(|first| first.to_uppercase().chain(letters).collect()).unwrap_or_default()
}

/// The page of one law.
pub fn page(chapter: &str, law: &Law, bank: &Survey) -> String {
    let mut page = format!("# {}\n\n*{chapter}* · `{}`\n\n{}\n", title(law), law.id, law.statement);
    for (head, text) in [("Signs", law.signs), ("When it applies", law.when), ("Source", law.source)] {
        write!(page, "\n## {head}\n\n{text}\n").unwrap();
    }
    if !law.wrong.is_empty() {
        page.push_str("\n## Common mistakes\n\nIf an answer shows one of these, the student is asked the question beside it; see the [chapter on marking](../marking.md).\n\n");
    }
    for mistake in law.wrong.iter().map(|form| form.of) {
        writeln!(page, "- `{}`: the student {}. *{}*", mistake.id, mistake.does, mistake.ask).unwrap();
    }
    let users = bank.using(law);
    page.push_str("\n## In the bank\n\n");
    if users.is_empty() {
        page.push_str("No problem of the bank uses this law.\n");
    }
    for (id, title) in users {
        writeln!(page, "- `{id}`: {title}").unwrap();
    }
    page
}

/// The summary, with every law between its marks.
pub fn listed(summary: &str) -> String {
    let (head, rest) = summary.split_once(START).unwrap();
    let (_, tail) = rest.split_once(END).unwrap();
    let mut list = String::new();
    for chapter in CHAPTERS {
        writeln!(list, "- [{}]()", chapter.title).unwrap();
        for law in chapter.laws {
            writeln!(list, "  - [{}](laws/{}.md)", title(law), law.id).unwrap();
        }
    }
    format!("{head}{START}{list}{END}{tail}")
}
