/// One mass, damped: the exponentials appear.
///
/// Emitted by frictiongen 0.1.0 from scene d0657647b2ae48c0.
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
pub struct SdofDamped;
/// [`SdofDamped`] at one frequency ratio: limits, regime, continuous motion.
#[allow(deprecated, non_camel_case_types)]
pub struct SdofDampedAt(::frictiongen::kernel::response::At<SdofDamped>);
/// The exact continuous motion of [`SdofDamped`] at one frequency and one friction ratio.
#[allow(deprecated, non_camel_case_types)]
pub struct SdofDampedMotion(::frictiongen::kernel::response::Continuous<SdofDamped>);
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
    impl SdofDamped {
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
                kind: Kind::Light,
                in_contact: true,
                resonance: 1.0,
                zeta: 0.05,
                q: 0.998749217771909,
                q_defect: 0.0012507822280910543,
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
        pub fn at(r: f64) -> Result<SdofDampedAt, OutOfDomain> {
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
        /// Below critical damping: u = x·(2e/q) sin(πqx)/D, g = (1 − e² − (2ζe/q) sin(πqx))/D, D = 1 + 2e cos(πqx) + e².
        /// `decay_exponent` is πζx, `decay_factor` e = exp(−πζx), `half_decay_factor` its root, `decay_complement` 1 − e; `sine` and
        /// `cosine` are of πqx/2, the difference of πx/2 and π(1 − q)x/2, and sin(πqx) is twice their product; `half_turns` is qx.  D is
        /// |`nearness`|², of (1 + e) cos(πqx/2) + i(1 − e) sin(πqx/2); `inverse_nearness` is 1/(|re| + |im|), `pole_weight` `size` times that
        /// over |`unit_nearness`|²: their product is `size`/D, in two factors, so that neither overflows beside a resonance.  `u_times_r` is
        /// uR times `size`.  g·D is (1 − e² − 2ae) + 2ae(1 − sin(πqx)/(πqx)) with a = πζx: `scaled_sinh_defect` of a is the first bracket,
        /// `one_minus_sinc_pi` of qx the second, without cancellation.  `reversal`, g + 2ζRu, is (1 − e²)/D + ζuR.
        ///
        /// Operations: 63: 37 ×, 11 +, 6 ÷, 5 sign, 1 exp_m1, 1 one_minus_sinc_pi, 1 scaled_sinh_defect, 1 sin_cos_pi.
        #[inline(always)]
        fn functions<const WITH_G: bool>(
            inverse_r: f64,
        ) -> (ContactAt<f64>, [ModeAt<f64>; 1]) {
            let detuning = (inverse_r - 1.0) * (inverse_r + 1.0);
            let loss = 0.1 * inverse_r;
            let size = Scalar::abs(detuning) + loss;
            let decay_exponent = 0.15707963267948966 * inverse_r;
            let half_decay_minus_one = Scalar::exp_m1(decay_exponent * -0.5);
            let half_decay_factor = 1.0 + half_decay_minus_one;
            let decay_complement = -(half_decay_minus_one * (1.0 + half_decay_factor));
            let decay_factor = half_decay_factor * half_decay_factor;
            let half_turns = 0.998749217771909 * inverse_r;
            let (sine, cosine) = Scalar::sin_cos_pi_minus(
                inverse_r * 0.5,
                inverse_r * 0.0006253911140455271,
            );
            let one_plus_factor = 1.0 + decay_factor;
            let nearness_re = one_plus_factor * cosine;
            let nearness_im = decay_complement * sine;
            let inverse_nearness = 1.0
                / (Scalar::abs(nearness_re) + Scalar::abs(nearness_im));
            let unit_nearness_re = nearness_re * inverse_nearness;
            let unit_nearness_im = nearness_im * inverse_nearness;
            let pole_weight = size * inverse_nearness
                / (unit_nearness_re * unit_nearness_re
                    + unit_nearness_im * unit_nearness_im);
            let u_times_r = 4.005009394574071 * sine * decay_factor
                * (cosine * inverse_nearness) * pole_weight;
            let u = u_times_r / inverse_r;
            let reversal = one_plus_factor * (decay_complement * inverse_nearness)
                * pole_weight + 0.05 * u_times_r;
            let g = if WITH_G {
                (Scalar::scaled_sinh_defect(decay_exponent)
                    + 2.0 * decay_factor * decay_exponent
                        * Scalar::one_minus_sinc_pi(half_turns)) * inverse_nearness
                    * pole_weight
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
    ::frictiongen::emitted_system!(SdofDamped, SdofDampedAt, f64, ["block"]);
    ::frictiongen::kernel::wraps!(SdofDampedAt, At of SdofDamped, Copy);
    impl Scene for SdofDamped {
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
        SdofDampedAt : stuck, orbit; SdofDamped : simulation, stepper
    );
    impl ProvidesMotion for SdofDamped {
        type Motion = SdofDampedMotion;
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
    ::frictiongen::kernel::wraps!(SdofDampedMotion, Continuous of SdofDamped, Copy);
    impl SdofDampedMotion {
        /// The motion of mass `block` (5.50 and its exact form, 7.29).
        ///
        /// It rubs on a support at rest: its motion is the contact's.
        #[must_use]
        pub fn block(&self) -> MotionOf<SdofDamped> {
            self.contact()
        }
    }
};
