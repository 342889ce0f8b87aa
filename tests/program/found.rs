//! Problems that readers wrote and the program got wrong: for each the exit code of `momentous check`, and the faults or the
//! answers. A row whose comment says what is wanted tells what happens until then.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use assert_cmd::Command;
use serde_json::Value;

/// What becomes of a file.
enum Outcome {
    /// Its promises hold (exit code 0), and these are its answers, each as `id = what the key prints`.
    Holds(&'static [&'static str]),
    /// A promise is broken (exit code 1), and the remark contains this.
    Broken(&'static [&'static str]),
    /// It does not load (exit code 2), and its faults contain this.
    Refused(&'static [&'static str]),
}

use Outcome::{Broken, Holds, Refused};

/// Each file with what becomes of it.
const FOUND: &[(&str, Outcome)] = &[
    ("about_nowhere", Refused(&["there is no point `NOWHERE`", "the points are: O"])),
    ("aiming", Holds(&["angle_A1 = 12.1"])),
    ("angle_with_a_relative_velocity", Holds(&["angle(v_A2, v_rel_A2) = 26.6"])),
    ("backwards", Refused(&["`backwards` is not a direction of this scene", "its directions are `ahead`"])),
    ("classify_at_a_moving_wall", Holds(&["a = perfectly plastic"])),
    // By hand: 2/3*5*T^1.5 = 3*2.5.
    ("brake_by_a_root", Holds(&["T = 1.72 s"])),
    // By hand: 2.25*10*sin 127 and 1.8*10*cos 53.
    ("direction_along_an_axis", Holds(&["speed_A1 = 18.0 m/s", "speed_B1 = 10.8 m/s"])),
    // By hand: 2.25*10*sin 53 and 1.8*10*cos 53.
    ("direction_along_x", Holds(&["speed_A1 = 18.0 m/s", "speed_B1 = 10.8 m/s"])),
    // A raft of four times the mass goes back by a fifth of what the dog walks along it.
    // By hand: 60 degrees less 43.9, as far as ball A is turned from the line of impact.
    ("direction_beyond_half_a_turn", Holds(&["v_B2.x = -0.693 v_0", "angle_A2 = 16.1"])),
    ("displacement_by_its_direction", Holds(&["s_D = 1.60 m", "s_B = -0.400 m"])),
    // By hand: sqrt(6^2 + (2/0.6*4)^2).
    ("drawn_in_at_a_told_speed", Holds(&["speed_B2 = 14.6 ft/s"])),
    ("enough_for_an_angle", Holds(&["a = no"])),
    ("distance_in_brackets", Refused(&["`distance[rise]` is not known", "`distance: s`, and ask for `s`"])),
    ("formula_of_an_own_name", Holds(&["F_m = pi*m*v_A2/(2*tau)"])),
    // By hand: the speed along the line of impact is 6*3/5.
    ("calculation_of_an_angle", Holds(&["speed_B2 = 2.16 m/s", "v_A2.y = -3.46 m/s"])),
    // By hand: -sqrt(1 + 2*4.9e12/1.74e6^2*12).
    ("gravity_from_an_expression", Holds(&["v_A2 = -6.31 m/s", "W_A = 3.24 N"])),
    ("opposite_forces", Holds(&["v_G2 = 1.00 m/s", "T_gained = 60.0 J", "a = yes"])),
    ("expression_without_a_label", Holds(&["gap = "])),
    // 2/5 of sqrt(2*9.81*0.4).
    ("falls_on_a_string", Holds(&["v_B3 = 1.12 m/s"])),
    ("fraction_beside_a_kind", Holds(&["v_B2 = 1.50 m/s", "b = inelastic, but not perfectly"])),
    ("fraction_with_a_unit", Holds(&["v_A2 = 0.868 m/s", "T_lost[1] = 5.33 J"])),
    ("fractions_beside_a_kind", Holds(&["v_A2 = 1.00 m/s", "T_lost[1] = 0.833 J", "d = inelastic, but not perfectly"])),
    ("given_by_given", Holds(&["v_A2 = 6.00 m/s"])),
    ("height_in_terms_of_r", Holds(&["v_A2 = sqrt(10*R*g)"])),
    // By hand: (0.26/3.2)^(1/6).
    ("height_of_a_counted_bounce", Holds(&["e = 0.658"])),
    // By hand: the impulse gives the velocity across at once.
    ("impulse_across", Holds(&["speed_B2 = 40.2 m/s", "angle_B2 = 85.0"])),
    ("interact_after_impact", Holds(&["v_C3 = 0.444 m/s", "p_3 = 1.00 kg m/s"])),
    ("jerked_along", Holds(&["speed_A2 = 0.167 u", "J_A.x = m*u/3"])),
    ("kind_by_numbers", Holds(&["a = perfectly plastic", "b = no"])),
    ("mass_after_a_burn", Holds(&["v_C3 = 31.6 m/s", "T_lost[coupling] = 99900 J", "T_A2 = 250000 J"])),
    ("label_with_a_comma", Refused(&["a text with a comma or a colon stands in quotation marks"])),
    ("mass_of_a_union", Holds(&["v_C2 = 1.00 m/s", "m_B = 4.00 kg"])),
    ("letters_behind_values", Holds(&["v_A2 = m_A*v_A1/(m_A + m_B)"])),
    ("mass_in_terms_of_m", Holds(&["J_B = 6.30 m"])),
    ("moon", Refused(&["the text never prints `g`, which the solution needs"])),
    ("multiple_backwards", Holds(&["v_n2 = -0.333 v_n1"])),
    ("multiple_of_a_height", Holds(&["r_A4 = 0.250 h"])),
    ("multiple_of_a_multiple", Holds(&["r_A4 = 1.00 h"])),
    ("name_collision", Refused(&["`t_1` stands for", "`t_2` stands for"])),
    // 8/9 of the energy, whatever the mass and the speed.
    ("one_constant_part", Holds(&["share = 88.9%"])),
    ("order_of_losses", Holds(&["b = T_lost[second] < T_lost[first]"])),
    ("orbit_circle", Holds(&["r_K1 = 2.50 × 10^8 km"])),
    ("order_of_what_is_equal", Broken(&["`speed_A2` and `speed_B2` are equal with these numbers"])),
    ("passes_through", Broken(&["would pass through the block); if that is meant, write `allow: [passes-through]`"])),
    ("printed_component", Holds(&["speed_A3 = 20.0 m/s"])),
    ("range_after_flight", Holds(&["e = 0 <= e < 0.917"])),
    ("range_of_multiples", Holds(&["e = 0.250 < e <= 1"])),
    ("range_in_symbols", Holds(&["e = 0.600 < e <= 1"])),
    ("ratio_as_a_symbol", Holds(&["v_Q2 = 0.2*u*(4 + 9*e)"])),
    // By hand: e = 2 v_B2/v_A1 - 1, and v_C3 = (1 + e)/2 v_B2.
    ("restitution_in_symbols", Holds(&["v_C3 = v_B2^2/v_A1"])),
    ("required_to_be_positive", Holds(&["e = 0.800 < e <= 1"])),
    // By the laws the block is at rest at the end; a simulation finds that to within its rounding.
    ("rest_by_a_graph", Holds(&["v_A2 = 0 m/s", "work[pull] = -24.0 J"])),
    ("roots_all", Holds(&["dt = 1.49 s or 0.546 s"])),
    ("share_as_a_formula", Holds(&["q = m_B/(m_A + m_B)"])),
    ("shelf", Holds(&["r_ball2.x = 3.97 m"])),
    ("sides_as_written", Holds(&["a = no"])),
    ("slide_by_height", Holds(&["v_A2 = 11.9 m/s"])),
    ("small_beside_large", Holds(&["v_B2 = 0.0150 m/s", "T_B2 = 6.75 × 10^-4 J", "J_B = 0.0900 N s"])),
    // None is lost with any seed, which `varies` says.
    ("strike_elastic", Broken(&["b: yes", "`T_lost` is always 0"])),
    // A spring pulls it back with more than it is pushed: it never goes so far.
    ("turned_back_by_a_force", Broken(&["would come to rest before it had gone the whole way"])),
    ("unit_of_letters", Refused(&["write `as: formula`"])),
    ("unknown_normal", Holds(&["beta = -14.0", "e = 0.500"])),
    ("told_in_another_form", Holds(&["e = 0.667"])),
    ("wall_creates_energy", Refused(&["the ball would leave the wall faster than it arrived (e above 1)"])),
    (
        "weight_in_a_long_impact",
        Refused(&["weight would give the ball 10 % or more of its change of momentum in the impact"]),
    ),
];

