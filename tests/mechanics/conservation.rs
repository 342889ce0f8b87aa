//! What is conserved, and of which kind an impact is: decided by identity, by sign, by numbers, or not at all; and never otherwise
//! than the worked solution of the same variant says.

use std::collections::BTreeMap;
use std::sync::Arc;

use momentous::bank::Bank;
use momentous::exercise::Exercise;
use momentous::explain::Audience;
use momentous::explain::Detail;
use momentous::fault::Source;
use momentous::grade::DecimalMark;
use momentous::problem::{Ask, ChoicePart, Loaded, PartKind, ad_hoc, compile, compile_ad_hoc, load};
use momentous::scene::Stage;
use momentous::scene::stage::Partners;

/// A small problem: axes, points and surfaces are always the same.
fn problem(axes: &str, stage: &str, given: &str, ask: &str) -> String {
    format!(
        "id: test/conservation\ntitle: Conservation\nlevel: intro\nscene:\n  axes: {axes}\n  bodies: {{ A: {{ name: block A }}, B: {{ name: block B }} }}\n  \
         surfaces: {{ wall: {{ normal: to the left, velocity: u }}, pad: {{ normal: to the left }} }}\n  points: {{ O: {{ name: the pivot }}, P: {{ name: the post }} }}\n  \
         stages: [ {stage} ]\ngiven: {{ {given} }}\ntext: Something happens.\nask: [ {ask} ]\n"
    )
}

const LINE: &str = "{ x: to the right }";
const UPRIGHT: &str = "{ x: to the right, y: upwards }\n  plane: vertical";
const TURNING: &str = "{ x: [counter-clockwise, clockwise] }";

/// What is decided of each part, with its reason; or the faults.
fn decided(text: &str, seed: u64) -> Result<Vec<(String, String)>, String> {
    let loaded = load(Source::new("conservation.yaml", text)).map_err(|faults| faults.to_string())?;
    let problem = Arc::new(compile_ad_hoc(loaded).map_err(|faults| faults.to_string())?);
    let exercise = Exercise::draw(&problem, 0, seed).map_err(|reason| reason.to_string())?;
    let worked = exercise.worked();
    let decide = |choice: &ChoicePart| {
        let decision = choice.decided(&worked);
        (decision.options[decision.right].clone(), decision.because)
    };
    let parts = worked.form.parts.iter();
    Ok(parts
        .filter_map(|part| if let PartKind::Choice(choice) = &part.kind { Some(decide(choice)) } else { None })
        .collect())
}

const ENERGY: &str = "{ conserved: energy, of: [A, B] }";
const MOMENTUM: &str = "{ conserved: momentum, of: [A] }";
const KIND: &str = "{ classify: impact }";
const NEITHER: &str = "inelastic, but not perfectly";
const HIT: &str = "impact: { between: [A, B] }";
const WITH_E: &str = "impact: { between: [A, B], restitution: e }";

