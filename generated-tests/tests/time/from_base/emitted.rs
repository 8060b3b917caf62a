//! Compares emitted code with the run-time system, with damping relative to the moving base: straight-line code for
//! one and two masses, sums for three, loops over the modes for seventeen, and the constant tables of a step.

use frictiongen::{
    ContinuousMotion, FrictionSystem, LimitsAt, MotionAt, Of, Steady, StepLoad, Stepping, Steps,
};

scenes! {
    struct One {
        masses: { m: 1.5 },
        springs: { base - m: 600 },
        contact: m - base,
        excitation: base,
        damping: modal(0.05),
        damping_from: base,
        provide: [limits, motion, stuck, orbit, simulation, stepper],
        step: 1e-3,
    }
    struct Two {
        masses: { low: 1.2, up: 2 },
        springs: { base - low: 300, low - up: 220, up - wall: 90 },
        contact: up - wall,
        excitation: base,
        damping: modal[0.08, 0.7],
        damping_from: base,
        stiction: 1.2,
        provide: [limits, motion, stuck, orbit, stepper],
    }
    struct Three {
        masses: { a: 1, b: 2, c: 1.5 },
        springs: { base - a: 100, a - b: 80, b - c: 120, c - wall: 30 },
        contact: a - c,
        excitation: base,
        damping: rayleigh(0.3, 0.004),
        damping_from: base,
        provide: [limits, motion, stuck, orbit],
    }
    struct Seventeen {
        masses: {
            m0: 1, m1: 1.1, m2: 0.9, m3: 1, m4: 1.2, m5: 1, m6: 0.8, m7: 1, m8: 1,
            m9: 1, m10: 1.3, m11: 1, m12: 0.7, m13: 1, m14: 1, m15: 1.1, m16: 1,
        },
        springs: {
            base - m0: 100, m0 - m1: 90, m1 - m2: 110, m2 - m3: 100, m3 - m4: 80, m4 - m5: 100, m5 - m6: 120,
            m6 - m7: 100, m7 - m8: 100, m8 - m9: 100, m9 - m10: 95, m10 - m11: 100, m11 - m12: 105,
            m12 - m13: 100, m13 - m14: 90, m14 - m15: 100, m15 - m16: 100, m16 - wall: 40,
        },
        contact: m16 - base,
        excitation: base,
        damping: modal(0.03),
        damping_from: base,
        provide: [limits, motion(m0)],
    }
}

/// Relative tolerance. Both sides evaluate the same formulas, with sums in the same order.
const BAR: f64 = 1e-13;

fn close(one: f64, other: f64, what: &str) {
    assert!(
        (one - other).abs() <= BAR * other.abs().max(1e-3),
        "{what}: {one} {other}"
    );
}

/// Compares limits and motions at several frequency ratios.
fn compare<F>(name: &str, emitted: &F, masses: &[usize])
where
    F: FrictionSystem<Scalar = f64>,
    for<'a> F::At<'a>: MotionAt<Scalar = f64>,
{
    let system = system(name);
    let mut compared = 0;
    for step in 1..60 {
        let r = 0.05 * f64::from(step);
        let (at, want) = (emitted.at(r).expect("r"), system.at(r).expect("r"));
        let (continuous, sliding) = (at.continuous_limit(), at.sliding_limit());
        close(
            continuous,
            want.continuous_limit(),
            &format!("{name}, r = {r}: β_lim"),
        );
        close(
            sliding,
            want.sliding_limit(),
            &format!("{name}, r = {r}: β*_lim"),
        );
        let beta = 0.7 * continuous.min(sliding);
        let (motion, other) = (
            at.motion(beta).expect("continuous"),
            want.motion(beta).expect("continuous"),
        );
        for mass in masses {
            let ask = |steady: &dyn Steady<Scalar = f64>| [steady.amplitude(), steady.phase()];
            let own = motion.ask(Of::Mass(*mass), ask).expect("a mass");
            let mass = other.mass_at(*mass).expect("a mass");
            for (own, want) in own.into_iter().zip([mass.amplitude(), mass.phase()]) {
                close(own, want, &format!("{name}, r = {r}: a mass"));
                compared += 1;
            }
        }
    }
    println!("{name}: {compared} values of masses");
}

#[test]
fn closed_forms() {
    compare("One", &One, &[0]);
    compare("Two", &Two, &[0, 1]);
    compare("Three", &Three, &[0, 1, 2]);
    compare("Seventeen", &Seventeen, &[0]);
}

