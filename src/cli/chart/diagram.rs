//! Work-precision diagrams as SVG: error against time per solve, both on logarithmic axes, one line a method.

use std::fmt::Write;

use super::points::Row;
use super::tasks::asks;

/// The width of a drawing and the height of one task's panel, in pixels.
const WIDTH: f64 = 820.0;
const PANEL: f64 = 440.0;

/// The axes of a panel: where they begin and end.
const LEFT: f64 = 76.0;
const RIGHT: f64 = 600.0;
const TOP: f64 = 78.0;
const BOTTOM: f64 = 386.0;

/// The heights of the marks for failures, above the axes.
const FAILED: f64 = 60.0;

/// The decades of the errors: what is smaller counts as exact, what is larger is drawn at the edge.
const EXACT: f64 = -17.0;
const LARGEST: f64 = 2.0;

/// Each method with its colour on light and on dark pages and its mark, in the order of the legend.
const LOOKS: &[(&str, &str, &str, Mark)] = &[
    ("closed form", "#111111", "#ffffff", Mark::Star),
    ("linear solve", "#8a5a00", "#e0b050", Mark::Square),
    ("event driven", "#006b4f", "#35c99c", Mark::Diamond),
    ("Runge-Kutta 5(4)", "#0060b0", "#5fb4ff", Mark::Disc),
    ("explicit Euler", "#c02020", "#ff7b72", Mark::Triangle),
    ("symplectic Euler", "#b0449a", "#f08fdc", Mark::Square),
    ("Moreau-Jean", "#b85a00", "#ff9d3c", Mark::Disc),
    ("penalty", "#5f5f70", "#b5b5c8", Mark::Diamond),
    ("sequential impulses", "#6640c0", "#b79cff", Mark::Triangle),
];

#[derive(Clone, Copy)]
enum Mark {
    Disc,
    Square,
    Diamond,
    Triangle,
    Star,
}

/// The diagrams of all tasks in the rows, one below the other.
pub(super) fn svg(rows: &[Row]) -> String {
    let mut tasks: Vec<&str> = Vec::new();
    for row in rows {
        if !tasks.contains(&row.task.as_str()) {
            tasks.push(&row.task);
        }
    }
    let panels: String = tasks.iter().zip(0_u32..).map(|(task, place)| panel(task, place, rows)).collect();
    let height = PANEL * tasks.iter().map(|_| 1.0).sum::<f64>();
    let title = escaped(&tasks.join(", "));
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" viewBox=\"0 0 {WIDTH} {height}\" width=\"{WIDTH}\" \
         height=\"{height}\">\n<title>Error against time per solve: {title}</title>\n<style>\n{}</style>\n\
         <rect class=\"page\" width=\"{WIDTH}\" height=\"{height}\"/>\n{panels}</svg>\n",
        style_sheet()
    )
}

fn style_sheet() -> String {
    let mut light = String::from(
        "text{font:13px system-ui,'DejaVu Sans',sans-serif;fill:#222}\n.page{fill:#fff}\n.grid{stroke:#ddd}\n\
         .axis{stroke:#555;fill:none}\n.m path{stroke-width:1.6;fill:none;stroke-linejoin:round}\n\
         .m .spread{stroke-width:1;opacity:.55}\n.name{font-size:16px;font-weight:600}\n.small{font-size:11px}\n",
    );
    let mut dark = String::from("text{fill:#ddd}\n.page{fill:#15171c}\n.grid{stroke:#33363d}\n.axis{stroke:#aaa}\n");
    for ((_, on_light, on_dark, _), index) in LOOKS.iter().zip(0..) {
        let _ = writeln!(light, ".m{index} *{{stroke:{on_light}}}\n.m{index} .f{{fill:{on_light}}}");
        let _ = writeln!(dark, ".m{index} *{{stroke:{on_dark}}}\n.m{index} .f{{fill:{on_dark}}}");
    }
    format!("{light}@media (prefers-color-scheme:dark){{\n{dark}}}\n")
}

