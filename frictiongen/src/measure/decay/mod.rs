//! Finds friction and damping from a free vibration of one mass (thesis 4.3.2).
//!
//! A mass that is released oscillates about one point while it moves up, and about another point while it moves down,
//! because friction changes its direction. The distance between the two points is 2F/k. The extremes decrease by 4F/k
//! in a cycle (4.2). With viscous damping, the distance of the mass from the point of a half cycle also shrinks in
//! this half cycle, by the factor e^{−πζ/√(1−ζ²)} (Feeny and Liang, J. Sound Vib. 195 (1996) 149).
//!
//! The extremes give a first guess of the parameters. The code then fits the parameters to all samples between the
//! first and the last extreme, because noise makes a single peak appear too high.

mod fit;
mod swings;

use super::identify::Estimate;
use super::recording::Dimension;
use super::{MeasureError, Recording};
use crate::OutOfDomain;
use crate::study::System;
use crate::study::scene::Damping;
use fit::DecayFit;
use std::f64::consts::PI;
use swings::{Swings, noise};

/// Largest decrease in a half cycle that is treated as a rounding error, divided by the largest swing (distance from
/// one extreme to the next).
const ROUNDING: f64 = 1e-9;

/// Friction, damping and natural frequency found in a free vibration.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeDecay {
    /// Friction force F in the contact, in N.
    pub friction: Estimate,
    /// Friction force F divided by the stiffness k, in m. It is half the distance between the two points about which
    /// the mass oscillates.
    pub length: Estimate,
    /// Damping ratio ζ of the mass. Its interval is a single point if ζ was given.
    pub damping: Estimate,
    /// Undamped natural frequency of the vibrating mass, in Hz.
    pub hertz: Estimate,
    /// Friction force F divided by the stiffness k, in m, by the linear decrement. It is the mean of (x⁽¹⁾ − x⁽²⁾)/4
    /// over the extremes, where x⁽¹⁾ and x⁽²⁾ are extremes one cycle apart (4.2).
    pub linear_decrement: f64,
    /// The extremes that the fit has used. Each pair is the time from the first sample, in s, and the displacement, in
    /// m.
    pub extremes: Vec<(f64, f64)>,
    /// Standard deviation of the fit's residuals, divided by the standard deviation of the recording's noise. If this
    /// quotient is far above 1, the model does not describe the motion of the mass.
    pub misfit: f64,
}

impl FreeDecay {
    /// Returns the friction ratio β = F/(k₁Y) for a base motion of amplitude Y = `amplitude`, in m (4.3).
    #[must_use]
    pub fn friction_ratio(&self, amplitude: f64) -> f64 {
        self.length.value / amplitude
    }
}

impl System {
    /// Returns the damping ratio ζ of the first mode, if the description gives damping ratios. The caller can pass
    /// this ratio as the known damping to [`free_decay`](Self::free_decay).
    #[must_use]
    pub fn described_damping(&self) -> Option<f64> {
        match &self.scene().damping {
            Damping::Uniform(ratio) => Some(*ratio),
            Damping::Modal(ratios) => ratios.first().copied(),
            _ => None,
        }
    }

