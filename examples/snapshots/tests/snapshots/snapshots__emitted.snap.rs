/// A machine on a mount whose damper rubs on the frame.
///
/// Emitted by `friction_system!` of frictiongen 0.1.0 from scene 8c1821ad589d1450.  Change the description, not this code.
///
/// # Description
///
/// ```text
/// pub struct Mount {
///     masses: { frame: 40.0, machine: 12.5 },                       // kg
///     springs: { base - frame: 2.0e5, frame - machine: 3.1e4 },     // N/m
///     contact: frame - machine,
///     excitation: base,
///     damping: modal[0.01, 0.02],
///     stiction: 1.15,
///     provide: [limits, motion(machine), orbit],
/// }
/// ```
///
/// The damping acts on absolute velocities (damping_from: rest, the default).
///
/// The motion in the contact is the displacement of `machine` minus that of `frame`.
///
/// # What it offers
///
/// * `K1`, `M1`, `NATURAL_FREQUENCIES_HZ`, `NATURAL_FREQUENCIES`, `RESONANCES`, `MODE_SHAPES`, `SCENE_HASH`: constants of the chain
/// * `frequency_ratio(omega)`, `friction_ratio(friction, load)`: r and β from units
/// * `at(r)` returns [`MountAt`], with `limits()` (β_lim and β*_lim), `regime(beta)` (continuous, stick-slip, stuck or bistable) and `margin(beta)` (β/min(β_lim, β*_lim) − 1, negative below both limits), or an error if r is negative or not a number
/// * `limits_without_search(r)`: an upper bound on β_lim, and β*_lim itself; `limits_into(rs, continuous, sliding)`: both limits for a slice of frequency ratios, into slices of the same length
/// * `at(r)?.motion(beta)` returns [`MountMotion`], the continuous motion, with `contact()` and `machine()`
/// * `at(r)?.orbit(beta)` returns [`MountOrbit`], the steady state in any regime, with `contact()`, `frame()` and `machine()`
///
/// Answers of `at(r)` are non-dimensional: displacements are over Y, the amplitude of the base motion, and forces over k₁Y.  The time is τ = ωt.  A phase is the lag of a maximum behind that of the load, in rad.  In `motion(beta)` τ is 0 at a maximum of the motion in the contact, and elsewhere at a maximum of the load.
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
pub struct Mount;
/// [`Mount`] at one frequency ratio: limits, regime, continuous motion, steady states.
///
/// Worst case: the operations of `functions`, and in each search at most `most_evaluations()` sums over 2 modes.  This number depends on r, and never exceeds 20000.
#[allow(
    deprecated,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
pub struct MountAt(::frictiongen::kernel::response::At<Mount>);
/// Exact continuous motion of [`Mount`] at one frequency and one friction ratio.
#[allow(
    deprecated,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
pub struct MountMotion(::frictiongen::kernel::response::Continuous<Mount>);
/// Steady state of [`Mount`] at one frequency and one friction ratio, in any regime.
///
/// Room for 3 modes of the chain and of the stuck chain, for 280 numbers (states at the starts of segments, Jacobian matrices) and for 4 Floquet multipliers.
///
/// Worst case: 1048576 steps of all searches for events together, each a sum over at most 3 modes, those of the chain and of the stuck chain, and Newton's method on 4 unknowns.
#[allow(
    deprecated,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
