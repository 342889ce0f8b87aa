//! Values of the reader's own: a sheet that says them, fields that are read and marked, hints, and the worked solution.

use momentous::exercise::Exercise;
use serde_json::{Map, Value, json};

use super::client::{Client, encoded};
use super::{printed, problems};

/// A call with these values in place of a seed.
fn typed(call: &str, client: &Client, problem: &str, form: Option<&str>, set: &Value, more: &Value) -> Value {
    let mut request = json!({ "problem": problem, "form": form, "set": set });
    request.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
    client.call(call, &request).json(200)
}

/// The numbers that a drawn sheet prints, typed: the same sheet, and its answers are right.
#[test]
fn every_form_of_the_bank_is_the_same_sheet_with_its_own_numbers_typed() {
    let client = Client::new();
    let mut tried = 0;
    for problem in problems() {
        for (place, form) in problem.forms().iter().enumerate() {
            let name = form.question.name.as_deref();
            let exercise = Exercise::draw(&problem, place, 3).unwrap();
            let numbers = exercise.variant().printed_numbers(&problem);
            if numbers.is_empty() {
                continue;
            }
            tried += 1;
            let set: Map<String, Value> = numbers.into_iter().map(|(name, text)| (name, Value::from(text))).collect();
            let set = Value::from(set);
            let asked = json!({ "seed": 3 });
            let drawn = client.call("sheet", &json!({ "problem": problem.id(), "form": name, "seed": 3 })).json(200);
            let by_numbers = typed("sheet", &client, problem.id(), name, &set, &asked);
            assert_eq!(by_numbers["statement"], drawn["statement"], "{} {name:?} {set}", problem.id());
            // Numbers of one's own have no seed, from which the order of options comes.
            assert_eq!(in_order(&by_numbers["fields"]), in_order(&drawn["fields"]), "{} {name:?} {set}", problem.id());
            let answers =
                json!({ "seed": 3, "answers": in_own_letters(json!(printed(&exercise)), &drawn, &by_numbers) });
            let marked = typed("mark", &client, problem.id(), name, &set, &answers);
            assert_eq!(marked["right"], true, "{} {name:?}: {marked:#}", problem.id());
        }
    }
    assert!(tried > 100, "{tried}");
}

/// The drawings of a field, without the letters under which they are offered.
fn drawings(field: &Value) -> Vec<String> {
    let pictures = field["pictures"].as_array().into_iter().flatten();
    let drawing = |sheet: &Value| sheet["svg"].as_str().unwrap().split_once("</title>").unwrap().1.to_owned();
    pictures.map(drawing).collect()
}

/// Answers of one sheet, for another that offers the same pictures under other letters.
fn in_own_letters(mut answers: Value, drawn: &Value, typed: &Value) -> Value {
    for (drawn, drawn_field) in drawn["fields"].as_array().unwrap().iter().zip(typed["fields"].as_array().unwrap()) {
        let Some(answer) = answers.get_mut(drawn["id"].as_str().unwrap()).filter(|_| !drawings(drawn).is_empty())
        else {
            continue;
        };
        let letter = drawn["options"].as_array().unwrap().iter().position(|option| option == answer).unwrap();
        let place = drawings(drawn_field).iter().position(|drawing| *drawing == drawings(drawn)[letter]).unwrap();
        *answer = drawn_field["options"][place].clone();
    }
    answers
}

/// Fields with their options in the order of the alphabet, and their pictures in an order of their own.
fn in_order(fields: &Value) -> Value {
    let mut fields = fields.clone();
    for field in fields.as_array_mut().unwrap() {
        let mut pictures = drawings(field);
        pictures.sort();
        field["pictures"] = Value::from(pictures);
        if let Some(options) = field["options"].as_array_mut() {
            options.sort_by_key(Value::to_string);
        }
    }
    fields
}

