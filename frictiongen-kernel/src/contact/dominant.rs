//! The sums V, U and H in the form in which a mode's contribution to a motion needs them.
//!
//! A mode's own terms in two of these sums cancel from its contribution. Close to the mode's pole they outweigh all
//! others, and must not be added in the first place. That one mode, the dominant mode, therefore gets the sums over all
//! other modes. All other modes share the full sums, and so their rounding errors. A mass far from the contact moves by
//! the difference of its modes. A rounding error common to all modes cancels from that difference, while a separate one
//! for each mode would not.
//!
//! One mode is enough. Let two modes have the terms a, b in V and c, d in U, with ac ≥ bd. The terms ad and bc remain
//! of the second mode, and the larger of them is at least √(ac·bd) ≥ bd, which is the term that cancels.

use crate::contact::sums::{Chain, ContactAt, ModeAt};
use crate::modal_sum::mass_controlled::is_mass_controlled;
use crate::number::complex::{self, Complex};
use crate::number::scalar::Scalar;
use crate::oscillator::mode::Mode;

/// A mode's terms in V, U and H, or sums of them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Terms<S> {
    pub v: Complex<S>,
    pub u: S,
    pub h: Complex<S>,
}

impl<S: Scalar> Terms<S> {
    fn zero() -> Self {
        let zero = S::constant(0.0);
        Self {
            v: complex::real(zero),
            u: zero,
            h: complex::real(zero),
        }
    }

    /// Gives the terms their own names in emitted code.
    fn named(self, partner: Partner) -> Self {
        let named = |value: Complex<S>, re, im| {
            Complex::new(value.re.named(re, None), value.im.named(im, None))
        };
        let v = named(self.v, "others_v_re", "others_v_im");
        match partner {
            Partner::U => Self {
                v,
                u: self.u.named("others_u", None),
                ..self
            },
            Partner::H => Self {
                v,
                h: named(self.h, "others_h_re", "others_h_im"),
                ..self
            },
        }
    }

    /// Returns these terms where the condition is true, `other` elsewhere.
    fn select(&self, condition: S::Condition, other: &Self) -> Self {
        Self {
            v: complex::select(condition, self.v, other.v),
            u: S::select(condition, self.u, other.u),
            h: complex::select(condition, self.h, other.h),
        }
    }
}

/// The sum, other than V, whose own terms cancel.
#[derive(Clone, Copy)]
pub(crate) enum Partner {
    /// The sum U, in a motion.
    U,
    /// The sum H, in a stuck response.
    H,
}

/// The mode with the largest own terms so far.
#[derive(Clone, Copy)]
struct Heaviest<S> {
    weight: S,
    /// Index of the mode, as a scalar, since emitted code finds it by comparison.
    index: S,
    own: Terms<S>,
    static_residue: S,
}

impl<S: Scalar> Heaviest<S> {
    fn select(&self, condition: S::Condition, other: &Self) -> Self {
        Self {
            weight: S::select(condition, self.weight, other.weight),
            index: S::select(condition, self.index, other.index),
            own: self.own.select(condition, &other.own),
            static_residue: S::select(condition, self.static_residue, other.static_residue),
        }
    }
}

/// The dominant mode.
#[derive(Clone, Copy)]
enum Which<S> {
    /// The only mode.
    Only,
    /// The first of two. Each of the two gets the other's terms, which cancel nothing.
    First,
    /// The mode with this index, or no mode if the index is −1.
    Numbered(S),
}

/// The dominant mode, the sums for it, and the sums for the other modes.
#[derive(Clone, Copy)]
pub(crate) struct DominantSums<S> {
    which: Which<S>,
    pub own: Terms<S>,
    pub others: Terms<S>,
}

