//! Den Hartog's motion with two stops a cycle: one mass, undamped, rubbing on a fixed wall, μ = 1
//! (2.5.1).  A special case of [`orbit`](crate::orbit), which it does not rest on.
//!
//! From x̄(0) = X, x̄′(0) = 0, x̄(τ₀) = −X, x̄′(τ₀) = 0 and X = β + cos φ (2.32), with
//! D = (sin τ₀ − r sin(τ₀/r))/(1 − r²) and E = (cos τ₀ − cos(τ₀/r))/(1 − r²), follows
//! (cos φ, sin φ) = ∓(E, −D)/√(D² + E²) and 2β = ±[D² + E² + E(1 + cos(τ₀/r))]/√(D² + E²):
//! β as a function of the sliding time τ₀, to be inverted.

use crate::number::scalar::{Float, Plain};
use crate::oscillator::decay::{Decay, Instant, Undamped};

/// The finest division of the half period in the search for τ₀.
const MOST_SAMPLES: u32 = 4096;

/// Den Hartog's two-stop motion: from τ = 0 the mass slides from X to −X within τ₀, sticks until
/// τ = π, and goes back in the same way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoStops<S> {
    r: S,
    x: S,
    amplitude: S,
    /// (cos φ, sin φ).
    phase: (S, S),
    slide: S,
}

/// D, E and cos(τ/r) at τ.
fn sides<S: Float>(r: S, x: S, tau: S) -> (S, S, S) {
    let (one, half) = (S::constant(1.0), S::constant(0.5));
    let at = Instant::new(tau * S::inverse_pi());
    let basis = Undamped.basis(x, &at);
    let detuning = (one - r) * (one + r);
    if detuning.is_zero() {
        // On the resonance both are the derivatives by r.
        let d = (at.sine - tau * at.cosine) * half;
        return (d, tau * at.sine * half, basis.slope);
    }
    let d = basis.swing / detuning;
    (d, basis.swing_slope / detuning, basis.slope)
}

/// ±2β for a sliding time, and √(D² + E²).
fn friction<S: Float>(r: S, x: S, tau: S) -> (S, S) {
    let (d, e, slope) = sides(r, x, tau);
    let size = (d * d + e * e).sqrt();
    (size + e / size * (S::constant(1.0) + slope), size)
}

impl<S: Float> TwoStops<S> {
    /// The motion at r and β; none where the mass does not move in this way, or r is not positive
    /// and finite.  Below r = 1/100 it may be overlooked.
    ///
    /// ```
    /// use frictiongen_kernel::two_stops::TwoStops;
    ///
    /// let motion = TwoStops::new(0.3_f64, 0.4).expect("two stops");
    /// assert!((motion.amplitude() - 0.8567297780578).abs() < 1e-12);
    /// assert!(TwoStops::new(0.9, 0.3).is_none(), "it never stops");
    /// ```
    #[must_use]
    pub fn new(r: S, beta: S) -> Option<Self>
    where
        S: Plain,
    {
        let zero = S::constant(0.0);
        if !(zero < r && r.is_finite() && zero < beta && beta.is_finite()) {
            return None;
        }
        let x = S::constant(1.0) / r;
        let excess = |tau: S| friction(r, x, tau).0.abs() - beta - beta;
        let mut samples: u32 = 256;
        while f64::from(samples) * r.to_f64() < 64.0 && samples < MOST_SAMPLES {
            samples *= 2;
        }
        let step = S::pi() / S::constant(f64::from(samples));
        let mut before = excess(step * S::constant(0.5));
        for index in 1..=samples {
            let end = step * S::constant(f64::from(index));
            let here = excess(end);
            if (before < zero) != (here < zero) {
                let slide = halved(excess, (end - step).max(step * S::constant(0.5)), end);
                let motion = Self::sliding_for(r, x, beta, slide);
                if motion.holds(beta) {
                    return Some(motion);
                }
            }
            before = here;
        }
        None
    }

    fn sliding_for(r: S, x: S, beta: S, slide: S) -> Self {
        let (d, e, _) = sides(r, x, slide);
        let (twice, size) = friction(r, x, slide);
        let sign = S::constant(-1.0).copysign(-twice) / size;
        let phase = (e * sign, -(d * sign));
        Self {
            r,
            x,
            amplitude: beta + phase.0,
            phase,
            slide,
        }
    }

    /// Whether the mass slides one way until τ₀, and is held from then on.
    fn holds(&self, beta: S) -> bool {
        let zero = S::constant(0.0);
        let samples = 256;
        let slides = (1..samples).all(|index| {
            let share = S::constant(f64::from(index) / f64::from(samples));
            self.velocity(self.slide * share) < zero
        });
        let grip = beta * S::constant(1.0 + 4096.0 * S::EPSILON);
        let held = |force: S| force.abs() <= grip;
        let force = |tau: S| self.amplitude + self.load(tau);
        // Where the load is ±P within the stop.
        let (cosine, sine) = self.phase;
        let ahead = sine.atan2(cosine);
        let inside = |tau: S| self.slide < tau && tau < S::pi();
        let turns = (-1..=2).all(|turn| {
            let tau = S::pi() * S::constant(f64::from(turn)) - ahead;
            !inside(tau) || held(force(tau))
        });
        slides && turns && held(force(self.slide)) && zero < self.amplitude
    }

    fn load(&self, tau: S) -> S {
        let (sine, cosine) = (tau * S::inverse_pi()).sin_cos_pi();
        let (cos_phi, sin_phi) = self.phase;
        cosine * cos_phi - sine * sin_phi
    }

    fn velocity(&self, tau: S) -> S {
        let (d, e, _) = sides(self.r, self.x, tau);
        let (cosine, sine) = self.phase;
        -(cosine * d + sine * e)
    }

    /// X = max|x̄|.
    #[must_use]
    pub fn amplitude(&self) -> S {
        self.amplitude
    }

    /// φ: the load is cos(τ + φ) where τ counts from the end of the upper stop.
    #[must_use]
    pub fn phase(&self) -> S {
        let (cosine, sine) = self.phase;
        sine.atan2(cosine)
    }

    /// τ₀, for how long the mass slides in each half cycle.
    #[must_use]
    pub fn slide(&self) -> S {
        self.slide
    }

    /// The part of the cycle for which it sticks, 1 − τ₀/π.
    #[must_use]
    pub fn stuck_fraction(&self) -> S {
        S::constant(1.0) - self.slide * S::inverse_pi()
    }
}

/// The zero of a function between two places where its signs differ.
fn halved<S: Float>(function: impl Fn(S) -> S, mut low: S, mut high: S) -> S {
    let zero = S::constant(0.0);
    let below = function(low) < zero;
    for _ in 0..128 {
        let middle = (low + high) * S::constant(0.5);
        if !(low < middle && middle < high) {
            break;
        }
        if (function(middle) < zero) == below {
            low = middle;
        } else {
            high = middle;
        }
    }
    (low + high) * S::constant(0.5)
}
