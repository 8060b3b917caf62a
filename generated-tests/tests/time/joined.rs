//! Compares emitted code of scenes with several contacts with the run-time system, bit by bit. `study/joined` compares
//! the run-time system with `joints.json`, which a plain program with matrix exponentials made.

use frictiongen::study::joined::JoinedInput;
use frictiongen::{OutOfDomain, System};
use fuzzing::Random;
use std::sync::Mutex;

scenes! {
    struct Storeys {
        masses: { one: 2.0, two: 1.5, three: 1.0, four: 0.8 },
        springs: { base - one: 900.0, one - two: 700.0, two - three: 650.0, three - four: 500.0 },
        contacts: {
            brace: base - one { stiffness: 4000.0 },
            pads: one - two { share: 0.6, stiction: 1.2 },
            clamp: two - three { share: 0.5 },
            hanger: four - wall { stiffness: 2500.0, share: 0.3, stiction: 1.1 },
        },
        dampers: { three - four: 1.2 },
        damping: rayleigh(0.2, 1e-3),
        excitation: four,
        force: { one },
        provide: [stepper, simulation],
    }
    struct Pair {
        masses: { lower: 2.0, upper: 1.0 },
        springs: { base - lower: 800.0, lower - upper: 600.0 },
        contacts: { brace: base - lower { stiffness: 3000.0 }, pads: lower - upper { stiction: 1.2 } },
        excitation: upper,
        scalar: f32,
        input: hold,
        step: 1e-3,
        provide: [simulation, stepper],
    }
    // One contact: the code is that of the field `contact`.
    struct Named {
        masses: { lower: 2.0, upper: 1.0 },
        springs: { base - lower: 800.0, lower - upper: 600.0 },
        contacts: { pads: lower - upper { stiction: 1.2 } },
        damping: modal(0.02),
        excitation: upper,
        provide: [limits, motion, stuck, orbit, simulation, stepper],
    }
    struct Clutches {
        masses: { motor: 1.0, load: 3.0 },
        contacts: { clutch: motor - load, brake: load - wall { stiction: 1.3 } },
        excitation: motor,
        input: hold,
        provide: [stepper],
    }
}

/// Checks that emitted simulations give the bits of the run-time system.
#[test]
fn simulations_have_the_bits_of_the_system() {
    let system = system("Storeys");
    let joined = system.joined().expect("answers");
    let mut events = 0;
    for (r, beta) in [(0.4, 0.3), (0.9, 0.05), (1.3, 1.0)] {
        let mut emitted = Storeys::simulation(r, beta).expect("a simulation");
        let at = joined.at(r).expect("a frequency");
        let mut run = at.simulation(beta).expect("a simulation");
        for part in 0..60 {
            let count = emitted.advance(0.7).expect("a part");
            assert!(count as usize <= run.advance(0.7).expect("a part").len());
            events += count;
            assert_eq!(emitted.tau(), run.tau());
            let one = (emitted.one().displacement(), emitted.one().velocity());
            let four = (emitted.four().displacement(), emitted.four().velocity());
            assert_eq!(one, run.mass("one").expect("a mass"), "{r} {beta} {part}");
            assert_eq!(four, run.mass("four").expect("a mass"), "{r} {beta} {part}");
            let named = [
                (emitted.brace(), "brace"),
                (emitted.pads(), "pads"),
                (emitted.clamp(), "clamp"),
                (emitted.hanger(), "hanger"),
            ];
            for (now, name) in named {
                let expected = run.contact_named(name).expect("a contact");
                assert_eq!(now.displacement(), expected.displacement, "{name}");
                assert_eq!(now.velocity(), expected.velocity, "{name}");
                assert_eq!(now.force(), expected.force, "{name}");
                assert_eq!(now.is_sticking(), expected.is_sticking, "{name}");
            }
        }
    }
    assert!(events > 100, "{events}");
}

