//! Instants of the events in the steps of a stepper, with the feature `event-times`.

use frictiongen::study::SystemInput;
use frictiongen::study::sensitivity::Sensitive;
use frictiongen::{System, friction_system};
use std::f64::consts::TAU;

/// Number of steps in a period. Between two samples the base follows a cubic, whose error is (2π/4000)⁴/384 = 2e-14 of
/// the amplitude.
const STEPS: u32 = 4000;
const PERIODS: u32 = 12;
/// Largest difference of two instants, divided by the period. It is 1000 times the error of the cubic, because the
/// contact may stop with a small acceleration.
const NEAR: f64 = 1e-10;

/// Scenes with a point (r, β) at which the contact sticks and slides. The last scene has a stiff mode, so that a step
/// has several sub-intervals.
const SCENES: [(&str, f64, f64); 4] = [
    (
        "struct Frame { masses: { lower: 3.27, upper: 3.25 },
            springs: { base - lower: 1190, lower - upper: 1323 }, contact: upper - wall,
            excitation: base, damping: modal[0.010, 0.012], stiction: 1.2 }",
        0.3,
        0.4,
    ),
    (
        "struct Between { masses: { a: 1, b: 0.5 }, springs: { base - a: 1, a - b: 0.8 },
            contact: a - b, excitation: base, damping: modal(0.03) }",
        0.6,
        0.3,
    ),
    (
        "struct Elastic { masses: { a: 2 }, springs: { base - a: 3 }, contact: a - wall,
            stiffness: 20, excitation: base, damping: modal(0.02), stiction: 1.1,
            provide: [orbit, simulation, stepper] }",
        0.5,
        0.4,
    ),
    (
        "struct Stiff { masses: { heavy: 1, light: 1e-4 }, springs: { base - heavy: 1, heavy - light: 100 },
            contact: heavy - wall, excitation: base, damping: modal(0.05) }",
        0.7,
        0.4,
    ),
];

/// Returns the instants of the events of a simulation from rest, in periods.
fn simulated(system: &System, (r, beta): (f64, f64)) -> Vec<f64> {
    let mut run = system.simulation(r, beta).expect("in the domain");
    let (mut passed, until) = (0.0, TAU * f64::from(PERIODS + 1));
    let mut instants = Vec::new();
    while passed < until {
        let segment = run.advance(until - passed).expect("a reach");
        passed += segment.length;
        if segment.event.is_some() {
            instants.push(passed / TAU);
        }
        if segment.length == 0.0 && segment.event.is_none() {
            break;
        }
    }
    instants
}

/// Compares the instants with those of the simulation, whose search is another one: it has no time steps.
#[test]
fn the_instants_of_the_simulation() {
    for (text, r, beta) in SCENES {
        let system: System = text.parse().expect("a sound scene");
        let expected = simulated(&system, (r, beta));
        let stiffness = system.scene().first_stiffness();
        let omega = r * (stiffness / system.scene().masses[0].value).sqrt();
        let dt = TAU / omega / f64::from(STEPS);
        let mut stepper = system.stepper(dt).expect("a stepper");
        let input = |step: u32| {
            let (sine, cosine) = (TAU * f64::from(step) / f64::from(STEPS)).sin_cos();
            SystemInput::base(cosine, -omega * sine).friction(beta * stiffness)
        };
        stepper.begin(input(0)).expect("an input");
        assert_eq!(stepper.last_event(), None);
        let (mut seen, mut compared, mut worst) = (0, 0, 0.0_f64);
        for step in 1..=STEPS * PERIODS {
            let stepped = stepper.advance(input(step)).expect("a step");
            let Some(offset) = stepper.last_event() else {
                assert_eq!(stepped.events, 0);
                continue;
            };
            assert!(0 < stepped.events && (0.0..=dt).contains(&offset));
            if step == 1 && offset == 0.0 {
                // The contact breaks away at the start. The simulation starts with the sliding contact.
                assert_eq!(stepped.events, 1);
                continue;
            }
            seen += stepped.events as usize;
            let place = f64::from(step - 1) / f64::from(STEPS) + offset * omega / TAU;
            worst = worst.max((place - expected[seen - 1]).abs());
            compared += 1;
        }
        println!("{r} {beta}: {compared} instants, {worst:e} of a period");
        // The next event of the simulation comes after the last step.
        assert!(f64::from(PERIODS) - NEAR < expected[seen]);
        assert!(
            2 * PERIODS as usize <= compared,
            "only {compared} steps with events"
        );
        assert!(worst < NEAR, "{worst:e} of a period in {text}");
    }
}

