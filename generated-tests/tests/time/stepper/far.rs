//! Tests a chain that has moved far away from its start. The force in its stuck contact is a difference of
//! displacements, of which single precision keeps few digits.

use frictiongen::{StepLoad, Stepping, System};
use frictiongen_kernel::Plain;

/// A motor that turns a load through a shaft. A weak spring joins the motor to the base.
const DRIVE: &str = "struct Drive { masses: { motor: 0.02, load: 0.05 },
    springs: { base - motor: 1e-3, motor - load: 800 }, contact: load - wall, excitation: motor, stiction: 1.2,
    provide: [stepper]";

/// Results of a run, in which rests alternate with pushes. Each list has one entry for each rest.
#[derive(Debug, Default)]
struct Run {
    events: u32,
    /// Displacements of the contact, one for each rest.
    places: Vec<f64>,
    /// Forces in the stuck contact, one for each rest.
    forces: Vec<f64>,
    /// Largest change of the contact's displacement during a rest.
    crept: f64,
}

/// Runs pushes of several seconds. After each push follows a rest, in which the torque varies by far less than the
/// break-away force.
fn run<S: Plain>(pushes: u32, friction: f64, damping: &str) -> Run {
    let system: System<S> = format!("{DRIVE}{damping} }}").parse().expect("a scene");
    let dt = S::constant(1e-3);
    let mut stepper = system.stepper(dt).expect("a step");
    let mut run = Run::default();
    let mut carried = 0.0;
    for push in 0..pushes {
        for step in 0..20_000 {
            let torque = if step < 7000 {
                friction + 1.0 + carried
            } else if step < 13_500 {
                carried - 1.0
            } else if step < 16_000 {
                carried
            } else {
                carried + 0.3 * friction * f64::from(step % 7 - 3) / 3.0
            };
            let forces = [(0, S::constant(torque))];
            let load = StepLoad {
                forces: &forces,
                ..StepLoad::friction(S::constant(friction))
            };
            let events = stepper.step(&load).expect("a sound load").events;
            run.events += events;
            let place = stepper.contact().displacement().to_f64();
            if step == 18_000 {
                run.places.push(place);
                run.forces.push(stepper.contact().force().to_f64());
            }
            if step > 18_000 {
                let last = run.places.last().copied().unwrap_or_default();
                run.crept = run.crept.max((place - last).abs());
            }
            if step == 6999 {
                carried = f64::from(push + 1) * 0.5;
            }
        }
    }
    run
}

/// Checks that four pushes in single precision have the number of events of double precision, to one event in a
/// hundred.
///
/// A displacement is a sum over about 10⁴ steps. Each step rounds a value of about 2000, so single precision gives
/// the sum to six digits. The forces are differences of these displacements.
#[test]
fn four_pushes_have_the_events_of_double_precision() {
    for damping in [", damping: modal(0.05)", ""] {
        for friction in [3.0, 1.0, 0.3, 0.1, 0.05, 0.03] {
            let wide = run::<f64>(4, friction, damping);
            let narrow = run::<f32>(4, friction, damping);
            println!("F {friction}{damping}: f64 {wide:?}");
            println!("   f32 {narrow:?}");
            // Without damping the shaft oscillates while the load stops, which causes hundreds of events.
            let events = narrow.events.abs_diff(wide.events);
            assert!(
                events <= wide.events / 100,
                "F {friction}{damping}: {events} more or less"
            );
            for (found, want) in narrow.places.iter().zip(&wide.places) {
                assert!((found - want).abs() < 1e-4 * want, "F {friction}{damping}");
            }
            if damping.is_empty() {
                continue;
            }
            for (found, want) in narrow.forces.iter().zip(&wide.forces) {
                // A rounding error of the displacement 2000, in the twist of a shaft of stiffness 800, is a force of
                // 0.1.
                assert!(
                    (found - want).abs() < 1e-4 * friction,
                    "F {friction}{damping}"
                );
            }
            assert!(
                wide.crept > 0.0 || narrow.crept <= 0.0,
                "F {friction}{damping}"
            );
        }
    }
}
