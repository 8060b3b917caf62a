/// Two masses with an elastic contact (Jenkins element): the stuck state, the steady state, the motion in time and a
/// stepper.
///
/// Emitted by `friction_system!` of frictiongen 0.1.0 from scene 5f758146e4b6252c.  Change the description, not this code.
///
/// # Description
///
/// ```text
/// pub struct Sprung
/// {
///     masses: { lower: 3.27, upper: 3.25 }, springs:
///     { base - lower: 1190.0, lower - upper: 1323.0 }, contact: upper - wall,
///     stiffness: 5.0e3, excitation: base, damping: modal[0.010, 0.012], provide:
///     [stuck, orbit, simulation, stepper], step: 1e-3,
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
/// * `at(r)` returns [`SprungAt`], with `limits()` (β_lim and β*_lim), `regime(beta)` (continuous, stick-slip, stuck or bistable) and `margin(beta)` (β/min(β_lim, β*_lim) − 1, negative below both limits), or an error if r is negative or not a number
/// * `limits_without_search(r)`: an upper bound on β_lim, and β*_lim itself; `limits_into(rs, continuous, sliding)`: both limits for a slice of frequency ratios, into slices of the same length
/// * `at(r)?.stuck()` returns [`SprungStuck`], the response while the contact is stuck, with `contact_force()`, `lower()` and `upper()`
/// * `at(r)?.orbit(beta)` returns [`SprungOrbit`], the steady state in any regime, with `contact()`, `lower()` and `upper()`
/// * `simulation(r, beta)` and `simulation_from(r, beta, state)` return [`SprungSimulation`], the motion in time from event to event, with `next()`, `lower()` and `upper()`
/// * `stepper(dt)`, `stepper_from(dt, state)` and `stepper_from_image(image)` return [`SprungStepper`], the motion by steps under any [`SprungInput`], with `begin(input)`, `advance(input)`, `image()`, `contact()`, `lower()` and `upper()`
/// * `declared_stepper()` returns [`SprungDeclaredStepper`], which borrows the tables of the declared step `STEP`, s
///
/// Answers of `at(r)` and of the simulation are non-dimensional: displacements are over Y, the amplitude of the base motion, and forces over k₁Y.  The time is τ = ωt.  The stepper uses the units of the scene, and seconds.
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
pub struct Sprung;
/// [`Sprung`] at one frequency ratio: limits, regime, stuck response, steady states.
///
/// Worst case: the operations of `functions`, and in each search at most `most_evaluations()` sums over 2 modes.  This number depends on r, and never exceeds 20000.
#[allow(
    deprecated,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
pub struct SprungAt(::frictiongen::kernel::response::At<Sprung>);
/// Response of [`Sprung`] at one frequency ratio while its contact is stuck.
#[allow(
    deprecated,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
pub struct SprungStuck(::frictiongen::kernel::response::Stuck<Sprung>);
/// Exact motion of [`Sprung`] in time, from event to event.  `next` returns its segments and never ends.
///
/// Worst case of `next`: 4000 steps of the search for the end of a segment, each a sum over at most 4 modes, those of the chain and of the stuck chain; of `advance` two segments.
#[allow(
    deprecated,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
pub struct SprungSimulation(
    ::frictiongen::kernel::simulation::FixedSimulation<
        ::core::primitive::f64,
        4,
        ::frictiongen::kernel::motion::ElasticChain<::core::primitive::f64>,
    >,
);
/// Steady state of [`Sprung`] at one frequency and one friction ratio, in any regime.
///
/// Room for 4 modes of the chain and of the stuck chain, for 291 numbers (states at the starts of segments, Jacobian matrices) and for 5 Floquet multipliers.
///
/// Worst case: 1048576 steps of all searches for events together, each a sum over at most 4 modes, those of the chain and of the stuck chain, and Newton's method on 5 unknowns.
#[allow(
    deprecated,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
pub struct SprungOrbit(
    ::frictiongen::kernel::orbit::FixedOrbit<
        ::core::primitive::f64,
        4,
        291,
        5,
        ::frictiongen::kernel::motion::ElasticChain<::core::primitive::f64>,
    >,
);
/// Stepper: motion of [`Sprung`] in time, by steps of one length, under any input.  `advance` takes a step.
///
/// A step of dt, in s, has ⌈46.07·dt⌉ parts, at most 1024: `STEP` has 1.  46.07 is the largest ω(1 + 2ζ) of a mode, in rad/s: in a part, the phase of the fastest mode advances by at most 1 rad.
/// A part in which the contact certainly keeps sliding, or keeps sticking, is a product of its state with tables.
/// In any other part the stepper searches the events, at most 8.
/// After these events, a contact at rest stays stuck to the end of the part, and in any other contact the friction force is constant there.  This force opposes the displacement of the contact in the part, so that it creates no energy.  `exceeded()` counts the step.
///
/// A step of `STEP` has at most 640 floating-point operations if all parts are such products, about 10888 with one event, never
/// more than 1639058.  `set_event_budget(n)` limits the events of a step to n, and `cost().most` is then the bound.
/// The numbers in its type: 4 coefficients of an input over a part, 2 modes, 2 modes with the contact stuck, 1 input.
#[allow(
    deprecated,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
