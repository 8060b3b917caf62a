/// The thesis's three masses (figure 6.1).
///
/// Emitted by `friction_system!` of frictiongen 0.1.0 from scene a809981133b08615.  Change the description, not this code.
///
/// # Description
///
/// ```text
/// pub struct Thesis
/// {
///     masses: { first: 1.0, second: 1.0, third: 1.0 }, springs:
///     { base - first: 1.0, first - second: 1.0, second - third: 1.0 }, contact:
///     second - wall, excitation: first,
/// }
/// ```
///
/// The motion in the contact is the displacement of `second`.
///
/// # What it offers
///
/// * `K1`, `M1`, `NATURAL_FREQUENCIES_HZ`, `NATURAL_FREQUENCIES`, `RESONANCES`, `MODE_SHAPES`, `SCENE_HASH`: constants of the chain
/// * `frequency_ratio(omega)`, `friction_ratio(friction, load)`: r and β from units
/// * `at(r)` returns [`ThesisAt`], with `limits()` (β_lim and β*_lim), `regime(beta)` (continuous, stick-slip, stuck or bistable) and `margin(beta)` (β/min(β_lim, β*_lim) − 1, negative below both limits), or an error if r is negative or not a number
/// * `limits_without_search(r)`: an upper bound on β_lim, and β*_lim itself; `limits_into(rs, continuous, sliding)`: both limits for a slice of frequency ratios, into slices of the same length
/// * `at(r)?.motion(beta)` returns [`ThesisMotion`], the continuous motion, with `contact()`, `first()`, `second()` and `third()`
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
pub struct Thesis;
/// [`Thesis`] at one frequency ratio: limits, regime, continuous motion.
///
/// Worst case: the operations of `functions`, and in each search at most `most_evaluations()` sums over 3 modes.  This number depends on r, and never exceeds 20000.
#[allow(
    deprecated,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
pub struct ThesisAt(::frictiongen::kernel::response::At<Thesis>);
/// Exact continuous motion of [`Thesis`] at one frequency and one friction ratio.
#[allow(
    deprecated,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
