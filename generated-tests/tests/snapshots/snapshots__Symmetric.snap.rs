/// A symmetric chain whose second mode the load at its middle does not drive, and the contact
/// there does not touch: the mode is gone from the emitted code.
///
/// Emitted by frictiongen 0.1.0 from scene c3a9898ece97a2c6.
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
pub struct Symmetric;
/// [`Symmetric`] at one frequency ratio: limits, regime, continuous motion, stuck response.
#[allow(deprecated, non_camel_case_types)]
pub struct SymmetricAt(::frictiongen::kernel::response::At<Symmetric>);
/// The exact continuous motion of [`Symmetric`] at one frequency and one friction ratio.
#[allow(deprecated, non_camel_case_types)]
pub struct SymmetricMotion(::frictiongen::kernel::response::Continuous<Symmetric>);
/// The response of [`Symmetric`] at one frequency ratio while its contact is stuck.
#[allow(deprecated, non_camel_case_types)]
pub struct SymmetricStuck(::frictiongen::kernel::response::Stuck<Symmetric>);
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
    impl Symmetric {
        /// ω_i, the natural frequencies, ascending: rad/s if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES: [f64; 3] = [
            0.7653668647301796,
            1.4142135623730951,
            1.8477590650225735,
        ];
        /// √λ_i = ω_i√(m₁/k₁): the frequency ratios r of the undamped resonances.
        pub const RESONANCES: [f64; 3] = [
            0.7653668647301796,
            1.4142135623730951,
            1.8477590650225735,
        ];
        /// φ, [mode][mass], with φᵀΓφ = 1 and Γ = diag(m_i/m₁); the first component of each that is not 0 is positive.
        pub const MODE_SHAPES: [[f64; 3]; 3] = [
            [0.5, 0.7071067811865476, 0.5],
            [0.7071067811865476, 0.0, -0.7071067811865476],
            [0.5, -0.7071067811865476, 0.5],
        ];
        /// The chain: `damped`, whether a mode is; `inverse_mass` m* = m₁/(effective mass of the contact), `stiction` μ, static over kinetic friction.
        /// `on_moving_base`: none, as the contact does not rub on a moving base.
        const CHAIN: Chain<f64> = Chain {
            damped: false,
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
        const MODES: [Mode<f64>; 2] = [
            Mode {
                kind: Kind::Undamped,
                in_contact: true,
                resonance: 0.7653668647301796,
                zeta: 0.0,
                q: 1.0,
                q_defect: 0.0,
                load: 0.7071067811865476,
                contact: 0.7071067811865476,
                residue: 0.5,
                inverse_mass: 0.5,
                static_residue: 0.8535533905932737,
            },
            Mode {
                kind: Kind::Undamped,
                in_contact: true,
                resonance: 1.8477590650225735,
                zeta: 0.0,
                q: 1.0,
                q_defect: 0.0,
                load: -0.7071067811865476,
                contact: -0.7071067811865476,
                residue: 0.5,
                inverse_mass: 0.5,
                static_residue: 0.14644660940672624,
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
            rubbing: Some(1),
            absorbs: true,
            unbounded: &[0.7653668647301796, 1.8477590650225735],
            invisible: &[],
        };
        /// The scene at the frequency ratio r = ω√(m₁/k₁).
        ///
        /// # Errors
        /// `OutOfDomain` for NaN and negative r; 0 and ∞ answer with the limits.
        #[inline]
        pub fn at(r: f64) -> Result<SymmetricAt, OutOfDomain> {
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
        const SHAPES: [[f64; 2]; 3] = transposed(
            &[Self::MODE_SHAPES[0], Self::MODE_SHAPES[2]],
        );
        /// The functions of an undamped mode.
        /// `x` is √λ/r = 1/R, `detuning` x² − 1, `size` |x² − 1| + 2ζx; E, `scale`, is the least of the modes in contact.
        /// `u` is uR².  It, `g` and `reversal` are multiplied by `size`, which removes the pole at x = 1; then by E over `size`.
        /// Undamped: u = x·tan(πx/2), g = 0.  `sine` and `cosine` are of πx/2; `…_off_pole` takes the place of an exact 0, so that no
        /// quotient is 0/0.
        #[inline(always)]
        fn undamped_mode(mode: &Mode<f64>, inverse_r: f64) -> ModeResponse<f64> {
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
        /// The load acts on the mass that rubs: a residue is (φᵀw)², and V = H.
        ///
        /// Operations: 37: 16 ×, 6 +, 5 compare, 4 sign, 4 ÷, 2 sin_cos_pi.
        #[inline(always)]
        fn functions(inverse_r: f64) -> (ContactAt<f64>, [ModeAt<f64>; 2]) {
            let [constants_1, constants_2] = &Self::MODES;
            let mode_1 = Self::undamped_mode(constants_1, inverse_r);
            let mode_2 = Self::undamped_mode(constants_2, inverse_r);
            let scale = Scalar::min(mode_1.size, mode_2.size);
            let modes = [
                Self::CHAIN.at_scale(&mode_1, scale),
                Self::CHAIN.at_scale(&mode_2, scale),
            ];
            let [at_1, at_2] = &modes;
            let v_re = at_1.response.re * constants_1.inverse_mass
                + at_2.response.re * constants_2.inverse_mass;
            let u = constants_1.inverse_mass * at_1.u
                + constants_2.inverse_mass * at_2.u;
            let contact = ContactAt {
                scale,
                v: Complex { re: v_re, im: 0.0 },
                u,
                g: 0.0,
                reversal: 0.0,
                h: Complex { re: v_re, im: 0.0 },
            };
            (contact, modes)
        }
    }
    ::frictiongen::emitted_system!(
        Symmetric, SymmetricAt, f64, ["left", "middle", "right"]
    );
    ::frictiongen::kernel::wraps!(SymmetricAt, At of Symmetric, Copy);
    impl Scene for Symmetric {
        type Scalar = f64;
        type Decay = Undamped;
        type Modes = [ModeAt<f64>; 2];
        type Waves = [Wave<f64, Undamped>; 2];
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
            Self::functions(inverse_r)
        }
        /// Those of the contact without G, which only a motion needs.
        #[inline]
        fn contact_without_g(&self, inverse_r: f64) -> ContactAt<f64> {
            Self::functions(inverse_r).0
        }
        /// r²E(H_c + μm*/r²) = `reversal` + μm*E: in β_lim it ensures that the contact breaks away at once at every reversal (5.63, 7.47).
        #[inline]
        fn break_away(&self, contact: &ContactAt<f64>) -> f64 {
            contact.scale
        }
        /// β_lim = |V|/√(U² + max(S, H_c + μm*/r²)²) (5.65, 5.80, 5.96, 7.49), with S the largest F(τ)/sin τ over
        /// 0 < τ < π, F a sum over modes: with more friction the contact would reverse within the half period.
        /// `constraint` is r²E times that maximum.
        #[inline]
        fn continuous_limit(&self, contact: &ContactAt<f64>, constraint: f64) -> f64 {
            let modulus_v = Scalar::abs(contact.v.re);
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
        SymmetricAt : orbit; Symmetric : simulation, stepper
    );
    impl ProvidesMotion for Symmetric {
        type Motion = SymmetricMotion;
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
            let mode_1_rise = mode_1_friction_force * contact.scale;
            let mode_1_forced = mode_1_friction_force * mode_1.u;
            let mode_2_friction_force = friction_weight * constants_2.inverse_mass;
            let mode_2_rise = mode_2_friction_force * contact.scale;
            let mode_2_forced = mode_2_friction_force * mode_2.u;
            let fundamental = Fundamental {
                cosine: friction.amplitude,
                sine: 0.0,
                response: Complex {
                    re: contact.v.re * friction.unscale,
                    im: 0.0,
                },
            };
            let waves = [
                motion_wave(
                    mode_1.x,
                    Undamped,
                    ModalCoefficients {
                        rise: mode_1_rise,
                        fall: 0.0,
                        forced: mode_1_forced,
                        residue: constants_1.inverse_mass * inverse_r * inverse_r,
                    },
                ),
                motion_wave(
                    mode_2.x,
                    Undamped,
                    ModalCoefficients {
                        rise: mode_2_rise,
                        fall: 0.0,
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
        #[allow(unused_variables)]
        fn mass_motion(
            at: &At<Self>,
            friction: &Friction<f64>,
            mass: usize,
        ) -> Option<MotionOf<Self>> {
            let (inverse_r, contact) = (at.inverse_ratio(), at.contact_sums());
            let [constants_1, constants_2] = &Self::MODES;
            let [mode_1, mode_2] = at.modes();
            if mass != 0 && mass != 2 {
                return None;
            }
            let mode_2_v_term_re = mode_2.response.re * constants_2.inverse_mass;
            let mode_2_u_term = constants_2.inverse_mass * mode_2.u;
            let mode_1_u_others = if mode_1.x < 0.5 { contact.u } else { mode_2_u_term };
            let mode_1_v_term_re = mode_1.response.re * constants_1.inverse_mass;
            let mode_1_u_term = constants_1.inverse_mass * mode_1.u;
            let mode_2_u_others = if mode_2.x < 0.5 { contact.u } else { mode_1_u_term };
            let mode_1_driven_re = mode_1.response.re * 0.3535533905932738;
            let mode_1_u_in_sum = if mode_1.x < 0.5 { 0.0 } else { mode_1.u };
            let mode_1_rubbed_back = -(0.3535533905932738 * mode_1_u_in_sum);
            let mode_2_driven_re = mode_2.response.re * -0.3535533905932738;
            let mode_2_u_in_sum = if mode_2.x < 0.5 { 0.0 } else { mode_2.u };
            let mode_2_rubbed_back = -(-0.3535533905932738 * mode_2_u_in_sum);
            let response_re = mode_1_driven_re + mode_2_driven_re;
            let mismatch_re = mode_1_driven_re * mode_1_u_others
                + mode_2_v_term_re * mode_1_rubbed_back
                + (mode_2_driven_re * mode_2_u_others
                    + mode_1_v_term_re * mode_2_rubbed_back);
            let inverse_re = 1.0 / contact.v.re;
            let friction_weight = friction.beta * friction.unscale;
            let mode_1_friction_force = friction_weight * 0.3535533905932738;
            let mode_1_rise = mode_1_friction_force * contact.scale;
            let mode_1_forced = mode_1_friction_force * mode_1_u_in_sum;
            let mode_2_friction_force = friction_weight * -0.3535533905932738;
            let mode_2_rise = mode_2_friction_force * contact.scale;
            let mode_2_forced = mode_2_friction_force * mode_2_u_in_sum;
            let (fundamental, waves) = (
                Fundamental {
                    cosine: friction.root * (response_re * inverse_re)
                        * friction.unscale,
                    sine: friction.beta * (mismatch_re * inverse_re) * friction.unscale,
                    response: Complex {
                        re: response_re * friction.unscale,
                        im: 0.0,
                    },
                },
                [
                    mass_wave(
                        mode_1.x,
                        Undamped,
                        ModalCoefficients {
                            rise: mode_1_rise,
                            fall: 0.0,
                            forced: mode_1_forced,
                            residue: 0.3535533905932738 * inverse_r * inverse_r,
                        },
                    ),
                    mass_wave(
                        mode_2.x,
                        Undamped,
                        ModalCoefficients {
                            rise: mode_2_rise,
                            fall: 0.0,
                            forced: mode_2_forced,
                            residue: -0.3535533905932738 * inverse_r * inverse_r,
                        },
                    ),
                ],
            );
            Some(Motion::of_mass(*friction, fundamental, waves))
        }
    }
    ::frictiongen::kernel::wraps!(SymmetricMotion, Continuous of Symmetric, Copy);
    impl SymmetricMotion {
        /// The motion of mass `left` (5.50 and its exact form, 7.29).
        #[must_use]
        pub fn left(&self) -> MotionOf<Symmetric> {
            self.mass(0)
        }
        /// The motion of mass `middle` (5.50 and its exact form, 7.29).
        ///
        /// It rubs on a support at rest: its motion is the contact's.
        #[must_use]
        pub fn middle(&self) -> MotionOf<Symmetric> {
            self.contact()
        }
        /// The motion of mass `right` (5.50 and its exact form, 7.29).
        #[must_use]
        pub fn right(&self) -> MotionOf<Symmetric> {
            self.mass(2)
        }
    }
    impl ProvidesStuck for Symmetric {
        type Stuck = SymmetricStuck;
        /// x̄* = (V_kH − H_kV)/H: `numerator` has each mode's products with the others, as those with itself would cancel.
        /// `driven` is a mode's part of V_k, `held_back` of −H_k; `v_term` and `h_term` of V and H; `inverse` is 1/H, `unscale` 1/(r²E).
        #[allow(unused_variables)]
        #[inline]
        fn stuck_mass(at: &At<Self>, mass: usize) -> Option<Complex<f64>> {
            let (inverse_r, contact) = (at.inverse_ratio(), at.contact_sums());
            let [constants_1, constants_2] = &Self::MODES;
            let [mode_1, mode_2] = at.modes();
            if mass != 0 && mass != 2 {
                return None;
            }
            let mode_2_v_term_re = mode_2.response.re * constants_2.inverse_mass;
            let mode_1_v_term_re = mode_1.response.re * constants_1.inverse_mass;
            let mode_1_driven_re = mode_1.response.re * 0.3535533905932738;
            let mode_1_held_back_re = mode_1.response.re * -0.3535533905932738;
            let mode_2_driven_re = mode_2.response.re * -0.3535533905932738;
            let mode_2_held_back_re = mode_2.response.re * 0.3535533905932738;
            let numerator_re = mode_1_driven_re * mode_2_v_term_re
                + mode_1_held_back_re * mode_2_v_term_re
                + (mode_2_driven_re * mode_1_v_term_re
                    + mode_2_held_back_re * mode_1_v_term_re);
            let inverse_re = 1.0 / contact.h.re;
            let unscale = inverse_r * inverse_r / contact.scale;
            Some(Complex {
                re: numerator_re * inverse_re * unscale,
                im: 0.0,
            })
        }
    }
    ::frictiongen::kernel::wraps!(SymmetricStuck, Stuck of Symmetric, Copy);
    impl SymmetricStuck {
        /// x̄* = V_k − H_kV/H, the complex amplitude of mass `left` over P/k₁ (6.11, 6.27, 6.33).
        #[must_use]
        pub fn left(&self) -> Complex<f64> {
            self.mass(0)
        }
        /// x̄* = V_k − H_kV/H, the complex amplitude of mass `middle` over P/k₁ (6.11, 6.27, 6.33).
        ///
        /// It is 0: the contact holds the mass to a support at rest.
        #[must_use]
        pub fn middle(&self) -> Complex<f64> {
            self.mass(1)
        }
        /// x̄* = V_k − H_kV/H, the complex amplitude of mass `right` over P/k₁ (6.11, 6.27, 6.33).
        #[must_use]
        pub fn right(&self) -> Complex<f64> {
            self.mass(2)
        }
    }
};
