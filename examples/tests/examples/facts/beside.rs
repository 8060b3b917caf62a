//! Checks the table further: the same numbers computed in another way, and their neighbourhood.

use super::close;
use frictiongen::study::System;
use frictiongen_examples::facts::ask::{
    amplitude, ask, base, chain, contact_invariant, estimate, fundamental, growth, limit, orbit,
    orbit_amplitude, peak, root, sliding_limit, unit, wall,
};
use frictiongen_examples::facts::chapter2::constraint_ratio;
use frictiongen_examples::facts::moving::{GAMMA, KAPPA, RATIO, rig_with};
use frictiongen_examples::facts::walls::maxima;
use std::f64::consts::{FRAC_PI_4, PI, SQRT_2, TAU};

/// Checks that β_lim has a finite slope at r = 1. At a distance of 1e-7 in r it differs by about 1e-7.
#[test]
fn f01_beside_the_resonance() {
    for r in [1.0 - 1e-7, 1.0 + 1e-7] {
        close(limit(&wall(""), r), FRAC_PI_4, 1e-6);
    }
    assert_eq!(wall("").resonance_thresholds().len(), 1);
}

/// Checks that β_lim approaches its limit for r → ∞ as 1/r². (6.28) is the closed form of that limit.
#[test]
fn f02_approached() {
    for mu in [1.0, 1.5] {
        let system = wall(&format!("stiction: {mu:?}"));
        let end = 2.0 / (4.0 * mu * mu + PI * PI).sqrt();
        close(limit(&system, f64::INFINITY), end, 1e-15);
        close(system.high_frequency_limits().0, end, 1e-15);
        close(limit(&system, 1e4), end, 1e-7);
    }
}

/// Checks that below r = 1/2 the velocity constraint is larger than its limit for τ → 0.
#[test]
fn f03_below_half() {
    for r in [0.35, 0.4, 0.45] {
        assert!(constraint_ratio(&wall(""), r) > 1.01, "at {r}");
    }
}

/// Returns β*_lim − β_lim as (3.24) and (3.21) print them, with S = 1 beyond r = 1/2.
fn printed_width(mu: f64, r: f64) -> f64 {
    let (v, u) = (1.0 / (1.0 - r * r), (PI / (2.0 * r)).tan() / r);
    let break_away = mu / (r * r);
    r * r / mu - ((v - 1.0).powi(2) / (u * u + break_away * break_away)).sqrt()
}

/// Checks that the extremes of the printed width are at the stated r and have the stated widths.
#[test]
fn f05_by_the_printed_limits() {
    let width = |r| printed_width(1.0, r);
    assert!(width(0.5553) > width(0.5543) && width(0.5553) > width(0.5563));
    assert!(width(0.7927) < width(0.7917) && width(0.7927) < width(0.7937));
    close(width(0.5553), 0.1730, 5e-5);
    close(width(0.7927), 0.1167, 5e-5);
}

/// Checks that the two printed limits touch at the stated μ.
#[test]
fn f06_by_the_printed_limits() {
    let narrowest = |mu: f64| {
        let width = |r| printed_width(mu, r);
        let places = (0..7000).map(|i| 0.50005 + 2e-4 * f64::from(i));
        places.map(width).fold(f64::INFINITY, f64::min)
    };
    assert!(narrowest(1.2310) > 0.0 && narrowest(1.2314) < 0.0);
}

/// Checks that the fundamental components of every pair of friction ratios cross at the same r.
#[test]
fn f07_by_pairs() {
    let system = base(1.0);
    for (one, other) in [(0.1, 0.5), (0.1, 1.4), (0.7, 1.2)] {
        let gain = |r| fundamental(&system, "m1", r, one) - fundamental(&system, "m1", r, other);
        close(root(gain, 1.48, 1.55), 1.506310, 5e-7);
    }
}

