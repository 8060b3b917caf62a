/// One mass on a spring, rubbing on a wall: no sums, no damping.
///
/// Emitted by frictiongen 0.1.0 from scene 63f03dd183c2a0cd.
#[::core::prelude::v1::derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::Eq,
    ::core::cmp::PartialEq,
    ::core::default::Default,
    ::core::hash::Hash
)]
pub struct SdofWall;
/// [`SdofWall`] at one frequency ratio: limits, regime, and the way to motions.
#[allow(deprecated, non_camel_case_types)]
pub struct SdofWallAt(::frictiongen::kernel::response::At<SdofWall>);
/// The exact continuous motion of [`SdofWall`] at one frequency and one friction ratio.
#[allow(deprecated, non_camel_case_types)]
pub struct SdofWallMotion(::frictiongen::kernel::response::Continuous<SdofWall>);
#[automatically_derived]
#[allow(
    deprecated,
    non_snake_case,
    non_camel_case_types,
    unused_imports,
    unused_qualifications,
    clippy::all,
    clippy::pedantic,
    clippy::nursery,
    clippy::restriction
)]
const _: () = {
    use ::frictiongen::kernel::emitted::*;
    impl SdofWall {
        /// ω_i, the natural frequencies, rad/s in the units given, ascending.
        pub const NATURAL_FREQUENCIES: [f64; 1] = [1.0];
        /// √λ_i = ω_i√(m₁/k₁): the frequency ratios r of the undamped resonances.
        pub const RESONANCES: [f64; 1] = [1.0];
        /// φ, [mode][mass], with φᵀΓφ = 1; of each mode the first component that counts is positive.
        pub const MODE_SHAPES: [[f64; 1]; 1] = [[1.0]];
        /// What the limits need beyond the modes.
        const CHAIN: Chain<f64> = Chain {
            damped: false,
            on_moving_base: None,
            inverse_mass: 1.0,
            stiction: 1.0,
        };
        /// An angular frequency, rad/s, as frequency ratio r = ω√(m₁/k₁).
        #[inline]
        #[must_use]
        pub const fn frequency_ratio(omega: f64) -> f64 {
            omega
        }
        /// A friction force F and a load amplitude P, for base motion k₁Y, as friction ratio β = F/P.
        #[inline]
        #[must_use]
        pub const fn friction_ratio(friction: f64, load: f64) -> f64 {
            friction / load
        }
    }
    impl SdofWall {
        /// The modes that the load or the contact drives.
        const MODES: [Mode<f64>; 1] = [
            Mode {
                kind: Kind::Undamped,
                in_contact: true,
                resonance: 1.0,
                zeta: 0.0,
                q: 1.0,
                q_defect: 0.0,
                load: 1.0,
                contact: 1.0,
                residue: 1.0,
                inverse_mass: 1.0,
                static_residue: 1.0,
            },
        ];
        /// All that the steady response rests on.
        const NUMBERS: Numbers<'static, f64> = Numbers {
            modes: &Self::MODES,
            chain: Self::CHAIN,
            ends: Ends {
                sliding_at_rest: 1.0,
                continuous_at_infinity: 0.5370292721463151,
                sliding_at_infinity: 1.0,
            },
            rubbing: Some(0),
            absorbs: false,
            unbounded: &[1.0],
            invisible: &[],
        };
        /// The scene at the frequency ratio r = ω√(m₁/k₁).
        ///
        /// # Errors
        /// `OutOfDomain` for NaN and negative r; 0 and ∞ answer with the limits.
        #[inline]
        pub fn at(r: f64) -> Result<SdofWallAt, OutOfDomain> {
            At::new(Self, r).map(From::from)
        }
        /// Both limits without search: β_lim with S replaced by its limit for τ → 0 (5.64), an upper bound, and
        /// β*_lim (6.11, 6.27, 6.33).  Where nothing else is asked of r, this is the shortest way.
        ///
        /// # Errors
        /// `OutOfDomain` for NaN and negative r; 0 and ∞ answer with the limits.
        #[inline]
        pub fn limits_without_search(r: f64) -> Result<Limits<f64>, OutOfDomain> {
            At::limits_without_search(&Self, r)
        }
        /// Both limits over a slice of frequency ratios, into slices of the same length.
        ///
        /// # Errors
        /// `OutOfDomain` for a slice of another length, which changes nothing, and at the first NaN or negative r.
        pub fn limits_into(
            rs: &[f64],
            continuous: &mut [f64],
            sliding: &mut [f64],
        ) -> Result<(), OutOfDomain> {
            At::limits_into(Self, rs, continuous, sliding)
        }
    }
    ::frictiongen::emitted_system!(SdofWall, SdofWallAt, f64, ["block"]);
    ::frictiongen::kernel::wraps!(SdofWallAt, At of SdofWall, Copy);
    impl Scene for SdofWall {
        type Scalar = f64;
        type Decay = Undamped;
        type Modes = [ModeAt<f64>; 1];
        type Waves = [Wave<f64, Undamped>; 1];
        #[inline]
        fn numbers(&self) -> Numbers<'static, f64> {
            Self::NUMBERS
        }
        /// φ of a mass, by modes.
        #[inline]
        fn shape(&self, mass: usize) -> Option<&[f64]> {
            match mass {
                0 => Some(&[1.0]),
                _ => None,
            }
        }
        /// The smallest and the largest 1/r at which the formulas are evaluated: beyond, squares leave the scalar's range.
        #[inline]
        fn inverse_ratio_range(&self) -> (f64, f64) {
            (3.8725919148493183e-121, 2.5822498780869086e120)
        }
        /// Working space of the searches, and of the waves of a motion.
        #[inline]
        fn idle(&self) -> Self::Waves {
            Self::MODES.map(|mode| Wave::idle(&mode))
        }
        /// A copy of the modes for a motion to keep.
        #[inline]
        fn kept(modes: &Self::Modes) -> Self::Modes {
            *modes
        }
        /// The response and damping functions V, U, G, H of the contact (3.11, 5.20, 5.34, 5.37, 7.11, 7.12), each
        /// times r²E with the scale E that keeps them finite on a resonance, and each mode's part in them.
        ///
        /// `frequency` is x = √λ/r = 1/R of a mode, `detuning` x² − 1, `size` |x² − 1| + 2ζx; the smallest `size` is E, `scale`.
        /// `u` is uR² and `reversal` g + 2ζRu; both and `g` come times `size`, then times E, as does `response`, 1/(x² − 1 + 2iζx).
        /// Undamped: `sine` and `cosine` are of πx/2, and where a divisor is exactly 0 `…_off_pole` has another next to it.
        ///
        /// Operations: 12: 4 ×, 2 +, 2 compare, 2 sign, 1 sin_cos_pi, 1 ÷.
        #[inline]
        fn frequency_stage(&self, inverse_r: f64) -> (ContactAt<f64>, [ModeAt<f64>; 1]) {
            let (sine, plain_cosine) = Scalar::sin_cos_pi(inverse_r * 0.5);
            let detuning = Scalar::detuning_off_pole(
                (inverse_r - 1.0) * (inverse_r + 1.0),
            );
            let cosine = Scalar::cosine_off_pole(plain_cosine);
            let size = Scalar::abs(detuning);
            let u = sine * size / (inverse_r * cosine);
            let v_re = Scalar::copysign(1.0, detuning);
            let contact = ContactAt {
                scale: size,
                v: Complex { re: v_re, im: 0.0 },
                u,
                g: 0.0,
                reversal: 0.0,
                h: Complex { re: v_re, im: 0.0 },
            };
            let modes = [
                ModeAt {
                    x: inverse_r,
                    response: Complex { re: v_re, im: 0.0 },
                    u,
                    g: 0.0,
                },
            ];
            (contact, modes)
        }
        /// r²E(H_c + μm*/r²), what the contact force needs for break-away at a reversal (5.63, 7.47).
        #[inline]
        fn break_away(&self, contact: &ContactAt<f64>) -> f64 {
            contact.scale
        }
        /// β_lim = |V|/√(U² + max(S, H_c + μm*/r²)²) (5.65, 5.80, 5.96, 7.49); `constraint` is r²E times that
        /// maximum.
        #[inline]
        fn continuous_limit(&self, contact: &ContactAt<f64>, constraint: f64) -> f64 {
            let excitation = Scalar::abs(contact.v.re);
            excitation / Scalar::sqrt(contact.u * contact.u + constraint * constraint)
        }
        /// β*_lim = |V|/(μ|H|) (6.11, 6.27, 6.33).
        #[inline]
        fn sliding_limit(&self, contact: &ContactAt<f64>) -> f64 {
            let excitation = Scalar::abs(contact.v.re);
            let receptance = Scalar::abs(contact.h.re);
            excitation / receptance
        }
        /// Both limits (5.64; 6.11, 6.27, 6.33), without what only a motion needs, and the real part of H.  The names are
        /// those of `frequency_stage`.
        ///
        /// Operations: 19: 6 ×, 3 +, 3 sign, 3 ÷, 2 compare, 1 sin_cos_pi, 1 √.
        #[inline]
        fn limits_without_search(&self, inverse_r: f64) -> (Limits<f64>, f64) {
            let (sine, plain_cosine) = Scalar::sin_cos_pi(inverse_r * 0.5);
            let detuning = Scalar::detuning_off_pole(
                (inverse_r - 1.0) * (inverse_r + 1.0),
            );
            let cosine = Scalar::cosine_off_pole(plain_cosine);
            let size = Scalar::abs(detuning);
            let u = sine * size / (inverse_r * cosine);
            let v_re = Scalar::copysign(1.0, detuning);
            let excitation = Scalar::abs(v_re);
            (
                Limits {
                    continuous: excitation / Scalar::sqrt(u * u + size * size),
                    sliding: excitation / excitation,
                },
                v_re,
            )
        }
    }
    ::frictiongen::kernel::not_provided!(SdofWallAt : stuck, orbit);
    ::frictiongen::kernel::not_provided!(SdofWall : stepper);
    ::frictiongen::kernel::not_provided!(SdofWall : simulation);
    impl ProvidesMotion for SdofWall {
        type Motion = SdofWallMotion;
        #[allow(unused_variables)]
        fn contact_motion(at: &At<Self>, friction: &Friction<f64>) -> MotionOf<Self> {
            let (inverse_r, contact) = (at.inverse_ratio(), at.contact_sums());
            let [mode_1] = at.modes();
            let friction_weight = friction.beta * friction.unscale;
            let rise = friction_weight * contact.scale;
            let swing = friction_weight * mode_1.u;
            let fundamental = Fundamental {
                cosine: friction.amplitude,
                sine: 0.0,
                response: Complex {
                    re: contact.v.re * friction.unscale,
                    im: 0.0,
                },
            };
            let waves = [
                motion_wave(
                    mode_1.x,
                    Undamped,
                    ModalCoefficients {
                        rise,
                        fall: 0.0,
                        swing,
                        gain: inverse_r * inverse_r,
                    },
                ),
            ];
            Motion::of_contact(*friction, fundamental, waves)
        }
    }
    ::frictiongen::kernel::wraps!(SdofWallMotion, Continuous of SdofWall, Copy);
    impl SdofWallMotion {
        /// The motion of mass `block` (5.50 and its exact form, 7.29).
        ///
        /// It rubs on a support at rest: its motion is the contact's.
        #[must_use]
        pub fn block(&self) -> MotionOf<SdofWall> {
            self.contact()
        }
    }
};