/// Axes, stage, given, question, the right phrase, and a part of its reason.
const ROWS: &[(&str, &str, &str, &str, &str, &str)] = &[
    // Stages that last: equal ends do not suffice.
    (
        UPRIGHT,
        "flight: { body: A, until: y = 0 m }",
        "v_A1.x: 1 m/s, v_A1.y: 9 m/s, r_A1.x: 0 m, r_A1.y: 0 m",
        "{ conserved: energy, of: [A] }",
        "no",
        "its final value equals its initial value, but weight does work",
    ),
    (
        UPRIGHT,
        "flight: { body: A, until: y = -2 m }",
        "v_A1.x: 1 m/s, v_A1.y: 9 m/s, r_A1.x: 0 m, r_A1.y: 0 m",
        "{ conserved: energy, of: [A] }",
        "no",
        "weight does work",
    ),
    (
        UPRIGHT,
        "flight: { body: A, during: 2 s }",
        "v_A1.x: 1 m/s, v_A1.y: 9 m/s, r_A1.x: 0 m, r_A1.y: 0 m",
        "{ conserved: momentum, of: [A], along: x }",
        "yes",
        "",
    ),
    (
        LINE,
        "push: { body: A, during: 2 s, forces: [{ name: the motor, value: 4*t*1 N/s - 4 N }] }",
        "m_A: 2 kg, v_A1: 3 m/s",
        MOMENTUM,
        "no",
        "its final value equals its initial value, but the motor",
    ),
    (
        LINE,
        "push: { body: A, during: 2 s, forces: [{ value: 4 N }, { value: 4 N, direction: to the left }] }",
        "m_A: 2 kg, v_A1: 3 m/s",
        MOMENTUM,
        "yes",
        "cancel at every moment",
    ),
    (
        LINE,
        "push: { body: A, during: 2 s, forces: [{ value: F }] }",
        "m_A: 2 kg, v_A1: 3 m/s, F: 0 N",
        MOMENTUM,
        "yes",
        "",
    ),
    (LINE, "walk: { body: A, on: B, distance: 4 m }", "m_A: 2 kg, m_B: 3 kg", MOMENTUM, "no", "block B"),
    (LINE, "walk: { body: A, on: B, distance: 4 m }", "m_A: 2 kg, m_B: 3 kg", ENERGY, "no", "does work"),
    (TURNING, "rotate: { body: A, about: O, arm: [2 m, 1 m] }", "m_A: 2 kg, v_A1: 3 m/s", ABOUT_O, "yes", "no moment"),
    (
        TURNING,
        "rotate: { body: A, about: O, arm: [2 m, 1 m] }",
        "m_A: 2 kg, v_A1: 3 m/s",
        ABOUT_P,
        "no",
        "has a moment",
    ),
    (
        TURNING,
        "rotate: { body: A, about: O, arm: 2 m }",
        "m_A: 2 kg, v_A1: 3 m/s",
        "{ conserved: energy, of: [A] }",
        "yes",
        "right angles",
    ),
    // A force that is perpendicular to the path all the way does no work; on any other orbit it does.
    (
        POLAR,
        ORBIT,
        "GM: 400 m^3/s^2, r_A1: 4 m, v_A1.theta: 10 m/s, v_A1.r: 0 m/s, m_A: any kg",
        OF_A,
        "yes",
        "perpendicular",
    ),
    (
        POLAR,
        ORBIT,
        "GM: 400 m^3/s^2, r_A1: 4 m, v_A1.theta: 11 m/s, v_A1.r: 0 m/s, m_A: any kg",
        OF_A,
        "no",
        "does work",
    ),
    (
        POLAR,
        ORBIT,
        "GM: 400 m^3/s^2, r_A1: 4 m, v_A1.theta: 10 m/s, v_A1.r: 1 m/s, m_A: any kg",
        OF_A,
        "no",
        "does work",
    ),
    (POLAR, ORBIT, "GM: 400 m^3/s^2, r_A1: 4 m, v_A1.theta: 10 m/s, v_A1.r: 0 m/s", MOMENTUM, "no", "external"),
    (POLAR, ORBIT, "GM: 400 m^3/s^2, r_A1: 4 m, v_A1.theta: 11 m/s, v_A1.r: 0 m/s", ABOUT_O, "yes", "no moment"),
    (POLAR, LEASH, "k: 50 N/m, r_A1: 3 m, v_A1.theta: 10 m/s, v_A1.r: 0 m/s, m_A: 3 kg", OF_A, "yes", "perpendicular"),
    (POLAR, LEASH, "k: 50 N/m, r_A1: 3 m, v_A1.theta: 10 m/s, v_A1.r: 0 m/s, m_A: 2 kg", OF_A, "no", "does work"),
    (POLAR, "central: { body: A, about: O }", "r_A1: 3 m, v_A1.theta: 10 m/s, r_A2: 3 m", OF_A, "no", "does work"),
    // What static friction holds does not move; what it cannot hold does.
    (LINE, PUSHED, "m_A: 20 kg, F: 50 N", MOMENTUM, "yes", "block A stays at rest"),
    (LINE, PUSHED, "m_A: 20 kg, F: 50 N", OF_A, "yes", "nothing moves"),
    (LINE, PUSHED, "m_A: 20 kg, F: 150 N", MOMENTUM, "no", "friction exerts"),
    (LINE, PUSHED, "m_A: 20 kg, F: 150 N", OF_A, "no", "does work"),
    // Sudden stages, by identity, whatever the masses and velocities are.
    (LINE, "impact: { between: [A, B], elastic: true }", ANY, ENERGY, "yes", "elastic"),
    (LINE, "impact: { between: [A, B], elastic: true }", ANY, KIND, "elastic", "e = 1"),
    (LINE, "impact: { between: [A, B], plastic: true }", ANY, KIND, "perfectly plastic", "stay together"),
    (LINE, HIT, ANY, "{ conserved: momentum, of: [A, B] }", "yes", "cancel in pairs"),
    (LINE, "interact: { between: [A, B], elastic: true }", ANY, ENERGY, "yes", "lose no kinetic energy"),
    (
        TURNING,
        "strike: { body: A, about: O, at: 1 m, carries: { B: 2 m }, restitution: e }",
        STRUCK,
        ENERGY,
        "yes",
        "elastic",
    ),
    // By a sign.
    (LINE, "impact: { between: [A, B], plastic: true }", ANY, ENERGY, "no", "stay together"),
    (LINE, WITH_E, "m_A: any kg, m_B: any kg, v_A1: any m/s, v_B1: 0 m/s, e: 0.5", ENERGY, "no", "e below 1"),
    (LINE, WITH_E, "m_A: any kg, m_B: any kg, v_A1: any m/s, v_B1: 0 m/s, e: 0.5", KIND, NEITHER, "between 0 and 1"),
    (LINE, WITH_E, "m_A: any kg, m_B: any kg, v_A1: any m/s, v_B1: 0 m/s, e: 0.5", MOMENTUM, "no", "block B"),
    // By numbers: of e, or of the velocities where nothing names e.
    (LINE, WITH_E, "m_A: any kg, m_B: any kg, v_A1: any m/s, v_B1: 0 m/s, e: 1", KIND, "elastic", "e = 1"),
    (LINE, WITH_E, "m_A: 1 kg, m_B: 1 kg, v_A1: 3 m/s, v_B1: 0 m/s, e: 0", KIND, "perfectly plastic", "e = 0"),
    (
        LINE,
        HIT,
        "m_A: 3 kg, m_B: 2 kg, v_A1: 12 m/s, v_B1: -2 m/s, v_A2: 0.8 m/s",
        KIND,
        "elastic",
        "no kinetic energy is lost",
    ),
    (LINE, HIT, "m_A: 3 kg, m_B: 2 kg, v_A1: 12 m/s, v_B1: -2 m/s, v_A2: 0.8 m/s", ENERGY, "yes", "elastic"),
    (LINE, HIT, "m_A: 3 kg, m_B: 2 kg, v_A1: 12 m/s, v_B1: -2 m/s, v_A2: 1.5 m/s", KIND, NEITHER, "separate"),
    (
        LINE,
        HIT,
        "m_A: 1 kg, m_B: 3 kg, v_A1: 3 m/s, v_B1: -1 m/s, v_A2: 0 m/s",
        KIND,
        "perfectly plastic",
        "stay together",
    ),
    (
        LINE,
        HIT,
        "m_A: 1 kg, m_B: 3 kg, v_A1: 3 m/s, v_B1: -1 m/s, v_A2: 0 m/s",
        ENERGY,
        "no",
        "part of the kinetic energy is lost",
    ),
    // 222.8 J and 222.7 J, from data of three figures.
    (
        LINE,
        HIT,
        NEARLY,
        ENERGY,
        "yes",
        "222.8\u{a0}J before and 222.7\u{a0}J after are equal within the precision of the data",
    ),
    (LINE, HIT, NEARLY, KIND, "elastic", "within the precision of the data"),
    // A single body may keep its energy by its numbers: it bounces back from a heavier one as fast as it came.
    (
        LINE,
        "impact: { between: [A, B], elastic: true }",
        "m_A: 1 kg, m_B: 3 kg, v_A1: 3 m/s, v_B1: -3 m/s",
        OF_A,
        "no",
        "the other body",
    ),
    (
        LINE,
        "impact: { between: [A, B], elastic: true }",
        "m_A: 1 kg, m_B: 1 kg, v_A1: 3 m/s, v_B1: -3 m/s",
        OF_A,
        "yes",
        "the same",
    ),
    (
        LINE,
        "impact: { body: A, against: pad }",
        "m_A: any kg, v_A1: 4 m/s, v_A2: -4 m/s",
        KIND,
        "elastic",
        "no kinetic energy",
    ),
    (
        LINE,
        "impact: { body: A, against: wall, restitution: 1 }",
        "m_A: any kg, v_A1: 4 m/s, u: -1 m/s",
        KIND,
        "elastic",
        "e = 1",
    ),
    (
        LINE,
        "impact: { body: A, against: wall, restitution: 1 }",
        "m_A: 2 kg, v_A1: 4 m/s, u: -1 m/s",
        OF_A,
        "no",
        "the surface moves",
    ),
];

