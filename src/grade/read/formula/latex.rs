//! The commands of LaTeX that may stand in a formula.

use super::named::Named;
use super::token::Token;

/// The meaning of a command.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Command {
    /// A letter of a name.
    Letter(char),
    /// A token of its own.
    Token(Token),
    /// Nothing but a space.
    Space,
    /// How what follows looks: nothing.
    Nothing,
    /// How its argument looks: the argument alone is read.
    Wrapper,
    /// `\frac`: two arguments follow.
    Fraction,
    /// `\sqrt`: a radicand follows, or a degree in square brackets before it.
    Root,
}

const SPACES: [&str; 9] = [",", ";", ":", "!", " ", ">", "quad", "qquad", "thinspace"];
const NOTHING: [&str; 20] = [
    "left",
    "right",
    "big",
    "Big",
    "bigg",
    "Bigg",
    "bigl",
    "bigr",
    "Bigl",
    "Bigr",
    "biggl",
    "biggr",
    "middle",
    "displaystyle",
    "textstyle",
    "limits",
    "(",
    ")",
    "[",
    "]",
];
const WRAPPERS: [&str; 15] = [
    "mathrm",
    "text",
    "textrm",
    "textit",
    "textbf",
    "mathit",
    "mathbf",
    "mathsf",
    "mathnormal",
    "boldsymbol",
    "bm",
    "operatorname",
    "mbox",
    "vec",
    "ensuremath",
];
const FRACTIONS: [&str; 4] = ["frac", "dfrac", "tfrac", "cfrac"];
const TOKENS: [(&str, Token); 19] = [
    ("cdot", Token::Times),
    ("times", Token::Times),
    ("ast", Token::Times),
    ("star", Token::Times),
    ("bullet", Token::Times),
    ("div", Token::Over),
    ("slash", Token::Over),
    ("over", Token::WholeOver),
    ("pm", Token::PlusMinus),
    ("mp", Token::PlusMinus),
    ("lvert", Token::Bar),
    ("rvert", Token::Bar),
    ("vert", Token::Bar),
    ("mid", Token::Bar),
    ("|", Token::Bar),
    ("{", Token::Open('}')),
    ("}", Token::Close('}')),
    ("degree", Token::Degree),
    ("circ", Token::Degree),
];

/// The command of that name, without its backslash.
pub(super) fn command(name: &str) -> Option<Command> {
    if SPACES.contains(&name) {
        return Some(Command::Space);
    }
    if NOTHING.contains(&name) {
        return Some(Command::Nothing);
    }
    if WRAPPERS.contains(&name) {
        return Some(Command::Wrapper);
    }
    if FRACTIONS.contains(&name) {
        return Some(Command::Fraction);
    }
    if name == "sqrt" {
        return Some(Command::Root);
    }
    if let Some((_, token)) = TOKENS.iter().find(|(listed, _)| *listed == name) {
        return Some(Command::Token(token.clone()));
    }
    if let Some(letter) = super::signs::greek(name) {
        return Some(Command::Letter(letter));
    }
    Named::find(name).map(|function| Command::Token(Token::Function(function)))
}