#[test]
fn stuck_responses_and_steady_states() {
    for step in 1..12 {
        let r = 0.2 * f64::from(step);
        let at = Two::at(r).expect("r");
        let system = system("Two");
        let want = system.at(r).expect("r");
        let (own, stuck) = (
            at.stuck().expect("stuck").low(),
            want.stuck().expect("stuck"),
        );
        let other = stuck.mass("low").expect("a mass");
        close(own.re, other.re, "stuck, re");
        close(own.im, other.im, "stuck, im");
        let beta = 0.5 * (at.continuous_limit() + at.sliding_limit());
        let (own, other) = (
            at.orbit(beta).expect("settles"),
            want.orbit(beta).expect("settles"),
        );
        close(
            own.low().amplitude(),
            other.mass("low").expect("a mass").amplitude(),
            "orbit",
        );
        let [own, other] = [own.multipliers(), other.multipliers()].map(|all| {
            all.iter()
                .fold(0.0_f64, |most, one| most.max(one.re.hypot(one.im)))
        });
        assert!((own - other).abs() < 1e-9, "multipliers {own} {other}");
    }
    for step in 1..12 {
        let r = 0.2 * f64::from(step);
        let at = Three::at(r).expect("r");
        let system = system("Three");
        let want = system.at(r).expect("r");
        let (own, stuck) = (at.stuck().expect("stuck").b(), want.stuck().expect("stuck"));
        let other = stuck.mass("b").expect("a mass");
        close(own.re, other.re, "stuck, re");
        close(own.im, other.im, "stuck, im");
        let beta = 0.9 * at.sliding_limit();
        let (own, other) = (
            at.orbit(beta).expect("settles"),
            want.orbit(beta).expect("settles"),
        );
        close(
            own.b().amplitude(),
            other.mass("b").expect("a mass").amplitude(),
            "orbit",
        );
    }
}

/// Runs a stepper under an irregular ground motion, and returns all numbers that it reports.
fn follow<T: Stepping<Scalar = f64>>(mut stepper: T, masses: usize) -> Vec<f64> {
    let mut said = Vec::new();
    for step in 0..2000 {
        let t = f64::from(step);
        let load = StepLoad {
            base: [0.01 * (0.021 * t).sin(), 0.21 * (0.021 * t).cos()],
            forces: &[],
            friction: 0.8 + 0.3 * (0.013 * t).sin(),
        };
        if step == 0 {
            stepper.begin_with(&load).expect("before the first step");
            continue;
        }
        said.push(stepper.step(&load).expect("a sound load").force);
        for mass in 0..masses {
            let now = stepper.mass(mass);
            said.extend([now.displacement(), now.velocity()]);
        }
        let work = stepper.work();
        said.extend([work.load, work.friction, work.damping, work.stored]);
    }
    said
}

#[test]
fn steppers() {
    let bits = |values: Vec<f64>| values.into_iter().map(f64::to_bits).collect::<Vec<_>>();
    // The scene declares another step for its constant tables, so this stepper computes its tables.
    let own = follow(Steps::stepper(&One, 1.1e-3).expect("a step"), 1);
    let system_of = |name| system(name);
    let one = system_of("One");
    assert_eq!(
        bits(own),
        bits(follow(Steps::stepper(&one, 1.1e-3).expect("a step"), 1))
    );
    let two = system_of("Two");
    let own = follow(Steps::stepper(&Two, 1e-3).expect("a step"), 2);
    assert_eq!(
        bits(own),
        bits(follow(Steps::stepper(&two, 1e-3).expect("a step"), 2))
    );
    // The base moves at a constant velocity and carries the masses along, so damping takes less and less energy.
    let mut carried = Two::stepper(1e-3).expect("a step");
    let mut single = One::stepper(1e-3).expect("a step");
    for step in 1..=20_000 {
        let (displacement, velocity, friction) = (1e-4 * f64::from(step), 0.1, 0.0);
        let input = TwoInput {
            displacement,
            velocity,
            friction,
        };
        carried.advance(input).expect("a sound input");
        let input = OneInput {
            displacement,
            velocity,
            friction,
        };
        single.advance(input).expect("a sound input");
    }
    assert!((single.m().displacement() - 2.0).abs() < 1e-6);
    // The wall holds the upper mass back. From then on damping resists the base and takes as much energy as the base
    // gives.
    let work = carried.work();
    assert!(0.0 < work.damping && work.damping < work.load, "{work:?}");
    // Constant tables are rounded only once, so the results differ by rounding.
    let own = follow(Steps::stepper(&One, 1e-3).expect("a step"), 1);
    let other = follow(Steps::stepper(&one, 1e-3).expect("a step"), 1);
    let size = other
        .iter()
        .fold(0.0_f64, |size, value| size.max(value.abs()));
    for (own, other) in own.iter().zip(&other) {
        assert!((own - other).abs() < 1e-10 * size, "{own} {other}");
    }
}