/// The whole decades from the fastest to the slowest solve.
fn decades(rows: &[&Row]) -> (f64, f64) {
    let logs = rows.iter().map(|row| libm::log10(row.seconds));
    let (low, high) = logs.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), log| (low.min(log), high.max(log)));
    let (low, high) = (libm::floor(low).clamp(-12.0, 12.0), libm::ceil(high).clamp(-12.0, 12.0));
    (low, high.max(low + 1.0))
}

fn panel(task: &str, place: u32, rows: &[Row]) -> String {
    let rows: Vec<&Row> = rows.iter().filter(|row| row.task == task).collect();
    let (low, high) = decades(&rows);
    let across = |seconds: f64| {
        let part = (libm::log10(seconds).clamp(low, high) - low) / (high - low);
        LEFT + (RIGHT - LEFT) * part
    };
    let mut out = format!("<g transform=\"translate(0 {})\">\n", PANEL * f64::from(place));
    let what = asks(task).map(|asks| format!(": {asks}")).unwrap_or_default();
    let _ = writeln!(out, "<text class=\"name\" x=\"{LEFT}\" y=\"30\">{}</text>", escaped(&format!("{task}{what}")));
    axes(&mut out, low, high);
    let mut line = TOP + 6.0;
    for ((name, _, _, mark), index) in LOOKS.iter().zip(0..) {
        let own: Vec<&Row> = rows.iter().filter(|row| row.method == *name).copied().collect();
        if own.is_empty() {
            continue;
        }
        let _ = writeln!(out, "<g class=\"m m{index}\">");
        series(&mut out, &own, *mark, &across);
        legend(&mut out, line, name, *mark, &own);
        out.push_str("</g>\n");
        line += 36.0;
    }
    out.push_str("</g>\n");
    out
}

fn height(error: f64) -> f64 {
    let log = if error > 0.0 { libm::log10(error).clamp(EXACT, LARGEST) } else { EXACT };
    BOTTOM - (BOTTOM - TOP) * (log - EXACT) / (LARGEST - EXACT)
}

fn axes(out: &mut String, low: f64, high: f64) {
    let _ = writeln!(
        out,
        "<rect class=\"axis\" x=\"{LEFT}\" y=\"{TOP}\" width=\"{}\" height=\"{}\"/>",
        RIGHT - LEFT,
        BOTTOM - TOP
    );
    for decade in (-17_i32..=2).filter(|decade| decade % 2 == 0 || *decade == -17) {
        let y = height(libm::pow(10.0, f64::from(decade)));
        let text = match decade {
            -17 => "exact".to_owned(),
            0 => "1".to_owned(),
            _ => format!("10<tspan class=\"small\" dy=\"-5\">{}</tspan>", decade.to_string().replace('-', "\u{2212}")),
        };
        // The label of the decade beside `exact` would touch it.
        if decade != -16 {
            let _ = writeln!(out, "<text x=\"{}\" y=\"{:.1}\" text-anchor=\"end\">{text}</text>", LEFT - 8.0, y + 4.0);
        }
        let _ = writeln!(out, "<path class=\"grid\" d=\"M{LEFT} {y:.1}H{RIGHT}\"/>");
    }
    let mut decade = low;
    while decade <= high {
        let x = LEFT + (RIGHT - LEFT) * (decade - low) / (high - low);
        let _ = writeln!(out, "<path class=\"grid\" d=\"M{x:.1} {TOP}V{BOTTOM}\"/>");
        let text = time(decade);
        let _ = writeln!(
            out,
            "<text class=\"small\" x=\"{x:.1}\" y=\"{}\" text-anchor=\"middle\">{text}</text>",
            BOTTOM + 18.0
        );
        decade += 1.0;
    }
    let middle = f64::midpoint(LEFT, RIGHT);
    let _ = writeln!(out, "<text x=\"{middle}\" y=\"{}\" text-anchor=\"middle\">time per solve</text>", BOTTOM + 40.0);
    let turn = f64::midpoint(TOP, BOTTOM);
    let _ = writeln!(
        out,
        "<text transform=\"translate(18 {turn}) rotate(-90)\" text-anchor=\"middle\">relative error</text>\n\
         <text class=\"small\" x=\"{}\" y=\"{}\" text-anchor=\"end\">failures</text>",
        LEFT - 8.0,
        FAILED + 4.0
    );
}