const POLAR: &str = "polar";
const ORBIT: &str = "central: { body: A, about: O, gravity: GM }";
const LEASH: &str = "central: { body: A, about: O, spring: { stiffness: k, unstretched: 1 m } }";
const PUSHED: &str =
    "push: { body: A, during: 2 s, forces: [{ value: F }, { friction: { static: 0.5, kinetic: 0.4 } }] }";
const ABOUT_O: &str = "{ conserved: angular-momentum, of: [A], about: O }";
const ABOUT_P: &str = "{ conserved: angular-momentum, of: [A], about: P }";
const OF_A: &str = "{ conserved: energy, of: [A] }";
const ANY: &str = "m_A: any kg, m_B: any kg, v_A1: any m/s, v_B1: 0 m/s";
const STRUCK: &str = "m_A: any kg, m_B: any kg, v_A1: any m/s, omega_1: 0 rad/s, e: 1";
const NEARLY: &str = "m_A: 3.00 kg, m_B: 2.00 kg, v_A1: 12.0 m/s, v_B1: -2.61 m/s, v_A2: 0.314 m/s";

#[test]
fn each_question_has_its_answer_and_its_reason() {
    let mut wrong = Vec::new();
    for (axes, stage, given, ask, answer, reason) in ROWS {
        match decided(&problem(axes, stage, given, ask), 1) {
            Ok(decisions) if decisions[0].0 == *answer && decisions[0].1.contains(reason) => {}
            other => wrong.push(format!("{stage} {given} {ask}: {other:?}, not {answer} ({reason})")),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn what_nothing_decides_is_an_author_s_fault() {
    let rows = [
        (LINE, HIT, ANY, KIND, "the kind of the impact depends on `m_A`"),
        (LINE, HIT, ANY, ENERGY, "which can have any value"),
        (
            LINE,
            WITH_E,
            "m_A: 1 kg, m_B: 1 kg, v_A1: 3 m/s, v_B1: 0 m/s, e: any",
            ENERGY,
            "whether the kinetic energy of block A and block B is conserved",
        ),
        (
            TURNING,
            "rotate: { body: A, about: O, arm: 2 m }",
            "m_A: 2 kg, v_A1: 3 m/s",
            "{ conserved: angular-momentum, of: [A], about: Q }",
            "there is no point `Q` in this scene",
        ),
        (
            TURNING,
            "rotate: { body: A, about: O, arm: 2 m }",
            "m_A: 2 kg, v_A1: 3 m/s",
            "{ conserved: angular-momentum, of: [A] }",
            "the point of the angular momentum is missing",
        ),
        (
            LINE,
            HIT,
            "m_A: 1 kg, m_B: 1 kg, v_A1: 3 m/s, v_B1: 0 m/s, v_A2: 1 m/s",
            "{ conserved: energy, of: [A, B], about: Q }",
            "there is no point `Q`",
        ),
    ];
    for (axes, stage, given, ask, said) in rows {
        let found = decided(&problem(axes, stage, given, ask), 1);
        assert!(found.as_ref().is_err_and(|faults| faults.contains(said)), "{stage} {given} {ask}: {found:?}");
    }
}

/// Between half a unit of each last place and twice that, nothing is said.
#[test]
fn values_too_close_to_call_are_refused_by_check() {
    let given = "m_A: 3.00 kg, m_B: 2.00 kg, v_A1: 12.0 m/s, v_B1: -2.00 m/s, v_A2: 0.86 m/s";
    let text = problem(LINE, HIT, given, KIND);
    let problem = compile_ad_hoc(load(Source::new("close.yaml", &text)).unwrap()).map(Arc::new).unwrap();
    let exercise = Exercise::draw(&problem, 0, 1).unwrap();
    let PartKind::Choice(choice) = &exercise.worked().form.parts[0].kind else { panic!("a choice") };
    assert!(choice.unclear(&exercise.worked()).is_some_and(|values| values.contains("220.0\u{a0}J before")));
}

/// A problem of the bank asked anew: the energy lost in an impact of two bodies, its kind, and what is conserved.
fn asked_anew(loaded: &Loaded, index: usize, bodies: &[&str; 2]) -> Option<Arc<momentous::problem::Problem>> {
    let name = loaded.draft.scene.stages[index].name().unwrap_or("impact").to_owned();
    let suffix = if loaded.draft.scene.stages.len() > 1 { format!("[{}]", index + 1) } else { String::new() };
    let mut changed = ad_hoc(loaded, 0, &[], &[format!("T_lost{suffix}")]).ok()?;
    let [first, second] = bodies;
    for ask in [
        format!("{{ classify: impact, stage: {name} }}"),
        format!("{{ conserved: energy, of: [{first}, {second}], stage: {name} }}"),
        format!("{{ conserved: momentum, of: [{first}, {second}], stage: {name} }}"),
    ] {
        let ask: Ask = serde_yaml::from_str(&ask).unwrap();
        changed.questions[0].ask.push(ask);
    }
    compile_ad_hoc(changed).ok().map(Arc::new)
}

/// For each impact of two bodies in the bank: key, worked solution, sheet and diagnosis of a variant say the same.
#[test]
fn key_solution_sheet_and_diagnosis_never_contradict_each_other() {
    let mut seen = BTreeMap::new();
    for source in Bank::built_in().sources() {
        let loaded = load(source.clone()).unwrap();
        compile(loaded.clone(), None).unwrap();
        for (index, stage) in loaded.draft.scene.stages.iter().enumerate() {
            let Stage::Impact(impact) = stage else { continue };
            let Some(Partners::Bodies(first, second)) = impact.partners() else { continue };
            let Some(problem) = asked_anew(&loaded, index, &[first, second]) else { continue };
            for seed in 1..=3 {
                let Ok(exercise) = Exercise::draw(&problem, 0, seed) else { continue };
                let worked = exercise.worked();
                let right: Vec<String> = (worked.form.parts.iter())
                    .filter_map(|part| match &part.kind {
                        PartKind::Choice(choice) => Some(choice.decided(&worked)),
                        _ => None,
                    })
                    .map(|decision| decision.options[decision.right].clone())
                    .collect();
                let [kind, energy, _] = &right[..] else { panic!("{}: {right:?}", source.name) };
                let said = format!("{} seed {seed}: {right:?}", source.name);
                assert_eq!(kind == "elastic", energy == "yes", "{said}");
                let solution = format!("{:?}", exercise.outline(Audience::Everyone, Detail::Full));
                assert_eq!(solution.contains("one is lost: the impact is elastic"), kind == "elastic", "{said}");
                let mut numbers = worked.form.parts.iter().flat_map(momentous::problem::Part::numbers);
                let lost = numbers.next().map(|(_, number)| worked.answer(number));
                let is_nothing = lost.map(|lost| lost.value.abs() <= lost.error.max(1e-9));
                assert!(is_nothing.is_none_or(|is_zero| is_zero == (kind == "elastic")), "{said}: {lost:?}");
                for (place, wrong) in [(2, if energy == "yes" { "no" } else { "yes" }), (3, "no")] {
                    let id = worked.form.parts[place].id.clone();
                    let report = exercise.grade(&BTreeMap::from([(id, wrong.to_owned())]), DecimalMark::Point);
                    let codes = report.parts[place]
                        .diagnosis
                        .as_ref()
                        .map(|diagnosis| diagnosis.codes.join(" "))
                        .unwrap_or_default();
                    assert!(energy == "no" || !codes.contains("momentum-judged-by-energy"), "{said}: {codes}");
                    assert!(energy == "no" || !codes.contains("energy-judged-by-momentum"), "{said}: {codes}");
                }
                *seen.entry(kind.clone()).or_insert(0) += 1;
            }
        }
    }
    assert!(seen.len() == 3 && seen.values().sum::<usize>() > 60, "{seen:?}");
}
