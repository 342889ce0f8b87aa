//! A value, however it is written, is read as that value or asked back, and never read as another.

use momentous::grade::{Answer, DecimalMark, ExpectedKind, ExpectedNumber, ExpectedVector, Frame, FrameAxis, read};
use momentous::quantity::{Decimal, Rational, Unit};
use proptest::prelude::*;

const MARKS: [DecimalMark; 3] = [DecimalMark::Either, DecimalMark::Point, DecimalMark::Comma];

/// A number to be written: its sign, the digits before the point, and those behind it.
#[derive(Clone, Debug)]
struct Digits {
    minus: bool,
    whole: u32,
    decimals: String,
}

impl Digits {
    fn plain(&self) -> String {
        let sign = if self.minus { "-" } else { "" };
        let point = if self.decimals.is_empty() { "" } else { "." };
        format!("{sign}{}{point}{}", self.whole, self.decimals)
    }

    fn value(&self) -> Rational {
        Decimal::parse(&self.plain()).unwrap().to_rational()
    }

    /// The digits before the point in groups of three.
    fn grouped(&self, by: &str) -> String {
        let digits = self.whole.to_string();
        let mut groups: Vec<&str> = Vec::new();
        let mut end = digits.len();
        while end > 3 {
            groups.push(&digits[end - 3..end]);
            end -= 3;
        }
        groups.push(&digits[..end]);
        groups.reverse();
        let sign = if self.minus { "-" } else { "" };
        format!("{sign}{}", groups.join(by))
    }

    /// The mantissa and the power of ten.
    fn scientific(&self) -> (String, usize) {
        let digits = self.whole.to_string();
        let sign = if self.minus { "-" } else { "" };
        (format!("{sign}{}.{}{}", &digits[..1], &digits[1..], self.decimals), digits.len() - 1)
    }

    /// Ways to write it.
    fn forms(&self) -> Vec<String> {
        let plain = self.plain();
        let (mantissa, power) = self.scientific();
        let behind =
            |mark: &str| if self.decimals.is_empty() { String::new() } else { format!("{mark}{}", self.decimals) };
        let unsigned = plain.trim_start_matches('-');
        let mut forms = vec![
            plain.clone(),
            plain.replace('-', "\u{2212}"),
            plain.replace('-', "- "),
            plain.replace('-', "minus "),
            plain.replace('.', ","),
            format!("({plain})"),
            format!("{}{}", self.grouped(" "), behind(".")),
            format!("{}{}", self.grouped("\u{202f}"), behind(",")),
            format!("{}{}", self.grouped("'"), behind(".")),
            format!("{}{}", self.grouped(","), behind(".")),
            format!("{mantissa}e{power}"),
            format!("{mantissa} e{power}"),
            format!("{mantissa}E+{power}"),
            format!("{mantissa}x10^{power}"),
            format!("{mantissa} × 10^{power}"),
            format!("{mantissa}*10**{power}"),
            format!("{mantissa}·10^{{{power}}}"),
            format!(r"{mantissa}\times 10^{{{power}}}"),
            format!(r"{mantissa} \cdot 10^{power}"),
            format!("{plain} + 0"),
            format!("2*{plain}/2"),
            format!(r"\frac{{{plain}}}{{1}}"),
        ];
        // One point alone begins the decimals.
        if self.whole >= 1_000_000 || !self.decimals.is_empty() {
            forms.push(format!("{}{}", self.grouped("."), behind(",")));
        }
        if self.minus {
            forms.push(format!("-1*{unsigned}"));
        } else {
            forms.push(format!("+{plain}"));
            forms.push(format!("{}{} - 1", self.whole + 1, behind(".")));
        }
        forms
    }
}

fn digits() -> impl Strategy<Value = Digits> {
    let whole = prop_oneof![1..10_u32, 10..1000_u32, 1000..10_000_000_u32];
    (any::<bool>(), whole, "[0-9]{0,4}").prop_map(|(minus, whole, decimals)| Digits { minus, whole, decimals })
}

/// Units of a velocity as they are written, and how many metres per second each is: above and below the bar.
const UNITS: [(&str, u32, u32); 12] = [
    ("m/s", 1, 1),
    ("m s^-1", 1, 1),
    ("ms^-1", 1, 1),
    ("ms⁻¹", 1, 1),
    ("M/S", 1, 1),
    ("Metres per second", 1, 1),
    ("m/s (m s^-1)", 1, 1),
    (r"\mathrm{m}/\mathrm{s}", 1, 1),
    (r"\frac{m}{s}", 1, 1),
    ("km/h", 5, 18),
    ("KM/H", 5, 18),
    ("kmh^-1", 5, 18),
];
const BEFORE: [&str; 7] = ["", "= ", "v = ", "v_A2=", "about ", "the answer is ", "~"];
const BEHIND: [&str; 6] = ["", ".", "!", " (2 s.f.)", " approx.", " "];

fn velocity() -> ExpectedKind {
    ExpectedKind::Number(ExpectedNumber::new(1.0, Unit::parse("m/s").unwrap()))
}

