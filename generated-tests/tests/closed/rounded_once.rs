//! Tests that constants in single precision are double-double numbers, rounded once.
//!
//! A conversion through a double would round them twice. The difference shows only if the double lies halfway between
//! two single numbers, because the second rounding then does not know on which side of the halfway point the exact
//! number is. The stiffnesses here are (1 + k·2⁻²⁴)² with a rounding up or down. ω = √(k₁/m₁) then differs from a
//! halfway point by 2⁻⁵³.

use frictiongen::{System, friction_system};

/// Stiffness with ω = 1 + 2⁻²⁴ + 2⁻⁵³. The nearest single number is 1 + 2⁻²³. A rounding through a double would give
/// the even neighbour 1.
const ABOVE: &str = "1.0000001192092933";
/// Stiffness with ω = 1 + 3·2⁻²⁴ − 2⁻⁵³. The nearest single number is 1 + 2⁻²³. A rounding through a double would
/// give the even neighbour 1 + 2⁻²².
const BELOW: &str = "1.0000003576279004";

friction_system! {
    pub struct Above {
        masses: { block: 1 },
        springs: { base - block: 1.0000001192092933 },
        contact: block - wall,
        excitation: block,
        scalar: f32,
    }
}

friction_system! {
    pub struct Below {
        masses: { block: 1 },
        springs: { base - block: 1.0000003576279004 },
        contact: block - wall,
        excitation: block,
        scalar: f32,
    }
}

/// Returns (1 + k·2⁻²⁴)², which double precision represents exactly.
fn square(k: f64) -> f64 {
    let root = 1.0 + k * 2.0_f64.powi(-24);
    root * root
}

#[test]
fn emitted_and_at_run_time() {
    // These stiffnesses are the double-precision neighbours of the exact squares.
    let texts = [ABOVE, BELOW];
    let meant = [square(1.0).next_up(), square(3.0).next_down()];
    for (text, meant) in texts.iter().zip(meant) {
        assert_eq!(text.parse::<f64>().expect("a number"), meant);
    }
    let nearest = 1.0 + f32::EPSILON;
    let single = texts.map(|stiffness| {
        let text = format!(
            "struct Block {{ masses: {{ block: 1 }}, springs: {{ base - block: {stiffness} }},
                contact: block - wall, excitation: block }}"
        );
        let system: System<f32> = text.parse().expect("a valid scene");
        (system.natural_frequencies()[0], system.frequency_ratio(1.0))
    });
    let mut compared = 0;
    for (what, got) in [
        ("emitted, above", Above::NATURAL_FREQUENCIES[0]),
        ("emitted, below", Below::NATURAL_FREQUENCIES[0]),
        ("run time, above", single[0].0),
        ("run time, below", single[1].0),
    ] {
        assert_eq!(got, nearest, "{what}");
        compared += 1;
    }
    // The frequency ratio of 1 rad/s is 1/ω, so it shows the same rounding.
    for (what, got) in [
        ("emitted, above", Above::frequency_ratio(1.0)),
        ("emitted, below", Below::frequency_ratio(1.0)),
        ("run time, above", single[0].1),
        ("run time, below", single[1].1),
    ] {
        assert_eq!(got, 1.0 / nearest, "{what}");
        compared += 1;
    }
    println!("{compared} constants compared, none skipped");
    assert_eq!(compared, 8);
}
