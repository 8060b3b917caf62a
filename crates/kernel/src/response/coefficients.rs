//! Coefficients of the exact continuous motion at one friction ratio (section 4 of `docs/derivation.md`).
//!
//! The response of mode i has a term with V, the response of the contact to the load, and a term with friction. Both
//! terms have a pole at the mode's resonance, and the poles partly cancel. The formulas therefore use ν = p v/V and κ
//! = (p v U − w u V)/V. p and w are the products φᵀp and φᵀw of the mode, v is its response, and u and g are its
//! damping functions. Where the terms of mode i itself would cancel in ν and κ, the code leaves them out of U and V.
//!
//! The formula of the motion of mass k then has no cancellation: x̄_k = Re[Q ρ e^{iτ}] + β Im[Σ φ_k κ e^{iτ}] + β Σ
//! φ_k w [ (1 − d) − g d + uR²(sin τ − …) ]. Here ρ = Σ φ_k ν = V_k/V and Q = √(|V|² − β²U²). φ_k is the component of
//! mass k in the mode shape. d is the free vibration of the mode after a unit displacement.
//!
//! Close to a damped resonance, the terms g d and Qρ are large and nearly proportional to cos τ. The code therefore
//! adds −g cos τ to the coefficient of cos τ. The small term g (cos τ − d) remains.

pub use super::coefficient_types::{Friction, Fundamental, ModalCoefficients};
use crate::contact::dominant::{DominantParts, DominantSums, Partner};
use crate::contact::quadrature::{InPhase, Quadratures};
use crate::contact::sums::{Chain, ContactAt, ModeAt};
use crate::modal_sum::mass_controlled::is_mass_controlled;
use crate::number::complex::{self, Complex, named};
use crate::number::phase::wrapped;
use crate::number::scalar::Scalar;
use crate::oscillator::mode::Mode;

/// Text for emitted code, which explains the factor of a mode in the response of mass k to a force in the contact.
const BY_CONTACT: &str = "φ_k(φᵀw), from the contact to mass k";

/// Names and texts for emitted code, for the real and the imaginary part of a mode's term in V_k. V_k is the response
/// of mass k to the load.
const DRIVEN: [(&str, &str); 2] = [
    ("driven_re", "Re of the own term of V_k"),
    ("driven_im", "Im of the own term of V_k"),
];

/// Factor 2^24. Multiplied by this factor, even the smallest positive `f32` has a finite reciprocal.
const INTO_RANGE: f64 = (1_u32 << 24) as f64;

impl<S: Scalar> Chain<S> {
    /// Returns the amplitude Z and the phase φ of the contact's relative motion at the friction ratio β (2.21, 5.35,
    /// 5.38, 7.20, 7.21).
    #[inline]
    pub fn friction(&self, contact: &ContactAt<S>, inverse_r: S, beta: S) -> Friction<S> {
        let modulus_v =
            complex::modulus(contact.v, self.damped).named("modulus_v", "|V|·r²E", None);
        let velocity_part = (beta * contact.u).named("friction_quadrature", "βU·r²E", None);
        // The code takes the root of the product (|V| − βU)(|V| + βU). The difference |V|² − (βU)² would lose its
        // digits close to a limit.
        let zero = S::constant(0.0);
        let less = (modulus_v - velocity_part).max(zero);
        let more = (modulus_v + velocity_part).max(zero);
        let root = if self.damped || self.on_moving_base.is_some() {
            // On a moving base the factors |V| − βU and |V| + βU grow as r⁴. With damping V may almost vanish. The
            // product of the factors may then overflow or underflow, so that the code takes the root of each factor.
            less.sqrt() * more.sqrt()
        } else {
            (less * more).sqrt()
        };
        let root = root.named("in_phase", "Q·r²E, Q = √(|V|² − (βU)²)", None);
        let unscale = (inverse_r * inverse_r / contact.scale).named("unscale", "1/(r²E)", None);
        let amplitude = if self.damped {
            root - beta * contact.g
        } else {
            root
        };
        let direction = if self.damped {
            contact.v.im.atan2(contact.v.re)
        } else {
            S::select(contact.v.re.lt(zero), S::pi(), zero)
        };
        let lag = (-velocity_part).atan2(root) - direction;
        Friction {
            beta,
            root,
            amplitude: (amplitude * unscale).named(
                "amplitude",
                "Z = Q − βG (3.11, 5.35, 7.20)",
                None,
            ),
            phase: wrapped(lag.named("lag", "φ, not yet within one turn (5.38, 7.21)", None)),
            unscale,
        }
    }

