//! The pages of `momentous serve` with a clock that whoever runs it sets: for the tests in a browser, in which weeks pass. Each line of
//! standard input is a moment, as milliseconds since the beginning of 1970; the clock stands there until the next, and says so.
//! Problem files are checked by the program that the first argument names; the second is a server of mail, where there is one. The data
//! are in the current folder.

use std::env;
use std::error::Error;
use std::io::stdin;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::AtomicI64;
use std::sync::atomic::Ordering::SeqCst;
use std::thread::spawn;

use momentous::course::Moment;
use momentous::course_pages::{Clock, Post, serve};
use momentous::store::Address;
use momentous::web::Settings;

fn main() -> Result<(), Box<dyn Error>> {
    let settings = Settings {
        bind: ([127, 0, 0, 1], 0).into(),
        program: env::args_os().nth(1).map(PathBuf::from),
        ..Settings::default()
    };
    let first = told().ok_or("say on standard input when it begins, in milliseconds")?;
    let now = Arc::new(AtomicI64::new(first));
    let read = Arc::clone(&now);
    let clock = Clock::new(move || Moment::from_millis(read.load(SeqCst)));
    let post = env::args().nth(2).map(|server| Post::new(&server, "momentous@example.edu")).transpose()?;
    serve(settings, &Address::Folder("momentous-data".into()), post, clock, |address, link| {
        println!("http://{address}{}", link.unwrap_or_default());
        spawn(move || {
            while let Some(moment) = told() {
                now.store(moment, SeqCst);
                println!("{}", Moment::from_millis(moment));
            }
        });
    })?;
    Ok(())
}

/// The next moment on standard input.
fn told() -> Option<i64> {
    let line = stdin().lines().next()?.ok()?;
    line.trim().parse().ok()
}
