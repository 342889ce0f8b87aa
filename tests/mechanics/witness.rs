//! Every answer of the bank has an independent simulation that would find out a wrong one.

use std::path::Path;

use momentous::bank::AnswerSpread;
use momentous::bank::Audit;
use momentous::bank::Bank;
use momentous::bank::FormAudit;
use momentous::bank::Outcome;
use momentous::bank::Promise;
use momentous::bank::Seeds;
use momentous::bank::audit;
use momentous::bank::files_under;
use momentous::fault::Source;
use momentous::render::Renderer;

/// Seeds for each form; the first says whether wrong answers are found out, the others that right ones are not.
const SEEDS: u64 = 2;

/// So many seeds, all of them simulated.
fn first(seeds: u64) -> Seeds {
    Seeds { drawn: seeds, simulated: seeds }
}

fn audits() -> Vec<Audit> {
    let bank = Bank::in_folder(Path::new("problem_bank")).unwrap();
    let renderer = Renderer::new(None).unwrap();
    bank.select(&[]).unwrap().iter().map(|source| audit(source, first(SEEDS), &renderer)).collect()
}

/// Published problems, which were collected for their answers and not for what can be simulated.
#[test]
fn what_books_ask_is_not_contradicted() {
    let bank = Bank::in_folder(Path::new("problem_bank")).unwrap();
    let renderer = Renderer::new(None).unwrap();
    let (mut contradicted, mut witnessed, mut forms) = (Vec::new(), 0, 0);
    for path in files_under(Path::new("tests/fixtures/reference")).unwrap() {
        let Ok(source) = bank.open(&path.to_string_lossy()) else { continue };
        for form in audit(&source, first(1), &renderer).forms {
            forms += 1;
            witnessed += usize::from(form.simulation.is_whole());
            if matches!(form.outcome(Promise::Simulation), Some(Outcome::Broken(_))) {
                contradicted.push(format!("{}: {:?}", path.display(), form.outcome(Promise::Simulation)));
            }
        }
    }
    assert_eq!(contradicted, Vec::<String>::new());
    assert!(4 * witnessed >= 3 * forms && forms > 100, "{witnessed} of {forms}");
}

#[test]
fn every_answer_of_the_bank_is_witnessed_and_a_wrong_one_found_out() {
    let audits = audits();
    let forms: Vec<(&Audit, &FormAudit)> =
        audits.iter().flat_map(|audit| audit.forms.iter().map(move |form| (audit, form))).collect();
    let named =
        |(audit, form): &(&Audit, &FormAudit)| format!("{:?} {:?}: {:?}", audit.problem, form.form, form.simulation);
    let broken = forms.iter().filter(|(_, form)| matches!(form.outcome(Promise::Simulation), Some(Outcome::Broken(_))));
    assert_eq!(broken.map(named).collect::<Vec<_>>(), Vec::<String>::new());
    // `unseen` are answers that were put wrong by 0.1 % without the simulation finding it out.
    let unseen: Vec<String> = forms.iter().filter(|(_, form)| !form.simulation.is_whole()).map(named).collect();
    assert!(forms.len() > 100 && unseen.is_empty(), "{unseen:#?}");
    // Bounds are small beside what they bound, or agreement would mean nothing.
    let loose: Vec<String> = forms.iter().filter(|(_, form)| form.simulation.bound > 1e-4).map(named).collect();
    assert_eq!(loose, Vec::<String>::new());
}

/// Questions of conservation that equal ends would answer wrongly, or forces that do nothing: axes, stage, given, question.
const CONSERVED: [(&str, &str, &str, &str); 4] = [
    (
        "{ x: [counter-clockwise, clockwise] }",
        "rotate: { body: A, about: O, arm: 2 m, moment: 4*t*1 J/s - 4 J, during: 2 s }",
        "m_A: 2 kg, v_A1: 3 m/s",
        "{ conserved: angular-momentum, of: [A], about: O }",
    ),
    (
        "{ x: [counter-clockwise, clockwise] }",
        "rotate: { body: A, about: O, arm: [2 m, 1 m] }",
        "m_A: 2 kg, v_A1: 3 m/s",
        "{ conserved: angular-momentum, of: [A], about: O }",
    ),
    (
        "polar",
        "central: { body: A, about: O, gravity: GM }",
        "GM: 400 m^3/s^2, r_A1: 4 m, v_A1.theta: 11 m/s, v_A1.r: 0 m/s, r_A2: 5 m",
        "{ conserved: angular-momentum, of: [A], about: O }",
    ),
    (
        "{ x: to the right }",
        "push: { body: A, during: 2 s, forces: [{ value: F }, { friction: { static: 0.5, kinetic: 0.4 } }] }",
        "m_A: 20 kg, F: 50 N, v_A1: 0 m/s",
        "{ conserved: momentum, of: [A] }",
    ),
];

