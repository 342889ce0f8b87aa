//! The units, as data. Factors lead to the coherent SI unit of the same dimension and are exact by definition.

use super::Dimension;
use super::factor::StaticFactor;

/// A unit that has a symbol of its own.
#[derive(Debug)]
pub(super) struct UnitRow {
    /// How it is printed.
    pub(super) symbol: &'static str,
    /// Other ways to write it.
    pub(super) aliases: &'static [&'static str],
    /// The dimension that it measures.
    pub(super) dimension: Dimension,
    /// Its size in the coherent SI unit.
    pub(super) factor: StaticFactor,
    /// Whether it takes the prefixes of the SI.
    pub(super) prefixes: bool,
    /// Whether it stands directly behind its number, as a degree sign does.
    pub(super) attached: bool,
    /// Its name for one.
    pub(super) singular: &'static str,
    /// Its name for several.
    pub(super) plural: &'static str,
}

impl UnitRow {
    /// The same unit, taking the prefixes of the SI.
    const fn prefixed(self) -> Self {
        Self { prefixes: true, ..self }
    }

    /// The same unit, standing directly behind its number.
    const fn attached(self) -> Self {
        Self { attached: true, ..self }
    }
}

const fn row(
    symbol: &'static str,
    aliases: &'static [&'static str],
    dimension: Dimension,
    factor: StaticFactor,
    singular: &'static str,
    plural: &'static str,
) -> UnitRow {
    UnitRow { symbol, aliases, dimension, factor, prefixes: false, attached: false, singular, plural }
}

const NUMBER: Dimension = Dimension::NONE;
const MASS: Dimension = Dimension::MASS;
const LENGTH: Dimension = Dimension::LENGTH;
const TIME: Dimension = Dimension::TIME;
const VOLUME: Dimension = Dimension::new(0, 3, 0);
const SPEED: Dimension = Dimension::VELOCITY;
const FREQUENCY: Dimension = Dimension::new(0, 0, -1);
const FORCE: Dimension = Dimension::FORCE;
const ENERGY: Dimension = Dimension::ENERGY;
const POWER: Dimension = Dimension::new(1, 2, -3);
const PRESSURE: Dimension = Dimension::new(1, -1, -2);

const UNITY: StaticFactor = StaticFactor::integer(1);
const MINUTE: StaticFactor = StaticFactor::integer(60);
const HOUR: StaticFactor = StaticFactor::integer(3600);
const DAY: StaticFactor = StaticFactor::integer(86_400);
const INCH: StaticFactor = StaticFactor::decimal(254, 4);
const FOOT: StaticFactor = StaticFactor::integer(12).times(INCH);
const MILE: StaticFactor = StaticFactor::integer(5280).times(FOOT);
const STANDARD_GRAVITY: StaticFactor = StaticFactor::decimal(980_665, 5);
const POUND_MASS: StaticFactor = StaticFactor::decimal(45_359_237, 8);
const POUND: StaticFactor = POUND_MASS.times(STANDARD_GRAVITY);
const SIXTEENTH: StaticFactor = UNITY.over(StaticFactor::integer(16));
const REVOLUTION: StaticFactor = StaticFactor::integer(2).times(StaticFactor::PI);

