//! The characters of a formula: each as the one that it stands for, and the letters of LaTeX by name.

use super::super::vulgar::of_character;

/// Letters of the Greek alphabet, and how problem files and LaTeX spell them.
const GREEK: [(char, &str); 32] = [
    ('α', "alpha"),
    ('β', "beta"),
    ('γ', "gamma"),
    ('δ', "delta"),
    ('ε', "epsilon"),
    ('ζ', "zeta"),
    ('η', "eta"),
    ('θ', "theta"),
    ('ι', "iota"),
    ('κ', "kappa"),
    ('λ', "lambda"),
    ('μ', "mu"),
    ('ν', "nu"),
    ('ξ', "xi"),
    ('π', "pi"),
    ('ρ', "rho"),
    ('σ', "sigma"),
    ('τ', "tau"),
    ('υ', "upsilon"),
    ('φ', "phi"),
    ('χ', "chi"),
    ('ψ', "psi"),
    ('ω', "omega"),
    ('Γ', "Gamma"),
    ('Δ', "Delta"),
    ('Θ', "Theta"),
    ('Λ', "Lambda"),
    ('Π', "Pi"),
    ('Σ', "Sigma"),
    ('Φ', "Phi"),
    ('Ψ', "Psi"),
    ('Ω', "Omega"),
];

/// Characters that stand for others.
const MEANT: [(&str, char); 17] = [
    ("−–—‒﹣", '-'),
    ("⋅∙•·∗⋆×✕✖⨯", '*'),
    ("∕⁄÷", '/'),
    ("∆", 'Δ'),
    ("µ", 'μ'),
    ("ϑ", 'θ'),
    ("ϕ", 'φ'),
    ("ϵ", 'ε'),
    ("ϱ", 'ρ'),
    ("\u{2126}", 'Ω'),
    ("ℎ", 'h'),
    ("ℓ", 'l'),
    ("∣❘", '|'),
    ("′’", '\''),
    ("º˚", '°'),
    ("~", ' '),
    ("∓", '±'),
];

const RAISED: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺⁽⁾ⁿˣᵗᵏ";
const UNRAISED: &str = "0123456789-+()nxtk";
const LOWERED: &str = "₀₁₂₃₄₅₆₇₈₉ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ";
const UNLOWERED: &str = "0123456789aehijklmnoprstuvx";

/// The sign in place of those that mean nothing: marks of direction and signs that are not printed.
pub(super) const NOTHING: char = '\u{200b}';

/// The offset between a full-width form and the ASCII character that it shows.
const FULL_WIDTH: u32 = 0xFEE0;
/// The letters of mathematics in all their faces (Unicode's mathematical alphanumeric symbols), and how many a face has.
const FACES: std::ops::RangeInclusive<u32> = 0x1D400..=0x1D6A3;
const FACE: u32 = 52;
/// The same with Greek letters: a face has the capitals, the nabla, the small ones, and other forms of six of them.
const GREEK_FACES: std::ops::RangeInclusive<u32> = 0x1D6A8..=0x1D7CB;
const GREEK_FACE: &str = "ΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΘΣΤΥΦΧΨΩ∇αβγδεζηθικλμνξοπρςστυφχψω∂εθκφρπ";
/// The digits of mathematics in all their faces.
const DIGIT_FACES: std::ops::RangeInclusive<u32> = 0x1D7CE..=0x1D7FF;

/// The character that is meant.
pub(super) fn plain(character: char) -> char {
    let code = u32::from(character);
    let ascii = match code {
        0xFF01..=0xFF5E => char::from_u32(code - FULL_WIDTH).unwrap_or(character),
        0x200B..=0x200F | 0x2060..=0x2064 | 0xFEFF => NOTHING,
        code if FACES.contains(&code) => {
            let place = (code - FACES.start()) % FACE;
            char::from_u32(if place < 26 { 65 + place } else { 71 + place }).unwrap_or(character)
        }
        code if GREEK_FACES.contains(&code) => {
            let letters: usize = GREEK_FACE.chars().count();
            let place = usize::try_from(code - GREEK_FACES.start()).unwrap_or(0) % letters;
            GREEK_FACE.chars().nth(place).unwrap_or(character)
        }
        code if DIGIT_FACES.contains(&code) => {
            char::from_digit((code - DIGIT_FACES.start()) % 10, 10).unwrap_or(character)
        }
        _ if character.is_whitespace() => ' ',
        _ => character,
    };
    // Nearly all characters are these, and each name of a sheet is looked at for each term.
    if ascii.is_ascii_alphanumeric() {
        return ascii;
    }
    MEANT.iter().find(|(signs, _)| signs.contains(ascii)).map_or(ascii, |(_, meant)| *meant)
}

/// The Greek letter that is spelt so.
pub(super) fn greek(word: &str) -> Option<char> {
    let word = match word {
        "vartheta" => "theta",
        "varphi" => "phi",
        "varepsilon" => "epsilon",
        "varrho" => "rho",
        other => other,
    };
    GREEK.iter().find(|(_, spelt)| *spelt == word).map(|(letter, _)| *letter)
}

/// How a Greek letter is spelt.
pub(super) fn spelt(letter: char) -> Option<&'static str> {
    GREEK.iter().find(|(listed, _)| *listed == letter).map(|(_, spelt)| *spelt)
}

/// The character on the line for one above it.
pub(super) fn unraised(character: char) -> Option<char> {
    RAISED.chars().zip(UNRAISED.chars()).find(|(raised, _)| *raised == character).map(|(_, meant)| meant)
}

/// The character on the line for one below it.
pub(super) fn unlowered(character: char) -> Option<char> {
    LOWERED.chars().zip(UNLOWERED.chars()).find(|(lowered, _)| *lowered == character).map(|(_, meant)| meant)
}

/// The numbers above and below the bar of a fraction of one character.
pub(super) fn fraction(character: char) -> Option<(i64, u32)> {
    of_character(character).map(|(above, below)| (i64::from(above), below))
}
