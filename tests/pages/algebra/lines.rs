//! The lines of a solution, and whether each follows from those that it names by what it says was done.

use std::collections::BTreeSet;

use serde_json::Value;

use super::points::Points;
use super::term::{Sized, Term, Values};
use super::typed;

/// One line of the JSON of a solution.
pub struct Line {
    pub number: Option<u64>,
    pub left: Term,
    pub relation: String,
    pub right: Option<Term>,
    pub operation: String,
    pub from: Vec<usize>,
    pub factor: Option<Term>,
    pub not_zero: Vec<Term>,
    text: String,
}

impl Line {
    fn read(json: &Value) -> Result<Self, String> {
        let term = |text: &Value| text.as_str().map(typed::read).transpose();
        let line = Self {
            number: json["number"].as_u64(),
            left: term(&json["left"])?.ok_or("no left side")?,
            relation: json["relation"].as_str().unwrap_or_default().to_owned(),
            right: term(&json["right"])?,
            operation: json["operation"].as_str().unwrap_or_default().to_owned(),
            from: json["from"].as_array().into_iter().flatten().filter_map(Value::as_u64).map(|n| n as usize).collect(),
            factor: term(&json["factor"])?,
            not_zero: json["not_zero"]
                .as_array()
                .into_iter()
                .flatten()
                .filter_map(|t| term(t).transpose())
                .collect::<Result<_, _>>()?,
            text: json.to_string(),
        };
        Ok(line)
    }

    /// The left side less the right one.
    fn difference(&self, values: &Values) -> Sized {
        self.left.value(values).minus(self.right(values))
    }

    fn right(&self, values: &Values) -> Sized {
        self.right.as_ref().map_or(Sized::of(f64::NAN), |right| right.value(values))
    }

    fn sides(&self) -> impl Iterator<Item = &Term> {
        [&self.left].into_iter().chain(&self.right)
    }

    /// The side in which a quantity does not stand.
    fn side_without(&self, quantity: &Term) -> Option<&Term> {
        let Term::Name(name) = quantity else { return None };
        self.sides().find(|side| !side.mentions(name))
    }

    fn mentions(&self, name: &str) -> bool {
        self.sides().any(|side| side.mentions(name))
    }
}

/// Every sentence of a solution that is not true, in words.
pub fn faults(json: &[Value], actual: &Values) -> Vec<String> {
    let mut lines = Vec::new();
    for written in json {
        match Line::read(written) {
            Ok(line) => lines.push(line),
            Err(fault) => return vec![format!("{written}: {fault}")],
        }
    }
    let mut faults = Vec::new();
    for (place, line) in lines.iter().enumerate() {
        let sources: Vec<&Line> =
            line.from.iter().filter_map(|place_before| lines[..place].get(place_before - 1)).collect();
        let named: Vec<String> =
            line.from.iter().map(|number| format!("\n  {number}: {}", lines[number - 1].text)).collect();
        let fault = if sources.len() == line.from.len() {
            check(line, &sources, actual)
        } else {
            Err("names a later line".into())
        };
        if let Err(fault) = fault {
            faults.push(format!("{fault}\n  {}{}", line.text, named.concat()));
        }
    }
    faults.extend(numbering(&lines));
    faults
}

/// The lines that do not hold for the numbers of a variant.
pub fn faults_of_numbers(json: &[Value], actual: &Values) -> Vec<String> {
    let lines = json.iter().map(Line::read);
    let checked = lines.filter_map(|line| line.and_then(|line| holds(&line, actual)).err());
    checked.collect()
}

/// Numbers run from 1, and every derived line that a later one is made from has one.
fn numbering(lines: &[Line]) -> Vec<String> {
    let mut faults = Vec::new();
    let numbers: Vec<u64> = lines.iter().filter_map(|line| line.number).collect();
    if numbers != (1..=numbers.len() as u64).collect::<Vec<_>>() {
        faults.push(format!("the numbers are {numbers:?}"));
    }
    let used: BTreeSet<usize> =
        lines.iter().filter(|line| line.operation != "together").flat_map(|line| line.from.clone()).collect();
    for place in used {
        let line = &lines[place - 1];
        let alone = ["law", "piece"].contains(&line.operation.as_str());
        if line.number.is_none() && !alone {
            faults.push(format!("a derived line that is used has no number: {}", line.text));
        }
    }
    faults
}

fn holds(line: &Line, actual: &Values) -> Result<(), String> {
    if line.relation == "=" && line.right.is_some() && !line.left.value(actual).agrees(line.right(actual)) {
        return Err(format!("does not hold for these numbers: {:?} {:?}", line.left.value(actual), line.right(actual)));
    }
    if let Some(zero) = line.not_zero.iter().find(|term| term.value(actual).value == 0.0) {
        return Err(format!("divides by {zero:?}, which is zero"));
    }
    Ok(())
}

