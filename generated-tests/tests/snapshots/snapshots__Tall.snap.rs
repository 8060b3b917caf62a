/// Seventeen masses: passes over the modes instead of straight lines.
///
/// Emitted by frictiongen 0.1.0 from scene fc6191d9cb991d4e.
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
pub struct Tall;
/// [`Tall`] at one frequency ratio: limits, regime, continuous motion.
#[allow(deprecated, non_camel_case_types)]
pub struct TallAt(::frictiongen::kernel::response::At<Tall>);
/// The exact continuous motion of [`Tall`] at one frequency and one friction ratio.
#[allow(deprecated, non_camel_case_types)]
pub struct TallMotion(::frictiongen::kernel::response::Continuous<Tall>);
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
    impl Tall {
        /// ω_i, the natural frequencies, ascending: rad/s if masses are in kg and springs in N/m.
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
        /// √λ_i = ω_i√(m₁/k₁): the frequency ratios r of the undamped resonances.
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
        /// φ, [mode][mass], with φᵀΓφ = 1 and Γ = diag(m_i/m₁); the first component of each that is not 0 is positive.
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
        /// The chain: `damped`, whether a mode is; `inverse_mass` m* = m₁/(effective mass of the contact), `stiction` μ, static over kinetic friction.
        /// `on_moving_base`: none, as the contact does not rub on a moving base.
        const CHAIN: Chain<f64> = Chain {
            damped: true,
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
        const MODES: [Mode<f64>; 17] = [
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 0.08972966070102985,
                zeta: 0.02,
                q: 0.999799979995999,
                q_defect: 0.0002000200040010003,
                load: 0.03030361732426425,
                contact: 0.06036324774007196,
                residue: 0.0018292247599648993,
                inverse_mass: 0.0036437216777293023,
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
                inverse_mass: 0.03006464785868579,
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
                inverse_mass: 0.06985833908321797,
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
                inverse_mass: 0.10337239967856843,
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
                inverse_mass: 0.11405567394258509,
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
                inverse_mass: 0.09663215137067799,
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
                inverse_mass: 0.05970656173431514,
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
                inverse_mass: 0.021514868465215227,
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
                inverse_mass: 0.0009183092229354483,
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
                inverse_mass: 0.008088640365607651,
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
                inverse_mass: 0.039484743178574436,
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
                inverse_mass: 0.0796014303802242,
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
                inverse_mass: 0.10862679245156681,
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
                inverse_mass: 0.11222644918262019,
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
                inverse_mass: 0.08862268465440586,
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
                inverse_mass: 0.049472384810419684,
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
                inverse_mass: 0.014110201942650804,
                static_residue: -0.0018071032318584057,
            },
        ];
        /// `ends`: β*_lim for r → 0, both limits for r → ∞; `rubbing`: the mass that rubs on a support at rest; `absorbs`:
        /// V and H may share zeros, where the holding force says what a limit is; `unbounded`: undamped resonances that
        /// the load drives, `invisible`: those that the contact does not touch.
        const NUMBERS: Numbers<'static, f64> = Numbers {
            modes: &Self::MODES,
            chain: Self::CHAIN,
            ends: Ends {
                sliding_at_rest: 0.5,
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
        pub fn at(r: f64) -> Result<TallAt, OutOfDomain> {
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
        const SHAPES: [[f64; 17]; 17] = transposed(&Self::MODE_SHAPES);
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
    }
    ::frictiongen::emitted_system!(
        Tall, TallAt, f64, ["m1", "m2", "m3", "m4", "m5", "m6", "m7", "m8", "m9", "m10",
        "m11", "m12", "m13", "m14", "m15", "m16", "m17"]
    );
    ::frictiongen::kernel::wraps!(TallAt, At of Tall, Copy);
    impl Scene for Tall {
        type Scalar = f64;
        type Decay = Damped<f64>;
        type Modes = [ModeAt<f64>; 17];
        type Waves = [Wave<f64, Damped<f64>>; 17];
        #[inline]
        fn numbers(&self) -> Numbers<'static, f64> {
            Self::NUMBERS
        }
        /// φ of a mass, by modes.
        #[inline]
        fn shape(&self, mass: usize) -> Option<&[f64]> {
            match mass {
                2 => Some(&Self::SHAPES[2]),
                _ => None,
            }
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
        /// The response and damping functions V, U, G, H of the contact (3.11, 5.20, 5.34, 5.37, 7.11, 7.12), each
        /// times r²E with the scale E that keeps them finite on a resonance, and each mode's part in them.
        /// Of each mode `response` is 1/(x² − 1 + 2iζx) and R = 1/x.  Sums over modes: V of residue·`response`; H, U, G and r²H_c of
        /// (φᵀw)² times `response`, uR², gR² and g + 2ζRu (`reversal`).
        ///
        /// Operations: 1513: 918 ×, 306 +, 136 ÷, 85 sign, 17 exp_m1, 17 one_minus_sinc_pi, 17 scaled_sinh_defect, 17 sin_cos_pi.
        #[inline]
        fn frequency_stage(
            &self,
            inverse_r: f64,
        ) -> (ContactAt<f64>, [ModeAt<f64>; 17]) {
            let mut responses = [ModeResponse::<f64>::zero(); 17];
            let mut scale = ::core::f64::INFINITY;
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
                let inverse_size = 1.0 / response.size;
                let unit_re = response.denominator.re * inverse_size;
                let unit_im = response.denominator.im * inverse_size;
                let inverse_modulus = 1.0 / (unit_re * unit_re + unit_im * unit_im);
                let scale_over_size = sum.scale * inverse_size;
                let response_re = unit_re * inverse_modulus * scale_over_size;
                let response_im = -(unit_im * inverse_modulus) * scale_over_size;
                let u_scaled = response.u * scale_over_size;
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
                sum.u = sum.u + mode.inverse_mass * u_scaled;
                sum.h.re = sum.h.re + response_re * mode.inverse_mass;
                sum.v.im = sum.v.im + response_im * mode.residue;
                sum.h.im = sum.h.im + response_im * mode.inverse_mass;
                sum.g = sum.g
                    + mode.inverse_mass * (g_scaled / (response.x * response.x));
                sum.reversal = sum.reversal
                    + mode.inverse_mass
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
        /// r²E(H_c + μm*/r²) = `reversal` + μm*E: in β_lim it ensures that the contact breaks away at once at every reversal (5.63, 7.47).
        #[inline]
        fn break_away(&self, contact: &ContactAt<f64>) -> f64 {
            contact.reversal + contact.scale
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
            modulus_v / modulus_h
        }
    }
    ::frictiongen::kernel::not_provided!(
        TallAt : stuck, orbit; Tall : simulation, stepper
    );
    ::frictiongen::kernel::left_out!(
        TallMotion : m1, m2, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14, m15, m16,
        m17
    );
    impl ProvidesMotion for Tall {
        type Motion = TallMotion;
    }
    ::frictiongen::kernel::wraps!(TallMotion, Continuous of Tall, Copy);
    impl TallMotion {
        /// The motion of mass `m3` (5.50 and its exact form, 7.29).
        #[must_use]
        pub fn m3(&self) -> MotionOf<Tall> {
            self.mass(2)
        }
    }
};