/// What an answer means in metres per second.
fn meant(text: &str, mark: DecimalMark) -> Option<Rational> {
    let Ok(Answer::Number(answer)) = read(text, &velocity(), mark) else { return None };
    let factor = answer.unit.clone().unwrap_or_default().factor();
    Some(answer.directed().scaled(&factor).unwrap().value().into_owned())
}

proptest! {
    #[test]
    fn a_value_is_read_as_itself_or_asked_back(
        digits in digits(),
        unit in 0..UNITS.len(),
        before in 0..BEFORE.len(),
        behind in 0..BEHIND.len(),
    ) {
        let (written, above, below) = UNITS[unit];
        let value = digits.value() * Rational::from(above) / Rational::from(below);
        let mut read_as_itself = 0;
        for form in digits.forms() {
            let text = format!("{}{form} {written}{}", BEFORE[before], BEHIND[behind]);
            for mark in MARKS {
                // With a decimal comma a point groups thousands, and a comma does not, as the student was told.
                if let Some(found) = meant(&text, mark) {
                    let grouped = mark == DecimalMark::Comma && form.contains(['.', ',']);
                    prop_assert!(found == value || grouped, "{text} ({mark:?}): {found}, not {value}");
                    read_as_itself += usize::from(found == value);
                }
            }
        }
        prop_assert!(read_as_itself >= 20, "{digits:?} in {written}: only {read_as_itself} readings");
    }

    #[test]
    fn what_has_two_readings_is_asked_back(one in digits(), other in 1..99_u32, unit in 0..UNITS.len()) {
        let (written, ..) = UNITS[unit];
        let positive = Digits { minus: false, ..one };
        let (mantissa, _) = positive.scientific();
        let mantissa = mantissa.trim_end_matches('.');
        let size = positive.plain();
        for text in [
            format!("{mantissa} × 10{other} {written}"),
            format!("{mantissa}*10{other} {written}"),
            format!("{mantissa}x10{other} {written}"),
            format!("{mantissa}x10-{other} {written}"),
            format!("{}.10^{other} {written}", positive.whole),
            format!("{}·{other} {written}", positive.whole),
            format!("{size}-{other} {written}"),
            format!("{size}\u{2013}{other} {written}"),
            format!("{size}±{other} {written}"),
            format!("{size} +- {other} {written}"),
            format!("{size} +/- {other} {written}"),
            format!("{size} {other} {written}"),
            format!("{size} * {written} *"),
            format!("{size} {written} {other}"),
            format!("{size}h{other:02}"),
        ] {
            for mark in MARKS {
                prop_assert!(meant(&text, mark).is_none(), "{text} ({mark:?}) is {:?}", meant(&text, mark));
            }
        }
    }

    #[test]
    fn a_vector_is_read_as_itself_or_asked_back(x in digits(), y in digits()) {
        let axis = |letter, plus: &str, minus: &str| FrameAxis { letter, senses: [plus.to_owned(), minus.to_owned()] };
        let frame = Frame { axes: vec![axis('x', "east", "west"), axis('y', "north", "south")] };
        let unit = Unit::parse("m/s").unwrap();
        let components = vec![ExpectedNumber::new(1.0, unit.clone()), ExpectedNumber::new(1.0, unit)];
        let asked = ExpectedKind::Vector(ExpectedVector { components, frame });
        let (a, b) = (x.plain(), y.plain());
        let plus = if y.minus { "-" } else { "+" };
        let side = |digits: &Digits, plus, minus| if digits.minus { minus } else { plus };
        let [to_x, to_y] = [side(&x, "east", "west"), side(&y, "north", "south")];
        let [size_x, size_y] = [&a, &b].map(|own| own.trim_start_matches('-').to_owned());
        for text in [
            format!("({a}, {b}) m/s"),
            format!("({a}; {b}) m/s"),
            format!("[{a} {b}] m/s"),
            format!("{a}, {b} m/s"),
            format!("{a} m/s, {b} m/s"),
            format!("{a}i {plus} {size_y}j m/s"),
            format!("{a} î {plus} {size_y} ĵ m/s"),
            format!("({a} m/s)i + ({b} m/s)j"),
            format!(r"{a}\vec{{i}} {plus} {size_y}\vec{{j}} m/s"),
            format!("vx = {a} m/s, vy = {b} m/s"),
            format!("{size_x} m/s {to_x}, {size_y} m/s {to_y}"),
            format!("{size_x} m/s {to_x} and {size_y} m/s {to_y}"),
            format!("{size_x} {to_x} {size_y} {to_y}"),
            format!("{size_x} {} {size_y} {}", &to_x[..1].to_uppercase(), &to_y[..1].to_uppercase()),
            format!(r"\begin{{pmatrix}} {a} \\ {b} \end{{pmatrix}} m/s"),
        ] {
            if let Ok(Answer::Vector(answer)) = read(&text, &asked, DecimalMark::Point) {
                let found: Vec<Rational> = answer.components.iter().map(|own| own.value().into_owned()).collect();
                prop_assert_eq!(found, vec![x.value(), y.value()], "{}", text);
            }
        }
        for text in [format!("{size_x} + {size_y}j m/s"), format!("({size_x}, {size_y}°)"), format!("{size_x} m/s {size_y}° from north")] {
            prop_assert!(read(&text, &asked, DecimalMark::Point).is_err(), "{text}");
        }
    }
}
