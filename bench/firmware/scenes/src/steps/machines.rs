//! Scenes with a stepper: chains of equal masses, of which the last mass rubs.

pub use super::several::{elastic_contacts, one_dashpot, three_contacts, two_contacts, two_rigid};
use super::{Machine, Outcome};
use frictiongen::kernel::simulation::Contact;
use frictiongen::kernel::stepper::Cost;

macro_rules! machine {
    ($module:ident $name:literal $scalar:ident $on_base:literal $last:ident
        |$load:ident, $friction:ident| { $($field:ident: $value:expr),* }
        $($scene:tt)*) => {
        #[doc = concat!("Steps of ", $name, ".")]
        pub mod $module {
            use super::*;

            frictiongen::friction_system! {
                /// A chain.
                pub struct Chain {
                    $($scene)*
                    scalar: $scalar,
                    provide: [stepper],
                    step: 1e-3,
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

            /// Creates a stepper at rest that borrows its constant tables.
            #[inline(never)]
            #[cfg_attr(feature = "prove", no_panic::no_panic)]
            pub fn start_declared() {
                core::hint::black_box(&Chain::declared_stepper());
            }

            /// Reads displacement and velocity of the masses, with one call for each mass.
            #[inline(never)]
            #[cfg_attr(feature = "prove", no_panic::no_panic)]
            pub fn each(run: &Run) {
                for index in 0..Chain::NATURAL_FREQUENCIES.len() {
                    core::hint::black_box(&run.0.mass(index));
                }
            }

            /// Reads all masses in one call.
            #[inline(never)]
            #[cfg_attr(feature = "prove", no_panic::no_panic)]
            pub fn all(run: &Run) {
                core::hint::black_box(&run.0.all_masses());
            }

            /// Returns the time since the start, in s.
            #[inline(never)]
            #[cfg_attr(feature = "prove", no_panic::no_panic)]
            pub fn time(run: &Run) -> $scalar {
                run.0.time()
            }

            /// Advances the stepper by one step.
            #[inline(never)]
            #[cfg_attr(feature = "prove", no_panic::no_panic)]
            pub fn advance(run: &mut Run, $load: [$scalar; 2], $friction: $scalar) -> Option<Outcome> {
                let stepped = run.0.advance(ChainInput { $($field: $value),* }).ok()?;
                Some(Outcome {
                    sticks: stepped.contact == Contact::Stuck,
                    events: stepped.events,
                    exceeded: stepped.exceeded,
                })
            }

            impl Machine for Run {
                type Scalar = $scalar;
                const NAME: &'static str = $name;
                const ON_BASE: bool = $on_base;

                fn start() -> Option<Self> {
                    start()
                }

                fn advance(&mut self, load: [$scalar; 2], friction: $scalar) -> Option<Outcome> {
                    advance(self, load, friction)
                }

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

                fn read_all(&self) -> Option<()> {
                    all(self);
                    Some(())
                }

                fn bits(&self) -> [u64; 3] {
                    let mass = self.0.$last();
                    let values = [mass.displacement(), mass.velocity(), self.0.work().load];
                    values.map(|value| u64::from(value.to_bits()))
                }
            }
        }
    };
}

machine! {
    one_force "1 mass f32, undamped, force held" f32 false m1 |load, friction| { force: load[0], friction: friction }
    masses: { m1: 3.25 },
    springs: { base - m1: 1323.0 },
    contact: m1 - wall,
    excitation: m1,
    input: hold,
}

machine! {
    one_base "1 mass f32, damped, on a moving base, linear" f32 true m1 |load, friction| { displacement: load[0], velocity: load[1], friction: friction }
    masses: { m1: 3.25 },
    springs: { base - m1: 1323.0 },
    contact: m1 - base,
    excitation: base,
    damping: modal(0.02),
    input: linear,
}

machine! {
    two_force "2 masses f32, undamped, force held" f32 false m2 |load, friction| { force: load[0], friction: friction }
    masses: { m1: 3.25, m2: 3.25 },
    springs: { base - m1: 1323.0, m1 - m2: 1323.0 },
    contact: m2 - wall,
    excitation: m1,
    input: hold,
}

machine! {
    two_base "2 masses f32, damped, on a moving base, linear" f32 true m2 |load, friction| { displacement: load[0], velocity: load[1], friction: friction }
    masses: { m1: 3.25, m2: 3.25 },
    springs: { base - m1: 1323.0, m1 - m2: 1323.0 },
    contact: m2 - base,
    excitation: base,
    damping: modal(0.02),
    input: linear,
}

machine! {
    five_force "5 masses f32, undamped, force held" f32 false m5 |load, friction| { force: load[0], friction: friction }
    masses: { m1: 3.25, m2: 3.25, m3: 3.25, m4: 3.25, m5: 3.25 },
    springs: { base - m1: 1323.0, m1 - m2: 1323.0, m2 - m3: 1323.0, m3 - m4: 1323.0, m4 - m5: 1323.0 },
    contact: m5 - wall,
    excitation: m1,
    input: hold,
}

machine! {
    five_base "5 masses f32, damped, on a moving base, linear" f32 true m5 |load, friction| { displacement: load[0], velocity: load[1], friction: friction }
    masses: { m1: 3.25, m2: 3.25, m3: 3.25, m4: 3.25, m5: 3.25 },
    springs: { base - m1: 1323.0, m1 - m2: 1323.0, m2 - m3: 1323.0, m3 - m4: 1323.0, m4 - m5: 1323.0 },
    contact: m5 - base,
    excitation: base,
    damping: modal(0.02),
    input: linear,
}

machine! {
    ten_force "10 masses f32, undamped, force held" f32 false m10 |load, friction| { force: load[0], friction: friction }
    masses: { m1: 3.25, m2: 3.25, m3: 3.25, m4: 3.25, m5: 3.25, m6: 3.25, m7: 3.25, m8: 3.25, m9: 3.25, m10: 3.25 },
    springs: { base - m1: 1323.0, m1 - m2: 1323.0, m2 - m3: 1323.0, m3 - m4: 1323.0, m4 - m5: 1323.0, m5 - m6: 1323.0, m6 - m7: 1323.0, m7 - m8: 1323.0, m8 - m9: 1323.0, m9 - m10: 1323.0 },
    contact: m10 - wall,
    excitation: m1,
    input: hold,
}

machine! {
    ten_base "10 masses f32, damped, on a moving base, linear" f32 true m10 |load, friction| { displacement: load[0], velocity: load[1], friction: friction }
    masses: { m1: 3.25, m2: 3.25, m3: 3.25, m4: 3.25, m5: 3.25, m6: 3.25, m7: 3.25, m8: 3.25, m9: 3.25, m10: 3.25 },
    springs: { base - m1: 1323.0, m1 - m2: 1323.0, m2 - m3: 1323.0, m3 - m4: 1323.0, m4 - m5: 1323.0, m5 - m6: 1323.0, m6 - m7: 1323.0, m7 - m8: 1323.0, m8 - m9: 1323.0, m9 - m10: 1323.0 },
    contact: m10 - base,
    excitation: base,
    damping: modal(0.02),
    input: linear,
}

machine! {
    one_elastic "1 mass f32, undamped, elastic contact, force held" f32 false m1 |load, friction| { force: load[0], friction: friction }
    masses: { m1: 3.25 },
    springs: { base - m1: 1323.0 },
    contact: m1 - wall,
    stiffness: 1.0e4,
    excitation: m1,
    input: hold,
}

machine! {
    two_elastic "2 masses f32, damped, elastic contact, on a moving base, linear" f32 true m2 |load, friction| { displacement: load[0], velocity: load[1], friction: friction }
    masses: { m1: 3.25, m2: 3.25 },
    springs: { base - m1: 1323.0, m1 - m2: 1323.0 },
    contact: m2 - wall,
    stiffness: 1.0e4,
    excitation: base,
    damping: modal(0.02),
    input: linear,
}

machine! {
    five_elastic "5 masses f32, damped, elastic contact, on a moving base, linear" f32 true m5 |load, friction| { displacement: load[0], velocity: load[1], friction: friction }
    masses: { m1: 3.25, m2: 3.25, m3: 3.25, m4: 3.25, m5: 3.25 },
    springs: { base - m1: 1323.0, m1 - m2: 1323.0, m2 - m3: 1323.0, m3 - m4: 1323.0, m4 - m5: 1323.0 },
    contact: m5 - wall,
    stiffness: 1.0e4,
    excitation: base,
    damping: modal(0.02),
    input: linear,
}

machine! {
    one_force_double "1 mass f64, undamped, force held" f64 false m1 |load, friction| { force: load[0], friction: friction }
    masses: { m1: 3.25 },
    springs: { base - m1: 1323.0 },
    contact: m1 - wall,
    excitation: m1,
    input: hold,
}

machine! {
    one_base_double "1 mass f64, damped, on a moving base, linear" f64 true m1 |load, friction| { displacement: load[0], velocity: load[1], friction: friction }
    masses: { m1: 3.25 },
    springs: { base - m1: 1323.0 },
    contact: m1 - base,
    excitation: base,
    damping: modal(0.02),
    input: linear,
}

machine! {
    two_force_double "2 masses f64, undamped, force held" f64 false m2 |load, friction| { force: load[0], friction: friction }
    masses: { m1: 3.25, m2: 3.25 },
    springs: { base - m1: 1323.0, m1 - m2: 1323.0 },
    contact: m2 - wall,
    excitation: m1,
    input: hold,
}

machine! {
    two_base_double "2 masses f64, damped, on a moving base, linear" f64 true m2 |load, friction| { displacement: load[0], velocity: load[1], friction: friction }
    masses: { m1: 3.25, m2: 3.25 },
    springs: { base - m1: 1323.0, m1 - m2: 1323.0 },
    contact: m2 - base,
    excitation: base,
    damping: modal(0.02),
    input: linear,
}

/// An operation that is applied to every machine. The machines have different types, so that a list cannot contain
/// them.
pub trait Visitor {
    /// Receives one machine.
    fn visit<M: Machine>(&mut self)
    where
        M::Scalar: super::script::Tone;
}

/// Applies a visitor to all machines in turn.
pub fn visit(visitor: &mut impl Visitor) {
    visitor.visit::<one_force::Run>();
    visitor.visit::<one_base::Run>();
    visitor.visit::<two_force::Run>();
    visitor.visit::<two_base::Run>();
    visitor.visit::<five_force::Run>();
    visitor.visit::<five_base::Run>();
    visitor.visit::<ten_force::Run>();
    visitor.visit::<ten_base::Run>();
    visitor.visit::<one_elastic::Run>();
    visitor.visit::<two_elastic::Run>();
    visitor.visit::<five_elastic::Run>();
    visitor.visit::<one_dashpot::Run>();
    visitor.visit::<two_contacts::Run>();
    visitor.visit::<two_rigid::Run>();
    visitor.visit::<elastic_contacts::Run>();
    visitor.visit::<three_contacts::Run>();
    visitor.visit::<one_force_double::Run>();
    visitor.visit::<one_base_double::Run>();
    visitor.visit::<two_force_double::Run>();
    visitor.visit::<two_base_double::Run>();
}