    /// Finds friction, damping and natural frequency from a free vibration of a scene with one mass.
    ///
    /// `damping` is the damping ratio ζ if it is known. If `damping` is `None`, the call fits ζ together with the other
    /// unknowns.
    ///
    /// ```
    /// use frictiongen::measure::{Channel, Recording, Unit};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let plate: frictiongen::System = "struct Plate {
    ///     masses: { plate: 2.0 }, springs: { base - plate: 752.0 }, contact: plate - wall, excitation: base,
    /// }"
    /// .parse()?;
    /// // From 20 mm, about ±0.5 mm, at 3 Hz: 2 mm less each cycle.
    /// let at = |t: f64| {
    ///     let half = (6.0 * t).floor();
    ///     let side = if half % 2.0 == 0.0 { 1.0 } else { -1.0 };
    ///     side * (0.5 + (19.5 - half) * (std::f64::consts::PI * (6.0 * t - half)).cos())
    /// };
    /// let samples = (0..2500).map(|i| at(f64::from(i) / 1000.0)).collect();
    /// let channel = Channel { name: "plate".into(), unit: Unit::MILLIMETRE, samples };
    /// let found = plate.free_decay(&Recording::new(1000.0, vec![channel])?, None)?;
    /// assert!((found.length.value - 0.5e-3).abs() < 1e-9 && (found.hertz.value - 3.0).abs() < 1e-6);
    /// assert!((found.friction.value - 0.5e-3 * 752.0).abs() < 1e-6);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`MeasureError`] for more than one mass, for an elastic contact, and for a channel that is not the displacement
    /// of the mass. [`MeasureError`] also for too few extremes above the noise, and for extremes that do not decrease.
    pub fn free_decay(
        &self,
        recording: &Recording,
        damping: Option<f64>,
    ) -> Result<FreeDecay, MeasureError> {
        self.single().map_err(OutOfDomain::from)?;
        let scene = self.scene();
        if scene.stiffness.is_some() {
            return Err(MeasureError::Asked(
                "a free vibration gives the friction force only of a rigid contact, but this scene has `stiffness`; identify the force from steady recordings, or leave `stiffness` out",
            ));
        }
        let [mass] = scene.masses.as_slice() else {
            return Err(MeasureError::Asked(
                "a free decay gives the friction force only for a scene with one mass, because several masses beat (thesis 6.4.2)",
            ));
        };
        let stiffness: f64 = scene.springs.iter().map(|spring| spring.stiffness).sum();
        let channel = recording.channel(&mass.name).ok_or(MeasureError::NoMass)?;
        if channel.unit.dimension() != Dimension::Displacement {
            return Err(MeasureError::WrongDimension {
                channel: channel.name.clone(),
                unit: channel.unit.name(),
                needed: Dimension::Displacement.needed(),
            });
        }
        let scale = channel.unit.scale();
        let samples: Vec<f64> = channel.samples.iter().map(|value| value * scale).collect();
        of(&samples, recording.even_rate()?, stiffness, damping)
    }
}

fn of(
    samples: &[f64],
    rate: f64,
    stiffness: f64,
    damping: Option<f64>,
) -> Result<FreeDecay, MeasureError> {
    let noise = noise(samples);
    let swings = Swings::of(samples, noise)?;
    let fit = DecayFit::new(samples, &swings, damping)?.solved()?;
    // The sampled extremes may seem to decrease, although the true extremes between the samples do not. The fitted
    // parameters decide.
    if !(ROUNDING < fit.length.0 / swings.largest + fit.decrement.0) {
        return Err(MeasureError::NoDecay);
    }
    let ratio = |decrement: f64| decrement / PI.hypot(decrement);
    let undamped = |half: f64| rate / (2.0 * half) / (1.0 - ratio(fit.decrement.0).powi(2)).sqrt();
    Ok(FreeDecay {
        friction: between(fit.length, &|length| length * stiffness),
        length: between(fit.length, &|length| length),
        damping: between(fit.decrement, &ratio),
        hertz: between(fit.half, &undamped),
        linear_decrement: swings.linear_decrement,
        extremes: swings
            .turns
            .iter()
            .map(|(place, value)| (*place as f64 / rate, *value))
            .collect(),
        misfit: fit.deviation / noise.max(f64::MIN_POSITIVE),
    })
}

/// Returns the estimate of a quantity that is a monotone function `of` a fitted parameter. The pair contains the value
/// of the parameter and the half width of its confidence interval.
fn between((value, reach): (f64, f64), of: &dyn Fn(f64) -> f64) -> Estimate {
    let (a, b) = if reach.is_finite() {
        (of(value - reach), of(value + reach))
    } else {
        (f64::NEG_INFINITY, f64::INFINITY)
    };
    Estimate {
        value: of(value),
        from: a.min(b),
        to: a.max(b),
    }
}