pub struct ThesisMotion(::frictiongen::kernel::response::Continuous<Thesis>);
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
    impl Thesis {
        /// Hash of all fields of the scene and of all names (FNV-1a, 64 bits).  Descriptions that differ only in layout, comments
        /// or attributes have the same hash.  To verify it, emit the description again.
        pub const SCENE_HASH: ::core::primitive::u64 = 0xa809_9811_33b0_8615;
        /// k₁, the stiffness of the spring `base - first`: N/m, if springs are in N/m.
        pub const K1: f64 = 1.0;
        /// m₁, the mass `first`: kg, if masses are in kg.
        pub const M1: f64 = 1.0;
        /// Natural frequencies in Hz, ascending, if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES_HZ: [f64; 3] = [
            0.07083061316114524,
            0.19846296786640766,
            0.2867872977971578,
        ];
        /// Natural frequencies ω_i, ascending; rad/s if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES: [f64; 3] = [
            0.4450418679126288,
            1.246979603717467,
            1.8019377358048383,
        ];
        /// Frequency ratios r of the undamped resonances, √λ_i = ω_i√(m₁/k₁).
        pub const RESONANCES: [f64; 3] = [
            0.4450418679126288,
            1.246979603717467,
            1.8019377358048383,
        ];
        /// Mode shapes φ, [mode][mass], with φᵀΓφ = 1 and Γ = diag(m_i/m₁).  The first component that is not 0 is positive.
        pub const MODE_SHAPES: [[f64; 3]; 3] = [
            [0.32798527760568175, 0.5910090485061035, 0.7369762290995783],
            [0.7369762290995783, 0.32798527760568175, -0.5910090485061035],
            [0.5910090485061035, -0.7369762290995783, 0.32798527760568175],
        ];
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
        const MODES: [Mode<f64>; 3] = [
            Mode {
                /// kind of damping: `Undamped` for ζ = 0, `Light` for ζ < 1/2, `Heavy` for ζ < 1, `Critical` for ζ = 1, `Over` for ζ > 1
                kind: Kind::Undamped,
                /// true if the contact drives the mode: φᵀw is not 0
                in_contact: true,
                /// √λ, the frequency ratio r of the undamped resonance
                resonance: 0.4450418679126288,
                /// ζ, the modal damping ratio
                zeta: 0.0,
                /// √|1 − ζ²|
                q: 1.0,
                /// 1 − q
                q_defect: 0.0,
                /// φᵀp, with p the load on each mass over P
                load: 0.32798527760568175,
                /// φᵀw, with w = 1 at the mass that rubs and −1 at its partner
                contact: 0.5910090485061035,
                /// (φᵀp)(φᵀw)
                residue: 0.19384226684174422,
                /// (φᵀw)², the term of m*
                contact_squared: 0.34929169541608984,
                /// (φᵀp)(φᵀw)/λ
                static_residue: 0.9786935821895919,
            },
            Mode {
                kind: Kind::Undamped,
                in_contact: true,
                resonance: 1.246979603717467,
                zeta: 0.0,
                q: 1.0,
                q_defect: 0.0,
                load: 0.7369762290995783,
                contact: 0.32798527760568175,
                residue: 0.2417173530900137,
                contact_squared: 0.10757434232607613,
                static_residue: 0.15544942857434563,
            },
            Mode {
                kind: Kind::Undamped,
                in_contact: true,
                resonance: 1.8019377358048383,
                zeta: 0.0,
                q: 1.0,
                q_defect: 0.0,
                load: 0.5910090485061035,
                contact: -0.7369762290995783,
                residue: -0.4355596199317579,
                contact_squared: 0.5431339622578341,
                static_residue: -0.13414301076393756,
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
                sliding_at_rest: 0.5,
                /// β_lim for r → ∞
                continuous_at_infinity: 0.0,
                /// β*_lim for r → ∞
                sliding_at_infinity: 0.0,
            },
            /// index of the mass that rubs on a support
            rubbing: Some(1),
            /// true if V and H may have a common zero: the chain then absorbs the load, and the limits follow from the force that holds a stuck contact
            absorbs: true,
            /// undamped resonances that the load drives
            unbounded: &[0.4450418679126288, 1.246979603717467, 1.8019377358048383],
            /// those of them in which the contact does not move
            invisible: &[],
        };
        /// Mode shapes φ of `MODES`, [mass][mode].
        const SHAPES: [[f64; 3]; 3] = transposed(&Self::MODE_SHAPES);
        /// The functions of an undamped mode.
        ///
        /// It returns uR²·size, g·size and (g + 2ζRu)·size.  The factor `size` removes the pole at x = 1.
        ///
        /// Operations: 12: 5 ×, 2 +, 2 compare, 1 sign, 1 sin_cos_pi, 1 ÷.
        #[inline(always)]
        fn undamped_mode(mode: &Mode<f64>, inverse_r: f64) -> ModeResponse<f64> {
            /// x = √λ/r = 1/R
            let x = mode.resonance * inverse_r;
            /// sin(πx/2), cos(πx/2)
            let (sine, plain_cosine) = Scalar::sin_cos_pi(x * 0.5);
            /// x² − 1; a tiny number in place of an exact 0
            let detuning = Scalar::detuning_off_pole((x - 1.0) * (x + 1.0));
            /// cos(πx/2); a tiny number in place of an exact 0
            let cosine = Scalar::cosine_off_pole(plain_cosine);
            /// |x² − 1|
            let size = Scalar::abs(detuning);
            /// uR²·size = tan(πx/2)/x·size (5.20, 5.34)
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
        /// Without damping r²G, r²H_c and the imaginary parts are 0.
        ///
        /// Operations: 62: 27 ×, 12 +, 8 compare, 6 sign, 6 ÷, 3 sin_cos_pi.
        #[inline(always)]
        fn functions(inverse_r: f64) -> (ContactAt<f64>, [ModeAt<f64>; 3]) {
            let [constants_1, constants_2, constants_3] = &Self::MODES;
            let mode_1 = Self::undamped_mode(constants_1, inverse_r);
            let mode_2 = Self::undamped_mode(constants_2, inverse_r);
            let mode_3 = Self::undamped_mode(constants_3, inverse_r);
            /// E, the smallest `size` of the modes in contact
            let scale = Scalar::min(mode_1.size, mode_2.size);
            let scale = Scalar::min(scale, mode_3.size);
            let modes = [
                Self::CHAIN.at_scale(&mode_1, scale),
                Self::CHAIN.at_scale(&mode_2, scale),
                Self::CHAIN.at_scale(&mode_3, scale),
            ];
            let [at_1, at_2, at_3] = &modes;
            let sum = Self::CHAIN.begun_by(scale, constants_1, &mode_1, at_1, false);
            /// `false`: this mode is not the only one, so that E is not always its own `size`
            let sum = Self::CHAIN
                .joined_by(&sum, constants_2, &mode_2, at_2, false, false);
            let sum = Self::CHAIN
                .joined_by(&sum, constants_3, &mode_3, at_3, false, false);
            let contact = Self::CHAIN.completed(&sum, inverse_r);
            (contact, modes)
        }
    }
    /// The functions `at`, `limits_without_search` and `limits_into`.
    ::frictiongen::kernel::scene_functions!(Thesis, ThesisAt, f64, At);
    /// The trait `FrictionSystem`, by which generic code calls any scene.  The texts are the names of the masses.
    ::frictiongen::emitted_system!(Thesis, ThesisAt, f64, ["first", "second", "third"]);
    /// `Clone`, `Copy`, `Debug`, `From` and `Deref`: the answers at one frequency have all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(ThesisAt, At of Thesis, Copy);
    impl Scene for Thesis {
        /// The items that every scene has: types, constants and the calls of the frequency stage.  The word says whether a
        /// mode is damped, and the number is the number of modes that the load or the contact drives.
        ::frictiongen::kernel::scene_items!(f64, undamped, 3);
        /// Components of a mass in the mode shapes.
        #[inline]
        fn shape(&self, mass: usize) -> Option<&[f64]> {
            Self::SHAPES.get(mass).map(<[f64; 3]>::as_slice)
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
        /// Operations: 3: 2 sign, 1 ÷.
        #[inline]
        fn sliding_limit(&self, contact: &ContactAt<f64>) -> f64 {
            /// |V|·r²E
            let modulus_v = Scalar::abs(contact.v.re);
            /// |H|·r²E
            let modulus_h = Scalar::abs(contact.h.re);
            modulus_v / modulus_h
        }
    }
    /// Placeholders for methods that `provide` does not list: the compiler refuses a call and says what to add.
    ::frictiongen::kernel::not_provided!(
        ThesisAt : stuck, orbit; Thesis : simulation, stepper, self_check
    );
    /// The motions are those of the kernel, which sums over the modes in loops.  Worst case: a fixed number of operations
    /// for each mode.  No search is made before an amplitude or a phase is asked for.
    impl ProvidesMotion for Thesis {
        type Motion = ThesisMotion;
    }
    /// `Clone`, `Copy`, `Debug`, `From` and `Deref`: the motion has all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(ThesisMotion, Continuous of Thesis, Copy);
    impl ThesisMotion {
        /// Motion of mass `first` (5.50 and its exact form, 7.29).
        #[must_use]
        pub fn first(&self) -> MotionOf<Thesis> {
            self.mass(0)
        }
        /// Motion of mass `second` (5.50 and its exact form, 7.29).
        ///
        /// It rubs on a support at rest, so its motion is that of the contact.
        #[must_use]
        pub fn second(&self) -> MotionOf<Thesis> {
            self.contact()
        }
        /// Motion of mass `third` (5.50 and its exact form, 7.29).
        #[must_use]
        pub fn third(&self) -> MotionOf<Thesis> {
            self.mass(2)
        }
    }
};
