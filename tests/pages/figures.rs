//! Figures: labels keep clear of everything, both writers are well-formed, nothing is clipped.

mod random;
mod scenes;

use momentous::figure::{Drawing, Overlap, Shape, bounds, overlaps, svg, svg_file, tikz};
use random::Dice;

const SEEDS: u64 = 200;

type Draw = fn(&mut Dice) -> Drawing;

fn gallery() -> Vec<(String, Drawing)> {
    let mut all = Vec::new();
    all.extend(scenes::momentum_diagrams().into_iter().map(|(name, it)| (format!("momentum {name}"), it.drawing())));
    all.extend(
        scenes::situations()
            .into_iter()
            .chain(scenes::surroundings())
            .map(|(name, it)| (format!("situation {name}"), it.drawing())),
    );
    all.extend(scenes::angular_diagrams().into_iter().map(|(name, it)| (format!("angular {name}"), it.drawing())));
    all.extend(scenes::force_plots().into_iter().map(|(name, it)| (format!("force {name}"), it.drawing())));
    all.extend(scenes::mass_centres().into_iter().map(|(name, it)| (format!("centre {name}"), it.drawing())));
    all
}

fn assert_good(name: &str, drawing: &Drawing) {
    if let Some(Overlap { label, other }) = overlaps(drawing).first() {
        panic!("{name}: {label:?}\ntouches {other:?}");
    }
    let frame = bounds(&drawing.shapes);
    assert!(frame.low.x >= drawing.low.x && frame.high.x <= drawing.high.x, "{name}: clipped at a side");
    assert!(frame.low.y >= drawing.low.y && frame.high.y <= drawing.high.y, "{name}: clipped above or below");
    assert_well_formed(name, &svg(drawing));
    assert_well_formed(name, &svg_file(drawing));
    assert_balanced(name, &tikz(drawing));
}

/// Every element closed in the right order, every attribute quoted, every `&` the start of a known entity.
fn assert_well_formed(name: &str, text: &str) {
    let mut open: Vec<&str> = Vec::new();
    let mut parts = text.split('<');
    assert_eq!(parts.next(), Some(""), "{name}: text before the first element");
    for part in parts {
        let (tag, content) = part.split_once('>').unwrap_or_else(|| panic!("{name}: a tag without an end: {part}"));
        assert_eq!(tag.matches('"').count() % 2, 0, "{name}: an attribute without its end: {tag}");
        if let Some(closing) = tag.strip_prefix('/') {
            assert_eq!(open.pop(), Some(closing), "{name}: closed in the wrong order");
        } else if !tag.ends_with('/') {
            open.extend(tag.split_whitespace().next());
        }
        for entity in content.split('&').skip(1) {
            let known = ["amp;", "lt;", "gt;", "quot;"];
            assert!(known.iter().any(|known| entity.starts_with(known)), "{name}: &{entity}");
        }
        assert!(!content.contains('>'), "{name}: a bare > in {content}");
    }
    assert!(open.is_empty(), "{name}: not closed: {open:?}");
    assert!(!text.contains("NaN") && !text.contains("inf,"), "{name}: a coordinate that is no number");
}

fn assert_balanced(name: &str, text: &str) {
    assert_eq!(text.matches('{').count(), text.matches('}').count(), "{name}: braces");
    assert_eq!(text.matches('$').count() % 2, 0, "{name}: dollar signs");
    let statements = text.lines().filter(|line| !line.starts_with("\\begin") && !line.starts_with("\\end"));
    for line in statements {
        assert!(line.starts_with('\\') && line.ends_with(';'), "{name}: {line}");
    }
}

#[test]
fn the_gallery_is_clear_complete_and_well_formed() {
    for (name, drawing) in gallery() {
        assert_good(&name, &drawing);
    }
}

#[test]
fn momentum_diagrams_fit_on_a_sheet() {
    for (name, diagram) in scenes::momentum_diagrams() {
        let drawing = diagram.drawing();
        assert!((drawing.high - drawing.low).x <= 460.0, "{name}");
    }
}

#[test]
fn random_figures_are_clear_complete_and_well_formed() {
    let kinds: [(&str, Draw); 7] = [
        ("momentum", random::momentum_diagram),
        ("situation", random::situation),
        ("held", random::held),
        ("launched", random::launched),
        ("angular", random::angular_diagram),
        ("force", random::force_plot),
        ("centre", random::mass_centre),
    ];
    for (kind, draw) in kinds {
        for seed in 0..SEEDS {
            let drawing = draw(&mut Dice(seed));
            assert_good(&format!("{kind} {seed}"), &drawing);
            assert_eq!(drawing, draw(&mut Dice(seed)), "{kind} {seed} differs from itself");
        }
    }
}

#[test]
fn nonsense_is_drawn_without_a_panic() {
    for drawing in random::nonsense() {
        assert_well_formed("nonsense", &svg(&drawing));
        assert_balanced("nonsense", &tikz(&drawing));
    }
}

#[test]
fn both_writers_are_stable() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.bind(|| {
        for kept in ["momentum two_carts", "situation oblique", "force ramp"] {
            let drawing = gallery().into_iter().find(|(name, _)| name == kept).expect("a scene of that name").1;
            insta::assert_snapshot!(format!("figure {kept} svg"), svg(&drawing));
            insta::assert_snapshot!(format!("figure {kept} tikz"), tikz(&drawing));
        }
    });
}

#[test]
fn arrows_that_are_not_to_scale_are_told() {
    let caption = |after: f64| {
        let (_, mut diagram) = scenes::momentum_diagrams().remove(0);
        diagram.bodies.iter_mut().for_each(|body| body.after.value = Some([after, 0.0]));
        diagram.drawing().caption
    };
    assert!(!caption(2.0).contains("longer than to scale"));
    assert!(caption(0.001).ends_with("The shortest arrows are drawn longer than to scale."));
}

#[test]
fn an_origin_is_drawn_where_it_leaves_room_and_told_where_not() {
    let shown = |shift: f64| {
        let (_, mut figure) = scenes::mass_centres().remove(0);
        figure.particles.iter_mut().chain(&mut figure.centre).for_each(|particle| particle.position[0] += shift);
        let drawing = figure.drawing();
        let is_origin = |shape: &Shape| matches!(shape, Shape::Label { text, .. } if *text == scenes::name("O"));
        (drawing.shapes.iter().any(is_origin), drawing.caption.contains("outside the figure"))
    };
    assert_eq!([shown(1.0), shown(40.0)], [(true, false), (false, true)]);
}