    /// Returns the coefficients of cos τ and sin τ in the closed form of the contact's relative motion. The
    /// coefficient of cos τ is the amplitude, and that of sin τ is 0, because the contact has its maximum at τ = 0.
    #[inline]
    pub fn contact_fundamental(
        &self,
        contact: &ContactAt<S>,
        friction: &Friction<S>,
    ) -> Fundamental<S> {
        Fundamental {
            cosine: friction.amplitude,
            sine: S::constant(0.0),
            response: complex::scale(contact.v, friction.unscale),
        }
    }

    /// Returns the coefficients of one mode in a motion. For mass k, `residue` is φ_k(φᵀw). For the contact, `residue`
    /// is (φᵀw)². φ_k is the component of mass k in the mode shape φ, and w the contact direction.
    #[inline]
    pub fn modal_coefficients(
        &self,
        at: &ModeAt<S>,
        residue: S,
        contact: &ContactAt<S>,
        friction: &Friction<S>,
        inverse_r: S,
        index: usize,
    ) -> ModalCoefficients<S> {
        let weight = (friction.beta * friction.unscale).named("friction_weight", "β/(r²E)", None);
        let force = (weight * residue).named(
            "friction_force",
            "β/(r²E)·φ_k(φᵀw), for the contact β/(r²E)·(φᵀw)²",
            Some(index),
        );
        let fall = if self.damped {
            (force * (at.g / (at.x * at.x))).named("fall", "coefficient of cos τ − d", Some(index))
        } else {
            S::constant(0.0)
        };
        ModalCoefficients {
            rise: (force * contact.scale).named("rise", "coefficient of (1 − d)/x²", Some(index)),
            fall,
            forced: (force * at.u).named("forced", "coefficient of sin τ − Rq̃", Some(index)),
            harmonic: residue * inverse_r * inverse_r,
        }
    }

    /// Returns the coefficients of one mode in the motion of a mass, for
    /// [`mass_wave`](crate::response::motion::mass_wave). A mode that resonates far below the excitation frequency is
    /// mass-controlled. A single function then gives its whole response, because separate terms would cancel (see
    /// `modal_sum::mass_controlled`).
    #[inline]
    #[allow(clippy::too_many_arguments, reason = "a mode, and all it rests on")]
    pub fn mass_coefficients(
        &self,
        mode: &Mode<S>,
        at: &ModeAt<S>,
        residue: S,
        contact: &ContactAt<S>,
        friction: &Friction<S>,
        inverse_r: S,
        index: usize,
    ) -> ModalCoefficients<S> {
        let at = self.without_parts(mode, at, index);
        self.modal_coefficients(&at, residue, contact, friction, inverse_r, index)
    }

    /// Returns the response and damping functions of a mode. For a mass-controlled mode (resonance far below the
    /// excitation frequency) u and g are 0 in the result. The response of such a mode to friction is a single function
    /// that already contains the effects of u and g.
    fn without_parts(&self, mode: &Mode<S>, at: &ModeAt<S>, index: usize) -> ModeAt<S> {
        let (slow, zero) = (
            is_mass_controlled(mode.kind, mode.zeta, at.x),
            S::constant(0.0),
        );
        let g = if self.damped {
            S::select(slow, zero, at.g).named(
                "offset",
                "g·E, or 0 if the mode is mass-controlled (x < 1/2)",
                Some(index),
            )
        } else {
            at.g
        };
        ModeAt {
            u: S::select(slow, zero, at.u).named(
                "u_in_sum",
                "uR²·E, or 0 if the mode is mass-controlled (x < 1/2)",
                Some(index),
            ),
            g,
            ..*at
        }
    }

