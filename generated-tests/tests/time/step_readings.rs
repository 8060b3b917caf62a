//! Compares three implementations of one stepper: emitted with tables that are computed at the start, emitted with
//! constant tables, and the run-time system.

use frictiongen::study::SystemInput;
use frictiongen::{Given, OutOfDomain, StepLoad, Stepping, Steps, System};
use frictiongen_kernel::simulation::Contact;
use frictiongen_kernel::{Float, Scalar};
use generated_tests::shown;

fn system<S: Float>(name: &str) -> System<S> {
    let known = shown::SCENES.iter().find(|(known, _)| *known == name);
    known.expect("a scene").1.parse().expect("a valid scene")
}

/// Returns the inputs of a step: base displacement, base velocity, force and friction, before scaling. They change
/// irregularly, so that the contact stops every few steps.
fn acting(step: u32) -> [f64; 4] {
    let t = f64::from(step);
    [
        (0.0213 * t).sin() + 0.4 * (0.31 * t).sin(),
        0.0213 * (0.0213 * t).cos() + 0.4 * 0.31 * (0.31 * t).cos(),
        0.3 * (0.117 * t + 1.0).sin(),
        1.0 + 0.2 * (0.01 * t).sin(),
    ]
}

/// Factors that scale the inputs for a scene: base displacement, base velocity, force and friction.
struct Strength {
    base: f64,
    velocity: f64,
    force: f64,
    friction: f64,
    /// Indices of the loaded masses.
    loaded: &'static [usize],
}

/// Runs a stepper. Returns every number that it reports after each step, and the total number of events.
fn run<T: Stepping>(mut stepper: T, strength: &Strength, masses: usize) -> (Vec<f64>, u32) {
    let (mut said, mut events) = (Vec::new(), 0);
    let number = T::Scalar::constant;
    for step in 0..4000 {
        let [base, velocity, force, friction] = acting(step);
        let share = |place: usize| force * (1.0 - 0.3 * place as f64) * strength.force;
        let forces: Vec<(usize, T::Scalar)> = strength
            .loaded
            .iter()
            .enumerate()
            .map(|(place, mass)| (*mass, number(share(place))))
            .collect();
        let load = StepLoad {
            base: [
                number(base * strength.base),
                number(velocity * strength.velocity),
            ],
            forces: &forces,
            friction: number(friction * strength.friction),
        };
        let stepped = if step == 0 {
            stepper.begin_with(&load).expect("before the first step");
            continue;
        } else {
            stepper.step(&load).expect("a sound load")
        };
        events += stepped.events;
        said.push(stepped.force.to_f64());
        said.push(f64::from(u8::from(stepped.contact == Contact::Stuck)));
        for mass in 0..masses {
            let now = stepper.mass(mass);
            said.extend([now.displacement().to_f64(), now.velocity().to_f64()]);
        }
        let (contact, work) = (stepper.contact(), stepper.work());
        said.extend(
            [contact.displacement(), contact.velocity(), contact.force()].map(Float::to_f64),
        );
        said.extend([work.load, work.friction, work.damping, work.stored].map(Float::to_f64));
    }
    assert_eq!(stepper.steps(), 3999);
    (said, events)
}

const SHAKEN: Strength = Strength {
    base: 0.01,
    velocity: 10.0,
    force: 0.0,
    friction: 8.0,
    loaded: &[],
};
const PUSHED: Strength = Strength {
    base: 0.0,
    velocity: 0.0,
    force: 60.0,
    friction: 9.0,
    loaded: &[0],
};
const BOWED: Strength = Strength {
    base: 0.0,
    velocity: 0.0,
    force: 60.0,
    friction: 3.0,
    loaded: &[1, 0],
};

