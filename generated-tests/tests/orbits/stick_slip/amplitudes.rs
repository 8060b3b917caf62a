//! Compares the largest |x̄| of a mass in a motion with stops with two values: samples of the motion, and the
//! amplitude of the contact.

use frictiongen::friction_system;

friction_system! {
    struct Slow {
        masses: { m1: 1.0, m2: 1.0 },
        springs: { base - m1: 1.0, m1 - m2: 1.0 },
        contact: m2 - wall,
        excitation: m1,
        damping: modal[0.1 / 0.6180339887498949, 0.1 / 1.618033988749895],
        provide: [limits, orbit],
    }
}

/// Checks amplitudes of masses that hardly move. While the contact is stuck, its mass moves only by rounding. A
/// search for a level that only this rounding reaches must not leave the stop.
#[test]
fn of_masses_that_hardly_move() {
    const SAMPLES: u32 = 400;
    let mut compared = 0;
    for k in 0..1500_u32 {
        let r = 0.3 + 1.7 * f64::from(k) / 1500.0;
        let beta = 0.2 + 0.6 * f64::from(k % 7) / 7.0;
        let orbit = Slow::at(r).expect("in the domain").orbit(beta);
        let orbit = orbit.unwrap_or_else(|error| panic!("r = {r}, β = {beta}: {error}"));
        compared += 1;
        // The amplitude of the contact follows from the events, without a search.
        let (mass, contact) = (orbit.mass(1).amplitude(), orbit.contact().amplitude());
        assert!(
            (mass - contact).abs() <= 1e-9 * contact.max(1e-6),
            "r = {r}, β = {beta}: {mass:e}, of the contact {contact:e}"
        );
        let first = orbit.mass(0);
        let sample = |i| {
            let turn = f64::from(i) / f64::from(SAMPLES);
            first.displacement(turn * core::f64::consts::TAU).abs()
        };
        let sampled = (0..SAMPLES).map(sample).fold(0.0, f64::max);
        let amplitude = first.amplitude();
        // Samples at intervals of 2π/400 miss at most a fraction of (π/400)²/2 = 3e-5 of a sinusoid, and 1e-3 of its
        // tenth harmonic.
        assert!(
            sampled <= amplitude * (1.0 + 1e-12) && amplitude <= sampled * (1.0 + 1e-3),
            "r = {r}, β = {beta}: {amplitude:e}, of samples {sampled:e}"
        );
    }
    println!("{compared} orbits compared, none skipped");
    assert_eq!(compared, 1500);
}
