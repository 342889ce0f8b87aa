//! What the planner takes and what it leaves: the fewest equations that a textbook would use, of whole problems.

use std::collections::BTreeSet;

use momentous::problem::{Ask, Problem, Sampler};
use momentous::solve::{Cause, Step};

use crate::variants::{bank, bank_problem, form_name, problem, read, sheet, solved, value};

const CARTS: &str = "\
axes: { x: to the right }
bodies:
  A: { name: cart A }
  B: { name: cart B }
stages:
  - impact: { between: [A, B], restitution: e }
";

const GIVEN: &[(&str, &str)] = &[("m_A", "3 kg"), ("m_B", "2 kg"), ("v_A1", "3 m/s"), ("v_B1", "-2 m/s"), ("e", "0.7")];

const CRATE: &str = "\
axes: { x: along the floor, y: up }
bodies:
  A: { name: the crate, mass: m }
stages:
  - push:
      body: A
      during: dt
      forces:
        - { name: the pull, value: F, direction: 0 deg }
";

/// A step as a reader would tell it: what is found, by which laws.
fn told(problem: &Problem, leaf: usize, step: &Step) -> String {
    let names: Vec<&str> =
        step.unknowns.iter().map(|symbol| problem.model().symbols.entry(*symbol).name.as_str()).collect();
    let system = &problem.forms()[0].solver.leaf(leaf).system;
    let law = |place: &usize| problem.model().instances[system.equations[*place].tag].law.name;
    let laws: Vec<&str> = step.equations.iter().map(law).collect();
    format!("{}: {}", names.join(", "), laws.join(" + "))
}

/// The answer plan of the first form, in its first regime.
fn plan(problem: &Problem) -> Vec<String> {
    problem.forms()[0].solver.leaf(0).answer_steps().iter().map(|step| told(problem, 0, step)).collect()
}

fn unknowns(steps: &[Step], problem: &Problem) -> BTreeSet<String> {
    let names = steps.iter().flat_map(|step| &step.unknowns);
    names.map(|symbol| problem.model().symbols.entry(*symbol).name.clone()).collect()
}

fn carts(ask: &[&str]) -> Problem {
    problem("carts.yaml", &sheet(CARTS, GIVEN, ask))
}

#[test]
fn conservation_is_taken_where_nobody_asks_for_the_impulse() {
    assert_eq!(
        plan(&carts(&["v_A2", "v_B2"])),
        ["v_A2, v_B2: conservation of linear momentum + the law of restitution"]
    );
}

#[test]
fn one_velocity_is_found_with_the_other_and_nothing_else() {
    assert_eq!(plan(&carts(&["v_A2"])), plan(&carts(&["v_A2", "v_B2"])));
}

#[test]
fn an_impulse_that_is_asked_takes_one_equation_more() {
    let steps = plan(&carts(&["J_A"]));
    assert_eq!(steps.len(), 2, "{steps:?}");
    assert_eq!(steps[1], "J_A: the principle of impulse and momentum");
}

#[test]
fn what_is_given_after_a_plastic_impact_needs_no_restitution() {
    let scene = CARTS.replace("restitution: e", "plastic: true, becomes: C");
    let problem = problem("plastic.yaml", &sheet(&scene, &GIVEN[..4], &["v_C2"]));
    assert_eq!(plan(&problem), ["v_C2: conservation of linear momentum"]);
}

#[test]
fn what_nobody_asks_for_is_in_the_audit_only() {
    let problem = carts(&["v_A2", "v_B2"]);
    let leaf = problem.forms()[0].solver.leaf(0);
    let (answer, all) = (unknowns(leaf.answer_steps(), &problem), unknowns(&leaf.audit.plan.steps, &problem));
    assert_eq!(answer, BTreeSet::from(["v_A2".to_owned(), "v_B2".to_owned()]));
    for name in ["T_lost", "J_A", "J_B"] {
        let met = |names: &BTreeSet<String>| names.iter().any(|listed| listed.split('[').next() == Some(name));
        assert!(!met(&answer) && met(&all), "{name}: {answer:?} {all:?}");
    }
}

/// In no plan of the bank does a step find what neither is asked nor serves a later step.
#[test]
fn every_step_of_the_bank_serves_the_question() {
    for problem in bank() {
        for (index, form) in problem.forms().iter().enumerate() {
            // Where the sheet tells enough to find a quantity, the solution finds it.
            let found = form.question.ask.iter().filter_map(|ask| match ask {
                Ask::Enough(enough) => problem.model().symbol_of(&enough.enough),
                _ => None,
            });
            let asked: BTreeSet<_> = form.wanted().chain(found).collect();
            for leaf in form.solver.leaves() {
                let mut needed = asked.clone();
                for step in leaf.answer_steps().iter().rev() {
                    assert!(
                        step.unknowns.iter().any(|unknown| needed.contains(unknown)),
                        "{}: {:?}",
                        form_name(&problem, index),
                        unknowns(std::slice::from_ref(step), &problem)
                    );
                    let read = step.equations.iter().flat_map(|place| leaf.system.equations[*place].symbols());
                    needed.extend(read);
                }
            }
        }
    }
}

