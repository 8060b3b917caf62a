//! Tests that one contact is the same scene in the fields `contact` and `contacts`.

use crate::read_scene;
use frictiongen_model::scene::{
    CONTACT, ConstantForce, ContactSides, Impact, NamedStop, Node, Scene, StopLaw,
};

fn read(fields: &str) -> Scene {
    let text = format!(
        "struct Chain {{ masses: {{ a: 2, b: 3 }}, springs: {{ base - a: 5, a - b: 6 }}, excitation: base, {fields} }}"
    );
    read_scene(&text).unwrap_or_else(|errors| panic!("{errors}\n{text}"))
}

#[test]
fn one_contact_is_the_same_scene_in_both_fields() {
    for (one, listed) in [
        ("contact: b - wall", "contacts: { contact: b - wall }"),
        (
            "contact: b - a, stiction: 1.2",
            "contacts: { contact: b - a { stiction: 1.2 } }",
        ),
        (
            "contact: b - base, stiffness: 40",
            "contacts: { contact: b - base { stiffness: 40, share: 1 } }",
        ),
        (
            "contact: b - wall, friction: stribeck(0.1: 0.8)",
            "contacts: { contact: b - wall }, friction: stribeck(0.1: 0.8)",
        ),
        (
            "contact: b - wall, accuracy: 1e-4, range: { r: 0.2..2 }, provide: [limits, motion]",
            "contacts: { contact: b - wall }, accuracy: 1e-4, range: { r: 0.2..2 }, provide: [limits, motion]",
        ),
    ] {
        assert_eq!(read(listed), read(one), "{one}");
    }
    let named = read("contacts: { pads: b - wall { stiction: 1.2 } }");
    assert_eq!(named.contact_name, "pads");
    let unnamed = Scene {
        contact_name: CONTACT.to_owned(),
        ..named
    };
    assert_eq!(unnamed, read("contact: b - wall, stiction: 1.2"));
}

/// Checks that `contact: a - b { … }` is `contacts: { contact: a - b { … } }`.
#[test]
fn a_single_contact_has_the_properties_of_a_named_one() {
    for (properties, is_joined) in [
        ("{ stiffness: 40 }", false),
        ("{ stiffness: 40, stiction: 1.2 }", false),
        ("{}", false),
        ("{ share: 0.5 }", true),
        ("{ speed: 0.2 }", true),
    ] {
        let single = read(&format!("contact: b - wall {properties}"));
        let named = read(&format!("contacts: {{ contact: b - wall {properties} }}"));
        assert_eq!(single, named, "{properties}");
        assert_eq!(single.is_joined(), is_joined, "{properties}");
    }
    let fields = read("contact: b - wall, stiffness: 40, stiction: 1.2");
    for mixed in [
        "contact: b - wall { stiffness: 40, stiction: 1.2 }",
        "contact: b - wall { stiffness: 40 }, stiction: 1.2",
        "stiffness: 40, contact: b - wall { stiction: 1.2 }",
        "contact: b - wall {}, stiffness: 40, stiction: 1.2",
    ] {
        assert_eq!(read(mixed), fields, "{mixed}");
    }
}

#[test]
fn several_contacts_stay_in_the_list() {
    for fields in [
        "contacts: { pads: b - wall { share: 0.5 } }",
        "contacts: { pads: b - wall }, dampers: { a - b: 1 }",
        "contacts: { pads: b - wall { speed: 0.2 } }",
        "contacts: { pads: b - wall }, stops: { bumper: b - a { gap: 0, restitution: 1 } }",
        "contacts: { pads: b - wall }, constant: { a: 3 }",
        "contacts: { pads: b - wall, brace: base - a { stiffness: 40 } }",
    ] {
        assert!(read(fields).is_joined(), "{fields}");
    }
    for text in [
        // No spring holds a mass.
        "struct Block { masses: { a: 2 }, contacts: { pads: a - wall }, excitation: a }",
        "struct Pair { masses: { a: 2, b: 3 }, springs: { a - b: 6 }, contacts: { pads: a - wall }, excitation: a }",
        // The load never moves the contact.
        "struct Idle { masses: { a: 2, b: 3 }, springs: { base - a: 5, base - b: 6 }, contacts: { pads: b - wall }, excitation: a }",
    ] {
        assert!(
            read_scene(text).is_ok_and(|scene| scene.is_joined()),
            "{text}"
        );
    }
}

