//! Emitted solvers of scenes with an elastic contact give the bits of the run-time system.

use frictiongen::kernel::Float;
use frictiongen::study::SystemInput;
use frictiongen::{LimitsAt as _, OrbitAt as _, System, friction_system};

friction_system! {
    /// Two floors with a damper on a brace.
    struct Frame {
        masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
        contact: upper - wall, stiffness: 5.0e3,
        excitation: base,
        damping: modal[0.010, 0.012],
        stiction: 1.2,
        provide: [stuck, orbit, simulation, stepper],
    }
}

friction_system! {
    /// Two masses that rub on each other, in single precision and without damping.
    struct Pair {
        masses: { left: 1.0, right: 2.0 },
        springs: { base - left: 100.0, left - right: 80.0 },
        contact: left - right, stiffness: 300.0,
        excitation: left,
        scalar: f32,
        provide: [stuck, orbit, simulation, stepper],
    }
}

friction_system! {
    /// One mass on the moving base.
    struct Block {
        masses: { block: 2.0 },
        springs: { base - block: 50.0 },
        contact: block - base, stiffness: 400.0,
        excitation: base,
        damping: modal(0.03),
        provide: [stuck, orbit, simulation, stepper],
    }
}

const FRAME: &str = "struct Frame { masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 }, contact: upper - wall, stiffness: 5.0e3,
    excitation: base, damping: modal[0.010, 0.012], stiction: 1.2, provide: [orbit] }";
const PAIR: &str = "struct Pair { masses: { left: 1.0, right: 2.0 },
    springs: { base - left: 100.0, left - right: 80.0 }, contact: left - right, stiffness: 300.0,
    excitation: left, scalar: f32, provide: [orbit] }";
const BLOCK: &str = "struct Block { masses: { block: 2.0 }, springs: { base - block: 50.0 },
    contact: block - base, stiffness: 400.0, excitation: base, damping: modal(0.03), provide: [orbit] }";

/// Compares numbers bit for bit.
fn same<S: Float>(own: &[S], expected: &[S]) -> usize {
    assert_eq!(own.len(), expected.len());
    for (index, (own, expected)) in own.iter().zip(expected).enumerate() {
        assert_eq!(
            own.bits(),
            expected.bits(),
            "number {index}: {own:?} for {expected:?}"
        );
    }
    own.len()
}

/// The numbers of a steady state and of the motion of its contact.
macro_rules! orbit_numbers {
    ($orbit:expr) => {{
        let orbit = $orbit;
        let contact = orbit.contact();
        let mut all = vec![
            orbit.stuck_fraction(),
            orbit.sliding_distance(),
            orbit.origin(),
            contact.amplitude(),
            contact.phase(),
            contact.harmonic(3).re,
        ];
        all.extend(orbit.multipliers().iter().flat_map(|one| [one.re, one.im]));
        all
    }};
}

/// Compares limits, stuck amplitudes, steady states and a motion in time over frequencies and frictions.
macro_rules! compare {
    ($name:ident, $text:ident, $scalar:ident, $first:ident) => {{
        let system: System<$scalar> = $text.parse().expect("a scene");
        let mut compared = 0;
        for r in [0.3, 0.75, 1.3, 2.1] {
            let (own, at) = ($name::at(r).expect("own"), system.at(r).expect("run time"));
            let limits = [own.continuous_limit(), own.sliding_limit()];
            compared += same(&limits, &[at.continuous_limit(), at.sliding_limit()]);
            let (own_stuck, stuck) = (own.stuck().expect("own"), at.stuck().expect("run time"));
            for mass in 0..system.scene().masses.len() {
                let (a, b) = (own_stuck.mass(mass), stuck.mass_at(mass).expect("a mass"));
                compared += same(&[a.re, a.im], &[b.re, b.im]);
            }
            for share in [0.2, 0.7] {
                let beta = share * at.sliding_limit();
                match (own.orbit(beta), at.orbit(beta)) {
                    (Ok(own), Ok(orbit)) => {
                        compared += same(&orbit_numbers!(&own), &orbit_numbers!(&orbit));
                        let name = stringify!($first);
                        let (a, b) = (own.$first(), orbit.mass(name).expect("a mass"));
                        compared += same(&[a.amplitude()], &[b.amplitude()]);
                    }
                    (own, orbit) => assert_eq!(own.err(), orbit.err()),
                }
                let mut own = $name::simulation(r, beta).expect("own");
                let mut run = system.simulation(r, beta).expect("run time");
                for _ in 0..60 {
                    let (a, b) = (
                        own.next().expect("a segment"),
                        run.next().expect("a segment"),
                    );
                    assert_eq!(a.event, b.event);
                    let numbers = [own.friction(), own.relative().0, own.relative().1];
                    let expected = [run.friction(), run.relative().0, run.relative().1];
                    compared += same(&[a.length], &[b.length]) + same(&numbers, &expected);
                }
            }
        }
        println!("{}: {compared} numbers", stringify!($name));
        compared
    }};
}

