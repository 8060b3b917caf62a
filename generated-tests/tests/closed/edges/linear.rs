//! Tests that at β = 0 the motion is the plain linear response.
//!
//! The reference is the sum of modal receptances x̄_k = Σ φ_k φᵀp/(λ − r² + 2iζr√λ), which the test computes
//! independently in complex double-double numbers. For the contact the reference is wᵀx̄ − s.

use crate::edges::scenes::{Rounded, SCENES, ratios, system};
use frictiongen::study::System;
use frictiongen_kernel::Scalar;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_model::modal::Modal;

/// Tolerance, in rounding units of each term of the sum of receptances and of the frequency ratio in the term.
const BAR: f64 = 8.0;

/// A sum of receptances, with its sensitivity to relative changes of each term, of each √λ and of r.
struct Response {
    re: Dd,
    im: Dd,
    condition: f64,
    /// Sensitivity to r of the receptance that is most sensitive. If it exceeds 1/ε, r is within a rounding unit of a
    /// pole.
    steepest: f64,
}

/// Returns the response to the load along `direction`, which maps the index of a mode to the component of its mode
/// shape in this direction.
fn response(modal: &Modal, r: Dd, direction: impl Fn(usize) -> Dd, relative: bool) -> Response {
    let zero = Dd::ZERO;
    let mut sum = Response {
        re: zero,
        im: zero,
        condition: 0.0,
        steepest: 0.0,
    };
    let mut add = |re: Dd, im: Dd, condition: f64| {
        sum.re = sum.re + re;
        sum.im = sum.im + im;
        sum.condition += condition * (re.abs() + im.abs()).to_f64();
        if !(re.is_zero() && im.is_zero()) {
            sum.steepest = sum.steepest.max(condition);
        }
    };
    for mode in 0..modal.resonances.len() {
        let root = modal.resonances[mode];
        let zeta = modal.damping_ratios[mode];
        let (a, b) = ((root - r) * (root + r), (zeta + zeta) * r * root);
        let square = a * a + b * b;
        // For the motion relative to a moving base, v − 1 replaces v: v − 1 = (r² − 2iζr√λ)/(λ − r² + 2iζr√λ).
        let (re, im) = if relative {
            let (c, d) = (r * r, -b);
            ((c * a + d * b) / square, (d * a - c * b) / square)
        } else {
            (a / square, -b / square)
        };
        let mut weight = direction(mode) * modal.loads[mode];
        if relative {
            weight = weight / (root * root);
        }
        // `steep` is the sensitivity of 1/(λ − r² + 2iζr√λ) to r. The sensitivity to √λ is equal.
        let steep = (root * root + r * r + b).to_f64() / square.sqrt().to_f64();
        add(weight * re, weight * im, 1.0 + 2.0 * steep);
    }
    if relative {
        add(modal.static_motion, zero, 1.0);
    }
    sum
}

fn angle(difference: f64) -> f64 {
    let turn = std::f64::consts::TAU;
    let difference = difference.rem_euclid(turn);
    difference.min(turn - difference)
}

/// Numbers of compared answers and of omitted ones, with the reasons, and the largest error divided by its bound.
#[derive(Debug, Default)]
struct Seen {
    compared: usize,
    /// Number of answers whose r is within a rounding unit of a pole. These answers have only a lower bound.
    on_poles: usize,
    /// Number of frequencies without a motion: undamped resonances, and frequencies where β_lim = 0.
    without: usize,
    worst: f64,
}

fn compare<S: Rounded>(name: &str, system: &System<S>, seen: &mut Seen) {
    let modal = system.modal();
    let epsilon = S::EPSILON;
    for r in ratios(system.resonances()) {
        let at = system.at(r).expect("in the domain");
        let Ok(motion) = at.motion(S::constant(0.0)) else {
            let undamped = modal.damping_ratios.iter().any(|zeta| zeta.is_zero());
            let limit = at.continuous_limit().min(at.sliding_limit());
            assert!(
                undamped && system.resonances().contains(&r) || limit.is_zero(),
                "{name}, r = {r:?}: no motion without friction"
            );
            seen.without += 1;
            continue;
        };
        let exact = Dd::from(r.to_f64());
        let mut check = |what: String, of: Response, amplitude: S, phase: S| {
            let want = (of.re * of.re + of.im * of.im).sqrt();
            let error = (Dd::from(amplitude.to_f64()) - want).abs().to_f64();
            let bound = BAR * epsilon * of.condition;
            if BAR * epsilon * of.steepest > 0.25 {
                // If r is within a rounding unit of a pole, the answer has no upper bound. Its lower bound is the
                // answer at the far end of that unit.
                let least = (want * want).to_f64() / (want.to_f64() + bound) * 0.5;
                assert!(
                    amplitude.to_f64() >= least,
                    "{name}, r = {r:?}: {what} {amplitude:?} on a pole, at least {least:e}"
                );
                seen.on_poles += 1;
                return;
            }
            seen.compared += 1;
            seen.worst = seen.worst.max(error / (epsilon * of.condition));
            assert!(
                error <= bound,
                "{name}, r = {r:?}: {what} {amplitude:?} for {}, bound {bound:e}",
                want.to_f64()
            );
            // The lag is −arg of the sum. If the sum has an error `bound`, the lag has the error `bound` divided by
            // the modulus of the sum.
            let lag = Scalar::atan2(-of.im, of.re);
            let error = angle(phase.to_f64() - lag.to_f64());
            let bound = BAR * epsilon * (of.condition / want.to_f64() + 4.0);
            assert!(
                error <= bound,
                "{name}, r = {r:?}: {what} lags by {phase:?} for {}, bound {bound:e}",
                lag.to_f64()
            );
        };
        let contact = response(
            modal,
            exact,
            |mode| modal.contacts[mode],
            modal.on_moving_base,
        );
        let steady = motion.contact();
        check(
            String::from("contact"),
            contact,
            steady.amplitude(),
            steady.phase(),
        );
        for mass in 0..modal.shapes.len() {
            let of = response(modal, exact, |mode| modal.shapes[mode][mass], false);
            let steady = motion.mass_at(mass).expect("a mass");
            check(
                format!("mass {mass}"),
                of,
                steady.amplitude(),
                steady.phase(),
            );
        }
    }
}

fn all<S: Rounded>(precision: &str) -> Seen {
    let mut seen = Seen::default();
    for (name, text) in SCENES {
        compare(name, &system::<S>(text), &mut seen);
    }
    println!(
        "linear response, {precision}: {} compared, {} on poles bounded from below only, {} \
         frequencies without a motion; worst {:.2} roundings of the terms",
        seen.compared, seen.on_poles, seen.without, seen.worst
    );
    seen
}

#[test]
fn without_friction_in_double_precision() {
    let seen = all::<f64>("f64");
    assert_eq!(
        (seen.compared, seen.on_poles, seen.without),
        (41_529, 492, 21)
    );
}

#[test]
fn without_friction_in_single_precision() {
    let seen = all::<f32>("f32");
    assert_eq!(
        (seen.compared, seen.on_poles, seen.without),
        (19_881, 492, 37)
    );
}
