//! Limits β_lim and β*_lim of an undamped chain for a run-time `System`, without the search for the velocity constraint
//! S. The code copies the constants of the modes once into packed arrays, and uses these arrays at every frequency.

use crate::contact::regime::Limits;
use crate::contact::sums::{Chain, ContactAt};
use crate::number::complex;
use crate::number::lanes::Lanes;
use crate::number::scalar::{Float, Scalar};
use crate::oscillator::mode::Mode;

/// Largest number of pairs of modes in [`DrivenModes`]. If the contact drives more modes, the chain uses
/// [`pairs`](crate::contact::pairs) instead.
const PAIRS: usize = 8;

/// Constants of one mode, or of a pair of modes. The code computes the modal sums V, H and U of the contact from these
/// constants.
#[derive(Clone, Copy, Debug)]
struct DrivenConstants<S> {
    resonance: S,
    /// Residue (φᵀw)(φᵀp) of the mode in the response V to the load. On a moving base it is the static residue
    /// (φᵀw)(φᵀp)/λ.
    load: S,
    contact_squared: S,
}

/// Two numbers of a mode at one frequency: x² − 1, where x = √λ/r = 1/R, and the damping function u. The code stores u
/// multiplied by R² and by |x² − 1|. The stored u does not yet contain the scale E of the chain.
type Own<S> = [S; 2];

/// Terms of a mode in V (response to the load), H (receptance) and U (damping function) of the contact, in this order.
type LimitTerms<S> = [S; 3];

/// Constants of those modes of an undamped chain that the contact drives, in the order of the chain. Two modes are
/// stored as a pair. If the number of modes is odd, the last mode is stored separately.
#[derive(Clone, Debug)]
pub struct DrivenModes<S> {
    pairs: [DrivenConstants<Lanes<S>>; PAIRS],
    count: usize,
    one: Option<DrivenConstants<S>>,
}

impl<S: Scalar> DrivenConstants<S> {
    fn none() -> Self {
        let zero = S::constant(0.0);
        Self {
            resonance: zero,
            load: zero,
            contact_squared: zero,
        }
    }

    /// Returns x² − 1 and the damping function u of the mode at 1/r, where x = √λ/r.
    #[inline(always)]
    fn own(&self, inverse_r: S) -> Own<S> {
        let response = Mode::undamped(self.resonance * inverse_r);
        [response.denominator.re, response.u]
    }

    /// Returns the terms of the mode in the modal sums V, H and U, multiplied by the scale E of [`ContactAt`].
    #[inline(always)]
    fn terms(&self, scale: S, [detuning, u]: Own<S>) -> LimitTerms<S> {
        let response = scale / detuning;
        [
            response * self.load,
            response * self.contact_squared,
            self.contact_squared * (u * response.abs()),
        ]
    }
}

impl<S: Float> DrivenConstants<Lanes<S>> {
    fn beside(modes: [DrivenConstants<S>; 2]) -> Self {
        let of = |constant: fn(DrivenConstants<S>) -> S| Lanes(modes.map(constant));
        Self {
            resonance: of(|mode| mode.resonance),
            load: of(|mode| mode.load),
            contact_squared: of(|mode| mode.contact_squared),
        }
    }
}

impl<S: Float> DrivenModes<S> {
    /// Gathers the constants of those modes of a chain that the contact drives. Returns `None` if the chain is damped,
    /// or if the contact drives no mode or more than 16. The result is also `None` for a scalar type of which no
    /// processor computes two numbers at the same time.
    #[must_use]
    pub fn of(chain: &Chain<S>, modes: &[Mode<S>]) -> Option<Self> {
        let in_contact = modes.iter().filter(|mode| mode.in_contact);
        let count = in_contact.clone().count();
        if chain.damped || !S::PAIRS || count == 0 || count > 2 * PAIRS {
            return None;
        }
        let mut driven = in_contact.map(|mode| DrivenConstants {
            resonance: mode.resonance,
            load: if chain.on_moving_base.is_some() {
                mode.static_residue
            } else {
                mode.residue
            },
            contact_squared: mode.contact_squared,
        });
        let mut found = Self {
            pairs: [DrivenConstants::none(); PAIRS],
            count: 0,
            one: None,
        };
        for pair in &mut found.pairs {
            match (driven.next(), driven.next()) {
                (Some(first), Some(second)) => {
                    *pair = DrivenConstants::beside([first, second]);
                    found.count += 1;
                }
                (one, _) => {
                    found.one = one;
                    break;
                }
            }
        }
        Some(found)
    }

