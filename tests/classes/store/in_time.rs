//! In time is what was asked for before the close: its headers are there, and the rest follows within half a minute.

use std::io::{BufRead, BufReader, Write};
use std::net::TcpStream;
use std::sync::Arc;
use std::sync::atomic::{AtomicI64, Ordering};
use std::sync::mpsc::channel;
use std::thread;

use momentous::course::Moment;
use momentous::course_pages::{Clock, serve};
use momentous::store::Address;
use momentous::web::Settings;

use super::class::Class;
use super::client::Client;
use super::database::on_both;

/// A server in this process, with a clock that the test sets: its address.
fn started(data: Address, clock: &Arc<AtomicI64>) -> String {
    let settings = Settings { bind: ([127, 0, 0, 1], 0).into(), ..Settings::default() };
    let read = Arc::clone(clock);
    let clock = Clock::new(move || Moment::from_millis(read.load(Ordering::SeqCst)));
    let (tell, told) = channel();
    // It serves until the tests end.
    thread::spawn(move || serve(settings, &data, None, clock, |address, _| tell.send(address.to_string()).unwrap()));
    told.recv().unwrap()
}

/// A form of which the headers were sent. The server wants the rest, so it has taken note of the time.
fn begun(address: &str, item: &str, cookie: &str, length: usize) -> BufReader<TcpStream> {
    let mut stream = TcpStream::connect(address).unwrap();
    write!(
        stream,
        "POST {item} HTTP/1.1\r\nHost: {address}\r\nOrigin: http://{address}\r\nCookie: {cookie}\r\nExpect: 100-continue\r\n\
         Content-Type: application/x-www-form-urlencoded\r\nContent-Length: {length}\r\n\r\n"
    )
    .unwrap();
    let mut stream = BufReader::new(stream);
    assert_eq!([line(&mut stream), line(&mut stream)], ["HTTP/1.1 100 Continue", ""]);
    stream
}

/// The next line of a response.
fn line(stream: &mut BufReader<TcpStream>) -> String {
    let mut line = String::new();
    stream.read_line(&mut line).unwrap();
    line.trim_end().to_owned()
}

#[test]
fn what_begins_before_the_close_counts_and_nothing_is_released_meanwhile() {
    on_both(async |database| {
        let store = database.serve().await;
        let class = Class::kept(&store, 1, &[("impact/two-carts", "forward")]).await;
        let closes = class.assignment.policy.closes;
        drop(store);
        let clock = Arc::new(AtomicI64::new(closes.millis()));
        let address = started(database.address(), &clock);
        let at = |after: i64| clock.store(closes.after(after).millis(), Ordering::SeqCst);
        let item = &class.items[0];
        let solution = format!("{item}/solution");
        let mut client = Client::of(&address).unwrap();
        let cookie = class.students[0].sign_in(&mut client);
        assert_eq!(client.get(item, &cookie).unwrap().status, 200);

        let body = "request=slow&answer.v_A2=1.00+m%2Fs";
        let mut slow = begun(&address, item, &cookie, body.len());
        at(15_000);
        assert_eq!(client.get(&solution, &cookie).unwrap().status, 403, "nothing is released yet");
        assert_eq!(client.post(item, &cookie, &[("answer.v_A2", "2.00 m/s")]).unwrap().status, 422, "it has closed");
        slow.get_mut().write_all(body.as_bytes()).unwrap();
        assert!(line(&mut slow).starts_with("HTTP/1.1 303"));
        at(60_000);
        let page = client.get(item, &cookie).unwrap().text;
        assert!(page.contains("class=\"receipts\"") && page.contains("1.00 m/s"), "{page}");
        assert_eq!(client.get(&solution, &cookie).unwrap().status, 403);
        at(60_001);
        assert_eq!(client.get(&solution, &cookie).unwrap().status, 200);
    });
}
