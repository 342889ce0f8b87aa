//! Nothing that a student types disappears: not what cannot be read, not a form that is sent twice, not what lies saved at the close.

use momentous::course::{StoredReport, Unsubmitted};
use momentous::store::AssignmentWithItems;

use super::student::{form, right};
use super::university::{Browser, DAY, University};

const CARTS: &str = "impact/two-carts";

/// A university with an assignment of one problem, and the address of its sheet.
fn sheet(unsubmitted: Unsubmitted) -> (University, AssignmentWithItems, String) {
    let university = University::new();
    let whole = university.assignment(&[(CARTS, "forward", 10)], |policy| policy.unsubmitted = unsubmitted);
    let address = university.address(&format!("/items/{}", whole.items[0].key));
    (university, whole, address)
}

/// What was kept of each attempt of Ada's.
fn reports(university: &University) -> Vec<StoredReport> {
    let attempts = university.wait(async |store| {
        let sheets = store.sheets_of(University::member("ada")).await.unwrap();
        store.attempts(sheets[0].key).await.unwrap()
    });
    attempts.iter().map(|attempt| StoredReport::of(attempt).unwrap()).collect()
}

/// What stands in the field of a part.
fn field<'a>(page: &'a str, part: &str) -> &'a str {
    let name = format!("name=\"answer.{part}\" value=\"");
    page.split_once(&name).unwrap_or_else(|| panic!("{part}: {page}")).1.split('"').next().unwrap()
}

fn gradebook(university: &University, whole: &AssignmentWithItems) -> String {
    let address = university.address(&format!("/assignments/{}/gradebook.csv", whole.assignment.key));
    let table = university.browser_of("ida").get(&address).text(200);
    table.lines().find(|line| line.starts_with("ada,")).unwrap().to_owned()
}

#[test]
fn what_cannot_be_read_stays_in_its_field_and_is_one_attempt() {
    let (university, _, address) = sheet(Unsubmitted::Leave);
    let mut ada = university.browser_of("ada");
    let text = "1,45 Joule oder so";
    ada.post(&address, &form("1", &[("answer.v_A2", "97.0 m/s"), ("answer.T_lost", text)])).to();
    let page = ada.get(&address).text(200);
    assert_eq!((field(&page, "T_lost"), field(&page, "v_A2")), (text, "97.0 m/s"));
    assert!(page.contains("class=\"reading unreadable\""), "{page}");
    // Sent again from a new page it is nothing new; beside another answer it stays where it is.
    ada.post(&address, &form("2", &[("answer.v_A2", "97.0 m/s"), ("answer.T_lost", text)])).text(422);
    ada.post(&address, &form("3", &[("answer.v_A2", "98.0 m/s"), ("answer.T_lost", text)])).to();
    assert_eq!(field(&ada.get(&address).text(200), "T_lost"), text);
    ada.post(&address, &form("4", &[("answer.T_lost", "1.45 J")])).to();
    assert_eq!(field(&ada.get(&address).text(200), "T_lost"), "1.45 J");
    assert_eq!(reports(&university).len(), 3);
}

#[test]
fn the_same_form_is_one_attempt_and_other_answers_are_another_with_or_without_a_key() {
    for key in ["a key", ""] {
        let (university, _, address) = sheet(Unsubmitted::Leave);
        let mut ada = university.browser_of("ada");
        let mut send = |text: &str| ada.post(&address, &form(key, &[("answer.v_A2", text)])).to().to_owned();
        assert_eq!(send("97.0 m/s"), format!("{address}#marks"));
        assert_eq!(send(" 97.0 m/s "), format!("{address}?again=1#marks"), "{key}");
        assert_eq!(send("98.0 m/s"), format!("{address}#marks"), "{key}");
        assert_eq!(send("98.0 m/s"), format!("{address}?again=2#marks"), "{key}");
        assert_eq!(send("99.0 m/s"), format!("{address}#marks"), "{key}");
        assert_eq!(reports(&university).len(), 3, "{key}");
        let said = university.browser_of("ada").get(&format!("{address}?again=2")).text(200);
        assert!(said.contains("They are one attempt: number 2"), "{said}");
    }
}

/// A browser without JavaScript presses the first button of a form where somebody presses Enter.
#[test]
fn enter_reads_and_saves_and_hands_in_nothing() {
    let (university, _, address) = sheet(Unsubmitted::Leave);
    let mut ada = university.browser_of("ada");
    let page = ada.get(&address).text(200);
    let form = page.split_once("class=\"answers\"").unwrap().1;
    let first = form.split_once("<button").unwrap().1.split('>').next().unwrap();
    let draft = first.split_once("formaction=\"").unwrap().1.split('"').next().unwrap();
    ada.post(draft, &[("answer.v_A2", "0.500 m/s to the left"), ("answer.v_B2", "3..2")]).to();
    let page = ada.get(&address).text(200);
    assert!(page.contains("Read as 0.500 metres per second to the left."), "{page}");
    assert_eq!((field(&page, "v_B2"), page.contains("class=\"reading unreadable\"")), ("3..2", true));
    assert!(reports(&university).is_empty());
}

