//! Roots between bounds: a sign change is found from zero upwards and narrowed down.

use super::super::number::real::{Real, Sign};

/// Octaves that are scanned, as exponents of two: from about 1e-9 to 1e12 in base units.
const OCTAVES: std::ops::RangeInclusive<i32> = -30..=40;
/// Points in each octave.
const POINTS: i32 = 16;
/// The number of times that a bracket is narrowed; Illinois steps need far fewer.
const NARROWINGS: usize = 400;
/// Every so many narrowings the bracket is halved, whatever the secant says.
const HALVING: usize = 8;

/// Behind a root, the next one is sought up to so many times its size.
const FARTHEST: f64 = 1024.0;

/// The first root of a function between two limits, zero itself not counted. The bound of the result covers an interval at whose
/// ends the function surely has opposite signs.
/// `None` where the scan meets no such root. Two roots closer together than a scan's step may both be missed.
pub(super) fn next_root<R: Real>([least, most]: [f64; 2], mut function: impl FnMut(&R) -> R) -> Option<R> {
    let is_first = least <= 0.0;
    let most = if is_first { most } else { most.min(FARTHEST * least) };
    let mut earlier: Option<Point<R>> = is_first.then(|| Point::at(R::point(0.0), &mut function));
    let places = OCTAVES.flat_map(|octave| (0..POINTS).map(move |part| (octave, part)));
    let places =
        places.map(|(octave, part)| libm::exp2(f64::from(octave)) * (1.0 + f64::from(part) / f64::from(POINTS)));
    for x in places.filter(|x| *x > least) {
        let here = Point::at(R::point(x), &mut function);
        let root_here = match (earlier.as_ref().map(Point::sign), here.sign()) {
            (_, Sign::Zero) => Some(here.x.clone()),
            (Some(before), after) if opposite(before, after) => {
                earlier.clone().and_then(|earlier| narrow(earlier, here.clone(), &mut function))
            }
            _ => None,
        };
        if let Some(root) = root_here {
            return Some(root).filter(|root| root.rough() <= most);
        }
        if x > most {
            return None;
        }
        earlier = match here.sign() {
            Sign::Negative | Sign::Positive => Some(here),
            Sign::Unsure => earlier,
            Sign::Zero | Sign::NotReal => None,
        };
    }
    None
}

/// A place and the function's value there.
#[derive(Clone)]
struct Point<R> {
    x: R,
    y: R,
}

impl<R: Real> Point<R> {
    fn at(x: R, function: &mut impl FnMut(&R) -> R) -> Self {
        let y = function(&x);
        Self { x, y }
    }

    fn sign(&self) -> Sign {
        self.y.sign()
    }
}

fn opposite(one: Sign, other: Sign) -> bool {
    matches!((one, other), (Sign::Negative, Sign::Positive) | (Sign::Positive, Sign::Negative))
}

/// The Illinois method: secants, with the value at an end that stays twice halved (Dowell and Jarratt, 1971).
/// `None` where the sign changes at a pole or where the function has no value.
fn narrow<R: Real>(mut low: Point<R>, mut high: Point<R>, function: &mut impl FnMut(&R) -> R) -> Option<R> {
    let (low_sign, high_sign) = (low.sign(), high.sign());
    let start = low.y.rough().abs().max(high.y.rough().abs());
    let half = R::point(0.5);
    let (mut low_weight, mut high_weight) = (low.y.clone(), high.y.clone());
    let mut stayed = None;
    for round in 1..=NARROWINGS {
        let width = high.x.rough() - low.x.rough();
        let tight = high.x.sub(&low.x).rough().abs() <= 4.0 * R::SPACING * high.x.rough().abs();
        if tight && width >= 0.0 {
            break;
        }
        let middle = low.x.add(&high.x).mul(&half).centre();
        let slope = high_weight.sub(&low_weight).centre();
        let secant = low.x.sub(&low_weight.centre().mul(&high.x.sub(&low.x)).div(&slope)).centre();
        let inside = secant.sub(&low.x).sign() == Sign::Positive && high.x.sub(&secant).sign() == Sign::Positive;
        let x = if inside && round % HALVING != 0 { secant } else { middle };
        let here = Point::at(x, function);
        match here.sign() {
            Sign::Zero => return Some(here.x),
            Sign::NotReal => return None,
            Sign::Unsure => return Some(around(&here.x, &low, &high, function)),
            sign if sign == low_sign => {
                if stayed == Some(high_sign) {
                    high_weight = high_weight.mul(&half);
                }
                (stayed, low_weight) = (Some(high_sign), here.y.clone());
                low = here;
            }
            _ => {
                if stayed == Some(low_sign) {
                    low_weight = low_weight.mul(&half);
                }
                (stayed, high_weight) = (Some(low_sign), here.y.clone());
                high = here;
            }
        }
    }
    let continuous = low.y.rough().abs().min(high.y.rough().abs()) <= start;
    continuous.then(|| low.x.hull(&high.x))
}

/// The smallest interval found around `x` at whose ends the signs are sure.
fn around<R: Real>(x: &R, low: &Point<R>, high: &Point<R>, function: &mut impl FnMut(&R) -> R) -> R {
    let (grow, start) = (R::point(8.0), R::point(8.0 * R::SPACING).mul(&R::point(x.rough())).centre());
    let mut end = |limit: &Point<R>, step: &dyn Fn(&R) -> R, is_inside: &dyn Fn(&R) -> bool| {
        let mut reach = start.clone();
        loop {
            let end = step(&reach).centre();
            if !is_inside(&end) {
                return limit.x.clone();
            }
            if function(&end).sign() == limit.sign() {
                return end;
            }
            reach = reach.mul(&grow).centre();
        }
    };
    let below = end(low, &|reach| x.sub(reach), &|below| below.sub(&low.x).sign() == Sign::Positive);
    let above = end(high, &|reach| x.add(reach), &|above| high.x.sub(above).sign() == Sign::Positive);
    below.hull(&above)
}
