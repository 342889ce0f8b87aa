//! The sheets of a class on paper.

use super::university::University;

#[test]
fn a_printed_sheet_is_the_one_that_the_student_sees() {
    let university = University::new();
    let whole =
        university.assignment(&[("impact/two-carts", "forward", 7), ("impulse/parcel-push", "forward", 2)], |_| {});
    university.set_clock(-1);
    let mut ida = university.browser_of("ida");
    let print = university.address(&format!("/assignments/{}/print", whole.assignment.key));
    let page = ida.get(&print).text(200);
    assert!(page.contains("4 sheets for 2 students") && page.contains("even before it opens"), "{page}");
    let sheets = ida.get(&format!("{print}/sheets"));
    assert_eq!(sheets.header("content-disposition"), Some("attachment; filename=\"sheets.html\""));
    let sheets = sheets.text(200);
    assert!(sheets.contains("ada &lt;script&gt; (ada)") && !sheets.contains("<script>"));
    let kept = university.wait(async |store| store.sheets(whole.assignment.key).await.unwrap());
    assert_eq!(kept.len(), 4);
    for sheet in &kept {
        let digest = &sheet.issued.digest;
        let file = university.wait(async |store| store.problem_file(university.course.key, digest).await.unwrap());
        assert!(file.is_some(), "its file is kept");
    }
    assert!(!ida.get(&print).text(200).contains("even before it opens"), "the problems are pinned");
    university.set_clock(0);
    let mut ada = university.browser_of("ada");
    let item = university.address(&format!("/items/{}", whole.items[0].key));
    ada.get(&item).text(200);
    let after = university.wait(async |store| store.sheets(whole.assignment.key).await.unwrap());
    assert_eq!(after, kept, "the page draws no other sheet");
    let again = ida.get(&format!("{print}/sheets")).text(200);
    assert_eq!(again, sheets);
    let key = ida.get(&format!("{print}/key")).text(200);
    assert!(key.contains("ada &lt;script&gt; (ada)") && key.contains("m/s"), "{key}");
    assert_eq!(ida.get(&format!("{print}/key?as=scroll")).status, 404);
    let pdf = ida.get(&format!("{print}/key?as=pdf"));
    assert_eq!(ida.get(&print).text(200).contains("?as=pdf"), cfg!(feature = "pdf"), "what is offered is there");
    if cfg!(feature = "pdf") {
        assert_eq!(pdf.header("content-type"), Some("application/pdf"));
    } else {
        assert_eq!(pdf.status, 404);
    }
    for login in ["ada", "ann"] {
        assert_eq!(university.browser_of(login).get(&format!("{print}/key")).status, 403, "{login}");
    }
}
