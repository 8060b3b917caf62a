//! One undamped mass with an elastic contact is the bilinear hysteretic oscillator. Its steady state against Iwan's exact
//! solution (J. Appl. Mech. 32 (1965) 921) and against Caughey's equivalent linearisation (J. Appl. Mech. 27 (1960) 640),
//! which is an approximation.

use frictiongen::System;
use std::f64::consts::PI;

fn system(stiffness: f64) -> System {
    format!(
        "struct Bilinear {{ masses: {{ block: 1.0 }}, springs: {{ base - block: 1.0 }}, contact: block - wall,
            stiffness: {stiffness:?}, excitation: block, provide: [orbit] }}"
    )
    .parse()
    .unwrap()
}

/// Free vibration about a particular solution: displacement and velocity after a time t.
fn swung([x, v]: [f64; 2], omega: f64, t: f64) -> [f64; 2] {
    let (sine, cosine) = (omega * t).sin_cos();
    [x * cosine + v / omega * sine, v * cosine - x * omega * sine]
}

/// One half period of the exact motion, for r² x″ + x + f = cos(τ + φ). At τ = 0 the motion is at its maximum A, and the
/// force of the contact is β. The spring of stiffness κ unloads until the force is −β at τ₁. Then the contact slides, with a
/// constant force, until the velocity is 0 at τ = π.
struct Exact {
    r: f64,
    beta: f64,
    kappa: f64,
}

impl Exact {
    /// Returns what the three conditions lack: x(τ₁) = A − 2β/κ, x(π) = −A and x′(π) = 0.
    fn lacking(&self, [amplitude, phase, first]: [f64; 3]) -> [f64; 3] {
        let Self { r, beta, kappa } = *self;
        let r2 = r * r;
        let forced = |stiffness: f64, tau: f64| {
            let size = 1.0 / (stiffness - r2);
            let (sine, cosine) = (tau + phase).sin_cos();
            [size * cosine, -size * sine]
        };
        let phase_of = |stiffness: f64, rest: f64, start: [f64; 2], from: f64, to: f64| {
            let ([x, v], omega) = (forced(stiffness, from), stiffness.sqrt() / r);
            let [free, rate] = swung([start[0] - x - rest, start[1] - v], omega, to - from);
            let [x, v] = forced(stiffness, to);
            [free + x + rest, rate + v]
        };
        // Stuck: (1 + κ) x = κ(A − β/κ) at rest. Sliding: x = β.
        let anchor = (kappa * amplitude - beta) / (1.0 + kappa);
        let slips = phase_of(1.0 + kappa, anchor, [amplitude, 0.0], 0.0, first);
        let end = phase_of(1.0, beta, slips, first, PI);
        [
            slips[0] - amplitude + 2.0 * beta / kappa,
            end[0] + amplitude,
            end[1],
        ]
    }

    /// Solves the three conditions by Newton's method with central differences.
    fn solved(&self, mut at: [f64; 3]) -> Option<[f64; 3]> {
        for _ in 0..40 {
            let now = self.lacking(at);
            let mut columns = [[0.0; 3]; 3];
            for (index, column) in columns.iter_mut().enumerate() {
                let step = 1e-5 * at[index].abs().max(1e-2);
                let moved = |by: f64| {
                    let mut moved = at;
                    moved[index] += by;
                    self.lacking(moved)
                };
                let (above, below) = (moved(step), moved(-step));
                *column = [0, 1, 2].map(|row| (above[row] - below[row]) / (2.0 * step));
            }
            let determinant = |a: [f64; 3], b: [f64; 3], c: [f64; 3]| {
                a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1])
                    + c[0] * (a[1] * b[2] - a[2] * b[1])
            };
            let [a, b, c] = columns;
            let all = determinant(a, b, c);
            let step = [
                determinant(now, b, c) / all,
                determinant(a, now, c) / all,
                determinant(a, b, now) / all,
            ];
            for (value, step) in at.iter_mut().zip(step) {
                *value -= step;
            }
            if step.iter().all(|step| step.abs() < 1e-14) {
                break;
            }
        }
        let lacks = self
            .lacking(at)
            .iter()
            .fold(0.0_f64, |most, one| most.max(one.abs()));
        (lacks < 1e-12 * at[0].abs().max(1.0)).then_some(at)
    }
}

