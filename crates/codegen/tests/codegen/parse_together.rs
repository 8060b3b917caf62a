//! Tests that one error neither hides another nor is reported twice. Other tests of this file check what a macro can
//! still emit for a faulty description.
#![allow(
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "a test may fail"
)]

use frictiongen_codegen::{MacroErrors, SizeLimits, parse_text, parse_tokens};
use frictiongen_model::scene::Precision;

fn errors(text: &str) -> Vec<String> {
    let diagnostics = parse_text(text, &SizeLimits::MACRO).expect_err("the text is faulty");
    // `Display` prints the list, one error in a line.
    let printed: Vec<_> = diagnostics.to_string().lines().map(str::to_owned).collect();
    let listed: Vec<_> = diagnostics.list.iter().map(ToString::to_string).collect();
    assert_eq!(printed, listed);
    printed
}

fn failure(text: &str) -> MacroErrors {
    let tokens = text.parse().expect("the text is made of tokens");
    parse_tokens(tokens, &SizeLimits::MACRO).expect_err("the text is faulty")
}

const FAULTY: &str = "struct Frame {
    masses: { lower: 0, upper: 3,25, roof: 1.0 kg, },
    sprngs: { base - lower: 1190.0, lower - uper: 1323.0 upper - roof: 1/0, roof - roof: 1 },
    contact: upper - upper,
    excitation: wall,
    damping: modal[0.01, -0.01, x, 0.01],
    stiction: 0.5
    scalar: f16,
    provide: [limits, moton],
    colour: red,
}";

#[test]
fn every_error_is_told_at_once() {
    let errors = errors(FAULTY);
    let expected = [
        "2:22: the mass `lower` is 0.0",
        "2:34: a mass needs a name before its value",
        "2:48: `kg` does not belong",
        "3:5: a scene has no field `sprngs`; did you mean `springs`?",
        "3:58: a comma is missing before `upper`",
        "3:73: this divides by zero",
        "3:84: this spring joins `roof` to itself",
        "4:22: the contact rubs `upper` on itself",
        "5:17: a wall never moves",
        "6:26: a modal damping ratio is -0.01",
        "6:33: `x` is not a number",
        "7:15: the stiction μ is 0.5",
        "8:5: a comma is missing before `scalar`",
        "8:13: the scalar is",
        "9:23: `moton` cannot be provided; did you mean `motion`?",
        "10:5: a scene has no field `colour`",
    ];
    assert_eq!(errors.len(), expected.len(), "{errors:#?}");
    for (error, place) in errors.iter().zip(expected) {
        assert!(error.starts_with(place), "{error}\n{place}");
    }
}

#[test]
fn an_unreadable_part_gives_no_second_error() {
    for (from, to) in [
        // If the list of masses is unreadable, three follow-up errors must not occur: an unknown name, a mass without
        // support, and a damping list that is too short.
        ("{ a: 1, b: 2 }", "[1, 2]"),
        ("b: 2 }", "(b): 2 }"),
        // If the springs are unreadable, no mass may be reported as unsupported or out of reach.
        ("{ base - a: 1, a - b: 1 }", "1.0"),
        ("a - b: 1", "a = b: 1"),
        ("a - b: 1", "a - c: 1"),
        ("a - b: 1", "a - b: kg"),
        // If the contact or the excitation is unreadable, no mass may be reported as out of reach.
        ("b - wall", "b"),
        ("b - wall", "x - wall"),
        ("excitation: a", "excitation: x"),
        // A declaration that is incomplete, or that belongs to an item that is not emitted, is reported only once.
        ("stiction: 1", "range: 0"),
        ("stiction: 1", "range: { r: 0.1..1, beta: 0..1 }"),
        ("stiction: 1", "range: { r: 0..1 }, accuracy: 1e-4"),
        ("stiction: 1", "provide: [stepper], step: 0"),
        // If the list of provided items is unreadable, no field may be reported because the stepper is missing.
        ("stiction: 1", "provide: stepper, step: 1"),
        ("stiction: 1", "provide: [steper], friction: stribeck(1: 1)"),
        ("stiction: 1", "provide: [stepper, limit], force: { b }"),
        // An unreadable law, input or load is reported once.
        ("stiction: 1", "provide: [stepper], friction: stribeck(1)"),
        (
            "stiction: 1",
            "provide: [stepper], friction: stribeck(x: 0.5)",
        ),
        (
            "stiction: 1",
            "provide: [stepper], friction: stribeck(1: x, 2: 1)",
        ),
        ("stiction: 1", "input: 1"),
        ("stiction: 1", "friction: stribeck"),
        ("stiction: 1", "provide: [stepper], force: { x, b }"),
        (
            "stiction: 1",
            "stiction: 0.5, provide: [stepper], friction: stribeck(1: 0.9)",
        ),
        // Unreadable items leave an empty list, which is not a separate error.
        ("stiction: 1", "provide: [limit]"),
        ("stiction: 1", "provide: [motion(c)]"),
        ("stiction: 1", "accuracy: good"),
        ("stiction: 1", "stiction: one"),
        ("modal[0.1, 0.2]", "modal[0.1, ]x"),
        ("modal[0.1, 0.2]", "modal[0.1, x]"),
        ("modal[0.1, 0.2]", "modal(x)"),
        ("modal[0.1, 0.2]", "rayleigh(1, x)"),
        ("masses", "maases"),
    ] {
        let text = "struct S { masses: { a: 1, b: 2 }, springs: { base - a: 1, a - b: 1 }, \
            contact: b - wall, excitation: a, damping: modal[0.1, 0.2], stiction: 1 }";
        assert!(text.contains(from), "{from}");
        let expected = if to.ends_with("]x") { 2 } else { 1 };
        let errors = errors(&text.replacen(from, to, 1));
        assert_eq!(errors.len(), expected, "{to}: {errors:#?}");
    }
}