/// The gram; with `kilo`, the SI's unit of mass.
pub(super) const GRAM: UnitRow = row("g", &[], MASS, StaticFactor::decimal(1, 3), "gram", "grams").prefixed();
/// The metre.
pub(super) const METRE: UnitRow = row("m", &["meter", "meters"], LENGTH, UNITY, "metre", "metres").prefixed();
/// The second.
pub(super) const SECOND: UnitRow = row("s", &["sec", "secs"], TIME, UNITY, "second", "seconds").prefixed();
/// The slug, which a force of one pound accelerates at one foot per second squared.
pub(super) const SLUG: UnitRow = row("slug", &[], MASS, POUND.over(FOOT), "slug", "slugs");
/// The foot.
pub(super) const FOOT_UNIT: UnitRow = row("ft", &[], LENGTH, FOOT, "foot", "feet");
/// The radian.
pub(super) const RADIAN: UnitRow = row("rad", &["rads"], NUMBER, UNITY, "radian", "radians");
/// The degree.
pub(super) const DEGREE: UnitRow = row(
    "°",
    &["deg", "degs", "º", "˚"],
    NUMBER,
    StaticFactor::PI.over(StaticFactor::integer(180)),
    "degree",
    "degrees",
)
.attached();
/// The revolution.
pub(super) const REVOLUTION_UNIT: UnitRow =
    row("rev", &["revs", "turn", "turns"], NUMBER, REVOLUTION, "revolution", "revolutions");

/// Every unit that has a symbol of its own.
#[rustfmt::skip] // a table is read by its columns
pub(super) static UNITS: &[UnitRow] = &[
    GRAM,
    row("t",    &["tonne", "tonnes", "metric ton", "metric tons"],    MASS,      StaticFactor::integer(1000),                  "tonne", "tonnes"),
    SLUG,
    row("lbm",  &[],                       MASS,      POUND_MASS,                                   "pound-mass", "pounds-mass"),
    row("ozm",  &[],                       MASS,      POUND_MASS.times(SIXTEENTH),                  "ounce-mass", "ounces-mass"),
    METRE,
    row("in",   &[],                       LENGTH,    INCH,                                         "inch", "inches"),
    FOOT_UNIT,
    row("yd",   &[],                       LENGTH,    StaticFactor::integer(3).times(FOOT),         "yard", "yards"),
    row("mi",   &[],                       LENGTH,    MILE,                                         "mile", "miles"),
    row("nmi",  &[],                       LENGTH,    StaticFactor::integer(1852),                  "nautical mile", "nautical miles"),
    row("AU",   &["au", "ua"],             LENGTH,    StaticFactor::integer(149_597_870_700),       "astronomical unit", "astronomical units"),
    row("ly",   &[],                       LENGTH,    StaticFactor::integer(9_460_730_472_580_800), "light-year", "light-years"),
    row("L",    &["l", "liter", "liters"], VOLUME,    StaticFactor::decimal(1, 3),                  "litre", "litres").prefixed(),
    row("gal",  &[],                       VOLUME,    StaticFactor::integer(231).times(INCH).times(INCH).times(INCH), "gallon", "gallons"),
    SECOND,
    row("min",  &["mins"],                 TIME,      MINUTE,                                       "minute", "minutes"),
    row("h",    &["hr", "hrs"],            TIME,      HOUR,                                         "hour", "hours"),
    row("day",  &["d"],                    TIME,      DAY,                                          "day", "days"),
    row("wk",   &[],                       TIME,      StaticFactor::integer(7).times(DAY),          "week", "weeks"),
    row("yr",   &["yrs"],                  TIME,      StaticFactor::decimal(36_525, 2).times(DAY),  "year", "years"),
    row("mph",  &[],                       SPEED,     MILE.over(HOUR),                              "mile per hour", "miles per hour"),
    row("kt",   &["kts", "kn"],                 SPEED,     StaticFactor::integer(1852).over(HOUR),       "knot", "knots"),
    row("Hz",   &[],                       FREQUENCY, UNITY,                                        "hertz", "hertz").prefixed(),
    row("rpm",  &["RPM"],                  FREQUENCY, REVOLUTION.over(MINUTE),                      "revolution per minute", "revolutions per minute"),
    RADIAN,
    // No other prefix is in use, and `Grad` is a degree in German.
    row("mrad", &[],                       NUMBER,    StaticFactor::decimal(1, 3),                  "milliradian", "milliradians"),
    row("µrad", &["urad", "μrad"],         NUMBER,    StaticFactor::decimal(1, 6),                  "microradian", "microradians"),
    DEGREE,
    REVOLUTION_UNIT,
    row("%",    &["percent", "pct"],       NUMBER,    StaticFactor::decimal(1, 2),                  "per cent", "per cent").attached(),
    row("N",    &[],                       FORCE,     UNITY,                                        "newton", "newtons").prefixed(),
    row("dyn",  &[],                       FORCE,     StaticFactor::decimal(1, 5),                  "dyne", "dynes").prefixed(),
    row("kgf",  &["kp"],                   FORCE,     STANDARD_GRAVITY,                             "kilogram-force", "kilograms-force"),
    row("lb",   &["lbf", "lbs"],           FORCE,     POUND,                                        "pound", "pounds"),
    row("oz",   &["ozf"],                  FORCE,     POUND.times(SIXTEENTH),                       "ounce", "ounces"),
    row("kip",  &[],                       FORCE,     StaticFactor::integer(1000).times(POUND),     "kip", "kips"),
    row("ton",  &[],                       FORCE,     StaticFactor::integer(2000).times(POUND),     "short ton", "short tons"),
    row("J",    &[],                       ENERGY,    UNITY,                                        "joule", "joules").prefixed(),
    row("eV",   &[],                       ENERGY,    StaticFactor::decimal(1_602_176_634, 28),     "electronvolt", "electronvolts").prefixed(),
    row("erg",  &[],                       ENERGY,    StaticFactor::decimal(1, 7),                  "erg", "ergs").prefixed(),
    row("cal",  &[],                       ENERGY,    StaticFactor::decimal(4184, 3),               "calorie", "calories").prefixed(),
    row("Btu",  &["BTU"],                  ENERGY,    StaticFactor::decimal(105_505_585_262, 8),    "British thermal unit", "British thermal units"),
    row("W",    &[],                       POWER,     UNITY,                                        "watt", "watts").prefixed(),
    row("hp",   &[],                       POWER,     StaticFactor::integer(550).times(FOOT).times(POUND), "horsepower", "horsepower"),
    row("Pa",   &[],                       PRESSURE,  UNITY,                                        "pascal", "pascals").prefixed(),
    row("bar",  &[],                       PRESSURE,  StaticFactor::integer(100_000),               "bar", "bars").prefixed(),
    row("atm",  &[],                       PRESSURE,  StaticFactor::integer(101_325),               "standard atmosphere", "standard atmospheres"),
    row("psi",  &[],                       PRESSURE,  POUND.over(INCH).over(INCH),                  "pound per square inch", "pounds per square inch"),
];