    /// Returns the coefficients of cos τ and sin τ in the closed form of the motion of mass k. `shape` contains the
    /// component of mass k in each mode shape.
    pub fn fundamental(
        &self,
        shape: &[S],
        modes: &[Mode<S>],
        at: &[ModeAt<S>],
        contact: &ContactAt<S>,
        friction: &Friction<S>,
        inverse_r: S,
    ) -> Fundamental<S> {
        self.fundamental_loaded(shape, (modes, InPhase), at, contact, friction, inverse_r)
    }

    /// Returns the coefficients of [`fundamental`](Self::fundamental), for modes with loads in quadrature (90° out of
    /// phase).
    pub fn fundamental_loaded(
        &self,
        shape: &[S],
        (modes, quadratures): (&[Mode<S>], impl Quadratures<S>),
        at: &[ModeAt<S>],
        contact: &ContactAt<S>,
        friction: &Friction<S>,
        inverse_r: S,
    ) -> Fundamental<S> {
        let known = modes.iter().zip(at.iter().copied());
        let loaded = (known.clone(), quadratures);
        let sums = self.dominant_sums(loaded, Partner::U, contact, inverse_r);
        let known = shape.iter().zip(known).enumerate();
        let parts = known.map(|(index, (component, (mode, at)))| (index, *component, mode, at));
        self.fundamental_of((parts, quadratures), &sums, contact, friction)
    }

