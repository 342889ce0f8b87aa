//! Practice pages: what goes into the file, the folder and the package.

use std::io::{Cursor, Read};

use momentous::export::{ENGINE_FILE, PAGE_FILE, PageProblem, PracticePage, Reported};

/// A page whose title and problem try to end the elements in which they stand.
fn page() -> PracticePage<'static> {
    let text = "title: </script><script>alert(1)</script>\n".to_owned();
    let problem = PageProblem { name: "impact/evil.yaml".to_owned(), text, course: None, id: "impact/evil".to_owned() };
    PracticePage {
        title: "<b>\"Carts\" & balls".to_owned(),
        problems: vec![problem],
        engine: b"the engine",
        templates: None,
    }
}

#[test]
fn nothing_of_a_problem_ends_an_element_of_the_page() {
    let file = page().one_file().unwrap();
    assert!(file.contains("<title>&lt;b&gt;"), "{file}");
    assert!(!file.contains("<b>") && !file.contains("alert(1)</script>"), "{file}");
    assert!(file.contains("dGhlIGVuZ2luZQ==") && !file.contains(ENGINE_FILE));
    assert!(file.contains("data-start=\"/practice/impact/evil?seed=1\""));
}

#[test]
fn a_page_of_a_folder_loads_its_engine_from_beside() {
    let file = page().beside_its_engine().unwrap();
    assert!(file.contains(&format!("data-beside=\"{ENGINE_FILE}\"")) && !file.contains("dGhlIGVuZ2luZQ=="));
    assert!(file.contains("connect-src 'self'") && !page().one_file().unwrap().contains("connect-src"));
}

#[test]
fn a_template_of_a_course_takes_the_place_of_the_page() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("page")).unwrap();
    std::fs::write(folder.path().join("page/page.tera"), "{{ title }}").unwrap();
    let page = PracticePage { templates: Some(folder.path()), ..page() };
    assert_eq!(page.one_file().unwrap(), "&lt;b&gt;&quot;Carts&quot; &amp; balls");
}

#[test]
fn a_package_holds_page_engine_and_manifest() {
    let mut bytes = Vec::new();
    page().scorm(&mut bytes, Reported::Completion).unwrap();
    let mut package = zip::ZipArchive::new(Cursor::new(bytes)).unwrap();
    let mut file = |name: &str| {
        let mut text = String::new();
        package.by_name(name).unwrap().read_to_string(&mut text).unwrap();
        text
    };
    let manifest = file("imsmanifest.xml");
    assert!(manifest.contains("<schemaversion>1.2</schemaversion>") && manifest.contains("&lt;b&gt;"), "{manifest}");
    let html = file(PAGE_FILE);
    assert!(html.contains("LMSInitialize") && !html.contains("data-scored>"));
    assert_eq!(file(ENGINE_FILE), "the engine");
}
