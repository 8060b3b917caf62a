//! Modal sums V, U and H of the contact that leave out the terms of the dominant mode. The dominant mode outweighs all
//! others.
//!
//! The contribution of a mode to the motion of a mass contains a difference of two products of the sums V, U and H. V
//! is the response of the contact to the load, U its damping function, and H its receptance. In this difference the
//! mode's own terms cancel. Close to the mode's resonance its own terms outweigh all others, and their rounding errors
//! would remain. For this *dominant* mode the code therefore uses sums over all other modes.
//!
//! All other modes use the full sums, so that their rounding errors are equal. The motion of a mass far from the
//! contact is a small difference of modal terms. Equal rounding errors cancel in this difference.
//!
//! No second dominant mode is needed. To prove this, let the first of two modes have the terms a in V and c in U, and
//! the second the terms b in V and d in U. Let ac ≥ bd. The products ad and bc remain in the contribution of the second
//! mode. The larger of ad and bc is at least √(ac·bd) ≥ bd, and bd is the product that cancels.

use crate::contact::quadrature::Quadratures;
use crate::contact::sums::{Chain, ContactAt, ModeAt};
use crate::modal_sum::mass_controlled::is_mass_controlled;
use crate::number::complex::{self, Complex};
use crate::number::scalar::Scalar;
use crate::oscillator::mode::Mode;

/// Terms of one mode in three modal sums of the contact, or the three sums themselves. The sums are the response V to
/// the load, the damping function U and the receptance H.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ModalTerms<S> {
    pub v: Complex<S>,
    pub u: S,
    pub h: Complex<S>,
}

impl<S: Scalar> ModalTerms<S> {
    fn zero() -> Self {
        let zero = S::constant(0.0);
        Self {
            v: complex::real(zero),
            u: zero,
            h: complex::real(zero),
        }
    }

    /// Names the terms for emitted code. The emitted code then has one local variable for each term.
    fn named(self, partner: Partner) -> Self {
        const V: [(&str, &str); 2] = [
            ("others_v_re", "Re of V of the other modes"),
            ("others_v_im", "Im of V of the other modes"),
        ];
        const H: [(&str, &str); 2] = [
            ("others_h_re", "Re of H of the other modes"),
            ("others_h_im", "Im of H of the other modes"),
        ];
        let v = complex::named(self.v, V, None);
        match partner {
            Partner::U => Self {
                v,
                u: self.u.named("others_u", "U of the other modes", None),
                ..self
            },
            Partner::H => Self {
                v,
                h: complex::named(self.h, H, None),
                ..self
            },
        }
    }

    /// Returns the terms `self` if the condition is true, and `other` if it is false.
    fn select(&self, condition: S::Condition, other: &Self) -> Self {
        Self {
            v: complex::select(condition, self.v, other.v),
            u: S::select(condition, self.u, other.u),
            h: complex::select(condition, self.h, other.h),
        }
    }
}

/// Selects the modal sum that the code combines with V, the response of the contact to the load. The contribution of a
/// mode to a motion contains products of V and the selected sum. In this contribution the mode's own terms cancel.
#[derive(Clone, Copy)]
pub(crate) enum Partner {
    /// The sum combined with V is the damping function U of the contact, for a continuous motion.
    U,
    /// The sum combined with V is the receptance H of the contact, for the response of the stuck chain.
    H,
}

/// Candidate for the dominant mode. Each mode has a term in V (response to the load), and a term in U (damping
/// function) or H (receptance). Among the modes visited so far, the candidate has the largest product of its two terms.
#[derive(Clone, Copy)]
struct Heaviest<S> {
    weight: S,
    /// Index of the mode as a scalar. Emitted code finds the mode by comparing scalars.
    index: S,
    own: ModalTerms<S>,
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

/// Identifies the dominant mode, whose terms outweigh those of all other modes.
#[derive(Clone, Copy)]
enum Which<S> {
    /// The chain has only one mode, which is dominant.
    Only,
    /// The chain has two modes, and the first counts as dominant. Each mode gets the sums without its own terms, in
    /// which nothing cancels.
    First,
    /// The mode with this index is dominant. The index −1 means that no mode is dominant.
    Numbered(S),
}

/// Modal sums V, U and H of the contact in two versions. `own` is for the dominant mode, and leaves out the terms of
/// this mode. `others` is for all other modes, and contains all terms.
#[derive(Clone, Copy)]
pub(crate) struct DominantSums<S> {
    which: Which<S>,
    pub own: ModalTerms<S>,
    pub others: ModalTerms<S>,
}

impl<S: Scalar> DominantSums<S> {
    /// Adds the compliance of an elastic contact to the receptance H, in those sums that leave out the terms of a mode.
    /// The sums over all modes already contain the compliance.
    pub fn with_compliance(mut self, compliance: S) -> Self {
        self.own.h.re = self.own.h.re + compliance;
        if matches!(self.which, Which::First) {
            self.others.h.re = self.others.h.re + compliance;
        }
        self
    }