#[test]
fn emitted_is_run_time() {
    assert!(compare!(Frame, FRAME, f64, lower) > 2000);
    assert!(compare!(Pair, PAIR, f32, left) > 2000);
    assert!(compare!(Block, BLOCK, f64, block) > 2000);
}

/// The trait's methods reach the emitted scene.
#[test]
fn an_emitted_scene_is_a_friction_system() {
    fn amplitude<F>(system: &F, r: f64, beta: f64) -> f64
    where
        F: frictiongen::FrictionSystem<Scalar = f64>,
        for<'a> F::At<'a>: frictiongen::OrbitAt,
    {
        let at = system.at(r).expect("in the domain");
        let orbit = at.orbit(beta).expect("a steady state");
        use frictiongen::SteadyState as _;
        let asked = orbit.ask(frictiongen::Of::Mass(0), |motion| motion.amplitude());
        asked.expect("a mass")
    }
    let system: System = FRAME.parse().expect("a scene");
    assert_eq!(
        amplitude(&Frame, 0.8, 0.2).to_bits(),
        amplitude(&system, 0.8, 0.2).to_bits()
    );
}

/// Steps under a base motion, and under a force in single precision.  At run time a force has a cubic over the step whose
/// higher terms vanish, so that the bits are those of the emitted line.
#[test]
fn emitted_steps_are_run_time() {
    let system: System = FRAME.parse().expect("a scene");
    let mut run = system.stepper(2e-3).expect("run time");
    let mut own = Frame::stepper(2e-3).expect("own");
    let mut events = 0;
    for step in 1..=3000_u32 {
        let (sine, cosine) = (0.02 * f64::from(step)).sin_cos();
        let (displacement, velocity, friction) =
            (0.01 * sine, 0.1 * cosine, 3.0 + f64::from(step % 3));
        let input = SystemInput::base(displacement, velocity).friction(friction);
        let expected = run.advance(input).expect("a step");
        let input = FrameInput {
            displacement,
            velocity,
            friction,
        };
        let stepped = own.advance(input).expect("a step");
        assert_eq!(
            (stepped.contact, stepped.events),
            (expected.contact, expected.events),
            "{step}"
        );
        let upper = run.mass("upper").expect("a mass");
        same(
            &[
                stepped.force,
                own.upper().displacement(),
                own.upper().velocity(),
                own.work().friction,
            ],
            &[
                expected.force,
                upper.displacement(),
                upper.velocity(),
                run.work().friction,
            ],
        );
        events += stepped.events;
    }
    assert!(events > 50, "{events}");
    let mut single = Pair::stepper(5e-3).expect("own");
    let mut events = 0;
    for step in 1..=2000_u32 {
        let force = 20.0 * (0.06 * f64::from(step)).sin() as f32;
        let stepped = single
            .advance(PairInput {
                force,
                friction: 3.0,
            })
            .expect("a step");
        assert!(stepped.force.abs() <= 3.0 * (1.0 + 1e-5));
        events += stepped.events;
    }
    assert!(events > 50 && single.exceeded() == 0, "{events}");
}
