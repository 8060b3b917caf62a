//! Tests of the width of printed tables: what is asked fits, and the rest is named.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "a test may fail"
)]

use crate::common::{FRAME, output};

/// Commands that print tables, each with a heading that must not be left out.
const TABLES: [(&[&str], &str); 8] = [
    (&["limits", "--hz", "1:1:3"], "continuous limit"),
    (
        &["response", "--hz", "1:1:3", "--friction", "0.4"],
        "amplitude",
    ),
    (
        &[
            "response",
            "--hz",
            "1:1:3",
            "--friction",
            "0.4",
            "--of",
            "accel(upper)",
        ],
        "amplitude",
    ),
    (
        &["orbit", "--hz", "1:1:3", "--friction", "0.4"],
        "amplitude",
    ),
    (
        &[
            "curve",
            "--hz",
            "1:1.5",
            "--friction",
            "0.4",
            "--of",
            "upper-lower",
        ],
        "upper-lower",
    ),
    (
        &["map", "--hz", "1:1:3", "--friction", "0.4", "--of", "upper"],
        "upper",
    ),
    (
        &[
            "time",
            "--hz",
            "1.2",
            "--friction",
            "0.4",
            "--cycles",
            "1",
            "--samples",
            "8",
        ],
        "displacement",
    ),
    (
        &[
            "sensitivity",
            "--hz",
            "1.7",
            "--friction",
            "0.4",
            "--of",
            "lower",
        ],
        "lower",
    ),
];

#[test]
fn tables_fit() {
    for (asked, heading) in TABLES {
        let asked = [&asked[..1], &[FRAME], &asked[1..], &["--base", "0.001"]].concat();
        let whole = output("", &asked);
        for width in ["80", "100", "160"] {
            let text = output("", &[&asked[..], &["--width", width]].concat());
            let widest = text.lines().map(|line| line.chars().count()).max().unwrap();
            assert!(
                widest <= width.parse().unwrap(),
                "{asked:?}: {widest}\n{text}"
            );
            assert!(text.contains(heading), "{asked:?}: {heading}\n{text}");
            let unbroken = whole.lines().all(|line| line.chars().count() <= 80);
            assert!(
                unbroken || width == "160" || text.contains("left out to fit"),
                "{text}"
            );
        }
        assert_eq!(output("", &[&asked[..], &["--width", "0"]].concat()), whole);
    }
}

/// Beside Hz and N, r and beta need `--groups`.
#[test]
fn groups_on_request() {
    let asked = [
        "orbit",
        FRAME,
        "--hz",
        "1:1:3",
        "--friction",
        "0.4",
        "--base",
        "0.001",
        "--width",
        "120",
    ];
    let heading = |text: &str| {
        let at = text
            .lines()
            .position(|line| line.starts_with("---"))
            .unwrap();
        text.lines().nth(at - 2).unwrap().to_owned()
    };
    let short = output("", &asked);
    let words = heading(&short);
    assert!(
        !words
            .split_whitespace()
            .any(|word| word == "r" || word == "beta"),
        "{words}"
    );
    assert!(short.contains("--groups has r and beta"), "{short}");
    let words = heading(&output("", &[&asked[..], &["--groups"]].concat()));
    assert!(words.split_whitespace().any(|word| word == "r"), "{words}");
    assert!(
        words.split_whitespace().any(|word| word == "beta"),
        "{words}"
    );
}
