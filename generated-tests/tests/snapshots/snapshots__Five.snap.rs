/// Five masses, damped: sums over modes are calls, the frequency stage is straight lines.
///
/// Emitted by `friction_system!` of frictiongen 0.1.0 from scene fea12f32a4a7d13c.  Change the description, not this code.
///
/// # Description
///
/// ```text
/// pub struct Five
/// {
///     masses: { m1: 1.0, m2: 1.0, m3: 1.0, m4: 1.0, m5: 1.0 }, springs:
///     {
///         base - m1: 1.0, m1 - m2: 1.0, m2 - m3: 1.0, m3 - m4: 1.0, m4 - m5: 1.0
///     }, contact: m1 - wall, excitation: m1, damping: modal(0.01), provide:
///     [limits, motion(m5), stuck],
/// }
/// ```
///
/// The motion in the contact is the displacement of `m1`.
///
/// # What it offers
///
/// * `K1`, `M1`, `NATURAL_FREQUENCIES_HZ`, `NATURAL_FREQUENCIES`, `RESONANCES`, `MODE_SHAPES`, `SCENE_HASH`: constants of the chain
/// * `frequency_ratio(omega)`, `friction_ratio(friction, load)`: r and β from units
/// * `at(r)` returns [`FiveAt`], with `limits()` (β_lim and β*_lim), `regime(beta)` (continuous, stick-slip, stuck or bistable) and `margin(beta)` (β/min(β_lim, β*_lim) − 1, negative below both limits), or an error if r is negative or not a number
/// * `limits_without_search(r)`: an upper bound on β_lim, and β*_lim itself; `limits_into(rs, continuous, sliding)`: both limits for a slice of frequency ratios, into slices of the same length
/// * `at(r)?.motion(beta)` returns [`FiveMotion`], the continuous motion, with `contact()` and `m5()`
/// * `at(r)?.stuck()` returns [`FiveStuck`], the response while the contact is stuck, with `contact_force()`, `m1()`, `m2()`, `m3()`, `m4()` and `m5()`
///
/// Answers of `at(r)` are non-dimensional: displacements are over P/k₁, with P the amplitude of the force, and forces over P.  The time is τ = ωt.  A phase is the lag of a maximum behind that of the load, in rad.  In `motion(beta)` τ is 0 at a maximum of the motion in the contact, and elsewhere at a maximum of the load.
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
pub struct Five;
/// [`Five`] at one frequency ratio: limits, regime, continuous motion, stuck response.
///
/// Worst case: the operations of `functions`, and in each search at most `most_evaluations()` sums over 5 modes.  This number depends on r, and never exceeds 20000.
#[allow(
    deprecated,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
pub struct FiveAt(::frictiongen::kernel::response::At<Five>);
/// Exact continuous motion of [`Five`] at one frequency and one friction ratio.
#[allow(
    deprecated,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
pub struct FiveMotion(::frictiongen::kernel::response::Continuous<Five>);
/// Response of [`Five`] at one frequency ratio while its contact is stuck.
#[allow(
    deprecated,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
