//! The web application, request by request, without a network.

mod client;
mod hostile;
mod limits;
mod played;
mod simulators;
mod typed;
mod work;

use std::collections::BTreeMap;
use std::sync::Arc;

use momentous::bank::Bank;
use momentous::exercise::Exercise;
use momentous::problem::{Problem, compile, load};
use momentous::web::{App, Settings};
use serde_json::{Value, json};

use client::{Client, encoded};

/// Every problem of the built-in bank, compiled.
fn problems() -> impl Iterator<Item = Arc<Problem>> {
    let bank = Bank::built_in();
    let sources: Vec<_> = bank.sources().cloned().collect();
    sources.into_iter().map(|source| Arc::new(compile(load(source).unwrap(), None).unwrap()))
}

/// The answers of a variant as they are printed.
fn printed(exercise: &Exercise) -> BTreeMap<String, String> {
    exercise.worked().form.parts.iter().map(|part| (part.id.clone(), exercise.printed(part))).collect()
}

#[test]
fn every_form_of_the_bank_is_practised() {
    let client = Client::new();
    for problem in problems() {
        for (place, form) in problem.forms().iter().enumerate() {
            let name = form.question.name.as_deref().unwrap_or_default();
            let address = format!("/practice/{}?form={name}&seed=3", problem.id());
            let page = client.get(&address).text(200);
            let answers = printed(&Exercise::draw(&problem, place, 3).unwrap());
            let mut fields = vec![("form".to_owned(), name.to_owned()), ("seed".to_owned(), "3".to_owned())];
            for (part, answer) in answers {
                assert!(page.contains(&format!("name=\"answer.{part}\"")), "{address}: no field for {part}");
                fields.push((format!("answer.{part}"), answer));
            }
            let marked = client.post(&address, &encoded(&fields)).text(200);
            assert!(marked.contains("Well done"), "{address}: a printed answer is not right");
        }
    }
}

#[test]
fn no_page_holds_code_or_style_of_its_own() {
    let client = Client::new();
    for problem in problems() {
        for page in ["play", "practice", "solution", "solve"] {
            let response = client.get(&format!("/{page}/{}", problem.id()));
            let policy = response.header("content-security-policy");
            assert!(policy.contains("default-src 'none'") && !policy.contains("unsafe"), "{policy}");
            let text = response.text(200);
            for forbidden in ["<style", " style=", " on", "javascript:", "<script>"] {
                let found = text.match_indices(forbidden).find(|(at, _)| is_markup(&text, *at, forbidden));
                assert!(found.is_none(), "{page} of {}: {forbidden}", problem.id());
            }
        }
    }
}

/// Whether what was found stands inside a tag; ` on` must be an attribute there: ` onclick=`.
fn is_markup(text: &str, at: usize, found: &str) -> bool {
    let in_tag = text[..=at].rfind('<') > text[..at].rfind('>');
    let in_value = text[text[..=at].rfind('<').unwrap_or(0)..at].matches('"').count() % 2 == 1;
    let is_attribute = found != " on"
        || text[at + 1..]
            .split_once('=')
            .is_some_and(|(name, _)| name.chars().all(|letter| letter.is_ascii_lowercase()));
    in_tag && !in_value && is_attribute
}

#[test]
fn the_first_page_is_small_and_its_files_are_kept() {
    let client = Client::new();
    let page = client.get("/").text(200);
    let addresses: Vec<&str> = page.split('"').filter(|text| text.starts_with("/static/")).collect();
    let mut size = page.len();
    for address in addresses {
        let file = client.get(address);
        assert!(file.header("cache-control").contains("immutable"), "{address}");
        if !address.contains(".woff2") {
            size += file.text(200).len();
        }
    }
    assert!(size < 60_000, "{size} bytes");
}

#[test]
fn the_gallery_goes_the_way_of_a_course_and_finds_by_topic_level_and_answer() {
    let client = Client::new();
    let page = client.get("/").text(200);
    let place = |title: &str| page.find(&format!(">{title}</h2>")).unwrap_or_else(|| panic!("no section {title}"));
    let titles = [
        "Impulse and momentum",
        "Conservation of momentum",
        "Impact",
        "Coefficient of restitution",
        "Angular momentum",
    ];
    assert!(titles.map(place).is_sorted());
    assert!(page.contains("Find the velocity of each cart afterwards and the kinetic energy lost."));
    let count = |query: &str| {
        let page = client.get(&format!("/?{query}")).text(200);
        page.matches("<li><img ").count()
    };
    let all = count("level=intro") + count("level=core") + count("level=challenge");
    assert_eq!(all, Bank::built_in().ids().count());
    assert!((1..all).contains(&count("answer=interval")) && (1..all).contains(&count("topic=streams")));
    assert_eq!(count("topic=streams&search=hockey"), 0);
    let taken = client.get("/?search=resitution").text(200);
    assert!(taken.contains("Problems for <strong>restitution</strong>"));
}

#[test]
fn every_problem_has_a_small_figure() {
    let client = Client::new();
    for problem in problems() {
        let figure = client.get(&format!("/figure/{}", problem.id())).text(200);
        assert!(figure.starts_with("<svg "), "{}", problem.id());
    }
    assert_eq!(client.get("/figure/impact/two-cart").status, 404);
}

