//! The friction force from recordings, for the figures of chapter 4.

use crate::made::{How, NATURAL, Noise, RATE, Y, motions, recording, rig};
use frictiongen::measure::{
    Datum, Identified, IdentifyRequest, Measured, Observation, Unknown, Using, Verdict,
};
use frictiongen::study::{sensitivity::Quantity, units::Load};
use frictiongen::{Of, Regime, System};

/// Returns the observation at r and β, without noise but with a stated deviation.
pub fn seen(system: &System, r: f64, beta: f64, masses: &[usize], deviation: f64) -> Observation {
    let at = system.at(r).unwrap();
    let response = at.response(beta).unwrap();
    let motions = masses.iter().map(|mass| Datum {
        mass: *mass,
        harmonic: 1,
        value: response.harmonic(Of::Mass(*mass), 1).unwrap(),
        deviation,
    });
    Observation {
        hertz: system.hertz(r),
        load: Load::Base(Y),
        load_deviation: 0.0,
        motions: motions.collect(),
    }
}

/// Returns k₁Y, the load that belongs to β = 1.
pub fn scale(system: &System) -> f64 {
    system.scene().springs[0].stiffness * Y
}

fn identified(system: &System, seen: Observation, using: Using) -> Identified {
    let request = IdentifyRequest {
        using,
        ..IdentifyRequest::default()
    };
    system.identify(&[seen], &request).unwrap()
}

/// Friction ratios 0.2, 0.4 and 0.6 are identified over r = 0.5 to 2.5 from 60 s at 2 kHz and 40 dB. Wherever the
/// verdict is `Determined`, β is within 2 %.
#[test]
fn within_two_per_cent_over_the_range_of_chapter_4() {
    let system = rig("");
    let mut noise = Noise::new(2);
    let (mut told, mut stops, mut worst) = (0, 0, 0.0_f64);
    for beta in [0.2, 0.4, 0.6] {
        for r in [0.5, 0.62, 0.75, 0.9, 0.97, 1.05, 1.25, 1.6, 2.0, 2.5] {
            let how = How {
                hertz: r * NATURAL,
                beta,
                rate: RATE,
                seconds: 60.0,
                skip: 200.0,
            };
            let recording = recording(&system, &motions(&system, how), RATE, 100.0, &mut noise);
            let measured = Measured::of(&recording, system.scene()).unwrap();
            let seen = Observation::of(&measured, &system, 1);
            for using in [Using::Complex, Using::Phase] {
                let found = identified(&system, seen.clone(), using);
                // At r = 1/2 the steady state is one of a continuum. From rest, the model reaches the steady state of
                // the measurement.
                assert_eq!(
                    found.verdict,
                    Verdict::Determined,
                    "β = {beta}, r = {r}, {using:?}: {:?}",
                    found.levels
                );
                let error = found.friction.value / scale(&system) / beta - 1.0;
                assert!(
                    error.abs() < 0.02,
                    "β = {beta}, r = {r}, {using:?}: {error}"
                );
                worst = worst.max(error.abs());
                told += 1;
                stops += usize::from(found.explained[0].regime == Regime::StickSlip);
            }
        }
    }
    assert_eq!(told, 60);
    assert!(stops > 4, "{stops}");
    println!("{told} told, {stops} of them with stops, worst error {worst:.2e}");
}

/// The fundamental gives β directly while the contact slides: |X₁ − V| = 4β|H|/π. The test uses a mass away from the
/// contact.
#[test]
fn from_a_mass_away_from_the_contact() {
    let frame: System = "struct Frame {
        masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
        contact: lower - wall,
        excitation: base,
        damping: modal[0.010, 0.012],
    }"
    .parse()
    .unwrap();
    let observation = seen(&frame, 1.25, 0.3, &[1], 1e-4);
    let found = identified(&frame, observation.clone(), Using::Complex);
    assert!((found.friction.value / scale(&frame) - 0.3).abs() < 1e-6);
    let at = frame.at(1.25).unwrap();
    let harmonic = |beta: f64| at.response(beta).unwrap().harmonic(Of::Mass(1), 1).unwrap();
    let (still, known) = (harmonic(0.0), harmonic(0.1));
    let direct = 0.1 * (observation.motions[0].value - still).norm() / (known - still).norm();
    assert!((direct - 0.3).abs() < 1e-12, "{direct}");
}