    /// Returns two values of V, the response of the contact of a damped chain to the load. The code measures the phase
    /// of the dominant mode against the first value, and the phases of all other modes against the second value.
    ///
    /// A mode is in phase with its own term of V. The full V and V without this term therefore give the same phase. For
    /// the dominant mode, and for both modes of a chain of two, the function uses the smaller of these two numbers,
    /// because its phase is more accurate. In longer chains, all other modes use the full V.
    pub fn turning(&self, contact: &ContactAt<S>) -> (Complex<S>, Complex<S>) {
        let size = |v| complex::size(v, true);
        let all = size(contact.v).named("v_size", "(|Re V| + |Im V|)·r²E", None);
        let least = |others: Complex<S>, of: usize| {
            let v = complex::select(size(others).lt(all), others, contact.v);
            Complex::new(
                v.re.named(
                    "turning_re",
                    "Re of V, or of V without the own term if that is smaller: the own term is in phase",
                    Some(of),
                ),
                v.im.named(
                    "turning_im",
                    "Im of V, or of V without the own term if that is smaller: the own term is in phase",
                    Some(of),
                ),
            )
        };
        let others = match self.which {
            Which::First => least(self.others.v, 1),
            Which::Only | Which::Numbered(_) => self.others.v,
        };
        (least(self.own.v, 0), others)
    }
}

/// Modal sum in the motion of a mass, in two parts: `own` is the term of the dominant mode, and `others` the sum over
/// all other modes.
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