pub struct MountOrbit(
    ::frictiongen::kernel::orbit::FixedOrbit<::core::primitive::f64, 3, 280, 4>,
);
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
    impl Mount {
        /// Hash of all fields of the scene and of all names (FNV-1a, 64 bits).  Descriptions that differ only in layout, comments
        /// or attributes have the same hash.  To verify it, emit the description again.
        pub const SCENE_HASH: ::core::primitive::u64 = 0x8c18_21ad_589d_1450;
        /// k₁, the stiffness of the spring `base - frame`: N/m, if springs are in N/m.
        pub const K1: f64 = 200000.0;
        /// m₁, the mass `frame`: kg, if masses are in kg.
        pub const M1: f64 = 40.0;
        /// √(k₁/m₁), by which angular frequencies are divided: rad/s.
        const REFERENCE: f64 = 70.71067811865476;
        /// Natural frequencies in Hz, ascending, if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES_HZ: [f64; 2] = [
            7.071752647376391,
            12.613164045401122,
        ];
        /// Natural frequencies ω_i, ascending; rad/s if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES: [f64; 2] = [44.43313233000368, 79.25084700711017];
        /// Frequency ratios r of the undamped resonances, √λ_i = ω_i√(m₁/k₁).
        pub const RESONANCES: [f64; 2] = [0.6283793835980964, 1.120776226670104];
        /// Mode shapes φ, [mode][mass], with φᵀΓφ = 1 and Γ = diag(m_i/m₁).  The first component that is not 0 is positive.
        pub const MODE_SHAPES: [[f64; 2]; 2] = [
            [0.3426795800926145, 1.6805434410452347],
            [0.9394523433296388, -0.6130038684705358],
        ];
        /// Constants of the chain.
        const CHAIN: Chain<f64> = Chain {
            /// true if a mode is damped
            damped: true,
            /// relative motion in the contact for r → 0, over the amplitude Y of the base motion, if the contact rubs on the moving base
            on_moving_base: None,
            /// m* = m₁/(effective mass of the contact)
            inverse_mass: 4.2,
            /// μ, static over kinetic friction
            stiction: 1.15,
        };
        /// Returns the frequency ratio r = ω√(m₁/k₁) of an angular frequency ω, rad/s.
        #[inline]
        #[must_use]
        pub const fn frequency_ratio(omega: f64) -> f64 {
            omega / Self::REFERENCE
        }
        /// Returns β = F/(k₁Y) of a kinetic friction force F.  `load` is k₁Y, with Y the amplitude of the base motion.
        #[inline]
        #[must_use]
        pub const fn friction_ratio(friction: f64, load: f64) -> f64 {
            friction / load
        }
        /// Modes that the load or the contact drives.
        const MODES: [Mode<f64>; 2] = [
            Mode {
                /// kind of damping: `Undamped` for ζ = 0, `Light` for ζ < 1/2, `Heavy` for ζ < 1, `Critical` for ζ = 1, `Over` for ζ > 1
                kind: Kind::Light,
                /// true if the contact drives the mode: φᵀw is not 0
                in_contact: true,
                /// √λ, the frequency ratio r of the undamped resonance
                resonance: 0.6283793835980964,
                /// ζ, the modal damping ratio
                zeta: 0.01,
                /// √|1 − ζ²|
                q: 0.9999499987499375,
                /// 1 − q
                q_defect: 5.000125006250391e-5,
                /// φᵀp, with p the load on each mass over k₁Y
                load: 0.3426795800926145,
                /// φᵀw, with w = 1 at the mass that rubs and −1 at its partner
                contact: 1.33786386095262,
                /// (φᵀp)(φᵀw)
                residue: 0.45845862609232785,
                /// (φᵀw)², the term of m*
                contact_squared: 1.7898797104430517,
                /// (φᵀp)(φᵀw)/λ
                static_residue: 1.1610643562596341,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 1.120776226670104,
                zeta: 0.02,
                q: 0.999799979995999,
                q_defect: 0.0002000200040010003,
                load: 0.9394523433296388,
                contact: -1.5524562118001746,
                residue: -1.4584586260923278,
                contact_squared: 2.4101202895569482,
                static_residue: -1.1610643562596341,
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
                sliding_at_rest: 0.0,
                /// β_lim for r → ∞
                continuous_at_infinity: 0.12230290454700268,
                /// β*_lim for r → ∞
                sliding_at_infinity: 0.2070393374741201,
            },
            /// index of the mass that rubs on a support
            rubbing: None,
            /// true if V and H may have a common zero: the chain then absorbs the load, and the limits follow from the force that holds a stuck contact
            absorbs: false,
            /// undamped resonances that the load drives
            unbounded: &[],
            /// those of them in which the contact does not move
            invisible: &[],
        };
        /// Mode shapes φ of `MODES`, [mass][mode].
        const SHAPES: [[f64; 2]; 2] = transposed(&Self::MODE_SHAPES);
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
            inverse_r: f64,
        ) -> (ContactAt<f64>, [ModeAt<f64>; 2]) {
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
        /// Constants of the motion in time.
        const DYNAMICS: Dynamics<'static, f64> = Dynamics {
            /// constants of the chain
            chain: Self::CHAIN,
            /// all modes, those that the contact drives first
            modes: &Self::MODES,
            /// modes of the chain with its contact stuck; the state of a mode is y and u = y′/Ω
            held: &[
                HeldMode {
                    /// kind of damping: `Undamped` for ζ = 0, `Light` for ζ < 1/2, `Heavy` for ζ < 1, `Critical` for ζ = 1, `Over` for ζ > 1
                    kind: Kind::Light,
                    /// |s| of the oscillator's root s, over √(k₁/m₁): without damping, the frequency ratio r of the resonance
                    frequency: 0.8728715609439696,
                    /// ζ = −Re s/|s|
                    zeta: 0.015074980551220883,
                    /// √|1 − ζ²|
                    q: 0.99988636602435,
                    /// force of the chain on the contact, with its damping force, at y = −1
                    force: 0.27464447784205487,
                    /// m₁₁, m₁₂ and m₂₂ give y = m₁₁B(η, g) + m₁₂B(η, h) and u = m₁₂B(η, g) + m₂₂B(η, h).  η is the motion of the chain's modes minus the static motion that the stuck contact causes.  g and h are the `participations` of y and u.  B(a, b) is the sum of 2ζσab + a′b + ab′ over the chain's modes, with σ = `resonance`.  g′ is −Ωh, and h′ is Ω(g − 2ζh), with Ω = `frequency` and ζ of this mode.  [m₁₁, m₁₂, m₂₂] = [B(h, h), −B(g, h), B(g, g)]/(B(g, g)B(h, h) − B(g, h)²)
                    inverse: [
                        0.04287888540748418,
                        0.6540151732676781,
                        -0.06259741744191138,
                    ],
                },
            ],
            /// displacement of a mode of the chain per unit of y and of u: for each mode of `held` in turn, one pair for each mode that the contact drives; the largest number of a held mode has the modulus 1
            participations: &[
                [-1.0, 0.03272999580865182],
                [-0.8617723648393789, 0.02820580588920484],
            ],
            /// φ, mass after mass
            shapes: Self::SHAPES.as_flattened(),
            /// φᵀΓ, mode after mode
            weights: &[
                0.3426795800926145,
                0.5251698253266358,
                0.9394523433296388,
                -0.1915637088970424,
            ],
            /// index of the mass that rubs on a support
            rubbing: None,
        };
    }
    /// The functions `at`, `limits_without_search` and `limits_into`.
    ::frictiongen::kernel::scene_functions!(Mount, MountAt, f64, At);
    /// The trait `FrictionSystem`, by which generic code calls any scene.  The texts are the names of the masses.
    ::frictiongen::emitted_system!(Mount, MountAt, f64, ["frame", "machine"]);
    /// `Clone`, `Copy`, `Debug`, `From` and `Deref`: the answers at one frequency have all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(MountAt, At of Mount, Copy);
    impl Scene for Mount {
        /// The items that every scene has: types, constants and the calls of the frequency stage.  The word says whether a
        /// mode is damped, and the number is the number of modes that the load or the contact drives.
        ::frictiongen::kernel::scene_items!(f64, damped, 2);
        /// Components of a mass in the mode shapes.
        #[inline]
        fn shape(&self, mass: usize) -> Option<&[f64]> {
            match mass {
                1 => Some(&Self::SHAPES[1]),
                _ => None,
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
        /// Operations: 2: 1 +, 1 ×.
        #[inline]
        fn break_away(&self, contact: &ContactAt<f64>) -> f64 {
            contact.reversal
                + Self::CHAIN.stiction * Self::CHAIN.inverse_mass * contact.scale
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
        /// Operations: 4: 2 hypot, 1 ×, 1 ÷.
        #[inline]
        fn sliding_limit(&self, contact: &ContactAt<f64>) -> f64 {
            /// |V|·r²E
            let modulus_v = Scalar::hypot(contact.v.re, contact.v.im);
            /// |H|·r²E
            let modulus_h = Scalar::hypot(contact.h.re, contact.h.im);
            modulus_v / (Self::CHAIN.stiction * modulus_h)
        }
    }
    /// Placeholders for methods that `provide` does not list: the compiler refuses a call and says what to add.
    ::frictiongen::kernel::not_provided!(
        MountAt : stuck; Mount : simulation, stepper, self_check
    );
    /// Placeholders for masses whose motion `provide` does not list: the compiler refuses a call.
    ::frictiongen::kernel::left_out!(MountMotion : frame);
    impl ProvidesMotion for Mount {
        type Motion = MountMotion;
        /// The relative motion in the contact: its terms of cos τ and sin τ, and the coefficients of each mode's functions.
        ///
        /// d and q̃ are free motions of a mode, solutions of y″ + 2ζxy′ + x²y = 0: d from d = 1 and d′ = 0 at τ = 0, and q̃
        /// from q̃ = 0 and q̃′ = x.  The coefficients multiply (1 − d)/x² (`rise`), cos τ − d (`fall`, 0 without damping)
        /// and sin τ − Rq̃ (`forced`).  `harmonic` is (φᵀw)²/r², which only higher harmonics need.  Of `friction`, `unscale`
        /// is 1/(r²E), `amplitude` is Q − βG with Q = √(|V|² − (βU)²), and `root` is Q·r²E.
        ///
        /// Operations: 19: 17 ×, 2 ÷.
        /// The kernel adds one wave for each of 2 modes.  No search is made before an amplitude or a phase is asked for.
        fn contact_motion(at: &At<Self>, friction: &Friction<f64>) -> MotionOf<Self> {
            let inverse_r = at.inverse_ratio();
            let contact = at.contact_sums();
            let [constants_1, constants_2] = &Self::MODES;
            let [mode_1, mode_2] = at.modes();
            /// β/(r²E)
            let friction_weight = friction.beta * friction.unscale;
            /// β/(r²E)·φ_k(φᵀw), for the contact β/(r²E)·(φᵀw)²
            let mode_1_friction_force = friction_weight * constants_1.contact_squared;
            /// coefficient of cos τ − d
            let mode_1_fall = mode_1_friction_force * (mode_1.g / (mode_1.x * mode_1.x));
            /// coefficient of (1 − d)/x²
            let mode_1_rise = mode_1_friction_force * contact.scale;
            /// coefficient of sin τ − Rq̃
            let mode_1_forced = mode_1_friction_force * mode_1.u;
            /// β/(r²E)·φ_k(φᵀw), for the contact β/(r²E)·(φᵀw)²
            let mode_2_friction_force = friction_weight * constants_2.contact_squared;
            /// coefficient of cos τ − d
            let mode_2_fall = mode_2_friction_force * (mode_2.g / (mode_2.x * mode_2.x));
            /// coefficient of (1 − d)/x²
            let mode_2_rise = mode_2_friction_force * contact.scale;
            /// coefficient of sin τ − Rq̃
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
                        harmonic: constants_1.contact_squared * inverse_r * inverse_r,
                    },
                ),
                motion_wave(
                    mode_2.x,
                    <Damped<f64> as Decay<f64>>::of(constants_2),
                    ModalCoefficients {
                        rise: mode_2_rise,
                        fall: mode_2_fall,
                        forced: mode_2_forced,
                        harmonic: constants_2.contact_squared * inverse_r * inverse_r,
                    },
                ),
            ];
            Motion::of_contact(*friction, fundamental, waves)
        }
        /// The motion of mass k: its terms of cos τ and sin τ, and the coefficients of each mode.
        ///
        /// The coefficients are those of `contact_motion`, with φ_k(φᵀw) in place of (φᵀw)².
        /// The two products of a mode with itself cancel, so both are left out.  A mode with x < 1/2 is
        /// mass-controlled: `mass_wave` has its whole response, and its u and g are 0 in the sums.
        ///
        /// Operations: 138: 79 ×, 23 +, 20 compare, 12 sign, 4 ÷.
        /// The kernel adds one wave for each of 2 modes.  No search is made before an amplitude or a phase is asked for.
        fn mass_motion(
            at: &At<Self>,
            friction: &Friction<f64>,
            mass: usize,
        ) -> Option<MotionOf<Self>> {
            let inverse_r = at.inverse_ratio();
            let contact = at.contact_sums();
            let [constants_1, constants_2] = &Self::MODES;
            let [mode_1, mode_2] = at.modes();
            if mass != 1 {
                return None;
            }
            let [shape_1, shape_2] = *Self::SHAPES.get(mass)?;
            /// Re of the own term of V
            let mode_2_v_term_re = mode_2.response.re * constants_2.residue;
            /// Im of the own term of V
            let mode_2_v_term_im = mode_2.response.im * constants_2.residue;
            /// the own term of U
            let mode_2_u_term = constants_2.contact_squared * mode_2.u;
            /// U without the own term, or all of it for x < 1/2
            let mode_1_u_others = if mode_1.x < 0.5 { contact.u } else { mode_2_u_term };
            /// Re of the own term of V
            let mode_1_v_term_re = mode_1.response.re * constants_1.residue;
            /// Im of the own term of V
            let mode_1_v_term_im = mode_1.response.im * constants_1.residue;
            /// the own term of U
            let mode_1_u_term = constants_1.contact_squared * mode_1.u;
            /// U without the own term, or all of it for x < 1/2
            let mode_2_u_others = if mode_2.x < 0.5 { contact.u } else { mode_1_u_term };
            /// φ_k(φᵀp), from the load to mass k
            let mode_1_by_load = shape_1 * constants_1.load;
            /// Re of the own term of V_k
            let mode_1_driven_re = mode_1.response.re * mode_1_by_load;
            /// Im of the own term of V_k
            let mode_1_driven_im = mode_1.response.im * mode_1_by_load;
            /// φ_k(φᵀw), from the contact to mass k
            let mode_1_by_contact = shape_1 * constants_1.contact;
            /// g·E, or 0 if the mode is mass-controlled (x < 1/2)
            let mode_1_offset = if mode_1.x < 0.5 { 0.0 } else { mode_1.g };
            /// uR²·E, or 0 if the mode is mass-controlled (x < 1/2)
            let mode_1_u_in_sum = if mode_1.x < 0.5 { 0.0 } else { mode_1.u };
            /// the own term of −U_k
            let mode_1_rubbed_back = -(mode_1_by_contact * mode_1_u_in_sum);
            /// g·E/x²
            let mode_1_fall_per_force = mode_1_offset / (mode_1.x * mode_1.x);
            /// φ_k(φᵀp), from the load to mass k
            let mode_2_by_load = shape_2 * constants_2.load;
            /// Re of the own term of V_k
            let mode_2_driven_re = mode_2.response.re * mode_2_by_load;
            /// Im of the own term of V_k
            let mode_2_driven_im = mode_2.response.im * mode_2_by_load;
            /// φ_k(φᵀw), from the contact to mass k
            let mode_2_by_contact = shape_2 * constants_2.contact;
            /// g·E, or 0 if the mode is mass-controlled (x < 1/2)
            let mode_2_offset = if mode_2.x < 0.5 { 0.0 } else { mode_2.g };
            /// uR²·E, or 0 if the mode is mass-controlled (x < 1/2)
            let mode_2_u_in_sum = if mode_2.x < 0.5 { 0.0 } else { mode_2.u };
            /// the own term of −U_k
            let mode_2_rubbed_back = -(mode_2_by_contact * mode_2_u_in_sum);
            /// g·E/x²
            let mode_2_fall_per_force = mode_2_offset / (mode_2.x * mode_2.x);
            /// Re of V_k·r²E
            let response_re = mode_1_driven_re + mode_2_driven_re;
            /// Im of V_k·r²E
            let response_im = mode_1_driven_im + mode_2_driven_im;
            /// Re of V_kU − U_kV, without the products of a mode with itself
            let mismatch_re = mode_1_driven_re * mode_1_u_others
                + mode_2_v_term_re * mode_1_rubbed_back
                + (mode_2_driven_re * mode_2_u_others
                    + mode_1_v_term_re * mode_2_rubbed_back);
            /// Im of V_kU − U_kV, without the products of a mode with itself
            let mismatch_im = mode_1_driven_im * mode_1_u_others
                + mode_2_v_term_im * mode_1_rubbed_back
                + (mode_2_driven_im * mode_2_u_others
                    + mode_1_v_term_im * mode_2_rubbed_back);
            /// Re of V·r²E times 2²⁴, so that its reciprocal does not overflow
            let v_in_range_re = contact.v.re * 16777216.0;
            /// Im of V·r²E times 2²⁴, so that its reciprocal does not overflow
            let v_in_range_im = contact.v.im * 16777216.0;
            /// 1/(|Re| + |Im|) of the divisor
            let inverse_norm = 1.0
                / (Scalar::abs(v_in_range_re) + Scalar::abs(v_in_range_im));
            /// Re of the divisor, over |Re| + |Im|
            let unit_re = v_in_range_re * inverse_norm;
            /// Im of the divisor, over |Re| + |Im|
            let unit_im = v_in_range_im * inverse_norm;
            /// (1/(|Re| + |Im|))/(Re² + Im²) of `unit_re`, `unit_im`
            let inverse_modulus = inverse_norm / (unit_re * unit_re + unit_im * unit_im);
            /// Re of the reciprocal
            let inverse_re = unit_re * inverse_modulus;
            /// Im of the reciprocal
            let inverse_im = -(unit_im * inverse_modulus);
            /// Q·r²E times 2²⁴, which keeps products in range
            let root_in_range = friction.root * 16777216.0;
            /// β/(r²E)
            let friction_weight = friction.beta * friction.unscale;
            /// β times 2²⁴, which keeps products in range
            let beta_in_range = friction.beta * 16777216.0;
            /// (|Re V| + |Im V|)·r²E
            let v_size = Scalar::abs(contact.v.re) + Scalar::abs(contact.v.im);
            /// Re of V, or of V without the own term if that is smaller: the own term is in phase
            let mode_2_turning_re = if Scalar::abs(mode_1_v_term_re)
                + Scalar::abs(mode_1_v_term_im) < v_size
            {
                mode_1_v_term_re
            } else {
                contact.v.re
            };
            /// Im of V, or of V without the own term if that is smaller: the own term is in phase
            let mode_2_turning_im = if Scalar::abs(mode_1_v_term_re)
                + Scalar::abs(mode_1_v_term_im) < v_size
            {
                mode_1_v_term_im
            } else {
                contact.v.im
            };
            /// Re of V, or of V without the own term if that is smaller: the own term is in phase
            let mode_1_turning_re = if Scalar::abs(mode_2_v_term_re)
                + Scalar::abs(mode_2_v_term_im) < v_size
            {
                mode_2_v_term_re
            } else {
                contact.v.re
            };
            /// Im of V, or of V without the own term if that is smaller: the own term is in phase
            let mode_1_turning_im = if Scalar::abs(mode_2_v_term_re)
                + Scalar::abs(mode_2_v_term_im) < v_size
            {
                mode_2_v_term_im
            } else {
                contact.v.im
            };
            /// Q/(|Re V| + |Im V|)
            let in_phase_over_v = root_in_range * inverse_norm;
            /// β/(r²E)·φ_k(φᵀw), for the contact β/(r²E)·(φᵀw)²
            let mode_1_friction_force = friction_weight * mode_1_by_contact;
            /// coefficient of cos τ − d
            let mode_1_fall = mode_1_friction_force * mode_1_fall_per_force;
            /// coefficient of (1 − d)/x²
            let mode_1_rise = mode_1_friction_force * contact.scale;
            /// coefficient of sin τ − Rq̃
            let mode_1_forced = mode_1_friction_force * mode_1_u_in_sum;
            /// β/(r²E)·φ_k(φᵀw), for the contact β/(r²E)·(φᵀw)²
            let mode_2_friction_force = friction_weight * mode_2_by_contact;
            /// coefficient of cos τ − d
            let mode_2_fall = mode_2_friction_force * mode_2_fall_per_force;
            /// coefficient of (1 − d)/x²
            let mode_2_rise = mode_2_friction_force * contact.scale;
            /// coefficient of sin τ − Rq̃
            let mode_2_forced = mode_2_friction_force * mode_2_u_in_sum;
            let (fundamental, waves) = (
                Fundamental {
                    cosine: (root_in_range
                        * (response_re * inverse_re - response_im * inverse_im)
                        + beta_in_range
                            * (mismatch_re * inverse_im + mismatch_im * inverse_re))
                        * friction.unscale
                        + (-(mode_1_by_contact * mode_1_fall_per_force)
                            - mode_2_by_contact * mode_2_fall_per_force)
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
                            harmonic: mode_1_by_contact * inverse_r * inverse_r,
                        },
                    ),
                    mass_wave(
                        mode_2.x,
                        <Damped<f64> as Decay<f64>>::of(constants_2),
                        ModalCoefficients {
                            rise: mode_2_rise,
                            fall: mode_2_fall,
                            forced: mode_2_forced,
                            harmonic: mode_2_by_contact * inverse_r * inverse_r,
                        },
                    ),
                ],
            );
            Some(Motion::of_mass(*friction, fundamental, waves))
        }
    }
    /// `Clone`, `Copy`, `Debug`, `From` and `Deref`: the motion has all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(MountMotion, Continuous of Mount, Copy);
    impl MountMotion {
        /// Motion of mass `machine` (5.50 and its exact form, 7.29).
        #[must_use]
        pub fn machine(&self) -> MotionOf<Mount> {
            self.mass(1)
        }
    }
    impl ProvidesOrbit for Mount {
        type Orbit = MountOrbit;
        type State = [f64; 2];
        /// Returns the steady state that the motion from `start` reaches.  If the motion does not settle and `last` is true, it
        /// returns its last 64 cycles.  Otherwise the error [`NoOrbit`] gives the reason.
        #[inline]
        fn settled(
            at: &At<Self>,
            beta: f64,
            start: Start<'_, f64>,
            last: bool,
        ) -> Result<MountOrbit, NoOrbit> {
            Orbit::new(
                    Self::DYNAMICS,
                    at.frequency_ratio(),
                    beta,
                    at.sliding_limit(),
                    start,
                    last,
                    [Part::empty(); 3],
                    [0.0; 280],
                    [Complex { re: 0.0, im: 0.0 }; 4],
                )
                .map(From::from)
        }
    }
    /// `Clone`, `Debug`, `From` and `Deref`: the steady state has all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(MountOrbit, FixedOrbit of f64, 3, 280, 4);
    impl MountOrbit {
        /// Motion of mass `frame`.
        #[must_use]
        pub fn frame(&self) -> FixedOrbitMotion<'_, f64, 3, 280, 4> {
            self.mass(0)
        }
        /// Motion of mass `machine`.
        #[must_use]
        pub fn machine(&self) -> FixedOrbitMotion<'_, f64, 3, 280, 4> {
            self.mass(1)
        }
    }
};