/// Compares emitted steppers, which use tables, with the run-time system, which follows power series. The forces are
/// random, and the friction forces change and vanish.
#[test]
fn steppers_follow_the_system() {
    let system = system("Storeys");
    let joined = system.joined().expect("answers");
    let dt = 0.01;
    let mut emitted = Storeys::stepper(dt).expect("a stepper");
    let mut run = joined.stepper(dt).expect("a stepper");
    let mut random = Random(7);
    let (mut events, mut worst, mut input) = (0, 0.0_f64, StoreysInput::default());
    for step in 0..3000 {
        if step % 50 == 0 {
            input.force = random.between(-30.0, 30.0);
            input.one = random.between(-20.0, 20.0);
        }
        if step % 130 == 0 {
            input.friction = StoreysFriction {
                brace: random.between(0.0, 9.0),
                pads: random.between(0.0, 5.0),
                clamp: if step % 260 == 0 { 0.0 } else { 2.0 },
                hanger: random.between(0.0, 4.0),
            };
        }
        let friction = input.friction;
        let forces = [("four", input.force), ("one", input.one)];
        let frictions = [
            ("brace", friction.brace),
            ("pads", friction.pads),
            ("clamp", friction.clamp),
            ("hanger", friction.hanger),
        ];
        let count = emitted.advance(input).expect("a step").events;
        let sampled = JoinedInput {
            forces: &forces,
            frictions: &frictions,
            ..JoinedInput::default()
        };
        assert_eq!(
            count as usize,
            run.advance(sampled).expect("a step"),
            "{step}"
        );
        events += count;
        let three = (emitted.three().displacement(), emitted.three().velocity());
        let expected = run.mass("three").expect("a mass");
        worst = worst.max((three.0 - expected.0).abs());
        worst = worst.max((three.1 - expected.1).abs());
        for (now, name) in [
            (emitted.brace(), "brace"),
            (emitted.pads(), "pads"),
            (emitted.clamp(), "clamp"),
        ] {
            let expected = run.contact_named(name).expect("a contact");
            worst = worst.max((now.force() - expected.force).abs());
            assert_eq!(now.is_sticking(), expected.is_sticking, "{name} {step}");
        }
    }
    assert!(events > 200, "{events}");
    // Velocities and forces are of the size 1 to 10. Each step adds some rounding errors of 1e-16.
    assert!(worst < 1e-11, "{worst:e}");
}

/// Checks that a single contact of the field `contacts` has a method with its name, which returns what `contact` returns.
#[test]
fn one_contact_has_a_method_of_its_name() {
    let at = Named::at(0.9).expect("a frequency");
    let motion = at.motion(0.1).expect("a motion");
    assert_eq!(motion.pads().amplitude(), motion.contact().amplitude());
    let stuck = at.stuck().expect("a stuck state");
    assert_eq!(stuck.pads(), stuck.contact_force());
    let orbit = at.orbit(0.4).expect("a steady state");
    assert_eq!(orbit.pads().amplitude(), orbit.contact().amplitude());
    let mut run = Named::simulation(0.9, 0.4).expect("a simulation");
    run.advance(20.0).expect("a motion");
    assert_eq!(run.pads(), run.contact());
    let mut step = Named::stepper(0.01).expect("a stepper");
    let input = NamedInput {
        force: 3.0,
        friction: 1.0,
    };
    step.advance(input).expect("a step");
    assert_eq!(step.pads().force(), step.contact().force());
}

/// Checks a clutch that sticks and drives two masses as one. Formulas give the acceleration and the slip.
#[test]
fn a_clutch_and_a_brake() {
    let dt = 0.125;
    let mut step = Clutches::stepper(dt).expect("a stepper");
    let friction = ClutchesFriction {
        clutch: 10.0,
        brake: 0.0,
    };
    let input = ClutchesInput {
        force: 8.0,
        friction,
    };
    for _ in 0..8 {
        step.advance(input).expect("a step");
    }
    // 8 N act on 4 kg for 1 s. The clutch transmits 6 N of them.
    assert!(step.clutch().is_sticking() && step.clutch().velocity() == 0.0);
    assert!((step.load().velocity() - 2.0).abs() < 1e-13, "{step:?}");
    assert!((step.clutch().force().abs() - 6.0).abs() < 1e-13);
    assert!(!step.brake().is_sticking() && step.brake().force() == 0.0);
    // The brake slows both masses with 4 N, which is less than the 10 N that the clutch can hold. They stop after 2
    // s.
    let friction = ClutchesFriction {
        clutch: 10.0,
        brake: 4.0,
    };
    let input = ClutchesInput {
        force: 0.0,
        friction,
    };
    let events: u32 = (0..24)
        .map(|_| step.advance(input).expect("a step").events)
        .sum();
    assert_eq!(events, 1);
    assert!(step.brake().is_sticking() && step.motor().velocity() == 0.0);
    assert!((step.load().displacement() - 3.0).abs() < 1e-12, "{step:?}");
}

