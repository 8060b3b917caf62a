//! Tests that no text makes the parser panic or loop for ever, and that both parsers agree.
#![allow(
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "a test may fail"
)]

use frictiongen_codegen::{SizeLimits, parse_text, parse_tokens};
use fuzzing::Random;

const VALID: &str = "/// Doc.
pub(crate) struct Frame {
    masses: { lower: 3.27, upper: 3.25 * (1 + 0.5) }, // kg
    springs: { base - lower: 1190.0, lower - upper: -1 + 2e3, upper - wall: 1e1 },
    contact: upper - wall, /* brass */
    excitation: base,
    damping: modal[0.010, 0.012],
    stiction: 1.2,
    provide: [limits, motion(lower), stuck],
    accuracy: exact,
    scalar: f64,
    crate: ::frictiongen,
}";

const PIECES: [&str; 48] = [
    "{", "}", "(", ")", "[", "]", ",", ":", "::", "-", "->", "+", "*", "/", "//", "/*", "*/",
    "///", "//!", "/**", "\"", "'", "#", "#[", "#!", "=", ".", "..", "1", "1e400", "0x", "1e",
    "9_f32", "r#", "r#type", "_", "struct", "base", "wall", "lower", "masses:", "modal", "é", "ⓐ",
    "§", "\\", "\n", "\u{0}",
];

fn mutate(text: &mut Vec<char>, random: &mut Random) {
    let at = random.below(text.len() + 1);
    let to = (at + random.below(12)).min(text.len());
    match random.below(5) {
        0 => drop(text.drain(at..to)),
        1 => drop(text.splice(at..at, PIECES[random.below(PIECES.len())].chars())),
        2 => drop(text.splice(at..to, PIECES[random.below(PIECES.len())].chars())),
        3 => {
            let copy: Vec<char> = text[at..to].to_vec();
            let there = random.below(text.len() + 1);
            drop(text.splice(there..there, copy));
        }
        _ => text.truncate(if random.below(20) == 0 {
            at
        } else {
            text.len()
        }),
    }
}

/// Checks that neither parser panics. The two parsers must give the same verdict on a text of Rust tokens.
fn check(text: &str) -> bool {
    let from_text = parse_text(text, &SizeLimits::RUN_TIME);
    if let Err(diagnostics) = &from_text {
        assert!(!diagnostics.list.is_empty());
        for one in &diagnostics.list {
            assert!(
                one.line >= 1 && one.column >= 1 && !one.message.is_empty(),
                "{text}"
            );
        }
    }
    let Ok(tokens) = text.parse() else {
        return from_text.is_ok();
    };
    match (parse_tokens(tokens, &SizeLimits::RUN_TIME), &from_text) {
        (Ok(tokens), Ok(text)) => assert_eq!(tokens.scene, text.scene),
        (Err(_), Err(_)) => {}
        (tokens, from_text) => panic!("{text}\n{tokens:?}\n{from_text:?}"),
    }
    from_text.is_ok()
}

#[test]
fn the_text_is_valid_to_begin_with() {
    assert!(check(VALID));
}

#[test]
fn no_mutation_panics() {
    let mut random = Random(2021);
    let mut valid = 0;
    for _ in 0..10_000 {
        let mut text: Vec<char> = VALID.chars().collect();
        for _ in 0..=random.below(6) {
            mutate(&mut text, &mut random);
        }
        valid += usize::from(check(&text.iter().collect::<String>()));
    }
    // Some mutations change only comments or digits, so some texts stay valid. Without valid texts the test would show
    // nothing.
    assert!((100..9_000).contains(&valid), "{valid}");
}

#[test]
fn no_heap_of_pieces_panics() {
    let mut random = Random(5);
    for _ in 0..10_000 {
        let count = random.below(40);
        let text: String = (0..count)
            .flat_map(|_| [PIECES[random.below(PIECES.len())], " "])
            .collect();
        check(&text);
        check(&format!("struct S {{ {text} }}"));
    }
}

#[test]
fn every_beginning_of_a_text_is_told_what_it_lacks() {
    for (end, _) in VALID.char_indices() {
        assert!(!check(&VALID[..end]), "{end}");
    }
}

#[test]
fn depth_and_length_are_bounded() {
    for sign in [
        "(",
        "[",
        "{",
        "-",
        "masses: {",
        "/*",
        "#",
        "a: 1,",
        "'",
        "1 + (",
    ] {
        let heap = sign.repeat(200_000);
        assert!(parse_text(&heap, &SizeLimits::RUN_TIME).is_err());
        let inside = format!("struct S {{ masses: {{ a: {heap} 1");
        assert!(parse_text(&inside, &SizeLimits::RUN_TIME).is_err());
    }
}
