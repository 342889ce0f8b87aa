//! The drawn numbers of scheme 1, for ever: words found by an independent program (HMAC-SHA-256 and `ChaCha8` from their
//! definitions), and the values that a problem draws from them.

use momentous::fault::Source;
use momentous::problem::{Given, Streams, load};

type Golden = (&'static str, Option<&'static str>, &'static str, u64, u64, u64);

/// Problem, secret, name, seed, attempt, word.
const WORDS: &[Golden] = &[
    ("impact/two-carts", None, "m_A", 0, 0, 0x41d3_4a67_e71c_0c7b),
    ("impact/two-carts", None, "m_A", 1, 0, 0x59cb_b85f_23d2_6f97),
    ("impact/two-carts", None, "m_A", 6, 3, 0x4a4f_8d1e_861d_ebb2),
    ("impact/two-carts", None, "v_B1", 1, 0, 0x1c1a_4fa4_336a_dfe5),
    ("impact/two-carts", None, "v_B1", 1, 21, 0x6d1b_7409_58ae_2f01),
    ("impact/two-carts", Some("course 2026"), "m_A", 1, 0, 0xf43e_1640_cd5d_9f93),
    ("central/comet", None, "r_S1", u64::MAX, 0, 0x5ced_b7b5_f6a6_be90),
    ("central/comet", None, "r_S1", 4_294_967_296, 7, 0x7d5f_6d3f_4928_8c5e),
];

#[test]
fn words_are_those_of_the_scheme() {
    for &(problem, secret, name, seed, attempt, word) in WORDS {
        let streams = Streams::new(problem, secret.map(str::as_bytes), [name]);
        assert_eq!(streams.words().word(0, seed, attempt), word, "{problem} {name} {seed} {attempt}");
    }
}

#[test]
fn a_problem_draws_these_values() {
    let text = include_str!("../fixtures/problems/two_carts.yaml");
    let loaded = load(Source::new("two_carts.yaml", text)).unwrap();
    let streams = Streams::new(&loaded.draft.id, None, loaded.given.names());
    let mut words = streams.words();
    let mut variant = |seed: u64| {
        let draw = |(index, (name, given)): (usize, (&str, &Given))| match given {
            Given::Drawn { domain, unit } => {
                format!("{name} = {} {unit}", domain.value(domain.pick(words.word(index, seed, 0))))
                    .trim_end()
                    .to_owned()
            }
            other => format!("{name}: {other:?}"),
        };
        loaded.given.iter().enumerate().map(draw).collect::<Vec<_>>().join(", ")
    };
    let variants: Vec<String> = (0..4).map(&mut variant).collect();
    let expected = [
        "m_A = 2.0 kg, m_B = 5.0 kg, v_A1 = 6.0 m/s, v_B1 = -1.5 m/s, e = 0.80",
        "m_A = 2.5 kg, m_B = 2.0 kg, v_A1 = 5.5 m/s, v_B1 = -3.5 m/s, e = 0.50",
        "m_A = 1.0 kg, m_B = 4.0 kg, v_A1 = 5.0 m/s, v_B1 = -2.5 m/s, e = 0.65",
        "m_A = 3.0 kg, m_B = 5.0 kg, v_A1 = 5.5 m/s, v_B1 = -3.5 m/s, e = 0.80",
    ];
    assert_eq!(variants, expected);
}
