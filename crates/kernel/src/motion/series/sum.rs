//! A function of time between two events, with its derivatives and a bound on its third derivative. The function is a
//! sum over oscillators, plus a component at the excitation frequency. The oscillators are the modes of the chain, or
//! the modes of the chain with its contact stuck.

use super::local::{Local, LocalSeries, ORDER, ROUNDINGS, SERIES_REACH, Walked};
use crate::motion::oscillator::Part;
use crate::number::scalar::Float;

/// The function constant + cosine·cos τ + sine·sin τ, plus the sum of the oscillators' free motions. Each oscillator
/// near its resonance adds a forced motion that grows from zero.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OscillatorSum<'a, S> {
    pub parts: &'a [Part<S>],
    pub constant: S,
    pub cosine: S,
    pub sine: S,
    /// Sine and cosine of the excitation's phase at the start of the searched interval.
    pub phase: (S, S),
    /// Length in τ of the interval in which a search examines the function.
    pub reach: S,
    /// Rounding error of one value of the function.
    pub noise: S,
    /// Rate of the fastest oscillator, in rad per rad of the excitation. A differentiation multiplies the size of the
    /// function by at most this rate.
    pub(crate) rate: S,
    /// Bound on the third derivative of the fundamental component and of the oscillators near a resonance.
    bound: S,
}

impl<'a, S: Float> OscillatorSum<'a, S> {
    /// Creates the sum over the oscillators `parts`. The caller must have prepared each oscillator with [`Part::aim`].
    pub(crate) fn new(
        parts: &'a [Part<S>],
        constant: S,
        (cosine, sine): (S, S),
        phase: (S, S),
        reach: S,
    ) -> Self {
        let (one, two, four) = (S::constant(1.0), S::constant(2.0), S::constant(4.0));
        let mut noise = constant.abs() + cosine.abs() + sine.abs();
        let mut rate = one;
        let mut bound = cosine.abs() + sine.abs();
        for part in parts {
            let [a, b] = part.value;
            noise = noise + a.abs() + b.abs();
            rate = rate.max(part.x * (one + part.zeta + part.zeta));
            if part.near {
                // For a unit force on an oscillator near its resonance, the absolute values of the displacement's third
                // and fourth derivatives are at most 4 + 4τ.
                let [of_y, of_u] = part.weight;
                let push = part.push() * (of_y.abs() + of_u.abs()) * two;
                bound = bound + push * (four + four * reach);
                noise = noise + push * (one + reach);
            }
        }
        Self {
            parts,
            constant,
            cosine,
            sine,
            phase,
            reach,
            noise: noise * S::constant(ROUNDINGS * S::EPSILON),
            rate,
            bound,
        }
    }

    /// Returns the value and the derivatives of the function at the time τ.
    #[inline]
    pub(crate) fn local(&self, tau: S) -> Local<S> {
        let t = tau * S::inverse_pi();
        let (sine, cosine) = t.sin_cos_pi();
        let turning = self.cosine * cosine + self.sine * sine;
        let mut local = Local {
            value: self.constant + turning,
            slope: self.sine * cosine - self.cosine * sine,
            curve: -turning,
            bound: self.bound,
        };
        for part in self.parts {
            let turn = part.turn(t, tau);
            let [a, b] = part.value;
            let value = a * turn.c + b * turn.s;
            let [a, b] = part.slope;
            let slope = a * turn.c + b * turn.s;
            local.value = local.value + value;
            local.slope = local.slope + slope;
            let loss = (part.zeta + part.zeta) * part.x;
            local.curve = local.curve - part.x * part.x * value - loss * slope;
            local.bound = local.bound + part.bound * turn.decay_factor;
            if part.near {
                let [value, slope, curve, third] = part.grown(t, self.phase);
                let [of_y, of_u] = part.weight;
                let of_u = of_u / part.x;
                local.value = local.value + of_y * value + of_u * slope;
                local.slope = local.slope + of_y * slope + of_u * curve;
                local.curve = local.curve + of_y * curve + of_u * third;
            }
        }
        local
    }
}

impl<S: Float> Walked<S> for OscillatorSum<'_, S> {
    #[inline]
    fn local(&self, tau: S) -> Local<S> {
        self.local(tau)
    }

    /// Returns the power series of the function from the start, with the given value and slope. The reach of the series
    /// is the largest τ at which the series is exact to rounding.
    fn series(&self, value: S, slope: S) -> LocalSeries<S> {
        let mut terms = [S::constant(0.0); ORDER];
        let (mut cosine, mut sine) = (self.cosine, self.sine);
        for (order, term) in terms.iter_mut().enumerate() {
            *term = if order == 0 {
                self.constant + cosine
            } else {
                cosine
            };
            (cosine, sine) = (sine, -cosine);
        }
        for part in self.parts {
            let mut pair = part.value;
            for term in &mut terms {
                *term = *term + pair[0];
                pair = part.derived(pair);
            }
            if part.near {
                part.grown_series(self.phase, &mut terms);
            }
        }
        let [first, second, ..] = &mut terms;
        (*first, *second) = (value, slope);
        LocalSeries::new(terms, S::constant(SERIES_REACH) / self.rate)
    }

    fn noise(&self) -> S {
        self.noise
    }

    fn reach(&self) -> S {
        self.reach
    }
}
