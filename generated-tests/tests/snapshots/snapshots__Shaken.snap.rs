/// Two masses on a moving base, by steps of a millisecond: constant tables, and nothing at a frequency.
///
/// Emitted by `friction_system!` of frictiongen 0.1.0 from scene 091ff501af35821c.  Change the description, not this code.
///
/// # Description
///
/// ```text
/// pub struct Shaken
/// {
///     masses: { lower: 3.27, upper: 3.25 }, springs:
///     { base - lower: 1190.0, lower - upper: 1323.0 }, contact: upper - wall,
///     excitation: base, damping: modal[0.010, 0.012], stiction: 1.2, provide:
///     [stepper], step: 1e-3,
/// }
/// ```
///
/// The damping acts on absolute velocities (damping_from: rest, the default).
///
/// The motion in the contact is the displacement of `upper`.
///
/// # What it offers
///
/// * `K1`, `M1`, `NATURAL_FREQUENCIES_HZ`, `NATURAL_FREQUENCIES`, `RESONANCES`, `MODE_SHAPES`, `SCENE_HASH`: constants of the chain
/// * `frequency_ratio(omega)`, `friction_ratio(friction, load)`: r and β from units
/// * `stepper(dt)`, `stepper_from(dt, state)` and `stepper_from_image(image)` return [`ShakenStepper`], the motion by steps under any [`ShakenInput`], with `begin(input)`, `advance(input)`, `image()`, `contact()`, `lower()` and `upper()`
/// * `declared_stepper()` returns [`ShakenDeclaredStepper`], which borrows the tables of the declared step `STEP`, s
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
pub struct Shaken;
/// Stepper: motion of [`Shaken`] in time, by steps of one length, under any input.  `advance` takes a step.
///
/// A step of dt, in s, has ⌈32.90·dt⌉ parts, at most 1024: `STEP` has 1.  32.90 is the largest ω(1 + 2ζ) of a mode, in rad/s: in a part, the phase of the fastest mode advances by at most 1 rad.
/// A part in which the contact certainly keeps sliding, or keeps sticking, is a product of its state with tables.
/// In any other part the stepper searches the events, at most 8.
/// After these events, a contact at rest stays stuck to the end of the part, and in any other contact the friction force is constant there.  This force opposes the displacement of the contact in the part, so that it creates no energy.  `exceeded()` counts the step.
///
/// A step of `STEP` has at most 386 floating-point operations if all parts are such products, about 10634 with one event, never
/// more than 1638804.  `set_event_budget(n)` limits the events of a step to n, and `cost().most` is then the bound.
/// The numbers in its type: 4 coefficients of an input over a part, 2 modes, 1 mode with the contact stuck, 1 input.
#[allow(
    deprecated,
    non_camel_case_types,
    reason = "names and attributes are those of the description"
)]
pub struct ShakenStepper(
    ::frictiongen::kernel::stepper::FixedStepper<::core::primitive::f64, 4, 2, 1, 1>,
);
/// Loads on [`Shaken`] at an instant, in the units of the scene: the input of a step.
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
pub struct ShakenInput {
    /// Absolute displacement of the base.
    pub displacement: ::core::primitive::f64,
    /// Absolute velocity of the base, in the unit of displacement per second.
    pub velocity: ::core::primitive::f64,
    /// Kinetic friction force F, not negative.  A stuck contact holds up to μF.
    pub friction: ::core::primitive::f64,
}
/// With the feature `serde` of frictiongen, serde writes and reads these fields by name.
::frictiongen::kernel::written!(ShakenInput, displacement, velocity, friction);
/// Stepper of the declared step `STEP`.  It borrows its tables, which stay constants of the program, and has the methods and the costs of [`ShakenStepper`].
#[allow(
    dead_code,
    deprecated,
    non_camel_case_types,
    reason = "a program may use only the other stepper, and names and attributes are those of the description"
)]
pub struct ShakenDeclaredStepper(
    ::frictiongen::kernel::stepper::DeclaredStepper<::core::primitive::f64, 4, 2, 1, 1>,
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
    impl Shaken {
        /// Hash of all fields of the scene and of all names (FNV-1a, 64 bits).  Descriptions that differ only in layout, comments
        /// or attributes have the same hash.  To verify it, emit the description again.
        pub const SCENE_HASH: ::core::primitive::u64 = 0x091f_f501_af35_821c;
        /// k₁, the stiffness of the spring `base - lower`: N/m, if springs are in N/m.
        pub const K1: f64 = 1190.0;
        /// m₁, the mass `lower`: kg, if masses are in kg.
        pub const M1: f64 = 3.27;
        /// √(k₁/m₁), by which angular frequencies are divided: rad/s.
        const REFERENCE: f64 = 19.07653986153372;
        /// Natural frequencies in Hz, ascending, if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES_HZ: [f64; 2] = [
            1.9068239289554347,
            5.112902557500495,
        ];
        /// Natural frequencies ω_i, ascending; rad/s if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES: [f64; 2] = [
            11.980928093791238,
            32.12531422632804,
        ];
        /// Frequency ratios r of the undamped resonances, √λ_i = ω_i√(m₁/k₁).
        pub const RESONANCES: [f64; 2] = [0.6280451371556012, 1.6840220742078127];
        /// Mode shapes φ, [mode][mass], with φᵀΓφ = 1 and Γ = diag(m_i/m₁).  The first component that is not 0 is positive.
        pub const MODE_SHAPES: [[f64; 2]; 2] = [
            [0.5446174012864552, 0.8412612267718186],
            [0.8386846166563378, -0.5462905769681745],
        ];
        /// Constants of the chain.
        const CHAIN: Chain<f64> = Chain {
            /// true if a mode is damped
            damped: true,
            /// relative motion in the contact for r → 0, over the amplitude Y of the base motion, if the contact rubs on the moving base
            on_moving_base: None,
            /// m* = m₁/(effective mass of the contact)
            inverse_mass: 1.0061538461538462,
            /// μ, static over kinetic friction
            stiction: 1.2,
        };
        /// Returns the frequency ratio r = ω√(m₁/k₁) of an angular frequency ω, rad/s.
        #[inline]
        #[must_use]
        pub const fn frequency_ratio(omega: f64) -> f64 {
            omega / Self::REFERENCE
        }
        /// Returns β = F/(k₁Y) of a kinetic friction force F.  `load` is k₁Y, with Y the amplitude of the base motion.
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
                    resonance: 0.6280451371556012,
                    /// ζ, the modal damping ratio
                    zeta: 0.01,
                    /// √|1 − ζ²|
                    q: 0.9999499987499375,
                    /// 1 − q
                    q_defect: 5.000125006250391e-5,
                    /// φᵀp, with p the load on each mass over k₁Y
                    load: 0.5446174012864552,
                    /// φᵀw, with w = 1 at the mass that rubs and −1 at its partner
                    contact: 0.8412612267718186,
                    /// (φᵀp)(φᵀw)
                    residue: 0.4581655031275231,
                    /// (φᵀw)², the term of m*
                    contact_squared: 0.7077204516696252,
                    /// (φᵀp)(φᵀw)/λ
                    static_residue: 1.1615573893435114,
                },
                Mode {
                    kind: Kind::Light,
                    in_contact: true,
                    resonance: 1.6840220742078127,
                    zeta: 0.012,
                    q: 0.9999279974078134,
                    q_defect: 7.20025921866408e-5,
                    load: 0.8386846166563378,
                    contact: -0.5462905769681745,
                    residue: -0.4581655031275231,
                    contact_squared: 0.298433394484221,
                    static_residue: -0.16155738934351133,
                },
            ],
            /// modes of the chain with its contact stuck; the state of a mode is y and u = y′/Ω
            held: &[
                HeldMode {
                    /// kind of damping: `Undamped` for ζ = 0, `Light` for ζ < 1/2, `Heavy` for ζ < 1, `Critical` for ζ = 1, `Over` for ζ > 1
                    kind: Kind::Light,
                    /// |s| of the oscillator's root s, over √(k₁/m₁): without damping, the frequency ratio r of the resonance
                    frequency: 1.4531912144939334,
                    /// ζ = −Re s/|s|
                    zeta: 0.01106334956690814,
                    /// √|1 − ζ²|
                    q: 0.9999387992754158,
                    /// force of the chain on the contact, with its damping force, at y = −1
                    force: 1.3259697517355205,
                    /// m₁₁, m₁₂ and m₂₂ give y = m₁₁B(η, g) + m₁₂B(η, h) and u = m₁₂B(η, g) + m₂₂B(η, h).  η is the motion of the chain's modes minus the static motion that the stuck contact causes.  g and h are the `participations` of y and u.  B(a, b) is the sum of 2ζσab + a′b + ab′ over the chain's modes, with σ = `resonance`.  g′ is −Ωh, and h′ is Ω(g − 2ζh), with Ω = `frequency` and ζ of this mode.  [m₁₁, m₁₂, m₂₂] = [B(h, h), −B(g, h), B(g, g)]/(B(g, g)B(h, h) − B(g, h)²)
                    inverse: [
                        0.01603861671693582,
                        0.4832786094746962,
                        -0.026731977106591514,
                    ],
                },
            ],
            /// displacement of a mode of the chain per unit of y and of u: for each mode of `held` in turn, one pair for each mode that the contact drives; the largest number of a held mode has the modulus 1
            participations: &[
                [-0.6493709202128115, 0.010770429057713646],
                [-1.0, 0.01658594298337838],
            ],
            /// φ, mass after mass
            shapes: Self::ALL_SHAPES.as_flattened(),
            /// φᵀΓ, mode after mode
            weights: &[
                0.5446174012864552,
                0.8361158981677096,
                0.8386846166563378,
                -0.5429493501977269,
            ],
            /// index of the mass that rubs on a support
            rubbing: Some(1),
        };
        /// Step, s, for which the tables are constants.
        pub const STEP: f64 = 0.001;
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
            on_base: true,
            /// indices of the loaded masses
            forces: &[],
            /// course of the inputs during a step: constant with `Hold`; with `Linear` forces are linear, and a base follows a cubic
            input: Input::Linear,
            /// points of a friction law over the speed: speed, kinetic friction over F; without points the kinetic friction is F
            law: &[],
        };
        /// Returns the tables for the step dt, s.  If dt is the declared step `STEP`, the tables are constants.
        #[inline]
        fn step_tables(dt: f64) -> Result<FixedTables<f64, 4, 2, 1, 1>, OutOfDomain> {
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
        pub fn stepper(dt: f64) -> Result<ShakenStepper, OutOfDomain> {
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
        ) -> Result<ShakenStepper, OutOfDomain> {
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
        pub const fn declared_stepper() -> ShakenDeclaredStepper {
            ShakenDeclaredStepper {
                0: DeclaredStepper::declared(
                    Self::STEP_SCENE,
                    &Self::STEP_TABLES,
                    (0.0, Self::CHAIN.stiction),
                ),
            }
        }
    }
    /// Placeholders for methods that `provide` does not list: the compiler refuses a call and says what to add.
    ::frictiongen::kernel::not_provided!(Shaken : limits, simulation, self_check);
    /// `Clone`, `Debug`, `From` and `Deref`: the stepper has all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(ShakenStepper, FixedStepper of f64, 4, 2, 1, 1);
    impl ShakenStepper {
        /// Sets the input at the start of the first step.  Without this call the input there is 0.
        ///
        /// # Errors
        /// Same errors as `advance`.  A call after the first step returns `OutOfDomain`.
        pub fn begin(&mut self, input: ShakenInput) -> Result<(), OutOfDomain> {
            self.0
                .begin(Sample {
                    base: [input.displacement, input.velocity],
                    forces: &[],
                    friction: input.friction,
                })
        }
        /// Takes a step.  Friction changes linearly over it.  The base follows the cubic through the displacements and velocities of the last input and of this one.
        /// Returns the state of the contact and the friction force at the end of the step, and the number of events in it.  The comment on [`ShakenStepper`] gives the number of operations.
        ///
        /// # Errors
        /// `OutOfDomain` for NaN, infinite numbers, negative friction, numbers whose squares overflow, and if the energies
        /// that `work()` returns would overflow.  The stepper then keeps its state.
        pub fn advance(
            &mut self,
            input: ShakenInput,
        ) -> Result<Stepped<f64>, OutOfDomain> {
            self.0
                .advance(Sample {
                    base: [input.displacement, input.velocity],
                    forces: &[],
                    friction: input.friction,
                })
        }
        /// Absolute displacement and velocity of mass `lower` now.
        #[must_use]
        pub fn lower(&self) -> MassNow<f64> {
            self.mass(0)
        }
        /// Absolute displacement and velocity of mass `upper` now.
        #[must_use]
        pub fn upper(&self) -> MassNow<f64> {
            self.mass(1)
        }
    }
    impl ::core::ops::DerefMut for ShakenStepper {
        fn deref_mut(&mut self) -> &mut Self::Target {
            &mut self.0
        }
    }
    /// The traits `Steps` and `Stepping`, and the functions `image` and `stepper_from_image`, which write and read the state
    /// as bytes.  `true` stands for a moving base.  The list contains the indices of the loaded masses.
    ::frictiongen::emitted_stepper!(Shaken, ShakenStepper, f64, true, []);
    /// `Clone`, `Debug`, `From` and `Deref`: the stepper has all methods of the wrapped type.
    ::frictiongen::kernel::wraps!(
        ShakenDeclaredStepper, DeclaredStepper of f64, 4, 2, 1, 1
    );
    impl ShakenDeclaredStepper {
        /// Sets the input at the start of the first step.  Without this call the input there is 0.
        ///
        /// # Errors
        /// Same errors as `advance`.  A call after the first step returns `OutOfDomain`.
        pub fn begin(&mut self, input: ShakenInput) -> Result<(), OutOfDomain> {
            self.0
                .begin(Sample {
                    base: [input.displacement, input.velocity],
                    forces: &[],
                    friction: input.friction,
                })
        }
        /// Takes a step.  Friction changes linearly over it.  The base follows the cubic through the displacements and velocities of the last input and of this one.
        /// Returns the state of the contact and the friction force at the end of the step, and the number of events in it.  The comment on [`ShakenStepper`] gives the number of operations.
        ///
        /// # Errors
        /// `OutOfDomain` for NaN, infinite numbers, negative friction, numbers whose squares overflow, and if the energies
        /// that `work()` returns would overflow.  The stepper then keeps its state.
        pub fn advance(
            &mut self,
            input: ShakenInput,
        ) -> Result<Stepped<f64>, OutOfDomain> {
            self.0
                .advance(Sample {
                    base: [input.displacement, input.velocity],
                    forces: &[],
                    friction: input.friction,
                })
        }
        /// Absolute displacement and velocity of mass `lower` now.
        #[must_use]
        pub fn lower(&self) -> MassNow<f64> {
            self.mass(0)
        }
        /// Absolute displacement and velocity of mass `upper` now.
        #[must_use]
        pub fn upper(&self) -> MassNow<f64> {
            self.mass(1)
        }
    }
    impl ::core::ops::DerefMut for ShakenDeclaredStepper {
        fn deref_mut(&mut self) -> &mut Self::Target {
            &mut self.0
        }
    }
    /// The trait `Stepping` and the function `image`.  Base and loaded masses are written as above.
    ::frictiongen::emitted_stepper!(declared ShakenDeclaredStepper, f64, true, []);
    /// Tables: numbers alone, apart from the code that reads them.
    impl Shaken {
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
        /// 170 numbers; CRC-32 of their text, joined by commas: 4a7b746e.
        const STEP_TABLES: FixedTables<f64, 4, 2, 1, 1> = FixedTables {
            /// how the step is divided into parts
            pace: Pace {
                /// the step, s
                step: 0.001,
                /// number of parts of the step
                parts: 1,
                /// length of a part in the time t√(k₁/m₁)
                span: 0.019076539861533723,
                /// largest angle of an oscillator in a part, with its damping, rad
                rate: 0.03289632176775991,
                /// terms of a power series over a part
                terms: 9,
                /// wᵀ(K/k₁)⁻¹w, displacement of the contact per unit of steady force
                receptance: 1.8994708994708995,
                /// damping force per unit of velocity of the contact, (Σ 2ζ(φᵀw)²/σ)/receptance
                drag: 0.01410413805963866,
            },
            /// the modes of the chain
            modes: [
                ModeStep {
                    /// Ω, angle of the undamped mode in a part, rad
                    angle: 0.011980928093791239,
                    /// ζ, the modal damping ratio
                    zeta: 0.01,
                    /// Ω/σ², rate of u per unit of modal force
                    per_force: 0.030374472681901233,
                    /// φᵀw, displacement of the contact per unit of the mode
                    contact: 0.8412612267718186,
                    /// shear of u
                    turn: Row {
                        state: [-0.011979206189447332, -0.00023958985564112174],
                        drive: [
                            0.9998562795527669,
                            0.49995408562387184,
                            0.3333109738987084,
                            0.2499868234466716,
                        ],
                    },
                    /// the first row: both shears of y; row j > 0: weights of ∫ sʲy′ ds
                    moments: [
                        Row {
                            state: [0.0059902964634389174, 0.0059907749469114],
                            drive: [
                                0.0,
                                -0.0009984250051855111,
                                -0.0009984329799264024,
                                -0.0008985943644501107,
                            ],
                        },
                        Row {
                            state: [-4.784256009164269e-5, 0.005989292239390575],
                            drive: [
                                0.00399322654448078,
                                0.0014975083795576672,
                                0.0007986845738658952,
                                0.0004991830405481233,
                            ],
                        },
                        Row {
                            state: [-3.588164789296655e-5, 0.003992753100485772],
                            drive: [
                                0.0029948971909414222,
                                0.0011980028317100818,
                                0.0006655693583378706,
                                0.0004278707545892542,
                            ],
                        },
                        Row {
                            state: [-2.8705170974996717e-5, 0.0029945146166230653],
                            drive: [
                                0.002395905454926511,
                                0.0009983333680691712,
                                0.0005704872974473652,
                                0.00037438662126945183,
                            ],
                        },
                    ],
                },
                ModeStep {
                    angle: 0.03212531422632804,
                    zeta: 0.012,
                    per_force: 0.011327963067531397,
                    contact: -0.5462905769681745,
                    turn: Row {
                        state: [-0.03210740964769554, -0.0007707103914905889],
                        drive: [
                            0.9994426644823967,
                            0.49982853675390027,
                            0.3332518968566452,
                            0.2499528563304253,
                        ],
                    },
                    moments: [
                        Row {
                            state: [0.01606197437202761, 0.01606610301234305],
                            drive: [
                                0.0,
                                -0.0026773858084770613,
                                -0.002677454620163203,
                                -0.0024097484725885197,
                            ],
                        },
                        Row {
                            state: [-0.00034387700451624765, 0.016050260845190744],
                            drive: [
                                0.010704237850985005,
                                0.004014608609622604,
                                0.0021412647286458883,
                                0.0013383433302552167,
                            ],
                        },
                        Row {
                            state: [-0.0002578998246996775, 0.010698933945725533],
                            drive: [
                                0.00802793158325959,
                                0.0032116462228739063,
                                0.001784375796957569,
                                0.0011471471712092493,
                            ],
                        },
                        Row {
                            state: [-0.0002063155185785022, 0.008023614897916772],
                            drive: [
                                0.00642221013388308,
                                0.002676347256083441,
                                0.001529457512585131,
                                0.00100375085793752,
                            ],
                        },
                    ],
                },
            ],
            /// the modes of the chain with its contact stuck
            held: [
                HeldStep {
                    /// Ω, angle of the oscillator in a part, rad: |s| of its root s, times `span`
                    angle: 0.02772186012972412,
                    /// ζ = −Re s/|s|
                    zeta: 0.01106334956690814,
                    /// force of the chain on the contact, with its damping force, at y = −1
                    force: 1.3259697517355205,
                    /// rates of y and u per unit velocity and acceleration of a base to which the contact sticks
                    from_base: [[0.0, 0.0], [0.0, 0.0]],
                    /// the first row: both shears of y; row j > 0: weights of ∫ sʲy′ ds
                    moments: [
                        HeldRow {
                            state: [0.013860400651348838, 0.01386323497246942],
                            drive: [
                                [
                                    1.0000640467156905,
                                    0.5000320240126245,
                                    0.33335254799110636,
                                    0.2500128098868072,
                                ],
                                [
                                    0.0,
                                    -0.0023103325458940114,
                                    -0.0023103797850978452,
                                    -0.0020793688825103923,
                                ],
                            ],
                        },
                        HeldRow {
                            state: [-0.0002560885808648081, 0.013852601182606733],
                            drive: [
                                [
                                    0.4999039571203928,
                                    0.3333077205918742,
                                    0.24998932769495089,
                                    0.19999451127247025,
                                ],
                                [
                                    0.00923778489850409,
                                    0.0034645178627173393,
                                    0.0018478371465197655,
                                    0.0011549338679838113,
                                ],
                            ],
                        },
                        HeldRow {
                            state: [-0.00019206185030726252, 0.009234240379656308],
                            drive: [
                                [
                                    0.33325649978759486,
                                    0.24997865615599948,
                                    0.19999085233650557,
                                    0.16666186403884972,
                                ],
                                [
                                    0.006928173268623077,
                                    0.0027715869490339,
                                    0.0015398565536834446,
                                    0.0009899404424845277,
                                ],
                            ],
                        },
                        HeldRow {
                            state: [-0.00015364697230616441, 0.006925290370795257],
                            drive: [
                                [
                                    0.24993597250334476,
                                    0.19998170534619203,
                                    0.16665866247930267,
                                    0.14285287386090803,
                                ],
                                [
                                    0.005542448146956056,
                                    0.0023096392650284983,
                                    0.0013198720231881243,
                                    0.000866195918299186,
                                ],
                            ],
                        },
                    ],
                    /// the first row: shear of u; row j > 0: weights of ∫ sʲu′ ds
                    turns: [
                        HeldRow {
                            state: [-0.027709810176664487, -0.0006132051713344467],
                            drive: [
                                [
                                    -0.013857208994057756,
                                    -0.004619424095553665,
                                    -0.002309812465672652,
                                    -0.0013859259574586604,
                                ],
                                [
                                    0.9995653266770973,
                                    0.49986577124381654,
                                    0.3332694179926689,
                                    0.24996293050292206,
                                ],
                            ],
                        },
                        HeldRow {
                            state: [-0.013852601182606733, -0.0005626009194530948],
                            drive: [
                                [
                                    -0.00923778489850409,
                                    -0.0034645178627173393,
                                    -0.0018478371465197655,
                                    -0.0011549338679838113,
                                ],
                                [
                                    0.4996995554332807,
                                    0.3332310622474821,
                                    0.24994844115836157,
                                    0.1999689563982539,
                                ],
                            ],
                        },
                        HeldRow {
                            state: [-0.009234240379656308, -0.00039638510891725506],
                            drive: [
                                [
                                    -0.006928173268623077,
                                    -0.0027715869490339,
                                    -0.0015398565536834446,
                                    -0.0009899404424845277,
                                ],
                                [
                                    0.3331032021821331,
                                    0.249917330085455,
                                    0.19995678039383297,
                                    0.1666399599245185,
                                ],
                            ],
                        },
                        HeldRow {
                            state: [-0.006925290370795257, -0.000306880788755066],
                            drive: [
                                [
                                    -0.005542448146956056,
                                    -0.0023096392650284983,
                                    -0.0013198720231881243,
                                    -0.000866195918299186,
                                ],
                                [
                                    0.24981333642073228,
                                    0.1999306006530671,
                                    0.16662945806815044,
                                    0.14283370780443289,
                                ],
                            ],
                        },
                    ],
                },
            ],
            /// rate of u of each mode divided by the input, for each input
            loads: [[0.016542466377463476], [0.009500588362789723]],
            /// the same for each mode of the chain with its contact stuck
            held_loads: [
                [
                    HeldLoad {
                        /// rates of y and u per unit of the input
                        drive: [-0.0001824890966018129, -0.011002636195282627],
                        /// displacement where the input acts per unit of y and of u
                        reach: [-1.1923433196936333, 0.019776138317050704],
                    },
                ],
            ],
            /// coupling of each input to the contact
            channels: [
                Channel {
                    /// wᵀΓ⁻¹p, acceleration of the contact per unit of the input
                    acceleration: 0.0,
                    /// displacement where the input acts per unit of displacement of the stuck contact
                    lift: 0.5264623955431755,
                },
            ],
        };
    }
};
