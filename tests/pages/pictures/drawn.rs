//! What is drawn of a scene: what stands there, bodies together and apart, and the figure of the principle that a solution uses.

use super::*;

/// Where a force is asked that holds a body on its way, its free-body diagram is drawn.
#[test]
fn a_force_that_is_asked_is_seen_with_the_others() {
    let asked = [
        ("chains/crate-on-a-track", ["N_A2", "m_A g"]),
        ("chains/ballistic-pendulum", ["F_T,C2", "(m_A + m_B) g"]),
        ("conservation/lamp-under-a-trolley", ["F_T,A2", "m g"]),
        ("angular-momentum/lasso", ["F_T,A2", "W_A"]),
        ("angular-momentum/plane-on-a-line", ["F_T,A2", "m a_n"]),
        ("streams/grain-belt", ["F_hold,B", "F_B"]),
        ("strings/mooring-rope", ["N_V", "F_V"]),
    ];
    for (id, forces) in asked {
        let problem = bank().iter().find(|problem| problem.id() == id).expect("a problem");
        let forms = (0..problem.forms().len()).map(|form| {
            let variant = Sampler::new(problem, form).expect("a form").variant(1).expect("a variant");
            drawings_of_solution(Worked::new(problem, &variant).expect("its own problem"))
        });
        let mut diagrams = forms.flatten().filter(|drawing| drawing.title.starts_with("Free-body diagram"));
        let drawing = diagrams.next().unwrap_or_else(|| panic!("{id}: no free-body diagram"));
        let labels: Vec<String> = labels(&drawing).into_iter().map(Math::plain).collect();
        for force in forces {
            assert!(labels.iter().any(|label| label == force), "{id}: {force} is not among {labels:?}");
        }
    }
}

/// A solution by work and energy or by forces shows these, and no momentum.
#[test]
fn the_figure_is_that_of_the_principle_which_the_solution_uses() {
    let titles = [
        ("impulse/arrow-in-straw", vec!["Free-body diagram of the arrow", "Graph of F against x"]),
        ("impulse/bungee-tow", vec!["Free-body diagram of the sledge", "Graph of F against x"]),
        ("impulse/skydiver", vec!["Free-body diagram of the skydiver"]),
        ("impulse/tram-stops", vec!["Graph of v against t"]),
        ("impulse/bullet-in-gel", vec!["Graph of v against x", "Impulse-momentum diagram of the motion"]),
        ("impact/dropped-basketball", vec!["The fall of the ball", "Impulse-momentum diagram of the impact"]),
    ];
    for (id, expected) in titles {
        let problem = bank().iter().find(|problem| problem.id() == id).expect("a problem");
        let variant = Sampler::new(problem, 0).expect("a form").variant(1).expect("a variant");
        let drawings = drawings_of_solution(Worked::new(problem, &variant).expect("its own problem"));
        let titles: Vec<&str> = drawings.iter().map(|drawing| drawing.title.as_str()).collect();
        assert_eq!(titles, expected, "{id}");
    }
}

/// Walls, cushions, belts and vanes that a scene speaks of are seen.
#[test]
fn what_stands_there_is_drawn() {
    let sheet = |id: &str| {
        let problem = bank().iter().find(|problem| problem.id() == id).expect("a problem");
        let variant = Sampler::new(problem, 0).expect("a form").variant(1).expect("a variant");
        explain::situation(Worked::new(problem, &variant).expect("its own problem")).expect("a figure")
    };
    let surfaces = |id: &str| {
        let is_surface = |shape: &&Shape| matches!(shape, Shape::Line { role: Role::Surface, .. });
        sheet(id).shapes.iter().filter(is_surface).count()
    };
    assert_eq!((surfaces("impact/corner-shot"), surfaces("vectors/cushion-shot")), (2, 1));
    let rollers = sheet("streams/grain-belt").shapes;
    assert_eq!(rollers.iter().filter(|shape| matches!(shape, Shape::Circle { .. })).count(), 2);
    let vane = sheet("streams/turbine-vane");
    assert!(vane.shapes.iter().any(|shape| matches!(shape, Shape::Area { role: Role::Body, .. })));
    let names: Vec<String> = labels(&vane).into_iter().map(Math::plain).collect();
    assert!(names.iter().any(|name| name == "\u{3b8}"), "{names:?}");
}

/// Bodies that come apart are one body before, and each of them is seen in it.
#[test]
fn what_parts_is_drawn_together_before() {
    let is_parting =
        |problem: &&Problem| matches!(problem.loaded().draft.scene.stages.first(), Some(Stage::Separate(_)));
    assert!(bank().iter().filter(is_parting).count() > 5);
    each_variant(1, |at, worked| {
        let Some(Stage::Separate(separate)) = worked.problem.loaded().draft.scene.stages.first() else { return };
        let Some(drawing) = explain::situation(worked) else { return };
        let labels: Vec<String> = labels(&drawing).into_iter().map(Math::plain).collect();
        for body in separate.into.iter().chain(&separate.from) {
            assert!(labels.contains(body), "{at}: {body} is not among {labels:?}");
        }
    });
}
