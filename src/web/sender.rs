//! From where a request comes, behind proxies too.

use std::net::{IpAddr, Ipv4Addr};

use axum::http::{Extensions, HeaderMap};
use ipnet::IpNet;

use super::arrival::Arrival;

/// The header in which proxies add the address of whoever asked them.
const FORWARDED: &str = "x-forwarded-for";

/// The address of whoever sent a request. Of the addresses in `X-Forwarded-For` the last one counts that was added by a proxy that is
/// believed, and is none itself: what stands before it may be invented.
#[must_use]
pub fn sender(extensions: &Extensions, headers: &HeaderMap, trusted: &[IpNet]) -> IpAddr {
    let from = extensions.get::<Arrival>().map_or(IpAddr::V4(Ipv4Addr::LOCALHOST), |arrival| arrival.from.ip());
    behind(from.to_canonical(), headers, trusted)
}

fn behind(from: IpAddr, headers: &HeaderMap, trusted: &[IpNet]) -> IpAddr {
    let is_trusted = |address: &IpAddr| trusted.iter().any(|network| network.contains(address));
    let mut from = from;
    let lines: Vec<&str> = headers.get_all(FORWARDED).iter().filter_map(|line| line.to_str().ok()).collect();
    for told in lines.iter().flat_map(|line| line.split(',')).rev() {
        let Some(told) = told.trim().parse::<IpAddr>().ok().filter(|_| is_trusted(&from)) else { break };
        from = told.to_canonical();
    }
    from
}

/// Senders in a count of tries: those of one household or host share a network of 64 bits in IPv6.
#[must_use]
pub fn network(address: IpAddr) -> [u8; 16] {
    match address {
        IpAddr::V4(address) => address.to_ipv6_mapped().octets(),
        IpAddr::V6(address) => {
            let mut octets = address.octets();
            octets[8..].fill(0);
            octets
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;

    #[test]
    fn only_proxies_that_are_believed_say_for_whom_they_ask() {
        // Who connects, what the header holds, and who is taken for the sender. 10.0.0.1 and 10.1.*.* are believed.
        let cases = [
            ("192.0.2.7", "", "192.0.2.7"),
            ("192.0.2.7", "198.51.100.9", "192.0.2.7"),
            ("10.0.0.1", "", "10.0.0.1"),
            ("10.0.0.1", "198.51.100.9", "198.51.100.9"),
            ("10.0.0.1", "203.0.113.5, 198.51.100.9", "198.51.100.9"),
            ("10.0.0.1", "203.0.113.5, 198.51.100.9, 10.1.2.3", "198.51.100.9"),
            ("10.0.0.1", "10.0.0.1", "10.0.0.1"),
            ("10.0.0.1", "nonsense", "10.0.0.1"),
            ("10.0.0.1", "198.51.100.9, nonsense", "10.0.0.1"),
            ("::ffff:10.0.0.1", "2001:db8::1", "2001:db8::1"),
        ];
        let trusted = ["10.0.0.1/32", "10.1.0.0/16"].map(|text| text.parse::<IpNet>().unwrap());
        for (from, header, expected) in cases {
            let mut headers = HeaderMap::new();
            // One proxy writes one line, another a line of its own.
            for line in header.split(", ").filter(|line| !line.is_empty()) {
                headers.append(FORWARDED, line.parse().unwrap());
            }
            let from = from.parse::<IpAddr>().unwrap().to_canonical();
            assert_eq!(behind(from, &headers, &trusted), expected.parse::<IpAddr>().unwrap(), "{from}: {header}");
        }
    }

    #[test]
    fn a_network_of_ipv6_is_one_sender() {
        let network = |text: &str| network(text.parse().unwrap());
        assert_eq!(network("2001:db8::1"), network("2001:db8::ffff:2"));
        assert_ne!(network("2001:db8::1"), network("2001:db8:0:1::1"));
        assert_ne!(network("192.0.2.7"), network("192.0.2.8"));
    }
}
