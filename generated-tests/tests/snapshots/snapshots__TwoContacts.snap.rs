/// Two storeys with a brace and pads, under a force on the upper one.
///
/// Emitted by `friction_system!` of frictiongen 0.1.0 from scene 301ee3dfb1496c36.  Change the description, not this code.
///
/// # Description
///
/// ```text
/// pub struct TwoContacts {
///             masses: { lower: 2000, upper: 1500 },
///             springs: { base - lower: 1.5e6, lower - upper: 1.2e6 },
///             contacts: {
///                 brace: base - lower { stiffness: 5.0e6 },
///                 pads: lower - upper { share: 0.6, stiction: 1.2 },
///             },
///             dampers: { lower - upper: 1200.0 },
///             excitation: upper,
///             damping: modal(0.01),
///             provide: [stepper, simulation, stuck, orbit],
///         }
/// ```
///
/// # What it offers
///
/// * `stepper(dt)` returns [`TwoContactsStepper`], the motion by steps under any [`TwoContactsInput`]
/// * `simulation(r, beta)` returns [`TwoContactsSimulation`], the motion in time under a harmonic load
/// * `at(r)` returns [`TwoContactsAt`], the scene at one frequency
/// * `at(r)?.stuck()` returns [`TwoContactsStuck`], the state in which no contact slides
/// * `at(r)?.orbit(beta)` returns [`TwoContactsOrbit`], the steady state
#[::core::prelude::v1::derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::Eq,
    ::core::cmp::PartialEq,
    ::core::default::Default,
    ::core::hash::Hash
)]
pub struct TwoContacts;
/// Stepper: motion of [`TwoContacts`] in time, by steps of one length, under any input.  `advance` takes a step.
#[allow(deprecated, non_camel_case_types)]
#[::core::prelude::v1::derive(::core::clone::Clone, ::core::fmt::Debug)]
pub struct TwoContactsStepper(
    ::frictiongen::kernel::joints::Stepper<
        ::core::primitive::f64,
        ::frictiongen::kernel::joints::Fixed<2, 4, 2, 1, 6, 36, 0, 10, 0, 9, 8, 61, 4>,
        [::core::primitive::f64; 760],
    >,
);
/// Loads on [`TwoContacts`] and friction forces, in the units of the scene: the input of a step.
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
pub struct TwoContactsInput {
    /// Force on mass `upper` at the end of the step.
    pub force: ::core::primitive::f64,
    /// Kinetic friction force of each contact at the end of the step.
    pub friction: TwoContactsFriction,
}
/// With the feature `serde` of frictiongen, serde writes and reads these fields by name.
::frictiongen::kernel::written!(TwoContactsInput, force, friction);
/// Friction forces of [`TwoContacts`], by contact.
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
pub struct TwoContactsFriction {
    /// Kinetic friction force of contact `brace`, not negative.  A contact with 0 has no effect.
    pub brace: ::core::primitive::f64,
    /// Kinetic friction force of contact `pads`, not negative.  A contact with 0 has no effect.
    pub pads: ::core::primitive::f64,
}
/// With the feature `serde` of frictiongen, serde writes and reads these fields by name.
::frictiongen::kernel::written!(TwoContactsFriction, brace, pads);
/// Exact motion of [`TwoContacts`] in time under a harmonic load, from event to event.  Displacements are over P/k₁ (over Y for base motion), velocities are dx̄/dτ, and forces are over P (over k₁Y).
#[allow(deprecated, non_camel_case_types)]
#[::core::prelude::v1::derive(::core::clone::Clone, ::core::fmt::Debug)]
pub struct TwoContactsSimulation(
    ::frictiongen::kernel::joints::Simulation<
        ::core::primitive::f64,
        ::frictiongen::kernel::joints::Fixed<2, 4, 2, 1, 6, 36, 0, 10, 0, 9, 8, 61, 4>,
    >,
);
/// [`TwoContacts`] at one frequency.
#[allow(deprecated, non_camel_case_types)]
#[::core::prelude::v1::derive(::core::clone::Clone, ::core::fmt::Debug)]
pub struct TwoContactsAt(
    ::frictiongen::kernel::joints::At<
        ::core::primitive::f64,
        ::frictiongen::kernel::joints::Fixed<2, 4, 2, 1, 6, 36, 0, 10, 0, 9, 8, 61, 4>,
    >,
);
/// State of [`TwoContacts`] in which no contact slides, in closed form.  Displacements are over P/k₁ (over Y for base motion), and forces are over P (over k₁Y).
#[allow(deprecated, non_camel_case_types)]
#[::core::prelude::v1::derive(::core::clone::Clone, ::core::fmt::Debug)]
pub struct TwoContactsStuck(
    ::frictiongen::kernel::joints::StuckState<
        ::core::primitive::f64,
        ::frictiongen::kernel::joints::Fixed<2, 4, 2, 1, 6, 36, 0, 10, 0, 9, 8, 61, 4>,
    >,
);
/// Steady state of [`TwoContacts`].  Displacements are over P/k₁ (over Y for base motion), forces are over P (over k₁Y), and energies are over P²/k₁ (over k₁Y²).
#[allow(deprecated, non_camel_case_types)]
#[::core::prelude::v1::derive(::core::clone::Clone, ::core::fmt::Debug)]
pub struct TwoContactsOrbit(
    ::frictiongen::kernel::joints::Orbit<
        ::core::primitive::f64,
        ::frictiongen::kernel::joints::Fixed<2, 4, 2, 1, 6, 36, 0, 10, 0, 9, 8, 61, 4>,
    >,
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
    impl TwoContacts {
        /// Hash of all fields of the scene and of all names (FNV-1a, 64 bits).  Descriptions that differ only in layout, comments
        /// or attributes have the same hash.  To verify it, emit the description again.
        pub const SCENE_HASH: ::core::primitive::u64 = 0x301e_e3df_b149_6c36;
        /// The chain. Node numbers are those of the masses, then the wall, then the base. The level of each contact
        /// is its share. The start of a motion sets the stretch.
        const CHAIN: ::frictiongen::kernel::joints::Model<
            ::core::primitive::f64,
            ::frictiongen::kernel::joints::Fixed<
                2,
                4,
                2,
                1,
                6,
                36,
                0,
                10,
                0,
                9,
                8,
                61,
                4,
            >,
        > = ::frictiongen::kernel::joints::Model {
            size: ::frictiongen::kernel::joints::Fixed,
            masses: &[2000.0, 1500.0],
            springs: &[(0, 3, 1500000.0), (1, 0, 1200000.0)],
            dashpots: &[(1, 0, 1200.0)],
            damping: &[
                1397.2784866960274,
                -394.60058662189635,
                -394.60058662189635,
                776.6709617194668,
            ],
            damping_from_base: false,
            contacts: [
                ::frictiongen::kernel::joints::Contact {
                    plus: 0,
                    minus: 3,
                    level: ::frictiongen::kernel::joints::Wave {
                        constant: 1.0,
                        slope: 0.0,
                        amplitude: 0.0,
                        omega: 0.0,
                        phase: 0.0,
                    },
                    stiction: 1.0,
                    stiffness: ::core::option::Option::Some(5000000.0),
                    speed: 0.0,
                    stop: ::core::option::Option::None,
                },
                ::frictiongen::kernel::joints::Contact {
                    plus: 1,
                    minus: 0,
                    level: ::frictiongen::kernel::joints::Wave {
                        constant: 0.6,
                        slope: 0.0,
                        amplitude: 0.0,
                        omega: 0.0,
                        phase: 0.0,
                    },
                    stiction: 1.2,
                    stiffness: ::core::option::Option::None,
                    speed: 0.0,
                    stop: ::core::option::Option::None,
                },
            ],
            law: [],
            loads: [
                (
                    1,
                    ::frictiongen::kernel::joints::Wave {
                        constant: 0.0,
                        slope: 0.0,
                        amplitude: 0.0,
                        omega: 0.0,
                        phase: 0.0,
                    },
                ),
            ],
            base: ::frictiongen::kernel::joints::Curve {
                wave: ::frictiongen::kernel::joints::Wave {
                    constant: 0.0,
                    slope: 0.0,
                    amplitude: 0.0,
                    omega: 0.0,
                    phase: 0.0,
                },
                square: 0.0,
                cube: 0.0,
            },
            stretch: 1.0,
        };
    }
    impl TwoContacts {
        /// Creates a stepper with the step dt, s, for a chain at rest without load.  Every friction force is 0.
        ///
        /// # Errors
        /// `OutOfDomain` for a step that is not positive and finite, or too long.
        pub fn stepper(
            dt: ::core::primitive::f64,
        ) -> ::core::result::Result<TwoContactsStepper, ::frictiongen::OutOfDomain> {
            Self::stepper_from(dt, (&[0.0; 2], &[0.0; 2]))
        }
        /// Creates a stepper that starts from a state: displacements and velocities of all masses, in the order of the
        /// description.
        ///
        /// # Errors
        /// `OutOfDomain` also for a state that is not finite.
        pub fn stepper_from(
            dt: ::core::primitive::f64,
            (x, v): (&[::core::primitive::f64; 2], &[::core::primitive::f64; 2]),
        ) -> ::core::result::Result<TwoContactsStepper, ::frictiongen::OutOfDomain> {
            let started = ::frictiongen::kernel::joints::Stepper::from_state(
                Self::CHAIN,
                (dt, ::frictiongen::kernel::stepper::Input::Linear, false),
                [0.0; 760],
                (x, v),
            );
            started.map(TwoContactsStepper)
        }
        /// Creates a stepper from the bytes of an image.  The stepper has the step and the state of the stepper that wrote the
        /// image.
        ///
        /// # Errors
        /// `OutOfDomain` for an image of another scene or version, and for an image of which a bit has changed.
        pub fn stepper_from_image(
            bytes: &[::core::primitive::u8],
        ) -> ::core::result::Result<TwoContactsStepper, ::frictiongen::OutOfDomain> {
            let mut stepper = Self::stepper(
                ::frictiongen::kernel::joints::image_step(bytes, 2)?,
            )?;
            stepper.0.restore_image(bytes)?;
            ::core::result::Result::Ok(stepper)
        }
    }
    impl TwoContactsStepper {
        /// Sets the input at the start of the first step.  Without this call the input there is 0.
        ///
        /// # Errors
        /// Same errors as `advance`.  A call after the first step returns `OutOfDomain`.
        pub fn begin(
            &mut self,
            input: TwoContactsInput,
        ) -> ::core::result::Result<(), ::frictiongen::OutOfDomain> {
            self.0
                .begin(::frictiongen::kernel::joints::Sample {
                    base: [0.0; 2],
                    forces: &[input.force],
                    frictions: &[input.friction.brace, input.friction.pads],
                })
        }
        /// Takes a step.  Returns the number of its events.
        ///
        /// # Errors
        /// `OutOfDomain` for a force or a base motion that is not finite, for a friction force that is negative or not finite, and if
        /// the motion exceeds the range of numbers.  The stepper then keeps its state.
        pub fn advance(
            &mut self,
            input: TwoContactsInput,
        ) -> ::core::result::Result<
            ::frictiongen::kernel::joints::Stepped,
            ::frictiongen::OutOfDomain,
        > {
            self.0
                .advance(::frictiongen::kernel::joints::Sample {
                    base: [0.0; 2],
                    forces: &[input.force],
                    frictions: &[input.friction.brace, input.friction.pads],
                })
        }
        /// Length of an image of the stepper's state, in bytes.
        pub const IMAGE: ::core::primitive::usize = ::frictiongen::kernel::joints::image_bytes(
            ::core::mem::size_of::<::core::primitive::f64>(),
            2,
            2,
            1,
        );
        /// Returns the state as bytes, for a file or for flash memory.  `stepper_from_image` continues from these bytes.  The
        /// bytes contain a hash of the scene and of the step, a version and a checksum.
        #[must_use]
        pub fn image(&self) -> [::core::primitive::u8; Self::IMAGE] {
            let mut bytes = [0; Self::IMAGE];
            self.0.write_image(&mut bytes);
            bytes
        }
        /// Displacement and velocity of mass `lower` at the end of the last step.
        #[must_use]
        pub fn lower(
            &self,
        ) -> ::frictiongen::kernel::joints::MassState<::core::primitive::f64> {
            self.0.mass(0)
        }
        /// Displacement and velocity of mass `upper` at the end of the last step.
        #[must_use]
        pub fn upper(
            &self,
        ) -> ::frictiongen::kernel::joints::MassState<::core::primitive::f64> {
            self.0.mass(1)
        }
        /// Motion and force of contact `brace` at the end of the last step.
        #[must_use]
        pub fn brace(
            &self,
        ) -> ::frictiongen::kernel::joints::ContactState<::core::primitive::f64> {
            self.0.contact(0)
        }
        /// Motion and force of contact `pads` at the end of the last step.
        #[must_use]
        pub fn pads(
            &self,
        ) -> ::frictiongen::kernel::joints::ContactState<::core::primitive::f64> {
            self.0.contact(1)
        }
    }
    impl ::core::ops::Deref for TwoContactsStepper {
        type Target = ::frictiongen::kernel::joints::Stepper<
            ::core::primitive::f64,
            ::frictiongen::kernel::joints::Fixed<
                2,
                4,
                2,
                1,
                6,
                36,
                0,
                10,
                0,
                9,
                8,
                61,
                4,
            >,
            [::core::primitive::f64; 760],
        >;
        fn deref(&self) -> &Self::Target {
            &self.0
        }
    }
    impl ::core::ops::DerefMut for TwoContactsStepper {
        fn deref_mut(&mut self) -> &mut Self::Target {
            &mut self.0
        }
    }
    impl TwoContacts {
        /// √(k₁/m₁), k₁, and the kind of the load.
        const REFERENCE: ::frictiongen::kernel::joints::Reference<
            ::core::primitive::f64,
        > = ::frictiongen::kernel::joints::Reference {
            rate: 27.386127875258307,
            stiffness: 1500000.0,
            on_base: false,
        };
    }
    impl TwoContacts {
        /// Starts the exact motion in time from rest, at a maximum of the excitation.  β is the common friction: the
        /// friction of each contact is its share of it.
        ///
        /// # Errors
        /// `OutOfDomain` unless r is positive and finite, and β finite and not negative.
        pub fn simulation(
            r: ::core::primitive::f64,
            beta: ::core::primitive::f64,
        ) -> ::core::result::Result<TwoContactsSimulation, ::frictiongen::OutOfDomain> {
            ::frictiongen::kernel::joints::Simulation::new(
                    Self::CHAIN,
                    Self::REFERENCE,
                    (r, beta),
                    ::core::option::Option::None,
                )
                .map(TwoContactsSimulation)
        }
        /// Starts from a state at a maximum of the excitation: x̄ and dx̄/dτ of every mass.
        ///
        /// # Errors
        /// `OutOfDomain` also for a state that is not finite.
        pub fn simulation_from(
            r: ::core::primitive::f64,
            beta: ::core::primitive::f64,
            state: (&[::core::primitive::f64; 2], &[::core::primitive::f64; 2]),
        ) -> ::core::result::Result<TwoContactsSimulation, ::frictiongen::OutOfDomain> {
            ::frictiongen::kernel::joints::Simulation::new(
                    Self::CHAIN,
                    Self::REFERENCE,
                    (r, beta),
                    ::core::option::Option::Some((&state.0[..], &state.1[..])),
                )
                .map(TwoContactsSimulation)
        }
    }
    impl TwoContactsSimulation {
        /// Advances by `reach` in the phase τ, and returns the number of events on the way.
        ///
        /// # Errors
        /// `OutOfDomain` for a reach that is negative or not finite, and if the motion exceeds a bound.
        pub fn advance(
            &mut self,
            reach: ::core::primitive::f64,
        ) -> ::core::result::Result<::core::primitive::u32, ::frictiongen::OutOfDomain> {
            self.0.advance(reach)
        }
        /// Displacement and velocity of mass `lower` now.
        #[must_use]
        pub fn lower(
            &self,
        ) -> ::frictiongen::kernel::joints::MassState<::core::primitive::f64> {
            self.0.mass(0)
        }
        /// Displacement and velocity of mass `upper` now.
        #[must_use]
        pub fn upper(
            &self,
        ) -> ::frictiongen::kernel::joints::MassState<::core::primitive::f64> {
            self.0.mass(1)
        }
        /// Motion and force of contact `brace` now.
        #[must_use]
        pub fn brace(
            &self,
        ) -> ::frictiongen::kernel::joints::ContactState<::core::primitive::f64> {
            self.0.contact(0)
        }
        /// Motion and force of contact `pads` now.
        #[must_use]
        pub fn pads(
            &self,
        ) -> ::frictiongen::kernel::joints::ContactState<::core::primitive::f64> {
            self.0.contact(1)
        }
    }
    impl ::core::ops::Deref for TwoContactsSimulation {
        type Target = ::frictiongen::kernel::joints::Simulation<
            ::core::primitive::f64,
            ::frictiongen::kernel::joints::Fixed<
                2,
                4,
                2,
                1,
                6,
                36,
                0,
                10,
                0,
                9,
                8,
                61,
                4,
            >,
        >;
        fn deref(&self) -> &Self::Target {
            &self.0
        }
    }
    impl TwoContacts {
        /// Evaluates the scene at the frequency ratio r = ω√(m₁/k₁).
        ///
        /// # Errors
        /// `OutOfDomain` unless r is positive and finite.
        pub fn at(
            r: ::core::primitive::f64,
        ) -> ::core::result::Result<TwoContactsAt, ::frictiongen::OutOfDomain> {
            ::frictiongen::kernel::joints::At::new(
                    Self::CHAIN,
                    Self::REFERENCE,
                    r,
                    &["brace", "pads"],
                )
                .map(TwoContactsAt)
        }
    }
    impl ::core::ops::Deref for TwoContactsAt {
        type Target = ::frictiongen::kernel::joints::At<
            ::core::primitive::f64,
            ::frictiongen::kernel::joints::Fixed<
                2,
                4,
                2,
                1,
                6,
                36,
                0,
                10,
                0,
                9,
                8,
                61,
                4,
            >,
        >;
        fn deref(&self) -> &Self::Target {
            &self.0
        }
    }
    impl TwoContactsAt {
        /// Returns the state in which no contact slides, the common friction from which it exists (`limit`), and
        /// the contact that slides first below it (`first`).  No earlier motion has left a force in a contact.
        ///
        /// # Errors
        /// `StuckResonance` on an undamped resonance of the chain with its contacts stuck.
        pub fn stuck(
            &self,
        ) -> ::core::result::Result<TwoContactsStuck, ::frictiongen::StuckResonance> {
            self.0.stuck().map(TwoContactsStuck)
        }
    }
    impl TwoContactsStuck {
        /// Complex amplitude X of mass `lower`.  Its motion is x̄ = Re X exp(iτ).
        #[must_use]
        pub fn lower(&self) -> ::frictiongen::Complex<::core::primitive::f64> {
            self.0.mass(0)
        }
        /// Complex amplitude X of mass `upper`.  Its motion is x̄ = Re X exp(iτ).
        #[must_use]
        pub fn upper(&self) -> ::frictiongen::Complex<::core::primitive::f64> {
            self.0.mass(1)
        }
        /// Amplitude of the force of contact `brace`.
        #[must_use]
        pub fn brace(&self) -> ::core::primitive::f64 {
            self.0.contact(0)
        }
        /// Amplitude of the force of contact `pads`.
        #[must_use]
        pub fn pads(&self) -> ::core::primitive::f64 {
            self.0.contact(1)
        }
    }
    impl ::core::ops::Deref for TwoContactsStuck {
        type Target = ::frictiongen::kernel::joints::StuckState<
            ::core::primitive::f64,
            ::frictiongen::kernel::joints::Fixed<
                2,
                4,
                2,
                1,
                6,
                36,
                0,
                10,
                0,
                9,
                8,
                61,
                4,
            >,
        >;
        fn deref(&self) -> &Self::Target {
            &self.0
        }
    }
    impl TwoContactsAt {
        /// Returns the steady state that the motion from rest reaches.  β is the common friction: the friction of
        /// each contact is its share of it.
        ///
        /// # Errors
        /// `NoOrbit::OutOfDomain` for a β that is negative or not finite, and if the motion exceeds a bound.
        /// `NoOrbit::Unsettled` if the motion does not settle on a period of at most 64 cycles.
        pub fn orbit(
            &self,
            beta: ::core::primitive::f64,
        ) -> ::core::result::Result<TwoContactsOrbit, ::frictiongen::NoOrbit> {
            self.0.orbit(beta, ::core::option::Option::None).map(TwoContactsOrbit)
        }
        /// Returns the steady state that the motion from a state reaches.  The state is x̄ and dx̄/dτ of every mass
        /// at a maximum of the excitation.
        ///
        /// # Errors
        /// Those of `orbit`, also for a state that is not finite.
        pub fn orbit_from(
            &self,
            beta: ::core::primitive::f64,
            state: (&[::core::primitive::f64; 2], &[::core::primitive::f64; 2]),
        ) -> ::core::result::Result<TwoContactsOrbit, ::frictiongen::NoOrbit> {
            let state = (&state.0[..], &state.1[..]);
            self.0.orbit(beta, ::core::option::Option::Some(state)).map(TwoContactsOrbit)
        }
    }
    impl TwoContactsOrbit {
        /// Motion of mass `lower` over the period.
        #[must_use]
        pub fn lower(
            &self,
        ) -> ::frictiongen::kernel::joints::MassOrbit<
            '_,
            ::core::primitive::f64,
            ::frictiongen::kernel::joints::Fixed<
                2,
                4,
                2,
                1,
                6,
                36,
                0,
                10,
                0,
                9,
                8,
                61,
                4,
            >,
        > {
            self.0.mass(0)
        }
        /// Motion of mass `upper` over the period.
        #[must_use]
        pub fn upper(
            &self,
        ) -> ::frictiongen::kernel::joints::MassOrbit<
            '_,
            ::core::primitive::f64,
            ::frictiongen::kernel::joints::Fixed<
                2,
                4,
                2,
                1,
                6,
                36,
                0,
                10,
                0,
                9,
                8,
                61,
                4,
            >,
        > {
            self.0.mass(1)
        }
        /// Motion of contact `brace` over the period.
        #[must_use]
        pub fn brace(
            &self,
        ) -> ::frictiongen::kernel::joints::ContactOrbit<
            '_,
            ::core::primitive::f64,
            ::frictiongen::kernel::joints::Fixed<
                2,
                4,
                2,
                1,
                6,
                36,
                0,
                10,
                0,
                9,
                8,
                61,
                4,
            >,
        > {
            self.0.contact(0)
        }
        /// Motion of contact `pads` over the period.
        #[must_use]
        pub fn pads(
            &self,
        ) -> ::frictiongen::kernel::joints::ContactOrbit<
            '_,
            ::core::primitive::f64,
            ::frictiongen::kernel::joints::Fixed<
                2,
                4,
                2,
                1,
                6,
                36,
                0,
                10,
                0,
                9,
                8,
                61,
                4,
            >,
        > {
            self.0.contact(1)
        }
    }
    impl ::core::ops::Deref for TwoContactsOrbit {
        type Target = ::frictiongen::kernel::joints::Orbit<
            ::core::primitive::f64,
            ::frictiongen::kernel::joints::Fixed<
                2,
                4,
                2,
                1,
                6,
                36,
                0,
                10,
                0,
                9,
                8,
                61,
                4,
            >,
        >;
        fn deref(&self) -> &Self::Target {
            &self.0
        }
    }
};
