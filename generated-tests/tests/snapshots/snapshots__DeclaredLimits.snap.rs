/// Two masses and their limits, to a hundredth.
///
/// Emitted by `friction_system!` of frictiongen 0.1.0 from scene 54434a175b3a66b5.  Change the description, not this code.
///
/// # Description
///
/// ```text
/// pub struct DeclaredLimits {
///             masses: { lower: 1.0, upper: 1.0 },
///             springs: { base - lower: 1.0, lower - upper: 1.0 },
///             contact: upper - wall,
///             excitation: lower,
///             damping: modal(0.05),
///             scalar: f32,
///             provide: [limits],
///             accuracy: 1e-2,
///             range: { r: 0.5..2.0 },
///         }
/// ```
///
/// The motion in the contact is the displacement of `upper`.
///
/// # What it offers
///
/// * `K1`, `M1`, `NATURAL_FREQUENCIES_HZ`, `NATURAL_FREQUENCIES`, `RESONANCES`, `MODE_SHAPES`, `SCENE_HASH`: constants of the chain
/// * `frequency_ratio(omega)`, `friction_ratio(friction, load)`: r and β from units
/// * `at(r)` returns [`DeclaredLimitsAt`], with `limits()` (β_lim and β*_lim), `regime(beta)` (continuous, stick-slip, stuck or bistable) and `margin(beta)` (β/min(β_lim, β*_lim) − 1, negative below both limits), or an error outside the declared range of r
/// * `limits_without_search(r)`: an upper bound on β_lim, and β*_lim itself; `limits_into(rs, continuous, sliding)`: both limits for a slice of frequency ratios, into slices of the same length
///
/// Answers of `at(r)` are non-dimensional: displacements are over P/k₁, with P the amplitude of the force, and forces over P.  The time is τ = ωt.
///
/// Numbers in brackets are equations of L. Marino, *Dynamic analysis of mechanical systems with Coulomb friction*, Oxford 2021.  Counts of operations do not include operations whose operands are all constants, because the compiler computes them.  An expression that stands several times counts once, and an `if` as a comparison and a choice.
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
///
/// Worst case: the operations of `tabled_limit` and `tabled_sliding_limit` together.
#[allow(
    deprecated,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
pub struct DeclaredLimitsAt(::frictiongen::kernel::table::Compiled<DeclaredLimits>);
#[allow(
    deprecated,
    non_snake_case,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
