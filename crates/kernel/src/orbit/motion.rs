//! Amplitude, phase, velocity, acceleration and harmonics of the steady motion of the contact or of a mass.

use super::gauss::{PANEL, SIXTEEN};
use super::rates;
use super::segments::Segments;
use super::types::{Orbit, SegmentStart};
use crate::combination::Combination;
use crate::contact::sums::Chain;
use crate::motion::{Contact, ContactChain, OscillatorSum, Part, lift, rotated};
use crate::number::complex::{self, Complex};
use crate::number::phase::{within_cycle, wrapped};
use crate::number::scalar::Float;

/// Largest relative difference at which two amplitudes are treated as equal, in rounding units of the number type.
const ROUNDINGS: f64 = 64.0;
/// Largest difference at which two lags are treated as equal, in rad. In `f32` the code uses the larger value of
/// [`ROUNDINGS`] rounding units instead.
const SAME_LAG: f64 = 1e-9;

/// The steady motion of the contact or of a mass, in an [`Orbit`] (a steady state).
#[derive(Debug)]
pub struct OrbitMotion<'o, 'a, S, P, V, C, K = Chain<S>> {
    orbit: &'o Orbit<'a, S, P, V, C, K>,
    /// Combination of masses and base whose motion this is, or `None` for the contact's relative motion.
    combination: Option<Combination<'o, S>>,
    /// True for the contact's relative motion with the opposite sign.
    reversed: bool,
}

impl<S: Copy, P, V, C, K> Clone for OrbitMotion<'_, '_, S, P, V, C, K> {
    fn clone(&self) -> Self {
        *self
    }
}
impl<S: Copy, P, V, C, K> Copy for OrbitMotion<'_, '_, S, P, V, C, K> {}

/// Largest number of panels into which the quadrature of a harmonic divides one segment.
const MOST_PANELS: f64 = (1_u32 << 14) as f64;

/// The largest absolute displacement |x̄| that a search has found so far, and the lag of this displacement.
struct LargestDisplacement<S> {
    value: S,
    lag: Option<S>,
}

