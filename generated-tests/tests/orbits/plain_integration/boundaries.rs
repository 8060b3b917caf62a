//! Tests that the integrated motion changes its regime at the friction ratios β_lim and β*_lim.

use crate::plain_integration::equations::{Chain, Contact, STEPS, State, TOLERANCE, solve};
use crate::plain_integration::scenes::{on_base, on_each_other, on_wall};
use frictiongen::study::System;
use std::f64::consts::PI;

/// Returns the phase and the initial state of the formal motion. Its contact reverses at τ = 0 and τ = π. The
/// function ignores the sign of z̄′ between the reversals.
///
/// The friction force is +β for the whole half period, even where that is not physical. Newton's method solves y(π) =
/// −y(0), z̄′(0) = 0.
fn formal(chain: &Chain) -> (f64, State) {
    let m = 2 * chain.n;
    let place = |i: usize| if i < chain.n { i } else { 3 + i - chain.n };
    let residual = |t: f64, y: &State| -> Vec<f64> {
        let (mut end, h) = (*y, PI / STEPS as f64);
        for step in 0..STEPS {
            end = chain.step(t + step as f64 * h, &end, h, Contact::Slides(-1.0));
        }
        let mut out: Vec<f64> = (0..m).map(|i| end[place(i)] + y[place(i)]).collect();
        out.push(chain.relative_velocity(t, y));
        out
    };
    let height = |t: f64| chain.relative(t, &chain.frictionless(t));
    let mut t = (0..400)
        .map(|i| f64::from(i) * PI / 200.0)
        .max_by(|a, b| height(*a).total_cmp(&height(*b)))
        .unwrap();
    let mut y = chain.frictionless(t);
    for _ in 0..30 {
        let now = residual(t, &y);
        if now.iter().all(|value| value.abs() < 1e-12) {
            break;
        }
        let mut rows: Vec<Vec<f64>> = now.iter().map(|_| vec![0.0; m + 2]).collect();
        for j in 0..=m {
            let step = 1e-5;
            let moved = |by: f64| {
                let (mut t, mut y) = (t, y);
                if j < m {
                    y[place(j)] += by
                } else {
                    t += by
                }
                residual(t, &y)
            };
            for (row, (more, less)) in rows.iter_mut().zip(moved(step).iter().zip(moved(-step))) {
                row[j] = (more - less) / (2.0 * step);
            }
        }
        for (row, value) in rows.iter_mut().zip(&now) {
            row[m + 1] = -value;
        }
        let change = solve(rows);
        // The step is limited, because the first step from the frictionless motion may be too long.
        let scale = 0.3 / change[m].abs().max(0.3);
        for j in 0..m {
            y[place(j)] += scale * change[j];
        }
        t += scale * change[m];
    }
    let left = residual(t, &y)
        .iter()
        .fold(0.0, |most: f64, value| most.max(value.abs()));
    assert!(left < 1e-10, "no formal motion: {left:e}");
    (t, y)
}

/// Tells whether Coulomb's law permits the formal motion.
#[derive(Debug, PartialEq)]
enum Verdict {
    Continuous,
    /// z̄′ changes its sign within the half period.
    Turns,
    /// Static friction stops the contact at the reversal.
    Holds,
}

fn verdict(chain: &Chain) -> Verdict {
    let (t, start) = formal(chain);
    // The contact comes to rest from the positive direction, so the static friction is −μβ. The contact breaks away
    // if the load exceeds this friction.
    if -chain.holding_force(t, &start) <= chain.mu * chain.beta {
        return Verdict::Holds;
    }
    let (mut y, h) = (start, PI / STEPS as f64);
    for step in 0..STEPS - 1 {
        y = chain.step(t + step as f64 * h, &y, h, Contact::Slides(-1.0));
        if chain.relative_velocity(t + (step + 1) as f64 * h, &y) >= 0.0 {
            return Verdict::Turns;
        }
    }
    Verdict::Continuous
}

/// Checks that for β > β_lim Coulomb's law forbids the formal motion, with the verdict `beyond`. Returns the number
/// of compared verdicts.
fn check_boundary(mut chain: Chain, text: &str, beyond: Verdict) -> usize {
    let system: System = text
        .parse()
        .unwrap_or_else(|error| panic!("{error}\n{text}"));
    let at = system.at(chain.r).unwrap();
    let limit = at.continuous_limit();
    assert!(limit < at.sliding_limit(), "{text}");
    // The limit comes from the search for S if it is clearly smaller than the limit without search.
    let by_search = limit < at.continuous_limit_without_search() * (1.0 - 1e-3);
    assert_eq!(by_search, beyond == Verdict::Turns, "{text}");
    let mut compared = 0;
    // A grid samples z̄′ and limits the accuracy of the verdict more than the integration does. The factors closest
    // to 1 are chosen accordingly.
    for factor in [0.5, 0.98, 1.0 - 1e-5] {
        chain.beta = factor * limit;
        assert_eq!(
            verdict(&chain),
            Verdict::Continuous,
            "{factor} of {limit}: {text}"
        );
        compared += 1;
    }
    for factor in [1.0 + 1e-5, 1.02] {
        chain.beta = factor * limit;
        assert_eq!(verdict(&chain), beyond, "{factor} of {limit}: {text}");
        compared += 1;
    }
    compared
}

