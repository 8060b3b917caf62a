//! Compares the closed forms with plain time integration.
//!
//! The integration shares only the numbers of the scenes with the project. It uses matrices written by hand, the
//! classical Runge-Kutta method with a fixed step, and reversals by bisection within a step. Damped scenes run until
//! the transient has died out. For undamped scenes Newton's method finds the periodic state on the half-period map of
//! the same integration.
//!
//! With [`equations::STEPS`] steps in a half period, the phase of the fastest mode of the compared scenes changes by
//! less than 4e-3 rad in a step. The error of the Runge-Kutta method is then about 1e-11. The tests also assert that
//! the remaining transient, or Newton's residual, is below 1e-11. The instants of reversals and the displacements
//! then agree within 1e-11, and [`TOLERANCE`] leaves one more digit.

mod boundaries;
mod equations;
mod scenes;
mod steady;

use equations::{Chain, TOLERANCE};
use frictiongen::study::System;
use scenes::{on_base, on_each_other, on_wall};
use std::f64::consts::PI;
use steady::{steady, wrapped};

fn compare(chain: &Chain, damped: bool, text: &str, names: &[&str]) {
    let system: System = text
        .parse()
        .unwrap_or_else(|error| panic!("{error}\n{text}"));
    let at = system.at(chain.r).unwrap();
    let motion = at
        .motion(chain.beta)
        .unwrap_or_else(|error| panic!("{error:?}: {}", at.continuous_limit()));
    let steady = steady(chain, damped);

    let z = chain.relative(steady.top.t, &steady.top.y);
    let contact = motion.contact();
    let compared = std::cell::Cell::new(0);
    let near = |label: &str, found: f64, expected: f64, size: f64| {
        compared.set(compared.get() + 1);
        let error = (found - expected).abs();
        assert!(
            error < TOLERANCE * size,
            "{label}: {found} against {expected}, {error:e} of {size}"
        );
    };
    near("contact amplitude", contact.amplitude(), z, z);
    let slack = wrapped(contact.phase() - steady.top.t);
    near("contact phase", slack, 0.0, 1.0);
    assert!(contact.phase() > -PI && contact.phase() <= PI);

    for (k, name) in names.iter().enumerate() {
        let mass = motion.mass(name).unwrap();
        let (amplitude, lag) = steady.amplitude(chain, k);
        near(
            &format!("amplitude of {name}"),
            mass.amplitude(),
            amplitude,
            amplitude,
        );
        // Usually the instant of a maximum is known only to the square root of the accuracy of its value. Here both
        // sides solve for zero velocity, which gives the instant with full accuracy.
        near(
            &format!("phase of {name}"),
            wrapped(mass.phase() - lag),
            0.0,
            10.0,
        );
        for tau in [0.0, 0.4, 1.1, 2.3, PI, 4.0, 5.9, -0.7, 13.0] {
            let value = steady.at(chain, steady.top.t + tau, k);
            near(
                &format!("{name} at {tau}"),
                mass.displacement(tau),
                value,
                amplitude,
            );
            let velocity = steady.at(chain, steady.top.t + tau, 3 + k);
            near(
                &format!("velocity of {name} at {tau}"),
                mass.velocity(tau),
                velocity,
                10.0 * amplitude,
            );
        }
        for n in [1, 3, 5] {
            let (re, im) = steady.harmonic(chain, k, n);
            let harmonic = mass.harmonic(n);
            near(&format!("Re X_{n} of {name}"), harmonic.re, re, amplitude);
            near(&format!("Im X_{n} of {name}"), harmonic.im, im, amplitude);
        }
    }
    // The contact has two values. Each mass has two values, nine instants with two values, and three harmonics with two
    // values.
    println!("{} compared, none skipped", compared.get());
    assert_eq!(compared.get(), 2 + names.len() * (2 + 2 * 9 + 2 * 3));
    assert_eq!(names.len(), chain.n);
}

#[test]
fn wall_undamped() {
    let (chain, text) = on_wall(false);
    compare(&chain, false, text, &["a", "b", "c"]);
}

#[test]
fn wall_damped() {
    let (chain, text) = on_wall(true);
    compare(&chain, true, text, &["a", "b", "c"]);
}

#[test]
fn base_undamped() {
    let (chain, text, names) = on_base(false);
    compare(&chain, false, text, names);
}

#[test]
fn base_damped() {
    let (chain, text, names) = on_base(true);
    compare(&chain, true, text, names);
}

#[test]
fn masses_undamped() {
    let (chain, text) = on_each_other(false);
    compare(&chain, false, text, &["a", "b"]);
}

#[test]
fn masses_damped() {
    let (chain, text) = on_each_other(true);
    compare(&chain, true, text, &["a", "b"]);
}