    /// Returns the coefficients of cos τ and sin τ in the closed form of the motion of a mass, summed over the given
    /// modes. Each entry of `parts` belongs to one mode. The entry consists of the index of the mode, the component of
    /// the mass in the mode shape, the constants of the mode, and its functions at the frequency ratio r.
    pub(crate) fn fundamental_of<'a>(
        &self,
        (parts, quadratures): (
            impl Iterator<Item = (usize, S, &'a Mode<S>, ModeAt<S>)>,
            impl Quadratures<S>,
        ),
        sums: &DominantSums<S>,
        contact: &ContactAt<S>,
        friction: &Friction<S>,
    ) -> Fundamental<S>
    where
        S: 'a,
    {
        let (mut driven, mut rubbed) = (DominantParts::zero(), DominantParts::zero());
        let mut damped_back = S::constant(0.0);
        for (index, component, mode, at) in parts {
            let free = mode.driven(&at, component, quadratures.of(index), index);
            let free = named(free, DRIVEN, Some(index));
            driven = driven.with(self, sums, index, free);
            let residue = (component * mode.contact).named("by_contact", BY_CONTACT, Some(index));
            let at = self.without_parts(mode, &at, index);
            let back =
                (-(residue * at.u)).named("rubbed_back", "the own term of −U_k", Some(index));
            rubbed = rubbed.with(self, sums, index, complex::real(back));
            if self.damped {
                let offset = (at.g / (at.x * at.x)).named("fall_per_force", "g·E/x²", Some(index));
                damped_back = damped_back - residue * offset;
            }
        }
        let ratio = self.plus(driven.own, driven.others);
        // On a moving base V grows as r², and products with V could overflow or underflow.
        let on_base = self.on_moving_base.is_some();
        let one = S::constant(1.0);
        let (lower, raise_back) = if on_base {
            (S::constant(1.0 / INTO_RANGE), S::constant(INTO_RANGE))
        } else {
            (one, one)
        };
        // The code multiplies sums instead of ratios. A mass far from the contact moves by the small difference V_k U −
        // U_k V. Common factors must be exactly equal in both terms of this difference.
        let part = |driven, u: S, rubbed: Complex<S>, v| {
            let (u, rubbed) = (
                (u * lower).named(
                    "u_in_range",
                    "U of `u_others` over 2²⁴, which keeps products within the range of the scalar",
                    None,
                ),
                rubbed.re * lower,
            );
            self.plus(complex::scale(driven, u), complex::scale(v, rubbed))
        };
        let mismatch = self.plus(
            part(driven.own, sums.own.u, rubbed.own, sums.own.v),
            part(driven.others, sums.others.u, rubbed.others, sums.others.v),
        );
        let ratio = named(
            ratio,
            [
                ("response_re", "Re of V_k·r²E"),
                ("response_im", "Im of V_k·r²E"),
            ],
            None,
        );
        let mismatch = named(
            mismatch,
            [
                (
                    "mismatch_re",
                    "Re of V_kU − U_kV, without the products of a mode with itself",
                ),
                (
                    "mismatch_im",
                    "Im of V_kU − U_kV, without the products of a mode with itself",
                ),
            ],
            None,
        );
        // On a moving base the code does not scale V and β by 2²⁴. V does not vanish there, and β may be as large as
        // the number type allows.
        let vanishes = self.damped && !on_base;
        let raise = if vanishes {
            S::constant(INTO_RANGE)
        } else {
            one
        };
        let v = complex::scale(contact.v, raise);
        let v = named(
            v,
            [
                (
                    "v_in_range_re",
                    if vanishes {
                        "Re of V·r²E times 2²⁴, so that its reciprocal does not overflow"
                    } else {
                        "Re of V·r²E"
                    },
                ),
                (
                    "v_in_range_im",
                    if vanishes {
                        "Im of V·r²E times 2²⁴, so that its reciprocal does not overflow"
                    } else {
                        "Im of V·r²E"
                    },
                ),
            ],
            None,
        );
        let inverse_v = complex::reciprocal(v, self.damped);
        let response = complex::scale(ratio, friction.unscale);
        let ratio = complex::mul(ratio, inverse_v, self.damped);
        let mismatch = complex::mul(mismatch, inverse_v, self.damped);
        let Friction {
            beta,
            root,
            unscale,
            ..
        } = *friction;
        let root = (root * lower * raise).named(
            "root_in_range",
            match (vanishes, on_base) {
                (true, _) => "Q·r²E times 2²⁴, which keeps products in range",
                (_, true) => "Q·r²E times 2⁻²⁴, which keeps products in range",
                _ => "Q·r²E",
            },
            None,
        );
        let raised = (unscale * raise_back).named(
            "unscale_in_range",
            if on_base {
                "1/(r²E) times 2²⁴, which keeps products in range"
            } else {
                "1/(r²E)"
            },
            None,
        );
        if self.damped {
            let weight = (beta * unscale).named("friction_weight", "β/(r²E)", None);
            let beta = (beta * raise).named(
                "beta_in_range",
                if vanishes {
                    "β times 2²⁴, which keeps products in range"
                } else {
                    "β"
                },
                None,
            );
            let (_, (near, far)) = complex::inverse(v);
            let turned = |driven: Complex<S>, v: Complex<S>| {
                let v = complex::scale(complex::scale(v, raise), far);
                driven.im * v.re - driven.re * v.im
            };
            let (own, others) = sums.turning(contact);
            let lag = turned(driven.own, own) + turned(driven.others, others);
            let in_phase = (root * near).named("in_phase_over_v", "Q/(|Re V| + |Im V|)", None);
            Fundamental {
                cosine: (root * ratio.re + beta * mismatch.im) * raised + damped_back * weight,
                sine: (beta * mismatch.re - in_phase * lag) * raised,
                response,
            }
        } else {
            Fundamental {
                cosine: root * ratio.re * raised,
                sine: beta * mismatch.re * raised,
                response,
            }
        }
    }

    /// Returns x̄*_k = V_k − H_k V/H, the complex amplitude of mass k while the contact is stuck. The unit is P/k₁ (Y
    /// for base motion). V_k is the response of mass k to the load, and H_k its response to a unit force in the
    /// contact. V/H is the force that keeps the contact stuck.
    pub fn stuck(
        &self,
        shape: &[S],
        modes: &[Mode<S>],
        at: &[ModeAt<S>],
        contact: &ContactAt<S>,
        inverse_r: S,
    ) -> Complex<S> {
        self.stuck_loaded(shape, (modes, InPhase), at, contact, inverse_r)
    }