impl<'o, 'a, S, P, V, C, K> OrbitMotion<'o, 'a, S, P, V, C, K>
where
    S: Float,
    P: AsRef<[Part<S>]> + Clone + AsMut<[Part<S>]>,
    V: AsRef<[S]> + AsMut<[S]>,
    C: AsRef<[Complex<S>]> + AsMut<[Complex<S>]>,
    K: ContactChain<S>,
{
    pub(super) fn of_contact(orbit: &'o Orbit<'a, S, P, V, C, K>) -> Self {
        Self {
            orbit,
            combination: None,
            reversed: false,
        }
    }

    pub(super) fn of_reversed_contact(orbit: &'o Orbit<'a, S, P, V, C, K>) -> Self {
        Self {
            reversed: true,
            ..Self::of_contact(orbit)
        }
    }

    pub(super) fn of_combination(
        orbit: &'o Orbit<'a, S, P, V, C, K>,
        combination: Combination<'o, S>,
    ) -> Self {
        Self {
            orbit,
            combination: Some(combination),
            reversed: false,
        }
    }

    /// Returns the amplitude and its lag, from one search. The amplitude is the largest |x̄| in a period, in units of
    /// P/k₁ (of the base amplitude Y for base motion). The lag is in rad, as [`phase`](Self::phase) defines it.
    pub fn largest(&self) -> (S, S) {
        let best = self.best();
        (best.value, best.lag.unwrap_or(S::constant(0.0)))
    }

    /// Returns the amplitude of the motion: the largest absolute displacement |x̄| in a period, in units of P/k₁ (of
    /// the base amplitude Y for base motion).
    pub fn amplitude(&self) -> S {
        self.best().value
    }

    /// Returns the lag of the motion's largest |x̄| behind the excitation's maximum, in rad, in (−π, π]. If x̄ is
    /// negative at its largest |x̄|, the function adds half a turn to the lag.
    ///
    /// If the contact stops at its largest displacement, the lag belongs to the beginning of the stop. If several
    /// maxima are equal, the function returns the lag of smallest size. If two lags of equal size have opposite signs,
    /// it returns the positive lag.
    pub fn phase(&self) -> S {
        self.best().lag.unwrap_or(S::constant(0.0))
    }

    /// Returns the lag of the motion's fundamental component behind the excitation, −arg X₁, in rad, in (−π, π].
    pub fn fundamental_phase(&self) -> S {
        let fundamental = self.harmonic(1);
        wrapped(-fundamental.im.atan2(fundamental.re))
    }

    /// Returns the displacement x̄ at the phase τ in rad, in units of P/k₁ (of the base amplitude Y for base motion).
    /// At τ = 0 the contact's relative displacement begins to decrease from its maximum.
    pub fn displacement(&self, tau: S) -> S {
        self.evaluate(tau, |sum, tau| sum.local(tau).value)
    }

    /// Returns the velocity dx̄/dτ at the phase τ in rad. At τ = 0 the contact's relative displacement begins to
    /// decrease from its maximum.
    pub fn velocity(&self, tau: S) -> S {
        self.evaluate(tau, |sum, tau| sum.local(tau).slope)
    }

    /// Returns the acceleration d²x̄/dτ² at the phase τ in rad. At τ = 0 the contact's relative displacement begins to
    /// decrease from its maximum. The acceleration jumps when the contact reverses, stops or breaks away. At a jump the
    /// function returns the value just after the jump.
    pub fn acceleration(&self, tau: S) -> S {
        self.evaluate(tau, |sum, tau| sum.local(tau).curve)
    }

    /// Returns the largest absolute velocity |dx̄/dτ| in a period of the motion, in units of P/k₁ (of the base
    /// amplitude Y for base motion).
    pub fn largest_velocity(&self) -> S {
        let mut largest = S::constant(0.0);
        self.each(|_, sum| largest = largest.max(rates::largest_slope(sum)));
        largest
    }

    /// Returns the largest absolute acceleration |d²x̄/dτ²| in a period of the motion, in units of P/k₁ (of the base
    /// amplitude Y for base motion). At a jump of the acceleration, the search includes the values on both sides.
    pub fn largest_acceleration(&self) -> S {
        let mut largest = S::constant(0.0);
        self.each(|_, sum| largest = largest.max(rates::largest_curve(sum)));
        largest
    }

    /// Returns the complex amplitude X_n of a harmonic. The harmonics are defined by x̄ = Re Σ X_n e^{inτ_e}, where the
    /// phase τ_e is 0 at a maximum of the excitation. X_0 is the mean of x̄.
    ///
    /// If a vibration has more than about 10⁴ periods within a segment, only the order of magnitude of the result is
    /// correct. A vibration has this many periods for large n, and in modes far above the excitation frequency.
    pub fn harmonic(&self, n: u32) -> Complex<S> {
        self.component(S::constant(f64::from(n)), n == 0, |mark| {
            mark.contact_state.t
        })
    }

    /// Returns the complex amplitude X of a subharmonic component, which has k oscillations in a period of the motion.
    /// The component adds Re X e^{ikτ_e/n} to x̄, where n is the [`period`](Orbit::period) in cycles of the
    /// excitation. If k is a multiple of n, the component is a [`harmonic`](Self::harmonic). The phase τ_e is 0 at the
    /// maximum of the excitation closest to τ = 0.
    pub fn subharmonic(&self, k: u32) -> Complex<S> {
        let order = S::constant(f64::from(k)) / self.orbit.cycles();
        self.component(order, k == 0, |mark| self.orbit.angle(mark))
    }

    /// Returns the complex amplitude of one component of the motion. `order` is the frequency of the component divided
    /// by the excitation frequency. The function `starts` returns the excitation's phase at the start of a segment, in
    /// half-turns (π rad).
    fn component(
        &self,
        order: S,
        mean: bool,
        starts: impl Fn(&SegmentStart<S>) -> S,
    ) -> Complex<S> {
        let (zero, half) = (S::constant(0.0), S::constant(0.5));
        let mut total = complex::real(zero);
        self.each(|mark, sum| {
            let turning = (sum.rate + order) * mark.length * S::constant(1.0 / PANEL);
            let most = S::constant(MOST_PANELS);
            let panels = -(-turning.max(S::constant(1.0)).min(most)).floor();
            let width = mark.length / panels;
            let from = starts(mark);
            let mut start = zero;
            let mut done = zero;
            while done < panels {
                // Each panel has a separate sum. In one long sum the rounding errors of all terms would add up.
                let mut panel = complex::real(zero);
                for (node, weight) in SIXTEEN {
                    for side in [-node, node] {
                        let tau = start + width * half * S::constant(1.0 + side);
                        let t = (from + tau * S::inverse_pi()) * order;
                        let (sine, cosine) = t.sin_cos_pi();
                        let value = sum.local(tau).value * S::constant(weight);
                        panel.re = panel.re + value * cosine;
                        panel.im = panel.im - value * sine;
                    }
                }
                total = complex::add(total, complex::scale(panel, width * half));
                start = start + width;
                done = done + S::constant(1.0);
            }
        });
        let factor = if mean { half } else { S::constant(1.0) };
        complex::scale(total, S::inverse_pi() * factor / self.orbit.cycles())
    }

    fn best(&self) -> LargestDisplacement<S> {
        let zero = S::constant(0.0);
        let mut best = LargestDisplacement {
            value: zero,
            lag: None,
        };
        if self.turns_at_events() {
            self.at_events(&mut best);
        } else {
            self.each(|mark, sum| {
                sum.peaks(best.value, |tau, value| {
                    best.note(mark.contact_state.t + tau * S::inverse_pi(), value);
                    best.value
                });
            });
        }
        best
    }

    /// Returns true if this motion is the contact's relative motion.
    pub(super) fn is_contact(&self) -> bool {
        self.combination.is_none()
    }

    /// Returns true if this motion is the relative motion of a rigid contact. The velocity of a rigid contact changes
    /// its sign only at events. The velocity of an elastic contact may also change its sign while the contact sticks.
    pub(super) fn turns_at_events(&self) -> bool {
        self.is_contact() && self.orbit.setting.dynamics.chain.remembered() == 0
    }

    /// Records the contact's relative motion at all events. At an event the velocity is zero and |z̄| may be largest.
    /// The function leaves out the end of a stop, because the displacement is the same at the beginning of the stop.
    fn at_events(&self, best: &mut LargestDisplacement<S>) {
        let (mut first, mut stuck) = (None, false);
        for mark in self.orbit.segments() {
            if first.is_none() {
                first = Some(mark);
            } else if !stuck {
                best.note(mark.contact_state.t, self.signed(mark.relative));
            }
            stuck = mark.contact_state.contact == Contact::Stuck;
        }
        match first {
            // The segment before the first segment is the last segment of the period. The code knows only after the
            // loop whether the contact sticks in that segment.
            Some(first) if !stuck => best.note(first.contact_state.t, self.signed(first.relative)),
            Some(first) if best.lag.is_none() => {
                best.value = first.relative.abs();
            }
            _ => {}
        }
    }

    /// Returns the smallest and the largest relative displacement z̄ in a period. The smallest and the largest
    /// displacement occur at events of the contact.
    pub(super) fn extremes_at_events(&self) -> (S, S) {
        let mut extremes: Option<(S, S)> = None;
        for mark in self.orbit.segments() {
            let (least, most) = extremes.unwrap_or((mark.relative, mark.relative));
            extremes = Some((least.min(mark.relative), most.max(mark.relative)));
        }
        let (least, most) = extremes.unwrap_or((S::constant(0.0), S::constant(0.0)));
        if self.reversed {
            (-most, -least)
        } else {
            (least, most)
        }
    }

    /// Returns true if the motion repeats with the opposite sign after half a period.
    pub(super) fn is_symmetric(&self) -> bool {
        self.orbit.symmetric
    }

    /// Returns `value` unchanged, or −`value` if this motion is the relative motion with the opposite sign.
    fn signed(&self, value: S) -> S {
        if self.reversed { -value } else { value }
    }

    fn evaluate(&self, tau: S, question: impl Fn(&OscillatorSum<'_, S>, S) -> S) -> S {
        let Some((mut segments, mark, since)) = Segments::at(self.orbit, tau) else {
            return S::constant(0.0);
        };
        question(&self.segment_sum(segments.parts(), &mark), since)
    }

    pub(super) fn each(&self, mut question: impl FnMut(&SegmentStart<S>, &OscillatorSum<'_, S>)) {
        let mut segments = self.orbit.segments();
        while let Some(mark) = segments.next() {
            let sum = self.segment_sum(segments.parts(), &mark);
            question(&mark, &sum);
        }
    }

    /// Returns the motion in one segment as a sum over oscillators. The oscillators must have their state at the start
    /// of the segment.
    fn segment_sum<'p>(
        &self,
        parts: &'p mut [Part<S>],
        mark: &SegmentStart<S>,
    ) -> OscillatorSum<'p, S> {
        let zero = S::constant(0.0);
        let (setting, contact_state, reach) =
            (&self.orbit.setting, &mark.contact_state, mark.length);
        let (modes, stuck_modes) = setting.split(parts);
        let driven = setting.dynamics.in_contact();
        let mut constant = zero;
        let base = self.combination.map(|combination| combination.base);
        let mut fundamental = complex::real(base.unwrap_or(self.signed(-setting.base)));
        let component = |index: usize| -> S {
            let contact = || {
                let mode = setting.dynamics.modes.get(index);
                mode.map(|mode| self.signed(mode.contact))
            };
            let component = match self.combination {
                Some(combination) => combination.shape.get(index).copied(),
                None => contact(),
            };
            component.unwrap_or(zero)
        };
        let sticks = contact_state.contact == Contact::Stuck;
        if sticks {
            let (_, offset) = setting.start_sticking(modes, stuck_modes, contact_state, reach);
            for (part, (_, participations)) in
                stuck_modes.iter_mut().zip(setting.dynamics.held_modes())
            {
                part.weight = [zero; 2];
                for (index, participation) in participations.iter().enumerate() {
                    for (weight, participation) in part.weight.iter_mut().zip(participation) {
                        *weight = *weight + component(index) * *participation;
                    }
                }
            }
            for (index, mode) in setting.dynamics.driven().iter().enumerate() {
                let lift = component(index) * lift(mode, setting.receptance);
                constant = constant + lift * offset;
                fundamental.re = fundamental.re + lift * setting.base;
            }
        } else {
            let _ = setting.start_sliding(modes, contact_state, reach);
            for (index, part) in modes.iter_mut().enumerate().take(driven) {
                part.weight = [component(index), zero];
                constant = constant + component(index) * part.centre;
            }
        }
        for (index, part) in modes.iter_mut().enumerate().skip(driven) {
            part.weight = [component(index), zero];
        }
        // The slice `parts` contains the modes that the contact drives, then the other modes of the chain, then the
        // modes of the chain with its contact stuck.
        let modes = setting.dynamics.modes.len();
        let range = if sticks {
            driven..parts.len()
        } else {
            0..modes
        };
        let parts = parts.get_mut(range).unwrap_or_default();
        for part in parts.iter_mut() {
            part.aim();
            fundamental = complex::add(fundamental, part.fundamental());
        }
        let at = contact_state.t.sin_cos_pi();
        let (sine, cosine) = at;
        let cosines = rotated(fundamental, sine, cosine);
        let sines = -(fundamental.re * sine) - fundamental.im * cosine;
        OscillatorSum::new(parts, constant, (cosines, sines), at, reach)
    }
}