#[test]
fn stops_and_constant_forces_keep_their_order_and_numbers() {
    let scene = read(
        "contact: b - wall, constant: { b: -3, a: 4 }, stops: { soft: a - b { gap: 0.1, damping: 5, stiffness: 6 },
         rigid: wall - b { restitution: 0, gap: -0.2 } }",
    );
    let stop = |name: &str, from, to, gap, impact| NamedStop {
        name: name.to_owned(),
        sides: ContactSides { from, to },
        law: StopLaw { gap, impact },
    };
    let spring = Impact::Spring {
        stiffness: 6.0,
        damping: 5.0,
    };
    let [a, b] = [0, 1].map(Node::Mass);
    assert_eq!(
        scene.joints.stops,
        [
            stop("soft", a, b, 0.1, spring),
            stop("rigid", Node::Wall, b, -0.2, Impact::Restitution(0.0)),
        ]
    );
    let forces = [(1, -3.0), (0, 4.0)].map(|(mass, force)| ConstantForce { mass, force });
    assert_eq!(scene.joints.constant, forces);
    assert!(scene.joints.contacts.is_empty() && scene.is_joined());
}

#[test]
fn a_length_of_its_own_is_that_of_friction_belts_stops_and_constant_forces() {
    for (fields, has_length) in [
        ("contact: b - wall", false),
        ("contact: b - wall, dampers: { a - b: 1 }", false),
        ("contact: b - wall, stiffness: 40, stiction: 1.2", false),
        (
            "contacts: { pads: b - wall { share: 0.5, speed: 0 } }",
            false,
        ),
        ("contact: b - wall, friction: stribeck(0.1: 0.8)", true),
        ("contacts: { pads: b - wall { speed: -0.2 } }", true),
        (
            "contact: b - wall, stops: { bumper: b - a { gap: 0, restitution: 1 } }",
            true,
        ),
        ("contact: b - wall, constant: { a: 3 }", true),
    ] {
        assert_eq!(read(fields).has_length(), has_length, "{fields}");
    }
}

/// Checks that a speed of 0 is the default, so that the contact is a single contact.
#[test]
fn a_contact_with_the_speed_0_is_a_single_contact() {
    assert_eq!(
        read("contacts: { contact: b - wall { speed: 0 } }"),
        read("contact: b - wall")
    );
}

/// Checks line, column and text of errors that end the parsing of an entry.
#[test]
fn every_error_of_stops_and_constant_forces_has_its_place() {
    let text = "struct Chain {
    masses: { a: 2, b: 3 },
    springs: { base - a: 5, a - b: 6 },
    contacts: { a_b: a - b { speed: fast }, pads: b - wall { speeds: 1 } },
    stops: {
        one: a - c { gap: 0.1, stiffness: 1e6 },
        two: a - b { gap: 0.1, restitution: 2, stiffness: 3 },
        two: b - b { gap: x, stiffness: 3 },
        a - b { gap: 0.1, stiffness: 1 },
        four: a - b { gpa: 0.1 },
    },
    constant: { a: 1, a: 2, base: 3, c: 4 },
    excitation: a,
}";
    let told = read_scene(text).unwrap_err().to_string();
    let places: Vec<&str> = told
        .lines()
        .map(|line| line.split(": ").next().unwrap())
        .collect();
    assert_eq!(
        places,
        [
            "4:37", "4:62", "6:18", "7:32", "8:9", "8:18", "8:27", "9:9", "10:23", "12:23",
            "12:29", "12:38"
        ],
        "{told}"
    );
}