/// Checks that an emitted stepper and the run-time stepper agree bit for bit if both compute their tables at the
/// start.
#[test]
fn emitted_and_run_time_say_the_same_bits() {
    fn check<F: Steps>(name: &str, emitted: &F, dt: f64, strength: &Strength, masses: usize)
    where
        F::Scalar: frictiongen_kernel::Plain,
    {
        let dt = F::Scalar::constant(dt);
        let system: System<F::Scalar> = system(name);
        let (one, events) = run(emitted.stepper(dt).expect("a step"), strength, masses);
        let (other, _) = run(system.stepper(dt).expect("a step"), strength, masses);
        assert!(events > 30, "{name}: {events} events");
        assert_eq!(one.len(), other.len());
        for (place, (one, other)) in one.iter().zip(&other).enumerate() {
            assert_eq!(
                one.to_bits(),
                other.to_bits(),
                "{name}, {place}: {one} {other}"
            );
        }
        println!("{name}: {} values the same, {events} events", one.len());
    }
    // The length of these steps differs from the length that the scene declares.
    check("Shaken", &shown::Shaken, 1.1e-3, &SHAKEN, 2);
    check("Pushed", &shown::Pushed, 1e-3, &PUSHED, 1);
    check("Bowed", &shown::Bowed, 4e-4, &BOWED, 2);
}

/// Checks that constant tables, which are rounded once, and tables computed at the start, which are rounded a few
/// times, give the same motion up to the growth of rounding errors in 4000 steps. If the end of a step is next to an
/// event, the two steppers may count the event in different steps.
#[test]
fn constant_tables_say_the_same_to_rounding() {
    fn check(name: &str, constant: impl Stepping, system: impl Stepping, strength: &Strength) {
        let (one, events) = run(constant, strength, 2);
        let (other, others) = run(system, strength, 2);
        assert_eq!(events, others, "{name}");
        let fields = 11;
        let mut worst = 0.0_f64;
        for field in (0..fields).filter(|field| *field != 1) {
            let of = |said: &[f64]| -> Vec<f64> {
                said.iter().skip(field).step_by(fields).copied().collect()
            };
            let (one, other) = (of(&one), of(&other));
            let size = one
                .iter()
                .fold(0.0_f64, |most, value| most.max(value.abs()));
            for (one, other) in one.iter().zip(&other) {
                worst = worst.max((one - other).abs() / size);
            }
        }
        println!("{name}: {worst:.1e} of the largest apart, {events} events");
        assert!(worst < 1e-13, "{name}: {worst:e}");
        assert!(worst > 0.0, "{name}: these tables are no others");
    }
    let step = shown::Shaken::STEP;
    check(
        "Shaken",
        shown::Shaken::stepper(step).expect("its step"),
        system("Shaken").stepper(step).expect("its step"),
        &SHAKEN,
    );
    let step = shown::Bowed::STEP;
    check(
        "Bowed",
        shown::Bowed::stepper(step).expect("its step"),
        system("Bowed").stepper(step).expect("its step"),
        &BOWED,
    );
}

/// A stepper that borrows its constant tables. It is the value of a `static`.
static SHAKEN_AT_REST: shown::ShakenDeclaredStepper = shown::Shaken::declared_stepper();

/// Checks a stepper that borrows its tables against one that owns a copy. The stepper with borrowed tables gives the
/// same bits, needs less memory, and reads the images of the stepper with a copy.
#[test]
fn borrowed_tables_say_the_same_bits() {
    fn check(name: &str, (borrows, owns): (impl Stepping, impl Stepping), strength: &Strength) {
        let ((one, events), (other, _)) = (run(borrows, strength, 2), run(owns, strength, 2));
        let bits = |said: &[f64]| said.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
        assert!(events > 30, "{name}: {events} events");
        assert!(bits(&one) == bits(&other), "{name}");
    }
    let owns = shown::Shaken::stepper(shown::Shaken::STEP).expect("its step");
    check("Shaken", (SHAKEN_AT_REST.clone(), owns.clone()), &SHAKEN);
    let bowed = shown::Bowed::stepper(shown::Bowed::STEP).expect("its step");
    check("Bowed", (shown::Bowed::declared_stepper(), bowed), &BOWED);
    // The scene with the elastic contact.
    let sprung = shown::Sprung::stepper(shown::Sprung::STEP).expect("its step");
    check(
        "Sprung",
        (shown::Sprung::declared_stepper(), sprung),
        &SHAKEN,
    );
    assert!(2 * size_of::<shown::ShakenDeclaredStepper>() < size_of::<shown::ShakenStepper>());
    let mut borrows = SHAKEN_AT_REST.clone();
    borrows
        .restore_image(&owns.image())
        .expect("the same scene and step");
    assert_eq!(borrows.image(), owns.image());
}

