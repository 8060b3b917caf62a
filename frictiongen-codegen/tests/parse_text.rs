//! What is told about a text that is not even made of tokens, and about what stands around the fields.
#![allow(clippy::expect_used, reason = "a test may fail")]

use frictiongen_codegen::{Limits, parse_text, parse_tokens};

const FRAME: &str = "\
/// A frame.
pub struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    stiction: 1.2,
}
";

/// The errors of the frame after each first string in it has become the second.
fn errors(changes: &[(&str, &str)]) -> Vec<String> {
    let text = changes.iter().fold(FRAME.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from} is not in the frame");
        text.replacen(from, to, 1)
    });
    let diagnostics = parse_text(&text, &Limits::MACRO).expect_err("the text is faulty");
    // The other door, where it can be entered at all: what is no token never reaches a macro.
    if let Ok(tokens) = text.parse() {
        let failure = parse_tokens(tokens, &Limits::MACRO).expect_err("the tokens are faulty");
        let messages: Vec<_> = failure
            .errors
            .into_iter()
            .map(|error| error.to_string())
            .collect();
        let expected: Vec<_> = diagnostics
            .list
            .iter()
            .map(|one| one.message.clone())
            .collect();
        assert_eq!(messages, expected);
    }
    diagnostics.list.iter().map(ToString::to_string).collect()
}

macro_rules! told {
    ($($name:ident: $changes:tt => $expected:tt)*) => {
        $(#[test]
        fn $name() {
            assert_eq!(errors(&$changes), $expected);
        })*
    };
}

told! {
    an_empty_text: [(FRAME, "")] => [
        "1:1: there is no scene here; write `struct Name { masses: { … }, springs: { … }, contact: …, excitation: … }`",
    ]
    a_brace_that_does_not_close: [("stiction: 1.2,\n}\n", "stiction: 1.2,\n")] => [
        "2:18: this `{` is never closed; write `}` where it ends",
    ]
    a_list_that_does_not_close: [("3.25 }", "3.25")] => [
        "3:13: this `{` is not closed where its list ends; write `}` after the last entry",
    ]
    a_bracket_that_does_not_close: [("0.012]", "0.012")] => [
        "9:1: this `}` comes before the `[` (line 7, column 19) is closed; write `]` first",
    ]
    a_brace_too_many: [("1.2,\n}", "1.2,\n}}")] => [
        "9:2: this `}` closes nothing; delete it",
    ]
    the_wrong_bracket: [("0.012]", "0.012)")] => [
        "7:32: this `)` comes before the `[` (line 7, column 19) is closed; write `]` first",
    ]
    a_comment_that_does_not_close: [("stiction", "/* /* */ stiction")] => [
        "8:5: this comment is never closed; write `*/` where it ends",
    ]
    a_quotation_that_does_not_close: [("1.2", "\"1.2")] => [
        "8:15: this quotation mark is never closed; delete it, a scene needs none",
    ]
    a_stray_sign: [("3.27", "3.27 \\\\")] => [
        "3:27: `\\` means nothing in a scene; delete it",
        "3:28: `\\` means nothing in a scene; delete it",
    ]
    a_stray_character: [("3.27", "3.27 §")] => [
        "3:27: the character `§` (U+00A7) means nothing in a scene; delete it",
    ]
    a_typographic_minus: [("upper - wall", "upper − wall")] => [
        "5:20: `−` is typographic; write the plain `-`",
    ]
    a_name_of_foreign_signs: [("upper: 3.25", "ⓐ: 3.25")] => [
        "3:28: `ⓐ` is not a name; make names of letters, digits and `_`",
        "3:29: the name of a mass belongs here, not `:`; write, for example, `m1: 1.0`",
    ]
    a_description_without_struct: [("pub struct Frame", "Frame")] => [
        "2:1: `struct` is missing before `Frame`; write it there",
    ]
    another_item: [("pub struct Frame", "enum Frame")] => [
        "2:1: a scene is a `struct`, but here is `enum`; write `struct` instead",
    ]
    something_else_entirely: [("pub struct Frame", "17")] => [
        "2:1: a scene begins with `struct`, but here is `17`; write `struct Name { masses: { … }, springs: { … }, contact: …, excitation: … }`",
    ]
    fields_without_a_struct: [(FRAME, "masses: { a: 1 }, springs: { base - a: 1 }, contact: a - wall, excitation: a")] => [
        "1:1: the fields of a scene stand inside `struct Name { … }`; write that around them",
    ]
    a_struct_without_a_name: [("struct Frame", "struct")] => [
        "2:12: the name of the scene belongs here, not `{`; write, for example, `struct Frame`",
    ]
    nothing_after_struct: [(FRAME, "struct")] => [
        "1:7: the name of the scene belongs here, not the end; write, for example, `struct Frame`",
    ]
    a_keyword_for_a_scene: [("struct Frame", "struct Self")] => [
        "2:12: `Self` is a keyword of Rust and cannot name a scene; write, for example, `Frame`",
    ]
    type_parameters: [("struct Frame", "struct Frame<T>")] => [
        "2:17: a scene has no type parameters; delete them",
    ]
    no_braces: [(FRAME, "struct Frame;")] => [
        "1:13: the fields of a scene stand in braces, but here is `;`; write `{ … }` behind the name",
    ]
    a_second_scene: [("1.2,\n}", "1.2,\n} struct Other {}")] => [
        "9:3: `struct` stands behind the scene; one description holds one scene: give each a file or a macro call of its own",
    ]
    a_strange_visibility: [("pub struct", "pub(somewhere else) struct")] => [
        "2:4: a visibility is `pub`, `pub(crate)`, `pub(super)` or `pub(in path)`; write one of these",
    ]
    an_attribute_that_acts: [("/// A frame.", "#[derive(Debug)]")] => [
        "1:1: only doc comments, lint levels and `deprecated` may stand before a scene; put this attribute on a module around it",
    ]
    an_attribute_of_the_inside: [("/// A frame.", "#![allow(dead_code)]")] => [
        "1:1: a scene takes its doc comments and attributes from outside; write `///` or `#[…]` before `struct`",
    ]
    a_comment_of_the_inside: [("/// A frame.", "//! A frame.")] => [
        "1:1: a scene takes its doc comments and attributes from outside; write `///` or `#[…]` before `struct`",
    ]
    an_attribute_that_cannot_be_read: [("/// A frame.", "#[doc = ]")] => [
        "1:1: this attribute cannot be read: unexpected end of input, expected an expression",
    ]
    a_lone_hash: [("/// A frame.", "#")] => [
        "1:1: `#` means nothing here; a comment begins with `//`, a line of documentation with `///`",
    ]
    a_doc_comment_between_fields: [("    contact", "    /// Brass.\n    contact")] => [
        "5:5: doc comments and attributes stand before `struct` only; write a comment with `//` here",
    ]
}
