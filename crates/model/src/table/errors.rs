//! Errors of a polynomial piece of a table, divided by the errors that the request allows.

use super::digits::above;
use super::exact::{ANGLE, Exact, SIZE};
use super::fit::{FitSettings, Fitted};
use super::split::{Landmarks, LimitZero};
use frictiongen_kernel::Float;
use frictiongen_kernel::table::{ContactTable, Quotient};
use std::f64::consts::PI;

/// Ratios β/β_lim at which the amplitude and the phase of the contact are compared with the exact values.
pub const FRICTION_SHARES: [f64; 7] = [0.05, 0.3, 0.6, 0.8, 0.9, 0.95, 0.98];
/// The largest ratio in [`FRICTION_SHARES`].
pub const MOST_SHARE: f64 = {
    let [.., largest] = FRICTION_SHARES;
    largest
};
/// Change of r, in rounding units, whose effect is allowed near a zero of β_lim. It covers the rounding of r in the
/// computation of an exact value.
const ROUNDINGS: f64 = 4.0;

/// Exact values with which the polynomial pieces of a table are compared, and the errors that a piece may have.
pub(super) struct Comparison<'a, 'm, S> {
    pub exact: &'a mut Exact<'m>,
    pub landmarks: Landmarks,
    pub form: FitSettings,
    /// Largest allowed deviation of the polynomial from `side_factor`·β_lim, as a fraction of β_lim.
    pub limit: f64,
    /// Largest allowed error of the contact's amplitude (relative) and phase (rad).
    pub motion: f64,
    /// |V|, the amplitude of the contact without friction, as a product over zeros and poles. Without damping, V is
    /// real, and the product gives V with its sign. `None` if the motion of the contact is not needed, or if the table
    /// has polynomials for |V|.
    pub excitation: Option<Quotient<'a, S>>,
}

impl<S: Float> Comparison<'_, '_, S> {
    /// Returns the zero of β_lim at the origin of a polynomial piece. Returns `None` if the origin is not a zero.
    pub fn zero_of(&self, piece: &Fitted<S>) -> Option<LimitZero> {
        let to = |at: f64| S::constant(at).to_f64();
        self.landmarks.zero_at(piece.origin.to_f64(), to)
    }

    /// Returns the largest error of a polynomial piece, divided by the allowed error.
    pub fn error(
        &mut self,
        piece: &Fitted<S>,
        (low, high): (f64, f64),
        zero: Option<LimitZero>,
    ) -> f64 {
        let points = 2 * self.form.terms + 3;
        let step = (high - low) / (points - 1) as f64;
        let mut worst = 0.0_f64;
        for k in 0..points {
            let r = if k + 1 < points {
                low + step * k as f64
            } else {
                high
            };
            worst = worst.max(self.error_within(piece, r, (low, high), zero));
        }
        if worst > 1.0 {
            return worst;
        }
        let mut place = self.landmarks.closely.partition_point(|r| *r < low);
        while let Some(r) = self
            .landmarks
            .closely
            .get(place)
            .copied()
            .filter(|r| *r <= high)
        {
            worst = worst.max(self.error_within(piece, r, (low, high), zero));
            place += 1;
        }
        worst
    }

    /// Returns the error of a polynomial piece, divided by the allowed error. The error is that at the number of the
    /// type `S` within the piece that is nearest to r. Returns 0 if the piece contains no number of the type `S`.
    fn error_within(
        &mut self,
        piece: &Fitted<S>,
        r: f64,
        (low, high): (f64, f64),
        zero: Option<LimitZero>,
    ) -> f64 {
        // The nearest number of the type may lie outside the piece.
        let rounded = |r: f64| S::constant(r).to_f64();
        let own = match rounded(r) {
            own if own < low => above::<S>(low).to_f64(),
            own if own > high => -above::<S>(-high).to_f64(),
            own => own,
        };
        let beyond = zero.is_some_and(|zero| {
            let side = zero.distance(0.5 * (low + high));
            side * zero.distance(own) < 0.0
        });
        if beyond || own < low || high < own {
            0.0
        } else {
            self.error_at(piece, own)
        }
    }

    /// Returns the error of a polynomial piece at r, divided by the allowed error. The change of the exact value if r
    /// changes by a few rounding units does not count as an error.
    pub fn error_at(&mut self, piece: &Fitted<S>, r: f64) -> f64 {
        let own = S::constant(r);
        let r = own.to_f64();
        let of_limit = self.limit_error(piece, own);
        if !(of_limit <= 1.0) || self.form.functions == 1 {
            return or_infinite(of_limit);
        }
        let of_motion = self.motion_error(&self.answer(piece, own), r);
        of_limit.max(or_infinite(of_motion))
    }

    /// Returns r increased by `ROUNDINGS` rounding units, and r decreased by as many units.
    fn beside(r: f64) -> [f64; 2] {
        [1.0, -1.0].map(|side| r * (1.0 + side * ROUNDINGS * f64::EPSILON))
    }