/// By hand: 3 kg at 3 m/s meets 2 kg at -2 m/s with e = 0.7. The centre of mass moves at 1 m/s, so
/// `v_A2` = 1 - 0.7 (3 - 1) = -0.4 m/s and `v_B2` = 1 + 0.7 (1 + 2) = 3.1 m/s.
#[test]
fn typed_values_are_printed_read_marked_and_solved() {
    let client = Client::new();
    let set = json!({ "m_A": "3 kg", "m_B": "2 kg", "v_A1": "3 m/s", "v_B1": "-2 m/s", "e": "0.7" });
    let carts = |call: &str, more: Value| typed(call, &client, "impact/two-carts", None, &set, &more);
    let statement = carts("sheet", json!({}))["statement"].as_str().unwrap().to_owned();
    for words in ["3\u{a0}kg", "2\u{a0}m/s to the left", "0.7", "Find the velocity of each cart"] {
        assert!(statement.contains(words), "{words}: {statement}");
    }
    let marked = carts("mark", json!({ "answers": { "v_A2": "-0.400 m/s", "v_B2": "3.10 m/s", "T_lost": "3.00 J" } }));
    let verdicts: Vec<&str> =
        marked["parts"].as_array().unwrap().iter().map(|part| part["verdict"].as_str().unwrap()).collect();
    assert_eq!(verdicts, ["right", "right", "wrong"]);
    let read = carts("read", json!({ "part": "v_A2", "text": "0,400 m/s left" }));
    assert_eq!(read["understood"], "0.400 metres per second to the left");
    assert_eq!(carts("hint", json!({ "number": 1 }))["more"], true);
    let page = "/solution/impact/two-carts?set.m_A=3+kg&set.m_B=2+kg&set.v_A1=3+m%2Fs&set.v_B1=-2+m%2Fs&set.e=0.7";
    let solution = client.get(page).text(200);
    assert!(solution.contains("3.10"), "{solution}");
    assert!(solution.contains("set.v_B1=-2+m%2Fs"), "the way back to the sheet keeps the values");
}

/// What the text has no place for stands at its end; what is asked instead leaves the story.
#[test]
fn the_sheet_says_every_value_that_was_typed() {
    let client = Client::new();
    let statement = |request: Value| client.call("sheet", &request).json(200)["statement"].as_str().unwrap().to_owned();
    let moon = statement(json!({ "problem": "bouncing/rubber-ball", "set": { "g": "1.62 m/s^2" } }));
    assert!(moon.contains("1.62") && moon.contains("bounces up and down"), "{moon}");
    let kept = json!({ "h_0": "4 m", "e": "0.5", "n": "3" });
    let height = statement(json!({ "problem": "bouncing/rubber-ball", "set": kept, "find": ["h_n"] }));
    assert!(height.contains("4\u{a0}m") && height.contains("Here") && !height.contains("lie still"), "{height}");
}

#[test]
fn a_sheet_of_typed_values_is_answered_on_its_page() {
    let client = Client::new();
    let address = "/practice/impact/two-carts?set.m_A=3+kg&set.m_B=2+kg&set.v_A1=3+m%2Fs&set.v_B1=-2+m%2Fs&set.e=0.7";
    let page = client.get(address).text(200);
    assert!(page.contains("Own numbers</footer>") && !page.contains("seed 1"), "a typed variant has no seed");
    let hidden = page.match_indices("name=\"set.").count();
    assert_eq!(hidden, 5, "each value goes along with the answers");
    let fields = [
        ("set.m_A", "3 kg"),
        ("set.m_B", "2 kg"),
        ("set.v_A1", "3 m/s"),
        ("set.v_B1", "-2 m/s"),
        ("set.e", "0.7"),
        ("answer.v_A2", "-0.400 m/s"),
        ("answer.v_B2", "3.10 m/s"),
        ("answer.T_lost", "7.65 J"),
    ];
    let fields: Vec<(String, String)> = fields.map(|(name, value)| (name.to_owned(), value.to_owned())).into();
    assert!(client.post("/practice/impact/two-carts", &encoded(&fields)).text(200).contains("Well done"));
    let refused = client.get("/practice/impact/two-carts?set.e=2").text(422);
    assert!(refused.contains("above 1 would create energy"), "{refused}");
}

/// Where nothing is lost the bank's question has no answer, and the page says in words why; its links to a problem are gone.
#[test]
fn a_ball_that_loses_nothing_says_why_its_problem_has_no_solution() {
    let client = Client::new();
    let page = client.get("/simulators/restitution?e=1").text(200);
    assert!(page.contains("the sum of their times has no limit") && page.contains("add up without a limit"), "{page}");
    assert!(page.contains("data-problem hidden"));
    let air = client.get("/simulators/restitution?e=1&v_t=20").text(200);
    assert!(air.contains("In air no formula") && !air.contains("Nothing is lost: it bounces"), "{air}");
    let lossy = client.get("/simulators/restitution?e=0.9").text(200);
    assert!(lossy.contains("Worked solution") && !lossy.contains("data-problem hidden"));
}

#[test]
fn fields_of_own_numbers_are_labelled_with_the_names_of_their_quantities() {
    let page = Client::new().get("/solve/impact/two-carts").text(200);
    assert!(page.contains("<span>The mass of cart A "), "{page}");
}

#[test]
fn a_worked_solution_says_in_words_which_numbers_it_has() {
    let page = Client::new().get("/solution/impact/two-carts?form=forward&seed=3").text(200);
    assert!(page.contains("Numbers of seed 3"), "{page}");
    assert!(!page.contains("· digest") && !page.contains("· scheme"), "{page}");
}
