/// One mass on a spring, rubbing on a wall: no sums, no damping.
///
/// Emitted by `friction_system!` of frictiongen 0.1.0 from scene c6a0013aa6d29f2b.  Change the description, not this code.
///
/// # Description
///
/// ```text
/// pub struct SdofWall
/// {
///     masses: { block: 1.0 }, springs: { base - block: 1.0 }, contact: block -
///     wall, excitation: block,
/// }
/// ```
///
/// The motion in the contact is the displacement of `block`.
///
/// # What it offers
///
/// * `K1`, `M1`, `NATURAL_FREQUENCIES_HZ`, `NATURAL_FREQUENCIES`, `RESONANCES`, `MODE_SHAPES`, `SCENE_HASH`: constants of the chain
/// * `frequency_ratio(omega)`, `friction_ratio(friction, load)`: r and β from units
/// * `at(r)` returns [`SdofWallAt`], with `limits()` (β_lim and β*_lim), `regime(beta)` (continuous, stick-slip, stuck or bistable) and `margin(beta)` (β/min(β_lim, β*_lim) − 1, negative below both limits), or an error if r is negative or not a number
/// * `limits_without_search(r)`: an upper bound on β_lim, and β*_lim itself; `limits_into(rs, continuous, sliding)`: both limits for a slice of frequency ratios, into slices of the same length
/// * `at(r)?.motion(beta)` returns [`SdofWallMotion`], the continuous motion, with `contact()` and `block()`
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
pub struct SdofWall;
/// [`SdofWall`] at one frequency ratio: limits, regime, continuous motion.
///
/// Worst case: the operations of `functions`, and in each search at most `most_evaluations()` sums over 1 mode.  This number depends on r, and never exceeds 20000.
#[allow(
    deprecated,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
pub struct SdofWallAt(::frictiongen::kernel::response::At<SdofWall>);
/// Exact continuous motion of [`SdofWall`] at one frequency and one friction ratio.
#[allow(
    deprecated,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
