//! The stepper of two masses with an elastic and a rigid contact.

use super::{Cost, Machine, Outcome};

frictiongen::friction_system! {
    /// Two storeys with a brace and pads.
    pub struct Chain {
        masses: { m1: 3.25, m2: 3.25 },
        springs: { base - m1: 1323.0, m1 - m2: 1323.0 },
        contacts: {
            brace: base - m1 { stiffness: 1.0e4 },
            pads: m1 - m2 { stiction: 1.2 },
        },
        excitation: m1,
        scalar: f32,
        input: hold,
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

/// Advances the stepper by one step. The pads have 0.6 of the friction force of the brace.
#[inline(never)]
#[cfg_attr(feature = "prove", no_panic::no_panic)]
pub fn advance(run: &mut Run, load: [f32; 2], friction: f32) -> Option<Outcome> {
    let friction = ChainFriction {
        brace: friction,
        pads: 0.6 * friction,
    };
    let [force, _] = load;
    let stepped = run.0.advance(ChainInput { force, friction }).ok()?;
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
    const NAME: &'static str = "2 masses f32, two contacts, undamped, force held";
    const ON_BASE: bool = false;

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
        let values = [mass.displacement(), mass.velocity(), self.0.pads().force()];
        values.map(|value| u64::from(value.to_bits()))
    }
}
