//! Tests of two quantities that limit the steps of a search for events: the derivatives of an oscillator's motion, and
//! the bound on the third derivative.

use super::*;
use crate::motion::series::OscillatorSum;
use fuzzing::Random;

fn part(zeta: f64, x: f64) -> Part<f64> {
    let mut part = Part::empty();
    part.kind = if zeta == 0.0 {
        Kind::Undamped
    } else if zeta < 1.0 {
        Kind::Light
    } else if zeta == 1.0 {
        Kind::Critical
    } else {
        Kind::Over
    };
    (part.x, part.zeta) = (x, zeta);
    part.q2 = (1.0 - zeta) * (1.0 + zeta);
    part.q = if zeta == 1.0 {
        1.0
    } else {
        part.q2.abs().sqrt()
    };
    part
}

#[test]
fn third_derivatives_stay_within_their_bound() {
    let mut random = Random(29);
    let mut compared = 0;
    for zeta in [
        0.0, 1e-3, 0.3, 0.96, 0.98, 0.999, 1.0, 1.001, 1.5, 4.0, 30.0,
    ] {
        let mut most = 0.0_f64;
        for _ in 0..400 {
            let mut part = part(zeta, random.log_uniform(0.05, 20.0));
            let size = random.log_uniform(1e-3, 1e3);
            part.free = [random.signed(), random.signed()].map(|part| size * part);
            part.weight = [random.signed(), random.signed()];
            part.aim();
            let [a, b] = part.derived(part.derived(part.slope));
            for k in 0..40 {
                let tau = 0.15 * f64::from(k) / part.x;
                let turn = part.turn(tau / core::f64::consts::PI, tau);
                let share = (a * turn.c + b * turn.s).abs() / (part.bound * turn.decay_factor);
                assert!(
                    share <= 1.0 + 1e-9,
                    "ζ {zeta}, x {}, τ {tau}: {share}",
                    part.x
                );
                most = most.max(share);
                compared += 1;
            }
        }
        println!("ζ {zeta}: {most} of the bound");
        // A loose bound would be correct, but would make searches slow. The test therefore also requires that the bound
        // is tight.
        assert!(most > 0.3, "ζ {zeta}: {most}");
    }
    println!("{compared} derivatives compared, none skipped");
    assert_eq!(compared, 11 * 400 * 40);
}

/// Compares slope and curvature of the function that a search examines with finite differences. Some frequencies of the
/// test are near a resonance, where the forced motion grows from zero.
#[test]
fn slope_and_curve_are_derivatives() {
    // The error of a central difference with step h is h² times a derivative, plus ε/h from rounding with the unit ε.
    const STEP: f64 = 1e-5;
    let mut random = Random(31);
    let (mut compared, mut beside) = (0, 0);
    for case in 0..300 {
        let zeta = [0.0, 1e-3, 5e-3, 0.2][case % 4];
        let mut part = part(zeta, 1.0);
        part.sigma = 1.3;
        let r = if case % 3 == 0 {
            1.3 * random.log_uniform(0.5, 2.0)
        } else {
            1.3 * (1.0 + 5e-3 * random.signed())
        };
        let direct = Complex::new(random.signed(), random.signed());
        part.tuned(
            r,
            Complex::new(random.signed(), random.signed()),
            1.0,
            direct,
        );
        beside += usize::from(part.near);
        (part.y, part.u) = (random.signed(), random.signed());
        part.weight = [random.signed(), random.signed()];
        let phase = random.signed().sin_cos();
        part.start(phase);
        part.aim();
        let parts = [part];
        let sum = OscillatorSum::new(&parts, 0.3, (random.signed(), random.signed()), phase, 6.0);
        for _ in 0..10 {
            let tau = 0.1 + 5.0 * random.unit();
            let (local, before, after) =
                (sum.local(tau), sum.local(tau - STEP), sum.local(tau + STEP));
            for (name, found, by) in [
                ("slope", local.slope, after.value - before.value),
                ("curve", local.curve, after.slope - before.slope),
            ] {
                let want = by / (2.0 * STEP);
                assert!(
                    (found - want).abs() < 1e-8 * (1.0 + local.bound),
                    "{name}, ζ {zeta}, r {r}, τ {tau}: {found} instead of {want}"
                );
                compared += 1;
            }
        }
    }
    println!(
        "{compared} derivatives compared, none skipped; beside a resonance {beside} of 300 parts"
    );
    assert!(compared == 6000 && beside > 100);
}

/// Compares the Taylor series of the response at the start of a segment with its closed form. Near a resonance the
/// response to the load grows from 0.
#[test]
fn the_series_of_what_grows() {
    let mut random = Random(31);
    let mut compared = 0;
    for zeta in [0.0, 1e-9, 1e-6] {
        for apart in [0.0, 1e-9, -1e-6] {
            let mut part = part(zeta, 1.0 + apart);
            part.near = true;
            part.steady = Complex::new(random.signed(), random.signed());
            part.weight = [random.signed(), random.signed()];
            let (sine, cosine) = random.signed().sin_cos();
            let mut terms = [0.0; 12];
            part.grown_series((sine, cosine), &mut terms);
            for tau in [0.01, 0.05, 0.2] {
                let weights = terms.iter().enumerate().rev();
                let sum = weights.fold(0.0, |sum, (order, term)| {
                    term + sum * tau / (order as f64 + 1.0)
                });
                let [value, slope, ..] = part.grown(tau / core::f64::consts::PI, (sine, cosine));
                let expected = part.weight[0] * value + part.weight[1] * slope / part.x;
                // The neglected terms of the series are of the order τ¹²/12!. The closed form loses digits, because it
                // divides by the distance from its pole.
                assert!(
                    (sum - expected).abs() <= 1e-12 * tau,
                    "ζ {zeta}, {apart} from the pole, τ {tau}: {sum} for {expected}"
                );
                compared += 1;
            }
        }
    }
    println!("{compared} values compared, none skipped");
}
