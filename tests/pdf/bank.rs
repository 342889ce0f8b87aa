//! Every sheet and worked solution of the bank: it is set, and says what the page in HTML says.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use momentous::exercise::Exercise;
use momentous::explain::Audience;
use momentous::explain::Detail;
use momentous::render::{Format, Page, Solution};

use super::{RENDERER, poppler, print, problems};

/// The sides of the text on a page, in points: A4 with margins of 2 cm.
pub const SIDES: [f64; 2] = [56.6, 595.3 - 56.6];
/// What may stand out on either side: a full stop hangs in the margin.
pub const GROSS: f64 = 4.0;

#[test]
fn every_sheet_and_solution_of_the_bank_says_what_the_page_says() {
    if !poppler::is_installed() {
        return;
    }
    let exercises = problems::exercises(2);
    let next = AtomicUsize::new(0);
    let work = || {
        let mut wrong = Vec::new();
        while let Some(exercise) = exercises.get(next.fetch_add(1, Ordering::Relaxed)) {
            for page in pages(exercise) {
                wrong.extend(
                    faults(exercise, &page).into_iter().map(|fault| format!("{}: {fault}", problems::name(exercise))),
                );
            }
        }
        wrong
    };
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let wrong: Vec<String> = thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        workers.into_iter().flat_map(|worker| worker.join().unwrap()).collect()
    });
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The sheet and the solution with all that an instructor sees.
fn pages(exercise: &Exercise) -> [Page; 2] {
    let (outline, identity) = (exercise.outline(Audience::Instructor, Detail::Short), exercise.identity());
    let solution = Solution { outline, identity, audience: Audience::Instructor, faded: None };
    [Page::Sheet(exercise.sheet()), Page::Solution(solution)]
}

fn faults(exercise: &Exercise, page: &Page) -> Vec<String> {
    let pdf = print(std::slice::from_ref(page));
    let html = RENDERER.render(std::slice::from_ref(page), Format::Html).unwrap().text;
    let mut faults = Vec::new();
    let printed: Vec<String> = poppler::pages(&pdf).iter().map(|text| without_foot(text, exercise)).collect();
    let (printed, shown) = (printed.concat(), text_of(&html));
    if signs(&printed) != signs(&shown) {
        faults.push(format!(
            "letters and digits differ: {:?}\n{printed}\n{shown}",
            difference(&signs(&printed), &signs(&shown))
        ));
    }
    let mut written = words(&printed).into_iter();
    let in_lines = match page {
        // The figure of a sheet stands beside its text.
        Page::Sheet(_) => without("figure", &without("svg", &without("math", &html))),
        _ => without("svg", &without("math", &html)),
    };
    if let Some(lost) =
        words(&text_of(&in_lines)).into_iter().find(|word| !written.any(|word_written| word_written == *word))
    {
        faults.push(format!("not in its place: {lost}"));
    }
    for (left, right, word) in poppler::boxes(&pdf) {
        if left < SIDES[0] - GROSS || right > SIDES[1] + GROSS {
            faults.push(format!("stands out of the text: {word}"));
        }
    }
    faults.extend(lonely_headings(&poppler::pages(&pdf), page));
    faults
}

/// Headings that are the last of a page.
fn lonely_headings(pages: &[String], page: &Page) -> Vec<String> {
    let Page::Solution(solution) = page else { return Vec::new() };
    let last = |text: &String| text.lines().rev().nth(1).unwrap_or_default().to_owned();
    let is_heading = |line: &String| {
        solution
            .outline
            .sections
            .iter()
            .any(|section| line.ends_with(&section.heading) && line.starts_with(|sign: char| sign.is_ascii_digit()))
    };
    pages
        .iter()
        .map(last)
        .filter(is_heading)
        .map(|line| format!("a heading alone at the foot of a page: {line}"))
        .collect()
}

/// A page's text without its foot: the identity and the page's number.
fn without_foot(text: &str, exercise: &Exercise) -> String {
    let problem = exercise.identity().problem;
    let kept = text.lines().filter(|line| !(line.starts_with(&problem) && line.contains(" · ")));
    kept.flat_map(|line| [line, "\n"]).collect()
}

/// What a reader of the page sees: the text of its body without the identity, and of its pictures what is drawn.
fn text_of(html: &str) -> String {
    let body = html.split_once("<main>").unwrap().1.split_once("<footer>").unwrap().0;
    let mut text = String::new();
    let mut rest = body;
    while let Some((before, after)) = rest.split_once('<') {
        text.push_str(before);
        let (tag, after) = after.split_once('>').unwrap();
        let name: String = tag.chars().take_while(char::is_ascii_alphanumeric).collect();
        rest = match name.as_str() {
            "title" | "desc" | "style" => after.split_once(&format!("</{name}>")).unwrap().1,
            _ => after,
        };
        // Elements of mathematics stand side by side without a gap, those of text in lines of their own.
        if !(name.starts_with('m')
            || tag.starts_with("/m")
            || matches!(name.as_str(), "tspan" | "strong" | "em" | "span" | "small"))
        {
            text.push(' ');
        }
    }
    let entities = [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&#39;", "'"), ("&nbsp;", " "), ("&amp;", "&")];
    let text = entities.iter().fold(text, |text, (entity, sign)| text.replace(entity, sign));
    unicode_normalization::UnicodeNormalization::nfkc(text.as_str()).collect()
}

/// How often each letter, digit and sign stands in a text.
fn signs(text: &str) -> BTreeMap<char, usize> {
    let mut signs = BTreeMap::new();
    for sign in text.chars().filter(|sign| sign.is_alphanumeric() || "=+−<>≤≥≈≠×±%°".contains(*sign)) {
        *signs.entry(sign).or_default() += 1;
    }
    signs
}

fn difference(counts: &BTreeMap<char, usize>, other: &BTreeMap<char, usize>) -> Vec<(char, usize, usize)> {
    let of = |signs: &BTreeMap<char, usize>, sign: char| signs.get(&sign).copied().unwrap_or_default();
    let all = counts.keys().chain(other.keys().filter(|sign| !counts.contains_key(sign)));
    all.map(|sign| (*sign, of(counts, *sign), of(other, *sign))).filter(|(_, count, other)| count != other).collect()
}

/// A page in HTML without the elements of that name.
fn without(name: &str, html: &str) -> String {
    let (open, close) = (format!("<{name}"), format!("</{name}>"));
    let mut parts = html.split(&open);
    let first = parts.next().unwrap().to_owned();
    parts.fold(first, |kept, part| kept + part.split_once(&close).unwrap().1)
}

/// Words of four letters and more, and numbers with a point, in their order.
fn words(text: &str) -> Vec<String> {
    let parts = text.split(|sign: char| !(sign.is_alphanumeric() || sign == '.'));
    let parts = parts.map(|part| part.trim_matches('.')).filter(|part| part.chars().count() > 3);
    let is_number = |part: &str| part.chars().all(|sign| sign.is_ascii_digit() || sign == '.');
    parts.filter(|part| part.chars().all(char::is_alphabetic) || is_number(part)).map(str::to_owned).collect()
}
