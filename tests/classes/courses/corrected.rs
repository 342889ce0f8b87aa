//! A corrected problem taken into an assignment: what is said before, and what becomes of marks, solutions and key.

use super::handed::{Handed, right, text};
use super::university::DAY;

#[test]
fn a_corrected_problem_is_previewed_and_taken_in_once() {
    let handed = Handed::new();
    let (mut ida, mut second) = (handed.university.browser_of("ida"), handed.university.browser_of("ida"));
    let address = handed.assignment("/regrade");
    assert!(ida.get(&address).text(200).contains("No problem of this assignment has changed"));
    // Of 2 + 2 + 1 points Ada has 2; of 7 + 2 + 1 she has 7.
    handed.publish(&text().replace("v_A2, unit: m/s, points: 2", "v_A2, unit: m/s, points: 7"));
    let page = ida.get(&address).text(200);
    assert!(page.contains("It draws every sheet as it was handed out (1)"), "{page}");
    assert!(
        page.contains("<th scope=\"row\">ada &lt;script&gt;</th><td>4</td><td>7</td><td>7</td><td>10</td><td>–</td>"),
        "{page}"
    );
    assert_eq!(handed.row(), "ada,ada <script>,A,4,4,10", "a preview changes nothing");
    let fields = Handed::choice(&page, "remark");
    assert_eq!(
        ida.post(&address, &[&fields[..3], &[("choice", "issue_anew")]].concat()).status,
        400,
        "it is not offered"
    );
    ida.post(&address, &fields).to();
    assert_eq!(handed.row(), "ada,ada <script>,A,7,7,10");
    let late = second.post(&address, &fields).text(409);
    assert!(late.contains("nothing was done") || late.contains("Nothing was done"), "{late}");
    assert!(ida.get(&address).text(200).contains("No problem of this assignment has changed"));
    // What is handed in from now on is marked by the corrected problem.
    let answers = right(&handed.university, "ada");
    let mut ada = handed.university.browser_of("ada");
    ada.post(&handed.item(""), &[("request", "3"), ("answer.T_lost", &answers["T_lost"])]).to();
    assert_eq!(handed.row(), "ada,ada <script>,A,8,8,10");
}

#[test]
fn an_answer_that_comes_between_preview_and_change_is_not_overlooked() {
    let handed = Handed::new();
    handed.publish(&text().replace("v_A2, unit: m/s, points: 2", "v_A2, unit: m/s, points: 7"));
    let mut ida = handed.university.browser_of("ida");
    let page = ida.get(&handed.assignment("/regrade")).text(200);
    let answers = right(&handed.university, "ada");
    let mut ada = handed.university.browser_of("ada");
    ada.post(&handed.item(""), &[("request", "2"), ("answer.T_lost", &answers["T_lost"])]).to();
    ida.post(&handed.assignment("/regrade"), &Handed::choice(&page, "remark")).to();
    assert_eq!(handed.row(), "ada,ada <script>,A,8,8,10", "both attempts are marked anew");
}