pub struct FiveStuck(::frictiongen::kernel::response::Stuck<Five>);
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
    use ::core::f64::consts::PI;
    impl Five {
        /// Hash of all fields of the scene and of all names (FNV-1a, 64 bits).  Descriptions that differ only in layout, comments
        /// or attributes have the same hash.  To verify it, emit the description again.
        pub const SCENE_HASH: ::core::primitive::u64 = 0xfea1_2f32_a4a7_d13c;
        /// k₁, the stiffness of the spring `base - m1`: N/m, if springs are in N/m.
        pub const K1: f64 = 1.0;
        /// m₁, the mass `m1`: kg, if masses are in kg.
        pub const M1: f64 = 1.0;
        /// Natural frequencies in Hz, ascending, if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES_HZ: [f64; 5] = [
            0.045300219973033976,
            0.1322307055076684,
            0.20844864568835733,
            0.2677793162872051,
            0.30541609922537755,
        ];
        /// Natural frequencies ω_i, ascending; rad/s if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES: [f64; 5] = [
            0.2846296765465703,
            0.8308300260037729,
            1.3097214678905702,
            1.6825070656623624,
            1.9189859472289947,
        ];
        /// Frequency ratios r of the undamped resonances, √λ_i = ω_i√(m₁/k₁).
        pub const RESONANCES: [f64; 5] = [
            0.2846296765465703,
            0.8308300260037729,
            1.3097214678905702,
            1.6825070656623624,
            1.9189859472289947,
        ];
        /// Mode shapes φ, [mode][mass], with φᵀΓφ = 1 and Γ = diag(m_i/m₁).  The first component that is not 0 is positive.
        pub const MODE_SHAPES: [[f64; 5]; 5] = [
            [
                0.16989112404918136,
                0.32601867960931696,
                0.4557341406552499,
                0.5485287319805897,
                0.5968847876668415,
            ],
            [
                0.4557341406552499,
                0.5968847876668415,
                0.32601867960931696,
                -0.16989112404918136,
                -0.5485287319805897,
            ],
            [
                0.5968847876668415,
                0.16989112404918136,
                -0.5485287319805897,
                -0.32601867960931696,
                0.4557341406552499,
            ],
            [
                0.5485287319805897,
                -0.4557341406552499,
                -0.16989112404918136,
                0.5968847876668415,
                -0.32601867960931696,
            ],
            [
                0.32601867960931696,
                -0.5485287319805897,
                0.5968847876668415,
                -0.4557341406552499,
                0.16989112404918136,
            ],
        ];
        /// Constants of the chain.
        const CHAIN: Chain<f64> = Chain {
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
        pub const fn frequency_ratio(omega: f64) -> f64 {
            omega
        }
        /// Returns β = F/P of a kinetic friction force F.  `load` is P, the amplitude of the force.
        #[inline]
        #[must_use]
        pub const fn friction_ratio(friction: f64, load: f64) -> f64 {
            friction / load
        }
        /// Modes that the load or the contact drives.
        const MODES: [Mode<f64>; 5] = [
            Mode {
                /// kind of damping: `Undamped` for ζ = 0, `Light` for ζ < 1/2, `Heavy` for ζ < 1, `Critical` for ζ = 1, `Over` for ζ > 1
                kind: Kind::Light,
                /// true if the contact drives the mode: φᵀw is not 0
                in_contact: true,
                /// √λ, the frequency ratio r of the undamped resonance
                resonance: 0.2846296765465703,
                /// ζ, the modal damping ratio
                zeta: 0.01,
                /// √|1 − ζ²|
                q: 0.9999499987499375,
                /// 1 − q
                q_defect: 5.000125006250391e-5,
                /// φᵀp, with p the load on each mass over P
                load: 0.16989112404918136,
                /// φᵀw, with w = 1 at the mass that rubs and −1 at its partner
                contact: 0.16989112404918136,
                /// (φᵀp)(φᵀw)
                residue: 0.028862994030694332,
                /// (φᵀw)², the term of m*
                contact_squared: 0.028862994030694332,
                /// (φᵀp)(φᵀw)/λ
                static_residue: 0.35627144974809044,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 0.8308300260037729,
                zeta: 0.01,
                q: 0.9999499987499375,
                q_defect: 5.000125006250391e-5,
                load: 0.4557341406552499,
                contact: 0.4557341406552499,
                residue: 0.20769360695877911,
                contact_squared: 0.20769360695877911,
                static_residue: 0.30088376980823367,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 1.3097214678905702,
                zeta: 0.01,
                q: 0.9999499987499375,
                q_defect: 5.000125006250391e-5,
                load: 0.5968847876668415,
                contact: 0.5968847876668415,
                residue: 0.35627144974809044,
                contact_squared: 0.35627144974809044,
                static_residue: 0.20769360695877911,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 1.6825070656623624,
                zeta: 0.01,
                q: 0.9999499987499375,
                q_defect: 5.000125006250391e-5,
                load: 0.5485287319805897,
                contact: 0.5485287319805897,
                residue: 0.30088376980823367,
                contact_squared: 0.30088376980823367,
                static_residue: 0.10628817945420246,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 1.9189859472289947,
                zeta: 0.01,
                q: 0.9999499987499375,
                q_defect: 5.000125006250391e-5,
                load: 0.32601867960931696,
                contact: 0.32601867960931696,
                residue: 0.10628817945420246,
                contact_squared: 0.10628817945420246,
                static_residue: 0.028862994030694332,
            },
        ];
        /// Constants of the steady response.
        const NUMBERS: Numbers<'static, f64> = Numbers {
            /// modes that the load or the contact drives
            modes: &Self::MODES,
            /// constants of the chain
            chain: Self::CHAIN,
            /// limits of β for r → 0 and for r → ∞, which a range of tables does not restrict; β_lim for r → 0 is 0
            ends: Ends {
                /// β*_lim for r → 0
                sliding_at_rest: 1.0,
                /// β_lim for r → ∞
                continuous_at_infinity: 0.5370292721463151,
                /// β*_lim for r → ∞
                sliding_at_infinity: 1.0,
            },
            /// index of the mass that rubs on a support
            rubbing: Some(0),
            /// true if V and H may have a common zero: the chain then absorbs the load, and the limits follow from the force that holds a stuck contact
            absorbs: false,
            /// undamped resonances that the load drives
            unbounded: &[],
            /// those of them in which the contact does not move
            invisible: &[],
        };
        /// Mode shapes φ of `MODES`, [mass][mode].
        const SHAPES: [[f64; 5]; 5] = transposed(&Self::MODE_SHAPES);
        /// The functions of a lightly damped mode, ζ < 1/2.
        ///
        /// It returns uR²·size, g·size and (g + 2ζRu)·size.  The factor `size` removes the pole at x = 1.
        ///
        /// Operations: 56: 34 ×, 10 +, 4 sign, 4 ÷, 1 exp_m1, 1 one_minus_sinc_pi, 1 scaled_sinh_defect, 1 sin_cos_pi.
        #[inline(always)]
        fn damped_mode<const WITH_G: bool>(
            mode: &Mode<f64>,
            inverse_r: f64,
        ) -> ModeResponse<f64> {
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
        /// r²V = r²H, because the load acts on the mass that rubs.
        /// r²H is the sum of (φᵀw)²/(x² − 1 + 2iζx), r²U that of (φᵀw)²uR², r²G that of (φᵀw)²gR², r²H_c that of (φᵀw)²(g + 2ζRu).
        /// Each is returned times E as `v`, `h`, `u`, `g` or `reversal`.  E, the `scale`, is the smallest |x² − 1| + 2ζx of the
        /// modes in contact, so that the sums stay finite on a resonance.
        /// With `WITH_G` false, g and r²G are 0, for callers that do not use them.
        /// `sin_cos_pi_minus(a, b)` is the sine and the cosine of π(a − b), `one_minus_sinc_pi(a)` is 1 − sin(πa)/(πa), and
        /// `scaled_sinh_defect(a)` is 1 − e^(−2a) − 2a·e^(−a).
        ///
        /// Operations: 404: 245 ×, 75 +, 35 ÷, 25 sign, 5 exp_m1, 5 one_minus_sinc_pi, 5 scaled_sinh_defect, 5 sin_cos_pi, 4 compare.
        #[inline(always)]
        fn functions<const WITH_G: bool>(
            inverse_r: f64,
        ) -> (ContactAt<f64>, [ModeAt<f64>; 5]) {
            let [constants_1, constants_2, constants_3, constants_4, constants_5] = &Self::MODES;
            let mode_1 = Self::damped_mode::<WITH_G>(constants_1, inverse_r);
            let mode_2 = Self::damped_mode::<WITH_G>(constants_2, inverse_r);
            let mode_3 = Self::damped_mode::<WITH_G>(constants_3, inverse_r);
            let mode_4 = Self::damped_mode::<WITH_G>(constants_4, inverse_r);
            let mode_5 = Self::damped_mode::<WITH_G>(constants_5, inverse_r);
            /// E, the smallest `size` of the modes in contact
            let scale = Scalar::min(mode_1.size, mode_2.size);
            let scale = Scalar::min(scale, mode_3.size);
            let scale = Scalar::min(scale, mode_4.size);
            let scale = Scalar::min(scale, mode_5.size);
            let modes = [
                Self::CHAIN.at_scale(&mode_1, scale),
                Self::CHAIN.at_scale(&mode_2, scale),
                Self::CHAIN.at_scale(&mode_3, scale),
                Self::CHAIN.at_scale(&mode_4, scale),
                Self::CHAIN.at_scale(&mode_5, scale),
            ];
            let [at_1, at_2, at_3, at_4, at_5] = &modes;
            let sum = Self::CHAIN.begun_by(scale, constants_1, &mode_1, at_1, WITH_G);
            /// `false`: this mode is not the only one, so that E is not always its own `size`
            let sum = Self::CHAIN
                .joined_by(&sum, constants_2, &mode_2, at_2, false, WITH_G);
            let sum = Self::CHAIN
                .joined_by(&sum, constants_3, &mode_3, at_3, false, WITH_G);
            let sum = Self::CHAIN
                .joined_by(&sum, constants_4, &mode_4, at_4, false, WITH_G);
            let sum = Self::CHAIN
                .joined_by(&sum, constants_5, &mode_5, at_5, false, WITH_G);
            let contact = Self::CHAIN.completed(&sum, inverse_r);
            (contact, modes)
        }
    }
    /// The functions `at`, `limits_without_search` and `limits_into`.
    ::frictiongen::kernel::scene_functions!(Five, FiveAt, f64, At);
    /// The trait `FrictionSystem`, by which generic code calls any scene.  The texts are the names of the masses.
    ::frictiongen::emitted_system!(Five, FiveAt, f64, ["m1", "m2", "m3", "m4", "m5"]);
    /// `Clone`, `Copy`, `Debug`, `From` and `Deref`: the answers at one frequency have all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(FiveAt, At of Five, Copy);
    impl Scene for Five {
        /// The items that every scene has: types, constants and the calls of the frequency stage.  The word says whether a
        /// mode is damped, and the number is the number of modes that the load or the contact drives.
        ::frictiongen::kernel::scene_items!(f64, damped, 5);
        /// Components of a mass in the mode shapes.
        #[inline]
        fn shape(&self, mass: usize) -> Option<&[f64]> {
            Self::SHAPES.get(mass).map(<[f64; 5]>::as_slice)
        }
        /// Returns true if the scene provides the motion of this mass.  The other masses have mode shapes only for
        /// the stuck response.
        #[inline]
        fn moves(&self, mass: usize) -> bool {
            match mass {
                4 => true,
                _ => false,
            }
        }
        /// Smallest and largest 1/r at which the formulas are evaluated: 2^-400 and 2^400.
        /// Any other 1/r is moved to the nearer of both, at which the formulas have reached their limits for r → ∞ or r → 0.
        /// Between both, no square of √λ/r overflows or underflows.
        #[inline]
        fn inverse_ratio_range(&self) -> (f64, f64) {
            (3.8725919148493183e-121, 2.5822498780869086e120)
        }
        /// r²E(H_c + μm*/r²) = r²EH_c + μm*E: with it in β_lim the contact breaks away at once at every reversal (5.63, 7.47).
        ///
        /// Operations: 1: 1 +.
        #[inline]
        fn break_away(&self, contact: &ContactAt<f64>) -> f64 {
            contact.reversal + contact.scale
        }
        /// β_lim = |V|/√(U² + max(S, H_c + μm*/r²)²) (5.65, 5.80, 5.96, 7.49), with S the largest J(τ)/sin τ over
        /// 0 < τ < π.  With more friction the contact would reverse within the half period.  `constraint` is r²E times
        /// that maximum.  r²J is the sum of (φᵀw)²((1 + g)p + uR²(cos τ − p′)) over the modes.  p is the free motion of
        /// a mode, p″ + 2ζxp′ + x²p = 0, from p = 0 and p′ = 1 at τ = 0.
        ///
        /// Operations: 6: 2 ×, 1 +, 1 hypot, 1 ÷, 1 √.
        #[inline]
        fn continuous_limit(&self, contact: &ContactAt<f64>, constraint: f64) -> f64 {
            /// |V|·r²E
            let modulus_v = Scalar::hypot(contact.v.re, contact.v.im);
            modulus_v / Scalar::sqrt(contact.u * contact.u + constraint * constraint)
        }
        /// β*_lim = |V|/(μ|H|) (6.11, 6.27, 6.33).
        ///
        /// The load acts on the mass that rubs: V = H.
        ///
        /// Operations: none.
        #[inline]
        fn sliding_limit(&self, _: &ContactAt<f64>) -> f64 {
            1.0
        }
    }
    /// Placeholders for methods that `provide` does not list: the compiler refuses a call and says what to add.
    ::frictiongen::kernel::not_provided!(
        FiveAt : orbit; Five : simulation, stepper, self_check
    );
    /// Placeholders for masses whose motion `provide` does not list: the compiler refuses a call.
    ::frictiongen::kernel::left_out!(FiveMotion : m1, m2, m3, m4);
    /// The motions are those of the kernel, which sums over the modes in loops.  Worst case: a fixed number of operations
    /// for each mode.  No search is made before an amplitude or a phase is asked for.
    impl ProvidesMotion for Five {
        type Motion = FiveMotion;
    }
    /// `Clone`, `Copy`, `Debug`, `From` and `Deref`: the motion has all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(FiveMotion, Continuous of Five, Copy);
    impl FiveMotion {
        /// Motion of mass `m5` (5.50 and its exact form, 7.29).
        #[must_use]
        pub fn m5(&self) -> MotionOf<Five> {
            self.mass(4)
        }
    }
    /// The responses are those of the kernel, which sums over the modes in loops.  Worst case: a fixed number of
    /// operations for each mode, without a search.
    impl ProvidesStuck for Five {
        type Stuck = FiveStuck;
    }
    /// `Clone`, `Copy`, `Debug`, `From` and `Deref`: the response has all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(FiveStuck, Stuck of Five, Copy);
    impl FiveStuck {
        /// x̄* = V_k − H_kV/H, the complex amplitude of mass `m1` over P/k₁ (6.11, 6.27, 6.33).
        ///
        /// It is 0, because the contact holds the mass to a support at rest.
        #[must_use]
        pub fn m1(&self) -> Complex<f64> {
            self.mass(0)
        }
        /// x̄* = V_k − H_kV/H, the complex amplitude of mass `m2` over P/k₁ (6.11, 6.27, 6.33).
        #[must_use]
        pub fn m2(&self) -> Complex<f64> {
            self.mass(1)
        }
        /// x̄* = V_k − H_kV/H, the complex amplitude of mass `m3` over P/k₁ (6.11, 6.27, 6.33).
        #[must_use]
        pub fn m3(&self) -> Complex<f64> {
            self.mass(2)
        }
        /// x̄* = V_k − H_kV/H, the complex amplitude of mass `m4` over P/k₁ (6.11, 6.27, 6.33).
        #[must_use]
        pub fn m4(&self) -> Complex<f64> {
            self.mass(3)
        }
        /// x̄* = V_k − H_kV/H, the complex amplitude of mass `m5` over P/k₁ (6.11, 6.27, 6.33).
        #[must_use]
        pub fn m5(&self) -> Complex<f64> {
            self.mass(4)
        }
    }
};
