//! The scenes that step: chains of equal masses.

use super::{Machine, Outcome};
use frictiongen::kernel::stepper::{FixedStore, FixedTables, Input, Sample, StepScene, Stepper, Units};

macro_rules! machine {
    ($module:ident $name:literal $scalar:ident $terms:literal $modes:literal $held:literal $on_base:literal $input:ident $step:literal { $($scene:tt)* }) => {
        #[doc = $name]
        pub mod $module {
            use super::*;
            frictiongen::friction_system! {
                /// What steps.
                pub struct Frame { $($scene)* provide: [simulation], scalar: $scalar }
            }
            /// The stepper.
            pub struct Run(
                Stepper<
                    'static,
                    $scalar,
                    $terms,
                    FixedTables<$scalar, $terms, $modes, $held, 1>,
                    FixedStore<$scalar, $terms, $modes, $held, 1>,
                >,
            );
            /// A step as a function of its own.
            #[inline(never)]
            #[cfg_attr(feature = "prove", no_panic::no_panic)]
            pub fn advance(run: &mut Run, load: [$scalar; 2], friction: $scalar) -> Option<Outcome> {
                let sample = Sample {
                    base: load,
                    forces: if $on_base { &[] } else { core::slice::from_ref(&load[0]) },
                    friction,
                };
                let stepped = run.0.advance(sample).ok()?;
                Some(Outcome {
                    sticks: stepped.contact == frictiongen::kernel::simulation::Contact::Stuck,
                    events: stepped.events,
                    exceeded: stepped.exceeded,
                })
            }
            /// At rest.
            #[inline(never)]
            #[cfg_attr(feature = "prove", no_panic::no_panic)]
            pub fn start() -> Option<Run> {
                let scene = StepScene {
                    dynamics: Frame::DYNAMICS,
                    units: Units { stiffness: 1323.0, rate: 20.176_141_88, support: 1.0 },
                    on_base: $on_base,
                    forces: if $on_base { &[] } else { &[0] },
                    input: Input::$input,
                    law: &[],
                };
                let tables = FixedTables::new(&scene, $step).ok()?;
                Stepper::new(scene, tables, FixedStore::new(), None).ok().map(Run)
            }
            impl Machine for Run {
                type Scalar = $scalar;
                const NAME: &'static str = $name;
                fn start() -> Option<Self> {
                    start()
                }
                fn advance(&mut self, load: [$scalar; 2], friction: $scalar) -> Option<Outcome> {
                    advance(self, load, friction)
                }
                fn bits(&self) -> [u64; 3] {
                    let mass = self.0.mass($modes - 1);
                    let values = [mass.displacement(), mass.velocity(), self.0.work().load];
                    values.map(|value| u64::from(value.to_bits()))
                }
            }
        }
    };
}

machine! {
    one_force "1 mass f32, undamped, force held" f32 1 1 0 false Hold 1e-3 {
        masses: { m1: 3.25 }, springs: { base - m1: 1323.0 }, contact: m1 - wall, excitation: m1,
    }
}

machine! {
    one_force_double "1 mass f64, undamped, force held" f64 1 1 0 false Hold 1e-3 {
        masses: { m1: 3.25 }, springs: { base - m1: 1323.0 }, contact: m1 - wall, excitation: m1,
    }
}

machine! {
    one_base "1 mass f32, damped, base linear" f32 4 1 0 true Linear 1e-3 {
        masses: { m1: 3.25 }, springs: { base - m1: 1323.0 }, contact: m1 - base, excitation: base, damping: modal(0.02),
    }
}

machine! {
    one_base_double "1 mass f64, damped, base linear" f64 4 1 0 true Linear 1e-3 {
        masses: { m1: 3.25 }, springs: { base - m1: 1323.0 }, contact: m1 - base, excitation: base, damping: modal(0.02),
    }
}

machine! {
    two_force "2 masses f32, undamped, force held" f32 1 2 1 false Hold 1e-3 {
        masses: { m1: 3.25, m2: 3.25 }, springs: { base - m1: 1323.0, m1 - m2: 1323.0 }, contact: m2 - wall, excitation: m1,
    }
}

machine! {
    two_force_double "2 masses f64, undamped, force held" f64 1 2 1 false Hold 1e-3 {
        masses: { m1: 3.25, m2: 3.25 }, springs: { base - m1: 1323.0, m1 - m2: 1323.0 }, contact: m2 - wall, excitation: m1,
    }
}

machine! {
    two_base "2 masses f32, damped, base linear" f32 4 2 1 true Linear 1e-3 {
        masses: { m1: 3.25, m2: 3.25 }, springs: { base - m1: 1323.0, m1 - m2: 1323.0 }, contact: m2 - base, excitation: base, damping: modal(0.02),
    }
}

machine! {
    two_base_double "2 masses f64, damped, base linear" f64 4 2 1 true Linear 1e-3 {
        masses: { m1: 3.25, m2: 3.25 }, springs: { base - m1: 1323.0, m1 - m2: 1323.0 }, contact: m2 - base, excitation: base, damping: modal(0.02),
    }
}

machine! {
    five_force "5 masses f32, undamped, force held" f32 1 5 4 false Hold 1e-3 {
        masses: { m1: 3.25, m2: 3.25, m3: 3.25, m4: 3.25, m5: 3.25 }, springs: { base - m1: 1323.0, m1 - m2: 1323.0, m2 - m3: 1323.0, m3 - m4: 1323.0, m4 - m5: 1323.0 }, contact: m5 - wall, excitation: m1,
    }
}

machine! {
    five_base "5 masses f32, damped, base linear" f32 4 5 4 true Linear 1e-3 {
        masses: { m1: 3.25, m2: 3.25, m3: 3.25, m4: 3.25, m5: 3.25 }, springs: { base - m1: 1323.0, m1 - m2: 1323.0, m2 - m3: 1323.0, m3 - m4: 1323.0, m4 - m5: 1323.0 }, contact: m5 - base, excitation: base, damping: modal(0.02),
    }
}

machine! {
    ten_force "10 masses f32, undamped, force held" f32 1 10 9 false Hold 1e-3 {
        masses: { m1: 3.25, m2: 3.25, m3: 3.25, m4: 3.25, m5: 3.25, m6: 3.25, m7: 3.25, m8: 3.25, m9: 3.25, m10: 3.25 }, springs: { base - m1: 1323.0, m1 - m2: 1323.0, m2 - m3: 1323.0, m3 - m4: 1323.0, m4 - m5: 1323.0, m5 - m6: 1323.0, m6 - m7: 1323.0, m7 - m8: 1323.0, m8 - m9: 1323.0, m9 - m10: 1323.0 }, contact: m10 - wall, excitation: m1,
    }
}

machine! {
    ten_base "10 masses f32, damped, base linear" f32 4 10 9 true Linear 1e-3 {
        masses: { m1: 3.25, m2: 3.25, m3: 3.25, m4: 3.25, m5: 3.25, m6: 3.25, m7: 3.25, m8: 3.25, m9: 3.25, m10: 3.25 }, springs: { base - m1: 1323.0, m1 - m2: 1323.0, m2 - m3: 1323.0, m3 - m4: 1323.0, m4 - m5: 1323.0, m5 - m6: 1323.0, m6 - m7: 1323.0, m7 - m8: 1323.0, m8 - m9: 1323.0, m9 - m10: 1323.0 }, contact: m10 - base, excitation: base, damping: modal(0.02),
    }
}