/// Checks that the call for all masses gives the bits of the calls for single masses, in every state of the contact.
#[test]
fn all_masses_at_once_are_the_masses_one_by_one() {
    let mut stepper = shown::Shaken::declared_stepper();
    let system: System = system("Shaken");
    let mut other = system.stepper(shown::Shaken::STEP).expect("its step");
    let (mut stuck, mut slid) = (0, 0);
    for step in 0..4000 {
        let [base, velocity, _, friction] = acting(step);
        let load = StepLoad {
            base: [base * SHAKEN.base, velocity * SHAKEN.velocity],
            ..StepLoad::friction(friction * SHAKEN.friction)
        };
        stepper.step(&load).expect("a sound load");
        other.step(&load).expect("a sound load");
        let counted = if stepper.contact().is_sticking() {
            &mut stuck
        } else {
            &mut slid
        };
        *counted += 1;
        assert_eq!(stepper.all_masses(), [stepper.lower(), stepper.upper()]);
        assert_eq!(other.all_masses(), [other.mass_at(0), other.mass_at(1)]);
    }
    assert!(stuck > 100 && slid > 100, "{stuck}, {slid}");
    // The work for all masses: products of two mode shapes with two modes, and the modes of the stuck chain.
    assert_eq!(stepper.cost().masses, 2 * (12 + 12) + 2 * (4 * 2 + 4));
}

frictiongen::friction_system! {
    /// A scene whose step is nearly a radian of the faster mode. A series with too few terms would be wrong in a step
    /// of this length.
    struct Long {
        masses: { a: 1.0, b: 2.0 },
        springs: { base - a: 400.0, a - b: 300.0 },
        contact: b - wall,
        excitation: a,
        damping: modal(0.02),
        stiction: 1.2,
        provide: [stepper],
        step: 0.032,
    }
}

const LONG: &str =
    "struct Long { masses: { a: 1.0, b: 2.0 }, springs: { base - a: 400.0, a - b: 300.0 },
    contact: b - wall, excitation: a, damping: modal(0.02), stiction: 1.2, provide: [stepper] }";

/// Checks that the constant tables of a long step agree with those of the run-time system.
#[test]
fn a_declared_step_of_a_radian() {
    let system: System = LONG.parse().expect("a scene");
    let strength = Strength {
        loaded: &[0],
        friction: 3.0,
        ..PUSHED
    };
    let (one, events) = run(Long::stepper(Long::STEP).expect("its step"), &strength, 2);
    let (other, others) = run(system.stepper(Long::STEP).expect("its step"), &strength, 2);
    assert_eq!(events, others);
    assert!(events > 30, "{events} events");
    let size = other
        .iter()
        .fold(0.0_f64, |most, value| most.max(value.abs()));
    let apart = one
        .iter()
        .zip(&other)
        .fold(0.0_f64, |most, (one, other)| most.max((one - other).abs()));
    println!("{events} events, {:.1e}", apart / size);
    assert!(apart < 1e-13 * size, "{:e}", apart / size);
}

/// Checks that inputs given by name and inputs given by position lead to the same steps.
#[test]
fn named_inputs_are_those_by_place() {
    let system: System = system("Bowed");
    let mut by_place = shown::Bowed::stepper(shown::Bowed::STEP).expect("its step");
    let mut by_field = by_place.clone();
    let mut by_name = system.stepper(shown::Bowed::STEP).expect("its step");
    for step in 0..400 {
        let [a, b, c, _] = acting(step);
        let forces = [(0, 9.0 * b), (1, 20.0 * a), (0, c)];
        let load = StepLoad {
            forces: &forces,
            ..StepLoad::friction(3.0)
        };
        by_place.step(&load).expect("a sound load");
        let input = shown::BowedInput {
            force: 20.0 * a,
            string: 9.0 * b + c,
            friction: 3.0,
        };
        by_field.advance(input).expect("a sound input");
        let input = SystemInput::force(20.0 * a)
            .on("string", 9.0 * b)
            .on("string", c)
            .friction(3.0);
        by_name.advance(input).expect("a sound input");
    }
    let (one, other) = (by_place.string(), by_field.string());
    assert_eq!(one.displacement().to_bits(), other.displacement().to_bits());
    assert!(one.displacement() != 0.0);
    let third = by_name.mass("string").expect("a mass");
    assert!((third.displacement() - one.displacement()).abs() < 1e-12 * one.displacement().abs());
    // After `restore`, the same steps must give the same bits.
    let saved = by_field.save();
    let input = shown::BowedInput {
        force: 1.0,
        ..Default::default()
    };
    let first = by_field.advance(input).expect("a sound input");
    by_field.advance(input).expect("a sound input");
    by_field.restore(&saved).expect("its own");
    assert_eq!(by_field.advance(input).expect("a sound input"), first);
}