    #[inline(always)]
    fn pairs(&self) -> &[DrivenConstants<Lanes<S>>] {
        self.pairs.get(..self.count).unwrap_or_default()
    }

    /// Returns the scale E of [`ContactAt`], and the modal sums V, H and U over all modes.
    #[inline(always)]
    fn sums(&self, inverse_r: S) -> (S, LimitTerms<S>) {
        match (self.pairs(), &self.one) {
            ([], Some(only)) => {
                // With a single mode, the scale E is |x² − 1| of this mode. Then E/(x² − 1) is exactly 1 or −1.
                let [detuning, u] = only.own(inverse_r);
                let sign = S::constant(1.0).copysign(detuning);
                let terms = [
                    sign * only.load,
                    sign * only.contact_squared,
                    only.contact_squared * u,
                ];
                (detuning.abs(), terms)
            }
            ([two], None) => {
                let mut terms = [[S::constant(0.0); 2]; 3];
                let scale = of_two(two, inverse_r, &mut terms);
                (scale, terms.map(|[first, second]| first + second))
            }
            _ => self.sums_of_many(inverse_r),
        }
    }

    #[inline(always)]
    fn sums_of_many(&self, inverse_r: S) -> (S, LimitTerms<S>) {
        let zero = S::constant(0.0);
        let (pairs, one) = (self.pairs(), self.one.as_ref());
        // The arrays store the numbers so that the compiler uses packed instructions.
        let mut own = [[Lanes::constant(0.0); 2]; PAIRS];
        let mut own_of_one = [zero; 2];
        let mut least = Lanes::constant(f64::INFINITY);
        for (pair, own) in pairs.iter().zip(&mut own) {
            *own = pair.own(Lanes::all(inverse_r));
            least = least.min(own[0].abs());
        }
        let Lanes([a, b]) = least;
        let mut scale = Scalar::min(a, b);
        if let Some(mode) = one {
            own_of_one = mode.own(inverse_r);
            scale = Scalar::min(scale, own_of_one[0].abs());
        }
        let mut sums = [zero; 3];
        for (pair, own) in pairs.iter().zip(own) {
            let [v, h, u] = pair.terms(Lanes::all(scale), own);
            for ((v, h), u) in v.0.into_iter().zip(h.0).zip(u.0) {
                sums = plus(sums, [v, h, u]);
            }
        }
        if let Some(mode) = one {
            sums = plus(sums, mode.terms(scale, own_of_one));
        }
        (scale, sums)
    }
}

#[inline(always)]
fn plus<S: Scalar>([a, b, c]: LimitTerms<S>, [d, e, f]: LimitTerms<S>) -> LimitTerms<S> {
    [a + d, b + e, c + f]
}

/// Writes the terms of two modes in the modal sums V, H and U, and returns the scale E of the chain.
///
/// The function is not inlined, so that it stores its results in arrays. The compiler then uses packed instructions.
#[inline(never)]
fn of_two<S: Float>(modes: &DrivenConstants<Lanes<S>>, inverse_r: S, terms: &mut [[S; 2]; 3]) -> S {
    let own = modes.own(Lanes::all(inverse_r));
    let Lanes([a, b]) = own[0].abs();
    let scale = Scalar::min(a, b);
    *terms = modes.terms(Lanes::all(scale), own).map(|Lanes(both)| both);
    scale
}

impl<S: Float> Chain<S> {
    /// Returns the limits β_lim and β*_lim of an undamped chain at a finite 1/r > 0, and the receptance H of the
    /// contact. H is multiplied by r² and by the scale E of [`ContactAt`].
    ///
    /// The formula of β_lim uses the break-away term instead of the velocity constraint S. β*_lim contains no
    /// correction for masses that act as an absorber. If `is_one` is true, β*_lim is exactly 1
    /// ([`sliding_limit_is_one`](Self::sliding_limit_is_one)).
    #[inline]
    pub fn limits_of_driven(
        &self,
        modes: &DrivenModes<S>,
        inverse_r: S,
        is_one: bool,
    ) -> (Limits<S>, S) {
        let chain = Self {
            damped: false,
            ..*self
        };
        let zero = S::constant(0.0);
        let (scale, [v, h, u]) = modes.sums(inverse_r);
        let sum = ContactAt {
            scale,
            v: complex::real(v),
            u,
            g: zero,
            reversal: zero,
            h: complex::real(h),
        };
        let contact = chain.completed(&sum, inverse_r);
        let limits = Limits {
            continuous: chain.continuous_limit(&contact, chain.break_away(&contact)),
            sliding: if is_one {
                S::constant(1.0)
            } else {
                chain.sliding_limit(&contact)
            },
        };
        (limits, h)
    }
}
