/// One mass, over-critically damped: no oscillation is left.
///
/// Emitted by frictiongen 0.1.0 from scene 249fdf28d14e7e62.
/// Numbers in brackets are equations of L. Marino, *Dynamic analysis of mechanical systems with Coulomb friction*, Oxford 2021.
#[::core::prelude::v1::derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::Eq,
    ::core::cmp::PartialEq,
    ::core::default::Default,
    ::core::hash::Hash
)]
pub struct SdofOverdamped;
/// [`SdofOverdamped`] at one frequency ratio: limits, regime, continuous motion.
#[allow(deprecated, non_camel_case_types)]
pub struct SdofOverdampedAt(::frictiongen::kernel::response::At<SdofOverdamped>);
/// The exact continuous motion of [`SdofOverdamped`] at one frequency and one friction ratio.
#[allow(deprecated, non_camel_case_types)]
pub struct SdofOverdampedMotion(
    ::frictiongen::kernel::response::Continuous<SdofOverdamped>,
);
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
    impl SdofOverdamped {
        /// ω_i, the natural frequencies, ascending: rad/s if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES: [f64; 1] = [1.0];
        /// √λ_i = ω_i√(m₁/k₁): the frequency ratios r of the undamped resonances.
        pub const RESONANCES: [f64; 1] = [1.0];
        /// φ, [mode][mass], with φᵀΓφ = 1 and Γ = diag(m_i/m₁); the first component of each that is not 0 is positive.
        pub const MODE_SHAPES: [[f64; 1]; 1] = [[1.0]];
        /// The chain: `damped`, whether a mode is; `inverse_mass` m* = m₁/(effective mass of the contact), `stiction` μ, static over kinetic friction.
        /// `on_moving_base`: none, as the contact does not rub on a moving base.
        const CHAIN: Chain<f64> = Chain {
            damped: true,
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
        /// β = F/P of a kinetic friction force F; `load` is P, the amplitude of the force.
        #[inline]
        #[must_use]
        pub const fn friction_ratio(friction: f64, load: f64) -> f64 {
            friction / load
        }
        /// The modes that the load or the contact drives: `resonance` √λ, `q` √|1 − ζ²|, `q_defect` 1 − q, `load` φᵀp,
        /// with p where the load acts; `contact` φᵀw, with w 1 at the mass that rubs and −1 at its partner; `residue` their
        /// product, `inverse_mass` (φᵀw)², `static_residue` residue/λ.  A mode is `Light` below ζ = 1/2, `Heavy` below 1, `Over` above;
        /// `in_contact`: φᵀw is not 0.
        const MODES: [Mode<f64>; 1] = [
            Mode {
                kind: Kind::Over,
                in_contact: true,
                resonance: 1.0,
                zeta: 1.5,
                q: 1.118033988749895,
                q_defect: 1.0623058987490537,
                load: 1.0,
                contact: 1.0,
                residue: 1.0,
                inverse_mass: 1.0,
                static_residue: 1.0,
            },
        ];
        /// `ends`: β*_lim for r → 0, both limits for r → ∞; `rubbing`: the mass that rubs on a support at rest; `absorbs`:
        /// V and H may share zeros, where the holding force says what a limit is; `unbounded`: undamped resonances that
        /// the load drives, `invisible`: those that the contact does not touch.
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
            unbounded: &[],
            invisible: &[],
        };
        /// The scene at the frequency ratio r = ω√(m₁/k₁).
        ///
        /// # Errors
        /// `OutOfDomain` for NaN and negative r; 0 and ∞ answer with the limits.
        #[inline]
        pub fn at(r: f64) -> Result<SdofOverdampedAt, OutOfDomain> {
            At::new(Self, r).map(From::from)
        }
        /// Both limits without search: |V|/√(U² + (H_c + μm*/r²)²) (5.64), an upper bound of β_lim that leaves S out, and
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
        /// `OutOfDomain` for slices of unequal lengths, before anything is written; and at the first NaN or negative r, after what precedes it is.
        pub fn limits_into(
            rs: &[f64],
            continuous: &mut [f64],
            sliding: &mut [f64],
        ) -> Result<(), OutOfDomain> {
            At::limits_into(Self, rs, continuous, sliding)
        }
        /// φ of `MODES`, [mass][mode].
        const SHAPES: [[f64; 1]; 1] = transposed(&Self::MODE_SHAPES);
        /// The response and damping functions V, U, G, H of the contact (3.11, 5.20, 5.34, 5.37, 7.11, 7.12), each
        /// times r²E with the scale E that keeps them finite on a resonance, and each mode's part in them.
        /// Of each mode `response` is 1/(x² − 1 + 2iζx) and R = 1/x.  Sums over modes: V of residue·`response`; H, U, G and r²H_c of
        /// (φᵀw)² times `response`, uR², gR² and g + 2ζRu (`reversal`).
        /// `inverse_r` is x = 1/r, as √λ is 1; `detuning` is x² − 1, `size` |x² − 1| + 2ζx, which is E, `scale`.
        /// `u` is uR².  It, `g` and `reversal` are multiplied by `size`, which removes the pole at x = 1; then by E over `size`.  `loss` is 2ζx.
        /// Overdamped: u = x·(2e/q) sinh(πqx)/D, g = (1 − e² − (2ζe/q) sinh(πqx))/D, D = (1 + exp(−fast))(1 + exp(−slow)), e = exp(−πζx).
        /// `fast_decay` and `slow_decay` are π(ζ ± q)x, `spread` their difference, `slow_decay_factor` exp(−slow), `decay_minus_one`
        /// exp(−fast/2) − 1; `pole_weight` is `size` over D, `u_times_r` uR times `size`.  g comes in three parts of the third order in x,
        /// of which the one subtracted is at most two thirds of the others.
        ///
        /// Operations: 62: 27 ×, 10 +, 10 sign, 7 ÷, 4 exp_m1, 2 exp, 2 scaled_sinh_defect.
        #[inline(always)]
        fn functions<const WITH_G: bool>(
            inverse_r: f64,
        ) -> (ContactAt<f64>, [ModeAt<f64>; 1]) {
            let detuning = (inverse_r - 1.0) * (inverse_r + 1.0);
            let loss = 3.0 * inverse_r;
            let size = Scalar::abs(detuning) + loss;
            let fast_decay = 8.224796345905053 * inverse_r;
            let slow_decay = 1.1999816148643265 * inverse_r;
            let slow_exponent = -slow_decay;
            let spread = 7.024814731040727 * inverse_r;
            let slow_decay_factor = Scalar::exp(slow_exponent);
            let pole_weight = size
                / ((1.0 + slow_decay_factor) * (1.0 + Scalar::exp(-fast_decay)));
            let u_times_r = -Scalar::exp_m1(-spread) * slow_decay_factor
                / 1.118033988749895 * pole_weight;
            let decay_minus_one = Scalar::exp_m1(-(fast_decay * 0.5));
            let u = u_times_r / inverse_r;
            let reversal = -Scalar::exp_m1(-(9.42477796076938 * inverse_r)) * pole_weight
                + 1.5 * u_times_r;
            let g = if WITH_G {
                (decay_minus_one * decay_minus_one * -Scalar::exp_m1(slow_exponent)
                    + 2.0 * (1.0 + decay_minus_one)
                        * Scalar::scaled_sinh_defect(slow_decay * 0.5)
                    - slow_decay_factor
                        * Scalar::scaled_sinh_defect(3.5124073655203634 * inverse_r)
                        / 2.9270509831248424) * pole_weight
            } else {
                0.0
            };
            let inverse_size = 1.0 / size;
            let unit_re = detuning * inverse_size;
            let unit_im = loss * inverse_size;
            let inverse_modulus = 1.0 / (unit_re * unit_re + unit_im * unit_im);
            let response_re = unit_re * inverse_modulus;
            let response_im = -(unit_im * inverse_modulus);
            let g_sum = g / (inverse_r * inverse_r);
            let contact = ContactAt {
                scale: size,
                v: Complex {
                    re: response_re,
                    im: response_im,
                },
                u,
                g: g_sum,
                reversal,
                h: Complex {
                    re: response_re,
                    im: response_im,
                },
            };
            let modes = [
                ModeAt {
                    x: inverse_r,
                    response: Complex {
                        re: response_re,
                        im: response_im,
                    },
                    u,
                    g,
                },
            ];
            (contact, modes)
        }
    }
    ::frictiongen::emitted_system!(SdofOverdamped, SdofOverdampedAt, f64, ["block"]);
    ::frictiongen::kernel::wraps!(SdofOverdampedAt, At of SdofOverdamped, Copy);
    impl Scene for SdofOverdamped {
        type Scalar = f64;
        type Decay = Damped<f64>;
        type Modes = [ModeAt<f64>; 1];
        type Waves = [Wave<f64, Damped<f64>>; 1];
        #[inline]
        fn numbers(&self) -> Numbers<'static, f64> {
            Self::NUMBERS
        }
        /// φ of a mass, by modes.
        #[inline]
        fn shape(&self, mass: usize) -> Option<&[f64]> {
            Self::SHAPES.get(mass).map(<[f64; 1]>::as_slice)
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
        /// All functions of the contact at 1/r, and of its modes.
        #[inline]
        fn frequency_stage(&self, inverse_r: f64) -> (ContactAt<f64>, [ModeAt<f64>; 1]) {
            Self::functions::<true>(inverse_r)
        }
        /// Those of the contact without G, which only a motion needs.
        #[inline]
        fn contact_without_g(&self, inverse_r: f64) -> ContactAt<f64> {
            Self::functions::<false>(inverse_r).0
        }
        /// r²E(H_c + μm*/r²) = `reversal` + μm*E: in β_lim it ensures that the contact breaks away at once at every reversal (5.63, 7.47).
        #[inline]
        fn break_away(&self, contact: &ContactAt<f64>) -> f64 {
            contact.reversal + contact.scale
        }
        /// β_lim = |V|/√(U² + max(S, H_c + μm*/r²)²) (5.65, 5.80, 5.96, 7.49), with S the largest F(τ)/sin τ over
        /// 0 < τ < π, F a sum over modes: with more friction the contact would reverse within the half period.
        /// `constraint` is r²E times that maximum.
        #[inline]
        fn continuous_limit(&self, contact: &ContactAt<f64>, constraint: f64) -> f64 {
            let modulus_v = Scalar::hypot(contact.v.re, contact.v.im);
            modulus_v / Scalar::sqrt(contact.u * contact.u + constraint * constraint)
        }
        /// β*_lim = |V|/(μ|H|) (6.11, 6.27, 6.33).
        ///
        /// The load acts on the mass that rubs: V = H.
        #[inline]
        fn sliding_limit(&self, _: &ContactAt<f64>) -> f64 {
            1.0
        }
    }
    ::frictiongen::kernel::not_provided!(
        SdofOverdampedAt : stuck, orbit; SdofOverdamped : simulation, stepper
    );
    impl ProvidesMotion for SdofOverdamped {
        type Motion = SdofOverdampedMotion;
        /// The relative motion in the contact, and each mode's part in it: `rise` times (1 − d)/x², `fall` times cos τ − d and
        /// `forced` times sin τ − R·q̃, with d and q̃ the mode's free decays from a displacement and from a velocity; `unscale`
        /// is 1/(r²E), `residue` φ_k(φᵀw)/r², for the harmonics.  `friction_force` is β/(r²E) times a mode's φ_k(φᵀw); `friction` has
        /// `root`, Q = √(|V|² − (βU)²) times r²E, and `amplitude`, Q − βG.
        #[allow(unused_variables)]
        fn contact_motion(at: &At<Self>, friction: &Friction<f64>) -> MotionOf<Self> {
            let (inverse_r, contact) = (at.inverse_ratio(), at.contact_sums());
            let [constants_1] = &Self::MODES;
            let [mode_1] = at.modes();
            let friction_weight = friction.beta * friction.unscale;
            let fall = friction_weight * (mode_1.g / (mode_1.x * mode_1.x));
            let rise = friction_weight * contact.scale;
            let forced = friction_weight * mode_1.u;
            let fundamental = Fundamental {
                cosine: friction.amplitude,
                sine: 0.0,
                response: Complex {
                    re: contact.v.re * friction.unscale,
                    im: contact.v.im * friction.unscale,
                },
            };
            let waves = [
                motion_wave(
                    mode_1.x,
                    <Damped<f64> as Decay<f64>>::of(constants_1),
                    ModalCoefficients {
                        rise,
                        fall,
                        forced,
                        residue: inverse_r * inverse_r,
                    },
                ),
            ];
            Motion::of_contact(*friction, fundamental, waves)
        }
    }
    ::frictiongen::kernel::wraps!(
        SdofOverdampedMotion, Continuous of SdofOverdamped, Copy
    );
    impl SdofOverdampedMotion {
        /// The motion of mass `block` (5.50 and its exact form, 7.29).
        ///
        /// It rubs on a support at rest: its motion is the contact's.
        #[must_use]
        pub fn block(&self) -> MotionOf<SdofOverdamped> {
            self.contact()
        }
    }
};