/// Units of force and the units of mass that have this weight.
pub(super) static UNITS_OF_WEIGHT_AND_MASS: &[(&str, &str)] = &[("lb", "lbm"), ("oz", "ozm"), ("kgf", "kg")];

/// Words that stand for a product of units, and usual slips of the pen that have only one meaning.
pub(super) static SPELLINGS: &[(&str, &str)] = &[
    ("Ns", "N s"),
    ("Nm", "N m"),
    ("Nms", "N m s"),
    ("kNs", "kN s"),
    ("kNm", "kN m"),
    ("MNm", "MN m"),
    ("mNs", "mN s"),
    ("MNs", "MN s"),
    ("cNs", "cN s"),
    ("µNs", "µN s"),
    ("μNs", "µN s"),
    ("uNs", "µN s"),
    ("mNm", "mN m"),
    ("cNm", "cN m"),
    ("µNm", "µN m"),
    ("μNm", "µN m"),
    ("uNm", "µN m"),
    ("Js", "J s"),
    ("Ws", "W s"),
    ("Wh", "W h"),
    ("Nsec", "N s"),
    ("newtonsecond", "N s"),
    ("newtonseconds", "N s"),
    ("newtonmeter", "N m"),
    ("newtonmeters", "N m"),
    ("newtonmetre", "N m"),
    ("newtonmetres", "N m"),
    ("kWh", "kW h"),
    ("MWh", "MW h"),
    ("mWh", "mW h"),
    ("gm", "g"),
    ("gms", "g"),
    ("kgm", "kg m"),
    ("kgms", "kg m s"),
    ("ftlb", "ft lb"),
    ("ftlbf", "ft lb"),
    ("ftlbs", "ft lb"),
    ("lbft", "lb ft"),
    ("inlb", "in lb"),
    ("kph", "km/h"),
    ("kmh", "km/h"),
    ("kmph", "km/h"),
    ("mps", "m/s"),
    ("fps", "ft/s"),
    ("Kg", "kg"),
    ("KG", "kg"),
    ("kgs", "kg"),
    ("kilo", "kg"),
    ("kilos", "kg"),
    ("kms", "km"),
    ("cms", "cm"),
    ("cc", "cm^3"),
    ("ml", "mL"),
];

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test may panic
mod tests {
    use super::*;
    use crate::Quantity;

