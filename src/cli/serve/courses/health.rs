//! Reports of a running server on itself.

use std::io::{Read, Write};
use std::net::{IpAddr, Ipv4Addr, Ipv6Addr, SocketAddr, TcpStream};
use std::time::Duration;

use super::finding::Finding;

/// The longest time that a server may take to answer.
const PATIENCE: Duration = Duration::from_secs(10);
/// The bytes of an answer that are read.
const SHOWN: u64 = 4096;

/// The report of the server on an address at `/health`, below the path of its pages.
pub(super) fn finding(bind: SocketAddr, path: &str) -> Finding {
    let address = reached(bind);
    let help =
        "see its log (`journalctl -u momentous`), make room where the disk is full, and see whether the database runs";
    match asked(address, path) {
        Ok(answer) => {
            let said = answer.rsplit("\r\n").next().unwrap_or_default().trim();
            let status = answer.split(' ').nth(1).unwrap_or_default();
            if status == "200" {
                Finding::fine(format!("the server on {address} answers, and keeps what it is given"))
            } else {
                Finding::wrong(format!("the server on {address} says: {status} {said}"), help)
            }
        }
        Err(error) => {
            let help = "see whether it runs, and name its address with --bind";
            Finding::wrong(format!("the server on {address} does not answer: {error}"), help)
        }
    }
}

/// The address at which this machine reaches a server that listens so.
fn reached(bind: SocketAddr) -> SocketAddr {
    let ip = match bind.ip() {
        IpAddr::V4(ip) if ip.is_unspecified() => Ipv4Addr::LOCALHOST.into(),
        IpAddr::V6(ip) if ip.is_unspecified() => Ipv6Addr::LOCALHOST.into(),
        ip => ip,
    };
    SocketAddr::new(ip, bind.port())
}

fn asked(address: SocketAddr, path: &str) -> std::io::Result<String> {
    let mut stream = TcpStream::connect_timeout(&address, PATIENCE)?;
    stream.set_read_timeout(Some(PATIENCE))?;
    write!(stream, "GET {path}/health HTTP/1.1\r\nHost: {address}\r\nConnection: close\r\n\r\n")?;
    let mut answer = Vec::new();
    stream.take(SHOWN).read_to_end(&mut answer)?;
    Ok(String::from_utf8_lossy(&answer).into_owned())
}
