/// Seventeen masses: passes over the modes instead of straight lines.
///
/// Emitted by `friction_system!` of frictiongen 0.1.0 from scene fc6191d9cb991d4e.  Change the description, not this code.
///
/// # Description
///
/// ```text
/// pub struct Tall
/// {
///     masses:
///     {
///         m1: 1, m2: 1, m3: 1, m4: 1, m5: 1, m6: 1, m7: 1, m8: 1, m9: 1, m10: 1,
///         m11: 1, m12: 1, m13: 1, m14: 1, m15: 1, m16: 1, m17: 1,
///     }, springs:
///     {
///         base - m1: 1, m1 - m2: 1, m2 - m3: 1, m3 - m4: 1, m4 - m5: 1, m5 - m6:
///         1, m6 - m7: 1, m7 - m8: 1, m8 - m9: 1, m9 - m10: 1, m10 - m11: 1, m11
///         - m12: 1, m12 - m13: 1, m13 - m14: 1, m14 - m15: 1, m15 - m16: 1, m16
///         - m17: 1,
///     }, contact: m2 - wall, excitation: m1, damping: modal(0.02), provide:
///     [limits, motion(m3)],
/// }
/// ```
///
/// The motion in the contact is the displacement of `m2`.
///
/// # What it offers
///
/// * `K1`, `M1`, `NATURAL_FREQUENCIES_HZ`, `NATURAL_FREQUENCIES`, `RESONANCES`, `MODE_SHAPES`, `SCENE_HASH`: constants of the chain
/// * `frequency_ratio(omega)`, `friction_ratio(friction, load)`: r and β from units
/// * `at(r)` returns [`TallAt`], with `limits()` (β_lim and β*_lim), `regime(beta)` (continuous, stick-slip, stuck or bistable) and `margin(beta)` (β/min(β_lim, β*_lim) − 1, negative below both limits), or an error if r is negative or not a number
/// * `limits_without_search(r)`: an upper bound on β_lim, and β*_lim itself; `limits_into(rs, continuous, sliding)`: both limits for a slice of frequency ratios, into slices of the same length
/// * `at(r)?.motion(beta)` returns [`TallMotion`], the continuous motion, with `contact()` and `m3()`
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
pub struct Tall;
/// [`Tall`] at one frequency ratio: limits, regime, continuous motion.
///
/// Worst case: the operations of `frequency_stage`, and in each search at most `most_evaluations()` sums over 17 modes.  This number depends on r, and never exceeds 20000.
#[allow(
    deprecated,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
pub struct TallAt(::frictiongen::kernel::response::At<Tall>);
/// Exact continuous motion of [`Tall`] at one frequency and one friction ratio.
#[allow(
    deprecated,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
