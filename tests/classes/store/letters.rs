//! A sheet is printed in the letters that its course had when the assignment opened, whatever the settings of the bank say later.

use std::fs;
use std::path::Path;

use momentous::store::Address;

use super::class::Class;
use super::client::Client;
use super::database::{Database, block_on};
use super::server::Server;

const CARTS: &str = include_str!("../../../problem_bank/impact/two-carts.yaml");

/// A bank of one problem, which asks for a momentum, under settings with this letter for it.
fn bank(folder: &Path, letter: &str) {
    let topic = folder.join("problem_bank/impact");
    fs::create_dir_all(&topic).unwrap();
    let (asked, instead) = ("{ find: T_lost, unit: J, points: 1 }", "{ find: p_A2, unit: N s, points: 1 }");
    assert!(CARTS.contains(asked));
    fs::write(topic.join("two-carts.yaml"), CARTS.replacen(asked, instead, 1)).unwrap();
    fs::write(folder.join("problem_bank/course.yaml"), format!("symbols: {{ momentum: {letter} }}\n")).unwrap();
}

/// The page of the item, without the key of the next request, which is drawn at random.
fn page(server: &Server, item: &str, cookie: &str) -> String {
    let page = Client::of(&server.address).unwrap().get(item, cookie).unwrap();
    assert_eq!(page.status, 200, "{}", page.text);
    let (before, after) = page.text.split_once("name=\"request\" value=\"").unwrap();
    format!("{before}{}", &after[32..])
}

#[test]
fn a_sheet_keeps_the_letters_in_which_it_was_printed() {
    let room = tempfile::tempdir().unwrap();
    let data = Address::Folder(room.path().join("data"));
    let class = block_on(async {
        let store = Database::Folder(data.clone()).serve().await;
        Class::kept(&store, 2, &[("impact/two-carts", "forward")]).await
    });
    let item = &class.items[0];
    bank(room.path(), "L");
    let server = Server::start(room.path(), &data);
    let mut client = Client::of(&server.address).unwrap();
    let cookies: Vec<String> = class.students.iter().map(|student| student.sign_in(&mut client)).collect();
    let first = page(&server, item, &cookies[0]);
    assert!(first.contains("<mi>L</mi>") && !first.contains("<mi>p</mi>"), "{first}");
    drop(server);
    bank(room.path(), "G");
    let server = Server::start(room.path(), &data);
    assert_eq!(page(&server, item, &cookies[0]), first);
    let later = page(&server, item, &cookies[1]);
    assert!(
        later.contains("<mi>L</mi>") && !later.contains("<mi>G</mi>"),
        "one assignment, one way of writing: {later}"
    );
}