/// Checks that the error for a wrong input has the name of that input, and that the stepper keeps its state.
#[test]
fn faulty_inputs_are_refused_by_name() {
    fn told<T: std::fmt::Debug>(result: Result<T, OutOfDomain>) -> OutOfDomain {
        result.expect_err("refused")
    }
    for dt in [0.0, -1e-3, f64::NAN, f64::INFINITY, 1e9] {
        let step = OutOfDomain::Step(Given::of(dt));
        assert_eq!(told(shown::Shaken::stepper(dt).map(|_| ())), step, "{dt}");
        assert_eq!(told(system::<f64>("Shaken").stepper(dt).map(|_| ())), step);
    }
    let state = (&[0.0, f64::NAN], &[0.0, 0.0]);
    assert_eq!(
        told(shown::Shaken::stepper_from(1e-3, state).map(|_| ())),
        OutOfDomain::State
    );
    let mut stepper = shown::Bowed::stepper(shown::Bowed::STEP).expect("its step");
    let sound = shown::BowedInput {
        force: 9.0,
        string: 1.0,
        friction: 2.0,
    };
    stepper.advance(sound).expect("sound");
    let before = (stepper.string(), stepper.bow(), stepper.work());
    for (error, input) in [
        (
            OutOfDomain::Force(Given::NotANumber),
            shown::BowedInput {
                force: f64::NAN,
                ..sound
            },
        ),
        (
            OutOfDomain::Force(Given::Infinite),
            shown::BowedInput {
                string: f64::INFINITY,
                ..sound
            },
        ),
        (
            OutOfDomain::Friction(Given::Negative),
            shown::BowedInput {
                friction: -1.0,
                ..sound
            },
        ),
    ] {
        assert_eq!(told(stepper.advance(input)), error);
    }
    let system: System = system("Bowed");
    let mut run = system.stepper(1e-3).expect("a step");
    for (error, load) in [
        (
            OutOfDomain::Forces,
            StepLoad {
                forces: &[(2, 1.0)],
                ..StepLoad::friction(1.0)
            },
        ),
        (
            OutOfDomain::BaseAtRest,
            StepLoad {
                base: [1.0, 0.0],
                ..StepLoad::friction(1.0)
            },
        ),
    ] {
        assert_eq!(told(stepper.step(&load)), error);
        assert_eq!(told(run.step(&load)), error);
    }
    assert_eq!(before, (stepper.string(), stepper.bow(), stepper.work()));
    let refused = [
        run.advance(SystemInput::base(1.0, 0.0)),
        run.advance(SystemInput::force(1.0).on("rope", 1.0)),
    ];
    let refused = refused.map(|result| result.expect_err("refused").to_string());
    assert!(
        refused[0].starts_with("the base of this scene rests"),
        "{}",
        refused[0]
    );
    assert!(
        refused[1].starts_with("there is no mass `rope`"),
        "{}",
        refused[1]
    );
    assert_eq!(run.steps(), 0);
    // Functions of the closed forms refuse this friction law, and the error names it.
    let told = system
        .at(0.9)
        .map(|_| ())
        .expect_err("no constant level")
        .to_string();
    assert!(told.contains("needs a constant kinetic level"), "{told}");
    assert!(system.simulation(0.9, 0.1).is_err() && system.limits_without_search(0.9).is_err());
}