fn check(line: &Line, sources: &[&Line], actual: &Values) -> Result<(), String> {
    holds(line, actual)?;
    let points = || {
        Points::of(
            sources.iter().flat_map(|line_before| line_before.sides()).chain(line.sides()).chain(&line.factor),
            actual,
        )
    };
    let everywhere = |holds: &dyn Fn(&Values) -> Option<bool>| points().all(holds);
    let factor = |values: &Values| line.factor.as_ref().map_or(Sized::of(f64::NAN), |factor| factor.value(values));
    match (line.operation.as_str(), sources) {
        // Of what follows from two equations at once, and from all, the numbers decide.
        ("law" | "together", _) | ("count" | "numeric", [_]) | ("solve", [_, _]) => Ok(()),
        ("magnitude" | "angle", [cosine, sine]) => everywhere(&|values| {
            let [x, y] = [cosine, sine].map(|own| own.side_without(&line.left).map(|side| side.value(values)));
            let (x, y, found) = (x?, y?, line.right(values));
            match line.operation.as_str() {
                "magnitude" => finite(found.times(found), x.times(x).plus(y.times(y))),
                _ => finite(Sized::of(found.value.sin()).times(x), Sized::of(found.value.cos()).times(y)),
            }
        }),
        ("piece", [of]) => Points::only(actual).all(&|values| {
            Some(of.left.value(values).agrees(line.left.value(values)) && of.right(values).agrees(line.right(values)))
        }),
        ("add", [to, times]) => {
            everywhere(&|values| {
                let sum = to.difference(values).plus(factor(values).times(times.difference(values)));
                finite(sum, line.difference(values))
            })?;
            divisors_are_listed(line, sources, actual)
        }
        ("vanish", [of]) => {
            if !factor(actual).agrees(Sized::of(0.0)) && factor(actual).value.abs() > 1e-12 {
                return Err("what is said to be zero is not".into());
            }
            let fixed: Vec<String> = line.factor.iter().flat_map(Term::names).collect();
            everywhere(&|values| {
                let mut values = values.clone();
                values.extend(fixed.iter().filter_map(|name| Some((name.clone(), *actual.get(name)?))));
                finite(of.difference(&values), line.difference(&values))
            })
        }
        ("substitute", [what, into]) => {
            let Term::Name(name) = &what.left else { return Err("what is put in is no quantity".into()) };
            if !into.mentions(name) || line.mentions(name) {
                return Err(format!("{name} is not there, or stays"));
            }
            everywhere(&|values| {
                let mut values = values.clone();
                values.insert(name.clone(), what.right(&values).value);
                Some(
                    finite(into.left.value(&values), line.left.value(&values))?
                        && finite(into.right(&values), line.right(&values))?,
                )
            })
        }
        ("square", [of]) => everywhere(&|values| {
            let [left, right] = [of.left.value(values), of.right(values)];
            Some(finite(left.times(left), line.left.value(values))? && finite(right.times(right), line.right(values))?)
        }),
        ("collect", [of]) => {
            if line.right != Some(Term::Number(0.0)) {
                return Err("the right side is not zero".into());
            }
            everywhere(&|values| finite(factor(values).times(of.difference(values)), line.left.value(values)))
        }
        ("integrate", [of, ends @ ..]) => everywhere(&|values| {
            let mut values = values.clone();
            // What names an end of the range is said by the lines before it.
            for end in ends.iter().rev() {
                let Term::Name(name) = &end.left else { return Some(false) };
                values.insert(name.clone(), end.right(&values).value);
            }
            finite(of.right(&values), line.right(&values))
        }),
        ("solve" | "quadratic", [of]) => {
            let Term::Name(name) = &line.left else { return Err("what is found is no quantity".into()) };
            if line.right.as_ref().is_none_or(|right| right.mentions(name)) {
                return Err(format!("{name} stands on both sides"));
            }
            everywhere(&|values| {
                let mut values = values.clone();
                values.insert(name.clone(), line.right(&values).value);
                finite(of.left.value(&values), of.right(&values))
            })?;
            divisors_are_listed(line, sources, actual)
        }
        ("tangent", [of]) => {
            let angle = match &line.left {
                Term::Call(tangent, angle) if tangent == "tan" => angle.first(),
                _ => None,
            };
            let Some(Term::Name(angle)) = angle else { return Err("what is left is no tangent".into()) };
            everywhere(&|values| {
                let mut values = values.clone();
                values.insert(angle.clone(), line.right(&values).value.atan());
                finite(of.left.value(&values), of.right(&values))
            })?;
            divisors_are_listed(line, sources, actual)
        }
        (other, _) => Err(format!("`{other}` from {} lines is not known", sources.len())),
    }
}

/// Whether two values agree; nothing where one of them is none.
fn finite(left: Sized, right: Sized) -> Option<bool> {
    (left.value.is_finite() && right.value.is_finite()).then(|| left.agrees(right))
}

/// Whatever stands below a bar that did not before is among what is not zero.
fn divisors_are_listed(line: &Line, sources: &[&Line], actual: &Values) -> Result<(), String> {
    let before = sources.iter().flat_map(|line_before| line_before.sides()).flat_map(Term::divisors);
    let known: Vec<Term> = before.chain(line.not_zero.iter().cloned()).collect();
    let new = line.factor.iter().chain(&line.right).flat_map(Term::divisors);
    for divisor in new {
        let found = known.iter().any(|listed| {
            let same = |values: &Values| {
                let [one, other] = [listed.value(values), divisor.value(values)];
                Some(Sized::of(one.value.abs()).agrees(Sized::of(other.value.abs())))
            };
            Points::of([listed, &divisor].into_iter(), actual).all(&same).is_ok()
        });
        if !found {
            return Err(format!("divides by {divisor:?}, which is not listed"));
        }
    }
    Ok(())
}