    /// Adds the term `value` of the mode with the given index to the sum.
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
    /// Selects the dominant mode, whose own terms in the modal sums V, U and H outweigh all others. Returns the sums
    /// without the dominant mode's terms for the dominant mode, and the full sums for all other modes. In a chain of
    /// two modes, each mode gets the terms of the other mode.
    pub(crate) fn dominant_sums<'a>(
        &self,
        (modes, quadratures): (
            impl Iterator<Item = (&'a Mode<S>, ModeAt<S>)> + Clone,
            impl Quadratures<S>,
        ),
        partner: Partner,
        contact: &ContactAt<S>,
        inverse_r: S,
    ) -> DominantSums<S>
    where
        S: 'a,
    {
        let without = |sums: ModalTerms<S>, static_residue: S| {
            let Some(at_rest) = self.on_moving_base else {
                return sums;
            };
            let r2 = (S::constant(1.0) / (inverse_r * inverse_r)).named("r_squared", "r²", None);
            let kept = complex::real((at_rest - static_residue) * contact.scale);
            let v = complex::scale(self.plus(sums.v, kept), r2);
            ModalTerms { v, ..sums }
        };
        let mut known = modes.clone();
        if let (Some((first, at)), second, None) = (known.next(), known.next(), known.next()) {
            let Some((second, at_second)) = second else {
                let none = ModalTerms::zero();
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
                let own = self.own((other, quadratures), at_other, its);
                let others = without(own, mode.static_residue);
                self.in_full(mode, at, partner, contact, &others, it)
            };
            return DominantSums {
                which: Which::First,
                own: others(first, &at, second, &at_second, [0, 1]),
                others: others(second, &at_second, first, &at, [1, 0]),
            };
        }
        let zero = S::constant(0.0);
        let (mut sum, mut sizes) = (ModalTerms::zero(), (zero, zero));
        let mut heaviest: Option<Heaviest<S>> = None;
        for (index, (mode, at)) in modes.enumerate() {
            let own = self.own((mode, quadratures), &at, index);
            let next = self.candidate((mode, own), &at, partner, contact.scale, index);
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
        let all = ModalTerms {
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
        // In a motion, the product of the dominant mode's own terms cancels. The full sums are accurate enough if this
        // product is at most as large as the products that remain.
        let (v, other) = self.sizes(&heaviest.own, partner);
        let at_rest = match self.on_moving_base {
            Some(at_rest) => (at_rest - heaviest.static_residue).abs() * contact.scale,
            None => zero,
        };
        let remains = v * sizes.1 + (sizes.0 + at_rest) * other;
        let outweighs = remains.lt(heaviest.weight);
        let index = S::select(outweighs, heaviest.index, S::constant(-1.0));
        DominantSums {
            which: Which::Numbered(index.named("heaviest", "dominant mode, or −1", None)),
            own,
            others: all,
        }
    }

    fn candidate(
        &self,
        (mode, own): (&Mode<S>, ModalTerms<S>),
        at: &ModeAt<S>,
        partner: Partner,
        scale: S,
        index: usize,
    ) -> Heaviest<S> {
        // On a moving base the sums contain v − 1, where v is the response of a mode. In the difference of products
        // only the terms with v cancel.
        let v = if self.on_moving_base.is_some() {
            self.plus(own.v, complex::real(mode.static_residue * scale))
        } else {
            own.v
        };
        let (size, other) = self.sizes(&ModalTerms { v, ..own }, partner);
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
            weight: weight.named("weight", "product of both own terms", Some(index)),
            index: S::constant(index as f64),
            own,
            static_residue: mode.static_residue,
        }
    }

    /// Returns the sums V, U and H for one mode from `others`, the sums over the other modes. A mass-controlled mode
    /// resonates far below the excitation frequency, and has no term of U that cancels. For such a mode the result
    /// therefore contains the full U.
    fn in_full(
        &self,
        mode: &Mode<S>,
        at: &ModeAt<S>,
        partner: Partner,
        contact: &ContactAt<S>,
        others: &ModalTerms<S>,
        index: usize,
    ) -> ModalTerms<S> {
        let index = Some(index);
        let v = Complex::new(
            others
                .v
                .re
                .named("v_others_re", "Re V without the own term", index),
            others
                .v
                .im
                .named("v_others_im", "Im V without the own term", index),
        );
        match partner {
            Partner::U => {
                let slow = is_mass_controlled(mode.kind, mode.zeta, at.x);
                let u = S::select(slow, contact.u, others.u).named(
                    "u_others",
                    "U without the own term, or all of it for x < 1/2",
                    index,
                );
                ModalTerms { v, u, ..*others }
            }
            Partner::H => ModalTerms { v, ..*others },
        }
    }

    fn own(
        &self,
        (mode, quadratures): (&Mode<S>, impl Quadratures<S>),
        at: &ModeAt<S>,
        index: usize,
    ) -> ModalTerms<S> {
        const V: [(&str, &str); 2] = [
            ("v_term_re", "Re of the own term of V"),
            ("v_term_im", "Im of the own term of V"),
        ];
        const H: [(&str, &str); 2] = [
            ("h_term_re", "Re of the own term of H"),
            ("h_term_im", "Im of the own term of H"),
        ];
        let quadrature = quadratures.of(index);
        let h = complex::scale(at.response, mode.contact_squared);
        ModalTerms {
            v: complex::named(self.load_term(mode, at, quadrature), V, Some(index)),
            u: (mode.contact_squared * at.u).named("u_term", "the own term of U", Some(index)),
            h: complex::named(h, H, Some(index)),
        }
    }

    /// Returns the size of V, and the size of U or H, as `partner` selects. The size of a complex number is the sum of
    /// the absolute values of its real and imaginary part.
    fn sizes(&self, sums: &ModalTerms<S>, partner: Partner) -> (S, S) {
        let size = |value| complex::size(value, self.damped);
        let partner = match partner {
            Partner::U => sums.u.abs(),
            Partner::H => size(sums.h),
        };
        (size(sums.v), partner)
    }

    fn joined(&self, a: ModalTerms<S>, b: ModalTerms<S>) -> ModalTerms<S> {
        ModalTerms {
            v: self.plus(a.v, b.v),
            u: a.u + b.u,
            h: self.plus(a.h, b.h),
        }
    }
}

#[cfg(test)]
mod tests;
