//! Questions of yes or no about a scene, held against what the numbers of the same scene say.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use momentous::bank::Bank;
use momentous::exercise::Exercise;
use momentous::fault::Source;
use momentous::grade::DecimalMark;
use momentous::model::Timeline;
use momentous::problem::{Ask, Conservable, Conserved, Loaded, PartKind, ad_hoc, compile, compile_ad_hoc, load};
use momentous::scene::{Axis, Stage};

/// Seeds of which one at least must show that something is not conserved.
const SEEDS: u64 = 3;

/// The share of its parts by which a sum may change with rounding.
const ROUNDING: f64 = 1e-9;

/// What is asked of a stage: whether something is conserved for some bodies, with the names of its parts before and after.
struct Question {
    ask: Conserved,
    names: [Vec<String>; 2],
}

/// What a seed says: whether it is said to be conserved and why, and by which share of its parts it changes.
struct Seen {
    holds: bool,
    because: String,
    change: f64,
}

/// The question put to a problem, seed by seed; nothing where the problem does not tell enough to look at the numbers.
fn seen(loaded: &Loaded, question: &Question) -> Vec<Seen> {
    let Ok(mut changed) = ad_hoc(loaded, 0, &[], &question.names.concat()) else { return Vec::new() };
    changed.questions[0].ask.push(Ask::Conserved(question.ask.clone()));
    let Ok(problem) = compile_ad_hoc(changed).map(Arc::new) else { return Vec::new() };
    let look = |seed| {
        let exercise = Exercise::draw(&problem, 0, seed).ok()?;
        let PartKind::Choice(choice) = &exercise.worked().form.parts.last()?.kind else { return None };
        let decision = choice.decided(&exercise.worked());
        let value = |name: &String| {
            let symbol = problem.model().symbol_of(name)?;
            Some(exercise.variant().value(symbol)?.value)
        };
        let sides: Vec<Vec<f64>> =
            question.names.iter().map(|names| names.iter().map(value).collect()).collect::<Option<_>>()?;
        let [before, after] = [0, 1].map(|end: usize| sides[end].iter().sum::<f64>());
        let size: f64 = sides.iter().flatten().map(|part| part.abs()).sum();
        // Where everything is zero the numbers say nothing.
        if size == 0.0 {
            return None;
        }
        let change = (before - after).abs() / size;
        let holds = decision.options[decision.right] == "yes";
        Some(Seen { holds, because: decision.because, change })
    };
    (1..=SEEDS).filter_map(look).collect()
}

/// Every question of conservation that can be put to a stage, for everything that is there.
fn questions(loaded: &Loaded, index: usize) -> Vec<Question> {
    let scene = &loaded.draft.scene;
    let timeline = Timeline::new(scene);
    let stage = &scene.stages[index];
    let key = stage.name().unwrap_or_else(|| stage.key());
    let [before, after] = [index + 1, index + 2].map(|instant| timeline.alive(instant));
    // What becomes one, or comes apart, is asked of by its parts.
    let of: Vec<String> =
        if before.len() < after.len() { &after } else { &before }.iter().map(ToString::to_string).collect();
    let question = |conserved, letter: &str, along: Option<Axis>, component: &str| Question {
        ask: Conserved {
            conserved,
            of: of.clone(),
            along,
            about: None,
            stage: Some(key.to_owned()),
            points: None,
            label: None,
        },
        names: [(&before, index + 1), (&after, index + 2)].map(|(bodies, instant)| {
            bodies.iter().map(|body| format!("{letter}_{body}{instant}{component}")).collect()
        }),
    };
    let axes = scene.axes.rectangular();
    let component = |axis: Axis| if axes.len() > 1 { format!(".{}", axis.letter()) } else { String::new() };
    let mut questions = vec![question(Conservable::Energy, "T", None, "")];
    questions.extend(axes.iter().map(|(axis, _)| question(Conservable::Momentum, "p", Some(*axis), &component(*axis))));
    questions
}

