//! `momentous gallery`: every figure once, on one page.

use crate::room::Room;

#[test]
fn the_page_shows_every_figure_that_was_written() {
    let room = Room::with(&[]);
    let told = room.fine(&["gallery", "impact/two-carts", "central-force", "--seed", "7", "-o", "gallery"]);
    let page = room.read("gallery/index.html");
    let shown: Vec<&str> = page.split("<img src=\"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
    assert!(told.starts_with(&format!("{} figures", shown.len())), "{told}");
    assert!(shown.contains(&"impact/two-carts/form-1-sheet.svg"), "{shown:?}");
    assert!(shown.contains(&"central-force/comet-visit/form-1-solution-1.svg"), "{shown:?}");
    for file in &shown {
        assert!(room.read(&format!("gallery/{file}")).contains("<title>"), "{file}");
    }
    for heading in [
        "<h2>impact</h2>",
        "<h2>central-force</h2>",
        "A comet at its nearest point · central-force/comet-visit · orbit",
    ] {
        assert!(page.contains(heading), "{heading}");
    }
    // The same seed gives the same sheet's figure as `generate` prints.
    room.fine(&["generate", "impact/two-carts", "--seed", "7", "-o", "sheets/"]);
    let drawn = room.names("sheets").into_iter().find(|name| name.contains(".svg")).unwrap();
    assert_eq!(room.read(&format!("sheets/{drawn}")), room.read("gallery/impact/two-carts/form-1-sheet.svg"));
}