/// A power of ten of seconds as people say it.
fn time(decade: f64) -> String {
    let (base, unit) = match decade {
        decade if decade < -9.0 => (-12.0, "ps"),
        decade if decade < -6.0 => (-9.0, "ns"),
        decade if decade < -3.0 => (-6.0, "µs"),
        decade if decade < 0.0 => (-3.0, "ms"),
        _ => (0.0, "s"),
    };
    format!("{:.0} {unit}", libm::pow(10.0, decade - base))
}

/// The line of the medians, a thin line from each to the greatest error, and the crosses of the failures.
fn series(out: &mut String, rows: &[&Row], mark: Mark, across: &impl Fn(f64) -> f64) {
    let mut way = String::new();
    for row in rows {
        let x = across(row.seconds);
        if row.failures > 0 {
            let _ = writeln!(out, "<path d=\"M{:.1} {:.1}l8 8m0 -8l-8 8\"/>", x - 4.0, FAILED - 4.0);
        }
        let Some(median) = row.median_error else { continue };
        let y = height(median);
        let _ = write!(way, "{}{x:.1} {y:.1}", if way.is_empty() { 'M' } else { 'L' });
        if let Some(greatest) = row.greatest_error.filter(|greatest| *greatest > median) {
            let _ = writeln!(out, "<path class=\"spread\" d=\"M{x:.1} {y:.1}V{:.1}\"/>", height(greatest));
        }
        draw(out, mark, x, y);
    }
    if way.contains('L') {
        let _ = writeln!(out, "<path d=\"{way}\"/>");
    }
}

fn draw(out: &mut String, mark: Mark, x: f64, y: f64) {
    let shape = match mark {
        Mark::Disc => "m-3.2 0a3.2 3.2 0 1 0 6.4 0a3.2 3.2 0 1 0 -6.4 0z",
        Mark::Square => "m-3 -3h6v6h-6z",
        Mark::Diamond => "m0 -4.2l4.2 4.2l-4.2 4.2l-4.2 -4.2z",
        Mark::Triangle => "m0 -4l4 7h-8z",
        Mark::Star => "m0 -6.5l1.8 4.7l4.7 1.8l-4.7 1.8l-1.8 4.7l-1.8 -4.7l-4.7 -1.8l4.7 -1.8z",
    };
    let _ = writeln!(out, "<path class=\"f\" style=\"stroke-width:.5\" d=\"M{x:.1} {y:.1}{shape}\"/>");
}

/// A method's mark and name, and under it why it failed where it did.
fn legend(out: &mut String, y: f64, name: &str, mark: Mark, rows: &[&Row]) {
    let x = RIGHT + 28.0;
    let _ = writeln!(out, "<path d=\"M{:.1} {y}h24\"/>", x - 12.0);
    draw(out, mark, x, y);
    let _ = writeln!(out, "<text style=\"stroke:none\" x=\"{}\" y=\"{}\">{}</text>", x + 20.0, y + 4.0, escaped(name));
    let failed = rows.iter().filter(|row| row.failures > 0).count();
    if failed > 0 {
        let why = rows.iter().rev().find_map(|row| row.refusal.as_deref()).unwrap_or("no answer");
        let count = if failed == rows.len() { String::new() } else { format!("{failed} of {}, ", rows.len()) };
        let _ = writeln!(
            out,
            "<text class=\"small\" style=\"stroke:none\" x=\"{}\" y=\"{}\">\u{d7} {count}{}</text>",
            x + 20.0,
            y + 19.0,
            escaped(why)
        );
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