#[test]
fn where_a_problem_draws_something_else_the_instructor_chooses() {
    let other = text().replace("v_A2, unit: m/s, points: 2", "v_A2, unit: km/h, points: 2");
    for (choice, row, issue) in [
        ("full_marks", "ada,ada <script>,A,10,10,10", 0),
        ("drop", "ada,ada <script>,A,0,0", 0),
        ("issue_anew", "ada,ada <script>,A,,0,10", 1),
    ] {
        let handed = Handed::new();
        handed.publish(&other);
        let mut ida = handed.university.browser_of("ida");
        let page = ida.get(&handed.assignment("/regrade")).text(200);
        assert!(page.contains("Of 1 sheet it draws 1 otherwise"), "{page}");
        let refused = ida.post(&handed.assignment("/regrade"), &Handed::choice(&page, "remark"));
        assert_eq!(refused.status, 400, "nothing can be marked again");
        ida.post(&handed.assignment("/regrade"), &Handed::choice(&page, choice)).to();
        assert_eq!((handed.row().as_str(), handed.kept().issue), (row, issue), "{choice}");
        assert!(
            ida.get(&handed.assignment("/regrade")).text(200).contains("No problem of this assignment has changed"),
            "{choice}"
        );
        let mut ada = handed.university.browser_of("ada");
        let sheet = ada.get(&handed.item("")).text(200);
        assert_eq!(sheet.contains("km"), choice == "issue_anew", "{choice}: {sheet}");
        let full = sheet.contains("10 of 10</strong> points, full marks") && sheet.contains("a wrong unit");
        assert_eq!(full, choice == "full_marks", "{choice}: {sheet}");
        assert_eq!(sheet.contains("This problem no longer counts"), choice == "drop", "{choice}: {sheet}");
        // Whatever became of the marks, what is shown as right is right.
        handed.university.set_clock(4 * DAY);
        let solution = ada.get(&handed.item("/solution")).text(200);
        assert!(solution.contains("km"), "{choice}: {solution}");
        assert_eq!(solution.contains("what it says or asks has changed"), choice != "issue_anew", "{choice}");
        if choice != "drop" {
            let key = ida.get(&handed.assignment("/print/key")).text(200);
            assert!(key.contains("km"), "{choice}: {key}");
        }
    }
}

/// Each cart had the mass of the other: the sheets are the same, and what is right is not.
#[test]
fn after_a_correction_solution_and_key_are_of_the_corrected_problem_whatever_the_choice() {
    let other = text()
        .replace("name: cart A, mass: m_A", "name: cart A, mass: MASS")
        .replace("mass: m_B", "mass: m_A")
        .replace("MASS", "m_B");
    let solution = |handed: &Handed| {
        handed.university.set_clock(4 * DAY);
        handed.university.browser_of("ada").get(&handed.item("/solution")).text(200)
    };
    let (old_solution, old_key) = {
        let handed = Handed::new();
        (solution(&handed), ida_key(&handed))
    };
    let mut found = Vec::new();
    for choice in ["remark", "remark_never_lower", "full_marks", "drop"] {
        let handed = Handed::new();
        handed.publish(&other);
        let mut ida = handed.university.browser_of("ida");
        let page = ida.get(&handed.assignment("/regrade")).text(200);
        ida.post(&handed.assignment("/regrade"), &Handed::choice(&page, choice)).to();
        let solution_now = solution(&handed);
        assert!(
            solution_now != old_solution && !solution_now.contains("what it says or asks has changed"),
            "{choice}: {solution_now}"
        );
        assert_ne!(ida_key(&handed), old_key, "{choice}");
        found.push(solution_now);
    }
    found.dedup();
    assert_eq!(found.len(), 1, "the solution does not depend on the choice");
}

fn ida_key(handed: &Handed) -> String {
    handed.university.browser_of("ida").get(&handed.assignment("/print/key")).text(200)
}

#[test]
fn a_regrade_that_never_lowers_leaves_everybody_what_they_had() {
    let handed = Handed::new();
    handed.publish(&text().replace("v_A2, unit: m/s, points: 2", "v_A2, unit: m/s, points: 1"));
    let mut ida = handed.university.browser_of("ida");
    let page = ida.get(&handed.assignment("/regrade")).text(200);
    assert!(page.contains("<td>4</td><td>2.5</td><td>4</td><td>10</td><td>–</td>"), "{page}");
    ida.post(&handed.assignment("/regrade"), &Handed::choice(&page, "remark_never_lower")).to();
    assert_eq!(handed.row(), "ada,ada <script>,A,4,4,10");
    let mut ada = handed.university.browser_of("ada");
    let sheet = ada.get(&handed.item("")).text(200);
    assert!(sheet.contains("4 of 10</strong> points, as before the correction"), "{sheet}");
    // More is more.
    let answers = right(&handed.university, "ada");
    let fields = [("request", "3"), ("answer.v_B2", answers["v_B2"].as_str()), ("answer.T_lost", &answers["T_lost"])];
    ada.post(&handed.item(""), &fields).to();
    assert_eq!(handed.row(), "ada,ada <script>,A,10,10,10");
}