    #[rustfmt::skip]
    const EQUAL: &[(&str, &str)] = &[
        ("1 kg", "1000 g"), ("1 t", "1 Mg"), ("1 slug", "1 lb s^2/ft"), ("1 lbm", "0.45359237 kg"), ("16 ozm", "1 lbm"),
        ("1 km", "1000 m"), ("1 in", "25.4 mm"), ("1 ft", "0.3048 m"), ("1 yd", "3 ft"), ("1 mi", "1609.344 m"),
        ("1 nmi", "1852 m"), ("1 AU", "149597870.7 km"), ("1 ly", "299792458 m yr/s"), ("1 L", "1 dm^3"), ("1 gal", "3.785411784 L"),
        ("1 s", "1000000 us"), ("1 min", "60 s"), ("1 h", "3600 s"), ("1 day", "24 h"), ("1 wk", "168 h"), ("4 yr", "1461 day"),
        ("60 mph", "88 ft/s"), ("1 kt", "1 nmi/h"), ("1 Hz", "1 1/s"), ("60 rpm", "1 rev/s"),
        ("1 rad", "1"), ("360 °", "1 rev"), ("1000 mrad", "1 rad"), ("1000 µrad", "1 mrad"), ("5 %", "0.05"),
        ("1 kN", "1000 kg m/s^2"), ("1 dyn", "1 g cm/s^2"), ("1 kgf", "9.80665 N"), ("1 lb", "4.4482216152605 N"),
        ("16 oz", "1 lb"), ("1 kip", "1000 lb"), ("1 ton", "2 kip"),
        ("1 J", "1 N m"), ("1 eV", "1.602176634e-19 J"), ("1 erg", "1 dyn cm"), ("1 cal", "4.184 J"), ("1 Btu", "1055.05585262 J"),
        ("1 W", "1 J/s"), ("1 hp", "550 ft lb/s"), ("1 Pa", "1 N/m^2"), ("1 bar", "100 kPa"), ("1 atm", "1.01325 bar"), ("1 psi", "1 lb/in^2"),
        ("1 cm", "0.01 m"), ("1 nm", "1e-9 m"), ("1 GJ", "1e9 J"), ("1 hPa", "100 Pa"), ("1 THz", "1e12 Hz"), ("1 ps", "1e-12 s"), ("1 PJ", "1e15 J"), ("1 fs", "1e-15 s"),
    ];

    #[test]
    fn definitions_check_each_other() {
        for (left, right) in EQUAL {
            let [left, right] = [left, right].map(|text| Quantity::parse(text).unwrap());
            assert_eq!((left.si(), left.unit.dimension()), (right.si(), right.unit.dimension()), "{left} = {right}");
        }
        for unit in UNITS {
            let named = |text: &str| text.split([' ', '/']).any(|word| word == unit.symbol);
            assert!(EQUAL.iter().any(|(left, right)| named(left) || named(right)), "{} is not checked", unit.symbol);
        }
    }
}
