//! The prefixes of the SI that mechanics uses.

use super::factor::StaticFactor;

/// A decimal prefix.
#[derive(Debug)]
pub(super) struct Prefix {
    /// How it is printed: `k`.
    pub(super) symbol: &'static str,
    /// Other ways to write it: `u` for `µ`.
    pub(super) aliases: &'static [&'static str],
    /// How it is spoken: `kilo`.
    pub(super) name: &'static str,
    /// By what it multiplies.
    pub(super) factor: StaticFactor,
}

const fn up(symbol: &'static str, name: &'static str, power: u32) -> Prefix {
    Prefix { symbol, aliases: &[], name, factor: StaticFactor::integer(10_u128.pow(power)) }
}

const fn down(symbol: &'static str, name: &'static str, power: u32) -> Prefix {
    Prefix { symbol, aliases: &[], name, factor: StaticFactor::decimal(1, power) }
}

/// The one prefix that a base unit of the SI carries, in the kilogram.
pub(super) const KILO: Prefix = up("k", "kilo", 3);

/// Every prefix, the usual ones first.
pub(super) static PREFIXES: &[Prefix] = &[
    KILO,
    down("m", "milli", 3),
    down("c", "centi", 2),
    up("M", "mega", 6),
    Prefix { symbol: "µ", aliases: &["u", "μ"], name: "micro", factor: StaticFactor::decimal(1, 6) },
    up("G", "giga", 9),
    down("n", "nano", 9),
    down("d", "deci", 1),
    up("h", "hecto", 2),
    up("T", "tera", 12),
    down("p", "pico", 12),
    up("P", "peta", 15),
    down("f", "femto", 15),
];
