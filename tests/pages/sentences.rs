//! Sentences of worked solutions that were once wrong or said twice: what a page says, and what it does not say any more.

use std::sync::Arc;

use momentous::exercise::Exercise;
use momentous::explain::{Audience, Block, Detail, situation};
use momentous::render::{Format, Renderer, Solution};

use crate::problems;
use crate::variants;

/// The worked solution of a scene as Markdown.
fn page(scene: &str, given: &[(&str, &str)], ask: &[&str]) -> String {
    let text = variants::sheet(scene, given, ask);
    let exercise = Exercise::draw(&Arc::new(variants::problem("test.yaml", &text)), 0, 1).unwrap();
    page_of(&exercise)
}

fn page_of(exercise: &Exercise) -> String {
    let (outline, audience) = (exercise.outline(Audience::Everyone, Detail::Full), Audience::Everyone);
    let solution = Solution { outline, identity: exercise.identity(), audience, faded: None };
    Renderer::new(None).unwrap().render_solution(&solution, Format::Markdown).unwrap().text
}

/// A problem of the fixtures.
fn fixture(name: &str) -> String {
    form_in("tests/fixtures", name, 0)
}

/// A form of a problem of the bank.
fn form(name: &str, form: usize) -> String {
    form_in("problem_bank", name, form)
}

fn form_in(folder: &str, name: &str, form: usize) -> String {
    let path = format!("{}/{folder}/{name}.yaml", env!("CARGO_MANIFEST_DIR"));
    let problem = variants::problem(name, &std::fs::read_to_string(path).unwrap());
    page_of(&Exercise::draw(&Arc::new(problem), form, 1).unwrap())
}

/// A form of the bank at seed 1 as a short solution.
fn short(name: &str, form: usize) -> String {
    let path = format!("{}/problem_bank/{name}.yaml", env!("CARGO_MANIFEST_DIR"));
    let problem = variants::problem(name, &std::fs::read_to_string(path).unwrap());
    let exercise = Exercise::draw(&Arc::new(problem), form, 1).unwrap();
    let (outline, audience) = (exercise.outline(Audience::Everyone, Detail::Short), Audience::Everyone);
    let solution = Solution { outline, identity: exercise.identity(), audience, faded: None };
    Renderer::new(None).unwrap().render_solution(&solution, Format::Markdown).unwrap().text
}

#[test]
fn the_step_that_is_named_is_shown() {
    let rows = [
        ("bouncing/rubber-ball", 0, r"(1 + 2\,e + 2\,e^{2} + \text{...})"),
        ("impulse/skydiver", 0, r"\Delta t = \int_{0}^{v_{A2}} \frac{m}{m\,g - k\,v^{2}}\,dv"),
        ("streams/turbine-vane", 0, r"q_{V}\,(v - u) - (F_{V})_{x} = q_{V}\,(v - u)\,\cos \theta"),
        ("streams/turbine-vane", 0, "the force on the jet is opposite to that on the vane"),
        ("impulse/bobsleigh-start", 0, r"\frac{1}{2}\,t_{a}\,F_{\text{max}} + (t_{b} - t_{a})\,F_{\text{max}}"),
        ("impulse/kick-told-by-its-graph", 0, "the area under the graph of the force of the foot, two triangles"),
        ("angular-momentum/lasso", 0, "% greater than the right one, with"),
    ];
    for (name, form, shown) in rows {
        let said = short(name, form);
        assert!(said.contains(shown), "{shown} in {name}: {said}");
    }
}

#[test]
fn only_bodies_that_do_something_belong_to_the_system() {
    // The impact comes after the slide of which alone the normal force is asked.
    let said = short("chains/crate-on-a-track", 0);
    assert!(said.contains("The crate, at the upper end (1)"), "{said}");
    assert!(short("chains/crate-on-a-track", 1).contains("The crate and the trolley."));
}

#[test]
fn a_body_on_an_arm_does_not_move_along_a_line() {
    let scene = "axes: { x: [counter-clockwise, clockwise] }\nbodies:\n  A: { name: ball A }\n  B: { name: ball B }\npoints:\n  O: { name: the pivot }\nstages:\n  - rotate: { about: O, bodies: { A: a, B: a }, moment: M, during: tau }";
    let given =
        [("m_A", "2 kg"), ("m_B", "1 kg"), ("a", "0.5 m"), ("M", "4 N m"), ("tau", "2 s"), ("omega_1", "1 rad/s")];
    let said = page(scene, &given, &["speed_A2"]);
    assert!(said.contains("Ball A moves at right angles to the radius, so by the definition of speed"), "{said}");
    assert!(!said.contains("along a line"), "{said}");
}

