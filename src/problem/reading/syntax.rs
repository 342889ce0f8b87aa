//! Ways out of faults of YAML.

enum Clue {
    InMessage,
    InLine,
}

/// Ways out of faults of syntax, by a clue; the first that fits is told.
const HELP: &[(&str, Clue, &str)] = &[
    ("\t", Clue::InLine, "indent with spaces, not with tabs"),
    (": {{", Clue::InLine, "write a text that begins with `{{` in quotes, or on the next line after `>`"),
    ("- {{", Clue::InLine, "write a text that begins with `{{` in quotes"),
    (
        "mapping values are not allowed",
        Clue::InMessage,
        "write a text that contains a colon in quotes; else check the indentation",
    ),
    ("unexpected end of stream", Clue::InMessage, "close the quotes"),
    ("quoted scalar", Clue::InMessage, "close the quotes, on the same line"),
    ("invalid indentation", Clue::InMessage, "is a bracket, a brace or a quote above not closed?"),
    ("flow mapping", Clue::InMessage, "separate the entries with commas and close the brace `}`"),
    ("flow sequence", Clue::InMessage, "separate the items with commas and close the bracket `]`"),
    (
        "block mapping",
        Clue::InMessage,
        "keys of one mapping begin in the same column, each followed by a colon and a space",
    ),
    ("block collection", Clue::InMessage, "items of one list begin in the same column, each with `- `"),
];

/// The way out of a fault of syntax, by what the parser says and the line where it stopped.
pub(super) fn way_out(info: &str, line: &str) -> &'static str {
    let help = HELP.iter().find(|(clue, place, _)| match place {
        Clue::InMessage => info.contains(clue),
        Clue::InLine => line.contains(clue),
    });
    help.map_or("check the indentation, the quotes and the brackets around this place", |row| row.2)
}
