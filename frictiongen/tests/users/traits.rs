//! One generic function for emitted scenes and for run-time systems, over steady states and runs in time.

use frictiongen::kernel::simulation::Event;
use frictiongen::{
    FrictionSystem, Of, OrbitAt, OutOfDomain, Run, Simulates, SteadyState, System, friction_system,
};

const TEXT: &str = "struct Pair { masses: { a: 1, b: 0.7 }, springs: { base - a: 1, a - b: 2 },
    contact: b - wall, excitation: base, damping: modal[0.02, 0.05], stiction: 1.3 }";

friction_system! {
    pub struct Pair {
        masses: { a: 1, b: 0.7 },
        springs: { base - a: 1, a - b: 2 },
        contact: b - wall,
        excitation: base,
        damping: modal[0.02, 0.05],
        stiction: 1.3,
        provide: [limits, orbit, simulation],
    }
}

/// Returns every number of the steady states, as bits.
fn steady<F>(system: &F, points: &[(f64, f64)]) -> Vec<u64>
where
    F: FrictionSystem<Scalar = f64>,
    for<'a> F::At<'a>: OrbitAt,
{
    let mut told = Vec::new();
    for (r, beta) in points {
        let at = system.at(*r).expect("a ratio");
        let orbit = at.orbit(*beta).expect("a steady state");
        told.extend([orbit.stops(), orbit.reversals()].map(|count| count as u64));
        told.extend([orbit.is_symmetric(), orbit.is_stable(), orbit.is_marginal()].map(u64::from));
        told.push(orbit.stuck_fraction().to_bits());
        told.extend(orbit.multipliers().iter().map(|value| value.re.to_bits()));
        for of in [Of::Contact, Of::Mass(0), Of::Mass(1)] {
            let motion = orbit.ask(of, |motion| {
                let harmonic = motion.harmonic(3);
                [
                    motion.amplitude(),
                    motion.phase(),
                    motion.displacement(0.3),
                    motion.velocity(0.3),
                    harmonic.re,
                    harmonic.im,
                ]
            });
            told.extend(motion.expect("a motion").map(f64::to_bits));
        }
        assert!(orbit.ask(Of::Mass(2), |_| ()).is_none());
    }
    told
}

fn events<F: Simulates<Scalar = f64>>(system: &F) -> Result<Vec<(u64, Event)>, OutOfDomain> {
    let mut run = system.simulation(0.4, 0.3)?;
    let mut events = Vec::new();
    while run.cycles() < 20 {
        if let Some(event) = run.advance(0.5)?.event {
            events.push((run.phase().to_bits(), event));
            events.push((run.moment(0).velocity().to_bits(), event));
            events.push((run.relative().0.to_bits() ^ run.friction().to_bits(), event));
        }
    }
    Ok(events)
}

#[test]
fn one_function_for_both() {
    let system: System = TEXT.parse().expect("a sound scene");
    let points = [(0.4, 0.3), (0.6, 0.2), (1.3, 0.1), (0.5, 9.0)];
    let (emitted, run_time) = (steady(&Pair, &points), steady(&system, &points));
    assert_eq!(emitted, run_time);
    assert!(emitted.len() > 4 * 24);
    let (emitted, run_time) = (events(&Pair), events(&system));
    assert!(emitted.as_ref().is_ok_and(|events| events.len() > 100));
    assert_eq!(emitted, run_time);
}

const RATIO: f64 = Pair::frequency_ratio(2.0);
const FRICTION: f64 = Pair::friction_ratio(3.0, 4.0);

#[test]
fn ratios_at_compile_time() {
    assert_eq!((RATIO, FRICTION), (2.0, 0.75));
    fn initial<T: Default>() -> T {
        T::default()
    }
    assert_eq!(Pair, initial());
}

