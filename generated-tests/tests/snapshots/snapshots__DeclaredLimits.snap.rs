/// Two masses and their limits, to a hundredth.
///
/// Emitted by frictiongen 0.1.0 from scene 54434a175b3a66b5.
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
pub struct DeclaredLimits;
/// [`DeclaredLimits`] at one frequency ratio: limits, regime.
#[allow(deprecated, non_camel_case_types)]
pub struct DeclaredLimitsAt(::frictiongen::kernel::table::Compiled<DeclaredLimits>);
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
    impl DeclaredLimits {
        /// ω_i, the natural frequencies, ascending: rad/s if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES: [f32; 2] = [0.618034, 1.618034];
        /// √λ_i = ω_i√(m₁/k₁): the frequency ratios r of the undamped resonances.
        pub const RESONANCES: [f32; 2] = [0.618034, 1.618034];
        /// φ, [mode][mass], with φᵀΓφ = 1 and Γ = diag(m_i/m₁); the first component of each that is not 0 is positive.
        pub const MODE_SHAPES: [[f32; 2]; 2] = [
            [0.5257311, 0.8506508],
            [0.8506508, -0.5257311],
        ];
        /// The chain: `damped`, whether a mode is; `inverse_mass` m* = m₁/(effective mass of the contact), `stiction` μ, static over kinetic friction.
        /// `on_moving_base`: none, as the contact does not rub on a moving base.
        const CHAIN: Chain<f32> = Chain {
            damped: true,
            on_moving_base: None,
            inverse_mass: 1.0,
            stiction: 1.0,
        };
        /// An angular frequency, rad/s, as frequency ratio r = ω√(m₁/k₁).
        #[inline]
        #[must_use]
        pub const fn frequency_ratio(omega: f32) -> f32 {
            omega
        }
        /// β = F/P of a kinetic friction force F; `load` is P, the amplitude of the force.
        #[inline]
        #[must_use]
        pub const fn friction_ratio(friction: f32, load: f32) -> f32 {
            friction / load
        }
        /// The modes that the load or the contact drives: `resonance` √λ, `q` √|1 − ζ²|, `q_defect` 1 − q, `load` φᵀp,
        /// with p where the load acts; `contact` φᵀw, with w 1 at the mass that rubs and −1 at its partner; `residue` their
        /// product, `inverse_mass` (φᵀw)², `static_residue` residue/λ.  A mode is `Light` below ζ = 1/2, `Heavy` below 1, `Over` above;
        /// `in_contact`: φᵀw is not 0.
        const MODES: [Mode<f32>; 2] = [
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 0.618034,
                zeta: 0.05,
                q: 0.9987492,
                q_defect: 0.0012507823,
                load: 0.5257311,
                contact: 0.8506508,
                residue: 0.4472136,
                inverse_mass: 0.7236068,
                static_residue: 1.1708204,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 1.618034,
                zeta: 0.05,
                q: 0.9987492,
                q_defect: 0.0012507823,
                load: 0.8506508,
                contact: -0.5257311,
                residue: -0.4472136,
                inverse_mass: 0.2763932,
                static_residue: -0.1708204,
            },
        ];
        /// `ends`: β*_lim for r → 0, both limits for r → ∞; `rubbing`: the mass that rubs on a support at rest; `absorbs`:
        /// V and H may share zeros, where the holding force says what a limit is; `unbounded`: undamped resonances that
        /// the load drives, `invisible`: those that the contact does not touch.
        const NUMBERS: Numbers<'static, f32> = Numbers {
            modes: &Self::MODES,
            chain: Self::CHAIN,
            ends: Ends {
                sliding_at_rest: 0.5,
                continuous_at_infinity: 0.0,
                sliding_at_infinity: 0.0,
            },
            rubbing: Some(1),
            absorbs: false,
            unbounded: &[],
            invisible: &[],
        };
        /// The scene at the frequency ratio r = ω√(m₁/k₁), to the declared accuracy.
        ///
        /// # Errors
        /// `OutOfDomain` beyond the declared range, and for NaN.
        #[inline]
        pub fn at(r: f32) -> Result<DeclaredLimitsAt, OutOfDomain> {
            Compiled::new(Self, r).map(From::from)
        }
        /// Both limits without search: |V|/√(U² + (H_c + μm*/r²)²) (5.64), an upper bound of β_lim that leaves S out, and
        /// β*_lim (6.11, 6.27, 6.33).  Where nothing else is asked of r, this is the shortest way.
        ///
        /// # Errors
        /// `OutOfDomain` for NaN and negative r; 0 and ∞ answer with the limits.
        #[inline]
        pub fn limits_without_search(r: f32) -> Result<Limits<f32>, OutOfDomain> {
            At::limits_without_search(&Self, r)
        }
        /// Both limits over a slice of frequency ratios, into slices of the same length.
        ///
        /// # Errors
        /// `OutOfDomain` for slices of unequal lengths, before anything is written; and at the first r out of the domain, as of `at`, after what precedes it is.
        pub fn limits_into(
            rs: &[f32],
            continuous: &mut [f32],
            sliding: &mut [f32],
        ) -> Result<(), OutOfDomain> {
            Compiled::limits_into(Self, rs, continuous, sliding)
        }
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
            mode: &Mode<f32>,
            inverse_r: f32,
        ) -> ModeResponse<f32> {
            let x = mode.resonance * inverse_r;
            let detuning = (x - 1.0) * (x + 1.0);
            let loss = 2.0 * mode.zeta * x;
            let size = Scalar::abs(detuning) + loss;
            let decay_exponent = 3.1415927 * mode.zeta * x;
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
            inverse_r: f32,
        ) -> (ContactAt<f32>, [ModeAt<f32>; 2]) {
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
        /// β_lim over r from 0.5 to 2, to 1e-2:
        /// 6 pieces of degree 3, each Σ coefficients[j]·(r − origin)^j, and 8 buckets of 1/density; with β*_lim 176 bytes.
        /// Largest error 8.9e-3, at r = 0.5671188235282898: checked at 717 points that the fit did not see.
        const TABLE: Table<'static, f32, ::core::primitive::u8, 1, 4> = Table {
            low: 0.5,
            density: 5.333333,
            halvings: 2,
            buckets: &[0, 2, 2, 2, 3, 3, 4, 5],
            pieces: &[
                Piece {
                    from: 0.5,
                    origin: 0.526,
                    coefficients: [[0.316416, -0.2118, 46.296, 1409.4]],
                },
                Piece {
                    from: 0.55100006,
                    origin: 0.61,
                    coefficients: [[0.431202, 0.03878, -10.226, 152.02]],
                },
                Piece {
                    from: 0.66800004,
                    origin: 0.95,
                    coefficients: [[0.471414, 0.43586, 1.41924, 1.5812]],
                },
                Piece {
                    from: 1.23,
                    origin: 1.35,
                    coefficients: [[1.041401, 3.10322, 0.3456, -42.465]],
                },
                Piece {
                    from: 1.4710001,
                    origin: 1.58,
                    coefficients: [[1.084192, -3.87124, -4.3694, 87.268]],
                },
                Piece {
                    from: 1.684,
                    origin: 1.84,
                    coefficients: [[0.439482, -1.22154, 3.0542, -5.9054]],
                },
            ],
        };
        /// β*_lim as a product over its zeros and poles: `Zero` is (r − at − rest)(r + at), `Pair`
        /// (that + off)² + least, `Real` r² + off.
        const SLIDING_LIMIT: Quotient<'static, f32> = Quotient {
            gain: 0.04472136,
            squared: true,
            numerator: &[Factor::Real { off: 500.0 }],
            denominator: &[
                Factor::Pair {
                    at: 1.4126216,
                    rest: 5.885799e-8,
                    off: 0.0045,
                    least: 0.035919,
                },
            ],
        };
    }
    ::frictiongen::emitted_system!(
        DeclaredLimits, DeclaredLimitsAt, f32, ["lower", "upper"]
    );
    ::frictiongen::kernel::wraps!(
        DeclaredLimitsAt, Compiled of tabled DeclaredLimits, Copy
    );
    impl Scene for DeclaredLimits {
        type Scalar = f32;
        type Decay = Damped<f32>;
        type Modes = [ModeAt<f32>; 2];
        type Waves = [Wave<f32, Damped<f32>>; 2];
        #[inline]
        fn numbers(&self) -> Numbers<'static, f32> {
            Self::NUMBERS
        }
        /// φ of a mass, by modes: of none here, as no motion of a mass is provided.
        #[inline]
        fn shape(&self, _: usize) -> Option<&[f32]> {
            None
        }
        /// The smallest and the largest 1/r at which the formulas are evaluated: beyond, squares leave the scalar's range.
        #[inline]
        fn inverse_ratio_range(&self) -> (f32, f32) {
            (8.881784e-16, 1125899900000000.0)
        }
        /// Working space of the searches, and of the waves of a motion.
        #[inline]
        fn idle(&self) -> Self::Waves {
            Self::MODES.map(|mode| Wave::idle(&mode))
        }
        /// All functions of the contact at 1/r, and of its modes.
        #[inline]
        fn frequency_stage(&self, inverse_r: f32) -> (ContactAt<f32>, [ModeAt<f32>; 2]) {
            Self::functions::<true>(inverse_r)
        }
        /// Those of the contact without G, which only a motion needs.
        #[inline]
        fn contact_without_g(&self, inverse_r: f32) -> ContactAt<f32> {
            Self::functions::<false>(inverse_r).0
        }
        /// r²E(H_c + μm*/r²) = `reversal` + μm*E: in β_lim it ensures that the contact breaks away at once at every reversal (5.63, 7.47).
        #[inline]
        fn break_away(&self, contact: &ContactAt<f32>) -> f32 {
            contact.reversal + contact.scale
        }
        /// β_lim = |V|/√(U² + max(S, H_c + μm*/r²)²) (5.65, 5.80, 5.96, 7.49), with S the largest F(τ)/sin τ over
        /// 0 < τ < π, F a sum over modes: with more friction the contact would reverse within the half period.
        /// `constraint` is r²E times that maximum.
        #[inline]
        fn continuous_limit(&self, contact: &ContactAt<f32>, constraint: f32) -> f32 {
            let modulus_v = Scalar::hypot(contact.v.re, contact.v.im);
            modulus_v / Scalar::sqrt(contact.u * contact.u + constraint * constraint)
        }
        /// β*_lim = |V|/(μ|H|) (6.11, 6.27, 6.33).
        #[inline]
        fn sliding_limit(&self, contact: &ContactAt<f32>) -> f32 {
            let modulus_v = Scalar::hypot(contact.v.re, contact.v.im);
            let modulus_h = Scalar::hypot(contact.h.re, contact.h.im);
            modulus_v / modulus_h
        }
    }
    impl Tabled for DeclaredLimits {
        /// Where the tables hold.
        #[inline]
        fn domain(&self) -> Domain<f32> {
            Domain {
                r: (0.5, 2.0),
                beta: (0.0, ::core::f32::INFINITY),
                exact_beyond: false,
                always_continuous: false,
                never_stuck: false,
            }
        }
        /// β_lim (5.65, 5.80, 5.96, 7.49) from the table.
        ///
        /// Proven at every r: at most 9.93e-3 off, the bound being largest at r = 1.5726152692115718.
        ///
        /// Operations at every r: a lookup of 2 comparisons, 10 additions and multiplications.
        #[inline]
        fn tabled_limit(&self, r: f32) -> f32 {
            Self::TABLE.first(r)
        }
        /// β*_lim = |V|/(μ|H|) (6.11, 6.27, 6.33).
        ///
        /// Proven at every r: at most 7.36e-7 off, the bound being largest at r = 0.7281554190437972.
        ///
        /// Operations: 12 additions and multiplications, 1 divisions, 1 roots; largest error seen 2.2e-7.
        #[inline]
        fn tabled_sliding_limit(&self, r: f32) -> Option<f32> {
            Some(Self::SLIDING_LIMIT.size(r))
        }
    }
    ::frictiongen::kernel::not_provided!(
        DeclaredLimitsAt : motion, stuck, orbit; DeclaredLimits : simulation, stepper
    );
};