impl<S: Float> LargestDisplacement<S> {
    /// Records a value at an instant `t`. The instant is the excitation's phase in half-turns (π rad).
    fn note(&mut self, t: S, value: S) {
        let (one, two) = (S::constant(1.0), S::constant(2.0));
        let near = S::constant(1.0 - ROUNDINGS * S::EPSILON);
        let size = value.abs();
        if size < self.value * near {
            return;
        }
        let t = if value < S::constant(0.0) { t + one } else { t };
        let t = within_cycle(t);
        let lag = if one < t { t - two } else { t } * S::pi();
        let clear = self.value < size * near;
        self.value = self.value.max(size);
        // The lags of equal maxima differ by rounding. If two lags have nearly equal size, the code uses the positive
        // lag.
        let same = S::constant(SAME_LAG.max(ROUNDINGS * S::EPSILON));
        let better = match self.lag {
            Some(known) if !clear => {
                let shorter = known.abs() - lag.abs();
                same < shorter || (shorter.abs() <= same && known < lag)
            }
            _ => true,
        };
        if better {
            self.lag = Some(lag);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::LargestDisplacement;

    /// Returns the recorded lags in half-turns (π rad) for two values, in both orders of the values.
    fn lags(values: [(f64, f64); 2]) -> [f64; 2] {
        let [first, second] = values;
        [[first, second], [second, first]].map(|values| {
            let mut best = LargestDisplacement {
                value: 0.0,
                lag: None,
            };
            for (t, value) in values {
                best.note(t, value);
            }
            best.lag.expect("a value was noted") / core::f64::consts::PI
        })
    }

    /// Checks the lag that is kept if two maxima are equal: the lag of smaller size. If both lags have the same size,
    /// the positive lag counts. Rounding must not decide.
    #[test]
    fn of_equal_maxima_the_positive_lag() {
        let [first, second] = lags([(0.3, 2.0), (1.7, 2.0 * (1.0 + 1e-15))]);
        assert!((first - 0.3).abs() < 1e-15 && (second - 0.3).abs() < 1e-15);
        // A negative value has its lag half a turn later.
        let [first, second] = lags([(0.3, 2.0), (0.7 + 1e-16, -2.0)]);
        assert!((first - 0.3).abs() < 1e-15 && (second - 0.3).abs() < 1e-15);
        let [first, second] = lags([(0.3, 2.0), (1.8, 2.0)]);
        assert!((first + 0.2).abs() < 1e-15 && (second + 0.2).abs() < 1e-15);
        let [first, second] = lags([(0.3, 2.0), (1.8, 1.999)]);
        assert!((first - 0.3).abs() < 1e-15 && (second - 0.3).abs() < 1e-15);
    }
}
