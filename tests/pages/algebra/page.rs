//! The page of a worked solution beside its lines: each numbered equation says what its line says, and each sentence before
//! it names the lines and the factor that its line names.

use serde_json::Value;

use super::points::Points;
use super::printed::{self, Names};
use super::term::{Term, Values};
use super::typed;

/// What the page says otherwise than the lines, in words.
pub fn faults(markdown: &str, lines: &[Value], names: &Names, actual: &Values) -> Vec<String> {
    let blocks: Vec<&str> = markdown.split("\n\n").map(str::trim).collect();
    let mut faults = Vec::new();
    let mut numbered = 0;
    for (place, block) in blocks.iter().enumerate() {
        let Some(number) = tag(block) else { continue };
        numbered += 1;
        let Some(line) = lines.iter().find(|line| line["number"] == number) else {
            faults.push(format!("no line has the number {number}"));
            continue;
        };
        let sentence = place.checked_sub(1).map_or("", |before| blocks[before]);
        let found = same_equation(block, line, names, actual)
            .and_then(|()| same_sentence(sentence, line, lines, names, actual));
        faults.extend(found.err().map(|fault| format!("{fault}\n  {sentence}\n  {block}\n  {line}")));
    }
    let all = lines.iter().filter(|line| line["number"].is_u64()).count();
    if numbered != all {
        faults.push(format!("{all} lines have numbers, and {numbered} equations of the page"));
    }
    faults
}

fn tag(block: &str) -> Option<u64> {
    let (_, after) = block.split_once(r"\tag{")?;
    after.split('}').next()?.parse().ok()
}

fn same_equation(block: &str, line: &Value, names: &Names, actual: &Values) -> Result<(), String> {
    // An integral and the pieces of a function are compared as lines only.
    if block.contains(r"\int") || block.contains("cases") {
        return Ok(());
    }
    let mathematics = block.trim_matches('$').trim();
    let printed = printed::equation(mathematics, &of_line(names, line))?;
    for (side, key) in printed.iter().zip(["left", "right"]) {
        same(side, &typed::read(line[key].as_str().unwrap_or_default())?, actual)
            .map_err(|fault| format!("{key}: {fault}"))?;
    }
    Ok(())
}

/// The names that the line itself has come first: a speed and a velocity may share a letter.
fn of_line(names: &Names, line: &Value) -> Names {
    let text = line.to_string();
    let (contained, others): (Names, Names) = names.iter().cloned().partition(|(_, name)| text.contains(name.as_str()));
    contained.into_iter().chain(others).collect()
}

fn same(printed: &Term, typed: &Term, actual: &Values) -> Result<(), String> {
    Points::of([printed, typed].into_iter(), actual).all(&|values| {
        let [printed, typed] = [printed, typed].map(|term| term.value(values));
        (printed.value.is_finite() && typed.value.is_finite()).then(|| printed.agrees(typed))
    })
}

fn same_sentence(sentence: &str, line: &Value, lines: &[Value], names: &Names, actual: &Values) -> Result<(), String> {
    let from: Vec<&Value> = line["from"]
        .as_array()
        .into_iter()
        .flatten()
        .filter_map(|number| lines.get(number.as_u64()? as usize - 1))
        .collect();
    let mut named: Vec<u64> = from.iter().filter_map(|line| line["number"].as_u64()).collect();
    let said: Vec<u64> = sentence.split('(').skip(1).filter_map(|part| part.split_once(')')?.0.parse().ok()).collect();
    let factor = line["factor"].as_str().map(typed::read).transpose()?;
    match line["operation"].as_str().unwrap_or_default() {
        "law" => return Ok(()),
        "add" => {
            named.reverse();
            let sign = if sentence.contains("ubtract ") { -1.0 } else { 1.0 };
            let size = match sentence.split_once(" by $") {
                Some((_, after)) => printed::read(after.split('$').next().unwrap_or_default(), &of_line(names, line))?,
                None => Term::Number(1.0),
            };
            let signed = Term::Product(Box::new(Term::Number(sign)), Box::new(size));
            same(&signed, &factor.ok_or("no factor")?, actual)?;
        }
        "collect" => {
            let said = match sentence.split_once(" by $") {
                Some((_, after)) => printed::read(after.split('$').next().unwrap_or_default(), &of_line(names, line))?,
                None => Term::Number(if sentence.contains("all signs changed") { -1.0 } else { 1.0 }),
            };
            same(&said, &factor.ok_or("no factor")?, actual)?;
        }
        _ => {}
    }
    if said == named { Ok(()) } else { Err(format!("the sentence names {said:?}, the line {named:?}")) }
}
