//! Compares steady states with those of `reference/orbits.json`. Another program followed each motion for up to
//! thousands of cycles, with an error of about 1e-9.

use frictiongen::System;
use serde_json::Value;

/// Tolerance of the comparison. The reference has an error of about 1e-10 where a contact hardly moves.
const TOLERANCE: f64 = 1e-8;

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

fn close(found: f64, expected: f64, scale: f64, what: &str) {
    let apart = (found - expected).abs();
    assert!(
        apart <= TOLERANCE * scale,
        "{what}: {found} instead of {expected}"
    );
}

#[test]
fn every_steady_state() {
    let scenes: Vec<Value> =
        serde_json::from_str(include_str!("../../../reference/orbits.json")).expect("JSON");
    let (mut seen, mut compared) = (0, 0);
    for scene in &scenes {
        let text = scene["description"].as_str().expect("text");
        let system: System = text.parse().expect("a scene");
        for expected in scene["orbits"].as_array().expect("orbits") {
            let (r, beta) = (number(&expected["r"]), number(&expected["beta"]));
            let what = format!("{text}\nr = {r}, β = {beta}");
            let orbit = system.at(r).expect("in the domain").orbit(beta);
            let orbit = orbit.unwrap_or_else(|error| panic!("{what}: {error}"));
            let stops = expected["stops"].as_u64().expect("a count");
            assert_eq!(orbit.stops() as u64, stops, "{what}");
            let symmetric = expected["symmetric"].as_bool().expect("a flag");
            assert_eq!(orbit.is_symmetric(), symmetric, "{what}");
            assert!(orbit.is_stable(), "{what}");
            let stuck = number(&expected["stuck_fraction"]);
            close(orbit.stuck_fraction(), stuck, 1.0, &what);
            let contact = orbit.contact();
            let moved = number(&expected["contact_amplitude"]);
            close(contact.amplitude(), moved, moved, &what);
            let mean = number(&expected["contact_mean"]);
            close(contact.harmonic(0).re, mean, 1.0, &what);
            compared += 6;
            let masses = system.scene().masses.len();
            for values in ["amplitude", "fundamental"] {
                assert_eq!(expected[values].as_array().map(Vec::len), Some(masses));
            }
            for mass in 0..masses {
                let motion = orbit.mass_at(mass).expect("a mass");
                let amplitude = number(&expected["amplitude"][mass]);
                close(motion.amplitude(), amplitude, amplitude, &what);
                let first = motion.harmonic(1);
                let [re, im] = [0, 1].map(|part| number(&expected["fundamental"][mass][part]));
                close(first.re, re, amplitude, &what);
                close(first.im, im, amplitude, &what);
                compared += 3;
            }
            seen += 1;
        }
    }
    println!("{compared} values of {seen} steady states compared, none skipped");
    assert_eq!((seen, compared), (44, 504));
}