impl<S: Scalar> DominantSums<S> {
    /// Returns the values of V against which the phases of the dominant mode and of the others are measured, for a
    /// damped chain. A mode is in phase with its own term of V. The other modes' terms therefore give the same phase as
    /// the full V, and a more accurate one where they are smaller.
    pub fn turning(&self, contact: &ContactAt<S>) -> (Complex<S>, Complex<S>) {
        let size = |v| complex::size(v, true);
        let all = size(contact.v).named("v_size", None);
        let least = |others: Complex<S>, of: usize| {
            let v = complex::select(size(others).lt(all), others, contact.v);
            Complex::new(
                v.re.named("turning_re", Some(of)),
                v.im.named("turning_im", Some(of)),
            )
        };
        let others = match self.which {
            Which::First => least(self.others.v, 1),
            Which::Only | Which::Numbered(_) => self.others.v,
        };
        (least(self.own.v, 0), others)
    }
}

/// A sum over modes, separated into the dominant mode and the others.
#[derive(Clone, Copy)]
pub(crate) struct DominantParts<S> {
    pub own: Complex<S>,
    pub others: Complex<S>,
}

impl<S: Scalar> DominantParts<S> {
    pub fn zero() -> Self {
        let zero = complex::real(S::constant(0.0));
        Self {
            own: zero,
            others: zero,
        }
    }

    /// Returns the sum with one more mode.
    pub fn with(
        self,
        chain: &Chain<S>,
        sums: &DominantSums<S>,
        index: usize,
        value: Complex<S>,
    ) -> Self {
        match sums.which {
            Which::Numbered(number) => {
                let it = (number - S::constant(index as f64)).is_zero();
                let zero = complex::real(S::constant(0.0));
                Self {
                    own: complex::select(it, value, self.own),
                    others: chain.plus(self.others, complex::select(it, zero, value)),
                }
            }
            Which::First if index != 0 => Self {
                others: value,
                ..self
            },
            Which::First | Which::Only => Self { own: value, ..self },
        }
    }
}

impl<S: Scalar> Chain<S> {
    /// Returns the sums for the mode with the largest own terms, and those for the others.
    pub(crate) fn dominant_sums<'a>(
        &self,
        modes: impl Iterator<Item = (&'a Mode<S>, ModeAt<S>)> + Clone,
        partner: Partner,
        contact: &ContactAt<S>,
        inverse_r: S,
    ) -> DominantSums<S>
    where
        S: 'a,
    {
        let without = |sums: Terms<S>, static_residue: S| {
            let Some(at_rest) = self.on_moving_base else {
                return sums;
            };
            let r2 = (S::constant(1.0) / (inverse_r * inverse_r)).named("r_squared", None);
            let kept = complex::real((at_rest - static_residue) * contact.scale);
            let v = complex::scale(self.plus(sums.v, kept), r2);
            Terms { v, ..sums }
        };
        let mut known = modes.clone();
        if let (Some((first, at)), second, None) = (known.next(), known.next(), known.next()) {
            let Some((second, at_second)) = second else {
                let none = Terms::zero();
                let own = without(none, first.static_residue);
                return DominantSums {
                    which: Which::Only,
                    own: self.in_full(first, &at, partner, contact, &own, 0),
                    others: none,
                };
            };
            let others = |mode: &Mode<S>,
                          at: &ModeAt<S>,
                          other: &Mode<S>,
                          at_other: &ModeAt<S>,
                          [it, its]: [usize; 2]| {
                let others = without(self.own(other, at_other, its), mode.static_residue);
                self.in_full(mode, at, partner, contact, &others, it)
            };
            return DominantSums {
                which: Which::First,
                own: others(first, &at, second, &at_second, [0, 1]),
                others: others(second, &at_second, first, &at, [1, 0]),
            };
        }
        let zero = S::constant(0.0);
        let (mut sum, mut sizes) = (Terms::zero(), (zero, zero));
        let mut heaviest: Option<Heaviest<S>> = None;
        for (index, (mode, at)) in modes.enumerate() {
            let next = self.candidate(mode, &at, partner, contact.scale, index);
            heaviest = Some(match heaviest {
                None => next,
                Some(known) => {
                    let heavier = known.weight.lt(next.weight);
                    let other = known.own.select(heavier, &next.own);
                    let (v, partner) = self.sizes(&other, partner);
                    sizes = (sizes.0 + v, sizes.1 + partner);
                    sum = self.joined(sum, other);
                    next.select(heavier, &known)
                }
            });
        }
        let all = Terms {
            v: contact.v,
            u: contact.u,
            h: contact.h,
        };
        let Some(heaviest) = heaviest else {
            return DominantSums {
                which: Which::Only,
                own: all,
                others: all,
            };
        };
        let own = without(sum, heaviest.static_residue).named(partner);
        // The full sums lose nothing if no more cancels than the rounding of the other terms.
        let (v, other) = self.sizes(&heaviest.own, partner);
        let at_rest = match self.on_moving_base {
            Some(at_rest) => (at_rest - heaviest.static_residue).abs() * contact.scale,
            None => zero,
        };
        let remains = v * sizes.1 + (sizes.0 + at_rest) * other;
        let outweighs = remains.lt(heaviest.weight);
        let index = S::select(outweighs, heaviest.index, S::constant(-1.0));
        DominantSums {
            which: Which::Numbered(index.named("heaviest", None)),
            own,
            others: all,
        }
    }