pub struct TallMotion(::frictiongen::kernel::response::Continuous<Tall>);
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
    impl Tall {
        /// Hash of all fields of the scene and of all names (FNV-1a, 64 bits).  Descriptions that differ only in layout, comments
        /// or attributes have the same hash.  To verify it, emit the description again.
        pub const SCENE_HASH: ::core::primitive::u64 = 0xfc61_91d9_cb99_1d4e;
        /// k₁, the stiffness of the spring `base - m1`: N/m, if springs are in N/m.
        pub const K1: f64 = 1.0;
        /// m₁, the mass `m1`: kg, if masses are in kg.
        pub const M1: f64 = 1.0;
        /// Natural frequencies in Hz, ascending, if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES_HZ: [f64; 17] = [
            0.014280919042527483,
            0.04272777556449644,
            0.07083061316114524,
            0.09836316430834662,
            0.12510375309314115,
            0.15083708001784535,
            0.1753559554650126,
            0.19846296786640766,
            0.21997207314487777,
            0.2397100926318698,
            0.25751810740024195,
            0.27325273778602244,
            0.2867872977971578,
            0.29801281511463074,
            0.3068389084734983,
            0.3131945153596938,
            0.3170284641636058,
        ];
        /// Natural frequencies ω_i, ascending; rad/s if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES: [f64; 17] = [
            0.08972966070102985,
            0.268466531635311,
            0.4450418679126288,
            0.6180339887498949,
            0.7860500633078472,
            0.9477373249459974,
            1.101793962904205,
            1.246979603717467,
            1.3821252979737293,
            1.506142932007222,
            1.618033988749895,
            1.7168975872037322,
            1.8019377358048383,
            1.8724697412794744,
            1.9279257213917065,
            1.9678591771972593,
            1.9919485879904781,
        ];
        /// Frequency ratios r of the undamped resonances, √λ_i = ω_i√(m₁/k₁).
        pub const RESONANCES: [f64; 17] = [
            0.08972966070102985,
            0.268466531635311,
            0.4450418679126288,
            0.6180339887498949,
            0.7860500633078472,
            0.9477373249459974,
            1.101793962904205,
            1.246979603717467,
            1.3821252979737293,
            1.506142932007222,
            1.618033988749895,
            1.7168975872037322,
            1.8019377358048383,
            1.8724697412794744,
            1.9279257213917065,
            1.9678591771972593,
            1.9919485879904781,
        ];
        /// Mode shapes φ, [mode][mass], with φᵀΓφ = 1 and Γ = diag(m_i/m₁).  The first component that is not 0 is positive.
        pub const MODE_SHAPES: [[f64; 17]; 17] = [
            [
                0.03030361732426425,
                0.06036324774007196,
                0.0899368687780915,
                0.11878637103073232,
                0.14667947526908878,
                0.1733916026187133,
                0.19870768273666328,
                0.222423885431443,
                0.2443492617838555,
                0.2643072815554236,
                0.2821372545060723,
                0.2976956241774572,
                0.31085712372515767,
                0.3215157844936519,
                0.32958578921362314,
                0.33500216295215196,
                0.33772129625267205,
            ],
            [
                0.0899368687780915,
                0.1733916026187133,
                0.2443492617838555,
                0.2976956241774572,
                0.32958578921362314,
                0.33772129625267205,
                0.3215157844936519,
                0.2821372545060723,
                0.222423885431443,
                0.14667947526908878,
                0.06036324774007196,
                -0.03030361732426425,
                -0.11878637103073232,
                -0.19870768273666328,
                -0.2643072815554236,
                -0.31085712372515767,
                -0.33500216295215196,
            ],
            [
                0.14667947526908878,
                0.2643072815554236,
                0.32958578921362314,
                0.32958578921362314,
                0.2643072815554236,
                0.14667947526908878,
                0.0,
                -0.14667947526908878,
                -0.2643072815554236,
                -0.32958578921362314,
                -0.32958578921362314,
                -0.2643072815554236,
                -0.14667947526908878,
                0.0,
                0.14667947526908878,
                0.2643072815554236,
                0.32958578921362314,
            ],
            [
                0.19870768273666328,
                0.3215157844936519,
                0.3215157844936519,
                0.19870768273666328,
                0.0,
                -0.19870768273666328,
                -0.3215157844936519,
                -0.3215157844936519,
                -0.19870768273666328,
                0.0,
                0.19870768273666328,
                0.3215157844936519,
                0.3215157844936519,
                0.19870768273666328,
                0.0,
                -0.19870768273666328,
                -0.3215157844936519,
            ],
            [
                0.2443492617838555,
                0.33772129625267205,
                0.222423885431443,
                -0.03030361732426425,
                -0.2643072815554236,
                -0.33500216295215196,
                -0.19870768273666328,
                0.06036324774007196,
                0.2821372545060723,
                0.32958578921362314,
                0.1733916026187133,
                -0.0899368687780915,
                -0.2976956241774572,
                -0.3215157844936519,
                -0.14667947526908878,
                0.11878637103073232,
                0.31085712372515767,
            ],
            [
                0.2821372545060723,
                0.31085712372515767,
                0.06036324774007196,
                -0.2443492617838555,
                -0.32958578921362314,
                -0.11878637103073232,
                0.19870768273666328,
                0.33772129625267205,
                0.1733916026187133,
                -0.14667947526908878,
                -0.33500216295215196,
                -0.222423885431443,
                0.0899368687780915,
                0.3215157844936519,
                0.2643072815554236,
                -0.03030361732426425,
                -0.2976956241774572,
            ],
            [
                0.31085712372515767,
                0.2443492617838555,
                -0.11878637103073232,
                -0.33772129625267205,
                -0.14667947526908878,
                0.222423885431443,
                0.3215157844936519,
                0.03030361732426425,
                -0.2976956241774572,
                -0.2643072815554236,
                0.0899368687780915,
                0.33500216295215196,
                0.1733916026187133,
                -0.19870768273666328,
                -0.32958578921362314,
                -0.06036324774007196,
                0.2821372545060723,
            ],
            [
                0.32958578921362314,
                0.14667947526908878,
                -0.2643072815554236,
                -0.2643072815554236,
                0.14667947526908878,
                0.32958578921362314,
                0.0,
                -0.32958578921362314,
                -0.14667947526908878,
                0.2643072815554236,
                0.2643072815554236,
                -0.14667947526908878,
                -0.32958578921362314,
                0.0,
                0.32958578921362314,
                0.14667947526908878,
                -0.2643072815554236,
            ],
            [
                0.33772129625267205,
                0.03030361732426425,
                -0.33500216295215196,
                -0.06036324774007196,
                0.32958578921362314,
                0.0899368687780915,
                -0.3215157844936519,
                -0.11878637103073232,
                0.31085712372515767,
                0.14667947526908878,
                -0.2976956241774572,
                -0.1733916026187133,
                0.2821372545060723,
                0.19870768273666328,
                -0.2643072815554236,
                -0.222423885431443,
                0.2443492617838555,
            ],
            [
                0.33500216295215196,
                -0.0899368687780915,
                -0.31085712372515767,
                0.1733916026187133,
                0.2643072815554236,
                -0.2443492617838555,
                -0.19870768273666328,
                0.2976956241774572,
                0.11878637103073232,
                -0.32958578921362314,
                -0.03030361732426425,
                0.33772129625267205,
                -0.06036324774007196,
                -0.3215157844936519,
                0.14667947526908878,
                0.2821372545060723,
                -0.222423885431443,
            ],
            [
                0.3215157844936519,
                -0.19870768273666328,
                -0.19870768273666328,
                0.3215157844936519,
                0.0,
                -0.3215157844936519,
                0.19870768273666328,
                0.19870768273666328,
                -0.3215157844936519,
                0.0,
                0.3215157844936519,
                -0.19870768273666328,
                -0.19870768273666328,
                0.3215157844936519,
                0.0,
                -0.3215157844936519,
                0.19870768273666328,
            ],
            [
                0.2976956241774572,
                -0.2821372545060723,
                -0.03030361732426425,
                0.31085712372515767,
                -0.2643072815554236,
                -0.06036324774007196,
                0.3215157844936519,
                -0.2443492617838555,
                -0.0899368687780915,
                0.32958578921362314,
                -0.222423885431443,
                -0.11878637103073232,
                0.33500216295215196,
                -0.19870768273666328,
                -0.14667947526908878,
                0.33772129625267205,
                -0.1733916026187133,
            ],
            [
                0.2643072815554236,
                -0.32958578921362314,
                0.14667947526908878,
                0.14667947526908878,
                -0.32958578921362314,
                0.2643072815554236,
                0.0,
                -0.2643072815554236,
                0.32958578921362314,
                -0.14667947526908878,
                -0.14667947526908878,
                0.32958578921362314,
                -0.2643072815554236,
                0.0,
                0.2643072815554236,
                -0.32958578921362314,
                0.14667947526908878,
            ],
            [
                0.222423885431443,
                -0.33500216295215196,
                0.2821372545060723,
                -0.0899368687780915,
                -0.14667947526908878,
                0.31085712372515767,
                -0.3215157844936519,
                0.1733916026187133,
                0.06036324774007196,
                -0.2643072815554236,
                0.33772129625267205,
                -0.2443492617838555,
                0.03030361732426425,
                0.19870768273666328,
                -0.32958578921362314,
                0.2976956241774572,
                -0.11878637103073232,
            ],
            [
                0.1733916026187133,
                -0.2976956241774572,
                0.33772129625267205,
                -0.2821372545060723,
                0.14667947526908878,
                0.03030361732426425,
                -0.19870768273666328,
                0.31085712372515767,
                -0.33500216295215196,
                0.2643072815554236,
                -0.11878637103073232,
                -0.06036324774007196,
                0.222423885431443,
                -0.3215157844936519,
                0.32958578921362314,
                -0.2443492617838555,
                0.0899368687780915,
            ],
            [
                0.11878637103073232,
                -0.222423885431443,
                0.2976956241774572,
                -0.33500216295215196,
                0.32958578921362314,
                -0.2821372545060723,
                0.19870768273666328,
                -0.0899368687780915,
                -0.03030361732426425,
                0.14667947526908878,
                -0.2443492617838555,
                0.31085712372515767,
                -0.33772129625267205,
                0.3215157844936519,
                -0.2643072815554236,
                0.1733916026187133,
                -0.06036324774007196,
            ],
            [
                0.06036324774007196,
                -0.11878637103073232,
                0.1733916026187133,
                -0.222423885431443,
                0.2643072815554236,
                -0.2976956241774572,
                0.3215157844936519,
                -0.33500216295215196,
                0.33772129625267205,
                -0.32958578921362314,
                0.31085712372515767,
                -0.2821372545060723,
                0.2443492617838555,
                -0.19870768273666328,
                0.14667947526908878,
                -0.0899368687780915,
                0.03030361732426425,
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
        const MODES: [Mode<f64>; 17] = [
            Mode {
                /// kind of damping: `Undamped` for ζ = 0, `Light` for ζ < 1/2, `Heavy` for ζ < 1, `Critical` for ζ = 1, `Over` for ζ > 1
                kind: Kind::Light,
                /// true if the contact drives the mode: φᵀw is not 0
                in_contact: true,
                /// √λ, the frequency ratio r of the undamped resonance
                resonance: 0.08972966070102985,
                /// ζ, the modal damping ratio
                zeta: 0.02,
                /// √|1 − ζ²|
                q: 0.999799979995999,
                /// 1 − q
                q_defect: 0.0002000200040010003,
                /// φᵀp, with p the load on each mass over P
                load: 0.03030361732426425,
                /// φᵀw, with w = 1 at the mass that rubs and −1 at its partner
                contact: 0.06036324774007196,
                /// (φᵀp)(φᵀw)
                residue: 0.0018292247599648993,
                /// (φᵀw)², the term of m*
                contact_squared: 0.0036437216777293023,
                /// (φᵀp)(φᵀw)/λ
                static_residue: 0.22719303866223473,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 0.268466531635311,
                zeta: 0.02,
                q: 0.999799979995999,
                q_defect: 0.0002000200040010003,
                load: 0.0899368687780915,
                contact: 0.1733916026187133,
                residue: 0.015594297811942206,
                contact_squared: 0.03006464785868579,
                static_residue: 0.21636425799963271,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 0.4450418679126288,
                zeta: 0.02,
                q: 0.999799979995999,
                q_defect: 0.0002000200040010003,
                load: 0.14667947526908878,
                contact: 0.2643072815554236,
                residue: 0.03876845336834884,
                contact_squared: 0.06985833908321797,
                static_residue: 0.19573871643791838,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 0.6180339887498949,
                zeta: 0.02,
                q: 0.999799979995999,
                q_defect: 0.0002000200040010003,
                load: 0.19870768273666328,
                contact: 0.3215157844936519,
                residue: 0.06388765649999399,
                contact_squared: 0.10337239967856843,
                static_residue: 0.1672600561785624,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 0.7860500633078472,
                zeta: 0.02,
                q: 0.999799979995999,
                q_defect: 0.0002000200040010003,
                load: 0.2443492617838555,
                contact: 0.33772129625267205,
                residue: 0.08252194942802718,
                contact_squared: 0.11405567394258509,
                static_residue: 0.13355774100704082,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 0.9477373249459974,
                zeta: 0.02,
                q: 0.999799979995999,
                q_defect: 0.0002000200040010003,
                load: 0.2821372545060723,
                contact: 0.31085712372515767,
                residue: 0.08770437543147042,
                contact_squared: 0.09663215137067799,
                static_residue: 0.09764393892858751,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 1.101793962904205,
                zeta: 0.02,
                q: 0.999799979995999,
                q_defect: 0.0002000200040010003,
                load: 0.31085712372515767,
                contact: 0.2443492617838555,
                residue: 0.07595770870249491,
                contact_squared: 0.05970656173431514,
                static_residue: 0.06257070938977043,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 1.246979603717467,
                zeta: 0.02,
                q: 0.999799979995999,
                q_defect: 0.0002000200040010003,
                load: 0.32958578921362314,
                contact: 0.14667947526908878,
                residue: 0.04834347061800274,
                contact_squared: 0.021514868465215227,
                static_residue: 0.031089885714869123,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 1.3821252979737293,
                zeta: 0.02,
                q: 0.999799979995999,
                q_defect: 0.0002000200040010003,
                load: 0.33772129625267205,
                contact: 0.03030361732426425,
                residue: 0.01023417692389545,
                contact_squared: 0.0009183092229354483,
                static_residue: 0.005357449526045189,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 1.506142932007222,
                zeta: 0.02,
                q: 0.999799979995999,
                q_defect: 0.0002000200040010003,
                load: 0.33500216295215196,
                contact: -0.0899368687780915,
                residue: -0.03012904556980452,
                contact_squared: 0.008088640365607651,
                static_residue: -0.013281679561780814,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 1.618033988749895,
                zeta: 0.02,
                q: 0.999799979995999,
                q_defect: 0.0002000200040010003,
                load: 0.3215157844936519,
                contact: -0.19870768273666328,
                residue: -0.06388765649999399,
                contact_squared: 0.039484743178574436,
                static_residue: -0.02440291332141956,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 1.7168975872037322,
                zeta: 0.02,
                q: 0.999799979995999,
                q_defect: 0.0002000200040010003,
                load: 0.2976956241774572,
                contact: -0.2821372545060723,
                residue: -0.0839910260838993,
                contact_squared: 0.0796014303802242,
                static_residue: -0.028493388937034278,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 1.8019377358048383,
                zeta: 0.02,
                q: 0.999799979995999,
                q_defect: 0.0002000200040010003,
                load: 0.2643072815554236,
                contact: -0.32958578921362314,
                residue: -0.08711192398635158,
                contact_squared: 0.10862679245156681,
                static_residue: -0.026828602152787512,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 1.8724697412794744,
                zeta: 0.02,
                q: 0.999799979995999,
                q_defect: 0.0002000200040010003,
                load: 0.222423885431443,
                contact: -0.33500216295215196,
                residue: -0.07451248271175505,
                contact_squared: 0.11222644918262019,
                static_residue: -0.02125198092511808,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 1.9279257213917065,
                zeta: 0.02,
                q: 0.999799979995999,
                q_defect: 0.0002000200040010003,
                load: 0.1733916026187133,
                contact: -0.2976956241774572,
                residue: -0.051617921368707485,
                contact_squared: 0.08862268465440586,
                static_residue: -0.01388736712747049,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 1.9678591771972593,
                zeta: 0.02,
                q: 0.999799979995999,
                q_defect: 0.0002000200040010003,
                load: 0.11878637103073232,
                contact: -0.222423885431443,
                residue: -0.026420926180956487,
                contact_squared: 0.049472384810419684,
                static_residue: -0.006822758587192199,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 1.9919485879904781,
                zeta: 0.02,
                q: 0.999799979995999,
                q_defect: 0.0002000200040010003,
                load: 0.06036324774007196,
                contact: -0.11878637103073232,
                residue: -0.0071703311426722025,
                contact_squared: 0.014110201942650804,
                static_residue: -0.0018071032318584057,
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
            absorbs: false,
            /// undamped resonances that the load drives
            unbounded: &[],
            /// those of them in which the contact does not move
            invisible: &[],
        };
        /// Mode shapes φ of `MODES`, [mass][mode].
        const SHAPES: [[f64; 17]; 17] = transposed(&Self::MODE_SHAPES);
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
    }
    /// The functions `at`, `limits_without_search` and `limits_into`.
    ::frictiongen::kernel::scene_functions!(Tall, TallAt, f64, At);
    /// The trait `FrictionSystem`, by which generic code calls any scene.  The texts are the names of the masses.
    ::frictiongen::emitted_system!(
        Tall, TallAt, f64, ["m1", "m2", "m3", "m4", "m5", "m6", "m7", "m8", "m9", "m10",
        "m11", "m12", "m13", "m14", "m15", "m16", "m17"]
    );
    /// `Clone`, `Copy`, `Debug`, `From` and `Deref`: the answers at one frequency have all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(TallAt, At of Tall, Copy);
    impl Scene for Tall {
        /// The items that every scene has: types, constants and the calls of the frequency stage.  The word says whether a
        /// mode is damped, and the number is the number of modes that the load or the contact drives.
        ::frictiongen::kernel::scene_items!(f64, damped, 17, in passes);
        /// Components of a mass in the mode shapes.
        #[inline]
        fn shape(&self, mass: usize) -> Option<&[f64]> {
            match mass {
                2 => Some(&Self::SHAPES[2]),
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
        /// Operations: 1513: 918 ×, 306 +, 136 ÷, 85 sign, 17 exp_m1, 17 one_minus_sinc_pi, 17 scaled_sinh_defect, 17 sin_cos_pi.
        #[inline]
        fn frequency_stage(
            &self,
            inverse_r: f64,
        ) -> (ContactAt<f64>, [ModeAt<f64>; 17]) {
            let mut responses = [ModeResponse::<f64>::zero(); 17];
            let mut scale = f64::INFINITY;
            for (mode, response) in IntoIterator::into_iter(&Self::MODES)
                .zip(&mut responses)
            {
                *response = Self::damped_mode::<true>(mode, inverse_r);
                scale = Scalar::min(scale, response.size);
            }
            let mut sum = ContactAt::<f64>::zero(scale);
            let mut modes = [ModeAt::<f64>::zero(); 17];
            for ((mode, response), at) in IntoIterator::into_iter(&Self::MODES)
                .zip(&responses)
                .zip(&mut modes)
            {
                /// 1/size
                let inverse_size = 1.0 / response.size;
                /// (x² − 1)/size
                let unit_re = response.denominator.re * inverse_size;
                /// 2ζx/size
                let unit_im = response.denominator.im * inverse_size;
                /// 1/(Re² + Im²) of `unit_re`, `unit_im`
                let inverse_modulus = 1.0 / (unit_re * unit_re + unit_im * unit_im);
                /// E/size
                let scale_over_size = sum.scale * inverse_size;
                /// Re of E/(x² − 1 + 2iζx)
                let response_re = unit_re * inverse_modulus * scale_over_size;
                /// Im of E/(x² − 1 + 2iζx)
                let response_im = -(unit_im * inverse_modulus) * scale_over_size;
                /// uR²·E
                let u_scaled = response.u * scale_over_size;
                /// g·E
                let g_scaled = response.g * scale_over_size;
                *at = ModeAt {
                    x: response.x,
                    response: Complex {
                        re: response_re,
                        im: response_im,
                    },
                    u: u_scaled,
                    g: g_scaled,
                };
                sum.v.re = sum.v.re + response_re * mode.residue;
                sum.u = sum.u + mode.contact_squared * u_scaled;
                sum.h.re = sum.h.re + response_re * mode.contact_squared;
                sum.v.im = sum.v.im + response_im * mode.residue;
                sum.h.im = sum.h.im + response_im * mode.contact_squared;
                sum.g = sum.g
                    + mode.contact_squared * (g_scaled / (response.x * response.x));
                sum.reversal = sum.reversal
                    + mode.contact_squared
                        * (response.reversal * (sum.scale / response.size));
            }
            let contact = ContactAt {
                scale: sum.scale,
                v: Complex {
                    re: sum.v.re,
                    im: sum.v.im,
                },
                u: sum.u,
                g: sum.g,
                reversal: sum.reversal,
                h: Complex {
                    re: sum.h.re,
                    im: sum.h.im,
                },
            };
            (contact, modes)
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
        /// Operations: 3: 2 hypot, 1 ÷.
        #[inline]
        fn sliding_limit(&self, contact: &ContactAt<f64>) -> f64 {
            /// |V|·r²E
            let modulus_v = Scalar::hypot(contact.v.re, contact.v.im);
            /// |H|·r²E
            let modulus_h = Scalar::hypot(contact.h.re, contact.h.im);
            modulus_v / modulus_h
        }
    }
    /// Placeholders for methods that `provide` does not list: the compiler refuses a call and says what to add.
    ::frictiongen::kernel::not_provided!(
        TallAt : stuck, orbit; Tall : simulation, stepper, self_check
    );
    /// Placeholders for masses whose motion `provide` does not list: the compiler refuses a call.
    ::frictiongen::kernel::left_out!(
        TallMotion : m1, m2, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14, m15, m16,
        m17
    );
    /// The motions are those of the kernel, which sums over the modes in loops.  Worst case: a fixed number of operations
    /// for each mode.  No search is made before an amplitude or a phase is asked for.
    impl ProvidesMotion for Tall {
        type Motion = TallMotion;
    }
    /// `Clone`, `Copy`, `Debug`, `From` and `Deref`: the motion has all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(TallMotion, Continuous of Tall, Copy);
    impl TallMotion {
        /// Motion of mass `m3` (5.50 and its exact form, 7.29).
        #[must_use]
        pub fn m3(&self) -> MotionOf<Tall> {
            self.mass(2)
        }
    }
};
