/// The motion in time and the steady state in any regime.
///
/// Emitted by frictiongen 0.1.0 from scene eedbe5be51e36513.
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
pub struct Stopping;
/// [`Stopping`] at one frequency ratio: limits, regime, steady states.
#[allow(deprecated, non_camel_case_types)]
pub struct StoppingAt(::frictiongen::kernel::response::At<Stopping>);
/// The exact motion of [`Stopping`] in time, from event to event; `next` gives its segments.
#[allow(deprecated, non_camel_case_types)]
pub struct StoppingSimulation(
    ::frictiongen::kernel::simulation::FixedSimulation<::core::primitive::f64, 3>,
);
/// The steady state of [`Stopping`] at one frequency and one friction ratio, in any regime.
///
/// Its sizes: 3 modes and held modes, room for 280 numbers, 4 Floquet multipliers.
#[allow(deprecated, non_camel_case_types)]
pub struct StoppingOrbit(
    ::frictiongen::kernel::orbit::FixedOrbit<::core::primitive::f64, 3, 280, 4>,
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
    impl Stopping {
        /// ω_i, the natural frequencies, ascending: rad/s if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES: [f64; 2] = [
            0.6490960526996967,
            1.7032018484583367,
        ];
        /// √λ_i = ω_i√(m₁/k₁): the frequency ratios r of the undamped resonances.
        pub const RESONANCES: [f64; 2] = [0.6490960526996967, 1.7032018484583367];
        /// φ, [mode][mass], with φᵀΓφ = 1 and Γ = diag(m_i/m₁); the first component of each that is not 0 is positive.
        pub const MODE_SHAPES: [[f64; 2]; 2] = [
            [0.5683291693328758, 0.8673087078783189],
            [0.8228012854179333, -0.5990715452678017],
        ];
        /// The chain: `damped`, whether a mode is; `inverse_mass` m* = m₁/(effective mass of the contact), `stiction` μ, static over kinetic friction.
        /// `on_moving_base`: none, as the contact does not rub on a moving base.
        const CHAIN: Chain<f64> = Chain {
            damped: true,
            on_moving_base: None,
            inverse_mass: 1.1111111111111112,
            stiction: 1.2,
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
                resonance: 0.6490960526996967,
                zeta: 0.01,
                q: 0.9999499987499375,
                q_defect: 5.000125006250391e-5,
                load: 0.5683291693328758,
                contact: 0.8673087078783189,
                residue: 0.4929168375036549,
                inverse_mass: 0.7522243947615592,
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
                inverse_mass: 0.3588867163495518,
                static_residue: -0.16991879278905825,
            },
        ];
        /// `ends`: β*_lim for r → 0, both limits for r → ∞; `rubbing`: the mass that rubs on a support at rest; `absorbs`:
        /// V and H may share zeros, where the holding force says what a limit is; `unbounded`: undamped resonances that
        /// the load drives, `invisible`: those that the contact does not touch.
        const NUMBERS: Numbers<'static, f64> = Numbers {
            modes: &Self::MODES,
            chain: Self::CHAIN,
            ends: Ends {
                sliding_at_rest: 0.43650793650793657,
                continuous_at_infinity: 0.0,
                sliding_at_infinity: 0.0,
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
        pub fn at(r: f64) -> Result<StoppingAt, OutOfDomain> {
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
        /// φ of all modes, [mass][mode].
        const ALL_SHAPES: [[f64; 2]; 2] = transposed(&Self::MODE_SHAPES);
        /// The motion in time: all modes, those that the contact drives first, and the modes of the chain with its contact
        /// held.  Of a held mode `frequency` is √λ, `force` −(contact force)/y, and `inverse` the symmetric matrix
        /// [m₁₁, m₁₂, m₂₂] that takes the products of a motion with its two states to y and u.  `participations`: how far
        /// each free mode takes part in y and u of each held one; `shapes`: φ, mass after mass; `weights`: φᵀΓ, mode after
        /// mode.
        const DYNAMICS: Dynamics<'static, f64> = Dynamics {
            chain: Self::CHAIN,
            modes: &Self::MODES,
            held: &[
                HeldMode {
                    kind: Kind::Light,
                    frequency: 1.449137674618944,
                    zeta: 0.010995103927964253,
                    q: 0.9999395520178274,
                    force: 1.337251750218044,
                    inverse: [
                        0.015221582697280134,
                        0.46646859015104253,
                        -0.025479323952963484,
                    ],
                },
            ],
            participations: &[
                [-0.6907246979374844, 0.011264683757455306],
                [-1.0, 0.016308500030608204],
            ],
            shapes: Self::ALL_SHAPES.as_flattened(),
            weights: &[
                0.5683291693328758,
                0.7805778370904871,
                0.8228012854179333,
                -0.5391643907410216,
            ],
            rubbing: Some(1),
        };
        /// The exact motion in time from rest, the excitation at its maximum.
        ///
        /// # Errors
        /// `OutOfDomain` unless r is positive and finite, and β finite and not negative.
        pub fn simulation(r: f64, beta: f64) -> Result<StoppingSimulation, OutOfDomain> {
            let parts = [Part::empty(); 3];
            Simulation::new(Self::DYNAMICS, r, beta, None, parts).map(From::from)
        }
        /// The same from a state at a maximum of the excitation: x̄ and dx̄/dτ of every mass.
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
    ::frictiongen::emitted_system!(Stopping, StoppingAt, f64, ["lower", "upper"]);
    ::frictiongen::kernel::wraps!(StoppingAt, At of Stopping, Copy);
    impl Scene for Stopping {
        type Scalar = f64;
        type Decay = Damped<f64>;
        type Modes = [ModeAt<f64>; 2];
        type Waves = [Wave<f64, Damped<f64>>; 2];
        #[inline]
        fn numbers(&self) -> Numbers<'static, f64> {
            Self::NUMBERS
        }
        /// φ of a mass, by modes: of none here, as no motion of a mass is provided.
        #[inline]
        fn shape(&self, _: usize) -> Option<&[f64]> {
            None
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
            contact.reversal + 1.3333333333333333 * contact.scale
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
            modulus_v / (1.2 * modulus_h)
        }
    }
    ::frictiongen::kernel::not_provided!(StoppingAt : motion, stuck; Stopping : stepper);
    ::frictiongen::kernel::wraps!(StoppingSimulation, FixedSimulation of f64, 3);
    impl StoppingSimulation {
        /// Displacement and velocity of mass `lower` now.
        #[must_use]
        pub fn lower(&self) -> Moment<f64> {
            self.mass(0)
        }
        /// Displacement and velocity of mass `upper` now.
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
    ::frictiongen::kernel::wraps!(StoppingOrbit, FixedOrbit of f64, 3, 280, 4);
    impl StoppingOrbit {
        /// The motion of mass `lower`.
        #[must_use]
        pub fn lower(&self) -> FixedOrbitMotion<'_, f64, 3, 280, 4> {
            self.mass(0)
        }
        /// The motion of mass `upper`.
        #[must_use]
        pub fn upper(&self) -> FixedOrbitMotion<'_, f64, 3, 280, 4> {
            self.mass(1)
        }
    }
};
