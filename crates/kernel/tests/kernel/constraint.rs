//! The velocity constraint of chains given by their modes agrees with the printed sum on a grid.  Where sweeps are
//! slow, the test of a single β agrees with the limit.

use frictiongen_kernel::Float;
use frictiongen_kernel::contact::sums::{Chain, ContactAt, ModeAt};
use frictiongen_kernel::modal_sum::search::{Peak, Weight, most_evaluations};
use frictiongen_kernel::modal_sum::wave::Wave;
use frictiongen_kernel::oscillator::decay::Damped;
use frictiongen_kernel::oscillator::mode::{Kind, Mode};
use fuzzing::Random;
use std::f64::consts::{FRAC_PI_2, PI};

/// A mode by its resonance, its damping ratio, and the shares of load and contact in it.
#[derive(Clone, Copy)]
struct Part {
    resonance: f64,
    zeta: f64,
    load: f64,
    contact: f64,
}

fn random_parts(random: &mut Random, most: usize, damped: bool) -> Vec<Part> {
    let count = 1 + (random.unit() * most as f64) as usize;
    let mut parts: Vec<Part> = (0..count)
        .map(|_| Part {
            resonance: random.log_uniform(0.3, 10.0),
            zeta: if damped {
                random.log_uniform(1e-4, 0.3)
            } else {
                0.0
            },
            load: random.unit() - 0.5,
            contact: random.unit() - 0.5,
        })
        .collect();
    parts.sort_by(|a, b| a.resonance.total_cmp(&b.resonance));
    parts
}

struct At<S> {
    chain: Chain<S>,
    modes: Vec<Mode<S>>,
    at: Vec<ModeAt<S>>,
    contact: ContactAt<S>,
    waves: Vec<Wave<S, Damped<S>>>,
}

impl<S: Float> At<S> {
    fn new(parts: &[Part], inverse_r: S) -> Self {
        let c = S::constant;
        let modes: Vec<Mode<S>> = parts
            .iter()
            .map(|part| {
                let zeta = c(part.zeta);
                let q = ((c(1.0) - zeta) * (c(1.0) + zeta)).sqrt();
                let (load, contact, resonance) = (c(part.load), c(part.contact), c(part.resonance));
                Mode {
                    kind: if part.zeta == 0.0 {
                        Kind::Undamped
                    } else {
                        Kind::Light
                    },
                    in_contact: true,
                    resonance,
                    zeta,
                    q,
                    q_defect: zeta * zeta / (c(1.0) + q),
                    load,
                    contact,
                    residue: load * contact,
                    contact_squared: contact * contact,
                    static_residue: load * contact / (resonance * resonance),
                }
            })
            .collect();
        let chain = Chain {
            damped: parts.iter().any(|part| part.zeta > 0.0),
            on_moving_base: None,
            inverse_mass: modes
                .iter()
                .fold(c(0.0), |sum, mode| sum + mode.contact_squared),
            stiction: c(1.0),
        };
        let mut at = Vec::new();
        let contact = chain.contact(&modes, inverse_r, |mode| at.push(mode));
        let waves = modes.iter().map(Wave::idle).collect();
        Self {
            chain,
            modes,
            at,
            contact,
            waves,
        }
    }

    fn searched(&mut self) -> Peak<S> {
        self.chain
            .velocity_constraint(&self.contact, &self.modes, &self.at, &mut self.waves)
    }

    /// Upper bound on the evaluations of that search, from the modes' constants.
    fn most(&self) -> u32 {
        let one = S::constant(1.0);
        let modes = self.modes.iter().zip(&self.at);
        let fastest = modes.fold(S::constant(0.0), |most, (mode, at)| {
            most.max(at.x * (one + (mode.zeta + mode.zeta)))
        });
        most_evaluations(Weight::Sine, fastest)
    }

    fn limit(&mut self) -> S {
        let peak = self.searched();
        self.chain.continuous_limit(&self.contact, peak.value)
    }

    fn admits(&mut self, beta: S) -> bool {
        self.chain
            .is_continuous(beta, &self.contact, &self.modes, &self.at, &mut self.waves)
    }
}

/// r²·S without damping at τ: Σ c R[sin(τ/R) − T(cos(τ/R) − cos τ)]/sin τ.
fn printed(parts: &[Part], inverse_r: f64, tau: f64) -> f64 {
    let mode = |part: &Part| {
        let x = part.resonance * inverse_r;
        let tangent = (0.5 * PI * (x % 2.0)).tan();
        let turned = (x * tau).sin() - tangent * ((x * tau).cos() - tau.cos());
        part.contact * part.contact / x * turned
    };
    (parts.iter().map(mode).sum::<f64>() / tau.sin()).abs()
}

