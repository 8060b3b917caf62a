//! What needs motions with stops.

use super::chain;
use frictiongen::study::{System, SystemOrbit};

fn single(contact: &str, excitation: &str, rest: &str) -> System {
    chain(&[1.0], &[1.0], contact, excitation, rest)
}

fn orbit(system: &System, r: f64, beta: f64) -> SystemOrbit<'_> {
    let orbit = system.at(r).expect("in the domain").orbit(beta);
    orbit.unwrap_or_else(|error| panic!("r = {r}, β = {beta}: {error}"))
}

fn amplitude(orbit: &SystemOrbit<'_>) -> f64 {
    orbit.mass_at(0).expect("a mass").amplitude()
}

/// Asymmetric responses at r = 1/2 up to β = 1/3, and 1/12 with the wall on the base.
#[test]
fn f11_f12() {
    for (system, limit) in [
        (single("m1 - wall", "m1", ""), 1.0 / 3.0),
        (single("m1 - base", "base", ""), 1.0 / 12.0),
    ] {
        for share in [0.2, 0.6, 0.98] {
            let orbit = orbit(&system, 0.5, limit * share);
            assert!(!orbit.is_symmetric() && orbit.is_marginal());
            assert_eq!((orbit.stops(), orbit.reversals()), (0, 2));
        }
        let beyond = orbit(&system, 0.5, limit * 1.02);
        assert!(beyond.is_symmetric() && !beyond.is_marginal());
        assert_eq!(beyond.stops(), 2);
    }
}

/// Stops a cycle: two predominate; one stop near r = 1/2, and only for μ > 1.
#[test]
fn f33() {
    for (rest, points) in [
        ("", &[][..]),
        ("stiction: 1.5", &[(0.52, 0.08), (0.56, 0.12)]),
    ] {
        let system = single("m1 - base", "base", rest);
        let (mut two, mut stopping) = (0, 0);
        for i in 1..16 {
            for j in 1..30 {
                let (r, beta) = (0.16 * f64::from(i), 0.12 * f64::from(j));
                let Ok(orbit) = system.at(r).expect("in the domain").orbit(beta) else {
                    continue;
                };
                stopping += usize::from(orbit.stops() > 0);
                two += usize::from(orbit.stops() == 2);
                assert!(orbit.stops() != 1 || !points.is_empty());
            }
        }
        assert!(
            stopping > 10 && two * 10 >= stopping * 9,
            "{two} of {stopping}"
        );
        for (r, beta) in points {
            assert_eq!(orbit(&system, *r, *beta).stops(), 1);
        }
    }
}

/// No stop beyond β_lim, for r = 1/3 and 1/5; printed: sticking for any β > 0.
#[test]
fn f35_f36() {
    let system = single("m1 - wall", "m1", "");
    for (r, beta, largest) in [
        (1.0 / 3.0, 0.01, 0.983_595_621),
        (0.2, 0.005, 0.993_884_883),
    ] {
        let orbit = orbit(&system, r, beta);
        assert_eq!((orbit.stops(), orbit.reversals()), (0, 6));
        assert!((amplitude(&orbit) - largest).abs() < 5e-10);
    }
}

#[test]
fn f37() {
    let system = single("m1 - wall", "m1", "");
    let orbit = orbit(&system, 0.3, 0.4);
    assert_eq!((orbit.stops(), orbit.reversals()), (2, 0));
    assert!((amplitude(&orbit) - 0.856_729_778_057_8).abs() < 5e-14);
}

/// From which β on no sliding state of the mass on its base comes up to the base's own motion.
#[test]
fn f09() {
    let system = single("m1 - base", "base", "");
    let largest = |beta: f64| {
        let mut largest = 0.0_f64;
        for step in 40..160 {
            let at = system.at(f64::from(step) * 0.02).expect("in the domain");
            if beta < at.sliding_limit() {
                let orbit = at.orbit(beta).expect("a steady state");
                largest = largest.max(amplitude(&orbit));
            }
        }
        largest
    };
    let (mut above, mut below) = (1.0, 1.2);
    assert!(1.0 < largest(above) && largest(below) < 1.0);
    while below - above > 1e-3 {
        let middle = 0.5 * (above + below);
        if 1.0 < largest(middle) {
            above = middle;
        } else {
            below = middle;
        }
    }
    // The thesis goes in steps of 0.01.
    assert!(1.05 < above && below <= 1.06, "{below}");
}
