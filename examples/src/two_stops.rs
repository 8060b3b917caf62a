//! Computes Den Hartog's motion with two stops a cycle: one mass, undamped, rubbing on a fixed wall, μ = 1 (2.5.1). It
//! is a special case of an orbit, found here without the solver of orbits.
//!
//! The conditions are x̄(0) = X, x̄′(0) = 0, x̄(τ₀) = −X, x̄′(τ₀) = 0 and X = β + cos φ (2.32). With
//! D = (sin τ₀ − r sin(τ₀/r))/(1 − r²) and E = (cos τ₀ − cos(τ₀/r))/(1 − r²) they give
//! (cos φ, sin φ) = ∓(E, −D)/√(D² + E²) and 2β = ±[D² + E² + E(1 + cos(τ₀/r))]/√(D² + E²).
//! The program inverts this β, which is a function of the sliding time τ₀.

use frictiongen::kernel::oscillator::decay::{Decay, Instant, Undamped};
use frictiongen::scalar::Scalar;
use std::f64::consts::{FRAC_1_PI, PI};

/// Largest number of steps of the search for the sliding time τ₀ in half a period.
const MOST_SAMPLES: u32 = 4096;

/// Den Hartog's motion with two stops a cycle. From τ = 0 the mass slides from X to −X within τ₀, sticks until τ = π,
/// and returns in the same way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoStops {
    r: f64,
    x: f64,
    amplitude: f64,
    /// Cosine and sine of the phase φ of the load.
    phase: (f64, f64),
    slide: f64,
}

/// Returns D, E and cos(τ/r) at τ, as defined at the top of this file.
fn sides(r: f64, x: f64, tau: f64) -> (f64, f64, f64) {
    let at = Instant::new(tau * FRAC_1_PI);
    let basis = Undamped.basis(x, &at);
    let detuning = (1.0 - r) * (1.0 + r);
    if detuning == 0.0 {
        // At the resonance D and E are derivatives with respect to r.
        let d = (at.sine - tau * at.cosine) * 0.5;
        return (d, tau * at.sine * 0.5, basis.slope);
    }
    let d = basis.forced / detuning;
    (d, basis.forced_slope / detuning, basis.slope)
}

/// Returns ±2β for the sliding time τ₀ = `tau`, and √(D² + E²).
fn friction(r: f64, x: f64, tau: f64) -> (f64, f64) {
    let (d, e, slope) = sides(r, x, tau);
    let size = (d * d + e * e).sqrt();
    (size + e / size * (1.0 + slope), size)
}

impl TwoStops {
    /// Finds the motion with two stops at r and β. `None` if the mass does not move in this way, or if r is not
    /// positive and finite. Below r = 1/100 the search may miss the motion.
    ///
    /// ```
    /// use frictiongen_examples::two_stops::TwoStops;
    ///
    /// let motion = TwoStops::new(0.3, 0.4).expect("two stops");
    /// assert!((motion.amplitude() - 0.8567297780578).abs() < 1e-12);
    /// assert!(TwoStops::new(0.9, 0.3).is_none(), "it never stops");
    /// ```
    #[must_use]
    pub fn new(r: f64, beta: f64) -> Option<Self> {
        if !(0.0 < r && r.is_finite() && 0.0 < beta && beta.is_finite()) {
            return None;
        }
        let x = 1.0 / r;
        let excess = |tau: f64| friction(r, x, tau).0.abs() - beta - beta;
        let mut samples: u32 = 256;
        while f64::from(samples) * r < 64.0 && samples < MOST_SAMPLES {
            samples *= 2;
        }
        let step = PI / f64::from(samples);
        let mut before = excess(step * 0.5);
        for index in 1..=samples {
            let end = step * f64::from(index);
            let here = excess(end);
            if (before < 0.0) != (here < 0.0) {
                let slide = halved(excess, (end - step).max(step * 0.5), end);
                let motion = Self::sliding_for(r, x, beta, slide);
                if motion.holds(beta) {
                    return Some(motion);
                }
            }
            before = here;
        }
        None
    }

    fn sliding_for(r: f64, x: f64, beta: f64, slide: f64) -> Self {
        let (d, e, _) = sides(r, x, slide);
        let (twice, size) = friction(r, x, slide);
        let sign = 1.0_f64.copysign(-twice) / size;
        let phase = (e * sign, -(d * sign));
        Self {
            r,
            x,
            amplitude: beta + phase.0,
            phase,
            slide,
        }
    }

    /// Returns true if the mass slides in one direction until τ₀ and then sticks, at the friction ratio β.
    fn holds(&self, beta: f64) -> bool {
        let samples = 256;
        let slides = (1..samples).all(|index| {
            let share = f64::from(index) / f64::from(samples);
            self.velocity(self.slide * share) < 0.0
        });
        let grip = beta * (1.0 + 4096.0 * f64::EPSILON);
        let held = |force: f64| force.abs() <= grip;
        let force = |tau: f64| self.amplitude + self.load(tau);
        // At these instants of the stop the load is ±P, so the contact force is extreme.
        let ahead = self.phase();
        let inside = |tau: f64| self.slide < tau && tau < PI;
        let turns = (-1..=2).all(|turn| {
            let tau = PI * f64::from(turn) - ahead;
            !inside(tau) || held(force(tau))
        });
        slides && turns && held(force(self.slide)) && 0.0 < self.amplitude
    }

    fn load(&self, tau: f64) -> f64 {
        let (sine, cosine) = (tau * FRAC_1_PI).sin_cos_pi();
        let (cos_phi, sin_phi) = self.phase;
        cosine * cos_phi - sine * sin_phi
    }

    fn velocity(&self, tau: f64) -> f64 {
        let (d, e, _) = sides(self.r, self.x, tau);
        let (cosine, sine) = self.phase;
        -(cosine * d + sine * e)
    }

    /// Returns the amplitude X = max|x̄|.
    #[must_use]
    pub fn amplitude(&self) -> f64 {
        self.amplitude
    }

    /// Returns the phase φ. The load is cos(τ + φ), where τ counts from the end of the upper stop.
    #[must_use]
    pub fn phase(&self) -> f64 {
        let (cosine, sine) = self.phase;
        sine.atan2(cosine)
    }

    /// Returns the fraction of the cycle in which the mass sticks, 1 − τ₀/π.
    #[must_use]
    pub fn stuck_fraction(&self) -> f64 {
        1.0 - self.slide * FRAC_1_PI
    }
}

/// Finds the zero of a function by bisection between two arguments, at which its values have different signs.
fn halved(function: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let below = function(low) < 0.0;
    for _ in 0..128 {
        let middle = (low + high) * 0.5;
        if !(low < middle && middle < high) {
            break;
        }
        if (function(middle) < 0.0) == below {
            low = middle;
        } else {
            high = middle;
        }
    }
    (low + high) * 0.5
}
