#!/usr/bin/env python3
"""Makes momentous-math.woff2 out of STIX Two Math: the characters that documents print, with what grows around them.

    apt-get download texlive-fonts-extra        # on Debian 12; holds STIXTwoMath-Regular.otf, version 2.12
    pip install fonttools==4.68.0 brotli==1.2.1
    python3 make.py STIXTwoMath-Regular.otf

Whoever needs a further character adds it below. `cargo test --test fonts` says what the bank prints and the font lacks.
"""

import sys
from pathlib import Path

from fontTools import subset
from fontTools.ttLib import TTFont

NAME = "Momentous Math"
OUTPUT = Path(__file__).with_name("momentous-math.woff2")

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


def rename(font):
    notice, licence, address = (font["name"].getDebugName(number) for number in (0, 13, 14))
    version = font["name"].getDebugName(5)
    font["name"].names = []
    entries = {0: notice, 1: NAME, 2: "Regular", 3: f"{NAME}, from STIX Two Math {version}", 4: NAME}
    entries |= {5: version, 6: NAME.replace(" ", ""), 13: licence, 14: address}
    for number, text in entries.items():
        font["name"].setName(text, number, 3, 1, 0x409)
    cff = font["CFF "].cff
    cff.fontNames = [NAME.replace(" ", "")]
    cff.topDictIndex[0].FullName = cff.topDictIndex[0].FamilyName = NAME


def main(source):
    font = TTFont(source, recalcTimestamp=False)
    wanted = repertoire()
    lacking = wanted - font.getBestCmap().keys()
    if lacking:
        sys.exit("not in the font: " + " ".join(f"U+{code:04X}" for code in sorted(lacking)))
    other = dict(substitutions(font))
    for table in font["cmap"].tables:
        if table.isUnicode() and table.format != 14:
            table.cmap = {code: other.get(glyph, glyph) for code, glyph in table.cmap.items()}
    rename(font)
    options = subset.Options(
        layout_features=[], hinting=False, desubroutinize=True, glyph_names=False, notdef_outline=True, name_IDs=["*"]
    )
    options.drop_tables += ["BASE", "DSIG", "GDEF", "GPOS", "GSUB"]
    subsetter = subset.Subsetter(options)
    subsetter.populate(unicodes=wanted)
    subsetter.subset(font)
    font.flavor = "woff2"
    font.save(OUTPUT)
    print(f"{len(wanted)} characters, {len(font.getGlyphOrder())} glyphs, {OUTPUT.stat().st_size} bytes")


if __name__ == "__main__":
    main(*sys.argv[1:])