pub struct SdofWallMotion(::frictiongen::kernel::response::Continuous<SdofWall>);
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
    impl SdofWall {
        /// Hash of all fields of the scene and of all names (FNV-1a, 64 bits).  Descriptions that differ only in layout, comments
        /// or attributes have the same hash.  To verify it, emit the description again.
        pub const SCENE_HASH: ::core::primitive::u64 = 0xc6a0_013a_a6d2_9f2b;
        /// k₁, the stiffness of the spring `base - block`: N/m, if springs are in N/m.
        pub const K1: f64 = 1.0;
        /// m₁, the mass `block`: kg, if masses are in kg.
        pub const M1: f64 = 1.0;
        /// Natural frequencies in Hz, ascending, if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES_HZ: [f64; 1] = [0.15915494309189535];
        /// Natural frequencies ω_i, ascending; rad/s if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES: [f64; 1] = [1.0];
        /// Frequency ratios r of the undamped resonances, √λ_i = ω_i√(m₁/k₁).
        pub const RESONANCES: [f64; 1] = [1.0];
        /// Mode shapes φ, [mode][mass], with φᵀΓφ = 1 and Γ = diag(m_i/m₁).  The first component that is not 0 is positive.
        pub const MODE_SHAPES: [[f64; 1]; 1] = [[1.0]];
        /// Constants of the chain.
        const CHAIN: Chain<f64> = Chain {
            /// true if a mode is damped
            damped: false,
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
        const MODES: [Mode<f64>; 1] = [
            Mode {
                /// kind of damping: `Undamped` for ζ = 0, `Light` for ζ < 1/2, `Heavy` for ζ < 1, `Critical` for ζ = 1, `Over` for ζ > 1
                kind: Kind::Undamped,
                /// true if the contact drives the mode: φᵀw is not 0
                in_contact: true,
                /// √λ, the frequency ratio r of the undamped resonance
                resonance: 1.0,
                /// ζ, the modal damping ratio
                zeta: 0.0,
                /// √|1 − ζ²|
                q: 1.0,
                /// 1 − q
                q_defect: 0.0,
                /// φᵀp, with p the load on each mass over P
                load: 1.0,
                /// φᵀw, with w = 1 at the mass that rubs and −1 at its partner
                contact: 1.0,
                /// (φᵀp)(φᵀw)
                residue: 1.0,
                /// (φᵀw)², the term of m*
                contact_squared: 1.0,
                /// (φᵀp)(φᵀw)/λ
                static_residue: 1.0,
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
            unbounded: &[1.0],
            /// those of them in which the contact does not move
            invisible: &[],
        };
        /// Mode shapes φ of `MODES`, [mass][mode].
        const SHAPES: [[f64; 1]; 1] = transposed(&Self::MODE_SHAPES);
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
        /// Without damping r²G, r²H_c and the imaginary parts are 0.
        ///
        /// Operations: 12: 4 ×, 2 +, 2 compare, 2 sign, 1 sin_cos_pi, 1 ÷.
        #[inline(always)]
        fn functions(inverse_r: f64) -> (ContactAt<f64>, [ModeAt<f64>; 1]) {
            /// sin(πx/2), cos(πx/2)
            let (sine, plain_cosine) = Scalar::sin_cos_pi(inverse_r * 0.5);
            /// x² − 1; a tiny number in place of an exact 0
            let detuning = Scalar::detuning_off_pole(
                (inverse_r - 1.0) * (inverse_r + 1.0),
            );
            /// cos(πx/2); a tiny number in place of an exact 0
            let cosine = Scalar::cosine_off_pole(plain_cosine);
            /// |x² − 1|
            let size = Scalar::abs(detuning);
            /// uR²·size = tan(πx/2)/x·size (5.20, 5.34)
            let u = sine * size / (inverse_r * cosine);
            /// Re V·r²E
            let v_re = Scalar::copysign(1.0, detuning);
            let contact = ContactAt {
                scale: size,
                v: Complex { re: v_re, im: 0.0 },
                u,
                g: 0.0,
                reversal: 0.0,
                h: Complex { re: v_re, im: 0.0 },
            };
            let modes = [
                ModeAt {
                    x: inverse_r,
                    response: Complex { re: v_re, im: 0.0 },
                    u,
                    g: 0.0,
                },
            ];
            (contact, modes)
        }
    }
    /// The functions `at`, `limits_without_search` and `limits_into`.
    ::frictiongen::kernel::scene_functions!(SdofWall, SdofWallAt, f64, At);
    /// The trait `FrictionSystem`, by which generic code calls any scene.  The texts are the names of the masses.
    ::frictiongen::emitted_system!(SdofWall, SdofWallAt, f64, ["block"]);
    /// `Clone`, `Copy`, `Debug`, `From` and `Deref`: the answers at one frequency have all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(SdofWallAt, At of SdofWall, Copy);
    impl Scene for SdofWall {
        /// The items that every scene has: types, constants and the calls of the frequency stage.  The word says whether a
        /// mode is damped, and the number is the number of modes that the load or the contact drives.
        ::frictiongen::kernel::scene_items!(f64, undamped, 1);
        /// Components of a mass in the mode shapes.
        #[inline]
        fn shape(&self, mass: usize) -> Option<&[f64]> {
            Self::SHAPES.get(mass).map(<[f64; 1]>::as_slice)
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
        /// Operations: none.
        #[inline]
        fn break_away(&self, contact: &ContactAt<f64>) -> f64 {
            contact.scale
        }
        /// β_lim = |V|/√(U² + max(S, H_c + μm*/r²)²) (5.65, 5.80, 5.96, 7.49), with S the largest J(τ)/sin τ over
        /// 0 < τ < π.  With more friction the contact would reverse within the half period.  `constraint` is r²E times
        /// that maximum.  r²J is the sum of (φᵀw)²((1 + g)p + uR²(cos τ − p′)) over the modes.  p is the free motion of
        /// a mode, p″ + 2ζxp′ + x²p = 0, from p = 0 and p′ = 1 at τ = 0.
        ///
        /// Operations: 6: 2 ×, 1 +, 1 sign, 1 ÷, 1 √.
        #[inline]
        fn continuous_limit(&self, contact: &ContactAt<f64>, constraint: f64) -> f64 {
            /// |V|·r²E
            let modulus_v = Scalar::abs(contact.v.re);
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
        SdofWallAt : stuck, orbit; SdofWall : simulation, stepper, self_check
    );
    impl ProvidesMotion for SdofWall {
        type Motion = SdofWallMotion;
        /// The relative motion in the contact: its terms of cos τ and sin τ, and the coefficients of each mode's functions.
        ///
        /// d and q̃ are free motions of a mode, solutions of y″ + 2ζxy′ + x²y = 0: d from d = 1 and d′ = 0 at τ = 0, and q̃
        /// from q̃ = 0 and q̃′ = x.  The coefficients multiply (1 − d)/x² (`rise`), cos τ − d (`fall`, 0 without damping)
        /// and sin τ − Rq̃ (`forced`).  `harmonic` is (φᵀw)²/r², which only higher harmonics need.  Of `friction`, `unscale`
        /// is 1/(r²E), `amplitude` is Q − βG with Q = √(|V|² − (βU)²), and `root` is Q·r²E.
        ///
        /// Operations: 5: 5 ×.
        /// The kernel adds one wave for each of 1 mode.  No search is made before an amplitude or a phase is asked for.
        fn contact_motion(at: &At<Self>, friction: &Friction<f64>) -> MotionOf<Self> {
            let inverse_r = at.inverse_ratio();
            let contact = at.contact_sums();
            let [mode_1] = at.modes();
            /// β/(r²E)
            let friction_weight = friction.beta * friction.unscale;
            /// coefficient of (1 − d)/x²
            let rise = friction_weight * contact.scale;
            /// coefficient of sin τ − Rq̃
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
                        harmonic: inverse_r * inverse_r,
                    },
                ),
            ];
            Motion::of_contact(*friction, fundamental, waves)
        }
    }
    /// `Clone`, `Copy`, `Debug`, `From` and `Deref`: the motion has all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(SdofWallMotion, Continuous of SdofWall, Copy);
    impl SdofWallMotion {
        /// Motion of mass `block` (5.50 and its exact form, 7.29).
        ///
        /// It rubs on a support at rest, so its motion is that of the contact.
        #[must_use]
        pub fn block(&self) -> MotionOf<SdofWall> {
            self.contact()
        }
    }
};