/// An emitted stepper returns the instants of the stepper of a `System`, and a restored stepper returns `None`.
#[test]
fn the_instants_of_an_emitted_stepper() {
    friction_system! {
        struct Emitted {
            masses: { a: 1.0, b: 2.0 },
            springs: { base - a: 3.0, a - b: 1.5 },
            contact: b - wall,
            excitation: a,
            provide: [stepper],
            step: 0.125,
        }
    }
    let system: System =
        "struct Emitted { masses: { a: 1.0, b: 2.0 }, springs: { base - a: 3.0, a - b: 1.5 },
        contact: b - wall, excitation: a, provide: [stepper], step: 0.125 }"
            .parse()
            .expect("a sound scene");
    let mut emitted = Emitted::stepper(Emitted::STEP).expect("a stepper");
    let mut stepper = system.stepper(0.125).expect("a stepper");
    let mut compared = 0;
    for step in 0..400 {
        let force = 2.0 * (0.9 * f64::from(step) * 0.125).sin();
        let input = EmittedInput {
            force,
            friction: 0.7,
        };
        emitted.advance(input).expect("a step");
        let input = SystemInput::force(force).friction(0.7);
        stepper.advance(input).expect("a step");
        let pair = (emitted.last_event(), stepper.last_event());
        assert_eq!(pair.0.is_some(), pair.1.is_some());
        if let (Some(one), Some(other)) = pair {
            // Both search the same series, whose constants differ by roundings.
            assert!((one - other).abs() < 1e-11, "{one} {other}");
            let again = Emitted::stepper_from_image(&emitted.image()).expect("an image");
            assert_eq!(again.last_event(), None);
            compared += 1;
        }
    }
    assert!(20 < compared, "only {compared} steps with events");
}

/// The instants of a stepper with derivatives have derivatives too.
#[test]
fn the_derivative_of_an_instant() {
    let (text, ..) = SCENES[0];
    let text = text.replace("excitation: base", "excitation: lower");
    let system: System = text.parse().expect("a sound scene");
    let (dt, friction, change) = (0.02, 1.0, 1e-5);
    let unvaried = system.unvaried();
    let mut varied = unvaried.stepper(dt).expect("a stepper");
    let mut pair =
        [-change, change].map(|by| (friction + by, system.stepper(dt).expect("a stepper")));
    let mut compared = 0;
    for step in 1..400 {
        let force = 6.0 * (8.0 * dt * f64::from(step)).sin();
        let input = SystemInput::force(Sensitive::fixed(force.into()));
        let friction = Sensitive::variable(friction.into());
        varied.advance(input.friction(friction)).expect("a step");
        for (friction, stepper) in &mut pair {
            let input = SystemInput::force(force).friction(*friction);
            stepper.advance(input).expect("a step");
        }
        let [low, high] = pair.each_ref().map(|(_, stepper)| stepper.last_event());
        if let (Some(instant), Some(low), Some(high)) = (varied.last_event(), low, high) {
            let (found, expected) = (instant.slope.to_f64(), (high - low) / (2.0 * change));
            // A central difference has a relative error of about the square of the change, and rounding of 1e-15/1e-5.
            assert!(
                (found - expected).abs() < 1e-5 * found.abs() + 1e-8,
                "{found} {expected}"
            );
            compared += 1;
        }
    }
    assert!(10 < compared, "only {compared} instants");
}
