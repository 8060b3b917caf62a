//! Tests steady states that an implementation easily gets wrong.

use frictiongen::study::orbit::SystemOrbit;
use frictiongen::{NoOrbit, System};
use std::f64::consts::TAU;

fn block(excitation: &str, rest: &str) -> System {
    format!(
        "struct Block {{ masses: {{ block: 1 }}, springs: {{ base - block: 1 }},
        contact: block - wall, excitation: {excitation}, {rest} }}"
    )
    .parse()
    .expect("a scene")
}

fn orbit(system: &System, r: f64, beta: f64) -> SystemOrbit<'_> {
    let orbit = system.at(r).expect("in the domain").orbit(beta);
    orbit.unwrap_or_else(|error| panic!("r = {r}, β = {beta}: {error}"))
}

fn amplitude(orbit: &SystemOrbit<'_>) -> f64 {
    orbit.mass_at(0).expect("a mass").amplitude()
}

#[test]
fn six_reversals_without_a_stop() {
    let wall = block("block", "");
    let mut compared = 0;
    for (r, beta, largest) in [
        (1.0 / 3.0, 0.01, 0.983_595_621),
        (0.2, 0.005, 0.993_884_883),
    ] {
        let orbit = orbit(&wall, r, beta);
        assert_eq!((orbit.stops(), orbit.reversals()), (0, 6), "r = {r}");
        assert!((amplitude(&orbit) - largest).abs() < 1e-9, "r = {r}");
        assert_eq!(orbit.stuck_fraction(), 0.0);
        compared += 4;
    }
    println!("{compared} values compared, none skipped");
    assert_eq!(compared, 2 * 4);
    let orbit = orbit(&wall, 1.0 / 3.0, 0.05);
    assert_eq!((orbit.stops(), orbit.reversals()), (2, 2));
}

#[test]
fn steady_states_that_are_approached_slowly() {
    let wall = block("block", "");
    let mut compared = 0;
    for (r, beta, half) in [(0.325, 0.1, 0.999_957_840), (0.22, 0.05, 0.999_999_548_70)] {
        let orbit = orbit(&wall, r, beta);
        assert!(orbit.is_symmetric() && orbit.is_stable() && !orbit.is_marginal());
        let multipliers = orbit.multipliers().iter();
        let largest = multipliers.fold(0.0_f64, |most, value| most.max(value.norm()));
        // The reference prints at least nine digits.
        assert!((largest.sqrt() - half).abs() < 1e-9, "{}", largest.sqrt());
        compared += 1;
    }
    println!("{compared} multipliers compared, none skipped");
    assert_eq!(compared, 2);
}

/// Checks a member of a continuum of steady states. At r = 1/2 a free vibration has two cycles in each cycle of the
/// excitation. It loses no energy until it makes the contact stop.
#[test]
fn one_of_a_continuum() {
    let base = block("base", "");
    let orbit = orbit(&base, 0.5, 0.04);
    assert!(orbit.is_marginal() && orbit.is_stable() && !orbit.is_symmetric());
    assert_eq!((orbit.stops(), orbit.reversals()), (0, 2));
    // The motion from rest approaches the steady state ever more slowly: after n cycles the fraction of sticking is
    // of the order n^(−1/2).
    let mut run = base.simulation(0.5, 0.04).expect("in the domain");
    let (mut apart, mut compared) = ([0.0_f64; 2], 0);
    for (cycles, worst) in [200, 20_000].into_iter().zip(&mut apart) {
        while run.run().cycles() < cycles {
            run.advance(TAU).expect("a reach");
        }
        for _ in 0..8 {
            run.advance(TAU).expect("a reach");
            let found = run.mass("block").expect("a mass").displacement();
            let tau = run.run().phase() - orbit.origin();
            let steady = orbit.mass_at(0).expect("a mass").displacement(tau);
            *worst = worst.max((found - steady).abs());
            compared += 1;
        }
    }
    println!("{compared} displacements compared, none skipped");
    assert_eq!(compared, 2 * 8);
    let [early, late] = apart;
    assert!(early < 0.1 && late < 0.2 * early, "{apart:?}");
}