#[test]
fn an_orbit_names_what_is_at_its_focus() {
    let said = fixture("exercises/ser-halley");
    assert!(said.contains("ellipse with the Sun at a focus") && said.contains("distance of Comet Halley from the Sun"));
}

#[test]
fn the_energy_that_one_impact_loses_is_checked_once() {
    let said = fixture("reference/pl-ballistic-pendulum");
    assert_eq!(said.matches("Kinetic energy lost in the impact").count(), 1, "{said}");
}

#[test]
fn a_push_between_plain_times_is_given_by_the_shapes_under_its_graph() {
    let scene = "axes: { x: ahead }\nbodies:\n  A: { name: the ball }\nstages:\n  - push: { body: A, during: 6 ms, forces: [ { name: the bat, value: { points: [[0 s, 0 N], [2 ms, F_m], [4 ms, F_m], [6 ms, 0 N]] } } ] }";
    let said = page(scene, &[("m_A", "0.15 kg"), ("v_A1", "-30 m/s"), ("v_A2", "40 m/s")], &["F_m"]);
    // By hand: 0.15*70 = F (6 + 2)/2 ms.
    assert!(said.contains("a triangle, a rectangle and a triangle"), "{said}");
    assert!(!said.contains("cases") && said.contains("2625"), "{said}");
}

#[test]
fn a_range_says_multiples_of_what_may_be_anything() {
    let said = fixture("found/range_in_symbols");
    // By hand, with e = 1: (3 - 5)/8 of 2 u.
    assert!(said.contains(r"v_{P2} = -0.500\,u") && said.contains(r"1.2\,u \ge 0"), "{said}");
}

/// The figure on the sheet of a scene with two bodies on an arm, driven by a moment.
fn driven_arm(moment: &str) -> String {
    let scene = "axes: { x: [counter-clockwise, clockwise] }\nbodies:\n  A: { name: ball A }\n  B: { name: ball B }\npoints:\n  O: { name: the pivot }\nstages:\n  - rotate: { about: O, bodies: { A: a, B: a }, moment: MOMENT, during: 3 s }";
    let given = [("m_A", "2 kg"), ("m_B", "1 kg"), ("a", "0.5 m"), ("c", "4 N m/s"), ("omega_1", "1 rad/s")];
    let text = variants::sheet(&scene.replace("MOMENT", moment), &given, &["omega_2"]);
    let exercise = Exercise::draw(&Arc::new(variants::problem("test.yaml", &text)), 0, 1).unwrap();
    situation(exercise.worked()).unwrap().description
}

#[test]
fn a_moment_is_drawn_in_a_sense_that_it_keeps() {
    // A sense told at the start is kept, or found after it.
    assert!(driven_arm("c*t + 1 N m").contains("The moment M is counter-clockwise"));
    assert!(driven_arm("-c*t").contains("The moment M is clockwise"));
    // One that is lost on the way is not drawn.
    assert!(!driven_arm("c*t - 2 N m").contains("moment"));
}

/// A variant of a problem of the bank in its first form.
fn of_the_bank(id: &str) -> Exercise {
    let path = format!("{}/problem_bank/{id}.yaml", env!("CARGO_MANIFEST_DIR"));
    let problem = variants::problem(id, &std::fs::read_to_string(path).unwrap());
    Exercise::draw(&Arc::new(problem), 0, 1).unwrap()
}

fn drawn(id: &str) -> String {
    situation(of_the_bank(id).worked()).unwrap().description
}

fn diagrams(id: &str) -> Vec<String> {
    let blocks = of_the_bank(id)
        .outline(Audience::Everyone, Detail::Full)
        .sections
        .into_iter()
        .flat_map(|section| section.blocks);
    let told = |block| if let Block::Figure(drawing) = block { Some(drawing.description) } else { None };
    blocks.filter_map(told).collect()
}

#[test]
fn a_force_is_drawn_although_nobody_may_know_since_when_it_counts() {
    let drawn = drawn("impulse/crate-ramp-force");
    assert!(drawn.contains("the force F to the right"), "{drawn}");
}

#[test]
fn a_velocity_of_a_stream_is_not_that_of_the_body_it_meets() {
    let drawn = drawn("streams/fire-hose");
    assert_eq!(drawn, "The shield. The jet meets the shield with the velocity v to the right.");
}

#[test]
fn what_is_written_at_the_exhaust_are_magnitudes_as_in_the_law_of_thrust() {
    for (id, way) in [("streams/heavy-rocket", "downwards"), ("streams/moon-lander", "ahead")] {
        let told = diagrams(id).concat();
        assert!(told.contains(&format!("impulse: F_R \u{394}t, {way}; momentum after: \u{394}m u, {way}")), "{told}");
    }
}