pub struct SprungStepper(
    ::frictiongen::kernel::stepper::FixedStepper<
        ::core::primitive::f64,
        4,
        2,
        2,
        1,
        ::frictiongen::kernel::motion::ElasticChain<::core::primitive::f64>,
    >,
);
/// Loads on [`Sprung`] at an instant, in the units of the scene: the input of a step.
#[allow(
    deprecated,
    non_camel_case_types,
    non_snake_case,
    reason = "names and attributes are those of the description"
)]
#[::core::prelude::v1::derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq,
    ::core::default::Default
)]
pub struct SprungInput {
    /// Absolute displacement of the base.
    pub displacement: ::core::primitive::f64,
    /// Absolute velocity of the base, in the unit of displacement per second.
    pub velocity: ::core::primitive::f64,
    /// Kinetic friction force F, not negative.  A stuck contact holds up to μF.
    pub friction: ::core::primitive::f64,
}
/// With the feature `serde` of frictiongen, serde writes and reads these fields by name.
::frictiongen::kernel::written!(SprungInput, displacement, velocity, friction);
/// Stepper of the declared step `STEP`.  It borrows its tables, which stay constants of the program, and has the methods and the costs of [`SprungStepper`].
#[allow(
    dead_code,
    deprecated,
    non_camel_case_types,
    reason = "a program may use only the other stepper, and names and attributes are those of the description"
)]
pub struct SprungDeclaredStepper(
    ::frictiongen::kernel::stepper::DeclaredStepper<
        ::core::primitive::f64,
        4,
        2,
        2,
        1,
        ::frictiongen::kernel::motion::ElasticChain<::core::primitive::f64>,
    >,
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
    /// Hides a constant of this name in the user's module.
    #[allow(dead_code)]
    fn compliance() {}
    impl Sprung {
        /// Hash of all fields of the scene and of all names (FNV-1a, 64 bits).  Descriptions that differ only in layout, comments
        /// or attributes have the same hash.  To verify it, emit the description again.
        pub const SCENE_HASH: ::core::primitive::u64 = 0x5f75_8146_e4b6_252c;
        /// k₁, the stiffness of the spring `base - lower`: N/m, if springs are in N/m.
        pub const K1: f64 = 1190.0;
        /// m₁, the mass `lower`: kg, if masses are in kg.
        pub const M1: f64 = 3.27;
        /// √(k₁/m₁), by which angular frequencies are divided: rad/s.
        const REFERENCE: f64 = 19.07653986153372;
        /// Natural frequencies in Hz, ascending, if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES_HZ: [f64; 2] = [
            1.9068239289554347,
            5.112902557500495,
        ];
        /// Natural frequencies ω_i, ascending; rad/s if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES: [f64; 2] = [
            11.980928093791238,
            32.12531422632804,
        ];
        /// Frequency ratios r of the undamped resonances, √λ_i = ω_i√(m₁/k₁).
        pub const RESONANCES: [f64; 2] = [0.6280451371556012, 1.6840220742078127];
        /// Mode shapes φ, [mode][mass], with φᵀΓφ = 1 and Γ = diag(m_i/m₁).  The first component that is not 0 is positive.
        pub const MODE_SHAPES: [[f64; 2]; 2] = [
            [0.5446174012864552, 0.8412612267718186],
            [0.8386846166563378, -0.5462905769681745],
        ];
        /// Constants of the chain.
        const CHAIN: Chain<f64> = Chain {
            /// true if a mode is damped
            damped: true,
            /// relative motion in the contact for r → 0, over the amplitude Y of the base motion, if the contact rubs on the moving base
            on_moving_base: None,
            /// m* = m₁/(effective mass of the contact)
            inverse_mass: 1.0061538461538462,
            /// μ, static over kinetic friction
            stiction: 1.0,
        };
        /// Constants of the chain and of its elastic contact.  ρ = k₁/k is the compliance of the spring in series with
        /// the slider.
        const CONTACT: ElasticChain<f64> = ElasticChain {
            chain: Self::CHAIN,
            compliance: 0.238,
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
                resonance: 0.6280451371556012,
                /// ζ, the modal damping ratio
                zeta: 0.01,
                /// √|1 − ζ²|
                q: 0.9999499987499375,
                /// 1 − q
                q_defect: 5.000125006250391e-5,
                /// φᵀp, with p the load on each mass over k₁Y
                load: 0.5446174012864552,
                /// φᵀw, with w = 1 at the mass that rubs and −1 at its partner
                contact: 0.8412612267718186,
                /// (φᵀp)(φᵀw)
                residue: 0.4581655031275231,
                /// (φᵀw)², the term of m*
                contact_squared: 0.7077204516696252,
                /// (φᵀp)(φᵀw)/λ
                static_residue: 1.1615573893435114,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 1.6840220742078127,
                zeta: 0.012,
                q: 0.9999279974078134,
                q_defect: 7.20025921866408e-5,
                load: 0.8386846166563378,
                contact: -0.5462905769681745,
                residue: -0.4581655031275231,
                contact_squared: 0.298433394484221,
                static_residue: -0.16155738934351133,
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
                sliding_at_rest: 0.4678426266516825,
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
        const DYNAMICS: Dynamics<'static, f64, ElasticChain<f64>> = Dynamics {
            /// constants of the chain and of its elastic contact
            chain: Self::CONTACT,
            /// all modes, those that the contact drives first
            modes: &Self::MODES,
            /// modes of the chain with its contact stuck; the state of a mode is y and u = y′/Ω
            held: &[
                HeldMode {
                    /// kind of damping: `Undamped` for ζ = 0, `Light` for ζ < 1/2, `Heavy` for ζ < 1, `Critical` for ζ = 1, `Over` for ζ > 1
                    kind: Kind::Light,
                    /// |s| of the oscillator's root s, over √(k₁/m₁): without damping, the frequency ratio r of the resonance
                    frequency: 1.3283910228049443,
                    /// ζ = −Re s/|s|
                    zeta: 0.009007498923082695,
                    /// √|1 − ζ²|
                    q: 0.9999594316586802,
                    /// force of the chain on the contact, with its damping force, at y = −1
                    force: 1.6289215511039128,
                    /// m₁₁, m₁₂ and m₂₂ give y = m₁₁B(η, g) + m₁₂B(η, h) and u = m₁₂B(η, g) + m₂₂B(η, h).  η is the motion of the chain's modes minus the static motion that the stuck contact causes.  g and h are the `participations` of y and u.  B(a, b) is the sum of 2ζσab + a′b + ab′ over the chain's modes, with σ = `resonance`.  g′ is −Ωh, and h′ is Ω(g − 2ζh), with Ω = `frequency` and ζ of this mode.  [m₁₁, m₁₂, m₂₂] = [B(h, h), −B(g, h), B(g, g)]/(B(g, g)B(h, h) − B(g, h)²)
                    inverse: [
                        0.013243220276520692,
                        0.445099339002115,
                        -0.021261683909973433,
                    ],
                },
                HeldMode {
                    kind: Kind::Light,
                    frequency: 2.3860213867627627,
                    zeta: 0.006086800242141135,
                    q: 0.9999814752598232,
                    force: 5.230595946387919,
                    inverse: [
                        -0.0012843742659964996,
                        0.2480703742159704,
                        -0.0017355353616951216,
                    ],
                },
            ],
            /// displacement of a mode of the chain per unit of y and of u: for each mode of `held` in turn, one pair for each mode that the contact drives; the largest number of a held mode has the modulus 1
            participations: &[
                [-1.0, 0.011025457704632096],
                [-0.8302868779585623, 0.016978674839672275],
                [-0.8304094329330529, 0.006165154199322883],
                [1.0, 0.009494041090263854],
            ],
            /// φ, mass after mass
            shapes: Self::SHAPES.as_flattened(),
            /// φᵀΓ, mode after mode
            weights: &[
                0.5446174012864552,
                0.8361158981677096,
                0.8386846166563378,
                -0.5429493501977269,
            ],
            /// index of the mass that rubs on a support
            rubbing: Some(1),
        };
        /// Starts the exact motion in time from rest, at a maximum of the excitation.
        ///
        /// # Errors
        /// `OutOfDomain` unless r is positive and finite, and β finite and not negative.
        pub fn simulation(r: f64, beta: f64) -> Result<SprungSimulation, OutOfDomain> {
            let parts = [Part::empty(); 4];
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
        ) -> Result<SprungSimulation, OutOfDomain> {
            let parts = [Part::empty(); 4];
            let start = Some((&state.0[..], &state.1[..]));
            Simulation::new(Self::DYNAMICS, r, beta, start, parts).map(From::from)
        }
        /// Step, s, for which the tables are constants.
        pub const STEP: f64 = 0.001;
        /// Constants of the stepper.
        const STEP_SCENE: StepScene<'static, f64, ElasticChain<f64>> = StepScene {
            /// modes of the chain, and of the chain with its contact stuck
            dynamics: Self::DYNAMICS,
            /// factors to the units of the scene
            units: Units {
                /// k₁
                stiffness: Self::K1,
                /// √(k₁/m₁), rad/s
                rate: Self::REFERENCE,
                /// sum of the springs to the base, over k₁
                support: 1.0,
            },
            /// true if the base moves
            on_base: true,
            /// indices of the loaded masses
            forces: &[],
            /// interpolation of forces and friction between two samples; with `Linear` a base follows a cubic
            input: Input::Linear,
            /// points of a friction law over the speed: speed, kinetic friction over F; without points the kinetic friction is F
            law: &[],
        };
        /// Returns the tables for the step dt, s.  If dt is the declared step `STEP`, the tables are constants.
        #[inline]
        fn step_tables(dt: f64) -> Result<FixedTables<f64, 4, 2, 2, 1>, OutOfDomain> {
            if dt.to_bits() == Self::STEP.to_bits() {
                return Ok(Self::STEP_TABLES);
            }
            FixedTables::new(&Self::STEP_SCENE, dt)
        }
        /// Creates a stepper with the step dt, s, for a chain at rest without load.
        ///
        /// # Errors
        /// `OutOfDomain` for a step that is not positive and finite, or too long.
        #[inline]
        pub fn stepper(dt: f64) -> Result<SprungStepper, OutOfDomain> {
            let tables = Self::step_tables(dt)?;
            Stepper::new(Self::STEP_SCENE, tables, FixedStore::new(), None)
                .map(From::from)
        }
        /// Creates a stepper that starts from a state: absolute displacements and velocities of all masses, in the order of the
        /// description.  The unit of time is the second.
        ///
        /// # Errors
        /// `OutOfDomain` also for a state that is not finite.
        #[inline]
        pub fn stepper_from(
            dt: f64,
            state: (&[f64; 2], &[f64; 2]),
        ) -> Result<SprungStepper, OutOfDomain> {
            let tables = Self::step_tables(dt)?;
            let state = Some((&state.0[..], &state.1[..]));
            Stepper::new(Self::STEP_SCENE, tables, FixedStore::new(), state)
                .map(From::from)
        }
        /// Creates a stepper with the declared step `STEP`, for a chain at rest without load.  It computes and copies no
        /// tables, and can be the value of a `static`.  The pair of numbers is the friction force at the start, and μ.
        #[inline]
        #[must_use]
        #[allow(
            dead_code,
            clippy::init_numbered_fields,
            reason = "a program may use only the other stepper; for a scene in a function the type is an alias, which has no constructor function"
        )]
        pub const fn declared_stepper() -> SprungDeclaredStepper {
            SprungDeclaredStepper {
                0: DeclaredStepper::declared(
                    Self::STEP_SCENE,
                    &Self::STEP_TABLES,
                    (0.0, Self::CHAIN.stiction),
                ),
            }
        }
    }
    /// The functions `at`, `limits_without_search` and `limits_into`.
    ::frictiongen::kernel::scene_functions!(Sprung, SprungAt, f64, At);
    /// The trait `FrictionSystem`, by which generic code calls any scene.  The texts are the names of the masses.
    ::frictiongen::emitted_system!(Sprung, SprungAt, f64, ["lower", "upper"]);
    /// `Clone`, `Copy`, `Debug`, `From` and `Deref`: the answers at one frequency have all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(SprungAt, At of Sprung, Copy);
    impl Scene for Sprung {
        /// The items that every scene has: types, constants and the calls of the frequency stage.  The word says whether a
        /// mode is damped, and the number is the number of modes that the load or the contact drives.
        ::frictiongen::kernel::scene_items!(f64, damped, 2);
        /// Components of a mass in the mode shapes.
        #[inline]
        fn shape(&self, mass: usize) -> Option<&[f64]> {
            Self::SHAPES.get(mass).map(<[f64; 2]>::as_slice)
        }
        /// Compliance ρ of the elastic contact, which is added to H.
        #[inline]
        fn compliance(&self) -> Option<f64> {
            Some(Self::CONTACT.compliance)
        }
        /// Smallest and largest 1/r at which the formulas are evaluated: 2^-400 and 2^400.
        /// Any other 1/r is moved to the nearer of both, at which the formulas have reached their limits for r → ∞ or r → 0.
        /// Between both, no square of √λ/r overflows or underflows.
        #[inline]
        fn inverse_ratio_range(&self) -> (f64, f64) {
            (3.8725919148493183e-121, 2.5822498780869086e120)
        }
    }
    /// Placeholders for methods that `provide` does not list: the compiler refuses a call and says what to add.
    ::frictiongen::kernel::not_provided!(SprungAt : motion; Sprung : self_check);
    /// The responses are those of the kernel, which sums over the modes in loops.  Worst case: a fixed number of
    /// operations for each mode, without a search.
    impl ProvidesStuck for Sprung {
        type Stuck = SprungStuck;
    }
    /// `Clone`, `Copy`, `Debug`, `From` and `Deref`: the response has all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(SprungStuck, Stuck of Sprung, Copy);
    impl SprungStuck {
        /// x̄* = V_k − H_kV/(H + ρ), the complex amplitude of mass `lower` over Y (6.11, 6.27, 6.33).
        #[must_use]
        pub fn lower(&self) -> Complex<f64> {
            self.mass(0)
        }
        /// x̄* = V_k − H_kV/(H + ρ), the complex amplitude of mass `upper` over Y (6.11, 6.27, 6.33).
        #[must_use]
        pub fn upper(&self) -> Complex<f64> {
            self.mass(1)
        }
    }
    /// `Clone`, `Debug`, `From` and `Deref`: the simulation has all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(SprungSimulation, FixedSimulation of elastic f64, 4);
    impl SprungSimulation {
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
    impl ::frictiongen::Simulates for Sprung {
        type Run<'a> = SprungSimulation;
        fn simulation(
            &self,
            r: f64,
            beta: f64,
        ) -> Result<SprungSimulation, OutOfDomain> {
            Self::simulation(r, beta)
        }
    }
    impl ::core::ops::DerefMut for SprungSimulation {
        fn deref_mut(&mut self) -> &mut Self::Target {
            &mut self.0
        }
    }
    impl<'a> IntoIterator for &'a mut SprungSimulation {
        type Item = Segment<f64>;
        type IntoIter = &'a mut FixedSimulation<f64, 4, ElasticChain<f64>>;
        fn into_iter(self) -> Self::IntoIter {
            &mut self.0
        }
    }
    impl ProvidesOrbit for Sprung {
        type Orbit = SprungOrbit;
        type State = [f64; 2];
        /// Returns the steady state that the motion from `start` reaches.  If the motion does not settle and `last` is true, it
        /// returns its last 64 cycles.  Otherwise the error [`NoOrbit`] gives the reason.
        #[inline]
        fn settled(
            at: &At<Self>,
            beta: f64,
            start: Start<'_, f64>,
            last: bool,
        ) -> Result<SprungOrbit, NoOrbit> {
            Orbit::new(
                    Self::DYNAMICS,
                    at.frequency_ratio(),
                    beta,
                    at.sliding_limit(),
                    start,
                    last,
                    [Part::empty(); 4],
                    [0.0; 291],
                    [Complex { re: 0.0, im: 0.0 }; 5],
                )
                .map(From::from)
        }
    }
    /// `Clone`, `Debug`, `From` and `Deref`: the steady state has all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(SprungOrbit, FixedOrbit of elastic f64, 4, 291, 5);
    impl SprungOrbit {
        /// Motion of mass `lower`.
        #[must_use]
        pub fn lower(&self) -> FixedOrbitMotion<'_, f64, 4, 291, 5, ElasticChain<f64>> {
            self.mass(0)
        }
        /// Motion of mass `upper`.
        #[must_use]
        pub fn upper(&self) -> FixedOrbitMotion<'_, f64, 4, 291, 5, ElasticChain<f64>> {
            self.mass(1)
        }
    }
    /// `Clone`, `Debug`, `From` and `Deref`: the stepper has all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(
        SprungStepper, FixedStepper of elastic f64, 4, 2, 2, 1
    );
    impl SprungStepper {
        /// Sets the input at the start of the first step.  Without this call the input there is 0.
        ///
        /// # Errors
        /// Same errors as `advance`.  A call after the first step returns `OutOfDomain`.
        pub fn begin(&mut self, input: SprungInput) -> Result<(), OutOfDomain> {
            self.0
                .begin(Sample {
                    base: [input.displacement, input.velocity],
                    forces: &[],
                    friction: input.friction,
                })
        }
        /// Takes a step.  Friction changes linearly over it.  The base follows the cubic through the displacements and velocities of the last input and of this one.
        /// Returns the state of the contact and the friction force at the end of the step, and the number of events in it.  The comment on [`SprungStepper`] gives the number of operations.
        ///
        /// # Errors
        /// `OutOfDomain` for NaN, infinite numbers, negative friction, numbers whose squares overflow, and if the energies
        /// that `work()` returns would overflow.  The stepper then keeps its state.
        pub fn advance(
            &mut self,
            input: SprungInput,
        ) -> Result<Stepped<f64>, OutOfDomain> {
            self.0
                .advance(Sample {
                    base: [input.displacement, input.velocity],
                    forces: &[],
                    friction: input.friction,
                })
        }
        /// Absolute displacement and velocity of mass `lower` now.
        #[must_use]
        pub fn lower(&self) -> MassNow<f64> {
            self.mass(0)
        }
        /// Absolute displacement and velocity of mass `upper` now.
        #[must_use]
        pub fn upper(&self) -> MassNow<f64> {
            self.mass(1)
        }
    }
    impl ::core::ops::DerefMut for SprungStepper {
        fn deref_mut(&mut self) -> &mut Self::Target {
            &mut self.0
        }
    }
    /// The traits `Steps` and `Stepping`, and the functions `image` and `stepper_from_image`, which write and read the state
    /// as bytes.  `true` stands for a moving base.  The list contains the indices of the loaded masses.
    ::frictiongen::emitted_stepper!(Sprung, SprungStepper, f64, true, []);
    /// `Clone`, `Debug`, `From` and `Deref`: the stepper has all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(
        SprungDeclaredStepper, DeclaredStepper of elastic f64, 4, 2, 2, 1
    );
    impl SprungDeclaredStepper {
        /// Sets the input at the start of the first step.  Without this call the input there is 0.
        ///
        /// # Errors
        /// Same errors as `advance`.  A call after the first step returns `OutOfDomain`.
        pub fn begin(&mut self, input: SprungInput) -> Result<(), OutOfDomain> {
            self.0
                .begin(Sample {
                    base: [input.displacement, input.velocity],
                    forces: &[],
                    friction: input.friction,
                })
        }
        /// Takes a step.  Friction changes linearly over it.  The base follows the cubic through the displacements and velocities of the last input and of this one.
        /// Returns the state of the contact and the friction force at the end of the step, and the number of events in it.  The comment on [`SprungStepper`] gives the number of operations.
        ///
        /// # Errors
        /// `OutOfDomain` for NaN, infinite numbers, negative friction, numbers whose squares overflow, and if the energies
        /// that `work()` returns would overflow.  The stepper then keeps its state.
        pub fn advance(
            &mut self,
            input: SprungInput,
        ) -> Result<Stepped<f64>, OutOfDomain> {
            self.0
                .advance(Sample {
                    base: [input.displacement, input.velocity],
                    forces: &[],
                    friction: input.friction,
                })
        }
        /// Absolute displacement and velocity of mass `lower` now.
        #[must_use]
        pub fn lower(&self) -> MassNow<f64> {
            self.mass(0)
        }
        /// Absolute displacement and velocity of mass `upper` now.
        #[must_use]
        pub fn upper(&self) -> MassNow<f64> {
            self.mass(1)
        }
    }
    impl ::core::ops::DerefMut for SprungDeclaredStepper {
        fn deref_mut(&mut self) -> &mut Self::Target {
            &mut self.0
        }
    }
    /// The trait `Stepping` and the function `image`.  Base and loaded masses are written as above.
    ::frictiongen::emitted_stepper!(declared SprungDeclaredStepper, f64, true, []);
    /// Tables: numbers alone, apart from the code that reads them.
    impl Sprung {
        /// Advance of each oscillator over a part of `STEP`, with the time s from 0 to 1: y′ = Ωu, u′ = −Ω(y + 2ζu) + drive.
        /// σ = √λ is the frequency ratio of the mode's resonance.  The drive is a polynomial in s.
        ///
        /// A `Row` has the weights of y and u (`state`) and of the coefficients of the drive (`drive`).  y and u are those at the
        /// start of the part, except in a shear, where they are the present ones.
        /// In a `HeldRow` the first list of `drive` belongs to a drive of y, the second to a drive of u.
        /// Three shears advance y and u: y gains a·u, then u gains −b·y − c·u and a drive, then y gains a′·u and a drive.  `turn`
        /// or the first of `turns` has the state weights [−b, −c], the first of `moments` has [a, a′].
        ///
        /// These numbers are 0: the first weight for a drive of u in the first of `moments`, because a constant drive moves y only
        /// through u; `from_base` of a contact that does not rub on the moving base; and `held_loads` of an input that acts on a
        /// mass that a stuck contact holds at a support.
        ///
        /// Computed in double-double and rounded once: each number is exact to half a unit of its last place.  Numbers below
        /// 1e-26 of their largest terms are 0.
        /// 261 numbers; CRC-32 of their text, joined by commas: cd708864.
        const STEP_TABLES: FixedTables<f64, 4, 2, 2, 1> = FixedTables {
            /// how the step is divided into parts
            pace: Pace {
                /// the step, s
                step: 0.001,
                /// number of parts of the step
                parts: 1,
                /// length of a part in the time t√(k₁/m₁)
                span: 0.019076539861533723,
                /// largest angle of an oscillator in a part, with its damping, rad
                rate: 0.04607113825900722,
                /// terms of a power series over a part
                terms: 9,
                /// wᵀ(K/k₁)⁻¹w, displacement of the contact per unit of steady force
                receptance: 2.1374708994708995,
                /// damping force per unit of velocity of the contact, (Σ 2ζ(φᵀw)²/σ)/receptance
                drag: 0.012533691014476583,
            },
            /// the modes of the chain
            modes: [
                ModeStep {
                    /// Ω, angle of the undamped mode in a part, rad
                    angle: 0.011980928093791239,
                    /// ζ, the modal damping ratio
                    zeta: 0.01,
                    /// Ω/σ², rate of u per unit of modal force
                    per_force: 0.030374472681901233,
                    /// φᵀw, displacement of the contact per unit of the mode
                    contact: 0.8412612267718186,
                    /// shear of u
                    turn: Row {
                        state: [-0.011979206189447332, -0.00023958985564112174],
                        drive: [
                            0.9998562795527669,
                            0.49995408562387184,
                            0.3333109738987084,
                            0.2499868234466716,
                        ],
                    },
                    /// the first row: both shears of y; row j > 0: weights of ∫ sʲy′ ds
                    moments: [
                        Row {
                            state: [0.0059902964634389174, 0.0059907749469114],
                            drive: [
                                0.0,
                                -0.0009984250051855111,
                                -0.0009984329799264024,
                                -0.0008985943644501107,
                            ],
                        },
                        Row {
                            state: [-4.784256009164269e-5, 0.005989292239390575],
                            drive: [
                                0.00399322654448078,
                                0.0014975083795576672,
                                0.0007986845738658952,
                                0.0004991830405481233,
                            ],
                        },
                        Row {
                            state: [-3.588164789296655e-5, 0.003992753100485772],
                            drive: [
                                0.0029948971909414222,
                                0.0011980028317100818,
                                0.0006655693583378706,
                                0.0004278707545892542,
                            ],
                        },
                        Row {
                            state: [-2.8705170974996717e-5, 0.0029945146166230653],
                            drive: [
                                0.002395905454926511,
                                0.0009983333680691712,
                                0.0005704872974473652,
                                0.00037438662126945183,
                            ],
                        },
                    ],
                },
                ModeStep {
                    angle: 0.03212531422632804,
                    zeta: 0.012,
                    per_force: 0.011327963067531397,
                    contact: -0.5462905769681745,
                    turn: Row {
                        state: [-0.03210740964769554, -0.0007707103914905889],
                        drive: [
                            0.9994426644823967,
                            0.49982853675390027,
                            0.3332518968566452,
                            0.2499528563304253,
                        ],
                    },
                    moments: [
                        Row {
                            state: [0.01606197437202761, 0.01606610301234305],
                            drive: [
                                0.0,
                                -0.0026773858084770613,
                                -0.002677454620163203,
                                -0.0024097484725885197,
                            ],
                        },
                        Row {
                            state: [-0.00034387700451624765, 0.016050260845190744],
                            drive: [
                                0.010704237850985005,
                                0.004014608609622604,
                                0.0021412647286458883,
                                0.0013383433302552167,
                            ],
                        },
                        Row {
                            state: [-0.0002578998246996775, 0.010698933945725533],
                            drive: [
                                0.00802793158325959,
                                0.0032116462228739063,
                                0.001784375796957569,
                                0.0011471471712092493,
                            ],
                        },
                        Row {
                            state: [-0.0002063155185785022, 0.008023614897916772],
                            drive: [
                                0.00642221013388308,
                                0.002676347256083441,
                                0.001529457512585131,
                                0.00100375085793752,
                            ],
                        },
                    ],
                },
            ],
            /// the modes of the chain with its contact stuck
            held: [
                HeldStep {
                    /// Ω, angle of the oscillator in a part, rad: |s| of its root s, times `span`
                    angle: 0.02534110429824207,
                    /// ζ = −Re s/|s|
                    zeta: 0.009007498923082695,
                    /// force of the chain on the contact, with its damping force, at y = −1
                    force: 1.6289215511039128,
                    /// rates of y and u per unit velocity and acceleration of a base to which the contact sticks
                    from_base: [[0.0, 0.0], [0.0, 0.0]],
                    /// the first row: both shears of y; row j > 0: weights of ∫ sʲy′ ds
                    moments: [
                        HeldRow {
                            state: [0.012670266116179696, 0.012672194380537112],
                            drive: [
                                [
                                    1.000053517733828,
                                    0.5000267592741207,
                                    0.3333493890525082,
                                    0.25001070388352953,
                                ],
                                [
                                    0.0,
                                    -0.002111894304135467,
                                    -0.0021119264421695385,
                                    -0.0019007521123673159,
                                ],
                            ],
                        },
                        HeldRow {
                            state: [-0.00021400680474885752, 0.012664662970084188],
                            drive: [
                                [
                                    0.4999197411886122,
                                    0.3333119301409967,
                                    0.24999108179159202,
                                    0.1999954134201391,
                                ],
                                [
                                    0.008445046523237085,
                                    0.003167139460191703,
                                    0.001689207548711334,
                                    0.0010557797682795487,
                                ],
                            ],
                        },
                        HeldRow {
                            state: [-0.00016050212646508935, 0.008442516255489124],
                            drive: [
                                [
                                    0.3332691267735148,
                                    0.24998216407530396,
                                    0.19999235583837247,
                                    0.1666626534148928,
                                ],
                                [
                                    0.006333667411495698,
                                    0.002533692259930685,
                                    0.0014076675180476007,
                                    0.0009049520736222859,
                                ],
                            ],
                        },
                        HeldRow {
                            state: [-0.00012840006978502496, 0.006331607067476198],
                            drive: [
                                [
                                    0.24994649482959633,
                                    0.19998471210933727,
                                    0.16665997803690571,
                                    0.14285357552624017,
                                ],
                                [
                                    0.005066869552087048,
                                    0.0021113985315706187,
                                    0.0012065686232783472,
                                    0.0007918316836812067,
                                ],
                            ],
                        },
                    ],
                    /// the first row: shear of u; row j > 0: weights of ∫ sʲu′ ds
                    turns: [
                        HeldRow {
                            state: [-0.02533260930196329, -0.00045641574998021535],
                            drive: [
                                [
                                    -0.012667946331879103,
                                    -0.004222899808642019,
                                    -0.002111520696900633,
                                    -0.001266939444567897,
                                ],
                                [
                                    0.9996647740296241,
                                    0.4998971703359387,
                                    0.33328459241099173,
                                    0.24997182506925447,
                                ],
                            ],
                        },
                        HeldRow {
                            state: [-0.012664662970084188, -0.00044216068087733475],
                            drive: [
                                [
                                    -0.008445046523237085,
                                    -0.003167139460191703,
                                    -0.001689207548711334,
                                    -0.0010557797682795487,
                                ],
                                [
                                    0.49976760369368534,
                                    0.33325487413044286,
                                    0.24996065072124027,
                                    0.19997639354988753,
                                ],
                            ],
                        },
                        HeldRow {
                            state: [-0.008442516255489124, -0.0003125940386239422],
                            drive: [
                                [
                                    -0.006333667411495698,
                                    -0.002533692259930685,
                                    -0.0014076675180476007,
                                    -0.0009049520736222859,
                                ],
                                [
                                    0.33315502576873834,
                                    0.24993651961469845,
                                    0.19996699671106674,
                                    0.16664635070523565,
                                ],
                            ],
                        },
                        HeldRow {
                            state: [-0.006331607067476198, -0.00024246395746837422],
                            drive: [
                                [
                                    -0.005066869552087048,
                                    -0.0021113985315706187,
                                    -0.0012065686232783472,
                                    -0.0007918316836812067,
                                ],
                                [
                                    0.24985521518552867,
                                    0.19994667526933863,
                                    0.1666382417057561,
                                    0.14283931068016414,
                                ],
                            ],
                        },
                    ],
                },
                HeldStep {
                    angle: 0.045517032095051806,
                    zeta: 0.006086800242141135,
                    force: 5.230595946387919,
                    from_base: [[0.0, 0.0], [0.0, 0.0]],
                    moments: [
                        HeldRow {
                            state: [0.022760343839478486, 0.02276454840039266],
                            drive: [
                                [
                                    1.0001726857938127,
                                    0.5000863444917797,
                                    0.3333851405811777,
                                    0.2500345383980365,
                                ],
                                [
                                    0.0,
                                    -0.003793872004925973,
                                    -0.0037939420830151414,
                                    -0.0034145843078808445,
                                ],
                            ],
                        },
                        HeldRow {
                            state: [-0.0006903135568658458, 0.022738327769514784],
                            drive: [
                                [
                                    0.4997410930366386,
                                    0.3332642864066806,
                                    0.2499712292203266,
                                    0.1999852031905003,
                                ],
                                [
                                    0.01516604939057286,
                                    0.005688133681930841,
                                    0.003033894060075121,
                                    0.0018962646518767064,
                                ],
                            ],
                        },
                        HeldRow {
                            state: [-0.0005177160760834151, 0.015156613957312833],
                            drive: [
                                [
                                    0.3331262107406984,
                                    0.24994246129709444,
                                    0.19997533942781398,
                                    0.16665371948915242,
                                ],
                                [
                                    0.011374117605082085,
                                    0.004550441518295788,
                                    0.002528227358295664,
                                    0.0016253633673567205,
                                ],
                            ],
                        },
                        HeldRow {
                            state: [-0.0004141622249014208, 0.011366359923212294],
                            drive: [
                                [
                                    0.24982739966277634,
                                    0.1999506813757001,
                                    0.16664508873232842,
                                    0.14284563427703803,
                                ],
                                [
                                    0.009099060414056406,
                                    0.003791994540927413,
                                    0.0021670404255234145,
                                    0.0014221885750273855,
                                ],
                            ],
                        },
                    ],
                    turns: [
                        HeldRow {
                            state: [-0.04548871273845855, -0.0005539526754858924],
                            drive: [
                                [
                                    -0.022750384968943767,
                                    -0.007584335578370909,
                                    -0.003792403792880135,
                                    -0.0022755291984150406,
                                ],
                                [
                                    0.9993778294565842,
                                    0.4998213618461512,
                                    0.33325264101283125,
                                    0.24995503562011087,
                                ],
                            ],
                        },
                        HeldRow {
                            state: [-0.022738327769514784, -0.0009671208748125799],
                            drive: [
                                [
                                    -0.01516604939057286,
                                    -0.005688133681930841,
                                    -0.003033894060075121,
                                    -0.0018962646518767064,
                                ],
                                [
                                    0.4995564676104329,
                                    0.3331950413397356,
                                    0.2499342958061276,
                                    0.1999621188222159,
                                ],
                            ],
                        },
                        HeldRow {
                            state: [-0.015156613957312833, -0.0007022266390942381],
                            drive: [
                                [
                                    -0.011374117605082085,
                                    -0.004550441518295788,
                                    -0.002528227358295664,
                                    -0.0016253633673567205,
                                ],
                                [
                                    0.3329877467771129,
                                    0.24988706604002361,
                                    0.19994456179802064,
                                    0.16663393296487644,
                                ],
                            ],
                        },
                        HeldRow {
                            state: [-0.011366359923212294, -0.0005525317495671646],
                            drive: [
                                [
                                    -0.009099060414056406,
                                    -0.003791994540927413,
                                    -0.0021670404255234145,
                                    -0.0014221885750273855,
                                ],
                                [
                                    0.24971663133651328,
                                    0.19990451914912025,
                                    0.1666187080479548,
                                    0.14282832112151234,
                                ],
                            ],
                        },
                    ],
                },
            ],
            /// rate of u of each mode divided by the input, for each input
            loads: [[0.016542466377463476], [0.009500588362789723]],
            /// the same for each mode of the chain with its contact stuck
            held_loads: [
                [
                    HeldLoad {
                        /// rates of y and u per unit of the input
                        drive: [-0.00014161690435966214, -0.010545199913500574],
                        /// displacement where the input acts per unit of y and of u
                        reach: [-1.2409662332419196, 0.02024440952233361],
                    },
                ],
                [
                    HeldLoad {
                        drive: [4.410258981510079e-5, 0.0018283334866147148],
                        reach: [0.38642918928857967, 0.011320156470872964],
                    },
                ],
            ],
            /// coupling of each input to the contact
            channels: [
                Channel {
                    /// wᵀΓ⁻¹p, acceleration of the contact per unit of the input
                    acceleration: 0.0,
                    /// displacement where the input acts per unit of displacement of the stuck contact
                    lift: 0.4678426266516825,
                },
            ],
        };
    }
};