/// A stepper continues from a written state with the same bits. A state of another version, another scene or another
/// step, and a state with a changed length or number, is refused.
#[cfg(feature = "serde")]
#[test]
fn states_of_steppers_are_written_and_read() {
    use frictiongen::study::SystemInput;
    use frictiongen::study::stepper::{SystemStepSaved, SystemStepper};
    use serde_json::Value;
    let system: System = TEXT.parse().expect("a sound scene");
    let on_base = system.scene().excitation == frictiongen::study::scene::Excitation::Base;
    let mut count = 0_u32;
    let mut input = || {
        count += 1;
        let (sine, cosine) = (0.11 * f64::from(count)).sin_cos();
        let input = if on_base {
            SystemInput::base(sine, 0.11 * cosine)
        } else {
            SystemInput::force(sine)
        };
        input.friction(0.3)
    };
    let mut stepper = system.stepper(0.1).expect("a stepper");
    stepper.set_event_budget(3);
    for _ in 0..100 {
        let input = input();
        let text = serde_json::to_string(&input).expect("JSON");
        let read: SystemInput<'_> = serde_json::from_str(&text).expect("an input");
        assert_eq!(read, input);
        stepper.advance(read).expect("a step");
    }
    let text = serde_json::to_string(&stepper.save()).expect("JSON");
    let saved: SystemStepSaved = serde_json::from_str(&text).expect("a state");
    let mut again = system.stepper(0.1).expect("a stepper");
    again.restore(&saved).expect("the same scene");
    assert_eq!(again.image(), stepper.image());
    for _ in 0..100 {
        let input = input();
        let (one, other) = (stepper.advance(input.clone()), again.advance(input));
        assert_eq!(one.expect("a step"), other.expect("a step"));
    }
    assert_eq!(again.image(), stepper.image());

    let mut other = system.stepper(0.2).expect("a stepper");
    assert_eq!(other.restore(&saved), Err(OutOfDomain::Saved));
    let form: Value = serde_json::from_str(&text).expect("JSON");
    let changed = |change: &dyn Fn(&mut Value)| {
        let mut form = form.clone();
        change(&mut form);
        serde_json::from_value::<SystemStepSaved>(form)
    };
    for (change, said) in [
        (
            &(|form: &mut Value| form["version"] = 2.into()) as &dyn Fn(&mut Value),
            "the saved state has version 2, but this version of frictiongen reads version 1",
        ),
        (&|form| form["numbers"] = 1.into(), "invalid type"),
        (&|form| form["more"] = 1.into(), "unknown field `more`"),
        (
            &|form| {
                form.as_object_mut().expect("fields").remove("store");
            },
            "missing field `store`",
        ),
    ] {
        let error = changed(change).expect_err("a changed state").to_string();
        assert!(error.contains(said), "{error}");
    }
    // The scene's hash and the number of modes are checked when a stepper restores the state.
    let refused = |change: &dyn Fn(&mut Value)| {
        let mut stepper: SystemStepper<'_> = system.stepper(0.1).expect("a stepper");
        let before = stepper.image();
        let result = stepper.restore(&changed(change).expect("a state"));
        assert_eq!(stepper.image(), before);
        result
    };
    for change in [
        &(|form: &mut Value| form["scene"] = 1.into()) as &dyn Fn(&mut Value),
        &|form| form["line"] = 5.into(),
        &|form| form["store"]["last"] = Value::Array(Vec::new()),
    ] {
        assert_eq!(refused(change), Err(OutOfDomain::Saved));
    }
}

/// The state of an emitted stepper is written and read as that of a system.
#[cfg(feature = "serde")]
#[test]
fn states_of_emitted_steppers_are_written_and_read() {
    frictiongen::friction_system! {
        struct Stepped {
            masses: { a: 1.0, b: 2.0 },
            springs: { base - a: 3.0, a - b: 1.5 },
            contact: b - wall,
            excitation: a,
            provide: [stepper],
        }
    }
    let mut stepper = Stepped::stepper(0.1).expect("a stepper");
    let input = |step: u32| SteppedInput {
        force: (0.2 * f64::from(step)).sin(),
        friction: 0.2,
    };
    for step in 0..50 {
        stepper.advance(input(step)).expect("a step");
    }
    let text = serde_json::to_string(&stepper.save()).expect("JSON");
    let mut again = Stepped::stepper(0.1).expect("a stepper");
    let mut saved = again.save();
    assert!(!text.contains("scratch"), "{text}");
    fn read<'t, T: serde::Deserialize<'t>>(to: &mut T, text: &'t str) -> Result<(), String> {
        *to = serde_json::from_str(text).map_err(|error| error.to_string())?;
        Ok(())
    }
    read(&mut saved, &text).expect("a state");
    again.restore(&saved).expect("the same scene");
    for step in 50..100 {
        let (one, other) = (stepper.advance(input(step)), again.advance(input(step)));
        assert_eq!(one.expect("a step"), other.expect("a step"));
    }
    assert_eq!(stepper.image(), again.image());
    let longer = text.replace("\"last\":[", "\"last\":[0.0,");
    let error = read(&mut saved, &longer).expect_err("a longer list");
    assert!(error.contains("a list of 1 values"), "{error}");
}

