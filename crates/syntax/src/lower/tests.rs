//! Tests that one contact is the same scene in the fields `contact` and `contacts`.

use crate::read_scene;
use frictiongen_model::scene::{CONTACT, Scene};

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

#[test]
fn several_contacts_stay_in_the_list() {
    for fields in [
        "contacts: { pads: b - wall { share: 0.5 } }",
        "contacts: { pads: b - wall }, dampers: { a - b: 1 }",
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