#[test]
fn what_is_conserved_all_the_way_is_witnessed() {
    let renderer = Renderer::new(None).unwrap();
    for (axes, stage, given, ask) in CONSERVED {
        let printed: Vec<String> =
            given.split(", ").filter_map(|entry| Some(format!("{{{{ {} }}}}", entry.split_once(':')?.0))).collect();
        let text = format!(
            "id: a/b\ntitle: A\nlevel: intro\nscene:\n  axes: {axes}\n  bodies: {{ A: {{ name: block A }} }}\n  points: {{ O: {{ name: the pivot }} }}\n  \
             stages: [ {stage} ]\ngiven: {{ {given} }}\ntext: >\n  {}\nask: [ {ask} ]\n",
            printed.join(" ")
        );
        let audit = audit(&Source::new("a.yaml", &text), first(1), &renderer);
        let [form] = &audit.forms[..] else { panic!("{stage}: {audit:?}") };
        assert!(form.simulation.is_whole(), "{stage}: {:?}", form.simulation);
        assert!(
            matches!(form.outcome(Promise::Simulation), Some(Outcome::Kept)),
            "{stage}: {:?}",
            form.outcome(Promise::Simulation)
        );
    }
}

/// Questions of whether there is enough information, in scenes with another quantity open: what is given, what is asked, what is so.
/// With neither e nor a velocity afterwards momentum is one equation for two velocities: `OpenStax`, College Physics 2e, section 8.4,
/// takes the second one from the impact being elastic.
const ENOUGH: [(&str, &str, &str); 6] = [
    ("m_A: 0.5 kg, m_B: 3.5 kg, v_A1: 4 m/s, v_B1: 0 m/s", "v_A2", "no"),
    ("m_A: 0.5 kg, m_B: 3.5 kg, v_A1: 4 m/s, v_B1: 0 m/s, e: 1", "v_A2", "yes"),
    ("m_A: 0.5 kg, m_B: 3.5 kg, v_A1: 4 m/s, v_B1: 0 m/s", "v_G2", "yes"),
    ("m_A: 0.5 kg, m_B: 3.5 kg, v_A1: 4 m/s, v_B1: 0 m/s, v_A2: -1.6 m/s", "v_B2", "yes"),
    ("m_B: 3.5 kg, v_A1: 4 m/s, v_B1: 0 m/s, v_A2: -1.6 m/s", "v_B2", "no"),
    ("m_A: 0.5 kg, v_A1: 4 m/s, v_B1: 0 m/s, v_A2: -1.6 m/s", "J_B", "yes"),
];

#[test]
fn whether_there_is_enough_information_is_witnessed_by_worlds_that_print_the_same_sheet() {
    let renderer = Renderer::new(None).unwrap();
    for (given, sought, right) in ENOUGH {
        let printed: Vec<String> =
            given.split(", ").filter_map(|entry| Some(format!("{{{{ {} }}}}", entry.split_once(':')?.0))).collect();
        let text = format!(
            "id: a/b\ntitle: A\nlevel: intro\nscene:\n  axes: {{ x: to the right }}\n  bodies: {{ A: {{ name: cart A }}, B: {{ name: cart B }} }}\n  \
             stages: [ {{ impact: {{ between: [A, B], restitution: e }} }} ]\ngiven: {{ {given} }}\ntext: >\n  {}\nask: [ {{ enough: {sought} }} ]\n",
            printed.join(" ")
        );
        let audit = audit(&Source::new("a.yaml", &text), first(1), &renderer);
        let [form] = &audit.forms[..] else { panic!("{given}: {audit:?}") };
        let [AnswerSpread::Choice { right: found, .. }] = &form.answers[..] else { panic!("{given}: {form:?}") };
        assert_eq!(found.keys().map(String::as_str).collect::<Vec<_>>(), [right], "{sought} from {given}");
        assert!(form.simulation.is_whole(), "{sought} from {given}: {:?}", form.simulation);
        let outcome = form.outcome(Promise::Simulation);
        assert!(matches!(outcome, Some(Outcome::Kept)), "{sought} from {given}: {outcome:?}");
    }
}