/// Whether a quantity belongs to the direction across the line.
fn is_across(name: &str) -> bool {
    name.split('.').nth(1) == Some("y") || name.starts_with("N_")
}

/// How many steps of the answer speak of the direction across the line.
fn across(problem: &Problem) -> usize {
    let symbols = &problem.model().symbols;
    let leaf = problem.forms()[0].solver.leaf(0);
    let speaks = |places: &[usize]| {
        let symbols_of = places.iter().flat_map(|place| leaf.system.equations[*place].symbols());
        symbols_of.filter(|symbol| is_across(&symbols.entry(*symbol).name)).count()
    };
    leaf.answer_steps().iter().filter(|step| speaks(&step.equations) > 0).count()
}

#[test]
fn a_line_has_no_equation_across_it_unless_friction_needs_one() {
    let given = [("m", "20 kg"), ("v_A1", "1 m/s"), ("F", "90 N"), ("dt", "2 s"), ("mu", "0.2")];
    let smooth = CRATE.replace(", y: up", "");
    let without = problem("smooth.yaml", &sheet(&smooth, &given[..4], &["v_A2"]));
    let names: Vec<&str> = without.model().symbols.iter().map(|(_, entry)| entry.name.as_str()).collect();
    assert!(!names.iter().any(|name| is_across(name)), "{names:?}");
    assert_eq!(plan(&without).last().unwrap(), "v_A2: the principle of impulse and momentum");

    let rough = format!("{smooth}        - friction: {{ kinetic: mu }}\n");
    let with = problem("rough.yaml", &sheet(&rough, &given, &["v_A2"]));
    let steps = plan(&with);
    assert_eq!(
        across(&with),
        2,
        "the balance at right angles to the surface, and the friction that reads it: {steps:?}"
    );
    assert!(
        steps.iter().any(|step| step.starts_with("N_A: the balance of forces at right angles to the surface")),
        "{steps:?}"
    );
}

#[test]
fn the_energy_lost_leaves_two_coefficients_and_physics_chooses() {
    let given = [GIVEN[0], GIVEN[1], GIVEN[2], GIVEN[3], ("T_lost", "9.6 J")];
    let (problem, variant) = solved(&sheet(CARTS, &given, &["e"]));
    // 1/2 * (3*2/5) * 5^2 * (1 - e^2) = 9.6 has e = 0.6 and -0.6.
    let e = value(&problem, &variant, "e");
    assert!((e.value - 0.6).abs() <= e.error && e.error < 1e-12, "{e:?}");
    // The other root is followed to the velocities that belong to e = -0.6: 2.2 and -0.8 m/s.
    let leaf = problem.forms()[0].solver.leaf(variant.leaf());
    let [dead] = variant.dead() else { panic!("{:?}", variant.dead()) };
    let step = &leaf.audit.plan.steps[dead.step.expect("the givens are sound")];
    let found = |name: &str| {
        let symbol = problem.model().symbol_of(name).unwrap();
        dead.values[step.unknowns.iter().position(|unknown| *unknown == symbol).unwrap()].value
    };
    let e = (found("v_B2") - found("v_A2")) / (3.0 - -2.0);
    assert!((e + 0.6).abs() < 1e-12, "{e}");
    let Cause::Condition(condition) = dead.cause else { panic!("{:?}", dead.cause) };
    let reason = problem.model().reasons[leaf.system.conditions[condition].tag].to_string();
    assert_eq!(reason, "cart A would pass through cart B");
}

