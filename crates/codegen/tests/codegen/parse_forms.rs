//! Tests the language, and that the text parser and the token parser read it alike.
#![allow(
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "a test may fail"
)]

use frictiongen_codegen::{Description, SizeLimits, parse_text, parse_tokens};
use frictiongen_model::scene::{
    Accuracy, ContactSides, Damping, Excitation, FrictionLaw, Node, Precision, Provide, Scene,
    Spring, StepInput, StepperOptions,
};
use syn::parse::Parser;

/// Reads a text with both parsers.
fn read(text: &str) -> Description {
    let from_text =
        parse_text(text, &SizeLimits::MACRO).unwrap_or_else(|errors| panic!("{errors}"));
    let tokens = text.parse().expect("the text is made of tokens");
    let from_tokens = parse_tokens(tokens, &SizeLimits::MACRO).expect("the tokens are sound");
    assert_eq!(from_text.scene, from_tokens.scene);
    assert_eq!(from_text.mass_names, from_tokens.mass_names);
    assert_eq!(from_text.name, from_tokens.name);
    let attributes = [&from_text, &from_tokens].map(|one| attributes(one).len());
    assert_eq!(attributes[0], attributes[1]);
    assert_eq!(from_text.documentation, from_tokens.documentation);
    from_text
}

/// Returns the attributes of a description, as `syn` reads them.
fn attributes(description: &Description) -> Vec<syn::Attribute> {
    let tokens = description.attributes.clone();
    let parsed = syn::Attribute::parse_outer.parse2(tokens);
    parsed.expect("attributes of Rust")
}

/// Returns a scene of two masses with more fields.
fn scene(fields: &str) -> Scene {
    read(&format!(
        "struct S {{ masses: {{ a: 1, b: 2 }}, springs: {{ base - a: 1, a - b: 1 }}, \
         contact: b - wall, excitation: a, {fields} }}"
    ))
    .scene
}

#[test]
fn the_frame_of_the_manual() {
    let description = read(
        "/// Two-storey shear frame; a brass disc rubs on the upper floor.
        pub struct Frame {
            masses: { lower: 3.27, upper: 3.25 },                      // kg; the first is m₁
            springs: { base - lower: 1190.0, lower - upper: 1323.0 },  // N/m; the first is k₁
            contact: upper - wall,
            excitation: base,
            damping: modal[0.010, 0.012],
            stiction: 1.2,
        }",
    );
    assert_eq!(description.name, "Frame");
    assert_eq!(description.visibility.to_string(), "pub");
    assert_eq!(attributes(&description).len(), 1);
    assert_eq!(description.documentation.len(), 1);
    let facade: syn::Path = syn::parse2(description.facade).expect("a path");
    assert!(facade.leading_colon.is_some());
    assert_eq!(facade.segments[0].ident, "frictiongen");
    let scene = description.scene;
    assert_eq!(scene.masses[1].name, "upper");
    assert_eq!(scene.masses[1].value, 3.25);
    let second = Spring {
        from: Node::Mass(0),
        to: Node::Mass(1),
        stiffness: 1323.0,
    };
    assert_eq!(scene.springs[1], second);
    assert_eq!(
        scene.contact,
        ContactSides {
            from: Node::Mass(1),
            to: Node::Wall
        }
    );
    assert_eq!(scene.excitation, Excitation::Base);
    assert_eq!(scene.damping, Damping::Modal(vec![0.010, 0.012]));
    assert_eq!(scene.stiction, 1.2);
}

#[test]
fn what_is_left_out_has_its_default() {
    let scene = scene("");
    assert_eq!(scene.damping, Damping::None);
    assert_eq!(scene.stiction, 1.0);
    assert_eq!(scene.precision, Precision::F64);
    assert_eq!(scene.provide, [Provide::Limits, Provide::Motion(None)]);
    assert_eq!(scene.declared.accuracy, Accuracy::Exact);
    assert_eq!(scene.declared.range, None);
}

