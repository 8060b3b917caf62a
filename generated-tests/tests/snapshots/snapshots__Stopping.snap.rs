/// The motion in time and the steady state in any regime.
///
/// Emitted by `friction_system!` of frictiongen 0.1.0 from scene eedbe5be51e36513.  Change the description, not this code.
///
/// # Description
///
/// ```text
/// pub struct Stopping
/// {
///     masses: { lower: 1.0, upper: 0.9 }, springs:
///     { base - lower: 1.0, lower - upper: 1.1 }, contact: upper - wall,
///     excitation: base, damping: modal[0.010, 0.012], stiction: 1.2, provide:
///     [orbit, simulation],
/// }
/// ```
///
/// The damping acts on absolute velocities (damping_from: rest, the default).
///
/// The motion in the contact is the displacement of `upper`.
///
/// # What it offers
///
/// * `K1`, `M1`, `NATURAL_FREQUENCIES_HZ`, `NATURAL_FREQUENCIES`, `RESONANCES`, `MODE_SHAPES`, `SCENE_HASH`: constants of the chain
/// * `frequency_ratio(omega)`, `friction_ratio(friction, load)`: r and β from units
/// * `at(r)` returns [`StoppingAt`], with `limits()` (β_lim and β*_lim), `regime(beta)` (continuous, stick-slip, stuck or bistable) and `margin(beta)` (β/min(β_lim, β*_lim) − 1, negative below both limits), or an error if r is negative or not a number
/// * `limits_without_search(r)`: an upper bound on β_lim, and β*_lim itself; `limits_into(rs, continuous, sliding)`: both limits for a slice of frequency ratios, into slices of the same length
/// * `at(r)?.orbit(beta)` returns [`StoppingOrbit`], the steady state in any regime, with `contact()`, `lower()` and `upper()`
/// * `simulation(r, beta)` and `simulation_from(r, beta, state)` return [`StoppingSimulation`], the motion in time from event to event, with `next()`, `lower()` and `upper()`
///
/// Answers of `at(r)` and of the simulation are non-dimensional: displacements are over Y, the amplitude of the base motion, and forces over k₁Y.  The time is τ = ωt.
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
pub struct Stopping;
/// [`Stopping`] at one frequency ratio: limits, regime, steady states.
///
/// Worst case: the operations of `functions`, and in each search at most `most_evaluations()` sums over 2 modes.  This number depends on r, and never exceeds 20000.
#[allow(
    deprecated,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
pub struct StoppingAt(::frictiongen::kernel::response::At<Stopping>);
/// Exact motion of [`Stopping`] in time, from event to event.  `next` returns its segments and never ends.
///
/// Worst case of `next`: 4000 steps of the search for the end of a segment, each a sum over at most 3 modes, those of the chain and of the stuck chain; of `advance` two segments.
#[allow(
    deprecated,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
pub struct StoppingSimulation(
    ::frictiongen::kernel::simulation::FixedSimulation<::core::primitive::f64, 3>,
);
/// Steady state of [`Stopping`] at one frequency and one friction ratio, in any regime.
///
/// Room for 3 modes of the chain and of the stuck chain, for 280 numbers (states at the starts of segments, Jacobian matrices) and for 4 Floquet multipliers.
///
/// Worst case: 1048576 steps of all searches for events together, each a sum over at most 3 modes, those of the chain and of the stuck chain, and Newton's method on 4 unknowns.
#[allow(
    deprecated,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
