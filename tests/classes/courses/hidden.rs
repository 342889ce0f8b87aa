//! What solves an open assignment is hidden where the assignment says so, from all but those who teach; scenes are played all the same.

use axum::http::Method;
use momentous::course::Solvers;

use super::university::{Answer, Browser, DAY, University};

/// In the assignment; and of its kind, of the kind of another simulator, and of a kind without one.
const GIVEN: &str = "impact/two-carts";
const ALIKE: &str = "conservation/coupling-wagons";
const OTHER: &str = "bouncing/rubber-ball";
/// Later than what the server remembers of before.
const LATER: i64 = 10_000;

fn university(solvers: Solvers) -> University {
    let university = University::new();
    university.assignment(&[(GIVEN, "forward", 10)], |policy| policy.solvers = solvers);
    university.set_clock(LATER);
    university
}

fn call(browser: &mut Browser<'_>, name: &str, request: &str) -> Answer {
    browser.ask(Method::POST, &format!("/api/{name}"), Some(request.to_owned()), None)
}

/// Whether collisions are solved for somebody, wherever that can be asked for; every place says the same.
fn is_solved(browser: &mut Browser<'_>) -> bool {
    let page = browser.get("/simulators/collision").text(200);
    assert!(page.contains("aria-label=\"The carts on their track\"") && page.contains("Kinetic energy lost"), "{page}");
    let by_simulator = page.contains("<section class=\"solution\"") || page.contains("<h2>Solution");
    let said = page.contains("not solved with own numbers");
    let answer = call(browser, "collision", r#"{"values":{"m_A":3}}"#).text(200);
    let answer: serde_json::Value = serde_json::from_str(&answer).unwrap();
    assert!(answer["places"].is_array(), "{answer}");
    let by_call = !answer["problem"]["solved"].is_null();
    let discs = call(browser, "discs", r#"{"values":{"b":0}}"#).text(200);
    let discs: serde_json::Value = serde_json::from_str(&discs).unwrap();
    let by_discs = !discs["problem"]["solved"].is_null();
    let status = |answer: Answer| match answer.status {
        200 => true,
        403 => false,
        other => panic!("{other}: {}", answer.text),
    };
    let by_solving = status(browser.get(&format!("/solve/{ALIKE}")));
    let typed = status(browser.get(&format!("/practice/{ALIKE}?set.m_A=12+t")));
    let asked = format!(r#"{{"problem":"{ALIKE}","set":{{"m_A":"12 t"}}}}"#);
    let by_solve = status(call(browser, "solve", &asked));
    let practice = browser.get(&format!("/practice/{ALIKE}")).text(200);
    assert_eq!(practice.contains(">Own numbers</a>"), by_solving, "what is not there is not offered");
    let all = [!said, by_call, by_discs, by_solving, typed, by_solve];
    assert!(all.iter().all(|is_solved| *is_solved == by_call), "{all:?} {by_simulator}");
    browser.get(&format!("/solve/{OTHER}")).text(200);
    assert!(!browser.get("/simulators/restitution").text(200).contains("not solved with own numbers"));
    by_call
}

/// The simulators that the header of a page offers.
fn header(browser: &mut Browser<'_>, address: &str) -> Vec<String> {
    let page = browser.get(address).text;
    let site = page.split_once("<nav aria-label=\"Site\">").unwrap().1.split("</nav>").next().unwrap().to_owned();
    site.split("/simulators/").skip(1).map(|rest| rest.split('"').next().unwrap().to_owned()).collect()
}

#[test]
fn what_solves_an_open_assignment_is_hidden_where_it_says_so_from_all_but_those_who_teach() {
    let hidden = university(Solvers::Hidden);
    for who in [None, Some("ada"), Some("cleo")] {
        let mut browser = who.map_or_else(|| hidden.browser(), |login| hidden.browser_of(login));
        assert!(!is_solved(&mut browser), "{who:?}");
        for address in ["/", "/practice/impact/two-carts", "/simulators/collision", "/courses"] {
            if address != "/courses" || who.is_some() {
                assert_eq!(header(&mut browser, address), ["restitution"], "{who:?} {address}");
            }
        }
    }
    for login in ["ida", "ann"] {
        assert!(is_solved(&mut hidden.browser_of(login)), "{login} teaches");
    }
    // A minute after the close what is released is open.
    hidden.set_clock(3 * DAY + 12 * LATER);
    let mut ada = hidden.browser_of("ada");
    assert!(is_solved(&mut ada), "it has closed");
    assert_eq!(header(&mut ada, "/courses"), ["collision", "discs", "restitution"]);
}

#[test]
fn without_the_switch_nothing_is_hidden() {
    let shown = university(Solvers::Shown);
    let mut ada = shown.browser_of("ada");
    assert!(is_solved(&mut ada));
    assert_eq!(header(&mut ada, "/courses"), ["collision", "discs", "restitution"]);
}