#[test]
fn every_form_of_every_field() {
    assert_eq!(scene("damping: none").damping, Damping::None);
    assert_eq!(
        scene("damping: modal(0.02)").damping,
        Damping::Uniform(0.02)
    );
    assert_eq!(
        scene("damping: modal[1e-300, 8,]").damping,
        Damping::Modal(vec![1e-300, 8.0])
    );
    let rayleigh = Damping::Rayleigh {
        mass: 0.1,
        stiffness: 0.2,
    };
    assert_eq!(scene("damping: rayleigh(0.1, 0.2)").damping, rayleigh);
    assert_eq!(scene("scalar: f32").precision, Precision::F32);
    assert_eq!(scene("accuracy: exact").declared.accuracy, Accuracy::Exact);
    assert_eq!(
        scene("provide: [motion(b, a), stuck, orbit, simulation, limits]").provide,
        [
            Provide::Motion(Some(vec![1, 0])),
            Provide::Stuck,
            Provide::Orbit,
            Provide::Simulation,
            Provide::Limits
        ]
    );
}

#[test]
fn the_friction_law_and_the_stepper() {
    let plain = scene("provide: [stepper]");
    assert_eq!(plain.provide, [Provide::Stepper]);
    assert_eq!(plain.friction, FrictionLaw::Coulomb);
    assert_eq!(plain.stepping, StepperOptions::default());
    assert_eq!(plain.stepping.input, StepInput::Linear);
    let all = scene(
        "step: 1 / 48000, input: hold, force: { b, }, stiction: 1.5, provide: [stepper], \
         friction: stribeck(1e-3: 1.5, 2 * 0.1: 0.4,)",
    );
    let expected = StepperOptions {
        step: Some(1.0 / 48000.0),
        input: StepInput::Hold,
        forces: vec![1],
    };
    assert_eq!(all.stepping, expected);
    assert_eq!(all.friction.points(), [[1e-3, 1.5], [0.2, 0.4]]);
    let spelt_out = scene("friction: coulomb, input: linear, force: {}");
    assert_eq!(spelt_out, scene(""));
}

#[test]
fn contacts_of_every_kind_either_way_round() {
    for (text, from, to) in [
        ("a - b", Node::Mass(0), Node::Mass(1)),
        ("b-base", Node::Mass(1), Node::Base),
        ("base - a", Node::Base, Node::Mass(0)),
        ("wall - a", Node::Wall, Node::Mass(0)),
    ] {
        let scene = read(&format!(
            "struct S {{ contact: {text}, excitation: base, \
             springs: {{ base - a: 1, a - b: 1 }}, masses: {{ a: 1, b: 2 }} }}"
        ))
        .scene;
        assert_eq!(scene.contact, ContactSides { from, to });
    }
}

#[test]
fn numbers_are_arithmetic_on_literals() {
    for (text, value) in [
        ("1_000", 1000.0),
        ("1.5e-3", 1.5e-3),
        ("2E+2", 200.0),
        ("1 + 2 * 3 - 4 / 2", 5.0),
        ("(1 + 2) * -3 + 10", 1.0),
        ("8 / 2 / 2", 2.0),
        ("- - 2", 2.0),
        ("+2", 2.0),
        ("2 * -(-(3))", 6.0),
        ("0.1 + 0.2", 0.1 + 0.2),
    ] {
        let sum = format!("stiction: 1 + ({text})");
        assert_eq!(scene(&sum).stiction, 1.0 + value, "{text}");
    }
    let many = format!("stiction: {}2", "-".repeat(100_000));
    assert_eq!(scene(&many).stiction, 2.0);
    let deep = format!("stiction: {}2{}", "(".repeat(63), ")".repeat(63));
    assert_eq!(scene(&deep).stiction, 2.0);
}

#[test]
fn odd_layout_and_comments_change_nothing() {
    let tidy = scene("damping: modal(0.01), stiction: 1.5,");
    let odd = "\u{feff}// a /* comment\r\n/* and /* another */ */ /**/ pub(in crate::here)struct\tS{\
        stiction\n:\n1.5,damping:modal(0.01,),excitation:a,contact:b-/* the */wall,\
        masses:{a:1,b:2,},springs:{base-a:1,// k\n\na-b:1,},}";
    let odd = parse_text(odd, &SizeLimits::MACRO).expect("only the layout is odd");
    assert_eq!(odd.scene, tidy);
    let visibility: syn::Visibility = syn::parse2(odd.visibility).expect("a visibility");
    assert!(matches!(visibility, syn::Visibility::Restricted(_)));
}