    /// Returns the error of β_lim from a polynomial piece, divided by the allowed error.
    fn limit_error(&mut self, piece: &Fitted<S>, own: S) -> f64 {
        let r = own.to_f64();
        let Some(limit) = self.exact.at(r).map(|sample| sample.limit) else {
            return f64::INFINITY;
        };
        let off = (piece.value(0, own).to_f64() - self.form.side_factor * limit).abs();
        let plain = off / (self.limit * limit);
        if plain <= 1.0 {
            return plain;
        }
        // At a zero of β_lim, the allowed error is only the effect of a change of r by a few rounding units.
        let allowed = self.limit * limit + self.limit_noise(limit, r);
        if off <= allowed { 0.0 } else { off / allowed }
    }

    /// Returns the largest change of β_lim if r changes by `ROUNDINGS` rounding units.
    fn limit_noise(&mut self, limit: f64, r: f64) -> f64 {
        let near = Self::beside(r).map(|r| self.exact.at(r).map(|sample| sample.limit));
        let moved = near.into_iter().flatten();
        moved.map(|near| (near - limit).abs()).fold(0.0, f64::max)
    }

    /// Returns the largest error of the contact's amplitude and phase from a table, divided by the allowed error.
    fn motion_error(&mut self, answer: &ContactTable<S>, r: f64) -> f64 {
        let Some(sample) = self.exact.at(r) else {
            return f64::INFINITY;
        };
        let exact = self.exact.contact(&sample, r);
        // At a zero of β_lim and at an undamped resonance, the motion has no finite value to compare.
        if !(exact.limit > 0.0 && exact.excitation.is_finite()) {
            return 0.0;
        }
        let allowed = self.motion;
        let over = |off: &[f64; APART], noise: &[f64; APART]| {
            let parts = off
                .iter()
                .zip(noise)
                .map(|(off, noise)| off / (allowed + noise));
            parts.map(or_infinite).fold(0.0, f64::max)
        };
        let off = apart(answer, &exact);
        let plain = over(&off, &[0.0; APART]);
        if plain <= 1.0 {
            return plain;
        }
        // A change of r by a few rounding units changes β_lim and, by the same relative amount, the ratio β/β_lim.
        let mut noise = [self.limit_noise(exact.limit, r) / exact.limit; APART];
        for r in Self::beside(r) {
            let Some(moved) = self.exact.at(r) else {
                continue;
            };
            let moved = self.exact.contact(&moved, r);
            for (noise, moved) in noise.iter_mut().zip(apart(&moved, &exact)) {
                *noise = noise.max(moved);
            }
        }
        over(&off, &noise)
    }

    /// Returns the values of the contact at r that a polynomial piece and the product for |V| give: β_lim, a =
    /// β_lim·U/|V|, g = β_lim·G/|V|, arg V and |V|. V is the response of the contact to the load. U and G are the
    /// velocity and displacement of the contact that friction causes at a reversal.
    fn answer(&self, piece: &Fitted<S>, r: S) -> ContactTable<S> {
        let [limit, quadrature, displacement, direction] =
            [0, 1, 2, ANGLE].map(|function| piece.value(function, r));
        let one = S::constant(1.0);
        let excitation = self.excitation.map_or(one, |quotient| quotient.value(r));
        if self.form.functions > SIZE {
            let excitation = piece.value(SIZE, r);
            ContactTable::tabled([limit, quadrature, displacement, direction, excitation])
        } else if self.form.functions > ANGLE {
            ContactTable::damped([limit, quadrature, displacement, direction], excitation)
        } else {
            ContactTable::undamped([limit, quadrature], excitation)
        }
    }
}

/// Replaces NaN by infinity, so that NaN counts as a large error.
pub(super) fn or_infinite(error: f64) -> f64 {
    if error.is_nan() { f64::INFINITY } else { error }
}

/// Number of compared values: an amplitude and a phase of the contact for each ratio β/β_lim in `FRICTION_SHARES`.
const APART: usize = 2 * FRICTION_SHARES.len();

/// Returns the errors of the contact's amplitudes (relative), then those of its phases (rad), at all ratios in
/// `FRICTION_SHARES`.
fn apart<T: Float>(answer: &ContactTable<T>, exact: &ContactTable<f64>) -> [f64; APART] {
    let mut apart = [0.0; APART];
    let (amplitudes, phases) = apart.split_at_mut(FRICTION_SHARES.len());
    for ((share, amplitude), phase) in FRICTION_SHARES.iter().zip(amplitudes).zip(phases) {
        let beta = T::constant(share * exact.limit);
        let expected = exact.amplitude(beta.to_f64());
        // A table gives the motion only up to the β_lim of the table.
        let own = beta.min(answer.limit);
        *amplitude = (answer.amplitude(own).to_f64() - expected).abs() / expected;
        let turned = answer.phase(own).to_f64() - exact.phase(beta.to_f64());
        *phase = (turned - (turned / (2.0 * PI)).round() * 2.0 * PI).abs();
    }
    apart
}
