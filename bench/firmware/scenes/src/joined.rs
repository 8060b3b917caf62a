//! Scenes of the solver for several contacts: two masses with an elastic contact and a rigid contact, and chains with
//! one contact. A very small dashpot makes the generator use this solver for a chain with one contact.

frictiongen::friction_system! {
    /// Two storeys with a brace and pads.
    pub struct Storeys {
        masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
        contacts: {
            brace: base - lower { stiffness: 5000.0 },
            pads: lower - upper { stiction: 1.2 },
        },
        dampers: { lower - upper: 1.5 },
        excitation: upper,
        scalar: f32,
        input: hold,
        step: 1e-3,
        provide: [stepper, simulation, stuck, orbit],
    }
}

/// Creates a stepper of the scene at rest.
#[inline(never)]
#[cfg_attr(feature = "prove", no_panic::no_panic)]
pub fn start() -> Option<StoreysStepper> {
    Storeys::stepper(Storeys::STEP).ok()
}

/// Advances the stepper by one step. Returns the number of events and the force of the pads.
#[inline(never)]
#[cfg_attr(feature = "prove", no_panic::no_panic)]
pub fn advance(
    run: &mut StoreysStepper,
    force: f32,
    [brace, pads]: [f32; 2],
) -> Option<(u32, f32)> {
    let friction = StoreysFriction { brace, pads };
    let stepped = run.advance(StoreysInput { force, friction }).ok()?;
    Some((stepped.events, run.pads().force()))
}

/// Computes the motion from rest over a part of a cycle.
#[inline(never)]
#[cfg_attr(feature = "prove", no_panic::no_panic)]
pub fn simulate(r: f32, beta: f32, tau: f32) -> Option<f32> {
    let mut run = Storeys::simulation(r, beta).ok()?;
    run.advance(tau).ok()?;
    Some(run.upper().displacement())
}

/// Computes the friction ratio from which no contact slides.
#[inline(never)]
#[cfg_attr(feature = "prove", no_panic::no_panic)]
pub fn stuck_from(r: f32) -> Option<(f32, &'static str)> {
    let stuck = Storeys::at(r).ok()?.stuck().ok()?;
    Some((stuck.limit(), stuck.first()))
}

/// Computes the steady state of the scene. Returns the amplitude of the upper mass and the energy that the brace
/// dissipates in a cycle.
#[inline(never)]
#[cfg_attr(feature = "prove", no_panic::no_panic)]
pub fn settle(r: f32, beta: f32) -> Option<(f32, f32)> {
    let orbit = Storeys::at(r).ok()?.orbit(beta).ok()?;
    Some((orbit.upper().amplitude(), orbit.brace().energy()))
}

/// Chains of `stopping` with a very small dashpot.
pub mod single {
    frictiongen::friction_system! {
        /// One mass that rubs on a wall.
        pub struct Sdof {
            masses: { mass_1: 1.0 },
            springs: { base - mass_1: 1.0 },
            contact: mass_1 - wall,
            dampers: { base - mass_1: 1e-6 },
            excitation: mass_1,
            scalar: f32,
            provide: [orbit],
        }
    }

    frictiongen::friction_system! {
        /// Two masses of which the upper one rubs on a wall.
        pub struct Pair {
            masses: { lower: 3.27, upper: 3.25 },
            springs: { base - lower: 1190.0, lower - upper: 1323.0 },
            contact: upper - wall,
            dampers: { base - lower: 1e-6 },
            excitation: base,
            scalar: f32,
            provide: [orbit],
        }
    }

    frictiongen::friction_system! {
        /// Five damped masses of which the third one rubs on the moving base.
        pub struct Five {
            masses: { m1: 1.0, m2: 1.0, m3: 1.0, m4: 1.0, upper: 0.5 },
            springs: { base - m1: 1.0, m1 - m2: 1.0, m2 - m3: 1.0, m3 - m4: 1.0, m4 - upper: 1.0 },
            contact: m3 - base,
            dampers: { base - m1: 1e-6 },
            excitation: base,
            damping: modal(0.02),
            scalar: f32,
            provide: [orbit],
        }
    }
}