    /// Returns the complex amplitude of mass k while the contact is stuck, for modes with loads in quadrature (90° out
    /// of phase). Without loads in quadrature, [`stuck`](Self::stuck) returns the same amplitude.
    pub fn stuck_loaded(
        &self,
        shape: &[S],
        (modes, quadratures): (&[Mode<S>], impl Quadratures<S>),
        at: &[ModeAt<S>],
        contact: &ContactAt<S>,
        inverse_r: S,
    ) -> Complex<S> {
        let known = modes.iter().zip(at.iter().copied());
        let loaded = (known, quadratures);
        let sums = self.dominant_sums(loaded, Partner::H, contact, inverse_r);
        self.stuck_with(shape, (modes, quadratures), at, (contact, &sums), inverse_r)
    }

    /// Returns the complex amplitude of mass k while an elastic contact is stuck, for modes with loads in quadrature
    /// (90° out of phase). In the argument `contact`, H includes the compliance of the contact.
    pub(crate) fn stuck_elastic(
        &self,
        shape: &[S],
        (modes, quadratures): (&[Mode<S>], impl Quadratures<S>),
        at: &[ModeAt<S>],
        (contact, compliance): (&ContactAt<S>, S),
        inverse_r: S,
    ) -> Complex<S> {
        let known = modes.iter().zip(at.iter().copied());
        let loaded = (known, quadratures);
        let sums = self
            .dominant_sums(loaded, Partner::H, contact, inverse_r)
            .with_compliance(contact.compliance(compliance, inverse_r));
        self.stuck_with(shape, (modes, quadratures), at, (contact, &sums), inverse_r)
    }

    /// Returns the complex amplitude of a mass while the contact is stuck. `sums` contains the sums without the
    /// dominant mode's own terms, because these terms would cancel in the result.
    #[inline]
    fn stuck_with(
        &self,
        shape: &[S],
        (modes, quadratures): (&[Mode<S>], impl Quadratures<S>),
        at: &[ModeAt<S>],
        (contact, sums): (&ContactAt<S>, &DominantSums<S>),
        inverse_r: S,
    ) -> Complex<S> {
        let known = modes.iter().zip(at.iter().copied());
        let (mut driven, mut rubbed) = (DominantParts::zero(), DominantParts::zero());
        for (index, (component, (mode, at))) in shape.iter().zip(known).enumerate() {
            let free = mode.driven(&at, *component, quadratures.of(index), index);
            let free = named(free, DRIVEN, Some(index));
            driven = driven.with(self, sums, index, free);
            let residue = (*component * mode.contact).named("by_contact", BY_CONTACT, Some(index));
            let back = complex::scale(at.response, -residue);
            let back = named(
                back,
                [
                    ("held_back_re", "Re of the own term of −H_k"),
                    ("held_back_im", "Im of the own term of −H_k"),
                ],
                Some(index),
            );
            rubbed = rubbed.with(self, sums, index, back);
        }
        let part = |driven, h, rubbed, v| {
            let mul = |a, b| complex::mul(a, b, self.damped);
            self.plus(mul(driven, h), mul(rubbed, v))
        };
        let sum = self.plus(
            part(driven.own, sums.own.h, rubbed.own, sums.own.v),
            part(driven.others, sums.others.h, rubbed.others, sums.others.v),
        );
        let sum = named(
            sum,
            [
                (
                    "numerator_re",
                    "Re of V_kH − H_kV, without the products of a mode with itself",
                ),
                (
                    "numerator_im",
                    "Im of V_kH − H_kV, without the products of a mode with itself",
                ),
            ],
            None,
        );
        let inverse_h = complex::reciprocal(contact.h, self.damped);
        let unscale = (inverse_r * inverse_r / contact.scale).named("unscale", "1/(r²E)", None);
        complex::scale(complex::mul(sum, inverse_h, self.damped), unscale)
    }
}
