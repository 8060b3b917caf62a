/// Two masses that rub on each other, both loaded, with friction that falls with the speed.
///
/// Emitted by frictiongen 0.1.0 from scene c81bd2c91e74e45a.
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
pub struct Bowed;
/// The motion of [`Bowed`] by steps of one length, under any input; `advance` takes a step.
///
/// A step of dt, in s, has ⌈73.54·dt⌉ parts, at most 1024: `STEP` has 1.
/// A part in which the contact certainly keeps sliding, or keeps sticking, is one product with tables.
/// Any other is followed from event to event, for at most 8 events and, where the friction law bends, 64 stretches;
/// what is left of a part after that passes without creating energy, and `exceeded` tells.
///
/// A step of `STEP` has at most 260 floating-point operations by the tables, about 20148 with one event, never
/// more than 3732728.
#[allow(deprecated, non_camel_case_types)]
pub struct BowedStepper(
    ::frictiongen::kernel::stepper::FixedStepper<::core::primitive::f64, 2, 2, 1, 2>,
);
/// What acts on [`Bowed`] at an instant, in the scene's units.
#[allow(deprecated, non_camel_case_types, non_snake_case)]
#[::core::prelude::v1::derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq,
    ::core::default::Default
)]
pub struct BowedInput {
    /// The force on mass `bow`.
    pub force: ::core::primitive::f64,
    /// The force on mass `string`.
    pub string: ::core::primitive::f64,
    /// The kinetic friction force F at vanishing speed, not negative; at rest the contact holds up to μF.
    pub friction: ::core::primitive::f64,
}
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
    impl Bowed {
        /// ω_i, the natural frequencies, ascending: rad/s if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES: [f64; 2] = [8.660254037844386, 70.71067811865476];
        /// √λ_i = ω_i√(m₁/k₁): the frequency ratios r of the undamped resonances.
        pub const RESONANCES: [f64; 2] = [0.13693063937629152, 1.118033988749895];
        /// φ, [mode][mass], with φᵀΓφ = 1 and Γ = diag(m_i/m₁); the first component of each that is not 0 is positive.
        pub const MODE_SHAPES: [[f64; 2]; 2] = [[0.0, 0.5], [1.0, 0.0]];
        /// The chain: `damped`, whether a mode is; `inverse_mass` m* = m₁/(effective mass of the contact), `stiction` μ, static over kinetic friction.
        /// `on_moving_base`: none, as the contact does not rub on a moving base.
        const CHAIN: Chain<f64> = Chain {
            damped: true,
            on_moving_base: None,
            inverse_mass: 1.25,
            stiction: 1.2,
        };
        /// An angular frequency, rad/s, as frequency ratio r = ω√(m₁/k₁).
        #[inline]
        #[must_use]
        pub const fn frequency_ratio(omega: f64) -> f64 {
            omega / 63.245553203367585
        }
        /// β = F/P of a kinetic friction force F; `load` is P, the amplitude of the force.
        #[inline]
        #[must_use]
        pub const fn friction_ratio(friction: f64, load: f64) -> f64 {
            friction / load
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
            modes: &[
                Mode {
                    kind: Kind::Light,
                    in_contact: true,
                    resonance: 0.13693063937629152,
                    zeta: 0.02,
                    q: 0.999799979995999,
                    q_defect: 0.0002000200040010003,
                    load: 0.5,
                    contact: 0.5,
                    residue: 0.25,
                    inverse_mass: 0.25,
                    static_residue: 13.333333333333334,
                },
                Mode {
                    kind: Kind::Light,
                    in_contact: true,
                    resonance: 1.118033988749895,
                    zeta: 0.02,
                    q: 0.999799979995999,
                    q_defect: 0.0002000200040010003,
                    load: 0.0,
                    contact: -1.0,
                    residue: 0.0,
                    inverse_mass: 1.0,
                    static_residue: 0.0,
                },
            ],
            held: &[
                HeldMode {
                    kind: Kind::Light,
                    frequency: 0.51478150704935,
                    zeta: 0.01294340626805284,
                    q: 0.9999162306084346,
                    force: 0.49263264583729127,
                    inverse: [
                        0.050959169256267554,
                        1.5514832799238536,
                        -0.09112212607655873,
                    ],
                },
            ],
            participations: &[
                [-1.0, 0.016414813299717747],
                [-0.5, 0.008207406649858874],
            ],
            shapes: Self::ALL_SHAPES.as_flattened(),
            weights: &[0.0, 2.0, 1.0, 0.0],
            rubbing: None,
        };
        /// The step of which the tables are constants, in s.
        pub const STEP: f64 = 0.0005;
        /// What a stepper is told of the scene: `units`: k₁, √(k₁/m₁) in rad/s and the springs to the base over k₁;
        /// `forces`: the loaded masses; `law`: Stribeck's points, speed and kinetic friction over F.
        const STEP_SCENE: StepScene<'static, f64> = StepScene {
            dynamics: Self::DYNAMICS,
            units: Units {
                stiffness: 400.0,
                rate: 63.245553203367585,
                support: 1.0,
            },
            on_base: false,
            forces: &[1, 0],
            input: Input::Linear,
            law: &[[0.05, 0.6], [0.5, 0.3]],
        };
        /// What each oscillator does over a part of `STEP`, time s counted in parts: y′ = Ωu, u′ = −Ω(y + 2ζu) + drive, with
        /// `angle` Ω.  A row has the weights of the state (y, u) and of the drive's coefficients: `moments` give ∫ sʲy′ ds, `turns`
        /// ∫ sʲu′ ds.  The first of `moments`, with [a, a′], and `turn` or the first of `turns`, with [−b, −c], are three shears:
        /// y gains a·u, u gains −b·y − c·u and its drive, y gains a′·u and its drive.
        const STEP_TABLES: FixedTables<f64, 2, 2, 1, 2> = FixedTables {
            pace: Pace {
                step: 0.0005,
                parts: 1,
                span: 0.03162277660168379,
                rate: 0.03676955262170047,
                terms: 9,
                receptance: 14.133333333333333,
                drag: 0.007698591649105102,
            },
            modes: [
                ModeStep {
                    angle: 0.004330127018922193,
                    zeta: 0.02,
                    per_force: 0.2309401076758503,
                    contact: 0.5,
                    turn: Row {
                        state: [-0.004329738510109456, -0.00017319008162287563],
                        drive: [0.9999102777329534, 0.4999703525411097],
                    },
                    moments: [
                        Row {
                            state: [0.0021650043922424836, 0.0021651293925158592],
                            drive: [3.611118645726067e-35, -0.00036084459464672376],
                        },
                        Row {
                            state: [-6.249582351444837e-6, 0.0021648033779111423],
                            drive: [0.0014432792211717643, 0.00054124031448248],
                        },
                    ],
                },
                ModeStep {
                    angle: 0.035355339059327376,
                    zeta: 0.02,
                    per_force: 0.0282842712474619,
                    contact: -1.0,
                    turn: Row {
                        state: [-0.03532299081077876, -0.0014132140336109962],
                        drive: [0.9990850533636707, 0.4997123293371841],
                    },
                    moments: [
                        Row {
                            state: [0.017675343909472015, 0.017683678457965455],
                            drive: [9.62964972193618e-34, -0.002946646488076851],
                        },
                        Row {
                            state: [-0.00041639372877589725, 0.017655491974936353],
                            drive: [0.01177739317043956, 0.0044174444610406306],
                        },
                    ],
                },
            ],
            held: [
                HeldStep {
                    angle: 0.016278820596099707,
                    zeta: 0.01294340626805284,
                    force: 0.49263264583729127,
                    from_base: [[0.0, 0.0], [0.0, 0.0]],
                    moments: [
                        HeldRow {
                            state: [0.008139018363340432, 0.008140161732906465],
                            drive: [
                                [1.000022083918492, 0.5000110421143524],
                                [-1.925929944387236e-34, -0.0013566043290191491],
                            ],
                        },
                        HeldRow {
                            state: [-8.83170354021508e-5, 0.008136584884107354],
                            drive: [
                                [0.4999668792096997, 0.33332450085904003],
                                [0.0054252723580792426, 0.002034593974716893],
                            ],
                        },
                    ],
                    turns: [
                        HeldRow {
                            state: [-0.01627467225495078, -0.0004213179977154246],
                            drive: [
                                [-0.008138087370843428, -0.002712815012764184],
                                [0.9997451694289253, 0.49991873322771657],
                            ],
                        },
                        HeldRow {
                            state: [-0.008136584884107354, -0.000298947282981149],
                            drive: [
                                [-0.0054252723580792426, -0.002034593974716893],
                                [0.49982643620120876, 0.3332718317062294],
                            ],
                        },
                    ],
                },
            ],
            loads: [[0.11547005383792515, 0.0], [0.0, 0.0282842712474619]],
            held_loads: [
                [
                    HeldLoad {
                        drive: [-0.0004030617108639098, -0.024554754507676337],
                        reach: [-0.5, 0.008207406649858874],
                    },
                    HeldLoad {
                        drive: [-0.0004030617108639098, -0.024554754507676337],
                        reach: [-0.5, 0.008207406649858874],
                    },
                ],
            ],
            channels: [
                Channel {
                    residue: 0.25,
                    lift: 0.9433962264150944,
                },
                Channel {
                    residue: -1.0,
                    lift: -0.05660377358490566,
                },
            ],
        };
        #[inline]
        fn step_tables(dt: f64) -> Result<FixedTables<f64, 2, 2, 1, 2>, OutOfDomain> {
            if dt == Self::STEP {
                return Ok(Self::STEP_TABLES);
            }
            FixedTables::new(&Self::STEP_SCENE, dt)
        }
        /// The motion by steps of dt, in s, from rest under no load.
        ///
        /// # Errors
        /// `OutOfDomain` for a step that is not positive and finite, or too long.
        #[inline]
        pub fn stepper(dt: f64) -> Result<BowedStepper, OutOfDomain> {
            let tables = Self::step_tables(dt)?;
            Stepper::new(Self::STEP_SCENE, tables, FixedStore::new(), None)
                .map(From::from)
        }
        /// The same from a state: displacement and velocity of every mass.
        ///
        /// # Errors
        /// `OutOfDomain` also for a state that is not finite.
        #[inline]
        pub fn stepper_from(
            dt: f64,
            state: (&[f64; 2], &[f64; 2]),
        ) -> Result<BowedStepper, OutOfDomain> {
            let tables = Self::step_tables(dt)?;
            let state = Some((&state.0[..], &state.1[..]));
            Stepper::new(Self::STEP_SCENE, tables, FixedStore::new(), state)
                .map(From::from)
        }
    }
    ::frictiongen::kernel::not_provided!(Bowed : limits, simulation);
    ::frictiongen::kernel::wraps!(BowedStepper, FixedStepper of f64, 2, 2, 1, 2);
    impl BowedStepper {
        /// Says what the input is before the first step; otherwise it is none.  The contact answers for it at once.
        ///
        /// # Errors
        /// `OutOfDomain` as of `advance`, and after the first step.
        pub fn begin(&mut self, input: BowedInput) -> Result<(), OutOfDomain> {
            self.0
                .begin(Sample {
                    base: [0.0; 2],
                    forces: &[input.force, input.string],
                    friction: input.friction,
                })
        }
        /// Takes a step, in a straight line from the last input to this one.
        /// [`BowedStepper`] says what it costs.
        ///
        /// # Errors
        /// `OutOfDomain` for what is NaN or infinite, for friction below zero, for numbers whose squares
        /// overflow, and before the work does: the stepper is then what it was.
        pub fn advance(
            &mut self,
            input: BowedInput,
        ) -> Result<Stepped<f64>, OutOfDomain> {
            self.0
                .advance(Sample {
                    base: [0.0; 2],
                    forces: &[input.force, input.string],
                    friction: input.friction,
                })
        }
        /// Displacement and velocity of mass `string` now.
        #[must_use]
        pub fn string(&self) -> MassNow<f64> {
            self.mass(0)
        }
        /// Displacement and velocity of mass `bow` now.
        #[must_use]
        pub fn bow(&self) -> MassNow<f64> {
            self.mass(1)
        }
    }
    impl ::core::ops::DerefMut for BowedStepper {
        fn deref_mut(&mut self) -> &mut Self::Target {
            &mut self.0
        }
    }
    ::frictiongen::emitted_stepper!(Bowed, BowedStepper, f64, false, [1, 0]);
};
