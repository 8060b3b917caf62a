//! Response spectra: the largest displacement of damped oscillators whose base follows a recorded motion.

use super::drive::{BaseAcceleration, accelerations};
use super::{MeasureError, Recording};

/// Name of the recording's channel with the motion of the base.
const BASE: &str = "base";
/// Smallest number of time steps in a period of the oscillator. The code interpolates the displacement at an extreme
/// between two steps. The relative error of the extreme is below ((2π/40)²/8)²/2, about 5e-6.
const STEPS: f64 = 40.0;
/// Number of periods that [`periods`] returns in a decade.
const DECADE: f64 = 60.0;

/// Peak response of an oscillator to a recorded motion of its base.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PeakResponse {
    /// Undamped natural period of the oscillator, in s.
    pub period: f64,
    /// Largest displacement of the oscillator relative to its base during the record, in m.
    pub displacement: f64,
}

impl PeakResponse {
    /// Returns the undamped angular frequency of the oscillator, in rad/s.
    #[must_use]
    pub fn omega(&self) -> f64 {
        std::f64::consts::TAU / self.period
    }
}

/// Returns the natural periods of the oscillators for the response spectrum of a record, in s. The list has 60 periods
/// in a decade, from twice the time between two samples to the length of the record.
#[must_use]
pub fn periods(recording: &Recording) -> Vec<f64> {
    let shortest = 2.0 / recording.rate();
    let longest = recording.len().saturating_sub(1) as f64 / recording.rate();
    let count = (DECADE * (longest / shortest).log10()).ceil().max(0.0);
    let share = |index: usize| index as f64 / count.max(1.0);
    (0..=count as usize)
        .map(|index| shortest * (longest / shortest).powf(share(index)))
        .collect()
}

/// Returns the peak response of an oscillator for each period in `periods`, in s. The oscillator starts at rest and has
/// the damping ratio ζ, which must be less than 1. Its base follows the channel `base` of the recording.
///
/// # Errors
/// [`MeasureError`] if the recording has no channel `base`, if the unit of the channel is not that of a motion, or if the
/// samples are not evenly spaced.
pub fn response_spectrum(
    recording: &Recording,
    zeta: f64,
    periods: &[f64],
) -> Result<Vec<PeakResponse>, MeasureError> {
    let channel = recording.channel(BASE);
    let channel = channel.ok_or(MeasureError::NoDrive(BASE))?;
    let dt = 1.0 / recording.even_rate()?;
    let steps = accelerations(channel, dt)?;
    let peak = |period: &f64| PeakResponse {
        period: *period,
        displacement: Oscillator::new(std::f64::consts::TAU / period, zeta).peak(&steps, dt),
    };
    Ok(periods.iter().map(peak).collect())
}

/// An oscillator u″ + 2ζωu′ + ω²u = −a(t), where a(t) is the acceleration of its base.
#[derive(Clone, Copy, Debug)]
struct Oscillator {
    omega: f64,
    zeta: f64,
    /// Angular frequency of the oscillator's free damped vibration, in rad/s.
    damped: f64,
}

/// One time step of an oscillator, as a linear map. The state [u, u′] at the end of the step is the sum of two
/// products. The first is `state` times the state at the start. The second is `load` times the accelerations of the
/// base at start and end.
#[derive(Clone, Copy, Debug)]
struct OscillatorStep {
    state: [[f64; 2]; 2],
    load: [[f64; 2]; 2],
}

impl OscillatorStep {
    fn of(&self, [u, v]: [f64; 2], [a, b]: [f64; 2]) -> [f64; 2] {
        let [su, sv] = self.state;
        let [la, lb] = self.load;
        [0, 1].map(|row| {
            let at = |column: [f64; 2]| if row == 0 { column[0] } else { column[1] };
            at(su) * u + at(sv) * v + at(la) * a + at(lb) * b
        })
    }
}

impl Oscillator {
    fn new(omega: f64, zeta: f64) -> Self {
        Self {
            omega,
            zeta,
            damped: omega * (1.0 - zeta * zeta).sqrt(),
        }
    }

    /// Returns the state [u, u′] of the oscillator after a time t. During this time the acceleration of the base is a +
    /// s·t′, where t′ runs from 0 to t (Nigam and Jennings).
    fn moved(&self, [u, v]: [f64; 2], a: f64, s: f64, t: f64) -> [f64; 2] {
        let (omega, decay) = (self.omega, self.zeta * self.omega);
        let stiffness = omega * omega;
        // For the base acceleration a + st, the particular solution is the line −(a + st)/ω² + 2ζs/ω³.
        let slope = -s / stiffness;
        let line = |t: f64| slope * t - a / stiffness + 2.0 * self.zeta * s / (stiffness * omega);
        let first = u - line(0.0);
        let second = (v - slope + decay * first) / self.damped;
        let (sine, cosine) = (self.damped * t).sin_cos();
        let fading = (-decay * t).exp();
        let free = fading * (first * cosine + second * sine);
        let turned = fading * self.damped * (second * cosine - first * sine);
        [line(t) + free, slope + turned - decay * free]
    }

    fn step(&self, h: f64) -> OscillatorStep {
        OscillatorStep {
            state: [[1.0, 0.0], [0.0, 1.0]].map(|state| self.moved(state, 0.0, 0.0, h)),
            load: [
                self.moved([0.0; 2], 1.0, -1.0 / h, h),
                self.moved([0.0; 2], 0.0, 1.0 / h, h),
            ],
        }
    }

    /// Returns the largest |u| of the oscillator, in m, under the acceleration of the base in time steps of length `dt`.
    fn peak(&self, steps: &[BaseAcceleration], dt: f64) -> f64 {
        let parts = (STEPS * self.omega * dt / std::f64::consts::TAU)
            .ceil()
            .max(1.0);
        let h = dt / parts;
        let step = self.step(h);
        let mut state = [0.0; 2];
        let mut peak = 0.0_f64;
        for BaseAcceleration {
            jump,
            ends: [from, to],
        } in steps
        {
            let [u, v] = state;
            state = [u, v - jump];
            let slope = (to - from) / dt;
            let mut a = *from;
            for _ in 0..parts as usize {
                let next = step.of(state, [a, a + slope * h]);
                let [_, v] = state;
                let [u, w] = next;
                if v * w < 0.0 {
                    // The displacement has its extreme near the instant at which the straight line between the two
                    // velocities is zero.
                    let [turning, _] = self.moved(state, a, slope, h * v / (v - w));
                    peak = peak.max(turning.abs());
                }
                peak = peak.max(u.abs());
                state = next;
                a += slope * h;
            }
        }
        peak
    }
}

#[cfg(test)]
mod tests;