/// The line about a part beside the button; nothing where it is hidden.
fn outlook<'a>(page: &'a str, part: &str) -> Option<&'a str> {
    let line = page.split_once(&format!("<li data-new=\"answer.{part}\"")).unwrap().1;
    let (head, rest) = line.split_once('>').unwrap();
    (!head.contains(" hidden")).then(|| rest.split("</li>").next().unwrap())
}

#[test]
fn the_sheet_says_what_is_handed_in_and_what_it_costs() {
    let (university, _, address) = sheet(Unsubmitted::Leave);
    let mut ada = university.browser_of("ada");
    let page = ada.get(&address).text(200);
    assert!(["v_A2", "v_B2", "T_lost"].into_iter().all(|part| outlook(&page, part).is_none()));
    ada.post(&address, &form("1", &[("answer.v_A2", "97.0 m/s")])).to();
    university.set_clock(1000);
    let draft = format!("{address}/draft");
    let said = |ada: &mut Browser<'_>| {
        ada.post(&draft, &[("answer.v_A2", "98.0 m/s"), ("answer.v_B2", "1.00 m/s")]).to();
        let page = ada.get(&address).text(200);
        ["v_A2", "v_B2"].map(|part| outlook(&page, part).unwrap().rsplit(": ").next().unwrap().to_owned())
    };
    assert_eq!(said(&mut ada), ["for 90 % of its points", "for all of its points"]);
    // By hand: a day late leaves four fifths, of 9/10 and of all.
    university.set_clock(DAY + 1);
    assert_eq!(said(&mut ada), ["for 72 % of its points", "for 80 % of its points"]);
    for (request, text) in [("2", "95.0 m/s"), ("3", "96.0 m/s")] {
        ada.post(&address, &form(request, &[("answer.v_A2", text)])).to();
    }
    university.set_clock(DAY + 1000);
    assert_eq!(said(&mut ada)[0], "not marked, because no attempt is left");
}

#[test]
fn what_lies_saved_at_the_close_is_handed_in_where_the_assignment_says_so() {
    for (unsubmitted, row) in
        [(Unsubmitted::Leave, "ada,ada <script>,A,,0,10"), (Unsubmitted::HandIn, "ada,ada <script>,A,6.4,6.4,10")]
    {
        let (university, whole, address) = sheet(unsubmitted);
        let mut ada = university.browser_of("ada");
        ada.get(&address).text(200);
        let (_, answers) = right(&university, "ada");
        let draft = format!("{address}/draft");
        // In time and right; then late, with one right answer more.
        ada.post(&draft, &[("answer.v_A2", &answers["v_A2"])]).to();
        university.set_clock(DAY + 1);
        ada.post(
            &draft,
            &[("answer.v_A2", &answers["v_A2"]), ("answer.v_B2", &answers["v_B2"]), ("answer.T_lost", "3..2")],
        )
        .to();
        assert!(reports(&university).is_empty(), "nothing is handed in before");
        university.set_clock(2 * DAY + 1);
        // What comes now takes nothing's place.
        let refused = ada.post(&draft, &[("answer.T_lost", "9.00 J")]).text(422);
        assert!(refused.contains("the time for answers is over") && field(&refused, "T_lost") == "9.00 J", "{refused}");
        // By hand: 2 and 2 of 5 parts' points, four fifths of each: what counts was saved late.
        assert_eq!(gradebook(&university, &whole), row, "{unsubmitted:?}");
        assert_eq!(gradebook(&university, &whole), row, "once");
        let handed_in = usize::from(unsubmitted == Unsubmitted::HandIn);
        assert_eq!(reports(&university).len(), handed_in);
        let page = ada.get(&address).text(200);
        assert_eq!(page.contains("as it was saved, when no more was taken"), handed_in == 1, "{page}");
        assert_eq!(field(&page, "T_lost"), "3..2", "and nothing that was typed is gone");
    }
}

#[test]
fn what_was_handed_in_after_it_was_saved_counts() {
    let (university, whole, address) = sheet(Unsubmitted::HandIn);
    let mut ada = university.browser_of("ada");
    ada.post(&format!("{address}/draft"), &[("answer.v_A2", "97.0 m/s")]).to();
    university.set_clock(1000);
    let (_, answers) = right(&university, "ada");
    ada.post(&address, &form("1", &[("answer.v_A2", &answers["v_A2"])])).to();
    university.set_clock(3 * DAY + 1);
    assert_eq!(gradebook(&university, &whole), "ada,ada <script>,A,4,4,10");
    assert_eq!(reports(&university).len(), 1);
}