/// The inputs of emitted steppers are written with their names, and read with the same bits. The fields must be those
/// of the scene.
#[cfg(feature = "serde")]
#[test]
fn inputs_of_emitted_steppers_are_written_and_read() {
    frictiongen::friction_system! {
        pub struct Shaken {
            masses: { a: 1.0, größe: 2.0 },
            springs: { base - a: 3.0, a - größe: 1.5 },
            contact: größe - wall,
            excitation: base,
            force: { größe },
            scalar: f32,
            provide: [stepper],
        }
    }
    frictiongen::friction_system! {
        struct Joined {
            masses: { a: 1.0, b: 2.0 },
            springs: { base - a: 3.0, a - b: 1.5 },
            contacts: { low: a - wall, high: a - b },
            excitation: a,
            provide: [stepper],
        }
    }
    let mut input = ShakenInput {
        displacement: 0.1,
        velocity: -2e-30,
        größe: 0.3,
        friction: 1.0,
    };
    let text = serde_json::to_string(&input).expect("JSON");
    assert_eq!(
        text,
        r#"{"displacement":0.1,"velocity":-2e-30,"größe":0.3,"friction":1.0}"#
    );
    let mut stepper = Shaken::stepper(0.1).expect("a stepper");
    let mut again = Shaken::stepper(0.1).expect("a stepper");
    for step in 0..200_u8 {
        // A step of base and force, whose digits are not round.
        (input.displacement, input.velocity) = (0.01 * f32::from(step), 0.1);
        input.größe = (0.7 * f32::from(step)).sin();
        let text = serde_json::to_string(&input).expect("JSON");
        let read: ShakenInput = serde_json::from_str(&text).expect("an input");
        assert_eq!(read, input);
        stepper.advance(input).expect("a step");
        again.advance(read).expect("a step");
    }
    assert_eq!(stepper.image(), again.image());

    for (from, to, said) in [
        ("größe", "grösse", "unknown field `grösse`"),
        (",\"friction\":1.0", "", "missing field `friction`"),
        ("0.1", "null", "invalid type: null"),
    ] {
        let error = serde_json::from_str::<ShakenInput>(&text.replacen(from, to, 1));
        let error = error.expect_err("a wrong input").to_string();
        assert!(error.contains(said), "{error}");
    }
    // An input without a finite number is read by other formats than JSON. The step refuses it.
    input.größe = f32::NAN;
    let state = stepper.image();
    assert!(matches!(stepper.advance(input), Err(OutOfDomain::Force(_))));
    assert_eq!(stepper.image(), state);

    let input = JoinedInput {
        force: 0.25,
        friction: JoinedFriction {
            low: 1.0,
            high: 0.5,
        },
    };
    let text = serde_json::to_string(&input).expect("JSON");
    assert_eq!(text, r#"{"force":0.25,"friction":{"low":1.0,"high":0.5}}"#);
    let read: JoinedInput = serde_json::from_str(&text).expect("an input");
    assert_eq!(read, input);
    let mut joined = Joined::stepper(0.1).expect("a stepper");
    joined.advance(read).expect("a step");
}

#[cfg(feature = "serde")]
#[test]
fn results_and_scenes_are_written_and_read() {
    use frictiongen::kernel::simulation::Segment;
    use frictiongen::study::scene::Scene;
    use frictiongen::sweep::{self, LimitsPoint};
    let system: System = TEXT.parse().expect("a sound scene");
    let text = serde_json::to_string(system.scene()).expect("JSON");
    let scene: Scene = serde_json::from_str(&text).expect("a scene");
    assert_eq!(&scene, system.scene());
    let again = System::<f64>::try_from(scene).expect("a sound scene");
    assert_eq!(again.resonances(), system.resonances());
    let mut limits = [LimitsPoint::default(); 2];
    sweep::limits(&system, &[0.5, 1.5], &mut limits).expect("in the domain");
    let text = serde_json::to_string(&limits).expect("JSON");
    let read: [LimitsPoint<f64>; 2] = serde_json::from_str(&text).expect("limits");
    assert_eq!(read, limits);
    let mut run = system.simulation(0.4, 0.3).expect("in the domain");
    let segments: Vec<_> = run.by_ref().take(9).collect();
    let text = serde_json::to_string(&segments).expect("JSON");
    let read: Vec<Segment<f64>> = serde_json::from_str(&text).expect("segments");
    assert_eq!(read, segments);
    let error =
        frictiongen::Error::from(OutOfDomain::FrequencyRatio(frictiongen::Given::NotANumber));
    let text = serde_json::to_string(&error).expect("JSON");
    assert_eq!(text, r#"{"OutOfDomain":{"FrequencyRatio":"NotANumber"}}"#);
}