pub struct StoppingOrbit(
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
    impl Stopping {
        /// Hash of all fields of the scene and of all names (FNV-1a, 64 bits).  Descriptions that differ only in layout, comments
        /// or attributes have the same hash.  To verify it, emit the description again.
        pub const SCENE_HASH: ::core::primitive::u64 = 0xeedb_e5be_51e3_6513;
        /// k₁, the stiffness of the spring `base - lower`: N/m, if springs are in N/m.
        pub const K1: f64 = 1.0;
        /// m₁, the mass `lower`: kg, if masses are in kg.
        pub const M1: f64 = 1.0;
        /// Natural frequencies in Hz, ascending, if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES_HZ: [f64; 2] = [
            0.10330684532859413,
            0.2710729932653975,
        ];
        /// Natural frequencies ω_i, ascending; rad/s if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES: [f64; 2] = [
            0.6490960526996967,
            1.7032018484583367,
        ];
        /// Frequency ratios r of the undamped resonances, √λ_i = ω_i√(m₁/k₁).
        pub const RESONANCES: [f64; 2] = [0.6490960526996967, 1.7032018484583367];
        /// Mode shapes φ, [mode][mass], with φᵀΓφ = 1 and Γ = diag(m_i/m₁).  The first component that is not 0 is positive.
        pub const MODE_SHAPES: [[f64; 2]; 2] = [
            [0.5683291693328758, 0.8673087078783189],
            [0.8228012854179333, -0.5990715452678017],
        ];
        /// Constants of the chain.
        const CHAIN: Chain<f64> = Chain {
            /// true if a mode is damped
            damped: true,
            /// relative motion in the contact for r → 0, over the amplitude Y of the base motion, if the contact rubs on the moving base
            on_moving_base: None,
            /// m* = m₁/(effective mass of the contact)
            inverse_mass: 1.1111111111111112,
            /// μ, static over kinetic friction
            stiction: 1.2,
        };
        /// Returns the frequency ratio r = ω√(m₁/k₁) of an angular frequency ω, rad/s.
        #[inline]
        #[must_use]
        pub const fn frequency_ratio(omega: f64) -> f64 {
            omega
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
                resonance: 0.6490960526996967,
                /// ζ, the modal damping ratio
                zeta: 0.01,
                /// √|1 − ζ²|
                q: 0.9999499987499375,
                /// 1 − q
                q_defect: 5.000125006250391e-5,
                /// φᵀp, with p the load on each mass over k₁Y
                load: 0.5683291693328758,
                /// φᵀw, with w = 1 at the mass that rubs and −1 at its partner
                contact: 0.8673087078783189,
                /// (φᵀp)(φᵀw)
                residue: 0.4929168375036549,
                /// (φᵀw)², the term of m*
                contact_squared: 0.7522243947615592,
                /// (φᵀp)(φᵀw)/λ
                static_residue: 1.1699187927890582,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 1.7032018484583367,
                zeta: 0.012,
                q: 0.9999279974078134,
                q_defect: 7.20025921866408e-5,
                load: 0.8228012854179333,
                contact: -0.5990715452678017,
                residue: -0.4929168375036549,
                contact_squared: 0.3588867163495518,
                static_residue: -0.16991879278905825,
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
                sliding_at_rest: 0.43650793650793657,
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
        /// φ of all modes, [mass][mode].
        const ALL_SHAPES: [[f64; 2]; 2] = transposed(&Self::MODE_SHAPES);
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
                    frequency: 1.449137674618944,
                    /// ζ = −Re s/|s|
                    zeta: 0.010995103927964253,
                    /// √|1 − ζ²|
                    q: 0.9999395520178274,
                    /// force of the chain on the contact, with its damping force, at y = −1
                    force: 1.337251750218044,
                    /// m₁₁, m₁₂ and m₂₂ give y = m₁₁B(η, g) + m₁₂B(η, h) and u = m₁₂B(η, g) + m₂₂B(η, h).  η is the motion of the chain's modes minus the static motion that the stuck contact causes.  g and h are the `participations` of y and u.  B(a, b) is the sum of 2ζσab + a′b + ab′ over the chain's modes, with σ = `resonance`.  g′ is −Ωh, and h′ is Ω(g − 2ζh), with Ω = `frequency` and ζ of this mode.  [m₁₁, m₁₂, m₂₂] = [B(h, h), −B(g, h), B(g, g)]/(B(g, g)B(h, h) − B(g, h)²)
                    inverse: [
                        0.015221582697280134,
                        0.46646859015104253,
                        -0.025479323952963484,
                    ],
                },
            ],
            /// displacement of a mode of the chain per unit of y and of u: for each mode of `held` in turn, one pair for each mode that the contact drives; the largest number of a held mode has the modulus 1
            participations: &[
                [-0.6907246979374844, 0.011264683757455306],
                [-1.0, 0.016308500030608204],
            ],
            /// φ, mass after mass
            shapes: Self::ALL_SHAPES.as_flattened(),
            /// φᵀΓ, mode after mode
            weights: &[
                0.5683291693328758,
                0.7805778370904871,
                0.8228012854179333,
                -0.5391643907410216,
            ],
            /// index of the mass that rubs on a support
            rubbing: Some(1),
        };
        /// Starts the exact motion in time from rest, at a maximum of the excitation.
        ///
        /// # Errors
        /// `OutOfDomain` unless r is positive and finite, and β finite and not negative.
        pub fn simulation(r: f64, beta: f64) -> Result<StoppingSimulation, OutOfDomain> {
            let parts = [Part::empty(); 3];
            Simulation::new(Self::DYNAMICS, r, beta, None, parts).map(From::from)
        }
        /// Starts from a state at a maximum of the excitation: x̄ and dx̄/dτ of every mass, in the order of the description.
        ///
        /// # Errors
        /// `OutOfDomain` also for a state that is not finite.
        pub fn simulation_from(
            r: f64,
            beta: f64,
            state: (&[f64; 2], &[f64; 2]),
        ) -> Result<StoppingSimulation, OutOfDomain> {
            let parts = [Part::empty(); 3];
            let start = Some((&state.0[..], &state.1[..]));
            Simulation::new(Self::DYNAMICS, r, beta, start, parts).map(From::from)
        }
    }
    /// The functions `at`, `limits_without_search` and `limits_into`.
    ::frictiongen::kernel::scene_functions!(Stopping, StoppingAt, f64, At);
    /// The trait `FrictionSystem`, by which generic code calls any scene.  The texts are the names of the masses.
    ::frictiongen::emitted_system!(Stopping, StoppingAt, f64, ["lower", "upper"]);
    /// `Clone`, `Copy`, `Debug`, `From` and `Deref`: the answers at one frequency have all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(StoppingAt, At of Stopping, Copy);
    impl Scene for Stopping {
        /// The items that every scene has: types, constants and the calls of the frequency stage.  The word says whether a
        /// mode is damped, and the number is the number of modes that the load or the contact drives.
        ::frictiongen::kernel::scene_items!(f64, damped, 2);
        /// Neither the continuous motion nor the stuck response of a mass is provided, so no formula at one frequency needs
        /// mode shapes.
        #[inline]
        fn shape(&self, _: usize) -> Option<&[f64]> {
            None
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
        StoppingAt : motion, stuck; Stopping : stepper, self_check
    );
    /// `Clone`, `Debug`, `From` and `Deref`: the simulation has all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(StoppingSimulation, FixedSimulation of f64, 3);
    impl StoppingSimulation {
        /// Displacement and velocity of mass `lower` at the present instant.
        #[must_use]
        pub fn lower(&self) -> Moment<f64> {
            self.mass(0)
        }
        /// Displacement and velocity of mass `upper` at the present instant.
        #[must_use]
        pub fn upper(&self) -> Moment<f64> {
            self.mass(1)
        }
    }
    impl ::frictiongen::Simulates for Stopping {
        type Run<'a> = StoppingSimulation;
        fn simulation(
            &self,
            r: f64,
            beta: f64,
        ) -> Result<StoppingSimulation, OutOfDomain> {
            Self::simulation(r, beta)
        }
    }
    impl ::core::ops::DerefMut for StoppingSimulation {
        fn deref_mut(&mut self) -> &mut Self::Target {
            &mut self.0
        }
    }
    impl<'a> IntoIterator for &'a mut StoppingSimulation {
        type Item = Segment<f64>;
        type IntoIter = &'a mut FixedSimulation<f64, 3>;
        fn into_iter(self) -> Self::IntoIter {
            &mut self.0
        }
    }
    impl ProvidesOrbit for Stopping {
        type Orbit = StoppingOrbit;
        type State = [f64; 2];
        /// Returns the steady state that the motion from `start` reaches.  If the motion does not settle and `last` is true, it
        /// returns its last 64 cycles.  Otherwise the error [`NoOrbit`] gives the reason.
        #[inline]
        fn settled(
            at: &At<Self>,
            beta: f64,
            start: Start<'_, f64>,
            last: bool,
        ) -> Result<StoppingOrbit, NoOrbit> {
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
    ::frictiongen::kernel::wraps!(StoppingOrbit, FixedOrbit of f64, 3, 280, 4);
    impl StoppingOrbit {
        /// Motion of mass `lower`.
        #[must_use]
        pub fn lower(&self) -> FixedOrbitMotion<'_, f64, 3, 280, 4> {
            self.mass(0)
        }
        /// Motion of mass `upper`.
        #[must_use]
        pub fn upper(&self) -> FixedOrbitMotion<'_, f64, 3, 280, 4> {
            self.mass(1)
        }
    }
};
