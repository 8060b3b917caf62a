/// Two masses that rub on each other, both loaded, with friction that falls with the speed.
///
/// Emitted by `friction_system!` of frictiongen 0.1.0 from scene c81bd2c91e74e45a.  Change the description, not this code.
///
/// # Description
///
/// ```text
/// pub struct Bowed
/// {
///     masses: { string: 0.1, bow: 0.4 }, springs:
///     { base - string: 400.0, string - wall: 100.0, bow - wall: 30.0 }, contact:
///     string - bow, excitation: bow, damping: modal(0.02), stiction: 1.2,
///     friction: stribeck(0.05: 0.6, 0.5: 0.3), provide: [stepper], force:
///     { string }, step: 5e-4,
/// }
/// ```
///
/// The motion in the contact is the displacement of `bow` minus that of `string`.
///
/// # What it offers
///
/// * `K1`, `M1`, `NATURAL_FREQUENCIES_HZ`, `NATURAL_FREQUENCIES`, `RESONANCES`, `MODE_SHAPES`, `SCENE_HASH`: constants of the chain
/// * `frequency_ratio(omega)`, `friction_ratio(friction, load)`: r and β from units
/// * `stepper(dt)`, `stepper_from(dt, state)` and `stepper_from_image(image)` return [`BowedStepper`], the motion by steps under any [`BowedInput`], with `begin(input)`, `advance(input)`, `image()`, `contact()`, `string()` and `bow()`
/// * `declared_stepper()` returns [`BowedDeclaredStepper`], which borrows the tables of the declared step `STEP`, s
///
/// Counts of operations do not include operations whose operands are all constants, because the compiler computes them.  An expression that stands several times counts once, and an `if` as a comparison and a choice.
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
/// Stepper: motion of [`Bowed`] in time, by steps of one length, under any input.  `advance` takes a step.
///
/// A step of dt, in s, has ⌈73.54·dt⌉ parts, at most 1024: `STEP` has 1.  73.54 is the largest ω(1 + 2ζ) of a mode, in rad/s: in a part, the phase of the fastest mode advances by at most 1 rad.
/// A part in which the contact certainly keeps sliding, or keeps sticking, is a product of its state with tables.
/// In any other part the stepper searches the events, at most 8 (the friction law adds up to 64 changes of its line).
/// After these events, a contact at rest stays stuck to the end of the part, and in any other contact the friction force is constant there.  This force opposes the displacement of the contact in the part, so that it creates no energy.  `exceeded()` counts the step.
///
/// A step of `STEP` has at most 260 floating-point operations if all parts are such products, about 20148 with one event, never
/// more than 3732728.  `set_event_budget(n)` limits the events of a step to n, and `cost().most` is then the bound.
/// The numbers in its type: 2 coefficients of an input over a part, 2 modes, 1 mode with the contact stuck, 2 inputs.
#[allow(
    deprecated,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