/// Answers to one of the files, and how many points they get.
const MARKED: &[(&str, &[&str], &str)] = &[
    ("small_beside_large", &["v_B2=0.0150 m/s", "T_B2=6.75e-4 J", "J_B=0.0900 N s"], "3/3"),
    ("small_beside_large", &["v_B2=-0.25 m/s", "T_B2=0 J", "J_B=0 N s"], "0/3"),
    ("roots_all", &["dt=0.546 or 1.49 s"], "1/1"),
    ("roots_all", &["dt=1.49 s"], "0.5/1"),
    ("displacement_by_its_direction", &["s_D=1.60 m to the right", "s_B=0.400 m to the left"], "2/2"),
    ("displacement_by_its_direction", &["s_D=1.60 m to the left", "s_B=-0.400 m"], "1/2"),
    ("mass_in_terms_of_m", &["J_B=6.30m N s"], "1/1"),
    ("mass_in_terms_of_m", &["J_B=6.30 N s"], "0.5/1"),
    ("mass_in_terms_of_m", &["J_B=6.30 kg m/s"], "0.5/1"),
    ("mass_in_terms_of_m", &["J_B=6.30 m kg"], "0.5/1"),
];

/// What stands on the sheet of a file or in its solution, and what does not.
const PRINTED: &[(&str, &str, &str)] = &[
    ("falls_on_a_string", "is not the answer: particle A moves downwards", "downwards."),
    ("height_in_terms_of_r", "at the height $5\\,R$", "5.00 m"),
    ("letters_behind_values", "where $m_{A}$ is the mass of the cart, and $v_{A1}$ is", "where $m_{B}$"),
    ("mass_in_terms_of_m", "Particle A (mass $3\\,m$)", "3.00 kg"),
    ("restitution_in_symbols", "e = ", "0.1333"),
    ("share_as_a_formula", "q = \\frac{m_{B}}{m_{A} + m_{B}}", "here $"),
];

