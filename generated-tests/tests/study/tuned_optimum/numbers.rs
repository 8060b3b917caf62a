//! Tests that a new value of a number in the description changes that number and nothing else.

use frictiongen::study::{System, optimum::Tunable, sensitivity::Quantity};

/// Returns a description of two masses with a given damping and given numbers.
fn described(damping: &str, numbers: [f64; 5]) -> System {
    let [a, b, first, second, stiction] = numbers;
    let text = format!(
        "struct Pair {{ masses: {{ a: {a:?}, b: {b:?} }}, springs: {{ base - a: {first:?}, a - b: {second:?} }},
         contact: b - wall, excitation: a, damping: {damping}, stiction: {stiction:?} }}"
    );
    text.parse().expect("a valid scene")
}

const NUMBERS: [f64; 5] = [1.5, 0.4, 3.0, 0.7, 1.2];

/// Asserts that `with_value` gives the same scene as a new description.
fn same(system: &System, name: &str, value: f64, damping: &str, numbers: [f64; 5]) {
    let of = system.tunable_named(name).expect("a number");
    let changed = system.with_value(of, value).expect("a scene");
    assert_eq!(
        changed.scene(),
        described(damping, numbers).scene(),
        "{name}"
    );
}

#[test]
fn another_value_changes_one_number() {
    let cases = [
        "none",
        "modal(0.02)",
        "modal[0.02, 0.03]",
        "rayleigh(0.05, 0.02)",
    ];
    let mut tried = 0;
    for damping in cases {
        let system = described(damping, NUMBERS);
        for (place, name) in ["m a", "m b", "k base - a", "k a - b", "mu"]
            .iter()
            .enumerate()
        {
            let mut numbers = NUMBERS;
            numbers[place] = 2.25;
            same(&system, name, 2.25, damping, numbers);
            tried += 1;
        }
        let others: &[(&str, &str)] = match damping {
            "none" => &[
                ("zeta", "modal(0.07)"),
                ("zeta 1", "modal[0.07, 0]"),
                ("zeta 2", "modal[0, 0.07]"),
                ("a", "rayleigh(0.07, 0)"),
                ("b", "rayleigh(0, 0.07)"),
            ],
            "modal(0.02)" => &[
                ("zeta", "modal(0.07)"),
                ("zeta 1", "modal[0.07, 0.02]"),
                ("zeta 2", "modal[0.02, 0.07]"),
            ],
            "modal[0.02, 0.03]" => &[
                ("zeta", "modal(0.07)"),
                ("zeta 1", "modal[0.07, 0.03]"),
                ("zeta 2", "modal[0.02, 0.07]"),
            ],
            _ => &[("a", "rayleigh(0.07, 0.02)"), ("b", "rayleigh(0.05, 0.07)")],
        };
        for (name, expected) in others {
            same(&system, name, 0.07, expected, NUMBERS);
            tried += 1;
        }
        assert_eq!(
            system.tunables().len(),
            5 + others.len(),
            "{damping}: each number is tried"
        );
    }
    assert_eq!(tried, 33);
}

/// Checks that a number that the description does not contain is refused.
#[test]
fn a_number_that_is_not_there() {
    let ratio = Tunable::Quantity(Quantity::DampingRatio(0));
    let factor = Tunable::Quantity(Quantity::StiffnessDamping);
    assert!(
        described("rayleigh(0.05, 0.02)", NUMBERS)
            .with_value(ratio, 0.1)
            .is_err()
    );
    assert!(
        described("modal(0.02)", NUMBERS)
            .with_value(factor, 0.1)
            .is_err()
    );
    let beyond = Tunable::Quantity(Quantity::DampingRatio(2));
    assert!(
        described("modal(0.02)", NUMBERS)
            .with_value(beyond, 0.1)
            .is_err()
    );
}
