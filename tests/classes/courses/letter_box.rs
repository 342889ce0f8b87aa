//! A server of mail of a test's own: it takes every letter, and shows what has come.

use std::io::{BufRead, BufReader, Write};
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread;
use std::time::Duration;

use momentous::course_pages::Post;

/// How long a letter may take that is to come, and how long none is waited for.
const PATIENCE: Duration = Duration::from_secs(20);
const QUIET: Duration = Duration::from_millis(300);

/// The letters that have come.
pub struct LetterBox {
    pub address: SocketAddr,
    letters: Receiver<String>,
}

impl LetterBox {
    pub fn new() -> Self {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let address = listener.local_addr().unwrap();
        let (put, letters) = channel();
        thread::spawn(move || {
            for stream in listener.incoming() {
                let put = put.clone();
                thread::spawn(move || take(&stream.unwrap(), &put));
            }
        });
        Self { address, letters }
    }

    /// Letters that are put into it.
    pub fn post(&self) -> Post {
        Post::new(&format!("smtp://{}", self.address), "Momentous <momentous@example.edu>").unwrap()
    }

    /// The next letter, with its head; long lines are whole again (quoted-printable, RFC 2045).
    #[track_caller]
    pub fn letter(&self) -> String {
        let letter = self.letters.recv_timeout(PATIENCE).expect("a letter");
        letter.replace("=\n", "").replace("=3D", "=")
    }

    /// The path of the link in the next letter.
    #[track_caller]
    pub fn link(&self) -> String {
        let letter = self.letter();
        let link = letter.lines().find_map(|line| line.split_once("/mail/")).unwrap_or_else(|| panic!("{letter}")).1;
        format!("/mail/{}", link.trim())
    }

    /// Whether nothing has come.
    pub fn is_empty(&self) -> bool {
        self.letters.recv_timeout(QUIET).is_err()
    }
}

/// Talks as servers of mail do (RFC 5321), to its end.
fn take(stream: &TcpStream, put: &Sender<String>) {
    let mut answer = stream;
    let mut lines = BufReader::new(stream).lines().map_while(Result::ok);
    let mut say = |text: &str| answer.write_all(format!("{text}\r\n").as_bytes()).is_ok();
    say("220 ready");
    while let Some(line) = lines.next() {
        let word = line.split([' ', ':']).next().unwrap_or_default().to_uppercase();
        let goes_on = match word.as_str() {
            "DATA" => {
                say("354 go on");
                let letter: Vec<String> = lines.by_ref().take_while(|line| line != ".").collect();
                put.send(letter.join("\n")).is_ok() && say("250 taken")
            }
            "QUIT" => {
                say("221 bye");
                false
            }
            _ => say("250 fine"),
        };
        if !goes_on {
            return;
        }
    }
}
