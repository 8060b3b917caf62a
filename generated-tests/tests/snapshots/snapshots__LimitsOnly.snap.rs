/// The two limits alone.
///
/// Emitted by frictiongen 0.1.0 from scene c884e1ff1edbc4b7.
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
pub struct LimitsOnly;
/// [`LimitsOnly`] at one frequency ratio: limits, regime.
#[allow(deprecated, non_camel_case_types)]
pub struct LimitsOnlyAt(::frictiongen::kernel::response::At<LimitsOnly>);
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
    impl LimitsOnly {
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
            damped: false,
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
                kind: Kind::Undamped,
                in_contact: true,
                resonance: 0.618034,
                zeta: 0.0,
                q: 1.0,
                q_defect: 0.0,
                load: 0.5257311,
                contact: 0.8506508,
                residue: 0.4472136,
                inverse_mass: 0.7236068,
                static_residue: 1.1708204,
            },
            Mode {
                kind: Kind::Undamped,
                in_contact: true,
                resonance: 1.618034,
                zeta: 0.0,
                q: 1.0,
                q_defect: 0.0,
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
            unbounded: &[0.618034, 1.618034],
            invisible: &[],
        };
        /// The scene at the frequency ratio r = ω√(m₁/k₁).
        ///
        /// # Errors
        /// `OutOfDomain` for NaN and negative r; 0 and ∞ answer with the limits.
        #[inline]
        pub fn at(r: f32) -> Result<LimitsOnlyAt, OutOfDomain> {
            At::new(Self, r).map(From::from)
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
        /// `OutOfDomain` for slices of unequal lengths, before anything is written; and at the first NaN or negative r, after what precedes it is.
        pub fn limits_into(
            rs: &[f32],
            continuous: &mut [f32],
            sliding: &mut [f32],
        ) -> Result<(), OutOfDomain> {
            At::limits_into(Self, rs, continuous, sliding)
        }
        /// The functions of an undamped mode.
        /// `x` is √λ/r = 1/R, `detuning` x² − 1, `size` |x² − 1| + 2ζx; E, `scale`, is the least of the modes in contact.
        /// `u` is uR².  It, `g` and `reversal` are multiplied by `size`, which removes the pole at x = 1; then by E over `size`.
        /// Undamped: u = x·tan(πx/2), g = 0.  `sine` and `cosine` are of πx/2; `…_off_pole` takes the place of an exact 0, so that no
        /// quotient is 0/0.
        #[inline(always)]
        fn undamped_mode(mode: &Mode<f32>, inverse_r: f32) -> ModeResponse<f32> {
            let x = mode.resonance * inverse_r;
            let (sine, plain_cosine) = Scalar::sin_cos_pi(x * 0.5);
            let detuning = Scalar::detuning_off_pole((x - 1.0) * (x + 1.0));
            let cosine = Scalar::cosine_off_pole(plain_cosine);
            let size = Scalar::abs(detuning);
            let u = sine * size / (x * cosine);
            ModeResponse {
                x,
                denominator: Complex { re: detuning, im: 0.0 },
                size,
                u,
                g: 0.0,
                reversal: 0.0,
            }
        }
        /// The response and damping functions V, U, G, H of the contact (3.11, 5.20, 5.34, 5.37, 7.11, 7.12), each
        /// times r²E with the scale E that keeps them finite on a resonance, and each mode's part in them.
        /// Of each mode `response` is 1/(x² − 1 + 2iζx) and R = 1/x.  Sums over modes: V of residue·`response`; H, U, G and r²H_c of
        /// (φᵀw)² times `response`, uR², gR² and g + 2ζRu (`reversal`).
        /// `at_scale` has `response`, u and g of a mode times E: the last two times E over `size`.
        ///
        /// Operations: 40: 18 ×, 7 +, 5 compare, 4 sign, 4 ÷, 2 sin_cos_pi.
        #[inline(always)]
        fn functions(inverse_r: f32) -> (ContactAt<f32>, [ModeAt<f32>; 2]) {
            let [constants_1, constants_2] = &Self::MODES;
            let mode_1 = Self::undamped_mode(constants_1, inverse_r);
            let mode_2 = Self::undamped_mode(constants_2, inverse_r);
            let scale = Scalar::min(mode_1.size, mode_2.size);
            let modes = [
                Self::CHAIN.at_scale(&mode_1, scale),
                Self::CHAIN.at_scale(&mode_2, scale),
            ];
            let [at_1, at_2] = &modes;
            let v_re = at_1.response.re * constants_1.residue
                + at_2.response.re * constants_2.residue;
            let h_re = at_1.response.re * constants_1.inverse_mass
                + at_2.response.re * constants_2.inverse_mass;
            let u = constants_1.inverse_mass * at_1.u
                + constants_2.inverse_mass * at_2.u;
            let contact = ContactAt {
                scale,
                v: Complex { re: v_re, im: 0.0 },
                u,
                g: 0.0,
                reversal: 0.0,
                h: Complex { re: h_re, im: 0.0 },
            };
            (contact, modes)
        }
    }
    ::frictiongen::emitted_system!(LimitsOnly, LimitsOnlyAt, f32, ["lower", "upper"]);
    ::frictiongen::kernel::wraps!(LimitsOnlyAt, At of LimitsOnly, Copy);
    impl Scene for LimitsOnly {
        type Scalar = f32;
        type Decay = Undamped;
        type Modes = [ModeAt<f32>; 2];
        type Waves = [Wave<f32, Undamped>; 2];
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
            Self::functions(inverse_r)
        }
        /// Those of the contact without G, which only a motion needs.
        #[inline]
        fn contact_without_g(&self, inverse_r: f32) -> ContactAt<f32> {
            Self::functions(inverse_r).0
        }
        /// r²E(H_c + μm*/r²) = `reversal` + μm*E: in β_lim it ensures that the contact breaks away at once at every reversal (5.63, 7.47).
        #[inline]
        fn break_away(&self, contact: &ContactAt<f32>) -> f32 {
            contact.scale
        }
        /// β_lim = |V|/√(U² + max(S, H_c + μm*/r²)²) (5.65, 5.80, 5.96, 7.49), with S the largest F(τ)/sin τ over
        /// 0 < τ < π, F a sum over modes: with more friction the contact would reverse within the half period.
        /// `constraint` is r²E times that maximum.
        #[inline]
        fn continuous_limit(&self, contact: &ContactAt<f32>, constraint: f32) -> f32 {
            let modulus_v = Scalar::abs(contact.v.re);
            modulus_v / Scalar::sqrt(contact.u * contact.u + constraint * constraint)
        }
        /// β*_lim = |V|/(μ|H|) (6.11, 6.27, 6.33).
        #[inline]
        fn sliding_limit(&self, contact: &ContactAt<f32>) -> f32 {
            let modulus_v = Scalar::abs(contact.v.re);
            let modulus_h = Scalar::abs(contact.h.re);
            modulus_v / modulus_h
        }
    }
    ::frictiongen::kernel::not_provided!(
        LimitsOnlyAt : motion, stuck, orbit; LimitsOnly : simulation, stepper
    );
};