#[test]
fn every_regime_has_a_plan_and_seeds_on_both_sides() {
    let scene = format!("{CRATE}        - friction: {{ static: 0.4, kinetic: 0.3 }}\n").replace(", y: up", "");
    let given = [("m", "20 kg"), ("v_A1", "0 m/s"), ("F", "{ min: 60, max: 100, step: 1, unit: N }"), ("dt", "2 s")];
    let problem = problem("crate.yaml", &sheet(&scene, &given, &["v_A2"]));
    let force = problem.model().symbol_of("F").unwrap();
    let mut sampler = Sampler::new(&problem, 0).unwrap();
    let mut seen = BTreeSet::new();
    for seed in 0..60 {
        let variant = sampler.variant(seed).unwrap_or_else(|reason| panic!("seed {seed}: {reason}"));
        let words = problem.forms()[0].solver.leaf(variant.leaf()).words.join(", ");
        let pull = variant.value(force).unwrap().value;
        let speed = value(&problem, &variant, "v_A2").value;
        // Friction holds up to 0.4*20*9.81 = 78.48 N; sliding, it is 58.86 N.
        let slides = pull > 78.48;
        let expected = if slides { (pull - 58.86) / 20.0 * 2.0 } else { 0.0 };
        assert!((speed - expected).abs() < 1e-12, "{pull} {speed} {words}");
        seen.insert((slides, words));
    }
    assert_eq!(seen.len(), 2, "two regimes, each with words of its own: {seen:?}");
    assert_ne!(seen.first().unwrap().1, seen.last().unwrap().1);
}

#[test]
fn too_little_names_what_does_not_follow_and_what_would_do() {
    let message = read("carts.yaml", &sheet(CARTS, &GIVEN[..4], &["v_A2"])).unwrap_err();
    for words in ["`v_A2` does not follow from what is given", "give also ", "`e`"] {
        assert!(message.contains(words), "{words}\n{message}");
    }
}

#[test]
fn a_mass_that_is_never_told_leaves_energy_and_momentum_open() {
    // The kinetic energy is written twice, in components along the axes and along the slope: that does not tell the mass.
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/problem_bank/impact/ball-on-roof.yaml");
    let roof = std::fs::read_to_string(path).unwrap();
    for (name, message) in [
        ("T_ball1", "`T_ball1` does not follow from what is given"),
        ("T_ball2", "`T_ball2` does not follow from what is given"),
        ("p_ball1", "`p_ball1.x`, `p_ball1.y` do not follow from what is given"),
    ] {
        let asked = roof.replace("find: speed_ball3, unit: m/s", &format!("find: {name}"));
        assert_ne!(asked, roof);
        let faults = read("roof.yaml", &asked).err().unwrap_or_default();
        assert!(faults.contains(message) && faults.contains("give also `m_ball`"), "{faults}");
    }
}

#[test]
fn too_much_names_the_law_that_is_broken_and_what_it_connects() {
    let given = [GIVEN, &[("v_A2", "-0.5 m/s")]].concat();
    let message = read("carts.yaml", &sheet(CARTS, &given, &["v_B2"])).unwrap_err();
    let broken = "what is given contradicts the law of restitution, which connects `e`, `v_A1`, `v_B1`, `v_A2`, `v_B2`";
    assert!(message.contains(broken), "{message}");
}

#[test]
fn what_is_given_twice_and_agrees_is_a_check() {
    let given = [GIVEN, &[("v_A2", "-0.4 m/s")]].concat();
    let (problem, variant) = solved(&sheet(CARTS, &given, &["v_B2"]));
    assert!((value(&problem, &variant, "v_B2").value - 3.1).abs() < 1e-12);
    assert!(!problem.forms()[0].solver.leaf(0).audit.checks.is_empty());
}

#[test]
fn the_bank_asks_for_conservation_by_name() {
    let problem = bank_problem("impact/two-carts");
    assert_eq!(plan(&problem)[0], "v_A2, v_B2: conservation of linear momentum + the law of restitution");
}

#[test]
fn what_may_be_anything_may_stand_in_expressions_only() {
    let given = [("m", "any kg"), ("m_A", "2*m"), ("m_B", "m"), GIVEN[2], GIVEN[3], GIVEN[4]];
    let text = sheet(CARTS, &given, &["v_A2"]).replace("{{ m }} {{ m_A }} {{ m_B }}", "");
    let (problem, variant) = solved(&text);
    // (2*3 - 2 - 0.7*5)/3
    assert!((value(&problem, &variant, "v_A2").value - 0.5 / 3.0).abs() < 1e-12);
}

#[test]
fn what_only_a_relation_speaks_of_can_be_asked() {
    let text = sheet(CARTS, GIVEN, &[]) + "  - { find: x, unit: cm }\n";
    let text = text.replace("given:\n", "relations:\n  - { equation: k*x^2/2 = m_A*v_A2^2/2, because: the spring takes all of it }\nwhere: [ x > 0 m ]\ngiven:\n  k: 12 N/m\n");
    let text = text.replace("text: '", "text: '{{ k }} ");
    let (problem, variant) = solved(&text);
    assert!((value(&problem, &variant, "x").value - 0.2).abs() < 1e-12); // 0.4*sqrt(3/12)
}