    fn candidate(
        &self,
        mode: &Mode<S>,
        at: &ModeAt<S>,
        partner: Partner,
        scale: S,
        index: usize,
    ) -> Heaviest<S> {
        let own = self.own(mode, at, index);
        // On a moving base v cancels, not the v − 1 of the sums.
        let v = if self.on_moving_base.is_some() {
            self.plus(own.v, complex::real(mode.static_residue * scale))
        } else {
            own.v
        };
        let (size, other) = self.sizes(&Terms { v, ..own }, partner);
        let weight = size * other;
        let weight = match partner {
            Partner::U => S::select(
                is_mass_controlled(mode.kind, mode.zeta, at.x),
                S::constant(0.0),
                weight,
            ),
            Partner::H => weight,
        };
        Heaviest {
            weight: weight.named("weight", Some(index)),
            index: S::constant(index as f64),
            own,
            static_residue: mode.static_residue,
        }
    }

    /// Returns the sums for a mode. A mass-controlled mode has no terms of U that could cancel, and gets the full U.
    fn in_full(
        &self,
        mode: &Mode<S>,
        at: &ModeAt<S>,
        partner: Partner,
        contact: &ContactAt<S>,
        others: &Terms<S>,
        index: usize,
    ) -> Terms<S> {
        let index = Some(index);
        let v = Complex::new(
            others.v.re.named("v_others_re", index),
            others.v.im.named("v_others_im", index),
        );
        match partner {
            Partner::U => {
                let slow = is_mass_controlled(mode.kind, mode.zeta, at.x);
                let u = S::select(slow, contact.u, others.u).named("u_others", index);
                Terms { v, u, ..*others }
            }
            Partner::H => Terms { v, ..*others },
        }
    }

    fn own(&self, mode: &Mode<S>, at: &ModeAt<S>, index: usize) -> Terms<S> {
        let named = |value: Complex<S>, re, im| {
            let index = Some(index);
            Complex::new(value.re.named(re, index), value.im.named(im, index))
        };
        let h = complex::scale(at.response, mode.inverse_mass);
        Terms {
            v: named(self.load_term(mode, at), "v_term_re", "v_term_im"),
            u: (mode.inverse_mass * at.u).named("u_term", Some(index)),
            h: named(h, "h_term_re", "h_term_im"),
        }
    }

    /// Returns the size of V and that of its partner.
    fn sizes(&self, sums: &Terms<S>, partner: Partner) -> (S, S) {
        let size = |value| complex::size(value, self.damped);
        let partner = match partner {
            Partner::U => sums.u.abs(),
            Partner::H => size(sums.h),
        };
        (size(sums.v), partner)
    }

    fn joined(&self, a: Terms<S>, b: Terms<S>) -> Terms<S> {
        Terms {
            v: self.plus(a.v, b.v),
            u: a.u + b.u,
            h: self.plus(a.h, b.h),
        }
    }
}

#[cfg(test)]
mod tests;