/// Returns stiffness and loss of the equivalent linear spring at an amplitude A above β/κ.
fn equivalent(amplitude: f64, beta: f64, kappa: f64) -> [f64; 2] {
    let angle = (1.0 - 2.0 * beta / (kappa * amplitude))
        .clamp(-1.0, 1.0)
        .acos();
    let stiffness = kappa / PI * (angle - 0.5 * (2.0 * angle).sin());
    [stiffness, kappa / PI * angle.sin().powi(2)]
}

/// Returns Caughey's amplitude and phase lag: |1 + C − r² + iS| A = 1. `None` unless the contact slides.
fn caughey(r: f64, beta: f64, kappa: f64) -> Option<[f64; 2]> {
    let excess = |amplitude: f64| {
        let [stiffness, loss] = equivalent(amplitude, beta, kappa);
        amplitude * f64::hypot(1.0 + stiffness - r * r, loss) - 1.0
    };
    let (mut low, mut high) = (beta / kappa, 1e6);
    if !(excess(low) < 0.0 && 0.0 < excess(high)) {
        return None;
    }
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if excess(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    let [stiffness, loss] = equivalent(low, beta, kappa);
    Some([low, loss.atan2(1.0 + stiffness - r * r)])
}

/// Amplitude, sticking time and phase of steady states with one slide in each half period, against Iwan's equations.
#[test]
fn iwan_has_the_same_steady_state() {
    let (mut compared, mut worst, mut estimate) = (0, 0.0_f64, 0.0_f64);
    for kappa in [0.2, 1.0, 5.0] {
        let system = system(kappa);
        for r in [0.55, 0.8, 0.95, 1.05, 1.2, 1.6] {
            for beta in [0.1, 0.3, 0.5] {
                let Some([amplitude, lag]) = caughey(r, beta, kappa) else {
                    continue;
                };
                let orbit = system.at(r).unwrap().orbit(beta);
                let Ok(orbit) = orbit else { continue };
                if orbit.stops() != 2 || orbit.period() != 1 || orbit.is_marginal() {
                    continue;
                }
                let exact = Exact { r, beta, kappa };
                let sticks = (1.0 - 2.0 * beta / (kappa * amplitude))
                    .clamp(-1.0, 1.0)
                    .acos();
                let Some([own, phase, first]) = exact.solved([amplitude, lag, sticks]) else {
                    continue;
                };
                let contact = orbit.contact();
                let apart = [
                    contact.amplitude() / own - 1.0,
                    orbit.stuck_fraction() - first / PI,
                    // The maximum is at τ = 0 of the equations, which is φ after that of the load.
                    (contact.phase() - phase).sin(),
                ];
                // The condition of Newton's equations, up to 100, magnifies a rounding.
                assert!(
                    apart.iter().all(|one| one.abs() < 1e-12),
                    "{kappa} {r} {beta}: {apart:?}"
                );
                worst = apart.iter().fold(worst, |most, one| most.max(one.abs()));
                estimate = estimate.max((amplitude / own - 1.0).abs());
                compared += 1;
            }
        }
    }
    println!(
        "{compared} steady states, Iwan's within {worst:e}, Caughey's estimate within {estimate:.3}"
    );
    assert!(compared >= 30, "{compared}");
}

/// Caughey's linearisation leaves out the third harmonic, which is proportional to κ. It acts back on the fundamental by κ².
#[test]
fn caughey_differs_by_the_square_of_the_stiffness() {
    for (r, share) in [(0.7, 0.3), (1.5, 0.3), (0.7, 0.6)] {
        let mut last: Option<f64> = None;
        for kappa in [0.1, 0.01, 0.001] {
            // The force is a fixed share of what the stuck spring would have.
            let beta = share * kappa / f64::abs(1.0 - r * r);
            let system = system(kappa);
            let orbit = system.at(r).unwrap().orbit(beta).unwrap();
            let [amplitude, _] = caughey(r, beta, kappa).unwrap();
            let fundamental = orbit.contact().harmonic(1).norm();
            let apart = (amplitude / fundamental - 1.0).abs();
            println!("r = {r}, κ = {kappa}: {apart:e}");
            if let Some(last) = last {
                assert!((70.0..140.0).contains(&(last / apart)), "{last} {apart}");
            }
            last = Some(apart);
        }
    }
}
