//! Every scene of the stability suite by every method, against the table `tests/stability/table.txt`: right, refused by name, or
//! failing in the known way by the known amount. A method that starts to pass or to fail elsewhere breaks the test.

use std::fmt::Write;

use momentous::simulate::stability::run_all;

#[test]
fn every_method_does_what_the_table_says() {
    let mut table = String::new();
    let mut scene = "";
    for row in run_all() {
        if row.scene != scene {
            scene = row.scene;
            writeln!(table, "\n{scene}").unwrap();
        }
        writeln!(table, "    {:22}{}", row.method, row.verdict).unwrap();
    }
    let expected = include_str!("stability/table.txt").split_once("\n\n").expect("a head and a body").1;
    if table.trim() != expected.trim() {
        for (now, then) in table.trim().lines().zip(expected.trim().lines()).filter(|(now, then)| now != then) {
            println!("now   {now}\ntable {then}");
        }
        panic!("the table says otherwise; all of it is now:\n{table}");
    }
}
