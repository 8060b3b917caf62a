//! Compares damping that acts on velocities relative to the moving base with programs that use dense matrices: a
//! complex linear system for the motion without friction, and the plain integrator of the stepper's tests for motions
//! with friction.

mod emitted;
mod random;
mod record;

use frictiongen::System;

/// Returns the transmissibility of textbooks, √((1 + (2ζR)²)/((1 − R²)² + (2ζR)²)), with R = r for one mass.
fn textbook(r: f64, zeta: f64) -> f64 {
    let loss = (2.0 * zeta * r).powi(2);
    ((1.0 + loss) / ((1.0 - r * r).powi(2) + loss)).sqrt()
}

fn isolator(contact: &str) -> System {
    let text = format!(
        "struct Isolator {{ masses: {{ m: 100 }}, springs: {{ base - m: 3.9478e5 }}, contact: m - {contact},
            excitation: base, damping: modal(0.2), damping_from: base }}"
    );
    text.parse().expect("a scene")
}

/// Checks the isolator without friction for r from 0 to 10, with its contact on the base and on the wall.
#[test]
fn isolator_of_the_textbooks() {
    let mut compared = 0;
    for contact in ["base", "wall"] {
        let system = isolator(contact);
        for step in 0..=2000 {
            let r = f64::from(step) / 200.0;
            let at = system.at(r).expect("in the domain");
            let Ok(motion) = at.motion(0.0) else {
                // At r = 0 the contact does not slide.
                assert_eq!(step, 0);
                continue;
            };
            let amplitude = motion.mass("m").expect("a mass").amplitude();
            let want = textbook(r, 0.2);
            assert!((amplitude / want - 1.0).abs() < 1e-13, "r = {r}");
            compared += 1;
        }
        let r = system.frequency_ratio(std::f64::consts::TAU * 30.0);
        let motion = system.at(r).expect("a frequency").motion(0.0);
        let amplitude = motion
            .expect("continuous")
            .mass("m")
            .expect("a mass")
            .amplitude();
        assert_eq!(format!("{amplitude:.4}"), "0.1931");
    }
    println!("{compared} transmissibilities");
}

/// Checks that without damping the field `damping_from` changes no digit.
#[test]
fn without_damping_nothing_changes() {
    let text =
        "struct Two { masses: { a: 1, b: 2 }, springs: { base - a: 10, a - b: 15, b - wall: 3 },
        contact: b - a, excitation: base, stiction: 1.2";
    let [rest, base]: [System; 2] = [
        format!("{text} }}"),
        format!("{text}, damping: none, damping_from: base }}"),
    ]
    .map(|text| text.parse().expect("a scene"));
    for step in 1..200 {
        let r = 0.02 * f64::from(step);
        let both = [&rest, &base].map(|system| system.at(r).expect("in the domain"));
        let [one, other] = [&both[0], &both[1]].map(|at| at.limits());
        assert_eq!(one, other, "r = {r}");
        let [one, other] = [&both[0], &both[1]].map(|at| {
            let motion = at.motion(0.1 * one.continuous.min(one.sliding));
            motion.map(|motion| motion.mass("a").expect("a mass").amplitude())
        });
        assert_eq!(one.ok(), other.ok(), "r = {r}");
    }
}