#[test]
fn velocity_constraint_is_the_boundary() {
    let single = |zeta: f64, r: f64| {
        let mut c = [[0.0; 3]; 3];
        c[0][0] = 2.0 * zeta * r;
        Chain {
            n: 1,
            gamma: [1.0; 3],
            c,
            k: [[1.0, 0.0, 0.0], [0.0; 3], [0.0; 3]],
            w: [1.0, 0.0, 0.0],
            p: [1.0, 0.0, 0.0],
            s: 0.0,
            mu: 1.0,
            r,
            beta: 0.0,
        }
    };
    let mut compared = 0;
    for r in [0.35, 0.22] {
        compared += check_boundary(
            single(0.0, r),
            "struct One { masses: { a: 4 }, springs: { base - a: 9 }, contact: a - wall, excitation: a }",
            Verdict::Turns,
        );
        compared += check_boundary(
            single(0.02, r),
            "struct One { masses: { a: 4 }, springs: { base - a: 9 }, contact: a - wall, excitation: a,
             damping: modal(0.02) }",
            Verdict::Turns,
        );
    }
    // At this r the sum of the modes' own maxima is not the maximum of their sum.
    let (mut chain, text) = on_wall(false);
    chain.r = 0.35;
    compared += check_boundary(chain, text, Verdict::Turns);
    println!("{compared} verdicts compared, none skipped");
    assert_eq!(compared, (2 * 2 + 1) * (3 + 2));
}

#[test]
fn break_away_is_the_boundary() {
    let (chain, text) = on_wall(true);
    let mut compared = check_boundary(chain, text, Verdict::Holds);
    let (chain, text, _) = on_base(false);
    compared += check_boundary(chain, text, Verdict::Holds);
    let (chain, text, _) = on_base(true);
    compared += check_boundary(chain, text, Verdict::Holds);
    let (chain, text) = on_each_other(true);
    compared += check_boundary(chain, text, Verdict::Holds);
    println!("{compared} verdicts compared, none skipped");
    assert_eq!(compared, 4 * (3 + 2));
}

/// Compares two results for a stuck contact with the integration: the complex amplitudes, and the largest contact
/// force. Returns the number of compared amplitudes.
fn check_stuck(chain: &Chain, text: &str, names: &[&str]) -> usize {
    let system: System = text
        .parse()
        .unwrap_or_else(|error| panic!("{error}\n{text}"));
    let at = system.at(chain.r).unwrap();
    let limit = at.sliding_limit();
    let stuck = at.stuck().unwrap();
    // The contact sticks at z̄ = 0, and the integration starts from rest.
    let mut y = [0.0; 6];
    for (y, w) in y.iter_mut().zip(&chain.w) {
        *y = chain.s * w;
    }
    let h = PI / STEPS as f64;
    let mut sums = vec![(0.0, 0.0); chain.n];
    let (mut force, mut before) = (0.0f64, y);
    let cycles = 160;
    for cycle in 0..cycles {
        before = y;
        for step in 0..2 * STEPS {
            let t = step as f64 * h;
            if cycle + 1 == cycles {
                // Equal weights are exact over a whole period of a smooth function.
                for (k, sum) in sums.iter_mut().enumerate() {
                    sum.0 += y[k] * t.cos() / STEPS as f64;
                    sum.1 -= y[k] * t.sin() / STEPS as f64;
                }
                force = force.max(chain.holding_force(t, &y).abs());
            }
            y = chain.step(t, &y, h, Contact::Holds);
        }
    }
    let drift = (0..6).fold(0.0, |most: f64, i| most.max((y[i] - before[i]).abs()));
    assert!(drift < 1e-11, "not steady yet: {drift:e}");
    assert_eq!(names.len(), sums.len());
    let mut compared = 0;
    for (name, (re, im)) in names.iter().zip(sums) {
        let amplitude = stuck.mass(name).unwrap();
        let error = (amplitude.re - re).hypot(amplitude.im - im);
        assert!(
            error < TOLERANCE * 10.0,
            "stuck {name}: {amplitude:?} against {re} + {im}i"
        );
        compared += 1;
    }
    // The largest of 4000 samples of a sinusoid is at most a fraction of 3.1e-7 smaller than its amplitude.
    let error = force / chain.mu / limit - 1.0;
    assert!(
        error < TOLERANCE && error > -4e-7,
        "sliding limit {limit}, force {force}"
    );
    assert!(force > chain.mu * 0.999 * limit && force < chain.mu * 1.001 * limit);
    compared
}

#[test]
fn stuck_response_and_sliding_limit() {
    let (chain, text) = on_wall(true);
    let mut compared = check_stuck(&chain, text, &["a", "b", "c"]);
    let (chain, text, names) = on_base(true);
    compared += check_stuck(&chain, text, names);
    let (chain, text) = on_each_other(true);
    compared += check_stuck(&chain, text, &["a", "b"]);
    println!("{compared} amplitudes and three limits compared, none skipped");
    assert_eq!(compared, 3 + names.len() + 2);
}