/// Six modes near neighbouring odd multiples of the excitation's frequency.  Their vibrations are all in phase at the
/// middle of the half period, and nearly in phase nowhere else.  The constraint is therefore largest close to the
/// middle.
fn in_step(random: &mut Random) -> Vec<Part> {
    let mut odd: Vec<u32> = (12..19).map(|n| 2 * n + 1).collect();
    odd.remove((random.unit() * odd.len() as f64) as usize);
    let part = |n: u32| {
        let sign = if n % 4 == 1 { 1.0 } else { -1.0 };
        let x = f64::from(n) - sign * 0.005;
        let inverse_mass = (1.0 + 0.2 * random.unit()) * x * (0.5 * PI * x).cos().abs();
        Part {
            resonance: x,
            zeta: 0.0,
            load: 1.0,
            contact: inverse_mass.sqrt(),
        }
    };
    odd.into_iter().map(part).collect()
}

/// The sum is odd about the middle of the half period, and its largest value may be anywhere up to the middle.
#[test]
fn the_undamped_constraint_is_searched_to_the_middle() {
    let mut random = Random(8);
    let (mut compared, mut last_sixth, mut at_start) = (0, 0, 0);
    let mut worst = 0.0_f64;
    for case in 0..1260 {
        let (parts, inverse_r) = if case < 1200 {
            (
                random_parts(&mut random, 8, false),
                random.log_uniform(0.3, 12.0),
            )
        } else {
            (in_step(&mut random), 1.0)
        };
        let fastest = parts[parts.len() - 1].resonance * inverse_r;
        let points = 200 + (24.0 * fastest) as usize;
        let step = FRAC_PI_2 / points as f64;
        let value = |tau: f64| printed(&parts, inverse_r, tau);
        let values: Vec<f64> = (0..=points)
            .map(|i| value((i as f64).max(0.01) * step))
            .collect();
        let most = values.iter().copied().fold(0.0, f64::max);
        let (mut best, mut place) = (0.0_f64, 0.0);
        for (i, height) in values.iter().enumerate() {
            if *height < most * 0.95 {
                continue;
            }
            let (mut low, mut high) = (
                (i as f64 - 1.0).max(0.01) * step,
                ((i + 1).min(points) as f64) * step,
            );
            for _ in 0..60 {
                let width = 0.618_033_988_749_894_8 * (high - low);
                if value(high - width) < value(low + width) {
                    low = high - width;
                } else {
                    high = low + width;
                }
            }
            for tau in [0.5 * (low + high), (i as f64).max(0.01) * step] {
                if best < value(tau) {
                    (best, place) = (value(tau), tau);
                }
            }
        }
        let mut at = At::<f64>::new(&parts, inverse_r);
        let peak = at.searched();
        assert!(!peak.exceeded && peak.evaluations <= at.most());
        // For μ = 1 the quotient's limit for τ → 0 belongs to the constraint.
        let want = best.max(at.chain.inverse_mass);
        let got = peak.value / at.contact.scale;
        at_start += u32::from(best <= at.chain.inverse_mass * (1.0 + 1e-12));
        // Near a pole of a tangent the rounding of x is amplified.
        let pole = parts
            .iter()
            .map(|p| 1.0 / (0.5 * PI * p.resonance * inverse_r).cos().abs())
            .fold(1.0, f64::max);
        let off = (got / want - 1.0).abs() / (1.0 + 1e-6 * fastest * pole);
        assert!(off < 1e-9, "case {case}: {got}, not {want} at {place}");
        worst = worst.max(off);
        last_sixth += u32::from(place > 0.42 * PI && best > at.chain.inverse_mass * (1.0 + 1e-6));
        compared += 1;
    }
    println!(
        "{compared} chains, {at_start} decided at the start, {last_sixth} in the last sixth; worst {worst:e}"
    );
    assert_eq!(compared, 1260);
    assert!(last_sixth >= 10, "{last_sixth}");
}

/// The test of a β and the limit are two searches of the same sum.  They agree even where the rounding of r turns modes
/// of very low damping so far that two searches find different peaks.
#[test]
fn what_is_admitted_is_below_the_limit() {
    let mut random = Random(9);
    let (mut compared, mut exhausted) = (0, 0);
    let mut differing = Vec::new();
    for case in 0..640 {
        let mut parts = random_parts(&mut random, 8, case % 8 != 0);
        for part in &mut parts {
            part.zeta *= 1e-3;
        }
        let r = random.log_uniform(1e-6, 1e-4) as f32;
        let mut at = At::<f32>::new(&parts, 1.0 / r);
        let peak = at.searched();
        assert!(peak.evaluations <= at.most());
        exhausted += u32::from(peak.exceeded);
        let limit = at.limit();
        for above in [-1e-2, -1e-3, -1e-5, 0.0, 1e-5, 1e-3_f32] {
            let beta = limit * (1.0 + above);
            if at.admits(beta) != (beta < limit) {
                differing.push((case, r, above));
            }
            compared += 1;
        }
    }
    println!(
        "{compared} β, {differing:?} otherwise than the limit says, {exhausted} searches given up"
    );
    assert_eq!(compared, 3840);
    // The two searches then end with the best value of one and the same walk.
    assert!(exhausted >= 2, "{exhausted}");
    assert!(
        differing.is_empty(),
        "{} of {compared}: {:?}",
        differing.len(),
        differing[0]
    );
}
