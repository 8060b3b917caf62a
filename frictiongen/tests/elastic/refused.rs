//! Descriptions and questions that an elastic contact refuses by name.

use frictiongen::study::{System, scene::FrictionLaw};

const BLOCK: &str =
    "struct Block { masses: { block: 2.0 }, springs: { base - block: 50.0 }, contact: block - wall,
    stiffness: 400.0, excitation: block }";

fn told(text: &str) -> String {
    text.parse::<System>()
        .map(|_| ())
        .expect_err("an error")
        .to_string()
}

#[test]
fn faulty_stiffnesses_are_named() {
    for (stiffness, part) in [
        ("0", "it must be greater than zero"),
        ("-5.0", "it must be greater than zero"),
        ("1e25", "write at most"),
        ("1e70", "not between 1e-60 and 1e60"),
    ] {
        let message = told(&BLOCK.replace("400.0", stiffness));
        assert!(message.contains(part), "{stiffness}: {message}");
    }
    for (stiffness, part) in [
        (f64::NAN, "not a finite number"),
        (f64::INFINITY, "leave `stiffness` out"),
    ] {
        let builder = System::builder()
            .mass("block", 2.0)
            .spring("base", "block", 50.0)
            .contact("block", "wall");
        let error = builder
            .excitation("block")
            .stiffness(stiffness)
            .build()
            .expect_err("an error");
        assert!(error.to_string().contains(part), "{error}");
    }
}

/// The message names the largest stiffness that keeps the digits, and the scene accepts that stiffness.
#[test]
fn the_largest_stiffness_is_accepted() {
    let message = told(&BLOCK.replace("400.0", "1e25"));
    let most = message
        .split("write at most ")
        .nth(1)
        .and_then(|rest| rest.split(',').next())
        .expect("a number");
    assert!(
        BLOCK.replace("400.0", most).parse::<System>().is_ok(),
        "{most}"
    );
}

#[test]
fn fields_that_do_not_go_with_it_are_named() {
    for (field, part) in [
        (
            "accuracy: 1e-4, range: { r: 0.2..2.0 }",
            "leave `accuracy` and `range` out",
        ),
        ("friction: stribeck(0.1: 0.8)", "exclude each other"),
    ] {
        let message =
            told(&BLOCK.replace("excitation: block", &format!("excitation: block, {field}")));
        assert!(message.contains(part), "{field}: {message}");
    }
    let builder = System::builder()
        .mass("block", 2.0)
        .spring("base", "block", 50.0)
        .contact("block", "wall");
    let law = FrictionLaw::Stribeck(vec![[0.1, 0.8]]);
    assert!(
        builder
            .excitation("block")
            .stiffness(400.0)
            .friction(law)
            .build()
            .is_err()
    );
}

/// Questions about motion without stops have no answer.
#[test]
fn questions_of_a_rigid_contact_have_no_answer() {
    let system: System = BLOCK.parse().expect("a scene");
    assert_eq!(system.quasi_static_start(0.1), None);
    assert_eq!(system.high_frequency_limits(), (0.0, 0.0));
}
