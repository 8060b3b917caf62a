//! Computes exact results at one frequency ratio in double precision, and their uncertainty from rounding.

use frictiongen::System;
use frictiongen::study::SystemAt;
use frictiongen_kernel::Float;
use std::cell::OnceCell;
use std::f64::consts::PI;

/// Relative distance from a resonance. At a smaller distance a rounding unit of the resonance changes an amplitude by
/// more than the accuracy.
const BESIDE: f64 = 1e-13;
/// Number of rounding units of r. The effect of this change of r counts as noise.
const ROUNDINGS: f64 = 16.0;

/// Both limits at one r, and the motion of the contact at β = `share` times the smaller limit.
pub struct Exact<'a> {
    system: &'a System<f64>,
    r: f64,
    share: f64,
    epsilon: f64,
    pub limits: [f64; 2],
    pub motion: Option<Motion>,
    noise: OnceCell<Noise>,
}

/// Motion of the contact at a friction ratio below both limits.
pub struct Motion {
    pub beta: f64,
    /// Amplitude and phase. `None` if double precision finds no continuous motion.
    pub answer: Option<[f64; 2]>,
}

/// Allowed differences of the results: the effect of a change of r by `ROUNDINGS` rounding units, and the rounding of
/// sums.
#[derive(Default)]
pub struct Noise {
    pub limits: [f64; 2],
    pub motion: [f64; 2],
    /// True if β_lim is known to a tenth of its value. Closer to its zeros no motion is compared.
    pub known: bool,
}

/// Returns the absolute value of an angle, reduced by whole turns.
pub fn turn(angle: f64) -> f64 {
    (angle - (angle / (2.0 * PI)).round() * 2.0 * PI).abs()
}

impl<'a> Exact<'a> {
    /// Computes the results. Returns `None` if r is so close to a resonance or one of its odd subharmonics that a
    /// rounding unit is more than 10⁻⁴ of the distance.
    pub fn at<S: Float>(system: &'a System<f64>, r: f64, share: f64) -> Option<Self> {
        let near = |sigma: &f64| {
            let order = 2.0 * (0.5 * (sigma / r - 1.0)).round() + 1.0;
            (r * order / sigma - 1.0).abs()
        };
        let mut distances = system.resonances().iter().map(near);
        if distances.any(|distance| (1e-15..1e-12).contains(&distance)) {
            return None;
        }
        let at = system.at(r).expect("in the domain");
        let limits = at.limits();
        let limits = [limits.continuous, limits.sliding];
        let limit = limits[0].min(limits[1]);
        // If a limit is nearly zero by rounding, there is no motion to compare.
        let beside = |sigma: &f64| (r / sigma - 1.0).abs() < BESIDE.max(S::EPSILON);
        let asked = limit > 1e-9 && !system.resonances().iter().any(beside);
        let motion = asked.then(|| {
            let beta = S::constant(share * limit).to_f64();
            let answer = contact(&at, beta);
            Motion { beta, answer }
        });
        Some(Self {
            system,
            r,
            share,
            epsilon: S::EPSILON,
            limits,
            motion,
            noise: OnceCell::new(),
        })
    }

    /// Returns the noise of the results. It takes another search, so the method computes it only on the first call.
    pub fn noise(&self) -> &Noise {
        self.noise.get_or_init(|| {
            let moved = self.system.at(self.r * (1.0 + ROUNDINGS * f64::EPSILON));
            let moved = moved.expect("in the domain");
            let elsewhere = [moved.continuous_limit(), moved.sliding_limit()];
            let sums = sum_rounding(self.system, self.r);
            let limits = [0, 1].map(|k| {
                let limit = self.limits[k];
                (elsewhere[k] - limit).abs() + sums * limit
            });
            let motion = self.motion.as_ref().and_then(|motion| {
                let [amplitude, phase] = motion.answer?;
                let [other, turned] = contact(&moved, motion.beta).unwrap_or([amplitude, phase]);
                let apart = 1.0 - self.share;
                let rounding = sums / (apart * (1.0 + self.share)) + self.epsilon * 16.0 / apart;
                Some([
                    (other - amplitude).abs() + rounding * amplitude,
                    turn(turned - phase) + rounding,
                ])
            });
            Noise {
                limits,
                motion: motion.unwrap_or_default(),
                known: (elsewhere[0] / self.limits[0] - 1.0).abs() < 0.1,
            }
        })
    }
}

fn contact(at: &SystemAt<'_, f64>, beta: f64) -> Option<[f64; 2]> {
    let motion = at.motion(beta).ok()?;
    let contact = motion.contact();
    Some([contact.amplitude(), contact.phase()])
}

/// Returns the relative rounding errors of V and H, whose sums over the modes cancel near zeros.
fn sum_rounding(system: &System<f64>, r: f64) -> f64 {
    let modal = system.modal();
    let direct = if modal.on_moving_base { 1.0 } else { 0.0 };
    let (mut v, mut v_size, mut h, mut h_size) = ([-direct, 0.0], direct, [0.0, 0.0], 0.0);
    let modes = modal.resonances.iter().zip(&modal.damping_ratios);
    for ((sigma, zeta), (load, contact)) in modes.zip(modal.loads.iter().zip(&modal.contacts)) {
        let (sigma, zeta) = (sigma.to_f64(), zeta.to_f64());
        let (load, contact) = (load.to_f64(), contact.to_f64());
        let (re, im) = ((sigma - r) * (sigma + r), 2.0 * zeta * sigma * r);
        let size = re.hypot(im);
        if size == 0.0 || contact == 0.0 {
            continue;
        }
        let inverse = [re / size / size, -im / size / size];
        for k in 0..2 {
            v[k] += load * contact * inverse[k];
            h[k] += contact * contact * inverse[k];
        }
        v_size += (load * contact).abs() / size;
        h_size += contact * contact / size;
    }
    let worse = (v_size / v[0].hypot(v[1])).max(h_size / h[0].hypot(h[1]));
    4.0 * f64::EPSILON * worse
}
