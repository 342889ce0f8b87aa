#![no_main]

#[path = "../soak.rs"]
mod soak;

libfuzzer_sys::fuzz_target!(init: soak::prepare("route"), |bytes: &[u8]| soak::run("route", bytes));