/// Checks that at the stated β the highest amplitude of continuous motion equals the amplitude of the base.
#[test]
fn f09_by_the_closed_form() {
    let system = base(1.0);
    let highest = |beta: f64| {
        let of = |r| amplitude(&system, "m1", r, beta);
        of(peak(of, 1.26, 1.34))
    };
    assert!(highest(1.0569) > 1.0 && highest(1.0571) < 1.0);
}

/// Checks that outside its region the fundamental component falls with β: below the pole of U at r = 1/3, and above the
/// upper bound.
#[test]
fn f13_outside() {
    let system = wall("");
    let growth = |r| growth(&system, |r, beta| fundamental(&system, "m1", r, beta), r);
    assert!(growth(1.0 / 3.0 - 1e-6) < 0.0 && growth(1.0 / 3.0 + 1e-6) > 0.0);
    assert!(growth(0.605258 - 1e-6) > 0.0 && growth(0.605258 + 1e-6) < 0.0);
}

/// Checks that a threshold equals β_lim at the resonance. For β ≥ 1/2 there is no quasi-static start.
#[test]
fn f14_to_f16_at_the_ends() {
    let system = unit(3, "m2 - wall", "m1");
    for (r, beta) in system
        .resonances()
        .iter()
        .zip(system.resonance_thresholds())
    {
        close(limit(&system, *r), beta.unwrap(), 1e-12);
    }
    assert!(system.quasi_static_start(0.5).is_none());
    for r in [0.3_f64, 0.9, 1.3, 1.5, 2.0, 3.0] {
        let want = 1.0 / (2.0 - r * r).abs();
        close(sliding_limit(&system, r), want, 1e-13 * want);
    }
}

/// Checks that at an invariant point the condition is satisfied for every β.
#[test]
fn f17_f22_f24_for_every_friction() {
    let lower = unit(2, "m1 - wall", "m1");
    let upper = unit(2, "m2 - wall", "m1");
    for share in [0.1, 0.5, 0.95] {
        close(
            contact_invariant(&lower, share, 0.555, 0.6),
            5_f64.sqrt() / 4.0,
            1e-9,
        );
        close(
            contact_invariant(&lower, share, 1.05, 1.3),
            5_f64.sqrt() / 2.0,
            1e-9,
        );
        close(contact_invariant(&upper, share, 1.43, 1.47), 1.44981, 5e-6);
        close(fundamental(&upper, "m2", SQRT_2, 0.7 * share), 1.0, 1e-12);
    }
}

/// Checks both sides of r = 1, where mass m₁ has its antiresonance. At r = 1 V₁ changes sign, and with V₁ the growth of
/// the estimate with β.
#[test]
fn f18_either_side_of_one() {
    let system = unit(2, "m1 - wall", "m1");
    let growth = |r: f64| growth(&system, |r, beta| estimate(&system, "m2", r, beta), r);
    assert!(growth(1.0 - 1e-4) < 0.0 && growth(1.0 + 1e-4) > 0.0);
}

/// Checks that the resonances lie just above the maxima. β_lim at a resonance is π/4, because contact and force act on
/// the same mass.
#[test]
fn f26_resonances() {
    let system = unit(5, "m1 - wall", "m1");
    let found = maxima(&|r| limit(&system, r));
    assert_eq!(found.len(), system.resonances().len());
    for (resonance, (r, _)) in system.resonances().iter().zip(found) {
        assert!(r < *resonance && resonance - r < 0.1, "{r} {resonance}");
        close(limit(&system, *resonance), FRAC_PI_4, 1e-12);
    }
}

fn between() -> System {
    chain(&[1.0, 0.5], &[1.0, 0.5], "m1 - m2", "m1", "")
}

/// Checks that far above the resonances the limits differ from their values at r → ∞ by a term of order 1/r².
#[test]
fn f27_approached() {
    let (continuous, sliding) = between().high_frequency_limits();
    close(limit(&between(), 1e4), continuous, 1e-7);
    close(sliding_limit(&between(), 1e4), sliding, 1e-7);
}

