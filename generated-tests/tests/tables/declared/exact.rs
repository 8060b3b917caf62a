//! The exact answers at one frequency ratio, in double precision, and how far rounding moves them.

use frictiongen::System;
use frictiongen::study::SystemAt;
use frictiongen_kernel::Float;
use std::cell::OnceCell;
use std::f64::consts::PI;

/// Closer to a resonance a rounding of its place is more than an amplitude's accuracy.
const BESIDE: f64 = 1e-13;
/// Roundings of r.
const ROUNDINGS: f64 = 16.0;

/// Both limits, and a motion at a share of the smaller one.
pub struct Exact<'a> {
    system: &'a System<f64>,
    r: f64,
    share: f64,
    epsilon: f64,
    pub limits: [f64; 2],
    pub motion: Option<Motion>,
    noise: OnceCell<Noise>,
}

/// The contact's motion at a friction ratio below both limits.
pub struct Motion {
    pub beta: f64,
    /// Amplitude and phase; none where double precision finds no continuous motion.
    pub answer: Option<[f64; 2]>,
}

/// By how much answers may differ: r moved by some roundings, and the rounding of sums.
#[derive(Default)]
pub struct Noise {
    pub limits: [f64; 2],
    pub motion: [f64; 2],
    /// Whether β_lim is known to a tenth: within rounding of its zeros there is no motion to compare.
    pub known: bool,
}

/// An angle within a turn of zero, without its sign.
pub fn turn(angle: f64) -> f64 {
    (angle - (angle / (2.0 * PI)).round() * 2.0 * PI).abs()
}

impl<'a> Exact<'a> {
    /// None so close to a zero that the roundings of its place are more than 10⁻⁴ of the distance.
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
        // A point within rounding of a zero of a limit has no motion to compare.
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

    /// Evaluated where an answer is off without it: it costs another search.
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

/// Roundings of V and H over V and H: the sums over modes cancel beside zeros.
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
