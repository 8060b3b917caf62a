//! A function of time between two events: a fundamental component at the excitation's frequency and a sum over
//! oscillators, with its derivatives and what the third of them cannot exceed.

use super::part::Part;
use super::walk::Walked;
use crate::number::scalar::Float;

/// A function about one instant.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Local<S> {
    pub value: S,
    pub slope: S,
    pub curve: S,
    /// What |f‴| cannot exceed from there on, over the reach.
    pub bound: S,
}

/// constant + cosine·cos τ + sine·sin τ + what is left of the parts.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sum<'a, S> {
    pub parts: &'a [Part<S>],
    pub constant: S,
    pub cosine: S,
    pub sine: S,
    /// Sine and cosine of the excitation's angle at the start.
    pub phase: (S, S),
    /// How far the function is asked for, in τ.
    pub reach: S,
    /// What rounding can do to a value.
    pub noise: S,
    /// The largest rate at which a derivative can exceed what it derives.
    pub(crate) rate: S,
    /// The bounds of the fundamental component and of the parts beside a resonance.
    bound: S,
}

impl<'a, S: Float> Sum<'a, S> {
    /// The parts are aimed already.
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
                // |y⁗|, |y‴| ≤ 4 + 4τ for |x − 1| ≪ 1 and a unit force.
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
            noise: noise * S::constant(4.0 * S::EPSILON),
            rate,
            bound,
        }
    }

    /// The function after τ.
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
            local.bound = local.bound + part.bound * turn.kept;
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

impl<S: Float> Walked<S> for Sum<'_, S> {
    #[inline]
    fn local(&self, tau: S) -> Local<S> {
        self.local(tau)
    }

    /// Value, slope and curve after τ, and the largest τ for which they hold to rounding.
    fn series(&self, value: S, slope: S) -> Series<S> {
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
        Series {
            terms,
            reach: S::constant(0.03) / self.rate,
        }
    }

    fn noise(&self) -> S {
        self.noise
    }

    fn reach(&self) -> S {
        self.reach
    }
}

/// How many derivatives a series has.
pub(crate) const ORDER: usize = 9;

/// A function by its derivatives at the start.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Series<S> {
    terms: [S; ORDER],
    /// Up to here what is left out is below rounding.
    pub reach: S,
}

impl<S: Float> Series<S> {
    /// From the derivatives at the start; beyond `reach` what is left out shows.
    pub(crate) fn new(terms: [S; ORDER], reach: S) -> Self {
        Self { terms, reach }
    }

    /// Value, slope and curve.
    pub(super) fn at(&self, tau: S, bound: S) -> Local<S> {
        // Written out: in a loop the reciprocals are double-precision divisions on the target.
        let [c0, c1, c2, c3, c4, c5, c6, c7, c8] = self.terms;
        let [h2, h3, h4, h5, h6, h7, h8] = [
            S::constant(1.0 / 2.0),
            S::constant(1.0 / 3.0),
            S::constant(1.0 / 4.0),
            S::constant(1.0 / 5.0),
            S::constant(1.0 / 6.0),
            S::constant(1.0 / 7.0),
            S::constant(1.0 / 8.0),
        ];
        let horner = |terms: &[(S, S)], last: S| {
            let terms = terms.iter();
            terms.fold(last, |sum, (term, factor)| *term + sum * tau * *factor)
        };
        let one = S::constant(1.0);
        let value = [
            (c7, h8),
            (c6, h7),
            (c5, h6),
            (c4, h5),
            (c3, h4),
            (c2, h3),
            (c1, h2),
            (c0, one),
        ];
        let slope = [
            (c7, h7),
            (c6, h6),
            (c5, h5),
            (c4, h4),
            (c3, h3),
            (c2, h2),
            (c1, one),
        ];
        let curve = [(c7, h6), (c6, h5), (c5, h4), (c4, h3), (c3, h2), (c2, one)];
        let value = horner(&value, c8);
        let slope = horner(&slope, c8);
        let curve = horner(&curve, c8);
        Local {
            value,
            slope,
            curve,
            bound,
        }
    }

    /// The derivative of this order at the start.
    pub(super) fn term(&self, order: usize) -> S {
        self.terms.get(order).copied().unwrap_or(S::constant(0.0))
    }
}
