//! How long worked solutions are: a part that is asked takes a few lines and words, as in a textbook.

use momentous::exercise::Exercise;
use momentous::explain::{Audience, Detail};
use momentous::render::{Figures, Format, Renderer, Solution};

use crate::problems;

/// Rows with an equals sign, and words, captions and lists included.
#[derive(Clone, Copy, Debug)]
struct Length {
    lines: f64,
    words: f64,
}

/// The most that a solution takes for each part: the median of the bank, and the longest one.
const FOR_A_PART: [Length; 2] = [Length { lines: 6.0, words: 90.0 }, Length { lines: 16.0, words: 200.0 }];

/// The most that a whole solution takes in the median of the bank.
const WHOLE: Length = Length { lines: 12.0, words: 150.0 };

fn length(markdown: &str) -> Length {
    let (mut lines, mut words, mut is_equation) = (0, 0, false);
    for line in markdown.lines().filter(|line| !line.starts_with(['#', '<']) && !line.contains(" · digest ")) {
        match line {
            "$$" => is_equation = !is_equation,
            _ if is_equation => lines += usize::from(line.contains('=')),
            _ => {
                let caption = line.split("](").next().unwrap_or_default();
                let prose = caption.split('$').step_by(2).flat_map(str::split_whitespace);
                words += prose.filter(|word| word.contains(char::is_alphabetic)).count();
            }
        }
    }
    #[allow(clippy::cast_precision_loss, reason = "a page has few lines")]
    Length { lines: lines as f64, words: words as f64 }
}

fn solution(exercise: &Exercise, renderer: &Renderer) -> Length {
    let audience = Audience::Everyone;
    let outline = exercise.outline(audience, Detail::Short);
    let solution = Solution { outline, identity: exercise.identity(), audience, faded: None };
    length(&renderer.render_solution(&solution, Format::Markdown).unwrap().text)
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

#[test]
fn words_and_lines_are_counted() {
    let page = "# Title\n\n![The impact.](figure-1.svg)\n\nFrom $a = b$ and (2):\n\n$$\na = b = 3 \\\\\n & = c\n$$\n";
    let Length { lines, words } = length(page);
    assert_eq!(format!("{lines} {words}"), "2 4");
}

#[test]
fn solutions_are_as_short_as_a_textbooks() {
    let renderer = Renderer::new(None).unwrap().figures(Figures::Beside("figure".into()));
    let mut all = Vec::new();
    for exercise in problems::exercises(1) {
        let whole = solution(&exercise, &renderer);
        #[allow(clippy::cast_precision_loss, reason = "a form has few parts")]
        let parts = exercise.worked().form.parts.len() as f64;
        let part = Length { lines: whole.lines / parts, words: whole.words / parts };
        all.push((problems::name(&exercise), whole, part));
    }
    let median_of = |measure: &dyn Fn(&(String, Length, Length)) -> f64| median(all.iter().map(measure).collect());
    let [lines, words] = [median_of(&|row| row.2.lines), median_of(&|row| row.2.words)];
    let [whole_lines, whole_words] = [median_of(&|row| row.1.lines), median_of(&|row| row.1.words)];
    println!("{} solutions", all.len());
    println!("for each part, median: {lines:.1} lines, {words:.0} words");
    println!("whole, median: {whole_lines:.1} lines, {whole_words:.0} words");
    let most_of = |measure: &dyn Fn(&(String, Length, Length)) -> f64| all.iter().map(measure).fold(0.0, f64::max);
    println!("for a part, at most: {:.1} lines, {:.0} words", most_of(&|row| row.2.lines), most_of(&|row| row.2.words));
    let mut longest: Vec<&(String, Length, Length)> = all.iter().collect();
    longest.sort_by(|one, other| other.2.words.total_cmp(&one.2.words));
    for (name, whole, part) in &longest[..10] {
        println!(
            "{name}: {:.0} lines, {:.0} words for a part, {} and {} in all",
            part.lines, part.words, whole.lines, whole.words
        );
    }
    let [usual, most] = FOR_A_PART;
    assert!(lines <= usual.lines && words <= usual.words && whole_lines <= WHOLE.lines && whole_words <= WHOLE.words);
    let is_longer = |row: &&(String, Length, Length)| row.2.lines > most.lines || row.2.words > most.words;
    let longer: Vec<&str> = all.iter().filter(is_longer).map(|row| row.0.as_str()).collect();
    assert!(longer.is_empty(), "{longer:?}");
}