#[test]
fn each_call_answers_in_json() {
    let client = Client::new();
    let variant = json!({ "problem": "impact/two-carts", "form": "forward", "seed": 7 });
    let with = |more: Value| {
        let mut request = variant.clone();
        request.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
        request
    };
    let sheet = client.call("sheet", &variant).json(200);
    assert_eq!(sheet["fields"][0]["id"], "v_A2");
    let read = client.call("read", &with(json!({ "part": "v_A2", "text": "0,500 m/s left" }))).json(200);
    assert_eq!(read["understood"], "0.500 metres per second to the left");
    let marked = client.call("mark", &with(json!({ "answers": { "v_A2": "3.00 m/s" } }))).json(200);
    assert_eq!(marked["parts"][0]["verdict"], "wrong");
    let hint = client.call("hint", &with(json!({ "number": 1 }))).json(200);
    assert_eq!(hint["more"], true);
    let solved = client.call("solve", &with(json!({ "set": { "m_A": "3 kg" }, "find": ["v_A2"] }))).json(200);
    assert_eq!(solved["answers"].as_array().unwrap().len(), 1);
    let simulated = client.call("simulate", &variant).json(200);
    assert_eq!(simulated["stages"][0]["bodies"][0]["name"], "A");
    assert_eq!(client.call("givens", &variant).json(200)[0]["name"], "m_A");
}

#[test]
fn what_cannot_be_is_refused_with_its_reason() {
    let client = Client::new();
    let rows = [
        ("sheet", json!({ "problem": "impact/two-cart" }), 404, "did you mean `impact/two-carts`?"),
        ("sheet", json!({ "problem": "impact/two-carts", "form": "forwards" }), 404, "did you mean `forward`?"),
        ("sheet", json!({ "problem": "impact/two-carts", "seed": -1 }), 400, ""),
        ("sheet", json!({ "problem": 3 }), 400, ""),
        ("read", json!({ "problem": "impact/two-carts", "part": "x", "text": "1" }), 404, ""),
        ("solve", json!({ "problem": "impact/two-carts", "set": { "e": "2" } }), 422, ""),
        ("solve", json!({ "problem": "impact/two-carts", "set": { "m_A": "3 apples" } }), 422, ""),
        ("simulate", json!({ "problem": "impact/two-carts", "method": "penalti" }), 404, ""),
        ("nonsense", json!({}), 404, "the calls are "),
    ];
    for (call, request, status, help) in rows {
        let refused = client.call(call, &request).json(status);
        assert!(!refused["message"].as_str().unwrap().is_empty(), "{call}: {request}");
        assert!(refused["help"].as_str().unwrap_or_default().starts_with(help), "{call}: {refused}");
    }
}

#[test]
fn a_reading_does_not_depend_on_the_right_answer() {
    let client = Client::new();
    let texts = ["3.00 m/s", "-3.00 m/s", "0.4 to the left", "1e9", "3..2", "2 +- 1 m/s", "5.00 J"];
    for text in texts {
        let read = |seed: u64| {
            let request = json!({ "problem": "impact/two-carts", "seed": seed, "part": "v_A2", "text": text });
            client.call("read", &request).json(200)
        };
        assert!((2..20).all(|seed| read(seed) == read(1)), "{text}");
    }
}

#[test]
fn pages_begin_where_a_proxy_puts_them() {
    let client = Client::under("/physics");
    let page = client.get("/physics/").text(200);
    assert!(page.contains("href=\"/physics/practice/impact/two-carts?seed=1\""));
    let file = page.split('"').find(|text| text.ends_with("site.css")).unwrap();
    assert!(client.get(file).text(200).contains(".momentous-figure"));
    assert_eq!(client.get("/").status, 404);
}

#[test]
fn a_preview_follows_the_files_as_they_are_saved() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("carts.yaml");
    let text = Bank::built_in().find("impact/two-carts").unwrap().text.to_string();
    std::fs::write(&path, &text).unwrap();
    let client = Client::with(Settings { watch: Some(folder.path().to_owned()), ..Settings::default() });
    let page = || client.get("/practice/impact/two-carts");
    let stamp = client.get("/watch").text(200);
    assert!(page().text(200).contains("level track"));
    std::fs::write(&path, text.replace("level track", "level rail on a table")).unwrap();
    assert!(page().text(200).contains("level rail on a table"));
    // The simulators need no file of the folder.
    client.get("/simulators/restitution").text(200);
    assert_ne!(client.get("/watch").text(200), stamp);
    std::fs::write(&path, text.replace("v_A2, unit: m/s", "v_A9, unit: m/s")).unwrap();
    let broken = page().text(500);
    assert!(broken.contains("carts.yaml") && broken.contains("v_A9"), "the author is told where: {broken}");
    std::fs::write(&path, text).unwrap();
    assert!(page().text(200).contains("level track"));
}

#[test]
fn a_bank_that_cannot_be_read_is_told_before_anything_is_served() {
    let settings = Settings { watch: Some("no/such/folder".into()), ..Settings::default() };
    assert!(App::new(settings).err().is_some_and(|faults| faults.to_string().contains("no/such/folder")));
}