/// Checks that the estimates of every pair of β cross at one r, and that the exact amplitudes do not.
#[test]
fn f28_for_another_pair() {
    let system = between();
    let crossing = |of: fn(&System, &str, f64, f64) -> f64, low, high| {
        let difference = |r| of(&system, "m1", r, 0.02) - of(&system, "m1", r, 0.2);
        root(difference, low, high)
    };
    close(crossing(estimate, 0.75, 0.8), 0.777873, 5e-7);
    close(crossing(estimate, 1.19, 1.24), 1.21352, 5e-6);
    for (one, other, first, second) in [
        (0.01, 0.02, 0.7776, 1.2143),
        (0.05, 0.2, 0.7755, 1.2199),
        (0.2, 0.3, 0.7737, 1.2241),
    ] {
        let difference = |r| amplitude(&system, "m1", r, one) - amplitude(&system, "m1", r, other);
        close(root(difference, 0.75, 0.8), first, 5e-5);
        close(root(difference, 1.19, 1.24), second, 5e-5);
    }
}

/// Checks the pair of β that gives the lower bound of the first region, by the steady states.
#[test]
fn f28_by_the_orbits() {
    let system = between();
    let gain = |r| {
        let [less, more] = [0.4, 0.6].map(|beta| {
            let found = orbit(&system, r, beta).expect("a steady state");
            orbit_amplitude(&found, "m1")
        });
        more - less
    };
    assert!(gain(0.769548 - 1e-6) * gain(0.769548 + 1e-6) < 0.0);
}

/// Checks the estimate (7.61), typed in here. Its neglected terms are of the order ζ.
#[test]
fn f29_estimate() {
    for zeta in [0.01, 0.1] {
        let system = wall(&format!("damping: modal({zeta:?})"));
        let (sinh, cosh) = ((zeta * PI).sinh(), (zeta * PI).cosh());
        let estimate = system.resonant_peak_estimate(0, 0, 0.3).unwrap();
        let typed = 0.5 / zeta - 0.3 * sinh / (cosh - 1.0);
        close(estimate, typed, 1e-12 / zeta);
        close(amplitude(&system, "m1", 1.0, 0.3) / estimate, 1.0, zeta);
    }
}

/// Checks ω₀ and ω_z0 as (6.20) and neighbouring equations define them. Without friction m₁ does not move at ω₀, and
/// moves with the base at ω_z0.
#[test]
fn f30_antiresonances() {
    let omega = TAU / RATIO;
    let system = rig_with(omega);
    let still = omega * (KAPPA / GAMMA).sqrt();
    let together = still * (1.0 + GAMMA).sqrt();
    let free = amplitude(&system, "m1", system.frequency_ratio(still), 0.0);
    close(free, 0.0, 1e-12);
    let r = system.frequency_ratio(together);
    let slip = ask(&system, r, 0.0, |motion| motion.contact().amplitude());
    close(slip, 0.0, 1e-12);
}

/// Checks that at this r mass m₂ acts as an absorber, so that m₁ has no fundamental component at any friction.
#[test]
fn f32_for_every_friction() {
    let system = chain(&[1.0, GAMMA], &[1.0, KAPPA], "m1 - base", "base", "");
    let r = (KAPPA / GAMMA).sqrt();
    for beta in [0.1, 0.3, 0.5] {
        let slip = ask(&system, r, beta, |motion| {
            motion.contact().harmonic(1).norm()
        });
        close(slip, 1.0, 1e-12);
        close(fundamental(&system, "m1", r, beta), 0.0, 1e-12);
    }
}

/// Checks that near r = 1/2 there is one stop a cycle for μ > 1.
#[test]
fn f33_one_stop() {
    for (r, beta) in [(0.52, 0.08), (0.56, 0.12)] {
        let system = base(1.5);
        let found = orbit(&system, r, beta).expect("a steady state");
        assert_eq!((found.stops(), found.is_symmetric()), (1, false));
    }
}
