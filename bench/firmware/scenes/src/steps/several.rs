//! Steppers of scenes with several contacts, and of a scene with one contact and a dashpot.

use super::{Cost, Machine, Outcome};

macro_rules! machine {
    ($module:ident $name:literal $on_base:literal |$load:ident, $friction:ident| { $($field:ident: $value:expr),* }
        $forces:ident { $($scene:tt)* }) => {
        #[doc = concat!("Steps of ", $name, ".")]
        pub mod $module {
            use super::*;

            frictiongen::friction_system! {
                /// A chain.
                pub struct Chain {
                    masses: { m1: 3.25, m2: 3.25 },
                    springs: { base - m1: 1323.0, m1 - m2: 1323.0 },
                    $($scene)*
                    scalar: f32,
                    step: 1e-3,
                    provide: [stepper],
                }
            }

            /// The stepper of the chain.
            pub struct Run(ChainStepper);

            /// Creates a stepper at rest.
            #[inline(never)]
            #[cfg_attr(feature = "prove", no_panic::no_panic)]
            pub fn start() -> Option<Run> {
                Chain::stepper(Chain::STEP).ok().map(Run)
            }

            /// Creates a stepper at rest whose tables are constants.
            #[inline(never)]
            #[cfg_attr(feature = "prove", no_panic::no_panic)]
            pub fn start_declared() {
                core::hint::black_box(&Chain::declared_stepper());
            }

            /// Returns the length of a step, in s.
            #[inline(never)]
            #[cfg_attr(feature = "prove", no_panic::no_panic)]
            pub fn time(run: &Run) -> f32 {
                run.0.dt()
            }

            /// Advances the stepper by one step.
            #[inline(never)]
            #[cfg_attr(feature = "prove", no_panic::no_panic)]
            pub fn advance(run: &mut Run, $load: [f32; 2], $friction: f32) -> Option<Outcome> {
                let stepped = run.0.advance(ChainInput { $($field: $value),* }).ok()?;
                Some(Outcome {
                    sticks: run.0.motion().state().phases.contains(&0),
                    events: stepped.events,
                    exceeded: stepped.exceeded,
                })
            }

            /// Reads the masses, with one call for each mass.
            #[inline(never)]
            #[cfg_attr(feature = "prove", no_panic::no_panic)]
            pub fn each(run: &Run) {
                core::hint::black_box(&run.0.m1());
                core::hint::black_box(&run.0.m2());
            }

            impl Machine for Run {
                type Scalar = f32;
                const NAME: &'static str = $name;
                const ON_BASE: bool = $on_base;

                fn start() -> Option<Self> {
                    start()
                }

                fn advance(&mut self, load: [f32; 2], friction: f32) -> Option<Outcome> {
                    advance(self, load, friction)
                }

                const INSTRUCTIONS: u64 = 8;
                const DECLARED: Option<usize> = Some(core::mem::size_of::<ChainDeclaredStepper>());

                fn cost(&self) -> Option<Cost> {
                    Some(self.0.cost())
                }

                fn set_budget(&mut self, events: u8) -> Option<()> {
                    self.0.set_event_budget(events);
                    Some(())
                }

                fn start_declared() -> Option<()> {
                    start_declared();
                    Some(())
                }

                fn read_each(&self) {
                    each(self);
                }

                fn bits(&self) -> [u64; 3] {
                    let mass = self.0.m2();
                    let values = [mass.displacement(), mass.velocity(), self.0.$forces().force()];
                    values.map(|value| u64::from(value.to_bits()))
                }
            }
        }
    };
}

// The scene of `machines::two_base`. Its dashpot makes it a scene for the stepper of several contacts.
machine! {
    one_dashpot "2 masses f32, a contact and a dashpot, damped, on a moving base, linear" true
    |load, friction| { displacement: load[0], velocity: load[1], friction: friction }
    contact {
        contact: m2 - base,
        dampers: { m1 - m2: 0.01 },
        excitation: base,
        damping: modal(0.02),
        input: linear,
    }
}

machine! {
    two_contacts "2 masses f32, two contacts, undamped, force held" false
    |load, friction| { force: load[0], friction: ChainFriction { brace: friction, pads: 0.6 * friction } }
    pads {
        contacts: {
            brace: base - m1 { stiffness: 1.0e4 },
            pads: m1 - m2 { stiction: 1.2 },
        },
        excitation: m1,
        input: hold,
    }
}

machine! {
    two_rigid "2 masses f32, two rigid contacts, undamped, force held" false
    |load, friction| { force: load[0], friction: ChainFriction { brace: friction, pads: 0.6 * friction } }
    pads {
        contacts: { brace: base - m1, pads: m1 - m2 },
        excitation: m1,
        input: hold,
    }
}

machine! {
    elastic_contacts "2 masses f32, two elastic contacts, undamped, force held" false
    |load, friction| { force: load[0], friction: ChainFriction { brace: friction, pads: 0.6 * friction } }
    pads {
        contacts: {
            brace: base - m1 { stiffness: 1.0e4 },
            pads: m1 - m2 { stiffness: 5.0e3 },
        },
        excitation: m1,
        input: hold,
    }
}

machine! {
    three_contacts "2 masses f32, three contacts, undamped, force held" false
    |load, friction| { force: load[0], friction: ChainFriction { brace: friction, pads: 0.6 * friction, top: 0.4 * friction } }
    pads {
        contacts: {
            brace: base - m1 { stiffness: 1.0e4 },
            pads: m1 - m2 { stiction: 1.2 },
            top: m2 - wall,
        },
        excitation: m1,
        input: hold,
    }
}
