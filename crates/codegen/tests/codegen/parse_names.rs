//! Tests that names and attributes of a text are those that `syn` reads.
#![allow(clippy::expect_used, reason = "a test may fail")]

use frictiongen_codegen::{SizeLimits, parse_text, parse_tokens};
use frictiongen_syntax::read_scene;
use std::collections::BTreeSet;
use syn::ext::IdentExt;
use syn::parse::Parser;

/// Returns the words that the lexer refuses as names. Each word is on a line of its own.
fn refused(words: &[String]) -> BTreeSet<usize> {
    let told = read_scene(&words.join("\n")).expect_err("words are no scene");
    let names = told
        .list
        .iter()
        .filter(|told| told.message.contains("is not a name"));
    names.map(|told| told.line - 1).collect()
}

fn compare(words: &[String]) -> usize {
    let refused = refused(words);
    for (line, word) in words.iter().enumerate() {
        let read = syn::Ident::parse_any.parse_str(word).is_ok();
        assert_eq!(read, !refused.contains(&line), "{word:?}");
    }
    refused.len()
}

#[test]
fn names_of_every_kind() {
    let words = [
        "a",
        "_",
        "_1",
        "A9",
        "struct",
        "type",
        "Self",
        "crate",
        "async",
        "gen",
        "union",
        "é",
        "é1",
        "unten_ß",
        "上",
        "Étage",
        "ⓐ",
        "aⓐ",
        "ªb",
        "ʹx",
        "x·",
        "हिन्दी",
        "ﬁ",
        "ℵ0",
        "𝑥",
        "ǅ",
        "ᛮ",
        "Ⅷ",
        "r#type",
        "r#é",
        "r#a1",
    ];
    let words: Vec<_> = words.map(str::to_owned).into();
    // Letters that end a word for the lexer are reported as signs, not as names.
    let whole: Vec<_> = words
        .into_iter()
        .filter(|word| !word.contains(['·', 'ि', '्', 'ी']))
        .collect();
    assert!(compare(&whole) >= 2);
}

#[test]
fn every_letter_of_unicode() {
    let letters = ('\u{80}'..=char::MAX).filter(|letter| letter.is_alphabetic());
    let words: Vec<_> = letters
        .flat_map(|letter| [letter.to_string(), format!("a{letter}")])
        .collect();
    assert!(words.len() > 200_000, "{}", words.len());
    assert!(compare(&words) > 100);
}

#[test]
fn attributes_of_every_form() {
    let scene =
        "struct S { masses: { a: 1 }, springs: { base - a: 1 }, contact: a - wall, excitation: a }";
    for (attribute, read_at_run_time) in [
        ("#[doc]", true),
        ("#[doc = \"a\"]", true),
        ("#[doc = \"a\\n\\\"b\"]", true),
        ("#[doc = concat!(\"a\", \"b\")]", true),
        ("#[doc(hidden)]", true),
        ("#[doc[hidden]]", true),
        ("#[allow(dead_code, reason = \"a\")]", true),
        ("#[doc::inline = \"a\"]", true),
        ("#[doc 5]", true),
        ("#[doc = ]", false),
        ("#[doc = 5]", false),
        ("#[doc hidden]", false),
        ("#[doc \"a\"]", false),
        ("#[doc(hidden) x]", false),
        ("#[doc, hidden]", false),
        // Only emitted code needs the expression.
        ("#[doc = +]", true),
        ("#[doc = \"a\" \"b\"]", true),
        ("#[doc::]", true),
    ] {
        let text = format!("{attribute} {scene}");
        let tokens = text.parse().expect("the text is made of tokens");
        let from_text = parse_text(&text, &SizeLimits::MACRO);
        let told = |text: String| format!("this attribute cannot be read: {text}");
        match parse_tokens(tokens, &SizeLimits::MACRO) {
            Ok(from_tokens) => {
                let from_text = from_text.expect("both read the attribute");
                let [text, tokens] =
                    [from_text, from_tokens].map(|description| description.attributes.to_string());
                assert_eq!(text, tokens, "{attribute}");
                assert!(read_at_run_time, "{attribute}");
            }
            Err(failure) => {
                let from_text = from_text.expect_err("both refuse the attribute").list;
                let message = failure.errors.to_string();
                assert_eq!(from_text.len(), 1, "{attribute}");
                assert_eq!(from_text.first().map(|one| &one.message), Some(&message));
                // `syn` decides whether the form is valid.
                if !attribute.contains('5') {
                    let error = syn::Attribute::parse_outer
                        .parse_str(attribute)
                        .map(|_| ())
                        .expect_err("`syn` refuses the attribute");
                    assert_eq!(message, told(error.to_string()), "{attribute}");
                }
            }
        }
        let at_run_time = read_scene(&text);
        assert_eq!(at_run_time.is_ok(), read_at_run_time, "{attribute}");
    }
}

#[test]
fn paths_are_alike_in_a_text_and_in_tokens() {
    for path in [
        "::a",
        "a::b",
        "crate::r#type::b",
        "self::super::a",
        "::é::r#é",
        "r#async",
    ] {
        let text = format!(
            "pub(in {path}) struct S {{ crate: {path}, masses: {{ a: 1 }}, springs: {{ base - a: 1 }}, \
             contact: a - wall, excitation: a }}"
        );
        let from_text = parse_text(&text, &SizeLimits::MACRO).expect("a scene");
        let tokens = text.parse().expect("the text is made of tokens");
        let from_tokens = parse_tokens(tokens, &SizeLimits::MACRO).expect("a scene");
        let [text, tokens] = [from_text, from_tokens].map(|description| {
            (
                description.visibility.to_string(),
                description.facade.to_string(),
            )
        });
        // The text parser reads a raw word with non-ASCII letters as the plain word. Both words are the same name.
        assert_eq!(text.0.replace("r#é", "é"), tokens.0.replace("r#é", "é"));
        assert_eq!(text.1.replace("r#é", "é"), tokens.1.replace("r#é", "é"));
    }
}
