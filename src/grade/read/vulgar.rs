//! Fractions that are one character: `½`.

/// Each with what is above and below the bar.
const VULGAR: [(char, u32, u32); 15] = [
    ('½', 1, 2),
    ('⅓', 1, 3),
    ('⅔', 2, 3),
    ('¼', 1, 4),
    ('¾', 3, 4),
    ('⅕', 1, 5),
    ('⅖', 2, 5),
    ('⅗', 3, 5),
    ('⅘', 4, 5),
    ('⅙', 1, 6),
    ('⅚', 5, 6),
    ('⅛', 1, 8),
    ('⅜', 3, 8),
    ('⅝', 5, 8),
    ('⅞', 7, 8),
];

/// The numbers above and below the bar of such a character; none of any other.
pub(super) fn of_character(character: char) -> Option<(u32, u32)> {
    VULGAR.iter().find(|(vulgar, ..)| *vulgar == character).map(|(_, above, below)| (*above, *below))
}
