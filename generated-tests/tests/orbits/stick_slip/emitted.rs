//! Tests that emitted simulations and orbits equal those of the run-time system to the last bit.

use frictiongen::kernel::motion::ContactChain;
use frictiongen::kernel::orbit::{Orbit, OrbitMotion};
use frictiongen::kernel::simulation::{Part, Segment, Simulation};
use frictiongen::{Complex, NoOrbit, System};
use frictiongen_kernel::Float;

/// Returns the bits of every number of an orbit.
fn said<S, P, V, C, K>(orbit: &Orbit<'_, S, P, V, C, K>, masses: usize) -> Vec<u64>
where
    S: Float,
    P: AsRef<[Part<S>]> + Clone + AsMut<[Part<S>]>,
    V: AsRef<[S]> + AsMut<[S]>,
    C: AsRef<[Complex<S>]> + AsMut<[Complex<S>]>,
    K: ContactChain<S>,
{
    let mut bits = vec![
        orbit.stops() as u64,
        orbit.reversals() as u64,
        u64::from(orbit.is_symmetric()),
        u64::from(orbit.is_stable()),
        u64::from(orbit.is_marginal()),
        orbit.stuck_fraction().to_f64().to_bits(),
        orbit.origin().to_f64().to_bits(),
    ];
    for multiplier in orbit.multipliers() {
        bits.extend([multiplier.re, multiplier.im].map(|value| value.to_f64().to_bits()));
    }
    bits.extend(of_motion(&orbit.contact()));
    for mass in 0..masses {
        bits.extend(of_motion(&orbit.mass(mass)));
    }
    bits
}

fn of_motion<S, P, V, C, K>(motion: &OrbitMotion<'_, '_, S, P, V, C, K>) -> Vec<u64>
where
    S: Float,
    P: AsRef<[Part<S>]> + Clone + AsMut<[Part<S>]>,
    V: AsRef<[S]> + AsMut<[S]>,
    C: AsRef<[Complex<S>]> + AsMut<[Complex<S>]>,
    K: ContactChain<S>,
{
    let tau = S::constant(1.3);
    let x = motion.harmonic(3);
    let values = [
        motion.amplitude(),
        motion.phase(),
        motion.displacement(tau),
        motion.velocity(tau),
        x.re,
        x.im,
    ];
    values.map(|value| value.to_f64().to_bits()).to_vec()
}

/// Returns the bits of the first hundred segments of a run.
fn segments<S: Float, P: AsMut<[Part<S>]> + AsRef<[Part<S>]>>(
    run: &mut Simulation<'_, S, P>,
) -> Vec<Segment<S>> {
    run.take(100).collect()
}

/// Emits a scene, and compares it with the run-time system of the same text.
macro_rules! same {
    ($test:ident, $scalar:ty, ($($points:tt)*), ($($state:tt)*), struct $name:ident { $($body:tt)* }) => {
        mod $test {
            frictiongen::friction_system! {
                pub struct $name { $($body)* provide: [limits, orbit, simulation], }
            }
        }

        #[test]
        fn $test() {
            let text = stringify!(struct $name { $($body)* provide: [limits, orbit, simulation], });
            let system: System<$scalar> = text.parse().expect("a scene");
            let masses = system.scene().masses.len();
            let (x, v) = ($($state)*);
            let (mut stops, mut orbits, mut values, mut seen) = (0, 0, 0, 0);
            let mut without = std::collections::BTreeMap::new();
            let mut count = |expected: &Result<Vec<u64>, NoOrbit>| match expected {
                Ok(bits) => (orbits, values) = (orbits + 1, values + bits.len()),
                Err(error) => *without.entry(error.to_string()).or_insert(0) += 1,
            };
            for (r, beta) in [$($points)*] {
                let emitted = $test::$name::at(r).expect("in the domain");
                let at = system.at(r).expect("in the domain");
                let found = emitted.orbit(beta).map(|orbit| said(&orbit, masses));
                let expected = at.orbit(beta).map(|orbit| said(&orbit, masses));
                stops += expected.as_ref().map_or(0, |bits| bits[0]);
                assert_eq!(found, expected, "r = {r}, β = {beta}");
                count(&expected);
                let found = emitted.orbit_from(beta, (&x, &v)).map(|orbit| said(&orbit, masses));
                let expected = at.orbit_from(beta, (&x, &v));
                let expected = expected.map(|orbit| said(&orbit, masses));
                assert_eq!(found, expected, "r = {r}, β = {beta} from a state");
                count(&expected);
                let mut found = $test::$name::simulation(r, beta).expect("in the domain");
                let mut expected = system.simulation(r, beta).expect("in the domain");
                let run: Vec<_> = expected.by_ref().take(100).collect();
                assert_eq!(segments(&mut found), run, "r = {r}, β = {beta}");
                seen += run.len();
                let mass = &system.scene().masses[masses - 1].name;
                assert_eq!(found.mass(masses - 1), expected.mass(mass).expect("a mass"));
                let found = $test::$name::simulation_from(r, beta, (&x, &v));
                let expected = system.simulation_from(r, beta, (&x, &v)).expect("in the domain");
                let run: Vec<_> = expected.take(100).collect();
                assert_eq!(segments(&mut found.expect("in the domain")), run);
                seen += run.len();
            }
            println!("{values} values of {orbits} orbits and {seen} segments compared, no orbit: {without:?}");
            let points = [$($points)*].len();
            assert_eq!(seen, points * 2 * 100);
            // One point of `plain` is on a resonance that friction does not bound. All other points have an orbit.
            let unbounded = if stringify!($test) == "plain" { 2 } else { 0 };
            assert_eq!(orbits, points * 2 - unbounded);
            // An orbit has seven numbers of its own, six numbers for each motion, and the multipliers.
            assert!(values > orbits * (7 + 6 * (1 + masses)), "{values}");
            assert!(stops > 0, "no orbit that stops");
            let none: NoOrbit = $test::$name::at(0.5).expect("in the domain").orbit(<$scalar>::NAN).expect_err("none");
            assert!(matches!(none, NoOrbit::OutOfDomain(_)));
        }
    };
}

same!(
    plain, f64, ((0.3, 0.4), (1.0 / 3.0, 0.01), (0.9, 0.3), (1.0, 0.5), (2.0, 1.5)), ([0.3], [-0.2]),
    struct Block {
        masses: { block: 1.0 },
        springs: { base - block: 1.0 },
        contact: block - wall,
        excitation: block,
    }
);
same!(
    single, f32, ((0.3, 0.05), (0.9, 0.55), (2.0, 2.5)), ([0.3], [-0.2]),
    struct Single {
        masses: { block: 2.0 },
        springs: { base - block: 3.0 },
        contact: block - base,
        excitation: base,
        damping: modal(0.03),
        stiction: 1.2,
        scalar: f32,
    }
);
same!(
    frame, f64, ((0.3, 0.4), (0.8, 0.5), (1.4, 0.2)), ([0.3, 0.1], [-0.2, 0.4]),
    struct Frame {
        masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
        contact: upper - wall,
        excitation: base,
        damping: modal[0.010, 0.012],
    }
);
same!(
    overdamped, f64, ((0.3, 0.4), (0.8, 0.5), (1.9, 0.1)), ([0.3, 0.1], [-0.2, 0.4]),
    struct Overdamped {
        masses: { a: 1.0, b: 1.0 },
        springs: { base - a: 1.0, a - b: 1.0 },
        contact: b - base,
        excitation: base,
        damping: rayleigh(0.3, 1.4),
    }
);
// This chain has a pair of equal modes, one of which the contact does not touch.
same!(
    mirrored, f64, ((0.3, 0.2), (0.8, 0.1), (1.9, 0.1)), ([0.3, 0.1, 0.0], [-0.2, 0.4, 0.0]),
    struct Mirrored {
        masses: { a: 1.0, b: 1.0, c: 1.0 },
        springs: { base - b: 1.0, a - b: 1.0, b - c: 1.0 },
        contact: b - wall,
        excitation: b,
        damping: modal(0.02),
    }
);
same!(
    five, f64, ((0.3, 0.4), (0.7, 0.3), (1.4, 0.05)), ([0.1; 5], [0.0; 5]),
    struct Five {
        masses: { a: 1.0, b: 1.2, c: 0.9, d: 1.1, e: 1.0 },
        springs: { base - a: 1.0, a - b: 1.3, b - c: 1.0, c - d: 0.8, d - e: 1.0 },
        contact: c - wall,
        excitation: a,
        damping: modal(0.01),
    }
);

/// Checks that a mass can be found by its name, and that a run is an iterator.
#[test]
fn by_name() {
    let orbit = frame::Frame::at(0.3).expect("in the domain").orbit(0.4);
    let orbit = orbit.expect("a steady state");
    assert_eq!((orbit.stops(), orbit.reversals()), (2, 0));
    assert_eq!(orbit.upper().amplitude(), orbit.contact().amplitude());
    assert_eq!(orbit.lower().amplitude(), orbit.mass(0).amplitude());
    let mut run = frame::Frame::simulation(0.3, 0.4).expect("in the domain");
    let mut count = 0;
    for segment in &mut run {
        assert!(segment.length >= 0.0);
        count += 1;
        if count == 1000 {
            break;
        }
    }
    println!("{count} segments looked at, none skipped");
    assert_eq!(count, 1000);
    // After a thousand segments the run has reached the orbit.
    let tau = run.phase() - orbit.origin();
    let apart = run.lower().displacement() - orbit.lower().displacement(tau);
    assert!(apart.abs() < 1e-9, "{apart:e}");
    let apart = run.upper().velocity() - orbit.upper().velocity(tau);
    assert!(apart.abs() < 1e-9, "{apart:e}");
}
