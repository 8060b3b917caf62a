//! Coverage of confidence intervals: intervals of 95 % must contain the truth in 95 % of the repeats, up to three
//! standard deviations of this count. For 1000 repeats the accepted counts are 93 to 97 %.

use crate::force::{scale, seen};
use crate::made::{How, NATURAL, Noise, Y, motions, recording, rig};
use frictiongen::measure::{Estimate, IdentifyRequest, Measured, Observation, Unknown, Using};
use frictiongen::{Regime, System};

const REPEATS: usize = 1000;
/// Number of repeats in every run of the tests.
const FEW: usize = 300;

/// Asserts the share of intervals that contain the truth.
pub fn hold(what: &str, truth: f64, estimates: &[Estimate]) {
    assert!(FEW <= estimates.len(), "{what}");
    let count = estimates
        .iter()
        .filter(|estimate| estimate.holds(truth))
        .count();
    let repeats = estimates.len() as f64;
    let share = count as f64 / repeats;
    println!("{what}: {:.1} %", 100.0 * share);
    // Rounded to the next whole repeat, because a count is one.
    let off = 3.0 * (0.95 * 0.05 / repeats).sqrt() + 0.5 / repeats;
    assert!((share - 0.95).abs() < off, "{what}: {share}");
}

/// Returns a copy of the observations with new noise.
fn noisy(clean: &[Observation], noise: &mut Noise) -> Vec<Observation> {
    let mut all = clean.to_vec();
    for datum in all.iter_mut().flat_map(|seen| &mut seen.motions) {
        datum.value.re += datum.deviation * noise.next();
        datum.value.im += datum.deviation * noise.next();
    }
    all
}

/// Intervals from recordings with noise in both channels, 8 s at 500 Hz and 40 dB.
#[test]
fn from_recordings() {
    recordings(FEW);
}

/// Run with the command of `with_stops`.
#[test]
#[ignore = "half a minute without optimisation"]
fn from_many_recordings() {
    recordings(REPEATS);
}

fn recordings(repeats: usize) {
    let system = rig("");
    for (r, beta, using) in [
        (1.25, 0.4, Using::Complex),
        (1.25, 0.4, Using::Phase),
        (0.8, 0.2, Using::Amplitude),
    ] {
        let how = How {
            hertz: r * NATURAL,
            beta,
            rate: 500.0,
            seconds: 8.0,
            skip: 300.0,
        };
        let clean = motions(&system, how);
        let request = IdentifyRequest {
            using,
            ..IdentifyRequest::default()
        };
        let estimates: Vec<Estimate> = (0..repeats)
            .map(|seed| {
                let mut noise = Noise::new(seed as u64);
                let recording = recording(&system, &clean, 500.0, 100.0, &mut noise);
                let measured = Measured::of(&recording, system.scene()).unwrap();
                let seen = Observation::of(&measured, &system, 1);
                system.identify(&[seen], &request).unwrap().friction
            })
            .collect();
        hold(
            &format!("r = {r}, β = {beta}, {using:?}"),
            beta * system.scene().springs[0].stiffness * Y,
            &estimates,
        );
    }
}

/// Intervals from several frequencies and both masses together. The scatter of the residuals then also enters the
/// interval.
#[test]
fn from_several_frequencies() {
    several_frequencies(FEW);
}

/// Run with the command of `with_stops`.
#[test]
#[ignore = "a quarter of a minute without optimisation"]
fn from_several_frequencies_often() {
    several_frequencies(REPEATS);
}

fn several_frequencies(repeats: usize) {
    let frame: System = "struct Frame {
        masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
        contact: lower - wall, excitation: base, damping: modal(0.01),
    }"
    .parse()
    .unwrap();
    let clean: Vec<Observation> = [1.2, 1.4, 2.0]
        .iter()
        .map(|r| seen(&frame, *r, 0.3, &[0, 1], 3e-3))
        .collect();
    let mut noise = Noise::new(77);
    let estimates: Vec<Estimate> = (0..repeats)
        .map(|_| {
            frame
                .identify(&noisy(&clean, &mut noise), &IdentifyRequest::default())
                .unwrap()
                .friction
        })
        .collect();
    // The fit widens the interval where the residuals are larger than chance, and never narrows it. Its coverage is
    // therefore too large rather than too small.
    hold(
        "three frequencies, two masses",
        0.3 * scale(&frame),
        &estimates,
    );
}

/// Run with `cargo test --release -p frictiongen --features measure --test measure intervals -- --ignored --nocapture`.
#[test]
#[ignore = "minutes without optimisation"]
fn with_stops() {
    let system = rig("");
    let clean = [seen(&system, 0.42, 0.5, &[0], 1e-3)];
    for using in [Using::Complex, Using::Phase] {
        let mut noise = Noise::new(5);
        let request = IdentifyRequest {
            using,
            range: Some((0.0, scale(&system))),
            ..IdentifyRequest::default()
        };
        let estimates: Vec<Estimate> = (0..REPEATS)
            .map(|_| {
                let found = system
                    .identify(&noisy(&clean, &mut noise), &request)
                    .unwrap();
                assert_eq!(found.explained[0].regime, Regime::StickSlip);
                found.friction
            })
            .collect();
        hold(
            &format!("with stops, {using:?}"),
            0.5 * scale(&system),
            &estimates,
        );
    }
}

/// Run with the command of `with_stops`.
#[test]
#[ignore = "minutes without optimisation"]
fn of_damping_and_frequency() {
    let truth = rig("damping: modal(0.015),");
    let clean: Vec<Observation> = [0.7, 0.92, 1.1, 1.7]
        .iter()
        .map(|r| seen(&truth, *r, 0.3, &[0], 2e-3))
        .collect();
    let request = IdentifyRequest {
        unknowns: vec![Unknown::Damping, Unknown::Frequencies],
        ..IdentifyRequest::default()
    };
    let mut noise = Noise::new(6);
    let (mut friction, mut damping, mut factor) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..REPEATS {
        let found = truth
            .identify(&noisy(&clean, &mut noise), &request)
            .unwrap();
        friction.push(found.friction);
        damping.push(found.unknowns[0].1);
        factor.push(found.unknowns[1].1);
    }
    hold("friction beside ζ and ω", 0.3 * scale(&truth), &friction);
    hold("ζ", 0.015, &damping);
    hold("ω", 1.0, &factor);
}
