/// One mass and its motion, to a thousandth.
///
/// Emitted by frictiongen 0.1.0 from scene b7c8152cebe163ce.
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
pub struct DeclaredMotion;
/// [`DeclaredMotion`] at one frequency ratio: limits, regime, continuous motion.
#[allow(deprecated, non_camel_case_types)]
pub struct DeclaredMotionAt(::frictiongen::kernel::table::Compiled<DeclaredMotion>);
/// The continuous motion of [`DeclaredMotion`] at one frequency and one friction ratio: of the contact to the declared accuracy, of the masses exact.
#[allow(deprecated, non_camel_case_types)]
pub struct DeclaredMotionMotion(::frictiongen::kernel::table::Moving<DeclaredMotion>);
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
    impl DeclaredMotion {
        /// ω_i, the natural frequencies, ascending: rad/s if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES: [f64; 1] = [1.0];
        /// √λ_i = ω_i√(m₁/k₁): the frequency ratios r of the undamped resonances.
        pub const RESONANCES: [f64; 1] = [1.0];
        /// φ, [mode][mass], with φᵀΓφ = 1 and Γ = diag(m_i/m₁); the first component of each that is not 0 is positive.
        pub const MODE_SHAPES: [[f64; 1]; 1] = [[1.0]];
        /// The chain: `damped`, whether a mode is; `inverse_mass` m* = m₁/(effective mass of the contact), `stiction` μ, static over kinetic friction.
        /// `on_moving_base`: the contact rubs on the moving base; its relative motion over Y for r → 0.
        const CHAIN: Chain<f64> = Chain {
            damped: false,
            on_moving_base: Some(0.0),
            inverse_mass: 1.0,
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
        const MODES: [Mode<f64>; 1] = [
            Mode {
                kind: Kind::Undamped,
                in_contact: true,
                resonance: 1.0,
                zeta: 0.0,
                q: 1.0,
                q_defect: 0.0,
                load: 1.0,
                contact: 1.0,
                residue: 1.0,
                inverse_mass: 1.0,
                static_residue: 1.0,
            },
        ];
        /// `ends`: β*_lim for r → 0, both limits for r → ∞; `rubbing`: the mass that rubs on a support at rest; `absorbs`:
        /// V and H may share zeros, where the holding force says what a limit is; `unbounded`: undamped resonances that
        /// the load drives, `invisible`: those that the contact does not touch.
        const NUMBERS: Numbers<'static, f64> = Numbers {
            modes: &Self::MODES,
            chain: Self::CHAIN,
            ends: Ends {
                sliding_at_rest: 0.0,
                continuous_at_infinity: f64::INFINITY,
                sliding_at_infinity: f64::INFINITY,
            },
            rubbing: Some(0),
            absorbs: false,
            unbounded: &[1.0],
            invisible: &[],
        };
        /// The scene at the frequency ratio r = ω√(m₁/k₁), to the declared accuracy.
        ///
        /// # Errors
        /// `OutOfDomain` for NaN and negative r; beyond the declared range the exact formulas answer.
        #[inline]
        pub fn at(r: f64) -> Result<DeclaredMotionAt, OutOfDomain> {
            Compiled::new(Self, r).map(From::from)
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
        /// `OutOfDomain` for slices of unequal lengths, before anything is written; and at the first r out of the domain, as of `at`, after what precedes it is.
        pub fn limits_into(
            rs: &[f64],
            continuous: &mut [f64],
            sliding: &mut [f64],
        ) -> Result<(), OutOfDomain> {
            Compiled::limits_into(Self, rs, continuous, sliding)
        }
        /// φ of `MODES`, [mass][mode].
        const SHAPES: [[f64; 1]; 1] = transposed(&Self::MODE_SHAPES);
        /// The response and damping functions V, U, G, H of the contact (3.11, 5.20, 5.34, 5.37, 7.11, 7.12), each
        /// times r²E with the scale E that keeps them finite on a resonance, and each mode's part in them.
        /// Of each mode `response` is 1/(x² − 1 + 2iζx) and R = 1/x.  Sums over modes: H, U, G and r²H_c of (φᵀw)² times `response`,
        /// uR², gR² and g + 2ζRu (`reversal`).  V is the motion relative to the base, r² times the sum of `static_residue`·(1 − 2iζx)·
        /// `response`, and of `on_moving_base`·E, the static part.
        /// `inverse_r` is x = 1/r, as √λ is 1; `detuning` is x² − 1, `size` |x² − 1| + 2ζx, which is E, `scale`.
        /// `u` is uR².  It, `g` and `reversal` are multiplied by `size`, which removes the pole at x = 1; then by E over `size`.
        /// Undamped: u = x·tan(πx/2), g = 0.  `sine` and `cosine` are of πx/2; `…_off_pole` takes the place of an exact 0, so that no
        /// quotient is 0/0.
        ///
        /// Operations: 15: 6 ×, 2 +, 2 compare, 2 sign, 2 ÷, 1 sin_cos_pi.
        #[inline(always)]
        fn functions(inverse_r: f64) -> (ContactAt<f64>, [ModeAt<f64>; 1]) {
            let (sine, plain_cosine) = Scalar::sin_cos_pi(inverse_r * 0.5);
            let detuning = Scalar::detuning_off_pole(
                (inverse_r - 1.0) * (inverse_r + 1.0),
            );
            let cosine = Scalar::cosine_off_pole(plain_cosine);
            let size = Scalar::abs(detuning);
            let u = sine * size / (inverse_r * cosine);
            let h_re = Scalar::copysign(1.0, detuning);
            let r_squared = 1.0 / (inverse_r * inverse_r);
            let v_re = h_re * r_squared;
            let contact = ContactAt {
                scale: size,
                v: Complex { re: v_re, im: 0.0 },
                u,
                g: 0.0,
                reversal: 0.0,
                h: Complex { re: h_re, im: 0.0 },
            };
            let modes = [
                ModeAt {
                    x: inverse_r,
                    response: Complex { re: h_re, im: 0.0 },
                    u,
                    g: 0.0,
                },
            ];
            (contact, modes)
        }
        /// β_lim and a·sgn V = β_lim·U/V over r from 0.5 to 2, to 1e-3:
        /// 4 pieces of degree 5, each Σ coefficients[j]·(r − origin)^j, and 8 buckets of 1/density; with β*_lim 504 bytes.
        /// Largest error 7.0e-4, at r = 0.9948819864394244: checked at 816 points that the fit did not see.
        const TABLE: Table<'static, f64, ::core::primitive::u8, 2, 6> = Table {
            low: 0.5,
            density: 5.333333333333332,
            halvings: 1,
            buckets: &[0, 0, 1, 1, 2, 2, 2, 3],
            pieces: &[
                Piece {
                    from: 0.5,
                    origin: 0.64,
                    coefficients: [
                        [0.21699807, 1.4991218, 3.039399, -4.49481, -25.1913, -1.015],
                        [-0.40108, -3.157577, -1.0355, 16.0358, 45.826, -107.41],
                    ],
                },
                Piece {
                    from: 0.781,
                    origin: 0.93,
                    coefficients: [
                        [0.6990896, 1.306231, -1.33622, 3.9982, 3.673, -38.895],
                        [-0.988525, -0.375487, 3.82114, -11.9663, 6.034, 63.34],
                    ],
                },
                Piece {
                    from: 1.069,
                    origin: 1.35,
                    coefficients: [
                        [1.2047901, 1.326007, 0.50111, 0.1201, -0.45, 0.742],
                        [-0.933675, 0.194993, -0.16047, -0.02657, 0.7111, -1.4313],
                    ],
                },
                Piece {
                    from: 1.64,
                    origin: 1.82,
                    coefficients: [
                        [1.942737, 1.816688, 0.52324, -0.008, -0.001, 0.008],
                        [-0.870974, 0.08632, -0.07156, 0.0495, -0.027, 0.007],
                    ],
                },
            ],
        };
        /// β*_lim as a product over its zeros and poles: `Zero` is (r − at − rest)(r + at), `Pair`
        /// (that + off)² + least, `Real` r² + off.
        const SLIDING_LIMIT: Quotient<'static, f64> = Quotient {
            gain: 0.8333333333333334,
            squared: false,
            numerator: &[Factor::Real { off: 0.0 }],
            denominator: &[],
        };
        /// V, with its sign, in the same way.
        const EXCITATION: Quotient<'static, f64> = Quotient {
            gain: -1.0,
            squared: false,
            numerator: &[Factor::Real { off: 0.0 }],
            denominator: &[Factor::Zero { at: 1.0, rest: 0.0 }],
        };
    }
    ::frictiongen::emitted_system!(DeclaredMotion, DeclaredMotionAt, f64, ["block"]);
    ::frictiongen::kernel::wraps!(
        DeclaredMotionAt, Compiled of tabled DeclaredMotion, Copy
    );
    impl Scene for DeclaredMotion {
        type Scalar = f64;
        type Decay = Undamped;
        type Modes = [ModeAt<f64>; 1];
        type Waves = [Wave<f64, Undamped>; 1];
        #[inline]
        fn numbers(&self) -> Numbers<'static, f64> {
            Self::NUMBERS
        }
        /// φ of a mass, by modes.
        #[inline]
        fn shape(&self, mass: usize) -> Option<&[f64]> {
            Self::SHAPES.get(mass).map(<[f64; 1]>::as_slice)
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
        fn frequency_stage(&self, inverse_r: f64) -> (ContactAt<f64>, [ModeAt<f64>; 1]) {
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
            1.2 * contact.scale
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
        #[inline]
        fn sliding_limit(&self, contact: &ContactAt<f64>) -> f64 {
            let modulus_v = Scalar::abs(contact.v.re);
            let modulus_h = Scalar::abs(contact.h.re);
            modulus_v / (1.2 * modulus_h)
        }
    }
    impl Tabled for DeclaredMotion {
        /// Where the tables hold.
        #[inline]
        fn domain(&self) -> Domain<f64> {
            Domain {
                r: (0.5, 2.0),
                beta: (0.0, 2.0),
                exact_beyond: true,
                always_continuous: false,
                never_stuck: false,
            }
        }
        /// β_lim (5.65, 5.80, 5.96, 7.49) from the table.
        ///
        /// Proven at every r: at most 5.82e-4 off, the bound being largest at r = 0.500548828125.
        ///
        /// Operations at every r: a lookup of 1 comparison, 14 additions and multiplications.
        #[inline]
        fn tabled_limit(&self, r: f64) -> f64 {
            Self::TABLE.first(r)
        }
        /// β*_lim = |V|/(μ|H|) (6.11, 6.27, 6.33).
        ///
        /// Proven at every r: at most 5.86e-16 off, the bound being largest at r = 0.875.
        ///
        /// Operations: 4 additions and multiplications, 0 divisions, 0 roots; largest error seen 0.0e0.
        #[inline]
        fn tabled_sliding_limit(&self, r: f64) -> Option<f64> {
            Some(Self::SLIDING_LIMIT.size(r))
        }
    }
    impl TabledMotion for DeclaredMotion {
        type Moving = DeclaredMotionMotion;
        /// What amplitude and phase of the contact follow from (2.21, 5.35, 5.38, 7.20, 7.21).
        ///
        /// To 1e-3 up to β = 0.98·β_lim; nearer to it the error grows at most as 1/(1 − (β/β_lim)²).
        ///
        /// Proven at every r: at most 7.10e-4 off, the bound being largest at r = 0.9971381365212574.
        #[inline]
        fn tabled_contact(&self, r: f64) -> Option<ContactTable<f64>> {
            Some(
                ContactTable::undamped(Self::TABLE.values(r), Self::EXCITATION.value(r)),
            )
        }
    }
    ::frictiongen::kernel::not_provided!(
        DeclaredMotionAt : stuck, orbit; DeclaredMotion : simulation, stepper
    );
    impl ProvidesMotion for DeclaredMotion {
        type Motion = Continuous<Self>;
        /// The relative motion in the contact, and each mode's part in it: `rise` times (1 − d)/x², `fall` times cos τ − d and
        /// `forced` times sin τ − R·q̃, with d and q̃ the mode's free decays from a displacement and from a velocity; `unscale`
        /// is 1/(r²E), `residue` φ_k(φᵀw)/r², for the harmonics.  `friction_force` is β/(r²E) times a mode's φ_k(φᵀw); `friction` has
        /// `root`, Q = √(|V|² − (βU)²) times r²E, and `amplitude`, Q − βG.
        #[allow(unused_variables)]
        fn contact_motion(at: &At<Self>, friction: &Friction<f64>) -> MotionOf<Self> {
            let (inverse_r, contact) = (at.inverse_ratio(), at.contact_sums());
            let [mode_1] = at.modes();
            let friction_weight = friction.beta * friction.unscale;
            let rise = friction_weight * contact.scale;
            let forced = friction_weight * mode_1.u;
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
                        rise,
                        fall: 0.0,
                        forced,
                        residue: inverse_r * inverse_r,
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
            let [mode_1] = at.modes();
            if mass != 0 {
                return None;
            }
            let product = inverse_r * inverse_r;
            let r_squared = 1.0 / product;
            let v_others_re = -contact.scale * r_squared;
            let u_others = if mode_1.x < 0.5 { contact.u } else { 0.0 };
            let u_in_sum = if mode_1.x < 0.5 { 0.0 } else { mode_1.u };
            let rubbed_back = -u_in_sum;
            let u_in_range = u_others * 5.960464477539063e-8;
            let mismatch_re = mode_1.response.re * u_in_range
                + v_others_re * (rubbed_back * 5.960464477539063e-8);
            let inverse_re = 1.0 / contact.v.re;
            let root_in_range = friction.root * 5.960464477539063e-8;
            let unscale_in_range = friction.unscale * 16777216.0;
            let friction_weight = friction.beta * friction.unscale;
            let rise = friction_weight * contact.scale;
            let forced = friction_weight * u_in_sum;
            let (fundamental, waves) = (
                Fundamental {
                    cosine: root_in_range * (mode_1.response.re * inverse_re)
                        * unscale_in_range,
                    sine: friction.beta * (mismatch_re * inverse_re) * unscale_in_range,
                    response: Complex {
                        re: mode_1.response.re * friction.unscale,
                        im: 0.0,
                    },
                },
                [
                    mass_wave(
                        mode_1.x,
                        Undamped,
                        ModalCoefficients {
                            rise,
                            fall: 0.0,
                            forced,
                            residue: product,
                        },
                    ),
                ],
            );
            Some(Motion::of_mass(*friction, fundamental, waves))
        }
    }
    ::frictiongen::kernel::wraps!(
        DeclaredMotionMotion, Moving of tabled DeclaredMotion, Copy
    );
    impl DeclaredMotionMotion {
        /// The motion of mass `block` (5.50 and its exact form, 7.29).
        #[must_use]
        pub fn block(&self) -> MotionOf<DeclaredMotion> {
            self.mass(0)
        }
    }
};