fn path(name: &str) -> String {
    format!("{}/tests/fixtures/found/{name}.yaml", env!("CARGO_MANIFEST_DIR"))
}

/// Exit code and output.
fn run(arguments: &[&str]) -> (i32, String) {
    let output = Command::cargo_bin("momentous").unwrap().args(arguments).output().unwrap();
    (output.status.code().unwrap(), String::from_utf8(output.stdout).unwrap())
}

/// The answers of the key, each as `id = what is printed`.
fn answers(file: &str) -> Vec<String> {
    let (_, solved) = run(&["solve", file, "--format", "json"]);
    let record: Value = serde_json::from_str(&solved).unwrap();
    let answer = |part: &Value| {
        let printed = part["printed"].as_str().or(part["value"].as_str()).unwrap();
        format!("{} = {printed}", part["id"].as_str().unwrap())
    };
    record["ask"].as_array().unwrap().iter().map(answer).collect()
}

/// What does not become of a file as the table says.
fn differing((name, outcome): &(&str, Outcome)) -> Option<String> {
    let file = path(name);
    let (code, said) = run(&["check", &file, "--seeds", "5"]);
    let (expected, parts) = match outcome {
        Holds(parts) => (0, parts),
        Broken(parts) => (1, parts),
        Refused(parts) => (2, parts),
    };
    let said = match outcome {
        Holds(_) if code == 0 => answers(&file).join("\n"),
        _ => said,
    };
    let missing: Vec<&&str> = parts.iter().filter(|part| !said.contains(**part)).collect();
    (code != expected || !missing.is_empty()).then(|| format!("{name}: exit {code}, without {missing:?}\n{said}"))
}