/// Checks that for β = 0.9 β_lim the orbit equals the closed form, and for β ≥ β*_lim the stuck response.
#[test]
fn the_closed_form_on_either_side() {
    let scenes = [
        block("block", "damping: modal(0.02)"),
        block("base", "stiction: 1.3, damping: modal(0.1)"),
        "struct Frame {
            masses: { lower: 3.27, upper: 3.25 },
            springs: { base - lower: 1190.0, lower - upper: 1323.0 },
            contact: upper - wall, excitation: base, damping: modal[0.010, 0.012], stiction: 1.2,
        }"
        .parse()
        .expect("a scene"),
        "struct Five {
            masses: { a: 1.0, b: 1.2, c: 0.9, d: 1.1, e: 1.0 },
            springs: { base - a: 1.0, a - b: 1.3, b - c: 1.0, c - d: 0.8, d - e: 1.0 },
            contact: b - d, excitation: e, damping: rayleigh(0.01, 0.02),
        }"
        .parse()
        .expect("a scene"),
    ];
    let (mut places, mut compared) = (0, 0);
    for (index, system) in scenes.iter().enumerate() {
        for r in [0.31, 0.57, 0.93, 1.4, 2.3] {
            let at = system.at(r).expect("in the domain");
            let what = format!("scene {index}, r = {r}");
            let masses = 0..system.scene().masses.len();
            let beta = at.continuous_limit() * 0.9;
            places += masses.len();
            let motion = at.motion(beta);
            let motion = motion.unwrap_or_else(|error| panic!("{what}: {error}"));
            let sliding = orbit(system, r, beta);
            assert_eq!((sliding.stops(), sliding.reversals()), (0, 2), "{what}");
            compared += 2;
            for mass in masses.clone() {
                let found = sliding.mass_at(mass).expect("a mass");
                let expected = motion.mass_at(mass).expect("a mass");
                let size = expected.amplitude();
                assert!((found.amplitude() - size).abs() < 1e-12 * size, "{what}");
                assert!((found.phase() - expected.phase()).abs() < 1e-9, "{what}");
                for tau in [0.0, 0.7, 2.1, 4.0] {
                    let apart = found.displacement(tau) - expected.displacement(tau);
                    assert!(apart.abs() < 1e-11 * size, "{what}: {apart:e}");
                    let apart = found.velocity(tau) - expected.velocity(tau);
                    assert!(apart.abs() < 1e-10 * size, "{what}: {apart:e}");
                }
                for n in [1, 2, 3, 5] {
                    let apart = (found.harmonic(n) - expected.harmonic(n)).norm();
                    assert!(apart < 1e-11 * size, "{what}: {apart:e}");
                }
                compared += 2 + 4 * 2 + 4;
            }
            let stuck = at.stuck().expect("a response");
            // The start is the exact stuck motion Re(A e^{iτ}) and its derivative, at a maximum of the excitation.
            let state = masses
                .clone()
                .map(|mass| stuck.mass_at(mass).expect("a mass"));
            let (x, v): (Vec<f64>, Vec<f64>) = state.map(|a| (a.re, -a.im)).unzip();
            for beta in [at.sliding_limit(), at.sliding_limit() * 1.5] {
                let orbit = at.orbit_from(beta, (&x[..], &v[..])).expect("it sticks");
                assert_eq!((orbit.stops(), orbit.reversals()), (0, 0), "{what}");
                assert_eq!(orbit.stuck_fraction(), 1.0, "{what}");
                compared += 3;
                for mass in masses.clone() {
                    let expected = stuck.mass_at(mass).expect("a mass");
                    let found = orbit.mass_at(mass).expect("a mass");
                    let apart = (found.harmonic(1) - expected).norm();
                    assert!(apart < 1e-12 * (1.0 + expected.norm()), "{what}: {apart:e}");
                    let apart = found.amplitude() - expected.norm();
                    assert!(apart.abs() < 1e-12 * (1.0 + expected.norm()), "{what}");
                    compared += 2;
                }
            }
        }
    }
    println!("{compared} values compared, none skipped");
    // The scenes have one, one, two and five masses, and five frequency ratios in all.
    assert_eq!(places, 5 * 9);
    assert_eq!(compared, 20 * (2 + 2 * 3) + places * (14 + 2 * 2));
}

/// Checks that a contact does not move if β is below β*_lim by rounding only. At β = β*_lim exactly, the limit
/// decides.
#[test]
fn at_the_sliding_limit() {
    let base = block("base", "");
    let mut compared = 0;
    for r in [0.1, 0.3, 0.7, 1.3, 2.0] {
        let at = base.at(r).expect("in the domain");
        let orbit = at.orbit(at.sliding_limit()).expect("stuck");
        assert_eq!(orbit.stuck_fraction(), 1.0);
        assert_eq!(amplitude(&orbit), 0.0);
        let below = at.sliding_limit() * (1.0 - 1e-9);
        let orbit = at.orbit(below).expect("hardly sliding");
        assert!(amplitude(&orbit) < 1e-8, "r = {r}");
        compared += 3;
    }
    println!("{compared} values compared, none skipped");
    assert_eq!(compared, 5 * 3);
}