#[test]
fn each_error_of_a_macro_is_on_its_token() {
    let places: Vec<_> = failure(FAULTY)
        .errors
        .list
        .into_iter()
        .map(|(span, message)| {
            let start = span.start();
            format!("{}:{}: {message}", start.line, start.column + 1)
        })
        .collect();
    assert_eq!(places, errors(FAULTY));
}

#[test]
fn a_failure_keeps_what_a_macro_can_use() {
    let partial = failure(
        "/// Doc.
        pub(crate) struct Frame {
            masses: { lower: 0, type: 1, lower: 2, contact: 1, upper: },
            scalar: f32,
            crate: ::other,
        }",
    )
    .partial;
    assert_eq!(partial.name.expect("it has a name"), "Frame");
    assert_eq!(partial.mass_names, ["lower", "upper"]);
    assert_eq!(partial.precision, Precision::F32);
    assert_eq!(partial.facade.to_string(), ":: other");
    assert_eq!(partial.visibility.to_string(), "pub (crate)");
    assert_eq!(partial.documentation.len(), 1);

    // The moving base, the loaded masses and the step decide the fields of the input and `STEP`.
    let stepped = "struct Frame { masses: { a: 1, b: 1, c: 1 }, springs: { base - a: 1 }, contact: c - wall, \
        excitation: b, provide: [stepper], force: { c, b, a, x }, step: 1e }";
    let partial = failure(stepped).partial;
    assert_eq!((partial.on_base, partial.forces), (false, vec![0, 2]));
    assert!(partial.has_step);

    let partial = failure("struct type").partial;
    assert!(!partial.on_base && partial.forces.is_empty() && !partial.has_step);
    assert!(partial.name.is_none() && partial.mass_names.is_empty());
    assert_eq!(partial.facade.to_string(), ":: frictiongen");

    let deep = format!(
        "struct Deep {{ stiction: {}1{} }}",
        "(".repeat(70),
        ")".repeat(70)
    );
    let failure = failure(&deep);
    assert_eq!(failure.partial.name.expect("it has a name"), "Deep");
    assert_eq!(failure.errors.list.len(), 1);
}

#[test]
fn groups_without_brackets_are_read_as_a_macro_means_them() {
    use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
    let group = |text: &str| -> TokenStream {
        let inner: TokenStream = text.parse().expect("tokens");
        TokenTree::from(Group::new(Delimiter::None, inner)).into()
    };
    let (visibility, name, sum) = (group("pub(crate)"), group("a"), group("1 + 2"));
    let (nothing, negative) = (group(""), proc_macro2::Literal::f64_unsuffixed(-1.0));
    let tokens = quote::quote! {
        #nothing #visibility struct S {
            masses: { #name: #sum * 2 },
            springs: { base - #name: 4 - #negative },
            contact: #name - wall,
            excitation: #name,
        }
    };
    let description = parse_tokens(tokens, &SizeLimits::MACRO).expect("the tokens are sound");
    assert_eq!(description.scene.masses[0].value, 6.0);
    assert_eq!(description.scene.springs[0].stiffness, 5.0);
    let visibility: syn::Visibility = syn::parse2(description.visibility).expect("a visibility");
    assert!(matches!(visibility, syn::Visibility::Restricted(_)));
}