/// Checks that `f32` follows `f64` over the first half second of a scene.
#[test]
fn single_precision_follows_double_precision() {
    let text = "struct Pair { masses: { lower: 2.0, upper: 1.0 },
        springs: { base - lower: 800.0, lower - upper: 600.0 },
        contacts: { brace: base - lower { stiffness: 3000.0 }, pads: lower - upper { stiction: 1.2 } },
        excitation: upper, input: hold, provide: [stepper] }";
    let double: System = text.parse().expect("a valid scene");
    let joined = double.joined().expect("answers");
    let mut run = joined.stepper(f64::from(Pair::STEP)).expect("a stepper");
    let mut step = Pair::stepper(Pair::STEP).expect("a stepper");
    let (mut worst, mut size) = (0.0_f64, 0.0_f64);
    for index in 0..500_u16 {
        let force = if (index / 80) % 2 == 0 { 20.0 } else { -20.0 };
        let friction = PairFriction {
            brace: 6.0,
            pads: 4.0,
        };
        step.advance(PairInput { force, friction }).expect("a step");
        let input = JoinedInput {
            forces: &[("upper", f64::from(force))],
            frictions: &[("brace", 6.0), ("pads", 4.0)],
            ..JoinedInput::default()
        };
        run.advance(input).expect("a step");
        let expected = run.mass("upper").expect("a mass").0;
        worst = worst.max((f64::from(step.upper().displacement()) - expected).abs());
        size = size.max(expected.abs());
    }
    println!("f32: {:.1e} of the largest displacement", worst / size);
    // The run has about five hundred steps, each with several rounding errors of 6e-8.
    assert!(worst < 1e-4 * size, "{worst} {size}");
}

/// Checks that the stepper with constant tables, in a `static`, gives the bits of the other.
#[test]
fn declared_steppers_have_the_same_bits() {
    static DECLARED: Mutex<PairDeclaredStepper> = Mutex::new(Pair::declared_stepper());
    let mut declared = DECLARED.lock().expect("one thread");
    let mut other = Pair::stepper(Pair::STEP).expect("a stepper");
    let (brace, pads) = (6.0, 4.0);
    let friction = PairFriction { brace, pads };
    for index in 0..500_u16 {
        let force = if (index / 80) % 2 == 0 { 20.0 } else { -20.0 };
        let input = PairInput { force, friction };
        let stepped = other.advance(input).expect("a step");
        assert_eq!(declared.advance(input), Ok(stepped));
        assert_eq!(declared.upper(), other.upper());
        assert_eq!(declared.brace(), other.brace());
    }
    assert_eq!(declared.image(), other.image());
}

#[test]
fn bad_inputs_change_nothing() {
    let mut step = Storeys::stepper(1e-3).expect("a stepper");
    let good = StoreysInput {
        force: 5.0,
        ..StoreysInput::default()
    };
    step.advance(good).expect("a step");
    let before = format!("{step:?}");
    let nan = StoreysInput {
        one: f64::NAN,
        ..good
    };
    let mut negative = good;
    negative.friction.pads = -1.0;
    let refused = step.advance(nan);
    assert!(matches!(refused, Err(OutOfDomain::Force(_))), "{refused:?}");
    let refused = step.advance(negative);
    assert!(
        matches!(refused, Err(OutOfDomain::Friction(_))),
        "{refused:?}"
    );
    assert_eq!(format!("{step:?}"), before);
    for dt in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e3] {
        assert!(
            matches!(Storeys::stepper(dt), Err(OutOfDomain::Step(_))),
            "{dt}"
        );
    }
    assert!(Storeys::simulation(0.0, 0.1).is_err());
    assert!(Storeys::simulation(1.0, f64::NAN).is_err());
    let mut run = Storeys::simulation(1.0, 0.1).expect("a simulation");
    assert!(matches!(run.advance(-1.0), Err(OutOfDomain::Duration(_))));
    assert!(Storeys::simulation_from(1.0, 0.1, (&[f64::NAN; 4], &[0.0; 4])).is_err());
}

/// Checks that the memory in bytes is that of docs/data/joints-memory.csv.
#[test]
fn sizes_are_those_of_the_documentation() {
    let sizes = [
        ("Pair, f32, stepper", size_of::<PairStepper>()),
        ("Pair, f32, simulation", size_of::<PairSimulation>()),
        ("Clutches, stepper", size_of::<ClutchesStepper>()),
        ("Storeys, stepper", size_of::<StoreysStepper>()),
        ("Storeys, simulation", size_of::<StoreysSimulation>()),
    ];
    let table = include_str!("../../../docs/data/joints-memory.csv");
    let rows = sizes.map(|(what, size)| format!("\"{what}\",{size}\n"));
    let rows = rows.concat();
    assert!(
        table.contains(&rows),
        "docs/data/joints-memory.csv needs these rows:\n{rows}"
    );
}