#[test]
fn documentation_is_kept() {
    let doc = "/// One\n/** Two */ #[doc = \"Three\"] #[allow(dead_code)] #[deprecated(note = \"a \\\"b\\\"\")]\n";
    let rest =
        "struct S { masses: { a: 1 }, springs: { base - a: 1 }, contact: a - wall, excitation: a }";
    let description = read(&format!("{doc}{rest}"));
    assert_eq!(description.documentation(), "One\nTwo\nThree");
    let paths: Vec<_> = attributes(&description)
        .iter()
        .map(|one| one.path().segments[0].ident.to_string())
        .collect();
    assert_eq!(paths, ["doc", "doc", "doc", "allow", "deprecated"]);
}

#[test]
fn the_facade_may_have_another_name() {
    for (text, leading, segments) in [
        ("::friction", true, vec!["friction"]),
        (
            "crate::inner::friction",
            false,
            vec!["crate", "inner", "friction"],
        ),
    ] {
        let description = read(&format!(
            "struct S {{ crate: {text}, masses: {{ a: 1 }}, springs: {{ base - a: 1 }}, \
             contact: a - wall, excitation: a }}"
        ));
        let facade: syn::Path = syn::parse2(description.facade).expect("a path");
        assert_eq!(facade.leading_colon.is_some(), leading);
        let found: Vec<_> = facade
            .segments
            .iter()
            .map(|segment| segment.ident.to_string())
            .collect();
        assert_eq!(found, segments);
    }
}

#[test]
fn graphs_with_loops_and_walls() {
    let scene = read(
        "struct Scene38 {
            masses: { m1: 1.0, m2: 3.89677, m3: 3.70404, m4: 0.538117, m5: 0.325432 },
            springs: { base - m1: 1.0, m1 - m2: 3.12973, m2 - m3: 1.43467, m3 - m4: 2.89284,
                m4 - m5: 3.28471, m3 - wall: 1.48044, m1 - m5: 0.764305, base - m5: 1.85432 },
            contact: m4 - wall,
            excitation: base,
            damping: rayleigh(0.003825, 0.004001),
            stiction: 1.3,
        }",
    )
    .scene;
    assert_eq!(scene.springs.len(), 8);
}

#[test]
fn spreads_of_twelve_decades() {
    read(
        "struct Scene40 {
            masses: { m1: 1.0, m2: 1000000000000.0, m3: 1e-12, m4: 1.0 },
            springs: { base - m1: 1.0, m1 - m2: 1e-12, m2 - m3: 1000000000000.0, m3 - m4: 1.0 },
            contact: m1 - wall,
            excitation: m1,
        }",
    );
}

#[test]
fn letters_of_other_languages() {
    let scene = read(
        "struct Étage { masses: { unten_ß: 1, 上: 1 }, springs: { base - unten_ß: 1, unten_ß - 上: 1 }, \
         contact: 上 - wall, excitation: unten_ß }",
    )
    .scene;
    assert_eq!(scene.masses[1].name, "上");
}

#[test]
fn a_macro_takes_sixty_four_masses_and_a_text_a_thousand() {
    let chain = |count: usize| {
        let masses: Vec<_> = (0..count).map(|mass| format!("m{mass}: 1")).collect();
        let springs: Vec<_> = (1..count)
            .map(|mass| format!("m{} - m{mass}: 1", mass - 1))
            .collect();
        format!(
            "struct S {{ masses: {{ {} }},\nsprings: {{ base - m0: 1, {} }}, contact: m0 - wall, excitation: m0 }}",
            masses.join(", "),
            springs.join(", ")
        )
    };
    read(&chain(64));
    let tokens = chain(65).parse().expect("the text is made of tokens");
    let failure = parse_tokens(tokens, &SizeLimits::MACRO).expect_err("one too many");
    assert_eq!(
        failure.errors.to_string(),
        "the scene has 65 masses, but at most 64 are possible here; lump neighbouring masses together"
    );
    assert!(parse_text(&chain(1000), &SizeLimits::RUN_TIME).is_ok());
    assert!(parse_text(&chain(1001), &SizeLimits::RUN_TIME).is_err());
}