#[test]
fn each_file_ends_as_the_table_says() {
    let differing: Vec<String> = FOUND.iter().filter_map(differing).collect();
    assert!(differing.is_empty(), "\n{}", differing.join("\n"));
}

#[test]
fn sheets_and_solutions_print_what_the_table_says() {
    for (name, printed, absent) in PRINTED {
        let (_, said) = run(&["generate", &path(name), "--seed", "1", "--solution", "--detailed"]);
        assert!(said.contains(printed) && !said.contains(absent), "{name}: {said}");
    }
}

#[test]
fn marking_says_how_a_multiple_is_written() {
    let (_, said) =
        run(&["grade", "--problem", &path("mass_in_terms_of_m"), "--seed", "1", "--answer", "J_B=6.30 kg m/s"]);
    assert!(said.contains("The question asks for a multiple of `m`"), "{said}");
}

#[test]
fn sides_of_a_comparison_are_named_as_the_author_wrote_them_with_their_values() {
    let (_, solved) = run(&["solve", &path("sides_as_written"), "--format", "json"]);
    assert!(solved.contains("|v_A2| (1.769\u{a0}m/s) is greater than |v_B2| (0.8558\u{a0}m/s)"), "{solved}");
}

#[test]
fn quantities_of_several_stages_are_told_apart_and_a_multiple_keeps_its_letter() {
    for (name, said) in [
        ("order_of_losses", r"T_{\text{lost},\text{second}} < T_{\text{lost},\text{first}}"),
        ("order_of_losses", "with e below 1, part of the kinetic energy is lost in the impact"),
        ("multiple_backwards", r"that is $0.333\,v_{n1}$ to the left"),
        ("height_of_a_counted_bounce", r"\left(\frac{h_{n}}{h_{0}}\right)^{\frac{1}{2\,n}}"),
        ("jerked_along", r"=0.1667\,u"),
        (
            "expression_without_a_label",
            "the velocity of cart B just after the impact minus the velocity of cart A just after the impact, ",
        ),
        ("calculation_of_an_angle", r"$\gamma$ = $\arctan\left(\frac{3}{4}\right)$"),
        ("calculation_of_an_angle", r"$e = \text{4/5} = 0.8$"),
    ] {
        let (_, solved) = run(&["generate", &path(name), "--seed", "1", "--solution", "--detailed"]);
        assert!(solved.contains(said), "{name}: {said}\n{solved}");
    }
}

#[test]
fn every_file_is_in_the_table() {
    let files = fs::read_dir(Path::new(&path("any")).parent().unwrap()).unwrap();
    let files: BTreeSet<String> =
        files.map(|file| file.unwrap().path().file_stem().unwrap().to_str().unwrap().to_owned()).collect();
    let rows: BTreeSet<String> = FOUND.iter().map(|(name, _)| (*name).to_owned()).collect();
    assert_eq!(files, rows);
}

#[test]
fn answers_get_the_points_that_the_table_says() {
    for (name, answers, points) in MARKED {
        let file = path(name);
        let typed = answers.iter().flat_map(|answer| ["--answer", answer]);
        let arguments: Vec<&str> = ["grade", "--seed", "1", "--problem", &file].into_iter().chain(typed).collect();
        let (_, report) = run(&arguments);
        assert!(report.contains(&format!("total: {points}")), "{name}: {answers:?}\n{report}");
    }
}
