//! Compares emitted code of scenes with stops, moving surfaces and constant forces with the run-time system, bit by bit.
//! `study/joints/tests/rooms` compares the run-time system with a plain program.

use frictiongen::study::joined::JoinedInput;
use fuzzing::Random;

scenes! {
    struct Gear {
        masses: { motor: 1.0, load: 2.0 },
        springs: { wall - motor: 100.0, motor - load: 30.0 },
        contacts: { seal: wall - motor { speed: 0.2 }, pads: load - wall { share: 0.4, stiction: 1.3 } },
        stops: {
            bumper: load - wall { gap: 0.02, stiffness: 1e4, damping: 5 },
            tooth: motor - load { gap: 0.01, restitution: 0.6 },
        },
        constant: { load: 0.3 },
        damping: modal(0.02),
        excitation: motor,
        provide: [stepper, simulation],
    }
    struct Bell {
        masses: { clapper: 0.5 },
        contacts: { rub: clapper - wall },
        stops: { left: wall - clapper { gap: 0.01, restitution: 0.5 }, right: clapper - wall { gap: 0.01, restitution: 0.5 } },
        excitation: clapper,
        scalar: f32,
        provide: [stepper],
    }
}

#[test]
fn simulations_have_the_bits_of_the_system() {
    let system = system("Gear");
    let joined = system.joined().expect("a solver");
    let amplitude = 2.0;
    let mut stops = [0; 2];
    for (r, beta) in [(0.4, 0.3), (0.63, 0.1), (1.3, 0.6)] {
        let mut emitted = Gear::simulation_under(r, beta, amplitude).expect("a simulation");
        let at = joined.with_length(amplitude / 100.0).at(r);
        let mut run = at
            .expect("a frequency")
            .simulation(beta)
            .expect("a simulation");
        for part in 0..80 {
            emitted.advance(0.7).expect("a part");
            for event in run.advance(0.7).expect("a part") {
                if event.is_of_stop {
                    stops[event.contact - 2] += 1;
                }
            }
            let motor = (emitted.motor().displacement(), emitted.motor().velocity());
            assert_eq!(
                motor,
                run.mass("motor").expect("a mass"),
                "{r} {beta} {part}"
            );
            let named = [
                (emitted.seal(), "seal"),
                (emitted.pads(), "pads"),
                (emitted.bumper(), "bumper"),
                (emitted.tooth(), "tooth"),
            ];
            for (now, name) in named {
                let expected = run.contact_named(name).expect("a contact");
                assert_eq!(now.velocity(), expected.velocity, "{name}");
                assert_eq!(now.force(), expected.force, "{name}");
                assert_eq!(now.is_sticking(), expected.is_sticking, "{name}");
            }
        }
    }
    assert!(stops[0] > 10 && stops[1] > 10, "{stops:?}");
}

#[test]
fn steppers_follow_the_system() {
    let system = system("Gear");
    let joined = system.joined().expect("a solver");
    let dt = 0.01;
    let mut emitted = Gear::stepper(dt).expect("a stepper");
    let mut run = joined.stepper(dt).expect("a stepper");
    let mut random = Random(11);
    let (mut shut, mut dissipated) = (0, 0.0);
    for step in 0..3000 {
        let force = 4.0 * random.between(-1.0, 1.0);
        let friction = GearFriction {
            seal: 0.2,
            pads: random.between(0.0, 0.3),
        };
        let input = GearInput { force, friction };
        emitted.advance(input).expect("a step");
        let forces = [("motor", force)];
        let frictions = [("seal", friction.seal), ("pads", friction.pads)];
        let input = JoinedInput {
            forces: &forces,
            frictions: &frictions,
            ..JoinedInput::default()
        };
        run.advance(input).expect("a step");
        let load = (emitted.load().displacement(), emitted.load().velocity());
        assert_eq!(load, run.mass("load").expect("a mass"), "{step}");
        shut += usize::from(emitted.bumper().is_sticking());
        let work = emitted.work();
        let lost = work.damping + work.friction;
        assert!(lost > dissipated - 1e-12, "{step}: {lost} {dissipated}");
        dissipated = lost;
        if step == 1500 {
            let image = emitted.image();
            emitted = Gear::stepper_from_image(&image).expect("an image");
        }
    }
    assert!(shut > 20, "{shut}");
    assert_eq!(emitted.exceeded(), 0);
}

/// A mass between two walls, under a constant push, comes to rest at the right one.
#[test]
fn a_bell_comes_to_rest() {
    let mut bell = Bell::stepper(1e-3).expect("a stepper");
    for _ in 0..4000 {
        let input = BellInput {
            force: 0.2,
            friction: 0.0,
        };
        bell.advance(input).expect("a step");
        assert!(bell.clapper().displacement() < 0.010_001);
    }
    assert!(bell.right().is_sticking());
    assert_eq!(bell.clapper().velocity(), 0.0);
    assert!((bell.right().force() - 0.2).abs() < 1e-6);
    let push = |force| BellInput {
        force,
        friction: 0.0,
    };
    bell.advance(push(-0.2)).expect("a step");
    assert!(!bell.right().is_sticking());
}