#[test]
fn a_body_on_a_movable_pulley_is_not_on_an_end_of_the_string() {
    let drawn = drawn("strings/stage-scenery");
    assert!(
        drawn.ends_with(
            "the flat hangs on 2 strands of it, by a movable pulley; the counterweight is on one end of it."
        )
    );
}

#[test]
fn a_coupling_that_pushes_is_drawn_with_the_size_of_its_force() {
    let told = diagrams("strings/lorry-and-trailer").concat();
    assert!(told.contains("\u{2212}F_T \u{394}t") && !told.contains(" F_T \u{394}t"), "{told}");
}

#[test]
fn a_displacement_is_answered_with_its_direction() {
    let said = page_of(&of_the_bank("mass-centre/walk-along-barge"));
    assert!(said.contains("ft away from the quay."), "{said}");
}

#[test]
fn a_chain_does_not_flow() {
    let said = fixture("exercises/chain-lift");
    assert!(said.contains("The hanging part, with the chain arriving."), "{said}");
    assert!(said.contains("The chain comes to the hanging part with the difference of their velocities"));
    assert!(!said.contains("flows") && !said.contains("catches up"), "{said}");
}

#[test]
fn a_leash_is_no_spring() {
    let said = form("central-force/elastic-leash", 0);
    assert!(said.contains("Only the leash does work on the puck") && said.contains("The mass of the leash"), "{said}");
    assert!(!said.contains("spring"), "{said}");
}

#[test]
fn a_person_is_no_it() {
    let said = form("impulse/skydiver", 0);
    assert!(said.contains("The skydiver is acted on by weight and the resistance."), "{said}");
    assert!(!said.contains("its weight"), "{said}");
}

#[test]
fn a_brake_does_not_push() {
    let said = form("impulse/capsule-braking", 2);
    assert!(said.contains("The duration of the braking") && !said.contains("push"), "{said}");
}

#[test]
fn what_only_another_form_asks_is_not_looked_at() {
    let [start, inwards] = [0, 1].map(|number| form("angular-momentum/playground-carousel", number));
    assert!(start.contains("when it has been sped up (2).") && !start.contains("second motion"), "{start}");
    assert!(inwards.contains("From (2) to (3)"), "{inwards}");
    let orbit = form("central-force/comet-visit", 0);
    assert!(
        orbit.contains("The comet, at the nearest point.") && !orbit.contains("at the orbit of the Earth"),
        "{orbit}"
    );
}

#[test]
fn a_check_needs_nothing_that_was_not_found() {
    // The velocity after the impact is not asked for, and so neither is the energy then.
    let [normal, velocity] = [0, 1].map(|number| form("chains/crate-on-a-track", number));
    assert!(velocity.contains("Kinetic energy lost in the impact"), "{velocity}");
    assert!(!normal.contains("Kinetic energy lost"), "{normal}");
    // Nor are the velocities after this one, where only its impulses are.
    assert!(!form("impact/billiard-phases", 0).contains("does not pass through"));
}

#[test]
fn a_body_high_on_a_circle_moves_along_its_path() {
    let scene = "axes: { x: to the right }\nplane: vertical\nbodies:\n  A: { name: the bob }\nstages:\n  - swing: { body: A, length: L, to: alpha }";
    let given = [("m_A", "0.2 kg"), ("L", "0.5 m"), ("alpha", "120 deg"), ("v_A1", "6 m/s")];
    let said = page(scene, &given, &["v_A2"]);
    assert!(said.contains("m/s}$, along the path."), "{said}");
}

#[test]
fn a_solution_says_nothing_of_an_impact_that_it_does_not_use() {
    let force_before_the_impact = form("chains/crate-on-a-track", 0);
    for said in ["Why momentum and not energy", "Weight during the impact"] {
        assert!(!force_before_the_impact.contains(said), "{said}: {force_before_the_impact}");
    }
    assert!(form("impact/two-carts", 0).contains("Why momentum and not energy"));
}

/// Momentum is preferred to energy where momentum is used.
#[test]
fn who_says_why_momentum_serves_uses_it() {
    let mut said = 0;
    for exercise in problems::exercises(1) {
        let page = page_of(&exercise);
        if page.contains("Why momentum and not energy") {
            said += 1;
            assert!(page.contains("momentum:"), "{}: {page}", exercise.problem().id());
        }
    }
    assert!(said > 20, "{said}");
}

#[test]
fn a_root_without_a_formula_is_shown_between_two_trials() {
    let page = form("vectors/beach-ball", 0);
    // By hand: after 1.67 s the ball is still 15 mm above the sand, and after 1.68 s it would be 36 mm below.
    let trials = r"With $\Delta t = 1.67\text{ s}$ the left side of (1) is 1.2 % less than the right one, with $1.68\text{ s}$ 2.9 % greater";
    assert!(page.replace('\u{a0}', " ").contains(trials), "{page}");
}