/// For every stage of the bank: what is said to be conserved does not change, and what is said not to be does so with some
/// seed.
#[test]
fn what_is_said_to_be_conserved_is_conserved() {
    let (mut kept, mut lost) = (0, 0);
    let mut wrong = Vec::new();
    for source in Bank::built_in().sources() {
        let loaded = load(source.clone()).unwrap();
        for (index, stage) in loaded.draft.scene.stages.iter().enumerate() {
            // A rocket is not the same body before and after.
            if matches!(stage, Stage::Thrust(_)) {
                continue;
            }
            for question in questions(&loaded, index) {
                let seen = seen(&loaded, &question);
                let said = seen.iter().map(|seen| format!("{} ({}), {:e}", seen.holds, seen.because, seen.change));
                let said = format!("{} {:?} {said:?}", source.name, question.names, said = said.collect::<Vec<_>>());
                let changes = |seen: &&Seen| seen.change > ROUNDING;
                let refused: Vec<&Seen> = seen.iter().filter(|seen| !seen.holds).collect();
                if seen.iter().filter(changes).any(|seen| seen.holds) {
                    wrong.push(said.clone());
                }
                if !refused.is_empty() && !refused.iter().any(|seen| seen.change > ROUNDING) {
                    wrong.push(said);
                }
                kept += seen.len() - refused.len();
                lost += refused.len();
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(kept > 50 && lost > 50, "{kept} {lost}");
}

/// What is decided of the parts of a small problem: yes or no, or another phrase, each with its reason.
fn decisions(scene: &str, given: &str, ask: &str, seed: u64) -> Vec<(String, String)> {
    let text = format!(
        "id: test/concept\ntitle: Concept\nlevel: intro\nscene:\n  axes: {{ x: to the right }}\n  bodies: {{ A: {{ name: block A }}, B: {{ name: block B }} }}\n  surfaces: {{ wall: {{ normal: to the left, velocity: u }}, pad: {{ normal: to the left }} }}\n  stages: [ {scene} ]\ngiven: {{ {given} }}\ntext: Something happens.\nask: [ {ask} ]\n"
    );
    let loaded = load(Source::new("concept.yaml", &text)).unwrap_or_else(|faults| panic!("{faults}\n{text}"));
    let problem = Arc::new(compile_ad_hoc(loaded).unwrap_or_else(|faults| panic!("{faults}\n{text}")));
    let exercise = Exercise::draw(&problem, 0, seed).unwrap_or_else(|reason| panic!("{reason}\n{text}"));
    let parts = exercise.worked().form.parts.iter();
    let decided = parts.filter_map(|part| match &part.kind {
        PartKind::Choice(choice) => Some(choice.decided(&exercise.worked())),
        _ => None,
    });
    decided.map(|decision| (decision.options[decision.right].clone(), decision.because)).collect()
}

#[test]
fn what_acts_along_the_way_decides() {
    let energy = "{ conserved: energy, of: [A, B] }";
    let both = "m_A: 1 kg, m_B: 1 kg, v_A1: 0 m/s, dt: 1 s";
    let rows = [
        (
            "slide: { body: A, duration: 1 s }",
            "{ conserved: momentum, of: [A] }",
            "v_A1: 5 m/s",
            "yes",
            "no external impulse",
        ),
        (
            "slide: { body: A, friction: 0.1, duration: 1 s }",
            "{ conserved: momentum, of: [A] }",
            "v_A1: 5 m/s",
            "no",
            "friction",
        ),
        (
            "slide: { body: A, incline: 20 deg above +x, duration: 1 s }",
            "{ conserved: momentum, of: [A] }",
            "v_A1: 9 m/s",
            "no",
            "weight",
        ),
        (
            "slide: { body: A, friction: 0.1, duration: 1 s }",
            "{ conserved: energy, of: [B] }",
            "v_A1: 5 m/s",
            "yes",
            "",
        ),
        (
            "connected: { trailing: { body: A, on: level }, leading: { body: B }, duration: dt }",
            energy,
            both,
            "no",
            "but weight does work on block B",
        ),
        (
            "connected: { trailing: { body: A, on: level, friction: 0.2 }, leading: { body: B }, duration: dt }",
            energy,
            both,
            "no",
            "but friction does work on block A, and weight does work on block B",
        ),
        (
            "connected: { trailing: { body: A }, leading: { body: B }, duration: dt }",
            "{ conserved: energy, of: [A] }",
            "m_A: 1 kg, m_B: 2 kg, v_A1: 0 m/s, dt: 1 s",
            "no",
            "the string does work on block A",
        ),
        // Equal masses hang in balance.
        (
            "connected: { trailing: { body: A }, leading: { body: B }, duration: dt }",
            "{ conserved: energy, of: [A] }",
            both,
            "yes",
            "the total power of the other forces is zero",
        ),
        (
            "impact: { between: [A, B], elastic: true }",
            "{ conserved: energy, of: [A] }",
            "m_A: 1 kg, m_B: 1 kg, v_A1: 5 m/s, v_B1: 0 m/s",
            "no",
            "the other body",
        ),
        (
            "impact: { body: A, against: wall, restitution: 1 }",
            "{ conserved: energy, of: [A] }",
            "m_A: 1 kg, v_A1: 5 m/s, u: 1 m/s",
            "no",
            "the surface moves",
        ),
        (
            "impact: { body: A, against: pad, restitution: 1 }",
            "{ conserved: energy, of: [A] }",
            "m_A: 1 kg, v_A1: 5 m/s",
            "yes",
            "elastic",
        ),
    ];
    for (scene, ask, given, answer, reason) in rows {
        let (found, because) = decisions(scene, given, ask, 1).remove(0);
        assert_eq!(found, answer, "{scene}: {because}");
        assert!(because.contains(reason), "{scene}: {because}");
    }
}

/// The same question has another answer where the coefficient of restitution is another: drawn, or worked out first.
#[test]
fn the_coefficient_of_restitution_of_the_variant_decides() {
    let ask = "{ conserved: energy, of: [A, B] }, { classify: impact }";
    let scene = "impact: { between: [A, B], restitution: e }";
    let masses = "m_A: 2 kg, m_B: 2 kg, v_A1: 4 m/s, v_B1: 0 m/s";
    let rows = [
        ("0", ["no", "perfectly plastic"]),
        ("0.0", ["no", "perfectly plastic"]),
        ("0.5", ["no", "inelastic, but not perfectly"]),
        ("1", ["yes", "elastic"]),
    ];
    for (e, expected) in rows {
        let found = decisions(scene, &format!("{masses}, e: {e}"), ask, 1);
        assert_eq!(found.iter().map(|row| row.0.as_str()).collect::<Vec<_>>(), expected, "e = {e}");
    }
    // e = (v_B2 - v_A2)/(v_A1 - v_B1), and v_A2 = 4 m/s - v_B2.
    for (v, expected) in
        [("2 m/s", "perfectly plastic"), ("3 m/s", "inelastic, but not perfectly"), ("4 m/s", "elastic")]
    {
        let found = decisions(scene, &format!("{masses}, v_B2: {v}"), ask, 1);
        assert_eq!(found[1].0, expected, "v_B2 = {v}");
    }
    let drawn = format!("{masses}, e: {{ one_of: [0, 0.4, 1] }}");
    let kinds: std::collections::BTreeSet<String> =
        (1..40).map(|seed| decisions(scene, &drawn, ask, seed)[1].0.clone()).collect();
    assert_eq!(kinds.len(), 3, "{kinds:?}");
}

/// A solution speaks of a ground or a floor only where its problem does, of a wall only where there is one.
#[test]
fn what_is_left_out_is_something_that_the_scene_could_have() {
    let mut omissions = 0;
    for source in Bank::built_in().sources() {
        let problem = compile(load(source.clone()).unwrap(), None).unwrap();
        let words = source.text.to_lowercase();
        for omission in &problem.model().omissions {
            omissions += 1;
            let said = format!("{} {}", omission.what, omission.why);
            for place in ["ground", "floor", "table", "track"] {
                let slides = ["slide", "push", "spring"].iter().any(|stage| words.contains(&format!("- {stage}:")));
                let fits = words.contains(place) || place == "floor" && slides;
                assert!(!said.contains(place) || fits, "{}: {said}", source.name);
            }
        }
    }
    assert!(omissions > 100, "{omissions}");
}

/// Bank problem, form, part, what is answered, and the mistake that is behind it.
const MISJUDGED: &[(&str, &str, &str, &str, Option<&str>)] = &[
    ("concepts/two-trains", "concepts", "a", "no", Some("momentum-judged-by-energy")),
    ("concepts/two-trains", "concepts", "b", "yes", Some("part-for-system")),
    ("concepts/egg-drop", "concepts", "b", "yes", Some("outside-impulse-overlooked")),
    ("concepts/egg-drop", "concepts", "c", "no", Some("impulsive-force-as-ordinary")),
    ("concepts/egg-drop", "concepts", "d", "yes", Some("ordinary-force-as-impulsive")),
    ("concepts/egg-drop", "concepts", "d", "no", None),
    ("concepts/egg-drop", "concepts", "e", "elastic", None),
];

#[test]
fn a_wrong_judgement_is_told_from_the_mistake_behind_it() {
    let bank = Bank::in_folder(Path::new("problem_bank")).unwrap();
    for (id, form, part, text, behind) in MISJUDGED {
        let problem = Arc::new(load(bank.open(id).unwrap()).and_then(|loaded| compile(loaded, None)).unwrap());
        let form = problem.form(Some(form)).unwrap();
        let exercise = Exercise::draw(&problem, form, 1).unwrap();
        let answers = BTreeMap::from([((*part).to_owned(), (*text).to_owned())]);
        let report = exercise.grade(&answers, DecimalMark::Point);
        let reported = report.parts.iter().find(|reported| reported.id == *part).unwrap();
        let found = reported.diagnosis.as_ref().map(|diagnosis| diagnosis.codes.clone());
        assert_eq!(found, behind.map(|code| vec![code]), "{id}: {part} = {text}");
        assert!(reported.verdict.is_right() || reported.points.0 == 0.into(), "{id}: {part} = {text}");
    }
}
