//! A client that keeps its connection, as browsers do.

use std::io::{BufRead, BufReader, Error, ErrorKind, Read, Result, Write};
use std::net::TcpStream;

/// A client of one server.
pub struct Client {
    address: String,
    stream: BufReader<TcpStream>,
}

/// What a client needs of a response.
#[derive(Debug, Default)]
pub struct Response {
    pub status: u16,
    /// The cookie that was set, as it is sent back.
    pub cookie: Option<String>,
    pub text: String,
}

impl Client {
    /// A connection to a server at `host:port`.
    pub fn of(address: &str) -> Result<Self> {
        let stream = TcpStream::connect(address)?;
        stream.set_nodelay(true)?;
        Ok(Self { address: address.to_owned(), stream: BufReader::new(stream) })
    }

    /// Asks for a page.
    pub fn get(&mut self, path: &str, cookie: &str) -> Result<Response> {
        self.ask(&format!("GET {path}"), cookie, "")
    }

    /// Sends a form from a page of the server.
    pub fn post(&mut self, path: &str, cookie: &str, fields: &[(&str, &str)]) -> Result<Response> {
        let pairs: Vec<String> = fields.iter().map(|(name, value)| format!("{name}={}", escaped(value))).collect();
        self.ask(&format!("POST {path}"), cookie, &pairs.join("&"))
    }

    /// Whether the server has closed the connection since its last response, as it may close any that waits for nothing.
    fn is_closed(&self) -> bool {
        let stream = self.stream.get_ref();
        let has_ended = stream.set_nonblocking(true).is_ok() && matches!(stream.peek(&mut [0]), Ok(0));
        stream.set_nonblocking(false).is_err() || has_ended
    }

    fn ask(&mut self, what: &str, cookie: &str, body: &str) -> Result<Response> {
        if self.is_closed() {
            *self = Self::of(&self.address)?;
        }
        let (address, length) = (&self.address, body.len());
        let request = format!(
            "{what} HTTP/1.1\r\nHost: {address}\r\nOrigin: http://{address}\r\nCookie: {cookie}\r\n\
             Content-Type: application/x-www-form-urlencoded\r\nContent-Length: {length}\r\n\r\n{body}"
        );
        self.stream.get_mut().write_all(request.as_bytes())?;
        self.response()
    }

    fn response(&mut self) -> Result<Response> {
        let mut response = Response::default();
        let mut length = 0;
        loop {
            let mut line = String::new();
            // A server that was killed closes the connection within a response, or before it.
            if self.stream.read_line(&mut line)? == 0 {
                return Err(ErrorKind::UnexpectedEof.into());
            }
            let line = line.trim_end();
            if line.is_empty() {
                break;
            }
            match line.split_once(": ") {
                None => response.status = line.split(' ').nth(1).and_then(|code| code.parse().ok()).unwrap_or(0),
                Some(("content-length", value)) => length = value.parse().map_err(Error::other)?,
                Some(("set-cookie", value)) => response.cookie = value.split(';').next().map(str::to_owned),
                Some(_) => {}
            }
        }
        let mut body = vec![0; length];
        self.stream.read_exact(&mut body)?;
        response.text = String::from_utf8_lossy(&body).into_owned();
        Ok(response)
    }
}

fn escaped(text: &str) -> String {
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || b"-_.".contains(&byte);
    text.bytes().map(|byte| if plain(byte) { char::from(byte).to_string() } else { format!("%{byte:02X}") }).collect()
}
