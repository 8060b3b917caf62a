/// A spring graph with a wall spring, a second base spring and Rayleigh damping.
///
/// Emitted by frictiongen 0.1.0 from scene e83b5dca6752b54f.
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
pub struct Braced;
/// [`Braced`] at one frequency ratio: limits, regime, continuous motion.
#[allow(deprecated, non_camel_case_types)]
pub struct BracedAt(::frictiongen::kernel::response::At<Braced>);
/// The exact continuous motion of [`Braced`] at one frequency and one friction ratio.
#[allow(deprecated, non_camel_case_types)]
pub struct BracedMotion(::frictiongen::kernel::response::Continuous<Braced>);
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
    impl Braced {
        /// ω_i, the natural frequencies, ascending: rad/s if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES: [f64; 2] = [
            1.0284002101783678,
            1.4722068494967306,
        ];
        /// √λ_i = ω_i√(m₁/k₁): the frequency ratios r of the undamped resonances.
        pub const RESONANCES: [f64; 2] = [1.0284002101783678, 1.4722068494967306];
        /// φ, [mode][mass], with φᵀΓφ = 1 and Γ = diag(m_i/m₁); the first component of each that is not 0 is positive.
        pub const MODE_SHAPES: [[f64; 2]; 2] = [
            [0.613271751551687, 1.2488972723454137],
            [0.7898719888366252, -0.9696677797721163],
        ];
        /// The chain: `damped`, whether a mode is; `inverse_mass` m* = m₁/(effective mass of the contact), `stiction` μ, static over kinetic friction.
        /// `on_moving_base`: none, as the contact does not rub on a moving base.
        const CHAIN: Chain<f64> = Chain {
            damped: true,
            on_moving_base: None,
            inverse_mass: 2.5,
            stiction: 1.0,
        };
        /// An angular frequency, rad/s, as frequency ratio r = ω√(m₁/k₁).
        #[inline]
        #[must_use]
        pub const fn frequency_ratio(omega: f64) -> f64 {
            omega
        }
        /// β = F/(k₁Y) of a kinetic friction force F; `load` is k₁Y, Y the amplitude of the base's motion.
        #[inline]
        #[must_use]
        pub const fn friction_ratio(friction: f64, load: f64) -> f64 {
            friction / load
        }
        /// The modes that the load or the contact drives: `resonance` √λ, `q` √|1 − ζ²|, `q_defect` 1 − q, `load` φᵀp,
        /// with p where the load acts; `contact` φᵀw, with w 1 at the mass that rubs and −1 at its partner; `residue` their
        /// product, `inverse_mass` (φᵀw)², `static_residue` residue/λ.  A mode is `Light` below ζ = 1/2, `Heavy` below 1, `Over` above;
        /// `in_contact`: φᵀw is not 0.
        const MODES: [Mode<f64>; 2] = [
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 1.0284002101783678,
                zeta: 0.08921292842710984,
                q: 0.9960125769293575,
                q_defect: 0.0039874230706424575,
                load: 0.9254960696380404,
                contact: 1.2488972723454137,
                residue: 1.15584951693735,
                inverse_mass: 1.5597443968718145,
                static_residue: 1.0928913342651618,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 1.4722068494967306,
                zeta: 0.12639419910221375,
                q: 0.9919800937686754,
                q_defect: 0.008019906231324644,
                load: 0.5474550438935962,
                contact: -0.9696677797721163,
                residue: -0.5308495169373498,
                inverse_mass: 0.9402556031281853,
                static_residue: -0.24492536196720122,
            },
        ];
        /// `ends`: β*_lim for r → 0, both limits for r → ∞; `rubbing`: the mass that rubs on a support at rest; `absorbs`:
        /// V and H may share zeros, where the holding force says what a limit is; `unbounded`: undamped resonances that
        /// the load drives, `invisible`: those that the contact does not touch.
        const NUMBERS: Numbers<'static, f64> = Numbers {
            modes: &Self::MODES,
            chain: Self::CHAIN,
            ends: Ends {
                sliding_at_rest: 0.4442857142857143,
                continuous_at_infinity: 0.13425731803657878,
                sliding_at_infinity: 0.25,
            },
            rubbing: Some(1),
            absorbs: false,
            unbounded: &[],
            invisible: &[],
        };
        /// The scene at the frequency ratio r = ω√(m₁/k₁).
        ///
        /// # Errors
        /// `OutOfDomain` for NaN and negative r; 0 and ∞ answer with the limits.
        #[inline]
        pub fn at(r: f64) -> Result<BracedAt, OutOfDomain> {
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
        const SHAPES: [[f64; 2]; 2] = transposed(&Self::MODE_SHAPES);
        /// The functions of a lightly damped mode, ζ < 1/2.
        /// `x` is √λ/r = 1/R, `detuning` x² − 1, `size` |x² − 1| + 2ζx; E, `scale`, is the least of the modes in contact.
        /// `u` is uR².  It, `g` and `reversal` are multiplied by `size`, which removes the pole at x = 1; then by E over `size`.  `loss` is 2ζx.
        /// Below critical damping: u = x·(2e/q) sin(πqx)/D, g = (1 − e² − (2ζe/q) sin(πqx))/D, D = 1 + 2e cos(πqx) + e².
        /// `decay_exponent` is πζx, `decay_factor` e = exp(−πζx), `half_decay_factor` its root, `decay_complement` 1 − e; `sine` and
        /// `cosine` are of πqx/2, the difference of πx/2 and π(1 − q)x/2, and sin(πqx) is twice their product; `half_turns` is qx.  D is
        /// |`nearness`|², of (1 + e) cos(πqx/2) + i(1 − e) sin(πqx/2); `inverse_nearness` is 1/(|re| + |im|), `pole_weight` `size` times that
        /// over |`unit_nearness`|²: their product is `size`/D, in two factors, so that neither overflows beside a resonance.  `u_times_r` is
        /// uR times `size`.  g·D is (1 − e² − 2ae) + 2ae(1 − sin(πqx)/(πqx)) with a = πζx: `scaled_sinh_defect` of a is the first bracket,
        /// `one_minus_sinc_pi` of qx the second, without cancellation.  `reversal`, g + 2ζRu, is (1 − e²)/D + ζuR.
        #[inline(always)]
        fn damped_mode<const WITH_G: bool>(
            mode: &Mode<f64>,
            inverse_r: f64,
        ) -> ModeResponse<f64> {
            let x = mode.resonance * inverse_r;
            let detuning = (x - 1.0) * (x + 1.0);
            let loss = 2.0 * mode.zeta * x;
            let size = Scalar::abs(detuning) + loss;
            let decay_exponent = 3.141592653589793 * mode.zeta * x;
            let half_decay_minus_one = Scalar::exp_m1(decay_exponent * -0.5);
            let half_decay_factor = 1.0 + half_decay_minus_one;
            let decay_complement = -(half_decay_minus_one * (1.0 + half_decay_factor));
            let decay_factor = half_decay_factor * half_decay_factor;
            let half_turns = mode.q * x;
            let (sine, cosine) = Scalar::sin_cos_pi_minus(
                x * 0.5,
                x * (mode.q_defect * 0.5),
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
            let u_times_r = 4.0 / mode.q * sine * decay_factor
                * (cosine * inverse_nearness) * pole_weight;
            let u = u_times_r / x;
            let reversal = one_plus_factor * (decay_complement * inverse_nearness)
                * pole_weight + mode.zeta * u_times_r;
            let g = if WITH_G {
                (Scalar::scaled_sinh_defect(decay_exponent)
                    + 2.0 * decay_factor * decay_exponent
                        * Scalar::one_minus_sinc_pi(half_turns)) * inverse_nearness
                    * pole_weight
            } else {
                0.0
            };
            ModeResponse {
                x,
                denominator: Complex { re: detuning, im: loss },
                size,
                u,
                g,
                reversal,
            }
        }
        /// The response and damping functions V, U, G, H of the contact (3.11, 5.20, 5.34, 5.37, 7.11, 7.12), each
        /// times r²E with the scale E that keeps them finite on a resonance, and each mode's part in them.
        /// Of each mode `response` is 1/(x² − 1 + 2iζx) and R = 1/x.  Sums over modes: V of residue·`response`; H, U, G and r²H_c of
        /// (φᵀw)² times `response`, uR², gR² and g + 2ζRu (`reversal`).
        /// `at_scale` has `response`, u and g of a mode times E: the last two times E over `size`.
        ///
        /// Operations: 164: 102 ×, 29 +, 14 ÷, 10 sign, 2 exp_m1, 2 one_minus_sinc_pi, 2 scaled_sinh_defect, 2 sin_cos_pi, 1 compare.
        #[inline(always)]
        fn functions<const WITH_G: bool>(
            inverse_r: f64,
        ) -> (ContactAt<f64>, [ModeAt<f64>; 2]) {
            let [constants_1, constants_2] = &Self::MODES;
            let mode_1 = Self::damped_mode::<WITH_G>(constants_1, inverse_r);
            let mode_2 = Self::damped_mode::<WITH_G>(constants_2, inverse_r);
            let scale = Scalar::min(mode_1.size, mode_2.size);
            let modes = [
                Self::CHAIN.at_scale(&mode_1, scale),
                Self::CHAIN.at_scale(&mode_2, scale),
            ];
            let [at_1, at_2] = &modes;
            let v_re = at_1.response.re * constants_1.residue
                + at_2.response.re * constants_2.residue;
            let v_im = at_1.response.im * constants_1.residue
                + at_2.response.im * constants_2.residue;
            let h_re = at_1.response.re * constants_1.inverse_mass
                + at_2.response.re * constants_2.inverse_mass;
            let h_im = at_1.response.im * constants_1.inverse_mass
                + at_2.response.im * constants_2.inverse_mass;
            let u = constants_1.inverse_mass * at_1.u
                + constants_2.inverse_mass * at_2.u;
            let reversal = constants_1.inverse_mass
                * (mode_1.reversal * (scale / mode_1.size))
                + constants_2.inverse_mass * (mode_2.reversal * (scale / mode_2.size));
            let g_sum = if WITH_G {
                constants_1.inverse_mass * (at_1.g / (at_1.x * at_1.x))
                    + constants_2.inverse_mass * (at_2.g / (at_2.x * at_2.x))
            } else {
                0.0
            };
            let contact = ContactAt {
                scale,
                v: Complex { re: v_re, im: v_im },
                u,
                g: g_sum,
                reversal,
                h: Complex { re: h_re, im: h_im },
            };
            (contact, modes)
        }
    }
    ::frictiongen::emitted_system!(Braced, BracedAt, f64, ["left", "right"]);
    ::frictiongen::kernel::wraps!(BracedAt, At of Braced, Copy);
    impl Scene for Braced {
        type Scalar = f64;
        type Decay = Damped<f64>;
        type Modes = [ModeAt<f64>; 2];
        type Waves = [Wave<f64, Damped<f64>>; 2];
        #[inline]
        fn numbers(&self) -> Numbers<'static, f64> {
            Self::NUMBERS
        }
        /// φ of a mass, by modes.
        #[inline]
        fn shape(&self, mass: usize) -> Option<&[f64]> {
            Self::SHAPES.get(mass).map(<[f64; 2]>::as_slice)
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
        fn frequency_stage(&self, inverse_r: f64) -> (ContactAt<f64>, [ModeAt<f64>; 2]) {
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
            contact.reversal + 2.5 * contact.scale
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
        #[inline]
        fn sliding_limit(&self, contact: &ContactAt<f64>) -> f64 {
            let modulus_v = Scalar::hypot(contact.v.re, contact.v.im);
            let modulus_h = Scalar::hypot(contact.h.re, contact.h.im);
            modulus_v / modulus_h
        }
    }
    ::frictiongen::kernel::not_provided!(
        BracedAt : stuck, orbit; Braced : simulation, stepper
    );
    impl ProvidesMotion for Braced {
        type Motion = BracedMotion;
        /// The relative motion in the contact, and each mode's part in it: `rise` times (1 − d)/x², `fall` times cos τ − d and
        /// `forced` times sin τ − R·q̃, with d and q̃ the mode's free decays from a displacement and from a velocity; `unscale`
        /// is 1/(r²E), `residue` φ_k(φᵀw)/r², for the harmonics.  `friction_force` is β/(r²E) times a mode's φ_k(φᵀw); `friction` has
        /// `root`, Q = √(|V|² − (βU)²) times r²E, and `amplitude`, Q − βG.
        #[allow(unused_variables)]
        fn contact_motion(at: &At<Self>, friction: &Friction<f64>) -> MotionOf<Self> {
            let (inverse_r, contact) = (at.inverse_ratio(), at.contact_sums());
            let [constants_1, constants_2] = &Self::MODES;
            let [mode_1, mode_2] = at.modes();
            let friction_weight = friction.beta * friction.unscale;
            let mode_1_friction_force = friction_weight * constants_1.inverse_mass;
            let mode_1_fall = mode_1_friction_force * (mode_1.g / (mode_1.x * mode_1.x));
            let mode_1_rise = mode_1_friction_force * contact.scale;
            let mode_1_forced = mode_1_friction_force * mode_1.u;
            let mode_2_friction_force = friction_weight * constants_2.inverse_mass;
            let mode_2_fall = mode_2_friction_force * (mode_2.g / (mode_2.x * mode_2.x));
            let mode_2_rise = mode_2_friction_force * contact.scale;
            let mode_2_forced = mode_2_friction_force * mode_2.u;
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
                        rise: mode_1_rise,
                        fall: mode_1_fall,
                        forced: mode_1_forced,
                        residue: constants_1.inverse_mass * inverse_r * inverse_r,
                    },
                ),
                motion_wave(
                    mode_2.x,
                    <Damped<f64> as Decay<f64>>::of(constants_2),
                    ModalCoefficients {
                        rise: mode_2_rise,
                        fall: mode_2_fall,
                        forced: mode_2_forced,
                        residue: constants_2.inverse_mass * inverse_r * inverse_r,
                    },
                ),
            ];
            Motion::of_contact(*friction, fundamental, waves)
        }
        /// The motion of a mass k, in the same coefficients.  `driven` is a mode's φ_k(φᵀp)·`response`, their sum V_k; `rubbed_back`
        /// is −φ_k(φᵀw)·u, their sum −U_k; `mismatch` is V_kU − U_kV, in which each mode's product with itself, which would cancel,
        /// is left out: `v_term` and `u_term` are a mode's own in V and U, `v_others` and `u_others` what is left without them.  Where
        /// x < 1/2 the mode is mass-controlled: `mass_wave` has all of its response, so that `u_in_sum` and `offset`, else u and g, are 0
        /// and `u_others` is all of U.
        /// `…_in_range` is times 2²⁴ = 16777216, or over it, which keeps products within the scalar's range and cancels.  `inverse` is
        /// 1/V by way of `unit`, V over its `size`, |re| + |im|; `turning` is V less a mode's own term, or V where that is smaller,
        /// as a mode is in phase with its own; `in_phase_over_v` is `root` over that `size`.
        #[allow(unused_variables)]
        fn mass_motion(
            at: &At<Self>,
            friction: &Friction<f64>,
            mass: usize,
        ) -> Option<MotionOf<Self>> {
            let (inverse_r, contact) = (at.inverse_ratio(), at.contact_sums());
            let [constants_1, constants_2] = &Self::MODES;
            let [mode_1, mode_2] = at.modes();
            if mass != 0 {
                return None;
            }
            let mode_2_v_term_re = mode_2.response.re * constants_2.residue;
            let mode_2_v_term_im = mode_2.response.im * constants_2.residue;
            let mode_2_u_term = constants_2.inverse_mass * mode_2.u;
            let mode_1_u_others = if mode_1.x < 0.5 { contact.u } else { mode_2_u_term };
            let mode_1_v_term_re = mode_1.response.re * constants_1.residue;
            let mode_1_v_term_im = mode_1.response.im * constants_1.residue;
            let mode_1_u_term = constants_1.inverse_mass * mode_1.u;
            let mode_2_u_others = if mode_2.x < 0.5 { contact.u } else { mode_1_u_term };
            let mode_1_driven_re = mode_1.response.re * 0.5675805956811232;
            let mode_1_driven_im = mode_1.response.im * 0.5675805956811232;
            let mode_1_offset = if mode_1.x < 0.5 { 0.0 } else { mode_1.g };
            let mode_1_u_in_sum = if mode_1.x < 0.5 { 0.0 } else { mode_1.u };
            let mode_1_rubbed_back = -(0.7659134177193961 * mode_1_u_in_sum);
            let mode_1_fall_per_force = mode_1_offset / (mode_1.x * mode_1.x);
            let mode_2_driven_re = mode_2.response.re * 0.4324194043188768;
            let mode_2_driven_im = mode_2.response.im * 0.4324194043188768;
            let mode_2_offset = if mode_2.x < 0.5 { 0.0 } else { mode_2.g };
            let mode_2_u_in_sum = if mode_2.x < 0.5 { 0.0 } else { mode_2.u };
            let mode_2_rubbed_back = -(-0.7659134177193963 * mode_2_u_in_sum);
            let mode_2_fall_per_force = mode_2_offset / (mode_2.x * mode_2.x);
            let response_re = mode_1_driven_re + mode_2_driven_re;
            let response_im = mode_1_driven_im + mode_2_driven_im;
            let mismatch_re = mode_1_driven_re * mode_1_u_others
                + mode_2_v_term_re * mode_1_rubbed_back
                + (mode_2_driven_re * mode_2_u_others
                    + mode_1_v_term_re * mode_2_rubbed_back);
            let mismatch_im = mode_1_driven_im * mode_1_u_others
                + mode_2_v_term_im * mode_1_rubbed_back
                + (mode_2_driven_im * mode_2_u_others
                    + mode_1_v_term_im * mode_2_rubbed_back);
            let v_in_range_re = contact.v.re * 16777216.0;
            let v_in_range_im = contact.v.im * 16777216.0;
            let inverse_size = 1.0
                / (Scalar::abs(v_in_range_re) + Scalar::abs(v_in_range_im));
            let unit_re = v_in_range_re * inverse_size;
            let unit_im = v_in_range_im * inverse_size;
            let inverse_modulus = inverse_size / (unit_re * unit_re + unit_im * unit_im);
            let inverse_re = unit_re * inverse_modulus;
            let inverse_im = -(unit_im * inverse_modulus);
            let root_in_range = friction.root * 16777216.0;
            let friction_weight = friction.beta * friction.unscale;
            let beta_in_range = friction.beta * 16777216.0;
            let v_size = Scalar::abs(contact.v.re) + Scalar::abs(contact.v.im);
            let mode_2_turning_re = if Scalar::abs(mode_1_v_term_re)
                + Scalar::abs(mode_1_v_term_im) < v_size
            {
                mode_1_v_term_re
            } else {
                contact.v.re
            };
            let mode_2_turning_im = if Scalar::abs(mode_1_v_term_re)
                + Scalar::abs(mode_1_v_term_im) < v_size
            {
                mode_1_v_term_im
            } else {
                contact.v.im
            };
            let mode_1_turning_re = if Scalar::abs(mode_2_v_term_re)
                + Scalar::abs(mode_2_v_term_im) < v_size
            {
                mode_2_v_term_re
            } else {
                contact.v.re
            };
            let mode_1_turning_im = if Scalar::abs(mode_2_v_term_re)
                + Scalar::abs(mode_2_v_term_im) < v_size
            {
                mode_2_v_term_im
            } else {
                contact.v.im
            };
            let in_phase_over_v = root_in_range * inverse_size;
            let mode_1_friction_force = friction_weight * 0.7659134177193961;
            let mode_1_fall = mode_1_friction_force * mode_1_fall_per_force;
            let mode_1_rise = mode_1_friction_force * contact.scale;
            let mode_1_forced = mode_1_friction_force * mode_1_u_in_sum;
            let mode_2_friction_force = friction_weight * -0.7659134177193963;
            let mode_2_fall = mode_2_friction_force * mode_2_fall_per_force;
            let mode_2_rise = mode_2_friction_force * contact.scale;
            let mode_2_forced = mode_2_friction_force * mode_2_u_in_sum;
            let (fundamental, waves) = (
                Fundamental {
                    cosine: (root_in_range
                        * (response_re * inverse_re - response_im * inverse_im)
                        + beta_in_range
                            * (mismatch_re * inverse_im + mismatch_im * inverse_re))
                        * friction.unscale
                        + (-(0.7659134177193961 * mode_1_fall_per_force)
                            - -0.7659134177193963 * mode_2_fall_per_force)
                            * friction_weight,
                    sine: (beta_in_range
                        * (mismatch_re * inverse_re - mismatch_im * inverse_im)
                        - in_phase_over_v
                            * (mode_1_driven_im
                                * (mode_1_turning_re * 16777216.0 * inverse_modulus)
                                - mode_1_driven_re
                                    * (mode_1_turning_im * 16777216.0 * inverse_modulus)
                                + (mode_2_driven_im
                                    * (mode_2_turning_re * 16777216.0 * inverse_modulus)
                                    - mode_2_driven_re
                                        * (mode_2_turning_im * 16777216.0 * inverse_modulus))))
                        * friction.unscale,
                    response: Complex {
                        re: response_re * friction.unscale,
                        im: response_im * friction.unscale,
                    },
                },
                [
                    mass_wave(
                        mode_1.x,
                        <Damped<f64> as Decay<f64>>::of(constants_1),
                        ModalCoefficients {
                            rise: mode_1_rise,
                            fall: mode_1_fall,
                            forced: mode_1_forced,
                            residue: 0.7659134177193961 * inverse_r * inverse_r,
                        },
                    ),
                    mass_wave(
                        mode_2.x,
                        <Damped<f64> as Decay<f64>>::of(constants_2),
                        ModalCoefficients {
                            rise: mode_2_rise,
                            fall: mode_2_fall,
                            forced: mode_2_forced,
                            residue: -0.7659134177193963 * inverse_r * inverse_r,
                        },
                    ),
                ],
            );
            Some(Motion::of_mass(*friction, fundamental, waves))
        }
    }
    ::frictiongen::kernel::wraps!(BracedMotion, Continuous of Braced, Copy);
    impl BracedMotion {
        /// The motion of mass `left` (5.50 and its exact form, 7.29).
        #[must_use]
        pub fn left(&self) -> MotionOf<Braced> {
            self.mass(0)
        }
        /// The motion of mass `right` (5.50 and its exact form, 7.29).
        ///
        /// It rubs on a support at rest: its motion is the contact's.
        #[must_use]
        pub fn right(&self) -> MotionOf<Braced> {
            self.contact()
        }
    }
};
