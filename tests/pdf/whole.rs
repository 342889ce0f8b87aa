//! What a document is beside its text: tagged, titled, the same each time, and a whole class in one file.

use momentous::render::{Format, Identity, Page, Press, Renderer, Sheet};

use super::{poppler, print, problems};

fn sheets() -> Vec<Page> {
    let exercises = problems::exercises(1);
    let one = exercises.iter().find(|exercise| exercise.problem().id() == "impact/two-carts").unwrap();
    ["Ana", "Bo", "Zoë"].map(|name| Page::Sheet(Sheet { student: Some(name.into()), ..one.sheet() })).to_vec()
}

#[test]
fn the_same_document_has_the_same_bytes() {
    let pages = sheets();
    let first = print(&pages);
    print(&pages[..1]);
    let document = Renderer::new(None).unwrap().render(&pages, Format::Typst).unwrap().text;
    let again = std::thread::spawn(move || Press::new(None).unwrap().pdf(&document).unwrap()).join().unwrap();
    assert!(first == again, "{} bytes, then {}", first.len(), again.len());
}

#[test]
fn readers_that_speak_find_titles_headings_and_words_for_pictures() {
    let pdf = print(&sheets()[..1]);
    // The metadata is not compressed: PDF/UA asks for that.
    let raw = String::from_utf8_lossy(&pdf);
    assert!(raw.contains("<pdfuaid:part>1</pdfuaid:part>") && raw.contains("/Lang"), "no PDF/UA");
    if poppler::is_installed() {
        let info = poppler::info(&pdf);
        assert!(
            info.contains("Title:           Two carts on a straight track") && info.contains("Tagged:          yes"),
            "{info}"
        );
        let structure = poppler::structure(&pdf);
        assert!(
            structure.contains("H1") && structure.contains("Figure") && structure.contains("Formula"),
            "{structure}"
        );
    }
}

#[test]
fn the_language_of_the_course_is_that_of_the_document() {
    let sheet = Page::Sheet(Sheet { title: "Zwei Wagen".into(), identity: Identity::default(), ..Sheet::default() });
    let renderer = Renderer::new(None).unwrap().language("de-CH");
    let document = renderer.render(&[sheet], Format::Typst).unwrap().text;
    assert!(document.contains("lang: \"de\", region: \"CH\""));
    let pdf = Press::new(None).unwrap().pdf(&document).unwrap();
    assert!(String::from_utf8_lossy(&pdf).contains("(de-CH)"));
}

#[test]
fn each_students_sheet_begins_on_a_right_hand_page() {
    if !poppler::is_installed() {
        return;
    }
    let pages = poppler::pages(&print(&sheets()));
    let starts: Vec<usize> = (0..pages.len()).filter(|page| pages[*page].contains("\nFor ")).collect();
    assert_eq!(starts, [0, 2, 4], "{pages:#?}");
    assert!(pages[2].contains("For Bo") && pages[2].trim_end().ends_with('1'), "{}", pages[2]);
}

#[test]
fn a_sheet_reads_as_it_should() {
    if poppler::is_installed() {
        insta::assert_snapshot!("sheet", poppler::pages(&print(&sheets()[..1])).join("\n----\n"));
    }
}
