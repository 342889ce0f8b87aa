#!/usr/bin/env python3
"""Makes the fonts of documents out of STIX Two: momentous-math.woff2 with the characters that documents print as mathematics
and what grows around them, and momentous-serif*.woff2 with the letters of the Latin, Greek and Cyrillic scripts for PDF.

    apt-get download texlive-fonts-extra        # on Debian 12; holds the folder stix2-otf, version 2.12
    pip install fonttools==4.68.0 brotli==1.2.1
    python3 make.py stix2-otf

Whoever needs a further character adds it below. `cargo test --test pages fonts` says what the bank prints and the font lacks.
"""

import sys
from pathlib import Path

from fontTools import subset
from fontTools.ttLib import TTFont

MATH = "Momentous Math"
TEXT = "Momentous Serif"
STYLES = ("Regular", "Italic", "Bold")

# Browsers set single letters in the mathematical italics, whatever letter the document holds.
RANGES = {
    "ASCII": [(0x20, 0x7E)],
    "Greek": [(0x391, 0x3A1), (0x3A3, 0x3A9), (0x3B1, 0x3C9)],
    "italics": [(0x1D434, 0x1D454), (0x1D456, 0x1D467), (0x210E, 0x210E)],
    "Greek italics": [(0x1D6E2, 0x1D71B)],
    "bold letters": [(0x1D400, 0x1D433), (0x1D7CE, 0x1D7D7)],
    "bold italics": [(0x1D468, 0x1D49B)],
    "small Greek bold italics": [(0x1D736, 0x1D74E)],
    "accents": [(0x300, 0x304), (0x306, 0x308), (0x30A, 0x30A), (0x30C, 0x30C), (0x332, 0x332), (0x338, 0x338)],
    "invisible operators": [(0x2061, 0x2064)],
}
CHARACTERS = {
    "Latin-1": "\u00a0¬°±²³µ·¹×÷",
    "variants of Greek letters": "ϑϕϖϰϱϵ",
    "dotless letters": "ıȷ𝚤𝚥",
    "other letters": "ℏℓℂℕℝℤ∂∇∞",
    "spaces": "\u2002\u2003\u2005\u2009\u200a\u205f",
    "quotation marks and dashes": "–—‘’“”•",
    "accents": "´¨¯ˆˇ˘˙˚˜‾\u20d7⏞⏟",
    "brackets": "‖⟨⟩",
    "primes": "′″‴",
    "large operators": "√∏∑∫∬∮",
    "binary operators": "−∓∗∘∙⋅∩∪∧∨⊕⊗⊙",
    "relations": "∈∉∝∠∣∥∼≃≅≈≔≠≡≤≥≪≫⊂⊆⊥⟂∀∃∴",
    "dots": "…⋮⋯⋱",
    "arrows": "←↑→↓↔↕↖↗↘↙↦↺↻⇀⇌⇐⇑⇒⇓⇔⟵⟶⟷⟸⟹⟺",
}

# What names and stories are written in. What mathematics adds to it, PDF takes from the other font.
TEXT_RANGES = [
    (0x20, 0x7E),
    (0xA0, 0x24F),
    (0x2B0, 0x36F),
    (0x370, 0x3FF),
    (0x400, 0x52F),
    (0x1E00, 0x1EFF),
    (0x2000, 0x22FF),
    (0xFB00, 0xFB04),
]
TEXT_FEATURES = ["ccmp", "kern", "liga", "locl", "mark", "mkmk"]

# Stylistic sets of the font that replace its usual shapes: a pointed v, which the usual one is too like an upsilon for a
# subject full of velocities; and primes as large as browsers want them, which do not ask for the font's script sizes.
SETS = ("ss02", "ss04")


def repertoire():
    ranged = {code for ranges in RANGES.values() for first, last in ranges for code in range(first, last + 1)}
    return ranged | {ord(character) for characters in CHARACTERS.values() for character in characters}


def substitutions(font):
    table = font["GSUB"].table
    for record in table.FeatureList.FeatureRecord:
        if record.FeatureTag in SETS:
            for index in record.Feature.LookupListIndex:
                for part in table.LookupList.Lookup[index].SubTable:
                    yield from getattr(part, "ExtSubTable", part).mapping.items()


def rename(font, family, style):
    notice, licence, address = (font["name"].getDebugName(number) for number in (0, 13, 14))
    original, version = (font["name"].getDebugName(number) for number in (16, 5))
    original = original or font["name"].getDebugName(1)
    full = family if style == "Regular" else f"{family} {style}"
    font["name"].names = []
    entries = {0: notice, 1: family, 2: style, 3: f"{full}, from {original} {version}", 4: full}
    entries |= {5: version, 6: full.replace(" ", ""), 13: licence, 14: address}
    for number, text in entries.items():
        font["name"].setName(text, number, 3, 1, 0x409)
    cff = font["CFF "].cff
    cff.fontNames = [full.replace(" ", "")]
    cff.topDictIndex[0].FullName, cff.topDictIndex[0].FamilyName = full, family


def save(font, wanted, name, **settings):
    options = subset.Options(
        hinting=False, desubroutinize=True, glyph_names=False, notdef_outline=True, name_IDs=["*"], **settings
    )
    options.drop_tables += ["BASE", "DSIG"] + ([] if settings["layout_features"] else ["GDEF", "GPOS", "GSUB"])
    subsetter = subset.Subsetter(options)
    subsetter.populate(unicodes=wanted)
    subsetter.subset(font)
    font.flavor = "woff2"
    output = Path(__file__).with_name(f"{name}.woff2")
    font.save(output)
    print(f"{output.name}: {len(font.getBestCmap())} characters, {output.stat().st_size} bytes")


def make_math(folder):
    font = TTFont(folder / "STIXTwoMath-Regular.otf", recalcTimestamp=False)
    wanted = repertoire()
    lacking = wanted - font.getBestCmap().keys()
    if lacking:
        sys.exit("not in the font: " + " ".join(f"U+{code:04X}" for code in sorted(lacking)))
    other = dict(substitutions(font))
    for table in font["cmap"].tables:
        if table.isUnicode() and table.format != 14:
            table.cmap = {code: other.get(glyph, glyph) for code, glyph in table.cmap.items()}
    rename(font, MATH, "Regular")
    save(font, wanted, "momentous-math", layout_features=[])


def make_text(folder, style):
    font = TTFont(folder / f"STIXTwoText-{style}.otf", recalcTimestamp=False)
    wanted = {code for first, last in TEXT_RANGES for code in range(first, last + 1)}
    rename(font, TEXT, style)
    save(font, wanted, f"momentous-serif-{style.lower()}", layout_features=TEXT_FEATURES)


def main(folder):
    make_math(Path(folder))
    for style in STYLES:
        make_text(Path(folder), style)


if __name__ == "__main__":
    main(*sys.argv[1:])
