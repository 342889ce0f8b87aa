//! Lines of a file, counted alike whatever they end in, none of them longer than what fits into memory.

use std::collections::VecDeque;
use std::io;
use std::io::BufRead;
use std::io::ErrorKind;

/// The longest line that is kept, in bytes. Of a longer one the rest is passed over.
pub(super) const LONGEST: usize = 1 << 20;

/// Lines of a file.
#[derive(Debug)]
pub struct Lines<R> {
    input: R,
    /// Lines that were read and given back.
    ahead: VecDeque<Line>,
    /// The number of the line that was read last from the input.
    number: u64,
    /// The bytes that were read from the input.
    place: u64,
    /// Whether the input has failed: then nothing comes any more.
    is_over: bool,
}

/// A line.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Line {
    /// Its number, from 1.
    pub number: u64,
    /// Its beginning, in bytes.
    pub place: u64,
    /// Its bytes.
    pub bytes: Vec<u8>,
    /// Its end: `\n`, `\r\n`, `\r`, or nothing where the file ends.
    pub end: &'static str,
    /// Whether it was longer than a line may be.
    pub is_cut: bool,
}

impl<R: BufRead> Lines<R> {
    /// The lines of an input, from its beginning; a byte order mark is passed over.
    ///
    /// # Errors
    /// What the input says.
    pub fn of(mut input: R) -> io::Result<Self> {
        let mut place = 0;
        if filled(&mut input)?.starts_with("\u{feff}".as_bytes()) {
            input.consume('\u{feff}'.len_utf8());
            place = 3;
        }
        Ok(Self { input, ahead: VecDeque::new(), number: 0, place, is_over: false })
    }

    /// Reads the next line into the place of another one, whose memory it takes over; whether there is one.
    ///
    /// # Errors
    /// What the input says.
    pub fn read(&mut self, line: &mut Line) -> io::Result<bool> {
        if let Some(ahead) = self.ahead.pop_front() {
            *line = ahead;
            return Ok(true);
        }
        if self.is_over {
            return Ok(false);
        }
        let read = self.read_on(line);
        self.is_over = read.is_err();
        read
    }

    fn read_on(&mut self, line: &mut Line) -> io::Result<bool> {
        line.bytes.clear();
        (line.place, line.end, line.is_cut) = (self.place, "", false);
        loop {
            let buffer = filled(&mut self.input)?;
            if buffer.is_empty() {
                break;
            }
            let end = buffer.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
            let text = &buffer[..end.unwrap_or(buffer.len())];
            let room = LONGEST - line.bytes.len();
            line.bytes.extend_from_slice(&text[..text.len().min(room)]);
            line.is_cut |= text.len() > room;
            let is_return = end.is_some_and(|end| buffer[end] == b'\r');
            let taken = text.len() + usize::from(end.is_some());
            self.consume(taken);
            if end.is_some() {
                line.end = if is_return { "\r" } else { "\n" };
                if is_return && filled(&mut self.input)?.first() == Some(&b'\n') {
                    self.consume(1);
                    line.end = "\r\n";
                }
                break;
            }
        }
        let is_there = self.place > line.place;
        self.number += u64::from(is_there);
        line.number = self.number;
        Ok(is_there)
    }

    /// Gives lines back, which are the next ones then.
    pub(super) fn give_back(&mut self, lines: impl DoubleEndedIterator<Item = Line>) {
        for line in lines.rev() {
            self.ahead.push_front(line);
        }
    }

    fn consume(&mut self, bytes: usize) {
        self.input.consume(bytes);
        self.place += bytes as u64;
    }
}

impl<R: BufRead + io::Seek> Lines<R> {
    /// Goes to a line that begins there and has that number.
    ///
    /// # Errors
    /// What the input says.
    pub fn go_to(&mut self, place: u64, number: u64) -> io::Result<()> {
        // A short way is gone within what is in memory already.
        match i64::try_from(place).ok().zip(i64::try_from(self.place).ok()) {
            Some((to, from)) => self.input.seek_relative(to - from)?,
            None => _ = self.input.seek(io::SeekFrom::Start(place))?,
        }
        self.ahead.clear();
        (self.place, self.number, self.is_over) = (place, number.saturating_sub(1), false);
        Ok(())
    }
}

fn filled<R: BufRead>(input: &mut R) -> io::Result<&[u8]> {
    loop {
        match input.fill_buf() {
            Err(error) if error.kind() == ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
            // Asked for a second time, since a loop cannot give away what it borrowed.
            Ok(_) => return input.fill_buf(),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::*;

    fn all(text: &[u8]) -> Vec<(u64, String, &'static str)> {
        // A short buffer, so that line ends fall between two of them.
        let mut lines = Lines::of(io::BufReader::with_capacity(3, Cursor::new(text))).unwrap();
        let mut line = Line::default();
        let mut all = Vec::new();
        while lines.read(&mut line).unwrap() {
            all.push((line.number, String::from_utf8(line.bytes.clone()).unwrap(), line.end));
        }
        all
    }

    #[test]
    fn lines_count_the_same_with_any_ends() {
        for end in ["\n", "\r\n", "\r"] {
            let text = ["\u{feff}one", "", "three", "four"].join(end);
            let numbered: Vec<(u64, String)> =
                all(text.as_bytes()).into_iter().map(|(number, text, _)| (number, text)).collect();
            let expected = [(1, "one"), (2, ""), (3, "three"), (4, "four")];
            assert_eq!(numbered, expected.map(|(number, text)| (number, text.to_owned())), "{end:?}");
        }
        assert_eq!(all(b"a\r\nb\r"), [(1, "a".to_owned(), "\r\n"), (2, "b".to_owned(), "\r")]);
        assert_eq!(all(b""), []);
    }

    #[test]
    fn a_line_without_end_takes_no_more_memory_than_it_may() {
        let mut lines =
            Lines::of(io::BufReader::new(io::Read::chain(io::Read::take(io::repeat(b'x'), 3 << 20), &b"\nnext"[..])))
                .unwrap();
        let mut line = Line::default();
        assert!(lines.read(&mut line).unwrap() && line.is_cut);
        assert_eq!(line.bytes.len(), LONGEST);
        assert!(lines.read(&mut line).unwrap());
        assert_eq!((line.number, line.bytes.as_slice(), line.is_cut), (2, &b"next"[..], false));
    }
}