/// At r = √2 the fundamental of m₂ is the same for every friction (thesis 6.4.3), and the verdict reports it.
#[test]
fn at_an_invariant_point_it_says_so() {
    let pair: System = "struct Pair {
        masses: { m1: 1, m2: 1 }, springs: { base - m1: 1, m1 - m2: 1 },
        contact: m2 - wall, excitation: m1,
    }"
    .parse()
    .unwrap();
    let at = |r: f64, mass: usize| {
        let response = pair.at(r).unwrap();
        let value = response
            .response(0.3)
            .unwrap()
            .harmonic(Of::Mass(mass), 1)
            .unwrap();
        let datum = Datum {
            mass,
            harmonic: 1,
            value,
            deviation: 1e-4,
        };
        let seen = Observation {
            hertz: pair.hertz(r),
            load: Load::Force(1.0),
            load_deviation: 0.0,
            motions: vec![datum],
        };
        // Below the largest threshold of a resonance the contact slides at this resonance. An undamped scene with more
        // friction would take too long.
        let request = IdentifyRequest {
            range: Some((0.0, 1.2)),
            ..IdentifyRequest::default()
        };
        pair.identify(&[seen], &request).unwrap()
    };
    let invariant = at(2.0_f64.sqrt(), 1);
    assert_eq!(
        invariant.verdict,
        Verdict::NotDetermined,
        "{:?}",
        invariant.levels
    );
    assert!(invariant.friction.holds(0.3));
    // The motion of m₁ determines the friction.
    let other = at(2.0_f64.sqrt(), 0);
    assert_eq!(other.verdict, Verdict::Determined);
    assert!((other.friction.value - 0.3).abs() < 1e-3);
}

/// Between r = 0.334 and 0.605 the fundamental first grows with friction and then falls (figure 4.8), so one amplitude
/// belongs to two forces.
#[test]
fn two_levels_of_friction_with_one_amplitude() {
    let system = rig("");
    let observation = seen(&system, 0.5, 0.2, &[0], 1e-4);
    let amplitude = identified(&system, observation.clone(), Using::Amplitude);
    assert_eq!(
        amplitude.verdict,
        Verdict::SeveralLevels,
        "{:?}",
        amplitude.levels
    );
    let betas: Vec<f64> = amplitude
        .levels
        .iter()
        .map(|level| level.value / scale(&system))
        .collect();
    assert!(
        betas.iter().any(|beta| (beta - 0.2).abs() < 1e-3),
        "{betas:?}"
    );
    let at = system.at(0.5).unwrap();
    for beta in betas {
        let size = at
            .response(beta)
            .unwrap()
            .harmonic(Of::Mass(0), 1)
            .unwrap()
            .norm();
        assert!((size - observation.motions[0].value.norm()).abs() < 1e-3);
    }
    let both = identified(&system, observation, Using::Complex);
    assert_eq!(both.verdict, Verdict::Determined);
}

#[test]
fn a_stuck_contact_tells_the_least_force() {
    let system = rig("damping: modal(0.01),");
    let found = identified(&system, seen(&system, 0.8, 1.4, &[0], 1e-3), Using::Complex);
    assert_eq!(found.verdict, Verdict::Stuck);
    let beta = found.friction.from / scale(&system);
    // The contact sticks from β = 1 on. Just below, the motion is smaller than the noise and looks the same.
    assert!(
        found.friction.to.is_infinite() && (0.97..=1.0).contains(&beta),
        "{beta}"
    );
}

/// Four frequencies determine F, ζ and the natural frequency together.
#[test]
fn with_damping_and_frequency() {
    let truth = rig("damping: modal(0.015),");
    let guess = rig("damping: modal(0.003),");
    // The frequency of the guess is 1 % too high.
    let mut scene = guess.scene().clone();
    scene.springs[0].stiffness *= 1.02;
    let guess = System::try_from(scene).unwrap();
    let observations: Vec<Observation> = [0.7, 0.92, 1.1, 1.7]
        .iter()
        .map(|r| seen(&truth, *r, 0.3, &[0], 1e-4))
        .collect();
    let request = IdentifyRequest {
        unknowns: vec![Unknown::Damping, Unknown::Quantity(Quantity::Stiffness(0))],
        ..IdentifyRequest::default()
    };
    let found = guess.identify(&observations, &request).unwrap();
    assert!(
        (found.friction.value / (0.3 * scale(&truth)) - 1.0).abs() < 1e-6,
        "{found:?}"
    );
    assert!((found.unknowns[0].1.value - 0.015).abs() < 1e-7);
    let stiffness = truth.scene().springs[0].stiffness;
    assert!((found.unknowns[1].1.value / stiffness - 1.0).abs() < 1e-7);
    // The unknown of this test is a factor on the frequencies.
    let request = IdentifyRequest {
        unknowns: vec![Unknown::Damping, Unknown::Frequencies],
        ..IdentifyRequest::default()
    };
    let found = guess.identify(&observations, &request).unwrap();
    assert!(
        (found.unknowns[1].1.value - 1.02_f64.sqrt().recip()).abs() < 1e-7,
        "{found:?}"
    );
    assert!((found.friction.value / (0.3 * scale(&truth)) - 1.0).abs() < 1e-6);
}