#[allow(
    unused_doc_comments,
    clippy::doc_markdown,
    reason = "comments above statements explain them by formulas"
)]
#[allow(
    clippy::unreadable_literal,
    clippy::excessive_precision,
    clippy::approx_constant,
    clippy::similar_names,
    clippy::too_many_lines,
    reason = "numbers have all their digits, and formulas are written out"
)]
#[allow(
    clippy::suboptimal_flops,
    clippy::assign_op_pattern,
    clippy::suspicious_operation_groupings,
    reason = "operations and their order are those of the tested formulas"
)]
#[allow(
    clippy::wildcard_imports,
    clippy::inline_always,
    reason = "one import serves every scene, and the compiler folds constants after inlining"
)]
#[allow(
    clippy::expl_impl_clone_on_copy,
    reason = "`wraps!` implements both traits for types that stand outside this block"
)]
const _: () = {
    use ::frictiongen::kernel::emitted::*;
    use ::core::f32::consts::PI;
    impl DeclaredLimits {
        /// Hash of all fields of the scene and of all names (FNV-1a, 64 bits).  Descriptions that differ only in layout, comments
        /// or attributes have the same hash.  To verify it, emit the description again.
        pub const SCENE_HASH: ::core::primitive::u64 = 0x5443_4a17_5b3a_66b5;
        /// k₁, the stiffness of the spring `base - lower`: N/m, if springs are in N/m.
        pub const K1: f32 = 1.0;
        /// m₁, the mass `lower`: kg, if masses are in kg.
        pub const M1: f32 = 1.0;
        /// Natural frequencies in Hz, ascending, if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES_HZ: [f32; 2] = [0.09836316, 0.2575181];
        /// Natural frequencies ω_i, ascending; rad/s if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES: [f32; 2] = [0.618034, 1.618034];
        /// Frequency ratios r of the undamped resonances, √λ_i = ω_i√(m₁/k₁).
        pub const RESONANCES: [f32; 2] = [0.618034, 1.618034];
        /// Mode shapes φ, [mode][mass], with φᵀΓφ = 1 and Γ = diag(m_i/m₁).  The first component that is not 0 is positive.
        pub const MODE_SHAPES: [[f32; 2]; 2] = [
            [0.5257311, 0.8506508],
            [0.8506508, -0.5257311],
        ];
        /// Constants of the chain.
        const CHAIN: Chain<f32> = Chain {
            /// true if a mode is damped
            damped: true,
            /// relative motion in the contact for r → 0, over the amplitude Y of the base motion, if the contact rubs on the moving base
            on_moving_base: None,
            /// m* = m₁/(effective mass of the contact)
            inverse_mass: 1.0,
            /// μ, static over kinetic friction
            stiction: 1.0,
        };
        /// Returns the frequency ratio r = ω√(m₁/k₁) of an angular frequency ω, rad/s.
        #[inline]
        #[must_use]
        pub const fn frequency_ratio(omega: f32) -> f32 {
            omega
        }
        /// Returns β = F/P of a kinetic friction force F.  `load` is P, the amplitude of the force.
        #[inline]
        #[must_use]
        pub const fn friction_ratio(friction: f32, load: f32) -> f32 {
            friction / load
        }
        /// Modes that the load or the contact drives.
        const MODES: [Mode<f32>; 2] = [
            Mode {
                /// kind of damping: `Undamped` for ζ = 0, `Light` for ζ < 1/2, `Heavy` for ζ < 1, `Critical` for ζ = 1, `Over` for ζ > 1
                kind: Kind::Light,
                /// true if the contact drives the mode: φᵀw is not 0
                in_contact: true,
                /// √λ, the frequency ratio r of the undamped resonance
                resonance: 0.618034,
                /// ζ, the modal damping ratio
                zeta: 0.05,
                /// √|1 − ζ²|
                q: 0.9987492,
                /// 1 − q
                q_defect: 0.0012507823,
                /// φᵀp, with p the load on each mass over P
                load: 0.5257311,
                /// φᵀw, with w = 1 at the mass that rubs and −1 at its partner
                contact: 0.8506508,
                /// (φᵀp)(φᵀw)
                residue: 0.4472136,
                /// (φᵀw)², the term of m*
                contact_squared: 0.7236068,
                /// (φᵀp)(φᵀw)/λ
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
                contact_squared: 0.2763932,
                static_residue: -0.1708204,
            },
        ];
        /// Constants of the steady response.
        const NUMBERS: Numbers<'static, f32> = Numbers {
            /// modes that the load or the contact drives
            modes: &Self::MODES,
            /// constants of the chain
            chain: Self::CHAIN,
            /// limits of β for r → 0 and for r → ∞, which a range of tables does not restrict; β_lim for r → 0 is 0
            ends: Ends {
                /// β*_lim for r → 0
                sliding_at_rest: 0.5,
                /// β_lim for r → ∞
                continuous_at_infinity: 0.0,
                /// β*_lim for r → ∞
                sliding_at_infinity: 0.0,
            },
            /// index of the mass that rubs on a support
            rubbing: Some(1),
            /// true if V and H may have a common zero: the chain then absorbs the load, and the limits follow from the force that holds a stuck contact
            absorbs: false,
            /// undamped resonances that the load drives
            unbounded: &[],
            /// those of them in which the contact does not move
            invisible: &[],
        };
        /// The functions of a lightly damped mode, ζ < 1/2.
        ///
        /// It returns uR²·size, g·size and (g + 2ζRu)·size.  The factor `size` removes the pole at x = 1.
        ///
        /// Operations: 56: 34 ×, 10 +, 4 sign, 4 ÷, 1 exp_m1, 1 one_minus_sinc_pi, 1 scaled_sinh_defect, 1 sin_cos_pi.
        #[inline(always)]
        fn damped_mode<const WITH_G: bool>(
            mode: &Mode<f32>,
            inverse_r: f32,
        ) -> ModeResponse<f32> {
            /// x = √λ/r = 1/R
            let x = mode.resonance * inverse_r;
            /// x² − 1
            let detuning = (x - 1.0) * (x + 1.0);
            /// 2ζx
            let loss = 2.0 * mode.zeta * x;
            /// |x² − 1| + 2ζx, small beside the resonance
            let size = Scalar::abs(detuning) + loss;
            /// a = πζx
            let decay_exponent = PI * mode.zeta * x;
            /// exp(−a/2) − 1
            let half_decay_minus_one = Scalar::exp_m1(decay_exponent * -0.5);
            /// exp(−a/2)
            let half_decay_factor = 1.0 + half_decay_minus_one;
            /// 1 − e
            let decay_complement = -(half_decay_minus_one * (1.0 + half_decay_factor));
            /// e = exp(−a) with a = πζx (7.11)
            let decay_factor = half_decay_factor * half_decay_factor;
            /// qx, the half-turns of the free motion in half a period
            let half_turns = mode.q * x;
            /// sin(πqx/2), cos(πqx/2)
            let (sine, cosine) = Scalar::sin_cos_pi_minus(
                x * 0.5,
                x * (mode.q_defect * 0.5),
            );
            /// 1 + e
            let one_plus_factor = 1.0 + decay_factor;
            /// (1 + e) cos(πqx/2), whose square plus that of `nearness_im` is D = 1 + 2e cos(πqx) + e²
            let nearness_re = one_plus_factor * cosine;
            /// (1 − e) sin(πqx/2)
            let nearness_im = decay_complement * sine;
            /// 1/(|nearness_re| + |nearness_im|): with little damping D itself could underflow beside a resonance
            let inverse_nearness = 1.0
                / (Scalar::abs(nearness_re) + Scalar::abs(nearness_im));
            /// nearness_re·inverse_nearness
            let unit_nearness_re = nearness_re * inverse_nearness;
            /// nearness_im·inverse_nearness
            let unit_nearness_im = nearness_im * inverse_nearness;
            /// size/(D·inverse_nearness)
            let pole_weight = size * inverse_nearness
                / (unit_nearness_re * unit_nearness_re
                    + unit_nearness_im * unit_nearness_im);
            /// uR·size = (2e/q) sin(πqx)·size/D (7.11)
            let u_times_r = 4.0 / mode.q * sine * decay_factor
                * (cosine * inverse_nearness) * pole_weight;
            /// uR²·size
            let u = u_times_r / x;
            /// (g + 2ζRu)·size = ((1 − e²)/D + ζuR)·size, the term of H_c (5.63, 7.47)
            let reversal = one_plus_factor * (decay_complement * inverse_nearness)
                * pole_weight + mode.zeta * u_times_r;
            /// g·size = (1 − e² − (2ζe/q) sin(πqx))·size/D (7.12)
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
        /// Sums V, H, U, G and H_c of the contact (3.11, 5.20, 5.34, 5.37, 7.11, 7.12), and the functions of the modes.
        ///
        /// V is the response of the contact to the load, and H to a force in the contact.  U is the slope and G the value, at a
        /// reversal, of its response to a square wave of friction.  H_c decides whether the contact breaks away there (5.63).
        ///
        /// Sums over the modes, with x = √λ/r = 1/R:
        /// r²V is the sum of residue/(x² − 1 + 2iζx),
        /// r²H is the sum of (φᵀw)²/(x² − 1 + 2iζx), r²U that of (φᵀw)²uR², r²G that of (φᵀw)²gR², r²H_c that of (φᵀw)²(g + 2ζRu).
        /// Each is returned times E as `v`, `h`, `u`, `g` or `reversal`.  E, the `scale`, is the smallest |x² − 1| + 2ζx of the
        /// modes in contact, so that the sums stay finite on a resonance.
        /// With `WITH_G` false, g and r²G are 0, for callers that do not use them.
        /// `sin_cos_pi_minus(a, b)` is the sine and the cosine of π(a − b), `one_minus_sinc_pi(a)` is 1 − sin(πa)/(πa), and
        /// `scaled_sinh_defect(a)` is 1 − e^(−2a) − 2a·e^(−a).
        ///
        /// Operations: 164: 102 ×, 29 +, 14 ÷, 10 sign, 2 exp_m1, 2 one_minus_sinc_pi, 2 scaled_sinh_defect, 2 sin_cos_pi, 1 compare.
        #[inline(always)]
        fn functions<const WITH_G: bool>(
            inverse_r: f32,
        ) -> (ContactAt<f32>, [ModeAt<f32>; 2]) {
            let [constants_1, constants_2] = &Self::MODES;
            let mode_1 = Self::damped_mode::<WITH_G>(constants_1, inverse_r);
            let mode_2 = Self::damped_mode::<WITH_G>(constants_2, inverse_r);
            /// E, the smallest `size` of the modes in contact
            let scale = Scalar::min(mode_1.size, mode_2.size);
            let modes = [
                Self::CHAIN.at_scale(&mode_1, scale),
                Self::CHAIN.at_scale(&mode_2, scale),
            ];
            let [at_1, at_2] = &modes;
            /// Re V·r²E
            let v_re = at_1.response.re * constants_1.residue
                + at_2.response.re * constants_2.residue;
            /// Im V·r²E
            let v_im = at_1.response.im * constants_1.residue
                + at_2.response.im * constants_2.residue;
            /// Re H·r²E
            let h_re = at_1.response.re * constants_1.contact_squared
                + at_2.response.re * constants_2.contact_squared;
            /// Im H·r²E
            let h_im = at_1.response.im * constants_1.contact_squared
                + at_2.response.im * constants_2.contact_squared;
            /// U·r²E
            let u = constants_1.contact_squared * at_1.u
                + constants_2.contact_squared * at_2.u;
            /// H_c·r²E
            let reversal = constants_1.contact_squared
                * (mode_1.reversal * (scale / mode_1.size))
                + constants_2.contact_squared
                    * (mode_2.reversal * (scale / mode_2.size));
            /// G·r²E
            let g_sum = if WITH_G {
                constants_1.contact_squared * (at_1.g / (at_1.x * at_1.x))
                    + constants_2.contact_squared * (at_2.g / (at_2.x * at_2.x))
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
    /// The functions `at`, `limits_without_search` and `limits_into`.
    ::frictiongen::kernel::scene_functions!(
        DeclaredLimits, DeclaredLimitsAt, f32, Compiled
    );
    /// The trait `FrictionSystem`, by which generic code calls any scene.  The texts are the names of the masses.
    ::frictiongen::emitted_system!(
        DeclaredLimits, DeclaredLimitsAt, f32, ["lower", "upper"]
    );
    /// `Clone`, `Copy`, `Debug`, `From` and `Deref`: the answers at one frequency have all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(
        DeclaredLimitsAt, Compiled of tabled DeclaredLimits, Copy
    );
    impl Scene for DeclaredLimits {
        /// The items that every scene has: types, constants and the calls of the frequency stage.  The word says whether a
        /// mode is damped, and the number is the number of modes that the load or the contact drives.
        ::frictiongen::kernel::scene_items!(f32, damped, 2);
        /// Neither the continuous motion nor the stuck response of a mass is provided, so no formula at one frequency needs
        /// mode shapes.
        #[inline]
        fn shape(&self, _: usize) -> Option<&[f32]> {
            None
        }
        /// Smallest and largest 1/r at which the formulas are evaluated: 2^-50 and 2^50.
        /// Any other 1/r is moved to the nearer of both, at which the formulas have reached their limits for r → ∞ or r → 0.
        /// Between both, no square of √λ/r overflows or underflows.
        #[inline]
        fn inverse_ratio_range(&self) -> (f32, f32) {
            (8.881784e-16, 1125899900000000.0)
        }
        /// r²E(H_c + μm*/r²) = r²EH_c + μm*E: with it in β_lim the contact breaks away at once at every reversal (5.63, 7.47).
        ///
        /// Operations: 1: 1 +.
        #[inline]
        fn break_away(&self, contact: &ContactAt<f32>) -> f32 {
            contact.reversal + contact.scale
        }
        /// β_lim = |V|/√(U² + max(S, H_c + μm*/r²)²) (5.65, 5.80, 5.96, 7.49), with S the largest J(τ)/sin τ over
        /// 0 < τ < π.  With more friction the contact would reverse within the half period.  `constraint` is r²E times
        /// that maximum.  r²J is the sum of (φᵀw)²((1 + g)p + uR²(cos τ − p′)) over the modes.  p is the free motion of
        /// a mode, p″ + 2ζxp′ + x²p = 0, from p = 0 and p′ = 1 at τ = 0.
        ///
        /// Operations: 6: 2 ×, 1 +, 1 hypot, 1 ÷, 1 √.
        #[inline]
        fn continuous_limit(&self, contact: &ContactAt<f32>, constraint: f32) -> f32 {
            /// |V|·r²E
            let modulus_v = Scalar::hypot(contact.v.re, contact.v.im);
            modulus_v / Scalar::sqrt(contact.u * contact.u + constraint * constraint)
        }
        /// β*_lim = |V|/(μ|H|) (6.11, 6.27, 6.33).
        ///
        /// Operations: 3: 2 hypot, 1 ÷.
        #[inline]
        fn sliding_limit(&self, contact: &ContactAt<f32>) -> f32 {
            /// |V|·r²E
            let modulus_v = Scalar::hypot(contact.v.re, contact.v.im);
            /// |H|·r²E
            let modulus_h = Scalar::hypot(contact.h.re, contact.h.im);
            modulus_v / modulus_h
        }
    }
    impl Tabled for DeclaredLimits {
        /// Where the tables hold.
        #[inline]
        fn domain(&self) -> Domain<f32> {
            Domain {
                /// smallest and largest r of the tables
                r: (0.5, 2.0),
                /// smallest and largest β that a caller may pass
                beta: (0.0, f32::INFINITY),
                /// outside, the exact formulas answer; if false, a call is an error
                exact_beyond: false,
                /// β_lim exceeds every β of the range, so that no code compares them
                always_continuous: false,
                /// β*_lim exceeds every β of the range, so that no code evaluates it
                never_stuck: false,
            }
        }
        /// β_lim (5.65, 5.80, 5.96, 7.49) from the table.  Its error is relative.
        ///
        /// Proven at every r: at most 9.93e-3 off, the bound being largest at r = 1.5726153.  The macro and `expand` made this proof, and `frictiongen compile` makes it only with `--prove`.
        ///
        /// Operations: at every r a lookup of 2 comparisons, 10 additions and multiplications.
        #[inline]
        fn tabled_limit(&self, r: f32) -> f32 {
            Self::TABLE.first(r)
        }
        /// β*_lim = |V|/(μ|H|) (6.11, 6.27, 6.33).  Its error is relative.
        ///
        /// Proven at every r: at most 7.36e-7 off, the bound being largest at r = 0.72815543.
        ///
        /// Operations: 12 additions and multiplications, 1 division, 1 root.
        #[inline]
        fn tabled_sliding_limit(&self, r: f32) -> Option<f32> {
            Some(Self::SLIDING_LIMIT.magnitude(r))
        }
    }
    /// Placeholders for methods that `provide` does not list: the compiler refuses a call and says what to add.
    ::frictiongen::kernel::not_provided!(
        DeclaredLimitsAt : motion, stuck, orbit; DeclaredLimits : simulation, stepper,
        self_check
    );
    /// Tables: numbers alone, apart from the code that reads them.
    impl DeclaredLimits {
        /// β_lim over r from 0.5 to 2, to 1e-2:
        /// 6 pieces of degree 3 and 8 buckets; with β*_lim 176 bytes.
        /// Largest error of all of them 8.9e-3, at r = 0.5671188: checked at 717 points that the fit did not use.
        /// 47 numbers; CRC-32 of their text, joined by commas: 2823d52f.
        const TABLE: Table<'static, f32, ::core::primitive::u8, 1, 4> = Table {
            /// where the first bucket begins
            low: 0.5,
            /// buckets per unit of r
            density: 5.333333,
            /// comparisons that find the piece of r in its bucket
            halvings: 2,
            /// the first piece of each bucket
            buckets: &[0, 2, 2, 2, 3, 3, 4, 5],
            /// from the r `from` on, each function is Σ coefficients[j]·(r − origin)^j
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
        /// β*_lim = gain·|q|.  q is the numerator over the denominator, or the root of this quotient if `squared`.  Of the factors,
        /// `Zero` is (r − at − rest)(r + at), `Pair` (that + off)² + least, and `Real` r² + off.
        ///
        /// Largest error 2.2e-7 at the points of the check.
        /// 6 numbers; CRC-32 of their text, joined by commas: e576358c.
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
};