#[test]
fn axes_are_named_where_something_is_counted_along_them() {
    // Heights after bounces and what a flywheel does have no sign along an axis.
    for (name, form) in [("bouncing/rubber-ball", 0), ("angular-momentum/flywheel-run-up", 0)] {
        let said = short(name, form);
        assert!(!said.contains("axis points"), "{said}");
    }
    assert!(short("angular-momentum/flywheel-run-up", 0).contains("Counter-clockwise is positive."));
    assert!(short("mass-centre/walk-along-barge", 0).contains("axis points towards the quay"));
}

#[test]
fn a_bob_that_swings_does_not_move_along_a_line() {
    let said = short("chains/loop-after-a-blow", 0);
    assert!(said.contains(r"\lvert v_{B3}\rvert = v_{B3}") && !said.contains("along a line"), "{said}");
}

#[test]
fn two_turns_of_a_carousel_are_told_apart() {
    let said = short("angular-momentum/playground-carousel", 1);
    assert!(said.contains("with Alma and Bo on it"), "{said}");
    assert!(said.contains("while the distance of Alma and Bo from its axis changes"), "{said}");
}

#[test]
fn a_comparison_is_not_said_as_it_was_typed() {
    let said = short("concepts/rebound-or-not", 0);
    assert!(said.contains(r"m\_A v\_A1 (") && !said.contains(r"m\_A\*v"), "{said}");
}

#[test]
fn a_short_solution_numbers_only_what_it_refers_to() {
    for (name, form) in [("impulse/golf-drive", 0), ("impulse/skydiver", 0), ("streams/coal-wagon", 0)] {
        let said = short(name, form);
        assert!(!said.contains(r"\tag"), "{said}");
    }
    assert!(short("impact/two-carts", 0).contains(r"\tag{2}"));
}

#[test]
fn a_multiple_is_told_with_the_quantity_that_it_is_a_multiple_of() {
    let said = short("concepts/only-ratios", 0);
    assert!(!said.contains(r"\approx"), "{said}");
}

/// The figure on the sheet of a form of the bank.
fn sheet_of(name: &str, form: usize) -> momentous::figure::Drawing {
    let path = format!("{}/problem_bank/{name}.yaml", env!("CARGO_MANIFEST_DIR"));
    let problem = variants::problem(name, &std::fs::read_to_string(path).unwrap());
    situation(Exercise::draw(&Arc::new(problem), form, 1).unwrap().worked()).unwrap()
}

#[test]
fn a_sheet_shows_nothing_that_only_another_form_prints() {
    // The other components of the moment are drawn for both forms and printed for one.
    let [all, one] = [0, 1].map(|form| sheet_of("angular-momentum/telescope-in-orbit", form).description);
    assert!(all.contains("M_z") && all.contains("M_0"), "{all}");
    assert!(one.contains("the moment M_x") && !one.contains("M_z") && !one.contains("M_0"), "{one}");
}

#[test]
fn an_impulse_that_is_negligible_is_not_denied() {
    for (name, form) in [("chains/locked-bumpers", 1), ("chains/parcel-on-scale", 1), ("concepts/egg-drop", 1)] {
        let said = short(name, form);
        let denies = said.contains("no other impulse") || said.contains("only impulse");
        assert!(said.contains("is negligible") && !denies, "{said}");
    }
}

#[test]
fn what_climbs_inwards_is_not_said_to_move_round_as_before() {
    let said = short("angular-momentum/roundabout", 1);
    assert!(said.contains("the distance of Amina and Bj\u{f6}rn from the axle changes"), "{said}");
}

#[test]
fn only_the_rope_that_is_slack_hangs_down() {
    use momentous::figure::{Role, Shape};
    // Both sledges rest on a straight rope; the one to the snowmobile is slack: a curve of many points.
    let drawing = sheet_of("strings/two-sledges-in-tow", 0);
    let curves = drawing.shapes.iter().filter(|shape| match shape {
        Shape::Line { points, role, .. } => points.len() > 4 && *role != Role::Body,
        _ => false,
    });
    assert_eq!(curves.count(), 1);
}

#[test]
fn both_bobs_hang_in_the_picture_of_the_sheet() {
    let names = |drawing: &momentous::figure::Drawing| {
        let is_name = |shape: &&momentous::figure::Shape| matches!(shape, momentous::figure::Shape::Label { text, .. } if text.plain() == "B");
        drawing.shapes.iter().filter(is_name).count()
    };
    assert_eq!(names(&sheet_of("chains/pendulum-bobs", 0)), 1);
}