pub struct BowedStepper(
    ::frictiongen::kernel::stepper::FixedStepper<::core::primitive::f64, 2, 2, 1, 2>,
);
/// Loads on [`Bowed`] at an instant, in the units of the scene: the input of a step.
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
pub struct BowedInput {
    /// Force on mass `bow`.
    pub force: ::core::primitive::f64,
    /// Force on mass `string`.
    pub string: ::core::primitive::f64,
    /// Kinetic friction force F at vanishing speed, not negative.  A stuck contact holds up to μF.
    pub friction: ::core::primitive::f64,
}
/// With the feature `serde` of frictiongen, serde writes and reads these fields by name.
::frictiongen::kernel::written!(BowedInput, force, string, friction);
/// Stepper of the declared step `STEP`.  It borrows its tables, which stay constants of the program, and has the methods and the costs of [`BowedStepper`].
#[allow(
    dead_code,
    deprecated,
    non_camel_case_types,
    reason = "a program may use only the other stepper, and names and attributes are those of the description"
)]
pub struct BowedDeclaredStepper(
    ::frictiongen::kernel::stepper::DeclaredStepper<::core::primitive::f64, 2, 2, 1, 2>,
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
    impl Bowed {
        /// Hash of all fields of the scene and of all names (FNV-1a, 64 bits).  Descriptions that differ only in layout, comments
        /// or attributes have the same hash.  To verify it, emit the description again.
        pub const SCENE_HASH: ::core::primitive::u64 = 0xc81b_d2c9_1e74_e45a;
        /// k₁, the stiffness of the spring `base - string`: N/m, if springs are in N/m.
        pub const K1: f64 = 400.0;
        /// m₁, the mass `string`: kg, if masses are in kg.
        pub const M1: f64 = 0.1;
        /// √(k₁/m₁), by which angular frequencies are divided: rad/s.
        const REFERENCE: f64 = 63.245553203367585;
        /// Natural frequencies in Hz, ascending, if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES_HZ: [f64; 2] = [
            1.37832223855448,
            11.253953951963826,
        ];
        /// Natural frequencies ω_i, ascending; rad/s if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES: [f64; 2] = [8.660254037844386, 70.71067811865476];
        /// Frequency ratios r of the undamped resonances, √λ_i = ω_i√(m₁/k₁).
        pub const RESONANCES: [f64; 2] = [0.13693063937629152, 1.118033988749895];
        /// Mode shapes φ, [mode][mass], with φᵀΓφ = 1 and Γ = diag(m_i/m₁).  The first component that is not 0 is positive.
        pub const MODE_SHAPES: [[f64; 2]; 2] = [[0.0, 0.5], [1.0, 0.0]];
        /// Constants of the chain.
        const CHAIN: Chain<f64> = Chain {
            /// true if a mode is damped
            damped: true,
            /// relative motion in the contact for r → 0, over the amplitude Y of the base motion, if the contact rubs on the moving base
            on_moving_base: None,
            /// m* = m₁/(effective mass of the contact)
            inverse_mass: 1.25,
            /// μ, static over kinetic friction
            stiction: 1.2,
        };
        /// Returns the frequency ratio r = ω√(m₁/k₁) of an angular frequency ω, rad/s.
        #[inline]
        #[must_use]
        pub const fn frequency_ratio(omega: f64) -> f64 {
            omega / Self::REFERENCE
        }
        /// Returns β = F/P of a kinetic friction force F.  `load` is P, the amplitude of the force.
        #[inline]
        #[must_use]
        pub const fn friction_ratio(friction: f64, load: f64) -> f64 {
            friction / load
        }
        /// φ of all modes, [mass][mode].
        const ALL_SHAPES: [[f64; 2]; 2] = transposed(&Self::MODE_SHAPES);
        /// Constants of the motion in time.
        const DYNAMICS: Dynamics<'static, f64> = Dynamics {
            /// constants of the chain
            chain: Self::CHAIN,
            /// all modes, those that the contact drives first
            modes: &[
                Mode {
                    /// kind of damping: `Undamped` for ζ = 0, `Light` for ζ < 1/2, `Heavy` for ζ < 1, `Critical` for ζ = 1, `Over` for ζ > 1
                    kind: Kind::Light,
                    /// true if the contact drives the mode: φᵀw is not 0
                    in_contact: true,
                    /// √λ, the frequency ratio r of the undamped resonance
                    resonance: 0.13693063937629152,
                    /// ζ, the modal damping ratio
                    zeta: 0.02,
                    /// √|1 − ζ²|
                    q: 0.999799979995999,
                    /// 1 − q
                    q_defect: 0.0002000200040010003,
                    /// φᵀp, with p the load on each mass over P
                    load: 0.5,
                    /// φᵀw, with w = 1 at the mass that rubs and −1 at its partner
                    contact: 0.5,
                    /// (φᵀp)(φᵀw)
                    residue: 0.25,
                    /// (φᵀw)², the term of m*
                    contact_squared: 0.25,
                    /// (φᵀp)(φᵀw)/λ
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
                    contact_squared: 1.0,
                    static_residue: 0.0,
                },
            ],
            /// modes of the chain with its contact stuck; the state of a mode is y and u = y′/Ω
            held: &[
                HeldMode {
                    /// kind of damping: `Undamped` for ζ = 0, `Light` for ζ < 1/2, `Heavy` for ζ < 1, `Critical` for ζ = 1, `Over` for ζ > 1
                    kind: Kind::Light,
                    /// |s| of the oscillator's root s, over √(k₁/m₁): without damping, the frequency ratio r of the resonance
                    frequency: 0.51478150704935,
                    /// ζ = −Re s/|s|
                    zeta: 0.01294340626805284,
                    /// √|1 − ζ²|
                    q: 0.9999162306084346,
                    /// force of the chain on the contact, with its damping force, at y = −1
                    force: 0.49263264583729127,
                    /// m₁₁, m₁₂ and m₂₂ give y = m₁₁B(η, g) + m₁₂B(η, h) and u = m₁₂B(η, g) + m₂₂B(η, h).  η is the motion of the chain's modes minus the static motion that the stuck contact causes.  g and h are the `participations` of y and u.  B(a, b) is the sum of 2ζσab + a′b + ab′ over the chain's modes, with σ = `resonance`.  g′ is −Ωh, and h′ is Ω(g − 2ζh), with Ω = `frequency` and ζ of this mode.  [m₁₁, m₁₂, m₂₂] = [B(h, h), −B(g, h), B(g, g)]/(B(g, g)B(h, h) − B(g, h)²)
                    inverse: [
                        0.050959169256267554,
                        1.5514832799238536,
                        -0.09112212607655873,
                    ],
                },
            ],
            /// displacement of a mode of the chain per unit of y and of u: for each mode of `held` in turn, one pair for each mode that the contact drives; the largest number of a held mode has the modulus 1
            participations: &[
                [-1.0, 0.016414813299717747],
                [-0.5, 0.008207406649858874],
            ],
            /// φ, mass after mass
            shapes: Self::ALL_SHAPES.as_flattened(),
            /// φᵀΓ, mode after mode
            weights: &[0.0, 2.0, 1.0, 0.0],
            /// index of the mass that rubs on a support
            rubbing: None,
        };
        /// Step, s, for which the tables are constants.
        pub const STEP: f64 = 0.0005;
        /// Constants of the stepper.
        const STEP_SCENE: StepScene<'static, f64> = StepScene {
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
            on_base: false,
            /// indices of the loaded masses
            forces: &[1, 0],
            /// interpolation of forces and friction between two samples; with `Linear` a base follows a cubic
            input: Input::Linear,
            /// points of a friction law over the speed: speed, kinetic friction over F; without points the kinetic friction is F
            law: &[[0.05, 0.6], [0.5, 0.3]],
        };
        /// Returns the tables for the step dt, s.  If dt is the declared step `STEP`, the tables are constants.
        #[inline]
        fn step_tables(dt: f64) -> Result<FixedTables<f64, 2, 2, 1, 2>, OutOfDomain> {
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
        pub fn stepper(dt: f64) -> Result<BowedStepper, OutOfDomain> {
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
        ) -> Result<BowedStepper, OutOfDomain> {
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
        pub const fn declared_stepper() -> BowedDeclaredStepper {
            BowedDeclaredStepper {
                0: DeclaredStepper::declared(
                    Self::STEP_SCENE,
                    &Self::STEP_TABLES,
                    (0.0, Self::CHAIN.stiction),
                ),
            }
        }
    }
    /// Placeholders for methods that `provide` does not list: the compiler refuses a call and says what to add.
    ::frictiongen::kernel::not_provided!(Bowed : limits, simulation, self_check);
    /// `Clone`, `Debug`, `From` and `Deref`: the stepper has all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(BowedStepper, FixedStepper of f64, 2, 2, 1, 2);
    impl BowedStepper {
        /// Sets the input at the start of the first step.  Without this call the input there is 0.
        ///
        /// # Errors
        /// Same errors as `advance`.  A call after the first step returns `OutOfDomain`.
        pub fn begin(&mut self, input: BowedInput) -> Result<(), OutOfDomain> {
            self.0
                .begin(Sample {
                    base: [0.0; 2],
                    forces: &[input.force, input.string],
                    friction: input.friction,
                })
        }
        /// Takes a step, over which the input changes linearly from the last input to this one.
        /// Returns the state of the contact and the friction force at the end of the step, and the number of events in it.  The comment on [`BowedStepper`] gives the number of operations.
        ///
        /// # Errors
        /// `OutOfDomain` for NaN, infinite numbers, negative friction, numbers whose squares overflow, and if the energies
        /// that `work()` returns would overflow.  The stepper then keeps its state.
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
        /// Absolute displacement and velocity of mass `string` now.
        #[must_use]
        pub fn string(&self) -> MassNow<f64> {
            self.mass(0)
        }
        /// Absolute displacement and velocity of mass `bow` now.
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
    /// The traits `Steps` and `Stepping`, and the functions `image` and `stepper_from_image`, which write and read the state
    /// as bytes.  `true` stands for a moving base.  The list contains the indices of the loaded masses.
    ::frictiongen::emitted_stepper!(Bowed, BowedStepper, f64, false, [1, 0]);
    /// `Clone`, `Debug`, `From` and `Deref`: the stepper has all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(
        BowedDeclaredStepper, DeclaredStepper of f64, 2, 2, 1, 2
    );
    impl BowedDeclaredStepper {
        /// Sets the input at the start of the first step.  Without this call the input there is 0.
        ///
        /// # Errors
        /// Same errors as `advance`.  A call after the first step returns `OutOfDomain`.
        pub fn begin(&mut self, input: BowedInput) -> Result<(), OutOfDomain> {
            self.0
                .begin(Sample {
                    base: [0.0; 2],
                    forces: &[input.force, input.string],
                    friction: input.friction,
                })
        }
        /// Takes a step, over which the input changes linearly from the last input to this one.
        /// Returns the state of the contact and the friction force at the end of the step, and the number of events in it.  The comment on [`BowedStepper`] gives the number of operations.
        ///
        /// # Errors
        /// `OutOfDomain` for NaN, infinite numbers, negative friction, numbers whose squares overflow, and if the energies
        /// that `work()` returns would overflow.  The stepper then keeps its state.
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
        /// Absolute displacement and velocity of mass `string` now.
        #[must_use]
        pub fn string(&self) -> MassNow<f64> {
            self.mass(0)
        }
        /// Absolute displacement and velocity of mass `bow` now.
        #[must_use]
        pub fn bow(&self) -> MassNow<f64> {
            self.mass(1)
        }
    }
    impl ::core::ops::DerefMut for BowedDeclaredStepper {
        fn deref_mut(&mut self) -> &mut Self::Target {
            &mut self.0
        }
    }
    /// The trait `Stepping` and the function `image`.  Base and loaded masses are written as above.
    ::frictiongen::emitted_stepper!(declared BowedDeclaredStepper, f64, false, [1, 0]);
    /// Tables: numbers alone, apart from the code that reads them.
    impl Bowed {
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
        /// 86 numbers; CRC-32 of their text, joined by commas: fa89fe50.
        const STEP_TABLES: FixedTables<f64, 2, 2, 1, 2> = FixedTables {
            /// how the step is divided into parts
            pace: Pace {
                /// the step, s
                step: 0.0005,
                /// number of parts of the step
                parts: 1,
                /// length of a part in the time t√(k₁/m₁)
                span: 0.03162277660168379,
                /// largest angle of an oscillator in a part, with its damping, rad
                rate: 0.03676955262170047,
                /// terms of a power series over a part
                terms: 9,
                /// wᵀ(K/k₁)⁻¹w, displacement of the contact per unit of steady force
                receptance: 14.133333333333333,
                /// damping force per unit of velocity of the contact, (Σ 2ζ(φᵀw)²/σ)/receptance
                drag: 0.007698591649105102,
            },
            /// the modes of the chain
            modes: [
                ModeStep {
                    /// Ω, angle of the undamped mode in a part, rad
                    angle: 0.004330127018922193,
                    /// ζ, the modal damping ratio
                    zeta: 0.02,
                    /// Ω/σ², rate of u per unit of modal force
                    per_force: 0.2309401076758503,
                    /// φᵀw, displacement of the contact per unit of the mode
                    contact: 0.5,
                    /// shear of u
                    turn: Row {
                        state: [-0.004329738510109456, -0.00017319008162287563],
                        drive: [0.9999102777329534, 0.4999703525411097],
                    },
                    /// the first row: both shears of y; row j > 0: weights of ∫ sʲy′ ds
                    moments: [
                        Row {
                            state: [0.0021650043922424836, 0.0021651293925158592],
                            drive: [0.0, -0.00036084459464672376],
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
                            drive: [0.0, -0.002946646488076851],
                        },
                        Row {
                            state: [-0.00041639372877589725, 0.017655491974936353],
                            drive: [0.01177739317043956, 0.0044174444610406306],
                        },
                    ],
                },
            ],
            /// the modes of the chain with its contact stuck
            held: [
                HeldStep {
                    /// Ω, angle of the oscillator in a part, rad: |s| of its root s, times `span`
                    angle: 0.016278820596099707,
                    /// ζ = −Re s/|s|
                    zeta: 0.01294340626805284,
                    /// force of the chain on the contact, with its damping force, at y = −1
                    force: 0.49263264583729127,
                    /// rates of y and u per unit velocity and acceleration of a base to which the contact sticks
                    from_base: [[0.0, 0.0], [0.0, 0.0]],
                    /// the first row: both shears of y; row j > 0: weights of ∫ sʲy′ ds
                    moments: [
                        HeldRow {
                            state: [0.008139018363340432, 0.008140161732906465],
                            drive: [
                                [1.000022083918492, 0.5000110421143524],
                                [0.0, -0.0013566043290191491],
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
                    /// the first row: shear of u; row j > 0: weights of ∫ sʲu′ ds
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
            /// rate of u of each mode divided by the input, for each input
            loads: [[0.11547005383792515, 0.0], [0.0, 0.0282842712474619]],
            /// the same for each mode of the chain with its contact stuck
            held_loads: [
                [
                    HeldLoad {
                        /// rates of y and u per unit of the input
                        drive: [-0.0004030617108639098, -0.024554754507676337],
                        /// displacement where the input acts per unit of y and of u
                        reach: [-0.5, 0.008207406649858874],
                    },
                    HeldLoad {
                        drive: [-0.0004030617108639098, -0.024554754507676337],
                        reach: [-0.5, 0.008207406649858874],
                    },
                ],
            ],
            /// coupling of each input to the contact
            channels: [
                Channel {
                    /// wᵀΓ⁻¹p, acceleration of the contact per unit of the input
                    acceleration: 0.25,
                    /// displacement where the input acts per unit of displacement of the stuck contact
                    lift: 0.9433962264150944,
                },
                Channel {
                    acceleration: -1.0,
                    lift: -0.05660377358490566,
                },
            ],
        };
    }
};