/// Checks the amplitude of a contact that hardly slides. At β = 1 − ε the force near its peak exceeds friction by ε −
/// τ²/2. The mass slips from τ = −√(2ε) to 2√(2ε), by 9ε²/2r².
#[test]
fn hardly_sliding() {
    let wall = block("block", "");
    let mut compared = 0;
    for index in 0..200 {
        let r = 0.3 + 0.0123456 * f64::from(index);
        let at = wall.at(r).expect("in the domain");
        for below in [1e-3, 1e-4, 1e-5] {
            let orbit = at.orbit(1.0 - below).expect("hardly sliding");
            let expected = 2.25 * below * below / (r * r);
            let apart = (amplitude(&orbit) - expected).abs();
            // The formula neglects terms of the relative size ε = 1 − β. The answer may also be wrong by 64 roundings
            // of P/k₁.
            let left_out = 4.0 * below * (1.0 + 1.0 / (r * r)) * expected;
            let allowed = left_out + 64.0 * f64::EPSILON;
            assert!(
                apart < allowed,
                "r = {r}, {below:e}: {apart:e} of {allowed:e}"
            );
            assert_eq!(orbit.stops(), 2);
            compared += 1;
        }
    }
    println!("{compared} values compared, none skipped");
    assert_eq!(compared, 200 * 3);
}

/// Checks states on the resonance for β between β*_lim and β_n, the friction ratio from which the motion is bounded.
/// At these β friction does not bound a sliding motion. A contact that is at rest on the base stays at rest.
#[test]
fn stuck_on_a_resonance() {
    let base = block("base", "stiction: 1.5");
    let mut scene = base.scene().clone();
    scene.contact.to = frictiongen::study::scene::Node::Base;
    let moving = System::<f64>::try_from(scene).expect("a scene");
    let at = moving.at(1.0).expect("in the domain");
    let orbit = at.orbit_from(0.7, (&[1.0], &[0.0])).expect("it sticks");
    assert_eq!((orbit.stuck_fraction(), orbit.offset()), (1.0, 0.0));
    assert!((amplitude(&orbit) - 1.0).abs() < 1e-15);
    // A mass at absolute rest starts while the base is at Y. The spring breaks the contact away, and the sliding
    // motion grows.
    let rest = at.orbit(0.7);
    assert_eq!(rest.map(|orbit| orbit.stops()), Err(NoOrbit::Unbounded));
    // With enough friction the contact stays where it starts, with an offset of Y. Without an initial state, the mass
    // moves about the middle.
    let rest = at.orbit_from(1.4, (&[0.0], &[0.0]));
    for (orbit, moved) in [(at.orbit(1.4), 1.0), (rest, 2.0)] {
        let orbit = orbit.expect("it sticks");
        assert_eq!((orbit.stuck_fraction(), orbit.offset()), (1.0, -1.0));
        assert!((amplitude(&orbit) - moved).abs() < 1e-15);
    }
    let torn = at.orbit_from(0.7, (&[5.0], &[5.0]));
    assert_eq!(torn.map(|orbit| orbit.stops()), Err(NoOrbit::Unbounded));
}

#[test]
fn where_there_is_none() {
    let wall = block("block", "");
    let error = |system: &System, r: f64, beta: f64| {
        let at = system.at(r).expect("in the domain");
        at.orbit(beta).map(|orbit| orbit.stops()).expect_err("none")
    };
    assert_eq!(error(&wall, 1.0, 0.5), NoOrbit::Unbounded);
    assert!(matches!(error(&wall, 0.0, 0.5), NoOrbit::OutOfDomain(_)));
    assert!(matches!(
        error(&wall, 0.5, f64::NAN),
        NoOrbit::OutOfDomain(_)
    ));
    // This pair of masses is symmetric, and the load drives a mode that the contact does not touch.
    let pair: System = "struct Pair {
        masses: { left: 1, right: 1 },
        springs: { base - left: 1, left - right: 1, right - wall: 1 },
        contact: left - right, excitation: left,
    }"
    .parse()
    .expect("a scene");
    assert_eq!(error(&pair, 0.6, 0.1), NoOrbit::Undamped(0));
}

/// Checks a chain with two equal modes, in a basis where the contact drives only one of the two modes. The difference
/// of the masses' displacements moves as one oscillator under 5/4 of the friction.
#[test]
fn equal_modes_are_turned() {
    let alike: System = "struct Alike {
        masses: { a: 1, b: 4 },
        springs: { base - a: 1, base - b: 4 },
        contact: a - b,
        excitation: a,
        damping: modal(0.05),
    }"
    .parse()
    .expect("a scene");
    let single = block("block", "damping: modal(0.05)");
    let (mut compared, mut stops, mut worst) = (0, 0, 0.0_f64);
    for r in [0.3, 0.55, 0.8, 1.1, 1.7] {
        for beta in [0.1, 0.3, 0.5, 0.7] {
            let (both, one) = (orbit(&alike, r, beta), orbit(&single, r, 1.25 * beta));
            assert_eq!(
                (both.stops(), both.reversals()),
                (one.stops(), one.reversals()),
                "r = {r}, β = {beta}"
            );
            stops += both.stops();
            let apart = both.contact().amplitude() - amplitude(&one);
            worst = worst.max(apart.abs());
            worst = worst.max((both.stuck_fraction() - one.stuck_fraction()).abs());
            compared += 2;
        }
    }
    println!("{compared} values compared, worst {worst:.1e}, {stops} stops");
    assert!(worst < 1e-12 && stops > 10);
    assert_eq!(compared, 5 * 4 * 2);
}