/// μ can be identified where the contact stops. Where the contact only slides, the verdict reports that it cannot.
#[test]
fn stiction_where_it_shows() {
    let truth = rig("stiction: 1.3, damping: modal(0.01),");
    let guess = rig("stiction: 1.1, damping: modal(0.01),");
    let request = IdentifyRequest {
        unknowns: vec![Unknown::Stiction],
        ..IdentifyRequest::default()
    };
    let stops: Vec<Observation> = [0.3, 0.42]
        .iter()
        .map(|r| seen(&truth, *r, 0.5, &[0], 1e-5))
        .collect();
    let found = guess.identify(&stops, &request).unwrap();
    assert!(
        found
            .explained
            .iter()
            .all(|point| point.regime == Regime::StickSlip)
    );
    assert!(
        (found.unknowns[0].1.value - 1.3).abs() < 1e-3,
        "{:?}",
        found.unknowns
    );
    assert!((found.friction.value / (0.5 * scale(&truth)) - 1.0).abs() < 1e-3);
    let slides = [seen(&truth, 1.3, 0.3, &[0], 1e-5)];
    let found = guess.identify(&slides, &request).unwrap();
    assert!(found.unknowns[0].1.to.is_infinite(), "{:?}", found.unknowns);
}

/// Two amplitudes at resonance determine friction and damping (Liang and Feeny 2004): 2ζk|X| + 4F/π = kY for small ζ.
#[test]
fn two_amplitudes_at_resonance() {
    let truth = rig("damping: modal(0.02),");
    let stiffness = truth.scene().springs[0].stiffness;
    let friction = 0.3 * stiffness * Y;
    let at = |load: f64| {
        let beta = friction / (stiffness * load);
        let response = truth.at(1.0).unwrap().response(beta).unwrap();
        let value = response.harmonic(Of::Mass(0), 1).unwrap();
        Observation {
            hertz: truth.hertz(1.0),
            load: Load::Base(load),
            load_deviation: 0.0,
            motions: vec![Datum {
                mass: 0,
                harmonic: 1,
                value,
                deviation: 1e-4,
            }],
        }
    };
    let seen = [at(Y), at(2.0 * Y)];
    let request = IdentifyRequest {
        using: Using::Amplitude,
        unknowns: vec![Unknown::Damping],
        ..IdentifyRequest::default()
    };
    let found = rig("damping: modal(0.05),")
        .identify(&seen, &request)
        .unwrap();
    assert!(
        (found.friction.value / friction - 1.0).abs() < 1e-5,
        "{:?}",
        found.friction
    );
    assert!((found.unknowns[0].1.value - 0.02).abs() < 1e-6);
    // The method of the literature has two equations, each linear in one unknown.
    let [x, wide] = [0, 1].map(|place| seen[place].motions[0].value.norm() * [Y, 2.0 * Y][place]);
    let damping = Y / (2.0 * (wide - x));
    let simple = std::f64::consts::FRAC_PI_4 * stiffness * (Y - 2.0 * damping * x);
    assert!(
        (simple / friction - 1.0).abs() < 0.01 && (damping / 0.02 - 1.0).abs() < 0.01,
        "{simple}, {damping}"
    );
}

/// Where a stop is about to appear or disappear, no derivative exists. The fit then counts its differences, and finds
/// the same numbers.
#[test]
fn differences_are_counted() {
    let system: System = "struct Plate { masses: { plate: 2.0 }, springs: { base - plate: 752.0 },
        contact: plate - wall, excitation: base, damping: modal(0.02), stiction: 1.3 }"
        .parse()
        .unwrap();
    let mut counts = [0.8, 1.5].into_iter().zip([0.4, 0.6]).map(|(hertz, beta)| {
        let mut seen = seen(
            &system,
            system.frequency_ratio_at_hertz(hertz),
            beta,
            &[0],
            1e-3,
        );
        let response = system.at(system.frequency_ratio_at_hertz(hertz)).unwrap();
        let response = response.response(beta).unwrap();
        seen.motions.push(Datum {
            mass: 0,
            harmonic: 3,
            value: response.harmonic(Of::Mass(0), 3).unwrap(),
            deviation: 1e-3,
        });
        let request = IdentifyRequest {
            unknowns: vec![Unknown::Stiction],
            ..IdentifyRequest::default()
        };
        let found = system.identify(&[seen], &request).unwrap();
        assert!((found.friction.value - beta * scale(&system)).abs() < 1e-9);
        assert!((found.unknowns[0].1.value - 1.3).abs() < 1e-6);
        found.differences
    });
    assert_eq!(counts.next(), Some(0));
    assert!(counts.next().is_some_and(|count| 0 < count));
}
